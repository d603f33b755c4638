//! Widths by the names that they have in a module's text.
use reliefrtl_ir::{Atom, Expr, Func, Local, Module};

/// A width by the `localparam` of `m` that has the same value everywhere, where there is one; else with the larger or smaller of two values by
/// the `localparam` that has it.
pub(super) fn named(m: &Module, w: &Expr) -> Expr {
    let has_name = |e: &Expr| e.parts().0.iter().any(|(a, _)| matches!(a, Atom::Local(..)));
    let flat = w.expanded();
    // A number and a parameter alone say more than a name for them.
    let plain = matches!(flat.parts(), ([], _) | ([(Atom::Param(_), 1)], 0));
    let same = m.locals.iter().find(|l| !plain && !has_name(w) && l.value.expanded() == flat);
    same.map_or_else(|| with_bounds_named(m, w), |l| Expr::local(&l.name, l.value.clone()))
}

/// `w` with each bound (the larger or the smaller of two values) that a `localparam` of `m` has, but for a constant, by its name: written out, it takes a line
/// each time.
pub(super) fn with_bounds_named(m: &Module, w: &Expr) -> Expr {
    let is_bound = |a: &Atom| matches!(a, Atom::Call(Func::Max | Func::Min, _));
    w.with_atoms(&|a| {
        let Atom::Call(f, args) = a else { return None };
        let flat = Atom::Call(*f, args.iter().map(Expr::expanded).collect());
        m.locals.iter().filter(|_| is_bound(a)).find_map(|l| match l.value.expanded().parts() {
            ([(bound, 1)], konst) if *bound == flat => Some(Expr::local(&l.name, l.value.clone()) - konst),
            _ => None,
        })
    })
}

/// A sum of widths, such as that of a bundle, with as many of its terms as possible by the `localparam` of `m` that has them.
pub(super) fn by_parts(m: &Module, w: &Expr) -> Expr {
    let whole = named(m, w);
    let mut rest = whole.clone();
    for Local { name, value: e, .. } in &m.locals {
        let (flat, part) = (rest.expanded(), e.expanded());
        let (terms, konst) = part.parts();
        let of = |a: &Atom| flat.parts().0.iter().find(|t| t.0 == *a).map_or(0, |t| t.1);
        // How often the whole constant stands in what is left.
        let times = terms.iter().map(|(a, k)| if *k > 0 { of(a) / k } else { 0 }).min().unwrap_or(0);
        let times = if konst > 0 { times.min(flat.parts().1 / konst) } else { times };
        let is_name = matches!((terms, konst), ([(Atom::Param(_), 1)], 0));
        if times > 0 && konst >= 0 && !is_name {
            rest = (rest - part * times) + Expr::local(name, e.clone()) * times;
        }
    }
    if rest.to_string().len() < whole.to_string().len() { rest } else { whole }
}

#[cfg(test)]
mod tests {
    use super::*;
    use reliefrtl_ir::Builder;

    #[test]
    fn a_sum_is_said_by_the_constants_of_the_module() {
        let b = Builder::new("m", file!(), "widths");
        let (exp, levels) = (b.param("EXP_W", 7, "bits"), b.param("LEVELS", 8, "bits"));
        b.local("FloatW", &exp + 17, "bits of a float: sign, exponent, fraction");
        b.local("LevelW", (&levels + 1).clog2(), "bits of a level");
        let bundle = exp.clone() * 3 + (&levels + 1).clog2() + &levels + 54;
        let m = b.finish(&[]);
        assert_eq!(by_parts(&m, &bundle).to_string(), "LEVELS + 3 * FloatW + LevelW + 3");
        assert_eq!(by_parts(&m, &(&levels + 2)).to_string(), "LEVELS + 2");
        let at = |e: &Expr| e.eval(&m.default_binding());
        assert_eq!(at(&by_parts(&m, &bundle)), at(&bundle));
    }
}
