//! The order of events of a steady motion and their approximate times, computed at f64 without proof.

use super::unproved::{Event, Unproved};
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::motion::{End, Kind, LongRun, Segment, State, SteadyState, Trajectory};

/// One slide and the event that follows it.
#[derive(Debug, Clone, Copy)]
pub(super) struct OutlinedSlide {
    /// The sign of its velocity.
    pub(super) sign: i32,
    /// Its duration in natural time.
    pub(super) duration: f64,
    /// The phase of the release from the stop that follows; `None` where the body reverses immediately.
    pub(super) release: Option<f64>,
}

/// The part of a motion that repeats.
#[derive(Debug, Clone)]
pub(super) struct Outline {
    /// Phase of the drive at the start: a release, where the body stops.
    pub(super) phase: f64,
    /// Place at the start.
    pub(super) place: f64,
    pub(super) stops: bool,
    /// The number of half turns of the drive after which the motion repeats, with the opposite sign if odd.
    pub(super) half_turns: u32,
    pub(super) parts: Vec<OutlinedSlide>,
}

impl Outline {
    /// −1 where the motion repeats with the opposite sign, else 1.
    pub(super) const fn image(&self) -> i32 {
        if self.half_turns % 2 == 1 { -1 } else { 1 }
    }
}

/// The greatest number of slides in the part that repeats.
const MOST: usize = 512;

/// Tolerance for recognising a repetition at f64; it plays no part in the proof.
const RECOGNISED: f64 = 1e-6;

/// The part of the steady motion from rest that repeats.
///
/// # Errors
///
/// As for [`LongRun::from_start`]. The inner error says why there is no such motion.
pub(super) fn outline(ratios: Ratios<f64>) -> Result<Result<Outline, Unproved>, Error> {
    Ok(match LongRun::from_start(ratios, State::default())? {
        LongRun::Periodic(steady) => of_steady(ratios, &steady),
        LongRun::Family(_) => Err(Unproved::Family),
        LongRun::Rest(_)
        | LongRun::Irregular(_)
        | LongRun::Unbounded { .. }
        | LongRun::NotConverged { .. } => Err(Unproved::NotPeriodic),
    })
}

fn of_steady(ratios: Ratios<f64>, steady: &SteadyState<f64>) -> Result<Outline, Unproved> {
    let stops = steady.sticks_per_cycle > 0;
    let phases = Trajectory::new(ratios, steady.state).map_err(|_| Unproved::NotPeriodic)?;
    let mut phases = phases.map_while(Result::ok);
    // The outline begins with the first slide from rest; after a stop, if there are any.
    let mut last = phases.next().ok_or(Unproved::NotPeriodic)?;
    let first = loop {
        let next = phases.next().ok_or(Unproved::NotPeriodic)?;
        let begins = if stops { last.kind == Kind::Stick } else { last.ends_by == End::Reversal };
        if begins && next.kind != Kind::Stick {
            break next;
        }
        last = next;
    };
    let (start, half_turns) = (first.start(), steady.half_turns());
    let span = core::f64::consts::PI * f64::from(half_turns);
    let since = |phase: &Segment<f64>| phase.start().phase.since(start.phase);
    let mut outline =
        Outline { phase: start.phase.reduced(), place: start.x, stops, half_turns, parts: Vec::new() };
    outline.parts.push(part(&first, ratios.omega())?);
    for phase in phases.take(2 * MOST) {
        let place = phase.start().x;
        // The image of the first slide.
        if since(&phase) > span - RECOGNISED && phase.kind != Kind::Stick {
            let is_image = (since(&phase) - span).abs() < RECOGNISED
                && (phase.kind == first.kind) == (outline.image() > 0)
                && (place - f64::from(outline.image()) * start.x).abs() < RECOGNISED;
            return if is_image { Ok(outline) } else { Err(Unproved::NotPeriodic) };
        }
        match phase.kind {
            Kind::Stick => {
                let end = phase.end().ok_or(Unproved::NotPeriodic)?.phase.since(start.phase);
                if let Some(last) = outline.parts.last_mut() {
                    last.release = Some(outline.phase + end);
                }
            }
            Kind::SlideForward | Kind::SlideBackward => outline.parts.push(part(&phase, ratios.omega())?),
        }
    }
    Err(Unproved::TooManySlides)
}

/// A slide as a part; an error for a slide that ends in a grazing.
fn part(phase: &Segment<f64>, omega: f64) -> Result<OutlinedSlide, Unproved> {
    let sign = match phase.kind {
        Kind::SlideForward => 1,
        Kind::SlideBackward => -1,
        Kind::Stick => return Err(Unproved::NotPeriodic),
    };
    let grazes = Unproved::Undecided {
        event: Event::Slide,
        phase: phase.start().phase.reduced(),
        bits: f64::MANTISSA_DIGITS,
    };
    match (phase.duration(), phase.ends_by) {
        (Some(duration), End::Reversal | End::Stop) => {
            Ok(OutlinedSlide { sign, duration: duration / omega, release: None })
        }
        _ => Err(grazes),
    }
}
