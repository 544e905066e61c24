//! Records in the layouts of agencies and of columns: what is read of them, and what is said of bad ones.

mod bad;
#[path = "../../../tests/drawn/mod.rs"]
mod drawn;
mod files;
mod laboratories;
mod layouts;
mod parts;

use drawn::cases;
use layouts::{Drawn, Written};
use proptest::prelude::*;
use std::io::{BufReader, Read};
use stickslip::motion::record::{Body, Entry};
use stickslip_front::inputs::units::Reader;
use stickslip_front::record::{Options, Reading, Words, read};

/// The record of a text, in SI units.
pub(crate) fn read_text<'a>(text: &[u8], set: impl FnOnce(&mut Options<'a>)) -> Result<Reading<f64>, String> {
    // The options of a test may live as long as its text.
    let reader: &'static Reader = Box::leak(Box::new(Reader::new(None, "--units N,m")));
    let mut options: Options<'a> = Options::new("file", reader, Words::COMMAND);
    set(&mut options);
    read(text, &options)
}

fn check(written: &Written) -> Result<(), TestCaseError> {
    let found = read_text(written.text.as_bytes(), |options| {
        options.column = written.column;
        options.units = written.unit;
        options.time_step = written.time_step.as_deref();
    });
    let found = match found {
        Ok(found) => found,
        Err(error) => return Err(TestCaseError::fail(format!("{error}\n{}", written.text))),
    };
    prop_assert_eq!(found.record.samples().len(), written.samples.len());
    for (own, due) in found.record.samples().iter().zip(&written.samples) {
        // The conversion rounds twice, the product of the scale once more.
        let due = due * written.factor;
        prop_assert!((own - due).abs() <= 4.0 * f64::EPSILON * due.abs(), "{} {}", own, due);
    }
    let step = found.record.step().unwrap();
    prop_assert!((step / written.step - 1.0).abs() < 1e-12, "{} {}", step, written.step);
    let summary = &found.summary;
    prop_assert_eq!(summary.kind, written.kind);
    let peak = written.samples.iter().fold(0.0f64, |peak, sample| peak.max(sample.abs()));
    prop_assert!((summary.peak.abs() - peak).abs() <= 4.0 * f64::EPSILON * peak);
    let place = written.samples.iter().position(|sample| sample.abs() == peak).unwrap();
    prop_assert!((summary.peak_at - place as f64 * step).abs() < 1e-9);
    let pairs = written.samples.iter().zip(written.samples.iter().skip(1));
    let mean = pairs.map(|(a, b)| (a + b) / 2.0).sum::<f64>() / (written.samples.len() - 1) as f64;
    prop_assert!((summary.mean - mean).abs() <= 1e-12 * peak);
    Ok(())
}

macro_rules! layouts {
    ($($name:ident),*) => {
        proptest! {
            #![proptest_config(cases(300))]
            $(#[test]
            fn $name(drawn in layouts::drawn()) {
                check(&layouts::$name(&drawn))?;
            })*
        }
    };
}

layouts!(peer, knet, esm, cwb, cosmos, geonet, columns, samples);

/// One sample fewer or more than a header states is refused, with the number stated.
#[test]
fn a_count_that_differs_is_refused() {
    let drawn = Drawn {
        digits: (0..20).map(|i| i * 1234 - 5678).collect(),
        dos: false,
        blank_lines: false,
        trailing_text: false,
        glued: false,
        per_line: 1,
        step: 10,
        form: 4,
    };
    for (write, more) in [
        (layouts::peer as fn(&Drawn) -> Written, ".1E-01"),
        (layouts::knet, "7"),
        (layouts::esm, "1.0"),
        (layouts::cosmos, "1.0"),
        (layouts::geonet, "1.0"),
    ] {
        let written = write(&drawn);
        let read = |text: &str| read_text(text.as_bytes(), |options| options.column = written.column);
        read(&written.text).unwrap();
        let mut lines: Vec<&str> = written.text.lines().collect();
        if let Some(last) = lines.iter().rposition(|line| line.trim().parse::<f64>().is_ok()) {
            lines.remove(last);
            let error = read(&lines.join("\n")).unwrap_err();
            assert!(error.contains("20"), "{error}");
            lines.insert(last, more);
            lines.insert(last, more);
        } else {
            lines.push(more);
        }
        let error = read(&lines.join("\n")).unwrap_err();
        assert!(error.contains("line"), "{error}");
    }
}

#[test]
fn what_is_read_is_said_in_one_sentence() {
    let found = read_text(b"time[s],acc[gal]\n1,0\n1.5,-200\n2,100\n", |_| {}).unwrap();
    assert_eq!(
        found.summary.sentence(|x| x.to_string()),
        "Record (columns “acc”): 3 samples of acceleration 0.5 s apart, 1 s; peak -200 cm/s² at 1.5 s, mean \
         -75 cm/s²."
    );
    assert_eq!(found.record.samples(), [0.0, -2.0, 1.0]);
    assert_eq!(found.record.time(0), 1.0);
}

/// Rows that end with a comma, quoted names, and a decimal comma.
#[test]
fn rows_of_spreadsheets() {
    for text in [
        "time[s],acc[gal],\n0,0,\n1.5,-200,\n2,100,\n",
        "\"Time, s\",\"Acc, gal\"\n0,0\n1.5,-200\n2,100\n",
        "t;a\n[s];[gal]\n0;0\n1,5;-2,0e2\n2;100\n",
        "time  acc\n(s)  (gal)\n0 0\n1.5 -200\n2 100\n",
        "x,Time s,acc_gal\nq,0,0\nr,1.5,-200\ns,2,100\n",
    ] {
        let record =
            read_text(text.as_bytes(), |_| {}).unwrap_or_else(|error| panic!("{error}\n{text}")).record;
        assert_eq!((record.samples(), record.time(1)), (&[0.0, -2.0, 1.0][..], 1.5), "{text}");
    }
}

/// Two values at one time are a step of the load: its answers are the limit of those of a steep ramp. Three are refused,
/// and so is a step of a support on which a damper stands.
#[test]
fn two_values_at_one_time_are_a_step() {
    let record = |gap: f64, unit: &str| {
        let text = format!("time[s],{unit}\n0,0\n0.5,2\n{},-3\n2,-3\n{},1\n3,4\n", 0.5 + gap, 2.0 + gap);
        read_text(text.as_bytes(), |_| {}).map(|found| found.record)
    };
    for friction in [0.1, 0.7, 1.5, 2.5] {
        for (stiffness, damping) in [(0.0, 0.0), (4.0, 0.3), (90.0, 0.0), (400.0, 60.0)] {
            let body = Body::new(1.0, friction).unwrap();
            let body = body.with_stiffness(stiffness).unwrap().with_damping(damping).unwrap();
            let [step, ramp] = [0.0, 1e-9].map(|gap| body.follow(&record(gap, "force[N]").unwrap()).unwrap());
            for ((name, _, one), (.., other)) in step.entries().into_iter().zip(ramp.entries()) {
                match (one, other) {
                    (Entry::Value(one), Entry::Value(other)) => {
                        let (one, other) = (one.copied().unwrap_or(0.0), other.copied().unwrap_or(0.0));
                        // The ramp moves the body by its gap times the greatest velocity and its slope.
                        let is_near = (one - other).abs() < 1e-6 * (1.0 + other.abs());
                        assert!(is_near, "{name} {friction} {stiffness}: {one} {other}");
                    }
                    (Entry::Count(one), Entry::Count(other)) => {
                        assert_eq!(one, other, "{name} {friction} {stiffness}")
                    }
                    _ => panic!("{name}"),
                }
            }
        }
    }
    record(0.0, "foot-displacement[m]").unwrap();
    record(0.0, "damped-foot-displacement[m]").unwrap();
    let error = read_text(b"time[s],force[N]\n0,1\n1,1\n1,2\n1,3\n2,0\n", |_| {}).unwrap_err();
    assert_eq!(error, "file line 5: time step = 0 s: must be > 0 s after two values at one time");
}

/// Of several channels one is chosen by its name or its place; the others are named.
#[test]
fn of_several_channels_one_is_chosen() {
    let one = |channel: u32, quantity: &str, value: f64| {
        let real = "-999.0 ".repeat(33) + "10.0 " + &"-999.0 ".repeat(66);
        format!(
            "Corrected {quantity} (Format v01.20 with 13 text lines)\nSta Chan {channel}: x\n100 Real-header values follow on 1 lines, Format= (100F7.1)\n{real}\n0 Comment line(s) follow, each starting with a \"|\":\n2 {quantity} pts, approx 0 secs, units=cm/sec2,Format=(8F10.5)\n{value} 2\nEnd-of-data for chan {channel} {quantity}\n"
        )
    };
    let text = one(4, "acceleration", 1.0) + &one(4, "velocity", 9.0) + &one(7, "acceleration", 3.0);
    let error = read_text(text.as_bytes(), |_| {}).unwrap_err();
    assert_eq!(error, "file: has the channels chan 4, chan 7. Choose one by --column, such as 1");
    for (column, first) in [("4", 0.01), ("chan 7", 0.03), ("2", 0.03)] {
        let found = read_text(text.as_bytes(), |options| options.column = Some(column)).unwrap();
        assert_eq!(found.record.samples()[0], first, "{column}");
    }
    let error = read_text(text.as_bytes(), |options| options.column = Some("9")).unwrap_err();
    assert_eq!(error, "--column 9: must be a channel of file: chan 4, chan 7");
    let found = read_text(one(1, "velocity", 1.0).as_bytes(), |_| {});
    assert_eq!(found.unwrap_err(), "file line 6: velocity: must be an acceleration");
}

/// A text of this line without an end.
struct Endless(usize);

impl Read for Endless {
    fn read(&mut self, into: &mut [u8]) -> std::io::Result<usize> {
        let line = b"0.1\n";
        for byte in into.iter_mut() {
            *byte = line[self.0 % line.len()];
            self.0 += 1;
        }
        Ok(into.len())
    }
}

/// Ten million samples are read, and those of a source without an end are refused once memory would be too large.
#[test]
#[ignore = "takes long without optimisation: cargo test -p stickslip-front --release -- --ignored"]
fn ten_million_samples() {
    let reader = Reader::new(None, "");
    let options = Options {
        units: Some("g"),
        time_step: Some("0.01 s"),
        ..Options::new("endless", &reader, Words::COMMAND)
    };
    let many = BufReader::new(Endless(0).take(4 * 10_000_000));
    assert_eq!(read::<f64>(many, &options).unwrap().record.samples().len(), 10_000_000);
    let error = read::<f64>(BufReader::new(Endless(0)), &options).unwrap_err();
    assert_eq!(error, "endless line 33554433: the load: must have at most 33554432 samples");
}
