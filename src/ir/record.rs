//! Records: values under names, which pass a register, a memory or an instance together, as one bundle.
use super::builder::{Builder, Sig};
use super::expr::Expr;
use super::quantity::Quantity;
use std::ops::Index;

/// Values by the names of fields, in order. It stands for no hardware of its own: each field is a net, and a bundle is their concatenation.
#[derive(Clone, Default)]
pub struct Record<'b> {
    fields: Vec<(String, Sig<'b>)>,
}

impl<'b, N: Into<String>> FromIterator<(N, Sig<'b>)> for Record<'b> {
    fn from_iter<I: IntoIterator<Item = (N, Sig<'b>)>>(fields: I) -> Self {
        let fields: Vec<(String, Sig<'b>)> = fields.into_iter().map(|(n, v)| (n.into(), v)).collect();
        let twice = fields.iter().enumerate().find(|(k, f)| fields[..*k].iter().any(|o| o.0 == f.0));
        assert!(twice.is_none(), "a record has two fields {}", twice.map_or("", |t| &t.1.0));
        Self { fields }
    }
}

impl<'b, const K: usize> From<[(&str, Sig<'b>); K]> for Record<'b> {
    fn from(fields: [(&str, Sig<'b>); K]) -> Self {
        fields.into_iter().collect()
    }
}

impl<'b> Index<&str> for Record<'b> {
    type Output = Sig<'b>;
    fn index(&self, field: &str) -> &Sig<'b> {
        let names = || self.names().collect::<Vec<_>>().join(", ");
        self.find(field).unwrap_or_else(|| panic!("no field is named {field}; there are {}", names()))
    }
}

impl<'b> Record<'b> {
    /// A field by its name, if the record has it.
    pub fn get(&self, field: &str) -> Option<Sig<'b>> {
        self.find(field).copied()
    }
    pub(super) fn find(&self, field: &str) -> Option<&Sig<'b>> {
        self.fields.iter().find(|f| f.0 == field).map(|f| &f.1)
    }
    /// Names of the fields, in order.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.fields.iter().map(|f| f.0.as_str())
    }
    /// The fields, in order.
    pub fn iter(&self) -> impl Iterator<Item = (&str, Sig<'b>)> {
        self.fields.iter().map(|f| (f.0.as_str(), f.1))
    }
    /// The same fields with other values.
    pub fn map(&self, mut value: impl FnMut(&str, Sig<'b>) -> Sig<'b>) -> Self {
        self.iter().map(|(name, v)| (name, value(name, v))).collect()
    }
    /// The fields of this record, then those of another.
    ///
    /// # Panics
    /// If both have a field of one name.
    pub fn and(&self, other: impl Into<Record<'b>>) -> Self {
        self.fields.iter().cloned().chain(other.into().fields).collect()
    }
    /// Names the net of each field `<prefix>_<field>`.
    pub fn named(&self, prefix: &str) -> Self {
        self.map(|field, v| v.named(&format!("{prefix}_{field}")))
    }
    /// Bits of the whole record.
    pub fn width(&self) -> Expr {
        self.fields.iter().fold(Expr::from(0), |sum, (_, v)| sum + v.width())
    }
    /// The whole record as one bundle, the first field on top.
    #[track_caller]
    pub fn bundle(&self, b: &'b Builder) -> Sig<'b> {
        match &self.fields[..] {
            [(_, one)] => *one,
            _ => b.cat(&self.fields.iter().map(|f| f.1).collect::<Vec<_>>()),
        }
    }
    /// Takes a bundle apart into the fields that this record has. The nets need names.
    ///
    /// # Panics
    /// If the bundle has other bits than the record.
    #[track_caller]
    pub fn unbundle(&self, bundle: Sig<'b>) -> Self {
        if let [(name, _)] = &self.fields[..] {
            return Self { fields: vec![(name.clone(), bundle)] };
        }
        let mut above = bundle.width();
        self.map(|_, v| {
            above = above.clone() - v.width();
            bundle.slice(&above, v.width())
        })
    }
}

/// Output ports by the names of a record's fields.
pub struct OutputRecord {
    ports: Vec<(String, usize)>,
}

impl OutputRecord {
    /// Drives each port by the field of its name.
    #[track_caller]
    pub fn drive(&self, b: &Builder, record: &Record<'_>) {
        self.ports.iter().for_each(|(field, port)| b.drive(*port, record[field.as_str()]));
    }
}

impl Builder {
    /// Declares outputs `<prefix>_<field>`, each with its width, unit and meaning.
    pub fn output_record(&self, prefix: &str, fields: &[(&str, Expr, Quantity, &str)]) -> OutputRecord {
        let port = |(field, width, unit, doc): &(&str, Expr, Quantity, &str)| {
            ((*field).to_string(), self.output(&format!("{prefix}_{field}"), width, *unit, doc))
        };
        OutputRecord { ports: fields.iter().map(port).collect() }
    }
}
