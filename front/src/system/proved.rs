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

/// The bound after a time, where there is one.
pub(super) fn bound(model: &Model<f64>, laws: &[Tabled<'_>], time: f64) -> Option<Proved> {
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
    let inertia = inverse(&model.mass)?;
    let beta = |b: &[f64]| -> f64 {
        let sum: f64 = b.iter().zip(&inertia).map(|(x, row)| x * dot(row, b)).sum();
        sum.sqrt()
    };
    let least = |stiffness: Vec<Vec<f64>>| -> Option<f64> {
        // The roots of the eigenvalues over M, with their signs.
        let like =
            Model { mass: model.mass.clone(), damping: vec![vec![0.0; n]; n], stiffness, ..Model::default() };
        let roots = System::new(&like).ok()?.natural_frequencies(&[]);
        roots.into_iter().map(|root| root * root.abs()).reduce(f64::min)
    };
    if least(model.stiffness.clone())? < 0.0 {
        return None;
    }
    let mut damping: Vec<Vec<f64>> = (0..n)
        .map(|i| {
            (0..n).map(|j| f64::midpoint(entry(&model.damping, i, j), entry(&model.damping, j, i))).collect()
        })
        .collect();
    let mut push = 0.0;
    for (place, element) in model.elements.iter().enumerate() {
        let own = laws.iter().find(|law| law.element == place);
        let points: &[(f64, f64)] = match (&element.kind, own) {
            (_, Some(law)) => law.points,
            (Kind::Contact { law, .. }, None) => &law.points,
            _ => &[],
        };
        let slopes = points.iter().zip(points.iter().skip(1)).map(|(a, b)| (b.1 - a.1) / (b.0 - a.0));
        let fall = slopes.fold(0.0_f64, |most, slope| most.max(-slope));
        push += own.map_or(0.0, |law| law.within * beta(&element.direction));
        let b = &element.direction;
        damping
            .iter_mut()
            .zip(b)
            .for_each(|(row, x)| row.iter_mut().zip(b).for_each(|(c, y)| *c -= fall * x * y));
    }
    let has_springs = model.stiffness.iter().flatten().any(|x| *x != 0.0)
        || model.elements.iter().any(|element| matches!(element.kind, Kind::Elastic { .. }));
    let growth = -least(damping)?;
    let growth = if has_springs { growth.max(0.0) } else { growth };
    let growth = growth + growth.abs() * 1e-9;
    // (e^{Λt} − 1)/Λ, and its integral over the time.
    let x = growth * time;
    let whole = if x == 0.0 { time } else { libm::expm1(x) / growth };
    let way = if x.abs() < 1e-3 { time * time / 2.0 * (1.0 + x.abs()) } else { (whole - time) / growth };
    let (energy, way) = (push * whole * ROUNDING, push * way * ROUNDING);
    // Both motions stay on the table.
    let stays = |law: &Tabled<'_>| {
        let along = model.elements.get(law.element).map_or(f64::INFINITY, |element| beta(&element.direction));
        law.reach * ROUNDING + along * energy < law.range
    };
    if !laws.iter().all(stays) {
        return None;
    }
    let flexibility = inverse(&model.stiffness);
    let each = |matrix: &[Vec<f64>], by: f64| -> Vec<f64> {
        (0..n).map(|i| entry(matrix, i, i).sqrt() * by).collect()
    };
    let velocity = each(&inertia, energy);
    let mut displacement = each(&inertia, way);
    if let Some(flexibility) = flexibility {
        let held = each(&flexibility, energy);
        displacement.iter_mut().zip(held).for_each(|(x, held)| *x = x.min(held));
    }
    velocity.iter().chain(&displacement).all(|x| x.is_finite()).then_some(Proved { displacement, velocity })
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
