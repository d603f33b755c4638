//! The hardware: one file a unit, named as the unit is.
pub mod delay_line;
pub mod div_rows;
mod divider;
pub mod float;
pub mod interleave;
pub mod lzc;
mod quantity;
pub mod recip_table;
pub mod sqrt_rows;
pub mod stream;
pub mod traversal;

use reliefrtl_config::{Design, ExtraUnits};
use reliefrtl_ir::Module;
use std::sync::Arc;

/// The arithmetic of a design and what it is made of, leaves first: units that stand alone, at any legal format.
pub fn arithmetic(d: &Design) -> Vec<Arc<Module>> {
    delay_line::in_lines(arithmetic_in_registers(d), d.latency.delay_line)
}

fn arithmetic_in_registers(d: &Design) -> Vec<Arc<Module>> {
    let mut list = vec![lzc::lzc_module(8)];
    list.extend(d.datapath.kind.facts().reads_nodes.then(|| interleave::interleave_module(d.traverse.levels + 1)));
    list.extend((traversal::Datapath::of(d).arithmetic)(d));
    list.extend(chosen(d, d.extra));
    list
}

/// Units that no traversal needs and that only come where `emit.units` or a command names them, leaves first.
pub fn available(d: &Design) -> Vec<Arc<Module>> {
    delay_line::in_lines(chosen(d, ExtraUnits::ALL), d.latency.delay_line)
}

fn chosen(d: &Design, units: ExtraUnits) -> Vec<Arc<Module>> {
    units.iter().flat_map(|unit| float::extra(d, unit).into_iter().chain(stream::extra(unit))).collect()
}

/// Every unit of a design, leaves first, `traverse` last. What datapath and modes don't need is left out.
pub fn all(d: &Design) -> Vec<Arc<Module>> {
    let t = &d.traverse;
    let path = traversal::Datapath::of(d);
    let parity = traversal::reads_parity(d);
    let mut list = arithmetic_in_registers(d);
    let trims = d.mode.trim != reliefrtl_config::Trim::None;
    let nodes = d.datapath.kind.facts().reads_nodes;
    list.extend((nodes && (d.mode.start_level || trims)).then(|| traversal::start_level(t)));
    if d.mode.lod {
        list.extend([traversal::finest_level(d), traversal::node_hit(t)]);
    }
    let indices = path.level_decision.is_some();
    list.extend(nodes.then(|| traversal::height_address(t)));
    list.extend(indices.then(|| traversal::node_planes(d, parity)));
    list.extend((path.steps)(d));
    if trims {
        list.push(traversal::chord_trim(d));
        list.extend((d.mode.level_up != reliefrtl_config::LevelUp::None).then(|| traversal::trim_return(d)));
    }
    if d.fetch.blocks() {
        list.extend([traversal::cells::block_middle(d), traversal::cells::block_descent(d)]);
    } else {
        list.extend(indices.then(|| traversal::multi_level_down(d)));
    }
    list.extend((path.level_up)(d));
    list.extend(path.level_decision.map(|unit| unit(d)));
    list.extend([(path.setup)(d), (path.hit)(d), traversal::memory(d)]);
    if d.mode.bilinear {
        list.extend(traversal::bilinear::units(d));
    }
    list.push(traversal::traverse(d).module);
    delay_line::in_lines(list, d.latency.delay_line)
}
