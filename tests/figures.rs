//! The pictures in `docs/figures` and the page that shows them are what the library gives.
//!
//! `STICKSLIP_WRITE=1 cargo test --all-features --test figures` writes them.

use std::fmt::Write;
use stickslip::figures::{Figure, NAMES, Series, figure};
use stickslip::{Border, Cycle, Ratios};

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs");

fn all() -> impl Iterator<Item = Figure> {
    NAMES.into_iter().map(|name| figure(name).unwrap())
}

fn series<'a>(figure: &'a Figure, name: &str) -> &'a Series {
    figure.panels.iter().flat_map(|p| &p.series).find(|s| s.name == name).unwrap()
}

fn page() -> String {
    let mut page = String::from(
        "# The figures\n\nThose of the paper by their numbers, then ours, all from this library's results by one command, in seconds:\n\n\
         ```console\n$ stickslip figures --all --dir docs/figures\n```\n\n\
         `stickslip figure NAME --out FILE.csv` gives the data of one. `tests/figures.rs` holds this page and its pictures against the \
         library. Curves differ in lightness and mark as well as in colour, for print and for every eye.\n",
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

/// The errors of figure `accuracy` need multiple precision to be known.
fn is_complete(figure: &Figure) -> bool {
    figure.name != "accuracy" || cfg!(feature = "mp")
}

#[test]
fn the_kept_pictures_are_what_the_library_draws() {
    for figure in all().filter(is_complete) {
        let file = format!("{FOLDER}/figures/{}.svg", figure.name);
        let drawn = figure.svg().unwrap();
        if std::env::var_os("STICKSLIP_WRITE").is_some() {
            std::fs::create_dir_all(format!("{FOLDER}/figures")).unwrap();
            std::fs::write(&file, &drawn).unwrap();
        }
        let kept = std::fs::read_to_string(&file).unwrap();
        if figure.name == "3" {
            // Its settled errors are rounding, which any change of an operation's order moves, and the axis with them:
            // `tests/figure_3.rs` has its numbers.
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
    let file = format!("{FOLDER}/figures.md");
    if std::env::var_os("STICKSLIP_WRITE").is_some() {
        std::fs::write(&file, page()).unwrap();
    }
    assert_eq!(std::fs::read_to_string(file).unwrap(), page());
}

#[test]
fn every_series_has_points_in_its_frame() {
    for figure in all() {
        for panel in &figure.panels {
            let within = |(x, y): &(f64, f64)| {
                (panel.x.low..=panel.x.high).contains(x) && (panel.y.low..=panel.y.high).contains(y)
            };
            for series in &panel.series {
                let shown = series.points.iter().filter(|p| within(p)).count();
                let drawn = series.points.iter().filter(|(x, y)| x.is_finite() && y.is_finite()).count();
                assert!(shown > 0 && 3 * shown > drawn, "{}: {}", figure.name, series.name);
            }
        }
    }
    assert_eq!(figure("11"), None);
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
            // Away from the peak a straight piece of 0.005 is good to 1 %.
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
            let exact = Ratios::new(omega, alpha).and_then(Cycle::new).unwrap().max_velocity();
            if omega > 1.0 {
                assert!(printed > exact * (1.0 + 1e-9), "{omega} {alpha}");
            } else if omega > 0.75 {
                assert!((printed / exact - 1.0).abs() < 1e-8, "{omega} {alpha}: {printed} {exact}");
            }
        }
    }
}

#[test]
fn figure_8_has_a_dot_wherever_alpha_is_above_the_exact_border() {
    let figure = figure("8").unwrap();
    let dots = &series(&figure, "no stop in the exact motion").points;
    for &(omega, alpha) in dots {
        let least = Border::new(omega).unwrap().min_force_ratio();
        assert!(alpha >= least * (1.0 - 1e-9), "({omega}, {alpha}) below {least}");
    }
    let lattice = |i: u32, low: f64, high: f64, n: u32| low + (high - low) * f64::from(i) / f64::from(n - 1);
    let above = (0..61).flat_map(|i| (0..51).map(move |j| (i, j))).filter(|&(i, j)| {
        let (omega, alpha) = (lattice(i, 0.1725, 1.9725, 61), lattice(j, 0.5, 15.5, 51));
        alpha > Border::new(omega).unwrap().min_force_ratio()
    });
    // At Ω = 1 itself there is no steady motion to have a dot; the lattice keeps off it.
    assert_eq!(above.count(), dots.len());
}

#[test]
fn data_are_written_as_csv() {
    let mut text = Vec::new();
    figure("5").unwrap().write_csv(&mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("panel,series,x,y,value"));
    let line = lines.find(|l| l.starts_with("\"maximum displacement, ω_d t₂\",1/α = 0.5,0.7")).unwrap();
    let cells: Vec<&str> = line.rsplitn(4, ',').collect();
    let (omega, phase): (f64, f64) = (cells[2].parse().unwrap(), cells[1].parse().unwrap());
    assert_eq!(Ratios::new(omega, 2.0).and_then(Cycle::new).unwrap().displacement_phase(), phase);
}
