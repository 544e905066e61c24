//! Springs whose force is straight between points over the displacement: bilinear, hardening, slack or one-sided.
//!
//! Each straight piece is a branch of the motion, and the passage from one to the next is an event without a name: the force is continuous
//! there, and so is the derivative of the state. Beyond its points a law goes on straight.

use super::assembly::{Assembly, Part, Rule};
use super::error::Error;
use super::given::finite;
use super::matrix::{Matrix, add_times};
use super::mode::Mode;
use super::pieces::{Piece, straight_pieces};
use crate::float::Float;
use alloc::format;
use alloc::vec;
use alloc::vec::Vec;

/// The straight pieces of a spring.
pub(super) fn pieces<F: Float>(name: &str, points: &[(F, F)]) -> Result<Vec<Piece<F>>, Error> {
    if points.len() < 2 {
        return Err(Error::Length { name: format!("{name}: law"), found: points.len(), expected: 2 });
    }
    for &(displacement, force) in points {
        finite(&format!("{name}: displacement of the law"), displacement)?;
        finite(&format!("{name}: force of the law"), force)?;
    }
    let (places, slopes) = (format!("{name}: displacements of the law"), format!("{name}: slope of the law"));
    let mut pieces = straight_pieces(&places, &slopes, points)?;
    // A point on the straight line of its neighbours, such as the middle of a mirrored law, is no corner.
    pieces.dedup_by(|next, last| next.slope == last.slope);
    Ok(pieces)
}

impl<F: Float> Part<F> {
    /// The row of the stretch of a spring with a law, and its pieces.
    pub(super) fn bends(&self) -> Option<(&[F], &[Piece<F>])> {
        match (&self.rule, &self.stretch) {
            (Rule::Spring { pieces }, Some(stretch)) => Some((stretch, pieces)),
            _ => None,
        }
    }
}

/// The mode of a spring at a stretch.
pub(super) fn mode<F: Float>(pieces: &[Piece<F>], stretch: F) -> Mode {
    Mode::Bends { piece: pieces.partition_point(|piece| piece.from <= stretch).saturating_sub(1) }
}

/// The row of the force in a piece: `force + slope (y − from)`.
pub(super) fn tension<F: Float>(part: &Part<F>, piece: usize) -> Vec<F> {
    let mut row = vec![F::int(0); part.velocity.len()];
    if let Some((stretch, pieces)) = part.bends()
        && let Some(piece) = pieces.get(piece)
    {
        add_times(&mut row, piece.slope, stretch);
        if let Some(last) = row.last_mut() {
            *last = *last + piece.force - piece.slope * piece.from;
        }
    }
    row
}

/// The greatest size of a slope.
pub(super) fn stiffest<F: Float>(pieces: &[Piece<F>]) -> F {
    pieces.iter().fold(F::int(0), |most, piece| most.or_larger(piece.slope.abs()))
}

impl<F: Float> Assembly<F> {
    /// K with the slopes of the springs with laws at a displacement of all coordinates.
    pub(super) fn tangent_stiffness(&self, q: &[F]) -> Matrix<F> {
        let mut stiffness = self.stiffness.clone();
        for (part, _, slope) in self.springs_at(q) {
            for (i, &b) in part.direction.iter().enumerate() {
                add_times(stiffness.row_mut(i), slope * b, &part.direction);
            }
        }
        stiffness
    }

    /// Each spring with a law, with its force and its slope at a displacement of all coordinates, without what moves its other side.
    pub(super) fn springs_at(&self, q: &[F]) -> impl Iterator<Item = (&Part<F>, F, F)> {
        self.parts.iter().filter_map(|part| {
            let (stretch, pieces) = part.bends()?;
            let y = super::matrix::dot(stretch.get(..q.len())?, q);
            let Mode::Bends { piece } = mode(pieces, y) else { return None };
            let piece = pieces.get(piece)?;
            Some((part, piece.force + piece.slope * (y - piece.from), piece.slope))
        })
    }
}

/// The most steps of Newton's method to an equilibrium.
const MOST_STEPS: usize = 100;

impl<F: Float> Assembly<F> {
    /// The displacement at which steady sliding is in equilibrium, as [`System::sliding`](super::System::sliding) takes it, with a factor of the
    /// coefficients that act through displacements: only springs with laws need it, and without them it is 0. Newton's method on straight
    /// pieces is exact once the pieces are right.
    pub(super) fn sliding_equilibrium(&self, factor: F) -> Vec<F> {
        let zero = F::int(0);
        let mut q = vec![zero; self.n];
        if !self.parts.iter().any(|part| part.bends().is_some()) {
            return q;
        }
        let constant: Vec<F> = self.load.rows().filter_map(|row| row.last().copied()).collect();
        let mut slopes = Vec::new();
        for _ in 0..MOST_STEPS {
            let now: Vec<F> = self.springs_at(&q).map(|(_, _, slope)| slope).collect();
            if now == slopes {
                break;
            }
            let mut left = constant.clone();
            for (i, left) in left.iter_mut().enumerate() {
                *left = *left - super::matrix::dot(self.stiffness.row(i), &q);
            }
            for (part, force, _) in self.springs_at(&q) {
                add_times(&mut left, -force, &part.direction);
            }
            for part in &self.parts {
                let Some((sign, force, _)) = part.sliding() else { continue };
                let normal = part.normal().map_or(F::int(1), |row| {
                    let own = super::matrix::dot(row.get(..self.n).unwrap_or(&[]), &q);
                    factor * (own + row.last().copied().unwrap_or(zero))
                });
                add_times(&mut left, -(sign * force * normal), &part.direction);
            }
            let (step, _) = self.sliding_stiffness(&q, factor, &[]).solved(&left);
            add_times(&mut q, F::int(1), &step);
            slopes = now;
        }
        q
    }
}
