//! Arbitrary bytes as the file of a record or of a system: a record of finite samples in order, a system with natural
//! frequencies, or one line that says what is wrong.
use std::path::Path;
use stickslip_front::inputs::units::Reader;
use stickslip_front::record::{Options, Words, read};
use stickslip_front::system::{Description, NamedSystem, parsed};

/// Arbitrary bytes as the file of a record or of a system: a record of finite samples in order, a system with natural
/// frequencies, or one line that says what is wrong.
pub fn reader(file: &[u8]) {
    // The first four bytes choose the options.
    let Some(([step, skip, column, units], text)) = file.split_first_chunk::<4>() else { return };
    if *step >= 192 {
        return system(text);
    }
    let reader = Reader::new(None, "--units N,m");
    let pick = |from: &[&'static str], index: u8| from.get(usize::from(index) % (from.len() + 1)).copied();
    let options = Options {
        time_step: (step % 2 == 1).then_some("0.01"),
        time_column: (step % 4 == 2).then_some("2"),
        column: pick(&["1", "2", "all", "N", "acc", "chan 1"], *column),
        skip: u64::from(skip % 4),
        units: pick(&["g", "gal", "N", "mm", "furlong"], *units),
        ..Options::new("file", &reader, Words::COMMAND)
    };
    match read::<f64>(text, &options) {
        Ok(found) => {
            let record = &found.record;
            let (count, last) = (record.samples().len(), record.end());
            assert!(count >= 2 && found.summary.samples == count && last.is_finite());
            assert!(record.samples().iter().all(|sample| sample.is_finite()));
            assert!((1..count).all(|index| record.time(index) >= record.time(index - 1)));
            assert!(found.summary.peak.is_finite() && found.summary.duration >= 0.0);
        }
        Err(error) => assert!(error.contains("file") || error.contains("--"), "{error}"),
    }
}

fn system(text: &[u8]) {
    let text = String::from_utf8_lossy(text);
    let found = parsed(&text, "file").and_then(|value| NamedSystem::new(&value, [], Path::new("none"), None));
    match found {
        Ok(system) => {
            let description = Description::new(&system);
            assert_eq!(description.natural_frequencies.len(), description.coordinates.len());
        }
        Err(error) => assert!(!error.contains('\n'), "{error}"),
    }
}
