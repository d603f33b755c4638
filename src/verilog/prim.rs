//! Verilog bodies of the primitives: the only text that is not printed from a graph.
use reliefrtl_base::bits::{INDEX_W, SLOPE_W, START_W, recip_table};
use reliefrtl_ir::Prim;
use std::borrow::Cow;

/// The body of a primitive module, between header and `endmodule`.
pub fn body(p: Prim) -> Cow<'static, str> {
    Cow::Borrowed(match p {
        Prim::Lzc => LZC,
        Prim::Interleave => INTERLEAVE,
        Prim::DivRows => DIV_ROWS,
        Prim::SqrtRows => SQRT_ROWS,
        Prim::Memory => return Cow::Owned(format!("{MEMORY}{PRELOAD}")),
        Prim::FifoMem => MEMORY,
        Prim::Banks => BANKS,
        Prim::DelayLine => DELAY_LINE,
        Prim::RecipTable => return Cow::Owned(constants()),
    })
}

/// A table of constants with a register after it, in the form that every synthesizer takes for a block memory.
fn constants() -> String {
    let (word_w, last) = (START_W + SLOPE_W, (1u64 << INDEX_W) - 1);
    let digits = word_w.div_ceil(4) as usize;
    let line = |i: u64| format!("{word_w}'h{:0digits$x};\n", recip_table(i));
    let rows: String = (0..last).map(|i| format!("        {INDEX_W}'d{i}: word_q <= {}", line(i))).collect();
    format!(
        "
  reg [{}:0] word_q;

  always @(posedge clk) begin
    if (ce) begin
      case (index)
{rows}        default: word_q <= {}      endcase
    end
  end

  assign word = word_q;
",
        word_w - 1,
        line(last)
    )
}

const LZC: &str = r#"
  // Padded with ones below the last bit, so that the count of an all-zero word is W.
  localparam integer PadW = 1 << CountW;  // W, with ones below up to a power of two
  wire [PadW-1:0] padded = {bits, {(PadW - W){1'b1}}};

  // Binary tree. Level s covers groups of 2 << s bits: whether a group is all zeros, and else its
  // leading-zero count, which is that of the upper half, or 2^s plus that of the lower half. The
  // most significant bits of the count have the shortest path.
  genvar s, g;
  generate
    for (s = 0; s < CountW; s = s + 1) begin : gen_level
      localparam integer Groups = PadW >> (s + 1);  // groups of 2^(s+1) bits
      wire [Groups-1:0]         empty;
      wire [Groups*(s+1)-1:0]   lzc;
      for (g = 0; g < Groups; g = g + 1) begin : gen_group
        if (s == 0) begin : gen_first
          assign empty[g] = ~(padded[2*g+1] | padded[2*g]);
          assign lzc[g]   = ~padded[2*g+1];
        end else begin : gen_later
          wire         high_empty = gen_level[s-1].empty[2*g+1];
          wire [s-1:0] high_lzc = gen_level[s-1].lzc[(2*g+1)*s+:s];
          wire [s-1:0] low_lzc = gen_level[s-1].lzc[2*g*s+:s];
          assign empty[g]             = high_empty & gen_level[s-1].empty[2*g];
          assign lzc[g*(s+1)+:(s+1)] = {high_empty, high_empty ? low_lzc : high_lzc};
        end
      end
    end
  endgenerate
  assign count = gen_level[CountW-1].lzc;

  // verilator lint_off UNUSED
  wire unused_last = &{1'b0, gen_level[CountW-1].empty};
  // verilator lint_on UNUSED
"#;

const INTERLEAVE: &str = r#"
  genvar i;
  generate
    for (i = 0; i < W; i = i + 1) begin : gen_bit
      assign result[2*i]   = a[i];
      assign result[2*i+1] = b[i];
    end
  endgenerate
"#;

const DIV_ROWS: &str = r#"
  // Restoring division, one quotient bit per row: subtract if the divisor fits, then shift left.
  genvar r;
  generate
    for (r = 0; r < ROWS; r = r + 1) begin : gen_row
      wire [W:0]   here;
      wire [W+1:0] diff = {1'b0, here} - {2'b00, div};
      wire         fits = ~diff[W+1];
      wire [W:0]   next = {fits ? diff[W-1:0] : here[W-1:0], 1'b0};
      if (r == 0) begin : gen_first
        assign here = rem_in;
      end else begin : gen_later
        assign here = gen_row[r-1].next;
      end
      assign quot[ROWS-1-r] = fits;
      // verilator lint_off UNUSED
      wire unused_top = &{1'b0, diff[W]};
      // verilator lint_on UNUSED
    end
  endgenerate
  assign rem_out = gen_row[ROWS-1].next;
"#;

const SQRT_ROWS: &str = r#"
  // Restoring square root, one root bit per row: shift left, subtract 2 * root + 2^i if it fits,
  // and then set the bit.
  genvar r;
  generate
    for (r = 0; r < ROWS; r = r + 1) begin : gen_row
      localparam integer BitIndex = W - 1 - FIRST - r;  // bit that this row decides
      wire [W:0]   here;
      wire [W-1:0] root;
      wire [W-1:0] mark = {{(W - 1) {1'b0}}, 1'b1} << BitIndex;
      wire [W+1:0] trial = {1'b0, root, 1'b0} | {2'b00, mark};
      wire [W+2:0] diff = {1'b0, here, 1'b0} - {1'b0, trial};
      wire         fits = ~diff[W+2];
      wire [W:0]   next = fits ? diff[W:0] : {here[W-1:0], 1'b0};
      wire [W-1:0] more = root | (fits ? mark : {W{1'b0}});
      if (r == 0) begin : gen_first
        assign here = rem_in;
        assign root = root_in;
      end else begin : gen_later
        assign here = gen_row[r-1].next;
        assign root = gen_row[r-1].more;
      end
      // verilator lint_off UNUSED
      wire unused_top = &{1'b0, diff[W+1]};
      // verilator lint_on UNUSED
    end
  endgenerate
  assign rem_out  = gen_row[ROWS-1].next;
  assign root_out = gen_row[ROWS-1].more;
"#;

const MEMORY: &str = r#"
  // Reading the address that is being written is don't-care: no bypass logic.
  (* no_rw_check *)
  reg [DATA_W-1:0] mem [0:DEPTH-1];
  reg [DATA_W-1:0] read_q;

  always @(posedge clk) begin
    if (write_en) mem[write_addr] <= write_data;
    read_q <= mem[read_addr];
  end

  assign read_data = read_q;
"#;

const PRELOAD: &str = r#"
  generate
    if (MEM_INIT != "") begin : gen_preload
      initial $readmemh(MEM_INIT, mem);
    end
  endgenerate
"#;

const DELAY_LINE: &str = r#"
  // words of the memory; the last clock is its output register
  localparam integer Words = CLOCKS - 1;
  // bits of an address
  localparam integer IndexW = (Words > 8) ? 4 : ((Words > 4) ? 3 : ((Words > 2) ? 2 : 1));
  localparam integer Last = Words - 1;  // the last address

  // Circular buffer with read before write: a word is read one round after it was written. An index
  // beyond the last one wraps to 0, so any initial value is legal.
  reg [W-1:0]      ring [0:Words-1];
  reg [W-1:0]      out_q;
  reg [IndexW-1:0] index;

  wire              is_last = index >= Last[IndexW-1:0];
  wire [IndexW-1:0] next    = is_last ? {IndexW{1'b0}} : (index + {{(IndexW - 1) {1'b0}}, 1'b1});

  initial index = {IndexW{1'b0}};

  always @(posedge clk) begin
    if (ce) begin
      ring[index] <= in_data;
      out_q       <= ring[index];
      index       <= next;
    end
  end

  assign out_data = out_q;
"#;

const BANKS: &str = r#"
  // address bits inside a bank
  localparam integer WordW = (BANK_W < ADDR_W) ? BANK_W : (ADDR_W - 1);
  // banks, the last one not always full
  localparam integer BankCount = (DEPTH + (1 << WordW) - 1) >> WordW;

  genvar g;
  generate
    if (MEM_INIT != "") begin : gen_preload
      // One file initializes one array; the synthesizer divides it among block memories.
      // Reading the address that is being written is don't-care: no bypass logic.
      (* no_rw_check *)
      reg [DATA_W-1:0] mem [0:DEPTH-1];
      reg [DATA_W-1:0] read_q;
      reg [DATA_W-1:0] out_q;
      initial $readmemh(MEM_INIT, mem);
      always @(posedge clk) begin
        if (write_en) mem[write_addr] <= write_data;
        read_q <= mem[read_addr];
        out_q  <= read_q;
      end
      assign read_data = out_q;
    end else begin : gen_banks
      // Every bank is read. The bank select is decoded beside the read, one-hot, so that the output
      // multiplexer after the registers is one AND-OR.
      for (g = 0; g < BankCount; g = g + 1) begin : gen_bank
        localparam integer Index = g;  // number of the bank
        // Reading the address that is being written is don't-care: no bypass logic.
        (* no_rw_check *)
        reg  [DATA_W-1:0] mem [0:(1<<WordW)-1];
        reg  [DATA_W-1:0] read_q;
        reg  [DATA_W-1:0] out_q;
        reg               select_q;
        reg               select_out_q;
        wire [DATA_W-1:0] lower;
        wire [DATA_W-1:0] merged = lower | ({DATA_W{select_out_q}} & out_q);
        wire              written = write_addr[ADDR_W-1:WordW] == Index[ADDR_W-1-WordW:0];
        always @(posedge clk) begin
          if (write_en && written) mem[write_addr[WordW-1:0]] <= write_data;
          read_q      <= mem[read_addr[WordW-1:0]];
          out_q       <= read_q;
          select_q     <= read_addr[ADDR_W-1:WordW] == Index[ADDR_W-1-WordW:0];
          select_out_q <= select_q;
        end
        if (g == 0) begin : gen_first
          assign lower = {DATA_W{1'b0}};
        end else begin : gen_later
          assign lower = gen_bank[g-1].merged;
        end
        if (g == BankCount - 1) begin : gen_last
          assign read_data = merged;
        end
      end
    end
  endgenerate
"#;
