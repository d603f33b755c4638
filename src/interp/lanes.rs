//! Two-valued simulation of many independent copies of a design side by side.
//!
//! Lanes stand in blocks whose values fit the cache; in a block every operation is one loop over the lanes, which the
//! compiler vectorizes. Memories are shared by all lanes, and what is written must be the same in each; but for those of which each lane has
//! its own ([`FlatMem::own`]), whose words stand one after the other, lane by lane.
use super::kernel::BLOCK;
use super::layout::layout;
use super::netlist::*;
use super::program::{Block, Program};
use std::sync::Arc;

/// The state of `lanes` copies of a netlist.
pub struct Lanes {
    program: Program,
    blocks: Vec<Block>,
    lanes: usize,
    ports: Vec<FlatMem>,
    mems: Vec<Arc<Vec<u64>>>,
}

impl Lanes {
    /// `lanes` copies with registers and memories at zero.
    pub fn new(net: &Netlist, lanes: usize) -> Self {
        Self::with(net, layout(net, false), lanes)
    }
    /// The same, faster: only ports and registers can be read.
    pub fn of_ports(net: &Netlist, lanes: usize) -> Self {
        Self::with(net, layout(net, true), lanes)
    }
    fn with(net: &Netlist, program: Program, lanes: usize) -> Self {
        let blocks = (0..lanes.div_ceil(BLOCK)).map(|_| program.block()).collect();
        let mems = net
            .mems
            .iter()
            .map(|m| Arc::new(vec![0; if m.own { m.depth * lanes.div_ceil(BLOCK) * BLOCK } else { m.depth }]))
            .collect();
        Self { program, blocks, lanes, ports: net.mems.clone(), mems }
    }
    /// Number of lanes.
    pub fn lanes(&self) -> usize {
        self.lanes
    }
    /// The word of a slot in a lane.
    #[inline]
    pub fn get(&self, s: Slot, lane: usize) -> u64 {
        self.blocks[lane / BLOCK].get(self.program.at(s), lane % BLOCK)
    }
    /// The words of a slot in all lanes.
    pub fn read(&self, s: Slot, out: &mut [u64]) {
        let row = self.program.at(s);
        out.chunks_mut(BLOCK).zip(&self.blocks).for_each(|(out, b)| b.read(row, out));
    }
    /// Writes the word of an input in a lane.
    #[inline]
    pub fn set(&mut self, s: Slot, lane: usize, v: u64) {
        self.blocks[lane / BLOCK].set(self.program.at(s), lane % BLOCK, v);
    }
    /// Writes the word of an input in every lane.
    pub fn fill(&mut self, s: Slot, v: u64) {
        (0..self.lanes).for_each(|lane| self.set(s, lane, v));
    }
    /// Puts `words` into the shared memory `index` (a back door; the write port does the same, word by word).
    pub fn load(&mut self, index: usize, words: Arc<Vec<u64>>) {
        assert_eq!(words.len(), self.ports[index].depth, "memory image has the memory's depth");
        self.mems[index] = words;
    }

    /// Propagates inputs and registers through the combinational operations.
    pub fn eval(&mut self) {
        self.blocks.iter_mut().for_each(|b| self.program.eval(b));
    }

    /// One rising clock edge (after [`Lanes::eval`]).
    ///
    /// # Panics
    /// If lanes write different things to a memory.
    pub fn clock(&mut self) {
        for (k, b) in self.blocks.iter_mut().enumerate() {
            for r in &self.program.reads {
                let port = &self.ports[r.mem];
                for lane in 0..BLOCK {
                    let first = if port.own { (k * BLOCK + lane) * port.depth } else { 0 };
                    let at = b.get(r.addr, lane) as usize;
                    let word = if at < port.depth { self.mems[r.mem][first + at] } else { 0 };
                    b.set(r.hold, lane, word);
                }
            }
        }
        self.write_memories();
        self.blocks.iter_mut().for_each(|b| self.program.clock(b));
    }

    fn write_memories(&mut self) {
        for i in 0..self.ports.len() {
            let m = self.ports[i];
            if m.own {
                self.write_own(i);
                continue;
            }
            if (0..self.lanes).all(|l| self.get(m.write_en, l) == 0) {
                continue;
            }
            let same = |s: Slot| (0..self.lanes).all(|l| self.get(s, l) == self.get(s, 0));
            let shared = same(m.write_en) && same(m.write_addr) && same(m.write_data);
            assert!(shared, "lanes share their memories and must write the same");
            let (addr, data) = (self.get(m.write_addr, 0) as usize, self.get(m.write_data, 0));
            if let Some(word) = Arc::make_mut(&mut self.mems[i]).get_mut(addr) {
                *word = data;
            }
        }
    }

    fn write_own(&mut self, i: usize) {
        let m = self.ports[i];
        for lane in (0..self.lanes).filter(|l| self.get(m.write_en, *l) != 0).collect::<Vec<_>>() {
            let (addr, data) = (self.get(m.write_addr, lane) as usize, self.get(m.write_data, lane));
            if addr < m.depth {
                Arc::make_mut(&mut self.mems[i])[lane * m.depth + addr] = data;
            }
        }
    }
}
