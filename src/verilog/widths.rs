//! Widths by the names that they have in a module's text.
use reliefrtl_ir::{Atom, Expr, Func, Module};

/// A width by the `localparam` of `m` that has the same value everywhere, where there is one; else with the larger or smaller of two values by
/// the `localparam` that has it.
pub(super) fn named(m: &Module, w: &Expr) -> Expr {
    let has_name = |e: &Expr| e.parts().0.iter().any(|(a, _)| matches!(a, Atom::Local(..)));
    let flat = w.expanded();
    // A number and a parameter alone say more than a name for them.
    let plain = matches!(flat.parts(), ([], _) | ([(Atom::Param(_), 1)], 0));
    let same = m.locals.iter().find(|(_, e)| !plain && !has_name(w) && e.expanded() == flat);
    same.map_or_else(|| with_bounds_named(m, w), |(name, e)| Expr::local(name, e.clone()))
}

/// `w` with each bound (the larger or the smaller of two values) that a `localparam` of `m` has, but for a constant, by its name: written out, it takes a line
/// each time.
pub(super) fn with_bounds_named(m: &Module, w: &Expr) -> Expr {
    let is_bound = |a: &Atom| matches!(a, Atom::Call(Func::Max | Func::Min, _));
    w.with_atoms(&|a| {
        let Atom::Call(f, args) = a else { return None };
        let flat = Atom::Call(*f, args.iter().map(Expr::expanded).collect());
        m.locals.iter().filter(|_| is_bound(a)).find_map(|(name, e)| match e.expanded().parts() {
            ([(bound, 1)], konst) if *bound == flat => Some(Expr::local(name, e.clone()) - konst),
            _ => None,
        })
    })
}
