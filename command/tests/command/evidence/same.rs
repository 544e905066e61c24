//! The command prints the very numbers of the library: what is compared there, in tests/evidence, is what the command says.

use super::file;
use crate::command_line::json;
use crate::random::Random;
use serde_json::{Value, json};
use stickslip::internal::{ResponseAnswer, Value as Column};
use stickslip::motion::record::{Body, Entry, Record};
use stickslip::motion::{LongRun, State, SteadyAnswer};
use stickslip::{Excitation, Ratios, Response};

/// A value of the library as JSON.
fn value(of: Column<f64>) -> Value {
    match of {
        Column::Number(number) => json!(number),
        Column::Count(count) => json!(count),
        Column::Flag(flag) => json!(flag),
        Column::Text(text) => json!(text),
        Column::Pairs(pairs) => json!(pairs),
    }
}

/// Two numbers with the same bits, or the same words.
fn same(name: &str, printed: &Value, ours: &Value) {
    let is_same = match (printed.as_f64(), ours.as_f64()) {
        (Some(a), Some(b)) => a.to_bits() == b.to_bits(),
        _ => printed == ours,
    };
    assert!(is_same, "{name}: {printed} of the command, {ours} of the library");
}

#[test]
fn every_column_of_a_point_is_that_of_the_library() {
    let mut random = Random(78);
    let mut columns = 0;
    for i in 0..12 {
        let (omega, alpha) = (random.scale(0.2, 2.5), random.scale(1.1, 9.0));
        let zeta = if i % 2 == 0 { 0.0 } else { random.scale(1e-2, 0.5) };
        let eta = if i % 3 == 0 { random.between(1.01, 1.6) } else { 1.0 };
        let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
        let ratios = ratios.with_static_friction_ratio(eta).unwrap();
        let given = format!(
            "--omega {omega} --alpha {alpha} --damping-ratio {zeta} --static-ratio {eta} --format json"
        );
        let printed = json(&format!("response {given}"));
        let response = Response::new(ratios);
        let answer = ResponseAnswer { response: &response, peaks: true };
        for column in ResponseAnswer::<f64>::COLUMNS {
            let name = column.definition.name;
            same(name, &printed[name], &value((column.of)(&answer)));
            columns += 1;
        }
        let printed = json(&format!("steady {given}"));
        let limit = LongRun::from_start(ratios, State::default()).unwrap();
        let answer = SteadyAnswer::new(ratios, &limit, true).unwrap();
        for column in SteadyAnswer::<f64>::COLUMNS {
            let name = column.definition.name;
            same(name, &printed[name], &value((column.of)(&answer)));
            columns += 1;
        }
    }
    assert!(columns > 700, "{columns}");
}

#[test]
fn every_answer_under_a_record_is_that_of_the_library() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(79);
    for i in 0..4 {
        // At uneven times, which no reader turns into a step.
        let times: Vec<f64> = (0..20).map(|i| f64::from(i) * 0.08 + random.between(0.0, 0.02)).collect();
        let samples: Vec<f64> = times.iter().map(|_| 30.0 * random.between(-1.0, 1.0)).collect();
        let rows = times.iter().zip(&samples).map(|(t, x)| format!("{t},{x}\n"));
        let text = format!("time[s],force[N]\n{}", rows.collect::<String>());
        let file = file(&folder, &format!("{i}.csv"), &text);
        let printed = json(&format!(
            "record {file} --mass 5kg --stiffness 200N/m --damping 6N*s/m --friction 4N --format json"
        ));
        let body = Body::new(5.0, 4.0).and_then(|body| body.with_stiffness(200.0)).unwrap();
        let body = body.with_damping(6.0).unwrap();
        let record = Record::at_times(Excitation::Force, times, samples).unwrap();
        let answer = body.follow(&record).unwrap();
        for (name, _, entry) in answer.entries() {
            let ours = match entry {
                Entry::Value(value) => json!(value),
                Entry::Count(count) => json!(count),
            };
            same(name, &printed[name], &ours);
        }
    }
}
