//! Any bytes as a file of points. Each row has the answer that the command gives to its values as arguments,
//! up to the first invalid row, for which a single line states the error.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| stickslip_cli::fuzzed::points(input));
