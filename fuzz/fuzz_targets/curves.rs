//! A structure whose frictions and springs are curves: its answer, with its digits.
#![no_main]

use stickslip::generators::Curved;

libfuzzer_sys::fuzz_target!(|curved: Curved| stickslip_fuzz::curves(curved));
