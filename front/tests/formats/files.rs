//! A file in each layout (`tests/data/layouts.py`), some of which ObsPy wrote or read, and damaged copies of them.

use super::read_text;
use serde_json::Value;
use std::path::PathBuf;
use stickslip_front::inputs::units::{Reader, System};
use stickslip_front::record::{Options, Reading, Words, describe};

/// What must be read of a file.
struct Case {
    name: String,
    bytes: Vec<u8>,
    due: Value,
}

fn cases() -> Vec<Case> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../tests/data");
    let file = std::fs::read_to_string(folder.join("layouts.json")).unwrap();
    let all: serde_json::Map<String, Value> = serde_json::from_str(&file).unwrap();
    let case = |(name, due): (String, Value)| {
        let bytes = std::fs::read(folder.join("layouts").join(&name)).unwrap();
        Case { name, bytes, due }
    };
    all.into_iter().map(case).collect()
}

impl Case {
    /// Sets the options that the file needs.
    fn set<'a>(&'a self, options: &mut Options<'a>) {
        let option = |name: &str| self.due["options"][name].as_str();
        (options.column, options.units) = (option("column"), option("units"));
    }

    fn read(&self, bytes: &[u8]) -> Result<Reading<f64>, String> {
        read_text(bytes, |options| self.set(options))
    }

    fn samples(&self) -> Vec<f64> {
        let number = |value: &Value| value.as_f64().unwrap();
        self.due["samples"].as_array().unwrap().iter().map(number).collect()
    }
}

/// The value of a unit in m/s².
fn factor(unit: &str) -> f64 {
    match unit {
        "g" => super::layouts::G,
        "cm/s²" => 0.01,
        "m/s²" => 1.0,
        other => panic!("{other}"),
    }
}

#[test]
fn each_layout_gives_the_samples_that_were_written() {
    let cases = cases();
    assert!(cases.len() >= 17);
    for case in cases {
        let (name, due) = (&case.name, &case.due);
        let found = case.read(&case.bytes).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (record, summary) = (&found.record, &found.summary);
        let samples = case.samples();
        assert_eq!(record.samples().len(), samples.len(), "{name}");
        let unit = factor(due["unit"].as_str().unwrap());
        // Four roundings: of two conversions, of the scale, and of the product here.
        let off = due["tolerance"].as_f64().unwrap_or(4.0 * f64::EPSILON);
        for (own, sample) in record.samples().iter().zip(&samples) {
            let sample = sample * due["scale"].as_f64().unwrap() * unit;
            assert!((own - sample).abs() <= off * sample.abs(), "{name}: {own} {sample}");
        }
        match due["step"].as_f64() {
            Some(step) => assert!((record.step().unwrap() / step - 1.0).abs() < 1e-14, "{name}"),
            None => {
                let times = due["times"].as_array().unwrap().iter().map(|time| time.as_str().unwrap());
                for (index, time) in times.enumerate() {
                    assert_eq!(record.time(index), time.parse::<f64>().unwrap(), "{name}");
                }
            }
        }
        assert_eq!(record.time(0), due["start"].as_f64().unwrap_or(0.0), "{name}");
        assert_eq!(summary.kind, due["kind"].as_str().unwrap(), "{name}");
        assert_eq!(summary.unit, due["unit"].as_str().unwrap(), "{name}");
        assert_eq!(summary.channel.as_deref(), due["channel"].as_str(), "{name}");
        // Only what the formats lack is told: their headers agree with the samples.
        let is_told = summary.notes.iter().all(|note| note.contains("offset") || note.contains("DEEPSOIL"));
        assert!(is_told, "{name}: {:?}", summary.notes);
    }
}

/// A copy of a file with one change: a byte, or a line left out, repeated or cut, or the file cut.
fn damaged(bytes: &[u8], mut random: impl FnMut(usize) -> usize) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let lines: Vec<Vec<u8>> = bytes.split_inclusive(|byte| *byte == b'\n').map(<[u8]>::to_vec).collect();
    let (line, place) = (random(lines.len()), random(bytes.len()));
    let mut changed = lines.clone();
    match random(8) {
        0 => {
            changed.remove(line);
        }
        1 => changed.insert(line, lines[line].clone()),
        2 => changed[line].truncate(random(lines[line].len())),
        3 => changed.truncate(line),
        4 => changed.swap(line, random(lines.len())),
        5 => {
            bytes[place] = b"0123456789.-+ eE*/:,;\t\n\"x"[random(25)];
            return bytes;
        }
        6 => {
            bytes.remove(place);
            return bytes;
        }
        _ => {
            bytes[place] ^= 1 << random(8);
            return bytes;
        }
    }
    changed.concat()
}

/// Of 500 damaged copies of each file, one that is still read has the number of samples that it had, and what is refused is
/// refused in one line that names the file or an option.
#[test]
fn damaged_files_are_named_or_harmless() {
    let mut state = 0x2545_f491_4f6c_dd1du64;
    let mut random = move |below: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        usize::try_from(state >> 11).unwrap() % below.max(1)
    };
    for case in cases() {
        let mut read = 0;
        for _ in 0..500 {
            let bytes = damaged(&case.bytes, &mut random);
            match case.read(&bytes) {
                Ok(found) => {
                    read += 1;
                    let text = String::from_utf8_lossy(&bytes);
                    let samples = found.record.samples();
                    assert_eq!(samples.len(), case.samples().len(), "{}:\n{text}", case.name);
                    assert!(samples.iter().all(|sample| sample.is_finite()));
                }
                Err(error) => {
                    assert!(!error.contains('\n'), "{error}");
                    assert!(error.contains("file") || error.contains("--"), "{}: {error}", case.name);
                }
            }
        }
        // Comments and digits may change.
        assert!(read > 20, "{}: {read}", case.name);
    }
}

/// A peak of a header that the samples do not have is told, with its line and in its unit; a step or a number of samples that
/// contradicts itself is refused.
#[test]
fn headers_are_held_against_the_samples() {
    for (name, from, to, said) in [
        ("smc.smc", "2.4650000E+01", "9.9990000E+01", "Line 23 of file states the peak 9.9990000E+01, but"),
        (
            "csmip.V2",
            "Peak acceleration =   2",
            "Peak acceleration =   3",
            "Line 18 of file states the peak 3",
        ),
        ("csmip.V1", "Max  =   0.0", "Max  =   0.1", "states the peak 0.1"),
        (
            "unam.txt",
            "/24.65/",
            "/-30.5/",
            "states the peak -30.5, but the samples have 24.6498 in that unit",
        ),
        ("knet.EW", "Max. Acc. (gal)   1", "Max. Acc. (gal)   2", "from the mean in that unit"),
    ] {
        let case = cases().into_iter().find(|case| case.name == name).unwrap();
        let text = String::from_utf8(case.bytes.clone()).unwrap();
        assert!(text.contains(from), "{name}:\n{text}");
        let found = case.read(text.replace(from, to).as_bytes()).unwrap();
        assert!(
            found.summary.notes.iter().any(|note| note.contains(said)),
            "{name}: {:?}",
            found.summary.notes
        );
    }
    for (name, from, to, said) in [
        (
            "csmip.V2",
            "intervals of    0.020",
            "intervals of    0.010",
            "the step 0.020 s is not 0.01 s, as line 17 states",
        ),
        (
            "csmip.V2",
            " 45 points of inst",
            " 44 points of inst",
            "45 samples, but line 16 states another number",
        ),
        (
            "afad.txt",
            "DATA          : 45",
            "DATA          : 46",
            "46 samples of the channel, but the file has 45",
        ),
        ("tspair.txt", "00:00:00.040000", "00:00:00.050000", "is not sample 2 at 50 a second"),
        (
            "deepsoil.txt",
            "0.10 ",
            "0.12 ",
            "file line 7: time 0.12: must be a multiple of the step 0.02 of line 1",
        ),
    ] {
        let case = cases().into_iter().find(|case| case.name == name).unwrap();
        let text = String::from_utf8(case.bytes.clone()).unwrap();
        assert!(text.contains(from), "{name}:\n{text}");
        let error = case.read(text.replacen(from, to, 1).as_bytes()).unwrap_err();
        assert!(error.contains(said), "{name}: {error}");
    }
}

/// Each channel of a file is described without a machine, with the frequency of its greatest Fourier amplitude and its gaps.
#[test]
fn files_are_described() {
    let reader = Reader::new(Some(&System::default()), "--units N,m");
    let described =
        |bytes: &[u8]| describe(|| Ok(bytes), &Options::new("file", &reader, Words::COMMAND)).unwrap();
    for (name, channels) in [
        ("csmip.V1", vec!["360 Deg", "90 Deg"]),
        ("unam.txt", vec!["V", "N00E", "N90E"]),
        ("afad.txt", vec!["N-S", "E-W", "U-D"]),
        ("smc.smc", vec!["360"]),
    ] {
        let case = cases().into_iter().find(|case| case.name == name).unwrap();
        let found = described(&case.bytes);
        let names: Vec<_> = found.iter().map(|channel| channel.summary.channel.as_deref().unwrap()).collect();
        assert_eq!(names, channels);
        for channel in &found {
            assert_eq!((channel.record.samples().len(), channel.gaps.len()), (45, 0), "{name}");
            // The samples are sin(0.7 i) below a bell: the peak is that of the sine, to half of the grid of 256 points.
            let due = 0.7 / std::f64::consts::TAU / 0.02;
            assert!((channel.peak_frequency.unwrap() - due).abs() <= 0.5 * 50.0 / 256.0, "{name}");
        }
    }
    let rows = |i: i32| format!("{:.2},{:.4}\n", f64::from(i) / 100.0, (f64::from(i) * 0.3).sin());
    let text: String = (0..200).filter(|i| !(60..70).contains(i) && *i != 120).map(rows).collect();
    let [channel] = described(format!("time[s],acc[g]\n{text}").as_bytes()).try_into().unwrap();
    assert_eq!(channel.gaps, [[0.59, 0.7], [1.19, 1.21]]);
    let sentences = channel.sentences(|x| format!("{x:.2}"));
    assert!(
        sentences.ends_with("It has 2 gaps, such as from 0.59 s to 0.70 s, 1.19 s to 1.21 s."),
        "{sentences}"
    );
}
