//! Arbitrary bytes as the file of a record: a record of finite samples in order, or one line that says what is wrong.
#![no_main]

use arbitrary::Arbitrary;
use stickslip::inputs::units::Reader;
use stickslip_front::record::{Options, Words, read};

#[derive(Debug, Arbitrary)]
struct File<'a> {
    has_step: bool,
    skip: u8,
    column: Option<u8>,
    units: Option<u8>,
    text: &'a [u8],
}

libfuzzer_sys::fuzz_target!(|file: File<'_>| {
    let reader = Reader::new(None, "--units N,m");
    let pick = |from: &[&'static str], index: Option<u8>| {
        index.and_then(|index| from.get(usize::from(index) % from.len().max(1)).copied())
    };
    let options = Options {
        time_step: file.has_step.then_some(0.01),
        column: pick(&["1", "2", "all", "N", "acc", "chan 1"], file.column),
        skip: u64::from(file.skip % 4),
        units: pick(&["g", "gal", "N", "mm", "furlong"], file.units),
        ..Options::new("file", &reader, Words::COMMAND)
    };
    match read::<f64>(file.text, &options) {
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
});
