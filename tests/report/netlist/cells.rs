//! The models of `tests/cells` against what the vendors publish of the cells, restated here: a memory is a row of bits, a product is a product.
//! A bench is written, with stimulus and expected values of each clock, and each spoiled model fails it.
use super::super::synth::without_tools;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use std::fmt::Write;
use std::path::Path;
use std::process::Command;

/// A bit that may be unknown.
type Bit = Option<bool>;

/// A cell with one memory and two ports, in one of its settings.
struct Memory {
    cell: &'static str,
    /// The file of its model, and a macro that is set for it.
    file: &'static str,
    set: &'static str,
    /// Bits of a byte, and how many bytes there are.
    byte: usize,
    bytes: usize,
    /// Bits of a word at each port; none where the port does not read or does not write.
    reads: [Option<usize>; 2],
    writes: [Option<usize>; 2],
    /// What each port reads as it writes.
    modes: [Mode; 2],
    /// Whether a port that reads what the other one writes sees the old word, and not an unknown one.
    old: bool,
    /// Whether both ports are selected by the same pins.
    shared: bool,
    reset: Reset,
    /// The parameters beside the initial values.
    parameters: String,
    /// What the pins are connected to.
    pins: String,
    /// A setting that the model does not have.
    missing: &'static str,
}

/// What a port reads as it writes: nothing, the new word, the old one.
#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Hold,
    New,
    Old,
}

/// What the reset of a port does.
#[derive(Clone, Copy, PartialEq)]
enum Reset {
    /// Clears the output at any clock.
    Always,
    /// The same, and the port writes nothing.
    AlwaysAndStopsWrites,
    /// Sets the output to this where the port is enabled.
    Enabled(u128),
}

/// What one port is given in a clock. `at` counts bits, of which a byte has 8 with or without parity.
#[derive(Clone, Copy, Default)]
struct Ask {
    enabled: bool,
    selected: bool,
    reset: bool,
    writes: bool,
    bytes: usize,
    at: usize,
    data: u128,
}

impl Memory {
    /// Where the bits of the word at `at` stand in the row of all bits: words below a byte leave the parity bits out.
    fn places(&self, width: usize, at: usize) -> Vec<usize> {
        if width < 8 {
            let first = at / width * width;
            (first..first + width).map(|n| n / 8 * self.byte + n % 8).collect()
        } else {
            let word = at / (8 * (width / self.byte));
            (word * width..(word + 1) * width).collect()
        }
    }
    /// The places that a port writes.
    fn written(&self, port: usize, ask: &Ask) -> Vec<(usize, bool)> {
        let stopped = ask.reset && self.reset == Reset::AlwaysAndStopsWrites;
        let Some(width) = self.writes[port].filter(|_| ask.enabled && ask.selected && ask.writes && !stopped) else {
            return Vec::new();
        };
        let enabled = |k: usize| width <= self.byte || ask.bytes >> (k / self.byte) & 1 == 1;
        let places = self.places(width, ask.at).into_iter().enumerate();
        places.filter(|(k, _)| enabled(*k)).map(|(k, place)| (place, ask.data >> k & 1 == 1)).collect()
    }
    /// The outputs after a clock, with what the memory holds then.
    fn clock(&self, bits: &mut [Bit], out: &mut [Vec<Bit>; 2], asks: &[Ask; 2]) {
        let before = bits.to_vec();
        let written = [0, 1].map(|p| self.written(p, &asks[p]));
        for (place, value) in written.iter().flatten() {
            bits[*place] = Some(*value);
        }
        for port in 0..2 {
            let (Some(width), ask) = (self.reads[port], &asks[port]) else { continue };
            let runs = ask.enabled && ask.selected;
            let writes = runs && ask.writes && self.writes[port].is_some();
            let reset = match self.reset {
                Reset::Enabled(value) => (ask.reset && runs).then_some(value),
                _ => ask.reset.then_some(0),
            };
            if let Some(value) = reset {
                out[port] = (0..width).map(|k| Some(value >> k & 1 == 1)).collect();
                continue;
            }
            if !runs || writes && self.modes[port] == Mode::Hold {
                continue;
            }
            let now: &[Bit] = if writes && self.modes[port] == Mode::New { bits } else { &before };
            // Of a byte that the other port touches nothing is known.
            let lost =
                |place: usize| !self.old && written[1 - port].iter().any(|(w, _)| w / self.byte == place / self.byte);
            let places = self.places(width, ask.at);
            out[port] = places.into_iter().map(|p| if lost(p) { None } else { now[p] }).collect();
        }
    }
    /// The parameters of initial values.
    fn initial(&self, bits: &[Bit]) -> String {
        let bit = |n: usize| bits.get(n).copied().flatten().unwrap_or_default();
        let value = |width: usize, place: &dyn Fn(usize) -> Option<usize>| {
            let text: String = (0..width).rev().map(|k| if place(k).is_some_and(bit) { '1' } else { '0' }).collect();
            format!("{width}'b{text}")
        };
        let mut out = String::new();
        let total = self.byte * self.bytes;
        match self.cell {
            // Sixteen words of 18 bits, each in 20.
            "DP16KD" => (0..64).for_each(|n| {
                let place = |k: usize| (k % 20 < 18).then_some((16 * n + k / 20) * 18 + k % 20);
                write!(out, ", .INITVAL_{n:02X}({})", value(320, &place)).unwrap();
            }),
            "RAMB18E1" | "RAMB36E1" => {
                for n in 0..self.bytes / 32 {
                    let data = |k: usize| Some((32 * n + k / 8) * 9 + k % 8);
                    write!(out, ", .INIT_{n:02X}({})", value(256, &data)).unwrap();
                }
                for n in 0..self.bytes / 256 {
                    let parity = |k: usize| Some((256 * n + k) * 9 + 8);
                    write!(out, ", .INITP_{n:02X}({})", value(256, &parity)).unwrap();
                }
            }
            _ => (0..64).for_each(|n| {
                let place = |k: usize| Some(total / 64 * n + k);
                write!(out, ", .INIT_RAM_{n:02X}({})", value(total / 64, &place)).unwrap();
            }),
        }
        out
    }
}

impl Ask {
    /// As bits of the stimulus, first to last: enable, select, reset, write, 8 byte enables, 15 address bits, 72 bits of data.
    fn bits(&self) -> String {
        let f = |b: bool| if b { '1' } else { '0' };
        let flags: String = [self.enabled, self.selected, self.reset, self.writes].map(f).iter().collect();
        format!("{flags}{:08b}{:015b}{:072b}", self.bytes, self.at, self.data)
    }
}

/// Clocks of a memory's bench.
const CLOCKS: usize = 600;

/// A bench of a memory: stimulus and expected values of each clock as constants.
fn bench(m: &Memory, setting: &str, clocks: usize) -> [String; 2] {
    let mut random = ChaCha8Rng::seed_from_u64(7);
    let mut draw = |n: usize| random.next_u64() as usize % n;
    let mut bits: Vec<Bit> = (0..m.byte * m.bytes).map(|_| Some(draw(2) == 1)).collect();
    let initial = m.initial(&bits);
    let mut out: [Vec<Bit>; 2] = m.reads.map(|w| vec![Some(false); w.unwrap_or(0)]);
    let mut lines = String::new();
    let last = m.bytes * 8;
    for _ in 0..clocks {
        // Few places, of which the last is one: words meet.
        let asks = loop {
            let mut ask = |port: usize| Ask {
                enabled: draw(8) != 0,
                selected: draw(8) != 0,
                reset: draw(12) == 0,
                writes: draw(2) == 1,
                // A write writes something.
                bytes: 1 << draw(m.writes[port].map_or(1, |w| w.div_ceil(m.byte))) | draw(256),
                at: [draw(128), last - 1 - draw(128)][draw(2)],
                data: (draw(1 << 36) as u128) << 36 | draw(1 << 36) as u128,
            };
            let mut asks = [ask(0), ask(1)];
            asks[1].selected = if m.shared { asks[0].selected } else { asks[1].selected };
            let touched = [0, 1].map(|p| m.written(p, &asks[p]));
            // What two ports write to one byte nobody promises.
            if !touched[0].iter().any(|(a, _)| touched[1].iter().any(|(b, _)| a / m.byte == b / m.byte)) {
                break asks;
            }
        };
        m.clock(&mut bits, &mut out, &asks);
        let shown = |out: &[Bit]| {
            let text: String = out.iter().rev().map(|b| b.map_or('x', |b| if b { '1' } else { '0' })).collect();
            format!("{text:0>72}")
        };
        writeln!(lines, "{}{}{}{}", asks[0].bits(), asks[1].bits(), shown(&out[0]), shown(&out[1])).unwrap();
    }
    let mask = m.reads.map(|w| format!("72'b{:0>72}", "1".repeat(w.unwrap_or(0))));
    let text = format!(
        "module tb;
  reg clk = 0;
  reg en_a, sel_a, rst_a, wr_a, en_b, sel_b, rst_b, wr_b;
  reg [7:0] be_a, be_b;
  reg [14:0] ad_a, ad_b;
  reg [71:0] di_a, di_b;
  reg [71:0] want_a, want_b;
  wire [71:0] do_a, do_b;
  {cell} #({parameters}{initial}{setting}) dut ({pins});
  reg [341:0] steps [0:{clocks}];
  integer n;
  integer wrong = 0;
  initial begin
    if ({clocks} > 0) $readmemb(\"steps.txt\", steps, 0, {clocks} - 1);
    for (n = 0; n < {clocks}; n = n + 1) begin
      {{en_a, sel_a, rst_a, wr_a, be_a, ad_a, di_a, en_b, sel_b, rst_b, wr_b, be_b, ad_b, di_b, want_a, want_b}} = steps[n];
      #5 clk = 1;
      #5 clk = 0;
      if ((do_a & {mask_a}) !== want_a || (do_b & {mask_b}) !== want_b) wrong = wrong + 1;
    end
    if (wrong == 0) $display(\"PASS\");
    else $display(\"FAIL %0d\", wrong);
    $finish;
  end
endmodule
",
        cell = m.cell,
        parameters = m.parameters,
        pins = m.pins,
        mask_a = mask[0],
        mask_b = mask[1],
    );
    [text, lines]
}

/// `{name}{i}` connected to bit `i` of `to`, for each of `n`.
fn each(name: &str, n: usize, to: &str) -> String {
    (0..n).map(|i| format!(".{name}{i}({to}[{i}]), ")).collect()
}

/// Lattice: WE and the lowest address bits say what is written; CS0 low selects; the clock edge, its enable and the reset as TN-02204 draws them.
fn ecp5([a, b]: [usize; 2], modes: [Mode; 2]) -> Memory {
    let name = |m: Mode| ["NORMAL", "WRITETHROUGH", "READBEFOREWRITE"][m as usize];
    let mut pins = String::new();
    for (p, q, width) in [("A", "a", a), ("B", "b", b)] {
        pins += &each(&format!("DI{p}"), 18, &format!("di_{q}"));
        pins += &each(&format!("DO{p}"), 18, &format!("do_{q}"));
        for i in 0..14 {
            let low = if width == 18 && i < 2 { "be" } else { "ad" };
            write!(pins, ".AD{p}{i}({low}_{q}[{i}]), ").unwrap();
        }
        write!(pins, ".CE{p}(en_{q}), .OCE{p}(1'b1), .CLK{p}(clk), .WE{p}(wr_{q}), .RST{p}(rst_{q}), .CS{p}2(1'b0), .CS{p}1(1'b0), .CS{p}0(!sel_{q}), ")
            .unwrap();
    }
    Memory {
        cell: "DP16KD",
        file: "ecp5.v",
        set: "UNUSED",
        byte: 9,
        bytes: 2048,
        reads: [Some(a), Some(b)],
        writes: [Some(a), Some(b)],
        modes,
        old: false,
        shared: false,
        reset: Reset::AlwaysAndStopsWrites,
        parameters: format!(
            r#".DATA_WIDTH_A({a}), .DATA_WIDTH_B({b}), .WRITEMODE_A("{}"), .WRITEMODE_B("{}")"#,
            name(modes[0]),
            name(modes[1])
        ),
        pins: pins.trim_end_matches(", ").into(),
        missing: r#", .REGMODE_B("OUTREG")"#,
    }
}

/// Gowin's address: of words of two or four bytes the lowest bits are byte enables.
fn gowin_address(port: &str, width: usize) -> String {
    match width {
        16 | 18 => format!("{{ad_{port}[13:4], 2'b0, be_{port}[1:0]}}"),
        32 | 36 => format!("{{ad_{port}[13:5], 1'b0, be_{port}[3:0]}}"),
        _ => format!("ad_{port}[13:0]"),
    }
}

/// Gowin, one port that writes and one that reads; by the names of old Yosys, or the vendor's.
fn gowin_sdp(nine: bool, old_names: bool, [a, b]: [usize; 2]) -> Memory {
    let most = if nine { 36 } else { 32 };
    let pins = if old_names {
        ".CEA(en_a), .WREA(wr_a), .WREB(1'b0), .BLKSEL({2'b0, !sel_a})"
    } else {
        ".CEA(en_a && wr_a), .BLKSELA({2'b0, !sel_a}), .BLKSELB({2'b0, !sel_b})"
    };
    Memory {
        cell: [["SDPB", "SDPX9B"], ["SDP", "SDPX9"]][usize::from(old_names)][usize::from(nine)],
        file: "gowin.v",
        set: if old_names { "OLD_NAMES" } else { "UNUSED" },
        byte: 8 + usize::from(nine),
        bytes: 2048,
        reads: [None, Some(b)],
        writes: [Some(a), None],
        modes: [Mode::Hold; 2],
        old: false,
        shared: old_names,
        reset: Reset::Always,
        parameters: format!(".BIT_WIDTH_0({a}), .BIT_WIDTH_1({b})"),
        pins: format!(
            "{pins}, .CLKA(clk), .CLKB(clk), .CEB(en_b), .OCE(1'b1), .RESETA(rst_a), .RESETB(rst_b), .ADA({}), .ADB({}), .DI(di_a[{}:0]), .DO(do_b[{}:0])",
            gowin_address("a", a),
            gowin_address("b", b),
            most - 1,
            most - 1
        ),
        missing: ", .READ_MODE(1'b1)",
    }
}

/// Gowin, two ports that do both.
fn gowin_dp(nine: bool, old_names: bool, [a, b]: [usize; 2], modes: [Mode; 2]) -> Memory {
    let most = if nine { 18 } else { 16 };
    let blocks =
        if old_names { ".BLKSEL({2'b0, !sel_a})" } else { ".BLKSELA({2'b0, !sel_a}), .BLKSELB({2'b0, !sel_b})" };
    let mut pins = String::from(blocks);
    for (p, q, width) in [("A", "a", a), ("B", "b", b)] {
        write!(
            pins,
            ", .CLK{p}(clk), .CE{p}(en_{q}), .OCE{p}(1'b1), .RESET{p}(rst_{q}), .WRE{p}(wr_{q}), .AD{p}({}), .DI{p}(di_{q}[{}:0]), .DO{p}(do_{q}[{}:0])",
            gowin_address(q, width),
            most - 1,
            most - 1
        )
        .unwrap();
    }
    Memory {
        cell: [["DPB", "DPX9B"], ["DP", "DPX9"]][usize::from(old_names)][usize::from(nine)],
        reads: [Some(a), Some(b)],
        writes: [Some(a), Some(b)],
        modes,
        parameters: format!(
            ".BIT_WIDTH_0({a}), .BIT_WIDTH_1({b}), .WRITE_MODE0({}), .WRITE_MODE1({})",
            modes[0] as u8, modes[1] as u8
        ),
        pins,
        missing: ", .READ_MODE1(1'b1)",
        ..gowin_sdp(nine, old_names, [a, b])
    }
}

/// Xilinx, one port that writes (B) and one that reads (A), of which one is as wide as can be.
fn xilinx(large: bool, [read, write]: [usize; 2], old: bool) -> Memory {
    let half = if large { 4 } else { 2 };
    let nines = |v: &str, first: usize, lowest: usize, bits: usize| {
        let parts = (first..first + half).rev().map(|k| match bits {
            8 => format!("{v}[{}:{}]", 9 * k + lowest + 7, 9 * k + lowest),
            _ => format!("{v}[{}]", 9 * k + lowest),
        });
        format!("{{{}}}", parts.collect::<Vec<_>>().join(", "))
    };
    let wide = write == 18 * half;
    let b = if wide { half } else { 0 };
    // What a narrow write does not look at is something else.
    let lower = if wide { String::new() } else { "~".into() };
    let address = if large { ["{1'b1, ad_a}", "{1'b1, ad_b}"] } else { ["ad_a[13:0]", "ad_b[13:0]"] };
    let reset: u128 = if large { 0x8_1234_5678_9ABC_DEF5 } else { 0x9_2345_A7C3 };
    let outs = format!(
        ".DOADO({}), .DOPADOP({}), .DOBDO({}), .DOPBDOP({})",
        nines("do_a", 0, 0, 8),
        nines("do_a", 0, 8, 1),
        nines("do_a", half, 0, 8),
        nines("do_a", half, 8, 1)
    );
    let ins = format!(
        ".DIADI({}), .DIPADIP({}), .DIBDI({}), .DIPBDIP({})",
        lower.clone() + &nines("di_b", 0, 0, 8),
        lower + &nines("di_b", 0, 8, 1),
        nines("di_b", b, 0, 8),
        nines("di_b", b, 8, 1)
    );
    Memory {
        cell: if large { "RAMB36E1" } else { "RAMB18E1" },
        file: "xilinx.v",
        set: "UNUSED",
        byte: 9,
        bytes: if large { 4096 } else { 2048 },
        reads: [Some(read), None],
        writes: [None, Some(write)],
        modes: [Mode::Hold; 2],
        old,
        shared: false,
        reset: Reset::Enabled(reset),
        parameters: format!(
            r#".RAM_MODE("SDP"), .READ_WIDTH_A({read}), .WRITE_WIDTH_B({write}), .WRITE_MODE_B("{}"), .SRVAL_A({h}'h{:x}), .SRVAL_B({h}'h{:x})"#,
            if old { "READ_FIRST" } else { "WRITE_FIRST" },
            reset & ((1 << (9 * half)) - 1),
            reset >> (9 * half),
            h = 9 * half
        ),
        pins: format!(
            "{outs}, {ins}, .CLKARDCLK(clk), .CLKBWRCLK(clk), .ENARDEN(en_a && sel_a), .ENBWREN(en_b && sel_b), .RSTRAMARSTRAM(rst_a), .RSTRAMB(1'b0), .REGCEAREGCE(1'b1), .REGCEB(1'b1), .RSTREGARSTREG(1'b0), .RSTREGB(1'b0), .WEA({}'b0), .WEBWE(be_b[{}:0] & {{{}{{wr_b}}}}), .ADDRARDADDR({}), .ADDRBWRADDR({})",
            half,
            2 * half - 1,
            2 * half,
            address[0],
            address[1]
        ),
        missing: ", .DOA_REG(1)",
    }
}

fn memories() -> Vec<Memory> {
    use Mode::{Hold, New, Old};
    let mut all = vec![
        ecp5([18, 18], [Hold, New]),
        ecp5([18, 9], [Old, Hold]),
        ecp5([4, 9], [New, Old]),
        ecp5([2, 1], [Hold, New]),
        xilinx(false, [36, 36], false),
        xilinx(false, [18, 36], true),
        xilinx(false, [36, 9], false),
        xilinx(false, [1, 36], false),
        xilinx(true, [72, 72], true),
        xilinx(true, [72, 18], false),
        xilinx(true, [4, 72], false),
    ];
    for old_names in [false, true] {
        all.push(gowin_sdp(false, old_names, [32, 16]));
        all.push(gowin_sdp(false, old_names, [8, 2]));
        all.push(gowin_sdp(true, old_names, [36, 9]));
        all.push(gowin_sdp(true, old_names, [18, 36]));
        all.push(gowin_dp(false, old_names, [16, 1], [Hold, New]));
        all.push(gowin_dp(true, old_names, [18, 9], [Old, New]));
    }
    all
}

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
    if without_tools() {
        return;
    }
    for (name, bench, files, set) in benches() {
        assert_eq!(said(&bench, &files.map(model), set), "PASS", "{name}");
    }
}

/// What has no model ends the simulation, and says so.
#[test]
fn other_settings_of_a_memory_end_the_simulation() {
    if without_tools() {
        return;
    }
    let mut seen = std::collections::BTreeSet::new();
    for m in memories().iter().filter(|m| seen.insert(m.cell)) {
        let said = said(&bench(m, m.missing, 0), &["block_memory.v", m.file].map(model), m.set);
        assert!(
            said.starts_with(&format!("{}: a setting that has no model", m.cell.trim_end_matches('B'))),
            "{}: {said}",
            m.cell
        );
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
    if without_tools() {
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
