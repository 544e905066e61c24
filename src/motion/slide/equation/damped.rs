//! The functions of natural time with viscous damping; near resonance they come from
//! `cycle::damped::resonance`.

use super::{Equation, Responses};
use crate::cycle::damped::free::Free;
use crate::float::Float;

impl<F: Float> Equation<F> {
    /// The damping ratio ζ.
    #[inline]
    pub(crate) fn zeta(&self) -> F {
        self.damping / F::int(2)
    }

    /// The free vibration with ζ > 0.
    #[inline]
    pub(crate) fn vibration(&self) -> Free<F> {
        Free::new(self.zeta())
    }

    /// The free vibrations from (x, w) = (0, 1) and (1, 0) after φ: (sin φ, cos φ) without damping.
    #[inline]
    pub(crate) fn free_waves(&self, phi: F) -> (F, F) {
        if self.is_damped() { self.damped_free_waves(phi) } else { phi.sin_cos() }
    }

    #[cold]
    #[inline(never)]
    fn damped_free_waves(&self, phi: F) -> (F, F) {
        let waves = self.vibration().waves(phi);
        (waves.sine, waves.cosine + self.zeta() * waves.sine)
    }

    /// The free vibration (w, w′) after φ, from its initial values; `rotation` is [`Equation::free_waves`] at
    /// φ.
    ///
    /// From ζ = 1 on `w′ = −w/μ + (w_0′ + w_0/μ) e^{−μφ}` with the faster rate of decay μ = ζ + √(ζ² − 1): a
    /// slow creep then keeps its digits.
    pub(crate) fn freely(&self, phi: F, (s, c): (F, F), (w, rate): (F, F)) -> (F, F) {
        let after = w * c + rate * s;
        if self.damping < F::int(2) {
            return (after, rate * (c - self.damping * s) - w * s);
        }
        let slow = self.vibration().slow_rate();
        let fast = (-(phi / slow)).exp();
        (after, (rate + slow * w) * fast - slow * after)
    }

    /// `1 − Ω² + 2iζΩ`, (real, imaginary): the dynamic stiffness at the frequency of the drive.
    #[inline]
    pub(crate) fn stiffness(&self) -> (F, F) {
        let (one, omega) = (F::int(1), self.omega);
        ((one - omega) * (one + omega), self.damping * omega)
    }

    /// The forced response at (sin θ, cos θ): (x, w), without the shift by friction.
    #[inline]
    pub(crate) fn forced(&self, (sine, cosine): (F, F)) -> (F, F) {
        let (real, imaginary) = self.stiffness();
        let amplitude = self.alpha / (real.square() + imaginary.square());
        let x = amplitude * (real * sine - imaginary * cosine);
        (x, self.omega * amplitude * (real * cosine + imaginary * sine))
    }

    /// The free vibrations and the quotients C, S, D of `slide` at φ, with damping.
    #[cold]
    #[inline(never)]
    pub(crate) fn damped_waves(&self, phi: F) -> Responses<F> {
        let (one, two, eight) = (F::int(1), F::int(2), F::int(8));
        let near = self.omega * two >= one && self.omega <= two && self.damping * F::int(4) < one;
        if near && phi * eight <= F::int(1000) {
            return Responses::new(self.omega, &self.vibration(), phi);
        }
        let free = self.vibration();
        let at = free.waves(phi);
        let zeta_sine = free.zeta * at.sine;
        let (s, c) = (at.sine, at.cosine + zeta_sine);
        let drive = (self.omega * phi).sin_cos();
        let (real, imaginary) = self.stiffness();
        let square = real.square() + imaginary.square();
        let (above, beside) = (drive.1 - c, drive.0 - self.omega * s);
        let sine = (beside * real - above * imaginary) / square;
        Responses {
            free: (s, c),
            versine: free.step_response(phi, s),
            drive,
            c: (above * real + beside * imaginary) / square,
            s: sine,
            d: s - self.omega * sine,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::Ratios;
    #[cfg(feature = "mp")]
    use crate::float::Field;
    use crate::float::Float;
    #[cfg(feature = "mp")]
    use crate::float::mp::Mp;
    use crate::motion::slide::equation::Equation;

    fn equation<F: Float>(omega: F, zeta: F) -> Equation<F> {
        Equation::new(Ratios::new(omega, F::int(2)).unwrap().with_damping_ratio(zeta).unwrap())
    }

    /// C, S, s, c and 1 − c by the power series of the equation itself.
    #[cfg(feature = "mp")]
    fn series(omega: f64, zeta: f64, phi: f64) -> [Mp<6>; 5] {
        type Wide = Mp<6>;
        let (omega, damping, phi) = (Wide::from(omega), Wide::from(zeta) * Wide::int(2), Wide::from(phi));
        let solve = |start: (Wide, Wide), drive: (Wide, Wide)| {
            let (mut value, mut slope) = start;
            let (mut force, mut next_force) = drive;
            let (mut sum, mut power) = (Wide::int(0), Wide::int(1));
            for n in 1..400 {
                sum += value * power;
                (value, slope) = (slope, force - value - damping * slope);
                (force, next_force) = (next_force, -(omega.square() * force));
                power *= phi / Wide::int(n);
            }
            sum
        };
        let (zero, one) = (Wide::int(0), Wide::int(1));
        let c = solve((one, zero), (zero, zero));
        [
            solve((zero, zero), (one, zero)),
            solve((zero, zero), (zero, omega)),
            solve((zero, one), (zero, zero)),
            c,
            one - c,
        ]
    }

    /// The functions solve their equations, also through Ω = 1, ζ → 0 and ζ = 1.
    #[cfg(feature = "mp")]
    #[test]
    fn waves_are_the_series_of_the_equation() {
        for omega in [1e-3, 0.3, 0.55, 1.0 - 1e-9, 1.0, 1.0 + 1e-15, 1.2, 3.0, 40.0] {
            for zeta in [1e-60, 1e-17, 1e-8, 0.01, 0.124, 0.126, 0.6, 1.0 - 1e-9, 1.0, 1.0 + 1e-12, 1.5, 20.0]
            {
                for phi in [0.13, 0.7, 2.0, 5.0] {
                    if omega * phi > 30.0 || zeta * phi > 40.0 {
                        continue;
                    }
                    let (waves, exact) = (equation(omega, zeta).waves(phi), series(omega, zeta, phi));
                    let found = [waves.c, waves.s, waves.free.0, waves.free.1, waves.versine];
                    let unit = 6.0 * f64::EPSILON * (1.0 + phi * omega.max(1.0));
                    for (i, (found, exact)) in found.into_iter().zip(exact).enumerate() {
                        let size = [1.0 / (1.0 + omega * omega), 1.0 / (1.0 + omega), 1.0, 1.0, 1.0][i];
                        // The path under a unit force keeps its relative accuracy.
                        let size = if i == 4 && zeta >= 1.0 { 4.0 * exact.to_f64() } else { size };
                        let size = if i < 2 { f64::max(size, exact.to_f64().abs()) } else { size };
                        let error = (Mp::<6>::from(found) - exact).to_f64().abs();
                        assert!(
                            error <= unit * size,
                            "{i} at Ω = {omega}, ζ = {zeta}, φ = {phi}: {found:e} {error:e}"
                        );
                    }
                    let d = exact[2] - Mp::<6>::from(omega) * exact[1];
                    assert!(
                        (Mp::<6>::from(waves.d) - d).to_f64().abs() <= 2.0 * unit,
                        "{omega} {zeta} {phi}"
                    );
                }
            }
        }
    }

    /// As ζ → 0 the functions tend to those without damping.
    #[test]
    fn no_damping_is_the_limit() {
        for omega in [0.1f64, 0.7, 1.0, 1.3, 7.0] {
            let (with, without) = (equation(omega, 1e-20), equation(omega, 0.0));
            for phi in [0.2f64, 1.0, 3.0] {
                let (a, b) = (with.waves(phi), without.waves(phi));
                for (x, y) in [
                    (a.c, b.c),
                    (a.s, b.s),
                    (a.d, b.d),
                    (a.free.0, b.free.0),
                    (a.free.1, b.free.1),
                    (a.versine, b.versine),
                ] {
                    assert!((x - y).abs() < 2e-15, "Ω = {omega}, φ = {phi}: {x} {y}");
                }
            }
        }
    }
}
