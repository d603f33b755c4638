//! What a ray brings to the units of the traversal.

/// A ray at some level and parameter, as the datapath encodes it; indices are words of IDX_W bits. What a datapath has not is 0.
#[derive(Clone, Copy, Debug, Default)]
pub struct RaySample {
    /// The ports u, v, du, dv: a ray, or what is refused as one.
    pub(super) ray: [u64; 4],
    /// Level of the node.
    pub(super) level: u64,
    pub(super) axes: [AxisSample; 2],
    /// Height code of the node.
    pub(super) height: u64,
    /// Parameter so far.
    pub(super) t: u64,
    /// Parameter at which the ray is in the node and at or below its height.
    pub(super) m: u64,
    /// Parameter of the nearer exit plane.
    pub(super) t_exit: u64,
}

/// What a sample says about one axis.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct AxisSample {
    /// Entry point, and the same biased backward and forward.
    pub(super) p: u64,
    pub(super) p_back: u64,
    pub(super) p_ahead: u64,
    /// Travel (a float: in a datapath's unit; fixed point: its magnitude `a`, and `s` a height code).
    pub(super) d: u64,
    pub(super) a: u64,
    pub(super) s: u64,
    /// Travel down to the bottom plane, in texels.
    pub(super) dn: u64,
    /// Reciprocal of the travel, and its power of two.
    pub(super) r: u64,
    pub(super) z: u64,
    /// Toward smaller coordinates; not along this axis at all.
    pub(super) neg: u64,
    pub(super) never: u64,
    /// Texels of the ray's ends, and a texel that it does not get beyond.
    pub(super) entry: u64,
    pub(super) end: u64,
    pub(super) last: u64,
    /// The texel in which the ray is, the extent of the node that it may still go through, and the node's exit plane with its parameter.
    pub(super) at: u64,
    pub(super) low: u64,
    pub(super) high: u64,
    pub(super) plane: u64,
    pub(super) edge: u64,
    pub(super) t_plane: u64,
    /// Predicted hit, as a texel and as a position; the texel reached when the ray leaves the node; the position there.
    pub(super) hit: u64,
    pub(super) position: u64,
    pub(super) reach: u64,
    pub(super) cross: u64,
    /// Of a search by windows: planes that the ray has passed, parameter from plane to plane and of the first one, travel and offset of the estimate.
    pub(super) k: u64,
    pub(super) step: u64,
    pub(super) begin: u64,
    pub(super) travel: u64,
    pub(super) offset: u64,
    /// Parameter of the plane that ends some window.
    pub(super) end_of_window: u64,
}
