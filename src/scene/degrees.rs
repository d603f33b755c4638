//! Sine and cosine of degrees with nothing but + - * /, so that rays are equal to the last bit on every machine.

/// Sine and cosine; exact at multiples of 90 degrees, elsewhere within about one unit in the last place.
pub(super) fn sin_cos(degrees: f64) -> (f64, f64) {
    // The remainder of a division is exact, and so is the subtraction: both numbers are near each other.
    let turn = degrees % 360.0;
    let quarter = (turn / 90.0).round();
    let x = (turn - 90.0 * quarter) * (std::f64::consts::PI / 180.0);
    let square = x * x;
    // Taylor series on 45 degrees to either side; the first term left out is below 1e-19.
    let series = |first: u32| {
        let mut sum = 1.0;
        let mut n = first + 18;
        while n > first {
            sum = 1.0 - sum * square / f64::from(n * (n - 1));
            n -= 2;
        }
        sum
    };
    let (sin, cos) = (x * series(1), series(0));
    match (quarter as i64).rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn as_the_library_says() {
        for step in -7200..7200 {
            let degrees = f64::from(step) * 0.1;
            let (sin, cos) = super::sin_cos(degrees);
            assert!((sin - degrees.to_radians().sin()).abs() < 3e-15, "{degrees}");
            assert!((cos - degrees.to_radians().cos()).abs() < 3e-15, "{degrees}");
        }
        assert_eq!(super::sin_cos(90.0), (1.0, 0.0));
        assert_eq!(super::sin_cos(-180.0), (0.0, -1.0));
    }
}
