//! Exports of instruments in laboratories: names in several languages, rows of units, lines above the table, signals in
//! volts, and times of clocks.

use super::read_text;
use stickslip_front::record::Options;

/// A text, its options, the samples in SI units and the times.
type Export<'a> = (&'a str, &'a [(&'a str, &'a str)], [f64; 3], [f64; 3]);

fn set<'a>(options: &mut Options<'a>, given: &[(&str, &'a str)]) {
    for (name, value) in given {
        let place = match *name {
            "column" => &mut options.column,
            "time_column" => &mut options.time_column,
            "time_step" => &mut options.time_step,
            "units" => &mut options.units,
            "scale" => &mut options.scale,
            "remove_mean" => &mut options.remove_mean,
            "resample" => &mut options.resample,
            "from" => &mut options.from,
            "to" => &mut options.to,
            other => panic!("{other}"),
        };
        *place = Some(value);
    }
}

const TIMES: [f64; 3] = [0.0, 0.01, 0.02];
const ACC: [f64; 3] = [0.12, 3.2, -2.2];

#[test]
fn exports_of_instruments_go_in() {
    let exports: &[Export<'_>] = &[
        // German, Spanish, French, Italian, Portuguese, Dutch, Polish, Turkish.
        ("Zeit [s];Beschleunigung [m/s²]\r\n0,00;0,12\r\n0,01;3,20\r\n0,02;-2,20\r\n", &[], ACC, TIMES),
        ("Tiempo (s)\tAceleración (m/s²)\n0,00\t0,12\n0,01\t3,20\n0,02\t-2,20\n", &[], ACC, TIMES),
        ("Temps (ms);Accélération (gal)\n0;12\n10;320\n20;-220\n", &[], ACC, TIMES),
        ("Tempo;Accelerazione\n[s];[m/s^2]\n0;0,12\n0,01;3,2\n0,02;-2,2\n", &[], ACC, TIMES),
        ("Tempo (s),Força (N)\n0,0.12\n0.01,3.2\n0.02,-2.2\n", &[], ACC, TIMES),
        ("Tijd;Kracht\ns;kN\n0;0,00012\n0,01;0,0032\n0,02;-0,0022\n", &[], ACC, TIMES),
        ("Czas [s]\tPrzyspieszenie [m*s^-2]\n0\t0.12\n0.01\t3.2\n0.02\t-2.2\n", &[], ACC, TIMES),
        ("Zaman (s);ivme (m/s2)\n0;0,12\n0,01;3,2\n0,02;-2,2\n", &[], ACC, TIMES),
        // Logger Pro, with two loads; the quotient as DIN writes it; a_x beside other axes.
        (
            "\"Latest: Time (s)\",\"Latest: Force (N)\",\"Latest: Acceleration (m/s²)\"\n0,1,0.12\n0.01,2,3.2\n0.02,3,-2.2\n",
            &[("column", "Acceleration")],
            ACC,
            TIMES,
        ),
        ("t/s a/(m/s²)\n0 0.12\n0.01 3.2\n0.02 -2.2\n", &[], ACC, TIMES),
        ("time,a_x,a_y\ns,m/s2,m/s2\n0,9,0.12\n0.01,9,3.2\n0.02,9,-2.2\n", &[("column", "a_y")], ACC, TIMES),
        // A row of units below names that say nothing.
        ("Time,X\n[s],[m*s^-2]\n0,0.12\n0.01,3.2\n0.02,-2.2\n", &[], ACC, TIMES),
        ("Kanal 1;Kanal 2\ns;m/s²\n0;0,12\n0,01;3,2\n0,02;-2,2\n", &[], ACC, TIMES),
        (
            "A,B\n0,0.12\n0.01,3.2\n0.02,-2.2\n",
            &[("time_column", "A"), ("column", "B"), ("units", "m/s^2")],
            ACC,
            TIMES,
        ),
        (
            "0.12 1 0\n3.2 1 0.01\n-2.2 1 0.02\n",
            &[("time_column", "3"), ("column", "1"), ("units", "m/s^2")],
            ACC,
            TIMES,
        ),
        // Lines above the table, with a step in one of them.
        (
            "Device: X-16\nSerial: 12345\nStart: 2020-01-01 12:00:00\nRange 2 g\n\nTime (s),Acc (m/s^2)\n0,0.12\n0.01,3.2\n0.02,-2.2\n",
            &[],
            ACC,
            TIMES,
        ),
        ("Sample rate: 100 Hz\nAcc (m/s^2)\n0.12\n3.2\n-2.2\n", &[], ACC, TIMES),
        ("# dt = 10 ms\n0.12\n3.2\n-2.2\n", &[("units", "m/s^2")], ACC, TIMES),
        ("Sampling rate (Hz),100\nChannels,1\nAcc (m/s^2)\n0.12\n3.2\n-2.2\n", &[], ACC, TIMES),
        // LabVIEW with a decimal comma, a comment in its first row, and without times.
        (
            "LabVIEW Measurement\t\nDecimal_Separator\t,\nX_Columns\tOne\n***End_of_Header***\t\n\t\nChannels\t1\t\t\nSamples\t3\t\t\nY_Unit_Label\tm/s^2\t\nX_Dimension\tTime\t\nX0\t0,0\t\nDelta_X\t0,01\t\n***End_of_Header***\t\t\nX_Value\tAcc_0\tComment\n0,00\t0,12\tbegin\n0,01\t3,2\n0,02\t-2,2\n",
            &[],
            ACC,
            TIMES,
        ),
        (
            "LabVIEW Measurement\t\nX_Columns\tNo\n***End_of_Header***\t\n\t\nChannels\t1\t\t\nSamples\t3\t\t\nY_Unit_Label\tN\t\nX_Dimension\tTime\t\nX0\t0.0\t\nDelta_X\t0.01\t\n***End_of_Header***\t\t\nForce_0\tComment\n0.12\n3.2\n-2.2\n",
            &[],
            ACC,
            TIMES,
        ),
        // Volts and millivolts, by name, by option and without a unit.
        (
            "time (s),Voltage (V)\n0,0.05\n0.01,0.5\n0.02,-0.25\n",
            &[("column", "Voltage"), ("scale", "2.5 N/V")],
            [0.125, 1.25, -0.625],
            TIMES,
        ),
        (
            "time (s),U (mV)\n0,50\n0.01,500\n0.02,-250\n",
            &[("column", "2"), ("scale", "2.5N/V")],
            [0.125, 1.25, -0.625],
            TIMES,
        ),
        (
            "time (s),acc (mV)\n0,50\n0.01,500\n0.02,-250\n",
            &[("scale", "10 m/s^2/V")],
            [0.5, 5.0, -2.5],
            TIMES,
        ),
        (
            "0 50\n0.01 500\n0.02 -250\n",
            &[("units", "mV"), ("scale", "2.5 N/V")],
            [0.125, 1.25, -0.625],
            TIMES,
        ),
        ("0 0.05\n0.01 0.5\n0.02 -0.25\n", &[("scale", "2.5 N/V")], [0.125, 1.25, -0.625], TIMES),
        // Clocks, over midnight.
        (
            "timestamp,acc (m/s^2)\n2020-02-28T23:59:59.990Z,0.12\n2020-02-29T00:00:00.000Z,3.2\n2020-02-29T00:00:00.010Z,-2.2\n",
            &[],
            ACC,
            TIMES,
        ),
        ("Time;a [m/s²]\n12:00:00,50;0,12\n12:00:00,51;3,2\n12:00:00,52;-2,2\n", &[], ACC, TIMES),
    ];
    for (text, given, samples, times) in exports {
        let found = read_text(text.as_bytes(), |options| set(options, given))
            .unwrap_or_else(|error| panic!("{error}\n{text}"));
        let record = &found.record;
        assert_eq!(record.samples().len(), 3, "{text}");
        for (place, (sample, time)) in samples.iter().zip(times).enumerate() {
            let own = record.samples()[place];
            assert!((own - sample).abs() <= 4.0 * f64::EPSILON * sample.abs(), "{own} {sample}\n{text}");
            assert!((record.time(place) - time).abs() < 1e-15, "{}\n{text}", record.time(place));
        }
    }
}

#[test]
fn what_is_told_of_the_times() {
    let told = |text: &str| read_text(text.as_bytes(), |_| {}).unwrap().summary.sentence(|x| x.to_string());
    let jitter = told("time (s),acc (m/s^2)\n0,1\n0.0098,2\n0.0201,3\n0.03,1\n");
    assert!(jitter.contains("at unequal steps of 0.0098 s to 0.0103 s, 0.03 s"), "{jitter}");
    let short = read_text(b"time (s),acc (m/s^2)\n0,1\n0.5,2\n1.00000000001,3\n", |_| {}).unwrap().summary;
    let sentence = short.sentence(|x| format!("{x:.3}"));
    assert!(sentence.contains("at unequal steps of 0.5 s to 0.50000000001 s"), "{sentence}");
    // A cut has the step that a file with its rows alone has.
    let cut = read_text(b"time (s),acc (m/s^2)\n0,0\n0.1,1\n0.6,2\n1.1,3\n1.6,1\n", |options| {
        options.from = Some("0.1s");
    });
    let sentence = cut.unwrap().summary.sentence(|x| x.to_string());
    assert!(sentence.contains("4 samples of acceleration 0.5 s apart, 1.5 s"), "{sentence}");
    let repeated = told("time (s),acc (m/s^2)\n0,1\n0.01,2\n0.01,2\n0.01,2\n0.02,3\n");
    assert!(repeated.contains("3 samples") && repeated.contains("2 rows that repeat"), "{repeated}");
    let step = told("dt: 0.01\nacc (m/s^2)\n1\n2\n");
    assert!(step.ends_with("The step is that of line 1."), "{step}");
}

/// The mean that is taken off, the cut and the step, beside the same done by hand.
#[test]
fn the_mean_is_taken_off_and_the_step_is_changed() {
    let samples: Vec<f64> =
        (0..101).map(|i| if i < 40 { 5.0 } else { 5.0 + f64::from(i % 7) - 3.0 }).collect();
    let rows: String =
        samples.iter().enumerate().map(|(i, a)| format!("{:.2},{a}\n", i as f64 / 50.0)).collect();
    let text = format!("time (s),acc (m/s^2)\n{rows}");
    let read =
        |given: &[(&str, &'static str)]| read_text(text.as_bytes(), |options| set(options, given)).unwrap();
    let mean = |samples: &[f64]| {
        samples.windows(2).map(|pair| (pair[0] + pair[1]) / 2.0).sum::<f64>() / (samples.len() - 1) as f64
    };
    for (given, mean, part) in [
        ("all", mean(&samples), "all samples"),
        ("before", 5.0, "the 40 samples from 0 s to 0.78 s"),
        ("1s:2s", mean(&samples[50..]), "the 51 samples from 1 s to 2 s"),
    ] {
        let found = read(&[("remove_mean", given)]);
        for (own, sample) in found.record.samples().iter().zip(&samples) {
            assert!((own - (sample - mean)).abs() < 1e-14, "{given}: {own} {}", sample - mean);
        }
        assert!(found.summary.notes[0].contains(part), "{:?}", found.summary.notes);
    }
    let found = read(&[("remove_mean", "before"), ("from", "0.8s"), ("to", "1.6s"), ("resample", "5ms")]);
    let record = &found.record;
    assert_eq!((record.samples().len(), record.time(0), record.step()), (161, 0.8, Some(0.005)));
    for place in 0..161 {
        let (whole, part) = (40 + place / 4, (place % 4) as f64 / 4.0);
        let due = samples[whole] * (1.0 - part) + samples[(whole + 1).min(100)] * part - 5.0;
        assert!((record.samples()[place] - due).abs() < 1e-12, "{place}");
    }
    assert!(found.summary.notes[1].contains("from 0.02 s to 0.005 s"), "{:?}", found.summary.notes);
    let coarse = read(&[("resample", "0.04s")]);
    assert!(coarse.summary.notes[0].ends_with("so that samples between were left out."));
    for (given, said) in [
        (
            ("remove_mean", "middle"),
            "--remove-mean middle: must be all, before (the motion) or a window FROM:TO",
        ),
        (("remove_mean", "0s:0.001s"), "--remove-mean 0s:0.001s: must hold two samples or more"),
        (("resample", "0s"), "--resample 0s: must be > 0 s"),
        (("resample", "5s"), "--resample 5s: must be > 0 s"),
    ] {
        let error = read_text(text.as_bytes(), |options| set(options, &[given])).unwrap_err();
        assert!(error.starts_with(said), "{error}");
    }
}
