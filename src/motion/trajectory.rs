//! The motion as a sequence of segments: slide, stick, slide …

use super::drive_phase::DrivePhase;
use super::event::velocity_zero::{Lost, VelocityZero};
use super::slide::equation::Equation;
use super::slide::stick::{Stick, force_rounding};
use super::slide::{Direction, Slide};
use super::state::{Instant, State};
use crate::float::Float;
use crate::machine::error::{Error, Quantity};
use crate::machine::ratios::{Ratios, springless};
use crate::named::named;

named! {
    /// How a segment of the motion ends.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    pub enum End {
        /// The velocity goes through zero and the body slides back at once.
        Reversal = "reversal",
        /// The velocity reaches zero and the body stops.
        Stop = "stop",
        /// The velocity touches zero and the body continues in the same direction.
        Grazing = "grazing",
        /// The body, at rest, is released.
        Release = "release",
        /// The segment never ends.
        Never = "never",
    }
}

named! {
    /// The kind of a segment of the motion.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    pub enum Kind {
        /// The body slides towards larger x: friction is +r_y.
        SlideForward = "slide-forward",
        /// The body slides towards smaller x: friction is −r_y.
        SlideBackward = "slide-backward",
        /// The body is at rest.
        Stick = "stick",
    }
}

impl From<Direction> for Kind {
    #[inline]
    fn from(direction: Direction) -> Self {
        match direction {
            Direction::Forward => Self::SlideForward,
            Direction::Backward => Self::SlideBackward,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Body<F> {
    Slide(Slide<F>, VelocityZero<F>),
    Stick(Stick<F>),
}

/// One segment of the motion, from one change of its kind or direction to the next, exact at every instant.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::SegmentFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
#[non_exhaustive]
#[must_use]
pub struct Segment<F> {
    /// Sliding in one direction, or sticking.
    pub kind: Kind,
    /// The event that ends the segment.
    pub ends_by: End,
    pub(crate) body: Body<F>,
}

impl<F: Float> Segment<F> {
    /// The state at the start of the segment.
    pub fn start(&self) -> State<F> {
        match &self.body {
            Body::Slide(s, _) => State { phase: s.start, x: s.x, v: s.w / s.equation.omega },
            Body::Stick(s) => State { phase: s.start, x: s.x, v: F::int(0) },
        }
    }

    /// The state at the end of the segment, where the velocity is zero; `None` for a stop that never ends.
    pub fn end(&self) -> Option<State<F>> {
        let v = F::int(0);
        match &self.body {
            Body::Slide(_, zero) => Some(State { phase: zero.phase, x: zero.x, v }),
            Body::Stick(s) => s.release.map(|(phase, _)| State { phase, x: s.x, v }),
        }
    }

    /// The duration as a phase ω_d Δt; `None` for a stop that never ends.
    pub fn duration(&self) -> Option<F> {
        match &self.body {
            Body::Slide(s, zero) => Some(zero.phi * s.equation.omega),
            Body::Stick(s) => s.duration(),
        }
    }

    /// The motion at a phase θ between the start and the end of the segment.
    ///
    /// At other phases the result continues the formula of this segment and is not the motion.
    pub fn at(&self, phase: DrivePhase<F>) -> Instant<F> {
        match &self.body {
            Body::Slide(s, _) => {
                let omega = s.equation.omega;
                let m = s.motion(phase.since(s.start) / omega);
                Instant {
                    state: State { phase, x: m.x, v: m.w / omega },
                    acceleration: m.acceleration / omega.square(),
                    friction: s.direction.sign(),
                }
            }
            Body::Stick(s) => {
                let zero = F::int(0);
                let friction = s.equation.alpha * phase.sin_cos().0 - s.x;
                // Rounding can carry the force at the release beyond its bound.
                let most = s.equation.static_friction;
                let friction = if friction.abs() > most { most.with_sign_of(friction) } else { friction };
                Instant { state: State { phase, x: s.x, v: zero }, acceleration: zero, friction }
            }
        }
    }
}

/// The next segment, chosen at every velocity zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Next<F> {
    Slide(Slide<F>),
    Stick(Stick<F>),
}

impl<F: Float> Next<F> {
    /// Slide or stick at a velocity zero: by `|α sin θ − x|` against the static friction.
    ///
    /// Within rounding of the bound the first derivative that is not zero decides: a rising force releases
    /// the body, a falling one holds it.
    #[inline]
    pub(crate) fn at_rest(equation: Equation<F>, phase: DrivePhase<F>, x: F) -> Self {
        let sin_cos = phase.sin_cos();
        let force = equation.alpha * sin_cos.0 - x;
        let bound = equation.static_friction + force_rounding(&equation, x);
        if force.abs() > bound {
            let direction = Direction::of(force);
            return Self::Slide(Slide::from_rest(equation, phase, sin_cos, x, direction));
        }
        let stick = Stick::new(equation, phase, x);
        match stick.release {
            Some((end, direction)) if end.since(phase) <= F::int(0) => {
                Self::Slide(Slide::released(equation, phase, x, direction))
            }
            _ => Self::Stick(stick),
        }
    }

    /// The next segment from a state; `w = Ωv`.
    pub(crate) fn from_state(equation: Equation<F>, phase: DrivePhase<F>, x: F, w: F) -> Self {
        if w == F::int(0) {
            Self::at_rest(equation, phase, x)
        } else {
            Self::Slide(Slide::new(equation, phase, x, w, Direction::of(w)))
        }
    }

    /// The motion after a velocity zero, and the kind of event there.
    ///
    /// A slide can be too short for its phase to change, so that the next one begins at the same phase. A
    /// body released there is held until the force increases again. Hence **no more than three slides** begin
    /// at a phase: one that a negligible speed continues, one back, and one after a release.
    #[inline]
    pub(crate) fn after(slide: &Slide<F>, zero: &VelocityZero<F>) -> (Self, End) {
        let (equation, direction) = (slide.equation, slide.direction);
        // A velocity that touches zero has a minimum there. A static friction above the kinetic one then
        // stops the body.
        let goes_on = zero.grazes && !equation.has_higher_static_friction();
        if goes_on && direction.sign::<F>() * zero.jerk > F::int(0) {
            return (Self::Slide(Slide::grazing(equation, zero.phase, zero.x, direction)), End::Grazing);
        }
        let next = if zero.phase.since(slide.start) <= F::int(0) && slide.begins_at_bound() {
            Self::Stick(Stick::held(equation, zero.phase, zero.x))
        } else {
            Self::at_rest(equation, zero.phase, zero.x)
        };
        let end = match &next {
            Self::Slide(s) if s.direction == direction => End::Grazing,
            Self::Slide(_) => End::Reversal,
            Self::Stick(_) => End::Stop,
        };
        (next, end)
    }
}

/// The motion from a start, segment by segment: an iterator that ends only when the body rests permanently,
/// or after an error.
///
/// The error is [`Error::SearchBound`]: the search for the end of a slide exceeded its proved bound. No input
/// is known that causes it.
///
/// ```
/// use stickslip::Ratios;
/// use stickslip::motion::{Kind, State, Trajectory};
/// let mut motion = Trajectory::new(Ratios::new(0.4f64, 6.0)?, State::default())?;
/// let first = motion.next().unwrap()?;
/// assert_eq!(first.kind, Kind::Stick); // until the force reaches the friction force
/// assert!((first.duration().unwrap() - (1.0f64 / 6.0).asin()).abs() < 1e-15);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Trajectory<F> {
    pub(crate) equation: Equation<F>,
    next: Option<Next<F>>,
    /// The natural time expected of the next slide, from the last one.
    hint: F,
}

impl<F: Float> Trajectory<F> {
    /// The motion at (Ω, α) from a start.
    ///
    /// # Errors
    /// Where Ω is below 2⁻²⁰, because one slide then spans so many periods that a phase keeps few digits, or above that of
    /// a body whose spring cannot be seen (twice `springless`, 2²⁹ at f64); where ζ is above 2²⁰ and 2²⁰ Ω, or η above 2²⁰.
    pub fn new(ratios: Ratios<F>, start: State<F>) -> Result<Self, Error> {
        let equation = Equation::new(resolved(ratios)?);
        Ok(Self::of(equation, start))
    }

    pub(crate) fn of(equation: Equation<F>, start: State<F>) -> Self {
        let hint = F::pi() / equation.omega;
        let next = Next::from_state(equation, start.phase, start.x, start.v * equation.omega);
        Self { equation, next: Some(next), hint }
    }
}

impl<F: Float> Iterator for Trajectory<F> {
    type Item = Result<Segment<F>, Error>;

    #[inline]
    fn next(&mut self) -> Option<Result<Segment<F>, Error>> {
        match self.next? {
            Next::Stick(stick) => {
                self.next = stick.release.map(|(phase, direction)| {
                    Next::Slide(Slide::released(self.equation, phase, stick.x, direction))
                });
                let end = if self.next.is_some() { End::Release } else { End::Never };
                Some(Ok(Segment { kind: Kind::Stick, ends_by: end, body: Body::Stick(stick) }))
            }
            Next::Slide(slide) => {
                let zero = match slide.velocity_zero(self.hint) {
                    Ok(zero) => zero,
                    Err(Lost) => {
                        self.next = None;
                        return Some(Err(slide.lost("the velocity zero").into()));
                    }
                };
                let (next, end) = Next::after(&slide, &zero);
                self.hint = match &next {
                    Next::Slide(back) if end == End::Reversal => slide.expected_next(&zero, back),
                    Next::Slide(_) | Next::Stick(_) => zero.phi,
                };
                self.next = Some(next);
                Some(Ok(Segment {
                    kind: slide.direction.into(),
                    ends_by: end,
                    body: Body::Slide(slide, zero),
                }))
            }
        }
    }
}

impl<F: Float> core::iter::FusedIterator for Trajectory<F> {}

/// (Ω, α, ζ, η), if Ω is in the range where phases keep their digits, ζ where velocities do and η where
/// forces do.
pub(crate) fn resolved<F: Float>(ratios: Ratios<F>) -> Result<Ratios<F>, Error> {
    // A spring that is not there has an Ω with the rounding of its stiffness.
    let (least, greatest) = (F::exp2i(-20), (F::int(2) * springless()).or_larger(F::exp2i(20)));
    crate::machine::ratios::within(Quantity::FrequencyRatio, ratios.omega(), least, greatest)?;
    if ratios.is_damped() {
        let zeta = ratios.damping_ratio();
        // A body without a spring has ζ = c Ω/(2 m ω_d).
        let most = F::exp2i(20) * ratios.omega().or_larger(F::int(1));
        crate::machine::ratios::within(Quantity::DampingRatio, zeta, F::least_ratio(), most)?;
    }
    if ratios.has_higher_static_friction() {
        let eta = ratios.static_friction_ratio();
        crate::machine::ratios::within(Quantity::StaticFrictionRatio, eta, F::int(1), F::exp2i(20))?;
    }
    Ok(ratios)
}
