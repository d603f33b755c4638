//! Operations that are another value, or one of a cheaper operation: rules that hold for every operand.
use super::flat::Flat;
use super::netlist::*;
use reliefrtl_base::bits::mask;

impl Flat {
    /// The value of `op` without `op`, if one of the rules applies.
    pub fn simpler(&mut self, op: &FlatOp) -> Option<Slot> {
        let [a, b, c] = op.args;
        let (va, vb, vc) = (self.value(a), self.value(b), self.value(c));
        let (w, ones) = (op.width, mask(op.width));
        match op.kind {
            Kind::And if a == b || vb == Some(ones) => Some(a),
            Kind::And if va == Some(ones) => Some(b),
            Kind::And if self.is_repeated(a) => Some(self.choose(a, b, w)),
            Kind::And if self.is_repeated(b) => Some(self.choose(b, a, w)),
            Kind::And if va == Some(0) || vb == Some(0) => Some(self.constant(0, w)),
            Kind::Or if a == b || vb == Some(0) => Some(a),
            Kind::Or if va == Some(0) => Some(b),
            Kind::Or if va == Some(ones) || vb == Some(ones) => Some(self.constant(ones, w)),
            Kind::Xor | Kind::Sub if a == b => Some(self.constant(0, w)),
            Kind::Xor | Kind::Add | Kind::Sub if vb == Some(0) => Some(a),
            Kind::Xor | Kind::Add if va == Some(0) => Some(b),
            Kind::Eq if op.arg_width == 1 => match (va, vb) {
                (Some(1), _) => Some(b),
                (_, Some(1)) => Some(a),
                (Some(0), _) => Some(self.op(Kind::Not, &[b], 1, 0)),
                (_, Some(0)) => Some(self.op(Kind::Not, &[a], 1, 0)),
                _ => None,
            },
            Kind::RedOr | Kind::RedAnd if op.arg_width == 1 => Some(a),
            Kind::Not => self.made_by(a).filter(|x| x.kind == Kind::Not).map(|x| x.args[0]),
            Kind::Sext | Kind::Rep if w == op.arg_width => Some(a),
            Kind::Mux => self.simpler_mux(op, va, vb, vc),
            Kind::Shr => vb.filter(|n| *n < u64::from(w)).map(|n| self.op(Kind::Slice, &[a], w, n as u32)),
            Kind::Shl => match vb? {
                0 => Some(a),
                n if n < u64::from(w) => {
                    let (kept, zeros) = (self.op(Kind::Slice, &[a], w - n as u32, 0), self.constant(0, n as u32));
                    Some(self.op(Kind::Join, &[kept, zeros], w, n as u32))
                }
                _ => Some(self.constant(0, w)),
            },
            Kind::Slice => self.simpler_slice(op),
            Kind::Join => self.simpler_join(op, va),
            _ => None,
        }
    }

    fn is_repeated(&self, s: Slot) -> bool {
        self.made_by(s).is_some_and(|x| x.kind == Kind::Rep)
    }
    /// `{w{bit}} & word` is a choice between the word and 0.
    fn choose(&mut self, repeated: Slot, word: Slot, w: u32) -> Slot {
        let bit = self.made_by(repeated).map_or(repeated, |x| x.args[0]);
        let zero = self.constant(0, w);
        self.op(Kind::Mux, &[bit, word, zero], w, 0)
    }

    fn simpler_mux(&mut self, op: &FlatOp, va: Option<u64>, vb: Option<u64>, vc: Option<u64>) -> Option<Slot> {
        let [a, b, c] = op.args;
        match (va, vb, vc) {
            (Some(s), _, _) => return Some(if s == 1 { b } else { c }),
            _ if b == c => return Some(b),
            (_, Some(1), Some(0)) if op.width == 1 => return Some(a),
            (_, Some(0), Some(1)) if op.width == 1 => return Some(self.op(Kind::Not, &[a], 1, 0)),
            (_, _, Some(0)) if op.width == 1 => return Some(self.op(Kind::And, &[a, b], 1, 0)),
            (_, Some(1), _) if op.width == 1 => return Some(self.op(Kind::Or, &[a, c], 1, 0)),
            _ => {}
        }
        let negated = self.made_by(a).filter(|x| x.kind == Kind::Not)?;
        Some(self.op(Kind::Mux, &[negated.args[0], c, b], op.width, 0))
    }

    /// Slices of slices, and of concatenations of which they touch one part.
    fn simpler_slice(&mut self, op: &FlatOp) -> Option<Slot> {
        if op.aux == 0 && op.width == op.arg_width {
            return Some(op.args[0]);
        }
        // Of zeros that were put on top of a word nothing is left of the word; a kernel of 32 bits would not shift so far.
        if op.aux >= op.arg_width {
            return Some(self.constant(0, op.width));
        }
        let from = self.made_by(op.args[0])?;
        match from.kind {
            Kind::Slice if op.aux + op.width <= from.width => {
                Some(self.op(Kind::Slice, &from.args[..1], op.width, op.aux + from.aux))
            }
            Kind::Join if op.aux + op.width <= from.aux => {
                Some(self.op(Kind::Slice, &from.args[1..2], op.width, op.aux))
            }
            Kind::Join if op.aux >= from.aux => {
                Some(self.op(Kind::Slice, &from.args[..1], op.width, op.aux - from.aux))
            }
            _ => None,
        }
    }

    /// Zeros on top, and neighbouring slices of one word.
    fn simpler_join(&mut self, op: &FlatOp, va: Option<u64>) -> Option<Slot> {
        if va == Some(0) {
            return Some(self.op(Kind::Slice, &op.args[1..2], op.width, 0));
        }
        let (high, low) = (self.made_by(op.args[0])?, self.made_by(op.args[1])?);
        let inside = |x: &FlatOp| x.kind == Kind::Slice && x.aux + x.width <= x.arg_width;
        let neighbours =
            inside(&high) && inside(&low) && high.args[0] == low.args[0] && high.aux == low.aux + low.width;
        neighbours.then(|| self.op(Kind::Slice, &low.args[..1], op.width, low.aux))
    }
}
