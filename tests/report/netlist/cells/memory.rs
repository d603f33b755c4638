//! A memory with two ports as a row of bits, and the bench that holds a model against it.
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{RngCore, SeedableRng};
use std::fmt::Write;

/// A bit that may be unknown.
type Bit = Option<bool>;

/// A cell with one memory and two ports, in one of its settings.
pub struct Memory {
    pub cell: &'static str,
    /// The file of its model, and a macro that is set for it.
    pub file: &'static str,
    pub set: &'static str,
    /// Bits of a byte, and how many bytes there are.
    pub byte: usize,
    pub bytes: usize,
    /// Bits of a word at each port; none where the port does not read or does not write.
    pub reads: [Option<usize>; 2],
    pub writes: [Option<usize>; 2],
    /// What each port reads as it writes.
    pub modes: [Mode; 2],
    /// Whether a port that reads what the other one writes sees the old word, and not an unknown one.
    pub old: bool,
    /// Whether both ports are selected by the same pins.
    pub shared: bool,
    pub reset: Reset,
    /// The parameters beside the initial values.
    pub parameters: String,
    /// What the pins are connected to.
    pub pins: String,
    /// A setting that the model does not have.
    pub missing: &'static str,
}

/// What a port reads as it writes: nothing, the new word, the old one.
#[derive(Clone, Copy, PartialEq)]
pub enum Mode {
    Hold,
    New,
    Old,
}

/// What the reset of a port does.
#[derive(Clone, Copy, PartialEq)]
pub enum Reset {
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
pub const CLOCKS: usize = 600;

/// A bench of a memory: stimulus and expected values of each clock as constants.
pub fn bench(m: &Memory, setting: &str, clocks: usize) -> [String; 2] {
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
            // What two ports write to one byte is not promised.
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
