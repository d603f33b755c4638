//! Places for rays outside the loop, each with the clocks until its ray is ready.
use reliefrtl::ir::{Builder, Sig};
use reliefrtl::units::traversal::{Exchange, Slot};

/// Bits of a place's count.
const COUNT_W: u32 = 8;

/// One place.
struct Parked<'b> {
    taken: Sig<'b>,
    count: Sig<'b>,
    words: Vec<Sig<'b>>,
    /// Its ray is ready, and no earlier place has one that is.
    chosen: Sig<'b>,
    /// It is free, and no earlier place is.
    next_free: Sig<'b>,
}

/// The exchange with `places` of them; a ray is ready `fill` clocks after it was parked. With `swap`, one that finds no free place takes that of a
/// ray that is ready.
pub fn park<'b>(b: &'b Builder, slot: &Slot<'_, 'b>, places: u32, fill: u32, swap: bool) -> Exchange<'b> {
    b.section("parking", "");
    let kept = slot.kept.iter().map(|(name, v)| (format!("kept_{name}"), v));
    let held: Vec<(String, Sig<'b>)> = slot.held.words().map(|(n, v)| (n.to_owned(), v)).chain(kept).collect();
    let (mut ready, mut free) = (b.zeros(1), b.zeros(1));
    let mut list = Vec::new();
    for k in 0..places {
        let name = |what: &str| format!("place{k}_{what}");
        let taken = b.loop_reg(&name("taken"), 1, true);
        let count = b.loop_reg(&name("count"), COUNT_W, true);
        let words = held.iter().map(|(word, v)| b.loop_reg(&name(word), v.width(), false)).collect();
        let is_ready = (taken & count.none()).named(&name("is_ready"));
        let chosen = (is_ready & !ready).named(&name("is_chosen"));
        let next_free = (!taken & !free).named(&name("is_next_free"));
        (ready, free) = ((ready | is_ready).named(&name("ready_up_to")), (free | !taken).named(&name("free_up_to")));
        list.push(Parked { taken, count, words, chosen, next_free });
    }
    let waits = (slot.held.valid & slot.held.get("missed")).named("held_waits");
    let room = if swap { free | ready } else { free };
    let parks = (waits & room).named("parks");
    let slot_free = !slot.held.valid | slot.retire | parks;
    let pops = (slot_free & ready).named("pops");
    for (k, place) in list.iter().enumerate() {
        let name = |what: &str| format!("place{k}_{what}");
        let here = free.mux(place.next_free, place.chosen);
        let write = (parks & here).named(&name("is_written"));
        let stays = place.taken & !(pops & place.chosen);
        let less = place.count - place.count.any().zext(COUNT_W);
        let mut pairs = vec![
            (place.taken, (stays | write).named(&name("taken_next"))),
            (place.count, write.mux(b.lit(u64::from(fill), COUNT_W), less)),
        ];
        pairs.extend(place.words.iter().zip(&held).map(|(old, (_, new))| (*old, write.mux(*new, *old))));
        b.close(&pairs);
    }
    let word = |(at, (name, v)): (usize, &(String, Sig<'b>))| -> Sig<'b> {
        if name == "missed" {
            return b.zeros(1);
        }
        let masked = list.iter().map(|p| p.words[at] & p.chosen.rep(v.width()));
        let any = masked.reduce(|all, one| all | one).expect("there is a place");
        any.named(&format!("parked_{name}"))
    };
    let words: Vec<Sig<'b>> = held.iter().enumerate().map(word).collect();
    let (changes, kept) = words.split_at(slot.held.words().count());
    let changes: Vec<(&str, Sig<'b>)> = slot.held.words().map(|(name, _)| name).zip(changes.iter().copied()).collect();
    let kept = slot.kept.names().zip(kept.iter().copied()).collect();
    Exchange { parks, returns: ready, ray: slot.held.with(&changes), kept }
}
