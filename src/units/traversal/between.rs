//! What stands between two pipelines of `traverse` where ready has registers in its way (`latency.handshake`).
use super::stream_queue::{stream_queue, word_queue};
use super::stream_skid::{stream_skid, word_skid};
use crate::ir::{Builder, Sig};

/// A `stream_skid`, or a `stream_queue` if it is told of every word that sets out.
pub struct Between<'b> {
    /// Before which name: `setup`, `hit`.
    pub name: &'static str,
    /// The pipeline before it offers words.
    pub valid: Sig<'b>,
    /// Wire that says whether a word may set out; before a skid: whether the pipeline moves.
    pub room: Sig<'b>,
    /// The words are taken.
    pub take: Sig<'b>,
    /// A word sets out through the pipeline: it has no enable, and a queue stands behind it.
    pub sets_out: Option<Sig<'b>>,
}

impl<'b> Between<'b> {
    /// Passes `words` on; returns whether they are there, and themselves under `names`.
    pub fn pass(&self, b: &'b Builder, words: &[Sig<'b>], names: &[String]) -> (Sig<'b>, Vec<Sig<'b>>) {
        match self.sets_out {
            Some(sets_out) => self.queue(b, sets_out, words, names),
            None => self.skid(b, words, names),
        }
    }

    fn skid(&self, b: &'b Builder, words: &[Sig<'b>], names: &[String]) -> (Sig<'b>, Vec<Sig<'b>>) {
        let name = format!("{}_skid", self.name);
        let ins = [("in_valid", self.valid), ("out_ready", self.take)];
        let o = b.inst(&stream_skid(), &format!("u_{name}"), &[], &ins);
        b.connect(self.room, o[0].unstaged().named(&format!("{name}_ready")));
        let [first, second, turn] =
            [(2, "first"), (3, "second"), (4, "turn")].map(|(k, what)| o[k].named(&format!("{name}_{what}")));
        let place = |(word, to): (&Sig<'b>, &String)| {
            let ins = [("first_open", first), ("second_open", second), ("turn", turn), ("in_data", *word)];
            b.inst(&word_skid(), &format!("u_{name}_{to}"), &[("W", word.width())], &ins)[0].named(to)
        };
        (o[1], words.iter().zip(names).map(place).collect())
    }

    fn queue(&self, b: &'b Builder, sets_out: Sig<'b>, words: &[Sig<'b>], names: &[String]) -> (Sig<'b>, Vec<Sig<'b>>) {
        let name = format!("{}_queue", self.name);
        let ins = [("sets_out", sets_out), ("in_valid", self.valid), ("out_ready", self.take)];
        let o = b.inst(&stream_queue(), &format!("u_{name}"), &[], &ins);
        b.connect(self.room, o[0].unstaged().named(&format!("{name}_room")));
        let [write, read] = [(2, "write"), (3, "read")].map(|(k, what)| o[k].named(&format!("{name}_{what}")));
        let queue = word_queue();
        let place = |(word, to): (&Sig<'b>, &String)| {
            let own = |p: &str| queue.params.iter().find(|q| q.name == p).expect("a queue has it").default;
            let params = [("ADDR_W", own("ADDR_W").into()), ("DATA_W", word.width()), ("DEPTH", own("DEPTH").into())];
            let ins = [("write_en", self.valid), ("write_addr", write), ("write_data", *word), ("read_addr", read)];
            b.inst(&queue, &format!("u_{name}_{to}"), &params, &ins)[0].restage(0).named(to)
        };
        (o[1], words.iter().zip(names).map(place).collect())
    }
}
