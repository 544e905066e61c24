//! Floor spectra beside the Duhamel integral of the sampled absolute acceleration.

use crate::compared::{Origin::DenseSamples, near};
use crate::random::Random;
use crate::records::{RECORDS, Shaken};
use crate::sampled::{Floor, GAUSS, Machine, watched};

/// An oscillator on a floor: y and y′, and the greatest |y| and |y″ + A|.
struct Oscillator {
    frequency: f64,
    zeta: f64,
    state: [f64; 2],
    most: [f64; 2],
}

impl Oscillator {
    fn new(period: f64, zeta: f64) -> Self {
        Self { frequency: std::f64::consts::TAU / period, zeta, state: [0.0; 2], most: [0.0; 2] }
    }

    /// The free responses g and g′ to an impulse.
    fn impulse(&self, t: f64) -> [f64; 2] {
        let (decay, damped) =
            (self.zeta * self.frequency, self.frequency * (1.0 - self.zeta * self.zeta).sqrt());
        let (sine, cosine) = (damped * t).sin_cos();
        let size = (-decay * t).exp();
        [size * sine / damped, size * (cosine - decay / damped * sine)]
    }

    /// y, y′ and the absolute acceleration with its derivative, under A.
    fn quantities(&self, floor: f64) -> [[f64; 2]; 2] {
        let ([y, u], rate, square) =
            (self.state, 2.0 * self.zeta * self.frequency, self.frequency * self.frequency);
        let a = -floor - rate * u - square * y;
        [[y, u], [-rate * u - square * y, -rate * a - square * u]]
    }

    /// Moves through a part by `y(h) = free response − ∫ A(s) g(h − s) ds`.
    fn pass(&mut self, floor: &Floor) {
        let h = floor.length;
        let before = self.quantities(floor.ends[0]);
        let [y, u] = self.state;
        let (square, rate) = (self.frequency * self.frequency, 2.0 * self.zeta * self.frequency);
        let [g, dg] = self.impulse(h);
        let mut after = [y * (dg + rate * g) + u * g, u * dg - square * g * y];
        for ([place, weight], a) in GAUSS.iter().zip(floor.nodes) {
            let response = self.impulse(h * (1.0 - place));
            for (sum, response) in after.iter_mut().zip(response) {
                *sum -= weight * h * a * response;
            }
        }
        self.state = after;
        let after = self.quantities(floor.ends[1]);
        for (most, (one, two)) in self.most.iter_mut().zip(before.iter().zip(after)) {
            *most = most.max(one[0].abs()).max(two[0].abs());
            if one[1] * two[1] < 0.0 {
                *most = most.max(crest(*one, two, h));
            }
        }
    }
}

/// The extreme of the cubic with these values and slopes at its ends, regardless of sign.
fn crest([first, up]: [f64; 2], [last, down]: [f64; 2], h: f64) -> f64 {
    let (p, q) = (up * h, down * h);
    let (b, c) = (3.0 * (last - first) - 2.0 * p - q, 2.0 * (first - last) + p + q);
    let slope = |t: f64| p + t * (2.0 * b + 3.0 * c * t);
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if slope(middle) * up > 0.0 { low = middle } else { high = middle }
    }
    (first + low * (p + low * (b + low * c))).abs()
}

#[test]
fn floor_spectra_are_those_of_the_sampled_motion() {
    let mut random = Random(53);
    let mut compared = 0;
    for excitation in RECORDS {
        for _ in 0..14 {
            let mut shaken = Shaken::any(&mut random, excitation);
            shaken.times.truncate(12);
            shaken.samples.truncate(12);
            let machine = Machine {
                is_one_way: shaken.is_one_way,
                ..Machine::new(
                    [shaken.mass, shaken.stiffness, shaken.damping],
                    [
                        (shaken.friction[0] + shaken.friction[1]) / 2.0,
                        (shaken.friction[0] - shaken.friction[1]) / 2.0,
                        shaken.eta,
                    ],
                    shaken.mean,
                )
            };
            let duration = shaken.times[shaken.times.len() - 1] - shaken.times[0];
            // A body without a spring has no period of its own.
            let own = machine.period().min(duration / 2.0);
            if duration > 12.0 * own {
                continue;
            }
            let zeta = if random.next() < 0.3 { 0.0 } else { random.scale(0.005, 0.9) };
            // At the period of the body, beside it and far from it.
            let mut periods = [own, own * random.between(0.9, 1.1), own * random.scale(0.3, 4.0)];
            periods.sort_by(f64::total_cmp);
            let [x, v] = shaken.start;
            let found = shaken.body().floor_spectrum(&shaken.record(), x, v, &periods, zeta).unwrap();
            let parts = 400.0 * machine.period() / periods[0].min(own);
            let history = [&*shaken.times, &*shaken.samples];
            let sampled = watched(machine, shaken.load(), history, shaken.start, parts, true);
            if !sampled.is_over {
                continue;
            }
            let floors = sampled.found.floor.unwrap();
            for (response, period) in found.iter().zip(periods) {
                let mut oscillator = Oscillator::new(period, zeta);
                for floor in &floors {
                    oscillator.pass(floor);
                }
                // The surface stands still after the record, and so does the body.
                let (length, still) = (period / (1.0 - zeta * zeta).sqrt() / 500.0, 0.0);
                for _ in 0..500 {
                    oscillator.pass(&Floor { length, nodes: [still; 5], ends: [still; 2] });
                }
                let [y, a] = oscillator.most;
                let square = oscillator.frequency * oscillator.frequency;
                for (name, found, expected) in [
                    ("max_displacement", response.max_displacement, y),
                    ("pseudo_acceleration", response.pseudo_acceleration, square * y),
                    ("max_absolute_acceleration", response.max_absolute_acceleration, a),
                ] {
                    let output =
                        format!("record --floor-spectrum {name} by motion::record::Body::floor_spectrum");
                    near(&output, found, expected, DenseSamples, 1e-8);
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 60, "{compared}");
}

/// A body that friction holds on a surface moves its oscillators as the ground does: the step response of a damped oscillator,
/// and of a ramp without a damper.
#[test]
fn a_body_at_rest_has_the_spectrum_of_the_ground() {
    use stickslip::Excitation;
    use stickslip::motion::record::{After, Body, Record};
    let body = Body::new(2.0, 100.0).unwrap();
    let step = |samples: Vec<f64>| Record::new(Excitation::SurfaceAcceleration, 3.0, samples).unwrap();
    let (a, zeta, period) = (1.5, 0.05, 0.8);
    let record = step(vec![a, a]).followed_by(After::Hold);
    let found = body.floor_spectrum(&record, 0.0, 0.0, &[period], zeta).unwrap();
    let square = (std::f64::consts::TAU / period).powi(2);
    let over = (-std::f64::consts::PI * zeta / (1.0 - zeta * zeta).sqrt()).exp();
    let exact = a / square * (1.0 + over);
    assert!((found[0].max_displacement / exact - 1.0).abs() < 1e-12, "{found:?}");
    // After a rectangular pulse an undamped oscillator has twice the ground's displacement response times a sine.
    let record = step(vec![a, a]);
    let periods = [3.0 / 1.25, 30.0];
    let found = body.floor_spectrum(&record, 0.0, 0.0, &periods, 0.0).unwrap();
    for (response, factor) in found.iter().zip([2.0, 2.0 * (std::f64::consts::PI * 3.0 / 30.0).sin()]) {
        assert!((response.max_absolute_acceleration / (a * factor) - 1.0).abs() < 1e-12, "{response:?}");
    }
}
