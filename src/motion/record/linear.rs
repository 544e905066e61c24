//! The linear oscillator `x″ + 2βx′ + ω²x = f(t)` by its impulse response and its integrals.

use super::number::Number;
use alloc::vec::Vec;

/// The impulse response S₁ and its first three integrals at one time: `S₁″ + 2βS₁′ + ω²S₁ = 0`, S₁(0) = 0,
/// S₁′(0) = 1, and S₂, S₃, S₄ the responses to a unit step, a unit ramp and t²/2. As β, ω → 0, `S_n → tⁿ/n!`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Responses<F> {
    pub(super) impulse: F,
    pub(super) step: F,
    pub(super) ramp: F,
    pub(super) parabola: F,
}

/// The constants of a free vibration `g″ + 2βg′ + ω²g = 0`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Law<F> {
    /// 2β.
    pub(super) rate: F,
    /// ω².
    pub(super) square: F,
}

#[cfg(feature = "batch")]
impl<F: Number> Responses<F> {
    /// Those at the time 0.
    pub(super) fn none() -> Self {
        let zero = F::int(0);
        Self { impulse: zero, step: zero, ramp: zero, parabola: zero }
    }
}

impl<F: Number> Law<F> {
    /// The second derivative of a vibration, by its value and its derivative.
    #[inline(always)]
    pub(super) fn next(&self, value: F, derivative: F) -> F {
        -(self.rate * derivative) - self.square * value
    }

    /// The responses at a time, by the sums S₃/t³ and S₄/t⁴ over even and odd powers of t: `S_n = tⁿ/n! − 2βS_{n+1} −
    /// ω²S_{n+2}`, whose terms become smaller.
    #[inline(always)]
    pub(super) fn responses(&self, t: F, [even, odd]: [[F; 2]; 2]) -> Responses<F> {
        let square = t.square();
        let [third, fourth] = [even[0] + t * odd[0], even[1] + t * odd[1]];
        let (ramp, parabola) = (third * (square * t), fourth * square.square());
        let step = square * F::ratio(1, 2) - self.rate * ramp - self.square * parabola;
        let impulse = t - self.rate * step - self.square * ramp;
        Responses { impulse, step, ramp, parabola }
    }
}

/// The constants of a linear oscillator, β ≥ 0 and ω ≥ 0, and the series of its responses.
///
/// Both may be 0: a body without a spring, without a damper. No form here divides by them unless they are
/// large in comparison with 1/t.
#[derive(Debug, Clone)]
pub(super) struct Linear<F> {
    pub(super) law: Law<F>,
    /// Coefficients of S₃/t³ and S₄/t⁴ by powers of t, the highest first, in pairs of an even power and the odd one
    /// after it.
    series: Vec<[[F; 2]; 2]>,
    /// The times up to which the series serves: `2βt + ω²t² ≤ 4`, or the longest step where that is shorter.
    reach: F,
    /// Whether there is neither spring nor damper.
    is_exact: bool,
    pub(super) free: Free<F>,
    /// 1 over the longest time in which a free vibration has one zero at most, and does not fall by more than e⁴ after
    /// it: `max(d/π, λ/4)` with λ the slowest decay, and a margin for rounding.
    ///
    /// The signs at both ends of such a stretch are certain but for swings of some 100 roundings. Without the second
    /// bound, a vibration could vanish, swing far, and decay below the rounding of its value at the end.
    pub(super) shortness: F,
}

/// The free vibration by the sign of `β² − ω²`, with d its square root in magnitude.
#[derive(Debug, Clone, Copy)]
pub(super) enum Free<F> {
    /// `e^{−βt}` times sines of dt.
    Oscillating {
        /// β.
        decay: F,
        /// d = √(ω² − β²) > 0.
        frequency: F,
    },
    /// `e^{−λ₁t}` and `e^{−λ₂t}`, 0 ≤ λ₁ ≤ λ₂.
    Creeping {
        /// λ₁ = ω²/λ₂.
        slow: F,
        /// λ₂ = β + d.
        fast: F,
        /// 2d.
        between: F,
    },
    /// `e^{−βt}` times entire functions of `d²t²`: numbers that are critical, or not, within their bounds. They are taken as
    /// critical.
    Critical {
        /// β.
        decay: F,
        /// β² − ω², around 0.
        square: F,
    },
}

impl<F: Number> Free<F> {
    /// λ₁ and λ₂ of a vibration that creeps.
    pub(super) fn rates(&self) -> Option<[F; 2]> {
        match *self {
            Self::Oscillating { .. } => None,
            Self::Creeping { slow, fast, .. } => Some([slow, fast]),
            Self::Critical { decay, .. } => Some([decay; 2]),
        }
    }
}

impl<F: Number> Linear<F> {
    /// The oscillator with 2β = `rate` and ω² = `square`, for any time; with a `longest` one, its series has no more
    /// terms than that needs.
    pub(super) fn new(rate: F, square: F, longest: Option<F>) -> Option<Self> {
        let (half, two, four) = (F::ratio(1, 2), F::int(2), F::int(4));
        let (beta, omega) = (rate * half, square.sqrt());
        let difference = (beta - omega) * (beta + omega);
        // Critical but for the rounding of its numbers is critical.
        let is_critical = F::is_lost(difference.abs(), beta.square());
        let free = if !is_critical && difference.negative().is_none() {
            // Of a critical one d is small; otherwise nothing is known.
            let most = beta.square() * F::ratio(1, 1 << 20);
            (most - difference.abs()).positive().filter(|is_small| *is_small)?;
            Free::Critical { decay: beta, square: difference }
        } else if !is_critical && difference.negative()? {
            Free::Oscillating { decay: beta, frequency: (-difference).sqrt() }
        } else {
            let d = if is_critical { F::int(0) } else { difference.sqrt() };
            let fast = beta + d;
            let slow = if fast.positive()? { square / fast } else { F::int(0) };
            Free::Creeping { slow, fast, between: two * d }
        };
        // The positive root of ω²t² + 2βt = 4.
        let root = beta + (beta.square() + four * square).sqrt();
        let reach = match longest {
            Some(longest) if !(root * longest - four).positive()? => longest,
            // Without spring and damper the first term is the whole series.
            _ if root.positive()? => four / root,
            _ => F::int(1),
        };
        let is_exact = !root.positive()?;
        // y_j t^j with u₀ = 1, u₁ = −2β, u_{j+1} = −2βu_j − ω²u_{j−1} is the series of S₁/t; |u_j tʲ| ≤ pʲ with
        // p = 2βt + ω²t² where that is ≥ 1, and p^{j/2} below.
        let mut series = Vec::new();
        let (mut last, mut now) = (F::int(0), F::int(1));
        let (mut third, mut fourth) = (F::ratio(1, 6), F::ratio(1, 24));
        let size = rate * reach + square * reach.square();
        let growth = size.larger(size.sqrt());
        let mut bound = F::int(1);
        for j in 0..F::MOST_TERMS {
            series.push([now * third, now * fourth]);
            (last, now) = (now, -(rate * now + square * last));
            third = third / F::int(j.saturating_add(4));
            fourth = fourth / F::int(j.saturating_add(5));
            bound = bound * growth / F::int(j.saturating_add(4));
            if is_exact || F::is_negligible(bound) {
                break;
            }
        }
        if let (false, Some(first)) = (is_exact, series.first_mut()) {
            // The terms left out are at most a third of the bound: the first is a sixth, and each is less than half of
            // the one before.
            *first = first.map(|term| term.widened(bound));
        }
        if series.len() % 2 == 1 {
            series.push([F::int(0); 2]);
        }
        let mut series: Vec<_> = series.chunks_exact(2).filter_map(|pair| pair.try_into().ok()).collect();
        series.reverse();
        let shortness = match free {
            // A margin of 1/64 leaves the rounding of the length out of the proof.
            Free::Oscillating { decay, frequency } => {
                (frequency / F::pi() * F::ratio(65, 64)).larger(decay * F::ratio(1, 4))
            }
            Free::Creeping { slow, .. } => slow * F::ratio(1, 4),
            // Up to d = β/2¹⁰ this is above d/π.
            Free::Critical { decay, .. } => decay * F::ratio(1, 4),
        };
        Some(Self { law: Law { rate, square }, series, reach, is_exact, free, shortness })
    }

    /// The responses at a time t ≥ 0.
    #[inline(always)]
    pub(super) fn at(&self, t: F) -> Option<Responses<F>> {
        if self.is_exact || t.is_within(self.reach)? { Some(self.near(t)) } else { self.far(t) }
    }

    /// The longest step of a search over a length whose error Halley's estimate bounds: an eighth of the reach, over which
    /// a derivative changes by √e at most. Within the reach it changes by e⁴ at most, which the
    /// estimate tolerates.
    pub(super) fn longest_step(&self, length: F) -> Option<F> {
        (!self.is_near(length)).then(|| self.reach * F::ratio(1, 8))
    }

    /// Whether the series serves times up to this one.
    pub(super) fn is_near(&self, t: F) -> bool {
        self.is_exact || t.is_within(self.reach) == Some(true)
    }

    /// The coefficients of S₃/t³ and S₄/t⁴ in pairs of an even power of t and the odd one after it, the highest first.
    #[cfg(feature = "batch")]
    pub(super) fn series(&self) -> &[[[F; 2]; 2]] {
        &self.series
    }

    /// The responses by their series.
    #[inline(always)]
    pub(super) fn near(&self, t: F) -> Responses<F> {
        let square = t.square();
        let mut sums = [[F::int(0); 2]; 2];
        for pair in &self.series {
            for (sum, terms) in sums.iter_mut().zip(pair) {
                for (sum, term) in sum.iter_mut().zip(terms) {
                    *sum = *sum * square + *term;
                }
            }
        }
        self.law.responses(t, sums)
    }

    /// The responses in closed form, where `2βt + ω²t² > 4`.
    #[cold]
    fn far(&self, t: F) -> Option<Responses<F>> {
        Some(match self.free {
            Free::Oscillating { decay, frequency } => {
                let (sine, cosine) = (frequency * t).sin_cos();
                let size = (-(decay * t)).exponential();
                self.of_waves(t, decay, [size * cosine, size * sine / frequency])
            }
            Free::Critical { decay, square } => {
                let [cosine, sine] = (square * t.square()).hyperbolic();
                let size = (-(decay * t)).exponential();
                self.of_waves(t, decay, [size * cosine, size * (t * sine)])
            }
            // S_n is a divided difference of eᶻᵗ at −λ₁, −λ₂ and n − 1 times 0.
            Free::Creeping { slow, fast, between } => {
                let [first, second, third] = growth(slow * t)?.map(|phi| phi * t);
                let impulse = (-(slow * t)).exponential() * growth(between * t)?[0] * t;
                let step = (first - impulse) / fast;
                let ramp = (second * t - step) / fast;
                let parabola = (third * t.square() - ramp) / fast;
                Responses { impulse, step, ramp, parabola }
            }
        })
    }

    /// The responses at t by `e^{−βt} cos dt` and the impulse `e^{−βt} sin(dt)/d`.
    fn of_waves(&self, t: F, decay: F, [cosine, impulse]: [F; 2]) -> Responses<F> {
        let Law { rate, square } = self.law;
        let free = cosine - decay * impulse;
        let step = (F::int(1) - free - rate * impulse) / square;
        let ramp = (t - impulse - rate * step) / square;
        let parabola = (t.square() * F::ratio(1, 2) - step - rate * ramp) / square;
        Responses { impulse, step, ramp, parabola }
    }
}

/// φ₁, φ₂, φ₃ at −z, z ≥ 0: `φ₁ = (1 − e^{−z})/z`, `φ_{n+1} = (1/n! − φ_n)/z`.
pub(super) fn growth<F: Number>(z: F) -> Option<[F; 3]> {
    let one = F::int(1);
    if !z.is_within(one)? {
        let first = (one - (-z).exponential()) / z;
        let second = (one - first) / z;
        return Some([first, second, (F::ratio(1, 2) - second) / z]);
    }
    // φ₃ by its series, the others from it.
    let (mut term, mut third) = (F::ratio(1, 6), F::int(0));
    for j in 4..F::MOST_TERMS {
        third = third + term;
        if F::is_negligible(term) {
            break;
        }
        term = -(term * z) / F::int(j);
    }
    // The terms alternate and fall, so that those left out are less than the last one.
    let third = third.widened(term);
    let second = F::ratio(1, 2) - z * third;
    Some([one - z * second, second, third])
}
