//! Pictures of a system's motion, with the loop of each element, and of its answers over one axis.

use crate::bits::digits;
use crate::failure::Failure;
use crate::interrupt;
use crate::motion_plot::{axis, panel};
use crate::threads;
use rayon::prelude::*;
use std::f64::consts::TAU;
use stickslip::system::{Element, Motion, State};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};
use stickslip_front::curve::SETTLED;
use stickslip_front::inputs::units::Kind as Of;
use stickslip_front::limits::{MOST_ADDED, MOST_SCATTERED};
use stickslip_front::system::{Cell, Described, Grid, NamedSystem, kind_of};

/// The samples of a motion between which a picture draws straight lines.
const SAMPLES: usize = 3000;
/// The most coordinates, and the most elements, that a picture shows; a panel says of how many it shows some.
const SHOWN: usize = 40;
/// The most coordinates in a panel.
const TOGETHER: usize = 6;
/// The part of the greatest velocity below which a contact rests.
const AT_REST: f64 = 1e-9;

/// The marks along a curve.
const MARKS: usize = 8;

/// A quantity with its unit, for an axis.
fn label(described: &Described, name: &str, kind: Of) -> String {
    described.units.map_or_else(|| name.to_owned(), |units| format!("{name} ({})", units.name(kind)))
}

/// The time of an axis.
fn time(described: &Described) -> &'static str {
    if described.units.is_some() { "time (s)" } else { "time" }
}

/// The velocity of an element: `b·q′ − V(t)`.
fn velocity(of: &Described, element: &Element<f64>, at: f64, state: &State<f64>) -> f64 {
    let own: f64 = element.direction.iter().zip(&state.velocity).map(|(b, v)| b * v).sum();
    let part = |list: &[f64], place: usize| list.get(place).copied().unwrap_or(0.0);
    let harmonics = of.model.harmonics.iter().enumerate().map(|(i, harmonic)| {
        let (sin, cos) = (harmonic.frequency * at).sin_cos();
        part(&element.moves.sin, i) * sin + part(&element.moves.cos, i) * cos
    });
    own - element.moves.constant - harmonics.sum::<f64>()
}

/// The displacement of each coordinate over time, and the force of each element over the displacement along it.
pub(super) fn motion(
    of: &NamedSystem,
    start: &State<f64>,
    motion: &Motion<f64>,
    title: &str,
) -> Result<Figure, Failure> {
    let described = &of.described;
    let mut times: Vec<f64> = (0..=SAMPLES).map(|i| motion.duration * (i as f64 / SAMPLES as f64)).collect();
    // The corners of forces lie at events.
    times.extend(motion.events.iter().take(SAMPLES).map(|event| event.time.clamp(0.0, motion.duration)));
    times.sort_by(f64::total_cmp);
    let states = of.states(start, &times)?;
    let mut panels = Vec::new();
    let when = Axis::linear(time(described), 0.0, motion.duration);
    let length = label(described, "displacement", Of::Length);
    for (title, names) in parts(described) {
        let lines = names.iter().map(|(i, name)| {
            let at = |state: &State<f64>| state.displacement.get(*i).copied().unwrap_or(f64::NAN);
            let points = times.iter().copied().zip(states.iter().map(at));
            Series::new((*name).clone(), style(*i), i + 1, points)
        });
        let lines: Vec<_> = lines.collect();
        let values = lines.iter().flat_map(|line| line.points.iter().map(|point| point.1));
        let y = axis(&length, values, 0.08);
        panels.push(Panel::new(format!("displacements{title}"), when.clone(), y, lines));
    }
    let count = described.model.elements.len();
    for (i, element) in described.model.elements.iter().take(SHOWN).enumerate() {
        let along = |state: &State<f64>| -> f64 {
            element.direction.iter().zip(&state.displacement).map(|(b, q)| b * q).sum()
        };
        let force = |state: &State<f64>| state.force.get(i).copied().unwrap_or(f64::NAN);
        let points: Vec<_> = states.iter().map(|state| (along(state), force(state))).collect();
        let speeds: Vec<f64> = times
            .iter()
            .zip(&states)
            .map(|(at, state)| velocity(described, element, *at, state).abs())
            .collect();
        let most = speeds.iter().fold(0.0f64, |most, speed| most.max(*speed));
        let is_contact = kind_of(element) == "contact";
        let rests: Vec<bool> = speeds.iter().map(|speed| is_contact && *speed <= AT_REST * most).collect();
        let x = axis(&length, points.iter().map(|point| point.0), 0.08);
        let of_how_many = if count > SHOWN { format!(" ({} of {count})", i + 1) } else { String::new() };
        let title = format!("loop of {}{of_how_many}", element.name);
        panels.push(panel(&title, x, &label(described, "force", Of::Force), points, &rests));
    }
    Ok(Figure::new("system", title.to_owned(), "", panels))
}

/// The coordinates of each panel with their places, and how many of how many they are.
fn parts(described: &Described) -> Vec<(String, Vec<(usize, &String)>)> {
    let count = described.places().count();
    let shown: Vec<_> = described.places().zip(described.shown(&described.coordinates)).take(SHOWN).collect();
    let mut from = 0;
    let part = |names: &[(usize, _)]| {
        let to = from + names.len();
        let title =
            if count > TOGETHER { format!(", {} to {to} of {count}", from + 1) } else { String::new() };
        from = to;
        (title, names.to_vec())
    };
    shown.chunks(TOGETHER).map(part).collect()
}

/// Lines that colour alone does not tell apart differ in style.
const fn style(place: usize) -> Style {
    match place % 4 {
        0 => Style::Line,
        1 => Style::Dashed,
        2 => Style::Dotted,
        _ => Style::Thick,
    }
}

/// The answers of all rows of a grid, in parallel.
fn answers(grid: &Grid<'_>) -> Result<Vec<Vec<Cell<'static>>>, Failure> {
    let answer = |row: u64| {
        if interrupt::asked() {
            return Err(Failure::Interrupted);
        }
        Ok(grid.answer(row).unwrap_or_else(|_| grid.blank().to_vec()))
    };
    threads::on_all(|| (0..grid.len()).into_par_iter().map(answer).collect())
}

const fn number(cell: Option<&Cell<'_>>) -> f64 {
    match cell {
        Some(Cell::Number(Some(x))) => *x,
        Some(Cell::Count(Some(n))) => *n as f64,
        _ => f64::NAN,
    }
}

/// The greatest distance of a coordinate from zero in an answer.
fn height(answer: &[Cell<'_>], ends: [Option<usize>; 2]) -> f64 {
    let [most, least] = ends.map(|place| number(place.and_then(|place| answer.get(place))).abs());
    most.max(least)
}

/// The most answers that the peaks of all coordinates ask for.
const MOST_OF_ALL: usize = 3000;

/// A place on the axis, with its answer.
pub(super) type Placed = (f64, Vec<Cell<'static>>);

/// The curve with further places beside the peaks of each coordinate, in ascending order.
fn resolved_for_all(
    grid: &Grid<'_>,
    described: &Described,
    mut places: Vec<Placed>,
    place_of: &impl Fn(&str) -> Option<usize>,
) -> Result<Vec<Placed>, Failure> {
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let is_log = is_logarithmic(places.first().map_or(0.0, |p| p.0), places.last().map_or(0.0, |p| p.0));
    let (all, scattered) = (std::cell::Cell::new(0), std::cell::Cell::new(0));
    for name in described.shown(&described.coordinates).take(SHOWN) {
        let ends = ["max", "min"].map(|end| place_of(&format!("{name}.{end}_displacement")));
        let kind = place_of("kind");
        let is_scattered = |answer: &[Cell<'_>]| {
            let kind = kind.and_then(|place| answer.get(place));
            kind.is_some_and(|kind| SETTLED.iter().all(|settled| *kind != Cell::Text(settled)))
        };
        let of =
            |(x, answer): &Placed| (*x, if is_scattered(answer) { f64::NAN } else { height(answer, ends) });
        let added = std::cell::Cell::new(0);
        let at = |x: f64| {
            interrupt::check()?;
            added.set(added.get() + 1);
            all.set(all.get() + 1);
            if added.get() > MOST_ADDED || all.get() > MOST_OF_ALL || scattered.get() > MOST_SCATTERED {
                // Not asked for, and left out below.
                return Ok((x, Vec::new()));
            }
            let answer = grid.answer_at(0, x).unwrap_or_else(|_| grid.blank().to_vec());
            scattered.set(scattered.get() + usize::from(is_scattered(&answer)));
            Ok::<Placed, Failure>((x, answer))
        };
        let found = stickslip_front::curve::resolved(&places, is_log, of, |_| false, at)?;
        places = found.into_iter().map(|(place, _)| place).filter(|(_, answer)| !answer.is_empty()).collect();
    }
    Ok(places)
}

/// Whether an axis with these ends has equal steps for equal ratios.
fn is_logarithmic(low: f64, high: f64) -> bool {
    low > 0.0 && high / low > 20.0
}

/// The place of an answer in its row.
fn place_of(grid: &Grid<'_>, name: &str) -> Option<usize> {
    let place = grid.names().iter().position(|own| own.split('[').next() == Some(name));
    place.and_then(|place| place.checked_sub(grid.given(0).len()))
}

/// A curve over the one axis of a grid.
pub(super) struct Resolved {
    /// The place of the axis among what is given in a row.
    pub(super) axis: usize,
    /// The values of the grid.
    pub(super) given: Vec<f64>,
    /// Those with the ones beside peaks, in ascending order, with their answers.
    pub(super) places: Vec<Placed>,
}

/// The curve over the one axis of a grid, with its peaks resolved; `argument` is what asks for it.
pub(super) fn resolved(grid: &Grid<'_>, described: &Described, argument: &str) -> Result<Resolved, Failure> {
    let rows: Vec<u64> = (0..grid.len()).collect();
    let given = |row: &u64| grid.given(*row);
    let varies = |place: &usize| rows.iter().any(|row| given(row).get(*place) != given(&0).get(*place));
    let axes: Vec<usize> = (0..given(&0).len()).filter(varies).collect();
    let (&[axis], Some(name)) = (axes.as_slice(), axes.first().and_then(|place| grid.names().get(*place)))
    else {
        return Err(format!("{argument}: needs one axis, a --frequency or a --set with a range").into());
    };
    let values: Vec<f64> = rows.iter().map(|row| number(given(row).get(axis))).collect();
    if !values.iter().all(|x| x.is_finite()) {
        return Err(format!("{argument}: {name} must be a number in each row").into());
    }
    let places: Vec<Placed> = values.iter().copied().zip(answers(grid)?).collect();
    // Only the last axis has values between those of the grid.
    let is_last = axis + 1 == given(&0).len();
    let places = if is_last {
        resolved_for_all(grid, described, places, &|name| place_of(grid, name))?
    } else {
        places
    };
    Ok(Resolved { axis, given: values, places })
}

/// The greatest displacement of each coordinate over the one axis of a grid, dashed where a contact sticks.
pub(super) fn curve(grid: &Grid<'_>, described: &Described, title: &str) -> Result<Figure, Failure> {
    let Resolved { axis: place, places, .. } = resolved(grid, described, "--picture")?;
    let name = grid.names().get(place).map_or("", String::as_str);
    let place_of = |name: &str| place_of(grid, name);
    let (places, answers): (Vec<f64>, Vec<_>) = places.into_iter().unzip();
    let column = |name: &str| {
        let place = place_of(name);
        answers
            .iter()
            .map(move |answer| place.map_or(f64::NAN, |place| number(answer.get(place))))
            .collect::<Vec<_>>()
    };
    let sticks: Vec<bool> = {
        let contacts = described.model.elements.iter().filter(|e| kind_of(e) == "contact");
        let rests: Vec<Vec<f64>> = contacts.map(|e| column(&format!("{}.rest_fraction", e.name))).collect();
        (0..places.len()).map(|i| rests.iter().any(|of| of.get(i).is_some_and(|x| *x > 0.0))).collect()
    };
    let beside = |i: usize| {
        let at = |i: Option<usize>| i.and_then(|i| sticks.get(i)).copied().unwrap_or(false);
        at(Some(i)) || at(i.checked_sub(1)) || at(Some(i + 1))
    };
    let lines = |i: usize, name: &str, values: &mut Vec<f64>| {
        let mut series = Vec::new();
        let (most, least) =
            (column(&format!("{name}.max_displacement")), column(&format!("{name}.min_displacement")));
        let heights: Vec<f64> = most.iter().zip(&least).map(|(a, b)| a.abs().max(b.abs())).collect();
        values.extend(heights.iter().copied().filter(|y| y.is_finite() && *y > 0.0));
        // A piece with a rest at one of its ends is dashed, and the parts meet where the rests begin.
        let part = |is_shown: &dyn Fn(usize) -> bool| {
            let place = |(k, (&x, &y)): (usize, (&f64, &f64))| (x, if is_shown(k) { y } else { f64::NAN });
            places.iter().zip(&heights).enumerate().map(place).collect::<Vec<_>>()
        };
        let slides = |k: usize| !sticks.get(k).copied().unwrap_or(false);
        let is_one = described.places().nth(1).is_none();
        let line = if is_one { Style::Line } else { Style::Marked(usize::MAX) };
        series.push(Series::new(name.to_owned(), line, i + 1, part(&slides)));
        series.push(Series::new("", Style::Dashed, i + 1, part(&beside)));
        if !is_one {
            // Apart for each coordinate, so that the marks of equal curves do not coincide.
            let every = (places.len() / MARKS).max(1);
            let marks =
                places.iter().copied().zip(heights).skip(i % TOGETHER * every / TOGETHER).step_by(every);
            series.push(Series::new("", Style::Marks, i + 1, marks));
        }
        series
    };
    let ends = |values: &[f64]| {
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)))
    };
    let (low, high) = ends(&places);
    if low >= high {
        return Err("--picture: needs two values on its axis".into());
    }
    let is_log = is_logarithmic(low, high);
    let name = name.replace('[', " (").replace(']', ")");
    let x = Axis::new(&name, (low, high), is_log);
    let height = label(described, "peak displacement", Of::Length);
    let panels = parts(described).into_iter().enumerate().map(|(place, (title, names))| {
        let mut values = Vec::new();
        let mut series: Vec<_> = names.iter().flat_map(|(i, name)| lines(*i, name, &mut values)).collect();
        if place == 0 && sticks.contains(&true) {
            series.push(Series::new("a contact sticks", Style::Dashed, 0, []));
        }
        let (least, most) = ends(&values);
        let y = if least < most && most / least > 20.0 {
            Axis::logarithmic(&height, least / 1.3, most * 1.3)
        } else {
            axis(&height, values.into_iter().chain([0.0]), 0.08)
        };
        Panel::new(title.trim_start_matches([',', ' ']), x.clone(), y, series)
    });
    Ok(Figure::new("system", title.to_owned(), "", panels.collect::<Vec<_>>()))
}

/// The coordinates and the frequencies of the loads, as a title.
pub(super) fn title(described: &Described, question: &str) -> String {
    format!("{}{}", heading(described, question), loads(described))
}

/// The coordinates, or of many their number, as a title.
pub(super) fn heading(described: &Described, question: &str) -> String {
    let names: Vec<&str> = described.shown(&described.coordinates).map(String::as_str).collect();
    let names =
        if names.len() > TOGETHER { format!("{} coordinates", names.len()) } else { names.join(", ") };
    format!("{question}: {names}")
}

fn loads(described: &Described) -> String {
    let units = described.units.is_some();
    let loads: Vec<String> = described
        .model
        .harmonics
        .iter()
        .take(3)
        .map(|h| if units { format!("{} Hz", digits(h.frequency / TAU)) } else { digits(h.frequency) })
        .collect();
    if loads.is_empty() { String::new() } else { format!(", load at {}", loads.join(", ")) }
}
