//! Acceleration, transmitted force and absolute motion of the cycle with damping, in natural time.
//!
//! On the half cycle with x′ > 0 the force of spring, damper and friction is `f = x + 2ζx′ + 1`, and
//!
//! ```text
//! x″ = α sin θ − f,        y = x + (α/Ω²) sin θ,        y″ = −f.
//! ```
//!
//! Each is the sum of a driven part, a harmonic of the frequency Ω, and a free part with decreasing energy.

use super::DampedCycle;
use super::rising::{Moment, Rising, Vibration};
use crate::float::{Field, Float};
use crate::greatest::{Bound, Jet, greatest};

impl<F: Field> Rising<F> {
    /// x″ and its first two derivatives, in natural time.
    pub(crate) fn acceleration(&self, at: &Moment<F>) -> Jet<F> {
        let ([_, a, jerk], driven) = (self.velocity(at), self.driven(at).1);
        Jet { value: a, slope: jerk, second: at.free.snap - self.half.omega.square() * driven }
    }

    /// `f = x + 2ζx′ + 1` and its derivatives; x is given.
    pub(crate) fn force(&self, at: &Moment<F>, x: F) -> Jet<F> {
        let ([v, a, jerk], damper) = (self.velocity(at), F::int(2) * self.half.free.zeta);
        Jet { value: x + damper * v + F::int(1), slope: v + damper * a, second: a + damper * jerk }
    }

    /// `y = x + (α/Ω²) sin θ` and its derivatives; x is given.
    pub(crate) fn absolute(&self, at: &Moment<F>, x: F) -> Jet<F> {
        let ([v, a, jerk], square) = (self.velocity(at), self.half.omega.square());
        let Jet { value: force, slope: rate, .. } = self.force(at, x);
        // α sin θ = x″ + f, and its derivative.
        Jet { value: x + (a + force) / square, slope: v + (jerk + rate) / square, second: -force }
    }
}

impl<F: Field> Vibration<F> {
    /// x and its first two derivatives, in natural time.
    pub(crate) fn displacement(&self, at: &Moment<F>) -> Jet<F> {
        let [slope, second, _] = self.velocity(at);
        Jet { value: self.place(at), slope, second }
    }

    /// x by its definition; [`Rising::displacement`] has a form that keeps the digits of floats.
    pub(crate) fn place(&self, at: &Moment<F>) -> F {
        let ((a, h), (s, c)) = (self.driven, at.drive);
        let driven = if self.whole.is_some() { F::int(0) } else { a * c + h * s };
        at.free.x - F::int(1) - driven
    }
}

/// Bounds of the derivatives of x for a time.
struct Together<F> {
    acceleration: F,
    jerk: F,
    snap: F,
}

/// The smaller of two bounds.
fn less<F: Float>(a: F, b: F) -> F {
    if a < b { a } else { b }
}

impl<F: Float> DampedCycle<F> {
    /// Greatest |x″|, in B ω_n².
    pub(crate) fn max_acceleration(&self) -> F {
        let half = &self.rising.half;
        let (square, swing) = (half.omega.square(), self.rising.vibration().swing());
        let most = swing * square * half.omega;
        let bound = |a: F, b: F| {
            let (start, middle) = (self.rising.at(a), self.rising.at((a + b) / F::int(2)));
            let (v, slope) = self.rising.driven(&middle);
            let driven = Jet { value: slope, slope: -(square * v), second: most };
            let together = self.together(&start, b - a);
            let apart = self.apart(driven, (b - a) / F::int(2), start.free.acceleration_bound());
            Bound {
                curvature: less(most + start.free.jerk_bound(), together.snap),
                value: less(apart, together.acceleration),
            }
        };
        self.greatest(bound, |at| self.rising.acceleration(at))
    }

    /// Greatest |f|, in r_y.
    pub(crate) fn transmitted_force(&self) -> F {
        let half = &self.rising.half;
        let (square, damper, swing) = (half.omega.square(), self.damper(), self.rising.vibration().swing());
        // The driven part of f has the amplitude s √(1/Ω² + 4ζ²), and the free part is −h″.
        let amplitude = swing * (F::int(1) / half.omega).hypot(damper);
        let bound = |a: F, b: F| {
            let (start, middle) = (self.rising.at(a), self.rising.at((a + b) / F::int(2)));
            let (v, slope) = self.rising.driven(&middle);
            let driven = Jet {
                value: damper * v - slope / square,
                slope: v + damper * slope,
                second: square * amplitude,
            };
            let together = self.together(&start, b - a);
            Bound {
                // f″ = x″ + 2ζx‴
                curvature: less(
                    square * amplitude + start.free.jerk_bound(),
                    together.acceleration + damper * together.jerk,
                ),
                value: self.apart(driven, (b - a) / F::int(2), start.free.acceleration_bound()),
            }
        };
        self.greatest(bound, |at| self.rising.force(at, self.rising.displacement(at)))
    }

    /// Greatest |y|, in B.
    pub(crate) fn max_absolute_displacement(&self) -> F {
        let half = &self.rising.half;
        let (damper, one) = (self.damper(), F::int(1));
        let most = self.max_displacement + damper * half.omega * self.max_velocity + one;
        self.greatest(
            |_, _| Bound { curvature: most, value: one / F::int(0) },
            |at| self.rising.absolute(at, self.rising.displacement(at)),
        )
    }

    /// Greatest |x − u|, in B, where the support of the spring moves by u, with the damper or without it.
    pub(crate) fn max_spring_force(&self, has_damper: bool) -> F {
        let (seen, one) = (self.rising.seen_from_foot(has_damper), F::int(1));
        let (square, (a, h), (along, across)) = (seen.omega.square(), seen.driven, seen.force());
        let (most, growth) = (square * a.hypot(h), seen.omega * along.hypot(across));
        let bound = |from: F, to: F| {
            let (start, middle) = (seen.at(from), seen.at((from + to) / F::int(2)));
            let [speed, bend, _] = seen.velocity(&start);
            // √(x′² + x″²) grows by Ω times the force in a unit of time at most.
            let together = speed.hypot(bend) + growth * (to - from);
            let (apart, value) = if seen.whole.is_some() {
                (together, one / F::int(0))
            } else {
                let (s, c) = middle.drive;
                let driven = Jet { value: a * c + h * s, slope: seen.omega * (h * c - a * s), second: most };
                let free = start.free.x.hypot(start.free.v);
                (most + start.free.acceleration_bound(), driven.reach((to - from) / F::int(2)) + free + one)
            };
            Bound { curvature: less(apart, together), value }
        };
        let period = self.rising.half.period;
        greatest(F::int(0), period, F::int(0), bound, |tau| seen.displacement(&seen.at(tau)))
    }

    /// No derivative is larger than this until `time` after a moment.
    ///
    /// The velocity v obeys `v″ + 2ζv′ + v = αΩ cos θ`, so that √(v² + v′²) grows by αΩ in a unit of time at
    /// most, and so for its derivatives by αΩ² and αΩ³. Near resonance driven and free part are large and
    /// opposite, and this is far less than the sum of both.
    fn together(&self, at: &Moment<F>, time: F) -> Together<F> {
        let omega = self.rising.half.omega;
        let ([_, a, jerk], Jet { second: snap, .. }) =
            (self.rising.velocity(at), self.rising.acceleration(at));
        // α Ω = s q
        let growth = self.rising.swing() * self.rising.half.stiffness * omega * time;
        let acceleration = a.hypot(jerk) + growth;
        let jerk = jerk.hypot(snap) + growth * omega;
        Together { acceleration, jerk, snap: jerk }
    }

    /// No more than the driven and the free part give, where they are computed apart.
    fn apart(&self, driven: Jet<F>, radius: F, free: F) -> F {
        if self.rising.half.is_resonant { F::int(1) / F::int(0) } else { driven.reach(radius) + free }
    }

    /// The maximum over the half cycle, which is that of the other half, too.
    fn greatest(&self, bound: impl Fn(F, F) -> Bound<F>, jet: impl Fn(&Moment<F>) -> Jet<F>) -> F {
        let half = &self.rising.half;
        greatest(F::int(0), half.period, F::int(0), bound, |tau| jet(&self.rising.at(tau)))
    }

    /// 2ζ.
    fn damper(&self) -> F {
        F::int(2) * self.rising.half.free.zeta
    }
}

#[cfg(test)]
mod tests {
    use crate::{Cycle, Ratios, Response};

    /// No dense sample of the cycle exceeds a peak, and some come close: with little and much damping, for
    /// slow and fast drives.
    #[test]
    fn peaks_are_the_greatest_of_samples() {
        for (omega, margin, zeta) in [
            (0.02, 1.2, 0.01),
            (0.11, 1.02, 0.003),
            (0.34, 2.0, 0.02),
            (0.4, 1.3, 0.1),
            (0.7, 1.0, 0.3),
            (1.0, 5.0, 0.05),
            (1.5, 1.5, 0.7),
            (1.2, 1.1, 1.0),
            (0.5, 1.4, 5.0),
            (4.4, 3.0, 30.0),
        ] {
            let damped = |alpha| Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta)).unwrap();
            let alpha: f64 = margin * Response::new(damped(1.0)).border.min_force_ratio;
            let cycle = Cycle::new(damped(alpha)).unwrap();
            let (mut acceleration, mut force, mut absolute) = (0.0f64, 0.0f64, 0.0f64);
            let count = 400_000;
            for i in 0..count {
                let theta = (f64::from(i) + 0.5) * std::f64::consts::TAU / f64::from(count);
                let (x, v) = (cycle.displacement_at(theta), cycle.velocity_at(theta));
                let (drive, carried) = (alpha * theta.sin(), x + 2.0 * zeta * omega * v + v.signum());
                acceleration = acceleration.max((drive - carried).abs() / omega.powi(2));
                force = force.max(carried.abs());
                absolute = absolute.max((x + drive / omega.powi(2)).abs());
            }
            for (found, sampled) in [
                (cycle.max_acceleration(), acceleration),
                (cycle.transmitted_force(), force),
                (cycle.max_absolute_displacement(), absolute),
            ] {
                assert!(
                    found > sampled * (1.0 - 1e-11) && found < sampled * (1.0 + 1e-4),
                    "{omega} {alpha} {zeta}: {found} {sampled}"
                );
            }
        }
    }

    /// As ζ → 0 the peaks tend to those of the cycle without damping.
    #[test]
    fn a_little_damping_changes_little() {
        for (omega, alpha) in [(0.17, 60.0), (0.34, 400.0), (0.7, 2.0), (1.5, 2.5)] {
            let ratios = Ratios::new(omega, alpha).unwrap();
            let (with, without) =
                (Cycle::new(ratios.with_damping_ratio(1e-12).unwrap()).unwrap(), Cycle::new(ratios).unwrap());
            for of in [Cycle::max_acceleration, Cycle::transmitted_force, Cycle::max_absolute_displacement] {
                let (a, b): (f64, f64) = (of(&with), of(&without));
                assert!((a / b - 1.0).abs() < 1e-9, "{omega} {alpha}: {a} {b}");
            }
        }
    }

    /// Extreme ratios take no longer than others: 10⁷ free waves in a cycle, or decay within a 10⁻⁹th of it.
    #[test]
    fn many_waves_and_much_damping_take_no_time() {
        for (omega, alpha, zeta) in
            [(1e-7, 1e15, 1e-9), (1e-5, 3e10, 0.3), (2.0, 1e10, 1e9), (1e-3, 1e10, 1e6)]
        {
            let ratios = Ratios::new(omega, alpha).and_then(|r| r.with_damping_ratio(zeta)).unwrap();
            let cycle: Cycle<f64> = Cycle::new(ratios).unwrap();
            let found =
                [cycle.max_acceleration(), cycle.transmitted_force(), cycle.max_absolute_displacement()];
            assert!(found.iter().all(|x| x.is_finite() && *x > 0.0), "{found:?}");
        }
    }

    /// On the border at Ω = 1, the driven and the free part are 1/ζ times as large as their sum; only the
    /// rounding grows with that factor.
    #[test]
    fn at_resonance_on_the_border_the_search_ends() {
        let peaks = |zeta: f64| {
            let damped = |alpha| Ratios::new(1.0, alpha).and_then(|r| r.with_damping_ratio(zeta)).unwrap();
            let alpha: f64 = Response::new(damped(2.0)).border.min_force_ratio;
            let cycle = Cycle::new(damped(alpha)).unwrap();
            [cycle.max_acceleration(), cycle.transmitted_force(), cycle.max_absolute_displacement()]
        };
        let usual = peaks(1e-6);
        for zeta in [1e-9, 1e-12, 1e-15, 1e-16] {
            for (found, usual) in peaks(zeta).into_iter().zip(usual) {
                let rounding = 100.0 * f64::EPSILON / zeta;
                assert!((found - usual).abs() <= 1e-5 + rounding, "{zeta}: {found} {usual}");
            }
        }
    }
}
