//! Answers about many coordinates: those that are chosen, and how many a text leaves out.

use crate::command_line::{json, refused, stdout};
use crate::place::{Place, place};
use serde_json::{Value, json as value};

/// A tower of thirty storeys on a base that moves, with contacts at the first and the tenth.
fn tower() -> String {
    let masses: String = (1..=30).map(|i| format!("s{i} = \"{} t\"\n", 100 - i)).collect();
    let below = |i: usize| if i == 1 { "ground".to_owned() } else { format!("s{}", i - 1) };
    let springs: String = (1..=30)
        .map(|i| format!("[[springs]]\nbetween = [\"{}\", \"s{i}\"]\nstiffness = \"150 kN/mm\"\n", below(i)))
        .collect();
    let contacts: String = [1, 10]
        .map(|i| {
            let ends = format!("between = [\"{}\", \"s{i}\"]\n", below(i));
            format!("[[contacts]]\nname = \"damper {i}\"\n{ends}friction = \"400 kN\"\n")
        })
        .concat();
    format!(
        "units = \"kN,mm\"\ndamping = {{ ratio = \"2 %\" }}\n[masses]\n{masses}{springs}{contacts}\
         [base]\nacceleration = {{ amplitude = \"0.1 g\", frequency = \"1 Hz\" }}\n"
    )
}

/// A file of it.
fn tower_file() -> Place {
    let file = place("tower.toml");
    std::fs::write(&file, tower()).unwrap();
    file
}

/// The lists of an answer that have an entry for each coordinate.
const LISTS: [&str; 12] = [
    "/coordinates",
    "/start/displacement",
    "/start/velocity",
    "/end/displacement",
    "/end/velocity",
    "/max_displacement",
    "/min_displacement",
    "/max_velocity",
    "/min_velocity",
    "/max_absolute_acceleration",
    "/drift",
    "/mean_velocity",
];

/// An answer of chosen coordinates is that of all with their entries alone, in the order of the choice.
#[test]
fn chosen_coordinates_have_their_part_of_the_whole_answer() {
    let file = tower_file();
    let file = file.display();
    for question in ["simulate --until 2s", "steady --set s30.mass=60t", ""] {
        let all = json(&format!("system {file} {question} --format json"));
        let chosen = json(&format!("system {file} {question} --format json --coordinates s17,s2"));
        let mut due = all.clone();
        for list in LISTS {
            if let Some(list) = due.pointer_mut(list) {
                let entries = list.as_array().unwrap();
                assert_eq!(entries.len(), 30);
                *list = value!([entries[16], entries[1]]);
            }
        }
        assert_eq!(due["coordinates"], value!(["s17", "s2"]));
        assert!(chosen == due, "{question}");
        assert!(json(&format!("system {file} {question} --format json --coordinates all")) == all);
    }
}

/// Rows of samples and of grids have the columns of the chosen coordinates.
#[test]
fn rows_have_the_columns_of_chosen_coordinates() {
    let file = tower_file();
    let file = file.display();
    let rows = stdout(&format!("system {file} simulate --until 2s --samples 2 --coordinates s17,s2"));
    let all = stdout(&format!("system {file} simulate --until 2s --samples 2"));
    let names = "time[s],s17.displacement[mm],s2.displacement[mm],s17.velocity[mm/s],s2.velocity[mm/s],damper 1.force[kN],\
                 damper 10.force[kN],s17.absolute_acceleration[mm/s²],s2.absolute_acceleration[mm/s²]";
    assert_eq!(rows.lines().next(), Some(names));
    let cell = |table: &str, name: &str| -> String {
        let mut lines = table.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let place = lines.next().unwrap().iter().position(|own| *own == name).unwrap();
        lines.next_back().unwrap()[place].to_owned()
    };
    assert!(names.split(',').all(|name| cell(&rows, name) == cell(&all, name)));
    let grid = format!("system {file} simulate --until 1s --set s30.mass=60t,70t");
    let (rows, all) = (stdout(&format!("{grid} --coordinates s17,s2")), stdout(&grid));
    let header = rows.lines().next().unwrap();
    assert_eq!(header.split(',').filter(|name| name.contains("displacement")).count(), 6, "{header}");
    assert!(header.split(',').all(|name| cell(&rows, name) == cell(&all, name)), "{header}");
}

/// A text lists 24 coordinates and frequencies, and says how many there are beside them.
#[test]
fn a_text_says_what_it_leaves_out() {
    let file = tower_file();
    let file = file.display();
    let text = stdout(&format!("system {file}"));
    assert!(text.contains("  s24 ") && !text.contains("  s25 "), "{text}");
    assert!(text.contains("\n  and 6 more coordinates: --coordinates NAMES shows those, or all\n"), "{text}");
    let description: Value = json(&format!("system {file} --format json"));
    let last = description["natural_frequencies"][29].as_f64().unwrap() / std::f64::consts::TAU;
    let sliding = text.lines().find(|line| line.starts_with("  all contacts sliding")).unwrap();
    let (_, left) = sliding.rsplit_once(", 6 more up to ").unwrap();
    let left: f64 = left.trim_end_matches(" Hz").parse().unwrap();
    assert!((left - last).abs() < 1e-6 * last, "{sliding}");
    let text = stdout(&format!("system {file} simulate --until 1s"));
    assert!(text.contains("\ns24\n") && !text.contains("\ns25\n"), "{text}");
    assert!(text.contains("\n  and 6 more coordinates: --coordinates NAMES shows those, or all\n"), "{text}");
    let text = stdout(&format!("system {file} simulate --until 1s --coordinates s30"));
    assert!(
        text.contains("\ns30\n") && !text.contains("\ns1\n") && !text.contains("more coordinates"),
        "{text}"
    );
}

/// Natural frequencies up to a bound are those of the whole list.
#[test]
fn frequencies_below_a_bound_are_those_of_all() {
    let file = tower_file();
    let file = file.display();
    let all = json(&format!("system {file} --format json"));
    let below = json(&format!("system {file} --format json --frequencies-below 3Hz"));
    let due = |list: &Value| {
        let list = list.as_array().unwrap().iter();
        list.filter(|omega| omega.as_f64().unwrap() <= 3.0 * std::f64::consts::TAU)
            .cloned()
            .collect::<Value>()
    };
    for list in
        ["/natural_frequencies", "/natural_frequencies_stuck", "/elements/1/natural_frequencies_stuck"]
    {
        let (all, below) = (all.pointer(list).unwrap(), below.pointer(list).unwrap());
        assert_eq!(*below, due(all), "{list}");
        let count = below.as_array().unwrap().len();
        assert!(count > 0 && count < 12, "{below}");
    }
    let text = stdout(&format!("system {file} --frequencies-below 0.5Hz"));
    let count = due(&all["natural_frequencies"]).as_array().unwrap().len();
    assert!(text.contains("29 more up to") && count > 2, "{text}");
    refused(
        &format!("system {file} steady --frequencies-below 3Hz"),
        &["--frequencies-below: this question does not use it"],
    );
    refused(&format!("system {file} --frequencies-below 3kg"), &["--frequencies-below 3kg"]);
    refused(&format!("system {file} --frequencies-below=-1Hz"), &["--frequencies-below -1Hz: must be > 0"]);
}

/// A picture has the chosen coordinates alone, and a wrong choice is named.
#[test]
fn a_picture_has_the_chosen_coordinates() {
    let file = tower_file();
    let picture = place("tower.svg");
    stdout(&format!(
        "system {} simulate --until 1s --coordinates s30,s7 --picture {}",
        file.display(),
        picture.display()
    ));
    let drawn = std::fs::read_to_string(&*picture).unwrap();
    let has = |name: &str| drawn.contains(&format!("\n{name}\n"));
    assert!(has("s30") && has("s7") && !has("s1"), "{drawn}");
    assert!(drawn.contains("Motion: s30, s7"), "{drawn}");
    let file = file.display();
    refused(
        &format!("system {file} steady --coordinates s30,roof"),
        &["--coordinates roof: must be a coordinate: s1, s2,"],
    );
    refused(
        &format!("system {file} steady --coordinates s30,s30"),
        &["--coordinates s30: must be given once"],
    );
    refused(
        &format!("system {file} border --coordinates s30"),
        &["--coordinates: this question does not use it"],
    );
}
