//! Conditions on parameters that a module takes over from the modules in it, so that the user of the outermost one reads all of them there.
use super::expr::{Atom, Binding, Expr, Func};
use super::module::{Check, Instance, Module};
use reliefrtl_base::bits;
use std::collections::{BTreeMap, BTreeSet};

/// Least and greatest value of an expression.
type Range = (i128, i128);

/// Parameter values that are tried at most to see whether a condition follows; with more of them, bounds decide.
const TRIED: i128 = 2_000;

/// Adds to `m` the conditions of its instances, in terms of its own parameters; those that follow from others are left out.
///
/// # Panics
/// If a condition holds for no value of the parameters: the unit that instantiates gives a wrong one.
pub fn inherit(m: &mut Module) {
    let all = m.insts.iter().flat_map(|i| conditions(i).into_iter().map(|c| (i.name.clone(), c)));
    let (plain, rest): (Vec<_>, Vec<_>) = all.partition(|(_, c)| is_bound(c));
    // What is a bound by a number narrows the values for which the others have to follow.
    for (inst, check) in plain.into_iter().chain(rest) {
        if let Some(excess) = (&check.lhs - &check.rhs).expanded().as_const() {
            assert!(excess <= 0, "{}: {inst} never has {} <= {}", m.name, check.lhs, check.rhs);
            continue;
        }
        if follows(&check, &m.checks) {
            continue;
        }
        let narrower = |c: &Check| {
            let (least, most) = (c.rhs == check.rhs && check.lhs.as_const().is_some(), c.lhs == check.lhs);
            least && c.lhs.as_const().is_some() || most && c.rhs.as_const().is_some() && check.rhs.as_const().is_some()
        };
        match m.checks.iter_mut().find(|c| narrower(c)) {
            Some(weaker) => *weaker = check,
            None => m.checks.push(check),
        }
    }
    // What follows from the others would never be seen to fail; bounds by numbers stay, as they are what the others are tried within.
    for k in (0..m.checks.len()).rev().filter(|k| !is_bound(&m.checks[*k])).collect::<Vec<_>>() {
        let check = m.checks.remove(k);
        if !follows(&check, &m.checks) {
            m.checks.insert(k, check);
        }
    }
}

/// Whether a condition holds wherever others do: tried for every legal value of its parameters where these are few, else by their bounds. What
/// can't be told so does not follow.
fn follows(check: &Check, from: &[Check]) -> bool {
    let bounds = bounds(from);
    let excess = |c: &Check| (&c.lhs - &c.rhs).expanded();
    let below =
        |more: Expr| more.as_const().map_or_else(|| range(&more, &bounds).is_some_and(|r| r.1 <= 0), |k| k <= 0);
    if from.iter().any(|c| below(excess(check) - excess(c))) {
        return true;
    }
    let names = parameters(check);
    let values = |name: &String| bounds.get(name).copied();
    let Some(ranges) = names.iter().map(values).collect::<Option<Vec<Range>>>() else { return false };
    let count = ranges.iter().try_fold(1i128, |n, (low, high)| n.checked_mul((high - low + 1).max(0)));
    if count.is_none_or(|n| n > TRIED) {
        return below(excess(check));
    }
    let among: Vec<Check> = from.iter().filter(|c| parameters(c).is_subset(&names)).cloned().collect();
    let mut at: Binding = names.iter().zip(&ranges).map(|(n, r)| (n.clone(), r.0 as i64)).collect();
    loop {
        if hold(&among, &at) && check.lhs.eval_wide(&at) > check.rhs.eval_wide(&at) {
            return false;
        }
        // The next combination: the first parameter that has a further value takes it, those before start again.
        let next = names.iter().zip(&ranges).find(|(n, r)| {
            let value = at.get_mut(*n).expect("each has a value");
            let more = i128::from(*value) < r.1;
            *value = if more { *value + 1 } else { r.0 as i64 };
            more
        });
        if next.is_none() {
            return true;
        }
    }
}

/// Whether a condition bounds one parameter by a number.
fn is_bound(c: &Check) -> bool {
    let (l, r) = (c.lhs.expanded(), c.rhs.expanded());
    let one = |e: &Expr| matches!(e.parts(), ([(Atom::Param(_), 1)], 0));
    l.as_const().is_some() && one(&r) || one(&l) && r.as_const().is_some()
}

/// The parameters of a condition.
fn parameters(c: &Check) -> BTreeSet<String> {
    fn of(e: &Expr, out: &mut BTreeSet<String>) {
        for (a, _) in e.parts().0 {
            match a {
                Atom::Param(name) => drop(out.insert(name.clone())),
                Atom::Local(_, e) => of(e, out),
                Atom::Call(_, args) => args.iter().for_each(|e| of(e, out)),
            }
        }
    }
    let mut out = BTreeSet::new();
    of(&c.lhs, &mut out);
    of(&c.rhs, &mut out);
    out
}

/// What an instance requires, in terms of the parameters around it; of one parameter, as a bound by a number.
fn conditions(inst: &Instance) -> Vec<Check> {
    let map: BTreeMap<String, Expr> = inst.params.iter().cloned().collect();
    let of = |c: &Check| {
        let (lhs, rhs) = (c.lhs.substitute(&map), c.rhs.substitute(&map));
        let excess = (&lhs - &rhs).expanded();
        match excess.parts() {
            ([(Atom::Param(name), k)], konst) if *k > 0 => {
                Check { lhs: Expr::param(name), rhs: (-konst).div_euclid(*k).into() }
            }
            ([(Atom::Param(name), k)], konst) => {
                Check { lhs: (-(-konst).div_euclid(-k)).into(), rhs: Expr::param(name) }
            }
            _ => Check { lhs, rhs },
        }
    };
    inst.module.checks.iter().map(of).collect()
}

/// The parameters that conditions bound on both sides by numbers.
fn bounds(checks: &[Check]) -> BTreeMap<String, Range> {
    let name = |e: &Expr| match e.parts() {
        ([(Atom::Param(name), 1)], 0) => Some(name.clone()),
        _ => None,
    };
    let of = |e: &Expr| e.as_const().map(i128::from);
    let (mut least, mut most) = (BTreeMap::<String, i128>::new(), BTreeMap::<String, i128>::new());
    for c in checks {
        if let (Some(k), Some(name)) = (of(&c.lhs), name(&c.rhs)) {
            least.entry(name).and_modify(|v| *v = k.max(*v)).or_insert(k);
        }
        if let (Some(name), Some(k)) = (name(&c.lhs), of(&c.rhs)) {
            most.entry(name).and_modify(|v| *v = k.min(*v)).or_insert(k);
        }
    }
    least.into_iter().filter_map(|(name, k)| Some((name.clone(), (k, *most.get(&name)?)))).collect()
}

/// Bounds of an expression for all legal values of the parameters, each by itself; none where a parameter has none, or where numbers become
/// too large to tell.
fn range(e: &Expr, bounds: &BTreeMap<String, Range>) -> Option<Range> {
    let (terms, konst) = e.parts();
    terms.iter().try_fold((i128::from(konst), i128::from(konst)), |(low, high), (a, k)| {
        let (l, h) = of_atom(a, bounds)?;
        let k = i128::from(*k);
        let (l, h) = (l.checked_mul(k)?, h.checked_mul(k)?);
        Some((low.checked_add(l.min(h))?, high.checked_add(l.max(h))?))
    })
}

fn of_atom(a: &Atom, bounds: &BTreeMap<String, Range>) -> Option<Range> {
    let (f, args) = match a {
        Atom::Param(name) => return bounds.get(name).copied(),
        Atom::Local(_, e) => return range(e, bounds),
        Atom::Call(f, args) => (f, args),
    };
    let x = range(&args[0], bounds)?;
    let y = args.get(1).map_or(Some((0, 0)), |e| range(e, bounds))?;
    // Each rises with each of its operands as long as none is negative, but a quotient falls with its divisor.
    let positive = x.0 >= 0 && y.0 >= 0;
    match f {
        Func::Max => Some((x.0.max(y.0), x.1.max(y.1))),
        Func::Min => Some((x.0.min(y.0), x.1.min(y.1))),
        Func::Clog2 if x.0 >= 1 => Some((bits::clog2(x.0), bits::clog2(x.1))),
        Func::Mul if positive => Some((x.0.checked_mul(y.0)?, x.1.checked_mul(y.1)?)),
        Func::Div if positive && y.0 >= 1 => Some((x.0 / y.1, x.1 / y.0)),
        Func::Pow2 if x.0 >= 0 && x.1 < 100 => Some((1 << x.0, 1 << x.1)),
        _ => None,
    }
}

/// Whether the conditions of a module hold at a binding: bounds by numbers first, as what is computed of a parameter may be too large for any
/// number where it is beyond its own.
pub fn hold(checks: &[Check], b: &Binding) -> bool {
    let plain = |c: &&Check| c.lhs.as_const().is_some() || c.rhs.as_const().is_some();
    let (bounds, rest): (Vec<_>, Vec<_>) = checks.iter().partition(plain);
    bounds.into_iter().chain(rest).all(|c| c.lhs.eval_wide(b) <= c.rhs.eval_wide(b))
}

#[cfg(test)]
mod tests {
    use super::super::builder::Builder;
    use super::super::quantity::BITS;
    use super::*;
    use std::sync::Arc;

    /// A module of W bits that requires `least` <= W and 2 W <= `most`.
    fn inner(least: u32, most: u32) -> Arc<Module> {
        let b = Builder::new("inner", file!(), "a word");
        let w = b.param("W", 8, "bits");
        b.require(least, &w);
        b.require(w.clone() * 2, most);
        let a = b.input("a", &w, BITS, "a word");
        let o = b.output("o", &w, BITS, "the word");
        b.drive(o, a);
        b.finish(&[])
    }

    /// What a module of N bits, 2 to 20, requires that instantiates it at W = N + 2.
    fn outer(inner: &Arc<Module>) -> Vec<String> {
        let b = Builder::new("outer", file!(), "a word");
        let n = b.param("N", 8, "bits");
        b.require(2, &n);
        b.require(&n, 20);
        let a = b.input("a", &n + 2, BITS, "a word");
        let o = b.output("o", &n + 2, BITS, "the word");
        let word = b.inst(inner, "u_inner", &[("W", &n + 2)], &[("a", a)]).only().named("word");
        b.drive(o, word);
        let m = b.finish(&[]);
        m.checks.iter().map(|c| format!("{} <= {}", c.lhs, c.rhs)).collect()
    }

    #[test]
    fn what_follows_is_not_said_again() {
        assert_eq!(outer(&inner(4, 44)), ["2 <= N", "N <= 20"]);
    }

    #[test]
    fn a_condition_of_an_instance_is_one_of_the_module_around_it() {
        assert_eq!(outer(&inner(7, 44)), ["5 <= N", "N <= 20"]);
        assert_eq!(outer(&inner(4, 40)), ["2 <= N", "N <= 18"]);
    }

    #[test]
    fn ranges_hold_for_every_legal_value() {
        let (n, m) = (Expr::param("N"), Expr::param("M"));
        let bounds = BTreeMap::from([("N".to_string(), (2, 9)), ("M".to_string(), (1, 4))]);
        let all = [
            &n - &m + 3,
            (&n + 1).clog2() * -2,
            n.pow2() - &m,
            n.times(&m),
            n.larger(m.clone() * 3),
            n.smaller(&m),
            (&n + 1).div(&m),
        ];
        for e in all {
            let (low, high) = range(&e, &bounds).unwrap();
            let value = |n, m| e.eval_wide(&Binding::from([("N".into(), n), ("M".into(), m)]));
            let values: Vec<i128> =
                (2..=9).flat_map(|n| (1..=4).map(move |m| (n, m))).map(|(n, m)| value(n, m)).collect();
            let ends = (*values.iter().min().unwrap(), *values.iter().max().unwrap());
            assert!(low <= ends.0 && ends.1 <= high, "{e}: {low} to {high}, not {ends:?}");
        }
        assert_eq!(range(&Expr::param("K"), &bounds), None);
    }
}
