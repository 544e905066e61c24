//! Monte-Carlo: parameters drawn from distributions.

use crate::cycle::regime::Regime;
use crate::cycle::response::Response;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::Scales;
use crate::output::Output;
use crate::uncertainty::{Estimate, Parameters};
use rand::{RngCore, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The results of random draws of the parameters (Monte-Carlo).
///
/// A draw takes as many random numbers as it needs from the generator given to it, so that the parameters may have any
/// distribution, such as those of `rand_distr`, and may depend on each other. The draws are reproducible: the same seed
/// gives the same draws on every machine (ChaCha8), as far as the distributions do. Invalid draws, such as a negative
/// friction bound from a normal distribution, are counted and not repeated. Probabilities are conditional on a valid
/// draw, and [`MonteCarlo::invalid`] is the number of invalid ones.
///
/// ```
/// use rand_distr::{Distribution, LogNormal, Normal};
/// use stickslip::uncertainty::{MonteCarlo, Parameters};
/// use stickslip::{Excitation, Output, Regime};
/// let stiffness = Normal::new(1000.0, 20.0).unwrap();
/// let friction = LogNormal::from_mean_cv(5.0, 0.4).unwrap();
/// let found = MonteCarlo::new(
///     |rng| Parameters {
///         excitation: Excitation::Force,
///         mass: 50.0,
///         stiffness: stiffness.sample(rng),
///         friction_bound: friction.sample(rng),
///         amplitude: 12.0,
///         angular_frequency: 6.0,
///         damping: 0.0,
///     },
///     &[Output::MaxDisplacement],
///     20_000,
///     7,
/// )?;
/// let sticking = found.probability(Regime::Sticking);
/// // P(r_y > p₀/α_min = 8.115) is 0.0736 by the distribution function, at k = 1000.
/// assert!((sticking.value - 0.0736).abs() < 4.0 * sticking.standard_error);
/// assert_eq!(found.invalid, 0);
/// let [low, high] = [0.05, 0.95].map(|share| found.quantile(Output::MaxDisplacement, share).unwrap());
/// assert!(0.004 < low && low < high && high < 0.017);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct MonteCarlo {
    /// The total number of draws.
    pub draws: u32,
    /// Invalid draws: a parameter is not positive or not finite, or a ratio or scale is outside the domain of
    /// the number type.
    pub invalid: u32,
    regimes: [(Regime, u32); Regime::ALL.len()],
    /// The values of each output in increasing order, from the draws that have it.
    outputs: Vec<(Output, Vec<f64>)>,
}

impl MonteCarlo {
    /// Draws a machine and its drive `draws` times, and keeps these `outputs` in physical units ([`Output::unit`]).
    ///
    /// # Errors
    /// Where `draws` is zero.
    pub fn new(
        mut draw: impl FnMut(&mut dyn RngCore) -> Parameters<f64>,
        outputs: &[Output],
        draws: u32,
        seed: u64,
    ) -> Result<Self, Error> {
        if draws == 0 {
            return Err(Error::NotPositive { quantity: Quantity::Draws, value: written(f64::from(draws)) });
        }
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut regimes = Regime::ALL.map(|regime| (regime, 0));
        let mut outputs: Vec<_> = outputs.iter().map(|&output| (output, Vec::new())).collect();
        for _ in 0..draws {
            let Ok((response, scales)) = answer(&draw(&mut rng)) else { continue };
            for (regime, count) in &mut regimes {
                *count = u32::saturating_add(*count, u32::from(*regime == response.regime));
            }
            for (output, values) in &mut outputs {
                values.extend(output.of(&response).map(|y| y * output.unit(&scales)));
            }
        }
        for (_, values) in &mut outputs {
            values.sort_by(f64::total_cmp);
        }
        let valid = regimes.iter().fold(0, |sum, (_, count)| u32::saturating_add(sum, *count));
        Ok(Self { draws, invalid: draws.saturating_sub(valid), regimes, outputs })
    }

    /// The number of valid draws in each regime.
    #[cfg(feature = "serde")]
    pub(crate) const fn regimes(&self) -> &[(Regime, u32); Regime::ALL.len()] {
        &self.regimes
    }

    /// The number of valid draws in a regime.
    #[must_use]
    pub fn count(&self, regime: Regime) -> u32 {
        self.regimes.iter().filter(|(r, _)| *r == regime).map(|(_, count)| count).sum()
    }

    /// The probability of a regime, given that the draw is valid; NaN if no draw was.
    ///
    /// Its standard error is `√(p̃(1 − p̃)/(n + 4))` with `p̃ = (count + 2)/(n + 4)` (Agresti and Coull),
    /// which is not zero where all draws or none are in the regime.
    pub fn probability(&self, regime: Regime) -> Estimate {
        let (count, n) = (f64::from(self.count(regime)), f64::from(self.draws.saturating_sub(self.invalid)));
        let shrunk = (count + 2.0) / (n + 4.0);
        let standard_error = (shrunk * (1.0 - shrunk) / (n + 4.0)).sqrt();
        Estimate {
            value: count / n,
            standard_error,
            degrees_of_freedom: f64::INFINITY,
            range: (0.0, 1.0),
            alike: None,
        }
    }

    /// The values of a kept output in increasing order, from the draws in which the output exists: outputs of
    /// the cycle exist where the body does not stick. Empty for an output that was not kept.
    #[must_use]
    pub fn values(&self, output: Output) -> &[f64] {
        self.outputs.iter().find(|(kept, _)| *kept == output).map_or(&[], |(_, values)| values)
    }

    /// The quantile of an output, given that it exists. It is interpolated linearly between the ordered
    /// values, from the least at share 0 to the greatest at share 1. `None` for a share outside [0, 1], or if
    /// there is no value.
    #[must_use]
    pub fn quantile(&self, output: Output, share: f64) -> Option<f64> {
        let values = self.values(output);
        if !(0.0..=1.0).contains(&share) || values.is_empty() {
            return None;
        }
        let place = share * values.len().saturating_sub(1) as f64;
        let (below, part) = (place.floor(), place.fract());
        let low = *values.get(below as usize)?;
        let high = values.get((below as usize).saturating_add(1)).copied().unwrap_or(low);
        Some(low + (high - low) * part)
    }

    /// The mean of an output, given that it exists, with its standard error `s/√n`; `None` with fewer than
    /// two values.
    #[must_use]
    pub fn mean(&self, output: Output) -> Option<Estimate> {
        let values = self.values(output);
        let n = values.len() as f64;
        if n < 2.0 {
            return None;
        }
        let mean = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|y| (y - mean) * (y - mean)).sum();
        let standard_error = (squares / (n - 1.0) / n).sqrt();
        Some(Estimate {
            value: mean,
            standard_error,
            degrees_of_freedom: n - 1.0,
            range: (f64::NEG_INFINITY, f64::INFINITY),
            alike: None,
        })
    }
}

/// The values of a kept output: [`MonteCarlo::values`].
impl core::ops::Index<Output> for MonteCarlo {
    type Output = [f64];

    fn index(&self, output: Output) -> &[f64] {
        self.values(output)
    }
}

/// The answer for one draw, and its scales.
fn answer(drawn: &Parameters<f64>) -> Result<(Response<f64>, Scales<f64>), Error> {
    let (body, drive) = drawn.machine()?;
    Ok((Response::new(drive.ratios(&body)?), Scales::new(&body, &drive)?))
}

#[cfg(test)]
mod tests {
    use super::{MonteCarlo, Parameters};
    use crate::{Cycle, Error, Excitation, Output, Ratios, Regime};

    /// The first draws of a fixed list of (r_y, p₀, ω_d).
    fn first(draws: &[[f64; 3]], count: u32) -> Result<MonteCarlo, Error> {
        let mut next = draws.iter();
        let draw = |_: &mut dyn rand::RngCore| {
            let &[friction_bound, amplitude, angular_frequency] = next.next().unwrap();
            Parameters {
                excitation: Excitation::Force,
                mass: 1.0,
                stiffness: 4.0,
                friction_bound,
                amplitude,
                angular_frequency,
                damping: 0.0,
            }
        };
        MonteCarlo::new(draw, &[Output::MaxDisplacement], count, 1)
    }

    #[test]
    fn probabilities_quantiles_and_means_are_those_of_the_draws() {
        let draws = [
            [1.0, 5.0, 1.4],
            [1.0, 0.5, 1.4],
            [1.0, 2.0, 1.4],
            [-1.0, 2.0, 1.4],
            [1.0, 1.15, 1.4],
            [2.0, 6.0, 1.4],
            [1.0, f64::NAN, 1.4],
            [1.0, 1.1, 1.4],
            [1.0, 2.0, 2.0],
        ];
        let output = Output::MaxDisplacement;
        let found = first(&draws, 9).unwrap();
        assert_eq!((found.draws, found.invalid), (9, 2));
        for (regime, count) in
            [(Regime::Stuck, 1u32), (Regime::Sticking, 2), (Regime::NonSticking, 3), (Regime::Unbounded, 1)]
        {
            assert_eq!(found.count(regime), count);
            let (probability, count) = (found.probability(regime), f64::from(count));
            assert_eq!(probability.value, count / 7.0);
            // p̃ = (count + 2)/11 and √(p̃(1 − p̃)/11).
            let due = ((count + 2.0) * (9.0 - count) / 1331.0).sqrt();
            assert!((probability.standard_error / due - 1.0).abs() < 1e-15, "{regime:?}");
            assert_eq!(probability.degrees_of_freedom, f64::INFINITY);
        }
        // The unit of length is r_y/k.
        let length = |alpha: f64, unit: f64| {
            Cycle::new(Ratios::new(0.7, alpha).unwrap()).unwrap().max_displacement * unit
        };
        let mut due = [length(2.0, 0.25), length(5.0, 0.25), length(3.0, 0.5)];
        due.sort_by(f64::total_cmp);
        let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-14;
        assert!(
            found.values(output).iter().zip(due).all(|(&a, b)| close(a, b))
                && found.values(output).len() == 3
        );
        assert!(found.values(Output::MaxVelocity).is_empty());
        for (share, value) in [
            (0.0, due[0]),
            (0.25, 0.5 * (due[0] + due[1])),
            (0.5, due[1]),
            (0.875, 0.25 * due[1] + 0.75 * due[2]),
            (1.0, due[2]),
        ] {
            assert!(close(found.quantile(output, share).unwrap(), value), "{share}");
        }
        assert_eq!((found.quantile(output, -1e-9), found.quantile(output, 1.0 + 1e-9)), (None, None));
        let (mean, middle) = (found.mean(output).unwrap(), due.iter().sum::<f64>() / 3.0);
        let squares: f64 = due.iter().map(|x| (x - middle).powi(2)).sum();
        assert!(close(mean.value, middle) && close(mean.standard_error, (squares / 6.0).sqrt()));
        assert_eq!(mean.degrees_of_freedom, 2.0);
        // The mean of one value has no standard error; that of two has.
        for (count, is) in [(1, false), (2, false), (3, true)] {
            assert_eq!(first(&draws, count).unwrap().mean(output).is_some(), is, "{count}");
        }
        assert!(first(&draws, 0).is_err());
    }
}
