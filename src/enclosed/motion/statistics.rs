//! Properties of a proved cycle: its maximum speed and its multipliers.

use super::map::Map;
use super::slide::SlideBall;
use crate::enclosed::greatest::greatest;
use crate::float::Field;
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::greatest::Jet;
use core::cmp::Ordering;

/// The maximum speed of a slide, at whose ends the body is at rest.
pub(super) fn fastest<const W: usize>(slide: &SlideBall<W>, duration: &Ball<W>) -> Option<Ball<W>> {
    let speed = |phi| {
        let at = slide.at(phi);
        let [value, slope, second] = [at.w, at.acceleration, at.jerk].map(|x| slide.sign * x);
        Jet { value, slope, second }
    };
    greatest((Mp::ZERO, duration.upper()), speed).map(|found| found.value)
}

/// The multipliers of a cycle: those of the map followed by its mirror image, squared if a cycle is two
/// applications of the map.
///
/// Floats take a discriminant within its rounding as zero (`crate::motion::limit::matrix`), where balls give all that
/// it may lead to.
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
