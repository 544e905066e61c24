//! The colours of values over a plane: from dark to light, so that their order survives in print.

use crate::plane::Scale;
use crate::plane::share;
use plotters::style::RGBColor;

/// Viridis at nine places.
const SHADES: [(u8, u8, u8); 9] = [
    (68, 1, 84),
    (71, 45, 123),
    (59, 82, 139),
    (44, 114, 142),
    (33, 145, 140),
    (40, 174, 128),
    (94, 201, 98),
    (173, 220, 48),
    (253, 231, 37),
];

/// The number of steps in which shades are drawn, so that neighbours can share a rectangle.
pub(super) const STEPS: u32 = 48;

/// The shade at a position from 0 (dark) to 1 (light).
pub(super) fn shade(place: f64) -> RGBColor {
    let along = place.clamp(0.0, 1.0) * (SHADES.len() - 1) as f64;
    let below = along.floor();
    let at = |i: f64| SHADES.get(i as usize).or(SHADES.last()).copied().unwrap_or_default();
    let ((r, g, b), (s, h, c)) = (at(below), at(below + 1.0));
    let mix = |a: u8, b: u8| (f64::from(a) + (f64::from(b) - f64::from(a)) * (along - below)).round() as u8;
    RGBColor(mix(r, s), mix(g, h), mix(b, c))
}

impl Scale {
    /// The step of a value; `None` where there is nothing to draw.
    pub(super) fn step(&self, value: f64) -> Option<u32> {
        if value.is_nan() {
            return None;
        }
        Some(match self {
            Self::Names(_) => value.max(0.0) as u32,
            Self::Shades { low, high, logarithmic } => {
                let place = share((*low, *high), *logarithmic, value);
                (place.clamp(0.0, 1.0) * f64::from(STEPS - 1)).round() as u32
            }
        })
    }

    /// The colour of a step. Names run from light to dark.
    pub(super) fn colour(&self, step: u32) -> RGBColor {
        match self {
            Self::Names(names) => shade(1.0 - f64::from(step) / (names.len().max(2) - 1) as f64),
            Self::Shades { .. } => shade(f64::from(step) / f64::from(STEPS - 1)),
        }
    }
}
