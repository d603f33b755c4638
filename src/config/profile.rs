//! Latencies by name.
use super::{DatapathConfig, DatapathKind, Design, Divider, LatencyConfig};

/// A named set of latencies, slowest first. Clocks that were measured of each: `docs/clocks.md`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// Those of the published unit: add 2, multiply 1, compare 1, divide 2 (PIDM-HW section 4.2). Where the divider is outside of the loop, it is
    /// as deep as the rest needs, and what the published numbers do not name has the registers that 84 MHz need on an ECP5.
    Published,
    /// Between the two.
    Balanced,
    /// Every unit as deep as still pays.
    Fast,
}

words!(Profile: Published = "published", Balanced = "balanced", Fast = "fast");

impl Profile {
    /// Its latencies for a design: where the table of the divider does not fit the numbers, the divider has rows.
    pub fn latency_for(self, d: &Design) -> LatencyConfig {
        let latency = self.latency(d.datapath.kind);
        let fits = Design { latency, ..*d }.check_divider().is_ok();
        let rows = if d.datapath.kind.facts().short_loop { Self::SINGLE_ROWS } else { Self::ROWS };
        if fits { latency } else { LatencyConfig { div: rows, divider: Divider::Rows, ..latency } }
    }

    /// Clocks of a divider of rows, where there are many.
    const ROWS: u32 = 20;

    /// Its latencies for the published format.
    pub const fn latency(self, kind: DatapathKind) -> LatencyConfig {
        let latency = self.with_dividers(kind.facts().divides_in_loop);
        if kind.facts().short_loop && !matches!(self, Self::Published) {
            // The loop is faster than two rows of a divider in series, and than a difference and a clamp. A table is a third of the rows' area.
            return LatencyConfig {
                div: Self::TABLE,
                divider: Divider::Table,
                hit: if latency.hit > 1 { latency.hit } else { 1 },
                ..latency
            };
        }
        latency
    }

    /// Clocks of a reciprocal by table with registers on both sides of each multiplier.
    const TABLE: u32 = 20;

    /// Clocks of a reciprocal of 24 bits with one row a clock.
    const SINGLE_ROWS: u32 = 29;

    /// Its latencies for the published format, and dividers in the loop or outside of it: in it, the published latencies make the published 15 stages.
    pub(super) const fn with_dividers(self, in_loop: bool) -> LatencyConfig {
        let (add, mul, compare) = match self {
            Self::Published => (2, 1, 1),
            Self::Balanced => (3, 2, 1),
            Self::Fast => (6, 6, 2),
        };
        let (div, from_int, to_int, sqrt, add3) = match (self, in_loop) {
            (Self::Published, true) => (2, 1, 1, 4, 4),
            (Self::Published, _) => (Self::ROWS, 1, 1, 8, 4),
            (Self::Balanced, _) => (Self::ROWS, 2, 2, 12, 8),
            (Self::Fast, _) => (13, 5, 4, 20, 12),
        };
        let divider = if matches!(self, Self::Fast) { Divider::Table } else { Divider::Rows };
        let (decision, node, memory, select, handshake, delay_line) = match (self, in_loop) {
            (Self::Published, true) => (1, 0, 1, 0, 0, 0),
            (Self::Published, _) => (2, 1, 2, 1, 1, 0),
            (Self::Balanced, _) => (2, 2, 4, 1, 1, 0),
            (Self::Fast, _) => (5, 3, 4, 1, 3, 4),
        };
        let (setup, hit) = if matches!(self, Self::Fast) { (1, 2) } else { (0, 0) };
        LatencyConfig {
            add,
            mul,
            div,
            divider,
            compare,
            from_int,
            to_int,
            sqrt,
            add3,
            decision,
            node,
            memory,
            select,
            setup,
            hit,
            handshake,
            delay_line,
        }
    }
}

/// Those of [`Profile::Balanced`]: placed and routed, they meet the default clock with room to spare (`docs/clocks.md`).
impl Default for LatencyConfig {
    fn default() -> Self {
        Profile::Balanced.latency(DatapathConfig::default().kind)
    }
}
