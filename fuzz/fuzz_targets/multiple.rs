//! Three numbers of every kind: `Mp<LIMBS>` compared with `rug::Float`.
#![no_main]

libfuzzer_sys::fuzz_target!(|input: (u8, [u8; 96])| stickslip_fuzz::multiple(input));
