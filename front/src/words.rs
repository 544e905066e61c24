//! The answers in words, for the command and the page in the browser.

use stickslip::internal::{Observed, observed, springless_exponent};
use stickslip::motion::{Attractor, LongRun, SteadyState};
use stickslip::{Excitation, Float, Ratios, Regime, Response};

/// Seven significant digits at f64, without trailing zeros; all digits of a wider number.
#[must_use]
pub fn digits<F: Float>(x: F) -> String {
    if F::PRECISION > f64::MANTISSA_DIGITS {
        return x.to_string();
    }
    let x = x.to_f64();
    let rounded: f64 = format!("{x:.6e}").parse().unwrap_or(x);
    if rounded == 0.0 || (1e-4..1e7).contains(&rounded.abs()) {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

/// The verdict on a response in one sentence.
#[must_use]
pub fn verdict<F: Float>(response: &Response<F>) -> String {
    let (omega, alpha) = (response.ratios.omega(), response.ratios.alpha());
    let margin = digits(alpha / response.border.min_force_ratio);
    if response.ratios.has_higher_static_friction() {
        return with_static_friction(response);
    }
    match response.regime {
        Regime::Stuck => {
            "Stuck: α ≤ 1, so the force never exceeds friction and the body comes to rest for good.".into()
        }
        Regime::Sticking => format!(
            "Sticking: the body stops in each cycle. The force is {margin} of the minimum for continuous \
             sliding."
        ),
        Regime::NonSticking if response.cycle.as_ref().is_none() => format!(
            "Non-sticking: the body never stops and reverses six times a cycle. The force is {margin} of \
             the minimum for two reversals."
        ),
        Regime::NonSticking => {
            format!(
                "Non-sticking: the body never stops. The force is {margin} times the minimum for continuous \
                 sliding."
            )
        }
        // With one friction nothing depends on the start.
        Regime::Unbounded | Regime::DependsOnStart => format!(
            "Unbounded: at Ω = {omega} and α > 4/π = 1.27324 friction cannot hold the resonance, and the \
             displacement grows in every cycle."
        ),
    }
}

/// The verdict where static friction is higher, in one sentence or two.
fn with_static_friction<F: Float>(response: &Response<F>) -> String {
    let ratios = response.ratios;
    let margin = digits(ratios.alpha() / response.border.min_force_ratio);
    let from_rest = if ratios.moves_from_rest() {
        "a body at rest is released".to_owned()
    } else {
        format!(
            "a body at rest within ±{} B stays at rest",
            digits(ratios.static_friction_ratio() - ratios.alpha())
        )
    };
    match response.regime {
        Regime::Stuck => {
            "Stuck: α ≤ 1, so the force never exceeds friction and the body comes to rest for good.".to_owned()
        }
        Regime::Sticking => format!(
            "Sticking: the body stops again and again, from every start. The force is {margin} of the minimum for \
             continuous sliding."
        ),
        Regime::NonSticking => format!(
            "Non-sticking: in the long run the body never stops, from every start. The force is {margin} times the \
             minimum for continuous sliding."
        ),
        Regime::Unbounded => {
            "Unbounded: at Ω = 1 friction cannot hold the resonance, and the displacement grows in every cycle, from \
             every start."
                .to_owned()
        }
        Regime::DependsOnStart => {
            let without_stop = match response.reversals_per_cycle() {
                Some(2) => "a cycle without a stop exists and attracts its neighbourhood",
                Some(_) => "a cycle of six reversals without a stop exists and attracts its neighbourhood",
                None if response.has_motion_without_stop() => "a motion without a stop exists and grows without bound",
                None => "every other motion ends at rest or stops again and again",
            };
            format!("Depends on the start: {from_rest}, and {without_stop}.")
        }
    }
}

/// The verdict on the limit of a start in one sentence or two; `length` writes a displacement in B, and `advice` is a
/// sentence for a motion that has not settled, after a space, or empty.
#[must_use]
pub fn limit<F: Float>(
    ratios: Ratios<F>,
    limit: &LongRun<F>,
    length: impl Fn(F) -> String,
    advice: &str,
) -> String {
    let seen = observed(ratios, limit);
    match limit {
        LongRun::Periodic(steady) | LongRun::Family(steady) => of_steady(steady, &seen),
        LongRun::Rest(rest) => {
            let place = length(rest.position);
            match rest.slides {
                Some(0) if rest.position == F::int(0) => "Stuck: the body never moves.".to_owned(),
                Some(0) => format!("Stuck: the body never moves from {place}."),
                Some(1) => format!("Stuck: the body comes to rest at {place} after one slide."),
                Some(slides) => format!("Stuck: the body comes to rest at {place} after {slides} slides."),
                None => format!("Stuck: the body creeps towards rest at {place} for ever."),
            }
        }
        LongRun::Irregular(found) => {
            let turns = found.turns;
            format!(
                "Irregular: the motion from this start did not repeat itself in {turns} turns of the drive."
            )
        }
        LongRun::Unbounded { growth } => {
            format!("Unbounded: in the long run the amplitude grows by {} a cycle.", length(*growth))
        }
        LongRun::NotConverged { residual, periods, .. } => {
            let (periods, left) = (digits(periods.to_f64()), length(*residual));
            let limit = if seen.regime == Regime::DependsOnStart {
                "The borders do not decide its limit.".to_owned()
            } else {
                format!("By the borders its limit is {}.", seen.regime.name())
            };
            format!(
                "Undecided: after {periods} periods the motion still changes by {left} in half a cycle.{advice} {limit}"
            )
        }
    }
}

/// The verdict on a periodic motion.
fn of_steady<F: Float>(steady: &SteadyState<F>, seen: &Observed) -> String {
    match seen.sticks.unwrap_or_default() {
        0 if seen.sticks.is_none() => {
            "Sticking: its stops cannot be counted, because friction is lost in the rounding of the motion."
                .to_owned()
        }
        0 if seen.regime == Regime::Sticking => {
            "Sticking: α is so close below the border that the stops are too short for this arithmetic."
                .to_owned()
        }
        0 => match seen.reversals {
            Some(n) if n > 2 => format!("Non-sticking: the body never stops and reverses {n} times a cycle."),
            Some(_) | None => "Non-sticking: the body never stops.".to_owned(),
        },
        n => {
            let part = digits((steady.stick_fraction.to_f64() * 1e4).round() / 1e2);
            let stops = if n == 1 { "stop" } else { "stops" };
            format!("Sticking: {n} {stops} in a cycle, {part} % of the time.")
        }
    }
}

/// The starts that lead to a periodic motion, and the properties of its cycle; empty for other limits.
#[must_use]
pub fn origin<F: Float>(ratios: Ratios<F>, limit: &LongRun<F>) -> String {
    let steady = match limit {
        LongRun::Periodic(steady) => steady,
        LongRun::Family(_) => {
            return "At Ω = 1/(2n) the periodic motions form a family. The start leads to this one."
                .to_owned();
        }
        LongRun::Rest(_)
        | LongRun::Irregular(_)
        | LongRun::Unbounded { .. }
        | LongRun::NotConverged { .. } => {
            return String::new();
        }
    };
    // A friction of 0 is computed as one far below the rounding of the motion.
    if !ratios.is_damped() && ratios.alpha() > F::exp2i(80) {
        return "One periodic motion. Without friction and a damper, the free vibration of a start stays beside it.".to_owned();
    }
    // Without a spring the velocity alone decides.
    let is_free = ratios.omega() >= F::exp2i(springless_exponent::<F>().saturating_sub(2));
    if is_free || !ratios.has_higher_static_friction() {
        return "One periodic motion, from every start.".to_owned();
    }
    let cycle = match steady.turns_per_cycle {
        1 => String::new(),
        turns => format!(" A cycle takes {turns} turns of the drive."),
    };
    let symmetry = if steady.is_symmetric {
        ""
    } else {
        " It is not symmetric: its mirror image is a motion from other starts."
    };
    format!("The limit of this start. Other starts can have others.{cycle}{symmetry}")
}

/// What moves, the force that it exerts, and the meaning of x, as the words after “base motion”; `None` for a force.
#[must_use]
pub const fn base_motion(excitation: Excitation) -> Option<&'static str> {
    match excitation {
        Excitation::FootMotion => {
            Some("the spring's support moves over a fixed surface: p₀ = k u₀, x over the surface")
        }
        Excitation::DampedFootMotion => Some(
            "the support of spring and damper moves over a fixed surface: p₀ = √(k² + c²ω_d²) u₀, x over the surface",
        ),
        excitation if excitation.carries_surface() => {
            Some("the base carries the surface: p₀ = m ω_d² u₀, x relative to the base")
        }
        _ => None,
    }
}

/// [`base_motion`] as a sentence.
#[must_use]
pub fn base_motion_sentence(excitation: Excitation) -> Option<String> {
    base_motion(excitation).map(|words| format!("T{}.", words.trim_start_matches('t')))
}

/// The symmetry and the period of a motion, in words.
#[must_use]
pub fn shape<F: Float>(steady: &SteadyState<F>) -> String {
    let symmetry = if steady.is_symmetric { "Symmetric" } else { "Not symmetric" };
    match steady.turns_per_cycle {
        1 => format!("{symmetry}, a cycle of one turn of the drive"),
        turns => format!("{symmetry}, a cycle of {turns} turns of the drive"),
    }
}

/// A description of a limit.
#[must_use]
pub fn described<F: Float>(found: &Attractor<F>) -> String {
    let mirror = match found.mirror {
        Some(place) => format!(", the mirror image of {}", place.saturating_add(1)),
        None => String::new(),
    };
    match found.limit {
        LongRun::Periodic(steady) => {
            format!("{}{mirror}", shape(&steady))
        }
        LongRun::Family(_) => "A family of periodic motions, by their mean positions".to_owned(),
        LongRun::Rest(_) => "Rest".to_owned(),
        LongRun::Irregular(motion) if motion.is_chaotic() => format!("Irregular, chaotic{mirror}"),
        LongRun::Irregular(_) => format!("Irregular, not chaotic{mirror}"),
        LongRun::Unbounded { .. } => "Growing without bound".to_owned(),
        LongRun::NotConverged { .. } => "Not settled".to_owned(),
    }
}
