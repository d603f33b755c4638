//! All heights on chip: a height source that never misses. One to four clocks a read, as `latency.memory` says.
use super::cells::block_memory;
use super::height_banks::{bank_bits, height_banks};
use super::height_memory::height_memory;
use super::height_source::{HeightPort, HeightSource, Heights, Load, Place};
use super::loop_state::Ray;
use reliefrtl_config::{Design, Register};
use reliefrtl_ir::{Module, Sig};
use std::sync::Arc;

/// The whole pyramid in memory on chip, of one node a word, or of four siblings in four memories; or the windows of each size in one of its own.
pub struct OnChip;

impl HeightSource for OnChip {
    fn misses(&self) -> bool {
        false
    }
    fn open<'b>(&self, place: Place<'b>) -> Box<dyn HeightPort<'b> + 'b> {
        Box::new(Port(place))
    }
}

struct Port<'b>(Place<'b>);

impl<'b> HeightPort<'b> for Port<'b> {
    fn read(&mut self, _: &Ray<'b>, addresses: &[Sig<'b>]) -> Heights<'b> {
        let each = self.0.loads.iter().zip(addresses);
        Heights { words: each.map(|(load, address)| read(self.0, load, *address)).collect(), missed: None }
    }
}

/// The memory of a design: from two clocks on, banks with a register after each.
pub fn memory(d: &Design) -> Arc<Module> {
    let n = d.traverse.levels;
    let nodes = (2 * n + 1, ((1 << (2 * n + 2)) - 1) / 3);
    let (addr, depth) = if d.fetch.blocks() { block_memory(d) } else { nodes };
    if d.latency.has(Register::Bank) {
        height_banks(addr, d.traverse.height_bits, depth)
    } else {
        height_memory(addr, d.traverse.height_bits, depth)
    }
}

/// The height at `address`.
fn read<'b>(place: Place<'b>, load: &Load<'b>, address: Sig<'b>) -> Sig<'b> {
    let Place { b, s, d, .. } = place;
    let has = |register| d.latency.has(register);
    let mut params = vec![("ADDR_W", load.addr.width()), ("DATA_W", s.height.clone()), ("DEPTH", load.words.clone())];
    params.extend(has(Register::Bank).then(|| ("BANK_W", bank_bits())));
    let address = address.reg_if(has(Register::Address));
    let ins = [("write_en", load.en), ("write_addr", load.addr), ("write_data", load.data), ("read_addr", address)];
    // The last part of the file's name tells memories apart, where there are several.
    let of = load.file.replace('.', "_");
    let height = b.inst_of_file(&memory(d), &format!("u_heights{of}"), &params, &ins, load.file);
    let height = height.only().named(&format!("height{of}")).doc("highest code in the node [height codes]");
    height.reg_if(has(Register::Height))
}
