//! The end of a slide: the first zero of its velocity.

use super::cover::Cover;
use super::next_zero;
use super::search::{FoundZero, Safe, Verdict, ZeroSearch};
use super::stretch::polished_guess;
use crate::float::Float;
use crate::motion::broken::Broken;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::motion::Motion;
use crate::motion::slide::motion::SlideJet;
use crate::motion::slide::{Direction, Slide};

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

/// A search that exceeded its proved bound. It is of zero size, so that results that contain it stay small;
/// [`Slide::lost`] makes the error.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Lost;

/// The first event of a slide: its end, or a limit on the time.
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
        if self.equation.alpha * F::int(8) <= F::epsilon() {
            if let Some(end) = self.end_of_creep() {
                return Ok(end);
            }
            let least = F::exp2i(-960);
            if self.equation.alpha > F::int(0) && self.equation.alpha < least {
                // A forced wave of subnormal numbers has a sign of rounding. One that has digits moves nothing either.
                let mut slide = *self;
                slide.equation.alpha = least;
                return slide.velocity_zero(hint);
            }
        }
        match self.ends(hint, None)? {
            Outcome::Zero(zero) => Ok(zero),
            Outcome::Onward(_) => Err(Lost),
        }
    }

    /// The end of a slide without a drive, or with one below rounding: the body creeps to ∓1 until its
    /// velocity is rounding, for ever or for a long time.
    ///
    /// From ζ = 1 on the body turns only where `s(x + s) + ζ|w| > |w| √(ζ² − 1)`
    /// ([`crate::motion::FreeDecay`]). Below ζ = 1 it turns after the angle dφ of the point `(s(x + s) +
    /// ζ|w|, d|w|)`, half a turn for a body at rest there; d is small next to ζ = 1.
    #[cold]
    fn end_of_creep(&self) -> Option<VelocityZero<F>> {
        let (zero, sign) = (F::int(0), self.direction.sign::<F>());
        let free = self.equation.vibration();
        let speed = sign * self.w;
        let (push, swing) = (sign * self.x + F::int(1) + free.zeta * speed, free.frequency * speed);
        // e^{−n} < 2⁻ⁿ
        let phi = F::from_f64(f64::from(F::precision())) / free.slow_rate();
        let turns = if free.swings() {
            let angle = if speed > zero || push > zero { swing.atan2(push) } else { F::pi() };
            angle <= free.frequency * phi
        } else {
            push > swing
        };
        if turns {
            return None;
        }
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

    /// A velocity zero found by Householder's method from `hint`; no proof that it is the first.
    #[inline(never)]
    pub(crate) fn velocity_zero_near(&self, hint: F) -> Option<VelocityZero<F>> {
        let (within, f) = ((F::int(0), F::int(2) * hint), self.velocity());
        polished_guess(hint, self.equation.pace(), within, &f).map(|found| self.arrival(&found))
    }

    /// The velocity zero that ends the slide, if it is not after `limit`; otherwise the motion at the limit.
    ///
    /// # Errors
    /// [`Lost`].
    #[inline]
    pub(crate) fn until(&self, hint: F, limit: F) -> Result<Outcome<F>, Lost> {
        self.ends(hint, Some(limit))
    }

    /// The end of the slide, with or without a limit: one call of the search, into which the compiler inlines
    /// the motion of a slide.
    fn ends(&self, hint: F, limit: Option<F>) -> Result<Outcome<F>, Lost> {
        let (search, start) = (self.velocity_search(hint, limit), self.velocity_at_start());
        match next_zero(&search, start, self.velocity()) {
            Verdict::Zero(found) => Ok(Outcome::Zero(self.arrival(&found))),
            Verdict::Clear(Some((_, motion))) => Ok(Outcome::Onward(motion)),
            Verdict::Clear(None) => limit.map(|limit| Outcome::Onward(self.motion(limit))).ok_or(Lost),
            Verdict::Lost(_) => Err(Lost),
        }
    }

    /// The error for a search along this slide that exceeded its bound.
    #[cold]
    pub(crate) fn lost(&self, search: &'static str) -> Broken {
        let bound = if self.equation.is_damped() {
            "3π/Ω of natural time, and what the free vibration takes to turn or to fall below the forced one"
        } else {
            "π(1 + 2/Ω) of natural time"
        };
        self.equation.lost(search, self.start, bound)
    }

    /// The speed with its derivatives, and the motion from which it is computed.
    #[inline]
    fn velocity(&self) -> impl Fn(F) -> (SlideJet<F>, Motion<F>) + '_ {
        let sign = self.direction.sign::<F>();
        move |phi| {
            let m = self.motion(phi);
            (m.velocity_jet(&self.equation, sign), m)
        }
    }

    #[inline]
    fn velocity_at_start(&self) -> SlideJet<F> {
        self.motion_at_start().velocity_jet(&self.equation, self.direction.sign::<F>())
    }

    /// The properties of the velocity that are known before it is evaluated.
    #[inline]
    fn velocity_search(&self, hint: F, limit: Option<F>) -> ZeroSearch<'_, F> {
        let sign = self.direction.sign::<F>();
        let unit = F::int(4) * F::epsilon();
        let is_damped = self.equation.is_damped();
        ZeroSearch {
            omega: self.equation.omega,
            pace: self.equation.pace(),
            cover: Cover::new(self.equation.vibration()),
            waves: if is_damped { self.damped_waves() } else { None },
            angle: self.start.angle(),
            helping: self.start.is_even() == (self.direction == Direction::Forward),
            from_zero: sign * self.w <= F::int(0),
            limit,
            hint,
            safe: if is_damped { None } else { self.safe_window() },
            noise: unit * self.velocity_scale(),
            short_noise: Some(self.short_velocity_scale().map(|term| unit * term)),
        }
    }

    /// The state at a zero: the last step by Taylor's series, whose next term is below rounding.
    #[inline]
    fn arrival(&self, found: &FoundZero<F, Motion<F>>) -> VelocityZero<F> {
        let FoundZero { at, step: h, motion: m, grazes } = *found;
        let (half, third) = (h / F::int(2), h / F::int(3));
        let x = m.x + h * (m.w + half * (m.acceleration + third * m.jerk));
        let (fourth, fifth) = m.higher(&self.equation);
        let acceleration = m.acceleration + h * (m.jerk + half * (fourth + third * fifth));
        let jerk = m.jerk + h * fourth;
        // s′ = c − 2ζs, s″ = −(s + 2ζs′), s‴ = −(s′ + 2ζs″), and c′ = −s.
        let ((s, c), damping) = (m.rotation, self.equation.damping);
        let s1 = c - damping * s;
        let s2 = s + damping * s1;
        let s3 = s1 - damping * s2;
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

    /// The slide, if windows of the two waves of its velocity cost less than the stretches that they clear:
    /// for Ω > 2 or Ω < 1/4, and for ζ ≥ 1/2 unless the slide begins at rest close to its equilibrium,
    /// because it is short then. From ζ = 15/16 on the free vibration can take long to turn after any start.
    #[inline]
    fn damped_waves(&self) -> Option<&Self> {
        let (zero, one, two, four) = (F::int(0), F::int(1), F::int(2), F::int(4));
        let slow = F::ratio(15, 8);
        let Equation { omega, alpha, damping, .. } = self.equation;
        let is_short = self.w == zero && self.acceleration.abs() <= F::int(16) * (one + alpha);
        let is_stiff = damping >= slow || (damping >= one && !is_short);
        (omega * four < one || omega > two || is_stiff).then_some(self)
    }

    /// The window in which the slow wave of the velocity exceeds the amplitude of the fast one, for Ω outside
    /// [1/2, 2] and ζ = 0.
    ///
    /// `w = G cos θ + (free vibration of amplitude r)`, G = αΩ/(1 − Ω²). The amplitude does not decay, so that the
    /// window holds for the whole slide; the windows for a damped one (`window`) cost 4 to 16 % of a steady
    /// state more.
    ///
    /// # Rounding
    /// The circular functions are accurate to ε. G then has an error of 3ε|G|, and r one of `ε r + 6ε max(1,
    /// Ω) |G|`: two products and sums of G with cos θ and Ω sin θ, and the hypotenuse. The window is computed
    /// for a G smaller and an r larger (or the other way) by 8ε each, so that rounding cannot make it too
    /// wide; [`Safe::next`] subtracts the rounding of its ends. This margin changes the cosine of the angle
    /// at the end of the window by 16ε max(1, Ω). It shortens the window by some 1e-8 of a period if the end
    /// is far from the crest, and by at most the square root of that near it.
    fn safe_window(&self) -> Option<Safe<F>> {
        let (one, two) = (F::int(1), F::int(2));
        let Equation { omega, alpha, .. } = self.equation;
        if (omega * two >= one && omega <= two) || alpha == F::int(0) {
            return None;
        }
        let forced = alpha * omega / ((one - omega) * (one + omega));
        let (sine, cosine) = self.sin_cos_start();
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
mod tests;
