//! A proved steady motion: its box of uniqueness, extrema, stops and multipliers.

use super::map::{FollowedBalls, Map, MapStart};
use super::outline::{Outline, outline};
use super::slide::DrivenBody;
use super::statistics::{fastest, multipliers};
use super::unproved::Unproved;
use crate::enclosed::widen::{InBalls, has_bits, with_more_bits};
use crate::enclosed::{Enclosure, Known, valid};
use crate::float::Field;
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::ratios::Ratios;

/// A periodic motion that exists, with all its properties enclosed.
///
/// Displacements in units of B = r_y/k, velocities in B ω_d, phases ω_d t in rad.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Steady {
    /// Peak displacement x/B.
    pub max_displacement: Enclosure,
    /// Minimum displacement x/B.
    pub min_displacement: Enclosure,
    /// Peak velocity x′/(Bω_d).
    pub max_velocity: Enclosure,
    /// Minimum velocity x′/(Bω_d).
    pub min_velocity: Enclosure,
    /// Whether the two halves of a cycle have opposite signs.
    #[cfg_attr(feature = "serde", serde(rename = "symmetric"))]
    pub is_symmetric: bool,
    /// The number of turns of the drive in a cycle.
    pub turns_per_cycle: u32,
    /// The fraction of a cycle during which the body is at rest.
    pub stick_fraction: Enclosure,
    /// The number of stops in a cycle.
    pub sticks_per_cycle: u32,
    /// The number of velocity zeros in a cycle; a stop counts once.
    pub velocity_zeros_per_cycle: u32,
    /// The multipliers of a cycle, each (re, im); 0 where the body stops.
    pub multipliers: [(Enclosure, Enclosure); 2],
    /// Phase and place of a release, or of a reversal if the body never stops: these two enclosures contain
    /// exactly one such motion.
    pub start: (Enclosure, Enclosure),
    /// Half widths of the box in which this is the only such motion: of phase and place, or of place alone if
    /// the body stops.
    pub only_within: (Option<Enclosure>, Enclosure),
    /// The number of bits used.
    pub bits: u32,
}

/// The steady motion from rest at (Ω, α, ζ, η), enclosed to `bits` bits, where η = r_s/r_y is the ratio of
/// static to kinetic friction; or the reason why it is not proved.
///
/// With η > 1 other starts may lead to other motions.
///
/// # Errors
/// Where a ratio or `bits` is outside its domain ([`crate::motion::Trajectory::new`] for Ω).
pub(in crate::enclosed) fn steady(
    omega: &Known,
    alpha: &Known,
    damping_ratio: &Known,
    static_friction_ratio: &Known,
    bits: u32,
) -> Result<Result<Steady, Unproved>, Error> {
    let omega = omega.within(Quantity::FrequencyRatio, true)?;
    let alpha = alpha.within(Quantity::ForceRatio, false)?;
    let bits = valid(bits)?;
    let ratios = Ratios::new(omega.middle().to_f64(), alpha.middle().to_f64())?;
    let ratios = ratios.with_damping_ratio(damping_ratio.middle().to_f64())?;
    let eta = static_friction_ratio;
    if *eta.low() < 1 {
        let static_friction_ratio = written(Mp::<2>::from_rational(eta.low()).to_f64());
        return Err(Error::BelowKineticFriction { static_friction_ratio });
    }
    let ratios = ratios.with_static_friction_ratio(eta.middle().to_f64())?;
    let outline = match outline(ratios)? {
        Ok(outline) => outline,
        Err(why) => return Ok(Err(why)),
    };
    let mut last: Option<Result<Steady, Unproved>> = None;
    let motion = OutlinedMotion { ratios: [omega, alpha, damping_ratio, eta], outline, bits };
    let found = with_more_bits(&PRECISIONS, bits, &motion, |_, found| {
        let is_known = found.is_ok() && matches!(last, Some(Ok(_)));
        let is_sharp = matches!(found, Ok((_, true)));
        let found = last.insert(found.map(|(found, _)| found));
        (is_sharp || is_known).then(|| found.clone())
    });
    Ok(found.or(last).unwrap_or(Err(Unproved::NotAlone { bits })))
}

/// The precisions tried, in words of 64 bits.
const PRECISIONS: [u32; 5] = [3, 5, 9, 17, 65];

/// A motion to be proved at (Ω, α, ζ, η), to so many bits.
struct OutlinedMotion<'a> {
    ratios: [&'a Known; 4],
    outline: Outline,
    bits: u32,
}

impl InBalls for OutlinedMotion<'_> {
    /// The motion, and whether it has so many bits.
    type Found = Result<(Steady, bool), Unproved>;

    fn run<const W: usize>(&self) -> Self::Found {
        let [omega, alpha, zeta, eta] = self.ratios.map(Known::ball::<W>);
        let machine = DrivenBody::new(omega, alpha, zeta, eta);
        proved(&Map { machine, outline: &self.outline }, self.bits)
    }
}

/// The motion whose start the map takes to its image, with the proof; and whether `bits` of it are certain.
fn proved<const W: usize>(map: &Map<'_, W>, bits: u32) -> Result<(Steady, bool), Unproved> {
    let outline = map.outline;
    let mut middle = (Mp::of_f64(outline.phase), Mp::of_f64(outline.place));
    let start =
        |(phase, place): (Mp<W>, Mp<W>)| MapStart { phase: Ball::exact(phase), place: Ball::exact(place) };
    // Newton's method on the midpoints.
    let mut step = None;
    for _ in 0..12 {
        let at = map.follow(start(middle))?;
        let (by_phase, by_place) = newton(map, &at, &at)?;
        let is_small = |x: Ball<W>| Radius::above(x.mid()) <= x.rad().scaled(2);
        step = Some((by_phase, by_place));
        if is_small(by_place) && (outline.stops || is_small(by_phase)) {
            break;
        }
        middle = (middle.0 - by_phase.mid(), middle.1 - by_place.mid());
    }
    let (by_phase, by_place) = step.ok_or_else(alone_is_not_shown::<W>)?;
    let least = Radius::power_of_two(8 - i64::from(Mp::<W>::bits_now()));
    let size = |x: Ball<W>| Radius::above(x.mid()).plus(x.rad()).plus(least);
    let at = map.follow(start(middle))?;
    // First a small box for the motion, then a large one for uniqueness.
    let smallest = (size(by_phase), size(by_place));
    // If the certificate fails, its reason is more informative than the size of a box.
    let mut why = alone_is_not_shown::<W>();
    let found = (1..8).find_map(|n| match only_in(map, &at, (smallest.0.scaled(n), smallest.1.scaled(n))) {
        Ok(found) => Some(found),
        Err(reason) => {
            if !matches!(reason, Unproved::NotAlone { .. }) {
                why = reason;
            }
            None
        }
    });
    let followed = map.follow(found.ok_or(why)?)?;
    let large = |n: i64| Radius::power_of_two(-n);
    let reach = (5..40).step_by(3).find(|&n| only_in(map, &at, (large(n), large(n))).is_ok()).map(large);
    let reach = reach.map_or(smallest, |reach| (reach, reach));
    described(map, &followed, ((!outline.stops).then_some(reach.0), reach.1), bits)
}

/// The reason that uniqueness is not proved at this precision.
fn alone_is_not_shown<const W: usize>() -> Unproved {
    Unproved::NotAlone { bits: Mp::<W>::bits_now() }
}

/// The zero, if it is the only one in the box of these half widths around the start of `at`.
fn only_in<const W: usize>(
    map: &Map<'_, W>,
    at: &FollowedBalls<W>,
    reach: (Radius, Radius),
) -> Result<MapStart<W>, Unproved> {
    let stops = map.outline.stops;
    let middle = at.start;
    let around = MapStart {
        phase: Ball::new(middle.phase.mid(), reach.0),
        place: Ball::new(middle.place.mid(), reach.1),
    };
    let over = map.follow(around)?;
    let (by_phase, by_place) = newton(map, at, &over)?;
    let found = MapStart { phase: middle.phase - by_phase, place: middle.place - by_place };
    let is_inside = found.place.is_inside(&around.place) && (stops || found.phase.is_inside(&around.phase));
    if !is_inside {
        return Err(alone_is_not_shown::<W>());
    }
    over.is_the_motion(map)?;
    Ok(found)
}

/// Newton's step: the start minus the image of the end at `at`, divided by the derivatives of `over`.
fn newton<const W: usize>(
    map: &Map<'_, W>,
    at: &FollowedBalls<W>,
    over: &FollowedBalls<W>,
) -> Result<(Ball<W>, Ball<W>), Unproved> {
    let one = Ball::int(1);
    // F = (θ₁ − nπ − θ₀, x₀ ∓ x₁)
    let (f, g) = (at.end.phase - at.start.phase, at.start.place - at.end.place);
    let [[a, b], [c, d]] = over.derivatives;
    let (c, d) = (-(map.image() * c), one - map.image() * d);
    let (by_phase, by_place) = if map.outline.stops {
        // With a stop, the place alone determines the motion.
        (Ball::int(0), g / d)
    } else {
        let a = a - one;
        let determinant = a * d - b * c;
        ((f * d - b * g) / determinant, (a * g - c * f) / determinant)
    };
    if by_phase.is_entire() || by_place.is_entire() {
        return Err(alone_is_not_shown::<W>());
    }
    Ok((by_phase, by_place))
}

/// The properties of the motion, and whether `bits` of its extrema and its start are certain.
fn described<const W: usize>(
    map: &Map<'_, W>,
    followed: &FollowedBalls<W>,
    only_within: (Option<Radius>, Radius),
    bits: u32,
) -> Result<(Steady, bool), Unproved> {
    let zero = Ball::int(0);
    let mut displacement = (followed.start.place, followed.start.place);
    let (mut velocity, mut at_rest, mut stops) = ((zero, zero), zero, 0);
    let smaller = |a: &Ball<W>, b: &Ball<W>| -(-*a).larger(&-*b);
    for (step, part) in followed.steps.iter().zip(&map.outline.parts) {
        displacement = (smaller(&displacement.0, &step.end.place), displacement.1.larger(&step.end.place));
        let speed = fastest(&step.slide, &step.end.duration).ok_or_else(alone_is_not_shown::<W>)?;
        velocity = if part.sign > 0 {
            (velocity.0, velocity.1.larger(&speed))
        } else {
            (smaller(&velocity.0, &-speed), velocity.1)
        };
        if let Some(release) = step.release {
            at_rest = at_rest + (release - step.end.phase);
            stops += 1;
        }
    }
    let mut zeros = u32::try_from(followed.steps.len()).map_err(|_| Unproved::TooManySlides)?;
    if map.outline.image() < 0 {
        // The other half of the cycle has the opposite sign.
        let symmetric = |(low, high): (Ball<W>, Ball<W>)| {
            let greatest = high.larger(&-low);
            (-greatest, greatest)
        };
        (displacement, velocity) = (symmetric(displacement), symmetric(velocity));
        (stops, zeros) = (2 * stops, 2 * zeros);
    }
    let omega = map.machine.omega;
    let velocity = (velocity.0 / omega, velocity.1 / omega);
    let MapStart { phase, place } = followed.start;
    let is_sharp = [displacement.0, displacement.1, velocity.0, velocity.1, place]
        .into_iter()
        .all(|ball| has_bits(&ball, bits));
    let of = |ball: Ball<W>| Enclosure::of(&ball).unwrap_or_default().rounded(bits);
    let reach = |r: Radius| of(Ball::exact(r.value()));
    let is_symmetric = map.outline.half_turns % 2 == 1;
    let found = Steady {
        max_displacement: of(displacement.1),
        min_displacement: of(displacement.0),
        max_velocity: of(velocity.1),
        min_velocity: of(velocity.0),
        is_symmetric,
        turns_per_cycle: if is_symmetric { map.outline.half_turns } else { map.outline.half_turns / 2 },
        stick_fraction: of(at_rest / map.span()),
        sticks_per_cycle: stops,
        velocity_zeros_per_cycle: zeros,
        multipliers: multipliers(map, &followed.derivatives).map(|(re, im)| (of(re), of(im))),
        start: (of(phase), of(place)),
        only_within: (only_within.0.map(reach), reach(only_within.1)),
        bits: Mp::<W>::bits_now(),
    };
    Ok((found, is_sharp))
}
