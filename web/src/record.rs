//! A record dropped on the page: the motion under it, and its spectrum.

use crate::asked::Asked;
use serde_json::{Map, Value, json};
use stickslip::Excitation;
use stickslip::inputs::units::{Kind, Reader, System};
use stickslip::inputs::{Given, Input, Role};
use stickslip::motion::record::{Body, Entry, RecordAnswer};
use stickslip_front::record::{Options, Reading, Words, follows, read};

/// The most points of a curve that is drawn.
const DRAWN: f64 = 4000.0;

/// The inputs of a body: the drive of the machine is the record.
fn body_inputs(asked: &Asked<'_>, reader: &Reader) -> Result<Given<f64>, String> {
    let mut given = asked.given(reader)?;
    for input in Input::ALL
        .into_iter()
        .filter(|input| matches!(input.role(), Role::Drive | Role::Frequency | Role::RotatingMass))
    {
        given.take(input);
    }
    Ok(given)
}

/// The record of the question, and what was read of its file.
fn load(asked: &Asked<'_>, reader: &Reader) -> Result<Reading<f64>, String> {
    let (text, name) = (asked.text("text").unwrap_or_default(), asked.text("name").unwrap_or("record"));
    let step =
        asked.text("time_step").map(|text| reader.value::<f64>("time step", text, Kind::Time)).transpose()?;
    let options = Options {
        time_step: step,
        column: asked.text("column"),
        units: asked.text("record_units"),
        ..Options::new(name, reader, Words::PAGE)
    };
    read(text.as_bytes(), &options)
}

fn answers(answer: &RecordAnswer<f64>, system: &System) -> Value {
    let rows = answer.entries().into_iter().map(|(name, kind, entry)| match entry {
        Entry::Value(value) => json!({ "name": name, "value": value, "unit": system.name(kind) }),
        Entry::Count(count) => json!({ "name": name, "value": count, "unit": "" }),
    });
    rows.collect()
}

/// The motion of the machine's body under the record, and the answers of `stickslip record`.
pub(crate) fn record(asked: &Asked<'_>) -> Result<Value, String> {
    let reader = asked.reader()?;
    let Reading { record, summary, unused } = load(asked, &reader)?;
    let given = body_inputs(asked, &reader)?;
    let body = Body::given(&given, None)?;
    let named = |e: stickslip::Error| format!("{}: {e}", asked.text("name").unwrap_or("record"));
    let answer = body.follow_from(&record, 0.0, 0.0).map_err(named)?;
    for (name, _, entry) in answer.entries() {
        if let Entry::Value(Some(value)) = entry
            && !value.is_finite()
        {
            return Err(format!(
                "{}: {name} = {value} must be finite",
                asked.text("name").unwrap_or("record")
            ));
        }
    }
    let interval = (record.end() - record.time(0)) / DRAWN;
    let motion = body.motion(&record, 0.0, 0.0, interval).map_err(named)?;
    let column = |of: fn(&stickslip::motion::record::RecordState<f64>) -> f64| -> Vec<f64> {
        motion.states.iter().map(of).collect()
    };
    let stride = (record.samples().len() as f64 / DRAWN).ceil().max(1.0) as usize;
    let samples = record.samples().iter().enumerate().step_by(stride);
    let (times, samples): (Vec<f64>, Vec<f64>) =
        samples.map(|(index, value)| (record.time(index), *value)).unzip();
    let system = given.system;
    let load_unit = match record.excitation() {
        Excitation::Force => system.name(Kind::Force),
        Excitation::SurfaceAcceleration => system.name(Kind::Acceleration),
        _ => system.name(Kind::Length),
    };
    let rests: Vec<bool> = motion.states.iter().map(|state| state.direction == 0).collect();
    Ok(json!({
        "values": answers(&answer, &system),
        "time": column(|state| state.time), "displacement": column(|state| state.displacement),
        "velocity": column(|state| state.velocity), "rest": rests,
        "force": column(|state| state.transmitted_force),
        "load": { "time": times, "value": samples, "unit": load_unit },
        "units": { "displacement": system.name(Kind::Length), "velocity": system.name(Kind::Velocity),
            "force": system.name(Kind::Force) },
        "unused": unused, "channel": summary.channel, "follows": follows(&record),
        "read": summary.sentence(stickslip::words::digits),
    }))
}

/// The answers of bodies like the machine's with the natural periods `periods` in s, as `stickslip spectrum` gives them.
pub(crate) fn spectrum(asked: &Asked<'_>) -> Result<Value, String> {
    let reader = asked.reader()?;
    let record = load(asked, &reader)?.record;
    let mut given = body_inputs(asked, &reader)?;
    for input in Input::of_role(Role::Spring) {
        given.take(input);
    }
    let periods = asked.numbers("periods");
    let mut columns = Map::new();
    for &period in &periods {
        let mut given = given.clone();
        given.set(Input::Period, period);
        let answer =
            Body::given(&given, None)?.follow(&record).map_err(|e| format!("period {period}: {e}"))?;
        for (name, _, entry) in answer.entries() {
            let value = match entry {
                Entry::Value(value) => json!(value),
                Entry::Count(count) => json!(count),
            };
            if let Value::Array(column) = columns.entry(name).or_insert_with(|| json!([])) {
                column.push(value);
            }
        }
    }
    Ok(json!({ "periods": periods, "answers": columns, "unit": given.system.name(Kind::Length) }))
}
