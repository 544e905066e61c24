"""Values that carry a unit: used as texts with the same units are, or refused, and never read as bare numbers."""

import copy
import math
import pickle
import warnings

import astropy.table
import astropy.units as of_astropy
import numpy as np
import pandas
import pint
import pytest
import xarray

import stickslip as ss

pytestmark = pytest.mark.filterwarnings("error")
REGISTRY = pint.UnitRegistry()


def by_pint(number, unit):
    return REGISTRY.Quantity(number, unit)


def by_astropy(number, unit):
    with of_astropy.imperial.enable():
        return number * of_astropy.Unit(unit.replace("^", "**").replace("rpm", "cycle/min").replace("t*", "tonne*") if unit != "t" else "tonne")


def by_series(number, unit):
    return pandas.Series(np.atleast_1d(number), name=f"typed [{unit}]", dtype=float)


def by_attributes(number, unit):
    return xarray.DataArray(np.atleast_1d(number).astype(float), dims="n", attrs={"units": unit})


def by_frame(number, unit):
    return pandas.DataFrame({f"typed ({unit})": np.atleast_1d(number).astype(float)})


def by_objects(number, unit):
    return pandas.Series([by_pint(x, unit) for x in np.atleast_1d(number).tolist()])


def by_list(number, unit):
    return [by_pint(x, unit) for x in np.atleast_1d(number).tolist()]


SCALARS = [by_pint, by_astropy]
ARRAYS = [by_pint, by_astropy, by_series, by_attributes, by_frame, by_objects, by_list]
#: A number with its unit for each keyword, and the other keywords beside it.
OF_MACHINE = {
    "mass": (50.0, "t", {"stiffness": "1000 kN/m", "friction": "5 kN"}),
    "weight": (490.0, "kN", {"stiffness": "1000 kN/m", "friction": "5 kN"}),
    "stiffness": (1000.0, "kN/m", {"mass": "50 t", "friction": "5 kN"}),
    "natural_frequency": (90.0, "rpm", {"mass": "50 t", "friction": "5 kN"}),
    "period": (2200.0, "ms", {"mass": "50 t", "friction": "5 kN"}),
    "pendulum_radius": (1500.0, "mm", {"mass": "50 t", "friction": "5 kN"}),
    "friction": (5.0, "kN", {"mass": "50 t", "stiffness": "1000 kN/m"}),
    "friction_coefficient": (5.0, "percent", {"mass": "50 t", "stiffness": "1000 kN/m"}),
    "gravity": (9810.0, "mm/s^2", {"mass": "50 t", "stiffness": "1000 kN/m", "friction_coefficient": 0.05}),
    "friction_backward": (4000.0, "N", {"mass": "50 t", "stiffness": "1000 kN/m", "friction": "5 kN"}),
    "damping": (3.0, "N*s/mm", {"mass": "50 t", "stiffness": "1000 kN/m", "friction": "5 kN"}),
    "damping_ratio": (2.0, "percent", {"mass": "50 t", "stiffness": "1000 kN/m", "friction": "5 kN"}),
    "static_friction": (6000.0, "N", {"mass": "50 t", "stiffness": "1000 kN/m", "friction": "5 kN"}),
    "static_friction_ratio": (130.0, "percent", {"mass": "50 t", "stiffness": "1000 kN/m", "friction": "5 kN"}),
}
OF_DRIVE = {
    "force": (12.0, "kN", {"frequency": 1.0}),
    "unbalance": (350.0, "kg*mm", {"frequency": 1.0}),
    "foot_displacement": (9.0, "mm", {"frequency": 1.0}),
    "damped_foot_displacement": (9.0, "mm", {"frequency": 1.0}),
    "base_displacement": (9.0, "mm", {"frequency": 1.0}),
    "base_velocity": (30.0, "mm/s", {"frequency": 1.0}),
    "base_acceleration": (150.0, "cm/s^2", {"frequency": 1.0}),
    "mean_force": (500.0, "N", {"force": "12 kN", "frequency": 1.0}),
    "frequency": (120.0, "rpm", {"force": "12 kN"}),
    "angular_frequency": (2.0, "kHz", {"force": "12 kN"}),
}
OF_BLOCK = {
    "mass": (1.5, "t", {"friction": "2 kN"}),
    "friction": (2.0, "kN", {"mass": "1 t"}),
    "yield_acceleration": (100.0, "cm/s^2", {"mass": "1 t"}),
    "gravity": (9810.0, "mm/s^2", {"mass": "1 t", "friction_coefficient": 0.1}),
    "mean_force": (500.0, "N", {"mass": "1 t", "friction": "2 kN"}),
    "slope": (10.0, "deg", {"mass": "1 t", "friction": "2 kN"}),
}
ALL = [(of, name, *row) for of, rows in ((ss.Machine, OF_MACHINE), (ss.Drive, OF_DRIVE), (ss.Block, OF_BLOCK)) for name, row in rows.items()]
NAMES = [f"{of.__name__}.{name}" for of, name, *_ in ALL]


def values(of):
    """The numbers that determine a machine, a drive or a block."""
    names = ("mass", "stiffness", "friction", "friction_backward", "damping", "static_friction_ratio", "mean_force", "amplitude", "angular_frequency")
    return {name: np.asarray(getattr(of, name), float).reshape(-1) for name in names if getattr(of, name, None) is not None}


def typed(number, unit):
    return f"{number} {unit}".replace("percent", "%")


@pytest.mark.parametrize("units", [None, "kN,mm"])
@pytest.mark.parametrize("by", SCALARS)
@pytest.mark.parametrize("of, name, number, unit, others", ALL, ids=NAMES)
def test_a_quantity_is_the_text_with_its_unit(of, name, number, unit, others, by, units):
    due = of(**others, **{name: typed(number, unit)}, units=units)
    found = of(**others, **{name: by(number, unit)}, units=units)
    assert found.units == due.units
    for key, value in values(due).items():
        # Conversions by another package round twice more.
        np.testing.assert_allclose(values(found)[key], value, rtol=4e-16 * 3, err_msg=key)
    again = pickle.loads(pickle.dumps(found)).replace()
    assert values(copy.deepcopy(again)).keys() == values(due).keys() and again == found


@pytest.mark.parametrize("units", [None, "kN,mm"])
@pytest.mark.parametrize("by", ARRAYS)
@pytest.mark.parametrize("of, name, number, unit, others", [row for row in ALL if row[1] != "slope"], ids=[name for name in NAMES if "slope" not in name])
def test_an_array_has_the_numbers_of_its_texts(of, name, number, unit, others, by, units):
    numbers = [number, 1.25 * number]
    spelt = unit.replace("percent", "%") if by in (by_series, by_attributes, by_frame) else unit
    found = of(**others, **{name: by(np.array(numbers), spelt)}, units=units)
    each = [of(**others, **{name: typed(x, unit)}, units=units) for x in numbers]
    assert found.units == each[0].units
    for key, value in values(found).items():
        due = np.concatenate([values(one)[key] for one in each]) if value.size == 2 else values(each[0])[key]
        np.testing.assert_allclose(value, due, rtol=4e-16 * 3, err_msg=key)


@pytest.mark.parametrize("by", ARRAYS)
@pytest.mark.parametrize("of, name, number, unit, others", ALL, ids=NAMES)
def test_another_dimension_is_refused_by_name(of, name, number, unit, others, by):
    with pytest.raises(ss.Error) as error:
        of(**others, **{name: by(np.array([3.0, 4.0]), "kg*s")})
    assert name in str(error.value) and ("kg*s" in str(error.value) or name == "slope")
    if by not in SCALARS:
        return
    with pytest.raises(ss.Error, match=f"{name} (3.0 |.)(K|kelvin).{{0,1}}: must be .*, but .(K|kelvin). is not a known unit"):
        of(**others, **{name: by(3.0, "K")})
    with pytest.raises(ss.Error) as error:
        of(**others, **{name: by(3.0, "kg^2" if unit != "kg*mm" else "kg")})
    assert name in str(error.value) and "kg" in str(error.value) and "must be" in str(error.value)


def machine(units="N,m"):
    return ss.Machine(mass="50 t", stiffness="1000 kN/m", friction="5 kN", units=units)


@pytest.mark.parametrize("by", SCALARS)
def test_every_question_takes_quantities(by):
    drive, m = ss.Drive(force=by(12.0, "kN"), frequency=by(1.0, "Hz")), machine()
    close = lambda found, due: np.testing.assert_allclose(np.asarray(found, float), np.asarray(due, float), rtol=1e-12)  # noqa: E731
    close(m.min_force(frequency=by(60.0, "rpm")), m.min_force(frequency=1.0))
    close(m.min_force(frequency=by(np.array([1.0, 2.0]), "Hz")), m.min_force(frequency=[1.0, 2.0]))
    close(m.force_for_displacement(by(10.0, "mm"), frequency=1.0), m.force_for_displacement("10 mm", frequency=1.0))
    close(m.force_for_displacement(by(np.array([10.0, 12.0]), "mm"), frequency=1.0), m.force_for_displacement([0.01, 0.012], frequency=1.0))
    assert m.bands(frequency=(by(0.2, "Hz"), by(5.0, "Hz")), force=by(12.0, "kN")) == m.bands(frequency=(0.2, 5.0), force="12 kN")
    close(m.simulate(drive, phase=by(90.0, "deg"), displacement=by(1.0, "mm"), samples=4).displacement, m.simulate(drive, phase=math.pi / 2, displacement="1 mm", samples=4).displacement)
    close(m.decay(by(50.0, "mm")).path, m.decay("50 mm").path)
    close(m.best_stiffness(drive, stiffness=(by(500.0, "kN/m"), by(1500.0, "kN/m"))).stiffness, m.best_stiffness(drive, stiffness=("500 kN/m", "1500 kN/m")).stiffness)
    axes = {"displacement": by(np.array([-20.0, 20.0]), "mm"), "velocity": by(np.array([0.0, 100.0]), "mm/s")}
    close(m.basins(drive, **axes).displacement, [-0.02, 0.02])
    start = [(by(0.0, "rad"), by(1.0, "mm"), by(0.0, "m/s"))]
    assert len(m.attractors(drive, starts=start).attractors) == 1
    omega = m.response(drive).omega
    close(ss.response(by(100 * omega, "percent"), 2.4).max_displacement, ss.response(omega, 2.4).max_displacement)
    curve = m.response(ss.Drive(force="12 kN", frequency=np.linspace(0.8, 1.4, 12)))
    given = {"frequency": np.linspace(0.8, 1.4, 12), "units": "N,m"}
    due = ss.identify("50 t", "1000 kN/m", "12 kN", amplitude=curve.max_displacement, **given).friction.value
    close(ss.identify(by(50.0, "t"), by(1000.0, "kN/m"), by(12.0, "kN"), amplitude=by(1e3 * curve.max_displacement, "mm"), **given).friction.value, due)
    peaks = np.array([40, 33.1, 26.5, 20.2, 14.1])
    close(ss.identify_decay(by(peaks, "mm"), every="cycle").friction_displacement.value, ss.identify_decay(peaks / 1e3, every="cycle").friction_displacement.value)


def pulse(**given):
    return ss.Record(**{"samples": [0.0, -3.0, -3.0, 0.0], "time_step": 0.5, "unit": "m/s^2", **given})


@pytest.mark.parametrize("by", [by_pint, by_astropy])
def test_records_take_quantities(by):
    samples = np.array([0.0, -300.0, -300.0, 0.0])
    assert ss.Record(by(samples, "cm/s^2"), time_step=by(500.0, "ms")) == pulse()
    times = ss.Record(by(samples, "cm/s^2"), times=by(np.array([0.0, 500.0, 1000.0, 1500.0]), "ms"))
    assert times.times.tolist() == [0, 0.5, 1, 1.5] and times.unit == "m/s^2"
    with pytest.raises(ss.Error, match="unit = g: must be left out, because the samples are in m/s"):
        ss.Record(by(samples, "cm/s^2"), time_step=0.5, unit="g")
    with pytest.raises(ss.Error, match="is a unit of mass"):
        ss.Record(by(samples, "kg"), time_step=0.5)
    with pytest.raises(ss.Error, match="time_step 0.5 kg: must be a time"):
        pulse(time_step=by(0.5, "kg"))
    with pytest.raises(ss.Error, match="times .kg.: must be a time"):
        pulse(time_step=None, times=by(np.arange(4.0), "kg"))
    record, block = pulse(), ss.Block(mass="1 t", friction_coefficient=0.1)
    assert record.between(by(400.0, "ms"), by(1.0, "s")) == record.between(0.4, 1.0)
    start = block.follow(record, displacement=by(10.0, "mm"), velocity=by(5.0, "cm/s"))
    assert start.end_displacement == pytest.approx(block.follow(record, displacement="10 mm", velocity="5 cm/s").end_displacement, rel=1e-15)
    assert block.motion(record, interval=by(100.0, "ms")).time.tolist() == block.motion(record, interval=0.1).time.tolist()
    periods = {"friction_coefficient": by(5.0, "percent"), "mass": by(2.0, "t")}
    found = ss.spectrum(record, period=by(np.array([500.0, 1000.0]), "ms"), **periods)
    assert found.path.tolist() == ss.spectrum(record, period=[0.5, 1.0], friction_coefficient=0.05, mass="2 t").path.tolist()
    assert block.floor_spectrum(record, period=by(np.array([500.0]), "ms")).period.tolist() == [0.5]
    with pytest.raises(ss.Error, match="factor .kg.: must be a plain number"):
        record.scaled(by(2.0, "kg"))


def test_labels_of_records_have_units():
    index = pandas.Index([0.0, 500.0, 1000.0, 1500.0], name="t [ms]")
    found = ss.Record(pandas.Series([0.0, -300.0, -300.0, 0.0], index=index, name="acc (cm/s^2)"))
    assert (found.times.tolist(), found.unit, found.samples[1]) == ([0, 0.5, 1, 1.5], "cm/s^2", -300.0)
    time = xarray.DataArray([0.0, 500.0, 1000.0, 1500.0], dims="time", attrs={"units": "ms"})
    data = xarray.DataArray([0.0, -3.0, -3.0, 0.0], coords={"time": time}, attrs={"units": "m/s^2"})
    assert ss.Record(data).times.tolist() == [0, 0.5, 1, 1.5] and ss.Record(data).unit == "m/s^2"
    # The frame of a record is one, with its units in the attributes.
    frame = found.to_frame()
    frame.index = frame.index * 1e3
    frame.attrs["units"]["time"] = "ms"
    again = ss.Record(frame["base_acceleration"])
    assert again.unit == "cm/s^2" and again.times.tolist() == [0, 0.5, 1, 1.5]
    data.time.attrs["units"] = "kg"
    with pytest.raises(ss.Error, match="times .kg.: must be a time"):
        ss.Record(data)


SYSTEM = {
    "units": "N,mm",
    "masses": {"block": "1 t", "roof": {"mass": "500 kg", "start": "3 mm", "velocity": "1 mm/s"}},
    "springs": [{"between": ["ground", "block"], "stiffness": "200 N/mm", "damping": "0.3 N*s/mm"}, {"between": ["block", "roof"], "stiffness": "300 N/mm"}],
    "contacts": [{"name": "bearing", "between": ["ground", "block"], "friction": "450 N", "moves": "2 mm/s"}],
    "stops": [{"between": ["ground", "roof"], "gap": "9 mm", "stiffness": "1000 N/mm"}],
    "forces": [{"on": "roof", "amplitude": "1500 N", "frequency": "3 Hz", "phase": "30 deg"}, {"on": "roof", "constant": "20 N"}],
}


def quantities(value, by):
    if isinstance(value, dict):
        return {name: inner if name in ("units", "name", "on") else quantities(inner, by) for name, inner in value.items()}
    if isinstance(value, list):
        return [quantities(inner, by) for inner in value]
    if isinstance(value, str) and " " in value:
        number, unit = value.split()
        return by(float(number), unit)
    return value


@pytest.mark.parametrize("by", SCALARS)
def test_systems_take_quantities(by):
    due, found = ss.System(**SYSTEM), ss.System(**quantities(SYSTEM, by))
    assert found.natural_angular_frequencies().tolist() == pytest.approx(due.natural_angular_frequencies().tolist(), rel=1e-14)
    until = by(100.0, "ms")
    np.testing.assert_allclose(found.simulate(until).end_displacement, due.simulate("0.1 s").end_displacement, rtol=1e-9)
    np.testing.assert_allclose(due.states(by(np.array([0.0, 100.0]), "ms")).time, [0, 0.1])
    assert due.states([by(0.0, "ms"), by(100.0, "ms")]).time.tolist() == pytest.approx([0, 0.1])
    other = {"bearing.friction": by(0.5, "kN")}
    np.testing.assert_allclose(due.with_values(other).simulate(0.1).end_displacement, due.with_values({"bearing.friction": "500 N"}).simulate(0.1).end_displacement, rtol=1e-12)
    grid = due.curve(by(np.array([2.0, 3.0]), "Hz"), {"bearing.friction": by(np.array([0.4, 0.5]), "kN")})
    texts = due.curve(["2 Hz", "3 Hz"], {"bearing.friction": ["400 N", "500 N"]})
    assert list(grid)[1:] == list(texts)[1:]
    np.testing.assert_allclose(grid["roof.max_displacement[mm]"], texts["roof.max_displacement[mm]"], rtol=1e-9)
    for wrong in [{"masses": {"block": by(1.0, "m"), "roof": "500 kg"}}, {"masses": {"block": {"mass": by(1.0, "m")}, "roof": "500 kg"}}]:
        with pytest.raises(ss.Error, match="masses.block.* 1.0 m: must be a mass .*, but .m. is a unit of length"):
            ss.System(**{**SYSTEM, **wrong})
    with pytest.raises(ss.Error, match="frequency .*: must be a frequency"):
        due.curve(by(np.array([2.0, 3.0]), "kg"))
    with pytest.raises(ss.Error, match="until 3.0 kg: must be a time"):
        due.simulate(by(3.0, "kg"))
    with pytest.raises(ss.Error, match="mass.*2.0 kg: must be a finite number"):
        ss.System(mass=by(np.array([[2.0]]), "kg"), stiffness=[[8.0]])


def test_what_may_count_cycles_or_radians_is_refused():
    for value in [by_pint(2.0, "1/s"), by_astropy(2.0, "1/s"), by_pint(np.array([2.0]), "1/s")]:
        for keyword in ("frequency", "angular_frequency"):
            with pytest.raises(ss.Error, match=f"{keyword} .1 / (s|second).: may count cycles or radians"):
                ss.Drive(force=1.0, **{keyword: value})


def test_ratios_take_no_unit():
    for value in [by_pint(2.0, "N"), by_astropy(2.0, "N"), by_series([2.0], "N"), by_attributes([2.0], "N"), by_frame([2.0], "N")]:
        with pytest.raises(ss.Error, match="omega .*: must be a plain number"):
            ss.response(value, 2.5)
    for unit in ("-", "1", ""):
        assert ss.response(by_attributes([2.0], unit), 2.5).max_displacement.item() == ss.response(2.0, 2.5).max_displacement
        assert ss.response(by_series([2.0], unit), 2.5).max_displacement.item() == ss.response(2.0, 2.5).max_displacement
    # A place or a remark is no unit.
    for name in ("run[3]", "omega (old)", "(first)", "omega"):
        series = pandas.Series([2.0], name=name)
        assert ss.response(series, 2.5).max_displacement.item() == ss.response(2.0, 2.5).max_displacement
    # An answer in ratios is no force.
    with pytest.raises(ss.Error, match="force .B.: must be a force .*, but .B. is not a known unit"):
        ss.Drive(force=ss.response(by_attributes([2.0], "1"), 2.5).max_displacement, frequency=1.0)


def test_units_of_columns_must_agree():
    frame = pandas.DataFrame({"a [kN]": [1.0], "b [N]": [2.0]})
    with pytest.raises(ss.Error, match="force: must have one unit, not N, kN"):
        ss.Drive(force=frame, frequency=1.0)
    with pytest.raises(ss.Error, match="force: must have one unit for all elements, not none, kg"):
        ss.Drive(force=[by_pint(1.0, "N"), 2.0], frequency=1.0)
    table = astropy.table.Table({"force": [1.0, 2.0], "count": [1.0, 2.0]})
    table["force"].unit = "kN"
    assert ss.Drive(force=table["force"], frequency=1.0).amplitude.tolist() == [1000, 2000]
    assert ss.response(table["count"], 3.0).omega.tolist() == [1, 2]

    class Own(np.ndarray):
        units = "kN"

    with pytest.raises(ss.Error, match="force .kN.: is a .*Own, whose units are not read"):
        ss.Drive(force=np.array([1.0]).view(Own), frequency=1.0)


def test_labels_stay_beside_units():
    series = pandas.Series([9.0, 12.0], index=["a", "b"], name="force [kN]")
    found = machine().response(ss.Drive(force=series, frequency="1 Hz"))
    assert found.max_displacement.index.tolist() == ["a", "b"]
    drive = ss.Drive(force=series, frequency="1 Hz")
    assert (drive.amplitude.name, drive.amplitude.tolist()) == ("amplitude", [9000.0, 12000.0])
    assert ss.Drive(force="1 N", frequency=series.rename("f [Hz]")).angular_frequency.name == "angular_frequency"
    data = by_attributes([9.0, 12.0], "kN").assign_coords(n=[3, 4])
    assert machine().response(ss.Drive(force=data, frequency="1 Hz")).max_displacement.n.values.tolist() == [3, 4]
    wrapped = xarray.DataArray(by_pint(np.array([9.0, 12.0]), "kN"), dims="n")
    assert ss.Drive(force=wrapped, frequency=1.0).amplitude.values.tolist() == [9000, 12000]
    # The answers of a machine are arguments of another.
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        moved = machine("kN,mm").response(ss.Drive(force=data, frequency="1 Hz")).max_displacement
        assert ss.Drive(base_displacement=moved, frequency=1.0).amplitude.values == pytest.approx(moved.values / 1e3)
