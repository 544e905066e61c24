//! The motion through resonance, to 200 digits.
//!
//! At Ω = 1 eq. 44 is infinity minus infinity, and a sweep at f64 by the printed formula gives noise there.
//! In terms of the phase function K it is smooth: the displacement grows as √(α² − (4/π)²)/|1 − Ω²|, and the
//! border passes through 4/π with the slope 2/π. Here Ω − 1 runs from −10⁻¹ to −10⁻¹⁵⁰ and back on the other
//! side, at 768 bits, for a force 1.5 times the friction.
//!
//! The displacement times |1 − Ω²| differs from its limit, 0.7930…, by 1.29 times the distance from
//! resonance, both below and above it. So close to resonance the motion never settles in practice: a
//! disturbance halves in 0.69/(1 − |λ|) half cycles.

use std::io::Write;
use stickslip::float::Mp;
use stickslip::{Border, Cycle, Field, Float as _, Ratios};

/// A number with 231 digits.
type Number = Mp<12>;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    answer(&mut std::io::stdout().lock())
}

pub(crate) fn answer(out: &mut impl Write) -> Result<(), Box<dyn std::error::Error>> {
    let (one, alpha) = (Number::int(1), Number::ratio(3, 2));
    let at_resonance = Number::int(4) / Number::pi();
    writeln!(out, "border at Ω = 1  {:.200}", Border::new(one)?.min_force_ratio)?;
    writeln!(out, "less 4/π         {:e}", (Border::new(one)?.min_force_ratio - at_resonance).to_f64())?;
    let limit = (alpha.square() - at_resonance.square()).sqrt();
    writeln!(out, "Ω − 1      Δ₀/B           Δ₀/B |1 − Ω²| off its limit   1 − |λ|")?;
    for exponent in ["-1", "-3", "-10", "-50", "-150"] {
        for sign in ["-", "+"] {
            let offset: Number = format!("{sign}1e{exponent}").parse()?;
            let omega = one + offset;
            let cycle = Cycle::new(Ratios::new(omega, alpha)?)?;
            let reach = cycle.max_displacement;
            let scaled = reach * ((one - omega) * (one + omega)).abs();
            let (off, settling) = ((scaled / limit - one).abs(), one - cycle.contraction());
            writeln!(
                out,
                "{sign}1e{exponent:<6}  {:<13}  {:<27}  {}",
                short(reach),
                short(off),
                short(settling)
            )?;
        }
    }
    Ok(())
}

/// Five digits, with an exponent that may exceed the range of f64.
fn short(x: Number) -> String {
    format!("{x:.4e}")
}
