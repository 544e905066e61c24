//! The work of a damper as an integral of its own.
//!
//! Else it is what the balance of energy leaves, which for a weak damper is the rounding of the other works.

use super::follow::{Onset, Stretch, Watch};
use super::linear::Linear;
use super::load::Piece;
use super::number::Number as _;
use super::slide::Slide;
use crate::float::Float;
use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// The most pieces in which the velocity is a power series.
const MOST_PIECES: f64 = 1e6;

/// ∫ 2β(x′ − u′)² dt, with the velocity u′ of a support on which the damper stands.
#[derive(Debug)]
pub(super) struct Damper<F> {
    work: F,
    /// 2β.
    rate: F,
    /// Whether the motion has no last stop, after which the integral goes on.
    goes_on: bool,
    /// The pieces so far.
    pieces: f64,
    series: Vec<F>,
}

impl<F: Float> Damper<F> {
    pub(super) fn new(rate: F) -> Self {
        Self { work: F::int(0), rate, goes_on: false, pieces: 0.0, series: Vec::new() }
    }

    /// The work per mass, where the motion has an end.
    pub(super) fn work(&self) -> Option<F> {
        (!self.goes_on && self.pieces <= MOST_PIECES).then_some(self.work)
    }
}

impl<F: Float> Watch<F> for Damper<F> {
    fn slid(&mut self, linear: &Linear<F>, slide: &Slide<F>, stretch: &Stretch<'_, F>) -> Option<()> {
        let (rate, square, length) = (linear.law.rate, linear.law.square, stretch.length);
        if rate <= F::int(0) {
            return Some(());
        }
        let parts = (length * square.sqrt().or_larger(rate)).to_f64().ceil().max(1.0);
        self.pieces += parts;
        if self.pieces.is_nan() || self.pieces > MOST_PIECES {
            return Some(());
        }
        let (h, foot) = (length / F::from_f64(parts), stretch.foot / rate);
        let (mut part, mut v, mut a) = (0.0, slide.v, slide.a);
        while part < parts {
            // v = Σ cₙτⁿ over a piece, from v″ = s − ω²v − 2βv′; the coefficients fall like 2ⁿ/n!.
            self.series.clear();
            let (mut now, mut next, mut size) = (v, a * h, F::int(1));
            let mut n = 0usize;
            while size > F::epsilon() * F::ratio(1, 64) {
                self.series.push(now);
                let [one, two] = [1, 2].map(|more| F::count(n.saturating_add(more)));
                let push = if n == 0 { slide.slope * h.square() } else { F::int(0) };
                let then = (push - square * h.square() * now - rate * h * one * next) / (one * two);
                (now, next) = (next, then);
                size = size * F::int(2) / one;
                n = n.saturating_add(1);
            }
            let terms = || self.series.iter().enumerate();
            let [end, slope] =
                terms().fold([F::int(0); 2], |[sum, slope], (n, &c)| [sum + c, slope + F::count(n) * c]);
            let relative = |n: usize, c: F| if n == 0 { c - foot } else { c };
            let mut sum = F::int(0);
            for (i, &c) in terms() {
                for (j, &d) in terms() {
                    let power = F::count(i.saturating_add(j).saturating_add(1));
                    sum = sum + relative(i, c) * relative(j, d) / power;
                }
            }
            self.work = self.work + rate * h * sum;
            (v, a) = (end, slope / h);
            part += 1.0;
        }
        Some(())
    }

    fn rested(&mut self, _: F, piece: &Piece<F>, _: F, _: F, length: F) -> Option<()> {
        if self.rate > F::int(0) {
            self.work = self.work + piece.foot.square() / self.rate * length;
        }
        Some(())
    }

    fn released(&mut self, _: F, _: F, _: F, _: Onset) {}

    fn stopped(&mut self, _: F, _: F) -> Option<()> {
        Some(())
    }

    fn struck(&mut self, _: [F; 2], _: F) -> Option<()> {
        Some(())
    }

    fn freed(&mut self) {}

    fn counted(&mut self) {}

    fn stays(&mut self, _: F, _: F) -> Option<()> {
        Some(())
    }

    fn goes_on(&mut self, _: F, _: F) -> Option<()> {
        self.goes_on = true;
        Some(())
    }

    fn tends_to(&mut self, _: [F; 2], _: F, _: F) -> Option<()> {
        self.goes_on = true;
        Some(())
    }
}
