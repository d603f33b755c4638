//! A hardware module: parameters, ports, a graph of operations in stages, instances.
use super::expr::{Binding, Expr};
use super::prim::Prim;
use super::quantity::{Kind, Quantity};
use std::sync::Arc;

/// Index of a node in its module.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct NodeId(pub u32);

/// Index of an instance in its module.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct InstId(pub u32);

/// The operations. Widths: `a`, `b` are operands, `w` is the result. There is no implicit widening,
/// and sign is a property of the operation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Op {
    /// A port of the module (index into `Module::ports`).
    Input(usize),
    /// All zeros.
    Zeros,
    /// All ones.
    Ones,
    /// A literal below 2^w.
    Lit(u64),
    /// A constant expression over the parameters, modulo 2^w.
    Konst(Expr),
    /// Bitwise complement; w = a.
    Not,
    /// Bitwise and; w = a = b.
    And,
    /// Bitwise or; w = a = b.
    Or,
    /// Bitwise exclusive or; w = a = b.
    Xor,
    /// OR of all bits; w = 1.
    RedOr,
    /// AND of all bits; w = 1.
    RedAnd,
    /// Sum modulo 2^w; w = a = b.
    Add,
    /// Difference modulo 2^w; w = a = b.
    Sub,
    /// Unsigned product; w = a + b.
    Mul,
    /// Equality; a = b, w = 1.
    Eq,
    /// Unsigned less-than; a = b, w = 1.
    Ult,
    /// Signed less-than; a = b, w = 1.
    Slt,
    /// Shift left by the unsigned value of b, zeros come in, overshift gives 0; w = a.
    Shl,
    /// Logical shift right, overshift gives 0; w = a.
    Shr,
    /// Arithmetic shift right, overshift gives copies of the sign; w = a.
    Sar,
    /// `c ? a : b`; c = 1, w = a = b.
    Mux,
    /// Concatenation, first operand on top; w = sum.
    Concat,
    /// Bits `lo .. lo + w`; lo + w <= a.
    Slice {
        /// Lowest bit taken.
        lo: Expr,
    },
    /// Zeros on top; w >= a.
    Zext,
    /// Copies of the sign on top; w >= a.
    Sext,
    /// w copies of one bit.
    Rep,
    /// A register; operand d (for a loop register filled in when the loop is closed). Cleared by `rst` if `reset`.
    Reg {
        /// Synchronous reset to zero.
        reset: bool,
        /// True when d comes from the last stage of the loop instead of the stage before.
        wrap: bool,
        /// What it holds where d is unknown (x) in a simulation; `None`: x. Of one bit only. Without meaning for known values.
        unknown: Option<bool>,
    },
    /// A net declared before what drives it; w = a.
    Wire,
    /// Output `port` (index into the instantiated module's ports) of an instance.
    InstOut(InstId, usize),
}

impl Op {
    /// Name for messages.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Input(_) => "input",
            Self::Zeros => "zeros",
            Self::Ones => "ones",
            Self::Lit(_) => "literal",
            Self::Konst(_) => "constant",
            Self::Not => "not",
            Self::And => "and",
            Self::Or => "or",
            Self::Xor => "xor",
            Self::RedOr => "or-reduce",
            Self::RedAnd => "and-reduce",
            Self::Add => "add",
            Self::Sub => "sub",
            Self::Mul => "mul",
            Self::Eq => "eq",
            Self::Ult => "ult",
            Self::Slt => "slt",
            Self::Shl => "shl",
            Self::Shr => "shr",
            Self::Sar => "sar",
            Self::Mux => "mux",
            Self::Concat => "concat",
            Self::Slice { .. } => "slice",
            Self::Zext => "zext",
            Self::Sext => "sext",
            Self::Rep => "replicate",
            Self::Reg { .. } => "register",
            Self::Wire => "wire",
            Self::InstOut(..) => "instance output",
        }
    }
    /// Whether it moves words as they are, so that a bundle of more than 64 bits may pass.
    pub fn carries(&self) -> bool {
        use Op::*;
        matches!(self, Input(_) | InstOut(..) | Wire | Reg { .. } | Concat | Slice { .. } | Mux)
    }
    /// Constants have no stage.
    pub fn is_const(&self) -> bool {
        matches!(self, Self::Zeros | Self::Ones | Self::Lit(_) | Self::Konst(_))
    }
}

/// The pipeline stage of a value; constants and static inputs have none.
pub type Stage = Option<u32>;

/// One operation and its result.
#[derive(Clone, Debug)]
pub struct Node {
    /// What is computed.
    pub op: Op,
    /// Operands.
    pub args: Vec<NodeId>,
    /// Width of the result in bits.
    pub width: Expr,
    /// Base name; the printer puts the stage before it.
    pub name: Option<String>,
    /// Stage in which the result stands.
    pub stage: Stage,
    /// Index into `Module::sections`.
    pub section: usize,
    /// True for bits whose delays are cleared by reset.
    pub valid: bool,
    /// What it is and in which unit, for a comment where its net is declared.
    pub doc: Option<String>,
    /// It comes out of a handshake: it belongs to no stage of this module, and its name has none.
    pub handshaked: bool,
}

/// Direction of a port.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dir {
    /// Into the module.
    In,
    /// Out of the module.
    Out,
}

/// A port; its name is API and is never changed.
#[derive(Clone, Debug)]
pub struct Port {
    /// Name as printed.
    pub name: String,
    /// Direction.
    pub dir: Dir,
    /// Width in bits.
    pub width: Expr,
    /// Meaning, one line.
    pub doc: String,
    /// How its bits are read, and what the value counts.
    pub unit: Quantity,
    /// Stage at which an input is read or an output appears.
    pub stage: Stage,
}

impl Port {
    /// What it means, with its unit in brackets.
    pub fn meaning(&self) -> String {
        match self.unit.kind() {
            Kind::Bit | Kind::Clock => self.doc.clone(),
            Kind::Integer | Kind::Float => format!("{} [{}]", self.doc, self.unit),
        }
    }
}

/// A Verilog parameter.
#[derive(Clone, Debug)]
pub struct Param {
    /// Name as printed.
    pub name: String,
    /// Default value.
    pub default: i64,
    /// Meaning and unit, one line.
    pub doc: String,
}

/// A Verilog parameter that names a file for `$readmemh`; without a file ("") a memory holds unknown words at power-up.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FileParam {
    /// Name as printed.
    pub name: String,
    /// Meaning, one line.
    pub doc: String,
}

/// A named derived constant, printed as a `localparam`.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Local {
    /// Name as printed.
    pub name: String,
    /// Its value.
    pub value: Expr,
    /// Meaning, one line.
    pub doc: String,
}

/// A condition on parameters, `lhs <= rhs`; elaboration fails where it does not hold.
#[derive(Clone, Debug)]
pub struct Check {
    /// Left side.
    pub lhs: Expr,
    /// Right side.
    pub rhs: Expr,
}

/// Another module in use.
#[derive(Clone, Debug)]
pub struct Instance {
    /// What is instantiated.
    pub module: Arc<Module>,
    /// Instance name.
    pub name: String,
    /// Parameter values.
    pub params: Vec<(String, Expr)>,
    /// File parameters that are passed on under their own name: the name, and what stands after the name of the file.
    pub files: Vec<(String, String)>,
    /// Input port index and the value that drives it.
    pub inputs: Vec<(usize, NodeId)>,
    /// Stage of its inputs.
    pub stage: Stage,
    /// Section it stands in.
    pub section: usize,
}

/// A heading in the emitted text.
#[derive(Clone, Debug, Default)]
pub struct Section {
    /// Short title.
    pub title: String,
    /// Why it is done so.
    pub reason: String,
}

/// What is inside a module.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Body {
    /// The graph in `Module::nodes`.
    Graph,
    /// A primitive.
    Prim(Prim),
}

/// A hardware module.
#[derive(Clone, Debug)]
pub struct Module {
    /// Verilog module name.
    pub name: String,
    /// One sentence: what it does.
    pub summary: String,
    /// What was chosen at generation and no parameter can change: name and word, both of letters, digits and `_`.
    pub choices: Vec<(String, String)>,
    /// More of them, for the banner alone: the digest of the module's ports and operations tells them apart.
    pub described: Vec<(String, String)>,
    /// The digest of what is no parameter, once it was asked for.
    pub variant_memo: super::memo::Memo,
    /// Further banner lines: formats, policies, deviations.
    pub notes: Vec<String>,
    /// Rust source file that describes it, from the crate's root.
    pub source: String,
    /// Parameters in printed order.
    pub params: Vec<Param>,
    /// File parameters, printed after them.
    pub files: Vec<FileParam>,
    /// Conditions on the parameters.
    pub checks: Vec<Check>,
    /// Named derived constants, in order of dependence.
    pub locals: Vec<Local>,
    /// Ports in printed order (clock, enable and reset included).
    pub ports: Vec<Port>,
    /// Graph.
    pub nodes: Vec<Node>,
    /// Instances.
    pub insts: Vec<Instance>,
    /// Output port index and the node that drives it.
    pub outputs: Vec<(usize, NodeId)>,
    /// Values (or parts of them) that are deliberately not used.
    pub unused: Vec<NodeId>,
    /// Headings.
    pub sections: Vec<Section>,
    /// What the end of its description found: see [`Module::latency`].
    pub(crate) latency: Option<u32>,
    /// Clocks between two inputs.
    pub throughput: String,
    /// Graph or primitive.
    pub body: Body,
    /// The clock, clock enable and reset ports it has.
    pub clk: Option<usize>,
    /// Clock enable port.
    pub ce: Option<usize>,
    /// Reset port.
    pub rst: Option<usize>,
}

impl Module {
    /// Clocks from input to output, the stage in which all outputs stand; `None` for handshaked modules.
    pub fn latency(&self) -> Option<u32> {
        self.latency
    }
    /// The default parameter values.
    pub fn default_binding(&self) -> Binding {
        self.params.iter().map(|p| (p.name.clone(), p.default)).collect()
    }
    /// The defaults with `over` put over those names that this module has.
    pub fn binding_with(&self, over: &Binding) -> Binding {
        let mut b = self.default_binding();
        for (k, v) in over {
            if let Some(slot) = b.get_mut(k) {
                *slot = *v;
            }
        }
        b
    }
    /// A port by name.
    pub fn port(&self, name: &str) -> Option<(usize, &Port)> {
        self.ports.iter().enumerate().find(|(_, p)| p.name == name)
    }
    /// Of a unit with a handshake, the output `x_valid` that says whether the word of the output `x_data` counts.
    pub fn valid_of(&self, output: &str) -> Option<&Port> {
        let valid = format!("{}_valid", output.strip_suffix("_data")?);
        self.port(&valid).map(|p| p.1).filter(|p| p.dir == Dir::Out && self.latency.is_none())
    }
    /// The data inputs: all but clock, enable and reset.
    pub fn data_inputs(&self) -> impl Iterator<Item = (usize, &Port)> {
        let control = [self.clk, self.ce, self.rst];
        self.ports.iter().enumerate().filter(move |(i, p)| p.dir == Dir::In && !control.contains(&Some(*i)))
    }
    /// The outputs.
    pub fn data_outputs(&self) -> impl Iterator<Item = (usize, &Port)> {
        self.ports.iter().enumerate().filter(|(_, p)| p.dir == Dir::Out)
    }
    /// This module and all below it, leaves first, each once.
    pub fn hierarchy(self: &Arc<Self>) -> Vec<Arc<Module>> {
        fn walk(m: &Arc<Module>, out: &mut Vec<Arc<Module>>) {
            if out.iter().any(|o| o.name == m.name) {
                return;
            }
            m.insts.iter().for_each(|i| walk(&i.module, out));
            out.push(m.clone());
        }
        let mut out = Vec::new();
        walk(self, &mut out);
        out
    }
    /// The node of an id.
    pub fn node(&self, id: NodeId) -> &Node {
        &self.nodes[id.0 as usize]
    }
    /// The checks that fail at a binding, as text.
    pub fn failed_checks(&self, b: &Binding) -> Vec<String> {
        let bad = self.checks.iter().filter(|c| c.lhs.eval_wide(b) > c.rhs.eval_wide(b));
        bad.map(|c| {
            format!(
                "{}: {} <= {} does not hold ({} > {})",
                self.name,
                c.lhs,
                c.rhs,
                c.lhs.eval_wide(b),
                c.rhs.eval_wide(b)
            )
        })
        .collect()
    }
}
