//! A body and a record: the motion under it.
#![no_main]

use stickslip::generators::Shaken;

libfuzzer_sys::fuzz_target!(|shaken: Shaken| stickslip_fuzz::records(shaken));
