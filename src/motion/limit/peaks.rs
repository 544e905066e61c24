//! Acceleration, transmitted force and absolute motion of a steady state, stops included.

use super::long_run::LongRun;
use super::steady::SteadyState;
use crate::float::Float;
use crate::greatest::{Bound, Jet, greatest, is_unknown};
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::machine::support::Support;
use crate::motion::slide::Slide;
use crate::motion::slide::stick::Stick;
use crate::motion::trajectory::{Body, Trajectory};
use alloc::vec;
use core::cell::{Cell, RefCell};
use core::f64::consts::TAU;
use core::ops::ControlFlow;

/// The maximum absolute values in a cycle of the exact motion.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Peaks<F> {
    /// Acceleration |x″|, in B ω_d².
    pub acceleration: F,
    /// Force on the support, in r_y: of spring, friction and damper, `|k x + r + c x′|`, which at rest is the force of the
    /// drive. Where the support moves ([`crate::Ratios::excitation`]), support and surface together carry m x″.
    pub transmitted_force: F,
    /// The transmissibility: that force over p₀. Where the support moves, the acceleration over that of the support.
    pub transmissibility: F,
    /// Absolute displacement |x + u| under a base that carries the surface, u = (α/Ω²) sin θ, in B; |x| where the support
    /// moves over a fixed surface.
    pub absolute_displacement: F,
    /// Force in the spring k |x − u|, in r_y, where the support of the spring moves by u; k |x| otherwise.
    pub spring_force: F,
}

impl<F: Float> SteadyState<F> {
    /// The peaks of a cycle; the cycle is followed to find them.
    ///
    /// On a slide x″ obeys `f″ + f = −Ω²α sin θ` in natural time, and `x + u` obeys `f″ = −(x ± 1)`. Both
    /// have a bounded second derivative, and the maximum is found without sampling. Accuracy at f64: 1e-13 of
    /// max x/B + α/Ω².
    ///
    /// # Errors
    /// Those of the motion ([`Trajectory`]), and [`Error::SearchBound`] where a slide has so many oscillations of nearly
    /// one height that 2²⁰ parts do not tell the highest.
    pub fn peaks(&self) -> Result<Peaks<F>, Error> {
        self.peaks_while(&mut || ControlFlow::Continue(()))
    }

    /// As [`SteadyState::peaks`], but stops with [`Error::Interrupted`] where `keep_going`, asked at every step of the
    /// search, breaks: under a slow drive a cycle has very many oscillations.
    #[doc(hidden)]
    pub fn peaks_while(&self, keep_going: &mut dyn FnMut() -> ControlFlow<()>) -> Result<Peaks<F>, Error> {
        let zero = F::int(0);
        let reach = self.max_displacement.value.abs().or_larger(self.min_displacement.value.abs());
        let speed =
            self.equation.omega * self.max_velocity.value.abs().or_larger(self.min_velocity.value.abs());
        let mut peaks = Peaks {
            acceleration: zero,
            transmitted_force: zero,
            transmissibility: zero,
            absolute_displacement: zero,
            spring_force: zero,
        };
        let start = self.state;
        let phases = Trajectory::of(self.equation, start);
        let cycle = TAU * f64::from(self.turns_per_cycle);
        let keep_going = RefCell::new(keep_going);
        let is_interrupted = Cell::new(false);
        let stops = || {
            is_interrupted.set(is_interrupted.get() || (keep_going.borrow_mut())().is_break());
            is_interrupted.get()
        };
        for phase in phases {
            let phase = phase?;
            if stops() {
                return Err(Error::Interrupted);
            }
            if phase.start().phase.since(start.phase).to_f64() >= cycle {
                break;
            }
            let Some(length) = phase.duration() else { break };
            match &phase.body {
                Body::Slide(slide, _) => peaks.slide(slide, length, (reach, speed), &stops),
                Body::Stick(stick) => peaks.stick(stick, length),
            }
        }
        if is_interrupted.get() {
            return Err(Error::Interrupted);
        }
        let forces = [peaks.transmitted_force, peaks.spring_force];
        let found = [peaks.acceleration, peaks.absolute_displacement].into_iter().chain(forces);
        let search = "the greatest acceleration, force or absolute displacement";
        let lost = |bound| Err(self.equation.lost(search, start.phase, bound).into());
        if found.clone().any(is_unknown) {
            return lost("2²⁰ parts of a slide");
        }
        if found.into_iter().any(|peak: F| !peak.is_finite()) {
            return lost("the range of this number type");
        }
        let acceleration = peaks.acceleration / self.equation.omega.square();
        let support = self.equation.support();
        let carried = if support.is_foot() { acceleration } else { peaks.transmitted_force };
        Ok(Peaks {
            acceleration,
            transmitted_force: support.force(carried),
            transmissibility: support.transmissibility(carried),
            absolute_displacement: if support.is_foot() { reach } else { peaks.absolute_displacement },
            spring_force: if support.is_foot() { peaks.spring_force } else { reach },
        })
    }
}

impl<F: Float> LongRun<F> {
    /// The peaks of the limit at these ratios: of a cycle, or at rest; `None` for all other limits.
    ///
    /// # Errors
    /// As for [`SteadyState::peaks_while`].
    #[doc(hidden)]
    pub fn peaks_while(
        &self,
        ratios: &Ratios<F>,
        keep_going: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Option<Peaks<F>>, Error> {
        match (self.steady_state(), self.rest_position()) {
            (Some(steady), _) => steady.peaks_while(keep_going).map(Some),
            (None, x) => Ok(x.map(|x| Peaks::at_rest(&Support::from(ratios), x))),
        }
    }
}

/// From this power of two on, in natural time over the fastest decay, a slide is long.
const LONG: i32 = 13;

impl<F: Float> Peaks<F> {
    /// The peaks of a body that rests at x: friction carries the force of the drive, and the body moves with its base.
    pub(crate) fn at_rest(support: &Support<F>, x: F) -> Self {
        let zero = F::int(0);
        let carried = if support.is_foot() { zero } else { support.alpha };
        let base = if support.is_foot() { zero } else { support.alpha / support.omega.square() };
        Self {
            acceleration: zero,
            transmitted_force: support.force(carried),
            transmissibility: support.transmissibility(carried),
            absolute_displacement: x.abs() + base,
            spring_force: x.abs() + support.foot().map_or(zero, |(size, _)| size),
        }
    }

    /// The peaks of a slide, along which the displacement is at most `reach` and the speed w at most `speed`.
    ///
    /// With `w = w_f + h`, h the free vibration, `x″ = a_f + h′` and the force is `x + s + 2ζw = x_f + 2ζw_f
    /// − h′`. No derivative of h exceeds the initial energy `hypot(h″, h‴)`. Near resonance both waves are
    /// large, and the equation of motion gives the smaller bounds.
    ///
    /// Once `stops` is true, a search ends at once with an infinite value.
    fn slide(&mut self, slide: &Slide<F>, length: F, (reach, speed): (F, F), stops: &dyn Fn() -> bool) {
        let (zero, one) = (F::int(0), F::int(1));
        let equation = &slide.equation;
        let (omega, damping, sign) = (equation.omega, equation.damping, slide.direction.sign::<F>());
        let (square, end) = (omega.square(), length / omega);
        let (real, imaginary) = equation.stiffness();
        let amplitude = equation.alpha / real.hypot(imaginary);
        let (x, w) = equation.forced(slide.sin_cos_start());
        let (h, rate) = (slide.w - w, slide.acceleration + square * x);
        let second = -(h + damping * rate);
        let free = second.hypot(rate + damping * second);
        // |x + s + 2ζw|, |w′| and |w″|.
        let force = reach + one + damping * speed;
        let most = equation.alpha + force;
        let jerk = omega * equation.alpha + speed + damping * most;
        // On a slide of very many oscillations, or with much damping, the free vibration is looked at anew in each piece.
        let is_long = end * (one + damping) > F::exp2i(LONG);
        let free_motion = |phi: F| {
            if !is_long || damping == zero {
                return (h, rate);
            }
            slide.free_motion(phi)
        };
        let free_from = |phi: F| {
            if !is_long || damping == zero {
                return free;
            }
            let (w, rate) = slide.free_motion(phi);
            let second = -(w + damping * rate);
            second.hypot(rate + damping * second)
        };
        let free_from = &free_from;
        let known = |waves: F, ode: F| {
            move |low: F, _: F| {
                let waves = waves + free_from(low);
                let curvature = if waves < ode { waves } else { ode };
                Bound { curvature: if stops() { one / zero } else { curvature }, value: one / zero }
            }
        };
        // The greatest value in the windows that can have it.
        let windows = if is_long && damping == zero { slide.windows(end) } else { vec![(zero, end)] };
        let bend = known(square.square() * amplitude, square * equation.alpha + most + damping * jerk);
        self.acceleration = windows.iter().fold(self.acceleration, |best, &(low, high)| {
            greatest(low, high, best, bend, |phi| {
                let m = slide.motion(phi);
                Jet { value: m.acceleration, slope: m.jerk, second: m.higher(equation).0 }
            })
        });
        if damping == zero {
            // The force grows along the slide, and its ends decide.
            for x in [slide.x, slide.motion(end).x] {
                self.transmitted_force = self.transmitted_force.or_larger((x + sign).abs());
            }
        } else {
            let waves = square * amplitude * one.hypot(damping * omega);
            let bend = known(waves, most + damping * jerk);
            self.transmitted_force = greatest(zero, end, self.transmitted_force, bend, |phi| {
                let m = slide.motion(phi);
                let slope = m.w + damping * m.acceleration;
                Jet { value: m.x + sign + damping * m.w, slope, second: m.acceleration + damping * m.jerk }
            });
        }
        let bend = known(force, force);
        self.absolute_displacement = windows.iter().fold(self.absolute_displacement, |best, &(low, high)| {
            greatest(low, high, best, bend, |phi| {
                let m = slide.motion(phi);
                let slope = m.w + (m.jerk + m.w + damping * m.acceleration) / square;
                Jet { value: m.x + m.force / square, slope, second: -(m.x + sign + damping * m.w) }
            })
        });
        let Some((foot, on_foot)) = equation.support().foot() else { return };
        // With c = 2ζ of a damper on the support and c = 0 of another, u + cu′ = α sin θ gives
        // (1 + c²Ω²)(x − u) = c²Ω²x − x″ − s − (2ζ − c)x′ + c(x‴ + 2ζx″).
        // The driven part of x″ − u″ is that of x times Ω² hypot(Ω²/√(1 + c²Ω²), (2ζ − c)Ω).
        let (on_ground, turn) = (damping - on_foot, (on_foot * omega).square());
        let size = one + turn;
        let driven = square * amplitude * (square / size.sqrt()).hypot(on_ground * omega);
        let ode = most + square * foot;
        let bend = |low: F, _: F| {
            let (h, rate) = free_motion(low);
            let waves = driven + rate.hypot(h + damping * rate);
            let curvature = if waves < ode { waves } else { ode };
            Bound { curvature: if stops() { one / zero } else { curvature }, value: one / zero }
        };
        self.spring_force = windows.iter().fold(self.spring_force, |best, &(low, high)| {
            greatest(low, high, best, bend, |phi| {
                let m = slide.motion(phi);
                let (third, fourth) = m.higher(equation);
                let seen = |x: F, v: F, a: F, jerk: F| {
                    (turn * x - a - on_ground * v + on_foot * (jerk + damping * a)) / size
                };
                Jet {
                    value: seen(m.x, m.w, m.acceleration, m.jerk) - sign / size,
                    slope: seen(m.w, m.acceleration, m.jerk, third),
                    second: seen(m.acceleration, m.jerk, third, fourth),
                }
            })
        });
    }

    fn stick(&mut self, stick: &Stick<F>, length: F) {
        let alpha = stick.equation.alpha;
        let square = stick.equation.omega.square();
        let start = stick.start.reduced();
        let quarter = F::pi() / F::int(2);
        let mut at = |sine: F| {
            self.transmitted_force = self.transmitted_force.or_larger((alpha * sine).abs());
            let y = (stick.x + alpha * sine / square).abs();
            self.absolute_displacement = self.absolute_displacement.or_larger(y);
        };
        at(start.sin());
        at((start + length).sin());
        // The crests and troughs of the drive during the segment.
        for n in [1, 3, 5, 7] {
            let crest = quarter * F::int(n);
            if crest > start && crest < start + length {
                at(if n % 4 == 1 { F::int(1) } else { F::int(-1) });
            }
        }
        let Some((foot, damping)) = stick.equation.support().foot() else { return };
        let lag = (damping * stick.equation.omega).atan2(F::int(1));
        let mut seen = |sine: F| {
            self.spring_force = self.spring_force.or_larger((stick.x - foot * sine).abs());
        };
        seen((start - lag).sin());
        seen((start + length - lag).sin());
        for n in [1, 3, 5, 7] {
            let crest = quarter * F::int(n) + lag;
            if crest > start && crest < start + length {
                seen(if n % 4 == 1 { F::int(1) } else { F::int(-1) });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::motion::{LongRun, State, Trajectory};
    use crate::{Cycle, Ratios};

    /// No sample of the motion exceeds a peak, and some come close, with and without stops.
    #[test]
    fn peaks_are_the_greatest_of_samples() {
        for (omega, alpha, zeta) in [
            (0.05f64, 3.0f64, 0.0f64),
            (0.15, 3.0, 0.0),
            (0.3, 2.0, 0.0),
            (0.4, 6.0, 0.0),
            (0.4, 9.0, 0.0),
            (0.7, 1.2, 0.0),
            (1.6, 1.5, 0.0),
            (3.0, 1.3, 0.0),
            (0.3, 4.0, 0.1),
            (0.05, 3.0, 0.02),
            (0.8, 3.0, 0.4),
            (1.0, 9.0, 2.0),
            (3.0, 6.0, 1.0),
            // Long slides, whose free vibration is bounded anew in each piece.
            (1e-3, 100.0, 4000.0),
            (0.01, 30.0, 800.0),
        ] {
            let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
            let found = LongRun::from_start(ratios, State::default()).unwrap();
            let steady = found.steady_state().unwrap();
            let peaks = steady.peaks().unwrap();
            let (mut acceleration, mut force, mut absolute) = (0.0f64, 0.0f64, 0.0f64);
            let count = 100_000u32;
            for i in Trajectory::new(ratios, steady.state).unwrap().samples(count).unwrap().take(100_001) {
                let i = i.unwrap();
                let drive = alpha * i.state.phase.reduced().sin();
                let carried = i.state.x + i.friction + 2.0 * zeta * omega * i.state.v;
                acceleration = acceleration.max((drive - carried).abs() / omega.powi(2));
                force = force.max(carried.abs());
                absolute = absolute.max((i.state.x + drive / omega.powi(2)).abs());
            }
            for (found, sampled) in [
                (peaks.acceleration, acceleration),
                (peaks.transmitted_force, force),
                (peaks.absolute_displacement, absolute),
            ] {
                let close = found > sampled * (1.0 - 1e-10) && found < sampled * (1.0 + 1e-3);
                assert!(close, "{omega} {alpha}: {found} {sampled}");
            }
        }
    }

    /// Peaks that leave the range of their type are an error, and no infinite answer.
    #[test]
    fn peaks_beyond_the_range_are_refused() {
        let (mut refused, mut answered) = (0, 0);
        for i in 0..280u32 {
            let omega = 10f32.powf(i as f32 * 0.03 - 2.4);
            for alpha in [1.1f32, 13.0, 3e4] {
                let Ok(ratios) = Ratios::new(omega, alpha) else { continue };
                let Ok(found) = LongRun::from_start(ratios, State::default()) else { continue };
                let Some(steady) = found.steady_state() else { continue };
                match steady.peaks() {
                    Ok(peaks) => {
                        let all = [peaks.acceleration, peaks.transmitted_force, peaks.absolute_displacement];
                        assert!(all.into_iter().all(f32::is_finite), "{omega} {alpha}: {peaks:?}");
                        answered += 1;
                    }
                    Err(error) => {
                        assert!(error.to_string().contains("range of this number type"), "{error}");
                        refused += 1;
                    }
                }
            }
        }
        assert!(answered > 100, "{answered} answered, {refused} refused");
    }

    /// Hundreds of fast waves in a slide take no more time than a few.
    #[test]
    fn many_waves_take_no_time() {
        for (omega, alpha) in [(1e-3f64, 3e6f64), (2e-4, 6e7), (1e-3, 1.3e6), (2e-5, 6e9)] {
            let ratios = Ratios::new(omega, alpha).unwrap();
            let found = LongRun::from_start(ratios, State::default()).unwrap();
            let peaks = found.steady_state().unwrap().peaks().unwrap();
            let cycle = Cycle::new(ratios).unwrap();
            assert!((peaks.acceleration / cycle.max_acceleration() - 1.0).abs() < 1e-6, "{omega} {alpha}");
        }
    }

    /// Without stops the exact motion has the peaks of the closed forms.
    #[test]
    fn peaks_without_stops_are_those_of_the_closed_forms() {
        for (omega, alpha, zeta) in [
            (0.17, 60.0, 0.0),
            (0.3, 14.0, 0.0),
            (0.4, 9.0, 0.0),
            (0.55, 3.0, 0.0),
            (0.7, 2.0, 0.0),
            (0.999, 1.5, 0.0),
            (1.5, 2.5, 0.0),
            (4.4, 3.0, 0.0),
            (0.21, 60.0, 0.02),
            (0.7, 2.4, 0.05),
            (1.0, 3.0, 0.1),
            (0.8, 14.0, 1.3),
        ] {
            let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
            let cycle = Cycle::new(ratios).unwrap();
            let found = LongRun::from_start(ratios, State::default()).unwrap();
            let peaks = found.steady_state().unwrap().peaks().unwrap();
            for (exact, closed) in [
                (peaks.acceleration, cycle.max_acceleration()),
                (peaks.transmitted_force, cycle.transmitted_force()),
                (peaks.absolute_displacement, cycle.max_absolute_displacement()),
            ] {
                assert!((exact / closed - 1.0f64).abs() < 1e-10, "{omega} {alpha}: {exact} {closed}");
            }
        }
    }
}
