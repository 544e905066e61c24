//! `stickslip design dissipation` and `stiffness`: the optimum, and the reason why it is one.

use super::{AnswerRow, AskedDesign, DesignAnswer, searched_field, some};
use crate::bits::{Value, digits};
use crate::failure::Failure;
use crate::record::Cell;
use stickslip::design::{self, OptimumKind};
use stickslip::inputs::Input;
use stickslip::inputs::units::Kind;

impl<F: Value> AskedDesign<'_, F> {
    pub(super) fn dissipation(&self) -> Result<DesignAnswer<F>, Failure> {
        if self.args.sticking {
            return self.dissipation_of_all();
        }
        if !self.physical {
            let (omega, zeta) = (self.omega()?, self.damping_ratio());
            let best = design::most_dissipating_force_ratio(omega, zeta).map_err(|e| self.fail(e))?;
            let size = ("loop_size_stiffness", Kind::Ratio, best.value);
            return Ok(best_ratio("", 'α', ("force_ratio", Kind::Ratio, best.at), size, None, best.kind));
        }
        let body = self.body(true, false)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let best = design::most_dissipating_friction(&body, &drive).map_err(|e| self.fail(e))?;
        let place = self.friction_of(best.at);
        Ok(self.best("", &place, ("friction", Kind::Force, best.at), best.value, None, best.kind))
    }

    /// The friction that dissipates most with sticking allowed, by exact motions, with a bound on the
    /// dissipation at any friction.
    fn dissipation_of_all(&self) -> Result<DesignAnswer<F>, Failure> {
        let tolerance = F::ratio(1, 1_000_000);
        if !self.physical {
            let (omega, zeta) = (self.omega()?, self.damping_ratio());
            let best = design::most_dissipating_force_ratio_of_all(omega, zeta, tolerance);
            let best = best.map_err(|e| self.fail(e))?;
            let (at, bound) = (("force_ratio", Kind::Ratio, best.at), Some(best.bound));
            return Ok(best_ratio(
                " of all motions",
                'α',
                at,
                ("loop_size_stiffness", Kind::Ratio, best.value),
                bound,
                best.kind,
            ));
        }
        let body = self.body(true, false)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let best = design::most_dissipating_friction_of_all(&body, &drive, tolerance);
        let best = best.map_err(|e| self.fail(e))?;
        let place = self.friction_of(best.at);
        let at = ("friction", Kind::Force, best.at);
        Ok(self.best(" of all motions", &place, at, best.value, Some(best.bound), best.kind))
    }

    pub(super) fn stiffness(&self) -> Result<DesignAnswer<F>, Failure> {
        let (low, high) = self.range(Kind::Stiffness)?;
        if !self.physical {
            let best = design::most_dissipating_frequency_ratio(self.alpha()?, low, high);
            let best = best.map_err(|e| self.fail(e))?;
            return Ok(best_ratio(
                "",
                'Ω',
                ("omega", Kind::Ratio, best.at),
                ("loop_size_inertia", Kind::Ratio, best.value),
                None,
                best.kind,
            ));
        }
        if self.given.has(Input::DampingRatio) {
            let text = "--damping-ratio: changes with the stiffness that is asked for. Give the damping constant by \
                --damping";
            return Err(Failure::Input(text.to_owned()));
        }
        let body = self.body(false, true)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let best = design::most_dissipating_stiffness(&body, &drive, low, high).map_err(|e| self.fail(e))?;
        let (force, length) = (self.system().force(), self.system().length());
        let searched = body.damping() > F::int(0);
        let by = if searched { " (by a search that is not a proof)" } else { "" };
        let place = format!("with a stiffness of {} {force}/{length}{by}", digits(best.at));
        let at = ("stiffness", Kind::Stiffness, best.at);
        let mut answer = self.best("", &place, at, best.value, None, best.kind);
        if searched {
            answer.rows.iter_mut().for_each(|row| row.push(searched_field()));
        }
        Ok(answer)
    }

    fn friction_of(&self, friction: F) -> String {
        format!("with a friction bound of {} {}", digits(friction), self.system().force())
    }

    /// The optimum in physical units: its place, its value, and the reason for the optimum.
    fn best(
        &self,
        of_all: &str,
        place: &str,
        at: (&'static str, Kind, F),
        energy: F,
        bound: Option<F>,
        optimum: OptimumKind,
    ) -> DesignAnswer<F> {
        let (force, length) = (self.system().force(), self.system().length());
        let energy_text = digits(energy);
        let sentence = format!(
            "Dissipation is greatest{of_all} {place}: {energy_text} {force}·{length} a cycle, {}.",
            why(optimum)
        );
        DesignAnswer::one(sentence, best_fields(at, ("energy", Kind::Energy, energy), bound, optimum))
    }
}

/// The optimum in ratios, at α or Ω.
fn best_ratio<F: Value>(
    of_all: &str,
    symbol: char,
    at: (&'static str, Kind, F),
    size: (&'static str, Kind, F),
    bound: Option<F>,
    optimum: OptimumKind,
) -> DesignAnswer<F> {
    let sentence =
        format!("Dissipation is greatest{of_all} at {symbol} = {}, {}.", digits(at.2), why(optimum));
    DesignAnswer::one(sentence, best_fields(at, size, bound, optimum))
}

fn best_fields<F: Value>(
    at: (&'static str, Kind, F),
    size: (&'static str, Kind, F),
    bound: Option<F>,
    optimum: OptimumKind,
) -> AnswerRow<F> {
    let mut fields = vec![(at.0, at.1, some(at.2)), (size.0, size.1, some(size.2))];
    fields.extend(bound.map(|bound| ("bound", size.1, some(bound))));
    fields.push(("optimum", Kind::Ratio, Cell::Text(name(optimum))));
    fields
}

fn name(optimum: OptimumKind) -> &'static str {
    match optimum {
        OptimumKind::Interior => "interior",
        OptimumKind::Border => "border",
        OptimumKind::RangeEnd => "end-of-range",
        OptimumKind::Sticking => "sticking",
        // The library may add kinds.
        _ => "other",
    }
}

fn why(optimum: OptimumKind) -> &'static str {
    match optimum {
        OptimumKind::Interior => "an interior maximum",
        OptimumKind::Border => "on the border of sticking",
        OptimumKind::RangeEnd => "at the end of the range",
        OptimumKind::Sticking => "where it sticks, by the exact motion",
        _ => "by the motion itself",
    }
}
