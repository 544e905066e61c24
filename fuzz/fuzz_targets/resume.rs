//! A sweep that is resumed from any file: either it is completed as if it had not been interrupted, or the
//! file is left as it is.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| stickslip_cli::fuzzed::resume(input));
