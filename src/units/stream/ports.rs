//! Streams at the ports of a module.
use super::Stream;
use crate::quantity::{BIT, Quantity};
use reliefrtl_ir::{Builder, Expr, OutputRecord, Record, Sig};

/// A field of a port: its name, width, unit and meaning.
pub type Field<'a> = (&'a str, Expr, Quantity, &'a str);

/// A stream that enters: inputs `<name>_valid` and `<name>_<field>`, output `<name>_ready`.
pub struct InputStream<'b> {
    /// The word.
    pub data: Record<'b>,
    /// The word is valid.
    pub valid: Sig<'b>,
    ready: usize,
}

impl<'b> InputStream<'b> {
    /// Declares the ports.
    pub fn declare(b: &'b Builder, name: &str, ready_doc: &str, fields: &[Field<'_>]) -> Self {
        let valid = b.input(&format!("{name}_valid"), 1, BIT, "input valid");
        let ready = b.output(&format!("{name}_ready"), 1, BIT, ready_doc);
        let port = |(field, width, unit, doc): &Field<'_>| {
            ((*field).to_string(), b.input(&format!("{name}_{field}"), width, *unit, doc))
        };
        Self { data: fields.iter().map(port).collect(), valid, ready }
    }
    /// Drives the ready port.
    pub fn ready(&self, b: &Builder, ready: Sig<'_>) {
        b.drive(self.ready, ready);
    }
    /// The stream, its ready a wire of the name `wire` that drives the port.
    pub fn stream(self, b: &'b Builder, wire: &str) -> Stream<'b> {
        let ready = b.wire(wire, 1);
        self.ready(b, ready);
        Stream { data: self.data, valid: self.valid, ready }
    }
}

/// A stream that leaves: outputs `<name>_valid` and `<name>_<field>`, input `<name>_ready`.
pub struct OutputStream<'b> {
    valid: usize,
    /// The word transfers where this and valid are 1.
    pub ready: Sig<'b>,
    data: OutputRecord,
}

impl<'b> OutputStream<'b> {
    /// Declares the ports.
    pub fn declare(b: &'b Builder, name: &str, fields: &[Field<'_>]) -> Self {
        let valid = b.output(&format!("{name}_valid"), 1, BIT, "output valid");
        let doc = "output ready (transfer when valid && ready)";
        let ready = b.input_static(&format!("{name}_ready"), 1, BIT, doc);
        Self { valid, ready, data: b.output_record(name, fields) }
    }
    /// Drives the ports.
    #[track_caller]
    pub fn drive(&self, b: &Builder, valid: Sig<'_>, data: &Record<'_>) {
        b.drive(self.valid, valid);
        self.data.drive(b, data);
    }
    /// Lets a stream leave here.
    #[track_caller]
    pub fn take(&self, b: &'b Builder, stream: &Stream<'b>) {
        b.connect(stream.ready, self.ready);
        self.drive(b, stream.valid, &stream.data);
    }
}
