use glam::DVec3;
use reliefrtl::{config::*, golden::*, trace::*};
fn rays(e: f64, a: f64, dist: f64, scale: f64, rep: f64, stride: usize, d: &Design) -> Vec<RayInput> {
    let (e, a) = (e.to_radians(), a.to_radians());
    let f = DVec3::new(-a.sin() * e.cos(), -e.sin(), a.cos() * e.cos());
    let right = DVec3::new(a.cos(), 0.0, a.sin());
    let up = right.cross(f);
    let up = if up.y < 0.0 || (up.y.abs() < 1e-9 && up.z < 0.0) { -up } else { up };
    let o = -dist * f;
    let (w, h) = (1024usize, 768usize);
    let th = (22.5f64).to_radians().tan();
    let mut out = vec![];
    for py in (0..h).step_by(stride) {
        for px in (0..w).step_by(stride) {
            let sx = ((px as f64 + 0.5) / w as f64 * 2.0 - 1.0) * th * w as f64 / h as f64;
            let sy = (1.0 - (py as f64 + 0.5) / h as f64 * 2.0) * th;
            let dir = f + right * sx + up * sy;
            if dir.y >= 0.0 {
                continue;
            }
            let s = -o.y / dir.y;
            let p = o + dir * s;
            if p.x.abs() > 100.0 || p.z.abs() > 100.0 {
                continue;
            }
            let u = ((p.x / 200.0 + 0.5) * rep).rem_euclid(1.0);
            let v = ((0.5 - p.z / 200.0) * rep).rem_euclid(1.0);
            let k = scale * rep / 200.0;
            out.push(RayInput::from_f64(d.format, u, v, k * dir.x / -dir.y, k * -dir.z / -dir.y));
        }
    }
    out
}
fn main() {
    let mut d = Design::default();
    for (name, scale, rep) in [("rocks", 10.0, 4.0), ("stones", 5.0, 1.0), ("four", 30.0, 1.0), ("saints", 20.0, 1.0)] {
        let img = image::open(format!("/work/shared/scenes/{name}.png")).unwrap().to_luma8();
        let tex: Vec<u32> = img.pixels().map(|p| p.0[0] as u32).collect();
        let pyr = Pyramid::build(8, 8, &tex).unwrap();
        for (label, s, n, up) in [
            ("pdm", false, 1, LevelUp::None),
            ("tevs", false, 1, LevelUp::Tevs),
            ("a", true, 1, LevelUp::None),
            ("b", false, 2, LevelUp::None),
            ("c1", false, 1, LevelUp::Selective),
            ("c2", false, 1, LevelUp::Coherent),
            ("a+b+c1", true, 2, LevelUp::Selective),
        ] {
            d.mode = ModeConfig { start_level: s, levels_down: n, level_up: up };
            print!("{name} {label}: ");
            for (e, a, dist) in [(90.0, 36.4, 200.0), (22.0, 36.4, 200.0), (3.0, 100.0, 240.0)] {
                let r = rays(e, a, dist, scale, rep, 8, &d);
                let h = trace_golden(&d, &pyr, &r).unwrap();
                let m = h.iter().map(|x| x.steps as f64).sum::<f64>() / h.len() as f64;
                let mx = h.iter().map(|x| x.steps).max().unwrap();
                print!("{m:.2} (max {mx}, {} rays, limit {}) ", h.len(), h.iter().filter(|x| x.limit).count());
            }
            println!();
        }
    }
}
