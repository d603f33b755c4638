//! Streams of the library put together: records of more bits than a word pass a spill register, a FIFO and an arbiter, whose words come out
//! whole and in order, in the interpreter and in Icarus.
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use reliefrtl::interp::{Lanes, elaborate};
use reliefrtl::ir::{BITS, Binding, Builder, Expr, Module, Quantity};
use reliefrtl::units::stream::{InputStream, OutputStream, Stream};
use reliefrtl::verilog::{Style, print_module};
use std::collections::VecDeque;
use std::fmt::Write;
use std::process::Command;
use std::sync::Arc;

/// Fields of the streams, 110 bits in all; the first says which stream a word is of.
const FIELDS: [(&str, u32); 4] = [("from", 1), ("low", 40), ("flag", 5), ("high", 64)];
/// Clocks that are tried.
const CLOCKS: usize = 3000;

/// Stream `a` through a spill register, a map and a FIFO, stream `b` as it is; and the arbiter after them.
fn merged() -> Arc<Module> {
    let fields: Vec<(&str, Expr, Quantity, &str)> = FIELDS.map(|(name, w)| (name, w.into(), BITS, "a word")).to_vec();
    let b = Builder::new("merged", file!(), "two streams into one");
    b.clock();
    b.reset();
    let [first, second] = ["a", "b"].map(|name| InputStream::declare(&b, name, "input ready", &fields));
    let out = OutputStream::declare(&b, "out", &fields);
    let first = first.stream(&b, "a_word").spill(&b, "spilled");
    let first = first.map(|r| r.map(|name, v| if name == "flag" { (!v).named("inverted") } else { v }));
    let both = vec![first.fifo(&b, "queued", 4), second.stream(&b, "b_word")];
    out.take(&b, &Stream::arbiter(&b, "one", both));
    b.finish_streams(&[])
}

/// Rows of a clock: inputs (reset first) and outputs, as the interpreter has them, in which each word was found in its order.
fn interpreted(m: &Module) -> (Vec<Vec<u64>>, Vec<Vec<u64>>) {
    let net = elaborate(m, &Binding::new()).unwrap();
    let mut sim = Lanes::new(&net, 1);
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let (mut rows, mut results) = (vec![], vec![]);
    let mut sent = [VecDeque::<Vec<u64>>::new(), VecDeque::new()];
    let mut waiting: [Option<Vec<u64>>; 2] = [None, None];
    let (mut passed, mut load) = ([0; 2], [8; 3]);
    for clock in 0..CLOCKS {
        if clock % 40 == 0 {
            load = load.map(|_| rng.random_range(1..9));
        }
        let mut drive = |k: usize, held: &Option<Vec<u64>>| {
            let new = |rng: &mut ChaCha8Rng| {
                let word =
                    |(name, w): &(&str, u32)| if *name == "from" { k as u64 } else { rng.random::<u64>() >> (64 - w) };
                FIELDS.iter().map(word).collect()
            };
            held.clone().or_else(|| (rng.random_range(0..8) < load[k]).then(|| new(&mut rng)))
        };
        let inputs = [drive(0, &waiting[0]), drive(1, &waiting[1])];
        let ready = u64::from(rng.random_range(0..8) < load[2]);
        let mut row = vec![u64::from(clock < 2)];
        for o in &inputs {
            row.push(u64::from(o.is_some() && clock > 2));
            row.extend(o.clone().unwrap_or_else(|| vec![0; FIELDS.len()]));
        }
        row.push(ready);
        net.inputs.iter().zip(&row).for_each(|(p, v)| sim.set(p.slot, 0, *v));
        sim.eval();
        let out: Vec<u64> = net.outputs.iter().map(|p| sim.get(p.slot, 0)).collect();
        let of = |name: &str| out[net.outputs.iter().position(|p| p.name == name).unwrap()];
        for (k, o) in inputs.into_iter().enumerate() {
            let valid = row[1 + k * (FIELDS.len() + 1)] == 1;
            let transfer = valid && of(["a_ready", "b_ready"][k]) == 1;
            if let Some(word) = o.clone().filter(|_| transfer) {
                let inverted = |(i, v): (usize, &u64)| if k == 0 && i == 2 { v ^ 31 } else { *v };
                sent[k].push_back(word.iter().enumerate().map(inverted).collect());
            }
            waiting[k] = o.filter(|_| !transfer && valid);
        }
        if clock > 2 && of("out_valid") == 1 && ready == 1 {
            let word: Vec<u64> = FIELDS.iter().map(|(name, _)| of(&format!("out_{name}"))).collect();
            let from = word[0] as usize;
            assert_eq!(sent[from].pop_front().as_ref(), Some(&word), "clock {clock}");
            passed[from] += 1;
        }
        sim.clock();
        rows.push(row);
        results.push(out);
    }
    // A spill register and a FIFO of four words hold six at most, and nothing holds words of the other stream.
    assert!(sent[0].len() <= 6 && sent[1].is_empty(), "{sent:?}");
    assert!(passed.iter().all(|n| *n > CLOCKS / 8), "{passed:?}");
    (rows, results)
}

#[test]
fn records_pass_spill_register_fifo_and_arbiter() {
    let m = merged();
    let (rows, results) = interpreted(&m);
    if std::env::var("RELIEFRTL_NO_SIMULATORS").is_ok_and(|v| v == "1") {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let path = |name: &str| dir.path().join(name).to_str().unwrap().to_string();
    let mut text: String = m.hierarchy().iter().map(|m| print_module(m, &Style::default())).collect();
    let ports = |ports: Vec<(&str, i64)>, kind: &str| -> String {
        ports.iter().fold(String::new(), |s, (name, w)| s + &format!("  {kind} [{}:0] {name};\n", w - 1))
    };
    let width = |name: &str| m.port(name).unwrap().1.width.as_const().unwrap();
    let ins: Vec<(&str, i64)> =
        std::iter::once("rst").chain(m.data_inputs().map(|p| p.1.name.as_str())).map(|n| (n, width(n))).collect();
    let outs: Vec<(&str, i64)> = m.data_outputs().map(|p| p.1.name.as_str()).map(|n| (n, width(n))).collect();
    let columns = ins.len() + outs.len();
    let pins: Vec<String> = ins.iter().chain(&outs).map(|(n, _)| format!(".{n}({n})")).collect();
    text +=
        &format!("module top;\n  reg clk;\n  integer k, checks;\n  reg [63:0] data [0:{}];\n", columns * CLOCKS - 1);
    text += &(ports(ins.clone(), "reg") + &ports(outs.clone(), "wire"));
    writeln!(text, "  {} dut (.clk(clk), {});", Style::default().prefix.to_string() + "merged", pins.join(", "))
        .unwrap();
    writeln!(text, "  initial begin\n    clk = 0;\n    checks = 0;\n    $readmemh(\"{}\", data);", path("data.hex"))
        .unwrap();
    writeln!(text, "    for (k = 0; k < {CLOCKS}; k = k + 1) begin").unwrap();
    for (c, (name, _)) in ins.iter().enumerate() {
        writeln!(text, "      {name} = data[{columns} * k + {c}];").unwrap();
    }
    text += "      #1;\n";
    for (c, (name, w)) in outs.iter().enumerate() {
        // Words count while they are valid.
        let counts = if name.ends_with("_valid") || name.ends_with("_ready") { "1'b1" } else { "out_valid" };
        let at = format!("data[{columns} * k + {}]", ins.len() + c);
        let same = format!("{{{{(64 - {w}){{1'b0}}}}, {name}}} === {at}");
        let same = if *w == 64 { format!("{name} === {at}") } else { same };
        writeln!(text, "      if (k > 2 && {counts}) checks = checks + 1;").unwrap();
        writeln!(
            text,
            "      if (k > 2 && {counts} && !({same})) $display(\"WRONG %0d {name}: %h, not %h\", k, {name}, {at});"
        )
        .unwrap();
    }
    text += "      clk = 1;\n      #1 clk = 0;\n    end\n    $display(\"CHECKS %0d\", checks);\n  end\nendmodule\n";
    let data: String =
        rows.iter().zip(&results).flat_map(|(r, o)| r.iter().chain(o)).map(|v| format!("{v:x}\n")).collect();
    std::fs::write(path("all.v"), &text).unwrap();
    std::fs::write(path("data.hex"), data).unwrap();
    let run = |tool: &str, args: &[&str]| {
        let out = Command::new(tool).args(args).output().unwrap_or_else(|e| panic!("{tool} can't be started: {e}"));
        let said = String::from_utf8_lossy(&out.stdout) + String::from_utf8_lossy(&out.stderr);
        assert!(out.status.success(), "{said}");
        said.into_owned()
    };
    run("iverilog", &["-g2005", "-s", "top", "-o", &path("all.vvp"), &path("all.v")]);
    let said = run("vvp", &["-n", &path("all.vvp")]);
    assert!(!said.contains("WRONG"), "{}", said.lines().take(20).collect::<Vec<_>>().join("\n"));
    let counted = said.lines().find_map(|l| l.strip_prefix("CHECKS ")?.parse::<usize>().ok()).unwrap();
    assert!(counted > 3 * CLOCKS, "{counted}");
}
