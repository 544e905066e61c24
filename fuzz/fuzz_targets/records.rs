//! A body and a record: the motion under it.
#![no_main]

#[path = "../../tests/invariants/records.rs"]
mod records;

use stickslip::generators::Shaken;

libfuzzer_sys::fuzz_target!(|shaken: Shaken| records::followed(&shaken));
