//! The end of a slide: the first zero of its velocity.

use super::broken::Broken;
use super::cover::Cover;
use super::drive::DrivePhase;
use super::equation::Equation;
use super::event::{Found, Jet, Safe, Search, Verdict, next_zero};
use super::motion::Motion;
use super::slide::{Direction, Slide};
use super::window::Waves;
use crate::float::Float;

/// How a slide ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct VelocityZero<F> {
    /// Natural time since the start of the slide.
    pub(crate) phi: F,
    pub(crate) phase: DrivePhase<F>,
    pub(crate) x: F,
    /// `α sin θ − x − s` at the end: not positive along the slide.
    pub(crate) acceleration: F,
    /// `w″` at the end.
    pub(crate) jerk: F,
    /// The free vibrations, (sin φ, cos φ) without damping.
    pub(crate) rotation: (F, F),
    /// The velocity touches zero and keeps its sign.
    pub(crate) grazes: bool,
}

/// A search that passed its proved bound: of no size, so that the answers it stands beside stay as small as they are.
/// [`Slide::lost`] makes the error of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Lost;

/// What comes first of a slide: its end, or a limit on the time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Outcome<F> {
    Zero(VelocityZero<F>),
    /// The motion at the limit.
    Onward(Motion<F>),
}

impl<F: Float> Slide<F> {
    /// The velocity zero that ends the slide; `hint` is when it is expected (natural time).
    ///
    /// # Errors
    /// [`Lost`].
    #[inline]
    pub(crate) fn velocity_zero(&self, hint: F) -> Result<VelocityZero<F>, Lost> {
        if self.equation.alpha * F::int(8) <= F::epsilon()
            && let Some(end) = self.end_of_creep()
        {
            return Ok(end);
        }
        match self.ends(hint, None)? {
            Outcome::Zero(zero) => Ok(zero),
            Outcome::Onward(_) => Err(Lost),
        }
    }

    /// Without a drive, or one below rounding, and from ζ = 1 on: the end of a slide that creeps to ∓1 for ever, when its velocity is rounding.
    ///
    /// It turns only where `s(x + s) + ζ|w| > |w| √(ζ² − 1)` ([`super::FreeDecay`]).
    #[cold]
    fn end_of_creep(&self) -> Option<VelocityZero<F>> {
        let (zero, sign) = (F::int(0), self.direction.sign::<F>());
        let free = self.equation.vibration();
        let speed = sign * self.w;
        let turns = sign * self.x + F::int(1) + free.zeta * speed > free.frequency * speed;
        if !self.equation.is_damped() || free.swings() || turns {
            return None;
        }
        // e^{−n} < 2⁻ⁿ
        let phi = F::from_f64(f64::from(F::PRECISION)) / free.slow_rate();
        Some(VelocityZero {
            phi,
            phase: self.start.advanced(self.equation.omega * phi),
            x: -sign,
            acceleration: zero,
            jerk: zero,
            rotation: (zero, zero),
            grazes: false,
        })
    }

    /// The velocity zero that ends the slide, if not after `limit`; otherwise the motion at the limit.
    ///
    /// # Errors
    /// [`Lost`].
    #[inline]
    pub(crate) fn until(&self, hint: F, limit: F) -> Result<Outcome<F>, Lost> {
        self.ends(hint, Some(limit))
    }

    /// Both of these: one call of the search, into which the compiler puts the motion of a slide.
    fn ends(&self, hint: F, limit: Option<F>) -> Result<Outcome<F>, Lost> {
        if self.equation.is_damped() {
            self.damped_ends(hint, limit)
        } else {
            self.ends_by::<false>(hint, limit)
        }
    }

    #[cold]
    #[inline(never)]
    fn damped_ends(&self, hint: F, limit: Option<F>) -> Result<Outcome<F>, Lost> {
        self.ends_by::<true>(hint, limit)
    }

    /// The same by what is known when the program is compiled.
    #[inline]
    fn ends_by<const DAMPED: bool>(&self, hint: F, limit: Option<F>) -> Result<Outcome<F>, Lost> {
        let (search, start) =
            (self.velocity_search::<DAMPED>(hint, limit), self.velocity_at_start::<DAMPED>());
        match next_zero(&search, start, self.velocity::<DAMPED>()) {
            Verdict::Zero(found) => Ok(Outcome::Zero(self.arrival::<DAMPED>(&found))),
            Verdict::Clear(Some((_, motion))) => Ok(Outcome::Onward(motion)),
            Verdict::Clear(None) => limit.map(|limit| Outcome::Onward(self.motion(limit))).ok_or(Lost),
            Verdict::Lost(_) => Err(Lost),
        }
    }

    /// The error of a search along this slide that passed its bound.
    #[cold]
    pub(crate) fn lost(&self, search: &'static str) -> Broken {
        let bound = if self.equation.is_damped() {
            "3π/Ω of natural time, and what the free vibration takes to turn or to fall below the forced one"
        } else {
            "π(1 + 2/Ω) of natural time"
        };
        self.equation.lost(search, self.start, bound)
    }

    /// The speed with its derivatives, and the motion that it is of.
    #[inline]
    fn velocity<const DAMPED: bool>(&self) -> impl Fn(F) -> (Jet<F>, Motion<F>) + '_ {
        let sign = self.direction.sign::<F>();
        move |phi| {
            let m = self.motion_by::<DAMPED>(phi);
            (m.velocity_jet::<DAMPED>(&self.equation, sign), m)
        }
    }

    #[inline]
    fn velocity_at_start<const DAMPED: bool>(&self) -> Jet<F> {
        self.motion_at_start().velocity_jet::<DAMPED>(&self.equation, self.direction.sign::<F>())
    }

    /// What is known of the velocity before it is looked at.
    #[inline]
    fn velocity_search<const DAMPED: bool>(&self, hint: F, limit: Option<F>) -> Search<F> {
        let sign = self.direction.sign::<F>();
        let unit = F::int(4) * F::epsilon();
        Search {
            omega: self.equation.omega,
            pace: self.equation.pace(),
            cover: Cover::new(if DAMPED { self.equation.damping } else { F::int(0) }),
            waves: if DAMPED { self.damped_waves() } else { None },
            angle: self.start.angle(),
            helping: self.start.is_even() == (self.direction == Direction::Forward),
            from_zero: sign * self.w <= F::int(0),
            limit,
            hint,
            safe: if DAMPED { None } else { self.safe_window() },
            noise: unit * self.velocity_scale::<DAMPED>(),
            short_noise: Some(self.short_velocity_scale().map(|term| unit * term)),
        }
    }

    /// The state at a zero found: the last step by Taylor's series, whose next term is below rounding.
    #[inline]
    fn arrival<const DAMPED: bool>(&self, found: &Found<F, Motion<F>>) -> VelocityZero<F> {
        let Found { at, step: h, motion: m, grazes } = *found;
        let (half, third) = (h / F::int(2), h / F::int(3));
        let x = m.x + h * (m.w + half * (m.acceleration + third * m.jerk));
        let (fourth, fifth) = m.higher_by::<DAMPED>(&self.equation);
        let acceleration = m.acceleration + h * (m.jerk + half * (fourth + third * fifth));
        let jerk = m.jerk + h * fourth;
        // s′ = c − 2ζs, s″ = −(s + 2ζs′), s‴ = −(s′ + 2ζs″), and c′ = −s.
        let ((s, c), damping) = (m.rotation, self.equation.damping);
        let s1 = if DAMPED { c - damping * s } else { c };
        let s2 = if DAMPED { s + damping * s1 } else { s };
        let s3 = if DAMPED { s1 - damping * s2 } else { s1 };
        let rotation = (s + h * (s1 - half * (s2 + third * s3)), c - h * (s + half * (s1 - third * s2)));
        VelocityZero {
            phi: at + h,
            phase: self.start.advanced(self.equation.omega * (at + h)),
            x,
            acceleration,
            jerk,
            rotation,
            grazes,
        }
    }

    /// The motion at the velocity zero that ends the slide.
    pub(crate) fn motion_at(&self, zero: &VelocityZero<F>) -> Motion<F> {
        Motion {
            x: zero.x,
            w: F::int(0),
            acceleration: zero.acceleration,
            jerk: zero.jerk,
            force: zero.acceleration + zero.x + self.direction.sign::<F>(),
            rotation: zero.rotation,
        }
    }

    /// The motion at the start of the slide.
    pub(crate) fn motion_at_start(&self) -> Motion<F> {
        let (zero, one) = (F::int(0), F::int(1));
        Motion {
            x: self.x,
            w: self.w,
            acceleration: self.acceleration,
            jerk: self.jerk_at_start(),
            force: self.acceleration + self.x + self.direction.sign::<F>() + self.equation.damping * self.w,
            rotation: (zero, one),
        }
    }

    /// The two waves of the velocity with damping, where a slide may be long: for Ω outside [1/2, 2] or ζ from 1/2 on.
    #[inline]
    fn damped_waves(&self) -> Option<Box<Waves<F>>> {
        let (one, two) = (F::int(1), F::int(2));
        let Equation { omega, damping, .. } = self.equation;
        let long = self.equation.is_damped() && (omega * two < one || omega > two || damping >= one);
        long.then(|| Box::new(Waves::of(self)))
    }

    /// Where the slow one of the two waves of the velocity exceeds the amplitude of the fast one, for Ω outside [1/2, 2] and ζ = 0.
    ///
    /// `w = G cos θ + (free vibration of amplitude r)`, G = αΩ/(1 − Ω²).
    ///
    /// # Rounding
    /// With the circular functions right to ε, G is right to 3ε|G|, and r to `ε r + 6ε max(1, Ω) |G|`: two products and sums of G with
    /// cos θ and Ω sin θ, and the hypotenuse. The window is the one for G smaller and r larger (or the other way) by 8ε each, which rounding
    /// cannot make too wide; [`Safe::next`] takes off the rounding of its ends. What is lost of a window is as long as an angle whose cosine is
    /// 16ε max(1, Ω) from that of its end: some 1e-8 of a period where the window ends far from its crest, and at most the root of it.
    fn safe_window(&self) -> Option<Safe<F>> {
        let (one, two) = (F::int(1), F::int(2));
        let Equation { omega, alpha, .. } = self.equation;
        if (omega * two >= one && omega <= two) || alpha == F::int(0) {
            return None;
        }
        let forced = alpha * omega / ((one - omega) * (one + omega));
        let (sine, cosine) = self.start.sin_cos();
        let sign = self.direction.sign::<F>();
        let free = sign * (self.w - forced * cosine);
        let free_rate = sign * (self.acceleration + forced * omega * sine);
        let amplitude = free.hypot(free_rate);
        let unit = F::int(8) * F::epsilon();
        let rounding = unit * (amplitude + one.or_larger(omega) * forced.abs());
        let arccosine = |small: F, large: F| {
            let y = small / large;
            (y >= F::int(0) && y < one).then(|| ((one - y) * (one + y)).sqrt().atan2(y))
        };
        if omega < one {
            let half_width = arccosine(amplitude + rounding, forced * (one - unit))? / omega;
            let helping = self.start.is_even() == (self.direction == Direction::Forward);
            let crest = if helping { F::int(0) } else { F::pi() };
            Some(Safe {
                centre: (crest - self.start.angle()) / omega,
                half_width,
                period: two * F::pi() / omega,
            })
        } else {
            let half_width = arccosine(forced.abs() * (one + unit), amplitude - rounding)?;
            Some(Safe { centre: free_rate.atan2(free), half_width, period: two * F::pi() })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::VelocityZero;
    use crate::exact::drive::DrivePhase;
    use crate::exact::equation::Equation;
    use crate::exact::event::{Found, Verdict, next_zero};
    use crate::exact::slide::{Direction, Slide};
    use crate::nonsticking::{displacement_phase, max_displacement};
    use crate::phase_function::{PhaseFunction, one_minus_square};
    use crate::{Border, Ratios};
    use std::cell::Cell;
    use std::f64::consts::PI;

    /// The end of the rising half of the closed-form cycle at (Ω, α), which need not be a motion.
    fn end_of_rise(omega: f64, alpha: f64) -> VelocityZero<f64> {
        let k = PhaseFunction::new(omega).unwrap().value();
        let delta = max_displacement(k, alpha, one_minus_square(omega));
        let start = DrivePhase::new(displacement_phase(k, alpha, omega) - PI).unwrap();
        let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
        let slide = Slide::new(equation, start, -delta, 0.0, Direction::Forward);
        slide.velocity_zero(PI / omega).unwrap()
    }

    #[test]
    fn on_the_border_the_velocity_touches_zero_where_the_border_says() {
        for omega in [0.35, 0.4, 0.45, 0.3, 0.22] {
            let border = Border::new(omega).unwrap();
            let least = border.min_force_ratio();
            // τ* is counted from t₂ within the falling half: the same place in the rising one.
            let touch = border.phase() / omega;
            let above = end_of_rise(omega, least * (1.0 + 1e-9));
            assert!(!above.grazes && (above.phi - PI / omega).abs() < 1e-9, "Ω = {omega}: {above:?}");
            let below = end_of_rise(omega, least * (1.0 - 1e-9));
            assert!(!below.grazes && (below.phi - touch).abs() < 1e-3, "Ω = {omega}: {touch} {below:?}");
            // To within rounding it grazes.
            let close = (-40..=40).map(|i| end_of_rise(omega, least * (1.0 + f64::from(i) * 2e-16)));
            let grazing: Vec<_> = close.filter(|end| end.grazes).collect();
            assert!(!grazing.is_empty(), "Ω = {omega}");
            for end in grazing {
                assert!((end.phi - touch).abs() < 1e-6, "Ω = {omega}: {touch} {end:?}");
            }
        }
    }

    /// The last step is that of the motion, to the order of the terms left out.
    #[test]
    fn a_short_step_on_is_the_motion() {
        let equation = Equation::new(Ratios::new(0.7, 2.5).unwrap());
        let slide = Slide::new(equation, DrivePhase::new(0.3).unwrap(), -0.4, 1.1, Direction::Forward);
        for (at, step) in [(0.4, 2e-3), (1.3, -2e-3), (2.1, 1e-3)] {
            let found = Found { at, step, motion: slide.motion(at), grazes: false };
            let (zero, exact) = (slide.arrival::<false>(&found), slide.motion(at + step));
            let is = |a: f64, b: f64| assert!((a - b).abs() < 4e-11, "{at}: {a} {b}");
            is(zero.phi, at + step);
            is(zero.phase.since(slide.start), 0.7 * (at + step));
            is(zero.x, exact.x);
            is(zero.acceleration, exact.acceleration);
            assert!((zero.jerk - exact.jerk).abs() < 1e-5);
            is(zero.rotation.0, exact.rotation.0);
            is(zero.rotation.1, exact.rotation.1);
        }
        let noise = 4.0 * f64::EPSILON;
        let search = slide.velocity_search::<false>(1.0, None);
        assert_eq!(search.noise, noise * slide.velocity_scale::<false>());
        assert!(!search.from_zero);
        for (w, direction) in
            [(0.0, Direction::Forward), (0.0, Direction::Backward), (-1e-9, Direction::Forward)]
        {
            let slide = Slide::new(equation, slide.start, -0.4, w, direction);
            assert!(slide.velocity_search::<false>(1.0, None).from_zero, "{w} {direction:?}");
        }
        assert_eq!(search.short_noise, Some(slide.short_velocity_scale().map(|term| noise * term)));
    }

    #[test]
    fn the_work_is_bounded() {
        // A number in [0, 1) from three counters, without order.
        let spread = |i: u32, j: u32| {
            (f64::from(i) * 0.618_033_988_749_895 + f64::from(j) * 0.414_213_562_373_095).fract()
        };
        let slides = 40_000;
        // Evaluations, the most and in all: with half a period of the drive for a hint, and with one that is right to a percent.
        let (mut most, mut sum, mut sum_hinted) = (0, 0, 0);
        for i in 0..slides {
            let omega = 10f64.powf(6.0 * spread(i, 0) - 3.0);
            let alpha = 1.0 + 10f64.powf(4.0 * spread(i, i / 7) - 2.0);
            let theta = 7.0 * spread(i / 3, i);
            let reach = 2.0 * (1.0 + alpha) / (1.0 + omega);
            let (x, w) = (reach * (spread(i / 5, i) - 0.5), reach * spread(i, i / 11));
            let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
            let start = DrivePhase::new(theta).unwrap();
            let slide = Slide::new(equation, start, x, w, Direction::Forward);
            let found = |hint: f64| {
                let evaluations = Cell::new(0);
                let verdict = next_zero(
                    &slide.velocity_search::<false>(hint, None),
                    slide.motion_at_start().velocity_jet::<false>(&equation, 1.0),
                    |phi| {
                        evaluations.set(evaluations.get() + 1);
                        let m = slide.motion(phi);
                        (m.velocity_jet::<false>(&equation, 1.0), m)
                    },
                );
                let Verdict::Zero(zero) = verdict else { panic!("Ω = {omega}: {slide:?}") };
                (zero.at + zero.step, evaluations.get())
            };
            let (zero, evaluations) = found(PI / omega);
            let hinted = found(zero * 1.01).1;
            most = most.max(evaluations).max(hinted);
            (sum, sum_hinted) = (sum + evaluations, sum_hinted + hinted);
        }
        // 3.74 and 2.35 a slide: a guess, a hint or a jump that is of no use costs more.
        assert!(most <= 14, "{most}");
        assert!(sum <= 150_300 && sum_hinted <= 94_400, "{sum} {sum_hinted}");
    }

    /// Over the whole range of Ω, with a free wave of any size beside the forced one: the windows without zeros are left out.
    #[test]
    fn the_work_is_bounded_at_any_frequency() {
        let spread = |i: u32, step: f64| (f64::from(i) * step).fract();
        let (mut most, mut sum, slides) = (0, 0, 20_000);
        for i in 0..slides {
            let omega = 2f64.powf(40.0 * spread(i, 0.618_034) - 20.0);
            let alpha = 1.0 + 10f64.powf(3.0 * spread(i, 0.754_878) - 2.0);
            let theta = 2.0 * PI * spread(i, 0.569_841);
            let forced = alpha / ((1.0 - omega) * (1.0 + omega));
            let free = forced.abs() * omega * 10f64.powf(6.0 * spread(i, 0.437_016) - 3.0);
            let (sine, cosine) = (2.0 * PI * spread(i, 0.324_718)).sin_cos();
            let w = forced * omega * theta.cos() + free * cosine;
            let (direction, x) = (Direction::of(w), forced * theta.sin() + free * sine);
            let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
            let x = x - direction.sign::<f64>();
            let slide = Slide::new(equation, DrivePhase::new(theta).unwrap(), x, w, direction);
            let evaluations = Cell::new(0);
            let f = slide.velocity::<false>();
            let verdict = next_zero(
                &slide.velocity_search::<false>(PI / omega, None),
                slide.velocity_at_start::<false>(),
                |phi| {
                    evaluations.set(evaluations.get() + 1);
                    f(phi)
                },
            );
            assert!(matches!(verdict, Verdict::Zero(_)), "Ω = {omega}: {slide:?}");
            (most, sum) = (most.max(evaluations.get()), sum + evaluations.get());
        }
        assert!(most <= 24 && sum <= 7 * slides, "{most} {sum}");
    }

    /// A drive so weak that its share of the velocity is zero in the type: the windows are half periods of the free wave.
    #[test]
    fn a_drive_that_cannot_be_seen_costs_nothing() {
        for (omega, alpha, x) in [(2f64.powi(20), 1e-150, 1e290), (1e5, 1e-140, 1e200), (3e3, 1e-150, 7e290)]
        {
            let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
            let start = DrivePhase::new(0.3).unwrap();
            let slide = Slide::new(equation, start, -x, 0.0, Direction::Forward);
            let evaluations = Cell::new(0);
            let f = slide.velocity::<false>();
            let search = slide.velocity_search::<false>(PI / omega, None);
            let verdict = next_zero(&search, slide.velocity_at_start::<false>(), |phi| {
                evaluations.set(evaluations.get() + 1);
                f(phi)
            });
            let Verdict::Zero(zero) = verdict else { panic!("Ω = {omega}: {slide:?}") };
            assert!((zero.at + zero.step - PI).abs() < 1e-9, "Ω = {omega}: {} {}", zero.at, zero.step);
            assert!(evaluations.get() < 64, "Ω = {omega}: {}", evaluations.get());
        }
    }

    #[test]
    fn the_error_names_the_slide() {
        let equation = Equation::new(Ratios::new(0.7, 2.5).unwrap());
        let slide = Slide::new(equation, DrivePhase::new(7.5).unwrap(), -0.4, 1.1, Direction::Forward);
        let message = crate::Error::from(slide.lost("the velocity zero")).to_string();
        let start =
            "the velocity zero from phase ω_d t = 7.5 on at Ω = 0.7, α = 2.5 must be found within π(1 + 2/Ω)";
        assert!(message.starts_with(start), "{message}");
    }

    #[test]
    fn a_wrong_hint_changes_nothing() {
        for (omega, alpha, theta, x, w) in [
            (0.3, 5.0, 0.2, -1.0, 3.0),
            (0.8, 2.0, 1.0, 0.5, 4.0),
            (1.4, 3.0, -0.5, 0.1, 2.0),
            (20.0, 9.0, 0.3, 0.0, 0.7),
        ] {
            let equation = Equation::new(Ratios::new(omega, alpha).unwrap());
            let start = DrivePhase::new(theta).unwrap();
            let slide = Slide::new(equation, start, x, w, Direction::Forward);
            let right = slide.velocity_zero(0.0).unwrap();
            for i in 1..100 {
                let end = slide.velocity_zero(f64::from(i) * 0.11).unwrap();
                assert!(
                    (end.phi - right.phi).abs() < 1e-13 * (1.0 + omega),
                    "Ω = {omega}: {end:?} {right:?}"
                );
                assert!((end.x - right.x).abs() < 1e-13);
            }
        }
    }
}
