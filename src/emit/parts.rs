//! What the parts have that a design is measured on: more than that does not fit, and is said.
use serde::Serialize;

/// One kind of resource.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Resource {
    /// Its name.
    pub what: &'static str,
    /// The cells of a netlist that take one each, as Yosys names them; `*` at the end stands for any rest.
    pub cells: &'static [&'static str],
    /// How many the part has.
    pub most: u64,
}

/// A part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Part {
    /// Its name.
    pub name: &'static str,
    /// The name without blanks.
    pub word: &'static str,
    /// What it has; look-up tables come first.
    pub resources: &'static [Resource],
}

const fn has(what: &'static str, most: u64, cells: &'static [&'static str]) -> Resource {
    Resource { what, cells, most }
}

/// Lattice ECP5 family data sheet (FPGA-DS-02012), table 1.1; the same numbers as Lattice's mapper counts as available (`LUTS_avail`, `EBR_avail`) and
/// nextpnr-ecp5 lists for `--85k` (`TRELLIS_COMB`, `DP16KD`, `MULT18X18D`).
pub const ECP5: Part = Part {
    name: "ECP5-85 (LFE5U-85F)",
    word: "LFE5U-85F",
    resources: &[
        has("look-up_tables", 83_640, &["LUT4"]),
        has("flip-flops", 83_640, &["TRELLIS_FF"]),
        has("block_memories", 208, &["DP16KD", "PDPW16KD"]),
        has("multipliers", 156, &["MULT18X18D"]),
    ],
};

/// The most of each that any part of the family has: look-up tables and memories of the HX8K (iCE40 LP/HX family data sheet, FPGA-DS-02029, formerly
/// DS1040, table 1-1), multipliers of the UP5K (iCE40 UltraPlus family data sheet, FPGA-DS-02008). No part has both.
pub const ICE40: Part = Part {
    name: "the largest iCE40s (HX8K, UP5K)",
    word: "iCE40",
    resources: &[
        has("look-up_tables", 7680, &["SB_LUT4"]),
        has("flip-flops", 7680, &["SB_DFF*"]),
        has("block_memories", 32, &["SB_RAM40_4K*"]),
        has("multipliers", 8, &["SB_MAC16"]),
    ],
};

/// Xilinx 7 series overview (DS180) and CLB user guide (UG474, table 1-2): 33,650 slices of 4 look-up tables and 8 flip-flops. The part that `vivado.tcl` takes by default. Half a block memory is counted as a whole one of its own kind.
pub const XC7A200T: Part = Part {
    name: "Artix-7 XC7A200T",
    word: "XC7A200T",
    resources: &[
        has("look-up_tables", 134_600, &["LUT1", "LUT2", "LUT3", "LUT4", "LUT5", "LUT6"]),
        has("flip-flops", 269_200, &["FD*"]),
        has("block_memories", 365, &["RAMB36E1"]),
        has("half_block_memories", 730, &["RAMB18E1"]),
        has("multipliers", 740, &["DSP48E1"]),
    ],
};

/// Virtex-6 family overview (DS150): 118,560 slices of 4 look-up tables and 8 flip-flops, the largest LX part.
pub const XC6VLX760: Part = Part {
    name: "Virtex-6 XC6VLX760",
    word: "XC6VLX760",
    resources: &[
        has("look-up_tables", 474_240, &["LUT1", "LUT2", "LUT3", "LUT4", "LUT5", "LUT6"]),
        has("flip-flops", 948_480, &["FD*"]),
        has("block_memories", 720, &["RAMB36E1"]),
        has("half_block_memories", 1440, &["RAMB18E1"]),
        has("multipliers", 864, &["DSP48E1"]),
    ],
};

/// Gowin GW2A series data sheet (DS102), table of product resources: three flip-flops to four look-up tables, 140 memories of 18 kbit (2520 kbit).
/// Of two multipliers of 18 bits four of 9 are made, of four one of 36 (DSP user guide, UG287): each kind is counted as if it were alone.
pub const GW2A_55: Part = Part {
    name: "Gowin GW2A-55",
    word: "GW2A-55",
    resources: &[
        has("look-up_tables", 54_720, &["LUT1", "LUT2", "LUT3", "LUT4", "ALU"]),
        has("flip-flops", 41_040, &["DFF*"]),
        has(
            "block_memories",
            140,
            &["SP", "SPX9", "SDP", "SDPB", "SDPX9", "SDPX9B", "DP", "DPB", "DPX9", "DPX9B", "pROM*"],
        ),
        has("multipliers", 40, &["MULT18X18"]),
        has("multipliers_of_9_bits", 80, &["MULT9X9"]),
        has("multipliers_of_36_bits", 10, &["MULT36X36"]),
    ],
};

impl Resource {
    /// How many of `cells` take one.
    pub fn taken<'a>(&self, cells: impl IntoIterator<Item = (&'a String, &'a u64)>) -> u64 {
        let is = |name: &str| {
            self.cells.iter().any(|c| c.strip_suffix('*').map_or(*c == name, |start| name.starts_with(start)))
        };
        cells.into_iter().filter(|(name, _)| is(name)).map(|(_, n)| n).sum()
    }
}

impl Part {
    /// One phrase (`171 of 32 block memories`) for each resource of which a netlist takes more than the part has.
    pub fn misfits(&self, cells: &std::collections::BTreeMap<String, u64>) -> Vec<String> {
        let over = |r: &Resource| {
            let taken = r.taken(cells);
            (taken > r.most).then(|| format!("{taken} of {} {}", r.most, r.what.replace('_', " ")))
        };
        self.resources.iter().filter_map(over).collect()
    }
    /// The same without what is counted by the thousand: an assertion lists every cell.
    pub fn counted_in_scripts(&self) -> Self {
        // Look-up tables and flip-flops stand first.
        Self { resources: &self.resources[2..], ..*self }
    }
}

#[cfg(test)]
mod tests {
    use super::{ECP5, GW2A_55, ICE40, XC6VLX760, XC7A200T};

    #[test]
    fn what_is_too_much_is_named() {
        let cells = |n: u64| [("SB_RAM40_4K".to_string(), n), ("SB_RAM40_4KNR".to_string(), 1)].into();
        assert_eq!(ICE40.misfits(&cells(170)), ["171 of 32 block memories"]);
        assert!(ICE40.misfits(&cells(31)).is_empty());
        assert_eq!(GW2A_55.misfits(&[("MULT36X36".to_string(), 11)].into()), ["11 of 10 multipliers of 36 bits"]);
    }

    #[test]
    fn what_is_many_stands_first() {
        for part in [ECP5, ICE40, XC6VLX760, XC7A200T, GW2A_55] {
            let names: Vec<&str> = part.resources.iter().map(|r| r.what).collect();
            assert_eq!(names[..2], ["look-up_tables", "flip-flops"], "{}", part.name);
            assert!(part.counted_in_scripts().resources.iter().all(|r| r.most < 2000), "{}", part.name);
        }
    }
}
