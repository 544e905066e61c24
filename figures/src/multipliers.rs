//! The rate at which a disturbance decays.

use crate::shared::{evenly, inverse_force_ratios, of_frequency_ratio};
use stickslip::cycle::Multipliers;
use stickslip::{Cycle, Ratios};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};

/// The contraction per cycle over Ω, and the multipliers per half cycle in the complex plane.
pub(super) fn of_the_cycle() -> Figure {
    let contraction = |(index, alpha, name): (usize, f64, String)| {
        let points = frequency_ratios()
            .map(move |omega| (omega, multipliers_at(omega, alpha).map_or(f64::NAN, |m| m.contraction)));
        Series::new(name, Style::Marked(36 + index), index, points)
    };
    let locus = |(index, alpha, name): (usize, f64, String)| {
        let one = move |which: MultiplierPart| {
            frequency_ratios().map(move |omega| {
                multipliers_at(omega, alpha).map_or((f64::NAN, f64::NAN), |m| which(m.half_cycle))
            })
        };
        let points = one(|[first, _]| first).chain([(f64::NAN, f64::NAN)]).chain(one(|[_, second]| second));
        let marked = multipliers_at(MARKED, alpha).map(|m| m.half_cycle);
        [
            Series::new(name.clone(), Style::Dots, index, points),
            Series::new(name, Style::Marks, index, marked.into_iter().flatten()),
        ]
    };
    let circle = evenly(0.0, std::f64::consts::TAU, 181).map(|t| (t.cos(), t.sin()));
    let mut loci = vec![Series::new("modulus 1", Style::Dotted, 0, circle)];
    loci.extend(inverse_force_ratios(6).flat_map(locus));
    Figure::new(
        "multipliers",
        "How fast the motion settles",
        "Left: the part of a disturbance that remains after a cycle. Right: both multipliers of a \
            half cycle, for Ω from 0.2 to 2, marked at 3/2.",
        vec![
            Panel::new(
                "contraction per cycle",
                of_frequency_ratio(0.2, 2.0),
                Axis::linear("contraction max |λ|²", 0.0, 1.1),
                inverse_force_ratios(6).map(contraction).collect(),
            ),
            Panel::new(
                "multipliers per half cycle",
                Axis::linear("real part of λ", -1.1, 1.1),
                Axis::linear("imaginary part of λ", -1.1, 1.1),
                loci,
            ),
        ],
    )
}

/// One of two multipliers, each as (re, im).
type MultiplierPart = fn([(f64, f64); 2]) -> (f64, f64);

/// The frequency ratio of the marks.
const MARKED: f64 = 1.5;

/// Ω from 0.2 to 2.
fn frequency_ratios() -> impl Iterator<Item = f64> + Clone {
    evenly(0.2025, 1.9975, 360)
}

fn multipliers_at(omega: f64, alpha: f64) -> Option<Multipliers<f64>> {
    Ratios::new(omega, alpha).and_then(Cycle::new).ok().map(|cycle| cycle.multipliers())
}
