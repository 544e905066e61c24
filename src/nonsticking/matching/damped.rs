//! The matching equations 21–25 with viscous damping, solved by Newton's method without the closed forms.
//!
//! In natural time and lengths of the drive's static displacement, with `F(θ) = P sin θ − Q cos θ` the linear
//! oscillator's answer (`P = (1 − Ω²)/q²`, `Q = 2ζΩ/q²`), friction b and the free vibrations s, c from (x,
//! x′) = (0, 1) and (1, 0), the rising half cycle is
//!
//! ```text
//! x₁ = F − b + X c(τ) + ρ s(τ),   X = Δ₁ + b − F(θ₁),   ρ = V₀ − F′(θ₁),   τ = (θ − θ₁)/Ω
//! ```
//!
//! from t₁ on, and the falling one from t₂ on `x₂ = F + b + (Δ₀ − b − F(θ₂)) c − F′(θ₂) s`. Eq. 21–25 are
//! then
//!
//! ```text
//! x₁′(t₂) = 0,   x₂′(t₃) = −V₀,   x₁(t₂) = Δ₀,   x₂(t₃) = −Δ₁,   x₁″(t₁) = 0,
//! ```
//!
//! the second and the fourth being the paper's, followed forward from t₂ to t₃ = t₁ + π/ω_d and not backward,
//! where a free vibration would grow.
//!
//! The friction grows from zero, where `x = F`, to its value at f64; where eq. 25 has several roots the
//! fastest instant on a grid is taken. A path may end at a fold: then there is no cycle with that friction.

use super::Unknowns;
use super::step::{
    MatchingError, Solution, in_order, iterate, largest, most_iterations, newton_step, positive, unknowns,
};
use crate::error::written;
use crate::float::{Field, Float, Real};
use crate::nonsticking::damped::free::{self, Free};
use crate::ratios::Ratios;
use nalgebra::RealField;

/// The parameters of the equations; lengths are in units of p₀/k.
#[derive(Debug, Clone, Copy)]
pub(crate) struct System<F> {
    omega: F,
    free: Free<F>,
    /// P and Q.
    forced: (F, F),
    /// b = r_y/p₀.
    friction: F,
}

/// The free vibrations (s, c) from (0, 1) and (1, 0) at one time, and the slope of s.
#[derive(Clone, Copy)]
struct Waves<F> {
    s: F,
    c: F,
    slope: F,
}

impl<F: Field> Waves<F> {
    /// From `e^{−ζt} cos dt` and `e^{−ζt} sin(dt)/d`.
    fn of(at: free::Waves<F>, zeta: F) -> Self {
        let turned = zeta * at.sine;
        Self { s: at.sine, c: at.cosine + turned, slope: at.cosine - turned }
    }

    /// Displacement, velocity and acceleration from (x, w).
    fn from(&self, (x, w): (F, F), damping: F) -> [F; 3] {
        let (to, rate) = (x * self.c + w * self.s, w * self.slope - x * self.s);
        [to, rate, -(to + damping * rate)]
    }
}

impl<F: Real> System<F> {
    pub(crate) fn new(omega: F, zeta: F, friction: F) -> Self {
        let (spring, damper) = ((F::int(1) - omega) * (F::int(1) + omega), F::int(2) * zeta * omega);
        let square = spring.square() + damper.square();
        Self { omega, free: Free::new(zeta), forced: (spring / square, damper / square), friction }
    }

    fn damping(&self) -> F {
        F::int(2) * self.free.zeta
    }

    /// F and F′ at θ.
    fn forced_at(&self, theta: F) -> (F, F) {
        let ((sine, cosine), (p, q)) = (theta.sin_cos(), self.forced);
        (p * sine - q * cosine, self.omega * (p * cosine + q * sine))
    }

    /// Eq. 21–25: left less right, and the derivatives by t₁, t₂, V₀, Δ₀, Δ₁; by free vibration after a time.
    pub(crate) fn equations_by(
        &self,
        u: &Unknowns<F>,
        waves: impl Fn(&Free<F>, F) -> free::Waves<F>,
    ) -> ([F; 5], [[F; 5]; 5]) {
        let (zero, one, omega, damping) = (F::int(0), F::int(1), self.omega, self.damping());
        let (f1, g1) = self.forced_at(u.velocity_phase);
        let (f2, g2) = self.forced_at(u.displacement_phase);
        let tau = (u.displacement_phase - u.velocity_phase) / omega;
        let after = |t: F| Waves::of(waves(&self.free, t), self.free.zeta);
        let (near, far) = (after(tau), after(F::pi() / omega - tau));
        // From t₁ to t₂, with the influence of t₁ on the start: F′ = dF/dφ, dθ = Ω dφ.
        let [x, w, a] = near.from((u.deviation + self.friction - f1, u.max_velocity - g1), damping);
        let [dx1, dw1, _] = near.from((-(g1 / omega), omega * f1), damping);
        // From t₂ to t₃, with the influence of t₂.
        let [y, v, b] = far.from((u.max_displacement - self.friction - f2, -g2), damping);
        let [dy2, dv2, _] = far.from((-(g2 / omega), omega * f2), damping);
        let (sine, cosine) = u.velocity_phase.sin_cos();
        let residuals = [
            g2 + w,
            v - g1 + u.max_velocity,
            f2 - self.friction + x - u.max_displacement,
            self.friction - f1 + y + u.deviation,
            sine - u.deviation - self.friction - damping * u.max_velocity,
        ];
        let jacobian = [
            [dw1 - a / omega, a / omega - omega * f2, near.slope, zero, -near.s],
            [b / omega + omega * f1, dv2 - b / omega, one, -far.s, zero],
            [dx1 - w / omega, (g2 + w) / omega, near.s, -one, near.c],
            [(v - g1) / omega, dy2 - v / omega, zero, far.c, one],
            [cosine, zero, -damping, zero, -one],
        ];
        (residuals, jacobian)
    }

    /// Displacement and velocity of the falling half at the phase since t₂, by free vibration after a time.
    pub(crate) fn falling_by(
        &self,
        u: &Unknowns<F>,
        turn: F,
        waves: impl Fn(&Free<F>, F) -> free::Waves<F>,
    ) -> (F, F) {
        let (f2, g2) = self.forced_at(u.displacement_phase);
        let start = (u.max_displacement - self.friction - f2, -g2);
        let (f, g) = self.forced_at(u.displacement_phase + turn);
        let after = Waves::of(waves(&self.free, turn / self.omega), self.free.zeta);
        let [x, w, _] = after.from(start, self.damping());
        (f + self.friction + x, g + w)
    }
}

impl<F: Float> System<F> {
    /// Eq. 21–25: left less right, and the derivatives by t₁, t₂, V₀, Δ₀, Δ₁.
    pub(crate) fn equations(&self, u: &Unknowns<F>) -> ([F; 5], [[F; 5]; 5]) {
        self.equations_by(u, Free::waves)
    }

    /// Displacement and velocity of the falling half at the phase since t₂.
    pub(crate) fn falling(&self, u: &Unknowns<F>, turn: F) -> (F, F) {
        self.falling_by(u, turn, Free::waves)
    }

    /// The same cycle with t₁ at the fastest instant of a grid over the rising half, where that is faster.
    fn faster(&self, u: &Unknowns<F>, per_swing: f64) -> Option<Unknowns<F>> {
        let two = F::int(2);
        // The falling half is the rising one with the opposite sign, half a turn later.
        let first = u.displacement_phase - F::pi();
        let at = |phase: F| {
            let (x, w) = self.falling(u, phase - first);
            (-w, -x)
        };
        let points = 8 + (per_swing / self.omega.to_f64()).min(1e6) as i32;
        let noise = F::int(1024) * F::epsilon() * (F::int(1) + F::int(1) / self.omega);
        let inside = u.velocity_phase > first && u.velocity_phase < u.displacement_phase;
        let before = if inside { at(u.velocity_phase).0 } else { F::int(0) };
        let mut best = None;
        let mut most =
            before + noise * u.max_velocity.abs().or_larger(two * self.forced.0.hypot(self.forced.1));
        for i in 1..points {
            let phase = first + F::pi() * F::ratio(i, points);
            let (velocity, deviation) = at(phase);
            if velocity > most {
                most = velocity;
                best = Some(Unknowns { velocity_phase: phase, max_velocity: velocity, deviation, ..*u });
            }
        }
        best
    }

    /// The motion without friction, `x = F`.
    fn without_friction(&self) -> Unknowns<F> {
        let (p, q) = self.forced;
        let (lag, amplitude) = (q.atan2(p), p.hypot(q));
        Unknowns {
            velocity_phase: lag,
            displacement_phase: lag + F::pi() / F::int(2),
            max_velocity: self.omega * amplitude,
            max_displacement: amplitude,
            deviation: F::int(0),
        }
    }

    fn at_less(&self) -> System<f64> {
        System {
            friction: self.friction.to_f64(),
            ..System::new(self.omega.to_f64(), self.free.zeta.to_f64(), 0.0)
        }
    }
}

/// A step in friction, relative to the requested friction, must move no phase further than this.
const LONGEST: f64 = 0.2;

/// The cycle at f64 with all of its friction; the part of it where the path ends otherwise.
fn path(whole: &System<f64>) -> Result<Unknowns<f64>, f64> {
    let mut at = whole.without_friction();
    let (mut part, mut length) = (0.0, 1.0);
    for _ in 0..4000 {
        if part >= 1.0 {
            return Ok(at);
        }
        let next = if part + length < 1.0 { part + length } else { 1.0 };
        let system = System { friction: whole.friction * next, ..*whole };
        match settled(&system, &at) {
            Some(found) => {
                at = system.faster(&found, 32.0).and_then(|u| settled(&system, &u)).unwrap_or(found);
                (part, length) = (next, length * 1.5);
            }
            None => length /= 2.0,
        }
        if length < 1e-13 {
            break;
        }
    }
    Err(part)
}

/// Newton's method from a cycle with a little less friction: `None` where it does not settle close by.
fn settled(system: &System<f64>, from: &Unknowns<f64>) -> Option<Unknowns<f64>> {
    let mut at = in_order(from);
    let scale = system.forced.0.hypot(system.forced.1) * (1.0 + system.omega);
    let mut last = f64::INFINITY;
    for _ in 0..12 {
        let (residuals, jacobian) = system.equations(&unknowns(&at));
        let step = newton_step(&residuals, &jacobian)?;
        for (x, dx) in at.iter_mut().zip(&step) {
            *x -= dx;
        }
        let [t1, t2, lengths @ ..] = step;
        let size = t1.abs().max(t2.abs()).max(largest(&lengths) / scale);
        if size < 1e-11 || (size < 1e-7 && size >= last / 2.0) {
            let close = (at[1] - from.displacement_phase).abs() <= LONGEST;
            return close.then_some(unknowns(&at));
        }
        last = size;
    }
    None
}

/// Solves eq. 21–25 at (Ω, α, ζ), ζ > 0.
pub(super) fn solve<F: Float + RealField>(ratios: Ratios<F>) -> Result<Solution<F>, MatchingError> {
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let one = <F as Field>::int(1);
    let system = System::new(omega, ratios.damping_ratio(), one / alpha);
    let near = path(&system.at_less()).map_err(|part| MatchingError::NoCycle {
        omega: written(omega),
        alpha: written(alpha),
        part,
    })?;
    let mut start = in_order(&near).map(<F as Float>::from_f64);
    let mut iterations = 0;
    let (mut u, found) = loop {
        let found = iterate(start, |x| system.equations(&unknowns(x)))?;
        iterations += found.iterations;
        let u = unknowns(&found.at);
        match system.faster(&u, 16.0) {
            Some(faster) if iterations <= most_iterations::<F>() => start = in_order(&faster),
            _ => break (u, found),
        }
    };
    positive("Δ₀/B", u.max_displacement)?;
    let (residuals, jacobian) = system.equations(&u);
    let (p, q) = system.forced;
    let amplitude = Field::hypot(p, q);
    let parts = [one, amplitude, u.max_displacement, u.max_velocity, omega * amplitude];
    let size = parts.into_iter().fold(system.friction, F::or_larger);
    let residuals = residuals.map(|r| super::accuracy::in_last_places(r, size));
    let lost_bits = super::accuracy::lost_bits_of(&jacobian, Float::to_f64(size), &u);
    if largest(&residuals) > <F as Field>::int(64) * (one + one / omega) {
        return Err(MatchingError::NoConvergence { iterations, step: found.step, residual: found.residual });
    }
    u = Unknowns {
        max_velocity: u.max_velocity * alpha,
        max_displacement: u.max_displacement * alpha,
        deviation: u.deviation * alpha,
        ..u
    };
    Ok(Solution { unknowns: u, residuals, iterations, lost_bits })
}
