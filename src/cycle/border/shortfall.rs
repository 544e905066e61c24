//! The frequency ratios at which eq. 61 is below the exact border: a band around each pole 1/(2n+1), and no
//! others.
//!
//! Above the pole the band reaches to 1/(2n), below it to Ω_e in (1/(2n+2), 1/(2n+1)), the one crossing of
//! the two values of S (proved in [`super::lobe`]).

use super::Border;
use super::band_end::BandEnd;
use super::lobe::Lobe;
use crate::float::Float;

/// The frequency ratios around the pole 1/(2n+1) at which eq. 61 is below the exact border.
///
/// On (`low`, `pole`) and (`pole`, `high`) a force ratio that meets eq. 61 need not keep the body sliding. At
/// `low` and `high` eq. 61 is exact, and so it is between the `high` of one pole and the `low` of the next
/// one, and for Ω ≥ 1/2.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Shortfall<F> {
    /// The lower end Ω_e, in (1/(2n+2), 1/(2n+1)).
    pub low: F,
    /// The pole 1/(2n+1).
    pub pole: F,
    /// The upper end 1/(2n).
    pub high: F,
}

impl<F: Float> Border<F> {
    /// The band around the pole 1/(2n+1) in which eq. 61 is too low; `None` for n = 0, where there is no
    /// pole.
    ///
    /// `low` is the one root, on the bracket γ ∈ (π/2, π), of a monotonic function; accuracy at f64: 4 ulp.
    pub fn shortfall(n: u16) -> Option<Shortfall<F>> {
        let pole = Lobe::new(n).high_pole()?;
        let high = F::ratio(1, 2) / F::int(i32::from(n));
        Some(Shortfall { low: BandEnd::of(n).omega(), pole, high })
    }
}

#[cfg(test)]
mod tests {
    use crate::Border;
    use crate::cycle::border::tests::close;

    #[test]
    fn ends_of_the_bands_where_eq_61_falls_short() {
        assert_eq!(Border::<f64>::shortfall(0), None);
        for (n, low) in [
            (1, 0.299_505_147_567_967_3),
            (2, 0.186_828_225_506_139_28),
            (3, 0.135_934_367_957_850_08),
            (7, 0.065_104_590_685_760_67),
            (100, 0.004_966_207_411_299_988),
            (5000, 9.998639278110747e-05),
            (65535, 7.62943173153576e-06),
        ] {
            let found = Border::<f64>::shortfall(n).unwrap();
            close(found.low, low, 4.0);
            close(found.high, 0.5 / f64::from(n), 1.0);
            close(found.pole, 1.0 / (2.0 * f64::from(n) + 1.0), 1.0);
            // Eq. 61 is exact just outside, and too low just inside and on either side of the pole.
            let falls_short =
                |omega| Border::new(omega).is_ok_and(|b| b.min_force_ratio_turning_point < b.min_force_ratio);
            assert!(!falls_short(found.low * (1.0 - 1e-12)) && falls_short(found.low * (1.0 + 1e-12)));
            assert!(falls_short(found.pole * (1.0 - 1e-11)) && falls_short(found.pole * (1.0 + 1e-11)));
            let step = 1e-5 / f64::from(n);
            assert!(!falls_short(found.high * (1.0 + step)) && falls_short(found.high * (1.0 - step)));
        }
    }
}
