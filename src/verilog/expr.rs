//! One operation as a Verilog expression.
//!
//! Rules that keep the text's meaning equal to the graph's: only nets are indexed, signed operations and constants
//! with a name stand on their own wire or in braces, a mixed pair of operators always has parentheses, a unary operator
//! stands before a primary, and widening is written out.
use super::layout::{fill, group, literal, range, tight};
use super::widths::{named, with_bounds_named};
use reliefrtl_ir::{Expr, Names, Node, NodeId, Op};

/// How tightly an expression binds.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Binds {
    /// A name, a literal, a concatenation, an indexed name.
    Primary,
    /// `~x`.
    Unary,
    /// An associative operator, which may stand beside itself.
    Assoc(&'static str),
    /// Anything else: always in parentheses as an operand.
    Loose,
}

/// How a module's nodes are written as expressions.
pub trait Expressions {
    /// A node as an operand: its net, or its expression.
    fn operand(&self, id: NodeId) -> (String, Binds);
    /// A node as an operand of a binary operator.
    fn tight(&self, id: NodeId, beside: &'static str) -> String;
    /// The net of an operand that has to have one.
    fn net_of(&self, id: NodeId, n: &Node) -> String;
    /// The expression that computes a node.
    fn expr(&self, n: &Node) -> (String, Binds);
}

impl Expressions for Names<'_> {
    fn operand(&self, id: NodeId) -> (String, Binds) {
        match self.net(id) {
            Some(n) => (n, Binds::Primary),
            // Beside unsigned operands the shift would lose its sign; braces make it an expression of its own.
            None if self.m.node(id).op == Op::Sar => (format!("{{{}}}", self.expr(self.m.node(id)).0), Binds::Primary),
            None => self.expr(self.m.node(id)),
        }
    }

    fn tight(&self, id: NodeId, beside: &'static str) -> String {
        let (s, b) = self.operand(id);
        match b {
            Binds::Primary | Binds::Unary => s,
            Binds::Assoc(o) if o == beside => s,
            _ => format!("({s})"),
        }
    }

    fn net_of(&self, id: NodeId, n: &Node) -> String {
        self.net(id).unwrap_or_else(|| panic!("{}: {} needs a named operand", self.m.name, n.op.name()))
    }

    fn expr(&self, n: &Node) -> (String, Binds) {
        let a = |i: usize| n.args[i];
        let bin = |op: &'static str, assoc: bool| {
            let s = format!("{} {op} {}", self.tight(a(0), op), self.tight(a(1), if assoc { op } else { "" }));
            (s, if assoc { Binds::Assoc(op) } else { Binds::Loose })
        };
        let width = |id: NodeId| self.m.node(id).width.clone();
        match &n.op {
            Op::Zeros => (fill(&named(self.m, &n.width), 0), Binds::Primary),
            Op::Ones => (fill(&named(self.m, &n.width), 1), Binds::Primary),
            Op::Lit(v) => (literal(*v, &n.width), Binds::Primary),
            Op::Konst(_) => {
                let name = konst_name(n);
                (
                    format!("{name}{}", if n.width.as_const() == Some(1) { "[0]".into() } else { range(&n.width) }),
                    Binds::Primary,
                )
            }
            // A unary operator stands before a primary, not before another one.
            Op::Not => (format!("~{}", primary(self.operand(a(0)))), Binds::Unary),
            Op::And => bin("&", true),
            Op::Or => bin("|", true),
            Op::Xor => bin("^", true),
            Op::RedOr => (format!("|{}", primary(self.operand(a(0)))), Binds::Loose),
            Op::RedAnd => (format!("&{}", primary(self.operand(a(0)))), Binds::Loose),
            Op::Add => bin("+", false),
            Op::Sub => bin("-", false),
            Op::Eq => bin("==", false),
            Op::Ult => bin("<", false),
            Op::Shl => bin("<<", false),
            Op::Shr => bin(">>", false),
            Op::Sar => (format!("$signed({}) >>> {}", self.operand(a(0)).0, self.tight(a(1), "")), Binds::Loose),
            Op::Slt => (format!("$signed({}) < $signed({})", self.operand(a(0)).0, self.operand(a(1)).0), Binds::Loose),
            Op::Mul => {
                let (x, y) = (self.operand(a(0)).0, self.operand(a(1)).0);
                let (zx, zy) = (fill(&width(a(1)), 0), fill(&width(a(0)), 0));
                (format!("{{{zx}, {x}}} * {{{zy}, {y}}}"), Binds::Loose)
            }
            Op::Mux => {
                let [c, t, e] = [0, 1, 2].map(|i| self.tight(a(i), ""));
                (format!("{c} ? {t} : {e}"), Binds::Loose)
            }
            Op::Concat => {
                let parts: Vec<String> = n.args.iter().map(|x| self.operand(*x).0).collect();
                (format!("{{{}}}", parts.join(", ")), Binds::Primary)
            }
            Op::Slice { lo } => {
                let net = self.net_of(a(0), n);
                let full = *lo == Expr::from(0) && n.width == width(a(0));
                let hi = with_bounds_named(self.m, &(lo + n.width.clone() - 1));
                let lo = &with_bounds_named(self.m, lo);
                (
                    match (full, n.width.as_const()) {
                        (true, _) => net,
                        (_, Some(1)) => {
                            // The top bit by the width that has a name.
                            let above = lo + 1;
                            let by_name = named(self.m, &above);
                            let at = if by_name == above { lo.clone() } else { by_name - 1 };
                            format!("{net}[{}]", tight(&at))
                        }
                        _ => format!("{net}[{}:{}]", tight(&hi), tight(lo)),
                    },
                    Binds::Primary,
                )
            }
            Op::Zext => {
                let more = with_bounds_named(self.m, &(n.width.clone() - named(self.m, &width(a(0)))));
                (format!("{{{}, {}}}", fill(&more, 0), self.operand(a(0)).0), Binds::Primary)
            }
            Op::Sext => {
                let (net, w) = (self.net_of(a(0), n), width(a(0)));
                let top =
                    if w.as_const() == Some(1) { net.clone() } else { format!("{net}[{}]", tight(&(w.clone() - 1))) };
                (format!("{{{{{}{{{top}}}}}, {net}}}", group(&(n.width.clone() - w))), Binds::Primary)
            }
            Op::Rep => {
                if n.width.as_const() == Some(1) {
                    return self.operand(a(0));
                }
                (format!("{{{}{{{}}}}}", group(&named(self.m, &n.width)), self.operand(a(0)).0), Binds::Primary)
            }
            Op::Reg { .. } | Op::Wire | Op::InstOut(..) | Op::Input(_) => {
                unreachable!("{} always has a net", n.op.name())
            }
        }
    }
}

fn primary((text, binds): (String, Binds)) -> String {
    if binds == Binds::Primary { text } else { format!("({text})") }
}

/// The `localparam` that holds a constant expression.
pub fn konst_name(n: &Node) -> String {
    let name = n.name.as_ref().expect("constant expressions have names");
    let word = |w: &str| w[..1].to_uppercase() + &w[1..];
    name.split('_').map(word).collect()
}
