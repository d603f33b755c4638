//! Mutants of `traverse` itself: which ray enters, which leaves, what a slot takes, counters, limit, refusal; and of what stands beside its pipelines. The
//! shipped sets have to notice each in the interpreter, under full load or in rough traffic. Those that live stand by name with their reason.
use crate::budget::share;
use rayon::prelude::*;
use reliefrtl::catalogue::RaySet;
use reliefrtl::config::{Config, LatencyConfig};
use reliefrtl::interp::{Stream, Traffic, elaborate};
use reliefrtl::ir::{Module, Names, Node, NodeId, Op};
use reliefrtl::project::{Scene, ray_sets};
use reliefrtl::trace::{images, inputs, outputs};
use reliefrtl::units::traversal::traverse;
use std::sync::Arc;

const IDLE: &str = "idle is no word of a result: the bench and hardware::unknown look at it";
const SLOWER: &str = "later, with the same results";
const AGAIN: &str = "a done ray that goes round hits again, in the same node at the same parameter; others that are done are marked already";
const LEVEL: &str = "the level of a done ray: its result is made of place and parameter alone";
const EMPTY: &str = "in the first clock after reset nothing stands before a register of a handshake: setup has a clock at least, and no slot is filled";

/// Mutants that live, by handshake and name, each with the reason why no result can tell.
const LIVE: &[(u32, &str, &str)] = &[
    (0, "traverse: hit_ce or -> right", SLOWER),
    (0, "traverse: s0_slot_free or -> left", SLOWER),
    (0, "traverse: setup_ce or -> right", SLOWER),
    (0, "traverse: s6_given_up and -> left", AGAIN),
    (0, "traverse: node 269 mux -> never", LEVEL),
    (0, "traverse: s0_in_transfer and -> or", IDLE),
    (0, "traverse: s0_in_transfer and -> left", IDLE),
    (0, "traverse: s0_in_transfer and -> right", IDLE),
    (0, "traverse: out_transfer and -> or", IDLE),
    (0, "traverse: out_transfer and -> left", IDLE),
    (0, "traverse: out_transfer and -> right", IDLE),
    (0, "traverse: s0_in_transfer_q register -> not reset", IDLE),
    (0, "traverse: s0_out_transfer_q register -> not reset", IDLE),
    (0, "traverse: s0_in_flight_q register -> not reset", IDLE),
    (0, "traverse: s0_any_in_flight_q register -> not reset", IDLE),
    (0, "traverse: into s0_in_flight_down not -> not inverted", IDLE),
    (0, "traverse: s0_in_flight_down and -> or", IDLE),
    (0, "traverse: s0_in_flight_down and -> left", IDLE),
    (0, "traverse: s0_in_flight_down and -> right", IDLE),
    (0, "traverse: node 392 xor -> or", IDLE),
    (0, "traverse: s0_in_flight_next add -> sub", IDLE),
    (0, "traverse: into s0_is_idle or -> and", IDLE),
    (0, "traverse: into s0_is_idle or -> left", IDLE),
    (0, "traverse: into s0_is_idle or -> right", IDLE),
    (0, "traverse: s0_is_idle not -> not inverted", IDLE),
    (1, "traverse: s0_slot_free or -> left", SLOWER),
    (1, "traverse: s6_given_up and -> left", AGAIN),
    (1, "traverse: node 288 mux -> never", LEVEL),
    (1, "traverse: s0_in_transfer and -> or", IDLE),
    (1, "traverse: s0_in_transfer and -> left", IDLE),
    (1, "traverse: s0_in_transfer and -> right", IDLE),
    (1, "traverse: out_transfer and -> or", IDLE),
    (1, "traverse: out_transfer and -> left", IDLE),
    (1, "traverse: out_transfer and -> right", IDLE),
    (1, "traverse: s0_in_transfer_q register -> not reset", IDLE),
    (1, "traverse: s0_out_transfer_q register -> not reset", IDLE),
    (1, "traverse: s0_in_flight_q register -> not reset", IDLE),
    (1, "traverse: s0_any_in_flight_q register -> not reset", IDLE),
    (1, "traverse: into s0_in_flight_down not -> not inverted", IDLE),
    (1, "traverse: s0_in_flight_down and -> or", IDLE),
    (1, "traverse: s0_in_flight_down and -> left", IDLE),
    (1, "traverse: s0_in_flight_down and -> right", IDLE),
    (1, "traverse: node 411 xor -> or", IDLE),
    (1, "traverse: s0_in_flight_next add -> sub", IDLE),
    (1, "traverse: into s0_is_idle or -> and", IDLE),
    (1, "traverse: into s0_is_idle or -> left", IDLE),
    (1, "traverse: into s0_is_idle or -> right", IDLE),
    (1, "traverse: s0_is_idle not -> not inverted", IDLE),
    (1, "spill_register: out_of_reset register -> not reset", EMPTY),
    (1, "spill_register: ready_q register -> not reset", EMPTY),
    (1, "spill_register: load_first_q register -> not reset", EMPTY),
    (1, "spill_register: load_second_q register -> not reset", EMPTY),
    (1, "spill_register: into push and -> left", EMPTY),
];

/// Parts of `traverse` that hold nothing but valid bits, words and handshakes.
const BESIDE: [&str; 3] = ["setup_delay", "hit_delay", "spill_register"];

fn config(handshake: u32) -> Config {
    let mut c = Config::default();
    (c.traverse.levels, c.vectors.rays) = (4, 20);
    c.latency = LatencyConfig {
        add: 1,
        mul: 1,
        div: 1,
        compare: 1,
        from_int: 1,
        to_int: 1,
        decision: 1,
        node: 1,
        memory: 1,
        select: 0,
        setup: 0,
        hit: 0,
        delay_line: 0,
        handshake,
        ..Default::default()
    };
    c
}

/// What a slip could put in the place of a node, at the same widths.
fn neighbours(n: &Node) -> Vec<(&'static str, Node)> {
    let op = |op: Op| Node { op, ..n.clone() };
    let args = |args: Vec<NodeId>| Node { args, ..n.clone() };
    match (&n.op, &n.args[..]) {
        (Op::Not, _) => vec![("not inverted", op(Op::Wire))],
        (Op::And, [a, b]) => {
            vec![("or", op(Op::Or)), ("left", args(vec![*a, *a])), ("right", args(vec![*b, *b]))]
        }
        (Op::Or, [a, b]) => {
            vec![("and", op(Op::And)), ("left", args(vec![*a, *a])), ("right", args(vec![*b, *b]))]
        }
        (Op::Xor, _) => vec![("or", op(Op::Or))],
        (Op::Add, _) => vec![("sub", op(Op::Sub))],
        (Op::Eq, _) => vec![("less", op(Op::Ult))],
        (Op::Mux, [c, a, b]) => {
            vec![
                ("swapped", args(vec![*c, *b, *a])),
                ("always", args(vec![*c, *a, *a])),
                ("never", args(vec![*c, *b, *b])),
            ]
        }
        (Op::Reg { reset: true, wrap, unknown }, _) => {
            vec![("not reset", op(Op::Reg { reset: false, wrap: *wrap, unknown: *unknown }))]
        }
        _ => vec![],
    }
}

/// All mutants of a module's own graph, by name.
fn mutants(m: &Module) -> Vec<(String, Arc<Module>)> {
    let names = Names::new(m);
    let name = |k: usize| {
        let own = names.net(NodeId(k as u32));
        let reader = || (k + 1..m.nodes.len()).find(|r| m.nodes[*r].args.contains(&NodeId(k as u32)));
        own.or_else(|| reader().and_then(|r| names.net(NodeId(r as u32))).map(|n| format!("into {n}")))
            .unwrap_or_else(|| format!("node {k}"))
    };
    let mut out = Vec::new();
    for (k, n) in m.nodes.iter().enumerate() {
        for (what, other) in neighbours(n) {
            let mut changed = m.clone();
            changed.nodes[k] = other;
            out.push((format!("{}: {} {} -> {what}", m.name, name(k), n.op.name()), Arc::new(changed)));
        }
    }
    out
}

/// Mutants of `traverse` and of what stands beside its pipelines.
fn all(t: &Arc<Module>) -> Vec<(String, Arc<Module>)> {
    let mut out = mutants(t);
    for name in BESIDE {
        let Some(part) = t.insts.iter().find(|i| i.module.name == name).map(|i| i.module.clone()) else { continue };
        for (what, other) in mutants(&part) {
            let mut changed = Module::clone(t);
            let same = changed.insts.iter_mut().filter(|i| i.module.name == name);
            same.for_each(|i| i.module = other.clone());
            out.push((what, Arc::new(changed)));
        }
    }
    out
}

/// Whether the interpreter finds every expected row in this module's results, with this traffic.
fn passes(m: &Module, set: &RaySet, lanes: usize, traffic: Traffic, depth: u64) -> bool {
    let words: Vec<u64> = set.memory.lines().filter_map(|l| u64::from_str_radix(l, 16).ok()).collect();
    let net = elaborate(m, &set.set.params).unwrap();
    let image = &words[words.len() - net.mems[0].depth..];
    let steps = set.set.outputs.iter().position(|c| c.name == "out_steps").unwrap();
    let longest = set.set.expected.iter().map(|r| r[steps]).max().unwrap();
    let stream = Stream::new(&net, &inputs(m), &outputs(m), depth).patient(longest);
    let expected = &set.set.expected;
    let wrong = |ray: usize, words: &[u64]| words != expected[ray];
    let run = stream.run_until(&set.set.stimulus, &images(&net, image), lanes, traffic, wrong);
    run.is_ok_and(|run| run.results == *expected)
}

fn judge(handshake: u32) {
    let c = config(handshake);
    let sets: Vec<RaySet> =
        ray_sets(&c, &Scene::new(&c, None, false).unwrap()).unwrap().into_iter().map(|s| s.1).collect();
    let t = traverse(&c.design());
    let depth = u64::from(t.setup + t.slots + t.finish);
    // Cheapest first: most mutants die in the first run.
    let lives = |m: &Module| {
        passes(m, &sets[0], 128, Traffic::default(), depth)
            && sets[1..].iter().all(|s| passes(m, s, 128, Traffic::default(), depth))
            && sets[1..].iter().all(|s| passes(m, s, 16, Traffic::rough(7), depth))
            && passes(m, &sets[0], 16, Traffic::rough(3), depth)
            && passes(m, &sets[0], 4, Traffic { resets: 60, ..Traffic::rough(5) }, depth)
    };
    assert!(lives(&t.module), "the original");
    assert!(t.setup > 0, "{EMPTY}");
    // Up to three mutants of a node stand side by side, so that one in four meets each kind of them.
    let all: Vec<(String, Arc<Module>)> = all(&t.module).into_iter().step_by(share(4)).collect();
    let alive: Vec<&String> = all.par_iter().filter(|(_, m)| lives(m)).map(|(name, _)| name).collect();
    println!("handshake {handshake}: {} of {} killed", all.len() - alive.len(), all.len());
    alive.iter().for_each(|name| println!("    lives: {name}"));
    assert!(all.len() > 160 / share(4), "only {} mutants", all.len());
    let listed: Vec<&str> =
        LIVE.iter().filter(|l| l.0 == handshake && all.iter().any(|(name, _)| name == l.1)).map(|l| l.1).collect();
    let more: Vec<_> = alive.iter().filter(|n| !listed.contains(&n.as_str())).collect();
    assert!(more.is_empty(), "live and are not listed: {more:#?}");
    let less: Vec<_> = listed.iter().filter(|n| !alive.iter().any(|a| a.as_str() == **n)).collect();
    assert!(less.is_empty(), "are listed and die: {less:#?}");
}

#[test]
fn shipped_rays_kill_the_mutants_of_traverse() {
    judge(0);
}

#[test]
fn shipped_rays_kill_the_mutants_of_traverse_with_registered_handshakes() {
    judge(1);
}

/// The functions that a mutant of one operation may leave half alive, cut out whole.
#[test]
fn shipped_rays_notice_what_is_cut_out_of_the_description() {
    let c = config(0);
    let sets: Vec<RaySet> =
        ray_sets(&c, &Scene::new(&c, None, false).unwrap()).unwrap().into_iter().map(|s| s.1).collect();
    let t = traverse(&c.design());
    let depth = u64::from(t.setup + t.slots + t.finish);
    let named = |name: &str| {
        let found: Vec<usize> =
            t.module.nodes.iter().enumerate().filter(|(_, n)| n.name.as_deref() == Some(name)).map(|n| n.0).collect();
        *found.first().unwrap_or_else(|| panic!("no {name}"))
    };
    let constant = |name: &str, op: Op| {
        let mut m = Module::clone(&t.module);
        let k = named(name);
        m.nodes[k] = Node { op, args: vec![], ..m.nodes[k].clone() };
        m
    };
    let mut unreset = Module::clone(&t.module);
    for n in &mut unreset.nodes {
        if let Op::Reg { reset, .. } = &mut n.op {
            *reset = false;
        }
    }
    let cuts = [
        ("refusal", constant("new_refused", Op::Zeros)),
        ("step limit", constant("last_step", Op::Zeros)),
        ("back-pressure", constant("hit_ce", Op::Ones)),
        ("reset", unreset),
    ];
    for (what, m) in cuts {
        let notice = sets.iter().filter(|s| !passes(&m, s, 128, Traffic::default(), depth)).count()
            + usize::from(!passes(&m, &sets[0], 16, Traffic::rough(3), depth));
        assert!(notice > 0, "nothing notices that {what} is cut out");
    }
}
