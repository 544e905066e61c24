//! One contact and one harmonic load: the cycle of two reversals in closed form, and the least load at which it never
//! sticks.
//!
//! **The cycle.** Let x = (q, q′) obey `x′ = A x + (0, M⁻¹f) − p sgn y′`, p = (0, M⁻¹b r), and let E = e^{AT} over the half
//! period T = π/ω. After the reversal at which y is greatest the friction is +p. Its part of the motion, x_f, is turned
//! round by the half period, so that `−x_f = E x_f + ∫₀ᵀ e^{As} p ds`:
//!
//! `x_f = −(I + E)⁻¹ ∫₀ᵀ e^{As} ds p`,
//!
//! which is tanh(AT/2)(K⁻¹b r, 0) where K has an inverse. With the amplitude |Y| of y under the load alone, and y_f, v_f the
//! rows of y and y′ of x_f, the velocity is zero at the reversal where |Y| sin θ = v_f/ω, θ being the phase after the peak of
//! the load's part: `Δ₀ = a + y_f`, `a = √(|Y|² − (v_f/ω)²)`.
//!
//! **The border.** From the reversal on `y′ = v(τ) − v_f cos ωτ − ω a sin ωτ`, v(τ) the friction's part. It must be
//! negative up to the next reversal, and the contact must not stick at the reversal, where y″ ≤ −(η − 1) r b·M⁻¹b. So
//! a is at least S, the larger of `[v′(0) + (η − 1) r b·M⁻¹b]/ω²` and the supremum of
//! `[v(τ) − v_f cos ωτ]/(ω sin ωτ)`, and the least amplitude is `√(S² + (v_f/ω)²)`. The supremum is that of a quotient
//! with a positive denominator: from a lower bound of S, the place where `ω S sin ωτ − [v(τ) − v_f cos ωτ]` is least gives
//! the next one (Dinkelbach), until nothing is below zero.
//!
//! Bodies without mass that springs or dampers carry are in A, whose branch gives their velocities (`massless.rs`). A contact at one has no
//! border: with no mass to carry it on, the body sticks at each reversal until the force on it has changed by twice the friction.
//!
//! For one body these are eq. 42, 44 and 61 of the paper and the interior border (`src/cycle/border.rs`).

use super::assembly::{Assembly, Rule};
use super::branch::{Branch, polynomial};
use super::error::Error;
use super::first_passage::{greatest_place, integer};
use super::matrix::{Matrix, add_times, at, dot};
use super::mode::Mode;
use crate::float::Float;
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

/// The least load at which a contact never sticks.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Border<F> {
    /// The least load as a multiple of the given one. From it on the contact never sticks in a motion with two
    /// reversals a period.
    pub least_load_factor: F,
    /// The time after a reversal at which the velocity touches zero on the border; 0 where it is the reversal itself.
    pub touching_time: F,
    /// The load, as a multiple of the given one, from which on the contact leaves its rest in the middle of the springs, where it can hold
    /// more than the friction of sliding: the amplitude of the force that holds it at rest under the load, beside that of a constant load,
    /// reaches the static friction. None where both frictions are equal, or no load reaches the contact at rest.
    pub least_load_factor_from_rest: Option<F>,
}

/// The cycle of two reversals a period.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Cycle<F> {
    /// The greatest stretch y of the contact, from the middle of its motion: Δ₀.
    pub max_displacement: F,
    /// Its time after phase 0 of the load.
    pub displacement_time: F,
    /// The greatest velocity y′: V₀.
    pub max_velocity: F,
    /// Its time after phase 0 of the load.
    pub velocity_time: F,
    /// The work against friction in a period, 4 r Δ₀.
    pub work: F,
    /// How the load compares with the least one without sticking: below 1 the contact sticks, and this is no motion.
    pub margin: F,
}

/// The friction's part of the cycle.
struct Friction<F> {
    branch: Branch<F>,
    /// The number of steps in half a period.
    steps: usize,
    /// The state after the upper reversal, with (0, 1) for (sin ωτ, cos ωτ).
    z: Vec<F>,
    frequency: F,
    half: F,
    y: F,
    v: F,
    /// b on the velocities.
    velocity: Vec<F>,
    bound: F,
    response: F,
    peak: F,
    /// The amplitudes of y with sin and cos under the load alone.
    load: (F, F),
}

/// The most steps of half a period.
const MOST_STEPS: usize = 1_000_000;

fn unsupported(name: &str, condition: &'static str) -> Error {
    Error::Unsupported { name: name.to_string(), condition }
}

impl<F: Float> Friction<F> {
    fn new(given: &Assembly<F>) -> Result<Self, Error> {
        let zero = F::int(0);
        let [part] = given.parts.as_slice() else {
            return Err(unsupported(
                "elements",
                "must be one contact: with stops or further contacts there is no closed form",
            ));
        };
        let Rule::Contact { pieces, peak, normal } = &part.rule else {
            return Err(unsupported(&part.name, "must be neither elastic nor a stop"));
        };
        let ([piece], None) = (pieces.as_slice(), normal) else {
            return Err(unsupported(&part.name, "must have one friction force, at every speed and time"));
        };
        if part.velocity.iter().skip(2 * given.n).any(|&x| x != zero) {
            return Err(unsupported(&part.name, "must not move on its other side"));
        }
        if let Some(&joint) = given.massless.iter().find(|&&i| at(&part.direction, i) != zero) {
            return Err(given.without_mass(
                joint,
                "must not be at the contact: there it sticks at each reversal under any load, while its spring turns over",
            ));
        }
        let [frequency] = given.frequencies.as_slice() else {
            return Err(unsupported(
                "harmonics",
                "must be one: loads of several frequencies have no closed form",
            ));
        };
        if !given.moved.is_empty() {
            return Err(unsupported("moved", "must be absent: the closed form is that of a harmonic load"));
        }
        if !given.records.is_empty() {
            return Err(unsupported("records", "must be absent: the closed form is that of a harmonic load"));
        }
        let (n, frequency) = (given.n, *frequency);
        let constant: Vec<F> = given.load.rows().filter_map(|row| row.last().copied()).collect();
        let (shift, missing) = given.stiffness.solved(&constant);
        // A constant load shifts the middle of the cycle, if springs carry it.
        let left = given
            .stiffness
            .of(&shift)
            .into_iter()
            .zip(&constant)
            .fold(zero, |most, (a, &b)| most.or_larger((a - b).abs()));
        let size = constant.iter().fold(zero, |most, x| most.or_larger(x.abs()));
        if missing > 0 && left > size * F::exp2i(-20) {
            return Err(unsupported("constant load", "must be absent where no spring carries it"));
        }
        let load = amplitudes(given, &part.direction, frequency)?;
        // The friction alone.
        let mut system = given.clone();
        for i in 0..n {
            system.force.row_mut(i).get_mut(2 * n..).unwrap_or(&mut []).fill(zero);
        }
        let half = F::pi() / frequency;
        let modes = [Mode::Slides { forward: false, piece: 0 }];
        let longest = Branch::new(&system, &modes, [half; 2], [].iter()).step;
        let most = integer::<F>(MOST_STEPS);
        if !half.is_finite() || half > longest * most {
            return Err(unsupported(
                "half a period of the load",
                "must have at most 10⁶ steps of the fastest rate",
            ));
        }
        let mut steps = 1;
        while integer::<F>(steps) * longest < half {
            steps += 1;
        }
        let branch = Branch::new(&system, &modes, [half / integer(steps); 2], [].iter());
        if let Some(free) = branch.tie.as_ref().and_then(|tie| tie.free) {
            return Err(given.without_mass(free, "must be held by a spring or a damper"));
        }
        let mut power = steps;
        let (mut whole, mut square) = (Matrix::identity(system.size), branch.whole().dense());
        while power > 0 {
            if power % 2 == 1 {
                whole = square.times(&whole);
            }
            square = square.times(&square);
            power /= 2;
        }
        let size = 2 * n;
        let mut sum = Matrix::identity(size);
        let mut right = vec![zero; size];
        for (i, right) in right.iter_mut().enumerate() {
            for j in 0..size {
                let one: F = sum.at(i, j);
                sum.set(i, j, one + whole.at(i, j));
            }
            *right = -whole.at(i, system.size - 1);
        }
        let (mut z, missing) = sum.solved(&right);
        if missing > 0 {
            return Err(unsupported("harmonics", "must not be at a resonance of the undamped structure"));
        }
        z.extend([zero, F::int(1), F::int(1)]);
        let y = dot(&part.direction, &z);
        let velocity: Vec<F> = part.velocity.clone();
        let v = dot(&velocity, &z);
        let (bound, response) = (piece.force, dot(&part.direction, &part.response));
        Ok(Self { branch, steps, z, frequency, half, y, v, velocity, bound, response, peak: *peak, load })
    }

    /// The least a = √(|Y|² − (v_f/ω)²), with the place where it is decided.
    fn least(&self) -> (F, F) {
        let (zero, two) = (F::int(0), F::int(2));
        let slope = dot(&self.velocity, &self.branch.derivative(&self.z));
        let turning =
            (slope + (self.peak - F::int(1)) * self.bound * self.response) / self.frequency.square();
        let (mut least, mut place) = (turning.or_larger(zero), zero);
        // Each step of Dinkelbach's method at least doubles the digits near the end.
        for _ in 0..F::precision() {
            let (excess, at) = self.greatest(&self.quotient(least));
            let (sin, cos) = (self.frequency * at).sin_cos();
            let doubt = F::epsilon() * F::int(16) * (self.frequency * least + self.v.abs());
            if excess <= doubt || sin <= zero {
                break;
            }
            let mut terms = Vec::new();
            let state = self.at(at, &mut terms);
            let next = (dot(&self.velocity, &state) - self.v * cos) / (self.frequency * sin);
            if next <= least {
                break;
            }
            let small = (next - least) * two <= next * F::epsilon();
            (least, place) = (next, at);
            if small {
                break;
            }
        }
        (least, place)
    }

    /// The row of `v(τ) − v_f cos ωτ − ω a sin ωτ`: y′ after the upper reversal.
    fn quotient(&self, a: F) -> Vec<F> {
        let mut row = self.velocity.clone();
        let tail = [-(self.frequency * a), -self.v, F::int(0)];
        let from = row.len().saturating_sub(3);
        add_times(row.get_mut(from..).unwrap_or(&mut []), F::int(1), &tail);
        row
    }

    /// The state a time after the reversal.
    fn at(&self, time: F, terms: &mut Vec<F>) -> Vec<F> {
        let mut z = self.z.clone();
        let mut left = time;
        let mut next = vec![F::int(0); z.len()];
        while left > self.branch.step {
            self.branch.whole().of(&z, &mut next);
            z.copy_from_slice(&next);
            left = left - self.branch.step;
        }
        self.branch.after(&z, left, terms, &mut next);
        next
    }

    /// The greatest value of a row over the half period after the reversal, and its time.
    fn greatest(&self, row: &[F]) -> (F, F) {
        let (mut z, mut terms) = (self.z.clone(), Vec::new());
        let mut next = vec![F::int(0); z.len()];
        let (mut best, mut place, mut time) = (-F::int(1) / F::epsilon(), F::int(0), F::int(0));
        for _ in 0..self.steps {
            self.branch.taylor(&z, self.branch.step, &mut terms);
            let c = polynomial(row, &terms);
            let rounding = c.iter().fold(F::int(0), |sum, c| sum + c.abs()) * F::epsilon();
            let (value, at) = greatest_place(&c, best, rounding);
            if let Some(at) = at {
                (best, place) = (value, time + at * self.branch.step);
            }
            self.branch.whole().of(&z, &mut next);
            z.copy_from_slice(&next);
            time = time + self.branch.step;
        }
        (best, place)
    }
}

/// The amplitudes of y with sin ωt and cos ωt under the load alone.
fn amplitudes<F: Float>(system: &Assembly<F>, direction: &[F], frequency: F) -> Result<(F, F), Error> {
    let n = system.n;
    let mut matrix = Matrix::zero(2 * n, 2 * n);
    let mut right = vec![F::int(0); 2 * n];
    for i in 0..n {
        for j in 0..n {
            let elastic = system.stiffness.at(i, j) - frequency.square() * system.mass.at(i, j);
            let viscous = frequency * system.damping.at(i, j);
            matrix.set(i, j, elastic);
            matrix.set(n + i, n + j, elastic);
            matrix.set(i, n + j, -viscous);
            matrix.set(n + i, j, viscous);
        }
    }
    for (i, right) in right.iter_mut().enumerate() {
        let place = system.harmonic(0) + usize::from(i >= n);
        *right = system.load.at(i % n, place);
    }
    let (x, missing) = matrix.solved(&right);
    if missing > 0 {
        return Err(unsupported("harmonics", "must not be at a resonance of the undamped structure"));
    }
    Ok((dot(direction, &x), dot(direction, x.get(n..).unwrap_or(&[]))))
}

/// The load factor from which on the contact leaves its rest: with (q, T) the response of the structure whose contact is held,
/// `(K − ω²M + iωC) q + b T = f`, `b·q = 0`, and T₀ the force under the constant load, `λ |T| = η r − |T₀|`.
fn release<F: Float>(system: &Assembly<F>, friction: &Friction<F>) -> Option<F> {
    let (n, zero) = (system.n, F::int(0));
    let part = system.parts.first()?;
    let largest =
        |matrix: &Matrix<F>| matrix.rows().flatten().fold(zero, |most, x: &F| most.or_larger(x.abs()));
    // The force in a unit of the size of the other entries, so that no pivot looks like rounding.
    let unit = largest(&system.stiffness).or_larger(friction.frequency.square() * largest(&system.mass));
    // The amplitudes with sin ωt and cos ωt of q and T; at ω = 0 the two are alone.
    let held = |frequency: F, load: [usize; 2]| {
        let size = 2 * n + 2;
        let mut matrix = Matrix::zero(size, size);
        let mut right = vec![zero; size];
        for (half, &place) in load.iter().enumerate() {
            let (own, other) = (half * n, (1 - half) * n);
            for i in 0..n {
                for j in 0..n {
                    let elastic = system.stiffness.at(i, j) - frequency.square() * system.mass.at(i, j);
                    let viscous = frequency * system.damping.at(i, j);
                    matrix.set(own + i, own + j, elastic);
                    matrix.set(own + i, other + j, if half == 0 { -viscous } else { viscous });
                }
                let b = part.direction.get(i).copied().unwrap_or(zero) * unit;
                matrix.set(own + i, 2 * n + half, b);
                matrix.set(2 * n + half, own + i, b);
                if let Some(right) = right.get_mut(own + i) {
                    *right = system.load.at(i, place);
                }
            }
        }
        let (x, _) = matrix.solved(&right);
        let force = |k: usize| x.get(k).copied().unwrap_or(zero);
        force(2 * n).hypot(force(2 * n + 1)) * unit
    };
    let place = system.harmonic(0);
    let amplitude = held(friction.frequency, [place, place + 1]);
    // The column of the constant load beside one that is empty.
    let constant = held(zero, [system.size - 1, n]);
    let room = (friction.peak * friction.bound - constant).or_larger(zero);
    (amplitude > zero).then(|| room / amplitude)
}

/// The border of a system with one contact and one harmonic load.
pub(crate) fn border<F: Float>(system: &Assembly<F>) -> Result<Border<F>, Error> {
    let friction = Friction::new(system)?;
    let (least, touching_time) = friction.least();
    let (sin, cos) = friction.load;
    let amplitude = sin.hypot(cos);
    if amplitude <= F::int(0) {
        return Err(unsupported("harmonics", "must move the contact"));
    }
    let least_load_factor = least.hypot(friction.v / friction.frequency) / amplitude;
    let least_load_factor_from_rest =
        (friction.peak > F::int(1)).then(|| release(system, &friction)).flatten();
    Ok(Border { least_load_factor, touching_time, least_load_factor_from_rest })
}

/// The cycle of a system with one contact and one harmonic load; none where the load is too weak for it.
pub(crate) fn cycle<F: Float>(system: &Assembly<F>) -> Result<Option<Cycle<F>>, Error> {
    let friction = Friction::new(system)?;
    let (least, _) = friction.least();
    let (sin, cos) = friction.load;
    let amplitude = sin.hypot(cos);
    let lag = friction.v / friction.frequency;
    if amplitude <= lag.abs() {
        return Ok(None);
    }
    let a = amplitude.leg(lag);
    let max_displacement = a + friction.y;
    // The load's part is |Y| cos(ωt − φ), φ = atan2(sin, cos), and the reversal is θ after its peak.
    let turn = F::int(2) * F::pi();
    let phase = sin.atan2(cos) + lag.atan2(a);
    let positive = |phase: F| phase - turn * (phase / turn).floor();
    let displacement_time = positive(phase) / friction.frequency;
    // y′ is least after the upper reversal where its negative is greatest, and greatest half a period later.
    let turned: Vec<F> = friction.quotient(a).into_iter().map(|x| -x).collect();
    let (max_velocity, after) = friction.greatest(&turned);
    let velocity_time = positive(phase + friction.frequency * (after + friction.half)) / friction.frequency;
    let work = F::int(4) * friction.bound * max_displacement;
    let margin = amplitude / least.hypot(lag);
    Ok(Some(Cycle { max_displacement, displacement_time, max_velocity, velocity_time, work, margin }))
}
