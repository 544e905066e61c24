//! The points, and the errors at them.

use super::equations::equations;
use nalgebra::RealField;
use std::collections::BTreeMap;
use stickslip::cycle::matching::newton;
use stickslip::{Border, Cycle, Field, Float, PhaseFunction, Ratios};

/// `10⁻ᵏ`.
pub(crate) fn tenth_power<F: Float>(k: u32) -> F {
    (0..k).fold(<F as Field>::int(1), |x, _| x / <F as Field>::int(10))
}

/// Ω = 1 and 1/(2n+1), n = 1, 2, 3, each with a relative offset of ± 10⁻ᵏ.
pub(crate) fn special<F: Float>(powers: &[u32]) -> Vec<F> {
    let one = <F as Field>::int(1);
    let beside = |odd: i32, off: F| (one + off) / <F as Field>::int(odd);
    let at = |k: &u32| {
        let off = tenth_power::<F>(*k);
        [1, 3, 5, 7].map(|odd| [beside(odd, off), beside(odd, -off)])
    };
    powers.iter().flat_map(at).flatten().collect()
}

/// The worst results.
#[derive(Debug, Default)]
pub(crate) struct Worst {
    points: u32,
    /// The error relative to the closed forms in units in the last place, divided by 2^lost_bits.
    error: f64,
    /// The error of the border in units in the last place, divided by (1 + 1/Ω)².
    border: f64,
    /// The residual of eq. 21–25 in units in the last place.
    residual: f64,
    /// The residual of each of eq. 28–49 in units in the last place of its terms.
    equations: BTreeMap<&'static str, f64>,
    iterations: u32,
    border_iterations: u32,
    pub(crate) lost_bits: u32,
}

impl Worst {
    /// Solves at (Ω, α) and compares with the closed forms.
    pub(crate) fn add<F: Float + RealField>(&mut self, omega: F, alpha: F) {
        let cycle = Cycle::new(Ratios::new(omega, alpha).unwrap()).unwrap();
        let found = match newton::solve(cycle.ratios) {
            Ok(found) => found,
            Err(e) => panic!("Ω = {omega}, α = {alpha}: {e}"),
        };
        let (u, w) = (found.unknowns, cycle.unknowns());
        let one = <F as Field>::int(1);
        let apart = |a: F, b: F, size: F| Float::to_f64(Field::abs(a - b) / size / <F as Float>::epsilon());
        let errors = [
            apart(u.max_displacement, w.max_displacement, w.max_displacement),
            apart(u.max_velocity, w.max_velocity, w.max_velocity),
            apart(u.velocity_phase, w.velocity_phase, one),
            apart(u.displacement_phase, w.displacement_phase, one),
            apart(u.deviation, w.deviation, one + alpha),
        ];
        let error = errors.into_iter().fold(0.0, f64::max) / 2f64.powi(found.lost_bits as i32);
        assert!(error < 16.0, "Ω = {omega}, α = {alpha}: {errors:?} ulp, {} bits lost", found.lost_bits);
        self.points += 1;
        self.error = self.error.max(error);
        self.residual = found.residuals.iter().fold(self.residual, |most, r| most.max(Float::to_f64(*r)));
        self.iterations = self.iterations.max(found.iterations);
        self.lost_bits = self.lost_bits.max(found.lost_bits);
        for (name, residual, size, against_closed_form) in equations(omega, alpha, &u) {
            let ulp = apart(residual, <F as Field>::int(0), size);
            // Eq. 40–44, 47 and 49 compare with a closed form, so that the lost bits appear in them.
            let lost = if against_closed_form { 2f64.powi(found.lost_bits as i32) } else { 1.0 };
            assert!(ulp < 8.0 * lost, "eq. {name} at Ω = {omega}, α = {alpha}: {ulp} ulp");
            let worst = self.equations.entry(name).or_default();
            *worst = worst.max(ulp);
        }
    }

    /// Solves for the border at Ω and compares with eq. 61.
    pub(crate) fn add_border<F: Float + RealField>(&mut self, omega: F) {
        let found = match newton::solve_border(omega) {
            Ok(found) => found,
            Err(e) => panic!("border at Ω = {omega}: {e}"),
        };
        let by_61 = Border::turning_point_at(&PhaseFunction::new(omega).unwrap());
        let error = Float::to_f64((found.force_ratio - by_61) / by_61 / <F as Float>::epsilon()).abs();
        let per_turn = 1.0 + 1.0 / Float::to_f64(omega);
        assert!(
            error < 4.0 * per_turn * per_turn,
            "border at Ω = {omega}: {} by 6 × 6, {by_61} by eq. 61: {error} ulp",
            found.force_ratio
        );
        self.border = self.border.max(error / (per_turn * per_turn));
        self.border_iterations = self.border_iterations.max(found.iterations);
        let last = found.residuals.iter().fold(0.0, |most: f64, r| most.max(Float::to_f64(*r)));
        self.residual = self.residual.max(last);
    }

    /// Prints the results, and fails if they exceed these bounds.
    #[expect(
        clippy::print_stdout,
        reason = "the figures of docs/development/proof.md, seen with --nocapture"
    )]
    pub(crate) fn check(&self, name: &str, error: f64, iterations: u32) {
        println!("{name}: {self:?}");
        assert!(self.points > 0 && self.error <= error && self.iterations <= iterations, "{name}: {self:?}");
        assert!(self.residual < 100.0, "{name}: {self:?}");
    }

    /// The worse of two results.
    pub(crate) fn merged(mut self, other: &Self) -> Self {
        self.points += other.points;
        self.error = self.error.max(other.error);
        self.border = self.border.max(other.border);
        self.residual = self.residual.max(other.residual);
        for (name, &residual) in &other.equations {
            let worst = self.equations.entry(name).or_default();
            *worst = worst.max(residual);
        }
        self.lost_bits = self.lost_bits.max(other.lost_bits);
        self
    }

    /// Fails if a column of the table in `docs/development/proof.md` differs.
    pub(crate) fn is_on_the_page(&self, column: &str) {
        let rows = page_rows();
        let at = rows[0].iter().position(|cell| cell == column).unwrap();
        let mut compared = 0;
        for row in &rows[1..] {
            let of = |names: &[&str]| names.iter().map(|name| self.equations[name]).fold(0.0, f64::max);
            let measured = match row[0].split([' ', ',', '¹']).next().unwrap() {
                "21–25" => self.residual,
                "28" => of(&["28", "29"]),
                "32–36" => of(&["32", "33", "34", "35", "36"]),
                "38" => of(&["38", "39"]),
                "45" => of(&["45", "46"]),
                "42" => of(&["42, 44"]),
                "37" => of(&["37, 49"]),
                name @ ("40" | "41" | "43" | "47") => of(&[name]),
                "border" => self.border,
                "most" => f64::from(self.lost_bits),
                _ => continue,
            };
            let printed: f64 = row[at].parse().unwrap();
            // With another library of circular functions the last digit may differ.
            let slack = 0.06 + 0.2 * printed;
            assert!((measured - printed).abs() <= slack, "{column}, {}: {measured}, not {printed}", row[0]);
            compared += 1;
        }
        assert_eq!(compared, 13, "{rows:?}");
    }
}

/// The cells of the table of residuals in `docs/development/proof.md`, starting with the header.
fn page_rows() -> Vec<Vec<String>> {
    let page = include_str!("../../docs/development/proof.md").lines();
    let table = page
        .skip_while(|line| !line.starts_with("| equations | f64 |"))
        .take_while(|line| line.starts_with('|'));
    let cells = |line: &str| line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect();
    table.filter(|line| !line.starts_with("|---")).map(cells).collect()
}
