//! Text of the harnesses and scripts.
use crate::config::{Design, LevelUp, Trim};
use crate::emit::Files;
use crate::ir::{Binding, Module};
use crate::units::traversal::Traverse;
use minijinja::{Environment, context};
use std::fmt::Write;
use std::sync::Arc;

/// What a proof is about.
#[derive(Clone, Copy, Debug)]
pub struct Proof {
    /// Its name; the harness is `fv_<name>.v`, the script `fv_<name>.sby`.
    pub name: &'static str,
    /// Units that must be part of the design.
    pub units: &'static [&'static str],
    /// What is proved, in a sentence.
    pub claim: &'static str,
    text: &'static str,
    /// The solver: `smtbmc z3` names the assertion that fails, `abc bmc3` ends where the bits are many.
    engine: &'static str,
    /// Parameter values other than the defaults.
    over: &'static [(&'static str, i64)],
    /// The units stand behind each other: the claim is about what leaves after all their clocks, not after those of the first.
    chained: bool,
}

macro_rules! proof {
    ($name:literal, $units:expr, $claim:literal) => {
        proof!($name, $units, $claim, &[], false)
    };
    ($name:literal, $units:expr, $claim:literal, $over:expr) => {
        proof!($name, $units, $claim, $over, true)
    };
    ($name:literal, $units:expr, $claim:literal, $over:expr, $abc:expr) => {
        Proof {
            name: $name,
            units: $units,
            claim: $claim,
            text: include_str!(concat!("templates/fv_", $name, ".v")),
            engine: if $abc { "abc bmc3" } else { "smtbmc z3" },
            over: $over,
            chained: false,
        }
    };
}

impl Proof {
    const fn chained(self) -> Self {
        Self { chained: true, ..self }
    }

    /// Clocks after which the outputs are those of the inputs.
    fn clocks(&self, units: &[Arc<Module>]) -> u32 {
        let of = |name: &&str| units.iter().find(|m| m.name == **name).and_then(|m| m.latency).unwrap_or(0);
        if self.chained { self.units.iter().map(of).sum() } else { of(&self.units[0]) }
    }
}

/// Formats at which a solver compares whole arithmetic units.
const SMALL: &[(&str, i64)] = &[("EXP_W", 4), ("MAN_W", 3)];
/// A format at which two chains of an adder and a multiplier are compared.
const TINY: &[(&str, i64)] = &[("EXP_W", 4), ("MAN_W", 2), ("IDX_W", 5)];

/// The narrowest words of the fixed-point datapath, and a map whose texels are their units.
const NARROW: &[(&str, i64)] = &[("FRACTION_W", 8), ("RECIP_W", 8), ("LEVELS", 8), ("HEIGHT_W", 2), ("TILE_W", 1)];

const ALL: &[Proof] = &[
    proof!("lzc", &["lzc"], "zeros above the count, a one below it, at every width from 1 to 64", &[]),
    proof!("interleave", &["interleave"], "bits go where Morton order puts them, at every width from 1 to 32"),
    proof!("start_level", &["start_level"], "the lowest level whose node holds both ends of the ray"),
    proof!("height_address", &["height_address"], "inside the memory, and no two nodes share a word"),
    proof!("node_planes", &["node_planes"], "extent, exit plane and the texel behind it are those of the node"),
    proof!(
        "multi_level_down",
        &["multi_level_down"],
        "a descent goes at least one level down, stays in its bounds, and obeys the mode"
    ),
    proof!("level_up", &["level_up"], "the rule, and never above the root"),
    proof!("level_decision", &["level_decision"], "hit, descent or crossing: every output is that of the case", &[]),
    proof!(
        "progress",
        &["node_planes", "multi_level_down", "level_decision"],
        "a crossing moves the integer index forward, a descent never back: no ray visits a texel again"
    )
    .chained(),
    proof!("fp_lt", &["fp_lt"], "the order of the numbers, at full width"),
    proof!("fp_add", &["fp_add"], "the exact sum, rounded once (4/3)", SMALL),
    proof!("fp_mul", &["fp_mul"], "the exact product, rounded once (4/3)", SMALL),
    proof!("plane_time", &["plane_time", "fp_mul"], "a later plane never has a smaller parameter (4/2)", TINY),
    proof!(
        "fixed_plane_time",
        &["plane_time", "reciprocal"],
        "the product of distance and slope, rounded down, or all ones: monotone in the plane (8/8)",
        NARROW
    ),
    proof!(
        "fixed_predicted_hit",
        &["ray_setup", "plane_time", "predicted_hit", "reciprocal"],
        "an estimate passes no plane before its parameter (8/8)",
        NARROW
    )
    .chained(),
    proof!(
        "fixed_chord_end",
        &["ray_setup", "plane_time", "chord_end", "reciprocal"],
        "a chord ends behind every plane that is met by its parameter, and so does the ray at the bottom plane (8/8)",
        NARROW
    )
    .chained(),
    proof!("traverse", &["traverse"], "no ray is lost, none comes twice, and an offered result stays, by induction"),
];

/// The proofs that a design has.
pub fn proofs(units: &[Arc<Module>]) -> Vec<&'static Proof> {
    let has = |name: &&str| units.iter().any(|m| m.name == **name);
    ALL.iter().filter(|p| p.units.iter().all(&has)).collect()
}

/// Harness and script of every proof of a design, under `testbench/`; `files` are the emitted modules without folder, in `rtl/`.
pub fn proof_files(d: &Design, units: &[Arc<Module>], t: &Traverse, prefix: &str, files: &[String]) -> Files {
    let mut out = Files::new();
    for p in proofs(units) {
        let over: Binding = p.over.iter().map(|(k, v)| ((*k).to_string(), *v)).collect();
        let flights = Flights::of(t, d.latency.handshake > 0);
        let mut env = Environment::new();
        env.set_keep_trailing_newline(true);
        let (copies, values, name) = (units.to_vec(), over.clone(), prefix.to_string());
        env.add_function("instance", move |unit: String, mark: String, driven: Option<String>| {
            let m = copies.iter().find(|m| m.name == unit).expect("the design has the unit");
            instance(m, &values, &name, &mark, driven.as_deref().unwrap_or_default())
        });
        let (copies, values) = (units.to_vec(), over.clone());
        env.add_function("width", move |unit: String, port: String| {
            let m = copies.iter().find(|m| m.name == unit).expect("the design has the unit");
            m.port(&port).expect("the unit has the port").1.width.eval(&m.binding_with(&values))
        });
        let (copies, values) = (units.to_vec(), over.clone());
        env.add_function("value", move |unit: String, param: String| {
            let m = copies.iter().find(|m| m.name == unit).expect("the design has the unit");
            m.binding_with(&values)[&param]
        });
        let value = context! {
            claim => p.claim, latency => p.clocks(units), prefix,
            levels_down => d.mode.levels_down, parity => matches!(d.mode.level_up, LevelUp::Tevs | LevelUp::Selective),
            trims => d.mode.trim != Trim::None, lod => d.mode.lod, rule => rule(d.mode.level_up), slots => flights.len(), tag_w => d.traverse.tag_bits,
        };
        let text = env.render_str(p.text, value).expect("templates use only what they are given");
        out.insert(format!("testbench/fv_{}.v", p.name), text);
        let extra = if p.name == "traverse" { flights.script() } else { String::new() };
        // Combinational units and constant inputs are proved for good at one depth.
        let latency = p.clocks(units);
        // Long enough for a ray that is lost or doubled to be missed at a door, should the induction fail.
        let (mode, depth) =
            if p.name == "traverse" { ("prove", flights.len() as u32 + 3) } else { ("bmc", latency + 1) };
        out.insert(format!("testbench/fv_{}.sby", p.name), script(p, mode, depth, &extra, files));
    }
    out
}

/// Wires for every port of `m`, free constants where nobody drives them, and an instance. `driven` lists inputs that the harness drives.
fn instance(m: &Module, over: &Binding, prefix: &str, mark: &str, driven: &str) -> String {
    let b = m.binding_with(over);
    let driven: Vec<&str> = driven.split(' ').collect();
    let (mut nets, mut pins) = (String::new(), Vec::new());
    let data = m.data_inputs().map(|p| p.1).map(|p| (p, true)).chain(m.data_outputs().map(|p| (p.1, false)));
    for (p, input) in data {
        let free = if input && !driven.contains(&p.name.as_str()) { "(* anyconst *) " } else { "" };
        writeln!(nets, "  {free}wire [{}:0] {mark}{};", p.width.eval(&b) - 1, p.name).expect("writing to a string");
        pins.push(format!(".{0}({mark}{0})", p.name));
    }
    pins.extend(m.clk.is_some().then(|| ".clk(clk), .ce(1'b1)".to_string()));
    let params = m.params.iter().map(|p| format!(".{}({})", p.name, b[&p.name]));
    let params: Vec<String> = params.collect();
    let params = if params.is_empty() { String::new() } else { format!(" #({})", params.join(", ")) };
    format!("{nets}  {prefix}{}{params} {mark}dut (\n    {}\n  );", m.name, pins.join(",\n    "))
}

fn script(p: &Proof, mode: &str, depth: u32, extra: &str, files: &[String]) -> String {
    let (name, engine) = (p.name, p.engine);
    let list: String = files.iter().map(|f| format!("../rtl/{f}\n")).collect();
    let read: String = files.iter().map(|f| format!("read_verilog {f}\n")).collect();
    format!(
        "[options]\nmode {mode}\ndepth {depth}\n\n[engines]\n{engine}\n\n[script]\nread_verilog -formal fv_{name}.v\n{read}hierarchy -check -top fv_{name}\nproc\nflatten\n{extra}opt_clean\nprep -top fv_{name}\n\n[files]\nfv_{name}.v\n{list}"
    )
}

/// The places of `traverse` that hold a ray: nets of the valid bit and of the tag.
struct Flights(Vec<(String, String)>);

impl Flights {
    fn of(t: &Traverse, skids: bool) -> Self {
        let mut list = vec![("s0_back_valid".to_string(), "s0_back_tag".to_string())];
        list.extend((1..t.slots).map(|k| (format!("s{k}_valid"), format!("s{k}_tag"))));
        list.extend((1..=t.setup).map(|k| (format!("u_setup_delay.s{k}_valid"), format!("u_setup_delay.s{k}_data"))));
        list.extend((1..=t.finish).map(|k| (format!("u_hit_valid.s{k}_valid"), format!("u_hit_tag.s{k}_data"))));
        if skids {
            for (unit, tag) in [("u_setup_skid", "new_tag"), ("u_hit_skid", "waiting_tag")] {
                list.extend(["first", "second"].map(|k| (format!("{unit}.{k}_valid"), format!("{unit}_{tag}.{k}"))));
            }
        }
        Self(list)
    }

    fn len(&self) -> usize {
        self.0.len()
    }

    /// When a ray is done is left open, so what is proved holds whatever the datapath computes.
    fn script(&self) -> String {
        let mut s = "cd fv_traverse\ncutpoint w:dut.s0_back_done\n".to_string();
        for (k, (valid, tag)) in self.0.iter().enumerate() {
            writeln!(s, "connect -nounset -set holds_{k} \\dut.{valid}\nconnect -nounset -set tag_{k} \\dut.{tag}")
                .expect("writing to a string");
        }
        s + "cd ..\n"
    }
}

/// The rule's word in the configuration.
fn rule(up: LevelUp) -> &'static str {
    match up {
        LevelUp::None => "none",
        LevelUp::Tevs => "tevs",
        LevelUp::Selective => "selective",
        LevelUp::Coherent => "coherent",
        LevelUp::Always => "always",
    }
}
