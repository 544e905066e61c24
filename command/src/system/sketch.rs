//! A drawing of a system, as SVG text: bodies by their distance from the ground, and the springs, dampers, contacts and stops
//! between them. A chain runs from left to right, or upwards where it would be too wide or stands on a base that moves.

use crate::bits::digits;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use stickslip::system::{Element, Kind, Law, Signal};
use stickslip_front::inputs::units::Kind as Of;
use stickslip_front::system::{Described, frequency_of, with_unit};
use stickslip_front::text::printable;

/// The least distance of two columns of bodies, of the lines between two bodies, and the least size of a body, in pixels.
const GAP: f64 = 190.0;
const LINE: f64 = 40.0;
const BODY: f64 = 110.0;
const MARGIN: f64 = 40.0;
/// The height of a body in a drawing that runs upwards, and the distance of two.
const STOREY: f64 = 56.0;
const BETWEEN: f64 = 150.0;
/// The width of the arrow of a load.
const ARROW: f64 = 24.0;
/// The width from which a drawing runs upwards.
const WIDE: f64 = 1600.0;
/// The width of a letter.
const LETTER: f64 = 7.2;
/// The most bodies that a drawing shows: the chosen ones, or the first ones; it says of how many.
const MOST: usize = 40;

/// The symbol of a connection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Symbol {
    Spring,
    Damper,
    Contact,
    Elastic,
    Stop,
}

/// A connection of two bodies, or of the ground (`None`) and a body, with its text.
struct Link {
    ends: [Option<usize>; 2],
    symbol: Symbol,
    text: String,
}

fn quantity(described: &Described, x: f64, kind: Of) -> String {
    with_unit(x, described.units.as_ref(), kind)
}

/// The connections that the matrices of springs and dampers have: those off the diagonal between bodies, and what is left
/// of a row to the ground.
fn of_matrix(described: &Described, matrix: &[Vec<f64>], symbol: Symbol, kind: Of, links: &mut Vec<Link>) {
    for (i, row) in matrix.iter().enumerate() {
        let size = row.iter().fold(0.0f64, |most, x| most.max(x.abs()));
        let mut add = |ends, value: f64| {
            // What rounding leaves is no spring.
            if value.abs() > 1e-12 * size && size > 0.0 {
                links.push(Link { ends, symbol, text: quantity(described, value, kind) });
            }
        };
        add([None, Some(i)], row.iter().sum());
        for (j, value) in row.iter().enumerate().skip(i + 1) {
            add([Some(i), Some(j)], -value);
        }
    }
}

/// The two ends of an element: the first body with a negative share, and the first with a positive one.
fn ends(element: &Element<f64>) -> [Option<usize>; 2] {
    let first = |is: fn(&f64) -> bool| element.direction.iter().position(is);
    let (a, b) = (first(|x| *x < 0.0), first(|x| *x > 0.0));
    if b.is_some() { [a, b] } else { [None, a] }
}

fn links(described: &Described) -> Vec<Link> {
    let mut links = Vec::new();
    let model = &described.model;
    of_matrix(described, &model.stiffness, Symbol::Spring, Of::Stiffness, &mut links);
    of_matrix(described, &model.damping, Symbol::Damper, Of::Damping, &mut links);
    for (place, element) in model.elements.iter().enumerate() {
        let law = |points: usize| described.curve(place).unwrap_or_else(|| format!("law of {points} points"));
        let force = |x: f64| quantity(described, x, Of::Force);
        let (symbol, what) = match &element.kind {
            Kind::Contact { law: Law { points }, normal, .. } => {
                let what = match (points.as_slice(), normal) {
                    ([(_, one)], None) => force(*one),
                    ([(_, one)], Some(_)) => format!("µ = {}", digits(*one)),
                    (several, _) => law(several.len()),
                };
                (Symbol::Contact, what)
            }
            Kind::UnderStop { coefficient, .. } => {
                (Symbol::Contact, format!("µ = {} under the stop", digits(*coefficient)))
            }
            Kind::Elastic { stiffness, friction, normal } => {
                let friction =
                    if normal.is_some() { format!("µ = {}", digits(*friction)) } else { force(*friction) };
                (Symbol::Elastic, format!("{}, {friction}", quantity(described, *stiffness, Of::Stiffness)))
            }
            Kind::Stop { gap, .. } | Kind::HardStop { gap, .. } => {
                (Symbol::Stop, format!("gap {}", quantity(described, *gap, Of::Length)))
            }
            Kind::Spring { points } => (Symbol::Spring, law(points.len())),
        };
        links.push(Link { ends: ends(element), symbol, text: format!("{}: {what}", element.name) });
    }
    links
}

/// A sum of waves, a constant and records in words; empty where it is 0.
fn over_time(
    described: &Described,
    waves: &[(f64, f64)],
    constant: f64,
    has_record: bool,
    kind: Of,
) -> String {
    let own = |x: f64| quantity(described, x, kind);
    let wave = |(size, omega): &(f64, f64)| {
        format!("{} at {}", own(*size), frequency_of(*omega, described.units.as_ref()))
    };
    let mut all: Vec<String> = match waves {
        [_, _, _, ..] => vec![format!("{} waves", waves.len())],
        few => few.iter().map(wave).collect(),
    };
    all.extend((constant != 0.0).then(|| format!("{}, constant", own(constant))));
    all.extend(has_record.then(|| "a record".to_owned()));
    all.join(", ")
}

fn at(list: &[f64], place: usize) -> f64 {
    list.get(place).copied().unwrap_or(0.0)
}

/// The loads on a body, in words, without those of a base that moves.
fn loads(described: &Described, body: usize) -> String {
    let model = &described.model;
    // The load of the base on the body where its acceleration is 1.
    let inertia = described.base.as_ref().zip(model.mass.get(body)).map_or(0.0, |(base, row)| {
        -row.iter().zip(&base.influence).map(|(mass, share)| mass * share).sum::<f64>()
    });
    let of_base = |part: fn(&Signal<f64>) -> &Vec<f64>, place| {
        inertia * described.base.as_ref().map_or(0.0, |base| at(part(&base.acceleration), place))
    };
    let own =
        |whole: f64, base: f64| if (whole - base).abs() > 1e-9 * whole.abs() { whole - base } else { 0.0 };
    let waves = model.harmonics.iter().enumerate().map(|(place, of)| {
        let sin = own(at(&of.sin, body), of_base(|signal| &signal.sin, place));
        (sin.hypot(own(at(&of.cos, body), of_base(|signal| &signal.cos, place))), of.frequency)
    });
    let waves: Vec<_> = waves.filter(|(size, _)| *size > 0.0).collect();
    let constant = own(
        at(&model.constant, body),
        inertia * described.base.as_ref().map_or(0.0, |base| base.acceleration.constant),
    );
    let has_record = model
        .records
        .iter()
        .enumerate()
        .any(|(place, of)| own(at(&of.force, body), of_base(|signal| &signal.records, place)) != 0.0);
    over_time(described, &waves, constant, has_record, Of::Force)
}

/// The name of the ground, with the acceleration of one that moves.
fn ground_in_words(described: &Described) -> String {
    let Some(base) = &described.base else { return "ground".to_owned() };
    let Signal { constant, sin, cos, records, .. } = &base.acceleration;
    let waves = described.model.harmonics.iter().enumerate();
    let waves = waves.map(|(place, of)| (at(sin, place).hypot(at(cos, place)), of.frequency));
    let waves: Vec<_> = waves.filter(|(size, _)| *size > 0.0).collect();
    let has_record = records.iter().any(|share| *share != 0.0);
    let text = over_time(described, &waves, *constant, has_record, Of::Acceleration);
    if text.is_empty() { "ground".to_owned() } else { format!("ground, moves: {text}") }
}

fn escaped(text: &str) -> String {
    printable(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// The column of each body: its number of connections to a body of the first column, which the ground carries.
///
/// Of bodies that are joined to each other only one stands there, so that a chain whose bodies all rub on the ground is drawn as
/// one; those behind it have a ground of their own.
fn columns(count: usize, links: &[Link]) -> Vec<usize> {
    let joins = |link: &Link, i: usize| match link.ends {
        [Some(a), Some(b)] if a == i => Some(b),
        [Some(a), Some(b)] if b == i => Some(a),
        _ => None,
    };
    let others = |i: usize| links.iter().filter_map(move |link| joins(link, i));
    let stands = |i: usize, is: fn(Symbol) -> bool| {
        links
            .iter()
            .any(|link| is(link.symbol) && (link.ends == [None, Some(i)] || link.ends == [Some(i), None]))
    };
    let mut column = vec![0; count];
    while let Some(first) = column.iter().position(|depth| *depth == 0) {
        let mut joined = vec![first];
        let mut next = 0;
        while let Some(body) = joined.get(next).copied() {
            next += 1;
            let new: BTreeSet<usize> = others(body).filter(|other| !joined.contains(other)).collect();
            joined.extend(new);
        }
        joined.sort_unstable();
        let of = |is| joined.iter().copied().filter(|i| stands(*i, is)).collect::<Vec<usize>>();
        let carried = of(|symbol| !matches!(symbol, Symbol::Contact | Symbol::Elastic));
        let mut roots = if carried.is_empty() { of(|_| true) } else { carried };
        if roots.is_empty() {
            roots.push(first);
        }
        if roots.iter().any(|root| others(*root).any(|other| roots.contains(&other))) {
            roots.truncate(1);
        }
        let mut depth = 1;
        while !roots.is_empty() {
            for root in &roots {
                column.get_mut(*root).into_iter().for_each(|place| *place = depth);
            }
            let next: BTreeSet<usize> = roots.iter().flat_map(|root| others(*root)).collect();
            roots = next.into_iter().filter(|i| column.get(*i) == Some(&0)).collect();
            depth += 1;
        }
    }
    column
}

/// The width of a text.
fn width(text: &str) -> f64 {
    LETTER * text.chars().count() as f64
}

/// The sizes of a drawing: along the way from the ground, and across it.
#[derive(Clone, Copy)]
struct Sizes {
    /// Between the beginnings of bodies along the way.
    column: f64,
    /// Of a body along the way.
    body: f64,
    /// Between lines across the way.
    line: f64,
    /// The length of the whole way, if it runs upwards.
    upright: Option<f64>,
}

impl Sizes {
    fn of(described: &Described, shown: &[usize], links: &[Link], deepest: f64) -> Self {
        let longest = |widths: &mut dyn Iterator<Item = f64>| widths.fold(0.0f64, f64::max);
        let link = longest(&mut links.iter().map(|link| width(&link.text)));
        // Names are bold.
        let names = shown.iter().filter_map(|i| described.coordinates.get(*i)).map(|name| 1.1 * width(name));
        let loads = shown.iter().map(|i| width(&loads(described, *i)) + 2.0 * ARROW);
        let body = longest(&mut names.chain(loads)) + 16.0;
        let wide = body.max(BODY);
        let level = Self { column: wide + GAP.max(link + 60.0), body: wide, line: LINE, upright: None };
        // On a base that moves bodies stand on each other.
        if level.way(deepest) <= WIDE && (described.base.is_none() || deepest < 2.0) {
            return level;
        }
        // The texts stand beside the lines.
        let line = (link + 40.0).max(body / 1.2);
        let upright = Self { column: STOREY + BETWEEN, body: STOREY, line, upright: None };
        Self { upright: Some(upright.way(deepest)), ..upright }
    }

    /// The length of the way to the farthest body.
    fn way(&self, deepest: f64) -> f64 {
        2.0 * MARGIN + deepest * self.column + self.body
    }

    /// The place of a point.
    fn at(&self, (along, across): (f64, f64)) -> (f64, f64) {
        self.upright.map_or((along, across), |way| (across, way - along))
    }

    fn polyline(&self, svg: &mut String, points: &[(f64, f64)], extra: &str) {
        let points = points.iter().map(|point| self.at(*point));
        let points: Vec<String> = points.map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ =
            writeln!(svg, r#"<polyline points="{}" fill="none" stroke="black" {extra}/>"#, points.join(" "));
    }
}

/// The symbol along a line, with its text above or, where the line runs upwards, beside it.
fn draw(svg: &mut String, sizes: &Sizes, symbol: Symbol, (x0, x1, y): (f64, f64, f64), text: &str) {
    let middle = f64::midpoint(x0, x1);
    let line = |svg: &mut String, points: &[(f64, f64)], extra: &str| sizes.polyline(svg, points, extra);
    let (a, b) = (middle - 26.0, middle + 26.0);
    match symbol {
        Symbol::Spring | Symbol::Elastic => {
            let mut points = vec![(x0, y), (a, y)];
            points.extend(
                (0..8).map(|i| (a + 3.25 + 6.5 * f64::from(i), y + if i % 2 == 0 { -6.0 } else { 6.0 })),
            );
            points.extend([(b, y), (x1, y)]);
            line(svg, &points, "");
            if symbol == Symbol::Elastic {
                // The slider in series with the spring.
                line(svg, &[(b + 10.0, y - 6.0), (b + 34.0, y - 6.0)], r#"stroke-width="3""#);
                line(svg, &[(b + 10.0, y + 6.0), (b + 34.0, y + 6.0)], r#"stroke-width="3""#);
            }
        }
        Symbol::Damper => {
            line(svg, &[(x0, y), (middle, y)], "");
            line(svg, &[(middle, y - 7.0), (middle, y + 7.0)], r#"stroke-width="2""#);
            line(svg, &[(a, y - 9.0), (b, y - 9.0), (b, y + 9.0), (a, y + 9.0)], "");
            line(svg, &[(b, y), (x1, y)], "");
        }
        Symbol::Contact => {
            line(svg, &[(x0, y - 4.0), (b, y - 4.0)], r#"stroke-width="2.5""#);
            line(svg, &[(a, y + 4.0), (x1, y + 4.0)], r#"stroke-width="2.5""#);
            for i in 0..6 {
                let x = a + 4.0 + 8.0 * f64::from(i);
                line(svg, &[(x, y + 12.0), (x + 6.0, y + 5.0)], "");
            }
        }
        Symbol::Stop => {
            line(svg, &[(x0, y), (middle - 8.0, y)], "");
            line(svg, &[(middle - 8.0, y - 9.0), (middle - 8.0, y + 9.0)], r#"stroke-width="3""#);
            line(svg, &[(middle + 8.0, y - 9.0), (middle + 8.0, y + 9.0)], r#"stroke-width="3""#);
            line(svg, &[(middle + 8.0, y), (x1, y)], "");
        }
    }
    let (x, y) = sizes.at((middle, y));
    let (x, y, anchor) =
        if sizes.upright.is_some() { (x + 16.0, y + 4.0, "start") } else { (x, y - 13.0, "middle") };
    let text = escaped(text);
    let _ = writeln!(svg, r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{text}</text>"#);
}

/// The ground at the end of a line of a body that stands behind another one.
fn own_ground(svg: &mut String, sizes: &Sizes, (x, y): (f64, f64)) {
    sizes.polyline(svg, &[(x, y - 10.0), (x, y + 10.0)], "");
    for i in 0..3 {
        let end = y - 7.0 + 7.0 * f64::from(i);
        sizes.polyline(svg, &[(x, end), (x - 6.0, end + 6.0)], "");
    }
}

/// The height of a title above the drawing.
const TITLE: f64 = 30.0;

/// The drawing, with a title and of a width and a height in pixels if they are given.
pub(super) fn svg(described: &Described, title: Option<&str>, size: Option<(u32, u32)>) -> String {
    let shown: Vec<usize> = described.places().take(MOST).collect();
    let count = shown.len();
    // What joins a body to one that is not shown is left out.
    let end_of = |end: Option<usize>| match end {
        None => Some(None),
        Some(body) => shown.iter().position(|own| *own == body).map(Some),
    };
    let seen = |link: Link| Some(Link { ends: [end_of(link.ends[0])?, end_of(link.ends[1])?], ..link });
    let links: Vec<Link> = links(described).into_iter().filter_map(seen).collect();
    let column = columns(count, &links);
    let deepest = column.iter().copied().max().unwrap_or(1) as f64;
    let sizes = Sizes::of(described, &shown, &links, deepest);
    let Sizes { body, line, .. } = sizes;
    let is_upright = sizes.upright.is_some();
    // A straight line joins neighbouring columns; all other connections run below the bodies.
    let depth = |end: Option<usize>| end.and_then(|i| column.get(i)).copied().unwrap_or(0);
    let is_straight =
        |link: &Link| link.ends.contains(&None) || depth(link.ends[0]).abs_diff(depth(link.ends[1])) == 1;
    let mut height = vec![1usize; count];
    let (mut left, mut right) = (vec![0usize; count], vec![0usize; count]);
    for link in links.iter().filter(|link| is_straight(link)) {
        let [a, b] =
            if depth(link.ends[0]) < depth(link.ends[1]) { link.ends } else { [link.ends[1], link.ends[0]] };
        for (end, side) in [(a, &mut right), (b, &mut left)] {
            if let Some(place) = end.and_then(|end| side.get_mut(end)) {
                *place += 1;
            }
        }
    }
    for (i, lines) in height.iter_mut().enumerate() {
        *lines = left.get(i).copied().unwrap_or(0).max(right.get(i).copied().unwrap_or(0)).max(1);
    }
    let mut below: BTreeMap<usize, f64> = BTreeMap::new();
    let mut top = vec![0.0; count];
    for i in 0..count {
        let own = column.get(i).copied().unwrap_or(1);
        let next = below.entry(own).or_insert(MARGIN);
        if let Some(place) = top.get_mut(i) {
            *place = *next;
        }
        let room = if is_upright { line } else { 2.0 * line };
        *next += height.get(i).copied().unwrap_or(1) as f64 * line + room;
    }
    let most = below.values().fold(0.0f64, |most, y| most.max(*y));
    let x = |i: usize| MARGIN + column.get(i).copied().unwrap_or(1) as f64 * sizes.column;
    let mut svg = String::new();
    let (mut used_left, mut used_right) = (vec![0usize; count], vec![0usize; count]);
    let mut under = most;
    for link in &links {
        let [a, b] =
            if depth(link.ends[0]) <= depth(link.ends[1]) { link.ends } else { [link.ends[1], link.ends[0]] };
        let port = |side: &mut Vec<usize>, end: usize| {
            let place = side.get_mut(end).map_or(0, |place| {
                *place += 1;
                *place
            });
            top.get(end).copied().unwrap_or(0.0) + line * place as f64
        };
        let Some(b) = b else { continue };
        if is_straight(link) {
            let y = port(&mut used_left, b);
            match a {
                None => {
                    let is_first = depth(Some(b)) == 1;
                    let from = if is_first { MARGIN + 12.0 } else { x(b) - sizes.column + body + 34.0 };
                    if !is_first {
                        own_ground(&mut svg, &sizes, (from, y));
                    }
                    draw(&mut svg, &sizes, link.symbol, (from, x(b), y), &link.text);
                }
                Some(a) => {
                    let from = port(&mut used_right, a);
                    let bend = x(a) + body + 24.0;
                    sizes.polyline(&mut svg, &[(x(a) + body, from), (bend, y)], "");
                    draw(&mut svg, &sizes, link.symbol, (bend, x(b), y), &link.text);
                }
            }
            continue;
        }
        under += line;
        let bottom = |i: usize| {
            top.get(i).copied().unwrap_or(0.0) + line * (height.get(i).copied().unwrap_or(1) as f64 + 0.6)
        };
        let (from, to) = (a.map_or(MARGIN + 12.0, |a| x(a) + body / 3.0), x(b) + body * 2.0 / 3.0);
        let end = sizes.way(deepest) - MARGIN / 2.0;
        let to = if (to - from).abs() < 160.0 { (from + 180.0).min(end) } else { to };
        let start = a.map_or(under, bottom);
        sizes.polyline(&mut svg, &[(from, start), (from, under)], "");
        let end = (x(b) + body * 2.0 / 3.0, bottom(b));
        sizes.polyline(&mut svg, &[(to, under), (to, end.1 + 8.0), end], "");
        draw(&mut svg, &sizes, link.symbol, (from, to, under), &link.text);
    }
    let bodies = shown.iter().filter_map(|body| Some((*body, described.coordinates.get(*body)?)));
    for (i, (body_at, name)) in bodies.enumerate() {
        let across = top.get(i).copied().unwrap_or(0.0) + line * 0.4;
        let size = line * (height.get(i).copied().unwrap_or(1) as f64 + 0.2);
        let (wide, high) = if is_upright { (size, body) } else { (body, size) };
        let (x, y) = sizes.at((x(i), across));
        let y = if is_upright { y - body } else { y };
        let mass = described.model.mass.get(body_at).and_then(|row| row.get(body_at)).copied().unwrap_or(0.0);
        let is_moved = described.model.moved.iter().any(|moved| moved.coordinate == body_at);
        let text = if is_moved {
            "moved".to_owned()
        } else {
            described.typed_mass(body_at).map_or_else(|| quantity(described, mass, Of::Mass), str::to_owned)
        };
        let load = loads(described, body_at);
        // A load takes a third line, after an arrow to both sides.
        let (up, line) = if load.is_empty() { (3.0, 16.0) } else { (9.0, 14.0) };
        let (middle, first) = (x + wide / 2.0, y + high / 2.0 - up);
        let _ = writeln!(
            svg,
            r##"<rect x="{x:.1}" y="{y:.1}" width="{wide:.1}" height="{high:.1}" fill="#dde7f2" stroke="black" stroke-width="1.5"/>
<text x="{middle:.1}" y="{:.1}" text-anchor="middle" font-weight="bold">{}</text>
<text x="{middle:.1}" y="{:.1}" text-anchor="middle">{}</text>"##,
            first,
            escaped(name),
            first + line,
            escaped(&text)
        );
        if !load.is_empty() {
            let (from, line) = (middle - (width(&load) + ARROW) / 2.0, first + 2.0 * line - 4.0);
            let _ = writeln!(
                svg,
                r#"<path d="M{from:.1},{line:.1}h20m-5,-4l5,4l-5,4m-10,-8l-5,4l5,4" stroke="black" stroke-width="1.5" fill="none"/>
<text x="{:.1}" y="{:.1}" text-anchor="middle">{}</text>"#,
                middle + ARROW / 2.0,
                line + 4.0,
                escaped(&load)
            );
        }
    }
    let all = described.coordinates.len();
    if count < all {
        let _ = writeln!(svg, r#"<text x="{:.1}" y="14">{count} of {all} bodies</text>"#, MARGIN / 2.0);
    }
    // A text beside the last line has its room.
    let across = under + if is_upright && under > most { line } else { MARGIN };
    let (width, height) = sizes.upright.map_or((sizes.way(deepest), across), |way| (across, way));
    let (top, title) = title.map_or_else(Default::default, |title| {
        let middle = width / 2.0;
        let (line, text) = (-TITLE / 3.0, escaped(title));
        let shown = format!(
            r#"<text x="{middle:.1}" y="{line:.1}" text-anchor="middle" font-size="15">{text}</text>"#
        );
        (TITLE, shown + "\n")
    });
    let whole = height + top;
    let (wide, high) = size.map_or((width, whole), |(wide, high)| (wide.into(), high.into()));
    // What is seen has the proportions of the size, with the drawing in its middle.
    let scale = f64::min(wide / width, high / whole);
    let seen = (wide / scale, high / scale);
    let from = ((width - seen.0) / 2.0, (whole - seen.1) / 2.0 - top);
    let view = format!("{:.1} {:.1} {:.1} {:.1}", from.0, from.1, seen.0, seen.1);
    // The ground, hatched on its side without bodies.
    let mut ground = String::new();
    let mut y = MARGIN / 2.0;
    while y < across - MARGIN {
        let [a, b] = [(MARGIN + 12.0, y), (MARGIN + 2.0, y + 10.0)].map(|point| sizes.at(point));
        let _ = write!(ground, "M{:.1},{:.1}L{:.1},{:.1}", a.0, a.1, b.0, b.1);
        y += 10.0;
    }
    let [a, b] = [MARGIN / 2.0, across - MARGIN].map(|across| sizes.at((MARGIN + 12.0, across)));
    let _ = write!(ground, "M{:.1},{:.1}L{:.1},{:.1}", a.0, a.1, b.0, b.1);
    let named = if is_upright { (width / 2.0, height - MARGIN / 2.0) } else { (MARGIN / 2.0, b.1 + 18.0) };
    format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{wide:.0}" height="{high:.0}" viewBox="{view}" font-family="sans-serif" font-size="12">
<rect x="{2:.1}" y="{3:.1}" width="{4:.1}" height="{5:.1}" fill="white"/>
<path d="{ground}" stroke="black" fill="none"/>
<text x="{0:.1}" y="{1:.1}" text-anchor="{6}">{7}</text>
{title}{svg}</svg>
"#,
        named.0,
        named.1,
        from.0,
        from.1,
        seen.0,
        seen.1,
        if is_upright { "middle" } else { "start" },
        escaped(&ground_in_words(described)),
    )
}
