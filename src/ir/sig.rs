//! Operations on values; each states its width law and panics, with the caller's place, when it is broken.
use super::builder::{Builder, Sig};
use super::expr::Expr;
use super::module::{Op, Stage};
use std::ops::{Add, BitAnd, BitOr, BitXor, Not, Sub};

impl<'b> Sig<'b> {
    /// Width in bits.
    pub fn width(self) -> Expr {
        self.b.st.borrow().m.node(self.id).width.clone()
    }
    /// Stage; `None` for constants.
    pub fn stage(self) -> Stage {
        self.b.st.borrow().m.node(self.id).stage
    }
    /// Gives the value its base name.
    pub fn named(self, name: &str) -> Self {
        self.b.st.borrow_mut().m.nodes[self.id.0 as usize].name = Some(name.into());
        self
    }
    /// Says what the value is and in which unit: a comment where its net is declared.
    pub fn doc(self, text: &str) -> Self {
        self.b.st.borrow_mut().m.nodes[self.id.0 as usize].doc = Some(text.into());
        self
    }
    /// What it is: as [`Sig::doc`] says, or the port that it comes from.
    pub fn meaning(self) -> Option<String> {
        let st = self.b.st.borrow();
        let node = st.m.node(self.id);
        let port = || match node.op {
            Op::Input(p) => Some(st.m.ports[p].meaning()),
            Op::InstOut(i, p) => Some(st.m.insts[i.0 as usize].module.ports[p].meaning()),
            _ => None,
        };
        node.doc.clone().or_else(port)
    }
    /// Marks a valid bit: its delays are cleared by reset.
    pub fn valid(self) -> Self {
        self.b.st.borrow_mut().m.nodes[self.id.0 as usize].valid = true;
        self
    }
    /// The value delayed to `stage`.
    ///
    /// # Panics
    /// If it is only known later.
    #[track_caller]
    pub fn at(self, stage: u32) -> Self {
        let Some(mut s) = self.stage() else { return self };
        assert!(s <= stage, "a value of stage {s} is asked for in stage {stage}");
        let mut id = self.id;
        while s < stage {
            id = self.b.delay_once(id);
            s += 1;
        }
        Sig { b: self.b, id }
    }
    /// The value after a handshake: it starts a new count of stages.
    pub fn rebase_stage(self, stage: u32) -> Self {
        let node = &mut self.b.st.borrow_mut().m.nodes[self.id.0 as usize];
        (node.stage, node.handshaked) = (Some(stage), true);
        self
    }
    /// The value without a stage: control that is read as it is now.
    pub fn unstaged(self) -> Self {
        self.b.st.borrow_mut().m.nodes[self.id.0 as usize].stage = None;
        self
    }
    /// Register after the value: it is used one stage later.
    #[track_caller]
    pub fn reg(self) -> Self {
        match self.stage() {
            Some(s) => self.at(s + 1),
            None => self,
        }
    }
    /// Register after the value, if there is one.
    #[track_caller]
    pub fn reg_if(self, exists: bool) -> Self {
        if exists { self.reg() } else { self }
    }
    /// The value delayed to the stage of `other`.
    ///
    /// # Panics
    /// If it is only known later.
    #[track_caller]
    pub fn beside(self, other: Self) -> Self {
        other.stage().map_or(self, |stage| self.at(stage))
    }
    /// Register after a decision of one bit: used one stage later, where it is known in every simulation: an unknown bit counts as `unknown`.
    ///
    /// # Panics
    /// If it has no stage, or a register already.
    #[track_caller]
    pub fn decided(self, unknown: bool) -> Self {
        assert!(self.width() == Expr::from(1), "a decision has one bit");
        Sig { b: self.b, id: self.b.delay_as(self.id, Some(unknown)) }
    }
    #[track_caller]
    fn same(self, o: Self, what: &str) {
        let st = self.b.st.borrow();
        let (a, b) = (&st.m.node(self.id).width, &st.m.node(o.id).width);
        let (a, b) = (a.eval(&st.defaults), b.eval(&st.defaults));
        drop(st);
        assert!(a == b, "{what} of {a} and {b} bits: operands have the same width");
    }
    #[track_caller]
    fn binary(self, op: Op, o: Self) -> Self {
        self.same(o, op.name());
        self.b.push(op, vec![self.id, o.id], self.width())
    }
    #[track_caller]
    fn relation(self, op: Op, o: Self) -> Self {
        self.same(o, op.name());
        self.b.push(op, vec![self.id, o.id], Expr::from(1))
    }
    #[track_caller]
    fn unary(self, op: Op, w: Expr) -> Self {
        self.b.push(op, vec![self.id], w)
    }

    /// Equal; one bit.
    #[track_caller]
    pub fn eq(self, o: Self) -> Self {
        self.relation(Op::Eq, o)
    }
    /// Unsigned less-than; one bit.
    #[track_caller]
    pub fn lt(self, o: Self) -> Self {
        self.relation(Op::Ult, o)
    }
    /// Signed less-than; one bit.
    #[track_caller]
    pub fn slt(self, o: Self) -> Self {
        self.relation(Op::Slt, o)
    }
    /// Unsigned product of a + b bits.
    #[track_caller]
    pub fn product(self, o: Self) -> Self {
        let w = self.width() + o.width();
        self.b.push(Op::Mul, vec![self.id, o.id], w)
    }
    /// Left shift by an unsigned amount.
    #[track_caller]
    pub fn shift_left(self, n: Self) -> Self {
        self.b.push(Op::Shl, vec![self.id, n.id], self.width())
    }
    /// Logical right shift.
    #[track_caller]
    pub fn shift_right(self, n: Self) -> Self {
        self.b.push(Op::Shr, vec![self.id, n.id], self.width())
    }
    /// Arithmetic right shift.
    #[track_caller]
    pub fn sar(self, n: Self) -> Self {
        self.b.push(Op::Sar, vec![self.id, n.id], self.width())
    }
    /// `self ? a : b`.
    #[track_caller]
    pub fn mux(self, a: Self, b: Self) -> Self {
        a.same(b, "mux");
        self.b.push(Op::Mux, vec![self.id, a.id, b.id], a.width())
    }
    /// `width` bits from `lo` up.
    #[track_caller]
    pub fn slice(self, lo: impl Into<Expr>, width: impl Into<Expr>) -> Self {
        let (lo, width) = (lo.into(), width.into());
        {
            let st = self.b.st.borrow();
            let have = st.m.node(self.id).width.eval(&st.defaults);
            let top = (&lo + &width).eval(&st.defaults);
            assert!(top <= have, "slice up to bit {top} of {have} bits");
        }
        self.unary(Op::Slice { lo }, width)
    }
    /// One bit.
    #[track_caller]
    pub fn bit(self, i: impl Into<Expr>) -> Self {
        self.slice(i, 1)
    }
    /// The top bit.
    #[track_caller]
    pub fn msb(self) -> Self {
        self.bit(self.width() - 1)
    }
    /// Zeros on top, to `w` bits.
    #[track_caller]
    pub fn zext(self, w: impl Into<Expr>) -> Self {
        let w = w.into();
        if w == self.width() { self } else { self.unary(Op::Zext, w) }
    }
    /// Copies of the sign on top, to `w` bits.
    #[track_caller]
    pub fn sext(self, w: impl Into<Expr>) -> Self {
        let w = w.into();
        if w == self.width() { self } else { self.unary(Op::Sext, w) }
    }
    /// `w` copies of one bit.
    #[track_caller]
    pub fn rep(self, w: impl Into<Expr>) -> Self {
        self.unary(Op::Rep, w.into())
    }
    /// OR of all bits.
    #[track_caller]
    pub fn any(self) -> Self {
        self.unary(Op::RedOr, Expr::from(1))
    }
    /// AND of all bits.
    #[track_caller]
    pub fn all(self) -> Self {
        self.unary(Op::RedAnd, Expr::from(1))
    }
    /// No bit set.
    #[track_caller]
    pub fn none(self) -> Self {
        !self.any()
    }
    /// Its index in the module.
    pub fn id(self) -> crate::NodeId {
        self.id
    }
    /// The builder it belongs to.
    pub fn builder(self) -> &'b Builder {
        self.b
    }
}

macro_rules! operator {
    ($tr:ident, $f:ident, $op:ident) => {
        impl<'b> $tr for Sig<'b> {
            type Output = Sig<'b>;
            #[track_caller]
            fn $f(self, o: Self) -> Self {
                self.binary(Op::$op, o)
            }
        }
    };
}
operator!(BitAnd, bitand, And);
operator!(BitOr, bitor, Or);
operator!(BitXor, bitxor, Xor);
operator!(Add, add, Add);
operator!(Sub, sub, Sub);

impl<'b> Not for Sig<'b> {
    type Output = Sig<'b>;
    #[track_caller]
    fn not(self) -> Self {
        self.unary(Op::Not, self.width())
    }
}
