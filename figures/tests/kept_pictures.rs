//! The pictures in `docs/figures` and the page that shows them agree with the library.
//!
//! `STICKSLIP_WRITE=1 cargo test -p stickslip-figures --all-features` writes them.

#[path = "../../tests/kept/mod.rs"]
mod kept;

use kept::Kept;
use std::fmt::Write;
use stickslip::{Border, Cycle, Ratios};
use stickslip_draw::{Figure, Series, Style};
use stickslip_figures::{NAMES, figure};

fn all() -> impl Iterator<Item = Figure> {
    NAMES.into_iter().map(|name| figure(name).unwrap())
}

fn series<'a>(figure: &'a Figure, name: &str) -> &'a Series {
    figure.panels.iter().flat_map(|p| &p.series).find(|s| s.name == name).unwrap()
}

fn page() -> String {
    let mut page = String::from(
        "# The figures\n\nThose of the paper by their numbers, then ours, all from this library's results \
         by one command:\n\n\
         ```console\n$ stickslip figures --all --overwrite --dir docs/figures\n```\n\n\
         `stickslip figure NAME --out FILE.csv` gives the data of one. `--format png`, and `--out \
         FILE.png`, need a build with the feature `png`. Curves differ in lightness and mark as well as in \
         colour.\n",
    );
    for figure in all() {
        let heading = if figure.name.starts_with(|c: char| c.is_ascii_digit()) {
            format!("Figure {}: {}", figure.name, figure.title.trim_start_matches("Figure 3 again: "))
        } else {
            figure.title.clone()
        };
        write!(
            page,
            "\n## {heading}\n\n![{}](figures/{}.svg)\n\n{}\n",
            figure.title, figure.name, figure.caption
        )
        .unwrap();
    }
    page
}

/// The errors in figure `accuracy` require multiple precision.
fn is_complete(figure: &Figure) -> bool {
    figure.name != "accuracy" || cfg!(feature = "mp")
}

#[test]
fn the_kept_pictures_are_what_the_library_draws() {
    let mut files = Kept::default();
    for figure in all().filter(is_complete) {
        let file = format!("docs/figures/{}.svg", figure.name);
        let drawn = figure.svg().unwrap();
        let kept = files.at(&file, &drawn);
        if figure.name == "3" {
            // Its settled errors are rounding, which changes with the order of operations, and the axis with
            // them; `tests/pages/figure_3.rs` checks its numbers.
            assert!(
                kept.len().abs_diff(drawn.len()) * 5 < kept.len(),
                "{} against {}",
                kept.len(),
                drawn.len()
            );
            continue;
        }
        assert!(kept == drawn, "{file} is not what is drawn");
    }
}

#[test]
fn the_page_shows_every_figure_with_its_caption() {
    let page = page();
    assert_eq!(Kept::default().at("docs/figures.md", &page), page);
}

#[test]
fn captions_are_short() {
    for figure in all() {
        let words = figure.caption.split_whitespace().count();
        assert!((5..=30).contains(&words), "{}: {words} words", figure.name);
    }
}

#[test]
fn every_series_has_points_in_its_frame() {
    for figure in all() {
        for panel in &figure.panels {
            let within = |(x, y): &(f64, f64)| {
                (panel.x.low..=panel.x.high).contains(x) && (panel.y.low..=panel.y.high).contains(y)
            };
            for series in &panel.series {
                if series.style == Style::Beyond {
                    let in_range = |x: f64| (panel.x.low..=panel.x.high).contains(&x);
                    assert!(series.points.iter().all(|p| in_range(p.0) && p.1 == f64::INFINITY));
                    continue;
                }
                if series.style == Style::Note {
                    assert!(series.points.is_empty());
                    continue;
                }
                let shown = series.points.iter().filter(|p| within(p)).count();
                let drawn = series.points.iter().filter(|(x, y)| x.is_finite() && y.is_finite()).count();
                assert!(shown > 0 && 3 * shown > drawn, "{}: {}", figure.name, series.name);
            }
        }
    }
    assert_eq!(figure("11"), None);
}

/// Without multiple precision the errors of the library itself are missing, and the picture says by what it measures.
#[test]
fn the_measure_of_the_accuracy_is_named() {
    let figure = figure("accuracy").unwrap();
    let due = if cfg!(feature = "mp") { "this library, f64" } else { "measured by this library, f64" };
    assert!(figure.panels.iter().all(|panel| panel.series.iter().any(|series| series.name == due)));
}

/// Below the frequency of −1, which Newton's method in another program has as 2.653347727855322, all blows have the velocity of the closed form,
/// and the multipliers are its; above it two velocities take turns, and then many.
#[test]
fn the_period_of_the_impact_oscillator_doubles_where_the_multiplier_is_minus_one() {
    let figure = figure("impacts").unwrap();
    let [left, right] = &figure.panels[..] else { panic!("{figure:?}") };
    let border = left.series[3].points[0].0;
    assert!((border - 2.653_347_727_855_322).abs() < 1e-14, "{border}");
    let stable = &left.series[1].points;
    let mut close = 0;
    for &(omega, speed) in left.series[0].points.iter().filter(|p| p.0 < border - 0.03) {
        let after = stable.partition_point(|p| p.0 < omega).max(1);
        let (a, b) = (stable[after - 1], stable[after]);
        let line = a.1 + (b.1 - a.1) * (omega - a.0) / (b.0 - a.0);
        // The chord of a step of 0.0025 is within 10⁻⁵ of the line.
        assert!((speed - line).abs() < 2e-5, "{omega}: {speed} {line}");
        close += 1;
    }
    assert!(close > 1000, "{close}");
    let kinds = |low: f64, high: f64| {
        let mut found: Vec<i64> = left.series[0]
            .points
            .iter()
            .filter(|p| (low..high).contains(&p.0))
            .map(|p| (p.1 * 1e3).round() as i64)
            .collect();
        found.sort_unstable();
        found.dedup();
        found.len()
    };
    assert!((2..=3).contains(&kinds(2.6765, 2.6768)), "{}", kinds(2.6765, 2.6768));
    let of_form = &right.series[0].points;
    assert!(right.series[1].points.len() == 9);
    for &(omega, found) in &right.series[1].points {
        let after = of_form.partition_point(|p| p.0 < omega).max(1);
        let (a, b) = (of_form[after - 1], of_form[after]);
        let line = a.1 + (b.1 - a.1) * (omega - a.0) / (b.0 - a.0);
        assert!((found - line).abs() < 1e-4, "{omega}: {found} {line}");
    }
}

#[test]
fn figure_1_shows_the_law_and_a_motion_that_keeps_it() {
    let figure = figure("1").unwrap();
    let dots = &series(&figure, "exact motion, Ω = 0.4, α = 6").points;
    let mut at_rest = 0;
    for &(v, friction) in dots {
        if v == 0.0 {
            assert!(friction.abs() <= 1.0, "{friction}");
            at_rest += usize::from(friction.abs() < 0.99);
        } else {
            assert_eq!(friction, v.signum());
        }
    }
    assert!(dots.len() > 200 && at_rest > 5, "{at_rest} of {}", dots.len());
    let law = &series(&figure, "Coulomb's law").points;
    assert!(law.contains(&(0.0, -1.0)) && law.contains(&(0.0, 1.0)));
}

#[test]
fn figure_2_measures_the_cycle_it_draws() {
    let figure = figure("2").unwrap();
    let path = &series(&figure, "steady motion, Ω = 0.7, α = 2").points;
    let cycle = Ratios::new(0.7, 2.0).and_then(Cycle::new).unwrap();
    let greatest = |part: fn(&(f64, f64)) -> f64| path.iter().map(part).fold(0.0, f64::max);
    // With 240 points per cycle, a maximum is missed by at most (π/240)²/2 of its value.
    assert!((greatest(|p| p.0) / cycle.max_displacement - 1.0).abs() < 1e-4);
    assert!((greatest(|p| p.1) / cycle.max_velocity - 1.0).abs() < 1e-4);
    let lengths: Vec<f64> = figure.panels[0]
        .series
        .iter()
        .filter(|s| s.style == Style::Arrow && s.index == 0)
        .map(|s| (s.points[1].0 - s.points[0].0).hypot(s.points[1].1 - s.points[0].1))
        .collect();
    assert_eq!(lengths.len(), 6);
    for due in [cycle.deviation(), cycle.max_velocity, cycle.max_displacement] {
        assert_eq!(lengths.iter().filter(|l| (**l - due).abs() < 1e-12).count(), 2, "{due} of {lengths:?}");
    }
    // The arrows show the direction: to the right in the upper half.
    let ways: Vec<_> =
        figure.panels[0].series.iter().filter(|s| s.style == Style::Arrow && s.index == 2).collect();
    assert_eq!(ways.len(), 4);
    for way in ways {
        let (from, to) = (way.points[0], way.points[way.points.len() - 1]);
        assert!((to.0 - from.0) * from.1 > 0.0, "{from:?} to {to:?}");
    }
}

/// The lines of damping agree with the closed forms where the body does not stick, and with the border;
/// without a damper they have no bound at resonance and at the poles.
#[test]
fn damping_bounds_resonance_and_the_poles() {
    let figure = figure("damping").unwrap();
    for zeta in [0.0, 0.01, 0.05, 0.2] {
        let line = |panel: usize| {
            let series = &figure.panels[panel].series;
            series.iter().find(|s| s.name == format!("ζ = {zeta}")).unwrap().points.clone()
        };
        let ratios = |omega| Ratios::new(omega, 2.5).unwrap().with_damping_ratio(zeta).unwrap();
        let mut compared = 0;
        for (omega, amplitude) in line(0) {
            if let (Ok(cycle), true) = (Cycle::new(ratios(omega)), amplitude.is_finite()) {
                assert!(
                    (amplitude * 2.5 / cycle.max_displacement - 1.0).abs() < 1e-9,
                    "{zeta} {omega}: {amplitude}"
                );
                compared += 1;
            }
        }
        assert!(compared > 200, "{compared}");
        for (omega, least) in line(1).into_iter().filter(|p| p.1.is_finite()) {
            assert_eq!(
                least,
                Border::of(&Ratios::new(omega, 1.0).unwrap().with_damping_ratio(zeta).unwrap())
                    .min_force_ratio
            );
        }
        let is_unbounded = |panel: usize, at: f64| line(panel).contains(&(at, f64::INFINITY));
        assert_eq!((is_unbounded(0, 1.0), is_unbounded(1, 1.0 / 3.0)), (zeta < 0.01, zeta < 0.01), "{zeta}");
        assert!(line(2).iter().any(|p| p.1 > 0.1) && line(2).last().unwrap().1 == 0.0);
    }
}

/// Each curve of figure 3 agrees with an independent simulation (`tests/data/figure_3.py`), and the settled
/// motion is symmetric to rounding.
#[test]
fn figure_3_shows_each_error_under_its_name() {
    let figure = figure("3").unwrap();
    let mut compared = 0;
    for line in include_str!("../../tests/data/figure_3.csv").lines().skip(1) {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        let (inverse, omega) = (cells[0], cells[1]);
        for (i, due) in cells[2..].iter().enumerate() {
            let title = format!("error {}, ", i + 1);
            let panel = figure.panels.iter().find(|panel| panel.title.starts_with(&title)).unwrap();
            let name = format!("1/α = {inverse}, 20 cycles from rest");
            let series = panel.series.iter().find(|series| series.name == name).unwrap();
            let (_, drawn) = series.points.iter().find(|(x, _)| (x - omega).abs() < 1e-9).unwrap();
            // The rounding is 1e-15 of the displacement in each slide; the time of a flat extremum is known
            // to the square root of ε.
            assert!(
                (drawn - due).abs() < 1e-5 * due + 1e-12,
                "{title}{name}, Ω = {omega}: {drawn} for {due}"
            );
            compared += 1;
        }
    }
    assert_eq!(compared, 108);
    for panel in &figure.panels {
        for series in panel.series.iter().filter(|series| series.name.ends_with("settled")) {
            assert!(series.points.len() > 250 && series.points.iter().all(|(_, error)| *error < 1e-12));
        }
    }
}

#[test]
fn figure_4_marks_lie_on_the_exact_lines() {
    let figure = figure("4").unwrap();
    for tenth in 1..=6 {
        let name = format!("1/α = 0.{tenth}");
        let line = &series(&figure, &format!("{name}, exact")).points;
        let marks = &series(&figure, &format!("{name}, eq. 44")).points;
        let mut compared = 0;
        for (omega, mark) in marks.iter().filter(|(_, y)| y.is_finite()) {
            let after = line.iter().position(|(x, _)| x > omega).unwrap();
            let ((a, ya), (b, yb)) = (line[after - 1], line[after]);
            let between = ya + (yb - ya) * (omega - a) / (b - a);
            // Away from the peak, linear interpolation over 0.005 is accurate to 1 %.
            if (omega - 1.0).abs() > 0.05 {
                assert!((between / mark - 1.0).abs() < 0.01, "{name}, Ω = {omega}: {between} {mark}");
                compared += 1;
            }
        }
        assert!(compared > 15, "{name}: {compared}");
    }
}

#[test]
fn figure_7_shows_eq_49_too_large_above_resonance_only() {
    let figure = figure("7").unwrap();
    let printed = figure.panels[0].series.iter().filter(|s| s.name == "eq. 49 as printed");
    for (tenth, series) in (1..=6).zip(printed) {
        let alpha = 10.0 / f64::from(tenth);
        for &(omega, printed) in series.points.iter().filter(|(_, v)| v.is_finite()) {
            let exact = Ratios::new(omega, alpha).and_then(Cycle::new).unwrap().max_velocity;
            if omega > 1.0 {
                assert!(printed > exact * (1.0 + 1e-9), "{omega} {alpha}");
            } else if omega > 0.75 {
                // As printed the second root is that of a difference of two squares, each 4/(π(1 − Ω))² with a
                // rounding of four units in the last place.
                let lost = (8.0 * f64::EPSILON).sqrt() / (std::f64::consts::PI * (1.0 - omega)).powi(2);
                assert!((printed - exact).abs() < 1e-8 * exact + lost, "{omega} {alpha}: {printed} {exact}");
            }
        }
    }
}

#[test]
fn figure_8_has_a_dot_wherever_alpha_is_above_the_exact_border() {
    let figure = figure("8").unwrap();
    let dots = &series(&figure, "no stop in the exact motion").points;
    for &(omega, alpha) in dots {
        let least = Border::new(omega).unwrap().min_force_ratio;
        assert!(alpha >= least * (1.0 - 1e-9), "({omega}, {alpha}) below {least}");
    }
    let lattice = |i: u32, low: f64, high: f64, n: u32| low + (high - low) * f64::from(i) / f64::from(n - 1);
    let above = (0..61).flat_map(|i| (0..51).map(move |j| (i, j))).filter(|&(i, j)| {
        let (omega, alpha) = (lattice(i, 0.1725, 1.9725, 61), lattice(j, 0.5, 15.5, 51));
        alpha > Border::new(omega).unwrap().min_force_ratio
    });
    // At Ω = 1 itself there is no steady motion for a dot; the grid avoids it.
    assert_eq!(above.count(), dots.len());
}

/// A picture has the requested size, is mostly blank, and contains text, which would be missing without a
/// font.
#[cfg(feature = "png")]
#[test]
fn a_png_is_drawn_with_its_words() {
    use resvg::tiny_skia::Pixmap;
    use stickslip_draw::png_of_svg;
    let figure = figure("9a").unwrap();
    let svg = figure.svg().unwrap();
    let pixels = Pixmap::decode_png(&png_of_svg(&svg, 800).unwrap()).unwrap();
    let number = |name: &str| -> f64 {
        let rest = svg.split_once(&format!(" {name}=\"")).unwrap().1;
        rest.split_once('"').unwrap().0.parse().unwrap()
    };
    let height = 800.0 * number("height") / number("width");
    assert_eq!((pixels.width(), f64::from(pixels.height())), (800, height.round()));
    let dark = |from: usize, to: usize| {
        let rows = pixels.pixels().chunks(800).skip(from).take(to - from).flatten();
        rows.filter(|p| p.red() < 128).count()
    };
    let paper = pixels.pixels().iter().filter(|p| p.red() == 255).count();
    assert!(paper * 10 > 9 * pixels.pixels().len(), "{paper}");
    // Only the title is above the frame.
    assert!((200..5000).contains(&dark(0, 35)), "{}", dark(0, 35));
    assert!(png_of_svg(&svg, 0).is_err());
}

/// A page has the size of the drawing in points, its lines, and its texts as glyphs whose meaning is told.
#[cfg(feature = "png")]
#[test]
fn a_pdf_has_the_lines_and_the_texts_of_the_drawing() {
    use std::collections::{BTreeMap, BTreeSet};
    use std::io::Read;
    use stickslip_draw::pdf_of_svg;
    let figure = figure("9a").unwrap();
    let svg = figure.svg_of_size((600, 400)).unwrap();
    let page = pdf_of_svg(&svg).unwrap();
    let place = |part: &[u8]| page.windows(part.len()).position(|own| own == part).unwrap();
    let head = String::from_utf8_lossy(&page[..place(b"stream")]).into_owned();
    assert!(head.starts_with("%PDF-1.4\n") && head.contains("/MediaBox[0 0 450 300]"), "{head}");
    // The table holds the place of each object, and the last line but one the place of the table.
    let tail = String::from_utf8_lossy(&page[place(b"xref\n")..]).into_owned();
    let last: usize = tail.lines().rev().nth(1).unwrap().parse().unwrap();
    assert_eq!(last, place(b"xref\n"));
    let mut objects = BTreeMap::new();
    for (line, index) in tail.lines().skip(3).take(9).zip(1..) {
        let at: usize = line[..10].parse().unwrap();
        assert!(page[at..].starts_with(format!("{index} 0 obj\n").as_bytes()), "{line}");
        objects.insert(index, at);
    }
    let stream = |index: i32| {
        let own = &page[objects[&index]..];
        let of = |part: &[u8]| own.windows(part.len()).position(|bytes| bytes == part).unwrap();
        let mut content = Vec::new();
        flate2::read::ZlibDecoder::new(&own[of(b"stream\n") + 7..of(b"\nendstream")])
            .read_to_end(&mut content)
            .unwrap();
        content
    };
    let content = String::from_utf8(stream(4)).unwrap();
    let count =
        |operator: &str| content.lines().filter(|line| line.split(' ').next_back() == Some(operator)).count();
    assert!(count("S") >= svg.matches("<polyline").count(), "{}", count("S"));
    // The meaning of each glyph, in UTF-16.
    let meanings = String::from_utf8(stream(9)).unwrap();
    let meaning: BTreeMap<&str, String> = meanings
        .lines()
        .filter_map(|line| line.strip_prefix('<')?.strip_suffix('>')?.split_once("><"))
        .filter(|(_, to)| *to != "ffff")
        .map(|(glyph, to)| {
            let units = to.as_bytes().chunks(4).map(|unit| std::str::from_utf8(unit).unwrap());
            let units: Vec<u16> = units.map(|unit| u16::from_str_radix(unit, 16).unwrap()).collect();
            (glyph, String::from_utf16(&units).unwrap())
        })
        .collect();
    // Each part of a text of the drawing is one of the page.
    let texts: BTreeSet<String> = content
        .split("BT\n")
        .skip(1)
        .map(|text| {
            let glyphs =
                text.split("ET\n").next().unwrap().lines().filter_map(|line| line.strip_suffix("> Tj"));
            glyphs.map(|glyph| meaning[&glyph[1..]].as_str()).collect::<String>().trim().to_owned()
        })
        .collect();
    let parts = svg.split("<text").skip(1).flat_map(|text| {
        let inner = text.split_once('>').unwrap().1.split_once("</text>").unwrap().0;
        inner
            .split('<')
            .map(|part| part.split_once('>').map_or(part, |(_, after)| after).trim())
            .collect::<Vec<_>>()
    });
    let parts: BTreeSet<String> =
        parts.filter(|part| !part.is_empty()).map(|part| part.replace("&lt;", "<")).collect();
    assert_eq!(texts, parts);
    assert!(texts.len() > 10 && texts.iter().any(|text| text.contains('ω')), "{texts:?}");
    // The font is a part of DejaVu Sans.
    assert!(stream(8).starts_with(&[0, 1, 0, 0]) && stream(8).len() < 40_000, "{}", stream(8).len());
    // Every number of the page lies in the drawing, whose pixels the first line turns into points.
    assert!(content.starts_with("0.75 0 0 -0.75 0 300 cm\n"));
    for line in content.lines().filter(|line| [" l", " m", " Tm"].iter().any(|end| line.ends_with(end))) {
        let numbers: Vec<f64> = line.split(' ').filter_map(|x| x.parse().ok()).collect();
        let [x, y] = numbers[numbers.len() - 2..] else { panic!("{line}") };
        assert!((-1.0..=601.0).contains(&x) && (-1.0..=401.0).contains(&y), "{line}");
    }
}

#[test]
fn data_are_written_as_csv() {
    let mut text = Vec::new();
    figure("5").unwrap().write_csv(&mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("panel,series,x,y,value"));
    let line = lines.find(|l| l.starts_with("\"peak displacement, ω_d t₂\",1/α = 0.5,0.7")).unwrap();
    let cells: Vec<&str> = line.rsplitn(4, ',').collect();
    let (omega, phase): (f64, f64) = (cells[2].parse().unwrap(), cells[1].parse().unwrap());
    assert_eq!(Ratios::new(omega, 2.0).and_then(Cycle::new).unwrap().displacement_phase, phase);
}
