//! The picture of response curves.

use super::{AskedCurve, CurvePoint, Line, Source, shown};
use crate::bits::digits;
use crate::failure::Failure;
use crate::map::capital;
use stickslip_draw::{Axis, Figure, Panel, Series, Style};
use stickslip_front::curve::Place;
use stickslip_front::inputs::Input;

/// The part of the usual value below which a dip of a curve is cut off.
const LEAST: f64 = 1e-4;
/// The part of the usual value below which an end of a curve is cut off.
const LEAST_END: f64 = 1e-9;
/// The multiple of the usual value at which a curve without a bound is cut off.
const MOST: f64 = 100.0;
/// The multiple of the usual value up to which a peak is shown whole.
const MOST_OF_PEAK: f64 = 1e6;
/// The part of the axis on which the values are at most the usual one: a resonance takes less than the rest.
const USUAL: f64 = 0.75;
/// Colours and marks of the curves. Colours that are similar with colour blindness are omitted, and black is
/// reserved for the border and the resonance, which all pictures have.
const INDICES: [usize; 5] = [2, 1, 4, 5, 6];
/// The number of marks on a curve.
const MARKS: usize = 12;

impl AskedCurve {
    pub(super) fn figure(&self, lines: &[Line]) -> Result<Figure, Failure> {
        let frequencies = || lines.iter().flat_map(|line| &line.places).map(|place| place.frequency);
        let (left, right) =
            (frequencies().fold(f64::INFINITY, f64::min), frequencies().fold(0.0f64, f64::max));
        if left >= right {
            return Err(format!("{}: a picture needs two frequencies", self.axis.option()).into());
        }
        let (left, right) = self.look.x_range.unwrap_or((left, right));
        let frequency = format!("frequency ({})", self.unit.0);
        let name =
            if self.axis == Input::Frequency { frequency.as_str() } else { "frequency ratio Ω = ω_d/ω_n" };
        let x = self.grid.axis(name, (left, right));
        let all = VerticalRange::of(lines, self.grid.is_logarithmic());
        let range = match self.look.range {
            Some((low, high)) => VerticalRange { low, high, cut_below: false, cut_above: false },
            // A linear axis begins at 0.
            None if self.look.is_linear => VerticalRange { low: 0.0, cut_below: false, ..all },
            None => all,
        };
        let (low, high) = (range.low, range.high);
        let y = Axis::new(&self.label(), (low, high), !self.look.is_linear);
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
        // After the last colour the first one again, with another mark.
        let rounds = (0..).flat_map(|round| INDICES.map(|index| index + 7 * round));
        for (line, index) in lines.iter().zip(rounds) {
            let own = line.places.iter().map(|place| (place.frequency, place.height(), place.sticks));
            let met = line.border.iter().map(|&(frequency, value)| (frequency, value, false));
            let mut points: Vec<(f64, f64, bool)> = own.chain(met).collect();
            points.sort_by(|a, b| a.0.total_cmp(&b.0));
            let sticks = |i: Option<usize>| i.and_then(|i| points.get(i)).is_some_and(|point| point.2);
            let part = |with_stops: bool| {
                let part = points.iter().enumerate().map(|(i, &(frequency, value, own))| {
                    // A piece with a stop at one of its ends is dashed; the parts meet at the border.
                    let beside = own || sticks(i.checked_sub(1)) || sticks(Some(i + 1));
                    let shown = if with_stops { beside } else { !own };
                    (frequency, if shown { value } else { f64::NAN })
                });
                part.collect::<Vec<_>>()
            };
            let is_asked = |place: &&CurvePoint| place.source == Source::Grid;
            let asked: Vec<&CurvePoint> = line.places.iter().filter(is_asked).collect();
            // Offset so that the marks of coinciding curves do not coincide.
            let every = asked.len() / MARKS + index;
            let some = asked.into_iter().skip(every / 2).step_by(every);
            let marks = some.filter(|place| !place.sticks).map(|place| (place.frequency, place.height()));
            // The marks are among the requested frequencies, not among those added at a peak.
            let style = if lines.len() > 1 { Style::Marked(usize::MAX) } else { Style::Line };
            series.push(Series::new(line.name.clone(), style, index, part(false)));
            series.push(Series::new("", Style::Dashed, index, part(true)));
            if lines.len() > 1 {
                series.push(Series::new("", Style::Marks, index, marks));
            }
        }
        let within = |(_, value): &(f64, f64)| *value >= low && *value <= high;
        let border: Vec<_> = lines.iter().flat_map(|line| &line.border).copied().filter(within).collect();
        let is_dashed = |place: &CurvePoint| place.sticks && place.value.is_some();
        if lines.iter().flat_map(|line| &line.places).any(is_dashed) {
            series.push(Series::new("with stops (exact)", Style::Dashed, 0, []));
        }
        if !border.is_empty() {
            series.push(Series::new("sticking threshold", Style::Marks, 0, border));
        }
        let places = || lines.iter().flat_map(|line| &line.places);
        let unbounded: Vec<f64> =
            places().filter(|place| place.height() == f64::INFINITY).map(|place| place.frequency).collect();
        if !unbounded.is_empty() {
            series.push(Series::unbounded(unbounded));
        }
        let tops = || lines.iter().flat_map(tops).filter(|(_, value)| *value > high);
        if tops().next().is_some() {
            let greatest = tops().map(|(_, value)| value).fold(0.0, f64::max);
            let name = format!("cut off, peak at {}", digits(greatest));
            series.push(Series::new(name, Style::Beyond, 3, tops()));
        }
        for (is_missing, key) in [
            (places().any(|place| place.value == Some(0.0)), "no line: stuck"),
            (places().any(|place| place.height().is_nan()), "no line: undecided"),
        ] {
            if is_missing {
                series.push(Series::new(key, Style::Note, 0, []));
            }
        }
        let ends = [(range.cut_below, "below", digits(low)), (range.cut_above, "above", digits(high))];
        for (_, side, end) in ends.into_iter().filter(|(is_cut, ..)| *is_cut) {
            series.push(Series::new(format!("cut off {side} {end}"), Style::Note, 0, []));
        }
        let title = format!("{} against frequency", capital(shown(self.what).words));
        Ok(Figure::new("response-curve", title, "", vec![Panel::new(self.machine.clone(), x, y, series)]))
    }
}

/// The vertical axis.
struct VerticalRange {
    low: f64,
    high: f64,
    /// Whether a curve leaves the range downwards.
    cut_below: bool,
    /// Whether a curve leaves the range upwards.
    cut_above: bool,
}

impl VerticalRange {
    /// The range that shows every peak, the usual values, and enough of an unbounded curve to see it rise.
    fn of(lines: &[Line], logarithmic: bool) -> Self {
        let usual = usual(lines, logarithmic);
        let places = || lines.iter().flat_map(|line| &line.places);
        let heights = || places().map(CurvePoint::height).filter(|y| *y > 0.0);
        let is_unbounded = heights().any(f64::is_infinite);
        let peak = lines.iter().flat_map(tops).map(|(_, value)| value).fold(0.0, f64::max);
        let is_tall = peak > MOST_OF_PEAK * usual;
        let cut_above = is_unbounded || is_tall;
        let most = match (is_unbounded, is_tall) {
            (_, true) => MOST * usual,
            (true, false) => peak.max(MOST * usual),
            (false, false) if peak > 0.0 => peak,
            (false, false) => usual,
        };
        let least = heights().fold(most / 10.0, f64::min);
        // A curve is shown to its ends; a dip between them would take the room of the rest.
        let ends = lines.iter().flat_map(|line| [line.places.first(), line.places.last()]).flatten();
        let ends = ends.map(CurvePoint::height).filter(|y| *y > LEAST_END * usual);
        let floor = ends.map(|y| y / MARGIN).fold(LEAST * usual, f64::min);
        let cut_below = least < floor;
        let high = if cut_above { rounded(most * MARGIN) } else { most * MARGIN };
        let low = if cut_below { rounded(floor) } else { (least / MARGIN).min(high / 10.0) };
        // A tick of the axis takes the logarithm of its end.
        Self { low: low.max(f64::MIN_POSITIVE), high, cut_below, cut_above }
    }
}

/// The room between the values and the edges of the axis.
const MARGIN: f64 = 1.25;

/// The number with two digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

/// The value that the curves do not exceed on [`USUAL`] of the axis; 1 where there is none.
fn usual(lines: &[Line], logarithmic: bool) -> f64 {
    let length = |a: f64, b: f64| if logarithmic { (b / a).ln().abs() } else { (b - a).abs() };
    let mut pieces = Vec::new();
    for pair in lines.iter().flat_map(|line| line.places.windows(2)) {
        if let [a, b] = pair {
            let half = length(a.x, b.x) / 2.0;
            pieces.extend([a, b].map(|place| (place.height(), half)));
        }
    }
    pieces.retain(|(value, _)| *value > 0.0 && value.is_finite());
    pieces.sort_by(|a, b| a.0.total_cmp(&b.0));
    let whole: f64 = pieces.iter().map(|(_, length)| length).sum();
    let mut sum = 0.0;
    let beyond = pieces.iter().find(|(_, length)| {
        sum += length;
        sum >= USUAL * whole
    });
    beyond.or(pieces.last()).map_or(1.0, |(value, _)| *value)
}

/// The bounded local maxima of a curve as (frequency, value), its ends included.
fn tops(line: &Line) -> impl Iterator<Item = (f64, f64)> + '_ {
    let beside = |i: Option<usize>| i.and_then(|i| line.places.get(i)).map_or(f64::NAN, CurvePoint::height);
    line.places.iter().enumerate().filter_map(move |(i, place)| {
        let value = place.height();
        let is_exceeded = beside(i.checked_sub(1)) > value || beside(Some(i + 1)) > value;
        (value.is_finite() && !is_exceeded).then_some((place.frequency, value))
    })
}
