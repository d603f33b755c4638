//! What a module may not be: every rule of the verifier and every refusal of the builder, each with a module that breaks it and nothing else.
use reliefrtl::interp::elaborate;
use reliefrtl::ir::{
    BIT, BITS, Binding, Builder, Expr, Module, Node, NodeId, Op, Outputs, SYSTEM_VERILOG, Sig, VERILOG, verify,
};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

/// What a panic says.
fn panics(what: &str, f: impl FnOnce()) -> String {
    let payload = catch_unwind(AssertUnwindSafe(f)).expect_err(what);
    payload.downcast_ref::<String>().cloned().or_else(|| payload.downcast_ref::<&str>().map(|s| s.to_string())).unwrap()
}

/// A register after an AND: one stage, nothing wrong.
fn good() -> Module {
    let b = Builder::new("good", "tests", "a module");
    b.clock();
    b.clock_enable();
    let (x, y) = (b.input("x", 4, BITS, "x"), b.input("y", 4, BITS, "y"));
    let o = b.output("o", 4, BITS, "o");
    b.drive(o, (x & y).named("both").reg());
    Arc::unwrap_or_clone(b.finish(&[]))
}

/// The AND, and the register after it.
const AND: usize = 3;
const REGISTER: usize = 4;

#[test]
fn each_rule_names_what_breaks_it() {
    type Row = (&'static str, fn(&mut Module));
    let rows: [Row; 17] = [
        ("port name forever is not usable in Verilog", |m| m.ports[2].name = "forever".into()),
        ("port name x y is not usable in Verilog", |m| m.ports[2].name = "x y".into()),
        ("port y is declared twice", |m| m.ports[2].name = "y".into()),
        ("name endcase is not usable in Verilog", |m| {
            for k in [AND, REGISTER] {
                m.nodes[k].name = Some("endcase".into());
            }
        }),
        ("two values are named both in stage Some(1)", |m| {
            m.nodes.push(m.nodes[REGISTER].clone());
            m.unused.push(NodeId(REGISTER as u32 + 1));
        }),
        ("output o is driven 0 times", |m| m.outputs.clear()),
        ("output o is driven 2 times", |m| m.outputs.push(m.outputs[0])),
        ("register both is not driven", |m| m.nodes[REGISTER].args.clear()),
        ("and both reads a later value: a loop", |m| m.nodes[AND].args[0] = NodeId(REGISTER as u32)),
        ("register both of stage 2 reads and both of stage 0 without a delay", |m| m.nodes[REGISTER].stage = Some(2)),
        ("output o stands in stage 2, and the module's latency is 1", |m| m.nodes[REGISTER].stage = Some(2)),
        ("register both needs a clock, and the module has none", |m| m.clk = None),
        ("output o belongs to no stage, and the module's latency is 1", |m| m.nodes[REGISTER].stage = None),
        ("input y is never used", |m| m.nodes[AND].args[1] = m.nodes[AND].args[0]),
        ("and both: operands of [4, 4] bits do not give 5 bits", |m| m.nodes[AND].width = Expr::from(5)),
        ("and both: 0 bits; 1 to 64 are possible", |m| m.nodes[AND].width = Expr::from(0)),
        ("and both: 65 bits; 1 to 64 are possible", |m| m.nodes[AND].width = Expr::from(65)),
    ];
    assert_eq!(verify(&good(), &[]), [""; 0]);
    for (sentence, spoil) in rows {
        let mut m = good();
        spoil(&mut m);
        let said = verify(&m, &[]);
        assert!(said.iter().any(|s| s.starts_with(sentence)), "{sentence}: {said:?}");
    }
}

/// `now` is an AND, `later` the same two registers on.
fn two_outputs() -> Builder {
    let b = Builder::new("two", "tests", "a module");
    b.clock();
    b.clock_enable();
    let (now, later) = (b.output("now", 4, BITS, "at once"), b.output("later", 4, BITS, "two clocks later"));
    let both = (b.input("x", 4, BITS, "x") & b.input("y", 4, BITS, "y")).named("both");
    b.drive(now, both);
    b.drive(later, (!both).named("neither").reg().reg());
    b
}

#[test]
fn the_latency_of_a_module_is_the_stage_of_its_outputs() {
    let stages = |m: &Module| m.data_outputs().map(|(_, p)| p.stage).collect::<Vec<_>>();
    let registers = |m: &Module| m.nodes.iter().filter(|n| matches!(n.op, Op::Reg { .. })).count();
    let of = |m: Arc<Module>| (m.latency(), stages(&m), registers(&m));
    assert_eq!(of(two_outputs().finish(&[])), (Some(2), vec![Some(2); 2], 4));
    for asked in [1, 2, 5] {
        let b = two_outputs();
        b.at_least(asked);
        let clocks = asked.max(2);
        assert_eq!(of(b.finish(&[])), (Some(clocks), vec![Some(clocks); 2], 2 * clocks as usize));
    }
    let b = two_outputs();
    b.plan(3, &[("sum", 1)]);
    assert_eq!(of(b.finish(&[])), (Some(3), vec![Some(3); 2], 6));
    assert_eq!(of(two_outputs().finish_streams(&[])), (None, vec![Some(0), Some(2)], 2));
    let said = panics("a plan of handshakes", || {
        let b = two_outputs();
        b.plan(3, &[]);
        b.finish_streams(&[]);
    });
    assert!(said.starts_with("outputs of handshakes stand in no stage"), "{said}");
    // What belongs to no stage can't be brought to one.
    let said = panics("an output without a stage", || {
        let b = two_outputs();
        let held = b.input_static("held", 1, BIT, "held");
        b.drive(b.output("as_is", 1, BIT, "held"), !held);
        b.finish(&[]);
    });
    assert!(said.contains("output as_is belongs to no stage, and the module's latency is 2"), "{said}");
}

/// `o` is an AND of `x` and a wire that `around` drives from it.
fn looping(around: impl for<'b> Fn(&'b Builder, Sig<'b>) -> Sig<'b>) -> Module {
    let b = Builder::new("looping", "tests", "a module");
    b.clock();
    b.clock_enable();
    let x = b.input_static("x", 1, BIT, "x");
    let back = b.wire("back", 1);
    let o = b.output("o", 1, BIT, "o");
    let y = (x & back).named("y");
    b.connect(back, around(&b, y));
    b.drive(o, y);
    Arc::unwrap_or_clone(b.finish_streams(&[]))
}

/// `a` straight to `through`, and by a register to `held`.
fn leaf() -> Arc<Module> {
    let b = Builder::new("leaf", "tests", "a module");
    b.clock();
    b.clock_enable();
    let a = b.input("a", 1, BIT, "a");
    let (through, held) = (b.output("through", 1, BIT, "as it is"), b.output("held", 1, BIT, "a clock later"));
    b.drive(through, !a);
    b.drive(held, (!a).named("not_a").reg());
    b.finish_streams(&[])
}

#[test]
fn a_combinational_loop_is_named() {
    let said = panics("a loop through a wire", || drop(looping(|_, y| (!y).named("inverted"))));
    let circle = "a combinational loop: and y -> not inverted -> wire back -> and y";
    assert!(said.contains(circle), "{said}");
    let leaf = leaf();
    let through = |port: &str, other: &str| {
        looping(|b, y| {
            let outs = b.inst(&leaf, "u_leaf", &[], &[("a", y)]);
            b.unused(outs[other]);
            outs[port].unstaged()
        })
    };
    let said = panics("a loop through an instance", || drop(through("through", "held")));
    assert!(said.contains("a combinational loop: ") && said.contains("instance output"), "{said}");
    // The same circle with a register in it is none; and where nothing was verified, elaboration ends as well.
    let mut m = through("held", "through");
    elaborate(&m, &Binding::new()).unwrap();
    let at = |m: &Module, found: &dyn Fn(&Node) -> bool| m.nodes.iter().position(found).unwrap();
    let (wire, y) = (at(&m, &|n| n.op == Op::Wire), at(&m, &|n| n.name.as_deref() == Some("y")));
    m.nodes[wire].args = vec![NodeId(y as u32)];
    let said = elaborate(&m, &Binding::new()).unwrap_err().to_string();
    assert!(said.contains("a combinational loop, through "), "{said}");
}

/// Of both languages, each word; and no other.
#[test]
fn keywords_are_no_names() {
    assert_eq!((VERILOG.len(), SYSTEM_VERILOG.len()), (124, 124));
    for list in [&VERILOG, &SYSTEM_VERILOG] {
        assert!(list.windows(2).all(|w| w[0] < w[1]), "in order, each once");
        for word in list {
            let mut m = good();
            m.ports[2].name = (*word).into();
            assert_eq!(verify(&m, &[]), [format!("port name {word} is not usable in Verilog")]);
        }
    }
    for word in ["forever_", "Forever", "cases", "valid", "ready", "result"] {
        let mut m = good();
        m.ports[2].name = word.into();
        assert_eq!(verify(&m, &[]), [""; 0], "{word}");
    }
}

#[test]
fn the_builder_refuses_what_has_no_meaning() {
    fn x(b: &Builder) -> Sig<'_> {
        b.input("x", 4, BITS, "")
    }
    fn narrow(b: &Builder) -> Sig<'_> {
        b.input("y", 3, BITS, "")
    }
    fn inst<'b>(b: &'b Builder, inputs: &[(&str, Sig<'_>)]) -> Outputs<'b> {
        b.inst(&leaf(), "u_leaf", &[], inputs)
    }
    fn whole(b: &Builder) -> Outputs<'_> {
        inst(b, &[("a", b.lit(1, 1))])
    }
    type Row = (&'static str, fn(&Builder));
    let refusals: [Row; 13] = [
        ("and of 4 and 3 bits: operands have the same width", |b| _ = x(b) & narrow(b)),
        ("ult of 4 and 3 bits: operands have the same width", |b| _ = x(b).lt(narrow(b))),
        ("mux of 4 and 3 bits: operands have the same width", |b| _ = b.lit(1, 1).mux(x(b), narrow(b))),
        ("slice up to bit 5 of 4 bits", |b| _ = x(b).slice(2, 3)),
        ("a value of stage 1 is asked for in stage 0", |b| _ = x(b).reg().at(0)),
        ("a and without a name crosses a stage: name it", |b| _ = (x(b) & x(b)).reg()),
        ("a decision has one bit", |b| _ = x(b).decided(false)),
        ("m: output o has 3 bits, its driver 4", |b| b.drive(b.output("o", 3, BITS, ""), x(b))),
        ("u_leaf: input a is not driven", |b| _ = inst(b, &[])),
        ("u_leaf.a has 1 bits, its driver 4", |b| _ = inst(b, &[("a", x(b))])),
        ("leaf: no port z", |b| _ = inst(b, &[("z", b.lit(1, 1))])),
        ("u_leaf (an instance of leaf) has no output z; there are through, held", |b| _ = whole(b)["z"]),
        ("u_leaf (an instance of leaf) is asked for its only output and has through, held", |b| _ = whole(b).only()),
    ];
    for (sentence, refused) in refusals {
        let b = Builder::new("m", "tests", "a module");
        b.clock();
        b.clock_enable();
        let said = panics(sentence, || refused(&b));
        assert!(said.starts_with(sentence), "{sentence}: {said}");
    }
}

/// A module of a fixed latency, described by `body` from two inputs of four bits and an output.
fn fixed(body: impl for<'b> FnOnce(&'b Builder, [Sig<'b>; 2], usize)) -> String {
    panics("the module is wrong", || {
        let b = Builder::new("lie", "tests", "a module");
        b.clock();
        b.clock_enable();
        let ins = ["x", "y"].map(|n| b.input(n, 4, BITS, n));
        let out = b.output("o", 4, BITS, "o");
        body(&b, ins, out);
        b.finish(&[]);
    })
}

/// Registers that the stage of the outputs does not count would let a module lie about its latency.
#[test]
fn no_register_of_a_fixed_latency_goes_uncounted() {
    let said = fixed(|b, [x, y], out| {
        let back = b.wire("w", 4);
        b.connect(back, (x & y).named("both").reg().reg());
        b.drive(out, (back & x).named("mix"));
    });
    assert!(said.contains("wire w belongs to no stage and reads"), "{said}");
    let said = fixed(|b, [x, y], out| {
        let both = (x & y).named("both").reg();
        let late = (!both.reg().reg()).named("late").unstaged();
        b.drive(out, (late & both).named("mix"));
    });
    assert!(said.contains("not late belongs to no stage and reads"), "{said}");
    let said = fixed(|b, [x, y], out| {
        let before = b.loop_reg("before", 4, false);
        b.close(&[(before, (x & y).named("both"))]);
        b.drive(out, before);
    });
    assert!(said.contains("register before of a loop in a module of a fixed latency"), "{said}");
    let said = fixed(|b, [x, y], out| {
        b.drive(out, (x & y).named("both").reg().reg().rebase_stage(0));
    });
    assert!(said.contains("without a delay"), "{said}");
}

/// Whatever a module declares has one name space, and no keyword in it.
#[test]
fn every_declared_name_is_legal_and_its_own() {
    let through = |b: &Builder, width: &Expr, name: &str| {
        let x = b.input(name, width, BITS, "x");
        b.drive(b.output("z", width, BITS, "z"), x);
    };
    let of = |name: &str, body: &dyn Fn(&Builder)| {
        panics(name, || {
            let b = Builder::new(name, "tests", "a module");
            body(&b);
            b.finish(&[]);
        })
    };
    type Row<'a> = (&'a str, &'a str, &'a dyn Fn(&Builder));
    let rows: [Row<'_>; 8] = [
        ("casez", "module name casez is not usable", &|b| through(b, &Expr::from(4), "x")),
        ("m", "parameter name endcase is not usable", &|b| through(b, &b.param("endcase", 4, "w"), "x")),
        ("m", "localparam name forever is not usable", &|b| {
            through(b, &b.local("forever", Expr::from(4), "four"), "x")
        }),
        ("m", "parameter x has the name of something else", &|b| through(b, &b.param("x", 4, "w"), "x")),
        ("m", "parameter LATENCY has the name of something else", &|b| through(b, &b.param("LATENCY", 4, "w"), "x")),
        ("m", "net s0_both has the name of something else", &|b| {
            b.clock();
            b.clock_enable();
            let x = b.input("s0_both", 4, BITS, "x");
            b.drive(b.output("z", 4, BITS, "z"), (x & !x).named("both").reg());
        }),
        ("m", "instance name begin is not usable", &|b| {
            b.clock();
            b.clock_enable();
            let a = b.input("a", 1, BIT, "a");
            b.drive(b.output("z", 1, BIT, "z"), b.inst(&leaf(), "begin", &[], &[("a", a)])["held"].named("kept"));
        }),
        ("m", "instance u_leaf has the name of something else", &|b| {
            b.clock();
            b.clock_enable();
            let a = b.input("a", 1, BIT, "a");
            let first = b.inst(&leaf(), "u_leaf", &[], &[("a", a)])["held"].named("first");
            b.drive(
                b.output("z", 1, BIT, "z"),
                b.inst(&leaf(), "u_leaf", &[], &[("a", first)])["held"].named("second"),
            );
        }),
    ];
    for (name, sentence, body) in rows {
        let said = of(name, body);
        assert!(said.contains(sentence), "{sentence}: {said}");
    }
}
