use reliefrtl::{format::FloatFormat, interp::*, ir::Binding, units::*};
fn main() {
    let f = FloatFormat::FP24;
    for l in [0, 1, 2, 3, 5, 9, 20] {
        for (n, m, g) in
            [("add", float::fp_add(f, l), 0), ("mul", float::fp_mul(f, l), 1), ("div", float::fp_div(f, l), 2)]
        {
            let net = elaborate(&m, &Binding::from([("EXP_W".into(), 8), ("MAN_W".into(), 23)])).unwrap();
            let mut bad = 0;
            let mut x = 12345u64;
            let mut total = 0;
            let mut s = Lanes::new(&net, 64);
            s.set(net.input("ce")).fill(1);
            for _ in 0..1000 {
                let mut want = vec![];
                for lane in 0..64 {
                    let mut r = || {
                        x ^= x << 13;
                        x ^= x >> 7;
                        x ^= x << 17;
                        ((x >> 20) as u32 & 0x9fff_ffff) | 0x2000_0000
                    };
                    let (a, b) = (r(), r());
                    s.set(net.input("a"))[lane] = a as u64;
                    s.set(net.input("b"))[lane] = b as u64;
                    let (fa, fb) = (f32::from_bits(a), f32::from_bits(b));
                    let w = match g {
                        0 => fa + fb,
                        1 => fa * fb,
                        _ => fa / fb,
                    };
                    want.push(
                        if w.is_subnormal() { f32::from_bits(w.to_bits() & 0x8000_0000) } else { w }.to_bits() as u64
                    );
                }
                for _ in 0..l {
                    s.eval();
                    s.clock();
                }
                s.eval();
                let got = s.get(net.output("result"));
                for i in 0..64 {
                    total += 1;
                    if got[i] != want[i] {
                        bad += 1;
                        if bad < 3 {
                            println!("{n} L{l} got {:x} want {:x}", got[i], want[i]);
                        }
                    }
                }
            }
            println!("{n} L{l}: {bad} of {total}, {} ops {} regs", net.ops.len(), net.regs.len());
        }
    }
}
