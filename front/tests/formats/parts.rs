//! Parts of records, steps of their load, and what is said of them.

use crate::read_text;
use stickslip_front::inputs::units::{Reader, System};
use stickslip_front::record::{Options, Reading, Words, read};

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
    let reader = Reader::new(Some(&System::default()), "--units N,m");
    let mut options = Options::new("file", &reader, Words::COMMAND);
    (options.from, options.to) = (Some(from), Some(to));
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
    assert!(error.starts_with("--from 0.6 --to 0.5: "), "{error}");
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

/// A COSMOS file with these numbers 34 and 62 of the real header, of 40 samples in 0.8 s.
fn cosmos(recorder: &str, own: &str) -> String {
    let mut header = vec!["-999.0"; 100];
    (header[33], header[61]) = (recorder, own);
    format!(
        "Corrected acceleration (Format v01.20 with 13 text lines)\nSta Chan 1: x\n\
         100 Real-header values follow on 1 lines, Format= (100F8.3)\n{}\n\
         40 acceleration pts, approx 0.8 secs, units=cm/sec2,Format=(8F10.5)\n{}\nEnd-of-data\n",
        header.join(" "),
        "1.5 ".repeat(40)
    )
}

/// The step of a COSMOS file is number 62 of the real header, in ms, whatever that of the recorder was.
#[test]
fn the_step_of_cosmos_is_that_of_its_samples() {
    for (recorder, own, due) in
        [("0.005", "20.0", 0.02), ("0.02", "20.0", 0.02), ("5.0", "20.0", 0.02), ("20.0", "-999.0", 0.02)]
    {
        let found = read_text(cosmos(recorder, own).as_bytes(), |_| ()).unwrap();
        assert_eq!(found.record.step(), Some(due), "{recorder} {own}");
    }
    let error = read_text(cosmos("0.02", "2000").as_bytes(), |_| ()).unwrap_err();
    assert!(error.contains("number 62") && error.contains("2000"), "{error}");
}

/// A GeoNet file of 2018: “peak” in small letters, and the axis behind the name of the component.
#[test]
fn a_component_of_geonet_has_a_short_name() {
    let component = |name: &str, value: &str| {
        let mut text = "Corrected accelerogram EXAMPLE\n".to_owned();
        text += &"words\n".repeat(11);
        text += &format!(
            "Component {name}\nAcceleration:  peak    -274.1 mm/s/s at  0.36 sec     rms 2.2 mm/s/s\n"
        );
        text += "Velocity:\nDisplacement:\n";
        text += &"       0       0\n".repeat(3);
        text += "       0       0       0       3       0       0\n";
        text += &"       0       0       0       0       0       0\n".repeat(2);
        text += "     106       5       5    0.78   0.005    0.02\n";
        text += &"       0       0\n".repeat(3);
        text + &format!("{value:>8}{value:>8}{value:>8}\n")
    };
    let text = component("S16W  Longitudinal Accelerometer Axis", "1.0")
        + &component("N74W  Transverse Accelerometer Axis", "2.0");
    for (column, due) in [("S16W", 0.001), ("n74w", 0.002), ("2", 0.002)] {
        let found = read_text(text.as_bytes(), |options| options.column = Some(column)).unwrap();
        assert_eq!((found.record.samples()[0], found.record.step()), (due, Some(0.02)), "{column}");
    }
}

/// A CWB file has as many samples as its length and its rate say, or one more at the end of the length.
#[test]
fn the_samples_of_cwb_are_counted() {
    let text = |count: usize| {
        let rows = (0..count).map(|i| format!("{:10.3} 1.0 2.0 3.0\n", i as f64 * 0.005));
        format!(
            "#RecordLength(sec): 1.00\n#SampleRate(Hz): 200\n#AmplitudeUnit:  gal. DCoffset(corr)\n\
             #DataSequence: Time U(+); N(+); E(+)\n#Data: 4F10.3\n{}",
            rows.collect::<String>()
        )
    };
    for (count, is_right) in [(198, false), (199, false), (200, true), (201, true), (202, false)] {
        let found = read_text(text(count).as_bytes(), |options| options.column = Some("n"));
        assert_eq!(found.is_ok(), is_right, "{count}");
    }
}
