//! Width and constant expressions over module parameters.
use reliefrtl_base::bits;
use std::collections::BTreeMap;
use std::fmt;
use std::ops::{Add, Mul, Sub};
use std::sync::Arc;

/// Values of a module's parameters at one elaboration.
pub type Binding = BTreeMap<String, i64>;

/// A linear combination of atoms plus a constant; kept canonical, so equal expressions compare equal.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Expr {
    terms: Vec<(Atom, i64)>,
    konst: i64,
}

/// What an expression is linear in.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Atom {
    /// A Verilog parameter.
    Param(String),
    /// A named derived constant (a `localparam`) and what it stands for.
    Local(String, Arc<Expr>),
    /// A function of expressions.
    Call(Func, Vec<Expr>),
}

/// Functions that width expressions may use.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Func {
    /// `$clog2`.
    Clog2,
    /// The larger of two.
    Max,
    /// The smaller of two.
    Min,
    /// Product of two.
    Mul,
    /// Quotient, toward zero.
    Div,
    /// 2 to a power.
    Pow2,
}

impl From<i64> for Expr {
    fn from(konst: i64) -> Self {
        Self { terms: Vec::new(), konst }
    }
}
impl From<i32> for Expr {
    fn from(k: i32) -> Self {
        Self::from(i64::from(k))
    }
}
impl From<u32> for Expr {
    fn from(k: u32) -> Self {
        Self::from(i64::from(k))
    }
}
impl From<&Expr> for Expr {
    fn from(e: &Expr) -> Self {
        e.clone()
    }
}

impl Expr {
    /// The parameter `name`.
    pub fn param(name: &str) -> Self {
        Self::atom(Atom::Param(name.to_string()))
    }
    /// A named derived constant.
    pub fn local(name: &str, value: Expr) -> Self {
        Self::atom(Atom::Local(name.to_string(), Arc::new(value)))
    }
    fn atom(a: Atom) -> Self {
        Self { terms: vec![(a, 1)], konst: 0 }
    }
    fn call(f: Func, args: Vec<Expr>) -> Self {
        if args.iter().all(|a| a.terms.is_empty()) {
            let v: Vec<i128> = args.iter().map(|a| i128::from(a.konst)).collect();
            return Self::from(i64::try_from(apply(f, &v)).expect("constant expression fits 64 bits"));
        }
        Self::atom(Atom::Call(f, args))
    }
    /// Smallest k with 2^k >= self.
    pub fn clog2(&self) -> Self {
        Self::call(Func::Clog2, vec![self.clone()])
    }
    /// The larger of two.
    pub fn larger(&self, o: impl Into<Expr>) -> Self {
        let o = o.into();
        if *self == o { o } else { Self::call(Func::Max, vec![self.clone(), o]) }
    }
    /// The smaller of two.
    pub fn smaller(&self, o: impl Into<Expr>) -> Self {
        let o = o.into();
        if *self == o { o } else { Self::call(Func::Min, vec![self.clone(), o]) }
    }
    /// Product.
    pub fn times(&self, o: impl Into<Expr>) -> Self {
        let o = o.into();
        match (self.as_const(), o.as_const()) {
            (Some(k), _) => o * k,
            (_, Some(k)) => self.clone() * k,
            _ => Self::call(Func::Mul, vec![self.clone(), o]),
        }
    }
    /// Quotient, toward zero.
    pub fn div(&self, o: impl Into<Expr>) -> Self {
        Self::call(Func::Div, vec![self.clone(), o.into()])
    }
    /// 2 to the power self.
    pub fn pow2(&self) -> Self {
        Self::call(Func::Pow2, vec![self.clone()])
    }
    /// The value if no parameter occurs.
    pub fn as_const(&self) -> Option<i64> {
        self.terms.is_empty().then_some(self.konst)
    }
    /// The terms and the constant.
    pub fn parts(&self) -> (&[(Atom, i64)], i64) {
        (&self.terms, self.konst)
    }
    /// The value at a binding.
    ///
    /// # Panics
    /// If a parameter is not bound.
    pub fn eval(&self, b: &Binding) -> i64 {
        i64::try_from(self.eval_wide(b)).expect("expression fits 64 bits")
    }
    /// The value at a binding, in 128 bits.
    pub fn eval_wide(&self, b: &Binding) -> i128 {
        self.terms.iter().fold(i128::from(self.konst), |s, (a, k)| s + i128::from(*k) * a.eval(b))
    }
    /// The parameters and locals that occur, outermost first.
    pub fn visit_atoms(&self, f: &mut impl FnMut(&Atom)) {
        for (a, _) in &self.terms {
            f(a);
            match a {
                Atom::Call(_, args) => args.iter().for_each(|e| e.visit_atoms(f)),
                Atom::Local(_, e) => e.visit_atoms(f),
                Atom::Param(_) => {}
            }
        }
    }
    /// The expression with what `other` has for an atom in its place; where it has nothing, the arguments of a function are looked at.
    pub fn with_atoms(&self, other: &impl Fn(&Atom) -> Option<Expr>) -> Self {
        self.terms.iter().fold(Self::from(self.konst), |sum, (a, k)| {
            let e = other(a).unwrap_or_else(|| match a {
                Atom::Call(f, args) => Self::call(*f, args.iter().map(|x| x.with_atoms(other)).collect()),
                _ => Self::atom(a.clone()),
            });
            sum + e * *k
        })
    }
    /// The expression in terms of parameters only (ports stand before any `localparam`).
    pub fn expanded(&self) -> Self {
        self.substitute(&BTreeMap::new())
    }
    /// The expression with every parameter replaced (used when an instance binds parameters).
    pub fn substitute(&self, map: &BTreeMap<String, Expr>) -> Self {
        self.terms.iter().fold(Self::from(self.konst), |s, (a, k)| {
            let e = match a {
                Atom::Param(n) => map.get(n).cloned().unwrap_or_else(|| Self::param(n)),
                Atom::Local(_, e) => e.substitute(map),
                Atom::Call(f, args) => Self::call(*f, args.iter().map(|x| x.substitute(map)).collect()),
            };
            s + e * *k
        })
    }
}

impl Atom {
    fn eval(&self, b: &Binding) -> i128 {
        match self {
            Self::Param(n) => i128::from(*b.get(n).unwrap_or_else(|| panic!("parameter {n} is not bound"))),
            Self::Local(_, e) => e.eval_wide(b),
            Self::Call(f, args) => apply(*f, &args.iter().map(|e| e.eval_wide(b)).collect::<Vec<_>>()),
        }
    }
}

fn apply(f: Func, v: &[i128]) -> i128 {
    match f {
        Func::Clog2 => bits::clog2(v[0]),
        Func::Max => v[0].max(v[1]),
        Func::Min => v[0].min(v[1]),
        Func::Mul => v[0] * v[1],
        Func::Div => v[0] / v[1],
        Func::Pow2 => 1 << v[0],
    }
}

fn combine(a: &Expr, b: &Expr, sign: i64) -> Expr {
    let mut terms = a.terms.clone();
    for (atom, k) in &b.terms {
        match terms.iter_mut().find(|(t, _)| t == atom) {
            Some((_, c)) => *c += sign * k,
            None => terms.push((atom.clone(), sign * k)),
        }
    }
    terms.retain(|(_, k)| *k != 0);
    terms.sort_by(|x, y| (x.1 < 0, &x.0).cmp(&(y.1 < 0, &y.0)));
    Expr { terms, konst: a.konst + sign * b.konst }
}

impl<T: Into<Expr>> Add<T> for Expr {
    type Output = Expr;
    fn add(self, o: T) -> Expr {
        combine(&self, &o.into(), 1)
    }
}
impl<T: Into<Expr>> Sub<T> for Expr {
    type Output = Expr;
    fn sub(self, o: T) -> Expr {
        combine(&self, &o.into(), -1)
    }
}
impl<T: Into<Expr>> Add<T> for &Expr {
    type Output = Expr;
    fn add(self, o: T) -> Expr {
        combine(self, &o.into(), 1)
    }
}
impl<T: Into<Expr>> Sub<T> for &Expr {
    type Output = Expr;
    fn sub(self, o: T) -> Expr {
        combine(self, &o.into(), -1)
    }
}
impl Mul<i64> for Expr {
    type Output = Expr;
    fn mul(mut self, k: i64) -> Expr {
        if k == 0 {
            return Expr::from(0);
        }
        self.terms.iter_mut().for_each(|t| t.1 *= k);
        self.konst *= k;
        self
    }
}

impl fmt::Display for Expr {
    /// Verilog text, in the largest form first: `EXP_W + MAN_W - 1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        for (a, k) in &self.terms {
            let sign = if *k < 0 { "-" } else { "+" };
            match (first, *k < 0) {
                (true, true) => f.write_str("-")?,
                (true, false) => {}
                _ => write!(f, " {sign} ")?,
            }
            if k.abs() != 1 {
                write!(f, "{} * ", k.abs())?;
            }
            write!(f, "{a}")?;
            first = false;
        }
        match (first, self.konst) {
            (true, k) => write!(f, "{k}"),
            (_, 0) => Ok(()),
            (_, k) if k < 0 => write!(f, " - {}", -k),
            (_, k) => write!(f, " + {k}"),
        }
    }
}

impl fmt::Display for Atom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // Names and numbers need no parentheses of their own.
        let operand = |e: &Expr| match e.parts() {
            ([], k) if k >= 0 => e.to_string(),
            ([(Self::Param(_) | Self::Local(..), 1)], 0) => e.to_string(),
            _ => format!("({e})"),
        };
        match self {
            Self::Param(n) | Self::Local(n, _) => f.write_str(n),
            Self::Call(Func::Clog2, a) => write!(f, "$clog2({})", a[0]),
            Self::Call(function, a) => {
                let (x, y) = (operand(&a[0]), a.get(1).map(operand).unwrap_or_default());
                match function {
                    Func::Max => write!(f, "(({x} > {y}) ? {x} : {y})"),
                    Func::Min => write!(f, "(({x} < {y}) ? {x} : {y})"),
                    Func::Mul => write!(f, "({x} * {y})"),
                    Func::Div => write!(f, "({x} / {y})"),
                    Func::Pow2 | Func::Clog2 => write!(f, "(1 << {x})"),
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn canonical_text_and_value() {
        let (e, m) = (Expr::param("EXP_W"), Expr::param("MAN_W"));
        let w = &e + &m + 1;
        assert_eq!((w.clone() - 1).to_string(), "EXP_W + MAN_W");
        assert_eq!((w.clone() - &m - &e).as_const(), Some(1));
        let b = Binding::from([("EXP_W".into(), 7), ("MAN_W".into(), 16)]);
        assert_eq!(w.eval(&b), 24);
        assert_eq!((&w + 1).clog2().eval(&b), 5);
        assert_eq!(e.pow2().eval(&b), 128);
    }
}
