//! The stiffness that dissipates most with a damper, wherever the range ends beside the optimum.

use crate::random::Random;
use stickslip::design::{OptimumKind, most_dissipating_stiffness};
use stickslip::{Cycle, Drive, Error, Oscillator};

/// m = ω_d = r_y = 1: the stiffness is 1/Ω², and c = 2γ.
struct Question {
    alpha: f64,
    gamma: f64,
    low: f64,
    high: f64,
}

impl Question {
    fn body(&self, stiffness: f64) -> Oscillator<f64> {
        Oscillator::new(1.0, stiffness, 1.0).unwrap().with_damping(2.0 * self.gamma).unwrap()
    }

    fn drive(&self) -> Drive<f64> {
        Drive::force(self.alpha, 1.0).unwrap()
    }

    /// The work of friction in a cycle; 0 where the body sticks.
    fn energy(&self, stiffness: f64) -> f64 {
        let body = self.body(stiffness);
        let cycle = self.drive().ratios(&body).and_then(Cycle::new);
        cycle.map_or(0.0, |c| 4.0 * c.max_displacement * body.friction_displacement())
    }

    /// The best stiffness of a mesh that resolves the resonance, the poles and both ends of the range, refined
    /// around its best points.
    fn dense(&self) -> (f64, f64) {
        let top = self.high.min(1.0 + self.alpha);
        let mut places = vec![self.low, self.high];
        places.extend((0..=200).map(|i| self.low * (top / self.low).powf(f64::from(i) / 200.0)));
        let mut around = |centre: f64, width: f64, most: f64| {
            let mut off = width;
            while off < most {
                places.extend([centre - off, centre + off]);
                off *= 1.4;
            }
        };
        around(self.low, 1e-10 * self.low, self.low);
        around(self.high, 1e-10 * self.high, self.high);
        let first = ((self.low.sqrt() as i32) / 2 * 2 - 1).max(1);
        for n in (first..first + 40).step_by(2).map(f64::from).take_while(|n| *n < top.sqrt() + 2.0) {
            around(n * n, self.gamma * n / 32.0, 4.0 * n + 2.0);
        }
        places.retain(|v| *v >= self.low && *v <= self.high);
        places.sort_by(f64::total_cmp);
        let found: Vec<f64> = places.iter().map(|v| self.energy(*v)).collect();
        let mut peaks: Vec<usize> = (0..places.len())
            .filter(|&i| {
                found[i] >= found[i.saturating_sub(1)] && found[i] >= found[(i + 1).min(found.len() - 1)]
            })
            .collect();
        peaks.sort_by(|a, b| found[*b].total_cmp(&found[*a]));
        let mut best = peaks.first().map_or((self.low, 0.0), |&i| (places[i], found[i]));
        for &i in peaks.iter().take(3) {
            let (mut low, mut high) = (places[i.saturating_sub(1)], places[(i + 1).min(places.len() - 1)]);
            for _ in 0..60 {
                let third = (high - low) / 3.0;
                let (left, right) = (low + third, high - third);
                let (at_left, at_right) = (self.energy(left), self.energy(right));
                for (v, energy) in [(left, at_left), (right, at_right)] {
                    if energy > best.1 {
                        best = (v, energy);
                    }
                }
                if at_left >= at_right { high = right } else { low = left }
            }
        }
        best
    }

    /// Nothing is better than the answer, and the answer is that of the cycle there.
    fn check(&self) -> Option<OptimumKind> {
        let Self { alpha, gamma, low, high } = *self;
        let (at, energy) = self.dense();
        // Δ₀ = a − G: near α = 4/π two numbers are subtracted that are as large as at the resonance, 8γ/π|Z₁|².
        let shift = 8.0 / std::f64::consts::PI * gamma / ((at - 1.0).powi(2) + 4.0 * gamma * gamma);
        let slack = 1e-10 + 1e-14 * shift * 4.0 / energy.max(1.0);
        match most_dissipating_stiffness(&self.body(1.0), &self.drive(), low..=high) {
            Ok(best) => {
                assert!(low <= best.at && best.at <= high, "{alpha} {gamma} {low} {high}: {best:?}");
                // The refinement of the mesh ends at 1e-10 of the energy.
                assert!(
                    energy <= best.value * (1.0 + slack),
                    "α = {alpha}, γ = {gamma}, {low} to {high}: {best:?}, but {energy} at {at}"
                );
                // On the border rounding may decide for sticking.
                let there = [0.0, -1e-14, 1e-14].map(|off| self.energy(best.at * (1.0 + off)));
                let there = there.into_iter().find(|energy| *energy > 0.0).unwrap_or(0.0);
                assert!(
                    (there / best.value - 1.0).abs() < 10.0 * slack,
                    "{alpha} {gamma} {low} {high}: {best:?} {there}"
                );
                Some(best.kind)
            }
            Err(Error::SticksThroughout { .. }) => {
                assert!(energy == 0.0, "{alpha} {gamma} {low} {high}: {energy} at {at}");
                None
            }
            Err(error) => panic!("{alpha} {gamma} {low} {high}: {error}"),
        }
    }
}

fn force_ratio(random: &mut Random) -> f64 {
    match random.bits() % 4 {
        0 => random.between(1.2, 1.4),
        1 => {
            4.0 / std::f64::consts::PI
                + random.scale(1e-9, 0.1) * if random.bits().is_multiple_of(2) { 1.0 } else { -1.0 }
        }
        2 => random.scale(1.3, 10.0),
        _ => random.scale(2.0, 3e3),
    }
}

#[test]
fn no_stiffness_is_better_than_the_best() {
    let mut random = Random(31);
    let mut inside = 0;
    for _ in 0..300 {
        let (alpha, gamma) = (force_ratio(&mut random), random.scale(1e-7, 3.0));
        let low = random.scale(0.02, 1.0 + alpha);
        let high = low * (1.0 + random.scale(1e-6, 1e3));
        let kind = Question { alpha, gamma, low, high }.check();
        inside += u32::from(kind == Some(OptimumKind::Interior));
    }
    assert!(inside > 20, "{inside}");
}

/// One or both ends of the range 1e-6 to 0.5 of the optimum away from it.
#[test]
fn no_end_of_the_range_hides_the_optimum() {
    let mut random = Random(32);
    let (mut asked, mut inside) = (0, 0);
    while asked < 300 {
        let (alpha, gamma) = (force_ratio(&mut random), random.scale(1e-7, 3.0));
        let low = random.scale(0.3, (1.0 + alpha).min(200.0));
        let high = low * (1.0 + random.scale(1e-2, 20.0));
        let (at, energy) = Question { alpha, gamma, low, high }.dense();
        if energy == 0.0 {
            continue;
        }
        let (off, width) = (at * random.scale(1e-6, 0.5), at * random.scale(1e-6, 5.0));
        let (low, high) = match random.bits() % 4 {
            0 => (at + off, at + off + width),
            1 => ((at - off - width).max(at * 1e-3), at - off),
            2 => (at - off, at + width),
            _ => ((at - width).max(at * 1e-3), at + off),
        };
        let kind = Question { alpha, gamma, low, high }.check();
        inside += u32::from(kind == Some(OptimumKind::Interior));
        asked += 1;
    }
    assert!(inside > 40, "{inside}");
}

/// A weak damper and an end of the range just beyond the resonance: 4787 and 9.33 kN·m before.
#[test]
fn a_narrow_resonance_beside_an_end() {
    let body = Oscillator::new(1.0, 1.0, 1.0).unwrap().with_damping(0.0004).unwrap();
    let best = most_dissipating_stiffness(&body, &Drive::force(24.0, 1.0).unwrap(), 0.4..=1.02).unwrap();
    assert!((best.value / 227_267.6f64 - 1.0).abs() < 1e-6 && (best.at - 1.0).abs() < 1e-7, "{best:?}");
    let body = Oscillator::new(50e3, 1.0, 5e3).unwrap().with_damping(6.3e3).unwrap();
    let drive = Drive::force(30e3, std::f64::consts::TAU).unwrap();
    let best = most_dissipating_stiffness(&body, &drive, 1e6..=2.01e6).unwrap();
    assert!(
        (best.value / 11_941.0f64 - 1.0).abs() < 1e-3 && (best.at / 1_973.9e3 - 1.0).abs() < 1e-4,
        "{best:?}"
    );
    assert_eq!(best.kind, OptimumKind::Interior);
}
