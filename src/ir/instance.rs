//! Instances: another module in this one, with its parameters, its inputs by name, and its outputs by name.
use super::builder::{Builder, Sig};
use super::expr::Expr;
use super::module::*;
use super::record::Record;
use std::collections::BTreeMap;
use std::ops::Index;
use std::sync::Arc;

impl Builder {
    /// Instantiates `module`: parameters of the same name are passed through unless given, and inputs are matched by
    /// name. Returns the outputs by their names. `control` drives clock enable and reset where the module has them.
    #[track_caller]
    pub fn inst(
        &self,
        module: &Arc<Module>,
        name: &str,
        params: &[(&str, Expr)],
        inputs: &[(&str, Sig<'_>)],
    ) -> Outputs<'_> {
        self.inst_of_file(module, name, params, inputs, "")
    }
    /// The same; where both have a file parameter of one name, `suffix` is put after the name of the file.
    #[track_caller]
    pub fn inst_of_file(
        &self,
        module: &Arc<Module>,
        name: &str,
        params: &[(&str, Expr)],
        inputs: &[(&str, Sig<'_>)],
        suffix: &str,
    ) -> Outputs<'_> {
        let stage = inputs.iter().filter_map(|(_, s)| s.stage()).max();
        let stage = stage.map(|s| s.max(self.st.borrow().min_stage));
        let mut map = BTreeMap::new();
        for p in &module.params {
            let given = params.iter().find(|g| g.0 == p.name).map(|g| g.1.clone());
            let own = self.st.borrow().m.params.iter().any(|q| q.name == p.name);
            let value = given.or(own.then(|| Expr::param(&p.name)));
            map.insert(p.name.clone(), value.unwrap_or_else(|| panic!("{name}: parameter {} is not given", p.name)));
        }
        let mut ins = Vec::new();
        for (n, v) in inputs {
            let (i, port) = module.port(n).unwrap_or_else(|| panic!("{}: no port {n}", module.name));
            let v = if port.stage.is_some() { v.at(stage.unwrap_or(0)) } else { *v };
            let (pw, vw) = {
                let st = self.st.borrow();
                (port.width.substitute(&map).eval(&st.defaults), v.width().eval(&st.defaults))
            };
            assert!(pw == vw, "{name}.{n} has {pw} bits, its driver {vw}");
            ins.push((i, v.id));
        }
        if let Some(i) = module.ce.filter(|i| !ins.iter().any(|x| x.0 == *i)) {
            let own = self.st.borrow().m.ce;
            let ce = own.map(|p| self.input_node(p)).unwrap_or_else(|| self.lit(1, 1));
            ins.push((i, ce.id));
        }
        if let Some(i) = module.rst.filter(|i| !ins.iter().any(|x| x.0 == *i)) {
            let own = self.st.borrow().m.rst.unwrap_or_else(|| panic!("{name}: no reset"));
            ins.push((i, self.input_node(own).id));
        }
        for (i, p) in module.data_inputs() {
            assert!(ins.iter().any(|x| x.0 == i), "{name}: input {} is not driven", p.name);
        }
        ins.sort();
        let id = {
            let mut st = self.st.borrow_mut();
            let section = st.section;
            let params = module.params.iter().map(|p| (p.name.clone(), map[&p.name].clone())).collect();
            let passed = module.files.iter().filter(|f| st.m.files.iter().any(|own| own.name == f.name));
            let files = passed.map(|f| (f.name.clone(), suffix.to_string())).collect();
            st.m.insts.push(Instance {
                module: module.clone(),
                name: name.into(),
                params,
                files,
                inputs: ins,
                stage,
                section,
            });
            InstId(st.m.insts.len() as u32 - 1)
        };
        let outs = module.data_outputs().map(|(i, p)| {
            let s = p.stage.map(|k| stage.unwrap_or(0) + k);
            let out = self.push_at(Op::InstOut(id, i), vec![], p.width.substitute(&map), s);
            self.st.borrow_mut().m.nodes[out.id.0 as usize].handshaked = module.latency().is_none();
            out
        });
        Outputs::new(module, name, &outs.collect::<Vec<_>>())
    }
    fn input_node(&self, port: usize) -> Sig<'_> {
        let st = self.st.borrow();
        let i = st.m.nodes.iter().position(|n| n.op == Op::Input(port)).expect("port has a node");
        Sig { b: self, id: NodeId(i as u32) }
    }
}

/// What an instance puts out. A port is asked for by its name, so that one more in the module moves none of the others.
pub struct Outputs<'b> {
    module: Arc<Module>,
    instance: String,
    ports: Record<'b>,
}

impl<'b> Outputs<'b> {
    /// The values of the module's outputs, in the order of its ports.
    fn new(module: &Arc<Module>, instance: &str, values: &[Sig<'b>]) -> Self {
        let names = module.data_outputs().map(|(_, p)| p.name.as_str());
        Self { module: module.clone(), instance: instance.into(), ports: names.zip(values.iter().copied()).collect() }
    }
    /// An output by its name, where the module has it: some have a port only in some designs.
    pub fn get(&self, port: &str) -> Option<Sig<'b>> {
        self.ports.get(port)
    }
    /// The output of a module with a single one.
    ///
    /// # Panics
    /// If there are several, or none.
    #[track_caller]
    pub fn only(&self) -> Sig<'b> {
        let mut all = self.ports.iter().map(|f| f.1);
        match (all.next(), all.next()) {
            (Some(one), None) => one,
            _ => panic!("{} is asked for its only output and has {}", self.said(), self.names()),
        }
    }
    /// All outputs, as a record.
    pub fn record(self) -> Record<'b> {
        self.ports
    }
    fn said(&self) -> String {
        format!("{} (an instance of {})", self.instance, self.module.name)
    }
    fn names(&self) -> String {
        self.ports.names().collect::<Vec<_>>().join(", ")
    }
}

impl<'b> Index<&str> for Outputs<'b> {
    type Output = Sig<'b>;
    #[track_caller]
    fn index(&self, port: &str) -> &Sig<'b> {
        match self.ports.find(port) {
            Some(v) => v,
            None => panic!("{} has no output {port}; there are {}", self.said(), self.names()),
        }
    }
}
