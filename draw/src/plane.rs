//! Values over a plane.

/// Values at the points of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    /// The quantity shown.
    pub label: String,
    /// The abscissae, ascending.
    pub x: Vec<f64>,
    /// The ordinates, ascending.
    pub y: Vec<f64>,
    /// The values, row by row: all x at the first y, then at the second; NaN where there is none.
    pub values: Vec<f64>,
    /// The meaning of the colours.
    pub scale: Scale,
}

/// The meaning of the colours of a plane.
#[derive(Debug, Clone, PartialEq)]
pub enum Scale {
    /// The value is an index into this list of names.
    Names(Vec<String>),
    /// From dark to light as the value goes from the first number to the second.
    Shades {
        /// The value of the darkest shade.
        low: f64,
        /// The value of the lightest.
        high: f64,
        /// Whether the scale is logarithmic.
        logarithmic: bool,
    },
}

/// From 0 at the low end of a scale to 1 at its high end; the middle for the value of a scale whose ends are equal.
pub(crate) fn share((low, high): (f64, f64), logarithmic: bool, value: f64) -> f64 {
    if value == low && value == high {
        0.5
    } else if logarithmic {
        (value / low).ln() / (high / low).ln()
    } else if (high - low).is_finite() {
        (value - low) / (high - low)
    } else {
        (value / 2.0 - low / 2.0) / (high / 2.0 - low / 2.0)
    }
}

impl Plane {
    /// (x, y, value) of every point that has one.
    pub fn points(&self) -> impl Iterator<Item = (f64, f64, f64)> {
        let places = self.y.iter().flat_map(|&y| self.x.iter().map(move |&x| (x, y)));
        places.zip(&self.values).filter(|(_, value)| !value.is_nan()).map(|((x, y), &value)| (x, y, value))
    }

    /// The shades for these values: logarithmic where they span more than two orders of magnitude, and where nine tenths of
    /// them lie in the lowest tenth of a linear scale. There a 0 is as dark as the least value above it.
    #[must_use]
    pub fn shades(values: &[f64]) -> Scale {
        let finite = || values.iter().copied().filter(|v| v.is_finite());
        let (low, high) =
            (finite().fold(f64::INFINITY, f64::min), finite().fold(f64::NEG_INFINITY, f64::max));
        let logarithmic = low > 0.0 && high > 100.0 * low;
        let tenth = low + (high - low) / 10.0;
        let is_crowded = 10 * finite().filter(|v| *v <= tenth).count() >= 9 * finite().count();
        let least = finite().filter(|v| *v > 0.0).fold(f64::INFINITY, f64::min);
        if low >= 0.0 && is_crowded && least < high {
            Scale::Shades { low: least, high, logarithmic: true }
        } else if low < high {
            Scale::Shades { low, high, logarithmic }
        } else {
            Scale::Shades { low: 0.0, high: 1.0, logarithmic: false }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Plane, Scale};

    #[test]
    fn shades_of_crowded_values_are_logarithmic() {
        let of = |values: &[f64]| match Plane::shades(values) {
            Scale::Shades { low, high, logarithmic } => (low, high, logarithmic),
            Scale::Names(_) => panic!("{values:?}"),
        };
        let mut values: Vec<f64> = (0..91).map(f64::from).collect();
        values.extend([f64::NAN, 200.0, 400.0, 600.0, 800.0, 1000.0]);
        assert_eq!(of(&values), (1.0, 1000.0, true));
        // More than a tenth of the values above a tenth of the scale.
        values.extend([300.0; 7]);
        assert_eq!(of(&values), (0.0, 1000.0, false));
        // Values of either sign have no logarithm.
        assert_eq!(of(&[[-1.0; 1].as_slice(), &[0.0; 40], &[100.0]].concat()), (-1.0, 100.0, false));
        assert_eq!(of(&[1.0, 2.0]), (1.0, 2.0, false));
        assert_eq!(of(&[1.0, 200.0]), (1.0, 200.0, true));
        assert_eq!(of(&[0.0, 0.0]), (0.0, 1.0, false));
    }

    #[test]
    fn points_are_those_with_a_value() {
        let plane = Plane {
            label: String::new(),
            x: vec![1.0, 2.0],
            y: vec![3.0, 4.0],
            values: vec![0.5, f64::NAN, 0.25, f64::INFINITY],
            scale: Scale::Shades { low: 0.0, high: 1.0, logarithmic: false },
        };
        let points: Vec<_> = plane.points().collect();
        assert_eq!(points, [(1.0, 3.0, 0.5), (1.0, 4.0, 0.25), (2.0, 4.0, f64::INFINITY)]);
    }
}
