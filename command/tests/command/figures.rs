//! `stickslip figure`, `figures` and `map` from the user's side.

use crate::command_line::{refused, stdout};
use crate::kept::Kept;
use crate::place::place;
#[cfg(feature = "png")]
use std::path::Path;

#[test]
fn a_figure_goes_to_standard_output_or_a_file() {
    let drawing = stickslip_figures::figure("8").unwrap().svg().unwrap();
    assert!(stdout("figure 8") == drawing);
    let file = place("figure.svg");
    assert_eq!(stdout(&format!("figure 8 --out {}", file.display())), "");
    assert!(std::fs::read_to_string(file).unwrap() == drawing);
    let data = place("figure.csv");
    stdout(&format!("figure 10a --out {}", data.display()));
    let data = std::fs::read_to_string(data).unwrap();
    assert!(data.starts_with("panel,series,x,y,value\n,Ω = 1.2,"), "{}", &data[..60]);
}

#[test]
fn all_figures_by_one_command() {
    let names: Vec<String> = stdout("figures").lines().map(str::to_owned).collect();
    assert_eq!(names, stickslip_figures::NAMES);
    let folder = place("all-figures");
    stdout(&format!("figures --all --dir {}", folder.display()));
    for name in names {
        let drawing = std::fs::read_to_string(folder.join(format!("{name}.svg"))).unwrap();
        assert!(drawing.starts_with("<svg") && drawing.trim_end().ends_with("</svg>"), "{name}");
    }
    stdout(&format!("figures --all --format csv --dir {}", folder.display()));
    let data = std::fs::read_to_string(folder.join("10b.csv")).unwrap();
    assert!(data.starts_with("panel,series,x,y,value\n"), "{}", &data[..40]);
}

#[cfg(feature = "png")]
#[test]
fn figures_and_maps_as_png_and_pdf() {
    let is_png = |file: &Path| std::fs::read(file).unwrap().starts_with(b"\x89PNG\r\n\x1a\n");
    let file = place("figure-9b.png");
    stdout(&format!("figure 9b --out {}", file.display()));
    assert!(is_png(&file));
    let is_pdf = |file: &Path| std::fs::read(file).unwrap().starts_with(b"%PDF-1.4");
    let file = place("figure-9b.pdf");
    stdout(&format!("figure 9b --out {}", file.display()));
    assert!(is_pdf(&file));
    let file = place("curve.pdf");
    stdout(&format!("response-curve --omega 0.3:2:20 --alpha 3 --size 500x400 --out {}", file.display()));
    assert!(is_pdf(&file));
    let file = place("map-regime.png");
    stdout(&format!("map --omega 0.3:2:20 --alpha 0.5:8:10 --out {}", file.display()));
    assert!(is_png(&file));
}

#[cfg(not(feature = "png"))]
#[test]
fn a_build_without_png_says_so() {
    for arguments in ["figure 8 --out border.png", "map --out border.pdf", "figures --all --format pdf"] {
        refused(arguments, &["needs a build with the feature png", "rsvg-convert"]);
    }
}

#[test]
fn a_map_holds_every_point_of_the_grid() {
    let text = stdout("map regime --omega 0.4,0.7,1 --alpha 0.5:7.5:3");
    let due = [
        "omega,alpha,regime",
        "0.4,0.5,stuck",
        "0.7,0.5,stuck",
        "1.0,0.5,stuck",
        "0.4,4.0,sticking",
        "0.7,4.0,non-sticking",
        "1.0,4.0,unbounded",
        "0.4,7.5,non-sticking",
        "0.7,7.5,non-sticking",
        "1.0,7.5,unbounded",
    ];
    assert_eq!(text.lines().collect::<Vec<_>>(), due);
    assert_eq!(
        stdout("map stops --omega 0.4 --alpha 0.5,6,7"),
        "omega,alpha,stops\n0.4,0.5,\n0.4,6.0,2\n0.4,7.0,0\n"
    );
    let margin = stdout("map margin --omega 1 --alpha 2");
    let value: f64 = margin.lines().nth(1).unwrap().rsplit(',').next().unwrap().parse().unwrap();
    assert!((value - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    let steady = stdout("map steady:max_displacement --omega 0.4 --alpha 6");
    assert!(steady.lines().nth(1).unwrap().starts_with("0.4,6.0,6.7938"), "{steady}");
}

#[test]
fn a_map_is_drawn_with_a_key_and_the_border() {
    for (quantity, words) in [
        ("regime", vec!["stuck", "sticking", "non-sticking"]),
        ("stops", vec!["stops in a cycle", "white: the body never moves"]),
        ("margin", vec!["margin", "sticking threshold"]),
        ("steady:stick_fraction", vec!["fraction of time at rest"]),
        ("max_velocity", vec!["peak velocity (B ω", ">d</tspan>"]),
    ] {
        let file = place(&format!("map-{}.svg", quantity.replace(':', "-")));
        stdout(&format!("map {quantity} --omega 0.3:2:20 --alpha 0.5:8:10 --out {}", file.display()));
        let drawing = std::fs::read_to_string(file).unwrap();
        for word in words {
            assert!(drawing.contains(word), "{quantity}: {word}");
        }
        assert!(drawing.matches("<rect").count() > 20, "{quantity}");
    }
}

/// A key has at most eight lines, and values far beyond nearly all others, as near a pole, are cut off with a
/// note.
#[test]
fn a_map_can_be_read_at_low_frequencies_and_at_a_pole() {
    let draw = |arguments: &str| {
        let file = place("map-readable.svg");
        stdout(&format!("map {arguments} --overwrite --out {}", file.display()));
        std::fs::read_to_string(file).unwrap()
    };
    let stops = draw("stops --omega 0.02:0.1:9 --alpha 0.5:3:6");
    assert!(
        stops.contains("\n7 or more\n")
            && !stops.contains("\n8\n")
            && stops.contains("white: the body never moves"),
        "{stops}"
    );
    let margin = draw("margin --omega 0.2:2:37 --alpha 0.5:8:16");
    assert!(margin.contains("cut off below") && margin.contains("\n10⁻²\n"), "{margin}");
    let fraction = draw("steady:stick_fraction --omega 0.2:1:9 --alpha 1.2:6:7");
    // The numbers of the key rise upwards, from 0, no rest.
    let key = fraction.split("fraction of time at rest\n").last().unwrap();
    let (none, much) = (key.find("\n0.0\n"), key.find("\n0.6\n"));
    let height = |end: Option<usize>| -> i32 {
        let with = key[..end.unwrap()].rsplit(" y=\"").next().unwrap();
        with.split('"').next().unwrap().parse().unwrap()
    };
    assert!(height(none) > height(much), "{key}");
}

/// Small maps with names, with a linear and with a logarithmic scale; `STICKSLIP_WRITE=1` writes them.
#[test]
fn the_kept_maps_are_what_is_drawn() {
    let mut kept = Kept::default();
    for (name, arguments) in [
        ("map-regime", "regime --omega 0.3:1.2:6 --alpha 0.6:4.6:5"),
        ("map-margin", "margin --omega 0.6:1.4:6 --alpha 1:2:4"),
        ("map-max_displacement", "max_displacement --omega 0.2:3:6 --alpha 30:60:4"),
        ("map-stops", "stops --omega 0.1:0.4:4 --alpha 2:6:4"),
    ] {
        let drawn = place(&format!("kept-{name}.svg"));
        stdout(&format!("map {arguments} --out {}", drawn.display()));
        let drawing = std::fs::read_to_string(drawn).unwrap();
        assert!(
            kept.at(&format!("tests/data/{name}.svg"), &drawing) == drawing,
            "{name} is not what is drawn"
        );
    }
}

/// An existing picture is left alone unless it is to be replaced, even if the command fails.
#[test]
fn a_picture_is_replaced_where_that_is_asked_for() {
    let file = place("replaced.svg");
    let name = file.display();
    std::fs::write(&file, "a picture").unwrap();
    for arguments in ["figure 8", "map --omega 0.5:1:3 --alpha 2:3:3"] {
        refused(&format!("{arguments} --out {name}"), &["replaced.svg", "must not exist yet", "--overwrite"]);
    }
    let tall = "map --omega 0.1:2:3 --alpha 1:1000:1000000 --overwrite";
    refused(&format!("{tall} --out {name}"), &["--alpha: 1000000 values, must be ≤ 20000"]);
    refused("map --out /nowhere/at/all.svg", &["--out /nowhere/at/all.svg"]);
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "a picture");
    stdout(&format!("figure 8 --overwrite --out {name}"));
    assert!(std::fs::read_to_string(&file).unwrap().starts_with("<svg"));
    // No temporary file is left next to it.
    let beside = std::fs::read_dir(file.parent().unwrap()).unwrap().map(|entry| entry.unwrap().file_name());
    let left: Vec<_> = beside.filter(|name| name.to_string_lossy().starts_with("replaced.svg.")).collect();
    assert!(left.is_empty(), "{left:?}");
}

#[test]
fn bad_input_is_one_line_with_argument_value_and_inequality() {
    for (arguments, parts) in [
        ("figure 11", vec!["'11'", "<FIGURE>", "possible values: 1, 2, 3"]),
        ("figure 8 --out border.eps", vec!["--out border.eps", ".svg", ".png", ".pdf", ".csv"]),
        ("figure 8 --out border", vec!["--out border", "must end in"]),
        ("figure 8 --out /nowhere/at/all.svg", vec!["--out /nowhere/at/all.svg"]),
        ("map --out map.gif", vec!["--out map.gif", ".svg"]),
        ("figures --all --format eps", vec!["'eps'", "possible values: svg, png, pdf, csv"]),
        ("map speed", vec!["map speed", "must be one of"]),
        ("map steady:multipliers", vec!["map steady:multipliers", "must be one of"]),
        ("map --omega -1:2:10", vec!["--omega -1", "must be > 0"]),
        ("map --alpha 0:2:10", vec!["--alpha 0", "must be > 0"]),
        ("map --omega 2:1:10 --out map.svg", vec!["--omega", "ascending"]),
        (
            "map --omega 0.1:2:100000 --alpha 1:2:100000 --out map.svg",
            vec!["10000000000 points", "≤ 4000000"],
        ),
    ] {
        refused(arguments, &parts);
    }
}

#[test]
fn a_picture_has_as_many_points_as_fit() {
    let file = place("map-limits.svg");
    let map = |grids: &str| format!("map {grids} --out {}", file.display());
    for (grids, words) in [
        ("--omega 0.5:2:20001 --alpha 2:3:2", "--omega: 20001 values, must be ≤ 20000 in a picture"),
        ("--omega 2:3:2 --alpha 0.5:2:20001", "--alpha: 20001 values, must be ≤ 20000 in a picture"),
        ("--omega 2:3:2001 --alpha 0.5:2:2000", "--omega, --alpha: 4002000 points, must be ≤ 4000000"),
    ] {
        refused(&map(grids), &[words]);
        assert!(!file.exists());
    }
    for grids in ["--omega 0.5:2:20000 --alpha 2:3:2", "--omega 2:3:2 --alpha 0.5:2:20000"] {
        stdout(&map(grids));
        std::fs::remove_file(&file).unwrap();
    }
}

/// The motion of a machine begins with the cycle of its drive, and is named by the machine's data.
#[test]
fn a_motion_has_its_machine_in_the_title() {
    let machine =
        "--mass 50t --stiffness 1000kN/m --friction 5kN --frequency 0.55Hz --force 12kN --units kN,mm";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("motion.csv");
    stdout(&format!("motion-plot {machine} --out {}", file.display()));
    let text = std::fs::read_to_string(&file).unwrap();
    let first = text.lines().nth(1).unwrap();
    assert!(first.starts_with("displacement,sliding,0,"), "{first}");
    let drawn = stdout(&format!("motion-plot {machine}"));
    assert!(drawn.contains("m = 50 t") && drawn.contains("f = 0.55 Hz"), "{drawn}");
}

/// A map with a title, a size and a range of shades.
#[test]
fn a_map_looks_as_it_was_asked_to() {
    let map = "map steady:max_displacement --omega 0.5:1.5:8 --alpha 1.1:3:6";
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("map.svg");
    stdout(&format!("{map} --out {} --range 0:4 --title Stroke --size 700x500", file.display()));
    let text = std::fs::read_to_string(&file).unwrap();
    for part in ["width=\"700\" height=\"500\"", "Stroke"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    refused(&format!("{map} --range 4:0"), &["--range 4:0", "LOW < HIGH"]);
    refused(&format!("{map} --range 4"), &["--range 4", "LOW:HIGH"]);
    refused(&format!("{map} --size 4"), &["--size 4", "WIDTHxHEIGHT"]);
}
