//! The end of a module: where its latency comes from. No one states it: it is the stage in which the outputs stand.
use super::builder::{Builder, Driven, Sig};
use super::expr::Binding;
use super::module::*;
use super::prim::Prim;
use std::sync::Arc;

impl Builder {
    /// Ends a module of a fixed latency: the stage of its latest output, or of [`Builder::at_least`] if that is later. Outputs of earlier stages
    /// wait in registers, as operands do. What its instances require of the parameters becomes a requirement of its own, and it is verified
    /// at its defaults and at `bindings`.
    ///
    /// A latency can't be stated:
    ///
    /// ```compile_fail
    /// # use reliefrtl_ir::Builder;
    /// let b = Builder::new("m", file!(), "a module");
    /// b.finish(Some(7), &[]);
    /// ```
    ///
    /// # Panics
    /// With all problems at once; a module that fails here is a bug of the unit that describes it.
    #[track_caller]
    pub fn finish(self, bindings: &[Binding]) -> Arc<Module> {
        let latency = self.balance();
        self.end(Some(latency), bindings)
    }
    /// Ends a module whose outputs come by handshakes: it has no latency, and nothing is balanced.
    ///
    /// # Panics
    /// As [`Builder::finish`]; also if a stage was asked for.
    #[track_caller]
    pub fn finish_streams(self, bindings: &[Binding]) -> Arc<Module> {
        assert!(self.st.borrow().least == 0, "outputs of handshakes stand in no stage that could be asked for");
        self.end(None, bindings)
    }
    /// Ends a primitive: its outputs appear as many clocks after its inputs as `prim` takes at the default parameters.
    ///
    /// # Panics
    /// As [`Builder::finish`].
    #[track_caller]
    pub fn finish_primitive(self, prim: Prim) -> Arc<Module> {
        let clocks = {
            let mut st = self.st.borrow_mut();
            let clocks = prim.clocks(&st.defaults);
            st.m.body = Body::Prim(prim);
            st.m.ports.iter_mut().filter(|p| p.dir == Dir::Out).for_each(|p| p.stage = Some(clocks));
            clocks
        };
        self.end(Some(clocks), &[])
    }

    /// Delays all outputs to the latest one's stage, which it returns. The registers come where each output was driven.
    #[track_caller]
    fn balance(&self) -> u32 {
        let (driven, count) = {
            let st = self.st.borrow();
            (st.driven.clone(), st.m.nodes.len())
        };
        let of = |id: NodeId| Sig { b: self, id };
        let Some(latest) = driven.iter().filter_map(|d| of(d.by).stage()).max() else { return 0 };
        let latency = latest.max(self.st.borrow().least);
        let mut order: Vec<(usize, bool, usize)> = (0..count).map(|k| (k, true, k)).collect();
        for (k, d) in driven.iter().enumerate() {
            let before = self.st.borrow().m.nodes.len();
            self.st.borrow_mut().section = d.section;
            let late = of(d.by).at(latency).id;
            let mut st = self.st.borrow_mut();
            st.driven[k].by = late;
            order.extend((before..st.m.nodes.len()).map(|new| (d.nodes, false, new)));
        }
        order.sort();
        self.reorder(&order.into_iter().map(|o| o.2).collect::<Vec<_>>());
        latency
    }
    /// Puts the nodes into `order`, which has the index of each.
    fn reorder(&self, order: &[usize]) {
        let mut st = self.st.borrow_mut();
        let mut place = vec![NodeId(0); order.len()];
        order.iter().enumerate().for_each(|(new, old)| place[*old] = NodeId(new as u32));
        let to = |id: &mut NodeId| *id = place[id.0 as usize];
        let mut old: Vec<Option<Node>> = std::mem::take(&mut st.m.nodes).into_iter().map(Some).collect();
        st.m.nodes = order.iter().map(|k| old[*k].take().expect("each node once")).collect();
        st.m.nodes.iter_mut().flat_map(|n| n.args.iter_mut()).for_each(to);
        st.m.unused.iter_mut().for_each(to);
        st.m.insts.iter_mut().flat_map(|i| i.inputs.iter_mut()).for_each(|(_, id)| to(id));
        st.driven.iter_mut().for_each(|d| to(&mut d.by));
    }

    #[track_caller]
    fn end(self, latency: Option<u32>, bindings: &[Binding]) -> Arc<Module> {
        let st = self.st.into_inner();
        let mut m = st.m;
        for Driven { port, by, .. } in st.driven {
            m.ports[port].stage = m.node(by).stage;
            m.outputs.push((port, by));
        }
        m.latency = latency;
        super::conditions::inherit(&mut m);
        let problems = super::verify::verify(&m, bindings);
        assert!(problems.is_empty(), "module {} is wrong:\n  {}", m.name, problems.join("\n  "));
        Arc::new(m)
    }
}
