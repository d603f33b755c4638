//! A height memory whose lookups miss at random: hits and misses from an LFSR, and clocks until a missed word is there.
use reliefrtl::ir::{Expr, Sig};
use reliefrtl::units::traversal::{
    Addresses, Exchange, Field, HeightPort, HeightSource, Heights, Load, OnChip, Place, Ray, Sizes, Slot, Start,
};

/// What becomes of a ray whose lookup missed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Miss {
    /// It recirculates, until its word is there.
    Recirculate,
    /// It is parked in one of `places` until its word is there; a ray that finds none free recirculates, or with `swap` takes that of a ray that is
    /// ready (rule 3).
    Park { places: u32, swap: bool },
}

/// The pyramid on chip, as if it were a cache.
#[derive(Clone, Copy, Debug)]
pub struct Lookups {
    /// Seed of the LFSR.
    pub seed: u16,
    /// Misses, in eighths of the lookups: 0 to 8.
    pub misses: u32,
    /// Clocks until a missed word is there, 0 to 255.
    pub fill: u32,
    /// Registers between the next node's address and what the lookup says.
    pub clocks: u32,
    /// What a ray does meanwhile.
    pub miss: Miss,
    /// The lookup at the end of the loop takes another address than the next iteration's: a fault.
    pub astray: bool,
}

/// Names of the words that say what was looked up, of each memory.
const ASKED: [&str; 5] = ["asked_0", "asked_1", "asked_2", "asked_3", "asked_4"];

/// Bits of the counter of clocks.
const CLOCK_W: u32 = 16;

impl HeightSource for Lookups {
    fn fields(&self, _: &Sizes, loads: &[Load<'_>]) -> Vec<Field> {
        let mut list = vec![Field::new("missed", &Expr::from(1), Start::Zero)];
        list.extend(ASKED.iter().zip(loads).map(|(name, l)| Field::new(name, &l.addr.width(), Start::Zero)));
        if self.miss == Miss::Recirculate {
            list.push(Field::new("due", &Expr::from(i64::from(CLOCK_W)), Start::Zero));
        }
        list
    }
    fn places(&self) -> u32 {
        match self.miss {
            Miss::Recirculate => 0,
            Miss::Park { places, .. } => places,
        }
    }
    fn misses(&self) -> bool {
        true
    }
    fn open<'b>(&self, place: Place<'b>) -> Box<dyn HeightPort<'b> + 'b> {
        let b = place.b;
        b.section("random misses", "");
        // The first clock after reset puts the seed in.
        let (lfsr, seeded) = (b.loop_reg("lfsr", 16, true), b.loop_reg("is_seeded", 1, true));
        let feedback = (lfsr.bit(15) ^ lfsr.bit(13) ^ lfsr.bit(12) ^ lfsr.bit(10)).named("feedback");
        let shifted = b.cat(&[lfsr.slice(0, 15), feedback]);
        b.close(&[(lfsr, seeded.mux(shifted, b.lit(u64::from(self.seed.max(1)), 16))), (seeded, b.lit(1, 1))]);
        let rate = b.lit(u64::from(self.misses), 4);
        let miss = |low: u32, name: &str| b.sig(lfsr.slice(low, 3).zext(4).lt(rate).named(name).id()).unstaged();
        let (again, new) = (miss(0, "lookup_misses"), miss(7, "first_lookup_misses"));
        let clock = (self.miss == Miss::Recirculate).then(|| {
            let now = b.loop_reg("now_q", CLOCK_W, true);
            let next = (now + b.lit(1, CLOCK_W)).named("now");
            b.close(&[(now, next)]);
            [next, (next + b.lit(u64::from(self.fill), CLOCK_W)).named("due_now")].map(Sig::unstaged)
        });
        Box::new(Port { on_chip: OnChip.open(place), place, source: *self, again, new, clock })
    }
}

struct Port<'b> {
    on_chip: Box<dyn HeightPort<'b> + 'b>,
    place: Place<'b>,
    source: Lookups,
    /// Whether a lookup of this clock misses, at the end of the loop and of a new ray.
    again: Sig<'b>,
    new: Sig<'b>,
    /// The clock, and when a word that is asked for now will be there.
    clock: Option<[Sig<'b>; 2]>,
}

impl<'b> HeightPort<'b> for Port<'b> {
    fn exchange(&mut self, slot: &Slot<'_, 'b>) -> Option<Exchange<'b>> {
        match self.source.miss {
            Miss::Recirculate => None,
            Miss::Park { places, swap } => {
                Some(super::parking::park(self.place.b, slot, places, self.source.fill, swap))
            }
        }
    }

    fn first(&mut self, new: Ray<'b>, _: Sig<'b>, addresses: Addresses<'_, 'b>) -> Ray<'b> {
        let asked = addresses(&new);
        // All words start at zero.
        let missed = (new.get("missed") | (self.new & !new.get("done"))).named("new_misses");
        let mut words = vec![("missed", missed)];
        words.extend(self.clock.map(|[_, due]| ("due", (new.get("due") | due).named("new_due"))));
        words.extend(
            ASKED.iter().zip(asked).map(|(name, v)| (*name, (new.get(name) | v).named(&format!("new_{name}")))),
        );
        new.with(&words)
    }

    /// A word that missed, or that was not looked up, is not the right one: it has every bit wrong.
    fn read(&mut self, ray: &Ray<'b>, addresses: &[Sig<'b>]) -> Heights<'b> {
        let missed = ray.get("missed");
        let right = self.on_chip.read(ray, addresses).words;
        let word = |(k, (right, address)): (usize, (Sig<'b>, &Sig<'b>))| {
            let asked = ray.get(ASKED[k]);
            let other = !asked.at(address.stage().expect("an address has a stage")).eq(*address);
            let wrong = missed.at(other.stage().expect("as late as the address")) | other;
            let wrong = wrong.named(&format!("word_{k}_is_wrong")).at(right.stage().expect("a word has a stage"));
            (right ^ wrong.rep(right.width())).named(&format!("word_{k}"))
        };
        let words = right.into_iter().zip(addresses).enumerate().map(word).collect();
        Heights { words, missed: Some(missed) }
    }

    fn look_up(&mut self, next: Ray<'b>, addresses: Addresses<'_, 'b>) -> Ray<'b> {
        let b = self.place.b;
        b.section("lookup", "Of what the next iteration reads, at the end of the loop.");
        // What comes from a slot memory, and what follows from it, may be a clock later than the ray.
        let asked = addresses(&next);
        let last = asked.iter().filter_map(|v| v.stage()).fold(next.last_stage(), u32::max);
        let astray = |v: Sig<'b>| if self.source.astray { !v } else { v };
        let asked = ASKED.iter().zip(asked).map(|(name, v)| (*name, astray(v).named(&format!("{name}_next"))));
        let next = next.with(&asked.collect::<Vec<_>>()).delayed(last + self.source.clocks, "next");
        let missed = next.get("missed");
        // Of a ray that waits: recirculating, until its word is there; else until it was parked.
        let still = self.clock.map_or_else(|| b.lit(1, 1), |[now, _]| (now - next.get("due")).msb().named("is_early"));
        let misses = (missed.mux(still, self.again) & !next.get("done")).named("misses");
        let mut words = vec![("missed", misses)];
        words.extend(self.clock.map(|[_, due]| ("due", missed.mux(next.get("due"), due))));
        next.with(&words)
    }
}
