//! A structure with contacts, elastic contacts and stops under loads: its motion.
#![no_main]

use stickslip::generators::Structure;

libfuzzer_sys::fuzz_target!(|structure: Structure| stickslip_fuzz::systems(structure));
