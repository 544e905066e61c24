//! Mass, stiffness, friction bound, amplitude and frequency: the answers in physical units.
#![no_main]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

use stickslip::generators::Machine;

libfuzzer_sys::fuzz_target!(|m: Machine| {
    invariants::physical_units(m.mass, m.stiffness, m.friction_bound, m.amplitude, m.frequency, m.base);
});
