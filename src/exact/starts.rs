//! A fixed sequence of starts that fills a square of displacement and velocity evenly.

use super::state::State;
use crate::float::Float;
use crate::ratios::Ratios;

/// How far motions at these ratios may go, in B and B ω_d, which is where [`start_within`] looks for limits:
/// R = 3 + 2 (η + the frictionless amplitude, at most 20 α).
pub fn reach_of_starts<F: Float>(ratios: &Ratios<F>) -> F {
    let (swing, most) = (ratios.forced_amplitude().abs(), F::int(20) * ratios.alpha());
    let swing = if swing < most { swing } else { most };
    F::int(3) + F::int(2) * (ratios.static_friction_ratio() + swing)
}

/// The start of that number at ω_d t = 0 within |x| ≤ R and |v| ≤ R, in B and B ω_d, for
/// [`super::attractors()`]; `None` unless 0 < R ≤ 2⁴⁰.
///
/// The first is at rest at x = 0. The others are by the fractional parts of the multiples of 1/g and 1/g²,
/// g³ = g + 1, which fill a square more evenly than random numbers do: R₂ of M. Roberts, "The unreasonable
/// effectiveness of quasirandom sequences" (2018).
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::exact::{attractors, reach_of_starts, start_within};
/// let ratios = Ratios::new(0.5f64, 4.0)?.with_static_friction_ratio(1.3)?;
/// let reach = reach_of_starts(&ratios);
/// let starts: Vec<_> = (0..20).filter_map(|number| start_within(reach, number)).collect();
/// assert!(starts.len() == 20 && starts.iter().all(|start| start.x.abs() <= reach));
/// assert_eq!(attractors(ratios, &starts, 1000)?.of_start.len(), 20);
/// # Ok::<(), stickslip::Error>(())
/// ```
pub fn start_within<F: Float>(reach: F, number: u64) -> Option<State<F>> {
    if !(reach > F::int(0) && reach <= F::exp2i(40)) {
        return None;
    }
    let place = |step: f64| {
        let part = (number as f64 * step).fract();
        F::from_f64(if number == 0 { 0.0 } else { 2.0 * part - 1.0 }) * reach
    };
    let (x, v) = (place(0.754_877_666_246_692_7), place(0.569_840_290_998_053_3));
    // R ≤ 2⁴⁰ and no multiple is within 2⁻⁴⁰ of a whole number: the state is one that every type has.
    Some(State { x, v, ..State::default() })
}
