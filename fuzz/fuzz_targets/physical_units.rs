//! Mass, stiffness, friction bound, amplitude and frequency: the answers in physical units.
#![no_main]

use stickslip::generators::Machine;

libfuzzer_sys::fuzz_target!(|m: Machine| stickslip_fuzz::physical_units(m));
