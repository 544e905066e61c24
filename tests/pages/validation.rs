//! The numbers of docs/development/validation.md are those of the library.

use std::f64::consts::TAU;
use stickslip::design::{TurningPoints, identify_turning_points};
use stickslip::motion::record::{Body, Record};
use stickslip::motion::{FreeDecay, LongRun, State, SteadyState};
use stickslip::{Border, Cycle, Excitation, Ratios};

/// The steady motion from rest.
fn steady(omega: f64, alpha: f64, zeta: f64, eta: f64) -> SteadyState<f64> {
    let ratios = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
    let ratios = ratios.with_static_friction_ratio(eta).unwrap();
    *LongRun::from_start(ratios, State::default()).unwrap().steady_state().unwrap()
}

/// The amplitude at a reading of a free decay, with friction and damping fitted to all sixteen readings in mm, one every
/// 5 s. From reading to reading the amplitude A becomes q A − d, as from cycle to cycle with another q and d.
fn fitted(reading: u64) -> f64 {
    let readings =
        [70.0, 62.0, 54.0, 46.0, 41.0, 37.0, 31.0, 27.0, 23.0, 21.0, 18.0, 15.0, 13.0, 10.0, 7.0, 5.0];
    let found = identify_turning_points(&readings, None, TurningPoints::EveryCycle).unwrap();
    let (unit, zeta) = (found.friction_displacement.value, found.damping_ratio.value);
    let decay = FreeDecay::new(found.amplitude.value / unit, 0.0, zeta, 1.0).unwrap();
    decay.turning_point(2 * (reading - 1)).unwrap().1 * unit
}

/// The value of each row.
fn value(row: usize) -> f64 {
    let by_continuation = || steady(TAU / 8.667, 1.5, 0.05, 1.1);
    match row {
        1 => FreeDecay::new(12.0, 6.0, 0.0, 1.0).unwrap().rest_position,
        2 => steady(0.9, 1.5, 0.05, 1.1).max_displacement.value,
        3 => by_continuation().max_displacement.value,
        4 => by_continuation().stick_fraction * 8.667 / f64::from(by_continuation().sticks_per_cycle),
        5 => f64::from(steady(0.03, 3.0, 0.0, 1.0).sticks_per_cycle),
        6 => 1.0 / Border::new(1.0).unwrap().min_force_ratio,
        7 => {
            let g = 9.80665;
            let pulse = Record::new(Excitation::SurfaceAcceleration, 1.0, vec![-0.3 * g; 2]).unwrap();
            Body::new(1.0, 0.1 * g).unwrap().follow(&pulse).unwrap().residual_displacement.unwrap()
        }
        8 => {
            let decay = FreeDecay::new(20.0, 0.0, 0.0, 1.0).unwrap();
            let turn = |n| decay.turning_point(n).unwrap().1;
            turn(0) - turn(2)
        }
        9 => Cycle::new(Ratios::new(0.5, 3.0).unwrap()).unwrap().contraction(),
        10 => Border::new(2.0).unwrap().min_force_ratio,
        11 => fitted(8),
        12 => fitted(16),
        _ => panic!("row {row} has no computation"),
    }
}

#[test]
fn every_row_is_computed() {
    let page = include_str!("../../docs/development/validation.md");
    let rows: Vec<Vec<&str>> = page
        .lines()
        .filter_map(|line| Some(line.strip_prefix("| ")?.strip_suffix(" |")?.split(" | ").collect()))
        .filter(|cells: &Vec<&str>| cells.len() == 6 && cells[0].parse::<usize>().is_ok())
        .collect();
    assert_eq!(rows.len(), 12);
    for (place, cells) in (1..).zip(rows) {
        let [row, _, _, theirs, ours, difference] = cells[..] else { panic!("{cells:?}") };
        assert_eq!(row.parse(), Ok(place));
        let (theirs, value): (f64, f64) = (theirs.split(' ').next().unwrap().parse().unwrap(), value(place));
        let decimals = ours.split_once('.').map_or(0, |(_, digits)| digits.len());
        assert_eq!(format!("{value:.decimals$}"), ours, "row {row}");
        let off = value - theirs;
        if difference == "0" {
            assert!(off.abs() <= 4.0 * f64::EPSILON * theirs, "row {row}: {off:e}");
        } else {
            assert_eq!(format!("{off:.3e}"), difference, "row {row}");
        }
    }
}
