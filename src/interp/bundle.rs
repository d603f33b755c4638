//! Bundles of more than 64 bits: no operation computes with them, so the interpreter carries the words that they were made of, one beside
//! the other, and takes them out again where a slice asks for one.
use super::flat::Flat;
use super::netlist::{Kind, Slot};
use reliefrtl_base::bits::MAX_WIDTH;
use reliefrtl_ir::{Binding, Module, NodeId, Op};

/// The slots of a value, lowest first: one for a word, some for a bundle.
#[derive(Clone, Debug, Default)]
pub(super) struct Parts(Vec<Slot>);

impl From<Slot> for Parts {
    fn from(s: Slot) -> Self {
        Self(vec![s])
    }
}

impl Parts {
    /// The slot of a word.
    pub fn word(&self) -> Slot {
        assert!(self.0.len() == 1, "a bundle is carried, not computed with");
        self.0[0]
    }
    /// Whether there is more than one.
    pub fn is_bundle(&self) -> bool {
        self.0.len() > 1
    }
    /// The slots, lowest first.
    pub fn iter(&self) -> impl Iterator<Item = Slot> {
        self.0.iter().copied()
    }
    /// Another slot for each.
    pub fn map(&self, f: impl FnMut(Slot) -> Slot) -> Self {
        Self(self.iter().map(f).collect())
    }
}

impl Flat {
    /// Widths of the parts of a value, lowest first.
    pub fn widths_of(&self, p: &Parts) -> Vec<u32> {
        p.iter().map(|s| self.width(s)).collect()
    }
    /// Parts that no operation computes.
    pub fn sources(&mut self, widths: &[u32]) -> Parts {
        Parts(widths.iter().map(|w| self.source(*w)).collect())
    }
    /// Names a value; the parts of a bundle by their bits.
    pub fn name_parts(&mut self, name: &str, p: &Parts) {
        if !p.is_bundle() {
            return self.name(name, p.word());
        }
        let mut lo = 0;
        for s in p.iter() {
            let w = self.width(s);
            self.name(&format!("{name}[{}:{lo}]", lo + w - 1), s);
            lo += w;
        }
    }

    /// Widths of the parts in which a register or a wire carries its bundle: those of what drives it, so that words stay whole.
    pub fn shape(&self, m: &Module, b: &Binding, known: &[Parts], node: usize) -> Vec<u32> {
        let width = m.nodes[node].width.eval(b) as u32;
        let found = if width > MAX_WIDTH { self.driven(m, b, known, node, &mut vec![]) } else { Some(vec![width]) };
        found.unwrap_or_else(|| (0..width).step_by(MAX_WIDTH as usize).map(|lo| (width - lo).min(MAX_WIDTH)).collect())
    }

    fn driven(&self, m: &Module, b: &Binding, known: &[Parts], node: usize, seen: &mut Vec<usize>) -> Option<Vec<u32>> {
        if known[node].iter().next().is_some() {
            return Some(self.widths_of(&known[node]));
        }
        if seen.contains(&node) {
            return None;
        }
        seen.push(node);
        let n = &m.nodes[node];
        let mut of = |id: &NodeId| self.driven(m, b, known, id.0 as usize, seen);
        match n.op {
            Op::Reg { .. } | Op::Wire => of(&n.args[0]),
            Op::Mux => of(&n.args[1]).or_else(|| of(&n.args[2])),
            Op::Concat => n.args.iter().rev().map(of).collect::<Option<Vec<_>>>().map(|parts| parts.concat()),
            _ if n.width.eval(b) <= i64::from(MAX_WIDTH) => Some(vec![n.width.eval(b) as u32]),
            _ => None,
        }
    }

    /// A concatenation, slice or choice of which a bundle is the result or the operand.
    pub fn carried(&mut self, op: &Op, args: &[&Parts], width: u32, b: &Binding) -> Parts {
        match op {
            Op::Concat => Parts(args.iter().rev().flat_map(|p| p.iter()).collect()),
            Op::Slice { lo } => {
                let parts = self.bits(args[0], lo.eval(b) as u32, width);
                if width > MAX_WIDTH { parts } else { self.joined(&parts).into() }
            }
            Op::Mux => {
                let (choice, other) = (args[0].word(), self.reshaped(args[2], &self.widths_of(args[1])));
                let pairs: Vec<(Slot, Slot)> = args[1].iter().zip(other.iter()).collect();
                Parts(pairs.iter().map(|(x, y)| self.op(Kind::Mux, &[choice, *x, *y], self.width(*x), 0)).collect())
            }
            _ => unreachable!("{} computes", op.name()),
        }
    }

    /// The same bits in parts of other widths.
    pub fn reshaped(&mut self, p: &Parts, widths: &[u32]) -> Parts {
        if self.widths_of(p) == widths {
            return p.clone();
        }
        let mut lo = 0;
        let mut part = |w: &u32| {
            let bits = self.bits(p, lo, *w);
            lo += w;
            self.joined(&bits)
        };
        Parts(widths.iter().map(&mut part).collect())
    }

    /// `width` bits from `lo` up, in the parts that have them.
    fn bits(&mut self, p: &Parts, lo: u32, width: u32) -> Parts {
        let (mut at, mut out) = (0, vec![]);
        for s in p.iter() {
            let w = self.width(s);
            let (from, to) = (lo.max(at), (lo + width).min(at + w));
            if from < to {
                out.push(self.op(Kind::Slice, &[s], to - from, from - at));
            }
            at += w;
        }
        Parts(out)
    }

    /// Parts of 64 bits at most in all as one word.
    fn joined(&mut self, p: &Parts) -> Slot {
        let mut parts = p.iter();
        let low = parts.next().expect("a word has bits");
        parts.fold(low, |low, high| {
            let (w, more) = (self.width(low), self.width(high));
            self.op(Kind::Join, &[high, low], w + more, w)
        })
    }
}
