//! The points, and the answers there in balls.

use super::super::formulae::Answers;
use super::super::terms::Point;
use super::answered::Answered;
use crate::enclosed::Known;
use crate::enclosed::angle::Angle;
use crate::enclosed::border::Border;
use crate::enclosed::cycle::Cycle;
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use crate::nonsticking::matching::{Given, pi_1};
use crate::nonsticking::stability::{MultiplierPair, multiplier_product};
use crate::nonsticking::{loop_size_inertia, loop_size_stiffness};
use core::cmp::Ordering;
use rug::{Integer, Rational, ops::Pow};

/// A frequency ratio, a force ratio and a damping ratio, all exact.
pub(super) struct Place {
    pub(super) omega: Known,
    pub(super) alpha: Known,
    pub(super) zeta: Known,
    /// Whether the motion is proved there, which excludes the neighbourhood of the poles.
    pub(super) with_motion: bool,
    /// Whether the motions near the border are proved.
    pub(super) with_border: bool,
}

impl Place {
    /// Ω and α, to forty digits.
    pub(super) fn written(&self) -> (String, String) {
        (written(&self.omega), written(&self.alpha))
    }

    /// ζ, if there is a damper.
    pub(super) fn written_damping(&self) -> Option<String> {
        self.is_damped().then(|| written(&self.zeta))
    }

    pub(super) fn is_damped(&self) -> bool {
        *self.zeta.high() > 0
    }
}

fn written(x: &Known) -> String {
    Mp::<2>::from_rational(&x.middle()).to_string()
}

/// The points of [`super::super::points`], with exact ratios.
pub(super) fn places() -> Vec<Place> {
    let mut omegas = Vec::new();
    for ((p, q), (r, s)) in super::super::points::BANDS {
        let (low, high) = (Rational::from((p, q)), Rational::from((r, s)));
        omegas.extend((1..6).map(|i| (Rational::from(&high - &low) * Rational::from((i, 6)) + &low, true)));
    }
    for n in [1, 3, 5, 7] {
        for digits in [3u32, 10, 30] {
            let distance = Rational::from((Integer::from(1), Integer::from(10).pow(digits)));
            let middle = Rational::from((1, n));
            let is_ordinary = digits == 3;
            omegas.push((Rational::from(&middle - &distance), is_ordinary));
            omegas.push((middle + distance, is_ordinary));
        }
    }
    let of = |(omega, ordinary): (Rational, bool)| {
        let omega = Known::rational(omega);
        let least = Border::at(&Angle::<5>::new(&omega), &Known::rational(1.into())).min_force_ratio;
        let times = [Ball::ratio(101, 100), Ball::ratio(3, 2), Ball::int(4)];
        let at = move |(i, times): (usize, Ball<5>)| {
            let alpha = Mp::<1>::rounded((least * times).mid()).to_rational()?;
            let (omega, alpha) = (omega.clone(), Known::rational(alpha));
            let zeta = Known::rational(Rational::new());
            Some(Place { omega, alpha, zeta, with_motion: ordinary, with_border: ordinary && i == 0 })
        };
        times.into_iter().enumerate().filter_map(at)
    };
    omegas.into_iter().flat_map(of).collect()
}

/// The point and its answers.
#[derive(Clone)]
pub(super) struct Found<const W: usize> {
    pub(super) point: Point<Ball<W>>,
    pub(super) answers: Answers<Ball<W>>,
    pub(super) edge: Edge<W>,
}

/// The border.
#[derive(Clone, Copy)]
pub(super) struct Edge<const W: usize> {
    pub(super) min_force_ratio: Ball<W>,
    pub(super) turning_point: Ball<W>,
    pub(super) least_displacement: Ball<W>,
    pub(super) phase: Ball<W>,
}

impl<const W: usize> Found<W> {
    pub(super) fn at(place: &Place) -> Option<Self> {
        let angle = Angle::<W>::new(&place.omega);
        let (omega, alpha, one) = (angle.omega, place.alpha.ball(), Ball::int(1));
        let cycle = Cycle::at(&angle, alpha)?;
        let (sin_beta, cos_beta) = angle.sin_cos;
        let size = loop_size_stiffness(cycle.max_displacement, alpha);
        // λ = −(1 + s) cos(π/Ω)/2 ± √((1 + s)² cos²(π/Ω)/4 − s)
        let s = multiplier_product(omega, cycle.max_displacement);
        let mean = -((one + s) * pi_1(omega).cos()) / Ball::int(2);
        let discriminant = mean.square() - s;
        let is_complex = discriminant.sign().map(|sign| sign == Ordering::Less);
        let multipliers = if is_complex == Some(true) {
            MultiplierPair::Complex { re: mean, im: (-discriminant).sqrt() }
        } else {
            MultiplierPair::Real(mean + discriminant.sqrt(), mean - discriminant.sqrt())
        };
        let border = Border::at(&angle, &Known::rational(1.into()));
        let given = Given { amplitude: alpha / angle.one_minus_square, friction_displacement: one, omega };
        Some(Self {
            point: Point {
                given,
                alpha,
                k: angle.phase_function,
                tangent: sin_beta / cos_beta,
                cos_beta,
                one_minus_square: angle.one_minus_square,
                sign: if *place.omega.high() < 1 { one } else { -one },
                best: (angle.best_force_ratio(), angle.best_loop_size().unwrap_or_else(Ball::entire)),
                is_complex,
                is_late: cycle.displacement_phase.is_below(&cycle.velocity_phase),
            },
            answers: Answers {
                max_displacement: cycle.max_displacement,
                displacement_phase: cycle.displacement_phase,
                max_velocity: cycle.max_velocity,
                velocity_phase: cycle.velocity_phase,
                deviation: cycle.deviation,
                loop_size_stiffness: size,
                loop_size_inertia: loop_size_inertia(size, omega),
                contraction: cycle.contraction(&angle),
                multipliers,
            },
            edge: Edge {
                min_force_ratio: border.min_force_ratio,
                turning_point: border.turning_point,
                least_displacement: border.least_displacement,
                phase: border.phase?,
            },
        })
    }

    /// The answers for comparison with proved motions.
    pub(super) fn answered(&self) -> Answered<W> {
        let (point, answers, one) = (&self.point, &self.answers, Ball::int(1));
        let s = multiplier_product(point.given.omega, answers.max_displacement);
        Answered {
            scale: one + answers.max_displacement + point.given.amplitude.abs(),
            max_displacement: answers.max_displacement,
            displacement_phase: answers.displacement_phase,
            max_velocity: answers.max_velocity,
            sum: -((one + s) * pi_1(point.given.omega).cos()),
            product: s,
            contraction: answers.contraction,
            min_force_ratio: self.edge.min_force_ratio,
        }
    }
}
