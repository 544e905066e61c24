//! A checked system in balls: rows over the state, and linear equations between balls.

use super::super::assembly::{self, Assembly};
use super::super::error::Error;
use crate::float::Field;
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use alloc::string::String;
use alloc::vec::Vec;

/// A number with a bound of its error. The precision is that of the thread.
pub(crate) type Number = Ball<26>;
/// A row over the state, or a vector.
pub(super) type Row = Vec<Number>;

/// A straight piece of a law: `force + slope (w − from)` from the speed `from` on.
#[derive(Debug, Clone)]
pub(super) struct Piece {
    pub(super) from: Number,
    pub(super) force: Number,
    pub(super) slope: Number,
}

/// The law of an element.
#[derive(Debug)]
#[allow(clippy::large_enum_variant, reason = "there are a few of them, and they are not moved")]
pub(super) enum Rule {
    /// `peak` is none where static and kinetic friction are the same number; `normal` is the row of N, and 1 without one.
    Contact { pieces: Vec<Piece>, peak: Option<Number>, normal: Option<Row> },
    /// `place` is the force's place in the state; `bound` the row of the friction.
    Elastic { stiffness: Number, place: usize, bound: Row },
    /// `depth` is the row of y − gap.
    Stop { depth: Row, stiffness: Number, damping: Number },
}

/// An element.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) name: String,
    /// b.
    pub(super) direction: Row,
    /// M⁻¹b.
    pub(super) response: Row,
    /// The row of v.
    pub(super) velocity: Row,
    /// The row of V′.
    pub(super) moves: Row,
    pub(super) rule: Rule,
}

impl Part {
    /// Whether its static friction is above the kinetic one.
    pub(super) const fn has_peak(&self) -> bool {
        matches!(&self.rule, Rule::Contact { peak: Some(_), .. })
    }
}

/// A checked system in balls.
#[derive(Debug)]
pub(crate) struct Machine {
    pub(super) n: usize,
    /// The number of states that are not given functions of time.
    pub(super) free: usize,
    pub(super) size: usize,
    pub(super) frequencies: Row,
    pub(super) mass: Vec<Row>,
    pub(super) damping: Vec<Row>,
    pub(super) stiffness: Vec<Row>,
    pub(super) inverse: Vec<Row>,
    /// The rows of f − C q′ − K q, without elements.
    pub(super) force: Vec<Row>,
    /// The rows of f alone.
    pub(super) load: Vec<Row>,
    pub(super) parts: Vec<Part>,
}

/// A list of read numbers as balls: each within 64 units in the last place of the largest of them. Zeros are exact.
pub(super) fn read<const N: usize>(list: &[Mp<N>]) -> Row {
    let largest = list.iter().map(|x| Radius::above(*x)).fold(Radius::ZERO, Radius::max);
    list.iter().map(|x| Ball::read(*x, largest)).collect()
}

pub(super) fn read_one<const N: usize>(x: Mp<N>) -> Number {
    Ball::read(x, Radius::above(x))
}

/// Rows of one matrix, whose entries are sums of numbers of the size of the largest.
fn read_rows<'r, const N: usize>(rows: impl Iterator<Item = &'r [Mp<N>]>) -> Vec<Row> {
    let rows: Vec<&[Mp<N>]> = rows.collect();
    let all = rows.iter().flat_map(|row| row.iter());
    let largest = all.map(|x| Radius::above(*x)).fold(Radius::ZERO, Radius::max);
    rows.iter().map(|row| row.iter().map(|x| Ball::read(*x, largest)).collect()).collect()
}

/// What of a system is not enclosed.
pub(crate) fn refused<const N: usize>(system: &Assembly<Mp<N>>) -> Result<(), Error> {
    let no = |name: &str, condition| Err(Error::Unsupported { name: name.into(), condition });
    if !system.records.is_empty() {
        return no("record", "must be left out of a motion that is enclosed: loads are constants and waves");
    }
    if !system.moved.is_empty() {
        return no("moves", "of a body must be left out of a motion that is enclosed");
    }
    if !system.massless.is_empty() {
        return no("mass", "must be > 0 at each body of a motion that is enclosed");
    }
    if !system.levels.is_empty() {
        return no("levels", "must be left out of a motion that is enclosed, and its end must be a time");
    }
    for part in &system.parts {
        let condition = match &part.rule {
            assembly::Rule::Hard { .. } => "is a stop with a restitution, which is not enclosed",
            assembly::Rule::Spring { .. } => "is a spring with a law, which is not enclosed",
            assembly::Rule::Contact { .. } if part.under.is_some() => {
                "is under the force of a stop, which is not enclosed"
            }
            assembly::Rule::Elastic { normal: Some(_), .. } => {
                "is an elastic contact under a normal load that varies, which is not enclosed"
            }
            assembly::Rule::Contact { .. } | assembly::Rule::Elastic { .. } | assembly::Rule::Stop { .. } => {
                continue;
            }
        };
        return no(&part.name, condition);
    }
    if system.is_dependent {
        return no(
            "contacts",
            "must have independent directions in a motion that is enclosed: dependent ones share their force",
        );
    }
    Ok(())
}

impl Machine {
    /// The system in balls of the precision of the thread. M may be too near to a singular one for it.
    pub(crate) fn new<const N: usize>(system: &Assembly<Mp<N>>) -> Option<Self> {
        let n = system.n;
        let mass = read_rows(system.mass.rows());
        let inverse = solved(&mass, &identity(n))?;
        let part = |part: &assembly::Part<Mp<N>>| {
            let direction = read(&part.direction);
            let rule = match &part.rule {
                assembly::Rule::Contact { pieces, peak, normal } => {
                    let piece = |piece: &super::super::pieces::Piece<Mp<N>>| Piece {
                        from: read_one(piece.from),
                        force: read_one(piece.force),
                        slope: read_one(piece.slope),
                    };
                    let peak = (*peak != Mp::of_int(1)).then(|| read_one(*peak));
                    let normal = normal.as_deref().map(read);
                    Rule::Contact { pieces: pieces.iter().map(piece).collect(), peak, normal }
                }
                assembly::Rule::Elastic { stiffness, place, bound, .. } => {
                    Rule::Elastic { stiffness: read_one(*stiffness), place: *place, bound: read(bound) }
                }
                assembly::Rule::Stop { depth, stiffness, damping } => {
                    let [stiffness, damping] = [*stiffness, *damping].map(read_one);
                    Rule::Stop { depth: read(depth), stiffness, damping }
                }
                // Refused.
                assembly::Rule::Hard { .. } | assembly::Rule::Spring { .. } => return None,
            };
            let response = inverse.iter().map(|row| dot(row, &direction)).collect();
            let name = part.name.clone();
            Some(Part {
                name,
                direction,
                response,
                velocity: read(&part.velocity),
                moves: read(&part.moves),
                rule,
            })
        };
        Some(Self {
            n,
            free: system.free,
            size: system.size,
            frequencies: system.frequencies.iter().copied().map(read_one).collect(),
            damping: read_rows(system.damping.rows()),
            stiffness: read_rows(system.stiffness.rows()),
            force: read_rows(system.force.rows()),
            load: read_rows(system.load.rows()),
            parts: system.parts.iter().map(part).collect::<Option<_>>()?,
            inverse,
            mass,
        })
    }

    /// The loads at a time: sin ωt and cos ωt of each wave, and 1.
    pub(super) fn loads(&self, time: Number) -> Row {
        use crate::float::Real;
        let waves =
            self.frequencies.iter().flat_map(|&frequency| <[Number; 2]>::from((frequency * time).sin_cos()));
        waves.chain([Number::int(1)]).collect()
    }

    /// bᵢ·M⁻¹bⱼ.
    pub(super) fn coupling(&self, i: usize, j: usize) -> Number {
        match (self.parts.get(i), self.parts.get(j)) {
            (Some(a), Some(b)) => dot(&a.direction, &b.response),
            _ => Number::int(0),
        }
    }
}

/// Whether a number is exactly 0.
pub(super) fn is_zero(x: &Number) -> bool {
    x.rad().is_zero() && x.mid().is_zero()
}

/// The entry of a row; 0 beyond it.
pub(super) fn at(row: &[Number], i: usize) -> Number {
    row.get(i).copied().unwrap_or_else(|| Number::int(0))
}

pub(super) fn set(row: &mut [Number], i: usize, x: Number) {
    if let Some(place) = row.get_mut(i) {
        *place = x;
    }
}

pub(super) fn zeros(count: usize) -> Row {
    (0..count).map(|_| Number::int(0)).collect()
}

pub(super) fn identity(n: usize) -> Vec<Row> {
    (0..n).map(|i| unit(n, i)).collect()
}

pub(super) fn unit(size: usize, place: usize) -> Row {
    let mut row = zeros(size);
    set(&mut row, place, Number::int(1));
    row
}

pub(super) fn dot(a: &[Number], b: &[Number]) -> Number {
    let products = a.iter().zip(b).filter(|(a, b)| !is_zero(a) && !is_zero(b));
    products.fold(Number::int(0), |sum, (a, b)| sum + *a * *b)
}

/// `y += s x`.
pub(super) fn add_times(y: &mut [Number], s: Number, x: &[Number]) {
    for (y, x) in y.iter_mut().zip(x).filter(|(_, x)| !is_zero(x)) {
        *y = *y + s * *x;
    }
}

/// `X` of `A X = Y` by elimination, for a matrix that is near to a positive definite one; none where a pivot may be zero.
pub(super) fn solved(a: &[Row], y: &[Row]) -> Option<Vec<Row>> {
    let n = a.len();
    let mut rows: Vec<Row> = a.iter().zip(y).map(|(a, y)| a.iter().chain(y).copied().collect()).collect();
    for k in 0..n {
        let (done, below) = rows.split_at_mut_checked(k + 1)?;
        let pivot = done.last()?;
        let by = at(pivot, k);
        if by.contains_zero() {
            return None;
        }
        for row in below {
            let share = at(row, k);
            if !is_zero(&share) {
                add_times(row, -(share / by), pivot);
                set(row, k, Number::int(0));
            }
        }
    }
    for k in (0..n).rev() {
        let (above, rest) = rows.split_at_mut_checked(k)?;
        let pivot = rest.first_mut()?;
        let by = at(pivot, k);
        pivot.iter_mut().for_each(|x| *x = *x / by);
        for row in above {
            let share = at(row, k);
            if !is_zero(&share) {
                add_times(row, -share, pivot);
            }
        }
    }
    Some(rows.into_iter().map(|row| row.into_iter().skip(n).collect()).collect())
}
