use reliefrtl::{config::*, interp::*, ir::Binding, trace::Pipeline};
use std::collections::BTreeMap;
fn main() {
    let p = Pipeline::new(&Design::default(), &Binding::new()).unwrap();
    for net in [p.net.clone(), p.net.optimized()] {
        let mut k: BTreeMap<String, (usize, usize)> = BTreeMap::new();
        for o in &net.ops {
            let wide = o.args.iter().any(|a| net.widths[*a as usize] > 32) || o.width > 32;
            let e = k.entry(format!("{:?}", o.kind)).or_default();
            e.0 += 1;
            e.1 += usize::from(wide);
        }
        println!("ops {} regs {} {:?}", net.ops.len(), net.regs.len(), k);
        let en = net.regs.iter().filter(|r| r.enable.is_some()).count();
        let one = net.ops.iter().filter(|o| o.width == 1).count();
        let uses = |s: u32| net.ops.iter().filter(|o| o.args.contains(&s)).count();
        let mut single: BTreeMap<String, usize> = BTreeMap::new();
        let mut regd: std::collections::HashSet<u32> = net.regs.iter().map(|r| r.d).collect();
        regd.extend(net.outputs.iter().map(|o| o.slot));
        for o in &net.ops {
            let mut seen = vec![];
            for a in o.args {
                if a >= net.first_op && !seen.contains(&a) && uses(a) == 1 && !regd.contains(&a) {
                    seen.push(a);
                    *single
                        .entry(format!("{:?}<-{:?}", o.kind, net.ops[(a - net.first_op) as usize].kind))
                        .or_default() += 1;
                }
            }
        }
        let chain = net.regs.iter().filter(|r| net.regs.iter().any(|q| q.q == r.d)).count();
        let mut v: Vec<_> = single.into_iter().collect();
        v.sort_by_key(|x| std::cmp::Reverse(x.1));
        println!("enabled {en} one-bit ops {one} chained regs {chain} {:?}", &v[..30]);
    }
}
