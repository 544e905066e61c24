//! Each prescribed motion beside small steps: the other side of a contact, the end of a spring, the base and a body that is moved, each by a
//! displacement, a velocity and an acceleration, as waves and as a record.
//!
//! The steps are those of Runge and Kutta between the samples. The motion is its formula here: straight lines of a record, or of the
//! displacement of a base the cubic on which its samples lie.

use crate::place::{Place, place};
use std::f64::consts::TAU;
use std::path::Path;
use stickslip_front::system::{NamedSystem, parsed};

/// The times of a record.
const TIMES: [f64; 5] = [0.0, 0.35, 0.9, 1.3, 2.0];

#[derive(Clone, Copy, PartialEq, Debug)]
enum By {
    Displacement,
    Velocity,
    Acceleration,
}

/// A motion: its displacement, velocity and acceleration at a time within the record or the wave.
#[derive(Clone, Copy)]
enum Motion {
    /// `amplitude · sin(4 t + 0.3)` of the quantity.
    Wave(By, f64),
    /// Straight lines between values of the quantity.
    Lines(By, [f64; 5]),
    /// A cubic displacement, whose values are the record.
    Cubic([f64; 4]),
}

impl Motion {
    fn at(&self, t: f64) -> [f64; 3] {
        match *self {
            Self::Wave(by, a) => {
                let (sin, cos) = (4.0 * t + 0.3).sin_cos();
                let size = match by {
                    By::Displacement => a,
                    By::Velocity => a / 4.0,
                    By::Acceleration => a / 16.0,
                };
                // The velocity of a wave of the acceleration has the mean 0.
                match by {
                    By::Displacement => [size * sin, 4.0 * size * cos, -16.0 * size * sin],
                    By::Velocity => [-size * (cos - 0.3_f64.cos()), 4.0 * size * sin, 16.0 * size * cos],
                    By::Acceleration => [-size * (sin - 0.3_f64.sin()), -4.0 * size * cos, 16.0 * size * sin],
                }
            }
            Self::Lines(by, values) => {
                let (mut place, mut speed) = (0.0, 0.0);
                for i in 0..4 {
                    let (a, b) = (TIMES[i], TIMES[i + 1]);
                    let (h, slope) = (t.min(b) - a, (values[i + 1] - values[i]) / (b - a));
                    let value = values[i] + slope * h;
                    let is_here = t <= b;
                    match by {
                        By::Displacement if is_here => return [value, slope, 0.0],
                        By::Displacement => {}
                        By::Velocity => {
                            place += values[i] * h + slope * h * h / 2.0;
                            if is_here {
                                return [place, value, slope];
                            }
                        }
                        By::Acceleration => {
                            place += speed * h + values[i] * h * h / 2.0 + slope * h * h * h / 6.0;
                            speed += values[i] * h + slope * h * h / 2.0;
                            if is_here {
                                return [place, speed, value];
                            }
                        }
                    }
                }
                panic!("{t} is beyond the record")
            }
            Self::Cubic([a, b, c, d]) => {
                [a + t * (b + t * (c + t * d)), b + t * (2.0 * c + t * 3.0 * d), 2.0 * c + 6.0 * d * t]
            }
        }
    }
}

/// What is moved.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Moved {
    Side,
    End,
    Base,
    Body,
}

/// m = 2 on k = 5 and c = 0.4 with the friction 3.
const M: f64 = 2.0;
const K: f64 = 5.0;
const C: f64 = 0.4;
const R: f64 = 3.0;

/// The force on the body but for friction, at a displacement and a velocity.
fn force(of: Moved, motion: &Motion, t: f64, [x, v]: [f64; 2]) -> f64 {
    let [u, w, a] = motion.at(t);
    match of {
        Moved::Side | Moved::Body => -K * x - C * v,
        Moved::End => -K * (x - u) - C * (v - w),
        Moved::Base => -K * x - C * v - M * a,
    }
}

/// The velocity and the acceleration of what the body slides on.
fn side(of: Moved, motion: &Motion, t: f64) -> [f64; 2] {
    let [_, w, a] = motion.at(t);
    if matches!(of, Moved::Side | Moved::Body) { [w, a] } else { [0.0; 2] }
}

/// The displacement and the velocity of a body after a time, from rest at 0.
fn stepped(of: Moved, motion: &Motion, until: f64) -> [f64; 2] {
    const STEPS: u32 = 4000;
    let mut z = [0.0, 0.0];
    let mut pieces: Vec<f64> = TIMES.iter().copied().filter(|t| *t < until).collect();
    pieces.push(until);
    for pair in pieces.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        // Formulae just inside the piece.
        let inside = |t: f64| t.clamp(from + 1e-12, to - 1e-12);
        let holds = |t: f64, z: [f64; 2]| {
            let [_, a] = side(of, motion, inside(t));
            force(of, motion, inside(t), z) - M * a
        };
        let begin = |t: f64, z: &mut [f64; 2]| {
            let [w, _] = side(of, motion, inside(t));
            if (z[1] - w).abs() > 1e-10 {
                return (z[1] - w).signum();
            }
            z[1] = w;
            let needed = holds(t, *z);
            if needed.abs() <= R { 0.0 } else { needed.signum() }
        };
        let rate = |t: f64, z: [f64; 2], direction: f64| {
            let [w, a] = side(of, motion, inside(t));
            if direction == 0.0 {
                [w, a]
            } else {
                [z[1], (force(of, motion, inside(t), z) - direction * R) / M]
            }
        };
        let step = |t: f64, z: [f64; 2], direction: f64, h: f64| {
            let plus = |k: [f64; 2], by: f64| [z[0] + by * k[0], z[1] + by * k[1]];
            let one = rate(t, z, direction);
            let two = rate(t + h / 2.0, plus(one, h / 2.0), direction);
            let three = rate(t + h / 2.0, plus(two, h / 2.0), direction);
            let four = rate(t + h, plus(three, h), direction);
            [0, 1].map(|i| z[i] + h / 6.0 * (one[i] + 2.0 * two[i] + 2.0 * three[i] + four[i]))
        };
        let (mut t, h) = (from, (to - from) / f64::from(STEPS));
        let mut direction = begin(t, &mut z);
        while t < to - 1e-12 {
            let h = h.min(to - t);
            let over = |t: f64, z: [f64; 2]| match direction {
                0.0 => holds(t, z).abs() > R,
                _ => direction * (z[1] - side(of, motion, inside(t))[0]) < 0.0,
            };
            let next = step(t, z, direction, h);
            if !over(t + h, next) {
                (t, z) = (t + h, next);
                continue;
            }
            let (mut low, mut high) = (0.0, h);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if over(t + middle, step(t, z, direction, middle)) { high = middle } else { low = middle }
            }
            z = step(t, z, direction, high);
            t += high;
            if direction == 0.0 {
                direction = holds(t, z).signum();
            } else {
                z[1] = side(of, motion, inside(t))[0];
                let needed = holds(t, z);
                direction = if needed.abs() <= R { 0.0 } else { needed.signum() };
            }
        }
    }
    z
}

/// The file of the machine whose side, end, base or first body is moved as a text says.
fn file(of: Moved, moves: &str) -> String {
    let spring = format!("stiffness = {K}\ndamping = {C}\n");
    let friction = format!("name = \"pad\"\nfriction = {R}\n");
    let body = "[[springs]]\nbetween = [\"ground\", \"body\"]\n";
    let contact = "[[contacts]]\nbetween = [\"ground\", \"body\"]\n";
    match of {
        Moved::Side => {
            format!(
                "units = \"N,m\"\nmasses = {{ body = {M} }}\n{body}{spring}{contact}{friction}moves = {moves}\n"
            )
        }
        Moved::End => {
            format!(
                "units = \"N,m\"\nmasses = {{ body = {M} }}\n{body}{spring}moves = {moves}\n{contact}{friction}"
            )
        }
        Moved::Base => format!(
            "units = \"N,m\"\nmasses = {{ body = {M} }}\n{body}{spring}{contact}{friction}[base]\n{}\n",
            moves.trim_start_matches('{').trim_end_matches('}')
        ),
        Moved::Body => format!(
            "units = \"N,m\"\n[masses]\nbody = {M}\nplate = {{ moves = {moves} }}\n{body}{spring}[[contacts]]\nbetween = [\"plate\", \
             \"body\"]\n{friction}"
        ),
    }
}

/// The end of the motion of a file.
fn followed(text: &str, folder: &Path, until: f64) -> [f64; 2] {
    let value = parsed(text, "machine.toml").unwrap();
    let named = NamedSystem::new(&value, [], folder, None).unwrap_or_else(|e| panic!("{e}\n{text}"));
    let (motion, _) = named.simulate(&named.described.start, until).unwrap_or_else(|e| panic!("{e}\n{text}"));
    [motion.end.displacement[0], motion.end.velocity[0]]
}

fn folder(name: &str, rows: &[(f64, f64)]) -> Place {
    with_column(name, "value", rows)
}

/// A folder with a record, whose column of values has this name.
fn with_column(name: &str, column: &str, rows: &[(f64, f64)]) -> Place {
    let folder = place(name);
    std::fs::create_dir(&*folder).unwrap();
    let rows: String = rows.iter().map(|(t, x)| format!("{t},{x}\n")).collect();
    std::fs::write(folder.join("record.csv"), format!("time,{column}\n{rows}")).unwrap();
    folder
}

const WORDS: [(By, &str); 3] =
    [(By::Displacement, "displacement"), (By::Velocity, "velocity"), (By::Acceleration, "acceleration")];

#[test]
fn every_prescribed_motion_is_that_of_small_steps() {
    let records = [[0.0, 0.9, -0.4, 0.6, 0.2], [0.0, 3.0, -2.0, 2.5, 1.0], [0.0, 9.0, -8.0, 4.0, -3.0]];
    let mut moving = 0;
    for (place, of) in [Moved::Side, Moved::End, Moved::Base, Moved::Body].into_iter().enumerate() {
        for ((by, word), values) in WORDS.into_iter().zip(records) {
            let cubic = [0.0, 0.3, 4.0, -1.9];
            let is_smooth = (of, by) == (Moved::Base, By::Displacement);
            let lines = if is_smooth { Motion::Cubic(cubic) } else { Motion::Lines(by, values) };
            let rows: Vec<_> = TIMES
                .iter()
                .zip(values)
                .map(|(&t, value)| (t, if is_smooth { lines.at(t)[0] } else { value }))
                .collect();
            let column = if by == By::Acceleration { word } else { "value" };
            let folder = with_column(&format!("prescribed_{place}_{word}"), column, &rows);
            let unit = if by == By::Acceleration { ", units = \"m/s^2\"" } else { "" };
            let size = [0.8, 3.0, 11.0][by as usize];
            let wave = format!("{{ {word} = {{ amplitude = {size}, frequency = 4, phase = 0.3 }} }}");
            let record = format!("{{ {word} = {{ file = \"record.csv\"{unit} }} }}");
            for (motion, moves) in [(Motion::Wave(by, size), wave), (lines, record)] {
                for until in [0.3, 0.85, 1.27, 1.95] {
                    let ours = followed(&file(of, &moves), &folder, until);
                    let other = stepped(of, &motion, until);
                    for (a, b) in ours.iter().zip(other) {
                        assert!((a - b).abs() < 1e-8, "{of:?} {moves} until {until}: {ours:?} {other:?}");
                    }
                    moving += usize::from(other[0].abs() > 1e-3);
                }
            }
        }
    }
    assert!(moving > 80, "{moving}");
}

/// A belt whose acceleration is a constant, a sum of a wave and a record, and a record of a text without names.
#[test]
fn accelerations_of_a_side_add() {
    let values = [0.0, 9.0, -8.0, 4.0, -3.0];
    let rows: Vec<_> = TIMES.into_iter().zip(values).collect();
    let folder = with_column("prescribed_sum", "acceleration", &rows);
    let moves = "{ acceleration = [{ constant = 4 }, { amplitude = 11, frequency = 4, phase = 0.3 }, { file = \"record.csv\", units = \
                 \"m/s^2\" }] }";
    let (wave, lines) = (Motion::Wave(By::Acceleration, 11.0), Motion::Lines(By::Acceleration, values));
    // The body goes with the belt: without friction enough it lags.
    let ours = followed(&file(Moved::Side, moves), &folder, 0.12);
    // By hand: it slides at once, from a belt at −(11/4) cos 0.3, with −r.
    let start = wave.at(0.0)[1];
    assert!(start < 0.0 && lines.at(0.0)[1] == 0.0);
    // x″ = −(3 + 5x + 0.4x′)/2 while the belt runs backwards.
    let (rate, decay) = ((K / M - (C / (2.0 * M)).powi(2)).sqrt(), C / (2.0 * M));
    let t: f64 = 0.12;
    let (sin, cos) = (rate * t).sin_cos();
    let fall = (-decay * t).exp();
    let x = -R / K * (1.0 - fall * (cos + decay / rate * sin));
    let v = -R / K * fall * (decay * decay / rate + rate) * sin;
    let belt = |t: f64| 4.0 * t + wave.at(t)[1] + lines.at(t)[1];
    assert!((0..=120).all(|i| belt(0.001 * f64::from(i)) < -0.3), "the belt runs backwards");
    assert!((ours[0] - x).abs() < 1e-12 && (ours[1] - v).abs() < 1e-12, "{ours:?} {x} {v}");
    std::fs::write(folder.join("bare.txt"), "0 0\n0.35 3\n0.9 -2\n1.3 2.5\n2 1\n").unwrap();
    let bare = followed(&file(Moved::Side, "{ velocity = { file = \"bare.txt\" } }"), &folder, 1.95);
    let named = stepped(Moved::Side, &Motion::Lines(By::Velocity, [0.0, 3.0, -2.0, 2.5, 1.0]), 1.95);
    assert!((bare[0] - named[0]).abs() < 1e-8, "{bare:?} {named:?}");
}

/// A base by samples of a sine moves as one by the sine, the closer the more samples there are; the options of a record hold for
/// displacements, too.
#[test]
fn a_base_by_its_displacement() {
    let due = followed(
        &file(Moved::Base, "{ displacement = { amplitude = 0.8, frequency = 4 } }"),
        Path::new(""),
        1.9,
    );
    let mut before = f64::INFINITY;
    for (place, count) in [20, 80, 320].into_iter().enumerate() {
        let period = TAU / 4.0;
        let rows: Vec<_> = (0..=count)
            .map(|i| {
                (
                    period * f64::from(i) / f64::from(count),
                    800.0 * (TAU * f64::from(i % count) / f64::from(count)).sin(),
                )
            })
            .collect();
        let folder = folder(&format!("prescribed_sine_{place}"), &rows);
        let moves = "{ displacement = { file = \"record.csv\", units = \"mm\", repeats = true } }";
        let ours = followed(&file(Moved::Base, moves), &folder, 1.9);
        let off = (ours[0] - due[0]).abs();
        assert!(off < before / 4.0, "{count}: {ours:?} {due:?}");
        before = off;
        // Without names, in millimetres and by its step.
        let step = period / f64::from(count);
        let bare: String = rows.iter().map(|(_, x)| format!("{x}\n")).collect();
        std::fs::write(folder.join("bare.txt"), bare).unwrap();
        let moves = format!(
            "{{ displacement = {{ file = \"bare.txt\", units = \"mm\", time_step = \"{step} s\", repeats = true }} }}"
        );
        let bare = followed(&file(Moved::Base, &moves), &folder, 1.9);
        assert!((bare[0] - ours[0]).abs() < 1e-9, "{bare:?} {ours:?}");
    }
    assert!(before < 1e-5, "{before}");
}

/// What cannot be followed is refused by a line that says why.
#[test]
fn wrong_motions_are_refused() {
    let wrong = |name: &str, of: Moved, rows: &[(f64, f64)], moves: &str| {
        let folder = folder(name, rows);
        let text = file(of, moves);
        NamedSystem::new(&parsed(&text, "machine.toml").unwrap(), [], &folder, None).err().unwrap()
    };
    let jump = [(0.0, 0.0), (1.0, 1.0), (1.0, 2.0), (2.0, 0.0)];
    for of in [Moved::Side, Moved::End, Moved::Base, Moved::Body] {
        let name = format!("prescribed_jump_{}", of as usize);
        let text = wrong(&name, of, &jump, "{ displacement = { file = \"record.csv\" } }");
        assert!(text.contains("must not change at once"), "{of:?}: {text}");
    }
    let text = wrong(
        "prescribed_open",
        Moved::Base,
        &[(0.0, 0.0), (1.0, 1.0)],
        "{ displacement = { file = \"record.csv\", repeats = true } }",
    );
    assert!(text.contains("must end with its first value where it repeats itself"), "{text}");
    let text = wrong(
        "prescribed_kind",
        Moved::Side,
        &[(0.0, 0.0), (1.0, 1.0)],
        "{ velocity = { file = \"record.csv\", units = \"mm\" } }",
    );
    assert!(text.contains("must be a velocity"), "{text}");
}
