//! The picture of a map.

use super::BORDER_POINTS;
use super::limits;
use super::points::{Absence, Map, Mapped, margin};
use super::resonance::is_unbounded;
use super::symmetry::Breaks;
use crate::bits::digits;
use crate::failure::{Failure, Outcome};
use crate::grid::Grid;
use crate::input;
use crate::outputs;
use crate::row::Cell;
use std::collections::BTreeSet;
use stickslip_draw::{Axis, Figure, Panel, Plane, Scale, Series, Style};
use stickslip_front::inputs::{Input, Role};

impl Map<'_> {
    /// The meaning of the colours, in words, with the unit.
    fn label(&self) -> (String, String) {
        let words = match self.quantity.mapped {
            Mapped::Regime => "regime".to_owned(),
            Mapped::Margin => "margin over the sticking threshold, α/α_min".to_owned(),
            Mapped::Stops if self.has_static_friction() => "stops in a cycle, from rest".to_owned(),
            Mapped::Stops => "stops in a cycle".to_owned(),
            Mapped::Limits => format!("limits from {} starts", limits::STARTS),
            Mapped::Output => outputs::in_words(self.quantity.name),
        };
        let unit = match self.kind {
            Some(kind) => self.system.name(kind),
            None => outputs::find(self.quantity.name).map_or("", |key| key.measure.unit()).to_owned(),
        };
        let label =
            if matches!(unit.as_str(), "" | "1") { words.clone() } else { format!("{words} ({unit})") };
        (words, label)
    }

    fn has_static_friction(&self) -> bool {
        let given = self.axes.given_at(0);
        given.has_role(Role::StaticFriction)
            && input::point(&given).is_ok_and(|p| p.ratios.has_higher_static_friction())
    }

    /// The sticking threshold, computed from the border itself, if the vertical axis is α or proportional to
    /// it.
    fn border(&self) -> Vec<(f64, f64)> {
        let up = self.up.0;
        let inverse = matches!(up, Input::Friction | Input::FrictionCoefficient);
        if !inverse && up.role() != Role::Drive {
            return Vec::new();
        }
        let (low, _) = self.up.1.ends();
        let mut given = self.axes.given_at(0);
        let (across, upwards) = (self.on_axis(self.across.0).1, self.on_axis(up).1);
        let mut points = Vec::new();
        for i in 0..=BORDER_POINTS {
            let x = self.across.1.at(f64::from(i) / f64::from(BORDER_POINTS));
            given.set(self.across.0, x);
            given.set(up, low);
            let Ok(point) = input::point(&given) else { continue };
            let margin = margin(point.ratios);
            points.push((x * across, upwards * if inverse { low * margin } else { low / margin }));
        }
        points
    }

    /// The scale, reversed for the fraction of time at rest: as in all pictures, light shades mean motion.
    fn lit(&self, scale: Scale) -> Scale {
        match scale {
            Scale::Shades { low, high, logarithmic } if self.quantity.name == "stick_fraction" => {
                Scale::Shades { low: high, high: low, logarithmic }
            }
            Scale::Shades { .. } | Scale::Names(_) => scale,
        }
    }

    /// Fails if a picture would be too large.
    fn drawable(&self) -> Outcome {
        let (points, (x, y)) = (self.axes.len(), (self.across.0.option(), self.up.0.option()));
        if points > MOST {
            return Err(format!("{x}, {y}: {points} points, must be ≤ {MOST} in a picture").into());
        }
        for (parameter, grid) in [&self.across, &self.up] {
            if grid.len() > MOST_ACROSS {
                return Err(format!(
                    "{}: {} values, must be ≤ {MOST_ACROSS} in a picture",
                    parameter.option(),
                    grid.len()
                )
                .into());
            }
        }
        Ok(())
    }

    fn axis(&self, (parameter, grid): &(Input, Grid<f64>), ends: (f64, f64)) -> Axis {
        let label = match (self.on_axis(*parameter).0, *parameter) {
            (_, Input::Omega) => "frequency ratio Ω = ω_d/ω_n".to_owned(),
            (_, Input::Alpha) => "force ratio α = p₀/r_y".to_owned(),
            (unit, Input::Frequency) => format!("frequency ({unit})"),
            (unit, _) if unit.is_empty() => parameter.symbol().to_owned(),
            (unit, _) => format!("{} ({unit})", parameter.symbol()),
        };
        grid.axis(&label, ends)
    }

    pub(super) fn picture(&self) -> Result<Figure, Failure> {
        self.drawable()?;
        let values = |(parameter, grid): &(Input, Grid<f64>)| -> Vec<f64> {
            grid.values().map(|v| v * self.on_axis(*parameter).1).collect()
        };
        let (Some(across), Some(up)) = (ends(&values(&self.across)), ends(&values(&self.up))) else {
            let (x, y) = (self.across.0.option(), self.up.0.option());
            return Err(format!("{x}, {y}: a picture needs two values or more, ascending").into());
        };
        let (columns, is_asked) = self.columns();
        let columns = (self.across.0, Grid::List(columns));
        let (x, y) = (values(&columns), values(&self.up));
        let mut axes = self.axes.clone();
        axes.order([self.up.clone(), columns]);
        // The names from the lightest colour, for a body that never stops, to the darkest, for one at rest;
        // others are appended.
        let regimes: &[&str] = if self.has_static_friction() {
            &["non-sticking", "unbounded", "depends-on-start", "sticking", "stuck"]
        } else {
            &["non-sticking", "unbounded", "sticking", "stuck"]
        };
        let known = if matches!(self.quantity.mapped, Mapped::Limits) { &limits::NAMES[..] } else { regimes };
        let mut names: Vec<String> = known.iter().map(|name| (*name).to_owned()).collect();
        let mut named = false;
        let mut values = Vec::new();
        let (mut whole, mut absences) = (true, BTreeSet::new());
        // The values at the requested points, which alone determine the shades.
        let mut asked = Vec::new();
        let mut asked_so_far = is_asked.iter().cycle();
        self.cells(&axes, |given, found| {
            let value = match found.cell {
                // The line of unbounded motion shows these points.
                Cell::Text(_) if matches!(self.quantity.mapped, Mapped::Regime) && is_unbounded(&given) => {
                    f64::NAN
                }
                Cell::Text(name) => {
                    named = true;
                    place_of(name, &mut names)
                }
                Cell::Count(count) => count.map_or(f64::NAN, |n| n as f64),
                Cell::Number(number) => {
                    whole = false;
                    number.and_then(|number| number.double()).unwrap_or(f64::NAN)
                }
                Cell::Flag(Some(flag)) => {
                    named = true;
                    place_of(if flag { "true" } else { "false" }, &mut names)
                }
                Cell::Flag(None) | Cell::Pairs(_) | Cell::Intervals(_) => f64::NAN,
            };
            // The line of unbounded motion explains its own points.
            if value.is_nan() && !is_unbounded(&given) {
                absences.insert(found.absence);
            }
            values.push(value);
            if asked_so_far.next() == Some(&true) {
                asked.push(value);
            }
            Ok(())
        })?;
        let (words, label) = self.label();
        let mut title = capital(&words);
        let scale = match (named, whole) {
            (true, _) => Scale::Names(names),
            (false, true) => counted(&mut values),
            (false, false) => match (self.range, Plane::shades(&values)) {
                (Some((low, high)), Scale::Shades { logarithmic, .. }) => {
                    self.lit(Scale::Shades { low, high, logarithmic: logarithmic && low > 0.0 })
                }
                (_, scale) => self.lit(clipped(scale, &asked, &mut title)),
            },
        };
        let mut series = Vec::new();
        let border = self.border();
        if !border.is_empty() {
            let name = if self.has_static_friction() {
                "threshold of the cycle without a stop"
            } else {
                "sticking threshold"
            };
            series.push(Series::new(name, Style::Thick, 0, border));
        }
        let unbounded = self.unbounded();
        if unbounded.iter().any(|(x, y)| y.is_finite() && (across.0..=across.1).contains(x)) {
            series.push(Series::new("unbounded", Style::Line, 3, unbounded));
        }
        let Breaks { by_multiplier, others, missing } = self.breaks()?;
        let lines = [
            ("symmetry breaks at a multiplier of −1", 1, by_multiplier),
            ("a symmetric motion ends by a jump or a fold", 3, others),
        ];
        for (name, index, points) in lines.into_iter().filter(|(.., points)| !points.is_empty()) {
            series.push(Series::new(name, Style::Dots, index, points));
        }
        if missing > 0 {
            let note = format!("points missing at {missing} values, where the search reached its bound");
            series.push(Series::new(note, Style::Note, 0, []));
        }
        if !absences.is_empty() {
            let words: Vec<&str> = absences.into_iter().map(Absence::in_words).collect();
            series.push(Series::new(format!("white: {}", words.join(", ")), Style::Note, 0, []));
        }
        Ok(Figure::new(
            "map",
            title,
            "",
            vec![
                Panel::new(
                    self.machine.clone(),
                    self.axis(&self.across, across),
                    self.axis(&self.up, up),
                    series,
                )
                .over(Plane { label, x, y, values, scale }),
            ],
        ))
    }
}

/// The greatest number of points of a picture, in total and in one direction: it must fit in memory, and more
/// would not be visible.
const MOST: u64 = 4_000_000;
const MOST_ACROSS: u64 = 20_000;
/// The count that stands for all greater ones.
const MOST_NAMES: f64 = 7.0;
/// Shades for values that exceed nearly all others by this factor are cut off as those of a pole.
const POLE: f64 = 100.0;

/// A name for each count, the last one for all greater counts, because a longer key is hard to read.
fn counted(values: &mut [f64]) -> Scale {
    let most = values.iter().copied().filter(|v| v.is_finite()).fold(0.0, f64::max);
    let mut names: Vec<String> = (0..=most.min(MOST_NAMES) as u64).map(|n| n.to_string()).collect();
    if most > MOST_NAMES {
        // NaN remains without a name.
        values.iter_mut().filter(|value| **value > MOST_NAMES).for_each(|value| *value = MOST_NAMES);
        if let Some(last) = names.last_mut() {
            last.push_str(" or more");
        }
    }
    Scale::Names(names)
}

/// The shades without values close to a pole, from the values at the requested points; the title mentions the
/// cut-off.
fn clipped(scale: Scale, values: &[f64], title: &mut String) -> Scale {
    let Scale::Shades { low, high, logarithmic: true } = scale else { return scale };
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_by(f64::total_cmp);
    let at = |share: f64| sorted.get((sorted.len() as f64 * share) as usize).copied();
    let (Some(few), Some(most)) = (at(0.05), at(0.95)) else { return scale };
    let (new_low, new_high) = (low.max(few / POLE), high.min(most * POLE));
    match (new_low > low, new_high < high) {
        (false, false) => {}
        (true, false) => title.push_str(&format!(", cut off below {}", digits(round(new_low)))),
        (false, true) => title.push_str(&format!(", cut off above {}", digits(round(new_high)))),
        (true, true) => title.push_str(&format!(
            ", cut off below {} and above {}",
            digits(round(new_low)),
            digits(round(new_high))
        )),
    }
    let cut = |new: f64, old: f64| if new == old { old } else { round(new) };
    Scale::Shades { low: cut(new_low, low), high: cut(new_high, high), logarithmic: true }
}

/// The nearest power of ten.
fn round(value: f64) -> f64 {
    10f64.powf(value.log10().round())
}

/// The text with an initial capital.
pub(crate) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

/// The first and the last value, if the values are ascending.
pub(crate) fn ends(values: &[f64]) -> Option<(f64, f64)> {
    let ascending = values.windows(2).all(|pair| matches!(pair, [a, b] if a < b));
    match values {
        [first, .., last] if ascending => Some((*first, *last)),
        _ => None,
    }
}

/// The index of a name in the list; a new name is appended.
fn place_of(name: &str, names: &mut Vec<String>) -> f64 {
    let place = names.iter().position(|n| n == name).unwrap_or_else(|| {
        names.push(name.to_owned());
        names.len() - 1
    });
    place as f64
}
