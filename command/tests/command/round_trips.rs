//! The command's output is read back, number by number and bit by bit: CSV by `csv`, JSON by `serde_json`,
//! and both as input.

mod named;

use crate::command_line::{json, refused, stdout, stickslip};
use crate::drawn::cases;
use arbitrary::{Arbitrary, Unstructured};
use named::{
    Cell, Named, cells, foot, of_border, of_csv, of_json, of_machine, of_phase, of_response, of_steady,
    sorted,
};
use proptest::prelude::*;
use std::fmt::{Debug, LowerExp};
use std::str::FromStr;
use stickslip::generators::{Machine, Point, Start};
use stickslip::motion::{LongRun, State, Trajectory};
use stickslip::{Drive, NoStop, Oscillator, Output, Ratios, Regime, Response, Scales};

/// Random values of a type of `stickslip::generators`.
fn hard<T: for<'a> Arbitrary<'a> + Debug>() -> impl Strategy<Value = T> {
    prop::collection::vec(any::<u8>(), 16..96)
        .prop_filter_map("bytes", |bytes| T::arbitrary(&mut Unstructured::new(&bytes)).ok())
}

/// Points that have an answer.
fn points(most: usize) -> impl Strategy<Value = Vec<Point>> {
    let valid = hard::<Point>().prop_filter("ratios", |p| Ratios::new(p.omega, p.alpha).is_ok());
    prop::collection::vec(valid, 1..most)
}

fn ratios(p: &Point) -> Ratios<f64> {
    Ratios::new(p.omega, p.alpha).unwrap()
}

/// The points as CSV, with each number in the format of `write`.
fn table(points: &[Point], write: fn(f64) -> String) -> String {
    let rows = points.iter().map(|p| format!("{},{}\n", write(p.omega), write(p.alpha)));
    format!("omega,alpha\n{}", rows.collect::<String>())
}

fn plain(x: f64) -> String {
    x.to_string()
}

/// The output of a command with `--points -` for a table.
fn answers(command: &str, format: &str, table: &str) -> String {
    let run = stickslip(&format!("{command} --quiet --points - --format {format}"))
        .write_stdin(table.to_owned())
        .assert();
    String::from_utf8(run.success().stderr("").get_output().stdout.clone()).unwrap()
}

/// The objects of JSON lines.
fn of_lines<F: FromStr<Err: Debug> + LowerExp>(text: &str) -> Vec<Named> {
    text.lines().map(|line| of_json::<F>(&serde_json::from_str(line).unwrap())).collect()
}

/// Both formats of the answers to a table must have the expected values.
fn both<F: FromStr<Err: Debug> + LowerExp>(command: &str, table: &str, due: Vec<Named>) {
    assert_eq!(of_csv::<F>(&answers(command, "csv", table)), due, "{command}, CSV");
    let due: Vec<Named> = due.into_iter().map(sorted).collect();
    assert_eq!(of_lines::<F>(&answers(command, "jsonl", table)), due, "{command}, JSON lines");
}

proptest! {
    #![proptest_config(cases(24))]

    #[test]
    fn responses_and_borders(points in points(100)) {
        let response = |p: &Point| Response::new(ratios(p));
        both::<f64>("response", &table(&points, plain), points.iter().map(|p| of_response(&response(p))).collect());
        let due = points.iter().map(|p| of_border(&response(p))).collect();
        both::<f64>("border", &table(&points, |x| format!("{x:e}")), due);
    }

    /// The ratios are reproduced in whatever format they were written, and so are the answers.
    #[test]
    fn an_answer_is_an_input_with_the_same_answer(points in points(100)) {
        let first = answers("response", "csv", &table(&points, plain));
        prop_assert_eq!(&first, &answers("response", "csv", &first));
        for write in [|x| format!("{x:e}"), |x| format!("{x:?}"), |x: f64| serde_json::to_string(&x).unwrap()] {
            prop_assert_eq!(&first, &answers("response", "csv", &table(&points, write)));
        }
    }

    #[test]
    fn steady_states(points in points(60)) {
        let limit = |p: &Point| LongRun::from_start(ratios(p), State::default()).ok();
        let points: Vec<Point> =
            points.into_iter().filter(|p| p.omega > 1e-2 && limit(p).is_some()).collect();
        prop_assume!(!points.is_empty());
        let due = points.iter().map(|p| of_steady(ratios(p), &limit(p).unwrap())).collect();
        both::<f64>("steady", &table(&points, plain), due);
    }
}

proptest! {
    #![proptest_config(cases(100))]

    /// The motion from a typed start is the motion from that start.
    #[test]
    fn motions(start in hard::<Start>(), cycles in 1..4i64) {
        let Start { point: Point { omega, alpha }, x, v, .. } = start;
        prop_assume!(omega > 1e-2);
        let Ok(motion) =
            Ratios::new(omega, alpha).and_then(|ratios| Trajectory::new(ratios, State::new(0.0, x, v)?))
        else {
            return Ok(());
        };
        let due: Vec<Named> =
            motion.map(Result::unwrap).take_while(|p| p.start().phase.cycles() < cycles).map(|p| of_phase(&p)).collect();
        let line = format!("simulate --omega={omega} --alpha={alpha:e} --x0={x} --v0={v:e} \
            --cycles={cycles}");
        prop_assert_eq!(&of_csv::<f64>(&stdout(&format!("{line} --format csv"))), &due);
        let due: Vec<Named> = due.into_iter().map(sorted).collect();
        prop_assert_eq!(of_lines::<f64>(&stdout(&format!("{line} --format jsonl"))), due);
    }

    #[test]
    fn any_machine(m in hard::<Machine>()) {
        let body = Oscillator::new(m.mass.abs(), m.stiffness.abs(), m.friction_bound.abs());
        let excitation = if m.base { stickslip::Excitation::FootMotion } else { stickslip::Excitation::Force };
        if let (Ok(body), Ok(drive)) = (body, Drive::new(excitation, m.amplitude, m.frequency.abs())) {
            machine(&body, &drive);
        }
    }

    /// Units from the smallest to the largest, in which some of the answers overflow.
    #[test]
    fn any_units(point in hard::<Point>(), decades in prop::array::uniform3(-307.0..307.0)) {
        let [friction, length, frequency] = decades.map(|e| 10f64.powf(e));
        let (stiffness, slow) = (friction / length, frequency / point.omega);
        let body = Oscillator::new(stiffness / slow / slow, stiffness, friction);
        if let (Ok(body), Ok(drive)) = (body, Drive::force(point.alpha * friction, frequency)) {
            machine(&body, &drive);
        }
    }
}

/// A machine is reproduced as typed, with the library's answers; answers that overflow in its units are
/// refused.
fn machine(body: &Oscillator<f64>, drive: &Drive<f64>) {
    let (Ok(ratios), Ok(scales)) = (drive.ratios(body), Scales::new(body, drive)) else { return };
    let response = Response::new(ratios);
    let mut due = of_machine(&response, body, drive, &scales);
    due.extend(foot(drive));
    let mut of_ratios = of_response(&response);
    let cycle = response.cycle.as_ref().filter(|_| drive.excitation().moves_foot());
    if let Some((cycle, acceleration)) = cycle.zip(Output::MaxAcceleration.of(&response)) {
        // Foot and surface together carry the inertia m x″.
        let omega = ratios.omega();
        let force = acceleration * (omega * omega);
        let felt = [
            ("transmitted_force", force),
            ("transmissibility", acceleration / ratios.alpha()),
            ("max_absolute_displacement", cycle.max_displacement),
        ];
        for (name, value) in felt {
            of_ratios.iter_mut().filter(|(own, _)| own == name).for_each(|field| field.1 = Cell::of(value));
        }
        due.iter_mut()
            .filter(|(name, _)| *name == "transmitted_force")
            .for_each(|field| field.1 = Some(force * scales.force));
        due.push(("max_absolute_displacement", Some(cycle.max_displacement * scales.length)));
    } else if drive.excitation().moves_foot() {
        due.push(("max_absolute_displacement", None));
    } else {
        // A force moves no base.
        let absolute = of_ratios.iter_mut().filter(|(own, _)| own == "max_absolute_displacement");
        absolute.for_each(|field| field.1 = Cell::Absent);
    }
    let line = format!(
        "response --mass={} --stiffness={:e} --friction={} --{}={} --frequency={:e} --format json",
        body.mass(),
        body.stiffness(),
        body.friction_bound(),
        if drive.excitation().moves_foot() { "base-motion" } else { "force" },
        drive.amplitude(),
        drive.angular_frequency(),
    );
    if let Some((name, _)) = due.iter().find(|(_, value)| value.is_some_and(|x| !x.is_finite())) {
        return refused(&line, &[&format!("{name} = inf must be finite")]);
    }
    let mut answer = json(&line);
    let mut physical = answer.as_object_mut().unwrap().remove("physical").unwrap();
    for words in ["drive", "units"] {
        physical.as_object_mut().unwrap().remove(words).unwrap();
    }
    assert_eq!(of_json::<f64>(&physical), sorted(cells(&due)), "{line}");
    assert_eq!(of_json::<f64>(&answer), sorted(of_ratios), "{line}");
}

/// Here one float of Ω moves the border by 1.5e-4, and 7e-9 below it the body reverses six times.
#[test]
fn beside_a_pole_the_motion_and_the_border_agree() {
    let p = Point { omega: 0.012_345_679_012_334_45, alpha: 41_074_586_362_949.69 };
    let limit = LongRun::from_start(ratios(&p), State::default()).unwrap();
    assert_eq!(limit.steady_state().unwrap().velocity_zeros_per_cycle, 6);
    both::<f64>("steady", &table(&[p], plain), vec![of_steady(ratios(&p), &limit)]);
}

/// Here friction is lost in the rounding of the motion: a unit in the last place of a displacement is 4, and a
/// stop is a difference below 1. The borders decide: the body reverses six times without a stop at the first
/// force, and stops at the second, nobody knows how often.
#[test]
fn where_friction_is_lost_in_rounding_the_border_decides() {
    let omega: f64 = 0.010_309_278_350_515_464;
    let no_stop = NoStop::of(&Ratios::new(omega, 1.0).unwrap());
    let (_, greatest) = no_stop.six_reversals.unwrap();
    for (alpha, regime, stops) in [
        (3.335_884_628_701_366_8e16, Regime::NonSticking, Cell::of(0)),
        ((greatest * no_stop.border).sqrt(), Regime::Sticking, Cell::Absent),
    ] {
        let p = Point { omega, alpha };
        let due = of_steady(ratios(&p), &LongRun::from_start(ratios(&p), State::default()).unwrap());
        for cell in [("regime", Cell::Text(regime.to_string())), ("sticks_per_cycle", stops)] {
            assert!(due.contains(&(cell.0.to_owned(), cell.1)), "{due:?}");
        }
        both::<f64>("steady", &table(&[p], plain), vec![due]);
    }
}

#[test]
fn what_the_units_have_no_number_for_is_refused() {
    let near = "--mass 1e-295 --stiffness 1e-295 --friction 1e4 --frequency 1.0000000001 --force 1e5";
    let stiff = "--mass 1e307 --stiffness 1.7e308 --friction 1.7e308 --frequency 3";
    for (line, name) in [
        (format!("response {near}"), "max_displacement"),
        (format!("steady {near}"), "max_displacement"),
        (format!("simulate {near} --cycles 2 --x0 -1e308 --v0 1.7e308"), "end_displacement"),
        (format!("simulate {near} --cycles 2 --samples 3 --x0 1.7e308 --v0 1.7e308"), "velocity"),
        (format!("border {stiff}"), "min_force"),
        ("decay --mass 1 --stiffness 1 --friction 1e300 --x0 1.7e308 --v0 1.7e308".to_owned(), "first_turn"),
    ] {
        let formats: &[&str] =
            if line.starts_with("simulate") { &["text", "csv", "jsonl"] } else { &["text", "json"] };
        for format in formats {
            let run = stickslip(&format!("{line} --format {format}")).assert().code(2);
            let output = run.get_output();
            let (rows, message) = (output.stdout.clone(), String::from_utf8(output.stderr.clone()).unwrap());
            assert!(message.contains(&format!(" {name} = ")), "{line}: {message}");
            assert!(message.contains("inf must be finite"), "{line}: {message}");
            assert!(
                message.lines().count() == 1 && !String::from_utf8(rows).unwrap().contains("inf"),
                "{line}"
            );
        }
    }
}

/// Numbers of high precision, which are strings in JSON.
#[cfg(feature = "mp")]
mod wide {
    use super::{Named, Point, both, of_response, points};
    use crate::drawn::cases;
    use proptest::prelude::*;
    use stickslip::float::Mp;
    use stickslip::{Ratios, Response};

    proptest! {
        #![proptest_config(cases(16))]

        #[test]
        fn responses(points in points(12)) {
            // Thirds, so that the ratios themselves use all their digits.
            let third = |x: f64| Mp::<4>::from(x) / Mp::from(3);
            let valid: Vec<Ratios<Mp<4>>> = points
                .iter()
                .filter_map(|p: &Point| Ratios::new(third(p.omega), third(p.alpha)).ok())
                .collect();
            prop_assume!(!valid.is_empty());
            let rows: String = valid.iter().map(|r| format!("{},{:e}\n", r.omega(), r.alpha())).collect();
            let due: Vec<Named> = valid.iter().map(|&r| of_response(&Response::guarded(r))).collect();
            both::<Mp<4>>("response --bits 256", &format!("omega,alpha\n{rows}"), due);
        }
    }
}
