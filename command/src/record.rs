//! Answers as records: one list of names and values, written as JSON or CSV.

mod cell;
mod written;

use crate::bits::Value;
use crate::failure::{Failure, Outcome};
use crate::input::BorderScales;
use crate::machine::Machine;
use crate::physical::Physical;
use serde::ser::{Serialize, SerializeMap, Serializer};
use stickslip::units::Kind;
use stickslip::{NoStop, Ratios, Response};

pub(crate) use cell::Cell;

/// The text of some rows of CSV.
pub(crate) fn csv_text(
    fill: impl FnOnce(&mut csv::Writer<&mut Vec<u8>>) -> Outcome,
) -> Result<Vec<u8>, Failure> {
    let mut text = Vec::new();
    {
        let mut writer = csv::WriterBuilder::new().buffer_capacity(1 << 10).from_writer(&mut text);
        fill(&mut writer)?;
        writer.flush()?;
    }
    Ok(text)
}

/// The name of an output in the machine's units.
fn physical_name(wanted: &str) -> &str {
    wanted.strip_prefix("physical.").unwrap_or(wanted)
}

/// The outputs that need a search, or another cycle, of their own.
pub(crate) const PEAKS: [&str; 4] =
    ["max_acceleration", "transmitted_force", "transmissibility", "max_absolute_displacement"];

/// Named values in order, and those in physical units.
#[derive(Debug)]
pub(crate) struct Record<F> {
    pub(crate) fields: Vec<(&'static str, Cell<F>)>,
    pub(crate) physical: Physical<F>,
}

impl<F: Value> Serialize for Record<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, cell) in &self.fields {
            map.serialize_entry(name, cell)?;
        }
        let beside = self.physical.values_beside();
        for (name, _, cell) in beside {
            map.serialize_entry(name, cell)?;
        }
        if beside.is_empty() && !self.physical.is_empty() {
            map.serialize_entry("physical", &self.physical)?;
        }
        map.end()
    }
}

impl<F: Value> Record<F> {
    /// All outputs of a response; `None` for outputs that the regime does not have, and for the peaks if they
    /// are not requested.
    pub(crate) fn of_response(response: &Response<F>, peaks: bool) -> Self {
        let (ratios, border, cycle) = (response.ratios, response.border, response.cycle.as_ref());
        let of_cycle = |value: fn(&stickslip::Cycle<F>) -> F| Cell::Number(cycle.map(value));
        let peak = |value: fn(&stickslip::Cycle<F>) -> F| Cell::Number(cycle.filter(|_| peaks).map(value));
        Self {
            fields: vec![
                ("omega", Cell::Number(Some(ratios.omega()))),
                ("alpha", Cell::Number(Some(ratios.alpha()))),
                ("regime", Cell::Text(response.regime.name())),
                ("max_displacement", of_cycle(|c| c.max_displacement)),
                ("displacement_phase", of_cycle(|c| c.displacement_phase)),
                ("max_velocity", of_cycle(|c| c.max_velocity)),
                ("velocity_phase", of_cycle(|c| c.velocity_phase)),
                ("deviation", of_cycle(|c| c.deviation())),
                ("min_force_ratio", Cell::Number(Some(border.min_force_ratio))),
                ("min_force_ratio_turning_point", Cell::Number(Some(border.turning_point))),
                ("loop_size_stiffness", Cell::Number(response.loop_size_stiffness)),
                ("loop_size_inertia", Cell::Number(response.loop_size_inertia)),
                ("best_force_ratio", Cell::Number(Some(response.best_force_ratio))),
                ("best_loop_size", Cell::Number(response.best_loop_size)),
                ("contraction", of_cycle(|c| c.contraction())),
                ("reversals_per_cycle", Cell::Count(response.reversals_per_cycle().map(u64::from))),
                ("best_force_ratio_slides", Cell::Flag(Some(response.best_is_reached()))),
                ("dynamic_amplification", of_cycle(|c| c.max_displacement / c.ratios.alpha())),
                ("max_acceleration", peak(|c| c.max_acceleration())),
                ("transmitted_force", peak(|c| c.transmitted_force())),
                ("transmissibility", peak(|c| c.transmitted_force() / c.ratios.alpha())),
                ("max_absolute_displacement", peak(|c| c.max_absolute_displacement())),
            ],
            physical: Physical::default(),
        }
    }

    /// Adds ζ after the other ratios, and the work of the damper in a cycle.
    pub(crate) fn with_damping(mut self, response: &Response<F>) -> Self {
        self = self.with_damping_ratio(response.ratios.damping_ratio());
        if self.fields.iter().any(|(name, _)| *name == "alpha") {
            let work = response.cycle.as_ref().map(stickslip::Cycle::damper_work);
            self.fields.push(("damper_work", Cell::Number(work)));
        }
        self
    }

    /// Adds ζ after the other ratios.
    pub(crate) fn with_damping_ratio(mut self, damping_ratio: F) -> Self {
        let is_ratio = |(name, _): &(&'static str, Cell<F>)| matches!(*name, "omega" | "alpha");
        let place = self.fields.iter().take_while(|field| is_ratio(field)).count();
        self.fields.insert(place, ("damping_ratio", Cell::Number(Some(damping_ratio))));
        self
    }

    /// Adds η after the other ratios, and after the regime whether a motion without a stop exists and whether a
    /// body at rest is released.
    pub(crate) fn with_static_friction(self, response: &Response<F>) -> Self {
        let mut record = self.with_static_friction_ratio(response.ratios.static_friction_ratio());
        let place = record.fields.iter().take_while(|(name, _)| *name != "regime").count();
        let statements = [
            ("motion_without_stop", Cell::Flag(Some(response.has_motion_without_stop()))),
            ("moves_from_rest", Cell::Flag(Some(response.ratios.moves_from_rest()))),
        ];
        record.fields.splice(place + 1..place + 1, statements);
        record
    }

    /// Adds η after the other ratios.
    pub(crate) fn with_static_friction_ratio(mut self, static_friction_ratio: F) -> Self {
        let is_ratio =
            |(name, _): &(&'static str, Cell<F>)| matches!(*name, "omega" | "alpha" | "damping_ratio");
        let place = self.fields.iter().take_while(|field| is_ratio(field)).count();
        self.fields.insert(place, ("static_friction_ratio", Cell::Number(Some(static_friction_ratio))));
        self
    }

    /// Whether there is an output of this name: a field, or in the machine's units `physical.NAME`,
    /// `NAME[unit]`, or NAME where no field has that name.
    pub(crate) fn has(&self, wanted: &str) -> bool {
        self.fields.iter().any(|(name, _)| *name == wanted) || self.physical.has(physical_name(wanted))
    }

    /// The names of all outputs.
    pub(crate) fn output_names(&self) -> Vec<String> {
        let own = self.fields.iter().map(|(name, _)| (*name).to_owned());
        own.chain(self.physical.values.iter().map(|(name, ..)| format!("physical.{name}"))).collect()
    }

    /// Only these outputs, in this order, with those in the machine's units last.
    pub(crate) fn only(mut self, wanted: &[String]) -> Self {
        let field = |wanted: &String| self.fields.iter().find(|(name, _)| name == wanted).copied();
        let fields: Vec<_> = wanted.iter().filter_map(field).collect();
        let is_field = |wanted: &String| fields.iter().any(|(name, _)| name == wanted);
        let physical = wanted.iter().filter(|w| !is_field(w)).map(|w| physical_name(w));
        self.physical = self.physical.only(physical);
        self.fields = fields;
        self
    }

    /// The border at Ω and the best force ratio there, from a response at any α.
    pub(crate) fn of_border(response: &Response<F>) -> Self {
        let border = response.border;
        Self {
            fields: vec![
                ("omega", Cell::Number(Some(response.ratios.omega()))),
                ("min_force_ratio", Cell::Number(Some(border.min_force_ratio))),
                ("min_force_ratio_turning_point", Cell::Number(Some(border.turning_point))),
                ("border_phase", Cell::Number(Some(border.touching_phase))),
                ("least_displacement", Cell::Number(Some(border.min_displacement))),
                ("best_force_ratio", Cell::Number(Some(response.best_force_ratio))),
            ],
            physical: Physical::default(),
        }
    }

    /// Adds the force ratios without any stop.
    pub(crate) fn with_no_stop(mut self, no_stop: &NoStop<F>) -> Self {
        self.fields.push(("no_stop_force_ratios", Self::intervals(no_stop)));
        self
    }

    /// The intervals as a value.
    pub(crate) fn intervals(no_stop: &NoStop<F>) -> Cell<F> {
        let mut intervals = no_stop.intervals();
        Cell::Intervals([intervals.next(), intervals.next()])
    }

    /// Adds the loads on the surroundings of this machine. The fields are those for a force, or for a base
    /// that carries the surface.
    pub(crate) fn felt_around(mut self, machine: &Machine<F>) -> Self {
        if !machine.drive.excitation().moves_foot() {
            return self;
        }
        let number = |name: &str| match self.fields.iter().find(|(own, _)| *own == name) {
            Some((_, Cell::Number(value))) => *value,
            Some(_) | None => None,
        };
        let felt = number("omega").zip(number("alpha")).zip(number("max_acceleration"));
        let (none, zeta) = (F::int(0), machine.oscillator.damping_ratio());
        let felt = felt.and_then(|((omega, alpha), a)| {
            let ratios = Ratios::new(omega, alpha).and_then(|ratios| ratios.with_damping_ratio(zeta)).ok()?;
            Some(machine.drive.excitation().transmitted(&ratios, none, a))
        });
        let least = number("min_displacement").map_or(F::int(0), F::abs);
        let amplitude = number("max_displacement").map(|most| most.abs().or_larger(least));
        for (name, cell) in &mut self.fields {
            match *name {
                "transmitted_force" => *cell = Cell::Number(felt.map(|(force, _)| force)),
                "transmissibility" => *cell = Cell::Number(felt.map(|(_, ratio)| ratio)),
                "max_absolute_displacement" if felt.is_some() => *cell = Cell::Number(amplitude),
                _ => {}
            }
        }
        self
    }

    /// Adds the machine and the answer in its units; both loop sizes are the energy of a cycle.
    pub(crate) fn with_machine(self, machine: &Machine<F>) -> Self {
        let mut record = self.felt_around(machine);
        record.physical = record.in_units(machine);
        record
    }

    fn in_units(&self, machine: &Machine<F>) -> Physical<F> {
        let (scales, carried) = (&machine.scales, machine.drive.excitation().carries_surface());
        let best = self.fields.iter().find(|(name, _)| *name == "best_force_ratio").map(|(_, cell)| *cell);
        let best_force = match best {
            Some(Cell::Number(Some(ratio))) => ratio * scales.force,
            _ => F::int(0),
        };
        // The energy of the largest loop: A₁ is stated in units of p₀²/(2k) for that force.
        let best_energy = F::ratio(1, 2) * best_force * (best_force / machine.oscillator.stiffness());
        Physical::of_machine(machine).with(&self.fields, |name| match name {
            "max_displacement" => Some(("max_displacement", Kind::Length, scales.length)),
            "displacement_phase" => Some(("displacement_time", Kind::Time, scales.time)),
            "max_velocity" => Some(("max_velocity", Kind::Velocity, scales.velocity)),
            "velocity_phase" => Some(("velocity_time", Kind::Time, scales.time)),
            "deviation" => Some(("deviation", Kind::Length, scales.length)),
            "max_acceleration" => {
                Some(("max_acceleration", Kind::Acceleration, scales.velocity / scales.time))
            }
            "transmitted_force" => Some(("transmitted_force", Kind::Force, scales.force)),
            "max_absolute_displacement" if carried => {
                Some(("max_absolute_displacement", Kind::Length, scales.length))
            }
            "min_force_ratio" => Some(("min_force", Kind::Force, scales.force)),
            "min_force_ratio_turning_point" => Some(("min_force_turning_point", Kind::Force, scales.force)),
            "loop_size_stiffness" => Some(("energy_per_cycle", Kind::Energy, scales.energy_stiffness)),
            "damper_work" if !machine.has_damped_foot() => {
                Some(("damper_energy_per_cycle", Kind::Energy, scales.force * scales.length))
            }
            "best_force_ratio" => Some(("best_force", Kind::Force, scales.force)),
            "best_loop_size" => Some(("best_force_energy", Kind::Energy, best_energy)),
            _ => None,
        })
    }

    /// The border in the machine's units.
    pub(crate) fn with_border_scales(mut self, scales: &BorderScales<F>) -> Self {
        self.physical = Physical::of_border(scales).with(&self.fields, |name| match name {
            "min_force_ratio" => Some(("min_force", Kind::Force, scales.force)),
            "min_force_ratio_turning_point" => Some(("min_force_turning_point", Kind::Force, scales.force)),
            "border_phase" => Some(("border_time", Kind::Time, scales.time)),
            "least_displacement" => Some(("least_displacement", Kind::Length, scales.length)),
            "best_force_ratio" => Some(("best_force", Kind::Force, scales.force)),
            "no_stop_force_ratios" => Some(("no_stop_forces", Kind::Force, scales.force)),
            _ => None,
        });
        self
    }

    /// The record, if all its numbers are finite. In units that are too small a motion overflows to infinity,
    /// which JSON does not have.
    pub(crate) fn finite(self) -> Result<Self, Failure> {
        let physical = self.physical.values.iter().map(|&(name, _, cell)| (name, cell));
        self.fields.iter().copied().chain(physical).try_for_each(|(name, cell)| cell.finite(name))?;
        Ok(self)
    }
}
