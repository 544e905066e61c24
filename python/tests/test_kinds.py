"""Arrays of every kind as arguments, the mistakes that are easily made, and what results keep of their arguments."""

import array
import math
import warnings
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import stickslip as ss
from stickslip import _native, _rows

OMEGA = [0.5, 0.75, 1.5, 2.0]
ALPHA = 2.5


def module(name):
    return pytest.importorskip(name)


def masked():
    return np.ma.masked_array(OMEGA, [False] * 4)


#: How to make each kind of array-like of `OMEGA`, and the type of its results.
KINDS = {
    "list": (lambda: OMEGA, np.ndarray),
    "tuple": (lambda: tuple(OMEGA), np.ndarray),
    "range": (lambda: range(1, 5), np.ndarray),
    "float64": (lambda: np.array(OMEGA), np.ndarray),
    "float32": (lambda: np.array(OMEGA, np.float32), np.ndarray),
    "float16": (lambda: np.array(OMEGA, np.float16), np.ndarray),
    "longdouble": (lambda: np.array(OMEGA, np.longdouble), np.ndarray),
    "int64": (lambda: np.arange(1, 5), np.ndarray),
    "uint8": (lambda: np.arange(1, 5, dtype=np.uint8), np.ndarray),
    "big-endian": (lambda: np.array(OMEGA, ">f8"), np.ndarray),
    "masked": (masked, np.ma.MaskedArray),
    "strided": (lambda: np.repeat(OMEGA, 2)[::2], np.ndarray),
    "reversed": (lambda: np.array(OMEGA[::-1])[::-1], np.ndarray),
    "read-only": (lambda: np.broadcast_to(np.array(OMEGA), (4,)), np.ndarray),
    "Fortran": (lambda: np.asfortranarray(np.tile(OMEGA, (3, 1))), np.ndarray),
    "object": (lambda: np.array(OMEGA, object), np.ndarray),
    "Decimal": (lambda: [Decimal(str(x)) for x in OMEGA], np.ndarray),
    "Fraction": (lambda: [Fraction(x) for x in OMEGA], np.ndarray),
    "array.array": (lambda: array.array("d", OMEGA), np.ndarray),
    "memoryview": (lambda: memoryview(array.array("d", OMEGA)), np.ndarray),
    "pandas series": (lambda: module("pandas").Series(OMEGA, index=list("abcd")), "Series"),
    "pandas nullable": (lambda: module("pandas").Series(OMEGA, dtype="Float64"), "Series"),
    "pandas index": (lambda: module("pandas").Index(OMEGA), np.ndarray),
    "pandas column": (lambda: module("pandas").DataFrame({"omega": OMEGA})["omega"], "Series"),
    "pandas frame": (lambda: module("pandas").DataFrame({"omega": OMEGA}), "DataFrame"),
    "polars series": (lambda: module("polars").Series(OMEGA), np.ndarray),
    "polars column": (lambda: module("polars").DataFrame({"omega": OMEGA})["omega"], np.ndarray),
    "Arrow array": (lambda: module("pyarrow").array(OMEGA), np.ndarray),
    "Arrow chunks": (lambda: module("pyarrow").chunked_array([OMEGA[:1], OMEGA[1:]]), np.ndarray),
    "Arrow column": (lambda: module("pyarrow").table({"omega": OMEGA})["omega"], np.ndarray),
}
#: Kinds of a single number.
SCALARS = {
    "float": 1.5,
    "int": 2,
    "float64": np.float64(1.5),
    "float32": np.float32(1.5),
    "int64": np.int64(2),
    "uint8": np.uint8(2),
    "0-d": np.array(1.5),
    "Decimal": Decimal("1.5"),
    "Fraction": Fraction(3, 2),
}


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_array_gives_the_numbers_of_a_list(kind):
    make, expected = KINDS[kind]
    given = make()
    plain = np.array(given, dtype=float)
    for found, due in (
        (ss.response(given, ALPHA), ss.response(plain, ALPHA)),
        (ss.steady(given, ALPHA), ss.steady(plain, ALPHA)),
    ):
        if isinstance(expected, str):
            assert type(found.max_displacement).__name__ == expected
            assert found.max_displacement.index.equals(given.index) and found.regime.index.equals(given.index)
            assert found.transmissibility.index.equals(given.index)
        else:
            assert type(found.max_displacement) is expected
        for name in ("omega", "max_displacement", "transmissibility"):
            np.testing.assert_array_equal(np.asarray(found[name]), due[name])
        assert np.asarray(found.regime).tolist() == due.regime.tolist()


@pytest.mark.parametrize("kind", SCALARS)
def test_every_kind_of_number_gives_numbers(kind):
    found = ss.response(SCALARS[kind], ALPHA)
    assert type(found.max_displacement) is float and type(found.regime) is str
    assert found.max_displacement == ss.response(float(SCALARS[kind]), ALPHA).max_displacement


@pytest.mark.parametrize(
    "given",
    [np.array([True, False]), True, None, 1j, [1j], {0.5: 1}, (x for x in OMEGA), np.array(["1"]), np.array([1], "M8[D]")],
    ids=lambda given: type(given).__name__,
)
def test_what_is_no_number_is_a_type_error(given):
    with pytest.raises(TypeError, match="omega: must be numbers") as caught:
        ss.response(given, ALPHA)
    assert isinstance(caught.value, ss.Error)


def test_indices_are_kept_where_there_is_one():
    pandas = module("pandas")
    omega = pandas.Series(OMEGA, index=[3, 1, 4, 2], name="w")
    # The same index in another argument, or none.
    found = ss.steady(omega, pandas.Series(ALPHA, index=omega.index))
    frame = pandas.DataFrame(dict(ss.steady(omega, ALPHA, outputs=["regime", "transmissibility"])))
    assert frame.index.equals(omega.index) and found.transmissibility.equals(frame["transmissibility"])
    assert found.stick_fraction.name == "stick_fraction"
    with pytest.raises(ss.Error, match="omega and alpha: have different labels"):
        ss.steady(omega, pandas.Series(ALPHA, index=[1, 2, 3, 5]))
    # Labels in another order are put in order.
    alpha = pandas.Series([2.0, 3.0, 4.0, 5.0], index=[1, 2, 3, 4])
    due = ss.steady(OMEGA, [4.0, 2.0, 5.0, 3.0]).max_displacement
    assert ss.steady(omega, alpha).max_displacement.tolist() == due.tolist()
    # A series that is broadcast has no place in the shape of the result.
    assert type(ss.response(omega, [[2.0], [3.0]]).max_displacement) is np.ndarray
    machine = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0)
    answer = machine.steady(ss.Drive(force=9.0, frequency=omega))
    assert answer.max_displacement.index.equals(omega.index)
    assert answer.transmitted_force.index.equals(omega.index)
    record = ss.Record(np.sin(np.arange(200.0)), time_step=0.02)
    assert ss.spectrum(record, period=omega, friction_coefficient=0.02).path.index.equals(omega.index)
    gaps = ss.response(pandas.Series([0.7, None], dtype="Float64"), ALPHA)
    assert gaps.regime.tolist() == ["non-sticking", "invalid"] and math.isnan(gaps.max_displacement[1])


def test_text_in_a_column_of_pandas_is_no_number_and_a_gap_is_nan():
    pandas = module("pandas")
    with pytest.raises(TypeError, match="omega: must be numbers, not 0 0.7 1 1.5"):
        ss.response(pandas.Series(["0.7", "1.5"]), ALPHA)
    gaps = ss.response(pandas.Series([1.5, pandas.NA], dtype=object), ALPHA)
    assert gaps.regime.tolist() == ["non-sticking", "invalid"]
    masked = ss.response(np.ma.masked_array([Decimal("1.5"), None], [False, True]), ALPHA)
    assert masked.regime.tolist() == ["non-sticking", None]


def test_a_drive_outside_the_domain_is_one_invalid_point_of_many():
    for values in ([math.nan, 4.0], [-1.0, 4.0], [0.0, 4.0], [math.inf, 4.0], np.ma.masked_array([1.0, 4.0], [True, False])):
        # A force of 0 leaves the body at rest.
        forces = [] if np.ma.getdata(values)[0] == 0 else [ss.Drive(force=values, frequency=0.5)]
        for drive in (ss.Drive(force=9.0, frequency=values), *forces):
            found = machine().steady(drive)
            last = {"force": np.ravel(drive.amplitude)[-1], "angular_frequency": np.ravel(drive.angular_frequency)[-1]}
            alone = machine().steady(ss.Drive(**last))
            assert np.asarray(found.regime)[0] == "invalid" and found.regime[1] == alone.regime
            assert np.isnan(np.asarray(found.max_velocity)[0]) and np.isnan(np.asarray(found.transmitted_force)[0])
            assert found.max_velocity[1] == alone.max_velocity
            assert isinstance(found.max_velocity, np.ma.MaskedArray) == isinstance(values, np.ma.MaskedArray)
    with pytest.raises(ss.Error, match="must be > 0"):
        machine().steady(ss.Drive(force=9.0, frequency=-1.0))


def test_a_border_keeps_the_index_and_the_mask_of_its_frequencies():
    pandas = module("pandas")
    hertz = pandas.Series([1.0, 4.0], index=["a", "b"])
    found = machine().border(frequency=hertz)
    assert found.min_force_ratio.index.tolist() == ["a", "b"]
    assert found.min_force_ratio["b"] == machine().border(frequency=4.0).min_force_ratio
    assert machine().border(frequency=np.ma.masked_array([1.0, 4.0], [True, False])).min_force_ratio.mask.tolist() == [True, False]


def test_drives_and_records_compare_by_value():
    assert ss.Drive(force=9.0, frequency=OMEGA) == ss.Drive(force=9.0, frequency=OMEGA)
    assert ss.Drive(force=9.0, frequency=OMEGA) != ss.Drive(force=9.0, frequency=OMEGA[::-1])
    assert ss.Drive(force=9.0, frequency=1.0) != ss.Drive(base_acceleration=9.0, frequency=1.0) != None  # noqa: E711
    assert len({ss.Drive(force=9.0, frequency=1.0), ss.Drive(force=9.0, frequency=1.0)}) == 1
    assert ss.Record([0, 1.0], time_step=0.1) == ss.Record([0, 1.0], time_step=0.1) != ss.Record([0, 1.5], time_step=0.1)


def test_a_result_is_short_to_read():
    many = np.ma.masked_array(np.linspace(0.5, 2, 50), [True] * 50)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert "max_displacement=<(50,), nan>" in repr(ss.response(many, ALPHA))
    assert "max_displacement=<(50,)," in repr(ss.response(np.ma.masked_array(many.data, [False] + [True] * 49), [2.0] * 50))
    few = repr(ss.steady(np.ma.masked_array(OMEGA, [False, True, False, False]), ALPHA))
    assert "regime=['sticking', None, 'non-sticking', 'non-sticking']" in few and "  " not in few and len(few) < 2500
    assert "\n" not in repr(ss.response(OMEGA, ALPHA)) and "regime=<words, (9,)>" in repr(ss.steady(np.linspace(0.5, 1, 9), ALPHA))
    assert "friction=980.665" in repr(ss.Block("1 t", friction_coefficient=0.1)) and "_of" not in repr(ss.Block(1, 1))


def test_no_points_have_every_output():
    for found in (ss.response([], ALPHA), ss.steady([], ALPHA), machine().steady(ss.Drive(force=9.0, frequency=[]))):
        assert found.max_displacement.shape == (0,) and found.transmissibility.shape == (0,)
    record = ss.Record([0, 1.0], time_step=0.1)
    assert ss.spectrum(record, period=np.empty((0, 2)), friction_coefficient=0.1).path.shape == (0, 2)


@pytest.mark.parametrize("shape", [(600, 700), (1, 600, 700), (2, 300_000), (3, 1, 150_000)])
def test_a_map_in_blocks_has_the_numbers_of_its_points(shape):
    """Arrays that are broadcast become columns block by block."""
    *rows, columns = shape
    omega, alpha = np.linspace(0.3, 2, columns), np.linspace(1.1, 6, math.prod(rows)).reshape(*rows, 1)
    found = ss.response(omega, alpha, outputs=["regime", "margin"])
    full = ss.response(*(np.ascontiguousarray(array) for array in np.broadcast_arrays(omega, alpha)), outputs=["regime", "margin"])
    assert found.margin.shape == shape
    np.testing.assert_array_equal(found.margin, full.margin)
    np.testing.assert_array_equal(found._values["regime"].places, full._values["regime"].places)
    pairs = ss.steady(np.linspace(0.8, 2, 2), np.full((140_000, 1), 6.0), outputs=["multipliers"]).multipliers
    assert pairs.shape == (140_000, 2, 2) and (pairs == ss.steady([0.8, 2.0], 6.0).multipliers).all()


def test_masks_are_kept():
    omega = np.ma.masked_array(OMEGA, [False, True, False, False])
    alpha = np.ma.masked_array([[2.5], [3.0]], [[False], [True]])
    found = ss.steady(omega, alpha)
    assert found.transmissibility.mask.tolist() == [[False, True, False, False], [True] * 4]
    assert found.transmissibility.compressed().tolist() == ss.steady([0.5, 1.5, 2.0], 2.5).transmissibility.tolist()
    assert found.regime.mask.sum() == 5
    # The mask of one output is not that of another.
    found.transmissibility.mask[0, 0] = True
    assert not found.max_velocity.mask[0, 0] and not found.regime.mask[0, 0]


def test_a_result_is_not_changed_by_what_becomes_of_its_arguments():
    omega = np.array(OMEGA)
    found = ss.response(omega, ALPHA)
    omega[:] = 9.0
    assert found.omega.tolist() == OMEGA
    np.testing.assert_array_equal(found.transmissibility, ss.response(OMEGA, ALPHA).transmissibility)


def machine():
    return ss.Machine(mass=2.0, stiffness=800.0, friction=3.0)


MISTAKES = {
    "a frequency without its name": (lambda: machine().min_force(2.0), TypeError, "positional argument"),
    "both frequencies": (lambda: machine().min_force(frequency=2.0, angular_frequency=1.0), ss.Error, "give one of frequency"),
    "no frequency": (lambda: ss.identify(2.0, 800.0, 9.0, amplitude=[1.0]), ss.Error, "give one of frequency"),
    "a range as one number": (lambda: machine().bands(frequency=2.0, force=9.0), TypeError, "must be .low, high."),
    "an unknown output": (lambda: ss.response(0.7, 2).stroke, AttributeError, "has no value stroke. Its values are omega,"),
    "an unknown name": (lambda: ss.steady([0.7], 2, outputs="stroke"), ss.Error, "'stroke' must be one of regime"),
    "a unit in a ratio": (lambda: ss.response("2 Hz", 2), ss.Error, "omega: must be numbers, not '2 Hz'"),
    "a ratio of the wrong sign": (lambda: ss.response(-0.7, 2), ss.Error, "omega = -0.7 must be > 0"),
    "shapes that do not fit": (lambda: ss.steady([0.7, 1.0], [1.0, 2.0, 3.0]), ss.Error, "omega .2,., alpha .3,."),
    "a fraction of a sample": (lambda: ss.simulate(0.4, 6, samples=2.5), TypeError, "samples = 2.5: must be a whole number"),
    "half a bit": (lambda: ss.response("0.7", 2, bits=53.5), TypeError, "bits = 53.5: must be a whole number"),
    "writing to a result": (lambda: setattr(ss.response(0.7, 2), "omega", 1.0), AttributeError, "cannot be changed"),
    "ratios of ratios": (lambda: ss.response(0.7, 2).ratios, AttributeError, "Response has no value ratios"),
    "a number in place of a drive": (lambda: machine().response(2.0), TypeError, "drive: must be a Drive, not float"),
    "samples in place of a record": (lambda: machine().follow([0, 1.0]), TypeError, "record: must be a Record, not list"),
    "samples in place of a record of a spectrum": (
        lambda: ss.spectrum([0, 1.0], period=1.0, friction_coefficient=0.1),
        TypeError,
        "record: must be a Record, not list",
    ),
    "a float as a number of starts": (lambda: ss.attractors(0.5, 4, starts=1e3), TypeError, "starts = 1000.0: must be a whole number"),
    "an array in place of names of arrays": (lambda: ss.response([0.7], 2, out=np.empty(1)), TypeError, "out: must be a Mapping"),
    "an unknown excitation": (lambda: machine().min_force(frequency=2.0, excitation="acc"), ss.Error, "must be one of force, unbalance"),
    "rows of different lengths": (lambda: ss.response([[0.7], [0.7, 0.8]], 2), TypeError, "omega: must be numbers"),
    "a number beyond all floats": (lambda: ss.response(10**400, 2), TypeError, "omega: must be numbers"),
    "text in a column": (lambda: ss.response([0.7, "1.5"], 2), TypeError, "omega: must be numbers"),
    "a period of no length": (
        lambda: ss.spectrum(ss.Record([0, 1.0], time_step=0.1), period=0.0, friction_coefficient=0.1),
        ss.Error,
        "period 0.0: natural period T = 0 must be > 0",
    ),
    "more cycles than memory": (lambda: ss.simulate(0.4, 6, cycles=1e300, samples=9), ss.Error, "cycles 1e300, samples 9: more than"),
    "deleting a value": (lambda: delattr(ss.response(0.7, 2), "omega"), AttributeError, "cannot be changed"),
    "a machine without units": (
        lambda: ss.Machine("2 kg", "800 N/m", "3 N").response(ss.Drive(force=9, frequency=1)),
        ss.Error,
        "the drive: has no unit",
    ),
}


@pytest.mark.parametrize("mistake", MISTAKES)
def test_mistakes_are_told(mistake):
    call, kind, words = MISTAKES[mistake]
    with pytest.raises(kind, match=words):
        call()


def test_what_looks_like_a_mistake_and_is_none():
    # The natural frequency is that of a drive.
    assert machine().response(ss.Drive(force=9.0, frequency=machine().natural_frequency)).omega == pytest.approx(1.0, rel=1e-15)
    # A body that sticks has NaN in units, and the regime says why.
    stuck = machine().response(ss.Drive(force=3.1, frequency=0.5))
    assert stuck.regime == "sticking" and math.isnan(stuck.max_displacement)
    # Arrays lose nothing, with a machine or without.
    drive = ss.Drive(force=9.0, frequency=[2.0, 4.0])
    for found in (ss.response([0.7, 1.5], 2.5), machine().response(drive).ratios):
        assert [name for name in ss.OUTPUTS if np.shape(found[name]) != (2,)] == []
    for found in (ss.steady([0.7, 1.5], 2.5), machine().steady(drive).ratios):
        assert [name for name in ss.STEADY_OUTPUTS if np.shape(found[name])[:1] != (2,)] == []
    for found in (machine().response(drive), machine().steady(drive)):
        assert len(found) > 35 and [name for name in type(found)._names if np.shape(found[name])[:1] != (2,)] == []
    # A damping ratio above 1 is one of a strong damper, as for the command.
    assert ss.response(0.7, 2.0, damping_ratio=3).damping_ratio == 3.0
    # One name in place of a list of names; whole numbers of NumPy.
    assert list(ss.response(0.7, 2.0, outputs="margin"))[-1] == "margin"
    assert ss.simulate(0.4, 6, samples=np.int64(4)).phase.size == 5
    assert ss.steady(0.4, 6, max_periods=np.int32(100)).sticks_per_cycle == 2
    found = ss.response(0.7, 2.0)
    assert dict(found)["margin"] == found["margin"] == found.margin and len(found) == 4 + len(ss.OUTPUTS)
    assert {"regime", "transmissibility"} <= set(dir(ss.response([0.7], 2.0))) and {"limit"} <= set(dir(ss.steady([0.7], 2.0)))


def test_the_types_are_those_of_the_table():
    import outputs

    import stickslip._outputs as module

    with open(module.__file__, encoding="utf-8") as file:
        assert file.read() == outputs.text(), "run tests/outputs.py --write python/stickslip/_outputs.py"
    assert set(ss.Response._names) == {*ss.OUTPUTS, *_rows.RATIO_ROWS}
    assert set(ss.Steady._names) == {*ss.STEADY_OUTPUTS, *_rows.RATIO_ROWS}
    for excitation, _ in _native.EXCITATIONS:
        for name, (physical, _, _) in _native.physical_outputs(excitation).items():
            in_units = ss.MachineSteady if name in ss.STEADY_OUTPUTS else ss.MachineResponse
            assert physical in in_units._names, (name, physical)
