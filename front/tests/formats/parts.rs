//! Parts of records, steps of their load, and what is said of them.

use crate::read_text;
use stickslip::inputs::units::Reader;
use stickslip_front::record::{Cut, Options, Reading, Words, read};

/// The samples 0, 1, 2 … at these times.
fn table(times: &[String]) -> String {
    let rows = times.iter().enumerate().map(|(i, time)| format!("{time},{i}\n"));
    format!("time[s],acc[m/s^2]\n{}", rows.collect::<String>())
}

/// A number of steps of 10⁻⁴ s as a decimal.
fn decimal(steps: usize) -> String {
    format!("{}.{:04}", steps / 10_000, steps % 10_000)
}

fn cut(text: &str, [from, to]: [&str; 2]) -> Result<Reading<f64>, String> {
    let reader = Reader::new(None, "--units N,m");
    let mut options = Options::new("file", &reader, Words::COMMAND);
    let time = |text: &str| text.parse().ok();
    options.cut = Some(Cut { from: time(from), to: time(to), typed: "--from, --to" });
    read(text.as_bytes(), &options)
}

/// A cut keeps the samples at its ends, by the decimals of the file: the steps are whole numbers of 10⁻⁴ s here.
#[test]
fn a_cut_keeps_the_samples_at_its_ends() {
    for step in [1, 3, 7, 50, 123, 777, 2000] {
        for begin in [0, 13, 54_321] {
            let places: Vec<usize> = (0..40).map(|i| begin + i * step).collect();
            let times: Vec<String> = places.iter().map(|place| decimal(*place)).collect();
            let uneven: Vec<String> =
                places.iter().enumerate().map(|(i, place)| decimal(place * 2 + i % 2)).collect();
            for times in [times, uneven] {
                for (first, last) in [(0, 39), (1, 3), (3, 9), (5, 23), (17, 38)] {
                    let ends = [&*times[first], &*times[last]];
                    let due: Vec<f64> = (first..=last).map(|i| i as f64).collect();
                    let found = cut(&table(&times), ends).unwrap();
                    assert_eq!(found.record.samples(), due, "{ends:?}");
                    let summary = &found.summary;
                    assert_eq!((summary.samples, summary.peak), (due.len(), last as f64));
                    assert!((summary.peak_at - times[last].parse::<f64>().unwrap()).abs() < 1e-12);
                }
            }
        }
    }
    let error = cut(&table(&["0".to_owned(), "1".to_owned()]), ["0.6", "0.5"]).unwrap_err();
    assert!(error.starts_with("--from, --to: "), "{error}");
}

/// Times are those of the file: only rounding makes equal steps of them.
#[test]
fn times_are_those_of_the_file() {
    let thirds = read_text(b"time[s],acc[m/s^2]\n0,0\n0.3333333,3\n0.6666667,-3\n1,0\n", |_| ()).unwrap();
    assert_eq!((thirds.record.step(), thirds.record.time(1)), (None, 0.333_333_3));
    let tenths = read_text(b"time[ms],acc[m/s^2]\n0,0\n0.1,3\n0.2,-3\n0.3,0\n", |_| ()).unwrap();
    assert!((tenths.record.step().unwrap() - 1e-4).abs() < 1e-19);
}

/// A mean is one over time: 0.3 g for 60 ms and −0.9 g for 20 ms have none, and 3 kN for a tenth of the time is 300 N.
#[test]
fn a_mean_is_one_over_time() {
    let jerks: String = (0..50)
        .map(|i| {
            let t = f64::from(i) * 0.08;
            let [a, b] = [t + 0.06, t + 0.08];
            format!("{t:.3},0.3\n{a:.3},0.3\n{a:.3},-0.9\n{b:.3},-0.9\n")
        })
        .collect();
    let text = format!("time[s],acceleration[g]\n{jerks}");
    assert_eq!(read_text(text.as_bytes(), |_| ()).unwrap().summary.mean, 0.0);
    let force = read_text(b"time[s],force[N]\n0,3000\n0.2,3000\n0.2,0\n2,0\n", |_| ()).unwrap();
    assert!((force.summary.mean - 300.0).abs() < 1e-10, "{}", force.summary.mean);
}
