//! `stickslip response-curve`: an amplitude over the frequency, for one machine or several, stops included.

mod amplitude;
mod picture;

use crate::args::{Curve, CurveArgs};
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::given::{Given, Parameter as P};
use crate::grid::Grid;
use crate::input::{self, Point};
use crate::interrupt;
use crate::map::margin;
use crate::note::digits;
use amplitude::words;
use clap::ValueEnum;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::f64::consts::TAU;
use std::io::Write;
use stickslip::Response;
use stickslip::units::{Reader, System};

/// The greatest number of curves in a picture: with the border, the resonance and the dashes, the key then
/// has eight lines.
const MOST_CURVES: u64 = 5;
/// The greatest number of frequencies of a curve.
const MOST_POINTS: u64 = 100_000;

/// One frequency of a curve.
#[derive(Clone, Copy)]
struct Place {
    frequency: f64,
    regime: &'static str,
    sticks: bool,
    /// The margin to the border, α/α_min.
    margin: f64,
    value: Option<f64>,
}

struct Line {
    name: String,
    places: Vec<Place>,
    /// The points at which the curve meets the border of sticking.
    border: Vec<(f64, f64)>,
    /// The position of Ω = 1 on the axis.
    natural: f64,
}

/// The request: the quantity over one axis, for each value of another.
struct Asked {
    what: Curve,
    axis: P,
    grid: Grid<f64>,
    other: Option<(P, Grid<f64>, Vec<String>)>,
    given: Given<f64>,
    system: System,
}

pub(crate) fn run(args: &CurveArgs, out: &mut impl Write) -> Outcome {
    let target = Target::new(args.out.as_deref(), args.overwrite)?;
    let reader = args.units.reader();
    let asked = Asked::new(args, &reader)?;
    let lines = asked.lines()?;
    target.fill(out, |mut out| asked.rows(&lines, &mut out), || asked.figure(&lines))
}

impl Asked {
    fn new(args: &CurveArgs, reader: &Reader) -> Result<Self, Failure> {
        let mut given = Given::empty(reader.system());
        let (mut grid, mut other) = (None, None);
        for (parameter, text) in Given::<f64>::typed(&args.machine, &args.force) {
            let name = parameter.option();
            let values = Grid::with_units(name, text, reader, parameter.kind())?;
            let is_axis = matches!(parameter, P::Omega | P::Frequency) && values.len() > 1;
            if is_axis {
                if let Some((first, _)) = grid.replace((parameter, values)) {
                    let first: P = first;
                    return Err(Failure::Input(format!(
                        "{} and {name}: give one of the two as a grid",
                        first.option()
                    )));
                }
            } else if values.len() > 1 {
                if values.len() > MOST_CURVES {
                    return Err(Failure::Input(format!(
                        "{name} {text}: {} curves, must be ≤ {MOST_CURVES}",
                        values.len()
                    )));
                }
                let texts = text.split(',').map(|part| part.trim().to_owned()).collect();
                if let Some((first, ..)) = other.replace((parameter, values, texts)) {
                    let first: P = first;
                    return Err(Failure::Input(format!(
                        "{} and {name}: only one of them may be a list",
                        first.option()
                    )));
                }
            } else {
                given.set_typed(parameter, values.value(0), text);
            }
        }
        let Some((axis, grid)) = grid else {
            return Err(Failure::Input(
                "--frequency (or --omega): give a grid, such as 0.3Hz:5Hz:200".to_owned(),
            ));
        };
        if grid.len() > MOST_POINTS {
            return Err(Failure::Input(format!(
                "{}: {} frequencies, must be ≤ {MOST_POINTS}",
                axis.option(),
                grid.len()
            )));
        }
        Ok(Self { what: args.what, axis, grid, other, given, system: reader.system() })
    }

    fn lines(&self) -> Result<Vec<Line>, Failure> {
        let count = self.other.as_ref().map_or(1, |(_, values, _)| values.len());
        (0..count)
            .map(|i| {
                let mut given = self.given.clone();
                let name = match &self.other {
                    Some((parameter, values, texts)) => {
                        given.set(*parameter, values.value(i));
                        let text = usize::try_from(i).ok().and_then(|i| texts.get(i)).cloned();
                        format!("{} {}", parameter.symbol(), text.unwrap_or_else(|| digits(values.value(i))))
                    }
                    None => words(self.what).to_owned(),
                };
                self.line(name, &given)
            })
            .collect()
    }

    fn line(&self, name: String, given: &Given<f64>) -> Result<Line, Failure> {
        let at = |place: u64| {
            let mut given = given.clone();
            given.set(self.axis, self.grid.value(place));
            if interrupt::asked() {
                return Err(Failure::Interrupted);
            }
            input::point(&given)
        };
        let first = at(0)?;
        if self.what == Curve::Absolute
            && !first.machine.as_ref().is_some_and(|m| m.drive.excitation().carries_surface())
        {
            return Err(Failure::Input(
                "response-curve absolute: needs --base-acceleration, --base-velocity or --base-displacement"
                    .to_owned(),
            ));
        }
        let natural = first.machine.as_ref().map_or(1.0, |m| m.oscillator.natural_frequency() / TAU);
        let places = (0..self.grid.len()).into_par_iter().map(|place| self.place(&at(place)?));
        let places = places.collect::<Result<Vec<_>, Failure>>()?;
        let mut border = Vec::new();
        for (pair, next) in places.windows(2).zip(1..) {
            if let [a, b] = pair
                && (a.margin >= 1.0) != (b.margin >= 1.0)
            {
                border.extend(self.crossing(given, (self.grid.value(next - 1), self.grid.value(next)))?);
            }
        }
        Ok(Line { name, places, border, natural: self.natural(&first, natural) })
    }

    fn place(&self, point: &Point<f64>) -> Result<Place, Failure> {
        let response = Response::new(point.ratios);
        let margin = margin(&response);
        let (value, regime, sticks) = self.value(point, &response)?;
        Ok(Place { frequency: self.on_axis(point), regime, sticks, margin, value })
    }

    /// The point where the curve meets the border, between two frequencies on either side of it: by
    /// bisection, to the last bit.
    fn crossing(&self, given: &Given<f64>, (from, to): (f64, f64)) -> Result<Option<(f64, f64)>, Failure> {
        let at = |x: f64| {
            let mut given = given.clone();
            given.set(self.axis, x);
            input::point(&given)
        };
        let slides = |point: &Point<f64>| margin(&Response::new(point.ratios)) >= 1.0;
        let (mut inside, mut outside) = if slides(&at(from)?) { (from, to) } else { (to, from) };
        loop {
            let middle = inside + (outside - inside) / 2.0;
            if middle == inside || middle == outside {
                let place = self.place(&at(inside)?)?;
                return Ok(place.value.map(|value| (place.frequency, value)));
            }
            if slides(&at(middle)?) { inside = middle } else { outside = middle }
        }
    }

    /// The position on the axis: the frequency in hertz for a machine, Ω for ratios.
    fn on_axis(&self, point: &Point<f64>) -> f64 {
        point.machine.as_ref().map_or(point.ratios.omega(), |m| m.drive.angular_frequency() / TAU)
    }

    /// The position of Ω = 1, if the axis has one.
    fn natural(&self, first: &Point<f64>, natural: f64) -> f64 {
        // A machine that is tuned to each frequency has no single natural frequency.
        if first.machine.is_some() && self.axis == P::Omega { f64::NAN } else { natural }
    }

    fn is_machine(&self) -> bool {
        self.axis.is_physical() || self.given.is_physical()
    }

    fn rows(&self, lines: &[Line], out: &mut impl Write) -> Outcome {
        let what = self.what.to_possible_value().map_or(String::new(), |v| v.get_name().to_owned());
        let unit = self
            .label()
            .rsplit_once('(')
            .map_or("p₀".to_owned(), |(_, u)| u.trim_end_matches(')').to_owned());
        let axis = if self.is_machine() { "frequency[Hz]" } else { "omega[1]" };
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record(["curve", axis, "regime", &format!("{what}[{unit}]"), "margin[1]"])?;
        for line in lines {
            for place in &line.places {
                let value = place.value.map_or(String::new(), |x| x.to_string());
                let (frequency, margin) = (place.frequency.to_string(), place.margin.to_string());
                writer.write_record([&line.name, &frequency, place.regime, &value, &margin])?;
            }
        }
        Ok(writer.flush()?)
    }
}

#[cfg(test)]
mod tests {
    use super::{Asked, margin};
    use crate::args::{Command, CommandLine};
    use crate::input;
    use clap::Parser;
    use stickslip::Response;

    #[test]
    fn curves_meet_the_border_on_the_border() {
        let words = "stickslip response-curve --omega 0.2:2:30 --alpha 1.3,1.5,4 --damping-ratio 0.05";
        let Command::ResponseCurve(args) = CommandLine::parse_from(words.split(' ')).command else {
            panic!()
        };
        let asked = Asked::new(&args, &args.units.reader()).ok().unwrap();
        let lines = asked.lines().ok().unwrap();
        let mut met = 0;
        for (line, alpha) in lines.iter().zip([1.3, 1.5, 4.0]) {
            for &(omega, amplification) in &line.border {
                let mut given = asked.given.clone();
                given.set(asked.axis, omega);
                given.set(asked.other.as_ref().unwrap().0, alpha);
                let point = input::point(&given).ok().unwrap();
                assert!((margin(&Response::new(point.ratios)) - 1.0).abs() < 1e-14, "{alpha} {omega}");
                let cycle = stickslip::Cycle::new(point.ratios).unwrap();
                assert_eq!(amplification, cycle.max_displacement * (1.0 / alpha));
                met += 1;
            }
        }
        assert!(met >= 3, "{met}");
    }
}
