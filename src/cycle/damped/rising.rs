//! The half cycle with x′ > 0, from the minimum of x (τ = 0) to its maximum (τ = T = π/Ω), in natural time.
//!
//! ```text
//! x = −1 − a cos Ωτ − H sin Ωτ + h,    x′ = aΩ sin Ωτ − b cos Ωτ + h′,    b = ΩH,
//! ```
//!
//! h being free vibration from `(1 + G, b)`, a = √((α/q)² − H²).

use super::free::{Free, FreeState, Waves};
use super::half_period::HalfPeriod;
use super::resonance::Responses;
use crate::cycle::phase_function::one_minus_square_wide;
use crate::float::pair::Pair;
use crate::float::{Field, Float, Signed};

/// One half cycle: the half period and the amplitude a.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rising<F> {
    pub(crate) half: HalfPeriod<F>,
    /// a.
    pub(crate) amplitude: F,
    /// Δ₀/B = a − G, which is not computed as a difference because both are large near Ω = 1.
    pub(crate) max_displacement: F,
    /// What rounding took from Δ₀/B.
    pub(crate) rest: F,
}

/// The half cycle at one time: sine and cosine of Ωτ, and the free vibration.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moment<F> {
    pub(crate) tau: F,
    pub(crate) drive: (F, F),
    pub(crate) waves: Waves<F>,
    pub(crate) free: FreeState<F>,
}

impl<N: Signed> HalfPeriod<N> {
    /// The parts of the half cycle at τ in [0, T] that do not depend on the amplitude.
    #[inline]
    pub(crate) fn at(&self, tau: N) -> Moment<N> {
        let waves = self.free.waves(tau);
        let free = self.free.after(waves, N::int(1) + self.shift, self.omega * self.h);
        Moment { tau, drive: (self.omega * tau).sin_cos(), waves, free }
    }
}

impl<F: Float> HalfPeriod<F> {
    /// The moment at T − u, by free vibration back from `(1 − G, −b)`; for ζ < 1.
    pub(crate) fn before_end(&self, u: F) -> Moment<F> {
        let waves = self.free.waves(-u);
        let free = self.free.after(waves, F::int(1) - self.shift, -(self.omega * self.h));
        let (s, c) = (self.omega * u).sin_cos();
        Moment { tau: self.period - u, drive: (s, -c), waves, free }
    }
}

/// A driven and a free vibration: the velocity of any slide.
///
/// ```text
/// x′ = Ω(a sin Ωτ − H cos Ωτ) + h′,   h from (h_0, h_0′)
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Vibration<F> {
    pub(crate) free: Free<F>,
    pub(crate) omega: F,
    /// a and H.
    pub(crate) driven: (F, F),
    /// `h_0` and `h_0′`.
    pub(crate) start: (F, F),
    /// How long it lasts.
    pub(crate) end: F,
    /// Where both parts nearly cancel, x and x′ at the start: there they are computed as one, which takes the
    /// place of the free part.
    pub(crate) whole: Option<(F, F)>,
}

impl<F: Float> Vibration<F> {
    /// Converts each part to another number type.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Vibration<G> {
        Vibration {
            free: self.free.map(&to),
            omega: to(self.omega),
            driven: (to(self.driven.0), to(self.driven.1)),
            start: (to(self.start.0), to(self.start.1)),
            end: to(self.end),
            whole: self.whole.map(|(x, v)| (to(x), to(v))),
        }
    }

    /// The vibration at τ ≥ 0.
    #[inline]
    pub(crate) fn at(&self, tau: F) -> Moment<F> {
        if let Some(start) = self.whole {
            return self.whole_at(tau, start);
        }
        let waves = self.free.waves(tau);
        let free = self.free.after(waves, self.start.0, self.start.1);
        Moment { tau, drive: (self.omega * tau).sin_cos(), waves, free }
    }
}

impl<F: Field> Vibration<F> {
    /// The contribution of the drive alone to `x′/(B ω_n)`, and to its derivative.
    #[inline(always)]
    pub(crate) fn driven(&self, at: &Moment<F>) -> (F, F) {
        if self.whole.is_some() {
            return (F::int(0), F::int(0));
        }
        let ((s, c), omega, (a, h)) = (at.drive, self.omega, self.driven);
        (omega * (a * s - h * c), omega.square() * (a * c + h * s))
    }

    /// `x′/(B ω_n)` and its first two derivatives by τ.
    #[inline(always)]
    pub(crate) fn velocity(&self, at: &Moment<F>) -> [F; 3] {
        let (value, slope) = self.driven(at);
        let curvature = -(self.omega.square() * value);
        [value + at.free.v, slope + at.free.a, curvature + at.free.jerk]
    }
}

impl<F: Float> Vibration<F> {
    /// `Ω√(a² + H²)`, the velocity amplitude of the drive alone; if it is resonant, a bound of its
    /// contribution.
    pub(crate) fn swing(&self) -> F {
        if self.whole.is_some() {
            return self.driven_bound();
        }
        self.omega * self.driven.0.hypot(self.driven.1)
    }
}

impl<F: Field> Vibration<F> {
    /// The drive `f_c cos Ωτ + f_s sin Ωτ` that keeps the driven part `−a cos Ωτ − H sin Ωτ` up:
    /// `(f_c, f_s)`.
    pub(crate) fn force(&self) -> (F, F) {
        let (one, two) = (F::int(1), F::int(2));
        let (real, imaginary) = ((one - self.omega) * (one + self.omega), two * self.free.zeta * self.omega);
        let (a, h) = self.driven;
        (-(a * real + h * imaginary), a * imaginary - h * real)
    }
}

impl<F: Float> Vibration<F> {
    /// The whole vibration at τ from (x₀, v₀), and by the drive: it takes the place of the free part, and the
    /// driven part is none.
    fn whole_at(&self, tau: F, (x0, v0): (F, F)) -> Moment<F> {
        let (two, zeta, omega) = (F::int(2), self.free.zeta, self.omega);
        let Responses { free: (sine, cosine), drive, c, s, d, .. } = Responses::new(omega, &self.free, tau);
        let (along, across) = self.force();
        let x = x0 * cosine + v0 * sine + along * c + across * s;
        let v = v0 * (cosine - two * zeta * sine) - x0 * sine + along * d + across * omega * c;
        // x″ = f − x − 2ζx′, and its derivatives.
        let force = along * drive.1 + across * drive.0;
        let rate = omega * (across * drive.1 - along * drive.0);
        let a = force - x - two * zeta * v;
        let jerk = rate - v - two * zeta * a;
        let snap = -(omega.square() * force) - a - two * zeta * jerk;
        let waves = Waves { cosine: cosine - zeta * sine, sine };
        Moment { tau, drive, waves, free: FreeState { x, v, a, jerk, snap } }
    }

    /// A bound of the drive's contribution to any of these in half a period, for any number of derivatives by
    /// Ωτ: 2π times its amplitude, and a further factor 1/Ω for Ω < 1.
    ///
    /// x′ obeys the equation of motion with the right side f′: the size √(x′² + x″²) grows by no more than
    /// Ω|f| in a unit of time, and so on.
    fn driven_bound(&self) -> F {
        let (along, across) = self.force();
        let bound = F::int(2) * F::pi() * along.hypot(across);
        bound.or_larger(bound / self.omega)
    }
}

impl<F: Field> Rising<F> {
    /// The half cycle of amplitude a.
    pub(crate) fn new(half: HalfPeriod<F>, amplitude: F) -> Self {
        Self { half, amplitude, max_displacement: amplitude - half.shift, rest: F::int(0) }
    }

    /// Converts each part of the rising half to another number type.
    pub(crate) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Rising<G> {
        Rising {
            amplitude: to(self.amplitude),
            max_displacement: to(self.max_displacement),
            rest: to(self.rest),
            half: self.half.map(to),
        }
    }

    /// The half cycle as a vibration.
    #[inline(always)]
    pub(crate) fn vibration(&self) -> Vibration<F> {
        let half = &self.half;
        Vibration {
            free: half.free,
            omega: half.omega,
            driven: (self.amplitude, half.h),
            start: (F::int(1) + half.shift, half.omega * half.h),
            end: half.period,
            whole: half.is_resonant.then(|| (F::int(1) - self.max_displacement, F::int(0))),
        }
    }

    /// The contribution of the drive alone to `x′/(B ω_n)`, and to its derivative.
    #[inline(always)]
    pub(crate) fn driven(&self, at: &Moment<F>) -> (F, F) {
        self.vibration().driven(at)
    }

    /// `x′/(B ω_n)` and its first two derivatives by τ.
    #[inline(always)]
    pub(crate) fn velocity(&self, at: &Moment<F>) -> [F; 3] {
        self.vibration().velocity(at)
    }

    /// `Ω√(a² + H²) = Ωα/q`, the velocity amplitude of the drive alone.
    pub(crate) fn swing(&self) -> F {
        self.half.omega * self.amplitude.hypot(self.half.h)
    }
}

impl<F: Float> Rising<F> {
    /// The drive `f_c cos Ωτ + f_s sin Ωτ` that keeps the driven part up, to all digits: `(f_c, f_s)`.
    #[inline(always)]
    pub(crate) fn drive(&self) -> (Pair<F>, Pair<F>) {
        let HalfPeriod { omega, free, shift, h, rest: [_, shift_rest, h_rest], .. } = self.half;
        let a = Pair::new(self.max_displacement, self.rest) + Pair::new(shift, shift_rest);
        let (h, damper) = (Pair::new(h, h_rest), (free.zeta.wide() * omega).times(2));
        let stiffness = one_minus_square_wide(omega);
        (-(a * stiffness + h * damper), a * damper - h * stiffness)
    }

    /// The half cycle at τ in [0, T].
    #[inline]
    pub(crate) fn at(&self, tau: F) -> Moment<F> {
        self.vibration().at(tau)
    }

    /// x/B.
    ///
    /// `h − 1 = G − (1 + G)(1 − c) + b s`, c and s free vibration from (1, 0) and (0, 1): far above Ω = 1 each
    /// term is small ([`Free::step_response`]).
    pub(crate) fn displacement(&self, at: &Moment<F>) -> F {
        if self.half.is_resonant {
            return at.free.x - F::int(1);
        }
        let (s, c) = at.drive;
        self.free_displacement(at) - self.amplitude * c - self.half.h * s
    }

    /// x/B where x″/(B ω_n²) is small and known: `−a cos Ωτ − H sin Ωτ = (h″ − x″)/Ω²`, so that the drive
    /// drops out.
    pub(super) fn displacement_by(&self, at: &Moment<F>, acceleration: F) -> F {
        if self.half.is_resonant {
            return at.free.x - F::int(1);
        }
        self.free_displacement(at) + (at.free.a - acceleration) / self.half.omega.square()
    }

    /// h − 1.
    fn free_displacement(&self, at: &Moment<F>) -> F {
        let (half, sine) = (&self.half, at.waves.sine);
        let fall = (F::int(1) + half.shift) * half.free.step_response(at.tau, sine);
        half.shift - fall + half.omega * half.h * sine
    }
}
