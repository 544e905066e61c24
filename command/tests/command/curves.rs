//! Response curves and maps show resonance as it is, whatever the number of points.

use crate::command_line::{refused, stdout};
use crate::place::place;
/// A row of a response curve.
#[derive(Debug, Clone)]
struct Row {
    x: f64,
    regime: String,
    value: Option<f64>,
    point: String,
}

/// The rows of a single curve.
fn rows(arguments: &str) -> Vec<Row> {
    let text = stdout(arguments);
    assert!(!text.contains("NaN") && !text.contains("inf"), "{arguments}");
    let row = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        let value = (!cells[3].is_empty()).then(|| cells[3].parse().unwrap());
        Row { x: cells[1].parse().unwrap(), regime: cells[2].to_owned(), value, point: cells[5].to_owned() }
    };
    text.lines().skip(1).map(row).collect()
}

/// The row of the greatest value.
fn highest(rows: &[Row]) -> &Row {
    rows.iter().max_by(|a, b| a.value.unwrap_or(0.0).total_cmp(&b.value.unwrap_or(0.0))).unwrap()
}

/// The greatest value of a curve, by grids that become finer around it; only the points that were asked for
/// count.
fn peak(curve: impl Fn(&str) -> String, from: f64, to: f64) -> f64 {
    let (mut low, mut high, mut best) = (from, to, 0.0f64);
    for _ in 0..5 {
        let mut asked = rows(&curve(&format!("{low}:{high}:401")));
        asked.retain(|row| row.point == "grid");
        let place = asked.iter().position(|row| row.x == highest(&asked).x).unwrap();
        best = best.max(asked[place].value.unwrap());
        low = asked[place.saturating_sub(2)].x;
        high = asked[(place + 2).min(asked.len() - 1)].x;
    }
    best
}

/// A pixel of the shortest axis, of a decade on 440 pixels.
const PIXEL: f64 = std::f64::consts::LN_10 / 440.0;

#[test]
fn a_damped_peak_has_its_height_at_any_number_of_points() {
    for (zeta, alpha, what) in [
        (1e-6, 2.0, "displacement"),
        (1e-4, 4.0, "velocity"),
        (1e-2, 2.0, "acceleration"),
        (0.05, 1.1, "displacement"),
        (0.1, 3.0, "force"),
        (0.4, 6.0, "acceleration"),
        (1.0, 8.0, "displacement"),
    ] {
        let curve = |grid: &str| {
            format!("response-curve {what} --omega {grid} --alpha {alpha} --damping-ratio {zeta}")
        };
        let due = peak(curve, 0.2, 2.0);
        for count in [10, 200, 2000] {
            let found = rows(&curve(&format!("0.2:2:{count}")));
            let top = highest(&found);
            assert!(
                (top.value.unwrap() / due).ln().abs() < PIXEL / 10.0,
                "{what} {zeta} {count}: {top:?}, {due}"
            );
            assert_eq!(found.iter().filter(|row| row.point == "grid").count(), count);
            assert!(found.iter().all(|row| row.regime != "unbounded") && found.len() < count + 300);
        }
    }
}

/// The motion of a support and of a base, whose force depends on the frequency, with and without stops at the
/// peak.
#[test]
fn a_peak_of_a_base_motion_has_its_height() {
    for drive in [
        "--foot-displacement 20mm --damping 0.6N*s/m",
        "--damped-foot-displacement 20mm --damping 2N*s/m",
        "--base-acceleration 1.2m/s2",
        "--base-velocity 0.2m/s --damping-ratio 3%",
        "--base-displacement 15mm --damping-ratio 10%",
    ] {
        let curve = |grid: &str| {
            format!("response-curve --mass 1kg --stiffness 100N/m --friction 1N {drive} --frequency {grid}")
        };
        // The bare frequency is in rad/s, and the column in hertz.
        let in_hertz = |grid: &str| {
            let mut parts = grid.split(':');
            let [from, to, count] = std::array::from_fn(|_| parts.next().unwrap());
            curve(&format!("{from}Hz:{to}Hz:{count}"))
        };
        let due = peak(in_hertz, 0.3, 4.0);
        for count in [10, 200] {
            let found = rows(&in_hertz(&format!("0.3:4:{count}")));
            let top = highest(&found).value.unwrap();
            assert!((top / due).ln().abs() < PIXEL / 10.0, "{drive} {count}: {top} for {due}");
        }
    }
}

const MACHINE: &str = "--mass 50t --stiffness 1000kN/m --force 12kN --units kN,mm";

/// Without a damper friction forces no resonance from α = 4/π on: the curve has no height there.
#[test]
fn what_is_unbounded_is_written_and_drawn_as_such() {
    for count in [10, 200, 2000] {
        let found = rows(&format!("response-curve {MACHINE} --friction 9kN --frequency 0.2Hz:2Hz:{count}"));
        let one = found.iter().position(|row| row.regime == "unbounded").unwrap();
        let natural = 20f64.sqrt() / std::f64::consts::TAU;
        assert!((found[one].x / natural - 1.0).abs() < 1e-15 && found[one].value.is_none());
        assert_eq!(
            (found[one].point.as_str(), found.iter().filter(|r| r.value.is_none()).count()),
            ("natural", 1)
        );
        // Half a pixel beside it the curve is far above all else.
        let [before, after] = [&found[one - 1], &found[one + 1]].map(|row| (row.x - natural).abs() / 1.8);
        assert!(before < 1.0 / 1280.0 && after < 1.0 / 1280.0, "{before} {after}");
        let file = place(&format!("{count}.svg"));
        stdout(&format!(
            "response-curve {MACHINE} --friction 5kN,9kN --frequency 0.2Hz:2Hz:{count} --out {}",
            file.display()
        ));
        let drawing = std::fs::read_to_string(file).unwrap();
        assert!(drawing.contains("\nunbounded\n") && drawing.contains("cut off above"), "{count}");
        // Both curves reach the upper edge, at 66 pixels.
        for colour in ["#0072B2", "#E69F00"] {
            assert_eq!(top_of(&drawing, colour), 66.0 * 4.0, "{count} {colour}");
        }
    }
    // Below 4/π the body stops at resonance, and the peak is bounded.
    for alpha in [1.2, 1.27] {
        let found = rows(&format!("response-curve --omega 0.3:2:40 --alpha {alpha}"));
        assert!(found.iter().all(|row| row.value.is_some()), "{alpha}");
    }
    let above = rows("response-curve --omega 0.3:2:40 --alpha 1.2733");
    assert_eq!(above.iter().filter(|row| row.regime == "unbounded").count(), 1);
}

/// The piece between a frequency with stops and one without is drawn.
#[test]
fn a_curve_has_no_gap_at_the_border() {
    let file = place("curve.svg");
    stdout(&format!(
        "response-curve {MACHINE} --friction 5kN,9kN --frequency 0.2Hz:2Hz:10 --out {}",
        file.display()
    ));
    let drawing = std::fs::read_to_string(file).unwrap();
    // Both lines begin at the left edge of the plot, at 76 pixels.
    for colour in ["#0072B2", "#E69F00"] {
        let mut lines = drawing.split("<polyline ").filter(|line| line.contains(colour));
        assert!(lines.any(|line| line.contains("points=\"304,")), "{colour}");
    }
}

/// The least ordinate of the lines of a colour, in quarters of a pixel.
fn top_of(drawing: &str, colour: &str) -> f64 {
    let lines = drawing.split("<polyline ").skip(1).map(|line| line.split("/>").next().unwrap());
    let own = lines.filter(|line| line.contains(&format!("stroke=\"{colour}\"")));
    let ordinates = own.flat_map(|line| {
        let points = line.split("points=\"").nth(1).unwrap().split('"').next().unwrap();
        points.split_whitespace().map(|point| point.split(',').nth(1).unwrap().parse::<f64>().unwrap())
    });
    ordinates.fold(f64::INFINITY, f64::min)
}

/// The ordinate of the grid line at a label of the vertical axis, in quarters of a pixel.
fn ordinate(drawing: &str, label: &str) -> f64 {
    let number = |text: &str, name: &str| -> f64 {
        text.split(name).nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
    };
    let is_own = |text: &&str| text.contains(&format!(">\n{label}\n")) && text.contains("\"end\"");
    let own = drawing.split("<text ").skip(1).find(is_own).unwrap();
    let label = number(own, " y=\"");
    let lines = drawing.split("<polyline ").skip(1).filter(|line| line.contains("#DEDEDE"));
    let ordinates = lines.filter_map(|line| {
        let points: Vec<&str> =
            line.split("points=\"").nth(1)?.split('"').next()?.split_whitespace().collect();
        let [a, b] = points[..] else { return None };
        let [a, b] = [a, b].map(|point| point.split(',').nth(1).unwrap().parse::<f64>().unwrap());
        (a == b).then_some(a)
    });
    let nearest = ordinates.min_by(|a, b| (a - label).abs().total_cmp(&(b - label).abs())).unwrap();
    // A label is at a whole pixel.
    assert!((nearest - label).abs() <= 2.0, "{nearest} {label}");
    nearest
}

#[test]
fn a_peak_is_drawn_at_its_height() {
    for (zeta, alpha) in [(1e-6, 2.0), (1e-3, 3.0), (0.01, 4.0)] {
        let curve =
            |grid: &str| format!("response-curve --omega {grid} --alpha {alpha} --damping-ratio {zeta}");
        let due = peak(curve, 0.2, 2.0);
        for count in [10, 200, 2000] {
            let file = place(&format!("{zeta}-{count}.svg"));
            stdout(&format!("{} --out {}", curve(&format!("0.2:2:{count}")), file.display()));
            let drawing = std::fs::read_to_string(file).unwrap();
            let decades = due.log10().floor();
            // An axis that reaches 10⁴ has powers of ten only.
            let labels = if drawing.contains("\n10⁴\n") {
                ["10⁰", "10¹", "10²", "10³", "10⁴", "10⁵", "10⁶", "10⁷"]
            } else {
                ["1", "10", "100", "1000", "none", "none", "none", "none"]
            };
            let (one, below) = (ordinate(&drawing, labels[0]), ordinate(&drawing, labels[decades as usize]));
            let expected = one + (below - one) * due.log10() / decades;
            let drawn = top_of(&drawing, "#0072B2");
            assert!((drawn - expected).abs() <= 4.0, "{zeta} {count}: {drawn} for {expected} quarter pixels");
            assert!(!drawing.contains("cut off") && !drawing.contains("unbounded"));
        }
    }
}

#[test]
fn a_curve_that_leaves_the_picture_says_so() {
    let drawn = |arguments: &str| {
        let file = place("curve.svg");
        stdout(&format!("response-curve {arguments} --overwrite --out {}", file.display()));
        std::fs::read_to_string(file).unwrap()
    };
    // Every value to both ends of the range; a dip at the onset of sliding is cut off.
    let low = drawn("--omega 0.5:3000:60:log --alpha 3 --damping-ratio 0.1");
    assert!(!low.contains("cut off") && low.contains("\n10⁻⁷\n"), "{low}");
    let beyond = drawn("--omega 0.5:3e9:60:log --alpha 3 --damping-ratio 0.1");
    assert!(beyond.contains("cut off below "), "{beyond}");
    let high = drawn("--omega 0.2:2:60 --alpha 3 --damping-ratio 1e-9");
    assert!(high.contains("cut off above") && high.contains("cut off, peak at"), "{high}");
    let rest = drawn(
        "acceleration --mass 1kg --stiffness 100N/m --friction 1N --base-displacement 15mm --frequency 0.3Hz:4Hz:60",
    );
    assert!(rest.contains("no line: stuck"), "{rest}");
    assert!(!drawn("--omega 0.2:2:60 --alpha 3 --damping-ratio 0.02").contains("cut off"));
}

#[test]
fn the_least_force_moves_nothing() {
    for (what, due) in [
        ("displacement", 0.0),
        ("velocity", 0.0),
        ("acceleration", 0.0),
        ("force", 1.0),
        ("transmissibility", 1.0),
    ] {
        for alpha in ["5e-324", "1e-310", "0.5"] {
            for row in rows(&format!("response-curve {what} --omega 0.5:2:3 --alpha={alpha}")) {
                assert_eq!((row.regime.as_str(), row.value), ("stuck", Some(due)), "{what} {alpha}");
            }
        }
    }
}

#[test]
fn frequencies_are_in_order() {
    let x = |arguments: &str| -> Vec<f64> { rows(arguments).iter().map(|row| row.x).collect() };
    let up = x("response-curve --omega 0.5,1.5,1.2 --alpha 4 --damping-ratio 0.3");
    assert!(up.windows(2).all(|pair| pair[0] < pair[1]) && up.len() > 4, "{up:?}");
    let down = x("response-curve --omega 2:0.5:9 --alpha 4 --damping-ratio 0.3");
    assert!(down.windows(2).all(|pair| pair[0] > pair[1]) && down.len() > 10, "{down:?}");
}

/// The abscissae of the rectangles of a map's upper row, in quarters of a pixel, from left to right.
fn upper_row(drawing: &str) -> Vec<(i32, i32)> {
    let number = |element: &str, name: &str| -> i32 {
        element.split(&format!(" {name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
    };
    let elements = drawing.split("<rect").skip(1).map(|part| part.split("/>").next().unwrap());
    let shown: Vec<_> =
        elements.filter(|e| number(e, "y") == 66 * 4 && number(e, "x") < (76 + 640) * 4).collect();
    shown.iter().map(|e| (number(e, "x"), number(e, "x") + number(e, "width"))).collect()
}

/// A map has no stripe at resonance, whether a column lies on it or beside it.
#[test]
fn a_map_is_resolved_at_resonance() {
    let file = place("map.svg");
    for grid in ["0.7:1.3:21", "0.71:1.3:20", "0.7:1.3:300"] {
        let map = format!("map max_displacement --omega {grid} --alpha 2:6:5");
        stdout(&format!("{map} --overwrite --out {}", file.display()));
        let drawing = std::fs::read_to_string(&file).unwrap();
        assert!(drawing.contains("\nunbounded\n") && !drawing.contains("it sticks or rests"), "{grid}");
        let row = upper_row(&drawing);
        let gaps: Vec<i32> =
            row.windows(2).map(|pair| pair[1].0 - pair[0].1).filter(|gap| *gap > 0).collect();
        assert!(gaps.len() <= 1 && gaps.iter().all(|gap| *gap <= 8), "{grid}: {gaps:?}");
        assert!(row.len() > 12, "{grid}: {row:?}");
    }
    // The rows are those of the grid.
    assert_eq!(stdout("map max_displacement --omega 0.3:1.7:20 --alpha 2:6:5").lines().count(), 101);
    let drawn = |arguments: &str| {
        stdout(&format!("map {arguments} --overwrite --out {}", file.display()));
        std::fs::read_to_string(&file).unwrap()
    };
    // For a machine whose natural frequency depends on the row, the line is inclined.
    let inclined = drawn(
        "max_displacement --mass 1kg --friction 1N --force 4N --frequency 1Hz:3Hz:30 --stiffness 60N/m:200N/m:20",
    );
    assert!(inclined.contains("\nunbounded\n"));
    assert!(
        !drawn("max_displacement --omega 0.3:1.7:20 --alpha 2:6:5 --damping-ratio 0.1").contains("unbounded")
    );
    // The line alone shows what is unbounded in a map of regimes, and is named once.
    for grid in ["0.31:1.7:20", "0.3:1.7:21"] {
        let regime = drawn(&format!("regime --omega {grid} --alpha 2:6:5"));
        assert_eq!(regime.matches("\nunbounded\n").count(), 1, "{grid}");
        assert!(upper_row(&regime).windows(2).all(|pair| pair[1].0 - pair[0].1 <= 8), "{grid}");
    }
}

/// Title, size and vertical range of a picture; any number of curves, each with a mark of its own.
#[test]
fn a_picture_looks_as_it_was_asked_to() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("curves.svg");
    let curves = format!(
        "response-curve --mass 50t --stiffness 1000kN/m --force 12kN --friction 1kN,2kN,3kN,4kN,5kN,6kN,7kN \
         --frequency 20rpm:120rpm:30 --units kN,mm --out {} --overwrite",
        file.display()
    );
    stdout(&format!("{curves} --title Feeder --size 900x520 --linear --x-range 33:77 --y-range 0:100"));
    let text = std::fs::read_to_string(&file).unwrap();
    for part in ["width=\"900\" height=\"520\"", "Feeder", "frequency (rpm)", "7 kN", "\n70\n"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(!text.contains("\n80\n") || text.contains("\n100\n"), "{text}");
    for (arguments, parts) in [
        ("--size 90x20", ["--size", "must be from "]),
        ("--size 900", ["--size 900", "WIDTHxHEIGHT"]),
        ("--size NaNxNaN", ["--size", "must be from "]),
        ("--y-range 0:3", ["--y-range 0:3", "0 < LOW < HIGH"]),
        ("--y-range 3:1 --linear", ["--y-range 3:1", "LOW < HIGH"]),
        ("--y-range 1:inf", ["--y-range 1:inf", "LOW:HIGH"]),
        ("--y-range 1", ["--y-range 1", "LOW:HIGH"]),
        ("--x-range 1", ["--x-range 1", "LOW:HIGH"]),
        ("--x-range 3:2", ["--x-range 3:2", "LOW < HIGH"]),
    ] {
        refused(&format!("{curves} {arguments}"), &parts);
    }
    let many: Vec<String> = (1..=41).map(|i| format!("{i}kN")).collect();
    let many = curves.replace("1kN,2kN,3kN,4kN,5kN,6kN,7kN", &many.join(","));
    refused(&many, &["41 curves", "≤ 40"]);
}

/// The inputs that a picture shares stand below its title, each with its symbol and its unit.
#[test]
fn a_picture_shows_the_data_of_its_machine() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("picture.svg");
    let machine = "--mass 50t --stiffness 1000 --unbalance 0.35kg*m --units kN,mm";
    let grids = "--friction 1kN,2kN --frequency 20rpm:120rpm:9";
    for (command, line) in [
        (
            format!("response-curve {machine} {grids}"),
            "e = 0.35 kg·m\n",
        ),
        (format!("map {machine} {grids}"), "m = 50 t, k = 1000 kN/mm"),
        ("response-curve --omega 0.5:2:9 --alpha 2,3 --damping-ratio 5%".to_owned(), "ζ = 5%\n"),
        (format!("motion-plot {machine} --friction 10N --frequency 90rpm"), "f = 90 rpm"),
        (
            "motion-plot --mass 800kg --period 2.2s --friction-coefficient 0.05 --base-acceleration 0.2g --frequency 3rad/s"
                .to_owned(),
            "Steady motion: m = 800 kg, T = 2.2 s, µ = 0.05, ω",
        ),
    ] {
        stdout(&format!("{command} --out {} --overwrite", file.display()));
        let text = std::fs::read_to_string(&file).unwrap();
        let shown: Vec<&str> = text.lines().filter(|line| line.contains(" = ")).collect();
        assert!(text.contains(line), "{command}: {shown:?}");
    }
}

/// Without a machine a quantity is divided by its value for a slow force without friction.
#[test]
fn a_column_in_ratios_has_the_unit_of_its_quantity() {
    for (quantity, unit) in [
        ("displacement", "p₀/k"),
        ("velocity", "p₀/√(k m)"),
        ("acceleration", "p₀/m"),
        ("force", "p₀"),
        ("transmissibility", "1"),
    ] {
        let text = stdout(&format!("response-curve {quantity} --omega 0.5:2:3 --alpha 3"));
        let due = format!("curve,omega[1],regime,{quantity}[{unit}],margin[1],point");
        assert_eq!(text.lines().next(), Some(due.as_str()));
    }
}

/// A machine on a moving support or base as the command's options, and its amplitude by the library at a frequency in Hz.
struct Moved {
    machine: [f64; 4],
    excitation: stickslip::Excitation,
    option: &'static str,
    amplitude: f64,
}

impl Moved {
    fn at(&self, of: stickslip::motion::Amplitude, hertz: f64) -> f64 {
        let [mass, stiffness, friction, damping] = self.machine;
        let body =
            stickslip::Oscillator::new(mass, stiffness, friction).unwrap().with_damping(damping).unwrap();
        let drive =
            stickslip::Drive::new(self.excitation, self.amplitude, std::f64::consts::TAU * hertz).unwrap();
        of.of(drive.ratios(&body).unwrap(), self.excitation).unwrap().value.unwrap()
    }

    fn options(&self) -> String {
        let [mass, stiffness, friction, damping] = self.machine;
        format!(
            "--mass {mass} --stiffness {stiffness} --friction {friction} --damping {damping} --{} {} --units N,m",
            self.option, self.amplitude
        )
    }
}

/// Every maximum among 6,000 frequencies has a row, as high as the highest of them, however few rows are asked for.
#[test]
fn every_maximum_has_a_row() {
    use stickslip::{Excitation, motion::Amplitude};
    let mut maxima = 0;
    for (machine, excitation, option, amplitude, from, to) in [
        (
            [53.27, 86.8, 1.263, 2.72],
            Excitation::DampedFootMotion,
            "damped-foot-displacement",
            0.0873,
            0.020_308,
            0.1219,
        ),
        ([53.27, 86.8, 1.263, 2.72], Excitation::FootMotion, "foot-displacement", 0.0873, 0.020_308, 0.1219),
        ([800.0, 6525.0, 392.0, 60.0], Excitation::FootMotion, "foot-displacement", 0.3, 0.04, 1.5),
        ([1.0, 100.0, 1.0, 0.2], Excitation::SurfaceAcceleration, "base-acceleration", 1.3, 0.15, 4.0),
    ] {
        let moved = Moved { machine, excitation, option, amplitude };
        for count in [5, 9, 40] {
            let options = moved.options();
            let found = rows(&format!(
                "response-curve transmissibility {options} --frequency {from}Hz:{to}Hz:{count}"
            ));
            let step = (to - from) / 6000.0;
            let dense: Vec<f64> = (0..=6000)
                .map(|i| moved.at(Amplitude::Transmissibility, from + step * f64::from(i)))
                .collect();
            for (i, around) in dense.windows(3).enumerate() {
                let [before, here, after] = [around[0], around[1], around[2]];
                // A maximum of this height is more than the rounding of a search.
                let is_top = here > before * (1.0 + 1e-7) && here > after * (1.0 + 1e-7);
                if !is_top {
                    continue;
                }
                let x = from + step * (i as f64 + 1.0);
                let near = found.iter().filter(|row| (row.x - x).abs() <= 2.0 * step);
                let most = near.map(|row| row.value.unwrap()).fold(0.0, f64::max);
                assert!(
                    most >= here * (1.0 - 1e-9) && most < here * 1.01,
                    "{options} {count} at {x} Hz: {most} for {here}"
                );
                maxima += 1;
            }
        }
    }
    assert!(maxima > 20, "{maxima}");
}

/// Rows on both sides of the frequency where the body begins to move, and a line through the rows that is right to a
/// pixel from there on: p₀ = √(k² + c²ω²) u₀, or m ω² u₀, is the friction.
#[test]
fn the_onset_of_sliding_is_refined() {
    use stickslip::{Excitation, motion::Amplitude};
    for (machine, excitation, option, amplitude, onset, to) in [
        ([1.0, 100.0, 1.0, 0.4], Excitation::SurfaceMotion, "base-displacement", 0.02, 50f64.sqrt(), 4.0),
        // √(100² + 40² ω²) 0.005 = 1 at ω = √3e4/40.
        (
            [1.0, 100.0, 1.0, 40.0],
            Excitation::DampedFootMotion,
            "damped-foot-displacement",
            0.005,
            3e4f64.sqrt() / 40.0,
            4.0,
        ),
    ] {
        let moved = Moved { machine, excitation, option, amplitude };
        let onset = onset / std::f64::consts::TAU;
        let options = moved.options();
        let found = rows(&format!("response-curve force {options} --frequency 0.2Hz:{to}Hz:12"));
        let pair: Vec<&Row> = found.iter().filter(|row| row.point == "onset").collect();
        assert!(
            pair.len() == 2 && pair[0].regime == "stuck" && pair[1].regime == "sticking",
            "{options}: {pair:?}"
        );
        assert!(
            pair.iter().all(|row| (row.x / onset - 1.0).abs() < 1e-12),
            "{options}: {pair:?} for {onset}"
        );
        for i in 1..200 {
            // To the next row that was asked for, at the latest.
            let next = found.iter().find(|row| row.point == "grid" && row.x > onset).unwrap();
            let x = onset + (next.x - onset) * f64::from(i) / 200.0;
            // Where the curve is steep, it is right to a pixel to either side.
            let pixel = (to - 0.2) / 640.0;
            let around =
                [x - pixel, x, x + pixel].map(|x| moved.at(Amplitude::TransmittedForce, x) * machine[2]);
            let (least, most) = around.into_iter().fold((f64::MAX, 0.0f64), |(a, b), y| (a.min(y), b.max(y)));
            let after = found.iter().position(|row| row.x >= x).unwrap();
            let (a, b) = (&found[after - 1], &found[after]);
            let share = (x - a.x) / (b.x - a.x);
            let drawn = a.value.unwrap() * (b.value.unwrap() / a.value.unwrap()).powf(share);
            let is_right = drawn > least * (1.0 - PIXEL) && drawn < most * (1.0 + PIXEL);
            assert!(is_right, "{options} at {x} Hz: {drawn} for {around:?}");
        }
    }
}
