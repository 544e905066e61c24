//! How far a motion under laws that are curves is at most from that under their tables.
//!
//! Let e be the difference of both from one start, `s² = e′·M e′ + e·K e` with the energies of springs of elastic contacts, δ the force within which
//! a table is, L the greatest fall of a table per speed, `β² = b·M⁻¹b`. A friction jumps upwards where its velocity passes 0, and elastic contacts
//! store or lose, so that
//!
//! `s s′ ≤ e′·(Σ L b bᵀ − C) e′ + Σ δ |b·e′| ≤ Λ s² + Σ δ β s`, hence `s ≤ Σ δ β (e^{Λt} − 1)/Λ`,
//!
//! where Λ is the greatest eigenvalue of `Σ L b bᵀ − C` over M, and at least 0 where K has springs. Stops and springs with laws, a static friction above the
//! kinetic one and normal loads by the state have no such bound.
//!
//! **Steady motions.** Let two motions under the same loads have one period T, under the law and under its table, and Λ < 0. Over T, springs give back what they
//! take, so that with the mean square ρ² of `√(e′·M e′)`
//!
//! `−Λ ρ² T ≤ ∮ e′·(C − Σ L b bᵀ) e′ dt ≤ ∮ Σ δ |b·e′| dt ≤ Σ δ β ρ T`, hence `ρ ≤ Σ δ β/(−Λ)`.
//!
//! A displacement then differs by a constant, and by a part whose range is at most half of the way `∮ |e_i′| dt ≤ √(M⁻¹)_ii ρ T`. The constant may be any: friction
//! holds bodies in many places. At its least in the period `u = √(e′·M e′)` is at most ρ, and from there to any other instant, with x the change of e and ē its mean,
//! `u² ≤ ρ² + 2 Σ δ β ∫u dt − 2 x·K e₀ − x·K x`. The balance of the mean forces is `K ē = −Σ b (mean difference of frictions)`, of at most twice the
//! greatest friction F each; with `|x| ≤ ρ T/2` over M, and κ ≥ all eigenvalues of K over M, `u² ≤ ρ² + 2 Σ δ β ρ T + 3 κ (ρ T/2)² + 2 ρ T Σ β F`. So both stay on the table.

use serde::Serialize;
use stickslip::system::{Element, Kind, Model, System};

/// How far the numbers of an answer are from those under the law itself, at most: proved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Proved {
    /// Of the displacements of each coordinate, at all times.
    pub displacement: Vec<f64>,
    /// Of the velocities of each coordinate, at all times.
    pub velocity: Vec<f64>,
}

/// How far a steady motion is from every motion under the law itself that has the same period, at most: proved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ProvedSteady {
    /// Half of the way between the greatest and the least displacement of each coordinate.
    pub half_range: Vec<f64>,
    /// The root of the mean square, over the period, of the difference of the velocities of each coordinate.
    pub velocity_rms: Vec<f64>,
}

/// A law with its table.
pub(super) struct Tabled<'t> {
    pub(super) element: usize,
    pub(super) points: &'t [(f64, f64)],
    /// The force within which the table is: proved.
    pub(super) within: f64,
    /// The greatest speed of the motion under the table, and the end of the table.
    pub(super) reach: f64,
    pub(super) range: f64,
}

/// Beyond the rounding of the few operations here.
const ROUNDING: f64 = 1.0 + 1e-9;

/// The difference of two motions of a model, under laws and under their tables.
pub(super) struct Difference<'m> {
    model: &'m Model<f64>,
    laws: &'m [Tabled<'m>],
    /// M⁻¹.
    inertia: Vec<Vec<f64>>,
    /// Σ δ β.
    push: f64,
    /// Λ, which is negative where dampers take more than laws fall.
    growth: f64,
}

impl<'m> Difference<'m> {
    /// That of a model whose elements part no motions; none of another.
    pub(super) fn new(model: &'m Model<f64>, laws: &'m [Tabled<'m>]) -> Option<Self> {
        let n = model.mass.len();
        let is_symmetric = |matrix: &[Vec<f64>]| {
            matrix
                .iter()
                .enumerate()
                .all(|(i, row)| row.iter().enumerate().all(|(j, x)| entry(matrix, j, i) == *x))
        };
        let is_free = model.moved.is_empty() && model.elements.iter().all(keeps_order);
        if !is_free || !is_symmetric(&model.mass) || !is_symmetric(&model.stiffness) {
            return None;
        }
        let mut found = Self { model, laws, inertia: inverse(&model.mass)?, push: 0.0, growth: 0.0 };
        let mut damping: Vec<Vec<f64>> = (0..n)
            .map(|i| {
                let mean = |j| f64::midpoint(entry(&model.damping, i, j), entry(&model.damping, j, i));
                (0..n).map(mean).collect()
            })
            .collect();
        for (place, element) in model.elements.iter().enumerate() {
            let own = laws.iter().find(|law| law.element == place);
            let points: &[(f64, f64)] = match (&element.kind, own) {
                (_, Some(law)) => law.points,
                (Kind::Contact { law, .. }, None) => &law.points,
                _ => &[],
            };
            let slopes = points.iter().zip(points.iter().skip(1)).map(|(a, b)| (b.1 - a.1) / (b.0 - a.0));
            // A law that rises everywhere takes as a damper does.
            let fall = slopes.map(|slope| -slope).reduce(f64::max).unwrap_or(0.0);
            let b = &element.direction;
            found.push += own.map_or(0.0, |law| law.within * found.beta(b));
            damping
                .iter_mut()
                .zip(b)
                .for_each(|(row, x)| row.iter_mut().zip(b).for_each(|(c, y)| *c -= fall * x * y));
        }
        let growth = -found.least(damping)?;
        found.growth = growth + growth.abs() * 1e-9;
        Some(found)
    }

    /// β of a direction.
    fn beta(&self, b: &[f64]) -> f64 {
        let sum: f64 = b.iter().zip(&self.inertia).map(|(x, row)| x * dot(row, b)).sum();
        sum.sqrt()
    }

    /// The least eigenvalue of a matrix over M.
    fn least(&self, stiffness: Vec<Vec<f64>>) -> Option<f64> {
        // The roots of the eigenvalues over M, with their signs.
        let n = stiffness.len();
        let (mass, damping) = (self.model.mass.clone(), vec![vec![0.0; n]; n]);
        let like = Model { mass, damping, stiffness, ..Model::default() };
        let roots = System::new(&like).ok()?.natural_frequencies(&[]);
        roots.into_iter().map(|root| root * root.abs()).reduce(f64::min)
    }

    /// Whether both motions stay on their tables where the difference of velocities over M is at most this.
    fn stays(&self, difference: f64) -> bool {
        self.laws.iter().all(|law| {
            let element = self.model.elements.get(law.element);
            let along = element.map_or(f64::INFINITY, |element| self.beta(&element.direction));
            law.reach * ROUNDING + along * difference < law.range
        })
    }

    /// √ of the diagonal of a matrix, times a number.
    fn each(matrix: &[Vec<f64>], by: f64) -> Vec<f64> {
        (0..matrix.len()).map(|i| entry(matrix, i, i).sqrt() * by).collect()
    }

    /// The bound after a time from one start, where there is one.
    pub(super) fn after(&self, time: f64) -> Option<Proved> {
        let model = self.model;
        if self.least(model.stiffness.clone())? < 0.0 {
            return None;
        }
        let has_springs = model.stiffness.iter().flatten().any(|x| *x != 0.0)
            || model.elements.iter().any(|element| matches!(element.kind, Kind::Elastic { .. }));
        let growth = if has_springs { self.growth.max(0.0) } else { self.growth };
        // (e^{Λt} − 1)/Λ, and its integral over the time.
        let x = growth * time;
        let whole = if x == 0.0 { time } else { libm::expm1(x) / growth };
        let way = if x.abs() < 1e-3 { time * time / 2.0 * (1.0 + x.abs()) } else { (whole - time) / growth };
        let (energy, way) = (self.push * whole * ROUNDING, self.push * way * ROUNDING);
        if !self.stays(energy) {
            return None;
        }
        let velocity = Self::each(&self.inertia, energy);
        let mut displacement = Self::each(&self.inertia, way);
        if let Some(flexibility) = inverse(&model.stiffness) {
            let held = Self::each(&flexibility, energy);
            displacement.iter_mut().zip(held).for_each(|(x, held)| *x = x.min(held));
        }
        velocity
            .iter()
            .chain(&displacement)
            .all(|x| x.is_finite())
            .then_some(Proved { displacement, velocity })
    }

    /// The bound of a steady motion with this period and without a drift, where there is one.
    pub(super) fn over_period(&self, period: f64) -> Option<ProvedSteady> {
        let (model, taken) = (self.model, -self.growth);
        if taken <= 0.0 {
            return None;
        }
        // The mean square of e′ over M, and half the way that e goes in a period.
        let mean = self.push / taken * ROUNDING;
        let way = mean * period / 2.0;
        let product = |i: usize, j: usize| -> f64 {
            self.inertia.get(i).map_or(0.0, |row| {
                row.iter().zip(&model.stiffness).map(|(x, k)| x * k.get(j).copied().unwrap_or(0.0)).sum()
            })
        };
        let n = model.mass.len();
        let trace: f64 = (0..n).flat_map(|i| (0..n).map(move |j| product(i, j) * product(j, i))).sum();
        let pull: f64 = model
            .elements
            .iter()
            .enumerate()
            .map(|(place, element)| {
                self.most(place, element).map(|most| most * self.beta(&element.direction))
            })
            .sum::<Option<f64>>()?;
        let square =
            mean * mean + 4.0 * self.push * way + 3.0 * trace.max(0.0).sqrt() * way * way + 4.0 * pull * way;
        if !self.stays(square.sqrt() * ROUNDING) {
            return None;
        }
        let velocity_rms = Self::each(&self.inertia, mean);
        let half_range: Vec<f64> = velocity_rms.iter().map(|x| x * period / 4.0 * ROUNDING).collect();
        half_range.iter().all(|x| x.is_finite()).then_some(ProvedSteady { half_range, velocity_rms })
    }

    /// The greatest friction of an element; none where a normal load gives it.
    fn most(&self, place: usize, element: &Element<f64>) -> Option<f64> {
        let greatest = |points: &[(f64, f64)]| points.iter().fold(0.0, |most: f64, point| most.max(point.1));
        match &element.kind {
            Kind::Contact { law, normal: None, .. } => {
                let own = self.laws.iter().find(|law| law.element == place);
                // Beyond its last point a law goes on, so that its greatest friction is not known.
                let is_constant = law.points.len() == 1;
                own.map_or_else(
                    || is_constant.then(|| greatest(&law.points)),
                    |own| Some(greatest(own.points) + own.within),
                )
            }
            Kind::Elastic { friction, .. } => Some(*friction),
            Kind::Contact { .. }
            | Kind::Stop { .. }
            | Kind::HardStop { .. }
            | Kind::UnderStop { .. }
            | Kind::Spring { .. } => None,
        }
    }
}

/// Whether an element takes energy from the difference of two motions, but for the fall of its law.
fn keeps_order(element: &Element<f64>) -> bool {
    let over_time = |normal: &Option<stickslip::system::Normal<f64>>| {
        let of_state = |normal: &stickslip::system::Normal<f64>| {
            normal.displacement.iter().chain(&normal.velocity).any(|by| *by != 0.0)
        };
        !normal.as_ref().is_some_and(of_state)
    };
    match &element.kind {
        Kind::Contact { peak, normal, .. } => *peak == 1.0 && over_time(normal),
        // Its state is measured by its spring while it holds; open, it forgets its force.
        Kind::Elastic { normal, .. } => normal.is_none(),
        Kind::Stop { .. } | Kind::HardStop { .. } | Kind::UnderStop { .. } | Kind::Spring { .. } => false,
    }
}

fn entry(matrix: &[Vec<f64>], i: usize, j: usize) -> f64 {
    matrix.get(i).and_then(|row| row.get(j)).copied().unwrap_or(0.0)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The inverse of a positive definite matrix by Gauss and Jordan; none where it is not definite beyond rounding.
fn inverse(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let n = matrix.len();
    let unit = |i: usize| (0..n).map(move |j| f64::from(u8::from(i == j)));
    let mut rows: Vec<Vec<f64>> =
        matrix.iter().enumerate().map(|(i, row)| row.iter().copied().chain(unit(i)).collect()).collect();
    for k in 0..n {
        let pivot = entry(&rows, k, k);
        if pivot <= entry(matrix, k, k) * 1e-9 {
            return None;
        }
        let own: Vec<f64> = rows.get(k)?.iter().map(|x| x / pivot).collect();
        for (i, row) in rows.iter_mut().enumerate() {
            let factor = if i == k { pivot - 1.0 } else { row.get(k).copied()? };
            row.iter_mut().zip(&own).for_each(|(x, y)| *x -= factor * y);
        }
    }
    Some(rows.into_iter().map(|row| row.get(n..).unwrap_or(&[]).to_vec()).collect())
}
