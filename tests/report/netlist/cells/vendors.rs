//! The memories of the vendors: their pins, and what each does beside the others.
use super::memory::{Memory, Mode, Reset};
use std::fmt::Write;

/// `{name}{i}` connected to bit `i` of `to`, for each of `n`.
pub fn each(name: &str, n: usize, to: &str) -> String {
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

/// Two ports that read and write, each at one width: `WE` has a bit a byte, and a port that is not written at has none of them set.
fn xilinx_dual(large: bool, widths: [usize; 2], modes: [Mode; 2]) -> Memory {
    let half = if large { 4 } else { 2 };
    let list = |v: &str, lowest: usize, bits: usize| {
        let parts = (0..half).rev().map(|k| format!("{v}[{}:{}]", 9 * k + lowest + bits - 1, 9 * k + lowest));
        format!("{{{}}}", parts.collect::<Vec<_>>().join(", "))
    };
    let port = |p: &str, letter: &str| {
        let (din, dout) = (format!("di_{p}"), format!("do_{p}"));
        format!(
            ".DI{letter}DI({}), .DIP{letter}DIP({}), .DO{letter}DO({}), .DOP{letter}DOP({})",
            list(&din, 0, 8),
            list(&din, 8, 1),
            list(&dout, 0, 8),
            list(&dout, 8, 1)
        )
    };
    let address = if large { ["{1'b1, ad_a}", "{1'b1, ad_b}"] } else { ["ad_a[13:0]", "ad_b[13:0]"] };
    let word = |m: Mode| match m {
        Mode::Hold => "NO_CHANGE",
        Mode::New => "WRITE_FIRST",
        Mode::Old => "READ_FIRST",
    };
    let [a, b] = widths;
    let reset: u128 = if large { 0x9_2345_A7C3 } else { 0x2_A7C3 };
    Memory {
        cell: if large { "RAMB36E1" } else { "RAMB18E1" },
        file: "xilinx.v",
        set: "UNUSED",
        byte: 9,
        bytes: if large { 4096 } else { 2048 },
        reads: [Some(a), Some(b)],
        writes: [Some(a), Some(b)],
        old: modes == [Mode::Old; 2],
        modes,
        shared: false,
        reset: Reset::Enabled(reset),
        parameters: format!(
            r#".RAM_MODE("TDP"), .READ_WIDTH_A({a}), .WRITE_WIDTH_A({a}), .READ_WIDTH_B({b}), .WRITE_WIDTH_B({b}), .WRITE_MODE_A("{}"), .WRITE_MODE_B("{}"), .SRVAL_A({h}'h{reset:x}), .SRVAL_B({h}'h{reset:x})"#,
            word(modes[0]),
            word(modes[1]),
            h = 9 * half
        ),
        pins: format!(
            "{}, {}, .CLKARDCLK(clk), .CLKBWRCLK(clk), .ENARDEN(en_a && sel_a), .ENBWREN(en_b && sel_b), .RSTRAMARSTRAM(rst_a), .RSTRAMB(rst_b), .REGCEAREGCE(1'b1), .REGCEB(1'b1), .RSTREGARSTREG(1'b0), .RSTREGB(1'b0), .WEA({}), .WEBWE({}), .ADDRARDADDR({}), .ADDRBWRADDR({})",
            port("a", "A"),
            port("b", "B"),
            enables("a", a, half),
            enables("b", b, half),
            address[0],
            address[1]
        ),
        missing: ", .DOB_REG(1)",
    }
}

/// One enable a byte; a word of a byte or less is written by all of them alike.
fn enables(port: &str, width: usize, half: usize) -> String {
    match width {
        0..=9 => format!("{{{half}{{wr_{port}}}}}"),
        _ => format!("be_{port}[{}:0] & {{{half}{{wr_{port}}}}}", half - 1),
    }
}

pub fn memories() -> Vec<Memory> {
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
        xilinx_dual(false, [18, 9], [Old, Old]),
        xilinx_dual(false, [2, 18], [New, Hold]),
        xilinx_dual(true, [36, 36], [Hold, Old]),
        xilinx_dual(true, [1, 18], [Old, New]),
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
