//! Properties of a proved cycle: its maximum speed and its multipliers.

use super::map::Map;
use super::slide::Slide;
use crate::enclosed::root::only_zero;
use crate::float::Field;
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use core::cmp::Ordering;

/// The maximum speed of a slide: at a zero of the acceleration that is proved to be the only one in its
/// interval, while the speed in all other intervals is lower.
pub(super) fn fastest<const W: usize>(slide: &Slide<W>, duration: &Ball<W>) -> Option<Ball<W>> {
    let (mut best, mut found) = (Mp::<W>::ZERO, None::<Ball<W>>);
    // Attained speeds, to discard intervals that are certainly slower.
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
            // The speed is greater at an end, which belongs to a neighbour, or the body is at rest there.
            continue;
        }
        let middle = (low + high).scale2(-1);
        left.push((middle, high));
        left.push((low, middle));
    }
    None
}

/// The multipliers of a cycle: those of the map followed by its mirror image, squared if a cycle is two
/// applications of the map.
pub(super) fn multipliers<const W: usize>(
    map: &Map<'_, W>,
    derivatives: &[[Ball<W>; 2]; 2],
) -> [(Ball<W>, Ball<W>); 2] {
    let (zero, two, image) = (Ball::int(0), Ball::int(2), map.image());
    let is_half = map.outline.image() < 0;
    let [[a, b], [c, d]] = *derivatives;
    let real = |x: Ball<W>| (if is_half { x.square() } else { x }, zero);
    if map.outline.stops {
        return [real(d), real(zero)];
    }
    let complex = |(re, im): (Ball<W>, Ball<W>)| {
        if is_half { (re.square() - im.square(), two * re * im) } else { (re, im) }
    };
    let (trace, determinant) = (a + image * d, image * (a * d - b * c));
    let discriminant = trace.square() - determinant * Ball::int(4);
    match discriminant.sign() {
        Some(Ordering::Less) => {
            let (re, im) = complex((trace / two, (-discriminant).sqrt() / two));
            [(re, im.abs()), (re, -im.abs())]
        }
        Some(_) => {
            let root = discriminant.sqrt();
            let (plus, minus) = (real((trace + root) / two), real((trace - root) / two));
            if plus.0.abs().is_below(&minus.0.abs()) { [minus, plus] } else { [plus, minus] }
        }
        // Near a double root, both multipliers lie within this radius of the mean.
        None => {
            let reach = discriminant.abs().upper().sqrt();
            let around = Ball::between(-reach, reach) / two;
            let all = complex((trace / two + around, around));
            [all, all]
        }
    }
}
