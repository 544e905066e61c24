//! The closed forms with viscous damping: independent values, the motion itself, energy, limits, and the
//! functions that refuse damping.

mod digits;
mod ends;

use super::random::Random;
use std::f64::consts::PI;
use stickslip::float::Mp;
use stickslip::{Border, Cycle, Field, Float, Ratios, Response};

fn ratios<F: Float>(omega: F, zeta: F, alpha: F) -> Ratios<F> {
    Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap()
}

fn cycle(omega: f64, zeta: f64, alpha: f64) -> Cycle<f64> {
    Cycle::new(ratios(omega, zeta, alpha)).unwrap()
}

/// Every output of `tests/data/damped.csv`, with the scale of its error.
fn answers<F: Float>(omega: F, zeta: F, alpha: F) -> Vec<(&'static str, F, F)> {
    let found = Response::guarded(ratios(omega, zeta, alpha));
    let (border, c, one) = (found.border, found.cycle.as_ref().expect("non-sticking"), F::int(1));
    let phase = |x: F| if x > one { x } else { one };
    let sized = |name, x: F| (name, x, x);
    let speed = c.max_velocity;
    vec![
        sized("max_displacement", c.max_displacement),
        ("displacement_phase", c.displacement_phase, phase(c.displacement_phase)),
        sized("max_velocity", speed),
        ("velocity_phase", c.velocity_phase, phase(c.velocity_phase)),
        ("deviation", c.deviation(), if c.deviation().abs() > speed { c.deviation() } else { speed }),
        sized("min_force_ratio", border.min_force_ratio),
        sized("min_force_ratio_turning_point", border.min_force_ratio_turning_point),
        ("border_phase", border.border_phase, phase(border.border_phase)),
        sized("least_displacement", border.least_displacement),
        sized("contraction", c.contraction()),
        sized("damper_work", c.damper_work()),
    ]
}

/// The condition number of each output with respect to the inputs, by differences at 256 bits.
fn conditions(given: [f64; 3]) -> Vec<f64> {
    let at = |x: [Mp<4>; 3]| answers(x[0], x[1], x[2]);
    let (inputs, h) = (given.map(Mp::<4>::from), Mp::<4>::exp2i(-100));
    let plain = at(inputs);
    let mut sums = vec![0.0; plain.len()];
    for i in 0..3 {
        let mut other = inputs;
        other[i] *= Mp::<4>::from(1.0) + h;
        for ((sum, a), b) in sums.iter_mut().zip(&plain).zip(at(other)) {
            *sum += ((b.1 - a.1) / (a.2 * h)).abs().to_f64();
        }
    }
    sums
}

/// The worst error over all points, in units of `unit` times the condition number. For the first points, far
/// from all borders, this is the condition of the displacement with respect to α; for the others it is that
/// of each output with respect to Ω, ζ and α.
fn worst<F: Float>(read: impl Fn(&str) -> F, input: impl Fn(f64) -> F, unit: F) {
    let mut lines = include_str!("../data/damped.csv").lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let (mut points, mut failures) = (0, Vec::new());
    for line in lines {
        let cells: Vec<&str> = line.split(',').collect();
        let given = |i: usize| input(cells[i].parse::<f64>().unwrap());
        let of_displacement = cells.last().unwrap().parse::<f64>().unwrap();
        let own = conditions([0, 1, 2].map(|i| cells[i].parse().unwrap()));
        let found = answers(given(0), given(1), given(2));
        assert_eq!(found.len() + 4, names.len());
        let columns = names.iter().zip(&cells).skip(3);
        for (((name, value, size), (column, cell)), own) in found.into_iter().zip(columns).zip(own) {
            assert_eq!(name, *column);
            let only_alpha = points < 14 && name != "least_displacement";
            let condition = if only_alpha { of_displacement } else { own }.max(1.0);
            let error = ((value - read(cell)) / (size * unit)).abs().to_f64() / condition;
            if error > 4.0 {
                failures.push(format!("{name} at {}: {value} for {cell}, {error:.1}", cells[..3].join(" ")));
            }
        }
        points += 1;
    }
    assert_eq!((points, failures), (30, Vec::<String>::new()));
}

#[test]
fn four_units_in_the_last_place_at_double_precision() {
    worst(|text| text.parse().unwrap(), |x| x, f64::EPSILON);
}

#[test]
fn all_digits_of_the_reference_at_256_bits() {
    worst(|text| text.parse().unwrap(), Mp::<4>::from, Mp::<4>::from(1e-44));
}

/// The motion itself: slides in closed form, whose ends are found by scanning for the zero of the velocity.
struct Machine {
    omega: f64,
    zeta: f64,
    alpha: f64,
}

impl Machine {
    fn driven(&self, theta: f64) -> (f64, f64) {
        let (s, c) = (2.0 * self.zeta * self.omega, 1.0 - self.omega * self.omega);
        let (size, lag) = (self.alpha / s.hypot(c), s.atan2(c));
        (size * (theta - lag).sin(), size * self.omega * (theta - lag).cos())
    }

    /// The state (x, x′/ω_n) at the natural time t after a state at the phase θ, sliding with the given sign
    /// of the velocity.
    fn slid(&self, theta: f64, x: f64, v: f64, sign: f64, t: f64) -> (f64, f64) {
        let (from, to, zeta) = (self.driven(theta), self.driven(theta + self.omega * t), self.zeta);
        let (x0, v0) = (x + sign - from.0, v - from.1);
        let square = 1.0 - zeta * zeta;
        let d = square.abs().sqrt();
        let (c, s) = match square {
            0.0 => (1.0, t),
            _ if square > 0.0 => ((d * t).cos(), (d * t).sin() / d),
            _ => ((d * t).cosh(), (d * t).sinh() / d),
        };
        let decay = (-zeta * t).exp();
        let free = (decay * (x0 * c + (v0 + zeta * x0) * s), decay * (v0 * c - (zeta * v0 + x0) * s));
        (free.0 - sign + to.0, free.1 + to.1)
    }

    /// The motion from one reversal (θ, x) to the next, and whether the body sticks there.
    fn half_turn(&self, theta: f64, x: f64, sign: f64) -> (f64, f64, bool) {
        let step = 0.004f64.min(0.004 / self.omega);
        let speed = |t: f64| sign * self.slid(theta, x, 0.0, sign, t).1;
        let mut t = step;
        while speed(t) > 0.0 {
            t += step;
        }
        let (mut low, mut high) = (t - step, t);
        for _ in 0..60 {
            let middle = low + (high - low) / 2.0;
            if speed(middle) > 0.0 { low = middle } else { high = middle }
        }
        let (theta, x) = (theta + self.omega * high, self.slid(theta, x, 0.0, sign, high).0);
        (theta, x, (self.alpha * theta.sin() - x).abs() < 1.0)
    }
}

/// (Ω, ζ) over the plane: below and above 1/2, near 1/n, under- and overdamped.
fn plane(random: &mut Random) -> (f64, f64) {
    let omega = match random.bits() % 3 {
        0 => 10f64.powf(random.between(-1.2, 0.7)),
        1 => (1.0 + random.between(-0.05, 0.05)) / (1 + random.bits() % 7) as f64,
        _ => random.between(0.2, 0.6),
    };
    (omega, 10f64.powf(random.between(-3.5, 0.4)))
}

#[test]
fn the_cycle_is_the_motion_and_its_border_is_where_it_stops() {
    let mut random = Random(16);
    for _ in 0..150 {
        let (omega, zeta) = plane(&mut random);
        let least = Border::of(&ratios(omega, zeta, 1.0)).min_force_ratio;
        let run = |over: f64, from: f64, half_turns: u32| {
            let c = cycle(omega, zeta, least * from);
            let machine = Machine { omega, zeta, alpha: least * over };
            let (mut theta, mut x, mut sign) = (c.displacement_phase, c.max_displacement, -1.0);
            let mut stops = false;
            for _ in 0..half_turns {
                let (next, end, sticks) = machine.half_turn(theta, x, sign);
                // Near a pole 1/(2n+1) the body may reverse more often instead of stopping, as without
                // damping.
                stops = sticks || next - theta < 0.9 * PI;
                (theta, x, sign) = (next, end, -sign);
                if stops {
                    break;
                }
            }
            (stops, x.abs(), c.max_displacement)
        };
        let (stops, reached, max) = run(1.002, 1.002, 10);
        assert!(!stops, "{omega} {zeta}");
        assert!((reached / max - 1.0).abs() < 1e-7, "{omega} {zeta}: {reached} {max}");
        // Near resonance, a lightly damped motion takes a thousand turns to settle.
        let (stops, ..) = run(0.998, 1.0 + 1e-9, 5000);
        assert!(stops, "{omega} {zeta} must stop below the border, or reverse more often");
    }
}

#[test]
fn no_velocity_of_the_cycle_is_greater_or_negative() {
    let mut random = Random(17);
    for _ in 0..400 {
        let (omega, zeta) = plane(&mut random);
        let least = Border::of(&ratios(omega, zeta, 1.0)).min_force_ratio;
        let c = cycle(omega, zeta, least * (1.0 + 10f64.powf(random.between(-9.0, 1.0))));
        let count = (300.0 / omega.min(1.0)) as u32;
        let mut greatest = 0.0f64;
        for i in 0..count {
            let phase = c.displacement_phase + PI * (1.0 + f64::from(i) / f64::from(count));
            let v = c.velocity_at(phase);
            assert!(v >= -1e-12 * c.max_velocity, "{omega} {zeta}: {v:e}");
            greatest = greatest.max(v);
        }
        let ratio = greatest / c.max_velocity;
        assert!(ratio <= 1.0 + 1e-14 && ratio > 0.99, "{omega} {zeta}: {ratio}");
        let at = |phase: f64| (c.displacement_at(phase), c.velocity_at(phase));
        let close = |a: f64, b: f64| assert!((a - b).abs() < 1e-11 * c.max_velocity.max(c.max_displacement));
        close(at(c.displacement_phase).0, c.max_displacement);
        close(at(c.velocity_phase).1, c.max_velocity);
        close(at(c.velocity_phase).0, c.deviation());
    }
}

#[test]
fn what_the_drive_gives_friction_and_the_damper_take() {
    let mut random = Random(18);
    for _ in 0..2000 {
        let (omega, zeta) = plane(&mut random);
        let least = Border::of(&ratios(omega, zeta, 1.0)).min_force_ratio;
        let alpha = least * (1.0 + 10f64.powf(random.between(-1.0, 2.0)));
        let c = cycle(omega, zeta, alpha);
        // ∮ α sin θ dx: the work is that of the first harmonic, the response to the drive and to the square
        // wave of friction, whose amplitude is 4/π.
        let (s, k) = (2.0 * zeta * omega, 1.0 - omega * omega);
        let (q, lag) = (s.hypot(k), s.atan2(k));
        let work = PI * alpha * alpha * s / (q * q) + 4.0 * alpha / q * (c.displacement_phase + lag).sin();
        let taken = 4.0 * c.max_displacement + c.damper_work();
        let scale = PI * alpha * alpha * s / (q * q) + 4.0 * alpha / q;
        assert!((work - taken).abs() < 1e-13 * scale, "{omega} {zeta} {alpha}: {work} {taken}");
        assert!(c.damper_work() > 0.0);
    }
}

#[test]
fn multipliers_are_those_of_the_differenced_map() {
    for (omega, zeta, alpha) in [
        (0.7, 0.05, 2.4),
        (0.4, 0.05, 9.0),
        (1.3, 0.2, 5.0),
        (1.0, 0.02, 3.0),
        (0.8, 1.0, 9.0),
        (0.9, 1.6, 14.0),
    ] {
        let (c, machine) = (cycle(omega, zeta, alpha), Machine { omega, zeta, alpha });
        let (theta, x) = (c.displacement_phase, c.max_displacement);
        // The map of half a turn with the mirror image: (θ, x) ↦ (θ′ − π, −x′).
        let map = |dt: f64, dx: f64| {
            let (t, y, _) = machine.half_turn(theta + dt, x + dx, -1.0);
            (t - PI - theta, -y - x)
        };
        let h = 1e-5;
        let slope = |a: (f64, f64), b: (f64, f64)| ((a.0 - b.0) / (2.0 * h), (a.1 - b.1) / (2.0 * h));
        let (by_t, by_x) = (slope(map(h, 0.0), map(-h, 0.0)), slope(map(0.0, h), map(0.0, -h)));
        let (trace, product) = (by_t.0 + by_x.1, by_t.0 * by_x.1 - by_t.1 * by_x.0);
        let [(re, im), (other, _)] = c.multipliers().half_cycle;
        let found = (re + other, if im == 0.0 { re * other } else { re * re + im * im });
        assert!(
            (found.0 - trace).abs() < 1e-7 && (found.1 - product).abs() < 1e-7,
            "{omega} {zeta}: {found:?}"
        );
        assert!((c.contraction() - re.hypot(im)).abs() < 1e-14);
    }
}

#[test]
fn without_a_damper_in_the_limit() {
    for (omega, alpha) in [(0.3, 14.0), (0.4, 9.0), (0.7, 2.0), (1.0 + 1e-6, 1.5), (1.5, 2.5), (30.0, 4.0)] {
        let (damped, plain) =
            (Response::new(ratios(omega, 1e-14, alpha)), Response::new(ratios(omega, 0.0, alpha)));
        let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-7 * b.abs(), "{omega} {alpha}: {a} {b}");
        let (a, b) = (damped.cycle.unwrap(), plain.cycle.unwrap());
        close(a.max_displacement, b.max_displacement);
        close(a.displacement_phase, b.displacement_phase);
        close(a.max_velocity, b.max_velocity);
        close(a.velocity_phase, b.velocity_phase);
        close(a.contraction(), b.contraction());
        close(damped.border.min_force_ratio, plain.border.min_force_ratio);
        close(damped.best_force_ratio, plain.best_force_ratio);
        close(damped.loop_size_inertia.unwrap(), plain.loop_size_inertia.unwrap());
        close(damped.best_loop_size.unwrap(), plain.best_loop_size.unwrap());
        assert_eq!(b.damper_work(), 0.0);
    }
}

fn size_exists(omega: f64, zeta: f64) -> bool {
    Response::new(ratios(omega, zeta, 50.0)).best_is_reached()
}

#[test]
fn no_force_ratio_makes_a_larger_loop() {
    for (omega, zeta) in [(1.5, 0.05), (2.0, 0.3), (1.2, 0.01), (3.0, 1.2)] {
        let found = Response::new(ratios(omega, zeta, 50.0));
        let best = found.best_force_ratio;
        let size = |alpha: f64| Response::new(ratios(omega, zeta, alpha)).loop_size_stiffness;
        if let Some(at_best) = size(best) {
            assert!((at_best / found.best_loop_size.unwrap() - 1.0).abs() < 1e-13, "{omega} {zeta}");
            for i in 1..200 {
                let other = size(best * (0.9 + 0.01 * f64::from(i)));
                assert!(other.is_none_or(|a| a <= at_best * (1.0 + 1e-15)), "{omega} {zeta}");
            }
        } else {
            assert!(!found.best_is_reached());
        }
    }
    assert!(size_exists(1.5, 0.05));
}
