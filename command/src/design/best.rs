//! `stickslip design dissipation` and `stiffness`: the optimum, and the reason why it is one.

use super::{AskedDesign, DesignAnswer, searched_field, some};
use crate::bits::{Value, digits};
use crate::failure::Failure;
use crate::row::Cell;
use stickslip::Error;
use stickslip::design::{self, BoundedOptimum, Optimum, OptimumKind};
use stickslip_front::inputs::Input;
use stickslip_front::inputs::units::Kind;

/// An optimum, with the bound on every other value if it is one of all motions.
struct Best<F> {
    at: F,
    value: F,
    bound: Option<F>,
    kind: OptimumKind,
}

impl<F> From<Optimum<F>> for Best<F> {
    fn from(Optimum { at, value, kind, .. }: Optimum<F>) -> Self {
        Self { at, value, bound: None, kind }
    }
}

impl<F> From<BoundedOptimum<F>> for Best<F> {
    fn from(BoundedOptimum { at, value, bound, kind, .. }: BoundedOptimum<F>) -> Self {
        Self { at, value, bound: Some(bound), kind }
    }
}

impl<F: Value> AskedDesign<'_, F> {
    /// The force ratio or the friction that dissipates most; with sticking allowed by exact motions, with a bound on the
    /// dissipation at any friction.
    pub(super) fn dissipation(&self) -> Result<DesignAnswer<F>, Failure> {
        let tolerance = F::ratio(1, 1_000_000);
        if !self.physical {
            let (omega, zeta) = (self.omega()?, self.damping_ratio());
            let best = if self.args.sticking {
                design::most_dissipating_force_ratio_of_all(omega, zeta, tolerance).map(Best::from)
            } else {
                design::most_dissipating_force_ratio(omega, zeta).map(Best::from)
            };
            return self.best(best, ["force_ratio", "loop_size_stiffness"], |best| at('α', best));
        }
        let body = self.body(true, false)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let best = if self.args.sticking {
            design::most_dissipating_friction_of_all(&body, &drive, tolerance).map(Best::from)
        } else {
            design::most_dissipating_friction(&body, &drive).map(Best::from)
        };
        self.best(best, ["friction", "energy"], |best| {
            let force = self.system().force();
            format!("with a friction force of {} {force}: {}", digits(best.at), self.energy(best))
        })
    }

    pub(super) fn stiffness(&self) -> Result<DesignAnswer<F>, Failure> {
        let (low, high) = self.range(Kind::Stiffness)?;
        if !self.physical {
            let best = design::most_dissipating_frequency_ratio(self.alpha()?, low..=high).map(Best::from);
            return self.best(best, ["omega", "loop_size_inertia"], |best| at('Ω', best));
        }
        if self.given.has(Input::DampingRatio) {
            let text = "--damping-ratio: changes with the stiffness that is asked for. Give the damping constant by \
                --damping";
            return Err(text.into());
        }
        let body = self.body(false, true)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let best = design::most_dissipating_stiffness(&body, &drive, low..=high).map(Best::from);
        let searched = body.damping() > F::int(0);
        let by = if searched { " (by a search that is not a proof)" } else { "" };
        let mut answer = self.best(best, ["stiffness", "energy"], |best| {
            let unit = self.system().name(Kind::Stiffness);
            format!("with a stiffness of {} {unit}{by}: {}", digits(best.at), self.energy(best))
        })?;
        if searched {
            answer.rows.iter_mut().for_each(|row| row.push(searched_field()));
        }
        Ok(answer)
    }

    fn energy(&self, best: &Best<F>) -> String {
        format!("{} {}·{} a cycle", digits(best.value), self.system().force(), self.system().length())
    }

    /// The optimum: its place in words, its fields, and the reason for it.
    fn best(
        &self,
        found: Result<Best<F>, Error>,
        [at, value]: [&'static str; 2],
        place: impl FnOnce(&Best<F>) -> String,
    ) -> Result<DesignAnswer<F>, Failure> {
        let best = found.map_err(|e| self.fail(e))?;
        let of_all = if best.bound.is_some() { " of all motions" } else { "" };
        let (name, why) = match best.kind {
            OptimumKind::Interior => ("interior", "an interior maximum"),
            OptimumKind::Border => ("border", "at the sticking threshold"),
            OptimumKind::RangeEnd => ("end-of-range", "at the end of the range"),
            OptimumKind::Sticking => ("sticking", "where it sticks, by the exact motion"),
            // The library may add kinds.
            _ => ("other", "by the motion itself"),
        };
        let [at_kind, kind] = match at {
            "friction" => [Kind::Force, Kind::Energy],
            "stiffness" => [Kind::Stiffness, Kind::Energy],
            _ => [Kind::Ratio; 2],
        };
        let mut fields = vec![(at, at_kind, some(best.at)), (value, kind, some(best.value))];
        fields.extend(best.bound.map(|bound| ("bound", kind, some(bound))));
        fields.push(("optimum", Kind::Ratio, Cell::Text(name)));
        let sentence = format!("Dissipation is greatest{of_all} {}, {why}.", place(&best));
        Ok(DesignAnswer::one(sentence, fields))
    }
}

/// The place of an optimum in ratios.
fn at<F: Value>(symbol: char, best: &Best<F>) -> String {
    format!("at {symbol} = {}", digits(best.at))
}
