//! Machines in physical units: their ratios, and the scales of their answers.

use crate::points::{self, Values};
use crate::refused;
use crate::table::Table;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::collections::HashMap;
use stickslip::internal::definitions;
use stickslip::motion::SteadyOutput;
use stickslip::{Drive, Error, Excitation, Measure, Oscillator, Output, Ratios, Scales};
use stickslip_front::inputs::units::{InputError, Kind, Reader, System};
use stickslip_front::inputs::{Given, Input, Naming, Role, critical_damping, in_place_of_zeros};

/// Mass, stiffness, friction force of forward motion, that of backward motion (NaN if equal), damping
/// constant and static friction ratio.
pub(crate) type Body = (f64, f64, f64, f64, f64, f64);

pub(crate) fn body(
    (mass, stiffness, forward, backward, damping, static_friction_ratio): Body,
) -> Result<Oscillator<f64>, Error> {
    let body = Oscillator::new(mass, stiffness, forward)?;
    let body = if backward.is_nan() { body } else { body.with_directional_friction(forward, backward)? };
    body.with_damping(damping)?.with_static_friction_ratio(static_friction_ratio)
}

/// The excitation by the keyword of its amplitude.
pub(crate) fn excitation(name: &str) -> PyResult<Excitation> {
    let known = Input::named(name).and_then(Input::excitation);
    known.ok_or_else(|| {
        let names: Vec<_> = excitations().into_iter().map(|(name, _)| name).collect();
        refused(format!("excitation {name}: must be one of {}", names.join(", ")))
    })
}

/// Values by their keywords, as text, in the named system of units or else in SI; and the system, if it is known.
pub(crate) fn given(
    values: Vec<(String, String)>,
    units: Option<&str>,
) -> PyResult<(Given<f64>, Option<String>)> {
    let reader = reader(units)?;
    let mut given = Given::empty(&reader, Naming::Keyword);
    for (name, text) in values {
        let input = Input::named(&name).ok_or_else(|| refused(format!("{name}: is unknown")))?;
        given.read(input, &text, &reader).map_err(refused)?;
    }
    Ok((given, system(&reader, units)))
}

pub(crate) fn reader(units: Option<&str>) -> PyResult<Reader> {
    let of_units = |e: InputError| refused(format!("units {}: {e}", units.unwrap_or_default()));
    let system = units.map(|text| text.parse::<System>().map_err(of_units)).transpose()?;
    Ok(Reader::new(system.as_ref(), "units=\"kN,m\""))
}

/// The system of units of the values, if it was named or a value has a unit.
fn system(reader: &Reader, units: Option<&str>) -> Option<String> {
    (units.is_some() || reader.has_converted()).then(|| reader.system().to_string())
}

/// The body of the given values, and its damping ratio.
fn of_given(given: &Given<f64>) -> Result<(Body, f64), InputError> {
    let forward = given.friction()?.unwrap_or(f64::NAN);
    let backward = given.get(Input::FrictionBackward).unwrap_or(f64::NAN);
    let body = if given.is_without_spring() || forward == 0.0 && given.has_role(Role::Spring) {
        // Without friction or a spring: what needs them refuses the body, or puts in their place what cannot be seen.
        let body = given.body(None)?;
        (body.mass(), body.stiffness(), forward, backward, body.damping(), body.static_friction_ratio())
    } else {
        let body = given.oscillator()?;
        let (damping, ratio) = (body.damping(), body.static_friction_ratio());
        (body.mass(), body.stiffness(), forward, backward, damping, ratio)
    };
    let (mass, stiffness, _, _, damping, _) = body;
    let ratio =
        || if damping == 0.0 || stiffness == 0.0 { 0.0 } else { damping / critical_damping(mass, stiffness) };
    Ok((body, given.get(Input::DampingRatio).unwrap_or_else(ratio)))
}

/// The body of the given values, its damping ratio, and the system of units.
#[pyfunction]
fn machine(values: Vec<(String, String)>, units: Option<&str>) -> PyResult<(Body, f64, Option<String>)> {
    let (given, system) = given(values, units)?;
    let (body, ratio) = of_given(&given).map_err(refused)?;
    Ok((body, ratio, system))
}

/// The names of the columns of [`machines`].
const OF_BODY: [&str; 7] = [
    "mass",
    "stiffness",
    "friction",
    "friction_backward",
    "damping",
    "static_friction_ratio",
    "damping_ratio",
];

/// Why a place of columns has no body: the error names the values that are at fault.
fn named<T>(
    given: &mut Given<f64>,
    columns: &[(Input, Vec<f64>)],
    place: usize,
    of: &impl Fn(&Given<f64>) -> Result<T, InputError>,
) -> String {
    for (input, column) in columns {
        let value = column.get(place).copied().unwrap_or(f64::NAN);
        given.set_typed(*input, value, &format!("{value:?}"));
    }
    of(given).map_or_else(|error| error.to_string(), |_| String::new())
}

/// A column of numbers for each of `K` quantities, and the places without any, with the reasons.
pub(crate) type Columns<const K: usize> = ([Vec<f64>; K], Vec<(usize, String)>);

/// `n` bodies, each of the given values with those of the columns in the place of their own. A body outside the domain, or of
/// a number that is none, has NaN throughout. Values that make no body at all are an error.
pub(crate) fn each_given<const K: usize>(
    mut given: Given<f64>,
    columns: &[(String, PyReadonlyArray1<'_, f64>)],
    n: usize,
    of: impl Fn(&Given<f64>) -> Result<[f64; K], InputError>,
) -> PyResult<Columns<K>> {
    let column = |(name, array): &(String, PyReadonlyArray1<'_, f64>)| {
        let input = Input::named(name).ok_or_else(|| refused(format!("{name}: is unknown")))?;
        Ok::<_, PyErr>((input, array.as_slice()?.to_vec()))
    };
    let columns = columns.iter().map(column).collect::<PyResult<Vec<_>>>()?;
    let (mut found, mut failed) = ([const { Vec::new() }; K], Vec::new());
    for place in 0..n {
        let mut missing = None;
        for (input, column) in &columns {
            let value = column.get(place).copied().unwrap_or(f64::NAN);
            missing = missing
                .or_else(|| value.is_nan().then(|| format!("{} = NaN: must be finite", input.column())));
            given.set(*input, value);
        }
        let row =
            missing.map_or_else(|| of(&given).map_err(|_| named(&mut given, &columns, place, &of)), Err);
        let row = row.unwrap_or_else(|reason| {
            failed.push((place, reason));
            [f64::NAN; K]
        });
        for (column, value) in found.iter_mut().zip(row) {
            column.push(value);
        }
    }
    if failed.len() == n {
        // Values that no body can have together are refused; those outside the domain are not.
        for (input, _) in &columns {
            given.set(*input, if *input == Input::StaticFriction { 1e300 } else { 1.0 });
        }
        of(&given).map_err(refused)?;
    }
    Ok((found, failed))
}

/// Bodies as columns, the places that have none with the reasons, and the system of units.
pub(crate) type Machines<'py> = (Bound<'py, PyDict>, Vec<(usize, String)>, Option<String>);

/// Bodies as columns, of values as texts and, in place of some of these, of columns of bare numbers.
#[pyfunction]
fn machines<'py>(
    py: Python<'py>,
    values: Vec<(String, String)>,
    columns: Vec<(String, PyReadonlyArray1<'py, f64>)>,
    n: usize,
    units: Option<&str>,
) -> PyResult<Machines<'py>> {
    let (given, system) = given(values, units)?;
    let (found, failed) = each_given(given, &columns, n, |given| {
        let ((mass, stiffness, forward, backward, damping, eta), zeta) = of_given(given)?;
        Ok([mass, stiffness, forward, backward, damping, eta, zeta])
    })?;
    let mut table = Table::default();
    for (name, column) in OF_BODY.into_iter().zip(found) {
        table.number(name, column);
    }
    Ok((table.into_dict(py)?, failed, system))
}

/// The excitation of the given values by its keyword, its amplitude and the constant force, and their system of units.
#[pyfunction]
fn drive(values: Vec<(String, String)>, units: Option<&str>) -> PyResult<(String, f64, f64, Option<String>)> {
    let (given, system) = given(values, units)?;
    let (input, amplitude) = given.amplitude().map_err(refused)?;
    let mean = given.get(Input::MeanForce).unwrap_or(0.0);
    let kind = input.excitation().ok_or_else(|| refused(format!("{}: is no drive", input.column())))?;
    // An amplitude of 0 leaves the body at rest; the frequency is checked apart.
    let checked = Drive::new(kind, if amplitude == 0.0 { 1.0 } else { amplitude }, 1.0);
    checked.and_then(|drive| drive.with_mean_force(mean)).map_err(|error| refused(given.at_fault(&error)))?;
    Ok((input.column(), amplitude, mean, system))
}

/// Reads values, each given by name, text and kind, in the named system of units or else in SI.
#[pyfunction]
fn read_values(
    values: Vec<(String, String, String)>,
    units: Option<&str>,
) -> PyResult<(Vec<f64>, Option<String>)> {
    let reader = reader(units)?;
    let read =
        |(name, text, of): (String, String, String)| reader.value(&name, &text, kind(&of)?).map_err(refused);
    let found = values.into_iter().map(read).collect::<PyResult<_>>()?;
    Ok((found, system(&reader, units)))
}

/// The numbers of a column in a unit, in the named system of units or else in SI.
#[pyfunction]
fn read_column<'py>(
    py: Python<'py>,
    name: &str,
    numbers: PyReadonlyArray1<'py, f64>,
    unit: &str,
    of: &str,
    units: Option<&str>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let factor = reader(units)?.factor_of_column(name, unit, kind(of)?).map_err(refused)?;
    let found: Vec<f64> = numbers.as_slice()?.iter().map(|x| factor.times(*x)).collect();
    Ok(found.into_pyarray(py))
}

/// Whether a text is a unit.
#[pyfunction]
fn is_unit(text: &str) -> bool {
    Reader::is_unit(text)
}

/// Whether a text has a unit after its number.
#[pyfunction]
fn has_unit(text: &str) -> bool {
    Reader::has_unit(text)
}

/// The name of the unit of a kind of quantity in a system.
#[pyfunction]
fn unit_of(units: &str, of: &str) -> PyResult<String> {
    Ok(units.parse::<System>().map_err(refused)?.name(kind(of)?))
}

/// The kind of a quantity by its name.
fn kind(name: &str) -> PyResult<Kind> {
    Kind::named(name).ok_or_else(|| refused(format!("kind {name}: is unknown")))
}

/// The excitations by the keywords of their amplitudes, with the kinds of these.
fn excitations() -> Vec<(String, &'static str)> {
    // An unbalance has one keyword.
    let inputs = Input::ALL.into_iter();
    let inputs = inputs.filter(|input| input.excitation().is_some() && *input != Input::Eccentricity);
    inputs.map(|input| (input.column(), input.kind().name())).collect()
}

/// A body under a drive.
struct Under<'a> {
    body: &'a Oscillator<f64>,
    drive: Drive<f64>,
    ratios: Ratios<f64>,
    scales: Scales<f64>,
}

impl<'a> Under<'a> {
    fn new(body: &'a Oscillator<f64>, drive: Drive<f64>) -> Result<Self, Error> {
        let (ratios, scales) = (drive.ratios(body)?, Scales::new(body, &drive)?);
        Ok(Self { body, drive, ratios, scales })
    }
}

/// A value of a body under a drive.
type OfDrive = fn(&Under<'_>) -> f64;

/// The values of a body under a drive by their names.
const OF_DRIVE: [(&str, OfDrive); 16] = [
    ("omega", |under| under.ratios.omega()),
    ("alpha", |under| under.ratios.alpha()),
    ("damping_ratio", |under| under.ratios.damping_ratio()),
    ("static_friction_ratio", |under| under.ratios.static_friction_ratio()),
    ("length", |under| under.scales.length),
    ("velocity", |under| under.scales.velocity),
    ("time", |under| under.scales.time),
    ("force", |under| under.scales.force),
    ("force_amplitude", |under| under.drive.force_amplitude(under.body)),
    ("energy", |under| under.scales.energy_stiffness),
    ("energy_inertia", |under| under.scales.energy_inertia),
    ("acceleration", |under| under.scales.velocity / under.scales.time),
    ("stiffness", |under| Measure::Stiffness.size(&under.scales)),
    ("damping", |under| Measure::Damping.size(&under.scales)),
    ("mean_displacement", |under| under.scales.mean_displacement),
    ("mean_friction", |under| under.scales.mean_friction),
];

/// The values of one body or several, in the order of [`Body`].
pub(crate) struct Bodies<'a>([Values<'a>; 6]);

impl<'a> Bodies<'a> {
    pub(crate) fn of(given: &'a [points::Given<'_>; 6]) -> PyResult<Self> {
        let [mass, stiffness, friction, backward, damping, ratio] = given;
        Ok(Self([
            Values::of(mass)?,
            Values::of(stiffness)?,
            Values::of(friction)?,
            Values::of(backward)?,
            Values::of(damping)?,
            Values::of(ratio)?,
        ]))
    }

    /// Whether there is one body for all places.
    pub(crate) fn is_one(&self) -> bool {
        self.0.iter().all(|values| matches!(values, Values::One(..)))
    }

    /// The body at a place.
    pub(crate) fn at(&self, place: usize) -> Option<Result<Oscillator<f64>, Error>> {
        self.given_at(place).map(body)
    }

    /// The values of the body at a place.
    pub(crate) fn given_at(&self, place: usize) -> Option<Body> {
        let [mass, stiffness, friction, backward, damping, ratio] = self.0.map(|values| values.at(place));
        Some((mass?, stiffness?, friction?, backward?, damping?, ratio?))
    }
}

/// The frictions, the stiffnesses and the amplitudes of bodies under drives at `n` places, with those far below the rounding of
/// every motion in place of 0; as they are where there is no body or no drive.
#[pyfunction]
fn without_zeros<'py>(
    py: Python<'py>,
    of: [points::Given<'py>; 6],
    kind: &str,
    drives: [points::Given<'py>; 3],
    n: usize,
) -> PyResult<Bound<'py, PyDict>> {
    let (bodies, kind) = (Bodies::of(&of)?, excitation(kind)?);
    let [amplitude, frequency, _] = &drives;
    let (amplitude, frequency) = (Values::of(amplitude)?, Values::of(frequency)?);
    let mut found = [const { Vec::new() }; 4];
    for place in 0..n {
        let at = || Some((bodies.given_at(place)?, amplitude.at(place)?, frequency.at(place)?));
        let Some((given, amplitude, frequency)) = at() else { continue };
        let (mass, stiffness, forward, backward, damping, ratio) = given;
        // Without friction, too, the body is free, and has no answer here.
        let vanishing = || Some(Oscillator::without_spring(mass, 1.0, frequency).ok()?.stiffness());
        let stiffness =
            if stiffness == 0.0 && forward > 0.0 { vanishing().unwrap_or(0.0) } else { stiffness };
        let is_still = amplitude == 0.0;
        let is_free = forward == 0.0 && (backward == 0.0 || backward.is_nan());
        let (one, apart) = if is_free { (1.0, f64::NAN) } else { (forward, backward) };
        let there = || {
            let body = body((mass, stiffness, one, apart, damping, ratio))?;
            let drive = Drive::new(kind, if is_still { 1.0 } else { amplitude }, frequency)?;
            Ok::<_, Error>(in_place_of_zeros(&body, &drive, is_free, is_still))
        };
        // Friction by direction is that of the body, which the rule gives as a mean.
        let (friction, amplitude) = there().unwrap_or((forward, amplitude));
        let row = [if is_free { friction } else { forward }, apart, stiffness, amplitude];
        for (column, value) in found.iter_mut().zip(row) {
            column.push(value);
        }
    }
    let mut table = Table::default();
    for (name, column) in ["friction", "friction_backward", "stiffness", "amplitude"].into_iter().zip(found) {
        table.number(name, column);
    }
    table.into_dict(py)
}

/// Ratios or scales of bodies under drives of these amplitudes, angular frequencies and mean forces at `n` places, by their
/// names. A place outside the domain has NaN if it is one of `many`.
#[pyfunction]
fn machine_columns<'py>(
    py: Python<'py>,
    of: [points::Given<'py>; 6],
    kind: &str,
    drives: [points::Given<'py>; 3],
    n: usize,
    many: bool,
    names: Vec<String>,
) -> PyResult<Bound<'py, PyDict>> {
    let (bodies, kind) = (Bodies::of(&of)?, excitation(kind)?);
    let [amplitude, frequency, mean_force] = &drives;
    let amplitude = Values::of(amplitude)?;
    let (frequency, mean_force) = (Values::of(frequency)?, Values::of(mean_force)?);
    let chosen: Vec<_> = OF_DRIVE.iter().filter(|(name, _)| names.iter().any(|own| own == name)).collect();
    let mut columns: Vec<_> = chosen.iter().map(|_| Vec::with_capacity(n)).collect();
    let one = bodies.is_one().then(|| bodies.at(0)).flatten().transpose().map_err(refused)?;
    let filled = py.detach(|| {
        for place in 0..n {
            let at = || Some((amplitude.at(place)?, frequency.at(place)?, mean_force.at(place)?));
            let (Some((amplitude, frequency, mean_force)), Some(body)) =
                (at(), one.map(Ok).or_else(|| bodies.at(place)))
            else {
                continue;
            };
            let drive =
                Drive::new(kind, amplitude, frequency).and_then(|drive| drive.with_mean_force(mean_force));
            let bodies = body.as_ref().map_err(Clone::clone);
            let under = match bodies.and_then(|body| Under::new(body, drive?)) {
                Err(error) if !many => return Err(error),
                under => under.ok(),
            };
            for (column, (_, value)) in columns.iter_mut().zip(&chosen) {
                column.push(under.as_ref().map_or(f64::NAN, value));
            }
        }
        Ok::<_, Error>(())
    });
    filled.map_err(refused)?;
    let mut table = Table::default();
    for ((name, _), column) in chosen.into_iter().zip(columns) {
        table.number(name, column);
    }
    table.into_dict(py)
}

/// The size of a measure by its name: a column of [`machine_columns`], or one that follows from these.
const fn scale(measure: Measure) -> &'static str {
    match measure {
        Measure::Angle => "time",
        Measure::Turns => "period",
        Measure::Length => "length",
        Measure::Velocity => "velocity",
        Measure::Acceleration => "acceleration",
        Measure::Force | Measure::ForceRatio => "force",
        Measure::Stiffness => "stiffness",
        Measure::Damping => "damping",
        Measure::Work => "work",
        Measure::EnergyStiffness | Measure::EnergyOfLargestLoop => "energy",
        Measure::EnergyInertia => "energy_inertia",
        _ => "",
    }
}

/// The outputs that have a value in physical units under an excitation: for each name that of this value, its
/// scale and its kind.
#[pyfunction]
fn physical_outputs(
    excited: &str,
) -> PyResult<HashMap<&'static str, (&'static str, &'static str, &'static str)>> {
    let excited = excitation(excited)?;
    let outputs = Output::ALL.map(Output::definition).into_iter();
    let steady = SteadyOutput::ALL.map(SteadyOutput::definition).into_iter();
    let all = outputs.chain(steady).chain([definitions::PERIODS, definitions::REST_POSITION]);
    let named = all.filter_map(|output| {
        let name = output.physical_name(excited)?;
        Some((output.name, (name, scale(output.measure), output.measure.kind().name())))
    });
    Ok(named.collect())
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("EXCITATIONS", excitations())?;
    let kinds = Input::ALL.into_iter().map(|input| (input.column(), input.kind().name()));
    module.add("INPUTS", kinds.collect::<Vec<_>>())?;
    module.add_function(wrap_pyfunction!(read_column, module)?)?;
    module.add_function(wrap_pyfunction!(is_unit, module)?)?;
    module.add_function(wrap_pyfunction!(has_unit, module)?)?;
    module.add_function(wrap_pyfunction!(machine, module)?)?;
    module.add_function(wrap_pyfunction!(machines, module)?)?;
    module.add_function(wrap_pyfunction!(drive, module)?)?;
    module.add_function(wrap_pyfunction!(read_values, module)?)?;
    module.add_function(wrap_pyfunction!(unit_of, module)?)?;
    module.add_function(wrap_pyfunction!(physical_outputs, module)?)?;
    module.add_function(wrap_pyfunction!(without_zeros, module)?)?;
    module.add_function(wrap_pyfunction!(machine_columns, module)?)
}
