//! `stickslip design`.

mod asked;
mod best;
mod no_stop;
mod over_band;
mod static_friction;

use crate::args::{Format, Question, QuestionArgs};
use crate::bits::digits;
use crate::bits::{Value, at_bits};
use crate::failure::{Failure, Outcome};
use crate::given;
use crate::record::Cell;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::Write;
use stickslip::design::{self, Edge};
use stickslip::inputs::Input;
use stickslip::inputs::units::{Kind, System};
use stickslip::{Drive, Error, Excitation, NoStop, Oscillator};

use asked::AskedDesign;

pub(crate) fn run(question: &Question, out: &mut impl Write) -> Outcome {
    at_bits!(arguments(question).bits, respond(question: &Question, out))
}

const fn arguments(question: &Question) -> &QuestionArgs {
    match question {
        Question::Force(args)
        | Question::Friction(args)
        | Question::Bands(args)
        | Question::Displacement(args)
        | Question::Velocity(args)
        | Question::Dissipation(args)
        | Question::Stiffness(args) => args,
    }
}

/// A row of an answer: name, kind and value of each number.
type AnswerRow<F> = Vec<(&'static str, Kind, Cell<F>)>;

/// An answer: a sentence and its numbers.
struct DesignAnswer<F> {
    sentence: String,
    rows: Vec<AnswerRow<F>>,
}

impl<F: Value> DesignAnswer<F> {
    fn one(sentence: String, fields: AnswerRow<F>) -> Self {
        Self { sentence, rows: vec![fields] }
    }
}

fn respond<F: Value>(question: &Question, out: &mut impl Write) -> Outcome {
    let args = arguments(question);
    let reader = args.units.reader();
    let asked = AskedDesign::<F>::new(args, &reader)?;
    let answer = match question {
        Question::Force(_) if args.no_stop => asked.forces_without_stop(),
        Question::Bands(_) if args.no_stop => asked.bands_without_stop(),
        Question::Force(_) => asked.min_force(),
        Question::Friction(_) => match &args.over {
            Some(over) => asked.friction_over_band(over),
            None => asked.max_friction(),
        },
        Question::Bands(_) => asked.bands(),
        Question::Displacement(_) => asked.displacement(),
        Question::Velocity(_) => asked.velocity(),
        Question::Dissipation(_) => asked.dissipation(),
        Question::Stiffness(_) => asked.stiffness(),
    }?;
    answer.rows.iter().flatten().try_for_each(|(name, _, cell)| cell.finite(name))?;
    match args.format {
        Format::Text => asked.text(&answer, out),
        Format::Json => {
            let records: Vec<_> = answer.rows.iter().map(|row| asked.named(row)).collect();
            match (question, records.first()) {
                (Question::Bands(_), _) => serde_json::to_writer_pretty(&mut *out, &records)?,
                (_, Some(record)) => serde_json::to_writer_pretty(&mut *out, record)?,
                (_, None) => {}
            }
            Ok(out.write_all(b"\n")?)
        }
        Format::Jsonl | Format::Csv => {
            Err(Failure::Input("--format: the answer to design is text or json".to_owned()))
        }
    }
}

/// A row as JSON; in physical units it includes the kind of base motion and the unit of each value.
struct NamedRow<'a, F> {
    row: &'a AnswerRow<F>,
    system: Option<System>,
    base_motion: Option<&'static str>,
}

impl<F: Value> Serialize for NamedRow<'_, F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (name, _, cell) in self.row {
            map.serialize_entry(name, cell)?;
        }
        if let Some(base) = self.base_motion {
            map.serialize_entry("base_motion", base)?;
        }
        if let Some(system) = self.system {
            let numbers =
                self.row.iter().filter(|(_, _, cell)| matches!(cell, Cell::Number(_) | Cell::Intervals(_)));
            let units: Vec<_> = numbers.map(|(name, kind, _)| (*name, system.name(*kind))).collect();
            map.serialize_entry("units", &Units(&units))?;
        }
        map.end()
    }
}

struct Units<'a>(&'a [(&'static str, String)]);

impl Serialize for Units<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, unit)| (name, unit)))
    }
}

impl<F: Value> AskedDesign<'_, F> {
    fn min_force(&self) -> Result<DesignAnswer<F>, Failure> {
        if !self.physical {
            let omega = self.omega()?;
            let border = self.border(omega)?;
            let least = border.min_force_ratio;
            let mut fields =
                vec![("omega", Kind::Ratio, some(omega)), ("force_ratio", Kind::Ratio, some(least))];
            let ratios = self.ratios(omega)?;
            let sentence = if ratios.has_higher_static_friction() {
                let found = NoStop::of(&ratios);
                let names = ["release_force_ratio", "every_start_force_ratio"];
                fields.extend(static_friction::fields(&ratios, &found, names, Kind::Ratio, |x| x));
                static_friction::by_force(&ratios, &found, |x| format!("{} r_y", digits(x)))
            } else {
                format!("The body never sticks at a force of {} r_y or more.", digits(least))
            };
            return Ok(DesignAnswer::one(sentence, fields));
        }
        let (body, frequency) = (self.body(true, true)?, self.frequency()?);
        let force = design::min_amplitude(&body, Excitation::Force, frequency).map_err(|e| self.fail(e))?;
        let (newton, length) = (self.system().force(), self.system().length());
        let unbalance = self.system().name(Kind::Unbalance);
        let mut fields = force_and_equals(&body, frequency, force);
        fields.extend(self.shift(&body)?);
        let of =
            |name: &str| fields.iter().find(|(n, ..)| *n == name).map_or_else(String::new, |f| f.2.text());
        let mut sentence = format!(
            "The body never sticks at a force of {} {newton} or more: a rotating unbalance of {} {unbalance}, a \
             motion of {} {length} of the spring's foot over a fixed surface, or of {} {length} of a base that \
             carries the surface.",
            of("force"),
            of("unbalance"),
            of("foot_displacement"),
            of("base_displacement")
        );
        if body.static_friction_ratio() > self.one {
            let friction = body.friction_bound();
            let ratios = Drive::force(friction, frequency).and_then(|drive| drive.ratios(&body));
            let (ratios, unit) = (ratios.map_err(|e| self.fail(e))?, newton);
            let found = NoStop::of(&ratios);
            sentence =
                static_friction::by_force(&ratios, &found, |x| format!("{} {unit}", digits(x * friction)));
            let names = ["release_force", "every_start_force"];
            fields.extend(static_friction::fields(&ratios, &found, names, Kind::Force, |x| x * friction));
        }
        Ok(DesignAnswer::one(sentence, fields))
    }

    fn max_friction(&self) -> Result<DesignAnswer<F>, Failure> {
        if !self.physical {
            let omega = self.omega()?;
            let border = self.border(omega)?;
            let ratio = self.one / border.min_force_ratio;
            let mut fields =
                vec![("omega", Kind::Ratio, some(omega)), ("friction_to_force", Kind::Ratio, some(ratio))];
            let ratios = self.ratios(omega)?;
            let sentence = if ratios.has_higher_static_friction() {
                let found = NoStop::of(&ratios);
                let names = ["release_friction_to_force", "every_start_friction_to_force"];
                fields.extend(static_friction::fields(&ratios, &found, names, Kind::Ratio, |x| self.one / x));
                static_friction::by_friction(&ratios, &found, |x| format!("{} p₀", digits(x)))
            } else {
                format!("The body never sticks with a friction bound of {} p₀ or less.", digits(ratio))
            };
            return Ok(DesignAnswer::one(sentence, fields));
        }
        let body = self.body(true, false)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let friction = design::max_friction(&body, &drive).map_err(|e| self.fail(e))?;
        let mut sentence = format!(
            "The body never sticks with a friction bound of {} {} or less.",
            digits(friction),
            self.system().force()
        );
        let coefficient = friction / (body.mass() * self.given.gravity()?);
        let mut fields = vec![
            ("friction", Kind::Force, some(friction)),
            ("friction_coefficient", Kind::Ratio, some(coefficient)),
        ];
        if body.static_friction_ratio() > self.one {
            let ratios = drive.ratios(&body).map_err(|e| self.fail(e))?;
            let (found, force) = (NoStop::of(&ratios), drive.force_amplitude(&body));
            let unit = self.system().force();
            sentence =
                static_friction::by_friction(&ratios, &found, |x| format!("{} {unit}", digits(x * force)));
            let names = ["release_friction", "every_start_friction"];
            fields.extend(static_friction::fields(&ratios, &found, names, Kind::Force, |x| force / x));
        }
        Ok(DesignAnswer::one(sentence, fields))
    }

    fn bands(&self) -> Result<DesignAnswer<F>, Failure> {
        let (low, high) = self.range(Kind::Frequency)?;
        let (found, unit) = if self.physical {
            let body = self.body(true, true)?;
            // The frequency of the drive is unknown: only its amplitude counts.
            let drive = self.drive(&body, self.one)?;
            (design::frequency_bands(&body, &drive, low, high), "frequency")
        } else {
            (design::bands(self.alpha()?, self.damping_ratio(), low, high), "omega")
        };
        let kind = if self.physical { Kind::Frequency } else { Kind::Ratio };
        let names =
            if unit == "omega" { ["omega_from", "omega_to"] } else { ["frequency_from", "frequency_to"] };
        let edge = |edge: Edge| if edge == Edge::Range { "end-of-range" } else { "border" };
        let found = found.map_err(|e| self.fail(e))?;
        let searched = found.is_searched();
        let rows = found
            .map(|band| {
                band.map(|b| {
                    let mut row = vec![
                        (names[0], kind, some(b.low)),
                        (names[1], kind, some(b.high)),
                        ("low_edge", Kind::Ratio, Cell::Text(edge(b.low_edge))),
                        ("high_edge", Kind::Ratio, Cell::Text(edge(b.high_edge))),
                    ];
                    row.extend(searched.then(searched_field));
                    row
                })
            })
            .collect::<Result<Vec<_>, Error>>()
            .map_err(|e| self.fail(e))?;
        let sentence = match rows.len() {
            0 if searched => {
                "The body sticks or rests throughout that range, by a search that is not a proof.".to_owned()
            }
            0 => "The body sticks or rests throughout that range.".to_owned(),
            n if searched => format!(
                "The body does not stick in {n} {} of that range, found by a search that is not a proof:",
                if n == 1 { "band" } else { "bands" }
            ),
            1 => "The body does not stick in one band of that range:".to_owned(),
            n => format!("The body does not stick in {n} bands of that range, and in no others:"),
        };
        Ok(DesignAnswer { sentence, rows })
    }

    fn displacement(&self) -> Result<DesignAnswer<F>, Failure> {
        let target = self.target(Kind::Length)?;
        if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            return self.force_for(&body, design::force_for_displacement(&body, frequency, target));
        }
        let (omega, zeta) = (self.omega()?, self.damping_ratio());
        self.ratio_for(design::force_ratio_for_displacement(omega, zeta, target))
    }

    fn velocity(&self) -> Result<DesignAnswer<F>, Failure> {
        let target = self.target(Kind::Velocity)?;
        if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            return self.force_for(&body, design::force_for_velocity(&body, frequency, target));
        }
        let (omega, zeta) = (self.omega()?, self.damping_ratio());
        self.ratio_for(design::force_ratio_for_velocity(omega, zeta, target))
    }

    fn force_for(&self, body: &Oscillator<F>, force: Result<F, Error>) -> Result<DesignAnswer<F>, Failure> {
        let force = force.map_err(|e| self.fail(e))?;
        let sentence = format!("The force needed is {} {}.", digits(force), self.system().force());
        let mut fields = vec![("force", Kind::Force, some(force))];
        fields.extend(self.shift(body)?);
        Ok(DesignAnswer::one(sentence, fields))
    }

    /// The shift of the motion by a constant force, which changes no amplitude.
    fn shift(&self, body: &Oscillator<F>) -> Result<AnswerRow<F>, Failure> {
        if !self.given.has(Input::MeanForce) {
            return Ok(Vec::new());
        }
        Ok(vec![("mean_displacement", Kind::Length, some(given::mean_displacement(&self.given, body)?))])
    }

    fn ratio_for(&self, ratio: Result<F, Error>) -> Result<DesignAnswer<F>, Failure> {
        let ratio = ratio.map_err(|e| self.fail(e))?;
        let sentence = format!("The force needed is {} r_y.", digits(ratio));
        Ok(DesignAnswer::one(sentence, vec![("force_ratio", Kind::Ratio, some(ratio))]))
    }
}

/// A force, the unbalance, and the amplitude of either kind of base motion that exerts this force on the body.
fn force_and_equals<F: Value>(body: &Oscillator<F>, frequency: F, force: F) -> AnswerRow<F> {
    let equal = |name, kind, excitation| {
        let unit = Drive::new(excitation, F::int(1), frequency).map(|unit| unit.force_amplitude(body));
        (name, kind, Cell::Number(unit.ok().map(|unit| force / unit)))
    };
    vec![
        ("force", Kind::Force, some(force)),
        equal("unbalance", Kind::Unbalance, Excitation::Unbalance),
        equal("foot_displacement", Kind::Length, Excitation::FootMotion),
        equal("base_displacement", Kind::Length, Excitation::SurfaceMotion),
        equal("base_acceleration", Kind::Acceleration, Excitation::SurfaceAcceleration),
    ]
}

/// The field that marks an answer found by search, without a proof that it is the only one or the best.
const fn searched_field<F>() -> (&'static str, Kind, Cell<F>) {
    ("found_by", Kind::Ratio, Cell::Text("search"))
}

fn some<F: Value>(x: F) -> Cell<F> {
    Cell::Number(Some(x))
}
