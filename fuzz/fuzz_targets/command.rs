//! A command line and a file of points or of a record: the command's answer, except for computations that take long.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| stickslip_cli::fuzzed::command(input));
