//! Pictures of systems: the drawing of the bodies, motions with their loops, and curves with their peaks.

use super::MACHINE;
use crate::command_line::{refused, stdout};
use crate::place::place;

/// The places of the middles of the texts of a drawing.
fn texts(svg: &str) -> Vec<(f64, f64, String)> {
    let attribute = |tag: &str, name: &str| -> f64 {
        let (_, rest) = tag.split_once(&format!(" {name}=\"")).unwrap();
        rest.split_once('"').unwrap().0.parse().unwrap()
    };
    let found = svg.split("<text").skip(1).map(|part| {
        let (tag, rest) = part.split_once('>').unwrap();
        let text = rest.split_once('<').unwrap().0.to_owned();
        // A text that begins at its place has its middle behind it.
        let half = if tag.contains("\"start\"") { half(&text) } else { 0.0 };
        (attribute(tag, "x") + half, attribute(tag, "y"), text)
    });
    found.collect()
}

/// Half the width of a text.
fn half(text: &str) -> f64 {
    3.6 * text.chars().count() as f64
}

fn no_text_meets_another(texts: &[(f64, f64, String)]) {
    for (i, (x, y, text)) in texts.iter().enumerate() {
        for (other_x, other_y, other) in &texts[i + 1..] {
            let apart = (x - other_x).abs() > half(text) + half(other) || (y - other_y).abs() > 11.0;
            assert!(apart, "{text} meets {other}");
        }
    }
}

/// A tower of `count` storeys with long names, a brace in each.
fn tower(count: usize) -> String {
    let name = |i: usize| match i {
        0 => "ground".to_owned(),
        i => format!("storey number {i} of the tower"),
    };
    let masses: String = (1..=count).map(|i| format!("\"{}\" = \"{} t\"\n", name(i), 19 + i)).collect();
    let storeys: String = (1..=count)
        .map(|i| {
            let ends = format!("between = [\"{}\", \"{}\"]", name(i - 1), name(i));
            format!(
                "[[springs]]\n{ends}\nstiffness = \"{} kN/mm\"\ndamping = \"0.1 kN*s/mm\"\n[[contacts]]\n\
                 name = \"brace with a long name {i}\"\n{ends}\nfriction = \"{} kN\"\nstiffness = \"40 kN/mm\"\n",
                62 - 2 * i.min(20),
                17 + 3 * i
            )
        })
        .collect();
    format!(
        "units = \"kN,mm\"\n[masses]\n{masses}{storeys}[base]\n\
         acceleration = {{ amplitude = \"0.2 g\", frequency = \"1 Hz\" }}\n"
    )
}

#[test]
fn a_tower_is_drawn_upwards_with_each_storey() {
    let folder = place("drawings-of-towers");
    std::fs::create_dir(&*folder).unwrap();
    let (file, drawing) = (folder.join("tower.toml"), folder.join("tower.svg"));
    std::fs::write(&file, tower(12)).unwrap();
    stdout(&format!("system {} --picture {}", file.display(), drawing.display()));
    let svg = std::fs::read_to_string(&drawing).unwrap();
    let texts = texts(&svg);
    no_text_meets_another(&texts);
    let attribute = |tag: &str, name: &str| -> f64 {
        tag.split_once(&format!(" {name}=\"")).unwrap().1.split_once('"').unwrap().0.parse().unwrap()
    };
    // A letter of 12 pixels stays one of 8 on a screen of 1280 pixels.
    let width = attribute(svg.split_once('>').unwrap().0, "width");
    assert!(width < 1900.0, "{width}");
    let boxes: Vec<[f64; 4]> = svg
        .split("<rect")
        .filter(|tag| tag.contains("#dde7f2"))
        .map(|tag| ["x", "y", "width", "height"].map(|name| attribute(tag, name)))
        .collect();
    assert_eq!(boxes.len(), 12);
    let mut below = f64::INFINITY;
    for (i, [x, y, wide, high]) in boxes.into_iter().enumerate() {
        // Each storey stands above the one before, with its whole name within it.
        assert!(y + high < below, "{i}");
        below = y;
        let name = format!("storey number {} of the tower", i + 1);
        let (middle, at, _) = texts.iter().find(|text| text.2 == name).unwrap();
        assert!(middle - half(&name) > x && middle + half(&name) < x + wide && *at > y && *at < y + high);
        let brace = format!("brace with a long name {}: 40 kN/mm, {} kN", i + 1, 20 + 3 * i);
        assert!(texts.iter().any(|text| text.2 == brace && text.0 + half(&brace) < width), "{brace}");
        // Masses are as they are typed.
        let mass = format!("{} t", 20 + i);
        assert!(texts.iter().any(|text| text.2 == mass && text.1 > y && text.1 < y + high), "{mass}");
    }
    // The base moves, and the loads of that are its own.
    let of = |words: &str| texts.iter().filter(|text| text.2.contains(words)).count();
    assert_eq!((of("ground, moves: 1961.33 mm/s² at 1 Hz"), of(" at 1 Hz")), (1, 1));
}

/// Twenty blocks in a row, each of which rubs on the ground and on the one before.
fn row(count: usize) -> String {
    let name = |i: usize| if i == 0 { "ground".to_owned() } else { format!("block{i}") };
    let masses: String = (1..=count).map(|i| format!("{} = \"2 kg\"\n", name(i))).collect();
    let parts: String = (1..=count)
        .map(|i| {
            let (before, own) = (name(i - 1), name(i));
            format!(
                "[[springs]]\nbetween = [\"{before}\", \"{own}\"]\nstiffness = \"20 N/mm\"\n\
                 [[contacts]]\nname = \"floor{i}\"\nbetween = [\"ground\", \"{own}\"]\nfriction = \"5 N\"\n\
                 [[contacts]]\nname = \"side{i}\"\nbetween = [\"{before}\", \"{own}\"]\nfriction = \"3 N\"\n"
            )
        })
        .collect();
    format!("units = \"N,mm\"\n[masses]\n{masses}{parts}")
}

/// Each line is within the frame, and none goes through a body.
#[test]
fn forty_contacts_are_drawn_apart_from_each_other_and_from_bodies() {
    let folder = place("drawings-of-rows");
    std::fs::create_dir(&*folder).unwrap();
    for (count, width) in [(3, 1600.0), (20, 1300.0)] {
        let (file, drawing) = (folder.join("row.toml"), folder.join(format!("row{count}.svg")));
        std::fs::write(&file, row(count)).unwrap();
        stdout(&format!("system {} --picture {}", file.display(), drawing.display()));
        let svg = std::fs::read_to_string(&drawing).unwrap();
        let texts = texts(&svg);
        no_text_meets_another(&texts);
        for i in 1..=count {
            for due in [format!("floor{i}: 5 N"), format!("side{i}: 3 N")] {
                assert_eq!(texts.iter().filter(|text| text.2 == due).count(), 1, "{due}");
            }
        }
        let part = |tag: &str, name: &str| -> String {
            tag.split_once(&format!(" {name}=\"")).unwrap().1.split_once('"').unwrap().0.to_owned()
        };
        let size = ["width", "height"].map(|name| part(&svg, name).parse::<f64>().unwrap());
        assert!(size[0] < width, "{count}: {}", size[0]);
        let boxes: Vec<[f64; 4]> = svg
            .split("<rect")
            .filter(|tag| tag.contains("#dde7f2"))
            .map(|tag| ["x", "y", "width", "height"].map(|name| part(tag, name).parse().unwrap()))
            .collect();
        assert_eq!(boxes.len(), count);
        for tag in svg.split("<polyline").skip(1) {
            let points: Vec<[f64; 2]> = part(tag, "points")
                .split(' ')
                .map(|point| point.split_once(',').unwrap())
                .map(|(x, y)| [x.parse().unwrap(), y.parse().unwrap()])
                .collect();
            for pair in points.windows(2) {
                for place in (0..=50).map(|i| f64::from(i) / 50.0) {
                    let at = [0, 1].map(|axis| pair[0][axis] + place * (pair[1][axis] - pair[0][axis]));
                    assert!(at.iter().zip(&size).all(|(x, most)| *x >= 0.0 && x <= most), "{count}: {at:?}");
                    let is_inside = |[x, y, wide, high]: &[f64; 4]| {
                        at[0] > x + 1.0 && at[0] < x + wide - 1.0 && at[1] > y + 1.0 && at[1] < y + high - 1.0
                    };
                    assert!(!boxes.iter().any(is_inside), "{count}: {at:?}");
                }
            }
        }
    }
}

/// Of many bodies the first forty are drawn, or the chosen ones, with what joins them, and it says of how many.
#[test]
fn a_drawing_of_many_bodies_shows_some_of_them() {
    let folder = place("drawings-of-many");
    std::fs::create_dir(&*folder).unwrap();
    let (file, drawing) = (folder.join("row.toml"), folder.join("row.svg"));
    std::fs::write(&file, row(45)).unwrap();
    for (choice, count, last, floors) in
        [("", 40, "block40", 40), (" --coordinates block2,block3,block45", 3, "block45", 3)]
    {
        let picture = format!("--picture {} --overwrite", drawing.display());
        stdout(&format!("system {} {picture}{choice}", file.display()));
        let svg = std::fs::read_to_string(&drawing).unwrap();
        let texts = texts(&svg);
        no_text_meets_another(&texts);
        let of = |words: &str| texts.iter().filter(|text| text.2.contains(words)).count();
        assert_eq!((svg.matches("#dde7f2").count(), of("floor")), (count, floors));
        assert_eq!((of(&format!("{count} of 45 bodies")), of(last)), (1, 1));
        // block1 joins the second to the ground where it is shown, and the contact of two neighbours is drawn.
        assert_eq!((of("side1: "), of("side3: "), of("side45: ")), (usize::from(count == 40), 1, 0));
    }
}

#[test]
fn a_drawing_shows_the_loads_of_each_body_within_it() {
    let folder = place("drawings-of-loads");
    std::fs::create_dir(&*folder).unwrap();
    let (file, drawing) = (folder.join("loads.toml"), folder.join("loads.svg"));
    let loads = r#"
[[forces]]
on = "block"
constant = "70 N"
[[forces]]
on = "roof"
amplitude = "5 N"
frequency = "7 Hz"
[base]
acceleration = { amplitude = "0.1 g", frequency = "2 Hz" }
"#;
    std::fs::write(&file, format!("{MACHINE}{loads}")).unwrap();
    stdout(&format!("system {} --picture {}", file.display(), drawing.display()));
    let svg = std::fs::read_to_string(&drawing).unwrap();
    let texts = texts(&svg);
    no_text_meets_another(&texts);
    for due in ["70 N, constant", "1500 N at 3 Hz, 5 N at 7 Hz", "ground, moves: 980.665 mm/s² at 2 Hz"] {
        assert_eq!(texts.iter().filter(|text| text.2 == due).count(), 1, "{due}: {texts:?}");
    }
    // On a base that moves the roof stands above the block.
    let height = |name: &str| texts.iter().find(|text| text.2 == name).unwrap().1;
    assert!(
        height("roof") < height("block") && height("block") < height("ground, moves: 980.665 mm/s² at 2 Hz")
    );
    // An arrow to both sides beside each load.
    assert_eq!(svg.matches("h20m-5,-4l5,4l-5,4").count(), 2);
}

#[test]
fn a_picture_of_twelve_bodies_shows_all_of_them() {
    let folder = place("pictures-of-towers");
    std::fs::create_dir(&*folder).unwrap();
    let (file, picture) = (folder.join("tower.toml"), folder.join("tower.svg"));
    std::fs::write(&file, tower(12)).unwrap();
    stdout(&format!("system {} simulate --until 0.5s --picture {}", file.display(), picture.display()));
    let svg = std::fs::read_to_string(&picture).unwrap();
    // Long texts are broken into lines.
    let words = svg.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [", 1 to 6 of 12", ", 7 to 12 of 12"] {
        assert!(words.contains(&format!("displacements{part}")), "{part}");
    }
    for i in 1..=12 {
        assert!(words.contains(&format!("storey number {i} of the tower")), "storey {i}");
        assert!(words.contains(&format!("loop of brace with a long name {i}")), "brace {i}");
    }
}

#[test]
fn a_drawing_names_each_part_once_and_no_text_meets_another() {
    let folder = place("drawings-of-systems");
    std::fs::create_dir(&*folder).unwrap();
    let (file, drawing) = (folder.join("machine.toml"), folder.join("machine.svg"));
    // A chain, a ring, and a contact that leaps over bodies.
    let extra = r#"
[[contacts]]
between = ["ground", "roof"]
friction = "5 N"
stiffness = "2 N/mm"
[[stops]]
name = "end <stop>"
between = ["block", "mast"]
gap = "9 mm"
stiffness = "1 kN/mm"
[[springs]]
between = ["roof", "mast"]
stiffness = "3 N/mm"
damping = "4 N*s/mm"
"#;
    std::fs::write(&file, MACHINE.replace("[masses]", "[masses]\nmast = \"20 kg\"") + extra).unwrap();
    stdout(&format!("system {} --picture {}", file.display(), drawing.display()));
    let svg = std::fs::read_to_string(&drawing).unwrap();
    assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"));
    let texts = texts(&svg);
    let due = [
        "ground",
        "block",
        "roof",
        "mast",
        "1 t",
        "500 kg",
        "20 kg",
        "200 N/mm",
        "0.3 N·s/mm",
        "300 N/mm",
        "3 N/mm",
        "4 N·s/mm",
        "bearing: 450 N",
        "contacts[2]: 2 N/mm, 5 N",
        "end &lt;stop&gt;: gap 9 mm",
        "1500 N at 3 Hz",
    ];
    let mut own: Vec<&str> = texts.iter().map(|text| text.2.as_str()).collect();
    let mut due = due.to_vec();
    own.sort_unstable();
    due.sort_unstable();
    assert_eq!(own, due);
    no_text_meets_another(&texts);
    refused(&format!("system {} --picture {}", file.display(), drawing.display()), &["--picture", "exist"]);
    refused(&format!("system {} --picture none.eps", file.display()), &["must end in .svg, .png or .pdf"]);
    let line = format!("system {} --overwrite --picture {}", file.display(), drawing.display());
    refused(&format!("{line} --size 0x9"), &["--size 0x9", "1x1"]);
    stdout(&format!("{line} --size 900x500 --title A&B"));
    let sized = std::fs::read_to_string(&drawing).unwrap();
    assert!(sized.contains(r#"width="900" height="500""#) && sized.contains(">A&amp;B</text>"), "{sized}");
    // The title stands above all else, and what is seen has the proportions of the size.
    let numbers = |from: &str| -> Vec<f64> {
        let text = sized.split(from).nth(1).unwrap().split('"').next().unwrap();
        text.split(' ').map(|x| x.parse().unwrap()).collect()
    };
    let view = numbers("viewBox=\"");
    assert!((view[2] * 5.0 - view[3] * 9.0).abs() < 2.0, "{view:?}");
    let lines: Vec<_> = self::texts(&sized).into_iter().map(|(_, y, text)| (y, text)).collect();
    let top = lines.iter().min_by(|a, b| a.0.total_cmp(&b.0)).unwrap();
    assert!(top.1 == "A&amp;B" && top.0 > view[1], "{top:?}");
}

/// A drawing as PNG and PDF: of the proportions of the SVG, or of the size asked for.
#[cfg(feature = "png")]
#[test]
fn a_drawing_may_be_an_image_or_a_page() {
    let folder = place("drawings-of-all-kinds");
    std::fs::create_dir(&*folder).unwrap();
    let file = folder.join("machine.toml");
    std::fs::write(&file, MACHINE).unwrap();
    let drawn = |end: &str, look: &str| {
        let picture = folder.join(format!("machine.{end}"));
        stdout(&format!("system {} --overwrite --picture {}{look}", file.display(), picture.display()));
        std::fs::read(picture).unwrap()
    };
    let svg = String::from_utf8(drawn("svg", "")).unwrap();
    let of = |name: &str| -> f64 {
        svg.split(&format!("{name}=\"")).nth(1).unwrap().split('"').next().unwrap().parse().unwrap()
    };
    let (width, height) = (of("width"), of("height"));
    let size = |png: &[u8]| -> [u32; 2] {
        assert!(png.starts_with(b"\x89PNG"));
        [16, 20].map(|at| u32::from_be_bytes(png[at..at + 4].try_into().unwrap()))
    };
    let png = drawn("png", "");
    let [wide, high] = size(&png);
    assert!(wide == 1600 && (f64::from(high) - 1600.0 * height / width).abs() <= 1.0, "{wide} × {high}");
    assert_eq!(size(&drawn("png", " --size 500x300")), [1000, 600]);
    // Letters are outlines, so that the picture is more than its lines.
    assert!(png.len() > 10_000, "{} bytes", png.len());
    let pdf = drawn("pdf", "");
    assert!(pdf.starts_with(b"%PDF-"));
    let text = String::from_utf8_lossy(&pdf);
    let page = text.split("/MediaBox").nth(1).unwrap().trim_start().trim_start_matches('[');
    let page: Vec<f64> = page.split([' ', ']']).filter_map(|x| x.parse().ok()).take(4).collect();
    assert!((page[2] - 0.75 * width).abs() < 0.1 && (page[3] - 0.75 * height).abs() < 0.1, "{page:?}");
    assert!(pdf.len() > 3_000, "{} bytes", pdf.len());
}

#[test]
fn pictures_show_each_coordinate_and_the_loop_of_each_element() {
    let folder = place("pictures-of-systems");
    std::fs::create_dir(&*folder).unwrap();
    let file = folder.join("machine.toml");
    std::fs::write(&file, MACHINE).unwrap();
    for (name, line, parts) in [
        (
            "steady",
            "steady",
            vec!["Steady motion (periodic): block, roof, load at 3 Hz", "loop of bearing", "force (N)"],
        ),
        ("motion", "simulate --until 2s", vec!["displacement (mm)", "time (s)", "loop of bearing"]),
        ("curve", "curve --frequency 1Hz:9Hz:9", vec!["frequency (Hz)", "\na contact sticks\n"]),
        ("grid", "steady --set bearing.friction=100N:2kN:4", vec![]),
        ("friction", "steady --set bearing.friction=100N:900N:4", vec!["bearing.friction (N)"]),
    ] {
        let picture = folder.join(format!("{name}.svg"));
        let line = format!("system {} {line} --picture {}", file.display(), picture.display());
        if name == "grid" {
            refused(&line, &["both ends must have the same unit"]);
            continue;
        }
        stdout(&line);
        let svg = std::fs::read_to_string(&picture).unwrap();
        for part in parts {
            assert!(svg.contains(part), "{name}: {part}");
        }
    }
    refused(
        &format!(
            "system {} curve --frequency 1Hz:2Hz:2 --set bearing.friction=1N,2N --picture x.svg",
            file.display()
        ),
        &["--picture: needs one axis"],
    );
    refused(&format!("system {} border --picture x.svg", file.display()), &["--picture: this question"]);
}

/// The least pixel of a picture's lines of a colour, and the greatest: the top of the curve, and its foot.
fn heights(svg: &str, is_line: impl Fn(&str) -> bool) -> (f64, f64) {
    let lines = svg.split("<polyline ").skip(1).filter_map(|line| line.split("/>").next());
    let points = lines.filter(|line| is_line(line)).filter_map(|line| line.split("points=\"").nth(1));
    let ys = points.flat_map(|points| {
        let pairs = points.trim_end_matches('"').split_whitespace();
        pairs.filter_map(|pair| pair.split(',').nth(1)?.parse::<f64>().ok()).collect::<Vec<_>>()
    });
    ys.fold((f64::INFINITY, 0.0), |(low, high), y| (low.min(y), f64::max(high, y)))
}

/// Six frequencies, none at the peak of a lightly damped body, draw as high a peak as 601.
#[test]
fn a_drawn_curve_shows_its_peaks() {
    let folder = place("peaks-of-systems");
    std::fs::create_dir(&*folder).unwrap();
    let file = folder.join("one.toml");
    let text = "units = \"N,mm\"\n[masses]\nbody = \"1 t\"\n[[springs]]\nbetween = [\"ground\", \"body\"]\n\
                stiffness = \"200 N/mm\"\ndamping = \"0.2 N*s/mm\"\n[[contacts]]\nbetween = [\"ground\", \"body\"]\n\
                friction = \"10 N\"\n[[forces]]\non = \"body\"\namplitude = \"100 N\"\nfrequency = \"1 Hz\"\n";
    std::fs::write(&file, text).unwrap();
    let top = |count: usize| {
        let picture = folder.join(format!("{count}.svg"));
        let line = format!("system {} curve --frequency 1.5Hz:3Hz:{count}", file.display());
        stdout(&format!("{line} --picture {}", picture.display()));
        let svg = std::fs::read_to_string(&picture).unwrap();
        heights(&svg, |line| !line.contains("#DEDEDE") && line.split(',').count() > 8)
    };
    let (coarse, fine) = (top(6), top(601));
    assert!((coarse.0 - fine.0).abs() <= 4.0 && fine.1 - fine.0 > 1000.0, "{coarse:?} {fine:?}");
}
