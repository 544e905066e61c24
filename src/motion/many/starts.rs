//! A fixed sequence of starts that fills a square of displacement and velocity evenly.

use crate::float::Float;
use crate::machine::ratios::Ratios;
use crate::motion::state::State;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Starts at ω_d t = 0 within |x| ≤ R and |v| ≤ R, in B and B ω_d, for [`crate::motion::Attractors`].
///
/// The first start is at rest at x = 0. The others are the fractional parts of the multiples of 1/g and 1/g²,
/// g³ = g + 1, which fill a square more evenly than random numbers do: R₂ of M. Roberts, "The unreasonable
/// effectiveness of quasirandom sequences" (2018).
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::motion::Starts;
/// let starts = Starts::around(&Ratios::new(0.5f64, 4.0)?.with_static_friction_ratio(1.3)?);
/// assert_eq!(starts.get(0).x, 0.0);
/// assert!((1..1000).all(|number| starts.get(number).x.abs() <= starts.reach()));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Starts<F> {
    reach: F,
}

impl<F: Float> Starts<F> {
    /// Starts over the range of motions at these ratios: R = 3 + 2 (η + the frictionless amplitude, at most
    /// 20 α).
    pub fn around(ratios: &Ratios<F>) -> Self {
        let (swing, most) = (ratios.forced_amplitude().abs(), F::int(20) * ratios.alpha());
        let swing = if swing < most { swing } else { most };
        Self { reach: F::int(3) + F::int(2) * (ratios.static_friction_ratio() + swing) }
    }

    /// Starts with R = `reach`; `None` unless 0 < R ≤ 2⁴⁰.
    pub fn within(reach: F) -> Option<Self> {
        (reach > F::int(0) && reach <= F::exp2i(40)).then_some(Self { reach })
    }

    /// The range R.
    pub const fn reach(&self) -> F {
        self.reach
    }

    /// The start with this number.
    pub fn get(&self, number: u64) -> State<F> {
        let place = |step: f64| {
            let part = (number as f64 * step).fract();
            F::from_f64(if number == 0 { 0.0 } else { 2.0 * part - 1.0 }) * self.reach
        };
        let (x, v) = (place(0.754_877_666_246_692_7), place(0.569_840_290_998_053_3));
        // R ≤ 2⁴⁰ and no multiple is within 2⁻⁴⁰ of a whole number: every type can represent the state.
        State { x, v, ..State::default() }
    }
}
