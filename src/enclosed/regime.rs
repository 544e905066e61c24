//! The regime, where it is certain.

use crate::named::named;

named! {
    /// The regime, where it is certain.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    #[non_exhaustive]
    pub enum Regime [name] {
        /// α ≤ 1: the body ends at rest.
        Stuck = "stuck",
        /// 1 < α < α_min(Ω): there is no cycle of two reversals without a stop. The body sticks, except at the
        /// force ratios of six reversals near a pole ([`crate::cycle::SixReversals`]), which are not
        /// enclosed. With η > 1 it sticks from every start where α > η, and may end at rest where α ≤ η.
        BelowBorder = "below the border",
        /// α > α_min(Ω): two reversals a cycle and no stop. With η > 1 only above the bound of
        /// [`crate::NoStop::every_start`], because every start leads there.
        NonSticking = "non-sticking",
        /// Ω = 1, ζ = 0 and α > 4/π, with η > 1 α > 4η/π: the displacement grows without bound from every start.
        Unbounded = "unbounded",
        /// η > 1 and α > α_min(Ω), but not above the bound for every start: a motion of two reversals without a
        /// stop exists and attracts its neighbourhood. Other starts may lead to other motions, and for α ≤ η a
        /// body at rest stays at rest.
        DependsOnStart = "depends-on-start",
    }
}
