//! Input and result of the search for a zero (`event`).

use super::cover::Cover;
use super::window::VelocityWaves;
use crate::float::Float;
use crate::motion::slide::Slide;
use crate::motion::slide::motion::SlideJet;

/// The first zero is at `at + step`, where `step` is the last step; `motion` is the motion at `at`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FoundZero<F, M> {
    pub(crate) at: F,
    pub(crate) step: F,
    pub(crate) motion: M,
    /// The function touches zero without crossing it.
    pub(crate) grazes: bool,
}

/// A window of natural time that contains no zero; it repeats after `period`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Safe<F> {
    pub(crate) centre: F,
    pub(crate) half_width: F,
    pub(crate) period: F,
}

impl<F: Float> Safe<F> {
    /// The window that contains φ or is the next one, as (beginning, end), reduced by the rounding of its
    /// ends. If the window is empty, its beginning is not before its end.
    pub(crate) fn next(&self, phi: F) -> (F, F) {
        // The centre, the half width and turns times the period are each accurate to two units, and none
        // exceeds φ + 2 periods by much.
        let rounding = F::int(16) * F::epsilon() * (phi + self.period);
        let half_width = self.half_width - rounding;
        // A φ at the end of a window belongs to the next one.
        let turns = ((phi + rounding - self.centre - half_width) / self.period).floor() + F::int(1);
        let centre = self.centre + turns * self.period;
        (centre - half_width, centre + half_width)
    }
}

/// The properties of the function whose zero is sought.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ZeroSearch<'a, F> {
    pub(crate) omega: F,
    /// The fastest rate of change, [`crate::motion::slide::equation::Equation::pace`].
    pub(crate) pace: F,
    pub(crate) cover: Cover<F>,
    /// The angle of g at φ = 0 within its half turn, in `[−π/2, π/2)`: `|g| ∝ cos`.
    pub(crate) angle: F,
    /// Whether g ≥ 0 on that half turn.
    pub(crate) helping: bool,
    /// Whether f = 0 at φ = 0 and increases from there.
    pub(crate) from_zero: bool,
    /// The end of the search; the zero may be at the limit itself.
    pub(crate) limit: Option<F>,
    /// The natural time at which the zero is expected.
    pub(crate) hint: F,
    /// The window without zeros, for a motion without damping.
    pub(crate) safe: Option<Safe<F>>,
    /// The slide, if an examination of the two waves of its velocity costs less than the stretches that it
    /// clears.
    pub(crate) waves: Option<&'a Slide<F>>,
    /// The rounding error of f near a zero.
    pub(crate) noise: F,
    /// The rounding error of f near a zero at a short time, as the coefficients of 1, φ, φ², φ³.
    pub(crate) short_noise: Option<[F; 4]>,
}

impl<F: Float> ZeroSearch<'_, F> {
    /// How many half turns of g have passed at φ.
    pub(crate) fn half_turn_at(&self, phi: F) -> F {
        ((phi * self.omega + self.angle) / F::pi() + F::ratio(1, 2)).floor()
    }

    /// The rounding error of f near a zero at φ.
    pub(crate) fn noise_at(&self, phi: F) -> F {
        let least = |x: F, y: F| if x < y { x } else { y };
        let long =
            self.waves.map_or(self.noise, |slide| least(VelocityWaves::of(slide).noise_at(phi), self.noise));
        let Some([a, b, c, d]) = self.short_noise else { return long };
        least(a + phi * (b + phi * (c + phi * d)), long)
    }
}

/// The result for a stretch: a zero, or none with f at the end of the stretch if it was evaluated.
pub(crate) enum Verdict<F, M> {
    Zero(FoundZero<F, M>),
    Clear(Option<(SlideJet<F>, M)>),
    /// A proved bound was exceeded without an answer, at this φ.
    Lost(F),
}
