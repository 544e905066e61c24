//! A body that is pulled through its spring at a constant speed, or stands on a belt: stick-slip.
//!
//! The spring's end moves with the speed V over the surface, or the surface moves with V under the body. With
//! w = 1 − x′/V, x′ the speed of the body over the surface, τ = ω_n t from the release and d = √(1 − ζ²),
//!
//! ```text
//! w″ + 2ζw′ + w = 0,   w(0) = 1,   w′(0) = −A,   A = (η − 1) B ω_n/V,
//! w  = e^{−ζτ} [cos dτ + ((ζ − A)/d) sin dτ]
//! ```
//!
//! wherever the damper acts: at the release the force on the body is exactly that of static friction. With
//! H² = A² − 2ζA + 1 and dφ-phase `tan φ = Ad/(ζA − 1)`, 0 < φ ≤ π, w is least at dτ = φ, −He^{−ζφ/d}, and greatest
//! after it at dτ = φ + π, He^{−ζ(φ+π)/d}. The body stops where w comes back to 1. Its force is then
//! r_y − mVω_n w′ ≥ −r_s, since w² + w′² never grows, so that it sticks; the spring stretches again for the time
//! (A + w′)/ω_n. With V the distance of a slip is V times the period.
//!
//! Where the greatest w is below 1 the body never stops: it slides on, and its speed tends to V. That is so from
//! the speed on at which `A² − 2ζA = e^{2ζ(φ+π)/d} − 1`; for small ζ, A² = 4πζ.

use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::oscillator::Oscillator;
use crate::machine::ratios::positive;
use crate::root;

/// The motion of a body that is pulled through its spring at a constant speed, or stands on a belt of that speed, from
/// rest: stick-slip, or smooth sliding.
///
/// The damper acts on the body from the ground, or beside the spring; the answers are the same. A belt that moves with V
/// under the body is the same problem, with velocities over the belt. Accuracy at f64: some 10⁻¹⁵, times A/(A − A*) near the
/// speed of smooth sliding, whose A is A*.
///
/// ```
/// use stickslip::{Oscillator, motion::Pull};
/// // 1 kg, 100 N/m, 1 N kinetic and 1.5 N static friction, pulled at 1 cm/s
/// let body = Oscillator::new(1.0f64, 100.0, 1.0)?.with_static_friction(1.5)?.with_damping_ratio(0.01)?;
/// let pull = Pull::new(&body, 0.01)?;
/// assert!(pull.period.is_some_and(|t| (t - 1.334_366).abs() < 1e-6));
/// assert!(pull.smooth_above.is_some_and(|v| (v - 0.136_962).abs() < 1e-6));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
#[must_use]
pub struct Pull<F> {
    /// The period of a slip and a stick; `None` where the body slides smoothly.
    pub period: Option<F>,
    /// The duration of a slip; `None` where the body slides smoothly.
    pub slip_time: Option<F>,
    /// The duration of a stick; `None` where the body slides smoothly.
    pub stick_time: Option<F>,
    /// The distance of a slip over the surface; `None` where the body slides smoothly.
    pub slip_distance: Option<F>,
    /// The peak velocity over the surface: of the steady motion, V where the body slides smoothly; 2V where it does and
    /// has no damper, since it then swings between 0 and 2V for ever.
    pub max_velocity: F,
    /// The speed from which on the body slides smoothly; `None` where no speed does so: without a damper, where static
    /// friction exceeds the kinetic one.
    pub smooth_above: Option<F>,
}

impl<F: Float> Pull<F> {
    /// The motion at a speed V > 0 of the spring's end.
    ///
    /// # Errors
    /// Where V is not finite or not > 0, or a time or a velocity of the motion is beyond the range of F.
    pub fn new(body: &Oscillator<F>, speed: F) -> Result<Self, Error> {
        let speed = positive(Quantity::Velocity, speed)?;
        let frequency = positive(Quantity::NaturalFrequency, body.natural_frequency())?;
        let zeta = body.damping_ratio();
        let excess = body.static_friction_ratio() - F::int(1);
        // (η − 1) B ω_n, the speed whose A is 1.
        let scale = excess * body.friction_displacement() * frequency;
        let least = least_excess(zeta);
        let smooth_above = least.map(|least| scale / least);
        let smooth = Self {
            period: None,
            slip_time: None,
            stick_time: None,
            slip_distance: None,
            max_velocity: if zeta == F::int(0) { F::int(2) * speed } else { speed },
            smooth_above: if scale > F::int(0) { smooth_above } else { Some(F::int(0)) },
        };
        if smooth.smooth_above.is_some_and(|least| speed >= least) {
            return Ok(smooth);
        }
        let slip = Slip::new(zeta, scale / speed);
        let (slip_time, stick_time) = (slip.duration / frequency, slip.stick() / frequency);
        let period = positive(Quantity::Time, slip_time + stick_time)?;
        Ok(Self {
            period: Some(period),
            slip_time: Some(slip_time),
            stick_time: Some(stick_time),
            slip_distance: Some(positive(Quantity::Displacement, speed * period)?),
            max_velocity: positive(Quantity::Velocity, speed * (F::int(1) + slip.depth()))?,
            ..smooth
        })
    }
}

/// A slip: w from its release to its stop.
#[derive(Debug, Clone, Copy)]
struct Slip<F> {
    zeta: F,
    d: F,
    /// A > A*.
    excess: F,
    duration: F,
    /// The time from the stop to dτ = 2π, which has more digits than the duration where A is small.
    left: F,
}

impl<F: Float> Slip<F> {
    fn new(zeta: F, excess: F) -> Self {
        let (zero, two) = (F::int(0), F::int(2));
        let d = ((F::int(1) - zeta) * (F::int(1) + zeta)).sqrt();
        let mut slip = Self { zeta, d, excess, duration: zero, left: zero };
        // π − φ, whose digits φ itself would lose where A is small.
        let rest = (excess * d).atan2(F::int(1) - zeta * excess);
        let (low, high) = (rest / d, (rest + F::pi()) / d);
        slip.left = root::newton_within(low, high, |left| {
            let (value, slope) = slip.above(left);
            (value, -slope)
        });
        slip.duration = two * F::pi() / d - slip.left;
        slip
    }

    /// w − 1 and w′ at the time `left` before dτ = 2π.
    fn above(&self, left: F) -> (F, F) {
        let (one, two) = (F::int(1), F::int(2));
        let Self { zeta, d, excess, .. } = *self;
        let decay = -(zeta * (two * F::pi() / d - left));
        let fall = decay.exp();
        let (sine, cosine) = (d * left).sin_cos();
        let half = (d * left / two).sin();
        // w − 1 = (e^{−ζτ} − 1) − e^{−ζτ} [(1 − cos) + ((ζ − A)/d) sin dτ_left]
        let value = decay.exp_m1() - fall * (two * half.square() + (zeta - excess) / d * sine);
        // w′ = −e^{−ζτ} [A cos + ((ζA − 1)/d) sin dτ_left]
        let slope = -(fall * (excess * cosine + (zeta * excess - one) / d * sine));
        (value, slope)
    }

    /// The time of the stick that follows, A + w′.
    fn stick(&self) -> F {
        self.excess + self.above(self.left).1
    }

    /// The most that w falls below 0, He^{−ζφ/d}.
    fn depth(&self) -> F {
        let Self { zeta, d, excess, .. } = *self;
        let phase = (excess * d).atan2(zeta * excess - F::int(1));
        swing(zeta, excess).sqrt() * (-(zeta * phase / d)).exp()
    }
}

/// H² = (A − ζ)² + 1 − ζ².
fn swing<F: Float>(zeta: F, excess: F) -> F {
    (excess - zeta).square() + (F::int(1) - zeta) * (F::int(1) + zeta)
}

/// A*, above which the body stops; `None` without a damper, infinite where no A is large enough.
fn least_excess<F: Float>(zeta: F) -> Option<F> {
    let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
    if zeta == zero {
        return None;
    }
    let infinite = Some(one / zero);
    if zeta >= one {
        return infinite;
    }
    let d = ((one - zeta) * (one + zeta)).sqrt();
    // A* = ζ + √(ζ² + e^{2E} − 1), E = ζ(φ + π)/d; φ is at most π.
    let high = zeta + (zeta.square() + (F::int(4) * zeta * F::pi() / d).exp_m1()).sqrt();
    if !high.is_finite() {
        return infinite;
    }
    Some(root::newton_within(two * zeta, high, |a| {
        let phase = (a * d).atan2(zeta * a - one);
        let growth = (two * zeta * (phase + F::pi()) / d).exp_m1();
        let slope = two * (zeta - a) - two * zeta * (growth + one) / swing(zeta, a);
        (growth - a * (a - two * zeta), slope)
    }))
}

#[cfg(test)]
mod tests {
    use super::Pull;
    use crate::{Error, Oscillator};

    fn body(zeta: f64, eta: f64) -> Oscillator<f64> {
        let body = Oscillator::new(2.0, 450.0, 3.0).unwrap();
        body.with_damping_ratio(zeta).unwrap().with_static_friction_ratio(eta).unwrap()
    }

    /// Steps of a Runge–Kutta method, from the release to the stop: its duration, the distance and the peak velocity;
    /// `None` if the body has not stopped after twenty periods.
    fn stepped(body: &Oscillator<f64>, speed: f64, damper_moves: bool) -> Option<[f64; 4]> {
        let (m, k, r, c) = (body.mass(), body.stiffness(), body.friction_bound(), body.damping());
        let held = r * body.static_friction_ratio();
        // The damper on the support carries a part of the load at the release.
        let carried = if damper_moves { c * speed } else { 0.0 };
        let stretch = (held - carried) / k;
        let rate = |t: f64, [x, v]: [f64; 2]| {
            let damper = if damper_moves { c * (speed - v) } else { -c * v };
            [v, (k * (stretch + speed * t - x) + damper - r) / m]
        };
        let h = 1e-4;
        let step = |t: f64, y: [f64; 2], h: f64| {
            let add = |y: [f64; 2], k: [f64; 2], h: f64| [y[0] + h * k[0], y[1] + h * k[1]];
            let k1 = rate(t, y);
            let k2 = rate(t + h / 2.0, add(y, k1, h / 2.0));
            let k3 = rate(t + h / 2.0, add(y, k2, h / 2.0));
            let k4 = rate(t + h, add(y, k3, h));
            [0, 1].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
        };
        let (mut t, mut y, mut most) = (0.0, [0.0, 0.0], 0.0f64);
        while t < 20.0 * std::f64::consts::TAU / (k / m).sqrt() {
            let next = step(t, y, h);
            if next[1] < 0.0 {
                let (mut low, mut high) = (0.0, h);
                for _ in 0..60 {
                    let middle = (low + high) / 2.0;
                    if step(t, y, middle)[1] < 0.0 { high = middle } else { low = middle }
                }
                let [x, _] = step(t, y, low);
                // At rest the load grows by k V each second.
                let load = k * (stretch + speed * (t + low) - x) + carried;
                return Some([t + low, (held - load) / (k * speed), x, most]);
            }
            (t, y) = (t + h, next);
            most = most.max(y[1]);
        }
        None
    }

    #[test]
    fn the_slip_is_that_of_small_steps() {
        let mut compared = 0;
        for zeta in [0.0, 1e-6, 0.01, 0.1, 0.4] {
            for eta in [1.02, 1.3, 3.0] {
                for speed in [1e-3, 0.02, 0.1, 0.7] {
                    let body = body(zeta, eta);
                    let pull = Pull::new(&body, speed).unwrap();
                    for moves in [false, true] {
                        let by_steps = stepped(&body, speed, moves);
                        let found = [pull.slip_time, pull.stick_time, pull.slip_distance];
                        let Some([slip, stick, distance, most]) = by_steps else {
                            assert_eq!(found, [None; 3], "{zeta} {eta} {speed}");
                            assert_eq!(pull.max_velocity, speed);
                            continue;
                        };
                        compared += 1;
                        for (found, stepped) in found.into_iter().zip([slip, stick, distance]) {
                            let found = found.unwrap();
                            assert!(
                                (found - stepped).abs() < 1e-7 * (found + stepped + 1e-3),
                                "{zeta} {eta} {speed}: {found} {stepped}"
                            );
                        }
                        assert!(most <= pull.max_velocity * (1.0 + 1e-9), "{most} {}", pull.max_velocity);
                        assert!(most > pull.max_velocity * (1.0 - 1e-5), "{most} {}", pull.max_velocity);
                    }
                }
            }
        }
        assert!(compared > 70, "{compared}");
    }

    #[test]
    fn the_speed_of_smooth_sliding_is_where_small_steps_no_longer_stop() {
        for zeta in [0.002, 0.03, 0.2, 0.6] {
            let body = body(zeta, 1.4);
            let least = Pull::new(&body, 1.0).unwrap().smooth_above.unwrap();
            assert!(stepped(&body, least * 0.9999, false).is_some(), "{zeta}");
            assert!(stepped(&body, least * 1.0001, false).is_none(), "{zeta}");
            assert!(Pull::new(&body, least * 0.9999).unwrap().period.is_some());
            assert_eq!(Pull::new(&body, least).unwrap().period, None);
        }
        // Derjaguin, Push and Tolstoi (1957): ΔF/√(4πζ k m) for small damping.
        let body = body(1e-7, 1.4);
        let least = Pull::new(&body, 1.0).unwrap().smooth_above.unwrap();
        let limit = 0.4 * 3.0 / (4.0 * std::f64::consts::PI * 1e-7 * 450.0 * 2.0).sqrt();
        assert!((least / limit - 1.0).abs() < 1e-3, "{least} {limit}");
    }

    #[test]
    fn at_the_ends_of_the_ranges() {
        // Without a damper: ω t = 2π − 2 atan A, and the stick takes 2A/ω.
        let body_of = |zeta, eta| body(zeta, eta);
        for speed in [1e-12, 1e-3, 1e6] {
            let pull = Pull::new(&body_of(0.0, 1.5), speed).unwrap();
            let a: f64 = 0.5 * (3.0 / 450.0) * 15.0 / speed;
            let slip = (std::f64::consts::TAU - 2.0 * a.atan()) / 15.0;
            assert!((pull.slip_time.unwrap() / slip - 1.0).abs() < 4e-16, "{speed}");
            assert!((pull.stick_time.unwrap() / (2.0 * a / 15.0) - 1.0).abs() < 1e-13, "{speed}");
            assert_eq!(pull.smooth_above, None);
        }
        // With one friction and no damper w = cos τ, and the velocity V(1 − cos τ).
        assert_eq!(Pull::new(&body_of(0.0, 1.0), 0.25).unwrap().max_velocity, 0.5);
        assert_eq!(Pull::new(&body_of(0.1, 1.0), 0.25).unwrap().max_velocity, 0.25);
        // With one friction, or critical damping, every speed is smooth.
        for (zeta, eta) in [(0.0, 1.0), (0.1, 1.0), (1.0, 2.0), (3.0, 2.0), (1.0 - 1e-9, 2.0)] {
            let pull = Pull::new(&body_of(zeta, eta), 1e-30).unwrap();
            assert_eq!((pull.period, pull.smooth_above), (None, Some(0.0)), "{zeta} {eta}");
        }
        for speed in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            assert!(
                matches!(
                    Pull::new(&body_of(0.1, 2.0), speed),
                    Err(Error::NotPositive { .. } | Error::NotFinite { .. })
                ),
                "{speed}"
            );
        }
        assert!(Pull::new(&body_of(0.1, 2.0), 5e-324).is_err());
    }
}
