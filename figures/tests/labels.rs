//! No text of a picture leaves it or meets another: the figures, and axes of any range at every size.

#[path = "../../tests/text_boxes/mod.rs"]
mod text_boxes;

use stickslip_draw::{Axis, Figure, Panel, Series, Style};
use stickslip_figures::{NAMES, figure};

/// The least size of a picture, from the message that names it.
fn least(figure: &Figure) -> (u32, u32) {
    let message = figure.svg_of_size((1, 1)).unwrap_err().to_string();
    let size = message.split("from ").nth(1).unwrap().split(',').next().unwrap();
    let (width, height) = size.split_once('x').unwrap();
    (width.parse().unwrap(), height.parse().unwrap())
}

#[test]
fn the_texts_of_the_figures_keep_apart() {
    for name in NAMES {
        let figure = figure(name).unwrap();
        let (faults, texts) = text_boxes::faults(&figure.svg().unwrap());
        assert!(faults.is_empty() && texts > 5, "{name}: {faults:#?}");
    }
}

#[test]
fn the_texts_of_any_axes_keep_apart_at_any_size() {
    let ranges = [
        (0.0, 1.0),
        (-1e9, 1e9),
        (-3e-7, 4e-7),
        (5.00004, 5.00006),
        (-250_000.0, 250_000.0),
        (3.0, 3.0),
        (1.0, 1.0 + 4.0 * f64::EPSILON),
        (0.0, 5e-324),
        (-f64::MAX, f64::MAX),
        (1e-300, 1e300),
        (0.02, 0.9),
    ];
    let mut tried = 0;
    for across in ranges {
        for up in ranges {
            for (panels, logarithmic) in [(1, false), (1, true), (2, false), (5, true)] {
                let axis = |label: &str, (low, high)| Axis::new(label, (low, high), logarithmic && low > 0.0);
                let panel = |i: usize| {
                    let curve = Series::new(
                        "peak displacement",
                        Style::Line,
                        0,
                        [(across.0, up.0), (across.1, up.1)],
                    );
                    let (x, y) =
                        (axis("displacement (mm)", across), axis("absolute acceleration (m/s²)", up));
                    Panel::new(format!("panel {i}, α = p₀/r_y"), x, y, vec![curve])
                };
                let title = "Feeder 7 after its overhaul, ".repeat(if panels == 2 { 12 } else { 1 });
                let figure = Figure::new("f", title, "", (0..panels).map(panel).collect::<Vec<_>>());
                let (width, height) = least(&figure);
                for size in [None, Some((width, height)), Some((width + 200, height + 37))] {
                    let svg = size.map_or_else(|| figure.svg(), |size| figure.svg_of_size(size)).unwrap();
                    let (faults, texts) = text_boxes::faults(&svg);
                    let of = format!("{across:?}, {up:?}, {panels} panels, {size:?}");
                    assert!(faults.is_empty(), "{of}: {faults:#?}");
                    assert!(texts > 4 * panels, "{of}: {texts} texts");
                    tried += 1;
                }
            }
        }
    }
    assert_eq!(tried, 11 * 11 * 4 * 3);
}

/// The sizes of all letters but those of indices, in pixels of a drawing that is this many pixels wide.
fn letters(svg: &str, width: f64) -> Vec<f64> {
    let (_, rest) = svg.split_once("viewBox=\"0 0 ").unwrap();
    let units: f64 = rest.split(' ').next().unwrap().parse().unwrap();
    let sizes = svg.split("<text ").skip(1).map(|text| {
        let (_, rest) = text.split_once("font-size=\"").unwrap();
        rest.split('"').next().unwrap().parse::<f64>().unwrap() * width / units
    });
    sizes.collect()
}

/// In a column of 85 mm a pixel of 450 is 0.535 pt, so that 14 of them are 7.5 pt.
#[test]
fn a_narrow_picture_is_read_in_a_column_of_85_mm() {
    const POINTS: f64 = 85.0 / 25.4 * 72.0 / 450.0;
    let time = || Axis::linear("time (s)", 0.0, 30.0);
    let record = ["displacement of the support (mm)", "displacement (mm)", "absolute acceleration (m/s²)"]
        .map(|y| {
            let (title, _) = y.split_once(" (").unwrap();
            let curve = Series::new("sliding", Style::Line, 2, [(0.0, -0.7), (30.0, 0.9)]);
            let rest = Series::new("at rest", Style::Thick, 3, [(3.0, 0.1), (4.0, 0.1)]);
            Panel::new(title, time(), Axis::linear(y, -1.0, 1.0), vec![curve, rest])
        });
    let title =
        "Motion under quake.csv: mass 800 kg, period 2.5 s, friction coefficient 0.06, damping ratio 5 %";
    let of_record = Figure::new("record", title, "", record);
    // Beside the plot this key would leave it less than its least width, and within it would cover the curve.
    let wave = (0..200).map(|i| (f64::from(i) / 199.0 * 30.0, (f64::from(i) * 0.9).sin()));
    let curve = Series::new("peak displacement of the block", Style::Line, 2, wave);
    let of_curve = Panel::new("", time(), Axis::linear("displacement (mm)", -1.0, 1.0), vec![curve]);
    let of_curve = Figure::new("curve", title, "", [of_curve]);
    let mut seen = 0;
    let figures = ["4", "5", "8", "9a"].map(|name| figure(name).unwrap());
    // Two panels, low ones, whose vertical names take two lines, and ones that are too low for two.
    let low = Figure { panels: of_record.panels[1..].to_vec(), ..of_record.clone() };
    let sizes = [(of_record.clone(), 760), (of_record, 900), (low, 600), (of_curve, 400)];
    let figures = figures.map(|figure| (figure, 1400)).into_iter().chain(sizes);
    for (figure, height) in figures {
        let svg = figure.svg_of_size((450, height)).unwrap();
        let (faults, _) = text_boxes::faults(&svg);
        assert!(faults.is_empty(), "{}: {faults:#?}", figure.name);
        assert!(!svg.contains('…'), "{} {height}: {svg}", figure.name);
        for size in letters(&svg, 450.0) {
            assert!(size * POINTS >= 7.0, "{}: {} pt", figure.name, size * POINTS);
            seen += 1;
        }
    }
    assert!(seen > 60, "{seen}");
}

/// The words of a drawing from left to right, line by line.
fn words(svg: &str) -> Vec<String> {
    text_boxes::texts(svg).1.into_iter().map(|text| text.words).collect()
}

#[test]
fn a_long_name_takes_two_lines_and_one_where_two_have_no_room() {
    let name = "absolute acceleration (m/s²)";
    let panel = |title: &str| {
        let curve = Series::new("sliding", Style::Line, 2, [(0.0, -0.7), (30.0, 0.9)]);
        let axis = Axis::linear("time (s)", 0.0, 30.0);
        Panel::new(title, axis, Axis::linear(name, -1.0, 1.0), vec![curve])
    };
    let figure = Figure::new("f", "Motion", "", ["a", "b", "c"].map(panel)).stacked();
    let all = words(&figure.svg_of_size((700, 800)).unwrap());
    assert_eq!(all.iter().filter(|text| *text == "absolute acceleration").count(), 3, "{all:?}");
    assert_eq!(all.iter().filter(|text| *text == "(m/s²)").count(), 3, "{all:?}");
    let (width, height) = least(&figure);
    let narrow = words(&figure.svg_of_size((width, height)).unwrap());
    let cut = |text: &&String| text.starts_with("abs") && text.ends_with("… (m/s²)");
    assert_eq!(narrow.iter().filter(cut).count(), 3, "{narrow:?}");
}

/// A horizontal axis that panels share is labelled below the last of them; another axis has its own labels.
#[test]
fn stacked_panels_share_one_time_axis() {
    let panel = |title: &str, x: Axis| {
        let curve = Series::new("sliding", Style::Line, 2, [(0.0, 0.0), (7.0, 1.0)]);
        Panel::new(title, x, Axis::linear("a", 0.0, 1.0), vec![curve])
    };
    let time = || Axis::linear("time (s)", 0.0, 7.0);
    let last = panel("loop", Axis::linear("displacement (mm)", 0.0, 9.0));
    let panels = [panel("force", time()), panel("displacement", time()), panel("velocity", time()), last];
    let figure = Figure::new("record", "Motion", "", panels).stacked();
    let svg = figure.svg().unwrap();
    let count = |words: &[String], text: &str| words.iter().filter(|own| *own == text).count();
    let own = words(&svg);
    assert_eq!(["time (s)", "displacement (mm)", "7", "8"].map(|text| count(&own, text)), [1, 1, 1, 1]);
    let (_, texts) = text_boxes::texts(&svg);
    let top = |words: &str| texts.iter().find(|text| text.words == words).unwrap().of[1];
    assert!(top("velocity") < top("time (s)") && top("time (s)") < top("loop"));
    // Two by two, each panel has its own.
    let own = words(&figure.svg_of_size((900, 600)).unwrap());
    assert_eq!(count(&own, "time (s)"), 3);
}

#[test]
fn small_values_have_a_prefix_in_place_of_a_power_of_ten() {
    let curve = Series::new("sliding", Style::Line, 2, [(0.0, 0.0), (0.004, 2e-5)]);
    let axes = (Axis::linear("time (s)", 0.0, 0.004), Axis::linear("displacement (m)", 0.0, 2e-5));
    let figure = Figure::new("f", "Motion", "", [Panel::new("", axes.0, axes.1, vec![curve])]);
    let all = words(&figure.svg().unwrap());
    assert!(
        ["time (ms)", "displacement (µm)", "4", "20"].iter().all(|due| all.contains(&(*due).to_owned())),
        "{all:?}"
    );
    assert!(all.iter().all(|text| !text.contains("10⁻")), "{all:?}");
    // The data keep the unit that was asked for.
    let mut data = Vec::new();
    figure.write_csv(&mut data).unwrap();
    assert!(String::from_utf8(data).unwrap().ends_with(",sliding,0.004,0.00002,\n"));
}

/// The places of the first letters of the titles of four panels, one below the other or two by two.
#[test]
fn panels_over_one_time_are_stacked_where_there_is_room() {
    let panel = |title: &str| {
        let curve = Series::new("sliding", Style::Line, 2, [(0.0, 0.0), (30.0, 1.0)]);
        Panel::new(title, Axis::linear("time (s)", 0.0, 30.0), Axis::linear("a", 0.0, 1.0), vec![curve])
    };
    let titles = ["force", "displacement", "velocity", "acceleration"];
    let figure = Figure::new("record", "Motion", "", titles.map(panel)).stacked();
    let columns = |svg: &str| {
        let (_, texts) = text_boxes::texts(svg);
        let middles = texts.iter().filter(|text| titles.contains(&text.words.as_str()));
        let middles: std::collections::BTreeSet<_> =
            middles.map(|text| ((text.of[0] + text.of[2]) / 2.0).round() as i64).collect();
        assert!(text_boxes::faults(svg).0.is_empty());
        middles.len()
    };
    assert_eq!(columns(&figure.svg().unwrap()), 1);
    assert_eq!(columns(&figure.svg_of_size((900, 1200)).unwrap()), 1);
    assert_eq!(columns(&figure.svg_of_size((900, 600)).unwrap()), 2);
    assert_eq!(columns(&Figure { is_stacked: false, ..figure }.svg().unwrap()), 2);
}

#[test]
fn an_empty_and_a_level_panel_say_so() {
    let drawn = |points: [(f64, f64); 3], style| {
        let panel = Panel::new(
            "",
            Axis::linear("time (s)", 0.0, 2.0),
            Axis::linear("displacement (mm)", -1.0, 1.0),
            vec![Series::new("sliding", style, 2, points)],
        );
        let svg = Figure::new("f", "At rest", "", [panel]).svg().unwrap();
        let (faults, _) = text_boxes::faults(&svg);
        assert!(faults.is_empty(), "{faults:#?}");
        svg
    };
    for style in [Style::Line, Style::Marks, Style::Thick] {
        let points = |y: f64| [(0.0, y), (1.0, y), (2.0, y)];
        assert!(drawn(points(f64::NAN), style).contains("no values in this range"), "{style:?}");
        assert!(drawn(points(7.0), style).contains("no values in this range"), "{style:?}");
        let level = drawn(points(-0.0123456), style);
        assert_eq!(level.contains("constant: −0.01235"), style != Style::Marks, "{style:?}");
        let moves = drawn([(0.0, 0.2), (1.0, 0.3), (2.0, 0.2)], style);
        assert!(!moves.contains("constant") && !moves.contains("no values"), "{style:?}");
    }
    assert!(drawn([(0.0, 1e-9), (1.0, 1e-9), (2.0, 1e-9)], Style::Line).contains("constant: 1·10⁻⁹"));
}
