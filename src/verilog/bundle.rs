//! Delay bundles: values that only wait share one packed shift register, where each would have one of its own in every stage.
use super::layout::range;
use crate::ir::{Expr, Module, Names, NodeId, Op};
use std::collections::{BTreeMap, BTreeSet};

/// Registers that a bundle has to save: fewer are quicker read one by one.
const LEAST_REGISTERS: usize = 6;

/// Values that wait from one stage to a later one.
pub struct Bundle {
    /// Stage of the values that enter.
    pub from: u32,
    /// Stage of the registers at the end, which have nets of their own.
    pub to: u32,
    /// What enters, and the last register of its wait.
    pub values: Vec<(NodeId, NodeId)>,
}

/// All bundles of a module, in the order of their last and first stages.
pub struct Bundles {
    /// The bundles.
    pub list: Vec<Bundle>,
    /// Registers that a bundle holds, last ones included.
    held: BTreeSet<NodeId>,
}

impl Bundles {
    /// Finds the waits of two clocks and more of `m`: registers in a row that reset does not clear, of which nothing reads but the last. A
    /// value that the module keeps visible stays a register a stage.
    pub fn of(names: &Names) -> Self {
        let m = names.m;
        let mut readers = vec![0u32; m.nodes.len()];
        let reads = m.nodes.iter().flat_map(|n| n.args.iter()).chain(m.outputs.iter().map(|o| &o.1)).chain(&m.unused);
        reads
            .chain(m.insts.iter().flat_map(|i| i.inputs.iter().map(|x| &x.1)))
            .for_each(|id| readers[id.0 as usize] += 1);
        let waits = |id: NodeId| {
            let n = m.node(id);
            let visible = n.name.as_ref().is_some_and(|name| m.visible.contains(name));
            n.op == Op::Reg { reset: false, wrap: false, unknown: None } && !visible && names.staged
        };
        let ids = || (0..m.nodes.len() as u32).map(NodeId).filter(|id| waits(*id));
        let mut next = BTreeMap::new();
        for id in ids() {
            let from = m.node(id).args[0];
            if waits(from) && readers[from.0 as usize] == 1 {
                next.insert(from, id);
            }
        }
        let mut groups: BTreeMap<(u32, u32), Bundle> = BTreeMap::new();
        let mut rows: BTreeMap<(u32, u32), Vec<NodeId>> = BTreeMap::new();
        let inner: BTreeSet<NodeId> = next.values().copied().collect();
        for first in ids().filter(|id| !inner.contains(id)) {
            let row: Vec<NodeId> = std::iter::successors(Some(first), |id| next.get(id).copied()).collect();
            let last = *row.last().expect("a row has its first register");
            let to = names.stage[last.0 as usize];
            let from = to - row.len() as u32;
            if row.len() > 1 {
                let bundle = groups.entry((to, from)).or_insert_with(|| Bundle { from, to, values: vec![] });
                bundle.values.push((m.node(first).args[0], last));
                rows.entry((to, from)).or_default().extend(row);
            }
        }
        rows.retain(|_, row| row.len() >= LEAST_REGISTERS);
        let list = groups.into_iter().filter(|(key, _)| rows.contains_key(key)).map(|(_, b)| b).collect();
        Self { list, held: rows.into_values().flatten().collect() }
    }

    /// Whether a bundle holds this register, so that it has no clocked line of its own.
    pub fn holds(&self, id: NodeId) -> bool {
        self.held.contains(&id)
    }
}

impl Bundle {
    /// Name of the registers between the first stage and the last.
    pub fn net(&self) -> String {
        format!("s{}_to_s{}", self.from, self.to)
    }

    /// Their range; `named` gives a width by the name that it has in the text.
    pub fn range(&self, m: &Module, named: impl Fn(&Expr) -> Expr) -> String {
        let one = self.values.iter().fold(Expr::from(0), |sum, (_, last)| sum + named(&m.node(*last).width));
        range(&(one * i64::from(self.to - self.from - 1)))
    }
}

/// Bit `bit` of the shift register `net` of a module at its default parameters, by the name that it would have in a register of its own, such as
/// `s3_ups[7]`; `None` if the module has no such register.
pub fn delayed_bit(m: &Module, net: &str, bit: u32) -> Option<String> {
    let names = Names::new(m);
    let bundles = Bundles::of(&names);
    let b = bundles.list.iter().find(|b| b.net() == net)?;
    let defaults = m.default_binding();
    let width = |id: NodeId| m.node(id).width.eval(&defaults) as u32;
    let word: u32 = b.values.iter().map(|v| width(v.1)).sum();
    // Words enter at the low end; in a word the first value is on top.
    let (stage, mut rest) = (b.from + 1 + bit / word, bit % word);
    let (_, last) = b.values.iter().rev().find(|v| {
        let here = rest < width(v.1);
        rest -= if here { 0 } else { width(v.1) };
        here
    })?;
    let name = format!("s{stage}_{}", m.node(*last).name.as_ref()?);
    (stage < b.to).then(|| if width(*last) == 1 { name } else { format!("{name}[{rest}]") })
}

#[cfg(test)]
mod tests {
    use super::super::{Style, print_module};
    use super::delayed_bit;
    use crate::ir::{Builder, Module};

    /// A module whose three words of 8 bits come out four clocks later.
    fn module(visible: &[&str]) -> std::sync::Arc<Module> {
        let b = Builder::new("m", file!(), "delays");
        b.clock();
        visible.iter().for_each(|name| b.visible(name));
        let words = ["x", "y", "z"].map(|name| b.input(name, 8, "bits", "a word").named(&format!("word_{name}")));
        let outs = ["a", "b", "c"].map(|name| b.output(name, 8, "bits", "the word"));
        outs.iter().zip(words).for_each(|(out, word)| b.drive(*out, word, Some(4)));
        b.finish(Some(4), &[])
    }

    fn text(visible: &[&str]) -> String {
        print_module(&module(visible), &Style::default())
    }

    #[test]
    fn values_that_wait_alike_share_one_shift_register() {
        let all = text(&[]);
        let bundle = "  reg [71:0] s0_to_s4;\n  always @(posedge clk) begin\n    {s4_word_x, s4_word_y, s4_word_z, s0_to_s4} <=\n        \
                      {s0_to_s4, x, y, z};\n  end\n";
        assert!(all.contains(bundle) && !all.contains("s1_"), "{all}");
        // What stays visible has a net in each stage.
        let some = text(&["word_y"]);
        assert!(some.contains("reg [47:0] s0_to_s4;") && some.contains("s3_word_y <= s2_word_y;"), "{some}");
        // Three registers are none that a bundle is for.
        assert!(!text(&["word_x", "word_y"]).contains("_to_"));
    }

    #[test]
    fn bits_of_a_shift_register_have_names() {
        let m = module(&[]);
        let name = |bit| delayed_bit(&m, "s0_to_s4", bit);
        assert_eq!(name(0).as_deref(), Some("s1_word_z[0]"));
        assert_eq!(name(8 + 3).as_deref(), Some("s1_word_y[3]"));
        assert_eq!(name(2 * 24 + 23).as_deref(), Some("s3_word_x[7]"));
        assert_eq!((name(72), delayed_bit(&m, "s0_to_s3", 0)), (None, None));
    }
}
