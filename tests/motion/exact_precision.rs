//! The exact motion at any precision: against the closed forms where it does not stick, N bits against 2N where it does.

use stickslip::exact::{LongRun, State, SteadyState};
use stickslip::float::mp::Mp;
use stickslip::{Cycle, Float, Ratios};

fn ratios<F: Float>((p, q): (i32, i32), (r, s): (i32, i32)) -> Ratios<F> {
    Ratios::new(F::ratio(p, q), F::ratio(r, s)).unwrap()
}

fn steady<F: Float>(ratios: Ratios<F>, start: State<F>) -> SteadyState<F> {
    match LongRun::from_start(ratios, start).unwrap() {
        LongRun::Periodic(steady) => steady,
        other => panic!("{ratios:?}: {other:?}"),
    }
}

/// |a − b| in units in the last place of `scale`.
fn ulps<F: Float>(a: F, b: F, scale: F) -> f64 {
    ((a - b).abs() / (F::epsilon() * scale.abs())).to_f64()
}

fn matches_the_closed_form<F: Float>() {
    for (omega, alpha) in [
        ((7, 10), (2, 1)),
        ((3, 2), (5, 2)),
        ((2, 5), (7, 1)),
        ((51, 50), (2, 1)),
        ((3, 1), (4, 1)),
        ((9, 40), (60, 1)),
    ] {
        let ratios = ratios::<F>(omega, alpha);
        let cycle = Cycle::new(ratios).unwrap();
        // The loss of digits by the contraction, as in `exact_motion`.
        let condition = (1.0 + 1.0 / ratios.omega().to_f64()) * 8.0 / (1.0 - cycle.contraction().to_f64());
        for s in
            [steady(ratios, State::rest()), *SteadyState::from_cycle(&cycle).unwrap().steady_state().unwrap()]
        {
            let x = ulps(s.max_displacement(), cycle.max_displacement(), cycle.max_displacement());
            let v = ulps(s.max_velocity(), cycle.max_velocity(), cycle.max_velocity());
            let energy = ulps(s.energy_in(), s.energy_out(), s.energy_out());
            let lambda = ulps(s.contraction(), cycle.contraction().square(), F::int(1));
            assert!(x < 4.0 * condition && v < 4.0 * condition, "{omega:?} {alpha:?}: {x} {v} {condition}");
            assert!(energy < 100.0 * condition, "{omega:?} {alpha:?}: {energy}");
            assert!(lambda < 1e3 * condition, "{omega:?} {alpha:?}: {lambda}");
        }
    }
}

#[test]
fn the_closed_forms_to_the_last_places() {
    matches_the_closed_form::<f64>();
    matches_the_closed_form::<Mp<4>>();
    matches_the_closed_form::<Mp<16>>();
}

#[test]
fn twice_the_bits_agree_where_it_sticks() {
    for (omega, alpha, zeros) in [
        ((2, 5), (6, 1), 4),
        ((1, 10), (3, 1), 4),
        ((1, 2), (2, 1), 2),
        ((7, 10), (6, 5), 2),
        ((4, 5), (11, 10), 2),
    ] {
        let few = steady(ratios::<Mp<4>>(omega, alpha), State::rest());
        let many = steady(ratios::<Mp<8>>(omega, alpha), State::rest());
        assert_eq!(few.velocity_zeros_per_cycle(), zeros);
        let pairs = [
            (few.max_displacement(), many.max_displacement()),
            (few.max_velocity(), many.max_velocity()),
            (few.stick_fraction(), many.stick_fraction()),
        ];
        for (a, b) in pairs {
            let error = ((Mp::<8>::from_rug(&a.to_rug()) - b) / b).abs().to_f64();
            assert!(error < 2f64.powi(-240), "{omega:?} {alpha:?}: {error:e}");
        }
    }
}
