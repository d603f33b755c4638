//! The models of `tests/cells` against what the vendors publish of the cells, restated here: a memory is a row of bits, a product is a product.
//! A bench is written, with stimulus and expected values of each clock, and each spoiled model fails it.
mod memory;
mod vendors;

use crate::simulators::skip;
use memory::{CLOCKS, bench};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use vendors::{each, memories};

/// A bench of a multiplier: corners and random operands, each side with a sign or without.
fn products(cell: &str, width: usize) -> [String; 2] {
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let top = 1_u64 << (width - 1);
    let corners = [0, 1, top - 1, top, top + 1, 2 * top - 1];
    let mut pairs: Vec<(u64, u64)> = corners.iter().flat_map(|a| corners.map(|b| (*a, b))).collect();
    pairs.extend((0..60).map(|_| (random.next_u64() % (2 * top), random.next_u64() % (2 * top))));
    let mut lines = String::new();
    let mut steps = 0;
    for (a, b) in pairs {
        for signs in 0..4 {
            let value = |x: u64, sign: bool| i128::from(x) - if sign && x >= top { i128::from(2 * top) } else { 0 };
            let product = value(a, signs & 1 == 1) * value(b, signs & 2 == 2);
            let product = product & ((1 << (2 * width)) - 1);
            writeln!(lines, "{a:0width$b}{b:0width$b}{signs:02b}{product:0both$b}", both = 2 * width).unwrap();
            steps += 1;
        }
    }
    let pins = if cell == "MULT18X18D" {
        each("A", 18, "a") + &each("B", 18, "b") + &each("P", 36, "p") + ".SIGNEDA(signs[0]), .SIGNEDB(signs[1])"
    } else {
        ".A(a), .B(b), .ASIGN(signs[0]), .BSIGN(signs[1]), .DOUT(p)".into()
    };
    let (one, two, all) = (width - 1, 2 * width - 1, 4 * width + 1);
    let text = format!(
        "module tb;
  reg [{one}:0] a, b;
  reg [1:0] signs;
  reg [{two}:0] want;
  wire [{two}:0] p;
  {cell} dut ({pins});
  reg [{all}:0] steps [0:{steps} - 1];
  integer n;
  integer wrong = 0;
  initial begin
    $readmemb(\"steps.txt\", steps);
    for (n = 0; n < {steps}; n = n + 1) begin
      {{a, b, signs, want}} = steps[n];
      #1 if (p !== want) wrong = wrong + 1;
    end
    if (wrong == 0) $display(\"PASS\");
    else $display(\"FAIL %0d\", wrong);
    $finish;
  end
endmodule
"
    );
    [text, lines]
}

/// What Icarus says of a bench with the models of `files`, by their texts.
fn said([bench, steps]: &[String; 2], models: &[String], set: &str) -> String {
    let dir = tempfile::tempdir().unwrap();
    std::fs::write(dir.path().join("tb.v"), models.concat() + bench).unwrap();
    std::fs::write(dir.path().join("steps.txt"), steps).unwrap();
    let mut c = Command::new("iverilog");
    c.args(["-g2012", "-s", "tb", "-o", "tb.vvp", &format!("-D{set}"), "tb.v"]).current_dir(dir.path());
    let built = c.output().expect("Icarus is installed: sh tools/test.sh --tools");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let run = Command::new("vvp").args(["-n", "tb.vvp"]).current_dir(dir.path()).output().expect("vvp is there");
    String::from_utf8_lossy(&run.stdout).trim().to_owned()
}

fn model(file: &str) -> String {
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cells").join(file)).unwrap()
}

/// Its name, its text and steps, its models, a macro that is set.
type Bench = (String, [String; 2], [&'static str; 2], &'static str);

/// Every bench.
fn benches() -> Vec<Bench> {
    let memories = memories();
    let memories = memories.iter().map(|m| {
        (format!("{} {:?} {:?}", m.cell, m.reads, m.writes), bench(m, "", CLOCKS), ["block_memory.v", m.file], m.set)
    });
    let products = [
        ("MULT18X18D", 18, "ecp5.v"),
        ("MULT9X9", 9, "gowin.v"),
        ("MULT18X18", 18, "gowin.v"),
        ("MULT36X36", 36, "gowin.v"),
    ]
    .map(|(cell, width, file)| (cell.to_owned(), products(cell, width), ["block_memory.v", file], "UNUSED"));
    memories.chain(products).collect()
}

#[test]
fn models_do_what_the_vendors_publish() {
    if skip() {
        return;
    }
    for (name, bench, files, set) in benches() {
        assert_eq!(said(&bench, &files.map(model), set), "PASS", "{name}");
    }
}

/// What has no model ends the simulation, and says so.
#[test]
fn other_settings_of_a_memory_end_the_simulation() {
    if skip() {
        return;
    }
    let mut seen = std::collections::BTreeSet::new();
    for m in memories().iter().filter(|m| seen.insert(m.cell)) {
        let name = m.cell.trim_end_matches('B');
        let mut settings = vec![(m.missing, 0, "setting")];
        match m.file {
            "ecp5.v" => settings.push((r#", .RESETMODE("ASYNC")"#, CLOCKS, "reset")),
            "gowin.v" => settings.push((r#", .RESET_MODE("ASYNC")"#, CLOCKS, "reset")),
            _ => {}
        }
        for (setting, clocks, what) in settings {
            let said = said(&bench(m, setting, clocks), &["block_memory.v", m.file].map(model), m.set);
            assert!(said.starts_with(&format!("{name}: a {what} that has no model")), "{}: {said}", m.cell);
        }
    }
}

/// Models that are wrong in one place each, by the file: what the vendors publish is looked at.
const SPOILED: [(&str, &str, &str); 25] = [
    ("block_memory.v", "OLD == 0 && we", "OLD == 2 && we"),
    ("block_memory.v", "busy_a = we_a &", "busy_a = 0 &"),
    ("block_memory.v", "busy_b = we_b &", "busy_b = 0 &"),
    ("block_memory.v", "we[at + k - there] !== 0", "we[k] !== 0"),
    ("block_memory.v", "word[BYTE*k+:BYTE] = mem[at + k]", "word[BYTE*k+:BYTE] = mem[at]"),
    ("block_memory.v", "mem[at] >> low", "mem[at]"),
    ("block_memory.v", "mem[at][low + k]", "mem[at][k]"),
    ("block_memory.v", "if (we[k]) mem", "mem"),
    ("block_memory.v", "ad_a[14:3] & ~(BYTES_A - 1)", "ad_a[14:3]"),
    ("block_memory.v", "ad_b[2:0] & ~(WIDTH_B - 1)", "ad_b[2:0]"),
    ("block_memory.v", "row[BYTE*(i%32)+:BYTE]", "row[8*(i%32)+:BYTE]"),
    ("block_memory.v", "if (en_a || rst_a)", "if (en_a)"),
    ("block_memory.v", "if (en_b || rst_b)", "if (en_b)"),
    ("block_memory.v", "(we_a == 0 || MODE_A == 2)", "(we_a == 0 || MODE_A == 1)"),
    ("block_memory.v", "(we_b == 0 || MODE_B == 2)", "(we_b == 0)"),
    ("ecp5.v", "== 0 && !RSTA)", "== 0)"),
    ("ecp5.v", "padded[20*k+:18]", "padded[18*k+:18]"),
    ("ecp5.v", "SIGNEDB & b[17]", "SIGNEDA & b[17]"),
    ("gowin.v", "CEA && BLKSELA == BLK_SEL_0", "CEA"),
    ("gowin.v", "CEA && WREA && BLKSEL", "CEA && BLKSEL"),
    ("gowin.v", "{2'b0, ADA[1:0]}", "4'b11"),
    ("gowin.v", "BSIGN & B[35]", "B[35]"),
    ("xilinx.v", "WRITE_MODE_B == \"READ_FIRST\"", "1"),
    ("xilinx.v", "row[9*k+:9] = {parity[k]", "row[9*k+:9] = {1'b0"),
    ("xilinx.v", "WRITE_WIDTH_B == 72 ? ", "1 ? "),
];

#[test]
fn each_spoiled_model_fails_a_bench() {
    if skip() {
        return;
    }
    let benches = benches();
    for (file, from, to) in SPOILED {
        let text = model(file);
        assert!(text.contains(from), "{file} says {from}");
        let spoiled = text.replace(from, to);
        let of = |name: &str| if name == file { spoiled.clone() } else { model(name) };
        let fails =
            |(_, bench, files, set): &&Bench| files.contains(&file) && said(bench, &files.map(of), set) != "PASS";
        assert!(benches.iter().any(|b| fails(&b)), "{file}: {to} for {from}: no bench sees it");
    }
}
