//! A steady motion, proved: the box in which it is the only one, its extrema, its stops, its multipliers.

use super::super::root::only_zero;
use super::super::{Enclosure, Known, valid};
use super::half_turn::{HalfTurn, Map, Start};
use super::outline::outline;
use super::slide::{Machine, Slide};
use crate::error::{Error, Number, Quantity, written};
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use crate::ratios::Ratios;
use core::cmp::Ordering;

/// A symmetric periodic motion that exists, with all that is asked of it enclosed.
///
/// Displacements in units of B = r_y/k, velocities in B ω_d, phases ω_d t in rad.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Steady {
    /// Maximum displacement x/B; the minimum is its negative.
    pub max_displacement: Enclosure,
    /// Maximum velocity x′/(Bω_d); the minimum is its negative.
    pub max_velocity: Enclosure,
    /// The part of a cycle that the body is at rest.
    pub stick_fraction: Enclosure,
    /// Stops in a cycle.
    pub sticks_per_cycle: u32,
    /// Velocity zeros in a cycle; a stop counts once.
    pub velocity_zeros_per_cycle: u32,
    /// The multipliers of a cycle, each (re, im); 0 where the body stops.
    pub multipliers: [(Enclosure, Enclosure); 2],
    /// Phase and place of a release, or of a reversal where the body never stops: in these two enclosures there is one such motion.
    pub start: (Enclosure, Enclosure),
    /// The box in which it is the only such motion: half widths of phase and place; of place alone where the body stops.
    pub only_within: (Option<Enclosure>, Enclosure),
    /// The bits that it was computed with.
    pub bits: u32,
}

/// The steady motion from rest at (Ω, α, ζ, η), enclosed to `bits` bits, η = r_s/r_y being static friction over the kinetic one; `None` where it
/// is not proved: it grazes, is not symmetric, does not settle, has more than 512 slides in half a turn, or Ω = 1 without damping.
///
/// With η > 1 other starts may lead to other motions.
///
/// # Errors
/// Where a ratio or `bits` is outside its domain ([`crate::exact::Trajectory::new`] for Ω), or ζ ≥ 1, for which there is no enclosure.
pub fn steady(
    omega: &Known,
    alpha: &Known,
    damping_ratio: &Known,
    static_friction_ratio: &Known,
    bits: u32,
) -> Result<Option<Steady>, Error> {
    let omega = omega.within(Quantity::FrequencyRatio, true)?;
    let alpha = alpha.within(Quantity::ForceRatio, false)?;
    let bits = valid(bits)?;
    if *damping_ratio.high() >= 1 {
        return Err(Error::OutOfRange {
            quantity: Quantity::DampingRatio,
            value: written(damping_ratio.high().to_f64()),
            least: written(0.0),
            greatest: Number::spelled(1f64.next_down(), "0.999…"),
        });
    }
    let ratios = Ratios::new(omega.middle().to_f64(), alpha.middle().to_f64())?;
    let ratios = ratios.with_damping_ratio(damping_ratio.middle().to_f64())?;
    let eta = static_friction_ratio;
    if *eta.low() < 1 {
        let static_friction_ratio = written(Mp::<2>::from_rational(eta.low()).to_f64());
        return Err(Error::BelowKineticFriction { static_friction_ratio });
    }
    let ratios = ratios.with_static_friction_ratio(eta.middle().to_f64())?;
    let Some(outline) = outline(ratios)? else { return Ok(None) };
    let mut last = None;
    macro_rules! at {
        ($($width:literal)*) => {$(
            if Mp::<$width>::BITS >= bits + 64 {
                let machine = Machine::<$width>::new(omega.ball(), alpha.ball(), damping_ratio.ball(), eta.ball());
                let found = proved(&Map { machine, outline: &outline });
                if let Some(found) = &found && found.is_sharp(bits) {
                    return Ok(Some(found.answer(bits)));
                }
                let found = found.map(|found| found.answer(bits));
                if last.is_some() && found.is_some() {
                    return Ok(found);
                }
                last = found;
            }
        )*};
    }
    at!(3 5 9 17 65);
    Ok(last)
}

/// What is found at one width.
struct Found<const W: usize> {
    max_displacement: Ball<W>,
    max_velocity: Ball<W>,
    stick_fraction: Ball<W>,
    sticks: u32,
    zeros: u32,
    multipliers: [(Ball<W>, Ball<W>); 2],
    start: Start<W>,
    only_within: (Option<Radius>, Radius),
}

impl<const W: usize> Found<W> {
    fn values(&self) -> [&Ball<W>; 3] {
        [&self.max_displacement, &self.max_velocity, &self.start.place]
    }

    fn is_sharp(&self, bits: u32) -> bool {
        self.values().into_iter().all(|ball| {
            Radius::below(ball.mid()).exponent() - ball.rad().exponent() >= i64::from(bits) + 2
                || ball.rad().is_zero()
        })
    }

    fn answer(&self, bits: u32) -> Steady {
        let of = |ball: &Ball<W>| Enclosure::of(ball).unwrap_or_default().rounded(bits);
        let reach = |r: Radius| of(&Ball::exact(r.value()));
        Steady {
            max_displacement: of(&self.max_displacement),
            max_velocity: of(&self.max_velocity),
            stick_fraction: of(&self.stick_fraction),
            sticks_per_cycle: self.sticks,
            velocity_zeros_per_cycle: self.zeros,
            multipliers: [0, 1].map(|i| {
                let (re, im) = if i == 0 { self.multipliers[0] } else { self.multipliers[1] };
                (of(&re), of(&im))
            }),
            start: (of(&self.start.phase), of(&self.start.place)),
            only_within: (self.only_within.0.map(reach), reach(self.only_within.1)),
            bits: Mp::<W>::BITS,
        }
    }
}

/// The zero of the half-turn map less its mirror image, and the proof.
fn proved<const W: usize>(map: &Map<'_, W>) -> Option<Found<W>> {
    let outline = map.outline;
    let mut middle = (Mp::of_f64(outline.phase), Mp::of_f64(outline.place));
    let start =
        |(phase, place): (Mp<W>, Mp<W>)| Start { phase: Ball::exact(phase), place: Ball::exact(place) };
    // Newton's method on the midpoints.
    let mut step = None;
    for _ in 0..12 {
        let at = map.follow(start(middle))?;
        let (by_phase, by_place) = newton(&at, &at)?;
        let is_small = |x: Ball<W>| Radius::above(x.mid()) <= x.rad().scaled(2);
        step = Some((by_phase, by_place));
        if is_small(by_place) && (outline.stops || is_small(by_phase)) {
            break;
        }
        middle = (middle.0 - by_phase.mid(), middle.1 - by_place.mid());
    }
    let (by_phase, by_place) = step?;
    let least = Radius::power_of_two(8 - i64::from(Mp::<W>::BITS));
    let size = |x: Ball<W>| Radius::above(x.mid()).plus(x.rad()).plus(least);
    let at = map.follow(start(middle))?;
    // A small box for the motion, then a large one in which it is the only one.
    let smallest = (size(by_phase), size(by_place));
    let found = (1..8).find_map(|n| only_in(map, &at, (smallest.0.scaled(n), smallest.1.scaled(n))))?;
    let half = map.follow(found)?;
    let large = |n: i64| Radius::power_of_two(-n);
    let reach = (5..40).step_by(3).find(|&n| only_in(map, &at, (large(n), large(n))).is_some()).map(large);
    let reach = reach.map_or(smallest, |reach| (reach, reach));
    described(map, &half, ((!outline.stops).then_some(reach.0), reach.1))
}

/// Where the zero is that is the only one in the box of these half widths around the start of `at`; `None` where that is not shown.
fn only_in<const W: usize>(map: &Map<'_, W>, at: &HalfTurn<W>, reach: (Radius, Radius)) -> Option<Start<W>> {
    let stops = map.outline.stops;
    let middle = at.start;
    let around = Start {
        phase: Ball::new(middle.phase.mid(), reach.0),
        place: Ball::new(middle.place.mid(), reach.1),
    };
    let over = map.follow(around)?;
    let (by_phase, by_place) = newton(at, &over)?;
    let found = Start { phase: middle.phase - by_phase, place: middle.place - by_place };
    let is_inside = found.place.is_inside(&around.place) && (stops || found.phase.is_inside(&around.phase));
    (is_inside && over.is_the_motion(map)).then_some(found)
}

/// Newton's step: what start less mirrored end is at `at`, over the derivatives of `over`.
fn newton<const W: usize>(at: &HalfTurn<W>, over: &HalfTurn<W>) -> Option<(Ball<W>, Ball<W>)> {
    let one = Ball::int(1);
    // F = (θ₁ − π − θ₀, x₁ + x₀)
    let (f, g) = (at.end.phase - at.start.phase, at.start.place - at.end.place);
    let [[a, b], [c, d]] = over.derivatives;
    if c.sign() == Some(Ordering::Equal) && a.sign() == Some(Ordering::Equal) {
        // From a stop the place alone decides.
        let step = g / (d + one);
        return (!step.is_entire()).then_some((Ball::int(0), step));
    }
    let (a, d) = (a - one, d + one);
    let determinant = a * d - b * c;
    let (by_phase, by_place) = ((f * d - b * g) / determinant, (a * g - c * f) / determinant);
    (!by_phase.is_entire() && !by_place.is_entire()).then_some((by_phase, by_place))
}

/// What the motion is like.
fn described<const W: usize>(
    map: &Map<'_, W>,
    half: &HalfTurn<W>,
    only_within: (Option<Radius>, Radius),
) -> Option<Found<W>> {
    let zero = Ball::int(0);
    let mut max_displacement = half.start.place.abs();
    let (mut max_velocity, mut at_rest, mut stops) = (zero, zero, 0);
    for step in &half.steps {
        max_displacement = max_displacement.larger(&step.end.place.abs());
        max_velocity = max_velocity.larger(&fastest(&step.slide, &step.end.duration)?);
        if let Some(release) = step.release {
            at_rest = at_rest + (release - step.end.phase);
            stops += 1;
        }
    }
    let zeros = u32::try_from(half.steps.len()).ok()?;
    Some(Found {
        max_displacement,
        max_velocity: max_velocity / map.machine.omega,
        stick_fraction: at_rest / Ball::pi(),
        sticks: 2 * stops,
        zeros: 2 * zeros,
        multipliers: multipliers(&half.derivatives, map.outline.stops),
        start: half.start,
        only_within,
    })
}

/// The greatest speed of a slide: at a zero of the acceleration that is shown to be alone in its interval, all others being slower.
fn fastest<const W: usize>(slide: &Slide<W>, duration: &Ball<W>) -> Option<Ball<W>> {
    let (mut best, mut found) = (Mp::<W>::ZERO, None::<Ball<W>>);
    // A speed that is reached, to leave out what is certainly slower.
    for i in 1..64 {
        let speed = slide.sign * slide.at(Ball::exact(duration.mid() * Mp::of_int(i).scale2(-6))).w;
        if speed.lower() > best {
            best = speed.lower();
        }
    }
    let mut left = vec![(Mp::ZERO, duration.upper())];
    for _ in 0..4000 {
        let Some((low, high)) = left.pop() else { return found };
        let phi = Ball::between(low, high);
        if slide.speed_over(phi).upper() < best {
            continue;
        }
        let at = slide.at(phi);
        if (slide.sign * at.jerk).is_negative() || (slide.sign * at.jerk).is_positive() {
            let zero = only_zero(phi.mid(), |phi| slide.at(phi).acceleration, |phi| slide.at(phi).jerk);
            if let Some(zero) = zero
                && zero.is_inside(&phi)
            {
                let speed = slide.speed_over(zero);
                if speed.lower() > best {
                    best = speed.lower();
                }
                found = Some(found.map_or(speed, |other| other.larger(&speed)));
                continue;
            }
        }
        if at.acceleration.sign().is_some() {
            // Faster at an end, which belongs to a neighbour, or to rest.
            continue;
        }
        let middle = (low + high).scale2(-1);
        left.push((middle, high));
        left.push((low, middle));
    }
    None
}

/// The multipliers of a whole turn, from the derivatives over half a turn, in which the mirror image changes the sign of the place.
fn multipliers<const W: usize>(derivatives: &[[Ball<W>; 2]; 2], stops: bool) -> [(Ball<W>, Ball<W>); 2] {
    let (zero, two) = (Ball::int(0), Ball::int(2));
    let [[a, b], [c, d]] = *derivatives;
    if stops {
        return [(d.square(), zero), (zero, zero)];
    }
    let (trace, determinant) = (a - d, b * c - a * d);
    let discriminant = trace.square() - determinant * Ball::int(4);
    match discriminant.sign() {
        Some(Ordering::Less) => {
            let (re, im) = (trace / two, (-discriminant).sqrt() / two);
            let (square, twice) = (re.square() - im.square(), (two * re * im).abs());
            [(square, twice), (square, -twice)]
        }
        Some(_) => {
            let root = discriminant.sqrt();
            let of = |x: Ball<W>| ((x / two).square(), zero);
            let (plus, minus) = (of(trace + root), of(trace - root));
            if plus.0.is_below(&minus.0) { [minus, plus] } else { [plus, minus] }
        }
        // Beside a double root: both within its reach of the middle.
        None => {
            let reach = discriminant.abs().upper().sqrt();
            let around = Ball::between(-reach, reach) / two;
            let (re, im) = (trace / two + around, around);
            let all = (re.square() - im.square(), two * re * im);
            [all, all]
        }
    }
}
