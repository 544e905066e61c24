//! The friction for a target displacement: every friction of a machine whose steady motion has a stated amplitude.
//!
//! In the cycle of two reversals, with p₀ given and B = r_y/k, eq. 42 with a damper is
//!
//! ```text
//! (qX + gr)² = p₀² − K²r²,   X = kΔ₀,  g = qG,  r = r_y,
//! (K² + g²)r² + 2qXg r + q²X² − p₀² = 0
//! ```
//!
//! Its left side grows with r > 0, since q, X and g are ≥ 0, so that there is one root where qX < p₀ (without friction
//! the amplitude is p₀/qk), and none otherwise. It is an answer where p₀/r is on or above the border.
//!
//! With more friction the body stops, up to p₀/η, with which a body at rest is not released. There the amplitude is that of
//! the exact motion from rest, on a mesh of frictions; each change of sign is halved down to rounding. This part is a
//! search: two answers closer together than the mesh could be missed. A change of sign at a jump of the amplitude is no
//! answer.

use crate::cycle::Border;
use crate::cycle::damped;
use crate::cycle::regime::Regime;
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::{Ratios, positive};
use crate::motion::{Amplitude, Reached};
use crate::root;
use alloc::vec::Vec;

/// Places of the mesh between the border and rest.
const PLACES: i32 = 160;

/// A friction whose steady motion has the target displacement.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct TargetFriction<F> {
    /// The friction force r_y, unit of force.
    pub friction: F,
    /// The regime of the motion.
    pub regime: Regime,
    /// The greatest displacement of that motion, by the forward calculation: unit of length.
    pub max_displacement: F,
}

/// The friction forces with which the steady motion of `body` under `drive` has the greatest displacement `target`, in
/// increasing order; none where no friction gives it.
///
/// Mass, spring, damper and the ratio of static friction are those of `body`; its own friction force plays no part. A
/// displacement is measured from the mean displacement, and over a moving surface in relation to it. Friction without a
/// stop is a closed form, and the only one; with stops the answers are those of a search by the exact motion from rest
/// (`src/design/target_friction.rs`). Relative accuracy at f64 without stops: some 10⁻¹⁵ times the condition
/// `d ln r/d ln Δ₀`.
///
/// ```
/// use stickslip::{Drive, Oscillator, Regime, design::frictions_for_displacement};
/// let body = Oscillator::new(50.0, 1000.0, 1.0)?;
/// let found = frictions_for_displacement(&body, &Drive::force(12.0, 6.0)?, 0.01)?;
/// assert_eq!(found.len(), 1);
/// assert!(found.iter().all(|f| f.regime == Regime::NonSticking && f.friction < 12.0));
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// Where the target is not finite or not > 0, Ω leaves the domain of [`Ratios`], a force overflows or underflows; and
/// those of [`Amplitude::of`] but [`Error::NotSettled`].
pub fn frictions_for_displacement<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    target: F,
) -> Result<Vec<TargetFriction<F>>, Error> {
    let target = positive(Quantity::MaxDisplacement, target)?;
    let force = positive(Quantity::ForceAmplitude, drive.force_amplitude(body))?;
    let machine = Machine { body, drive, stiffness: body.stiffness() };
    // Ω, ζ and η do not depend on the friction.
    let ratios = machine.ratios(force)?;
    let border = force / Border::of(&ratios).min_force_ratio;
    let mut found = Vec::new();
    let mut add = |friction: F| -> Result<(), Error> {
        // On the border both searches find the one answer.
        let is_known =
            |known: &TargetFriction<F>| (known.friction / friction - F::int(1)).abs() < F::exp2i(-20);
        if found.iter().any(is_known) {
            return Ok(());
        }
        let Reached { value, regime } = machine.reached(friction)?;
        if let (Some(max_displacement), Some(regime)) = (value, regime)
            && (max_displacement / target - F::int(1)).abs() <= F::exp2i(-20)
        {
            found.push(TargetFriction { friction, regime, max_displacement });
        }
        Ok(())
    };
    if let Some(friction) = without_stop(&ratios, force, body.stiffness() * target).filter(|r| *r <= border) {
        add(friction)?;
    }
    let rest = force / body.static_friction_ratio();
    // The excess of the amplitude over the target; None where the motion did not settle. A motion without bound exceeds
    // any target.
    let excess = |friction: F| -> Result<Option<F>, Error> {
        let Reached { value, regime } = machine.reached(friction)?;
        let is_unbounded = regime == Some(Regime::Unbounded);
        Ok(if is_unbounded { Some(target) } else { value.map(|x| x - target) })
    };
    let place = |i: i32| border + (rest - border) * F::ratio(i, PLACES);
    let mut last: Option<(F, F)> = None;
    for friction in (0..=PLACES).map(place) {
        let Some(now) = excess(friction)? else {
            last = None;
            continue;
        };
        if let Some((before, then)) = last
            && (then < F::int(0)) != (now < F::int(0))
        {
            let mut failure = None;
            let value = |friction| {
                excess(friction).unwrap_or_else(|e| {
                    failure = Some(e);
                    None
                })
            };
            let (low, high) = root::enclosed(before, friction, with_gaps(value, then));
            if let Some(error) = failure {
                return Err(error);
            }
            add(if machine.is_closer(low, high, target)? { low } else { high })?;
        }
        last = Some((friction, now));
    }
    Ok(found)
}

/// A function whose missing values have the sign of its start.
fn with_gaps<F: Float>(mut value: impl FnMut(F) -> Option<F>, start: F) -> impl FnMut(F) -> F {
    move |x| value(x).unwrap_or(start)
}

/// A body whose friction is to be found.
struct Machine<'a, F> {
    body: &'a Oscillator<F>,
    drive: &'a Drive<F>,
    stiffness: F,
}

impl<F: Float> Machine<'_, F> {
    fn ratios(&self, friction: F) -> Result<Ratios<F>, Error> {
        self.drive.ratios(&self.body.with_friction_bound(friction)?)
    }

    /// The greatest displacement with a friction, and the regime; without a value where the motion did not settle.
    fn reached(&self, friction: F) -> Result<Reached<F>, Error> {
        match Amplitude::Displacement.of(self.ratios(friction)?, self.drive.excitation()) {
            Ok(Reached { value, regime }) => {
                Ok(Reached { value: value.map(|x| x * friction / self.stiffness), regime })
            }
            Err(Error::NotSettled { .. }) => Ok(Reached { value: None, regime: None }),
            Err(error) => Err(error),
        }
    }

    fn is_closer(&self, one: F, other: F, target: F) -> Result<bool, Error> {
        let off = |friction| -> Result<Option<F>, Error> {
            Ok(self.reached(friction)?.value.map(|x| (x - target).abs()))
        };
        Ok(match (off(one)?, off(other)?) {
            (Some(one), Some(other)) => one <= other,
            (one, _) => one.is_some(),
        })
    }
}

/// The positive root of the head of this file; `None` without one.
fn without_stop<F: Float>(ratios: &Ratios<F>, force: F, spring_force: F) -> Option<F> {
    let half = damped::half_period(ratios);
    let (driven, g) = (half.stiffness * spring_force, half.stiffness * half.shift);
    let squares = half.k.square() + g.square();
    let room = (force - driven) * (force + driven);
    let root = (driven * g).square() + squares * room;
    // r = (p₀² − q²X²)/(qXg + √…), which is without cancellation.
    let friction = room / (driven * g + root.sqrt());
    (room > F::int(0) && friction > F::int(0)).then_some(friction)
}

#[cfg(test)]
mod tests {
    use super::frictions_for_displacement;
    use crate::motion::{LongRun, State};
    use crate::{Drive, Excitation, Oscillator, Regime};

    /// The greatest displacement by many samples of the motion from rest.
    fn sampled(body: &Oscillator<f64>, drive: &Drive<f64>) -> f64 {
        let ratios = drive.ratios(body).unwrap();
        let LongRun::Periodic(steady) = LongRun::from_start(ratios, State::default()).unwrap() else {
            return 0.0;
        };
        let samples = crate::motion::Trajectory::new(ratios, steady.state).unwrap().samples(4000).unwrap();
        let most = samples.take(4000).map(|s| s.unwrap().state.x.abs()).fold(0.0, f64::max);
        most * body.friction_displacement()
    }

    #[test]
    fn each_answer_moves_by_the_target() {
        let (mut slides, mut sticks) = (0, 0);
        for zeta in [0.0, 0.05, 0.4] {
            for omega in [0.3, 0.7, 0.95, 1.0, 1.6, 4.0] {
                let body = Oscillator::new(2.0, 8.0, 1.0).unwrap().with_damping_ratio(zeta).unwrap();
                for excitation in [Excitation::Force, Excitation::SurfaceMotion] {
                    let drive = Drive::new(excitation, 3.0, 2.0 * omega).unwrap();
                    let p0: f64 = drive.force_amplitude(&body);
                    let static_stretch = p0 / 8.0;
                    for share in [0.02, 0.3, 0.8, 1.5] {
                        let target = share * static_stretch;
                        let found = frictions_for_displacement(&body, &drive, target).unwrap();
                        for answer in &found {
                            let body = Oscillator::new(2.0, 8.0, answer.friction).unwrap();
                            let body = body.with_damping_ratio(zeta).unwrap();
                            let x = sampled(&body, &drive);
                            assert!((x / target - 1.0).abs() < 2e-5, "{zeta} {omega} {share}: {x} {target}");
                            match answer.regime {
                                Regime::NonSticking => slides += 1,
                                _ => sticks += 1,
                            }
                        }
                        // Every amplitude below the one without friction belongs to some friction. At resonance without
                        // a damper the motion grows without bound from Δ₀ = B on, p₀ = 4r_y/π.
                        let q = ((1.0 - omega * omega).powi(2) + (2.0 * zeta * omega).powi(2)).sqrt();
                        let most = if q == 0.0 { std::f64::consts::FRAC_PI_4 } else { 1.0 / q };
                        assert_eq!(found.is_empty(), share >= most, "{zeta} {omega} {share}");
                    }
                }
            }
        }
        assert!(slides > 20 && sticks > 70, "{slides} {sticks}");
    }

    #[test]
    fn a_target_beyond_the_motion_without_friction_has_no_answer() {
        let body = Oscillator::new(2.0, 8.0, 1.0).unwrap();
        let drive = Drive::force(3.0, 1.0).unwrap();
        // Ω = 1/2: p₀/k/(1 − Ω²) = 1/2.
        assert!(frictions_for_displacement(&body, &drive, 0.5001).unwrap().is_empty());
        assert_eq!(frictions_for_displacement(&body, &drive, 0.4999).unwrap().len(), 1);
        for target in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(frictions_for_displacement(&body, &drive, target).is_err());
        }
    }
}
