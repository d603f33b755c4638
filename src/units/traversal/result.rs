//! The result of a ray that retires: its position in the texel, what is carried beside, the bilinear refinement; as one stream.
use super::bilinear::bilinear_hit;
use super::datapath::Datapath;
use super::height_source::Load;
use super::loop_state::{Ray, Sizes};
use crate::quantity::{BIT, BITS, ITERATIONS, LEVELS, Quantity, TEXELS, integer};
use crate::stream::{Pipeline, word_delay};
use reliefrtl_config::Design;
use reliefrtl_ir::{Builder, Expr, Record, Sig};

/// What a hit is, wherever it was found: texel, position in it, ray parameter.
const HIT: [&str; 5] = ["i", "j", "fu", "fv", "t"];

/// The fields of a result in the order of their ports, each with its width, unit and meaning.
pub(super) fn result_fields<'a>(b: &Builder, s: &Sizes, d: &Design) -> Vec<(&'a str, Expr, Quantity, &'a str)> {
    let (texel, position, one) = (|| s.levels.clone(), || s.frac.clone(), || Expr::from(1));
    let (time, unit) = s.numbers.time.clone();
    const FRACTION: Quantity = integer("1/2^FRAC_W texel");
    let mut list = vec![
        ("tag", s.tag.clone(), BITS, "tag of the ray"),
        ("i", texel(), TEXELS, "hit texel, column (u)"),
        ("j", texel(), TEXELS, "hit texel, row (v)"),
        ("fu", position(), FRACTION, "position in the texel along u"),
        ("fv", position(), FRACTION, "position in the texel along v"),
        ("t", time.clone(), unit, "ray parameter: 0 at the top plane"),
        ("wall", one(), BIT, "the hit is on the side of a texel"),
    ];
    let given_up = match d.gives_steps() {
        true => "given up: STEP_LIMIT reached, or not a ray (steps 0)",
        false => "given up: STEP_LIMIT reached, or not a ray",
    };
    list.push(("limit", one(), BIT, given_up));
    let windows = !d.datapath.kind.facts().counts_levels;
    let visited = if windows { "iterations, each over all windows" } else { "nodes visited" };
    list.extend(d.gives_steps().then(|| ("steps", 16.into(), ITERATIONS, visited)));
    if d.gives_crossings() {
        list.push(("crossings", 16.into(), ITERATIONS, "iterations that crossed into a neighbour"));
        list.push(("ups", 16.into(), LEVELS, "levels gone up"));
    }
    if d.mode.bilinear {
        b.require(&s.height + s.frac.clone() * 2 + &s.numbers.float.as_ref().expect("the watertight datapath").man, 60);
        list.extend([
            (
                "patch",
                2.into(),
                integer("code"),
                "surface between texel centres: 0 given up, 1 hit; not met: 2 above it, 3 below it",
            ),
            ("bi", texel(), TEXELS, "texel of the refined hit, column (u); not met: of the hit"),
            ("bj", texel(), TEXELS, "texel of the refined hit, row (v); not met: of the hit"),
            ("bfu", position(), FRACTION, "position of the refined hit in its texel along u"),
            ("bfv", position(), FRACTION, "position of the refined hit in its texel along v"),
            ("bt", time, unit, "ray parameter of the refined hit"),
        ]);
    }
    list
}

/// What a result is made of.
pub(super) struct Result<'a, 'b> {
    pub b: &'b Builder,
    pub d: &'a Design,
    pub path: &'a Datapath,
    pub sizes: &'a Sizes,
    /// The ray that leaves, by the loop's registers.
    pub held: &'a Ray<'b>,
    /// The load ports.
    pub loads: &'a [Load<'b>],
    /// Clocks from the loop to the output.
    pub clocks: u32,
}

impl<'b> Result<'_, 'b> {
    /// Sends the ray of the loop registers through `hit` where `retire` is 1; the words of [`result_fields`] at its end.
    pub fn pass(&self, hit: &Pipeline<'b>, retire: Sig<'b>) -> Record<'b> {
        let (b, held) = (self.b, self.held);
        b.section("result", "The ray that retires, from the loop registers.");
        let mut computed = self.position(hit.enable(b));
        // In a node of a coarser level, the hit position says which texel it is.
        let texel: Record<'b> = match self.d.mode.lod {
            true => Record::default(),
            false => [("i", "x", "column"), ("j", "y", "row")]
                .map(|(i, x, what)| {
                    let texel = held.get(x).slice(0, &self.sizes.levels);
                    (i, texel.doc(&format!("hit texel, {what} [texels]")))
                })
                .into(),
        };
        // The loop counts steps for its limit, whether a hit says them or not.
        let is_given = |n: &&str| *n != "steps" || self.d.gives_steps();
        let carried = ["t", "wall", "limit", "steps", "crossings", "ups", "tag"].into_iter().filter(is_given);
        let carried = carried.filter_map(|n| Some((n, held.find(n)?))).collect::<Record<'b>>();
        // Out of a slot memory it comes without its meaning.
        let carried = carried.map(|_, v| if v.meaning().is_some() { v } else { v.doc("tag of the ray [bits]") });
        if self.d.mode.bilinear {
            computed = computed.and(self.refined(hit.enable(b)));
        }
        let result = hit.pass(b, self.clocks, retire, (computed, texel.and(carried)), ["hit", "result"]);
        if self.d.mode.bilinear { refined_where_met(&result) } else { result }
    }

    /// Position of the hit in its texel, `fu` and `fv`; with a level of detail the texel, `i` and `j`, after it.
    fn position(&self, ce: Sig<'b>) -> Record<'b> {
        let (b, hit) = (self.b, (self.path.hit)(self.d));
        let axis = |name: &str, axis: &str| {
            let mut ins = (self.path.hit_inputs)(self.held, axis);
            ins.push(("ce", ce));
            let o = b.inst(&hit, &format!("u_hit_{name}"), &[("IDX_W", self.sizes.idx.clone())], &ins);
            o.record().map(|_, v| v.rebase_stage(0))
        };
        let (u, v) = (axis("u", "x"), axis("v", "y"));
        let mut place: Record<'b> = [("fu", u["fraction"]), ("fv", v["fraction"])].into();
        let early = self.clocks - hit.latency().expect("a pipeline");
        if early > 0 {
            // The refinement takes longer.
            let place_early = place.named("block");
            let ins = [("in_data", place_early.bundle(b)), ("ce", ce)];
            let o = b.inst(&word_delay("fraction_delay", early), "u_hit_fraction", &[("W", place.width())], &ins);
            let late = place_early.unbundle(o["out_data"].rebase_stage(0));
            place = late.map(|n, v| v.doc(&format!("position in the texel along {} [1/2^FRAC_W texel]", &n[1..])));
        }
        let texel = [("i", u.get("texel")), ("j", v.get("texel"))];
        place.and(texel.into_iter().filter_map(|(n, v)| Some((n, v?))).collect::<Record<'b>>())
    }

    /// The refinement beside the hit position: code of the patch, texel, position in it, ray parameter.
    fn refined(&self, ce: Sig<'b>) -> Record<'b> {
        let (b, load) = (self.b, &self.loads[0]);
        b.section("refine", "Bilinear refinement: moves the hit to the surface interpolated between texel centres.");
        let mut ins = vec![("load_en", load.en), ("load_addr", load.addr), ("load_data", load.data), ("ce", ce)];
        ins.extend(["p_x", "d_x", "r_x", "p_y", "d_y", "r_y", "t"].map(|n| (n, self.held.get(n))));
        let o = b.inst(&bilinear_hit(self.d), "u_bilinear", &[("IDX_W", self.sizes.idx.clone())], &ins);
        let ports = [("patch", "patch"), ("bi", "i"), ("bj", "j"), ("bfu", "fu"), ("bfv", "fv"), ("bt", "t_refined")];
        ports.map(|(field, port)| (field, o[port].rebase_stage(0))).into()
    }
}

/// The refined hit, or the hit itself where no surface is met; no patch where there is no hit at all.
fn refined_where_met<'b>(found: &Record<'b>) -> Record<'b> {
    let has_hit = (!found["limit"]).named("has_hit");
    let patch = (found["patch"] & has_hit.rep(2)).named("patch");
    let is_met = (patch.bit(0) & !patch.bit(1)).named("is_met");
    found.map(|field, v| match field.strip_prefix('b').filter(|old| HIT.contains(old)) {
        Some(old) => is_met.mux(v, found[old]),
        None if field == "patch" => patch,
        None => v,
    })
}
