//! Every kind of picture, in ratios and for machines, at rest, with one point, over huge and narrow ranges: no text leaves a picture or meets another.

use crate::command_line::stdout;
use crate::place::place;
use crate::text_boxes::faults;
use std::path::Path;

const BODY: &str = "--mass 50t --stiffness 1000kN/m --friction 5kN --units kN,mm";
const ISOLATOR: &str = "--mass 800kg --period 2.5s --friction-coefficient 0.06 --damping-ratio 5%";
const BASE: &str = "--mass 800kg --period 2.2s --base-acceleration";

/// The option that names the file of a picture, and the other arguments. QUAKE, PULSE and SYSTEM are files.
const PICTURES: &[(&str, &str)] = &[
    ("--out", "response-curve BODY --force 12kN --frequency 0.2Hz:2Hz:40"),
    ("--out", "response-curve velocity BODY --force 12kN --frequency 0.2Hz:2Hz:40"),
    ("--out", "response-curve acceleration BODY --force 12kN --frequency 0.2Hz:2Hz:40"),
    ("--out", "response-curve force BODY --force 12kN --frequency 0.2Hz:2Hz:40"),
    ("--out", "response-curve transmissibility BODY --force 12kN --frequency 0.2Hz:2Hz:40"),
    ("--out", "response-curve BODY --force 6kN,7kN,8kN,9kN,12kN --frequency 0.2Hz:2Hz:40"),
    ("--out", "response-curve BODY --force 12kN --frequency 0.2Hz:2Hz:40 --linear --size 450x300"),
    (
        "--out",
        "response-curve BASE 0.15g --friction-coefficient 0.05,0.1 --frequency 0.2Hz:4Hz:40 --units N,mm",
    ),
    (
        "--out",
        "response-curve --mass 1e-9kg --stiffness 1e-6N/m --friction 1e-15N --force 1e-14N --frequency 1Hz:10Hz:30",
    ),
    ("--out", "response-curve --omega 0.1:3:40 --alpha 1.5,3,6 --linear"),
    ("--out", "response-curve --omega 0.1:3:40 --alpha 0.5"),
    ("--out", "response-curve --omega 0.999:1.001:30 --alpha 1.2"),
    ("--out", "response-curve --omega 0.001:1000:40:log --alpha 3"),
    ("--out", "motion-plot BODY --force 6kN --frequency 1Hz"),
    ("--out", "motion-plot BODY --force 12kN --frequency 1Hz"),
    ("--out", "motion-plot BODY --force 1000000kN --frequency 1Hz"),
    ("--out", "motion-plot --mass 2kg --stiffness 4kN/m --friction 0.3N --frequency 200Hz --force 1.2N"),
    ("--out", "motion-plot --omega 0.15 --alpha 3"),
    ("--out", "motion-plot --omega 0.7 --alpha 2 --size 600x500"),
    ("--out", "motion-plot --omega 0.5 --alpha 4 --damping-ratio 0.02 --static-ratio 1.3"),
    ("--out", "map regime --omega 0.1:2:12 --alpha 1.1:10:9"),
    ("--out", "map stops --omega 0.1:2:12 --alpha 1.1:10:9"),
    ("--out", "map stops --omega 0.1:2:12 --alpha 0.1:0.9:9"),
    ("--out", "map margin --omega 0.1:2:12 --alpha 1.1:10:9"),
    ("--out", "map max_displacement --omega 0.1:2:12 --alpha 1.1:10:9"),
    ("--out", "map max_velocity --omega 1.5:1.5001:6 --alpha 5:5.0001:6"),
    ("--out", "map steady:max_displacement --omega 0.1:2:8 --alpha 0.5:10:6"),
    ("--out", "map stops BODY --frequency 0.2Hz:2Hz:8 --force 2kN:20kN:6"),
    (
        "--out",
        "map steady:max_displacement BASE 0.02g:0.4g:6 --friction-coefficient 0.05 --frequency 0.5Hz:3Hz:6 --units N,mm",
    ),
    ("--out", "map limits --omega 0.3:0.6:4 --alpha 3:6:3 --damping-ratio 0.02 --static-ratio 2"),
    ("--out", "decay --x0 10"),
    ("--out", "decay --x0 0.5"),
    ("--out", "decay --v0 3"),
    ("--out", "decay --x0 1000"),
    (
        "--out",
        "decay --mass 30kg --stiffness 12kN/m --friction 16N --damping-ratio 1% --x0 40mm --units N,mm",
    ),
    ("--out", "decay --mass 30kg --stiffness 12kN/m --friction 1.6e-9N --x0 4e-9mm --units N,mm"),
    ("--picture", "record QUAKE ISOLATOR"),
    ("--picture", "record QUAKE ISOLATOR --units kN,mm,g"),
    ("--picture", "record QUAKE ISOLATOR --scale 0.01"),
    ("--picture", "record QUAKE ISOLATOR --scale 1e6"),
    ("--picture", "record QUAKE ISOLATOR --scale 1e-3 --size 600x700"),
    ("--picture", "record PULSE --mass 50t --stiffness 1kN/mm --friction 5kN --units kN,mm"),
    ("--picture", "record PULSE --mass 50t --stiffness 1kN/mm --friction 50kN --units kN,mm"),
    ("--picture", "record QUAKE --mass 1t --no-spring --friction-coefficient 0.25 --slope 10deg --one-way"),
    ("--picture", "record QUAKE --yield-acceleration 0.08g --one-way"),
    (
        "--picture",
        "spectrum QUAKE --period 0.1s:4s:8:log --friction-coefficient 0.02,0.05,0.1 --damping-ratio 5%",
    ),
    (
        "--picture",
        "spectrum QUAKE --period 0.1s:4s:8 --friction-coefficient 0.02 --damping-ratio 5% --units kN,mm,g",
    ),
    ("--picture", "spectrum QUAKE --period 0.1s:4s:8 --friction-coefficient 2 --damping-ratio 5%"),
    ("--picture", "spectrum QUAKE PULSE --period 0.1s:4s:8 --mass 1t --friction-coefficient 0.02"),
    ("--picture", "spectrum QUAKE --yield-acceleration 0.02g:0.2g:6 --one-way"),
    ("--picture", "system SYSTEM"),
    ("--picture", "system SYSTEM steady"),
    ("--picture", "system SYSTEM steady --set bearing.friction=2MN"),
    ("--picture", "system SYSTEM curve --frequency 1Hz:5Hz:20"),
    ("--picture", "system SYSTEM simulate --until 2s"),
    ("--picture", "system SYSTEM simulate --until 0.001s"),
    ("--picture", "system SYSTEM record QUAKE --until 10s"),
    (
        "--out",
        "basins --omega 0.573 --alpha 3.92 --damping-ratio 0.005 --static-ratio 1.87 --x0 -12:12:7 --v0 -12:12:7",
    ),
    ("--out", "basins --omega 0.5 --alpha 0.8 --static-ratio 1.3 --x0 -3:3:5 --v0 -3:3:5"),
    (
        "--picture",
        "design friction BASE 0.15g --damping-ratio 5% --over 0.2Hz:2Hz --of absolute-displacement",
    ),
];

/// A quake, a pulse and a system, in a folder.
fn files(folder: &Path) {
    let mut quake = "time[s],acceleration[g]\n".to_owned();
    for i in 0..=600 {
        let t = f64::from(i) / 40.0;
        let a = 0.3 * (-((t - 6.0) / 3.0).powi(2)).exp() * (12.0 * t).sin() * (2.0 * t).cos();
        quake += &format!("{t},{a:.6}\n");
    }
    let system = r#"{"units": "N,mm", "masses": {"block": "1 t", "roof": "500 kg"},
        "springs": [{"between": ["ground", "block"], "stiffness": "200 N/mm", "damping": "0.3 N*s/mm"},
            {"between": ["block", "roof"], "stiffness": "300 N/mm"}],
        "contacts": [{"name": "bearing", "between": ["ground", "block"], "friction": "450 N"}],
        "forces": [{"on": "roof", "amplitude": "1.5 kN", "frequency": "3 Hz"}]}"#;
    std::fs::write(folder.join("quake.csv"), quake).unwrap();
    std::fs::write(folder.join("pulse.csv"), "time[s],force[kN]\n0,0\n0.1,12\n0.3,12\n0.4,0\n").unwrap();
    std::fs::write(folder.join("two.json"), system).unwrap();
}

#[test]
fn the_texts_of_every_kind_of_picture_keep_apart() {
    let folder = place("gallery");
    std::fs::create_dir(&folder).unwrap();
    files(&folder);
    let at = |name: &str| folder.join(name).display().to_string();
    let named = [
        ("BODY", BODY.to_owned()),
        ("ISOLATOR", ISOLATOR.to_owned()),
        ("BASE", BASE.to_owned()),
        ("QUAKE", at("quake.csv")),
        ("PULSE", at("pulse.csv")),
        ("SYSTEM", at("two.json")),
    ];
    let mut wrong = Vec::new();
    for (number, (option, arguments)) in PICTURES.iter().enumerate() {
        let picture = at(&format!("{number}.svg"));
        let arguments =
            named.iter().fold((*arguments).to_owned(), |text, (name, value)| text.replace(name, value));
        stdout(&format!("{arguments} {option} {picture}"));
        let (faults, texts) = faults(&std::fs::read_to_string(picture).unwrap());
        if !(faults.is_empty() && texts > 4) {
            wrong.push(format!("{arguments}: {texts} texts, {faults:#?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(PICTURES.len() >= 60);
}
