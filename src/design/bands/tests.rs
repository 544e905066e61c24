//! Tests of `bands.rs`.

use super::{Edge, bands, frequency_bands};
use crate::cycle::border::Lobe;
use crate::{Border, Drive, Error, Oscillator};

fn all(alpha: f64, low: f64, high: f64) -> Vec<super::Band<f64>> {
    bands(alpha, 0.0, low..=high).unwrap().collect::<Result<_, _>>().unwrap()
}

#[test]
fn the_number_of_bands_is_that_of_the_minima_below() {
    // The minima of the lobes are 1.21, 11.364, 28.88, 54.35, 87.81, …
    for (alpha, count) in [(1.2, 0), (1.22, 1), (11.3, 1), (11.5, 2), (28.8, 2), (29.0, 3), (88.0, 5)] {
        assert_eq!(all(alpha, 1e-3, 1e3).len(), count, "{alpha}");
    }
    assert_eq!(all(1e6, 1e-4, 1e3).len(), 500);
}

#[test]
fn a_range_cuts_them() {
    let whole = all(12.0, 0.01, 100.0);
    assert_eq!((whole[0].low_edge, whole[0].high_edge), (Edge::Border, Edge::Border));
    assert_eq!((whole[1].low_edge, whole[1].high_edge), (Edge::Border, Edge::Range));
    let cut = all(12.0, 0.29, 0.295);
    assert_eq!((cut[0].low, cut[0].high), (0.29, 0.295));
    assert_eq!(cut[0].low_edge, Edge::Range);
    assert!(all(12.0, 0.31, 0.36).is_empty());
    assert_eq!(all(12.0, 0.299, 0.4).len(), 2);
    assert_eq!(all(12.0, 0.3, 0.3).len(), 1);
    // Above the minimum of lobe 0, the border increases to √(1 + π²/4) = 1.8621 without reaching it.
    assert_eq!(all(1.862, 0.6, 2f64.powi(250))[0].high_edge, Edge::Border);
    assert_eq!(all(1.863, 0.6, 2f64.powi(250))[0].high_edge, Edge::Range);
}

#[test]
fn the_ends_slide_and_their_neighbours_stick() {
    let at = |omega: f64| Border::new(omega).unwrap().min_force_ratio;
    for alpha in [1.21, 1.3, 1.8, 1.862, 3.0, 12.0, 31.0, 1e4, 1e9] {
        for band in bands(alpha, 0.0, 1e-3..=1e3).unwrap().map(Result::unwrap) {
            for (end, edge, outward) in [(band.low, band.low_edge, -1.0), (band.high, band.high_edge, 1.0)] {
                assert!(at(end) <= alpha, "{alpha} {end}");
                let outside = at(end * (1.0 + outward * 4.0 * f64::EPSILON));
                // Near 1.862 the border is so flat that the next float has the same value.
                assert!(edge == Edge::Range || outside > alpha * (1.0 - 1e-15), "{alpha} {end}");
            }
        }
    }
}

#[test]
fn a_minimum_that_cannot_be_told_from_alpha_is_said_so() {
    for index in [0, 1, 2, 9] {
        let minimum = Lobe::new(index).minimum::<f64>();
        let (low, high) = (minimum.omega * 0.999, minimum.omega * 1.001);
        let count =
            |alpha| bands(alpha, 0.0, low..=high).unwrap().collect::<Result<Vec<_>, _>>().map(|b| b.len());
        assert!(matches!(count(minimum.force_ratio), Err(Error::Undecided { .. })));
        let apart = 1e-13;
        assert_eq!(count(minimum.force_ratio * (1.0 - apart)), Ok(0));
        assert_eq!(count(minimum.force_ratio * (1.0 + apart)), Ok(1));
    }
}

#[test]
fn far_below_the_last_lobe() {
    assert_eq!(all(3.0, 1e-30, 1e30).len(), 1);
    assert!(matches!(bands(1e12, 0.0, 1e-7..=1.0), Err(Error::OutOfRange { .. })));
    assert!(matches!(bands(3.0, 0.0, 1.0..=0.5), Err(Error::EmptyRange { .. })));
    assert!(bands(-3.0, 0.0, 0.5..=1.0).is_err());
}

#[test]
fn in_physical_units() {
    // ω_n = 2, r_y = 3.
    let body = Oscillator::new(2.0, 8.0, 3.0).unwrap();
    let ratios = all(12.0, 0.1, 2.0);
    for drive in [Drive::force(36.0, 1.0), Drive::new(crate::Excitation::FootMotion, 4.5, 7.0)] {
        let found: Vec<_> =
            frequency_bands(&body, &drive.unwrap(), 0.2..=4.0).unwrap().map(Result::unwrap).collect();
        assert_eq!(found.len(), 2);
        for (a, b) in found.iter().zip(&ratios) {
            assert_eq!((a.low, a.low_edge, a.high_edge), (2.0 * b.low, b.low_edge, b.high_edge));
        }
        assert_eq!(found[1].high, 4.0);
    }
}

/// An unbalance, base motions by displacement and velocity, and a damped support: against the border on a mesh of its own.
#[test]
fn bands_of_forces_that_change_with_the_frequency() {
    use crate::Excitation;
    let mut ends = 0;
    for (i, excitation) in [
        Excitation::Unbalance,
        Excitation::SurfaceMotion,
        Excitation::SurfaceVelocity,
        Excitation::DampedFootMotion,
    ]
    .into_iter()
    .enumerate()
    {
        for j in 0..24u32 {
            let damping = [0.0, 0.02, 0.4, 3.0][j as usize % 4];
            let body = Oscillator::new(2.0, 8.0, 3.0).unwrap().with_damping(damping).unwrap();
            let amplitude = 0.3 * 1.35f64.powi(j as i32) * [1.0, 0.5, 1.0, 1.0][i];
            let drive = |omega: f64| Drive::new(excitation, amplitude, omega).unwrap();
            let excess = |omega: f64| {
                let ratios = drive(omega).ratios(&body).unwrap();
                ratios.alpha() - Border::of(&ratios).min_force_ratio
            };
            let (low, high) = (0.5, 9.0);
            let bands = frequency_bands(&body, &drive(1.0), low..=high).unwrap();
            assert!(bands.is_searched());
            let found: Vec<_> = bands.map(Result::unwrap).collect();
            for k in 0..=20_000 {
                let omega = low + (high - low) * (f64::from(k) / 20_000.0);
                let is_inside = found.iter().any(|band| (band.low..=band.high).contains(&omega));
                assert_eq!(
                    is_inside,
                    excess(omega) >= 0.0,
                    "{excitation} {amplitude} {damping} {omega} {found:?}"
                );
            }
            for band in &found {
                for (end, edge, outward) in
                    [(band.low, band.low_edge, -1.0), (band.high, band.high_edge, 1.0)]
                {
                    if edge == Edge::Border {
                        let outside = excess(end * (1.0 + outward * 1e-12));
                        assert!(
                            excess(end * (1.0 - outward * 1e-12)) > 0.0 && outside < 0.0,
                            "{end} {band:?}"
                        );
                        ends += 1;
                    }
                }
            }
        }
    }
    assert!(ends > 60, "{ends}");
    let refused = frequency_bands(&Oscillator::new(2.0, 8.0, 3.0).unwrap(), &drive_of(1.0), 3.0..=2.0);
    assert!(matches!(refused, Err(Error::EmptyRange { .. })));
}

fn drive_of(unbalance: f64) -> Drive<f64> {
    Drive::new(crate::Excitation::Unbalance, unbalance, 1.0).unwrap()
}
