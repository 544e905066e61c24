//! The next step towards the fixed point of the map from stop to stop.

use crate::float::Float;

/// `G(x) − x` at a point, and its slope.
#[derive(Clone, Copy)]
pub(super) struct Miss<F> {
    pub(super) x: F,
    pub(super) value: F,
    pub(super) slope: F,
}

impl<F: Float> Miss<F> {
    /// The step to the zero of the cubic through this point and the one before, with their slopes; Newton's
    /// step without one.
    pub(super) fn step(&self, before: Option<Self>) -> F {
        let (two, three) = (F::int(2), F::int(3));
        let newton = -(self.value / self.slope);
        let Some(before) = before else { return newton };
        // value + slope t + a t² + b t³, t from here
        let back = self.x - before.x;
        let secant = (self.value - before.value) / back;
        let a = (two * self.slope + before.slope - three * secant) / back;
        let b = (self.slope + before.slope - two * secant) / back.square();
        // The zero next to here of the parabola, then Newton's steps for the cubic.
        let discriminant = self.slope.square() - F::int(4) * a * self.value;
        let bends_away = discriminant <= F::int(0) || !discriminant.is_finite();
        if bends_away {
            return newton;
        }
        let mut t = -(two * self.value) / (self.slope - discriminant.sqrt());
        for _ in 0..3 {
            let value = self.value + t * (self.slope + t * (a + t * b));
            let slope = self.slope + t * (two * a + three * t * b);
            t = t - value / slope;
        }
        t
    }
}
