//! The works of the drive and of the damper in a slide, each by its own closed form.
//!
//! With `S = α sin θ` and `C = αΩ cos θ`, multiplying `w″ + 2ζw′ + w = C` by S, by C and by w and integrating
//! by parts gives, [·] being the value at the end less that at the start and L the natural time between them,
//!
//! ```text
//! (1 − Ω²) W − 2ζ J     = [S²/2 − w′S + wC − 2ζwS]                                  = R₁
//! 2ζΩ² W + (1 − Ω²) J   = α²Ω²L/2 + [SC/2 − w′C − Ω²wS − 2ζwC]                       = R₂
//! ∫ 2ζw² dφ             = 2ζ (J − [ww′] − ζ[w²]) + Ω² W + [wC] − [w² + w′²]/2
//! ```
//!
//! for the work of the drive `W = ∫ S w dφ` and `J = ∫ C w dφ`. None of these forms uses the balance of
//! energy.

use super::Slide;
use super::equation::Equation;
use super::motion::Motion;
use crate::cycle::damped::squared::DrivenVelocity;
use crate::float::Float;

/// The works of one slide, in r_y B.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Works<F> {
    /// The work of the drive, ∫ α sin θ dx; with a damper on the moving support, of the support.
    pub(crate) drive: F,
    /// The work against the damper, ∫ 2ζw dx; of its own velocity where it stands on the moving support (`foot`).
    pub(crate) damper: F,
}

impl<F: Float> Slide<F> {
    /// The works from the start to `end`, after the natural time `phi`.
    #[inline]
    pub(crate) fn works(&self, phi: F, end: &Motion<F>) -> Works<F> {
        if self.equation.is_damped() {
            let works = self.damped_works(phi, end);
            return if self.equation.has_damped_foot() { self.works_of_foot(works, phi) } else { works };
        }
        Works { drive: self.work_of_drive(end), damper: F::int(0) }
    }

    /// Work of the drive `∫ α sin θ dx` from the start to `end` without damping, in r_y B: two terms and no circular
    /// function, in place of the three forms for a damper.
    ///
    /// By parts from `(w″ + w) sin θ = αΩ cos θ sin θ`, without the balance of energy:
    ///
    /// ```text
    /// ∫ sin θ dx = [sin θ (x + s − α sin θ/2) + Ω w cos θ]/(1 − Ω²)
    /// ```
    ///
    /// Where its terms are more than 32 times their sum, or |1 − Ω²| < 1/64, the energy balance is used
    /// instead: `[½x² + ½w²] + |Δx|`.
    pub(crate) fn work_of_drive(&self, end: &Motion<F>) -> F {
        let (one, two) = (F::int(1), F::int(2));
        let omega = self.equation.omega;
        let sign = self.direction.sign::<F>();
        let divisor = (one - omega) * (one + omega);
        let start = self.motion_at_start();
        // α times the bracket, from α sin θ and αΩ cos θ = w″ + w: two terms.
        let terms = |m: &Motion<F>| (m.force * (m.x + sign - m.force / two), (m.jerk + m.w) * m.w);
        let ((a, b), (c, d)) = (terms(end), terms(&start));
        let bracket = (a + b) - (c + d);
        let largest = (a.abs() + b.abs()).or_larger(c.abs() + d.abs());
        if divisor.abs() * F::int(64) < one || largest > F::int(32) * bracket.abs() {
            return self.gained(end);
        }
        bracket / divisor
    }

    /// The work of the drive by the balance of energy up to `end`: `[½x² + ½w²] + |Δx|`.
    fn gained(&self, end: &Motion<F>) -> F {
        let spring = (end.x - self.x) * (end.x + self.x);
        let kinetic = (end.w - self.w) * (end.w + self.w);
        (spring + kinetic) / F::int(2) + self.direction.sign::<F>() * (end.x - self.x)
    }

    /// The works with damping. Where `q² = (1 − Ω²)² + 4ζ²Ω²` is below 2⁻¹² the closed forms lose their
    /// digits: the damper's work then comes from the power series of the velocity, and the drive's from the
    /// balance of energy. A work whose terms nearly cancel is computed in the same way, except for the
    /// damper's work along a slide of many periods, whose closed form is accurate to the rounding of the
    /// drive's work.
    #[cold]
    #[inline(never)]
    pub(super) fn damped_works(&self, phi: F, end: &Motion<F>) -> Works<F> {
        let (p, imaginary) = self.equation.stiffness();
        let square = self.equation.omega.square();
        let determinant = p.square() + imaginary.square();
        if determinant * F::int(4096) < F::int(1) {
            let damper = self.damper_by_series(phi);
            return Works { drive: self.gained(end) + damper, damper };
        }
        let start = self.motion_at_start();
        let Works { drive, mut damper } = self.closed_works(phi, &start, end);
        // With little damping, the closed form leaves the rounding of the terms that do not contain ζ.
        let terms = |m: &Motion<F>| m.w.square() + m.acceleration.square() + square * drive.abs();
        if damper * F::int(1 << 16) < terms(end).or_larger(terms(&start)) {
            let is_short = phi * self.equation.pace() < F::int(16);
            damper = if is_short { self.damper_by_series(phi) } else { damper.or_larger(F::int(0)) };
        }
        let size = |m: &Motion<F>| m.force.square() + (m.acceleration * m.force).abs();
        if size(end).or_larger(size(&start)) > F::int(32) * drive.abs() {
            return Works { drive: self.gained(end) + damper, damper };
        }
        Works { drive, damper }
    }

    /// Both works by their closed forms alone.
    fn closed_works(&self, phi: F, start: &Motion<F>, end: &Motion<F>) -> Works<F> {
        let two = F::int(2);
        let k = self.equation.damping;
        let (p, imaginary) = self.equation.stiffness();
        let determinant = p.square() + imaginary.square();
        let square = self.equation.omega.square();
        // αΩ cos θ comes from the angle at the end, because the third derivative at a velocity zero has fewer
        // digits than the state.
        let ((sine, cosine), (turned_sine, turned_cosine)) =
            (self.sin_cos_start(), (self.equation.omega * phi).sin_cos());
        let rate = self.equation.alpha * self.equation.omega;
        let start = (start, rate * cosine);
        let end = (end, rate * (cosine * turned_cosine - sine * turned_sine));
        // The bracket of each form at one end.
        let first = |(m, c): (&Motion<F>, F)| {
            let s = m.force;
            s.square() / two - m.acceleration * s + m.w * c - k * m.w * s
        };
        let second = |(m, c): (&Motion<F>, F)| {
            let s = m.force;
            s * c / two - m.acceleration * c - square * m.w * s - k * m.w * c
        };
        let third = |(m, c): (&Motion<F>, F)| {
            let kinetic = (m.w.square() + m.acceleration.square()) / two;
            m.w * c - kinetic - k * m.w * (m.acceleration + k * m.w / two)
        };
        let (r1, r2) = (
            first(end) - first(start),
            self.equation.alpha.square() * square * phi / two + (second(end) - second(start)),
        );
        let drive = (p * r1 + k * r2) / determinant;
        // 2ζJ + Ω²W in one quotient, because the two nearly cancel above Ω = 1.
        let mixed = (k * r2 + square * (p - k.square()) * r1) / determinant;
        Works { drive, damper: mixed + (third(end) - third(start)) }
    }

    /// `∫ 2ζw² dφ` up to φ by the power series of w around the middles of parts, none longer than half of the
    /// fastest period.
    fn damper_by_series(&self, phi: F) -> F {
        let Equation { omega, damping, .. } = self.equation;
        // The cast of a float to an integer saturates.
        let parts = (phi * self.equation.pace() / F::pi()).to_f64() as u32;
        let parts = parts.saturating_add(1);
        let half = phi / (F::int(2) * F::from_f64(f64::from(parts)));
        let part = |n: u32| {
            let m = self.motion(half * F::from_f64(2.0 * f64::from(n) + 1.0));
            let force = (m.jerk + m.w + damping * m.acceleration, -(omega.square() * m.force));
            DrivenVelocity { omega, damping, velocity: (m.w, m.acceleration), force }.square_around(half)
        };
        damping * (0..parts).fold(F::int(0), |sum, n| sum + part(n))
    }
}

#[cfg(test)]
mod tests {
    use crate::Ratios;
    #[cfg(feature = "mp")]
    use crate::float::Float;
    use crate::motion::drive_phase::DrivePhase;
    use crate::motion::slide::equation::Equation;
    use crate::motion::slide::{Direction, Slide};
    use crate::motion::{LongRun, State};

    /// A static friction that exceeds the kinetic one by a rounding error changes no work, although the
    /// search for the velocity zeros then begins elsewhere.
    #[test]
    fn a_static_friction_a_float_above_the_kinetic_one_changes_no_work() {
        for (omega, alpha, zeta) in [
            (0.984_201_935_149_884_1, 1.683_912_667_519_5, 0.013_356_171_471_470_326),
            (0.7, 2.0, 0.05),
            (1.3, 3.0, 0.4),
            (0.4, 6.0, 0.05),
        ] {
            let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
            let works = |eta: f64| {
                let ratios = ratios.with_static_friction_ratio(eta).unwrap();
                let limit = LongRun::from_start(ratios, State::default()).unwrap();
                let steady = *limit.steady_state().unwrap();
                [steady.energy_in, steady.energy_out, steady.damper_work]
            };
            for (found, due) in works(1f64.next_up()).into_iter().zip(works(1.0)) {
                assert!((found / due - 1.0).abs() < 1e-12, "{omega} {alpha} {zeta}: {found} {due}");
            }
        }
    }

    /// Where the closed form is accurate, the series agrees with it, however long the slide.
    #[test]
    fn the_series_has_parts_enough() {
        for (omega, zeta) in [(0.7, 0.3), (3.0, 0.4), (0.4, 0.9), (0.2, 1.5)] {
            let ratios = Ratios::new(omega, 2.0).unwrap().with_damping_ratio(zeta).unwrap();
            let start = DrivePhase::of(0.4).unwrap();
            let slide = Slide::new(Equation::new(ratios), start, -0.7, 0.9, Direction::Forward);
            for phi in [0.3, 1.0, 2.0, 3.2, 4.5] {
                let works = slide.works(phi, &slide.motion(phi));
                let series: f64 = slide.damper_by_series(phi);
                let off = (series / works.damper - 1.0).abs();
                assert!(off < 1e-12, "Ω = {omega}, ζ = {zeta}, {phi}: {off:e}");
            }
        }
    }

    /// At 512 bits the closed form keeps digits where it cancels: the series agrees with all of them, and at
    /// f64 with nearly all digits of f64.
    #[cfg(feature = "mp")]
    #[test]
    fn the_series_is_the_closed_form_to_all_digits() {
        use crate::float::mp::Mp;
        fn slide<F: Float>(omega: f64, zeta: f64, speed: f64) -> Slide<F> {
            let ratios = Ratios::new(F::from_f64(omega), F::from_f64(3.0)).unwrap();
            let ratios = ratios.with_damping_ratio(F::from_f64(zeta)).unwrap();
            let start = DrivePhase::new(0, F::from_f64(0.375)).unwrap();
            let (x, w) = (F::from_f64(-0.75), F::from_f64(speed));
            Slide::new(Equation::new(ratios), start, x, w, Direction::Forward)
        }
        for omega in [0.15, 0.9, 1.0, 1.001, 10.0, 30.0, 300.0] {
            for zeta in [1e-6, 0.005, 0.05, 0.5, 1.0, 3.0] {
                for speed in [0.0, 0.01, 2.0] {
                    for share in [0.01, 0.5, 1.0] {
                        let phi = share * std::f64::consts::PI / f64::max(omega, 0.5);
                        let wide = slide::<Mp<8>>(omega, zeta, speed);
                        let time = Mp::from(phi);
                        let (start, end) = (wide.motion_at_start(), wide.motion(time));
                        let closed = wide.closed_works(time, &start, &end).damper;
                        let off = |found: Mp<8>| ((found - closed) / closed).abs().to_f64();
                        let by_series = off(wide.damper_by_series(time));
                        assert!(by_series < 1e-130, "{omega} {zeta} {speed} {share}: {by_series:e}");
                        let by_series = slide::<f64>(omega, zeta, speed).damper_by_series(phi);
                        let unit = f64::EPSILON * (8.0 + 2.0 * phi * omega.max(1.0));
                        // From rest, the velocity is the difference between the initial terms and those at
                        // the time.
                        assert!(off(by_series.into()) < 4.0 * unit, "{omega} {zeta} {speed} {share}");
                    }
                }
            }
        }
    }

    /// Both forms agree with ∫ α sin θ dx and ∫ 2ζw dx as sums over short steps.
    #[test]
    fn the_works_are_forces_along_the_way() {
        for omega in [0.3, 0.995, 1.0, 1.003, 2.2] {
            for zeta in [0.0, 1e-6, 0.003, 0.2, 1.0, 2.5] {
                for direction in [Direction::Forward, Direction::Backward] {
                    let ratios = Ratios::new(omega, 2.0).unwrap().with_damping_ratio(zeta).unwrap();
                    let start = DrivePhase::of(0.4).unwrap();
                    let slide = Slide::new(Equation::new(ratios), start, -0.7, 0.9, direction);
                    let steps = 4000;
                    let at = |n: i32| slide.motion(1.7 * f64::from(n) / f64::from(steps));
                    let (mut drive, mut damper) = (0.0, 0.0);
                    for n in 0..steps {
                        let (a, b) = (at(n), at(n + 1));
                        drive += (a.force + b.force) / 2.0 * (b.x - a.x);
                        damper += zeta * (a.w + b.w) * (b.x - a.x);
                    }
                    let works = slide.works(1.7, &at(steps));
                    let close = |a: f64, b: f64| (a - b).abs() < 1e-6;
                    assert!(
                        close(works.drive, drive) && close(works.damper, damper),
                        "Ω = {omega}, ζ = {zeta}: {works:?} for {drive} {damper}"
                    );
                }
            }
        }
    }
}
