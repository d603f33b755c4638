//! Colours. All arithmetic is linear; the square root stands in for the display's curve, because it is the same everywhere.
use reliefrtl_config::MapKind;

/// Linear red, green, blue.
pub(super) type Colour = [f64; 3];

/// A colour by height: the stops are evenly spaced from 0 to 1.
pub(super) fn by_height(stops: &[Colour], height: f64) -> Colour {
    let place = height.clamp(0.0, 1.0) * (stops.len() - 1) as f64;
    let low = (place as usize).min(stops.len() - 2);
    let part = place - low as f64;
    std::array::from_fn(|c| stops[low][c] + (stops[low + 1][c] - stops[low][c]) * part)
}

/// What the map's matter looks like, from its lowest to its highest place.
pub(super) const fn of_map(kind: MapKind) -> &'static [Colour] {
    match kind {
        MapKind::Bricks => &[
            [0.42, 0.39, 0.34],
            [0.46, 0.42, 0.36],
            [0.36, 0.19, 0.13],
            [0.40, 0.13, 0.08],
            [0.46, 0.16, 0.09],
            [0.56, 0.24, 0.15],
        ],
        MapKind::Dunes => &[[0.44, 0.24, 0.11], [0.64, 0.38, 0.18], [0.80, 0.54, 0.29], [0.92, 0.70, 0.43]],
        MapKind::Spikes => &[[0.05, 0.07, 0.13], [0.08, 0.19, 0.30], [0.18, 0.42, 0.52], [0.60, 0.80, 0.82]],
        MapKind::Stairs => &[[0.34, 0.30, 0.20], [0.52, 0.45, 0.31], [0.66, 0.59, 0.43], [0.78, 0.73, 0.58]],
        MapKind::Rocks | MapKind::File => {
            &[[0.10, 0.08, 0.06], [0.23, 0.20, 0.165], [0.36, 0.335, 0.30], [0.46, 0.445, 0.42], [0.56, 0.555, 0.54]]
        }
        MapKind::Flat | MapKind::Spike | MapKind::Pit | MapKind::Checker => {
            &[[0.10, 0.13, 0.20], [0.28, 0.34, 0.42], [0.62, 0.64, 0.62]]
        }
    }
}

/// How much the brightness of the map's matter varies from place to place; what is measured on stays even.
pub(super) const fn mottle_of(kind: MapKind) -> f64 {
    match kind {
        MapKind::Rocks | MapKind::Bricks => 0.45,
        MapKind::Stairs => 0.2,
        MapKind::Dunes => 0.1,
        _ => 0.0,
    }
}

/// From few to many: dark violet, blue-green, yellow; even to the eye, and readable in grey too.
pub(super) const HEAT: [Colour; 7] = [
    [0.027, 0.0, 0.080],
    [0.060, 0.035, 0.235],
    [0.030, 0.130, 0.280],
    [0.013, 0.270, 0.260],
    [0.090, 0.460, 0.150],
    [0.420, 0.660, 0.040],
    [0.990, 0.800, 0.020],
];

/// Linear to the bytes of a picture.
pub(super) fn bytes(colour: Colour) -> [u8; 3] {
    colour.map(|channel| (channel.clamp(0.0, 1.0).sqrt() * 255.0).round() as u8)
}
