//! Observation of a motion that is followed: its slides, stops and extrema, the divergence of its neighbours,
//! and whether it grows without bound.

use crate::float::Float;
use crate::machine::ratios::Ratios;
use crate::motion::broken::Budget;
use crate::motion::limit::irregular::Irregular;
use crate::motion::limit::long_run::growth_at_resonance;
use crate::motion::limit::matrix::Matrix;
use crate::motion::limit::propagation::MotionPart;
use crate::motion::slide::equation::Equation;
use crate::motion::state::PhasePoint;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Parts of the time for the standard error of the Lyapunov exponent.
const PARTS: u64 = 32;

/// Ω = 1 and α > 4/π without damping, where a motion can grow without bound.
pub(super) struct GrowthAtResonance<F> {
    large: F,
    growth: F,
}

impl<F: Float> GrowthAtResonance<F> {
    pub(super) fn of(ratios: &Ratios<F>) -> Option<Self> {
        let large = F::int(16) * (ratios.alpha() + ratios.static_friction_ratio());
        growth_at_resonance(ratios).map(|growth| Self { large, growth })
    }

    /// The growth per turn of a motion that is so large that it no longer stops, if it grows. The averaged
    /// motion then approaches the phase of the drive, and the motion grows without bound.
    pub(super) fn seen(&self, before: &PhasePoint<F>, after: &PhasePoint<F>) -> Option<F> {
        let (early, late) = (before.x.hypot(before.w), after.x.hypot(after.w));
        (early > self.large && late > early).then_some(self.growth)
    }
}

/// Observation of a motion while it is followed.
pub(super) struct Observation<F> {
    /// The number of half turns before the observation begins, and the number in one part of the time.
    from: u64,
    part: u64,
    is_counting: bool,
    /// Whether the states have the opposite sign, after an odd number of half turns.
    pub(super) is_upside_down: bool,
    disturbance: (F, F),
    growth: [f64; PARTS as usize],
    counted: u64,
    max_x: Option<F>,
    min_x: Option<F>,
    stops: u64,
    pub(super) slides: u64,
}

impl<F: Float> Observation<F> {
    pub(super) fn new(most: u64) -> Self {
        let from = most / 4;
        Self {
            from,
            part: most.saturating_sub(from).div_euclid(PARTS).max(1),
            is_counting: from == 0,
            is_upside_down: false,
            disturbance: (F::int(1), F::int(1)),
            growth: [0.0; PARTS as usize],
            counted: 0,
            max_x: None,
            min_x: None,
            stops: 0,
            slides: 0,
        }
    }

    pub(super) fn add(&mut self, part: &MotionPart<F>) {
        let x = match part {
            MotionPart::Slide(_, end) => {
                self.slides = self.slides.saturating_add(1);
                end.x
            }
            MotionPart::Onward(_, _, _, motion) => motion.x,
            MotionPart::Stick(stick, _) => {
                self.stops = self.stops.saturating_add(u64::from(self.is_counting));
                stick.x
            }
        };
        let x = if self.is_upside_down { -x } else { x };
        if self.is_counting {
            self.max_x = Some(self.max_x.map_or(x, |most| most.or_larger(x)));
            self.min_x = Some(self.min_x.map_or(x, |least| -((-least).or_larger(-x))));
        }
    }

    /// Propagates the disturbance over a half turn.
    pub(super) fn stretch(&mut self, derivative: &Matrix<F>, half_turns: u64) {
        let (x, w) = derivative.times(self.disturbance);
        let length = x.hypot(w);
        let is_usable = length > F::int(0) && length.is_finite();
        self.disturbance = if is_usable { (x / length, w / length) } else { (F::int(1), F::int(1)) };
        if self.is_counting && is_usable {
            let index = self.whole_parts();
            if let Some(growth) = self.growth.get_mut(index) {
                *growth += libm::log(length.to_f64());
                self.counted = self.counted.saturating_add(1);
            }
        }
        self.is_counting = half_turns >= self.from;
        self.is_upside_down = !self.is_upside_down;
    }

    /// The number of complete parts of the time.
    fn whole_parts(&self) -> usize {
        usize::try_from(self.counted.checked_div(self.part).unwrap_or(0)).unwrap_or(usize::MAX)
    }

    /// A state of the motion, with the change of sign undone.
    pub(super) fn upright(&self, y: &PhasePoint<F>) -> PhasePoint<F> {
        if self.is_upside_down { y.mirrored() } else { *y }
    }

    /// The irregular motion, if its neighbours do not approach it.
    pub(super) fn irregular(
        &self,
        equation: &Equation<F>,
        y: &PhasePoint<F>,
        budget: &Budget<'_>,
    ) -> Option<Irregular<F>> {
        let whole = self.whole_parts().min(PARTS as usize);
        if whole < PARTS as usize / 2 {
            return None;
        }
        // The values are per turn, and a turn is two half turns.
        let means = self.growth.iter().take(whole).map(|sum| 2.0 * sum / self.part as f64);
        let count = whole as f64;
        let mean = means.clone().sum::<f64>() / count;
        let variance = means.map(|part| (part - mean) * (part - mean)).sum::<f64>() / (count - 1.0);
        let error = (variance / count).sqrt();
        let is_irregular = mean > -4.0 * error && mean.is_finite();
        let (max_displacement, min_displacement) = (self.max_x?, self.min_x?);
        is_irregular.then(|| Irregular {
            state: y.state(equation.omega),
            lyapunov_exponent: F::from_f64(mean),
            lyapunov_exponent_error: F::from_f64(error),
            max_displacement,
            min_displacement,
            stops: self.stops,
            turns: self.counted / 2,
            periods: budget.periods(),
        })
    }
}
