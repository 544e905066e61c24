//! Every output of every command: it has its row in docs/development/evidence.md, and a number of another origin beside it.

mod designs;
mod identified;
mod motions;
mod records;
mod same;
mod systems;
mod units;

use crate::command_line::{json, stdout};
use crate::random::Random;
use identified::{curve_of_samples, load_and_motion};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

const PAGE: &str = include_str!("../../../docs/development/evidence.md");

/// The names in the rows of a command, and those of its kinds such as `simulate --samples`.
fn rows() -> BTreeMap<&'static str, BTreeSet<&'static str>> {
    let mut all: BTreeMap<_, BTreeSet<_>> = BTreeMap::new();
    for line in PAGE.lines().filter_map(|line| line.strip_prefix("| `")) {
        let cells: Vec<&str> = line.split(" | ").collect();
        let of = cells[0].split('`').next().unwrap();
        all.entry(of).or_default().extend(cells[1].split('`').skip(1).step_by(2));
    }
    all
}

/// The names of an answer: the keys of an object, or those of a header without units.
fn keys(text: &str) -> BTreeSet<String> {
    let Ok(value) = serde_json::from_str::<Value>(text) else {
        let header = text.lines().next().unwrap();
        return header.split(',').map(|name| name.split('[').next().unwrap().to_owned()).collect();
    };
    let object = if value.is_array() { &value[0] } else { &value };
    object.as_object().unwrap().keys().cloned().collect()
}

/// A file of the test with this text.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> String {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path.display().to_string()
}

/// The inputs that an answer repeats before its outputs, and what says in which units they are.
const INPUTS: [&str; 7] =
    ["omega", "alpha", "damping_ratio", "static_friction_ratio", "physical", "units", "record"];

/// Each command by its examples: together they have the outputs of its rows, no more and no fewer.
#[test]
fn every_output_of_every_command_has_its_row() {
    let folder = tempfile::tempdir().unwrap();
    let load = file(&folder, "load.csv", "time[s],force[kN]\n0,0\n0.1,12\n0.3,12\n0.4,0\n");
    let curve = file(&folder, "curve.csv", &curve_of_samples(&mut Random(1), 0.0));
    let peaks = file(&folder, "peaks.csv", "peak[mm]\n40\n33.1\n26.5\n20.2\n14.1\n");
    let motion = file(&folder, "motion.csv", &load_and_motion());
    let turns = folder.path().join("turns.csv").display().to_string();
    let system = file(&folder, "system.toml", crate::systems::MACHINE);
    let shaken = file(&folder, "shaken.toml", &crate::systems::shaken());
    let machine =
        "--mass 800kg --period 2.2s --friction-coefficient 0.05 --damping-ratio 2% --static-ratio 1.2";
    let quake = "--frequency 2Hz --base-acceleration 0.15g --format json";
    let ratios = "--omega 0.6 --alpha 3 --static-ratio 1.5";
    let body = "--mass 50 --stiffness 1000 --friction 5";
    let examples: &[(&str, &[String])] = &[
        ("response", &[format!("response {machine} {quake}")]),
        (
            "border",
            &[
                format!("border {machine} --frequency 2Hz --format json"),
                "border --omega 0.331 --no-stop --format json".to_owned(),
            ],
        ),
        ("steady", &[format!("steady {machine} {quake}")]),
        ("attractors", &[format!("attractors {ratios} --format json")]),
        ("basins", &[format!("basins {ratios} --x0=-2:2:3 --v0=-2:2:3")]),
        ("simulate", &[format!("simulate {body} --force 12 --frequency 3 --cycles 1 --format csv")]),
        (
            "simulate --samples",
            &[format!("simulate {body} --force 12 --frequency 3 --cycles 1 --samples 3 --format csv")],
        ),
        ("decay", &["decay --x0 5.5 --format json".to_owned(), format!("decay --x0 5.5 --out {turns} --format json")]),
        ("record", &[format!("record {load} --mass 50t --stiffness 1kN/mm --friction 5kN --format json")]),
        ("spectrum", &[format!("spectrum --quiet {load} --period 1s,2s --mass 50t --friction 5kN")]),
        (
            "identify",
            &[
                format!("identify {curve} --mass 5kg --stiffness 2kN/m --force 100N --format json"),
                format!("identify {curve} --mass 5kg --force 100N --format json"),
                format!("identify {curve} --mass 5kg --stiffness 2kN/m --format json"),
            ],
        ),
        (
            "identify --motion",
            &[format!("identify --motion {motion} --mass 2kg --format json")],
        ),
        ("identify --decay", &[format!("identify --decay {peaks} --stiffness 12kN/m --format json")]),
        (
            "design force",
            &[
                format!("design force {body} --frequency 6 --static-ratio 1.2 --damping-ratio 0.1 --mean-force 3 --format json"),
                "design force --omega 0.4 --static-ratio 1.2 --damping-ratio 0.1 --format json".to_owned(),
            ],
        ),
        (
            "design friction",
            &[
                "design friction --mass 50 --stiffness 1000 --frequency 6 --force 12 --static-ratio 1.2 --damping-ratio 0.1 --format json".to_owned(),
                "design friction --omega 0.4 --static-ratio 1.2 --damping-ratio 0.1 --format json".to_owned(),
            ],
        ),
        (
            "design friction --over",
            &["design friction --mass 800kg --period 2.2s --base-displacement 50mm --over 0.2Hz:2Hz --of absolute-displacement --format json".to_owned()],
        ),
        (
            "design friction --target-amplitude",
            &["design friction --mass 50kg --stiffness 1000N/m --frequency 6rad/s --force 12N --target-amplitude 10mm --format json".to_owned()],
        ),
        ("system", &[format!("system {system} --format json")]),
        ("system steady", &[format!("system {system} steady --format json"), format!("system {shaken} steady --format json")]),
        (
            "system simulate",
            &[
                format!("system {system} simulate --until 2s --format json"),
                format!("system {shaken} simulate --until 2s --format json"),
                format!("system {shaken} simulate --until 2s --samples 4 --format json"),
            ],
        ),
        (
            "system border",
            &[
                format!("system {system} border --format json"),
                format!("system {system} border --set bearing.static_ratio=1.5 --format json"),
            ],
        ),
        (
            "pull",
            &["pull --mass 2kg --stiffness 450N/m --friction 3N --static-friction 4N --speed 20mm/s --format json".to_owned()],
        ),
        (
            "design hold",
            &[
                format!("design hold {body} --unbalance 1 --format json"),
                format!("design hold {body} --force 60 --format json"),
                "design hold --mass 2 --force 3 --format json".to_owned(),
            ],
        ),
        (
            "design bands",
            &[
                "design bands --alpha 12 --damping-ratio 0.1 --from 0.1 --to 2 --format json".to_owned(),
                "design bands --alpha 80 --from 0.3 --to 0.4 --no-stop --format json".to_owned(),
                format!("design bands {body} --force 60 --from 1 --to 9 --format json"),
            ],
        ),
        (
            "design displacement, velocity",
            &[
                "design displacement --omega 1.5 --target 2 --format json".to_owned(),
                format!("design velocity {body} --frequency 6 --target 0.2 --format json"),
            ],
        ),
        (
            "design dissipation",
            &[
                "design dissipation --mass 50 --stiffness 1000 --frequency 6 --force 12 --format json".to_owned(),
                "design dissipation --omega 0.8 --format json".to_owned(),
            ],
        ),
        (
            "design dissipation --sticking",
            &[
                "design dissipation --mass 50 --stiffness 1000 --frequency 6 --force 12 --sticking --format json".to_owned(),
                "design dissipation --omega 0.3 --sticking --format json".to_owned(),
            ],
        ),
        (
            "design stiffness",
            &["design stiffness --mass 50 --friction 5 --frequency 6 --force 12 --from 500 --to 1500 --format json".to_owned()],
        ),
    ];
    let page = rows();
    for (of, runs) in examples {
        let mut found = BTreeSet::new();
        for run in *runs {
            found.extend(keys(&stdout(run)).into_iter().filter(|name| {
                // `design force --omega` repeats Ω, which is then no output either.
                !INPUTS.contains(&name.as_str()) || page[of].contains(name.as_str())
            }));
        }
        if *of == "decay" {
            found.extend(keys(&std::fs::read_to_string(&turns).unwrap()));
        }
        // The kind of the number in brackets of a header is of the same output.
        let page: BTreeSet<String> = page[of].iter().map(|name| (*name).to_owned()).collect();
        let lacks: Vec<_> = found.difference(&page).collect();
        assert!(lacks.is_empty(), "{of}: outputs without a row in docs/development/evidence.md: {lacks:?}");
        let beyond: Vec<_> = page.difference(&found).collect();
        assert!(
            beyond.is_empty(),
            "{of}: docs/development/evidence.md has outputs that no example has: {beyond:?}"
        );
    }
    let limits = json(&format!("attractors {ratios} --format json"));
    let found: BTreeSet<_> = keys(&limits["attractors"].to_string());
    assert_eq!(found, page["attractors[]"].iter().map(|name| (*name).to_owned()).collect());
    let frictions = json(
        "design friction --mass 50kg --stiffness 1000N/m --frequency 6rad/s --force 12N --target-amplitude 10mm --format json",
    );
    let mut found: BTreeSet<_> = keys(&frictions["solutions"].to_string());
    found.remove("units");
    let names = &page["design friction --target-amplitude[]"];
    assert_eq!(found, names.iter().map(|name| (*name).to_owned()).collect());
    let block = format!("record {load} --mass 50t --stiffness 1kN/mm --friction 5kN");
    let floors = json(&format!("{block} --floor-spectrum 0.1s --both-polarities --format json"));
    let mut found: BTreeSet<_> = keys(&floors["floor_spectrum"]["rows"].to_string());
    found.insert("floor_spectrum".to_owned());
    assert!(floors["polarity"].is_string() && floors["polarities"].is_object());
    let names = |of: &str| page[of].iter().map(|name| (*name).to_owned()).collect::<BTreeSet<_>>();
    assert_eq!(found, names("record --floor-spectrum"));
    let history = folder.path().join("history.csv").display().to_string();
    stdout(&format!("{block} --out {history}"));
    assert_eq!(keys(&std::fs::read_to_string(&history).unwrap()), names("record --out"));
    // Every command has its rows, or gives pictures, texts and the outputs of others.
    let help = stdout("help");
    let commands = help.lines().skip_while(|line| !line.starts_with("Commands:")).skip(1);
    let commands =
        commands.take_while(|line| !line.is_empty()).filter_map(|line| line.split_whitespace().next());
    let others = [
        "verify",
        "figure",
        "figures",
        "sweep",
        "motion-plot",
        "outputs",
        "options",
        "completions",
        "man",
        "help",
    ];
    for command in commands {
        let is_there = page.keys().any(|of| of.split([' ', ',']).next() == Some(command));
        assert!(
            is_there || others.contains(&command),
            "{command} has no row in docs/development/evidence.md"
        );
    }
}
