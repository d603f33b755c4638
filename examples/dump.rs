use reliefrtl::{format::FloatFormat, units::*, verilog::print_module};
fn main() {
    let f = FloatFormat::FP24;
    let l: u32 = std::env::args().nth(1).map(|s| s.parse().unwrap()).unwrap_or(2);
    let all = [
        float::fp_add(f, l),
        float::fp_mul(f, l),
        float::fp_div(f, l),
        float::fp_lt(f, l),
        float::fp_from_int(f, 14, l),
        float::fp_to_int(f, 14, l),
        float::fp_from_fixed(f, 26, 12, l),
        float::fp_to_fixed(f, 26, 12, l),
    ];
    std::fs::create_dir_all("/tmp/rtl").unwrap();
    for m in all {
        for m in m.hierarchy() {
            std::fs::write(format!("/tmp/rtl/{}.v", m.name), print_module(&m, "test")).unwrap();
        }
    }
}
