//! Pictures of a system's motion, with the loop of each element, and of its answers over one axis.

use crate::bits::digits;
use crate::failure::Failure;
use crate::interrupt;
use crate::motion_plot::{axis, panel};
use rayon::prelude::*;
use std::f64::consts::TAU;
use stickslip::inputs::units::Kind as Of;
use stickslip::system::{Element, Kind, Motion, State};
use stickslip_figures::{Axis, Figure, Panel, Series, Style};
use stickslip_front::system::{Cell, Described, Grid, NamedSystem};

/// The samples of a motion between which a picture draws straight lines.
const SAMPLES: usize = 3000;
/// The most coordinates, and the most elements, that a picture shows.
const SHOWN: usize = 6;
/// The part of the greatest velocity below which a contact rests.
const AT_REST: f64 = 1e-9;

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
    let states = of.system.states(start, &times)?;
    let mut panels = Vec::new();
    let when = Axis::linear(time(described), 0.0, motion.duration);
    let shown = described.coordinates.iter().take(SHOWN).enumerate();
    let lines = shown.map(|(i, name)| {
        let at = |state: &State<f64>| state.displacement.get(i).copied().unwrap_or(f64::NAN);
        Series::new(name.clone(), style(i), i + 1, times.iter().copied().zip(states.iter().map(at)))
    });
    let lines: Vec<_> = lines.collect();
    let values = lines.iter().flat_map(|line| line.points.iter().map(|point| point.1));
    let length = label(described, "displacement", Of::Length);
    let y = axis(&length, values, 0.08);
    panels.push(Panel::new("displacements", when, y, lines));
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
        let is_contact = matches!(element.kind, Kind::Contact { .. });
        let rests: Vec<bool> = speeds.iter().map(|speed| is_contact && *speed <= AT_REST * most).collect();
        let x = axis(&length, points.iter().map(|point| point.0), 0.08);
        let title = format!("loop of {}", element.name);
        panels.push(panel(&title, x, &label(described, "force", Of::Force), points, &rests));
    }
    Ok(Figure::new("system", title.to_owned(), "", panels))
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
    (0..grid.len()).into_par_iter().map(answer).collect()
}

/// The greatest displacement of each coordinate over the one axis of a grid, thick where a contact sticks.
pub(super) fn curve(grid: &Grid<'_>, described: &Described, title: &str) -> Result<Figure, Failure> {
    let rows: Vec<u64> = (0..grid.len()).collect();
    let number = |cell: Option<&Cell<'_>>| match cell {
        Some(Cell::Number(Some(x))) => *x,
        Some(Cell::Count(Some(n))) => *n as f64,
        _ => f64::NAN,
    };
    let given = |row: &u64| grid.given(*row);
    let varies = |place: &usize| rows.iter().any(|row| given(row).get(*place) != given(&0).get(*place));
    let axes: Vec<usize> = (0..given(&0).len()).filter(varies).collect();
    let ([place], Some(name)) = (axes.as_slice(), axes.first().and_then(|place| grid.names().get(*place)))
    else {
        return Err("--picture: shows one axis, a --frequency or a --set with a range".into());
    };
    let places: Vec<f64> = rows.iter().map(|row| number(given(row).get(*place))).collect();
    if !places.iter().all(|x| x.is_finite()) {
        return Err(format!("--picture: {name} must be a number in each row").into());
    }
    let answers = answers(grid)?;
    let before = given(&0).len();
    let column = |name: &str| {
        let place = grid.names().iter().position(|own| own.split('[').next() == Some(name));
        let place = place.and_then(|place| place.checked_sub(before));
        answers
            .iter()
            .map(move |answer| place.map_or(f64::NAN, |place| number(answer.get(place))))
            .collect::<Vec<_>>()
    };
    let mut series = Vec::new();
    let mut values = Vec::new();
    let sticks: Vec<bool> = {
        let contacts = described.model.elements.iter().filter(|e| matches!(e.kind, Kind::Contact { .. }));
        let rests: Vec<Vec<f64>> = contacts.map(|e| column(&format!("{}.rest_fraction", e.name))).collect();
        (0..rows.len()).map(|i| rests.iter().any(|of| of.get(i).is_some_and(|x| *x > 0.0))).collect()
    };
    let beside = |i: usize| {
        let at = |i: Option<usize>| i.and_then(|i| sticks.get(i)).copied().unwrap_or(false);
        at(Some(i)) || at(i.checked_sub(1)) || at(Some(i + 1))
    };
    for (i, name) in described.coordinates.iter().take(SHOWN).enumerate() {
        let (most, least) =
            (column(&format!("{name}.max_displacement")), column(&format!("{name}.min_displacement")));
        let heights: Vec<f64> = most.iter().zip(&least).map(|(a, b)| a.abs().max(b.abs())).collect();
        values.extend(heights.iter().copied().filter(|y| y.is_finite() && *y > 0.0));
        let points: Vec<_> = places.iter().copied().zip(heights).collect();
        if sticks.contains(&true) {
            let part =
                points.iter().enumerate().map(|(i, &(x, y))| (x, if beside(i) { y } else { f64::NAN }));
            series.push(Series::new(format!("{name}, a contact sticks"), Style::Thick, i + 1, part));
        }
        series.push(Series::new(name.clone(), style(i), i + 1, points));
    }
    let ends = |values: &[f64]| {
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(*x), high.max(*x)))
    };
    let (low, high) = ends(&places);
    if low >= high {
        return Err("--picture: needs two values on its axis".into());
    }
    let is_log = low > 0.0 && high / low > 20.0;
    let name = name.replace('[', " (").replace(']', ")");
    let x = Axis::new(&name, (low, high), is_log);
    let (least, most) = ends(&values);
    let height = label(described, "greatest displacement", Of::Length);
    let y = if least < most && most / least > 20.0 {
        Axis::logarithmic(&height, least / 1.3, most * 1.3)
    } else {
        axis(&height, values.into_iter().chain([0.0]), 0.08)
    };
    Ok(Figure::new("system", title.to_owned(), "", [Panel::new("", x, y, series)]))
}

/// The coordinates and the frequencies of the loads, as a title.
pub(super) fn title(described: &Described, question: &str) -> String {
    format!("{}{}", heading(described, question), loads(described))
}

/// The coordinates, as a title.
pub(super) fn heading(described: &Described, question: &str) -> String {
    format!(
        "{question}: {}",
        described.coordinates.iter().take(SHOWN).cloned().collect::<Vec<_>>().join(", ")
    )
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
