//! Machines in physical units: their ratios, and the scales of their answers.

use crate::refused;
use crate::table::Table;
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use stickslip::{Drive, Error, Excitation, Oscillator, Output, Scales};

/// Mass, stiffness, friction against motion forward, the same backward (NaN for the same), damping constant.
pub(crate) type Body = (f64, f64, f64, f64, f64);

pub(crate) fn body((mass, stiffness, forward, backward, damping): Body) -> Result<Oscillator<f64>, Error> {
    let body = Oscillator::new(mass, stiffness, forward)?;
    let body = if backward.is_nan() { body } else { body.with_directional_friction(forward, backward)? };
    body.with_damping(damping)
}

/// The excitation by the name of the argument that gives its amplitude.
pub(crate) fn excitation(name: &str) -> PyResult<Excitation> {
    Ok(match name {
        "force" => Excitation::Force,
        "foot_displacement" => Excitation::FootMotion,
        "damped_foot_displacement" => Excitation::DampedFootMotion,
        "base_displacement" => Excitation::SurfaceMotion,
        "base_velocity" => Excitation::SurfaceVelocity,
        "base_acceleration" => Excitation::SurfaceAcceleration,
        _ => return Err(refused(format!("excitation {name}: is none"))),
    })
}

/// The damping constant of a damping ratio.
#[pyfunction]
fn damping_constant(mass: f64, stiffness: f64, friction: f64, damping_ratio: f64) -> PyResult<f64> {
    let body =
        Oscillator::new(mass, stiffness, friction).and_then(|body| body.with_damping_ratio(damping_ratio));
    Ok(body.map_err(refused)?.damping())
}

/// Ω, α, ζ and the scales of one body under many drives.
#[pyfunction]
fn machine_columns<'py>(
    py: Python<'py>,
    of: Body,
    kind: &str,
    amplitude: PyReadonlyArray1<'py, f64>,
    angular_frequency: PyReadonlyArray1<'py, f64>,
    mean_force: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let (body, kind) = (body(of).map_err(refused)?, excitation(kind)?);
    let names = [
        "omega",
        "alpha",
        "damping_ratio",
        "length",
        "velocity",
        "time",
        "force",
        "energy",
        "energy_inertia",
        "acceleration",
        "mean_displacement",
    ];
    let mut columns: [Vec<f64>; 11] = Default::default();
    for (&amplitude, &frequency) in amplitude.as_slice()?.iter().zip(angular_frequency.as_slice()?) {
        let row = (|| {
            let drive = Drive::new(kind, amplitude, frequency)?.with_mean_force(mean_force)?;
            let (ratios, scales) = (drive.ratios(&body)?, Scales::new(&body, &drive)?);
            Ok::<_, Error>([
                ratios.omega(),
                ratios.alpha(),
                ratios.damping_ratio(),
                scales.length,
                scales.velocity,
                scales.time,
                scales.force,
                scales.energy_stiffness,
                scales.energy_inertia,
                scales.velocity / scales.time,
                scales.mean_displacement,
            ])
        })();
        for (column, value) in columns.iter_mut().zip(row.map_err(refused)?) {
            column.push(value);
        }
    }
    let mut table = Table::default();
    for (name, column) in names.into_iter().zip(columns) {
        table.number(name, column);
    }
    table.into_dict(py)
}

/// The scale of each output by its name: a name of [`machine_columns`], or nothing for a pure number.
fn units() -> Vec<(&'static str, &'static str)> {
    // Scales that no two dimensions share, so that a unit tells which it is.
    let marks = Scales {
        length: 2.0,
        velocity: 3.0,
        time: 5.0,
        force: 7.0,
        energy_stiffness: 11.0,
        energy_inertia: 13.0,
        mean_displacement: 0.0,
    };
    let names = [
        (marks.length, "length"),
        (marks.velocity, "velocity"),
        (marks.time, "time"),
        (marks.force, "force"),
        (marks.energy_stiffness, "energy"),
        (marks.energy_inertia, "energy_inertia"),
        (marks.velocity / marks.time, "acceleration"),
    ];
    let name = |unit: f64| names.iter().find(|(mark, _)| *mark == unit).map_or("", |(_, name)| name);
    Output::ALL.map(|output| (output.name(), name(output.unit(&marks)))).to_vec()
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("UNITS", units())?;
    module.add_function(wrap_pyfunction!(damping_constant, module)?)?;
    module.add_function(wrap_pyfunction!(machine_columns, module)?)
}
