//! The picture of spectra.

use super::Spectra;
use crate::bits::digits;
use crate::failure::Failure;
use crate::grid::Grid;
use crate::input;
use crate::progress;
use stickslip::motion::record::RecordAnswer;
use stickslip_draw::{Figure, Panel, Series, Style};
use stickslip_front::inputs::Input;
use stickslip_front::inputs::units::Kind;

/// Colours of the values of the second grid; similar ones with colour blindness are left out.
const INDICES: [usize; 5] = [2, 1, 4, 5, 6];

/// The number of marks on a line.
const MARKS: usize = 12;

/// The panels: a title, the kind of the values, and the value.
type Shown = (&'static str, Kind, fn(&RecordAnswer<f64>) -> f64);

const SHOWN: [Shown; 3] = [
    ("peak displacement", Kind::Length, |answer| {
        answer.max_displacement.abs().max(answer.min_displacement.abs())
    }),
    ("residual displacement", Kind::Length, |answer| answer.residual_displacement.map_or(f64::NAN, f64::abs)),
    ("peak absolute acceleration", Kind::Acceleration, |answer| answer.max_absolute_acceleration),
];

impl Spectra<'_> {
    /// One panel for each quantity, with a line for each record and each value of a second grid, and the mean of the
    /// records.
    pub(super) fn figure(&self) -> Result<Figure, Failure> {
        let grids = self.axes.grids();
        let bad = |text: String| Err(text.into());
        let is_period = |(input, _): &&(Input, Grid<f64>)| *input == Input::Period;
        let Some((axis, grid)) = grids.iter().find(is_period).or(grids.first()) else {
            return bad("--picture: needs a grid, such as --period 0.1s:4s:100:log".to_owned());
        };
        let others: Vec<_> = grids.iter().filter(|(input, _)| input != axis).collect();
        let other = match others.as_slice() {
            [] => None,
            [other] if other.1.len() <= INDICES.len() as u64 => Some(*other),
            [other] => {
                let (name, count) = (other.0.option(), other.1.len());
                return bad(format!("{name}: {count} values, must be ≤ {} in a picture", INDICES.len()));
            }
            _ => return bad("--picture: must have two grids at most".to_owned()),
        };
        let mut answers = Vec::new();
        let all = 0..self.axes.len() * self.loads.len() as u64;
        progress::in_order_kept(
            all,
            |points| self.answers(points),
            |answer| {
                answers.extend(answer.map(|(_, answer)| answer));
                Ok(())
            },
        )?;
        let unit = |kind: Kind| match (kind, self.frequency) {
            (Kind::Frequency, Some((unit, _))) => unit.to_owned(),
            _ => self.system.name(kind),
        };
        let label = |name: &str, kind: Kind| {
            if kind == Kind::Ratio { name.to_owned() } else { format!("{name} ({})", unit(kind)) }
        };
        let name = label(&axis.name().replace('-', " "), axis.kind());
        let place_of = |value: f64| self.shown(*axis, value);
        let x = grid.axis(&name, (place_of(grid.ends().0), place_of(grid.ends().1)));
        let (count, bodies) = (grid.len(), self.axes.len());
        // The grids vary in their order, the last fastest.
        let is_slow = grids.first().is_some_and(|(input, _)| input == axis);
        let lines = other.map_or(1, |(_, values)| values.len());
        let marked = match usize::try_from(count) {
            Ok(count) if lines > 1 => Style::Marked(count / MARKS + 1),
            _ => Style::Line,
        };
        let body = |place: u64, line: u64| if is_slow { place * lines + line } else { line * count + place };
        let panels = SHOWN.map(|(title, kind, value)| {
            let at = |load: u64, line: u64, place: u64| {
                let index = usize::try_from(load * bodies + body(place, line)).unwrap_or(usize::MAX);
                answers
                    .get(index)
                    .and_then(Option::as_ref)
                    .map_or(f64::NAN, |answer| self.system.shown(kind, value(answer)))
            };
            let mut series = Vec::new();
            let mut heights = vec![0.0];
            for (line, index) in (0..lines).zip(INDICES) {
                let of = other.map_or(String::new(), |(input, values)| {
                    input::in_symbols(
                        *input,
                        &digits(self.system.shown(input.kind(), values.value(line))),
                        &self.system,
                    )
                });
                let loads = self.loads.len() as u64;
                // Few records have a colour and a name each.
                let are_named = other.is_none() && loads > 1 && loads <= INDICES.len() as u64;
                for ((load, (name, _)), own) in (0..).zip(&self.loads).zip(INDICES.iter().cycle()) {
                    let points: Vec<_> = (0..count)
                        .map(|place| (place_of(grid.value(place)), at(load, line, place)))
                        .collect();
                    heights.extend(points.iter().map(|(_, height)| *height));
                    let name = match (loads, other) {
                        (1, Some(_)) => of.clone(),
                        (1, None) => (*name).to_owned(),
                        _ if are_named => (*name).to_owned(),
                        _ if load == 0 && line == 0 => "each record".to_owned(),
                        _ => String::new(),
                    };
                    let style = if loads == 1 || are_named { marked } else { Style::Dotted };
                    // The only record stands in the title.
                    let key = if loads == 1 && other.is_none() { String::new() } else { name.clone() };
                    let index = if are_named { *own } else { index };
                    series.push(Series::new(name, style, index, points).with_key(key));
                }
                if loads > 1 {
                    let mean =
                        |place: u64| (0..loads).map(|load| at(load, line, place)).sum::<f64>() / loads as f64;
                    let points = (0..count).map(|place| (place_of(grid.value(place)), mean(place)));
                    let name = if of.is_empty() { "mean".to_owned() } else { format!("mean, {of}") };
                    let (style, index) = if are_named { (Style::Thick, 0) } else { (marked, index) };
                    series.push(Series::new(name, style, index, points));
                }
            }
            let label = label(title, kind);
            Panel::new(title, x.clone(), crate::motion_plot::axis(&label, heights.into_iter(), 0.05), series)
        });
        let (first, count) = (self.loads.first().map_or("", |(name, _)| name), self.loads.len());
        let records = if count == 1 { first.to_owned() } else { format!("{count} records") };
        let is_fixed = |input| grids.iter().all(|(other, _)| *other != input);
        let machine = input::line(&self.args.machine, is_fixed, &self.system);
        let title = if machine.is_empty() {
            format!("Spectra of {records}")
        } else {
            format!("Spectra of {records}: {machine}")
        };
        Ok(Figure::new("spectrum", title, "", panels).stacked())
    }
}
