//! Two-valued simulation of many independent copies of a design side by side.
//!
//! Lanes stand in blocks whose values fit the cache; in a block every operation is one loop over the lanes, which the
//! compiler vectorizes. Memories are shared by all lanes, and what is written must be the same in each; but for those of which each lane has
//! its own ([`FlatMem::own`]), whose words stand one after the other, lane by lane.
use super::kernel::{BLOCK, FEW};
use super::layout::layout;
use super::netlist::*;
use super::program::{Block, Program};
use std::sync::Arc;

/// The state of `lanes` copies of a netlist.
pub struct Lanes {
    program: Program,
    blocks: Blocks,
    lanes: usize,
    ports: Vec<FlatMem>,
    mems: Vec<Arc<Vec<u64>>>,
}

/// Large blocks, or one small one where there are few lanes.
enum Blocks {
    Few(Box<Block<FEW>>),
    Many(Vec<Block<BLOCK>>),
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
        let (blocks, room) = match lanes.div_ceil(BLOCK) {
            _ if lanes <= FEW => (Blocks::Few(Box::new(program.block())), FEW),
            many => (Blocks::Many((0..many).map(|_| program.block()).collect()), many * BLOCK),
        };
        let words = |m: &FlatMem| if m.own { m.depth * room } else { m.depth };
        let mems = net.mems.iter().map(|m| Arc::new(vec![0; words(m)])).collect();
        Self { program, blocks, lanes, ports: net.mems.clone(), mems }
    }
    /// Number of lanes.
    pub fn lanes(&self) -> usize {
        self.lanes
    }
    /// The word of a slot in a lane.
    #[inline]
    pub fn get(&self, s: Slot, lane: usize) -> u64 {
        let row = self.program.at(s);
        match &self.blocks {
            Blocks::Few(b) => b.get(row, lane),
            Blocks::Many(blocks) => blocks[lane / BLOCK].get(row, lane % BLOCK),
        }
    }
    /// The words of a slot in all lanes.
    pub fn read(&self, s: Slot, out: &mut [u64]) {
        let row = self.program.at(s);
        match &self.blocks {
            Blocks::Few(b) => b.read(row, out),
            Blocks::Many(blocks) => out.chunks_mut(BLOCK).zip(blocks).for_each(|(out, b)| b.read(row, out)),
        }
    }
    /// Writes the word of an input in a lane.
    #[inline]
    pub fn set(&mut self, s: Slot, lane: usize, v: u64) {
        let row = self.program.at(s);
        match &mut self.blocks {
            Blocks::Few(b) => b.set(row, lane, v),
            Blocks::Many(blocks) => blocks[lane / BLOCK].set(row, lane % BLOCK, v),
        }
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
        match &mut self.blocks {
            Blocks::Few(b) => self.program.eval(b),
            Blocks::Many(blocks) => blocks.iter_mut().for_each(|b| self.program.eval(b)),
        }
    }

    /// One rising clock edge (after [`Lanes::eval`]).
    ///
    /// # Panics
    /// If lanes write different things to a memory.
    pub fn clock(&mut self) {
        let reads = Reads { program: &self.program, ports: &self.ports, mems: &self.mems };
        match &mut self.blocks {
            Blocks::Few(b) => reads.hold(b, 0),
            Blocks::Many(blocks) => blocks.iter_mut().enumerate().for_each(|(k, b)| reads.hold(b, k * BLOCK)),
        }
        self.write_memories();
        match &mut self.blocks {
            Blocks::Few(b) => self.program.clock(b),
            Blocks::Many(blocks) => blocks.iter_mut().for_each(|b| self.program.clock(b)),
        }
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

/// What the read ports of the memories see.
struct Reads<'a> {
    program: &'a Program,
    ports: &'a [FlatMem],
    mems: &'a [Arc<Vec<u64>>],
}

impl Reads<'_> {
    /// Puts aside what each memory reads, until the registers are clocked; the first lane of `b` is lane `first`.
    fn hold<const L: usize>(&self, b: &mut Block<L>, first: usize) {
        for r in &self.program.reads {
            let port = &self.ports[r.mem];
            for lane in 0..L {
                let own = if port.own { (first + lane) * port.depth } else { 0 };
                let at = b.get(r.addr, lane) as usize;
                let word = if at < port.depth { self.mems[r.mem][own + at] } else { 0 };
                b.set(r.hold, lane, word);
            }
        }
    }
}
