//! Quantities over time: constants, waves, shapes by name, sweeps and records, alone or in a sum.

use super::builder::Builder;
use super::described::{MOST_FREQUENCIES, MOST_RECORDS, MOST_SAMPLES, samples};
use super::node::{Fields, Node, Number, is_double, nearest};
use crate::inputs::units::Kind as Of;
use crate::record::{self, Options, Words};
use crate::text::of_bytes;
use std::io::{BufReader, Read};
use stickslip::Excitation;
use stickslip::motion::record::{After, Record as Measured};
use stickslip::system::{Beyond, Harmonic, MovedBy, Record, Signal};

/// The greatest length of the file of a table of two columns in bytes: some 50,000 rows.
const LONGEST_TABLE: u64 = 1 << 21;
/// By how much a sweep may differ from the straight lines between its samples, in parts of its amplitude.
const TOLERANCE: f64 = 1e-5;

/// Why a sweep has no more digits than a double.
const OF_DOUBLES: &str = "must be left out with more bits than a double has: its straight lines differ from the sweep by a part of its amplitude";

/// The fields of a record beside its file.
const OPTIONS: [&str; 12] = [
    "column",
    "scale",
    "from",
    "to",
    "units",
    "time_step",
    "time_column",
    "skip",
    "remove_mean",
    "resample",
    "repeats",
    "after",
];

/// The fields of a wave beside its amplitude.
const WAVE: [&str; 5] = ["frequency", "phase", "shape", "duty", "sweep"];

/// What a table of a quantity over time needs.
pub(super) const NEEDS: &str = "needs one of amplitude with frequency, constant, waves, and record";

/// The factor of an entry, 0 where a list ends early.
pub(super) fn at<F: Number>(list: &[F], i: usize) -> F {
    list.get(i).copied().unwrap_or(F::int(0))
}

/// Adds to an entry of a list, which grows to it.
fn add_at<F: Number>(list: &mut Vec<F>, i: usize, by: F) {
    list.resize(list.len().max(i.saturating_add(1)), F::int(0));
    if let Some(place) = list.get_mut(i) {
        *place = *place + by;
    }
}

/// Adds a signal with a factor.
pub(super) fn add<F: Number>(to: &mut Signal<F>, factor: F, signal: &Signal<F>) {
    to.constant = to.constant + factor * signal.constant;
    let lists = [
        (&mut to.sin, &signal.sin),
        (&mut to.cos, &signal.cos),
        (&mut to.records, &signal.records),
        (&mut to.rates, &signal.rates),
    ];
    for (to, from) in lists {
        from.iter().enumerate().for_each(|(i, &by)| add_at(to, i, factor * by));
    }
}

impl<F: Number> Builder<'_, F> {
    /// A quantity over time: a quantity, a table of its parts, or a list of both, whose sum it is.
    pub(super) fn signal(&mut self, node: &Node<'_>, kind: Of) -> Result<Signal<F>, String> {
        if node.value().is_array() {
            let mut sum = Signal::constant(F::int(0));
            for part in node.list()? {
                add(&mut sum, F::int(1), &self.signal(&part, kind)?);
            }
            return Ok(sum);
        }
        if !node.value().is_object() {
            return Ok(Signal::constant(node.constant(kind)?));
        }
        let fields = node.fields()?;
        let found = self.signal_of(&fields, kind, &[])?;
        fields.end()?;
        found.ok_or_else(|| fields.node.wrong(NEEDS))
    }

    /// The sum of the parts in a table: `constant`, a wave, `waves` and a record; none where it has none of them. The table may have
    /// these other fields.
    pub(super) fn signal_of(
        &mut self,
        fields: &Fields<'_>,
        kind: Of,
        others: &[&'static str],
    ) -> Result<Option<Signal<F>>, String> {
        let mut sum = None;
        if fields.get("amplitude").is_none()
            && let Some(node) = WAVE.iter().filter_map(|name| fields.get(name)).reduce(|first, _| first)
        {
            // A misspelt name says more than a missing one.
            fields.end_with(&["constant", "waves", "file", "record"])?;
            fields.end_with(others)?;
            return Err(node.wrong("needs an amplitude"));
        }
        let mut plus = |signal: &Signal<F>| {
            add(sum.get_or_insert_with(|| Signal::constant(F::int(0))), F::int(1), signal)
        };
        if let Some(node) = fields.get("constant") {
            plus(&Signal::constant(node.quantity(kind)?));
        }
        if fields.get("amplitude").is_some() {
            plus(&self.wave(fields, kind)?);
        }
        if let Some(node) = fields.get("waves") {
            for wave in node.list()? {
                plus(&self.signal(&wave, kind)?);
            }
        }
        match (fields.get("file"), fields.get("record")) {
            (Some(_), Some(node)) => {
                return Err(node.wrong("must be left out beside file, which is the same"));
            }
            (Some(node), None) | (None, Some(node)) => plus(&self.recorded(&node, fields, kind)?),
            (None, None) => without_options(fields)?,
        }
        Ok(sum)
    }

    /// The place of a frequency among the harmonics, to which it is added where it is new.
    fn harmonic(&mut self, node: &Node<'_>) -> Result<usize, String> {
        let frequency = frequency(node)?;
        let (n, harmonics) = (self.names.len(), &mut self.model.harmonics);
        if let Some(place) = harmonics.iter().position(|harmonic| harmonic.frequency == frequency) {
            return Ok(place);
        }
        let place = harmonics.len();
        if place == MOST_FREQUENCIES {
            return Err(node.wrong(&format!("must be one of ≤ {MOST_FREQUENCIES} frequencies in the file")));
        }
        harmonics.push(Harmonic { frequency, sin: vec![F::int(0); n], cos: vec![F::int(0); n] });
        Ok(place)
    }

    /// A wave `{ amplitude, frequency, phase, shape, duty }`, or `{ amplitude, sweep }`.
    fn wave(&mut self, fields: &Fields<'_>, kind: Of) -> Result<Signal<F>, String> {
        let mut signal = Signal::constant(F::int(0));
        let node = fields.required("amplitude")?;
        let amplitude: F = node.quantity(kind)?;
        if let Some(sweep) = fields.get("sweep") {
            for name in ["frequency", "phase", "shape", "duty"] {
                if let Some(node) = fields.get(name) {
                    return Err(node.wrong("must be left out beside sweep"));
                }
            }
            if !is_double::<F>() {
                return Err(sweep.wrong(OF_DOUBLES));
            }
            let record = swept(&sweep, amplitude.to_f64())?;
            add_at(&mut signal.records, self.add_record(&sweep, record)?, F::int(1));
            return Ok(signal);
        }
        let shape = fields.get("shape");
        let name = shape.as_ref().map_or(Ok("sine"), Node::text)?;
        let phase: F = fields.quantity_or("phase", Of::Angle, 0)?;
        let duty = fields.get("duty");
        let names = ["sine", "square", "triangle", "sawtooth", "pulse"];
        if let Some(node) = shape.as_ref().filter(|_| !names.contains(&name)) {
            return Err(node.wrong(&format!("is unknown. {}", nearest(name, names.into_iter()))));
        }
        if let Some(node) = duty.as_ref().filter(|_| !["square", "pulse"].contains(&name)) {
            return Err(
                node.wrong("needs the shape square or pulse, of whose period it is the part that is up")
            );
        }
        let duty = match duty {
            Some(node) => match node.number()? {
                part if part > F::int(0) && part < F::int(1) => part,
                _ => return Err(node.wrong("must be > 0 and < 1")),
            },
            None => F::ratio(1, 2),
        };
        let of_frequency = fields.required("frequency")?;
        // Points of one period, from 0 to 1, of the amplitude 1.
        let (zero, one) = (F::int(0), F::int(1));
        let points: &[(F, F)] = match name {
            "sine" => {
                let place = self.harmonic(&of_frequency)?;
                let (sine, cosine) = phase.sin_cos();
                add_at(&mut signal.sin, place, amplitude * cosine);
                add_at(&mut signal.cos, place, amplitude * sine);
                return Ok(signal);
            }
            "square" => &[(zero, one), (duty, one), (duty, -one), (one, -one)],
            "pulse" => &[(zero, one), (duty, one), (duty, zero), (one, zero)],
            "triangle" => &[(zero, zero), (F::ratio(1, 4), one), (F::ratio(3, 4), -one), (one, zero)],
            _ => &[(zero, -one), (one, one)],
        };
        let turn = F::int(2) * F::pi();
        let period = turn / frequency(&of_frequency)?;
        // It begins in the period that the time 0 is in.
        let turns = phase / turn;
        let begin = -((turns - turns.floor()) * period);
        let record = Record {
            times: points.iter().map(|&(part, _)| begin + part * period).collect(),
            values: points.iter().map(|&(_, value)| amplitude * value).collect(),
            force: vec![zero; self.names.len()],
            beyond: Beyond::Repeat,
        };
        add_at(&mut signal.records, self.add_record(&of_frequency, record)?, one);
        Ok(signal)
    }

    /// The record of a file with the options in the same table, or of a table of its own.
    fn recorded(&mut self, node: &Node<'_>, beside: &Fields<'_>, kind: Of) -> Result<Signal<F>, String> {
        if node.value().is_object() {
            let own = node.fields()?;
            let file = own.required("file")?;
            let found = self.recorded(&file, &own, kind)?;
            own.end()?;
            return Ok(found);
        }
        let record = self.measured(node, beside, kind)?;
        let mut signal = Signal::constant(F::int(0));
        add_at(&mut signal.records, self.add_record(node, record)?, F::int(1));
        Ok(signal)
    }

    /// A record as the commands `record` read it, with their options.
    fn measured(&self, node: &Node<'_>, fields: &Fields<'_>, kind: Of) -> Result<Record<F>, String> {
        let reader = node.reader();
        let file = self.folder.path(node.text()?);
        let name = file.display().to_string();
        let text = |name: &'static str| fields.get(name).map(|node| shown(&node));
        let [time_step, time_column, column, from, to, remove_mean, resample] =
            ["time_step", "time_column", "column", "from", "to", "remove_mean", "resample"].map(text);
        let units = fields.get("units").map(|node| node.text()).transpose()?;
        let is_load = [Of::Acceleration, Of::Force].contains(&kind);
        let options = Options {
            quantity: (!is_load).then_some(kind),
            time_step: time_step.as_deref(),
            time_column: time_column.as_deref(),
            column: column.as_deref(),
            skip: fields.get("skip").map_or(Ok(0), |node| {
                node.value().as_u64().ok_or_else(|| node.wrong("must be a whole number ≥ 0"))
            })?,
            units,
            from: from.as_deref(),
            to: to.as_deref(),
            remove_mean: remove_mean.as_deref(),
            resample: resample.as_deref(),
            ..Options::new(&name, reader, WORDS)
        };
        let about = |e: String| format!("{}: {e}", node.place());
        let opened = self.folder.open(&file).map_err(|e| about(format!("{name}: {e}")))?;
        let found: Measured<F> = record::read(BufReader::new(opened), &options).map_err(about)?.record;
        let due = if kind == Of::Force { Excitation::Force } else { Excitation::SurfaceAcceleration };
        if is_load && found.excitation() != due {
            return Err(node.wrong(&format!("must be a record of {}", due.name())));
        }
        let Record { times, values, .. } = samples(&found, Beyond::Zero);
        // A velocity ends with its record, and a displacement stays.
        finished(fields, times, values, kind != Of::Velocity && found.after() == After::Hold)
    }

    /// The first two columns of a CSV file: a law.
    pub(super) fn columns(&self, node: &Node<'_>, kinds: [Of; 2]) -> Result<Vec<(F, F)>, String> {
        let file = self.folder.path(node.text()?);
        let name = file.display().to_string();
        let bad = |e: &dyn std::fmt::Display| format!("{}: {name}: {e}", node.place());
        let mut bytes = Vec::new();
        let source = self.folder.open(&file).map_err(|e| bad(&e))?;
        source.take(LONGEST_TABLE.saturating_add(1)).read_to_end(&mut bytes).map_err(|e| bad(&e))?;
        if bytes.len() as u64 > LONGEST_TABLE {
            return Err(bad(&format!("must be ≤ {LONGEST_TABLE} bytes")));
        }
        let text = of_bytes(bytes).map_err(|e| bad(&e))?;
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
        let header = reader.headers().map_err(|e| bad(&e))?.clone();
        let names: Vec<(&str, Option<&str>)> = header.iter().map(crate::names::name_and_unit).collect();
        if names.len() < 2 {
            let first = if kinds[0] == Of::Velocity { "speed" } else { "displacement" };
            return Err(bad(&format!("must have the columns {first} and force")));
        }
        let mut points = Vec::new();
        for (line, row) in reader.records().enumerate() {
            let row = row.map_err(|e| bad(&e))?;
            let value = |place: usize, kind: Of| {
                let unit = names.get(place).and_then(|(_, unit)| *unit).unwrap_or("");
                let text = format!("{}{unit}", row.get(place).unwrap_or(""));
                let at = format!("{name}, line {}", line.saturating_add(2));
                let found = node.reader().value::<F>(&at, &text, kind);
                found.map_err(|e| format!("{}: {e}", node.place()))
            };
            let [of_first, of_second] = kinds;
            points.push((value(0, of_first)?, value(1, of_second)?));
        }
        Ok(points)
    }

    /// The place of a new record.
    fn add_record(&mut self, node: &Node<'_>, mut record: Record<F>) -> Result<usize, String> {
        let others = &self.model.records;
        let count = others.iter().fold(record.times.len(), |sum, of| sum.saturating_add(of.times.len()));
        if count > MOST_SAMPLES || others.len() == MOST_RECORDS {
            let most =
                format!("must be one of ≤ {MOST_RECORDS} records, with ≤ {MOST_SAMPLES} samples together");
            return Err(node.wrong(&most));
        }
        record.force = vec![F::int(0); self.names.len()];
        let place = others.len();
        self.model.records.push(record);
        Ok(place)
    }

    /// Adds a load, with the force on each body where the signal is 1.
    pub(super) fn load(&mut self, signal: &Signal<F>, force: &[F]) {
        let model = &mut self.model;
        let push = |list: &mut Vec<F>, by: F| {
            force.iter().enumerate().filter(|(_, share)| **share != F::int(0)).for_each(|(i, &share)| {
                add_at(list, i, by * share);
            });
        };
        push(&mut model.constant, signal.constant);
        for (i, harmonic) in model.harmonics.iter_mut().enumerate() {
            push(&mut harmonic.sin, at(&signal.sin, i));
            push(&mut harmonic.cos, at(&signal.cos, i));
        }
        for (i, record) in model.records.iter_mut().enumerate() {
            push(&mut record.force, at(&signal.records, i));
        }
    }

    /// A motion: a velocity, or a table with a displacement, a velocity or an acceleration over time.
    pub(super) fn motion(&mut self, node: &Node<'_>) -> Result<(MovedBy, Signal<F>), String> {
        let kinds = [
            ("displacement", MovedBy::Displacement, Of::Length),
            ("velocity", MovedBy::Velocity, Of::Velocity),
            ("acceleration", MovedBy::Acceleration, Of::Acceleration),
        ];
        let is_named = |name: &str| node.value().as_object().is_some_and(|map| map.contains_key(name));
        if !kinds.iter().any(|(name, ..)| is_named(name)) {
            return Ok((MovedBy::Velocity, self.signal(node, Of::Velocity)?));
        }
        let fields = node.fields()?;
        let mut given = kinds.into_iter().filter_map(|(name, by, kind)| Some((fields.get(name)?, by, kind)));
        let (first, by, kind) = given.next().ok_or_else(|| node.wrong("must have a motion"))?;
        if let Some((other, ..)) = given.next() {
            return Err(other.wrong("must be left out beside another quantity of the motion"));
        }
        drop(given);
        let signal = self.over_time(&first, &fields, kind)?;
        let jumps =
            |(i, factor): (usize, &F)| *factor != F::int(0) && self.model.records.get(i).is_some_and(jumps);
        if by == MovedBy::Displacement && signal.records.iter().enumerate().any(jumps) {
            return Err(first.wrong(
                "must not change at once, because that takes an infinite velocity: give a steep straight line between the values",
            ));
        }
        fields.end()?;
        Ok((by, signal))
    }

    /// A quantity over time, whose text may also be the name of a file with its options beside it.
    pub(super) fn over_time(
        &mut self,
        node: &Node<'_>,
        beside: &Fields<'_>,
        kind: Of,
    ) -> Result<Signal<F>, String> {
        let is_file = node.value().is_string() && node.quantity::<F>(kind).is_err();
        if is_file {
            return self.recorded(node, beside, kind);
        }
        without_options(beside)?;
        self.signal(node, kind)
    }

    /// The derivative of the waves of a signal.
    pub(super) fn derivative(&self, signal: &Signal<F>) -> Signal<F> {
        self.by_frequency(signal, |omega, sin, cos| (-(omega * cos), omega * sin))
    }

    /// The integral of the waves of a signal, with the mean 0.
    pub(super) fn integral(&self, signal: &Signal<F>) -> Signal<F> {
        self.by_frequency(signal, |omega, sin, cos| (cos / omega, -sin / omega))
    }

    fn by_frequency(&self, signal: &Signal<F>, of: impl Fn(F, F, F) -> (F, F)) -> Signal<F> {
        let waves = self.model.harmonics.iter().enumerate();
        let parts = waves.map(|(i, wave)| of(wave.frequency, at(&signal.sin, i), at(&signal.cos, i)));
        let (sin, cos) = parts.unzip();
        Signal { sin, cos, ..Signal::constant(F::int(0)) }
    }

    /// A signal with derivatives of the records of another one, in its order.
    pub(super) fn of_records(
        &mut self,
        node: &Node<'_>,
        signal: &Signal<F>,
        derivative: fn(&Record<F>) -> Result<Record<F>, &'static str>,
    ) -> Result<Signal<F>, String> {
        let mut result = Signal::constant(F::int(0));
        for (i, &factor) in signal.records.iter().enumerate().filter(|(_, factor)| **factor != F::int(0)) {
            let Some(record) = self.model.records.get(i) else { continue };
            let found = derivative(record).map_err(|must| node.wrong(must))?;
            let place = self.add_record(node, found)?;
            add_at(&mut result.records, place, factor);
        }
        Ok(result)
    }
}

/// The slopes of a record, as a record with steps; what it must be to have them.
pub(super) fn slopes_of<F: Number>(record: &Record<F>) -> Result<Record<F>, &'static str> {
    let pairs = record.times.iter().zip(&record.values);
    let (mut times, mut values) = (Vec::new(), Vec::new());
    for ((&a, &p), (&b, &q)) in pairs.clone().zip(pairs.skip(1)) {
        if a == b {
            return Err("must not change at once: that takes an infinite rate");
        }
        times.extend([a, b]);
        values.extend([(q - p) / (b - a); 2]);
    }
    let ends = (record.values.first(), record.values.last());
    if record.beyond == Beyond::Repeat && ends.0 != ends.1 {
        return Err("must end with its first value where it repeats itself");
    }
    let beyond = if record.beyond == Beyond::Repeat { Beyond::Repeat } else { Beyond::Zero };
    Ok(Record { times, values, force: Vec::new(), beyond })
}

/// The names of the reader's options in a file of a system.
const WORDS: Words = Words { units: "units", ..Words::PYTHON };

/// Refuses the options of a record beside something else.
fn without_options(fields: &Fields<'_>) -> Result<(), String> {
    let found: Vec<_> = OPTIONS.iter().filter_map(|name| fields.get(name)).collect();
    found
        .first()
        .map_or(Ok(()), |node| Err(node.wrong("belongs to a record, and needs the name of its file")))
}

/// Whether a record changes at once: two values at one time, or at the end of a period.
fn jumps<F: Number>(record: &Record<F>) -> bool {
    let ends = (record.values.first(), record.values.last());
    let mut pairs = record.times.iter().zip(record.times.iter().skip(1));
    pairs.any(|(a, b)| a == b) || (record.beyond == Beyond::Repeat && ends.0 != ends.1)
}

/// A positive frequency.
fn frequency<F: Number>(node: &Node<'_>) -> Result<F, String> {
    let frequency = node.quantity(Of::Frequency)?;
    if frequency > F::int(0) { Ok(frequency) } else { Err(node.wrong("must be > 0")) }
}

/// A name or a number as text.
fn shown(node: &Node<'_>) -> String {
    node.value().as_str().map_or_else(|| node.value().to_string(), str::to_owned)
}

/// A record with its factor, and with what follows it.
fn finished<F: Number>(
    fields: &Fields<'_>,
    times: Vec<F>,
    mut values: Vec<F>,
    holds: bool,
) -> Result<Record<F>, String> {
    if let Some(node) = fields.get("scale") {
        let factor: F = node.number()?;
        values.iter_mut().for_each(|x| *x = *x * factor);
    }
    let repeats = match fields.get("repeats") {
        Some(node) => node.value().as_bool().ok_or_else(|| node.wrong("must be true or false"))?,
        None => false,
    };
    let after = fields.get("after");
    let beyond = match after.as_ref().map(|node| node.text().map(|text| (node, text))).transpose()? {
        Some((node, _)) if repeats => {
            return Err(node.wrong("must be left out of a record that repeats itself"));
        }
        Some((_, "zero")) => Beyond::Zero,
        Some((_, "hold")) => Beyond::Hold,
        Some((node, _)) => return Err(node.wrong("must be zero or hold")),
        None if repeats => Beyond::Repeat,
        None if holds => Beyond::Hold,
        None => Beyond::Zero,
    };
    if let (Beyond::Repeat, Some(node)) = (beyond, fields.get("repeats"))
        && times.first() == times.last()
    {
        return Err(node.wrong("needs samples at two times"));
    }
    Ok(Record { times, values, force: Vec::new(), beyond })
}

/// A sine whose frequency changes from one value to another in a time, linearly or by a constant factor in equal times: as straight
/// lines that differ from it by at most a part of its amplitude.
fn swept<F: Number>(node: &Node<'_>, amplitude: f64) -> Result<Record<F>, String> {
    let fields = node.fields()?;
    let [from, to] = ["from", "to"].map(|name| fields.required(name).and_then(|node| frequency(&node)));
    let (from, to): (f64, f64) = (from?, to?);
    let of_duration = fields.required("duration")?;
    let duration: f64 = of_duration.quantity(Of::Time)?;
    if duration <= 0.0 {
        return Err(of_duration.wrong("must be > 0"));
    }
    let is_log = match fields.get("log") {
        Some(node) => node.value().as_bool().ok_or_else(|| node.wrong("must be true or false"))?,
        None => false,
    };
    let tolerance = match fields.get("tolerance") {
        Some(node) => match node.number()? {
            part if part > 0.0 && part < 1.0 => part,
            _ => return Err(node.wrong("must be > 0 and < 1")),
        },
        None => TOLERANCE,
    };
    fields.end()?;
    let growth = (to / from).ln() / duration;
    let steady = !is_log || growth == 0.0;
    let rate = |t: f64| if steady { from + (to - from) * t / duration } else { from * (growth * t).exp() };
    let phase = |t: f64| {
        if steady {
            t * (from + (to - from) * t / duration / 2.0)
        } else {
            from * (growth * t).exp_m1() / growth
        }
    };
    // A chord over h is off by h²/8 of the second derivative at most, which is at most ω² + |ω′|.
    let turn = |t: f64| {
        rate(t).powi(2) + if steady { (to - from).abs() / duration } else { (growth * rate(t)).abs() }
    };
    let (mut t, mut times) = (0.0, vec![0.0]);
    while t < duration {
        let step = |at: f64| (8.0 * tolerance / turn(at)).sqrt();
        let ahead = step(t);
        t += ahead.min(step((t + ahead).min(duration)));
        times.push(t.min(duration));
        if times.len() > MOST_SAMPLES {
            return Err(node.wrong(&format!(
                "must have ≤ {MOST_SAMPLES} samples: give a larger tolerance than {tolerance}, or a shorter duration"
            )));
        }
    }
    let values = times.iter().map(|&t| F::from_f64(amplitude * phase(t).sin())).collect();
    let times = times.into_iter().map(F::from_f64).collect();
    Ok(Record { times, values, force: Vec::new(), beyond: Beyond::Zero })
}
