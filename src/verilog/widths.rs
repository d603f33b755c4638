//! Widths by the names that they have in a module's text.
use crate::ir::{Atom, Expr, Module};

/// A width by the `localparam` of `m` that has the same value everywhere, where there is one.
pub(super) fn named(m: &Module, w: &Expr) -> Expr {
    let has_name = |e: &Expr| e.parts().0.iter().any(|(a, _)| matches!(a, Atom::Local(..)));
    let flat = w.expanded();
    // A number and a parameter alone say more than a name for them.
    let plain = matches!(flat.parts(), ([], _) | ([(Atom::Param(_), 1)], 0));
    let same = m.locals.iter().find(|(_, e)| !plain && !has_name(w) && e.expanded() == flat);
    same.map_or_else(|| w.clone(), |(name, e)| Expr::local(name, e.clone()))
}
