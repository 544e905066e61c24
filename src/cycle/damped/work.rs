//! The work of the damper in a cycle without stops.

use super::DampedCycle;
use super::rising::{Rising, Vibration};
use super::squared::DrivenVelocity;
use crate::float::{Field, Float};

impl<F: Float> DampedCycle<F> {
    /// The energy that the damper takes in a cycle, in units of r_y B: with the damper on the moving support by the velocity
    /// between body and support.
    ///
    /// `∮ 2ζ x′² dφ = 2ζT Ω²(α/q)² + 4G + 8ζI`, `I = 2[b (1 − Ω²) − 2ζΩ² a]/q²`: driven, free, and both. Near
    /// resonance these nearly cancel, and the power series of x′ is integrated.
    pub(crate) fn damper_work(&self, is_on_foot: bool) -> F {
        let half = &self.rising.half;
        let vibration = if is_on_foot { self.rising.seen_from_foot(true) } else { self.rising.vibration() };
        let (work, driven) = self.rising.damper_work(&vibration);
        let cancels = work * F::int(16) < driven;
        let small = || F::int(4) * half.free.zeta * square_of_velocity(&vibration);
        if half.is_resonant && cancels { small() } else { work }
    }
}

impl<F: Field> Rising<F> {
    /// The work of the damper along a vibration of this free part, in r_y B, and its driven part.
    pub(crate) fn damper_work(&self, vibration: &Vibration<F>) -> (F, F) {
        let (half, two) = (&self.half, F::int(2));
        let (a, h) = vibration.driven;
        let q2 = half.stiffness.square();
        let mixed = two * half.omega * (h * half.one_minus_square - half.damper() * a) / q2;
        let zeta = half.free.zeta;
        let driven = two * zeta * half.period * (half.omega * a.hypot(h)).square();
        (driven + F::int(4) * half.shift + F::int(8) * zeta * mixed, driven)
    }

    /// The body as seen from the support, which moves by `u = c cos Ωτ + s sin Ωτ`: a vibration of the same free part, whose
    /// driven part `−(a + c) cos Ωτ − (H + s) sin Ωτ` is written without a difference. With the damper on the support
    /// `u + 2ζu′` is the drive, and `(a + c, H + s) = Ω²(a − dH, H + da)/(1 + d²)`, d = 2ζΩ; otherwise u is the drive,
    /// and `(a + c, H + s) = (Ω²a − dH, Ω²H + da)`.
    pub(crate) fn seen_from_foot(&self, has_damper: bool) -> Vibration<F> {
        let (vibration, d, omega) = (self.vibration(), self.half.damper(), self.half.omega);
        if !has_damper {
            let ((a, h), (along, across), square) = (vibration.driven, vibration.force(), omega.square());
            let whole = vibration.whole.map(|(x, v)| (x - along, v - omega * across));
            return Vibration { driven: (square * a - d * h, square * h + d * a), whole, ..vibration };
        }
        let size = F::int(1) + d.square();
        let turned = |(a, h): (F, F)| ((a - d * h) / size, (h + d * a) / size);
        let (square, (a, h)) = (omega.square(), turned(vibration.driven));
        let (along, across) = turned(vibration.force());
        // Where the parts nearly cancel, the whole begins with x + 1 − u and −u′.
        let whole = vibration.whole.map(|(x, v)| (x - along, v - omega * across));
        Vibration { driven: (square * a, square * h), whole, ..vibration }
    }
}

/// `∫ x′² dτ` over half a cycle: a sum of power series around the middles of two parts, Ω being near 1.
fn square_of_velocity<F: Float>(vibration: &Vibration<F>) -> F {
    let Vibration { omega, free, end, .. } = *vibration;
    let damping = F::int(2) * free.zeta;
    let quarter = end / F::int(4);
    let part = |tau: F| {
        let at = vibration.at(tau);
        let [v, slope, curvature] = vibration.velocity(&at);
        let third = at.free.snap - omega.square() * vibration.driven(&at).1;
        let force = (curvature + damping * slope + v, third + damping * curvature + slope);
        DrivenVelocity { omega, damping, velocity: (v, slope), force }.square_around(quarter)
    };
    part(quarter) + part(F::int(3) * quarter)
}

#[cfg(test)]
mod tests {
    use crate::{Border, Cycle, Ratios};

    fn at<F: crate::Float>(omega: f64, zeta: f64, alpha: Option<f64>) -> Cycle<F> {
        let to = F::from_f64;
        let ratios = |alpha: F| Ratios::new(to(omega), alpha).unwrap().with_damping_ratio(to(zeta)).unwrap();
        let alpha = alpha.map_or_else(|| Border::of(&ratios(to(2.0))).min_force_ratio, to);
        Cycle::new(ratios(alpha)).unwrap()
    }

    /// At Ω = 1 on the border the work tends to 7.10434086 ζ: 4ζ times the integral without damping, by
    /// quadrature at 60 digits.
    fn takes_little<F: crate::Float>(zetas: &[f64]) {
        for zeta in zetas {
            let work = at::<F>(1.0, *zeta, None).damper_work().to_f64() / zeta;
            // The rounding of the border changes it by as much as 1/ζ times itself.
            let off = 1e-7 + 16.0 * F::epsilon().to_f64() / zeta;
            assert!((work - 7.104_340_86).abs() < off, "{zeta}: {work}");
        }
    }

    #[test]
    fn a_little_damper_takes_little() {
        takes_little::<f64>(&[1e-12, 1e-10, 1e-8]);
        #[cfg(feature = "mp")]
        takes_little::<crate::float::mp::Mp<4>>(&[1e-18, 1e-15, 1e-12, 1e-9]);
    }

    /// Where the closed form keeps half of its digits, both methods agree.
    #[test]
    fn the_integral_is_the_closed_form() {
        for (omega, zeta, alpha) in
            [(1.0, 0.01, Some(2.0)), (1.05, 0.02, Some(1.6)), (0.9, 0.03, None), (1.0, 1e-4, None)]
        {
            let cycle = at::<f64>(omega, zeta, alpha);
            let crate::cycle::waveform::Basis::Damped(damped) = &cycle.motion else { panic!("{cycle:?}") };
            let integral = 4.0 * zeta * super::square_of_velocity(&damped.rising.vibration());
            assert!(
                (cycle.damper_work() / integral - 1.0).abs() < 1e-12 / zeta.sqrt(),
                "{omega} {zeta}: {integral}"
            );
        }
    }

    #[cfg(feature = "mp")]
    #[test]
    fn it_has_any_number_of_digits() {
        use crate::float::mp::Mp;
        for (omega, zeta) in [(1.0, 1e-12), (0.9999, 1e-7), (1.01, 1e-5)] {
            let more = at::<Mp<4>>(omega, zeta, None);
            let many = at::<Mp<8>>(omega, zeta, None).damper_work();
            let (more, many) = (more.damper_work().to_string(), many.to_string());
            assert_eq!(more.get(..60), many.get(..60), "{omega} {zeta}");
            // At the same force ratio, a float above the border.
            let alpha = at::<f64>(omega, zeta, None).ratios.alpha().next_up();
            let some = at::<f64>(omega, zeta, Some(alpha)).damper_work();
            let many = at::<Mp<8>>(omega, zeta, Some(alpha)).damper_work().to_f64();
            assert!((some / many - 1.0).abs() < 1e-8, "{omega} {zeta}: {some}");
        }
    }
}
