//! Bands of frequency with a damper, or with a force that changes with the frequency: proved and searched
//! statements.
//!
//! Without damping each lobe of the border has one minimum, so that no band of one force is missed
//! (`bands`). No such proof is known with damping, where the poles of the border become finite peaks, nor for
//! `α_min(Ω)/α(Ω)` with an α that grows with Ω.
//!
//! **Proved:** `α_min ≥ 1/Ω² − 1`, so that there is no band below Ω = 1/√(1 + α). The reason is `G + 2ζΩH =
//! [sinh ζT + (ζ/d) sin dT]/N ≥ 0`, because `sinh ζT ≥ ζT ≥ (ζ/d) |sin dT|` (a hyperbolic sine for ζ ≥ 1);
//! hence `S ≥ 1/Ω²`, and `q ≥ |1 − Ω²|`. At the ends of a band, the computed border changes sides between two
//! adjacent numbers.
//!
//! **Proved to rounding:** where `e^{−ζT}` is below the rounding, G = 1 and H = 0, and the border has no
//! structure: `α_min = 2q/Ω²`, which falls with Ω. For Ω < d/2 the turning point decides: with x = dτ and
//! y = Ωτ < x/2, `ρ(τ)/ρ(0⁺) = e^{−ζτ} (sin x/x)(y/sin y)` is at most cos y for x ≤ π, at most ½ beyond, up to
//! `y = π/2`, and as small as the free vibration from there on.
//!
//! **Searched:** all else. The border is evaluated on a mesh: 32 points for each additional half turn of the
//! free vibration in half a period of the drive. The mesh is finer towards the border's peaks at dT/π = 3, 5,
//! …, down to a quarter of their width ζT/π. Where there are no peaks, the steps are 3 %.
//! Wherever a point of the mesh is next to an extremum on the wrong side of α, the extremum itself is
//! located.

use super::band::{Band, Edge};
use crate::cycle::Border;
use crate::cycle::border::Lobe;
use crate::float::Float;
use crate::greatest::highest;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::ratios::Ratios;
use crate::root;
use alloc::collections::VecDeque;

/// The parameter of the damper that is constant while the frequency ratio changes.
#[derive(Debug, Clone, Copy)]
pub(super) enum Damper<F> {
    /// The damping ratio ζ: the frequency of the drive changes.
    Ratio(F),
    /// The damping constant c, as γ = c/(2mω_d): the stiffness changes, ζ = γΩ.
    Constant(F),
}

impl<F: Float> Damper<F> {
    /// Whether there is a damper.
    pub(super) fn is_damped(self) -> bool {
        let (Self::Ratio(damping) | Self::Constant(damping)) = self;
        damping > F::int(0)
    }

    /// ζ at Ω.
    pub(super) fn ratio(self, omega: F) -> F {
        match self {
            Self::Ratio(zeta) => zeta,
            Self::Constant(gamma) => gamma * omega,
        }
    }

    /// The next point of the mesh.
    fn next(self, omega: F) -> F {
        let (one, two, three) = (F::int(1), F::int(2), F::int(3));
        let (zeta, geometric) = (self.ratio(omega), omega * F::ratio(33, 32));
        let square = (one - zeta) * (one + zeta);
        let d = square.abs().sqrt();
        if square <= F::int(0) || d <= two * omega || has_decayed(zeta, omega) {
            return geometric;
        }
        // The number of half turns of the free vibration in half a period of the drive.
        let turns = d / omega;
        let peak = three.or_larger(two * ((turns - one) / two).round() + one);
        let width = (zeta / omega).or_larger(F::int(64) * F::epsilon() * turns);
        let step = (turns - peak).abs().or_larger(width) / F::int(4);
        let finest = F::ratio(1, 32);
        d / (turns - if step < finest { step } else { finest })
    }
}

/// The force ratio while the frequency ratio changes, `α = √(α₀² + α₁²Ω² + α₂²Ω⁴)`: of a force, of a base motion by its
/// velocity, of a rotating unbalance or a base motion by its displacement, or of a support with its damper.
#[derive(Debug, Clone, Copy)]
pub(super) struct Force<F>(pub(super) [F; 3]);

impl<F: Float> Force<F> {
    /// One force ratio α at every frequency.
    pub(super) fn constant(alpha: F) -> Self {
        Self([alpha, F::int(0), F::int(0)])
    }

    /// α at Ω.
    pub(super) fn ratio(self, omega: F) -> F {
        let Self([constant, linear, square]) = self;
        constant.hypot(linear * omega).hypot(square * omega.square())
    }
}

/// Whether `e^{−ζT}`, which determines the peaks of the border, is below the rounding.
fn has_decayed<F: Float>(zeta: F, omega: F) -> bool {
    zeta * F::pi() > omega * decay_exponent()
}

/// The least ζT with `e^{−ζT} < ε/4`: `0.7 > ln 2` for each bit.
fn decay_exponent<F: Float>() -> F {
    let bits = i32::try_from(F::precision()).unwrap_or(i32::MAX).saturating_add(2);
    F::int(bits) * F::ratio(7, 10)
}

/// The greatest number of half turns of the free vibration that are searched, the number of lobes of the
/// undamped border.
const HALF_TURNS: i32 = 1 << 17;

/// A point of the mesh: Ω, and α minus the border at Ω, which is not negative where the body slides.
#[derive(Debug, Clone, Copy)]
struct MeshPoint<F> {
    omega: F,
    excess: F,
}

/// The bands of a range, by increasing frequency, where the body has a damper.
#[derive(Debug, Clone)]
pub(super) struct BandSearch<F> {
    force: Force<F>,
    damper: Damper<F>,
    /// The ends of the requested range.
    range: (F, F),
    next: Option<F>,
    /// The last point that was returned, and the point that waits for its neighbour.
    last: Option<MeshPoint<F>>,
    waiting: Option<MeshPoint<F>>,
    ready: VecDeque<MeshPoint<F>>,
    /// The last point of the previous band.
    before: Option<MeshPoint<F>>,
    least: Option<F>,
}

impl<F: Float> BandSearch<F> {
    /// The search in the range `[low, high]`, which is valid, as are α and ζ at both ends.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where the free vibration makes too many half turns to be searched.
    pub(super) fn new(force: Force<F>, damper: Damper<F>, low: F, high: F) -> Result<Self, Error> {
        let one = F::int(1);
        // α does not fall with Ω.
        let from = low.or_larger(one / (one + force.ratio(high)).sqrt());
        // The lowest Ω with peaks, for ζ at that Ω.
        let peaks_from = match damper {
            Damper::Ratio(zeta) => from.or_larger(zeta * F::pi() / decay_exponent()),
            Damper::Constant(_) => from,
        };
        // The steps of the mesh are 2⁻⁵ half turns, or a quarter of the width of a peak, and have to be resolved.
        let resolved = F::epsilon() * F::int(1 << 12);
        let least = (one / (one / high + F::int(HALF_TURNS))).or_larger(resolved);
        if peaks_from < least && !has_decayed(damper.ratio(peaks_from), peaks_from * F::ratio(33, 32)) {
            return Err(Error::OutOfRange {
                quantity: Quantity::FrequencyRatio,
                value: written(low),
                least: written(least),
                greatest: written(F::exp2i(F::RATIO_EXPONENT)),
            });
        }
        Ok(Self {
            force,
            damper,
            range: (low, high),
            next: (from <= high).then_some(from),
            last: None,
            waiting: None,
            ready: VecDeque::new(),
            before: None,
            least: None,
        })
    }

    /// The least value of the border so far.
    pub(super) const fn least(&self) -> Option<F> {
        self.least
    }

    fn excess(&self, omega: F) -> F {
        self.force.ratio(omega) - self.border(omega)
    }

    /// The border at Ω.
    fn border(&self, omega: F) -> F {
        let one = F::int(1);
        Border::of(&Ratios::of_valid(omega, one, self.damper.ratio(omega), one)).min_force_ratio
    }

    /// The next point of the mesh.
    fn advance(&mut self) -> Option<MeshPoint<F>> {
        let omega = self.next?;
        let high = self.range.1;
        let after = self.damper.next(omega);
        self.next = (omega < high).then(|| if after < high { after } else { high });
        let found = MeshPoint { omega, excess: self.excess(omega) };
        let least = self.force.ratio(omega) - found.excess;
        self.least = Some(self.least.map_or(least, |old| if least < old { least } else { old }));
        Some(found)
    }

    /// The next point of the mesh, or an extremum between points that may be on the other side of α.
    fn node(&mut self) -> Option<MeshPoint<F>> {
        loop {
            if let Some(node) = self.ready.pop_front() {
                return Some(node);
            }
            let found = self.advance();
            let Some(middle) = core::mem::replace(&mut self.waiting, found) else {
                found?;
                continue;
            };
            let hidden = self.hidden(self.last, middle, found);
            self.last = Some(middle);
            match hidden {
                Some(extremum) if extremum.omega < middle.omega => self.ready.extend([extremum, middle]),
                Some(extremum) => self.ready.extend([middle, extremum]),
                None => self.ready.push_back(middle),
            }
        }
    }

    /// The extremum next to the middle one of three points on one side of α, if the middle one is nearest to
    /// α and the extremum is on the other side of it. At an end of the range one of the neighbours is
    /// missing.
    fn hidden(
        &self,
        first: Option<MeshPoint<F>>,
        middle: MeshPoint<F>,
        last: Option<MeshPoint<F>>,
    ) -> Option<MeshPoint<F>> {
        let zero = F::int(0);
        let slides = middle.excess >= zero;
        let sign = F::int(if slides { 1 } else { -1 });
        let is_side = |node: MeshPoint<F>| (node.excess >= zero) == slides;
        let is_nearer = |node: MeshPoint<F>| sign * middle.excess <= sign * node.excess;
        let neighbours = first.into_iter().chain(last);
        let is_nearest = neighbours.clone().all(|node| is_side(node) && is_nearer(node));
        // On a mesh that resolves the border an extremum differs little from its neighbours.
        let change = neighbours.fold(zero, |most, node| most.or_larger((node.excess - middle.excess).abs()));
        if !is_nearest || middle.excess.abs() > F::int(8) * change {
            return None;
        }
        let depth = |omega: F| {
            let depth = -(sign * self.excess(omega));
            if depth > zero { Err(omega) } else { Ok(depth) }
        };
        let place = |node: Option<MeshPoint<F>>| node.unwrap_or(middle).omega;
        let omega = highest(place(first), place(last), F::epsilon(), depth).unwrap_or_else(|found| found);
        let found = MeshPoint { omega, excess: self.excess(omega) };
        (!is_side(found)).then_some(found)
    }
}

impl<F: Float> Iterator for BandSearch<F> {
    type Item = Band<F>;

    fn next(&mut self) -> Option<Band<F>> {
        let zero = F::int(0);
        let mut open: Option<(F, Edge, MeshPoint<F>)> = None;
        while let Some(node) = self.node() {
            let slides = node.excess >= zero;
            let previous = self.before.replace(node);
            open = match (open, previous) {
                (None, _) if !slides => None,
                (None, Some(before)) => {
                    let start = root::enclosed(before.omega, node.omega, |omega| self.excess(omega)).1;
                    Some((start, Edge::Border, node))
                }
                (None, None) => {
                    let edge = if node.omega > self.range.0 { Edge::Border } else { Edge::Range };
                    Some((node.omega, edge, node))
                }
                (Some((start, edge, _)), _) if slides => Some((start, edge, node)),
                (Some((low, low_edge, last)), _) => {
                    let high = root::enclosed(last.omega, node.omega, |omega| self.excess(omega)).0;
                    return Some(band(low, high, low_edge, Edge::Border));
                }
            };
        }
        open.map(|(low, low_edge, last)| band(low, last.omega, low_edge, Edge::Range))
    }
}

/// A band, with the lobe of the undamped border that contains its lower end.
fn band<F: Float>(low: F, high: F, low_edge: Edge, high_edge: Edge) -> Band<F> {
    let lobe = Lobe::containing(low).unwrap_or(Lobe::new(u16::MAX));
    Band { low, high, low_edge, high_edge, lobe: lobe.index(), reversals_per_cycle: 2 }
}
