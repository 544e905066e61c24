//! The maximum speed within a long slide.

use super::Fastest;
use crate::cycle::damped::fastest::fastest_time;
use crate::cycle::damped::rising::Vibration;
use crate::float::Float;
use crate::motion::slide::Slide;
use crate::motion::slide::motion::Motion;

impl<F: Float> Slide<F> {
    /// The parts (from, to) of a slide under a slow drive that can contain its maximum speed, around the
    /// crests of the forced wave; a part is empty unless from < to. `None` if the parts contain more than a
    /// few extrema, or if there are too many parts. `best` becomes the greatest of the speeds at the ends and
    /// at the crest of the free wave that is nearest to a crest of the forced wave.
    ///
    /// The speed is `A cos(Ωφ − c) + u` with `|u| ≤ r`, the amplitude of the free wave at the start. Where
    /// the forced wave is below an attained speed by more than r, there is no maximum.
    pub(super) fn around_crests(
        &self,
        end: F,
        arrival: &Motion<F>,
        best: &mut Fastest<F>,
    ) -> Option<[(F, F); 2]> {
        let (zero, one, two, pi) = (F::int(0), F::int(1), F::int(2), F::pi());
        let omega = self.equation.omega;
        let sign = self.direction.sign::<F>();
        let mut consider = |phi: F, w: F| {
            if sign * w > sign * best.w {
                *best = Fastest { phi, w };
            }
        };
        consider(end, arrival.w);
        let (x, w) = self.equation.forced(self.sin_cos_start());
        let forced = w.hypot(omega * x);
        let (free, rate) = (sign * (self.w - w), sign * (self.acceleration + omega.square() * x));
        let crest = (-(sign * omega * x)).atan2(sign * w) / omega;
        let next = crest + two * pi / omega;
        let vibration = self.equation.vibration();
        if let Some(within) = [crest, next].into_iter().find(|t| (zero..=end).contains(t))
            && vibration.swings()
        {
            // u = e^{−ζφ} R cos(dφ − χ)
            let d = vibration.frequency;
            let turns = (d * within - (rate + vibration.zeta * free).atan2(d * free)) / (two * pi);
            let near = within - (turns - (turns + one / two).floor()) * two * pi / d;
            if near > zero && near < end {
                consider(near, self.motion(near).w);
            }
        }
        // The free wave is bounded by its size at the start, and by a decaying envelope.
        let zeta = vibration.zeta;
        let size = free.hypot(rate);
        let envelope = (vibration.swings() && zeta > zero)
            .then(|| free.hypot((rate + zeta * free) / vibration.frequency));
        let rounding = F::int(64) * F::epsilon() * (forced + size);
        let least = |free: F| (sign * best.w - free - rounding) / forced;
        let half_width = |least: F| {
            let angle = if least < one { ((one - least) * (one + least)).sqrt().atan2(least) } else { zero };
            angle / omega
        };
        let at_start = least(size);
        let widest = half_width(at_start);
        let part = |crest: F| {
            let earliest = (crest - widest).or_larger(zero);
            let later = envelope.map(|envelope| envelope * (-(zeta * earliest)).exp());
            let width = later.filter(|later| *later < size).map_or(widest, |later| half_width(least(later)));
            let (from, to) = (crest - width, crest + width);
            (from.or_larger(zero), if to < end { to } else { end })
        };
        let parts = [part(crest), part(next)];
        let is_short = parts.iter().all(|(from, to)| *to - *from <= F::int(32));
        let are_all = next + two * pi / omega - widest >= end;
        (at_start > -one && is_short && are_all).then_some(parts)
    }

    /// The maximum speed where there can be many extrema, by the search of the closed-form cycle.
    #[cold]
    #[inline(never)]
    pub(super) fn fastest_of_waves(&self, end: F, arrival: &Motion<F>) -> Fastest<F> {
        let equation = &self.equation;
        let sign = self.direction.sign::<F>();
        let (x, w) = equation.forced(self.sin_cos_start());
        // s times the velocity; the drive's share is Ω(a sin Ωφ − H cos Ωφ).
        let h = -(sign * w / equation.omega);
        let (free_x, free_w) = (self.x + sign - x, self.w - w);
        let motion = Vibration {
            free: equation.vibration(),
            omega: equation.omega,
            driven: (-(sign * x), h),
            start: (sign * free_x, sign * free_w),
            end,
            whole: None,
        };
        let phi = fastest_time(&motion);
        let found = if phi >= end { arrival.w } else { self.motion(phi).w };
        let start = Fastest { phi: F::int(0), w: self.w };
        [Fastest { phi, w: found }, Fastest { phi: end, w: arrival.w }]
            .into_iter()
            .fold(start, |best, next| if sign * next.w > sign * best.w { next } else { best })
    }
}

#[cfg(test)]
mod tests;
