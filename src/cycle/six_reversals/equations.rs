//! The matching problem of the symmetric cycle of six reversals: five equations in five unknowns.

use crate::cycle::damped::free::Free;
use crate::cycle::damped::half_period::half_angle;
use crate::float::Float;
use crate::machine::ratios::Ratios;

/// The unknowns of the cycle; see the documentation of [`super`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unknowns<F> {
    /// `a = ω_n(t₂ − t₁)`, the natural time from the first reversal to the second.
    pub(super) before: F,
    /// `b = ω_n(t₃ − t₂)`, from the second to the third.
    pub(super) after: F,
    /// `s = AΩ sin Ωφ₂`, φ₂ the natural time from the forced maximum to the second reversal.
    pub(super) sine: F,
    /// `c = AΩ² cos Ωφ₂`.
    pub(super) cosine: F,
    /// `g₁`, the displacement of the free vibration at the second reversal.
    pub(super) swing: F,
}

/// The fifth equation: the quantity that is given in addition to Ω and ζ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Closing<F> {
    /// The force, as `AΩ² = αΩ²/q`.
    Force(F),
    /// An edge: at this reversal the force left over is exactly the friction force.
    Stop(Edge),
}

/// The reversal that becomes a stop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Edge {
    Second,
    Third,
}

impl<F: Float> Unknowns<F> {
    /// `AΩ² = √(c² + Ω²s²)`.
    pub(super) fn forced_acceleration(&self, omega: F) -> F {
        self.cosine.hypot(omega * self.sine)
    }

    pub(super) const fn to_array(self) -> [F; 5] {
        [self.before, self.after, self.sine, self.cosine, self.swing]
    }

    pub(super) const fn of_array([before, after, sine, cosine, swing]: [F; 5]) -> Self {
        Self { before, after, sine, cosine, swing }
    }

    pub(super) fn map<G: Float>(self, to: impl Fn(F) -> G) -> Unknowns<G> {
        Unknowns::of_array(self.to_array().map(to))
    }
}

/// The quantities that depend on Ω and ζ alone.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Problem<F> {
    pub(super) omega: F,
    pub(super) free: Free<F>,
    /// sin β and cos β of `β = dπ/2Ω`.
    pub(super) sin_beta: F,
    pub(super) cos_beta: F,
    /// `t = tanh(ζπ/2Ω)`.
    pub(super) loss: F,
    /// η: a reversal is a stop where the force left over is not above it, in units of r_y.
    pub(super) static_friction: F,
}

/// Free vibration after the time u of either sign: from (x, x′) = (1, 0) it is at (C, −S), from (0, 1) at (S,
/// D).
#[derive(Debug, Clone, Copy)]
pub(super) struct Wave<F> {
    /// `C = e^{−ζu} (cos du + ζ sin(du)/d)`.
    pub(super) c: F,
    /// `S = e^{−ζu} sin(du)/d`.
    pub(super) s: F,
    /// `D = e^{−ζu} (cos du − ζ sin(du)/d)`.
    pub(super) d: F,
}

impl<F: Float> Problem<F> {
    /// At an Ω, a ζ in [0, 1) and an η that are in their domains.
    pub(super) fn new(omega: F, zeta: F, static_friction: F) -> Self {
        let (two, free) = (F::int(2), Free::new(zeta));
        let half = F::pi() / (two * omega);
        let (sin_beta, cos_beta) = half_angle(&free, omega, half);
        // tanh x = (1 − e^{−2x})/(1 + e^{−2x})
        let fall = (-(two * zeta * half)).exp_m1();
        Self { omega, free, sin_beta, cos_beta, loss: -fall / (two + fall), static_friction }
    }

    /// At the Ω, ζ and η of these ratios.
    pub(super) fn of(ratios: &Ratios<F>) -> Self {
        Self::new(ratios.omega(), ratios.damping_ratio(), ratios.static_friction_ratio())
    }

    /// The distance from the pole without damping, as hypot(cot β, t).
    pub(super) fn distance(&self) -> F {
        (self.cos_beta / self.sin_beta).hypot(self.loss)
    }

    /// q, by which `AΩ² = αΩ²/q`.
    pub(super) fn stiffness(&self) -> F {
        let (one, omega) = (F::int(1), self.omega);
        (F::int(2) * self.free.zeta * omega).hypot((one - omega) * (one + omega))
    }

    /// The lag of the linear oscillator.
    pub(super) fn phase_lag(&self) -> F {
        let (one, omega) = (F::int(1), self.omega);
        (F::int(2) * self.free.zeta * omega).atan2((one - omega) * (one + omega))
    }

    /// The problem at a fraction of the distance from the pole without damping.
    pub(super) fn towards_the_pole(&self, share: F) -> Self {
        Self {
            free: Free::new(self.free.zeta * share),
            cos_beta: self.cos_beta * share,
            loss: self.loss * share,
            ..*self
        }
    }

    /// Converts each part of the problem to another number type.
    pub(super) fn map<G: Float>(&self, to: impl Fn(F) -> G) -> Problem<G> {
        Problem {
            omega: to(self.omega),
            free: self.free.map(&to),
            sin_beta: to(self.sin_beta),
            cos_beta: to(self.cos_beta),
            loss: to(self.loss),
            static_friction: to(self.static_friction),
        }
    }

    /// Free vibration after u.
    pub(super) fn wave(&self, u: F) -> Wave<F> {
        let (s, c) = (self.free.frequency * u).sin_cos();
        let decay = (-(self.free.zeta * u)).exp();
        let (sine, cosine) = (decay * s / self.free.frequency, decay * c);
        let shift = self.free.zeta * sine;
        Wave { c: cosine + shift, s: sine, d: cosine - shift }
    }

    /// `κ(u) = (cos Ωu − D(u))/S(u)` and its derivative.
    fn kappa(&self, u: F, wave: &Wave<F>) -> (F, F) {
        let (one, two, omega, free) = (F::int(1), F::int(2), self.omega, &self.free);
        let d = free.frequency;
        // cos Ωu − e^{−ζu} cos du, without cancellation for small u
        let product = two * ((d + omega) * u / two).sin() * ((d - omega) * u / two).sin();
        let fall = (-(free.zeta * u)).exp_m1();
        let value = free.zeta + (product - fall * (d * u).cos()) / wave.s;
        let slope = two * free.zeta * wave.d - omega * (omega * u).sin() - value * wave.d;
        (value, one + slope / wave.s)
    }

    /// `μ(u) = sin Ωu/(ΩS(u))` and its derivative, for small u by the first terms of its series.
    fn mu(&self, u: F, wave: &Wave<F>) -> (F, F) {
        let (one, two, omega, zeta) = (F::int(1), F::int(2), self.omega, self.free.zeta);
        let (slow_sine, slow_cosine) = (omega * u).sin_cos();
        let value = slow_sine / (omega * wave.s);
        let slope = if u.square().square() < F::epsilon() {
            zeta + ((one - omega) * (one + omega) + two * zeta.square()) * u / F::int(3)
        } else {
            (slow_cosine - value * wave.d) / wave.s
        };
        (value, slope)
    }

    /// `(cos β − t sin β J) g + (t cos β − sin β J) w`.
    fn antisymmetry(&self, g: [F; 2], w: [F; 2]) -> [F; 2] {
        let Self { sin_beta, cos_beta, loss, .. } = *self;
        let (jg, jw) = (self.turned(g), self.turned(w));
        let row = |g: F, jg: F, w: F, jw: F| {
            cos_beta * g - loss * sin_beta * jg + (loss * cos_beta * w - sin_beta * jw)
        };
        let ([g1, g2], [jg1, jg2], [w1, w2], [jw1, jw2]) = (g, jg, w, jw);
        [row(g1, jg1, w1, jw1), row(g2, jg2, w2, jw2)]
    }

    /// J z, `J = (A + ζ)/d`.
    fn turned(&self, [x, v]: [F; 2]) -> [F; 2] {
        let (zeta, d) = (self.free.zeta, self.free.frequency);
        [(zeta * x + v) / d, -(x + zeta * v) / d]
    }

    /// g₂, the free vibration's velocity at the second reversal.
    pub(super) fn free_velocity(&self, y: &Unknowns<F>) -> F {
        y.sine - self.wave(y.before).s + self.wave(-y.after).s
    }

    /// The force `α sin θ − x` at the three reversals, in units of r_y: the body slides on without a stop
    /// where the first and the third are below −η and the second is above η.
    pub(super) fn forces(&self, y: &Unknowns<F>) -> [F; 3] {
        let Unknowns { before: a, after: b, sine: s, cosine: c, swing: g1 } = *y;
        let (two_zeta, omega) = (F::int(2) * self.free.zeta, self.omega);
        let g2 = self.free_velocity(y);
        let (ahead, back) = (self.wave(b), self.wave(-b));
        let ((early, before), both) = ((self.wave(-a), self.wave(a)), (self.wave(a + b), self.wave(-a - b)));
        let (slow_a, slow_b) = ((omega * a).sin_cos(), (omega * b).sin_cos());
        // x″ + 2ζx′ + friction: x_f″ + 2ζx_f′ of the forced wave minus the free wave's displacement
        let forced = |sine: F, cosine: F| {
            let acceleration = omega * s * sine - c * cosine;
            acceleration - two_zeta * (s * cosine + c / omega * sine)
        };
        [
            forced(-slow_a.0, slow_a.1) - early.c * g1 - early.s * g2 + early.c - both.1.c,
            forced(F::int(0), F::int(1)) - g1 + before.c - back.c,
            forced(slow_b.0, slow_b.1) - ahead.c * g1 - ahead.s * g2 + both.0.c - ahead.c,
        ]
    }

    /// x and its derivative by natural time, u after the second reversal.
    pub(super) fn motion(&self, y: &Unknowns<F>, u: F) -> (F, F) {
        let Unknowns { before, after, sine: s, cosine: c, swing: g1 } = *y;
        let (omega, one, zero) = (self.omega, F::int(1), F::int(0));
        let ((slow_sine, slow_cosine), free) = ((omega * u).sin_cos(), self.wave(u));
        let g2 = self.free_velocity(y);
        let mut x = (c / omega * slow_cosine - s * slow_sine) / omega + free.c * g1 + free.s * g2;
        let mut w = -(c / omega * slow_sine + s * slow_cosine) - free.s * g1 + free.d * g2;
        let mut friction = one;
        for (at, sign) in [(-before, one), (zero, -one), (after, one)] {
            let wave = self.wave(u - at);
            let side = if u < at { sign } else { -sign };
            x = x + side * wave.c;
            w = w - side * wave.s;
            if u >= at {
                friction = -friction;
            }
        }
        (x - friction, w)
    }

    /// Left less right sides of the five equations, and their derivatives by (a, b, s, c, g₁).
    pub(super) fn residuals(&self, y: &Unknowns<F>, closing: Closing<F>) -> ([F; 5], [[F; 5]; 5]) {
        let Unknowns { before: a, after: b, sine: s, cosine: c, swing: g1 } = *y;
        let (zero, one) = (F::int(0), F::int(1));
        let (before, back) = (self.wave(a), self.wave(-b));
        let (early, ahead) = (self.wave(-a), self.wave(b));
        let ((kappa_a, dkappa_a), (kappa_b, dkappa_b)) = (self.kappa(-a, &early), self.kappa(b, &ahead));
        let ((mu_a, dmu_a), (mu_b, dmu_b)) = (self.mu(-a, &early), self.mu(b, &ahead));
        let g = [g1, s - before.s + back.s];
        let w = [before.c + back.c - one, -(before.s + back.s)];
        let [third, fourth] = self.antisymmetry(g, w);
        // By a, b, s and g₁.
        let [third_a, fourth_a] = self.antisymmetry([zero, -before.d], [-before.s, -before.d]);
        let [third_b, fourth_b] = self.antisymmetry([zero, -back.d], [back.s, back.d]);
        let [third_s, fourth_s] = self.antisymmetry([zero, one], [zero, zero]);
        let [third_g, fourth_g] = self.antisymmetry([one, zero], [zero, zero]);
        let (last, last_row) = self.closing(y, closing);
        (
            [
                c * mu_a + g1 + s * kappa_a - one - before.c + back.c,
                -(c * mu_b) - g1 - s * kappa_b - one - back.c + before.c,
                third,
                fourth,
                last,
            ],
            [
                [before.s - c * dmu_a - s * dkappa_a, back.s, kappa_a, mu_a, one],
                [-before.s, -(c * dmu_b) - s * dkappa_b - back.s, -kappa_b, -mu_b, -one],
                [third_a, third_b, third_s, zero, third_g],
                [fourth_a, fourth_b, fourth_s, zero, fourth_g],
                last_row,
            ],
        )
    }

    /// Left less right side of the fifth equation, and its derivatives.
    fn closing(&self, y: &Unknowns<F>, closing: Closing<F>) -> (F, [F; 5]) {
        let Unknowns { before: a, after: b, sine: s, cosine: c, swing: g1 } = *y;
        let (zero, one, omega, eta) = (F::int(0), F::int(1), self.omega, self.static_friction);
        let two_zeta = F::int(2) * self.free.zeta;
        let [_, second, third] = self.forces(y);
        match closing {
            Closing::Force(given) => {
                let found = y.forced_acceleration(omega);
                (found - given, [zero, zero, omega.square() * s / found, c / found, zero])
            }
            Closing::Stop(Edge::Second) => {
                (second - eta, [-self.wave(a).s, -self.wave(-b).s, -two_zeta, -one, -one])
            }
            Closing::Stop(Edge::Third) => {
                let (slow_sine, slow_cosine) = (omega * b).sin_cos();
                let (ahead, both) = (self.wave(b), self.wave(a + b));
                let g2 = self.free_velocity(y);
                let forced = omega * (c * slow_sine + omega * s * slow_cosine)
                    + two_zeta * (omega * s * slow_sine - c * slow_cosine);
                let by_b =
                    forced + ahead.s * g1 - ahead.d * g2 + ahead.s * self.wave(-b).d - both.s + ahead.s;
                let row = [
                    ahead.s * self.wave(a).d - both.s,
                    by_b,
                    omega * slow_sine - ahead.s - two_zeta * slow_cosine,
                    -slow_cosine - two_zeta / omega * slow_sine,
                    -ahead.c,
                ];
                (third + eta, row)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Closing, Edge, Problem, Unknowns};

    /// The rows of derivatives are compared with differences of the residuals.
    #[test]
    fn the_derivatives_are_those_of_the_residuals() {
        let at = [0.9, 1.3, -2.1, 7.5, -8.0];
        let every = [Closing::Force(9.0), Closing::Stop(Edge::Second), Closing::Stop(Edge::Third)];
        for (zeta, closing) in [0.0, 0.03].into_iter().flat_map(|zeta| every.map(|it| (zeta, it))) {
            let problem = Problem::new(0.331, zeta, 1.2);
            let residuals = |y| problem.residuals(&Unknowns::of_array(y), closing);
            let (_, rows) = residuals(at);
            for (column, h) in [1e-6f64; 5].into_iter().enumerate() {
                let moved = |by: f64| {
                    let mut y = at;
                    y[column] += by;
                    residuals(y).0
                };
                for (row, (up, down)) in rows.iter().zip(moved(h).into_iter().zip(moved(-h))) {
                    let slope = (up - down) / (2.0 * h);
                    assert!(
                        (row[column] - slope).abs() < 1e-7,
                        "{zeta} {closing:?} {column}: {} {slope}",
                        row[column]
                    );
                }
            }
        }
    }

    /// Without a damper the residuals are those of the equations at ζ = 0, which have circular functions alone.
    #[test]
    fn without_a_damper_they_are_the_equations_of_circular_functions() {
        let (omega, [a, b, s, c, p]) = (0.331f64, [0.9f64, 1.3, -2.1, 7.5, -8.0]);
        let beta = core::f64::consts::FRAC_PI_2 / omega;
        let kappa = |u: f64| ((omega * u).cos() - u.cos()) / u.sin();
        let mu = |u: f64| (omega * u).sin() / (omega * u.sin());
        let (x, y, q) = (a.cos() + b.cos() - 1.0, a.sin() - b.sin(), a.sin() + b.sin() - s);
        let due = [
            c * mu(a) + p - s * kappa(a) - (1.0 + a.cos() - b.cos()),
            -c * mu(b) - p - s * kappa(b) - (1.0 + b.cos() - a.cos()),
            p * beta.cos() + y * beta.sin(),
            -(q * beta.cos() - x * beta.sin()),
            c.hypot(omega * s) - 9.0,
        ];
        let problem = Problem::new(omega, 0.0, 1.0);
        let (found, _) = problem.residuals(&Unknowns::of_array([a, b, s, c, p]), Closing::Force(9.0));
        for (i, (found, due)) in found.into_iter().zip(due).enumerate() {
            assert!((found - due).abs() < 1e-14, "{i}: {found} {due}");
        }
        let forces = problem.forces(&Unknowns::of_array([a, b, s, c, p]));
        let both = (a + b).cos();
        let (slow_a, slow_b) = ((omega * a).sin_cos(), (omega * b).sin_cos());
        let due = [
            -(c * slow_a.1 + omega * s * slow_a.0) - p * a.cos() - q * a.sin() + a.cos() - both,
            -c - p + a.cos() - b.cos(),
            -(c * slow_b.1 - omega * s * slow_b.0) - p * b.cos() + q * b.sin() + both - b.cos(),
        ];
        for (found, due) in forces.into_iter().zip(due) {
            assert!((found - due).abs() < 1e-14, "{found} {due}");
        }
    }

    /// The two branches of the derivative of μ agree where they meet.
    #[test]
    fn a_short_arc_has_its_series() {
        for (zeta, allowed) in [(0.0, 1e-7), (0.03, 1e-4)] {
            let problem = Problem::new(0.331, zeta, 1.0);
            let slope = |u: f64| problem.mu(u, &problem.wave(u)).1 - zeta;
            assert!((slope(1.2e-4) / 1.2e-4 - slope(1.3e-4) / 1.3e-4).abs() < allowed, "{zeta}");
        }
    }
}
