//! The emitted text in Icarus, which knows x: the same rays, the memory as it is at power-up, resets of one clock at random.
use super::{LEVELS, config, scene, unknown_bits};
use crate::budget::share;
use crate::simulators::skip;
use reliefrtl::catalogue::ray_set;
use reliefrtl::config::{Config, Profile};
use reliefrtl::ir::{Dir, Module};
use reliefrtl::project::hardware;
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

const RAYS: usize = 60;

/// `v` in binary, x where `unknown` says so.
fn binary(v: u64, unknown: u64, width: u32) -> String {
    let bit = |k: u32| match (unknown >> k & 1, v >> k & 1) {
        (1, _) => 'x',
        (_, b) => char::from(b'0' + b as u8),
    };
    (0..width).rev().map(bit).collect()
}

/// A bench that drives x wherever nothing is asked, and says what leaves: `ray TAG LIMIT STEPS OUTPUT...` in binary.
fn bench(m: &Module, inputs: &[String], outputs: &[String], words: usize) -> String {
    let b = m.default_binding();
    let width = |name: &str| m.port(name).unwrap().1.width.eval(&b);
    let mut t = String::from("`timescale 1ns/1ps\nmodule unknown;\n");
    for p in &m.ports {
        let kind = if p.dir == Dir::In { "reg" } else { "wire" };
        writeln!(t, "  {kind} [{}:0] {};", p.width.eval(&b) - 1, p.name).unwrap();
    }
    for name in inputs {
        writeln!(t, "  reg [{}:0] of_{name} [0:{}];", width(name) - 1, RAYS - 1).unwrap();
    }
    let pins: Vec<String> = m.ports.iter().map(|p| format!(".{0}({0})", p.name)).collect();
    writeln!(t, "  {} dut ({});", m.name, pins.join(", ")).unwrap();
    let reads: String = inputs.iter().map(|n| format!("    $readmemb(\"{n}.bin\", of_{n});\n")).collect();
    let drive: String = inputs.iter().map(|n| format!("          {n} <= of_{n}[sent_now];\n")).collect();
    let unasked: String = inputs.iter().map(|n| format!("          {n} <= {{{}{{1'bx}}}};\n", width(n))).collect();
    let shown: String = outputs.iter().map(|n| format!("        $write(\" %b\", {n});\n")).collect();
    let heights = width("load_data");
    write!(
        t,
        r#"
  reg [{top}:0] image [0:{last}];
  integer words, resets, k, sent, inside, clocks, patience, sent_now;
  reg after_reset;
  reg [31:0] lfsr;
  initial begin
{reads}    $readmemh("memory.hex", image);
    if ($value$plusargs("words=%d", words) == 0) words = 0;
    if ($value$plusargs("resets=%d", resets) == 0) resets = 0;
    clk = 0; rst = 1; load_en = 0; in_valid = 0; out_ready = 0; sent = 0; inside = 0; clocks = 0; patience = 0;
    after_reset = 0; lfsr = 32'h1357_9bdf; k = 0;
    forever #5 clk = ~clk;
  end
  always @(posedge clk) begin
    clocks <= clocks + 1;
    lfsr <= {{lfsr[30:0], lfsr[31] ^ lfsr[21] ^ lfsr[1] ^ lfsr[0]}};
    rst <= clocks > words + 20 && sent < {rays} && resets > 0 && lfsr[3:0] == 4'd9;
    if (rst) begin
      after_reset <= 1;
      inside = 0;
      if (clocks > 1) begin resets <= resets - 1; $display("reset"); end
    end
    if (after_reset && (^{{in_ready, out_valid, slot_busy, idle}}) === 1'bx) begin
      $display("UNKNOWN in clock %0d: %b %b %b %b", clocks, in_ready, out_valid, slot_busy, idle);
      $finish;
    end
    if (after_reset && !rst && idle && inside != 0) $display("UNKNOWN rays inside while idle: %0d", inside);
    // Loaded word by word; else the port is left alone.
    if (clocks > 0 && k < words) begin
      load_en <= 1; load_addr <= k; load_data <= image[k]; k <= k + 1;
    end else begin
      load_en <= 0; load_addr <= 'bx; load_data <= {heights}'bx;
    end
    out_ready <= lfsr[3] | lfsr[11];
    if (after_reset && !rst) begin
      if (out_valid && out_ready) begin
        inside = inside - 1;
        patience <= 0;
        $write("ray %b %b %b", out_tag, out_limit, out_steps);
{shown}        $display("");
      end else patience <= patience + 1;
      if (in_valid && in_ready) inside = inside + 1;
      sent_now = sent + (in_valid && in_ready ? 1 : 0);
      sent <= sent_now;
      if (k >= words && clocks > words + 4 && sent_now < {rays} && (in_valid && !in_ready || lfsr[5] | lfsr[9])) begin
        in_valid <= 1;
        in_tag <= sent_now;
{drive}      end else begin
        in_valid <= 0;
        in_tag <= 'bx;
{unasked}      end
      if (sent == {rays} && inside == 0 && idle && !in_valid) begin
        $display("end");
        $finish;
      end
      if (patience > 60000) begin
        $display("UNKNOWN fate of %0d rays", inside);
        $finish;
      end
    end else if (rst && after_reset) in_valid <= 0;
  end
endmodule
"#,
        top = heights - 1,
        last = words - 1,
        rays = RAYS,
    )
    .unwrap();
    t
}

fn tool(dir: &Path, program: &str, args: &[&str]) -> String {
    let out = Command::new(program).args(args).current_dir(dir).output().expect("the program runs");
    let said = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    assert!(out.status.success(), "{program} {args:?}: {said}");
    said
}

fn check(c: &Config) {
    let d = c.design();
    let p = hardware(c).unwrap();
    let (m, dir) = (&p.traverse.module, tempfile::tempdir().unwrap());
    let (pyramid, rays) = scene(c, RAYS);
    let set = ray_set(&d, &pyramid, &rays, 1).unwrap();
    for (path, text) in p.files.iter().filter(|f| f.0.ends_with(".v")) {
        std::fs::create_dir_all(dir.path().join("rtl")).unwrap();
        std::fs::write(dir.path().join(path), text).unwrap();
    }
    let write = |name: &str, text: &str| std::fs::write(dir.path().join(name), text).unwrap();
    for (k, column) in set.set.inputs.iter().enumerate() {
        let word = |r: usize| {
            let x = unknown_bits(r, k, set.set.inputs.len(), column.width);
            binary(set.set.stimulus[r][k], x, column.width) + "\n"
        };
        write(&format!("{}.bin", column.name), &(0..RAYS).map(word).collect::<String>());
    }
    set.memory_files().for_each(|(name, text)| write(&name, text));
    let names = |columns: &[reliefrtl::vectors::Column]| columns.iter().map(|c| c.name.clone()).collect::<Vec<_>>();
    let words = pyramid.memory().len();
    let mut text = bench(m, &names(&set.set.inputs), &names(&set.set.outputs), words);
    text = text.replace(&format!("  {} dut", m.name), &format!("  {}{} dut", c.emit.prefix, m.name));
    write("unknown.v", &text);
    tool(dir.path(), "iverilog", &["-g2005", "-y", "rtl", "-s", "unknown", "-o", "unknown.vvp", "unknown.v"]);
    for (loaded, resets) in [(0, 0), (words / 2, 0), (words, 0), (words, 4), (0, 4)] {
        let args = ["-n", "unknown.vvp", &format!("+words={loaded}"), &format!("+resets={resets}")];
        let said = tool(dir.path(), "vvp", &args);
        let at = format!("{loaded} of {words} words, {:?} {:?} {:?}", d.mode, d.datapath.kind, d.latency);
        assert!(!said.contains("UNKNOWN") && said.ends_with("end\n"), "{at}: {said}");
        assert_eq!(said.matches("reset").count() > 1, resets > 0, "{at}: {said}");
        let mut seen = [false; RAYS];
        for line in said.lines().filter(|l| l.starts_with("ray ")) {
            let w: Vec<&str> = line.split_whitespace().skip(1).collect();
            let tag = usize::from_str_radix(w[0], 2).unwrap_or_else(|_| panic!("{at}: {line}"));
            assert!(!std::mem::replace(&mut seen[tag], true), "{at}: ray {tag} came twice");
            assert!(!w[1].contains('x') && !w[2].contains('x'), "{at}: limit and steps are known: {line}");
            let limit = w[1] == "1";
            let whole = w.iter().all(|w| !w.contains('x'));
            if tag % 5 < 2 && (loaded == words || (whole && !limit)) {
                let want: Vec<String> =
                    set.set.outputs.iter().zip(&set.set.expected[tag]).map(|(c, v)| binary(*v, 0, c.width)).collect();
                assert_eq!(w[3..], want, "{at}: ray {tag}");
            }
            assert!(limit || (tag % 5 != 2 && loaded > 0), "{at}: of ray {tag} nothing is known, but it has a hit");
        }
        assert!(resets > 0 || seen.iter().all(|s| *s), "{at}: a ray is missing");
        assert!(seen.iter().filter(|s| **s).count() > 5, "{at}");
    }
}

#[test]
fn unknown_values_reach_no_handshake_in_icarus() {
    if skip() {
        return;
    }
    assert_eq!(LEVELS, 3);
    let list = [
        config(&[], None),
        config(&["latency.handshake=1", "mode.level_up=coherent"], None),
        config(&["latency.handshake=2", "mode.lod=true"], None),
        config(&["latency.handshake=3", "latency.decision=4", "latency.node=2"], None),
        config(&["mode.trim=always", "mode.lod=true"], Some(Profile::Fast)),
        config(&["mode.start_level=false"], Some(Profile::Balanced)),
        config(&["mode.bilinear=true", "latency.handshake=1"], None),
        config(&["datapath.kind=fixed"], None),
        config(&["datapath.kind=fixed", "mode.trim=descent"], Some(Profile::Fast)),
        config(&["datapath.kind=published"], None),
        config(&["datapath.kind=published", "mode.start_level=false"], Some(Profile::Fast)),
    ];
    list.iter().step_by(share(3)).for_each(check);
}
