use reliefrtl::{config::*, units::traversal::*, verilog::print_module};
fn main() {
    let d = Design::default();
    let t = &d.traverse;
    let mut all = vec![
        start_level(t),
        height_address(t),
        node_planes(t, true),
        plane_time(&d),
        height_test(&d),
        predicted_hit(&d),
        node_crossing(&d),
        multi_level_down(t, &d.mode),
        level_decision(&d),
        hit_position(&d),
        ray_setup(&d),
        height_memory(17, 8, 87381),
    ];
    let tv = traverse(&d);
    println!("slots {} setup {} finish {}", tv.slots, tv.setup, tv.finish);
    all.push(tv.module);
    for r in LevelUp::ALL {
        all.extend(level_up(t, r));
    }
    let m = level_up(t, LevelUp::Selective).unwrap();
    all.push(m);
    std::fs::create_dir_all("/tmp/rtl").unwrap();
    for m in all {
        for m in m.hierarchy() {
            std::fs::write(format!("/tmp/rtl/{}.v", m.name), print_module(&m, &Default::default())).unwrap();
        }
    }
}
