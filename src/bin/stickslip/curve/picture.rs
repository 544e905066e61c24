//! The picture of response curves.

use super::{Asked, Line, Place, words};
use crate::failure::Failure;
use crate::map::capital;
use crate::note::digits;
use stickslip::figures::{Axis, Figure, Panel, Series, Style};

/// The range of the vertical axis; a value below it looks like rest.
const DECADES: f64 = 1e4;
/// Colours and marks of the curves. Colours that are similar with colour blindness are omitted, and black is
/// reserved for the border and the resonance, which all pictures have.
const INDICES: [usize; 5] = [2, 1, 4, 5, 6];
/// The number of marks on a curve.
const MARKS: usize = 12;

impl Asked {
    pub(super) fn figure(&self, lines: &[Line]) -> Result<Figure, Failure> {
        let frequencies = || lines.iter().flat_map(|line| &line.places).map(|place| place.frequency);
        let (left, right) =
            (frequencies().fold(f64::INFINITY, f64::min), frequencies().fold(0.0f64, f64::max));
        if left >= right {
            return Err(Failure::Input(format!("{}: a picture needs two frequencies", self.axis.option())));
        }
        let name = if self.is_machine() { "frequency (Hz)" } else { "frequency ratio Ω = ω_d/ω_n" };
        let x = if self.grid.is_logarithmic() {
            Axis::logarithmic(name, left, right)
        } else {
            Axis::linear(name, left, right)
        };
        let (low, high, clipped) = self.range(lines);
        let y = Axis::logarithmic(&self.label(), low, high);
        let mut series = Vec::new();
        let naturals: Vec<f64> = lines.iter().map(|line| line.natural).collect();
        let one = naturals.windows(2).all(|pair| matches!(pair, [a, b] if (a / b - 1.0).abs() < 1e-9));
        if let Some(&natural) = naturals.first().filter(|n| one && **n > left && **n < right) {
            series.push(Series::new(
                "natural frequency",
                Style::Dotted,
                0,
                [(natural, low), (natural, high)],
            ));
        }
        for (line, index) in lines.iter().zip(INDICES) {
            let part = |sticks: bool| {
                let points = line.places.iter().enumerate().map(move |(i, place)| {
                    // Both parts include the point where they meet, so that there is no gap.
                    let beside = line.places.get(i + 1).is_some_and(|next| next.sticks == sticks);
                    let shown = place.sticks == sticks || (sticks && beside);
                    let value = place.value.filter(|v| shown && *v >= low).unwrap_or(f64::NAN);
                    (place.frequency, value)
                });
                points.collect::<Vec<_>>()
            };
            // Offset so that the marks of coinciding curves do not coincide.
            let style =
                if lines.len() > 1 { Style::Marked(line.places.len() / MARKS + index) } else { Style::Line };
            series.push(Series::new(line.name.clone(), style, index, part(false)));
            series.push(Series::new("", Style::Dashed, index, part(true)));
        }
        let within = |(_, value): &(f64, f64)| *value >= low && *value <= high;
        let border: Vec<_> = lines.iter().flat_map(|line| &line.border).copied().filter(within).collect();
        let is_dashed = |place: &Place| place.sticks && place.value.is_some();
        if lines.iter().flat_map(|line| &line.places).any(is_dashed) {
            series.push(Series::new("with stops (exact)", Style::Dashed, 0, []));
        }
        if !border.is_empty() {
            series.push(Series::new("border of sticking", Style::Marks, 0, border));
        }
        let mut title = format!("{} against frequency", capital(words(self.what)));
        if clipped {
            let rounded = format!("{high:.1e}").parse().unwrap_or(high);
            title.push_str(&format!(", cut off at {}", digits(rounded)));
        }
        Ok(Figure {
            name: "response-curve".to_owned(),
            title,
            caption: String::new(),
            panels: vec![Panel { title: String::new(), x, y, plane: None, series }],
        })
    }

    /// The ends of the vertical axis, and whether a pole is cut off.
    fn range(&self, lines: &[Line]) -> (f64, f64, bool) {
        let mut values: Vec<f64> = lines
            .iter()
            .flat_map(|line| &line.places)
            .filter_map(|place| place.value.filter(|v| *v > 0.0))
            .collect();
        values.sort_by(f64::total_cmp);
        let most = values.last().copied().unwrap_or(1.0);
        // A value that exceeds nine tenths of all points a hundredfold is due to a pole.
        let usual = values.get(values.len() * 9 / 10).copied().unwrap_or(most);
        let unbounded = lines.iter().flat_map(|line| &line.places).any(|place| place.regime == "unbounded");
        let high = if most > 100.0 * usual { 100.0 * usual } else { most };
        let least = values.iter().copied().find(|v| *v > high / DECADES).unwrap_or(high / 10.0);
        let (low, top) = (least / 1.25, high * 1.25);
        (low.min(top / 10.0), top, unbounded || most > high)
    }
}
