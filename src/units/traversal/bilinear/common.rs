//! What several units of the refinement need.
use crate::traversal::height_memory::MEM_INIT;
use reliefrtl_ir::{Builder, Sig};

/// Declares the file of the map's words; each of the four memories of a copy has one of its own.
pub(super) fn preloaded(b: &Builder) {
    let doc = "with .0 to .3 after it, files for $readmemh with every fourth word of level 0; \"\": none";
    b.file_param(MEM_INIT, doc);
}

/// A float with the other sign.
pub(super) fn negated<'b>(b: &'b Builder, x: Sig<'b>, name: &str) -> Sig<'b> {
    b.cat(&[!x.msb(), x.slice(0, x.width() - 1)]).named(name)
}
