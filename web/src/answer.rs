//! The answer at one point: the verdicts, the closed forms, the steady state, and the machine in its units.

use crate::asked::{Asked, Problem};
use crate::drift::Drifting;
use crate::map::place;
use serde_json::{Map, Value, json};
use stickslip::internal::{Column, ResponseAnswer, Value as Answer, When};
use stickslip::motion::{LongRun, SteadyAnswer};
use stickslip::{Definition, Drive, Measure, NoStop, Response};
use stickslip_front::inputs::units::Kind;
use stickslip_front::inputs::{Driven, Given, Input, Role};
use stickslip_front::quantities;
use stickslip_front::without::{is_of_friction, is_of_spring, needs_spring, without_friction};
use stickslip_front::words::{self, digits};

/// The answers of `stickslip response` and `stickslip steady` to the question.
pub(crate) fn answer(asked: &Asked<'_>) -> Result<Value, String> {
    if let Some(drifting) = Drifting::asked(asked)? {
        return drifting.answer();
    }
    let problem = asked.problem()?;
    let Problem { given, point, start, .. } = &problem;
    let named = |e: stickslip::Error| String::from(given.at_fault(&e));
    let response = Response::guarded(point.ratios);
    let found = ResponseAnswer { response: &response, peaks: true };
    let values = Values { problem: &problem, best: response.best_force_ratio };
    let limit = LongRun::from_start(point.ratios, *start);
    let place = place(point.ratios, &limit);
    let steady = match limit.map_err(named) {
        Ok(limit) => {
            let answer = SteadyAnswer::new(point.ratios, &limit, true).map_err(named)?;
            json!({
                "verdict": words::limit(point.ratios, &limit, |x| length(x, &problem), ""),
                "origin": words::origin(point.ratios, &limit),
                "values": values.of(&answer, SteadyAnswer::COLUMNS),
            })
        }
        Err(error) => json!({ "error": error }),
    };
    let ratios = point.ratios;
    let has_spring = !problem.is_without_spring;
    Ok(json!({
        "omega": has_spring.then(|| ratios.omega()),
        "alpha": ratios.alpha(),
        "damping_ratio": has_spring.then(|| ratios.damping_ratio()),
        "static_friction_ratio": ratios.static_friction_ratio(),
        "verdict": words::verdict(&response),
        "values": values.of(&found, ResponseAnswer::COLUMNS),
        "steady": steady,
        "place": place,
        "start": [start.x, start.v],
        "has_start": problem.has_start,
        "is_frictionless": problem.is_frictionless,
        "is_free": problem.is_free,
        "is_without_spring": problem.is_without_spring,
        "notes": notes(&problem),
        "kinds": point.machine.as_ref().map(|machine| kinds(given, machine, problem.is_without_spring)),
        "six_reversals": NoStop::of(&point.ratios).six_reversals.map(|(low, high)| [low, high]),
        "machine": point.machine.as_ref().map(|machine| of_machine(&problem.typed, machine)),
    }))
}

/// A displacement in words.
fn length(x: f64, problem: &Problem) -> String {
    let ratio = format!("{} B", digits(x));
    let Some(machine) = problem.point.machine else { return ratio };
    let value = format!("{} {}", digits(x * machine.scales.length), problem.given.system.length());
    if problem.is_without_spring { value } else { format!("{ratio} = {value}") }
}

/// The meaning of the displacement: of a moving base, and of a shifted motion.
fn notes(problem: &Problem) -> Vec<String> {
    let Problem { given, point, .. } = problem;
    let Some(machine) = &point.machine else { return Vec::new() };
    let base = words::base_motion_sentence(machine.drive.excitation());
    let mean = digits(machine.scales.mean_displacement);
    let from = if problem.is_without_spring {
        Some("Displacements are measured from the middle of the motion.".to_owned())
    } else {
        given.is_shifted().then(|| {
            format!(
                "Displacements are measured from the mean displacement of {mean} {}.",
                given.system.length()
            )
        })
    };
    base.into_iter().chain(from).collect()
}

/// The value of each kind of input that the machine could be given by instead.
pub(crate) fn kinds(given: &Given<f64>, machine: &Driven<f64>, is_without_spring: bool) -> Value {
    let system = &given.system;
    let Driven { oscillator: body, drive, ratios, .. } = machine;
    let weight = body.mass() * system.gravity::<f64>();
    let turn = 2.0 * std::f64::consts::PI;
    // That of forward motion, as it is given beside that of backward motion.
    let friction =
        given.directional_friction().ok().flatten().map_or(body.friction_bound(), |(forward, _)| forward);
    let mut all = vec![
        (Input::Stiffness, body.stiffness()),
        (Input::Period, turn / body.natural_frequency()),
        (Input::PendulumRadius, weight / body.stiffness()),
        (Input::Friction, friction),
        (Input::FrictionCoefficient, friction / weight),
        (Input::DampingRatio, ratios.damping_ratio()),
        (Input::Damping, body.damping()),
        (Input::StaticFrictionRatio, ratios.static_friction_ratio()),
        (Input::StaticFriction, ratios.static_friction_ratio() * body.friction_bound()),
    ];
    for input in Input::ALL.into_iter().filter(|input| *input != Input::Eccentricity) {
        let unit =
            input.excitation().map(|excitation| Drive::new(excitation, 1.0, drive.angular_frequency()));
        if let Some(Ok(unit)) = unit {
            all.push((input, drive.force_amplitude(body) / unit.force_amplitude(body)));
        }
    }
    let needs_spring = |input: Input| {
        input.role() == Role::Spring
            || matches!(input, Input::DampingRatio | Input::FootDisplacement | Input::DampedFootDisplacement)
    };
    let there = all.into_iter().filter(|(input, _)| !is_without_spring || !needs_spring(*input));
    let rows = there.map(|(input, value)| {
        let unit = if input.kind() == Kind::Ratio { String::new() } else { system.name(input.kind()) };
        (input.column(), json!({ "value": value, "unit": unit }))
    });
    Value::Object(rows.collect())
}

/// The machine in units, as the command has it.
pub(crate) fn of_machine(typed: &Given<f64>, machine: &Driven<f64>) -> Value {
    let rows = quantities::of_machine(typed, machine).into_iter();
    rows.map(|(own, value)| json!({"name": own.name, "value": value, "unit": typed.system.name(own.kind)}))
        .collect()
}

/// The values of an answer, with those in the machine's units.
struct Values<'a> {
    problem: &'a Problem,
    /// The force ratio of the largest loop.
    best: f64,
}

impl Values<'_> {
    fn of<A>(&self, answer: &A, columns: impl IntoIterator<Item = Column<A, f64>>) -> Value {
        let columns = columns.into_iter().filter(|column| match column.when {
            When::Always => true,
            When::Damping => self.problem.given.has_role(Role::Damper),
            When::StaticFriction => self.problem.given.has_role(Role::StaticFriction),
        });
        columns.map(|column| self.value(column.definition, (column.of)(answer))).collect()
    }

    fn value(&self, definition: &Definition, value: Answer<f64>) -> Value {
        let mut row = Map::new();
        let mut add = |name: &str, value: Value| row.insert(name.to_owned(), value);
        add("name", json!(definition.name));
        add("symbol", json!(definition.symbol));
        add("meaning", json!(definition.meaning));
        add("unit", json!(definition.measure.unit()));
        let Problem { given, point, is_frictionless, is_without_spring, .. } = self.problem;
        let value = match value {
            Answer::Number(_) if *is_without_spring && needs_spring(definition) => Answer::Number(None),
            Answer::Number(Some(x)) if *is_frictionless => {
                Answer::Number(Some(without_friction(definition.measure, x)))
            }
            value => value,
        };
        // Values in units of the friction, or of the spring, do not exist without it.
        let is_without = *is_frictionless && is_of_friction(definition.measure)
            || *is_without_spring && is_of_spring(definition.measure);
        let own = match value {
            Answer::Number(_) if is_without => Value::Null,
            Answer::Number(number) => json!(number),
            Answer::Count(count) => json!(count),
            Answer::Flag(flag) => json!(flag),
            Answer::Text(text) => json!(text),
            Answer::Pairs(pairs) => json!(pairs),
        };
        add("value", own);
        if let Answer::Number(number) = value
            && let Some(machine) = &point.machine
            && let Some(name) = definition.physical_name(machine.drive.excitation())
        {
            let unit = given.system.name(definition.measure.kind());
            let value = number.map(|number| number * self.size(definition.measure));
            add("physical", json!({ "name": name, "value": value, "unit": unit }));
        }
        Value::Object(row)
    }

    /// The size of the unit of a measure.
    fn size(&self, measure: Measure) -> f64 {
        let Some(machine) = &self.problem.point.machine else { return 1.0 };
        measure.size_with(&machine.scales, self.best, machine.oscillator.stiffness())
    }
}
