//! The map of the motion: from a reversal or a release to its next repetition or mirror image.
//!
//! Its derivatives are by phase and place of a reversal, the numbers that the proof is about. Floats follow
//! disturbances of displacement and velocity at one phase (`crate::motion::limit::matrix`), which begin anywhere.

use super::certificate::{is_one_slide, is_one_stop, reverses};
use super::outline::{Outline, OutlinedSlide};
use super::slide::{DrivenBody, SlideBall, SlideEnd};
use super::unproved::{Event, Unproved};
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::float::{Field, Real};

/// The start of the motion. With stops the place alone determines it, and the phase is that of the release.
#[derive(Clone, Copy)]
pub(super) struct MapStart<const W: usize> {
    pub(super) phase: Ball<W>,
    pub(super) place: Ball<W>,
}

/// One slide, with its end and, after a stop, the phase of the release.
#[derive(Clone, Copy)]
pub(super) struct SlideStep<const W: usize> {
    pub(super) slide: SlideBall<W>,
    pub(super) end: SlideEnd<W>,
    pub(super) release: Option<Ball<W>>,
}

/// The computed part of a motion that repeats.
pub(super) struct FollowedBalls<const W: usize> {
    pub(super) start: MapStart<W>,
    pub(super) steps: Vec<SlideStep<W>>,
    /// Phase and place at the end, with the half turns subtracted, and mirrored after an odd number of half
    /// turns.
    pub(super) end: MapStart<W>,
    /// The derivatives of phase and place at the end (not mirrored) with respect to those at the start.
    pub(super) derivatives: [[Ball<W>; 2]; 2],
}

/// The map of an outline.
pub(super) struct Map<'a, const W: usize> {
    pub(super) machine: DrivenBody<W>,
    pub(super) outline: &'a Outline,
}

impl<const W: usize> Map<'_, W> {
    /// The phase of the drive that the map spans.
    pub(super) fn span(&self) -> Ball<W> {
        Ball::pi() * Ball::int(i32::try_from(self.outline.half_turns).unwrap_or(i32::MAX))
    }

    /// −1 where the motion repeats with the opposite sign, else 1.
    pub(super) fn image(&self) -> Ball<W> {
        Ball::int(self.outline.image())
    }

    /// The phase at which a body at rest at `place` is released in the direction `sign`.
    fn release(&self, guess: f64, place: Ball<W>, sign: i32, from: Ball<W>) -> Result<Ball<W>, Unproved> {
        let release = self.machine.release(Mp::of_f64(guess), place, Ball::int(sign));
        release.ok_or_else(|| undecided(Event::Release, from))
    }

    /// The start with its phase, if only the place is free.
    pub(super) fn start(&self, start: MapStart<W>) -> Result<MapStart<W>, Unproved> {
        match self.outline.parts.first() {
            Some(first) if self.outline.stops => {
                let phase = self.release(self.outline.phase, start.place, first.sign, start.phase)?;
                Ok(MapStart { phase, ..start })
            }
            _ => Ok(start),
        }
    }

    /// Computes the motion from a start.
    pub(super) fn follow(&self, start: MapStart<W>) -> Result<FollowedBalls<W>, Unproved> {
        let start = self.start(start)?;
        let (zero, one) = (Ball::int(0), Ball::int(1));
        let MapStart { mut phase, mut place } = start;
        // Derivatives of phase and place with respect to the start; with a stop the phase depends on the
        // place.
        let mut derivatives = if self.outline.stops {
            [[zero, self.by_place(phase)], [zero, one]]
        } else {
            [[one, zero], [zero, one]]
        };
        let mut released = self.outline.stops;
        let mut steps = Vec::new();
        let mut parts = self.outline.parts.iter().peekable();
        while let Some(part) = parts.next() {
            let slide = SlideBall::new(self.machine, part.sign, phase, place, released);
            let end = slide.end(Mp::of_f64(part.duration)).ok_or_else(|| undecided(Event::End, phase))?;
            let end = self.narrowed(part, &slide, end, place, released);
            derivatives = product(&end.derivatives, &derivatives);
            (phase, place) = (end.phase, end.place);
            released = false;
            // The last stop ends with the image of the first release.
            let mut release = None;
            if let (Some(guess), Some(next)) = (part.release, parts.peek()) {
                phase = self.release(guess, place, next.sign, phase)?;
                let [_, [a, b]] = derivatives;
                let slope = self.by_place(phase);
                derivatives = [[slope * a, slope * b], [a, b]];
                released = true;
                release = Some(phase);
            } else if part.release.is_some() {
                release = Some(start.phase + self.span());
            }
            steps.push(SlideStep { slide, end, release });
        }
        let end = MapStart { phase: phase - self.span(), place: self.image() * place };
        Ok(FollowedBalls { start, steps, end, derivatives })
    }

    /// The end of a slide by the mean value theorem, from the end of the slide that begins in the middle: a ball of starts
    /// has grown by its derivatives alone, which are below 1 over most stops. A ball of ends evaluated at once grows at every
    /// slide by more, and over a hundred slides without bound.
    fn narrowed(
        &self,
        part: &OutlinedSlide,
        slide: &SlideBall<W>,
        end: SlideEnd<W>,
        place: Ball<W>,
        released: bool,
    ) -> SlideEnd<W> {
        let exact = |x: Ball<W>| Ball::exact(x.mid());
        let middle = exact(place);
        let phase = if released {
            self.machine.release(slide.phase.mid(), middle, slide.sign)
        } else {
            Some(exact(slide.phase))
        };
        let Some(at) = phase.and_then(|phase| {
            SlideBall::new(self.machine, part.sign, phase, middle, released).end(end.duration.mid())
        }) else {
            return end;
        };
        let (by_phase, by_place) = (slide.phase - exact(slide.phase), place - middle);
        // After a stop the phase depends on the place.
        let [later, farther] = end.derivatives.map(|[a, b]| {
            if released {
                (a * self.by_place(slide.phase) + b) * by_place
            } else {
                a * by_phase + b * by_place
            }
        });
        let both = |whole: Ball<W>, at: Ball<W>| whole.intersection(&at).unwrap_or(whole);
        SlideEnd {
            phase: both(end.phase, at.phase + later),
            place: both(end.place, at.place + farther),
            ..end
        }
    }

    /// dθ/dx of a release, where α sin θ = x ± η.
    fn by_place(&self, phase: Ball<W>) -> Ball<W> {
        Ball::int(1) / (self.machine.alpha * phase.cos())
    }
}

impl<const W: usize> FollowedBalls<W> {
    /// Whether every start in the ball has this motion: no event is missed, and none is added.
    pub(super) fn is_the_motion(&self, map: &Map<'_, W>) -> Result<(), Unproved> {
        let outline = map.outline;
        let Some(first) = outline.parts.first() else { return Err(Unproved::NotPeriodic) };
        // The slide after the last one is the image of the first.
        let next_signs =
            outline.parts.iter().skip(1).map(|part| part.sign).chain([outline.image() * first.sign]);
        for (SlideStep { slide, end, release }, sign) in self.steps.iter().zip(next_signs) {
            let shown = |holds: bool, event: Event, phase: Ball<W>| {
                if holds { Ok(()) } else { Err(undecided(event, phase)) }
            };
            shown(is_one_slide(slide, &end.duration), Event::Slide, slide.phase)?;
            match release {
                Some(release) => shown(
                    is_one_stop(&map.machine, end.place, end.phase, *release, sign),
                    Event::Stop,
                    end.phase,
                )?,
                None => {
                    shown(reverses(&map.machine, end.place, end.phase, sign), Event::Reversal, end.phase)?
                }
            }
        }
        Ok(())
    }
}

/// The error for an event at a phase that balls of this precision cannot decide.
fn undecided<const W: usize>(event: Event, phase: Ball<W>) -> Unproved {
    let phase = phase.mid().to_f64().rem_euclid(core::f64::consts::TAU);
    Unproved::Undecided { event, phase, bits: Mp::<W>::bits_now() }
}

/// The product of two matrices.
fn product<const W: usize>(a: &[[Ball<W>; 2]; 2], b: &[[Ball<W>; 2]; 2]) -> [[Ball<W>; 2]; 2] {
    let [[b11, b12], [b21, b22]] = *b;
    a.map(|[x, y]| [x * b11 + y * b21, x * b12 + y * b22])
}
