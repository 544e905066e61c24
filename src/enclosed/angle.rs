//! The angle β = π/2Ω reduced by a multiple of π/2, and K(Ω), in balls.

use super::Known;
use crate::cycle::phase_function::{phase_function_beside_one, phase_function_of_tangent, tangent, turned};
use crate::cycle::{best_force_ratio, best_loop_size};
use crate::float::ball::{Ball, Radius};
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use core::cmp::Ordering;
use rug::{Integer, Rational};

/// The quantities that depend on Ω alone.
pub(crate) struct Angle<const W: usize> {
    pub(crate) omega: Ball<W>,
    /// Ω as an exact number or interval.
    pub(crate) known: Known,
    /// q mod 4 of β = q π/2 + w.
    pub(crate) quarter: u8,
    /// w, |w| ≤ π/4 where Ω is exact.
    pub(crate) remainder: Ball<W>,
    /// 1 − Ω².
    pub(crate) one_minus_square: Ball<W>,
    /// K(Ω).
    pub(crate) phase_function: Ball<W>,
    /// (sin β, cos β).
    pub(crate) sin_cos: (Ball<W>, Ball<W>),
}

impl<const W: usize> Angle<W> {
    /// β = q π/2 + w with `w = (π/2)(1 − qΩ)/Ω` holds for any q; the q of the middle of Ω makes w small. 1 −
    /// qΩ is exact.
    pub(crate) fn new(known: &Known) -> Self {
        let omega = known.ball::<W>();
        let q = known.middle().recip().round().into_numer_denom().0;
        let quarter = (q.clone() & Integer::from(3)).to_u8().unwrap_or(0);
        // 1 − qΩ decreases with Ω: the ends change places.
        let rest = Known::map(known, |x| Rational::from(x * &q) - 1u32).ball::<W>();
        let half_pi = Ball::pi() / Ball::int(2);
        let remainder = half_pi * -rest / omega;
        let from_one = known.map(|x| Rational::from(x - 1u32)).ball::<W>();
        let one_minus_square = -(from_one * (Ball::int(1) + omega));
        let phase_function = if q == 1 {
            phase_function_beside_one(omega, w_cot_w(remainder))
        } else {
            phase_function_of_tangent(omega, tangent(quarter, remainder))
        };
        let sin_cos = turned(quarter, remainder.sin_cos());
        Self { omega, known: known.clone(), quarter, remainder, one_minus_square, phase_function, sin_cos }
    }

    /// Whether Ω is exactly 1/(2n + 1), n ≥ 1, where K and the border are infinite.
    pub(crate) fn is_pole(&self) -> bool {
        let is_odd = self.quarter & 1 == 1 && self.remainder.sign() == Some(Ordering::Equal);
        is_odd && *self.known.high() < 1
    }

    /// The force ratio of the largest loop (eq. 65).
    pub(crate) fn best_force_ratio(&self) -> Ball<W> {
        best_force_ratio(self.phase_function)
    }

    /// The largest loop (eq. 66).
    pub(crate) fn best_loop_size(&self) -> Ball<W> {
        best_loop_size(self.phase_function, self.one_minus_square)
    }
}

/// `w cot w`.
///
/// Its series is `1 − w²/3 − Σ c_n w^2n`, n ≥ 2, with positive c_n whose sum is 2/3 − cot 1 < 1/40. For |w| ≤
/// 1 the remaining sum is therefore in [0, w⁴/40].
fn w_cot_w<const W: usize>(w: Ball<W>) -> Ball<W> {
    let size = Radius::above(w.mid()).plus(w.rad());
    let is_small = size < Radius::power_of_two(-i64::from(Mp::<W>::bits_now()) / 4);
    if !is_small && !w.contains_zero() {
        return w / w.tan();
    }
    if size > Radius::ONE {
        return Ball::entire();
    }
    let square = w.square();
    let rest = Ball::new(Mp::ZERO, size.times(size).times(size.times(size))) / Ball::int(40);
    Ball::int(1) - square / Ball::int(3) + rest
}
