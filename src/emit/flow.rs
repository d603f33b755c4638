//! What tools need beside the Verilog: scripts for Yosys, nextpnr and Vivado, and the clock as SDC, XDC and LPF.
use super::Files;
use super::parts::{ECP5, GW2A_55, ICE40, Part, XC7A200T};
use crate::config::Config;
use crate::ir::{Body, Module, Prim};
use crate::verilog::SPDX;
use minijinja::{Environment, context};
use std::sync::Arc;

/// A script: its file, its text, and the part that it says of what does not fit.
type Script = (&'static str, &'static str, Option<Part>);

const SCRIPTS: [Script; 8] = [
    ("ecp5.ys", include_str!("templates/ecp5.ys"), Some(ECP5)),
    ("ecp5.sh", include_str!("templates/ecp5.sh"), None),
    ("ice40.ys", include_str!("templates/ice40.ys"), Some(ICE40)),
    ("xilinx.ys", include_str!("templates/xilinx.ys"), Some(XC7A200T)),
    ("gowin.ys", include_str!("templates/gowin.ys"), Some(GW2A_55)),
    ("generic.ys", include_str!("templates/generic.ys"), None),
    ("liberty.ys", include_str!("templates/liberty.ys"), None),
    ("vivado.tcl", include_str!("templates/vivado.tcl"), None),
];

/// What several scripts include.
const SHARED: [(&str, &str); 2] =
    [("fits.ys", include_str!("templates/fits.ys")), ("cells.ys", include_str!("templates/cells.ys"))];

/// Bits from which on a memory is not made of flip-flops: where there are only gates, it stays an instance of its module.
const MACRO_BITS: i64 = 16384;

const CLOCKS: [(&str, &str); 3] = [
    ("sdc", include_str!("templates/clock.sdc")),
    ("xdc", include_str!("templates/clock.xdc")),
    ("lpf", include_str!("templates/clock.lpf")),
];

/// Nanoseconds of a clock of whole MHz, rounded down to picoseconds: a tool that meets it meets the clock.
fn period(mhz: u32) -> String {
    let ps = 1_000_000 / mhz;
    format!("{}.{:03}", ps / 1000, ps % 1000)
}

/// `flow/*` for each of `tops`, in a directory of its own where there are several; `rtl` holds the emitted files, by path, and the clock is
/// `emit.clock_mhz`. `pnr/` is there for what the scripts write, of which nothing is kept.
pub fn flow(c: &Config, tops: &[Arc<Module>], rtl: &Files) -> Files {
    let place = |m: &Module| if tops.len() == 1 { "flow".into() } else { format!("flow/{}{}", c.emit.prefix, m.name) };
    let results = ("pnr/.gitignore".to_string(), licensed("*\n!.gitignore\n"));
    tops.iter().flat_map(|m| of(c, m, rtl, &place(m))).chain([results]).collect()
}

/// Files of the memories below `top` that are no flip-flops where there are only gates.
fn macros(c: &Config, top: &Arc<Module>) -> Vec<String> {
    let large = |m: &Arc<Module>| {
        let b = m.default_binding();
        let bits = || b.get("DEPTH").zip(b.get("DATA_W")).map_or(0, |(depth, width)| depth * width);
        matches!(m.body, Body::Prim(Prim::Memory | Prim::Banks)) && bits() >= MACRO_BITS
    };
    top.hierarchy().iter().filter(|m| large(m)).map(|m| format!("rtl/{}{}.v", c.emit.prefix, m.name)).collect()
}

fn of(c: &Config, top: &Arc<Module>, rtl: &Files, place: &str) -> Files {
    let name = format!("{}{}", c.emit.prefix, top.name);
    let files: Vec<&String> = rtl.keys().filter(|f| f.starts_with("rtl/") && f.ends_with(".v")).collect();
    let inputs: Vec<&str> = top.data_inputs().map(|(_, p)| p.name.as_str()).collect();
    let mhz = c.emit.clock_mhz;
    let up = "../".repeat(place.split('/').count());
    let up = up.trim_end_matches('/');
    let value = context! { top => name, files, inputs, mhz, place, up, ns => period(mhz), clocked => top.clk.is_some(), macros => macros(c, top), least => MACRO_BITS };
    let mut env = Environment::new();
    env.set_keep_trailing_newline(true);
    let mut out = Files::new();
    for (file, text) in SHARED {
        env.add_template(file, text).expect("templates are well formed");
    }
    for (file, text, part) in SCRIPTS {
        let value = context! { part => part.map(|p| p.counted_in_scripts()), ..value.clone() };
        let text = env.render_str(text, &value).expect("templates use only what they are given");
        out.insert(format!("{place}/{file}"), licensed(&text));
    }
    for (kind, text) in CLOCKS {
        let text = env.render_str(text, &value).expect("templates use only what they are given");
        out.insert(format!("{place}/{name}.{kind}"), licensed(&text));
    }
    out
}

/// The text with the licence as its first comment, after the line that names an interpreter.
fn licensed(text: &str) -> String {
    let head = if text.starts_with("#!") { text.find('\n').map_or(0, |at| at + 1) } else { 0 };
    format!("{}# {SPDX}\n{}", &text[..head], &text[head..])
}

#[cfg(test)]
mod tests {
    use super::period;

    #[test]
    fn a_period_is_never_too_long() {
        assert_eq!(period(100), "10.000");
        assert_eq!(period(84), "11.904");
        assert_eq!(period(1000), "1.000");
    }
}
