//! The order of events of a steady motion, and roughly when they are: found at f64, proved by nothing here.

use crate::error::Error;
use crate::exact::{Direction, End, Kind, LongRun, Phase, State, SteadyState, Trajectory};
use crate::ratios::Ratios;

/// One slide, and what follows it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part {
    /// The sign of its velocity.
    pub(super) sign: i32,
    /// Its natural duration.
    pub(super) duration: f64,
    /// The phase of the release from the stop that follows; `None` where it reverses at once.
    pub(super) release: Option<f64>,
}

/// Half a turn of the drive.
#[derive(Debug, Clone)]
pub(super) struct Outline {
    /// Phase of the drive at the start: a release, where the body stops.
    pub(super) phase: f64,
    /// Place at the start.
    pub(super) place: f64,
    pub(super) stops: bool,
    pub(super) parts: Vec<Part>,
}

/// Slides in half a turn, at most.
const MOST: usize = 512;

/// Half a turn of the steady motion from rest; `None` where there is none, or none that is symmetric and clear of grazing.
///
/// # Errors
/// As of [`LongRun::from_start`].
pub(super) fn outline(ratios: Ratios<f64>) -> Result<Option<Outline>, Error> {
    LongRun::from_start(ratios, State::rest()).map(|run| half_turn(ratios, run.steady_state()?))
}

fn half_turn(ratios: Ratios<f64>, steady: &SteadyState<f64>) -> Option<Outline> {
    let stops = steady.sticks_per_cycle() > 0;
    let mut phases = Trajectory::new(ratios, steady.state()).ok()?;
    // The first slide that begins at rest: after a stop, where there are any.
    let mut last = phases.next()?.ok()?;
    let first = loop {
        let next = phases.next()?.ok()?;
        let begins = if stops { last.kind() == Kind::Stick } else { last.ends_by() == End::Reversal };
        if begins && matches!(next.kind(), Kind::Slide(_)) {
            break next;
        }
        last = next;
    };
    let start = first.start();
    let since = |phase: &Phase<f64>| phase.start().phase.since(start.phase);
    let mut parts = vec![part(&first, ratios.omega())?];
    for phase in phases.take(2 * MOST) {
        let phase = phase.ok()?;
        // The mirror image of the first slide.
        if since(&phase) > core::f64::consts::PI - 1e-6 && matches!(phase.kind(), Kind::Slide(_)) {
            let is_mirrored = (since(&phase) - core::f64::consts::PI).abs() < 1e-6
                && phase.kind() != first.kind()
                && (phase.start().x + start.x).abs() < 1e-6;
            return is_mirrored.then(|| Outline {
                phase: start.phase.reduced(),
                place: start.x,
                stops,
                parts,
            });
        }
        match phase.kind() {
            Kind::Stick => {
                parts.last_mut()?.release = Some(start.phase.reduced() + since_end(&phase, &first)?)
            }
            Kind::Slide(_) => parts.push(part(&phase, ratios.omega())?),
        }
    }
    None
}

/// The phase of the end of a phase, from the start of another.
fn since_end(phase: &Phase<f64>, first: &Phase<f64>) -> Option<f64> {
    phase.end().map(|end| end.phase.since(first.start().phase))
}

/// A slide as a part; `None` of one that grazes.
fn part(phase: &Phase<f64>, omega: f64) -> Option<Part> {
    let sign = match phase.kind() {
        Kind::Slide(Direction::Forward) => 1,
        Kind::Slide(Direction::Backward) => -1,
        Kind::Stick => return None,
    };
    let duration = phase.duration()? / omega;
    matches!(phase.ends_by(), End::Reversal | End::Stop).then_some(Part { sign, duration, release: None })
}
