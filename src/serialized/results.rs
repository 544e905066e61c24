//! Results are read back as they were written: the numbers that are public fields as they stand, all others computed
//! again from the ratios as by [`Response::new`].

use super::inputs::{Unread, absent, one, zero};
use crate::cycle::regime::Regime;
use crate::float::Float;
use crate::machine::error::Error;
use crate::motion::drive_phase::DrivePhase;
use crate::motion::event::velocity_zero::VelocityZero;
use crate::motion::limit::measures::Extreme;
use crate::motion::limit::steady::SteadyState;
use crate::motion::slide::equation::Equation;
use crate::motion::slide::stick::Stick;
use crate::motion::slide::{Direction, Slide};
use crate::motion::state::{PhasePoint, State};
use crate::motion::trajectory::{Body, resolved};
use crate::motion::{End, FreeDecay, Kind, Segment};
use crate::{Border, Cycle, Excitation, Ratios, Response};
use serde::{Deserialize, Serialize};

/// The ratios and the numbers of a cycle, null where there is none.
#[derive(Deserialize)]
#[serde(bound(deserialize = "F: Float + Deserialize<'de>"))]
pub(crate) struct CycleFields<F> {
    omega: F,
    alpha: F,
    #[serde(default = "zero")]
    damping_ratio: F,
    #[serde(default = "one")]
    static_friction_ratio: F,
    #[serde(default = "absent")]
    excitation: Option<Excitation>,
    max_displacement: Option<F>,
    displacement_phase: Option<F>,
    max_velocity: Option<F>,
    velocity_phase: Option<F>,
}

impl<F: Float> CycleFields<F> {
    fn ratios(&self) -> Result<Ratios<F>, Error> {
        Ok(Ratios::new(self.omega, self.alpha)?
            .with_damping_ratio(self.damping_ratio)?
            .with_static_friction_ratio(self.static_friction_ratio)?
            .under(self.excitation))
    }

    /// The cycle at these ratios; `None` where its numbers are absent.
    fn cycle(&self) -> Result<Option<Cycle<F>>, Error> {
        let Some(max_displacement) = self.max_displacement else { return Ok(None) };
        let mut cycle = Cycle::new(self.ratios()?)?;
        cycle.max_displacement = max_displacement;
        cycle.displacement_phase = self.displacement_phase.unwrap_or(cycle.displacement_phase);
        cycle.max_velocity = self.max_velocity.unwrap_or(cycle.max_velocity);
        cycle.velocity_phase = self.velocity_phase.unwrap_or(cycle.velocity_phase);
        Ok(Some(cycle))
    }
}

impl<F: Float> TryFrom<CycleFields<F>> for Cycle<F> {
    type Error = Unread;

    fn try_from(fields: CycleFields<F>) -> Result<Self, Unread> {
        fields.cycle()?.ok_or_else(|| Unread::of("a cycle: needs a max_displacement"))
    }
}

/// The answer at one point: its ratios, its regime, and the numbers of its border and its cycle.
#[derive(Deserialize)]
#[serde(bound(deserialize = "F: Float + Deserialize<'de>"))]
pub(crate) struct ResponseFields<F> {
    regime: Regime,
    #[serde(flatten)]
    border: Border<F>,
    #[serde(flatten)]
    cycle: CycleFields<F>,
    loop_size_stiffness: Option<F>,
    loop_size_inertia: Option<F>,
    best_force_ratio: F,
    best_loop_size: Option<F>,
}

impl<F: Float> TryFrom<ResponseFields<F>> for Response<F> {
    type Error = Unread;

    fn try_from(fields: ResponseFields<F>) -> Result<Self, Unread> {
        Ok(Self {
            ratios: fields.cycle.ratios()?,
            regime: fields.regime,
            border: fields.border,
            cycle: fields.cycle.cycle()?,
            loop_size_stiffness: fields.loop_size_stiffness,
            loop_size_inertia: fields.loop_size_inertia,
            best_force_ratio: fields.best_force_ratio,
            best_loop_size: fields.best_loop_size,
        })
    }
}

/// What the outputs of a steady state leave out of it.
#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "F: Float + Serialize", deserialize = "F: Float + Deserialize<'de>"))]
pub(crate) struct Followed<F> {
    ratios: Ratios<F>,
    start: PhasePoint<F>,
    /// The phases of the maximum and the minimum displacement, of the maximum and the minimum velocity.
    phases: [DrivePhase<F>; 4],
    distance: (F, F),
}

impl<F: Float> From<&SteadyState<F>> for Followed<F> {
    fn from(steady: &SteadyState<F>) -> Self {
        let extremes =
            [steady.max_displacement, steady.min_displacement, steady.max_velocity, steady.min_velocity];
        Self {
            ratios: steady.equation.ratios(),
            start: steady.start,
            phases: extremes.map(|extreme| extreme.phase),
            distance: steady.distance,
        }
    }
}

/// The outputs of a steady state by their names, and the rest of it.
#[derive(Deserialize)]
#[serde(bound(deserialize = "F: Float + Deserialize<'de>"))]
pub(crate) struct SteadyFields<F> {
    turns_per_cycle: u32,
    sticks_per_cycle: u32,
    velocity_zeros_per_cycle: u32,
    symmetric: bool,
    multipliers: [(F, F); 2],
    max_displacement: F,
    min_displacement: F,
    max_velocity: F,
    min_velocity: F,
    stick_fraction: F,
    energy_in: F,
    energy_out: F,
    damper_work: F,
    periods: F,
    state: State<F>,
    followed: Followed<F>,
}

impl<F: Float> From<SteadyFields<F>> for SteadyState<F> {
    fn from(fields: SteadyFields<F>) -> Self {
        let Followed { ratios, start, phases: [most, least, fastest, slowest], distance } = fields.followed;
        Self {
            max_displacement: Extreme { value: fields.max_displacement, phase: most },
            min_displacement: Extreme { value: fields.min_displacement, phase: least },
            max_velocity: Extreme { value: fields.max_velocity, phase: fastest },
            min_velocity: Extreme { value: fields.min_velocity, phase: slowest },
            sticks_per_cycle: fields.sticks_per_cycle,
            velocity_zeros_per_cycle: fields.velocity_zeros_per_cycle,
            stick_fraction: fields.stick_fraction,
            energy_in: fields.energy_in,
            energy_out: fields.energy_out,
            damper_work: fields.damper_work,
            multipliers: fields.multipliers,
            turns_per_cycle: fields.turns_per_cycle,
            is_symmetric: fields.symmetric,
            state: fields.state,
            distance,
            periods: fields.periods,
            equation: Equation::new(ratios),
            start,
        }
    }
}

/// What the ends of a segment leave out of it, in natural time.
#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[serde(bound(serialize = "F: Float + Serialize", deserialize = "F: Float + Deserialize<'de>"))]
pub(crate) enum Within<F> {
    Slide(Ratios<F>, OfSlide<F>),
    /// With the direction of the release.
    Stick(Ratios<F>, Option<Kind>),
}

/// The velocity and the acceleration at the start of a slide, its duration, and what is known of its end.
#[derive(Serialize, Deserialize)]
#[serde(bound(serialize = "F: Float + Serialize", deserialize = "F: Float + Deserialize<'de>"))]
pub(crate) struct OfSlide<F> {
    velocity: F,
    acceleration: F,
    duration: F,
    end_acceleration: F,
    end_jerk: F,
    end_rotation: (F, F),
    grazes: bool,
}

impl<F: Float> From<&Segment<F>> for Within<F> {
    fn from(segment: &Segment<F>) -> Self {
        match &segment.body {
            Body::Slide(slide, zero) => {
                let of_slide = OfSlide {
                    velocity: slide.w,
                    acceleration: slide.acceleration,
                    duration: zero.phi,
                    end_acceleration: zero.acceleration,
                    end_jerk: zero.jerk,
                    end_rotation: zero.rotation,
                    grazes: zero.grazes,
                };
                Self::Slide(slide.equation.ratios(), of_slide)
            }
            Body::Stick(stick) => {
                let released = stick.release.map(|(_, direction)| direction.into());
                Self::Stick(stick.equation.ratios(), released)
            }
        }
    }
}

/// A segment by its ends, and what they leave out.
#[derive(Deserialize)]
#[serde(bound(deserialize = "F: Float + Deserialize<'de>"))]
pub(crate) struct SegmentFields<F> {
    kind: Kind,
    ends_by: End,
    start: State<F>,
    end: Option<State<F>>,
    within: Within<F>,
}

impl<F: Float> TryFrom<SegmentFields<F>> for Segment<F> {
    type Error = Unread;

    fn try_from(
        SegmentFields { kind, ends_by, start, end, within }: SegmentFields<F>,
    ) -> Result<Self, Unread> {
        let direction = |kind| match kind {
            Kind::SlideForward => Some(Direction::Forward),
            Kind::SlideBackward => Some(Direction::Backward),
            Kind::Stick => None,
        };
        let State { phase, x, .. } = start;
        let body = match (direction(kind), end, within) {
            (Some(direction), Some(end), Within::Slide(ratios, of_slide)) => {
                let equation = Equation::new(resolved(ratios)?);
                let mut slide = Slide::new(equation, phase, x, of_slide.velocity, direction);
                slide.acceleration = of_slide.acceleration;
                let zero = VelocityZero {
                    phi: of_slide.duration,
                    phase: end.phase,
                    x: end.x,
                    acceleration: of_slide.end_acceleration,
                    jerk: of_slide.end_jerk,
                    rotation: of_slide.end_rotation,
                    grazes: of_slide.grazes,
                };
                Body::Slide(slide, zero)
            }
            (None, end, Within::Stick(ratios, released)) => {
                let release = end.map(|end| end.phase).zip(released.and_then(direction));
                Body::Stick(Stick { equation: Equation::new(resolved(ratios)?), start: phase, x, release })
            }
            _ => return Err(Unread::of("a segment: needs the ends and the fields of its kind")),
        };
        Ok(Self { kind, ends_by, body })
    }
}

/// A free vibration by its start and its machine.
#[derive(Deserialize)]
#[serde(bound(deserialize = "F: Float + Deserialize<'de>"))]
pub(crate) struct FreeDecayFields<F> {
    start: State<F>,
    damping_ratio: F,
    static_friction_ratio: F,
}

impl<F: Float> TryFrom<FreeDecayFields<F>> for FreeDecay<F> {
    type Error = Unread;

    fn try_from(fields: FreeDecayFields<F>) -> Result<Self, Unread> {
        let State { x, v, .. } = fields.start;
        Ok(Self::new(x, v, fields.damping_ratio, fields.static_friction_ratio)?)
    }
}

/// A number that may be infinite, which is null then.
pub(crate) mod infinite {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(crate) fn serialize<S: Serializer>(x: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        Some(*x).filter(|x| x.is_finite()).serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        Ok(Option::deserialize(deserializer)?.unwrap_or(f64::INFINITY))
    }
}

/// The ends of a range, null where it has none.
pub(crate) mod unbounded {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(crate) fn serialize<S: Serializer>(ends: &(f64, f64), serializer: S) -> Result<S::Ok, S::Error> {
        let finite = |x: f64| Some(x).filter(|x| x.is_finite());
        (finite(ends.0), finite(ends.1)).serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<(f64, f64), D::Error> {
        let (low, high): (Option<f64>, Option<f64>) = Deserialize::deserialize(deserializer)?;
        Ok((low.unwrap_or(f64::NEG_INFINITY), high.unwrap_or(f64::INFINITY)))
    }
}
