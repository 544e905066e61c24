//! Arbitrary bytes as the file of a record or of a system: a record of finite samples in order, a system with natural
//! frequencies, or one line that says what is wrong.
#![no_main]

libfuzzer_sys::fuzz_target!(|file: &[u8]| stickslip_fuzz::reader(file));
