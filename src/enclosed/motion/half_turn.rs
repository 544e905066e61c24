//! The half-turn map: from a reversal, or from a stop, to the next one that is its mirror image.

use super::certificate::{is_one_slide, is_one_stop, reverses};
use super::outline::Outline;
use super::slide::{End, Machine, Slide};
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::float::{Field, Real};

/// Where half a turn starts. With stops the place alone decides, and the phase is that of the release.
#[derive(Clone, Copy)]
pub(super) struct Start<const W: usize> {
    pub(super) phase: Ball<W>,
    pub(super) place: Ball<W>,
}

/// One slide of the half turn, with its end and, after a stop, the phase of the release.
#[derive(Clone, Copy)]
pub(super) struct Step<const W: usize> {
    pub(super) slide: Slide<W>,
    pub(super) end: End<W>,
    pub(super) release: Option<Ball<W>>,
}

/// Half a turn, followed.
pub(super) struct HalfTurn<const W: usize> {
    pub(super) start: Start<W>,
    pub(super) steps: Vec<Step<W>>,
    /// Phase and place at the end, less half a turn, mirrored.
    pub(super) end: Start<W>,
    /// The derivatives of phase and place at the end (not mirrored) by those at the start.
    pub(super) derivatives: [[Ball<W>; 2]; 2],
}

/// The half turn of an outline.
pub(super) struct Map<'a, const W: usize> {
    pub(super) machine: Machine<W>,
    pub(super) outline: &'a Outline,
}

impl<const W: usize> Map<'_, W> {
    /// The start with its phase, where the place alone is free.
    pub(super) fn start(&self, start: Start<W>) -> Option<Start<W>> {
        if !self.outline.stops {
            return Some(start);
        }
        let sign = Ball::int(self.outline.parts.first()?.sign);
        let phase = self.machine.release(Mp::of_f64(self.outline.phase), start.place, sign)?;
        Some(Start { phase, ..start })
    }

    /// Follows the half turn from a start.
    pub(super) fn follow(&self, start: Start<W>) -> Option<HalfTurn<W>> {
        let start = self.start(start)?;
        let (zero, one) = (Ball::int(0), Ball::int(1));
        let Start { mut phase, mut place } = start;
        // Derivatives of phase and place by those of the start; with a stop the phase follows the place.
        let mut derivatives = if self.outline.stops {
            [[zero, self.by_place(phase)], [zero, one]]
        } else {
            [[one, zero], [zero, one]]
        };
        let mut released = self.outline.stops;
        let mut steps = Vec::new();
        let mut parts = self.outline.parts.iter().peekable();
        while let Some(part) = parts.next() {
            let slide = Slide::new(self.machine, part.sign, phase, place, released);
            let end = slide.end(Mp::of_f64(part.duration))?;
            derivatives = product(&end.derivatives, &derivatives);
            (phase, place) = (end.phase, end.place);
            released = false;
            // The last stop ends with the mirror image of the first release.
            let mut release = None;
            if let (Some(guess), Some(next)) = (part.release, parts.peek()) {
                phase = self.machine.release(Mp::of_f64(guess), place, Ball::int(next.sign))?;
                let [_, [a, b]] = derivatives;
                let slope = self.by_place(phase);
                derivatives = [[slope * a, slope * b], [a, b]];
                released = true;
                release = Some(phase);
            } else if part.release.is_some() {
                release = Some(start.phase + Ball::pi());
            }
            steps.push(Step { slide, end, release });
        }
        let end = Start { phase: phase - Ball::pi(), place: -place };
        Some(HalfTurn { start, steps, end, derivatives })
    }

    /// dθ/dx of a release, where α sin θ = x ± η.
    fn by_place(&self, phase: Ball<W>) -> Ball<W> {
        Ball::int(1) / (self.machine.alpha * phase.cos())
    }
}

impl<const W: usize> HalfTurn<W> {
    /// Whether the motion of every start in the ball is this one: no event is passed, none is left out.
    pub(super) fn is_the_motion(&self, map: &Map<'_, W>) -> bool {
        let Some(first) = map.outline.parts.first() else { return false };
        // After the last slide comes the mirror image of the first one.
        let next_signs = map.outline.parts.iter().skip(1).map(|part| part.sign).chain([-first.sign]);
        let ends_alike =
            map.outline.parts.last().is_some_and(|part| part.release.is_some() == map.outline.stops);
        ends_alike
            && self.steps.iter().zip(next_signs).all(|(Step { slide, end, release }, sign)| {
                is_one_slide(slide, &end.duration)
                    && match release {
                        Some(release) => is_one_stop(&map.machine, end.place, end.phase, *release, sign),
                        None => reverses(&map.machine, end.place, end.phase, sign),
                    }
            })
    }
}

/// The product of two matrices.
fn product<const W: usize>(a: &[[Ball<W>; 2]; 2], b: &[[Ball<W>; 2]; 2]) -> [[Ball<W>; 2]; 2] {
    let [[b11, b12], [b21, b22]] = *b;
    a.map(|[x, y]| [x * b11 + y * b21, x * b12 + y * b22])
}
