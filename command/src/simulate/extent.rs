//! How far a motion is followed, by which samples, and the phase of its start.

use crate::args::SimulateArgs;
use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::input;
use std::f64::consts::TAU;
use stickslip::motion::{DrivePhase, State};
use stickslip_front::inputs::Driven;
use stickslip_front::inputs::units::{Kind as Quantity, Reader};

/// The greatest number of segments or samples of a run: hours at some millions per second.
const MOST_ROWS: f64 = 1e10;

/// The start at the phase of `--phase`.
pub(super) fn at_phase<F: Value>(
    start: State<F>,
    phase: Option<&str>,
    reader: &Reader,
) -> Result<State<F>, Failure> {
    let Some(text) = phase else { return Ok(start) };
    let phase = reader.value::<F>("--phase", text, Quantity::Angle)?;
    if phase != F::int(0) && !Reader::has_unit(text) {
        return Err(format!("--phase {text}: must have a unit, {text}deg or {text}rad").into());
    }
    // A phase is one of a turn.
    let turn = F::int(2) * F::pi();
    if phase < F::int(0) || phase >= turn {
        return Err(format!("--phase {text}: must be ≥ 0 and < 360deg").into());
    }
    State::new(phase, start.x, start.v).map_err(|e| format!("--phase {text}: {e}").into())
}

/// The distance of samples: so many in a cycle, or turns of the drive from one to the next.
#[derive(Debug, Clone, Copy)]
pub(super) enum Spacing {
    PerCycle(u64),
    Turns(f64),
}

/// How far the motion is followed.
pub(super) struct Extent {
    /// The turns of the drive.
    pub(super) turns: f64,
    /// The arguments as typed.
    pub(super) typed: String,
    pub(super) spacing: Option<Spacing>,
}

impl Extent {
    pub(super) fn new<F: Value>(
        args: &SimulateArgs,
        machine: Option<&Driven<F>>,
        reader: &Reader,
    ) -> Result<Self, Failure> {
        // The used options make sure that there is a machine where times are given.
        let per_time = machine.map_or(1.0, |m| 1.0 / m.scales.time.to_f64() / TAU);
        let positive = |name: &str, text: &str, kind: Quantity| -> Result<f64, Failure> {
            let value = reader.value::<f64>(name, text, kind)?;
            if value > 0.0 && value.is_finite() {
                return Ok(value);
            }
            Err(format!("{name} {text}: must be > 0").into())
        };
        let spacing = match (&args.samples, &args.rate) {
            (Some(count), _) => {
                Some(Spacing::PerCycle(input::count("--samples", count, u64::from(u32::MAX))?))
            }
            (None, Some(rate)) => {
                Some(Spacing::Turns(per_time / (positive("--rate", rate, Quantity::Frequency)? / TAU)))
            }
            (None, None) => None,
        };
        let (turns, typed) = match (&args.cycles, &args.duration) {
            (_, Some(text)) => {
                (positive("--duration", text, Quantity::Time)? * per_time, format!("--duration {text}"))
            }
            (cycles, None) => {
                let missing = || Failure::Input("--cycles is missing, or --duration".to_owned());
                let text = cycles.as_deref().ok_or_else(missing)?;
                let cycles = input::count("--cycles", text, MOST_ROWS as u64)?;
                (cycles as f64, format!("--cycles {cycles}"))
            }
        };
        let typed = args.rate.as_ref().map_or(typed.clone(), |rate| format!("{typed} --rate {rate}"));
        Ok(Self { turns, typed, spacing })
    }

    /// Whole cycles, the last one begun.
    pub(super) fn cycles(&self) -> u64 {
        self.turns.ceil() as u64
    }

    /// The number of samples; the end is included.
    pub(super) fn rows(&self, spacing: Spacing) -> u64 {
        let per_turn = match spacing {
            Spacing::PerCycle(n) => n as f64,
            Spacing::Turns(turns) => 1.0 / turns,
        };
        // A count that is whole but for rounding is whole.
        ((self.turns * per_turn * (1.0 + 4.0 * f64::EPSILON)).floor() as u64).saturating_add(1)
    }

    /// Refuses a simulation that would take years. A slide is no longer than half a turn of the drive or of the
    /// body, so that a cycle has about 2 + 2/Ω slides.
    pub(super) fn refuse_years(&self, omega: f64) -> Outcome {
        let (typed, slides) = (&self.typed, self.cycles() as f64 * (2.0 + 2.0 / omega));
        let rows = self.spacing.map(|spacing| (spacing, self.rows(spacing) as f64));
        let (argument, count, things) = match rows {
            Some((Spacing::PerCycle(n), rows)) if rows > MOST_ROWS + 1.0 => {
                (format!("{typed} --samples {n}"), rows - 1.0, "rows")
            }
            Some((Spacing::Turns(_), rows)) if rows > MOST_ROWS + 1.0 => (typed.clone(), rows, "rows"),
            _ if slides <= MOST_ROWS => return Ok(()),
            Some(_) => (typed.clone(), slides, "slides"),
            None => (typed.clone(), slides, "rows"),
        };
        Err(format!("{argument}: about {count:.1e} {things} at Ω = {omega}, must be ≤ {MOST_ROWS:.0e}")
            .into())
    }

    /// Whether a segment that begins at this phase is shown.
    pub(super) fn contains<F: Value>(&self, phase: DrivePhase<F>, start: DrivePhase<F>) -> bool {
        phase.since(start).to_f64() / TAU < self.turns
    }
}

#[cfg(test)]
mod tests {
    use super::{Extent, Spacing};

    /// The limit is ten thousand million rows or slides; a cycle has 2 + 2/Ω slides.
    #[test]
    fn a_run_of_years_is_refused() {
        for (cycles, samples, omega, words) in [
            (1_666_666_666_u32, None, 0.5, None),
            (1_666_666_667, None, 0.5, Some("rows")),
            (2_500_000_000, None, 1.0, None),
            (2_500_000_001, None, 1.0, Some("rows")),
            (4_000_000_000, None, 4.0, None),
            (4_000_000_001, None, 4.0, Some("rows")),
            (100_000_000, Some(100), 1.0, None),
            (100_000_001, Some(100), 1.0, Some("rows")),
            (2_500_000_001, Some(1), 1.0, Some("slides")),
            (2_500_000_000, Some(1), 1.0, None),
        ] {
            let spacing = samples.map(Spacing::PerCycle);
            let extent = Extent { turns: f64::from(cycles), typed: String::new(), spacing };
            let found = extent.refuse_years(omega).err().map(|failure| failure.to_string());
            match words {
                None => assert!(found.is_none(), "{cycles} {samples:?} {omega}: {found:?}"),
                Some(words) => {
                    assert!(found.as_ref().is_some_and(|f| f.contains(words)), "{cycles}: {found:?}")
                }
            }
        }
    }
}
