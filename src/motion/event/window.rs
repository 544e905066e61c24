//! Intervals in which the velocity of a damped slide cannot vanish, and which the search skips.
//!
//! Turned to the sign of the slide, the velocity is a forced wave and a free one, `f = G cos ψ + h`,
//! ψ = ψ_0 + Ωφ, and from any φ on the free one keeps below a falling exponential, `|h(φ + t)| ≤ r e^{−βt}`:
//!
//! ```text
//! r = hypot(h, (h′ + ζh)/d),   β = ζ             for ζ < 1/2
//! r = |h| + |h′ + σh| · 3/(4σ),  β = σ/2          above, by sin(dt)/d ≤ t and t e^{−σt/2} ≤ 2/(eσ)
//! ```
//!
//! with σ the slower rate of decay, ζ below 1 and ζ − √(ζ² − 1) above. Two windows follow, both known by
//! their two ends:
//!
//! * **The forced wave is larger**, `G cos ψ > r e^{−βt}`, on the half wave with cos ψ > 0: a concave
//!   function less a convex one, positive at both ends and so between them.
//! * **The free wave is larger**, `h > G`: h is the product of an exponential and a positive half wave, whose
//!   logarithm is concave, or from ζ = 1 on has one extremum at most and tends to zero; either way h > G at
//!   both ends of less than π/d means h > G between them.
//!
//! The far end of a window is found from inside, to within a fraction of the shorter period. If the free wave
//! is larger, the remaining time before the next zero is at most a period of the drive. If the forced wave is
//! larger, it is the time in which the free wave, at its lowest once in 2π/d, is not below the forced one. A
//! slide therefore needs a few windows and a few stretches at any Ω and ζ.

use crate::cycle::damped::free::Free;
use crate::float::Float;
use crate::motion::slide::Slide;
use crate::motion::slide::equation::Equation;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The two waves of a slide's velocity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct VelocityWaves<F> {
    equation: Equation<F>,
    free: Free<F>,
    /// The amplitude G of the forced wave.
    gain: F,
    /// The phase ψ of the forced wave at φ = 0.
    angle: F,
    /// The free wave h and its rate h′ at φ = 0.
    start: (F, F),
    /// |x′| and |x″| at φ = 0: the sizes of the terms of h and h′ other than the forced wave.
    size: (F, F),
    /// The slower rate of decay σ and the exponent β of the bound.
    rates: (F, F),
}

impl<F: Float> VelocityWaves<F> {
    /// The waves of a slide with damping.
    #[cold]
    #[inline(never)]
    pub(crate) fn of(slide: &Slide<F>) -> Self {
        let equation = slide.equation;
        let (one, two) = (F::int(1), F::int(2));
        let (omega, sign) = (equation.omega, slide.direction.sign::<F>());
        let free = equation.vibration();
        let (real, imaginary) = equation.stiffness();
        let gain = equation.alpha * omega / real.hypot(imaginary);
        let (sine, cosine) = slide.sin_cos_start();
        let (x, w) = equation.forced((sine, cosine));
        // F′ = −Ω² x
        let start = (sign * (slide.w - w), sign * (slide.acceleration + omega.square() * x));
        let angle = (sign * omega * x).atan2(sign * w);
        let size = (slide.w.abs(), slide.acceleration.abs());
        let slower = if free.swings() { free.zeta } else { free.slow_rate() };
        let decay = if free.zeta * two < one { free.zeta } else { slower / two };
        Self { equation, free, gain, angle, start, size, rates: (slower, decay) }
    }

    /// The rounding error of the velocity at φ, from the free vibrations at φ; the rounding error of the start
    /// decays like them.
    fn noise_of(&self, phi: F, rotation: (F, F)) -> F {
        let phase = F::int(16) * F::epsilon() * self.equation.omega * (F::int(1) + phi) * self.gain;
        self.free_noise(phi, rotation) + phase
    }

    /// The rounding errors of h and G at φ, without the error of the phase of the forced wave.
    fn free_noise(&self, phi: F, (s, c): (F, F)) -> F {
        let (speed, acceleration) = self.size;
        let (speed, acceleration) = (speed + self.gain, acceleration + self.equation.omega * self.gain);
        let free = (c.abs() * speed + s.abs() * acceleration) * (F::int(1) + self.turned(phi));
        F::int(16) * F::epsilon() * (free + self.gain)
    }

    /// The angle dφ, or the exponent σφ: accurate to ε, relative.
    fn turned(&self, phi: F) -> F {
        if self.free.swings() { phi } else { self.rates.0 * phi }
    }

    /// The rounding error of the velocity at φ.
    #[cold]
    #[inline(never)]
    pub(crate) fn noise_at(&self, phi: F) -> F {
        self.noise_of(phi, self.equation.free_waves(phi))
    }

    /// The bound r on the free wave, from h and h′.
    fn bound(&self, (h, rate): (F, F)) -> F {
        let (slower, decay) = self.rates;
        let turned = rate + slower * h;
        if decay == slower {
            return h.hypot(turned / self.free.frequency);
        }
        h.abs() + turned.abs() * F::ratio(3, 4) / slower
    }

    /// The end of the window that contains φ, if there is one longer than a stretch.
    #[cold]
    #[inline(never)]
    pub(crate) fn end(&self, phi: F) -> Option<F> {
        let (one, two, four) = (F::int(1), F::int(2), F::int(4));
        let Equation { omega, .. } = self.equation;
        let rotation = self.equation.free_waves(phi);
        let now = self.equation.freely(phi, rotation, self.start);
        let noise = self.noise_of(phi, rotation);
        let r = self.bound(now) + noise;
        let decay = self.rates.1;
        let psi = self.angle + omega * phi;
        let psi = psi - two * F::pi() * (psi / (two * F::pi())).round();
        let quarter = F::pi() / two;
        if self.gain * psi.cos() > r + noise && psi < quarter {
            let end = self.forced_end(psi, r, noise);
            return (end > one).then(|| phi + end);
        }
        // At any phase the forced wave is at most G.
        let noise = self.free_noise(phi, rotation);
        if now.0 > self.gain + noise {
            let far = if self.free.swings() {
                // The half wave ends at h = 0.
                let (h, rate) = now;
                let d = self.free.frequency;
                (d * h).atan2(-(rate + self.free.zeta * h)) / d
            } else {
                // r e^{−βt} ≤ noise: e^{−y} < 2⁻ⁿ for y > n.
                let digits = F::int(2) * F::from_f64(f64::from(F::precision()));
                digits / decay
            };
            let clear = |t: F| {
                let (s, c) = self.equation.free_waves(t);
                let (h, _) = self.equation.freely(t, (s, c), now);
                let terms = (now.0 * c).abs() + (now.1 * s).abs();
                let rounding = F::int(16) * F::epsilon() * (one + self.turned(t)) * terms;
                h - self.gain - noise - rounding
            };
            let end = inner_end(far, one / (four * omega), clear)?;
            return (end > one / omega).then(|| phi + end);
        }
        None
    }

    /// A lower bound of the time from ψ during which the forced wave stays above `r e^{−βt}` and `noise`, if
    /// it does at first: the time until it decreases to the bound at the previous time.
    fn forced_end(&self, psi: F, r: F, noise: F) -> F {
        let (one, two) = (F::int(1), F::int(2));
        let mut end = F::int(0);
        for _ in 0..MOST_ADVANCES {
            let fall = if end > F::int(0) { (-(self.rates.1 * end)).exp() } else { one };
            // The noise is added a second time for the rounding of the angle.
            let least = (r * fall + two * noise) / self.gain;
            let is_above = least < one;
            if !is_above {
                break;
            }
            let next = (((one - least) * (one + least)).sqrt().atan2(least) - psi) / self.equation.omega;
            let gained = next - end;
            end = end.or_larger(next);
            if gained * F::int(4) <= one {
                break;
            }
        }
        end
    }

    /// The longest duration of a slide. At two instants π/d apart the free wave cancels, and from ζ = 1/2 on
    /// it is below half of the forced wave after a time; in both cases the forced wave then changes its sign
    /// within half a turn of the drive. One more turn allows for rounding.
    #[cold]
    #[inline(never)]
    pub(crate) fn longest(&self) -> F {
        let turns = F::int(3) * F::pi() / self.equation.omega;
        let swing = if self.free.swings() { F::pi() / self.free.frequency } else { F::int(1) / F::int(0) };
        // ln(2r/G)/β; the logarithm at f64 and rounded up.
        let ratio = F::int(2) * self.bound(self.start) / self.gain;
        let fall = F::from_f64(ratio.to_f64().max(1.0).ln() + 1.0) / self.rates.1;
        turns + if swing < fall { swing } else { fall }
    }
}

/// The greatest number of steps towards the end of a window of the forced wave; the rest becomes another
/// window.
const MOST_ADVANCES: u32 = 8;

/// The last t with f(t) > 0 before `far`, for an f that is positive from 0 on up to one zero: approached from
/// below to within `close`.
///
/// The bracket shrinks by false position with the weight of a retained end halved (the Illinois rule), and at
/// least halves in three steps.
fn inner_end<F: Float>(far: F, close: F, f: impl Fn(F) -> F) -> Option<F> {
    let (zero, two) = (F::int(0), F::int(2));
    let (mut low, mut high) = (zero, far);
    let (mut at_low, mut at_high) = (f(low), f(high));
    if at_high > zero {
        return Some(high);
    }
    // NaN does not count as above zero.
    let is_above = at_low > zero;
    if !is_above {
        return None;
    }
    let (mut side, mut width) = (0, high - low);
    for step in 1..=F::precision().saturating_mul(4) {
        if high - low <= close || high - low <= F::int(64) * F::epsilon() * high {
            break;
        }
        let mut t = low + (high - low) * (at_low / (at_low - at_high));
        if step % 3 == 0 {
            if (high - low) * two > width {
                t = low + (high - low) / two;
            }
            width = high - low;
        }
        if !(t > low && t < high) {
            t = low + (high - low) / two;
        }
        let value = f(t);
        if value > zero {
            if side > 0 {
                at_high = at_high / two;
            }
            (low, at_low, side) = (t, value, 1);
        } else {
            if side < 0 {
                at_low = at_low / two;
            }
            (high, at_high, side) = (t, value, -1);
        }
    }
    Some(low)
}
