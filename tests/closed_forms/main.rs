//! The closed forms: independent values, any precision, batches, sensitivities, ranges, inverse problems.

#[path = "../compared/mod.rs"]
mod compared;
#[path = "../drawn/mod.rs"]
mod drawn;
#[path = "../machine_box/mod.rs"]
mod machine_box;
#[path = "../random/mod.rs"]
mod random;
#[cfg(feature = "mp")]
#[path = "../ulps/mod.rs"]
mod ulps;

#[cfg(feature = "mp")]
mod accuracy;
#[cfg(feature = "batch")]
mod batch;
#[cfg(all(feature = "batch", feature = "generators"))]
#[path = "../invariants/batches.rs"]
mod batches;
#[cfg(feature = "mp")]
mod damped;
mod design;
mod design_damped;
mod design_optimum;
#[cfg(feature = "mp")]
mod design_wide;
mod free_decay;
mod identify;
mod independent;
#[cfg(feature = "mp")]
mod precision;
mod reference;
#[cfg(all(feature = "dual", feature = "mp"))]
mod sensitivity;
mod tasks;
mod uncertainty;

/// The derivatives of the dimensionless outputs by Ω and α, beside their values.
#[cfg(feature = "dual")]
fn by_ratios(ratios: stickslip::Ratios<f64>) -> Vec<(stickslip::Output, f64, [f64; 2])> {
    use stickslip::float::Dual;
    let [omega, alpha] = Dual::parameters([ratios.omega(), ratios.alpha()]);
    let dual = stickslip::Ratios::new(omega, alpha).unwrap();
    let dual = dual.with_damping_ratio(Dual::from(ratios.damping_ratio())).unwrap();
    let response = stickslip::Response::new(dual);
    let outputs = stickslip::Output::ALL.into_iter();
    outputs.filter_map(|output| output.of(&response).map(|y| (output, y.value(), y.derivatives()))).collect()
}
