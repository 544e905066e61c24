//! A structure with contacts, elastic contacts and stops under loads: its motion.
#![no_main]

#[path = "../../tests/invariants/systems.rs"]
mod systems;

use stickslip::generators::Structure;

libfuzzer_sys::fuzz_target!(|structure: Structure| {
    systems::motion(&structure, 40);
    systems::slips(&structure);
});
