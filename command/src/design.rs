//! `stickslip design`.

mod asked;
mod best;
mod over_band;
mod row;
mod target_friction;

use crate::args::{Question, QuestionArgs};
use crate::bits::{Value, at_bits, digits};
use crate::failure::{Failure, Outcome};
use crate::row::{Cell, Cells};
use crate::{input, note, output};
use asked::AskedDesign;
use row::DesignAnswer;
pub(crate) use row::{AnswerRow, NamedRow, shown};
use std::io::Write;
use stickslip::design::{self, Band, Edge, Holding};
use stickslip::{Border, Drive, Error, Excitation, NoStop, Oscillator, Ratios};
use stickslip_front::inputs::units::Kind;
use stickslip_front::inputs::{Given, Input, Role};

pub(crate) fn run(question: &Question, out: &mut impl Write) -> Outcome {
    at_bits!(arguments(question).answer.bits, respond(question: &Question, out))
}

const fn arguments(question: &Question) -> &QuestionArgs {
    match question {
        Question::Force(args)
        | Question::Friction(args)
        | Question::Bands(args)
        | Question::Hold(args)
        | Question::Displacement(args)
        | Question::Velocity(args)
        | Question::Dissipation(args)
        | Question::Stiffness(args) => args,
    }
}

impl<F: Value> DesignAnswer<F> {
    fn one(sentence: String, fields: AnswerRow<F>) -> Self {
        Self { sentence, rows: vec![fields] }
    }
}

fn respond<F: Value>(question: &Question, out: &mut impl Write) -> Outcome {
    let args = arguments(question);
    let reader = args.answer.units.reader();
    let asked = AskedDesign::<F>::new(args, &reader)?;
    if let Some(target) = &args.target_amplitude {
        asked.driven()?;
        return asked.frictions_for(target, out);
    }
    if asked.given.is_without_drive() && !matches!(question, Question::Bands(_) | Question::Hold(_)) {
        asked.driven()?;
    }
    let answer = match question {
        Question::Force(_) if args.no_stop => asked.forces_without_stop(),
        Question::Bands(_) if args.no_stop => asked.bands_without_stop(),
        Question::Force(_) => asked.min_force(),
        Question::Friction(_) => match &args.over {
            Some(over) => asked.friction_over_band(over),
            None => asked.max_friction(),
        },
        Question::Bands(_) => asked.bands(),
        Question::Hold(_) => asked.holding(),
        Question::Displacement(_) => asked.force_for(
            Kind::Length,
            design::force_for_displacement,
            design::force_ratio_for_displacement,
        ),
        Question::Velocity(_) => {
            asked.force_for(Kind::Velocity, design::force_for_velocity, design::force_ratio_for_velocity)
        }
        Question::Dissipation(_) => asked.dissipation(),
        Question::Stiffness(_) => asked.stiffness(),
    }?;
    answer.rows.iter().flatten().try_for_each(|(name, _, cell)| cell.shown().finite(name))?;
    if !args.answer.format.is_json("design")? {
        return asked.text(&answer, out);
    }
    let records: Vec<_> = answer.rows.iter().map(|row| asked.named(row)).collect();
    match (question, records.first()) {
        (Question::Bands(_), _) | (_, None) => output::json(&records, out),
        (_, Some(record)) => output::json(record, out),
    }
}

impl<F: Value> AskedDesign<'_, F> {
    fn min_force(&self) -> Result<DesignAnswer<F>, Failure> {
        if !self.physical {
            let omega = self.omega()?;
            let ratios = self.ratios(omega)?;
            let least = Border::of(&ratios).min_force_ratio;
            let fields = vec![("omega", Kind::Ratio, some(omega)), ("force_ratio", Kind::Ratio, some(least))];
            let sentence = format!("The body never sticks at a force of {} r_y or more.", digits(least));
            let names = ["release_force_ratio", "every_start_force_ratio"];
            let force = Divided { is_force: true, names, kind: Kind::Ratio, scale: self.one, unit: "r_y" };
            return Ok(DesignAnswer::one(sentence, fields).divided(&ratios, &force));
        }
        let (body, frequency) = (self.body(true, true)?, self.frequency()?);
        let force = design::min_amplitude(&body, Excitation::Force, frequency).map_err(|e| self.fail(e))?;
        let force = force * self.share;
        let (newton, length) = (self.system().force(), self.system().length());
        let (unbalance, factor) = self.system().for_reading(Kind::Unbalance);
        let mut fields = force_and_equals(&self.given, &body, frequency, force);
        fields.extend(self.shift(&body)?);
        let of = |name: &str| {
            fields.iter().find(|(n, ..)| *n == name).map_or_else(String::new, |f| f.2.shown().text())
        };
        let foot = match of("foot_displacement") {
            far if far.is_empty() => "a motion ".to_owned(),
            far => format!("a motion of {far} {length} of the spring's support over a fixed surface, or "),
        };
        let turning = fields.iter().find(|(name, ..)| *name == "unbalance").and_then(|(_, _, cell)| {
            let Cell::Number(Some(value)) = cell else { return None };
            Some(digits(factor.times(*value)))
        });
        let sentence = format!(
            "The body never sticks at a force of {} {newton} or more: a rotating unbalance of {} {unbalance}, {foot}of {} \
             {length} of a base that carries the surface.",
            of("force"),
            turning.unwrap_or_default(),
            of("base_displacement")
        );
        let answer = DesignAnswer::one(sentence, fields);
        if body.static_friction_ratio() <= self.one {
            return Ok(answer);
        }
        let scale = body.friction_bound() * self.share;
        let ratios = Drive::force(body.friction_bound(), frequency).and_then(|drive| drive.ratios(&body));
        let names = ["release_force", "every_start_force"];
        let force = Divided { is_force: true, names, kind: Kind::Force, scale, unit: newton };
        Ok(answer.divided(&ratios.map_err(|e| self.fail(e))?, &force))
    }

    fn max_friction(&self) -> Result<DesignAnswer<F>, Failure> {
        if !self.physical {
            let omega = self.omega()?;
            let ratios = self.ratios(omega)?;
            let ratio = self.one / Border::of(&ratios).min_force_ratio;
            let fields =
                vec![("omega", Kind::Ratio, some(omega)), ("friction_to_force", Kind::Ratio, some(ratio))];
            let sentence =
                format!("The body never sticks with a friction force of {} p₀ or less.", digits(ratio));
            let names = ["release_friction_to_force", "every_start_friction_to_force"];
            let friction =
                Divided { is_force: false, names, kind: Kind::Ratio, scale: self.one, unit: "p₀" };
            return Ok(DesignAnswer::one(sentence, fields).divided(&ratios, &friction));
        }
        let body = self.body(true, false)?;
        let drive = self.drive(&body, self.frequency()?)?;
        let friction = design::max_friction(&body, &drive).map_err(|e| self.fail(e))?;
        let unit = self.system().force();
        let sentence =
            format!("The body never sticks with a friction force of {} {unit} or less.", digits(friction));
        let coefficient = friction / (body.mass() * self.given.gravity()?);
        let fields = vec![
            ("friction", Kind::Force, some(friction)),
            ("friction_coefficient", Kind::Ratio, some(coefficient)),
        ];
        let (names, scale) = (["release_friction", "every_start_friction"], drive.force_amplitude(&body));
        let friction = Divided { is_force: false, names, kind: Kind::Force, scale, unit };
        let ratios = drive.ratios(&body).map_err(|e| self.fail(e))?;
        Ok(DesignAnswer::one(sentence, fields).divided(&ratios, &friction))
    }

    fn bands(&self) -> Result<DesignAnswer<F>, Failure> {
        let (low, high) = self.range(Kind::Frequency)?;
        if self.given.is_without_drive() {
            let sentence = "Without a drive the body rests throughout that range.".to_owned();
            return Ok(DesignAnswer { sentence, rows: Vec::new() });
        }
        let found = if self.physical {
            let body = self.body(true, true)?;
            // The frequency of the drive is unknown: only its amplitude counts.
            let drive = self.drive(&body, self.one)?;
            design::frequency_bands(&body, &drive, low..=high)
        } else {
            design::bands(self.alpha()?, self.damping_ratio(), low..=high)
        };
        let found = found.map_err(|e| self.fail(e))?;
        let searched = found.is_searched();
        let row = |band: Result<Band<F>, Error>| {
            let band = band.map_err(|e| self.fail(e))?;
            let mut row = self.band([band.low, band.high], [band.low_edge, band.high_edge]);
            row.extend(searched.then(searched_field));
            Ok(row)
        };
        let rows = found.map(row).collect::<Result<Vec<_>, Failure>>()?;
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

    /// The static friction that holds the body under a drive of one frequency: as great as the force on it.
    fn holding_friction(&self) -> Result<DesignAnswer<F>, Failure> {
        let (input, _) = self.given.amplitude()?;
        let has_frequency = self.given.has(Input::Frequency);
        let is_constant = matches!(input, Input::Force | Input::BaseAcceleration | Input::FootDisplacement);
        if !is_constant && !has_frequency {
            let text =
                "--frequency is missing, or --friction, whose answer is the frequency up to which it holds";
            return Err(text.to_owned().into());
        }
        let frequency = if has_frequency { self.frequency()? } else { self.one };
        let body =
            self.body(matches!(input, Input::FootDisplacement | Input::DampedFootDisplacement), false)?;
        let force = if self.given.is_without_drive() {
            F::int(0)
        } else {
            self.drive(&body, frequency)?.force_amplitude(&body)
        };
        let coefficient = force / (body.mass() * self.given.gravity()?);
        let sentence = format!(
            "A static friction of at least {} {}, a coefficient of {}, holds the body at rest.",
            digits(force),
            self.system().force(),
            digits(coefficient)
        );
        let fields = vec![
            ("static_friction", Kind::Force, some(force)),
            ("static_friction_coefficient", Kind::Ratio, some(coefficient)),
        ];
        Ok(DesignAnswer::one(sentence, fields))
    }

    fn holding(&self) -> Result<DesignAnswer<F>, Failure> {
        if !self.given.has_role(Role::Friction) {
            return self.holding_friction();
        }
        if self.given.has(Input::Frequency) {
            let frequency = self.given.label(Input::Frequency);
            return Err(format!("{frequency}: must be left out beside a friction").into());
        }
        let body = self.body(true, true)?;
        let found = if self.given.is_without_drive() {
            Holding::Always
        } else if self.is_without_friction {
            Holding::Never
        } else {
            let drive = self.drive(&body, self.one)?;
            design::holding_frequency(&body, &drive).map_err(|e| self.fail(e))?
        };
        let static_friction = body.static_friction_ratio() * body.friction_bound();
        let static_friction = if self.is_without_friction { F::int(0) } else { static_friction };
        let force = format!("{} {}", digits(static_friction), self.system().force());
        let (holds, frequency, sentence) = match found {
            Holding::UpTo(frequency) => (
                "below",
                Some(frequency),
                format!(
                    "Friction holds a body at rest up to {} rad/s, where the force on it is {force}.",
                    digits(frequency)
                ),
            ),
            Holding::Always => {
                ("always", None, format!("Friction of {force} holds a body at rest at every frequency."))
            }
            Holding::Never | _ => {
                ("never", None, format!("Friction of {force} holds the body at no frequency."))
            }
        };
        let mut fields: AnswerRow<F> = vec![("holds", Kind::Ratio, Cell::Text(holds))];
        fields.push(("holding_frequency", Kind::Frequency, Cell::Number(frequency)));
        if frequency.is_none() && !self.args.answer.format.is_json("design")? {
            fields.pop();
        }
        Ok(DesignAnswer::one(sentence, fields))
    }

    /// A band of frequencies, or of Ω, and the kinds of its ends.
    fn band(&self, [low, high]: [F; 2], edges: [Edge; 2]) -> AnswerRow<F> {
        let ([from, to], kind) = if self.physical {
            (["frequency_from", "frequency_to"], Kind::Frequency)
        } else {
            (["omega_from", "omega_to"], Kind::Ratio)
        };
        let [low_edge, high_edge] =
            edges.map(|edge| Cell::Text(if edge == Edge::Range { "end-of-range" } else { "border" }));
        vec![
            (from, kind, some(low)),
            (to, kind, some(high)),
            ("low_edge", Kind::Ratio, low_edge),
            ("high_edge", Kind::Ratio, high_edge),
        ]
    }

    /// The force for a target, by the function of a body in units or that of ratios.
    fn force_for(
        &self,
        target: Kind,
        in_units: fn(&Oscillator<F>, F, F) -> Result<F, Error>,
        in_ratios: fn(F, F, F) -> Result<F, Error>,
    ) -> Result<DesignAnswer<F>, Failure> {
        let target = self.target(target)?;
        let (found, name, kind, unit, shift) = if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            let found = in_units(&body, frequency, target);
            (found, "force", Kind::Force, self.system().force(), self.shift(&body)?)
        } else {
            let found = in_ratios(self.omega()?, self.damping_ratio(), target);
            (found, "force_ratio", Kind::Ratio, "r_y", Vec::new())
        };
        let force = found.map_err(|e| self.fail(e))?;
        let fields = [(name, kind, some(force))].into_iter().chain(shift).collect();
        Ok(DesignAnswer::one(format!("The force needed is {} {unit}.", digits(force)), fields))
    }

    /// The shift of the motion by a constant force, which changes no amplitude.
    fn shift(&self, body: &Oscillator<F>) -> Result<AnswerRow<F>, Failure> {
        if !self.given.has(Input::MeanForce) {
            return Ok(Vec::new());
        }
        Ok(vec![("mean_displacement", Kind::Length, some(input::mean_displacement(&self.given, body)?))])
    }
}

/// A force, the unbalance, and the amplitude of either kind of base motion that exerts this force on the body.
fn force_and_equals<F: Value>(
    given: &Given<F>,
    body: &Oscillator<F>,
    frequency: F,
    force: F,
) -> AnswerRow<F> {
    let equal = |name, kind, excitation| {
        let unit = Drive::new(excitation, F::int(1), frequency).map(|unit| unit.force_amplitude(body));
        (name, kind, Cell::Number(unit.ok().map(|unit| force / unit)))
    };
    let mut row = vec![
        ("force", Kind::Force, some(force)),
        equal("unbalance", Kind::Unbalance, Excitation::Unbalance),
        equal("foot_displacement", Kind::Length, Excitation::FootMotion),
        equal("base_displacement", Kind::Length, Excitation::SurfaceMotion),
        equal("base_acceleration", Kind::Acceleration, Excitation::SurfaceAcceleration),
    ];
    row.retain(|(name, ..)| *name != "foot_displacement" || !given.is_without_spring());
    row
}

/// The field that marks an answer found by search, without a proof that it is the only one or the best.
const fn searched_field<F>() -> (&'static str, Kind, Cell<F>) {
    ("found_by", Kind::Ratio, Cell::Text("search"))
}

fn some<F: Value>(x: F) -> Cell<F> {
    Cell::Number(Some(x))
}

impl<F: Value> AskedDesign<'_, F> {
    fn forces_without_stop(&self) -> Result<DesignAnswer<F>, Failure> {
        let (found, unit, mut fields, name, kind) = if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            let forces = design::forces_without_stop(&body, frequency).map_err(|e| self.fail(e))?;
            let fields = force_and_equals(&self.given, &body, frequency, forces.min());
            (forces, self.system().force(), fields, "no_stop_forces", Kind::Force)
        } else {
            self.one_friction()?;
            let omega = self.omega()?;
            let at = Ratios::new(omega, F::int(1)).and_then(|at| at.with_damping_ratio(self.damping_ratio()));
            let ratios = NoStop::of(&at.map_err(|e| self.fail(e))?);
            let least = ("force_ratio", Kind::Ratio, some(ratios.min()));
            let fields = vec![("omega", Kind::Ratio, some(omega)), least];
            (ratios, "r_y", fields, "no_stop_force_ratios", Kind::Ratio)
        };
        fields.push((name, kind, Cells::intervals(&found)));
        Ok(DesignAnswer::one(format!("The body does not stop {}.", note::no_stop(&found, unit)), fields))
    }

    fn bands_without_stop(&self) -> Result<DesignAnswer<F>, Failure> {
        let (low, high) = self.range(Kind::Frequency)?;
        self.driven()?;
        let found = if self.physical {
            let body = self.body(true, true)?;
            // The frequency of the drive is unknown: only its amplitude counts.
            let drive = self.drive(&body, self.one)?;
            design::frequency_bands_without_stop(&body, &drive, low..=high)
        } else {
            self.one_friction()?;
            design::bands_without_stop(self.alpha()?, self.damping_ratio(), low..=high)
        };
        let row = |band: Band<F>| {
            let mut row = self.band([band.low, band.high], [band.low_edge, band.high_edge]);
            let reversals = Cell::Count(Some(band.reversals_per_cycle.into()));
            row.push(("reversals_per_cycle", Kind::Ratio, reversals));
            row
        };
        let rows: Vec<_> = found.map_err(|e| self.fail(e))?.into_iter().map(row).collect();
        let sentence = match rows.len() {
            0 => "The body stops or rests throughout that range.".to_owned(),
            1 => "The body does not stop in one band of that range:".to_owned(),
            n => format!("The body does not stop in {n} bands of that range:"),
        };
        Ok(DesignAnswer { sentence, rows })
    }
}

/// The quantity whose bound is asked for: a force, or a friction.
struct Divided<'a, F> {
    /// Whether it is a force, or a friction force as a part of the force.
    is_force: bool,
    /// The names of the one that releases a body at rest, and of the one that suffices for every start.
    names: [&'static str; 2],
    kind: Kind,
    /// The size of r_y, or for a friction that of the force.
    scale: F,
    unit: &'a str,
}

impl<F: Value> DesignAnswer<F> {
    /// The answer where static friction divides it into three; otherwise as it is.
    fn divided(mut self, ratios: &Ratios<F>, of: &Divided<'_, F>) -> Self {
        if !ratios.has_higher_static_friction() {
            return self;
        }
        let (eta, found, one) = (ratios.static_friction_ratio(), NoStop::of(ratios), F::int(1));
        let Divided { is_force, names: [release, every_start], kind, scale, unit } = *of;
        let text = |x: F| format!("{} {unit}", digits(if is_force { x * scale } else { one / x * scale }));
        let [released, with, more, bound] = if is_force {
            ["above a force of", "at", "more", "above"]
        } else {
            ["with a friction force below", "with", "less", "below"]
        };
        let of_every_start = match found.every_start {
            Some(least) => format!("Every start leads to sliding without a stop {bound} {}.", text(least)),
            None => "The start decides between this motion and others.".to_owned(),
        };
        self.sentence = format!(
            "A body at rest is released {released} {}. A motion without a stop exists and attracts its \
             neighbourhood {with} {} or {more}. {of_every_start}",
            text(eta),
            text(found.border)
        );
        let value = |x: F| some(if is_force { x * scale } else { scale / x });
        let release = (release, kind, value(eta));
        let bound = found.every_start.map(|bound| (every_start, kind, value(bound)));
        self.rows.iter_mut().for_each(|row| row.extend([release].into_iter().chain(bound)));
        self
    }
}
