//! `--clock`: latencies from what was measured, and what they are good for.
use reliefrtl::catalogue::timed;
use reliefrtl::config::{Choice, DatapathConfig, Design, Part, Scope};
use reliefrtl::error::Result;
use reliefrtl::measured::{Entry, all};

fn for_clock(mhz: u32, d: &Design, scope: Scope<'_>) -> Result<Choice> {
    reliefrtl::config::for_clock(mhz, d, scope, &timed())
}

/// Whole MHz on ECP5 of the entries that `asks` tells.
fn measured(asks: impl Fn(&Entry) -> bool) -> Vec<u32> {
    let found = all().iter().filter(|e| e.target == "ecp5" && asks(e));
    found.filter_map(|e| e.clock.as_ref()).map(|clock| clock.median as u32).collect()
}

/// The fastest watertight traversal of those that were placed as a profile has them.
fn best() -> u32 {
    let kind = format!("datapath.kind={}", DatapathConfig::default().kind.word());
    let whole = |e: &Entry| {
        let words = e.words();
        let ["--unit", _, "--profile", _, rest @ ..] = words.as_slice() else { return false };
        let rest = rest.strip_prefix(&["--set", kind.as_str()][..]).unwrap_or(rest);
        !rest.iter().any(|w| ["--set", "--copies", "--clock"].contains(w))
    };
    measured(whole).into_iter().max().unwrap()
}

/// What a unit reaches at a latency.
fn of(unit: &str, clocks: u32) -> u32 {
    measured(|e| e.latency == Some(clocks) && e.is_alone(unit, &[]))[0]
}

/// Of units it may: where more registers stand between them, fewer in them reach the same clock.
#[test]
fn a_faster_clock_never_takes_fewer_registers_between_the_units() {
    let total = |mhz| {
        let l = for_clock(mhz, &Design::default(), Scope::Traversal).unwrap().latency;
        [l.compare, l.to_int, l.decision, l.node, l.memory, l.handshake]
    };
    for mhz in 2..=best() {
        let (slow, fast) = (total(mhz - 1), total(mhz));
        assert!(slow.iter().zip(&fast).all(|(a, b)| a <= b), "{mhz} MHz: {slow:?}, {fast:?}");
    }
}

#[test]
fn every_unit_of_arithmetic_was_measured_at_several_latencies() {
    let units = timed();
    assert!(units.len() >= 12 && units.iter().any(|u| u.part == Part::Beside), "{units:?}");
    let by_table = ["--set", "latency.divider=table"];
    for (unit, more) in units.iter().map(|u| (u.unit, &[][..])).chain([("fp_div", &by_table[..])]) {
        let at = all().iter().filter(|e| e.target == "ecp5" && e.clock.is_some() && e.is_alone(unit, more));
        let mut clocks: Vec<_> = at.map(|e| e.latency).collect();
        let count = clocks.len();
        clocks.sort();
        clocks.dedup();
        assert!(count > 1 && clocks.len() == count, "{unit} {more:?}: {clocks:?}");
    }
}

/// Each choice expects what was asked, until something is changed that it rests on.
#[test]
fn a_choice_is_judged_by_what_it_became() {
    for mhz in 1..=130 {
        let mut d = Design::default();
        let choice = for_clock(mhz, &d, Scope::Traversal).unwrap();
        d.latency = choice.latency;
        assert!(!choice.provenance(mhz, &d, Scope::Traversal).contains("less than"), "{mhz}");
        d.latency.add = 1;
        let said = choice.provenance(mhz, &d, Scope::Traversal);
        let share: u32 = said.split(" % of that").next().and_then(|s| s.rsplit(' ').next()).unwrap().parse().unwrap();
        let counted = of("fp_add", 1) * share / 100;
        assert_eq!(said.contains("less than"), counted < mhz, "{said}");
        assert!(counted >= mhz || said.contains("fp_add in 1 clock,"), "{said}");
    }
    let mut d = Design::default();
    let choice = for_clock(160, &d, Scope::Traversal).unwrap();
    d.latency = choice.latency;
    assert!(choice.provenance(160, &d, Scope::Traversal).contains("profile fast"));
    d.latency.mul = 0;
    assert!(choice.provenance(160, &d, Scope::Traversal).contains("nothing is promised"));
    d.latency = choice.latency;
    assert!(choice.provenance(160, &d, Scope::Traversal).contains("profile fast"));
    d.datapath.fraction_bits += 1;
    assert!(choice.provenance(160, &d, Scope::Traversal).contains("this design: place it"));
    d.datapath = Design::default().datapath;
    d.mode.bilinear = true;
    assert!(choice.provenance(160, &d, Scope::Traversal).contains("this design: place it"));
}

/// A promise is of what was measured, not of a latency near it, nor of other registers between the units.
#[test]
fn what_was_not_measured_is_not_promised() {
    let mut d = Design::default();
    let choice = for_clock(120, &d, Scope::Traversal).unwrap();
    (d.latency, d.latency.handshake) = (choice.latency, 0);
    assert!(choice.provenance(120, &d, Scope::Traversal).contains("registers between the units were changed"));
    let unit = ["fp_div".to_string()];
    let mhz = of("fp_div", 20);
    let choice = for_clock(mhz, &d, Scope::Alone(&unit)).unwrap();
    (d.latency, d.latency.div) = (choice.latency, 22);
    assert!(choice.provenance(mhz, &d, Scope::Alone(&unit)).contains("fp_div in 22 clocks was not measured"));
    let unit = ["fp_from_int".to_string()];
    let choice = for_clock(130, &d, Scope::Alone(&unit)).unwrap();
    (d.latency, d.traverse.levels) = (choice.latency, 10);
    assert!(choice.provenance(130, &d, Scope::Alone(&unit)).contains("nor was this format or width"));
}

#[test]
fn a_unit_alone_needs_no_margin() {
    let unit = ["fp_add".to_string()];
    let mut d = Design::default();
    let mhz = of("fp_add", 8);
    let choice = for_clock(mhz, &d, Scope::Alone(&unit)).unwrap();
    d.latency = choice.latency;
    let said = choice.provenance(mhz, &d, Scope::Alone(&unit));
    assert_eq!(choice.latency.add, 8, "{said}");
    assert!(said.contains(&format!("fp_add in 8 clocks alone reached {mhz} MHz")), "{said}");
}

#[test]
fn what_nothing_reaches_is_refused() {
    let e = for_clock(400, &Design::default(), Scope::Traversal).unwrap_err().to_string();
    assert!(e.contains("--clock 400") && e.contains(&format!("at most --clock {}", best())), "{e}");
    let mut d = Design::default();
    d.datapath.kind = "published".parse().unwrap();
    let e = for_clock(120, &d, Scope::Traversal).unwrap_err().to_string();
    assert!(e.contains("datapath.kind = published"), "{e}");
    let unit = ["fp_add3".to_string()];
    let e = for_clock(300, &d, Scope::Alone(&unit)).unwrap_err().to_string();
    assert!(e.contains("fp_add3 at 300 MHz") && e.contains(&of("fp_add3", 12).to_string()), "{e}");
    let unit = ["lzc".to_string()];
    let e = for_clock(100, &d, Scope::Alone(&unit)).unwrap_err().to_string();
    assert!(e.contains("no clock of lzc was measured"), "{e}");
}
