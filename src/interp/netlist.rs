//! A module and all below it as one flat list of operations, elaborated at parameter values and levelized once.
use reliefrtl_ir::Binding;
use std::collections::BTreeMap;

/// Index of a value.
pub type Slot = u32;

/// What a flat operation computes; widths are numbers now.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Kind {
    Copy,
    Not,
    And,
    Or,
    Xor,
    RedOr,
    RedAnd,
    Add,
    Sub,
    Mul,
    Eq,
    Ult,
    Slt,
    Shl,
    Shr,
    Sar,
    Mux,
    /// `args[0] << aux | args[1]`.
    Join,
    /// `args[0] >> aux`, cut to the width.
    Slice,
    Sext,
    Rep,
    Lzc,
    Interleave,
    /// Remainder of `aux` rows of division of `args[0]` by `args[1]`.
    DivRem,
    /// Quotient bits of the same.
    DivQuot,
    /// Word `args[0]` of the table of reciprocals.
    RecipTable,
}

/// One flat operation.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct FlatOp {
    /// What is computed.
    pub kind: Kind,
    /// Operands (unused ones repeat the first).
    pub args: [Slot; 3],
    /// Width of the result.
    pub width: u32,
    /// Width of the first operand.
    pub arg_width: u32,
    /// Shift or row count.
    pub aux: u32,
}

/// A register.
#[derive(Clone, Copy, Debug)]
pub struct FlatReg {
    /// Its output.
    pub q: Slot,
    /// Its input.
    pub d: Slot,
    /// Clock enable.
    pub enable: Option<Slot>,
    /// Synchronous reset to zero.
    pub reset: Option<Slot>,
    /// What it holds where its input is unknown; `None`: unknown bits. Of one bit only.
    pub unknown: Option<bool>,
}

/// A memory with one write and one registered read.
#[derive(Clone, Copy, Debug)]
pub struct FlatMem {
    pub write_en: Slot,
    pub write_addr: Slot,
    pub write_data: Slot,
    pub read_addr: Slot,
    pub read_data: Slot,
    /// Words.
    pub depth: usize,
    /// Every copy of the design has words of its own; else all read the same.
    pub own: bool,
}

/// A port of the elaborated module.
#[derive(Clone, Debug)]
pub struct FlatPort {
    pub name: String,
    pub slot: Slot,
    pub width: u32,
}

/// The elaborated design.
#[derive(Clone, Debug, Default)]
pub struct Netlist {
    /// Parameter values.
    pub binding: Binding,
    /// Width of every slot.
    pub widths: Vec<u32>,
    /// Slots with a constant value.
    pub consts: Vec<(Slot, u64)>,
    /// Inputs, in port order (clock left out).
    pub inputs: Vec<FlatPort>,
    /// Outputs, in port order.
    pub outputs: Vec<FlatPort>,
    /// Operations in an order in which operands come first; operation i writes slot `first_op + i`.
    pub ops: Vec<FlatOp>,
    /// The first slot that an operation writes.
    pub first_op: Slot,
    /// Registers.
    pub regs: Vec<FlatReg>,
    /// Memories: first those that all copies share, then those of each copy.
    pub mems: Vec<FlatMem>,
    /// Hierarchical names (`u_add.s1_sum`) of slots, for waveforms and mismatch reports; none once it is optimized.
    pub names: BTreeMap<String, Slot>,
}

impl Netlist {
    /// The input `name`.
    ///
    /// # Panics
    /// If there is none.
    pub fn input(&self, name: &str) -> Slot {
        self.inputs.iter().find(|p| p.name == name).unwrap_or_else(|| panic!("no input {name}")).slot
    }
    /// The output `name`.
    ///
    /// # Panics
    /// If there is none.
    pub fn output(&self, name: &str) -> Slot {
        self.outputs.iter().find(|p| p.name == name).unwrap_or_else(|| panic!("no output {name}")).slot
    }
}
