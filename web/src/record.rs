//! A record dropped on the page: the motion under it, and its spectrum.

use crate::asked::Asked;
use serde_json::{Map, Value, json};
use stickslip::Excitation;
use stickslip::motion::record::{Body, Entry, Record, RecordAnswer, RecordState};
use stickslip_front::inputs::units::{Kind, Reader, System};
use stickslip_front::inputs::{Given, Input, Role};
use stickslip_front::record::{Channel, Options, Reading, Words, follows, read};

/// The parts of the time of a picture.
const PARTS: f64 = 1200.0;

/// The most rows of which a picture draws each.
const MOST: usize = 10_000;

/// A time and values at it.
type Row = [f64; 5];

/// The rows of a picture: all of few, and of many the first, the last, and those with an extreme of a
/// value in each part of the time.
fn drawn(rows: Vec<Row>) -> Vec<Row> {
    let [start, end] = [rows.first(), rows.last()].map(|row| row.map_or(0.0, |[time, ..]| *time));
    if rows.len() <= MOST {
        return rows;
    }
    let part = |[time, ..]: &Row| ((time - start) / (end - start) * PARTS).floor();
    let extremes = |rows: &[Row]| -> Vec<Row> {
        let mut places = vec![0, rows.len() - 1];
        for value in 1..5 {
            let of =
                |place: &usize| rows.get(*place).and_then(|row| row.get(value)).copied().unwrap_or_default();
            let order = |a: &usize, b: &usize| of(a).total_cmp(&of(b));
            places.extend((0..rows.len()).min_by(order));
            places.extend((0..rows.len()).max_by(order));
        }
        places.sort_unstable();
        places.dedup();
        places.into_iter().filter_map(|place| rows.get(place).copied()).collect()
    };
    rows.chunk_by(|a, b| part(a) == part(b)).flat_map(extremes).collect()
}

/// A column of rows.
fn column(rows: &[Row], place: usize) -> Vec<f64> {
    rows.iter().filter_map(|row| row.get(place).copied()).collect()
}

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

/// The record of the question, and what was read of its file, whose text is in a field of that name.
pub(crate) fn load(asked: &Asked<'_>, reader: &Reader, field: &str) -> Result<Reading<f64>, String> {
    let (text, name) = (asked.text(field).unwrap_or_default(), asked.text("name").unwrap_or("record"));
    let options = Options {
        time_step: asked.text("time_step"),
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

/// Time, displacement, velocity, force on the support and whether it rests, of the motion from rest.
fn rows(body: &Body<f64>, record: &Record<f64>) -> Result<Vec<Row>, stickslip::Error> {
    let interval = (record.end() - record.time(0)) / 4000.0;
    let states = body.motion(record, 0.0, 0.0, interval)?.states;
    let row = |state: RecordState<f64>| {
        let rest = f64::from(u8::from(state.direction == 0));
        [state.time, state.displacement, state.velocity, state.transmitted_force, rest]
    };
    Ok(states.into_iter().map(row).collect())
}

/// All states of the motion under the record, in columns with the names of a file.
pub(crate) fn table(asked: &Asked<'_>) -> Result<Value, String> {
    let reader = asked.reader()?;
    let record = load(asked, &reader, "text")?.record;
    let given = body_inputs(asked, &reader)?;
    let rows = rows(&given.body(None)?, &record).map_err(|e| named(asked, &e))?;
    let names = [
        ("time", Kind::Time),
        ("displacement", Kind::Length),
        ("velocity", Kind::Velocity),
        ("transmitted_force", Kind::Force),
    ];
    let columns = names.into_iter().enumerate().map(|(place, (name, kind))| {
        (format!("{name}[{}]", given.system.name(kind)), json!(column(&rows, place)))
    });
    Ok(Value::Object(columns.collect()))
}

/// An error of the motion under the file of the question.
fn named(asked: &Asked<'_>, error: &stickslip::Error) -> String {
    format!("{}: {error}", asked.text("name").unwrap_or("record"))
}

/// The motion of the machine's body under the record, and the answers of `stickslip record`.
pub(crate) fn record(asked: &Asked<'_>) -> Result<Value, String> {
    let reader = asked.reader()?;
    let reading = load(asked, &reader, "text")?;
    let unused = reading.unused.clone();
    let channel = Channel::from(reading);
    let read = channel.sentences(stickslip_front::words::digits);
    let Channel { record, summary, .. } = channel;
    let given = body_inputs(asked, &reader)?;
    let body = given.body(None)?;
    let named = |e| named(asked, &e);
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
    let rows = rows(&body, &record).map_err(named)?;
    let count = rows.len();
    let rows = drawn(rows);
    let samples =
        record.samples().iter().enumerate().map(|(index, value)| [record.time(index), *value, 0.0, 0.0, 0.0]);
    let samples = drawn(samples.collect());
    let system = given.system;
    let load_unit = match record.excitation() {
        Excitation::Force => system.name(Kind::Force),
        Excitation::SurfaceAcceleration => system.name(Kind::Acceleration),
        _ => system.name(Kind::Length),
    };
    let rests: Vec<bool> = column(&rows, 4).into_iter().map(|rest| rest > 0.0).collect();
    Ok(json!({
        "values": answers(&answer, &system),
        "comes_to": stickslip_front::record::comes_to(&answer),
        "time": column(&rows, 0), "displacement": column(&rows, 1), "velocity": column(&rows, 2),
        "force": column(&rows, 3), "rest": rests, "count": count,
        "load": { "time": column(&samples, 0), "value": column(&samples, 1), "unit": load_unit },
        "units": { "displacement": system.name(Kind::Length), "velocity": system.name(Kind::Velocity),
            "force": system.name(Kind::Force) },
        "unused": unused, "channel": summary.channel, "follows": follows(&record),
        "read": read,
    }))
}

/// The answers of bodies like the machine's with the natural periods `periods` in s, as `stickslip spectrum` gives them.
pub(crate) fn spectrum(asked: &Asked<'_>) -> Result<Value, String> {
    let reader = asked.reader()?;
    let record = load(asked, &reader, "text")?.record;
    let mut given = body_inputs(asked, &reader)?;
    for input in Input::of_role(Role::Spring) {
        given.take(input);
    }
    let periods = asked.numbers("periods");
    let mut columns = Map::new();
    for &period in &periods {
        let mut given = given.clone();
        given.set(Input::Period, period);
        let answer = given.body(None)?.follow(&record).map_err(|e| format!("period {period}: {e}"))?;
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
