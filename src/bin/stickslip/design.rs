//! `stickslip design`.

mod best;
mod no_stop;

use crate::args::{Format, Question, QuestionArgs};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
use crate::given::{Given, Parameter as P};
use crate::input::completed;
use crate::machine::base_motion;
use crate::note::digits;
use crate::record::Cell;
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::io::Write;
use stickslip::design::{self, Edge};
use stickslip::units::{Kind, Reader, System};
use stickslip::{Border, Drive, Error, Excitation, Oscillator, Quantity, Ratios};

/// The question and where its answer goes.
struct Run<'a, W>(&'a Question, &'a mut W);

pub(crate) fn run(question: &Question, out: &mut impl Write) -> Outcome {
    bits::run(arguments(question).bits, Run(question, out))
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
type Row<F> = Vec<(&'static str, Kind, Cell<F>)>;

/// An answer: what it says in a sentence, and its numbers.
struct Answer<F> {
    sentence: String,
    rows: Vec<Row<F>>,
}

impl<F: Value> Answer<F> {
    fn one(sentence: String, fields: Row<F>) -> Self {
        Self { sentence, rows: vec![fields] }
    }
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(question, out) = self;
        let args = arguments(question);
        let reader = args.units.reader();
        let asked = Asked::<F>::new(args, &reader)?;
        let answer = match question {
            Question::Force(_) if args.no_stop => asked.forces_without_stop(),
            Question::Bands(_) if args.no_stop => asked.bands_without_stop(),
            Question::Force(_) => asked.least_force(),
            Question::Friction(_) => asked.greatest_friction(),
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
}

/// A row as JSON: in physical units with the kind of base motion and the unit of each value.
struct Named<'a, F> {
    row: &'a Row<F>,
    system: Option<System>,
    base_motion: Option<&'static str>,
}

impl<F: Value> Serialize for Named<'_, F> {
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

/// The arguments of a question, ready to be read as its answer needs them.
struct Asked<'a, F> {
    args: &'a QuestionArgs,
    reader: &'a Reader,
    given: Given<F>,
    physical: bool,
    one: F,
}

impl<'a, F: Value> Asked<'a, F> {
    fn new(args: &'a QuestionArgs, reader: &'a Reader) -> Result<Self, Failure> {
        let given = Given::of(&args.machine, &args.force, reader)?;
        let physical = given.is_physical();
        if physical && (given.has(P::Omega) || given.has(P::Alpha)) {
            let text = "--omega and --alpha: a question is asked in ratios or in physical units, not in both";
            return Err(Failure::Input(text.to_owned()));
        }
        Ok(Self { args, reader, given, physical, one: F::int(1) })
    }

    /// The sentence, what base motion it is about, and a line for each number with its unit.
    fn text(&self, answer: &Answer<F>, out: &mut impl Write) -> Outcome {
        writeln!(out, "{}", answer.sentence)?;
        if let Some(base) = self.base_motion() {
            writeln!(out, "Base motion {base}.")?;
        }
        for row in &answer.rows {
            writeln!(out)?;
            for (name, kind, cell) in row {
                let is_number = matches!(cell, Cell::Number(_) | Cell::Intervals(_)) && *kind != Kind::Ratio;
                let unit = if is_number { format!(" {}", self.system().name(*kind)) } else { String::new() };
                let mut hertz = String::new();
                if let (Cell::Number(Some(value)), Kind::Frequency) = (cell, kind) {
                    hertz = format!(" = {} Hz", digits(*value / (F::int(2) * F::pi())));
                }
                writeln!(out, "  {:<22} {}{unit}{hertz}", name.replace('_', " "), cell.text())?;
            }
        }
        Ok(())
    }

    fn named<'r>(&self, row: &'r Row<F>) -> Named<'r, F> {
        Named { row, system: self.physical.then(|| *self.system()), base_motion: self.base_motion() }
    }

    /// Which kind of base motion the question is about, if any.
    fn base_motion(&self) -> Option<&'static str> {
        let given = |several: &[P]| several.iter().any(|p| self.given.has(*p));
        if given(&[P::FootDisplacement]) {
            base_motion(Excitation::FootMotion)
        } else if given(&[P::BaseAcceleration, P::BaseVelocity, P::BaseDisplacement]) {
            base_motion(Excitation::SurfaceMotion)
        } else {
            None
        }
    }

    /// The error behind the arguments of the machine, the range and the target that it comes from.
    fn fail(&self, error: Error) -> Failure {
        use Quantity as Q;
        let QuestionArgs { from, to, target, .. } = self.args;
        let quantity = error.quantity();
        // The range is of what is asked for, which no other argument gives.
        let of_range = [Q::FrequencyRatio, Q::AngularFrequency, Q::Stiffness];
        let targets = [Q::MaxDisplacement, Q::MaxDisplacementRatio, Q::MaxVelocity, Q::MaxVelocityRatio];
        let own: [(&str, &Option<String>, &[Q]); 3] =
            [("--from", from, &of_range), ("--to", to, &of_range), ("--target", target, &targets)];
        let named: Vec<String> = own
            .iter()
            .filter(|(_, _, quantities)| quantity.is_some_and(|q| quantities.contains(&q)))
            .filter_map(|(name, value, _)| value.as_ref().map(|v| format!("{name} {v}")))
            .collect();
        match (named.join(" "), self.given.at_fault(error.clone())) {
            (arguments, Failure::Input(text)) if !arguments.is_empty() && text == error.to_string() => {
                Failure::Input(format!("{arguments}: {error}"))
            }
            (arguments, Failure::Input(text)) if !arguments.is_empty() => {
                Failure::Input(text.replacen(": ", &format!(" {arguments}: "), 1))
            }
            (_, failure) => failure,
        }
    }

    fn system(&self) -> &System {
        &self.given.system
    }

    fn omega(&self) -> Result<F, Failure> {
        self.given.required(P::Omega)
    }

    /// The damping ratio that is given, or none.
    fn damping_ratio(&self) -> F {
        self.given.get(P::DampingRatio).unwrap_or(F::int(0))
    }

    /// Refuses a damping ratio and a static friction above the kinetic one, where it is not known what they
    /// do.
    fn undamped(&self) -> Result<(), Failure> {
        if let Some(eta) = self.given.get(P::StaticFrictionRatio).filter(|eta| *eta != self.one) {
            return Err(self.fail(Error::StaticFriction { static_friction_ratio: eta.into() }));
        }
        let zeta = self.damping_ratio();
        if zeta > F::int(0) {
            return Err(self.fail(Error::Damped { damping_ratio: zeta.into() }));
        }
        Ok(())
    }

    /// The border at Ω with the damping ratio and the static friction ratio that are given.
    fn border(&self, omega: F) -> Result<Border<F>, Failure> {
        let ratios = Ratios::new(omega, self.one).map_err(|e| self.fail(e))?;
        Ok(Border::of(&completed(&self.given, ratios)?))
    }

    fn alpha(&self) -> Result<F, Failure> {
        self.given.required(P::Alpha)
    }

    fn frequency(&self) -> Result<F, Failure> {
        self.given.required(P::Frequency)
    }

    /// `--from` and `--to`, in units of this kind where the question is physical.
    fn range(&self, kind: Kind) -> Result<(F, F), Failure> {
        Ok((self.read("--from", &self.args.from, kind)?, self.read("--to", &self.args.to, kind)?))
    }

    fn target(&self, kind: Kind) -> Result<F, Failure> {
        self.read("--target", &self.args.target, kind)
    }

    fn read(&self, name: &str, text: &Option<String>, kind: Kind) -> Result<F, Failure> {
        match text {
            Some(text) => {
                Ok(self.reader.value(name, text, if self.physical { kind } else { Kind::Ratio })?)
            }
            None => Err(Failure::Input(format!("{name} is missing"))),
        }
    }

    /// The body; what the question does not need may be missing, and is then 1.
    fn body(&self, needs_stiffness: bool, needs_friction: bool) -> Result<Oscillator<F>, Failure> {
        let or_one = |found: Option<F>, needed: bool, names: &str| match found {
            None if needed => Err(Failure::Input(format!("{names} is missing"))),
            found => Ok(found.unwrap_or(self.one)),
        };
        let mass = self.given.mass()?;
        let stiffness = or_one(self.given.stiffness()?, needs_stiffness, "--stiffness (or --period)")?;
        let friction =
            or_one(self.given.friction()?, needs_friction, "--friction (or --friction-coefficient)")?;
        let body = Oscillator::new(mass, stiffness, friction).map_err(|e| self.fail(e))?;
        self.given.with_damper(body)
    }

    fn drive(&self, body: &Oscillator<F>, frequency: F) -> Result<Drive<F>, Failure> {
        self.given.drive(body, frequency)
    }

    fn least_force(&self) -> Result<Answer<F>, Failure> {
        if !self.physical {
            let omega = self.omega()?;
            let border = self.border(omega)?;
            let least = border.min_force_ratio();
            let sentence = format!("The body never sticks at a force of {} r_y or more.", digits(least));
            return Ok(Answer::one(
                sentence,
                vec![("omega", Kind::Ratio, some(omega)), ("force_ratio", Kind::Ratio, some(least))],
            ));
        }
        let (body, frequency) = (self.body(true, true)?, self.frequency()?);
        let force = design::least_force(&body, frequency).map_err(|e| self.fail(e))?;
        let (newton, length) = (self.system().force(), self.system().length());
        let fields = force_and_base_motions(&body, frequency, force);
        let of =
            |name: &str| fields.iter().find(|(n, ..)| *n == name).map_or_else(String::new, |f| f.2.text());
        let sentence = format!(
            "The body never sticks at a force of {} {newton} or more: a motion of {} {length} of the spring's foot over a \
             surface that stays, or of {} {length} of a base that carries the surface.",
            of("force"),
            of("foot_displacement"),
            of("base_displacement")
        );
        Ok(Answer::one(sentence, fields))
    }

    fn greatest_friction(&self) -> Result<Answer<F>, Failure> {
        if !self.physical {
            let omega = self.omega()?;
            let border = self.border(omega)?;
            let ratio = self.one / border.min_force_ratio();
            let sentence =
                format!("The body never sticks with a friction bound of {} p₀ or less.", digits(ratio));
            return Ok(Answer::one(
                sentence,
                vec![("omega", Kind::Ratio, some(omega)), ("friction_to_force", Kind::Ratio, some(ratio))],
            ));
        }
        let body = self.body(true, false)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let friction = design::greatest_friction(&body, &drive).map_err(|e| self.fail(e))?;
        let sentence = format!(
            "The body never sticks with a friction bound of {} {} or less.",
            digits(friction),
            self.system().force()
        );
        let coefficient = friction / (body.mass() * self.given.gravity()?);
        let fields = vec![
            ("friction", Kind::Force, some(friction)),
            ("friction_coefficient", Kind::Ratio, some(coefficient)),
        ];
        Ok(Answer::one(sentence, fields))
    }

    fn bands(&self) -> Result<Answer<F>, Failure> {
        let (low, high) = self.range(Kind::Frequency)?;
        let mut searched = self.damping_ratio() > F::int(0);
        let (found, unit) = if self.physical {
            let body = self.body(true, true)?;
            searched = body.damping() > F::int(0);
            // The frequency of the drive is what is asked for: its amplitude alone counts.
            let drive = self.drive(&body, self.one)?;
            (design::frequency_bands(&body, &drive, low, high), "frequency")
        } else {
            (design::bands_with_damping(self.alpha()?, self.damping_ratio(), low, high), "omega")
        };
        let kind = if self.physical { Kind::Frequency } else { Kind::Ratio };
        let names =
            if unit == "omega" { ["omega_from", "omega_to"] } else { ["frequency_from", "frequency_to"] };
        let edge = |edge: Edge| if edge == Edge::Range { "end-of-range" } else { "border" };
        let rows = found
            .map_err(|e| self.fail(e))?
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
        Ok(Answer { sentence, rows })
    }

    fn displacement(&self) -> Result<Answer<F>, Failure> {
        let target = self.target(Kind::Length)?;
        if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            return self.force_for(design::force_for_displacement(&body, frequency, target));
        }
        let (omega, zeta) = (self.omega()?, self.damping_ratio());
        self.ratio_for(design::force_ratio_for_displacement_with_damping(omega, zeta, target))
    }

    fn velocity(&self) -> Result<Answer<F>, Failure> {
        let target = self.target(Kind::Velocity)?;
        if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            return self.force_for(design::force_for_velocity(&body, frequency, target));
        }
        let (omega, zeta) = (self.omega()?, self.damping_ratio());
        self.ratio_for(design::force_ratio_for_velocity_with_damping(omega, zeta, target))
    }

    fn force_for(&self, force: Result<F, Error>) -> Result<Answer<F>, Failure> {
        let force = force.map_err(|e| self.fail(e))?;
        let sentence = format!("The force needed is {} {}.", digits(force), self.system().force());
        Ok(Answer::one(sentence, vec![("force", Kind::Force, some(force))]))
    }

    fn ratio_for(&self, ratio: Result<F, Error>) -> Result<Answer<F>, Failure> {
        let ratio = ratio.map_err(|e| self.fail(e))?;
        let sentence = format!("The force needed is {} r_y.", digits(ratio));
        Ok(Answer::one(sentence, vec![("force_ratio", Kind::Ratio, some(ratio))]))
    }
}

/// A force, and the amplitude of either kind of base motion that is this force on the body.
fn force_and_base_motions<F: Value>(body: &Oscillator<F>, frequency: F, force: F) -> Row<F> {
    let acceleration = force / body.mass();
    vec![
        ("force", Kind::Force, some(force)),
        ("foot_displacement", Kind::Length, some(force / body.stiffness())),
        ("base_displacement", Kind::Length, some(acceleration / frequency.square())),
        ("base_acceleration", Kind::Acceleration, some(acceleration)),
    ]
}

/// Of an answer that no proof shows to be the only one or the best: with a damper.
const fn searched_field<F>() -> (&'static str, Kind, Cell<F>) {
    ("found_by", Kind::Ratio, Cell::Text("search"))
}

fn some<F: Value>(x: F) -> Cell<F> {
    Cell::Number(Some(x))
}
