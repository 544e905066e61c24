"""Arguments of every kind beside each other: each number of an answer is that of a single call with the values of its labels."""

import math

import numpy as np
import pytest

import stickslip as ss

#: How many combinations of arguments are tried for each question.
TRIES = 500


class Random:
    """Arguments of random kinds over two axes with labels, and the numbers that belong to each pair of labels."""

    def __init__(self, seed):
        self.random = np.random.default_rng(seed)
        self.rows, self.columns = self.random.integers(0, 4, 2) + self.random.integers(0, 2)
        self.labels = ([f"r{i}" for i in range(self.rows)], [f"c{i}" for i in range(self.columns)])

    def values(self, low, high, whole):
        """Numbers for each pair of labels, that depend on both axes, one of them or none."""
        along = self.random.integers(0, 4)
        shape = (self.rows if along & 1 else 1, self.columns if along & 2 else 1)
        numbers = self.random.integers(math.ceil(low), math.floor(high) + 1, shape).astype(float) if whole else self.random.uniform(low, high, shape)
        gaps = self.random.random(shape) < 0.15 if self.random.random() < 0.3 and not whole else np.zeros(shape, dtype=bool)
        return np.where(gaps, np.nan, numbers), bool(along & 1), bool(along & 2)

    def plain(self, numbers):
        """An array of NumPy of these numbers: strided, of integers, masked, a list."""
        kind = self.random.integers(0, 6)
        if kind == 0:
            return np.repeat(numbers, 2, axis=-1)[..., ::2]
        if kind == 1:
            return np.asfortranarray(numbers[::-1])[::-1]
        if kind == 2 and np.isnan(numbers).any():
            return np.ma.masked_array(np.where(np.isnan(numbers), 1.0, numbers), np.isnan(numbers))
        if kind == 3 and numbers.size and (numbers == np.round(numbers)).all():
            return numbers.astype(self.random.choice([np.int64, np.uint8, np.float32]))
        if kind == 4 and numbers.size:
            return numbers.tolist()
        return numbers

    def order(self, n):
        return self.random.permutation(n) if self.random.random() < 0.5 else np.arange(n)

    def pandas(self, numbers, on_rows, on_columns):
        import pandas

        rows, columns = self.order(self.rows), self.order(self.columns)
        names = [np.array(labels, dtype=object)[order] for labels, order in zip(self.labels, (rows, columns))]
        if on_rows and on_columns:
            return pandas.DataFrame(numbers[rows][:, columns], index=names[0], columns=names[1])
        if on_rows:
            return pandas.Series(numbers[rows, 0], index=names[0])
        if on_columns:
            return pandas.Series(numbers[0, columns], index=names[1])
        return float(numbers[0, 0])

    def xarray(self, numbers, on_rows, on_columns):
        import xarray

        rows = self.order(self.rows) if on_rows else [0]
        columns = self.order(self.columns) if on_columns else [0]
        array = xarray.DataArray(
            numbers[rows][:, columns],
            dims=("row", "column"),
            coords={**({"row": np.array(self.labels[0], dtype=object)[rows]} if on_rows else {}), **({"column": np.array(self.labels[1], dtype=object)[columns]} if on_columns else {})},
        )
        array = array if on_rows else array.isel(row=0)
        array = array if on_columns else array.isel(column=0)
        return array.transpose() if self.random.random() < 0.5 else array


def ratios(random, bounds):
    return {name: random.values(*bound, random.random.random() < 0.2) for name, bound in bounds.items()}


def given(random, values, kind):
    """The arguments in a kind of array, and the shape and labels of the answer; None for a kind that is not possible."""
    if kind == "numpy":
        return {name: float(numbers[0, 0]) if not (rows or columns) else random.plain(numbers) for name, (numbers, rows, columns) in values.items()}
    return {name: getattr(random, kind)(*value) for name, value in values.items()}


def numbers_of(value, random, kind):
    """The numbers of an answer by their labels, in the order of the labels."""
    if kind == "pandas" and hasattr(value, "columns"):
        return value.loc[random.labels[0], random.labels[1]].to_numpy()
    if kind == "pandas" and hasattr(value, "index"):
        on_rows = len(value) == random.rows and (random.rows == 0 or set(value.index) == set(random.labels[0]))
        array = value.loc[random.labels[0] if on_rows else random.labels[1]].to_numpy()
        return array[:, None] if on_rows else array[None]
    if kind == "xarray" and hasattr(value, "dims"):
        value = value.sel({dim: random.labels[place] for place, dim in enumerate(("row", "column")) if dim in value.dims})
        array = value.transpose(*(dim for dim in ("row", "column") if dim in value.dims)).to_numpy()
        return array.reshape(random.rows if "row" in value.dims else 1, random.columns if "column" in value.dims else 1)
    return np.ma.filled(value, np.nan) if isinstance(value, np.ma.MaskedArray) else np.asarray(value)


def points_of(values):
    """The values of each point by name."""
    names, arrays = zip(*((name, numbers) for name, (numbers, _, _) in values.items()))
    return [dict(zip(names, map(float, point))) for point in zip(*(array.flat for array in np.broadcast_arrays(*arrays)))]


def same(one, other):
    return one == other or one != one and other != other


def compare(found, alone, values, random, kind, names):
    """Each number of the answer beside that of a single call; the number of comparisons."""
    compared = 0
    shape = np.broadcast_shapes(*(numbers.shape for numbers, _, _ in values.values()))
    if not any(rows or columns for _, rows, columns in values.values()):
        shape = ()
    for name in names if 0 not in shape else ():
        answer = np.broadcast_to(numbers_of(found[name], random, kind), shape)
        for place in np.ndindex(shape):
            at = {key: float(np.broadcast_to(numbers, shape or (1, 1))[place or (0, 0)]) for key, (numbers, _, _) in values.items()}
            assert same(float(answer[place]), alone(name, at)), (name, at, kind)
            compared += 1
    return compared


def tried(seed, bounds, call, alone, names, groups=()):
    compared = refused = 0
    for number in range(TRIES):
        random = Random(seed + number)
        kind = ("numpy", "pandas", "xarray")[number % 3]
        values = ratios(random, bounds)
        arguments = given(random, values, kind)
        try:
            found = call(**arguments)
        except ss.Error as error:
            numbers = [numbers for numbers, _, _ in values.values()]
            # Nothing is refused but what has no answer at any point, and series along different axes without a frame.
            sets = [{values[name][1:] for name in group} for group in (*groups, tuple(values))]
            only_series = kind == "pandas" and any((True, True) not in own and {(True, False), (False, True)} <= own for own in sets)
            empty = kind == "pandas" and 0 in (random.rows, random.columns)
            none = all(alone(names[0], at) != alone(names[0], at) for at in points_of(values)) or np.isnan(sum(numbers)).all()
            assert only_series or empty or none, (error, arguments)
            refused += 1
            continue
        compared += compare(found, alone, values, random, kind, names)
    return compared, refused


def one_call(call):
    """A single call that has NaN where it is refused."""
    cache = {}

    def alone(name, at):
        key = tuple(at.values())
        if key not in cache:
            try:
                cache[key] = call(**at)
            except ss.Error:
                cache[key] = None
        return math.nan if cache[key] is None else float(cache[key][name])

    return alone


RATIOS = {"omega": (0.3, 3.0), "alpha": (1.1, 9.0), "damping_ratio": (0.0, 0.3), "static_friction_ratio": (1.0, 1.5)}


@pytest.mark.parametrize("question", ["response", "steady"])
def test_ratios_of_every_kind_are_aligned_by_their_labels(question):
    pytest.importorskip("pandas"), pytest.importorskip("xarray")
    call = getattr(ss, question)
    names = ["max_displacement", "transmissibility"] if question == "response" else ["max_displacement", "stick_fraction"]
    compared, refused = tried(100 if question == "response" else 9100, RATIOS, call, one_call(call), names)
    assert compared > 2500 and 5 < refused < TRIES // 3, (compared, refused)


def test_machines_and_drives_of_every_kind_are_aligned_by_their_labels():
    pytest.importorskip("pandas"), pytest.importorskip("xarray")

    def call(mass, friction, damping_ratio, force, frequency):
        machine = ss.Machine(mass=mass, stiffness=900.0, friction=friction, damping_ratio=damping_ratio)
        return machine.response(ss.Drive(force=force, frequency=frequency))

    # A machine and a drive are aligned by themselves, and then with each other.
    groups = [("mass", "friction", "damping_ratio"), ("force", "frequency")]
    bounds = {"mass": (1.0, 5.0), "friction": (2.0, 9.0), "damping_ratio": (0.0, 0.2), "force": (10.0, 40.0), "frequency": (1.0, 6.0)}
    compared, refused = tried(700, bounds, call, one_call(call), ["max_displacement", "min_force", "omega"], groups)
    assert compared > 4000 and 5 < refused < TRIES // 3, (compared, refused)


def test_spectra_of_every_kind_are_aligned_by_their_labels():
    pytest.importorskip("pandas"), pytest.importorskip("xarray")
    record = ss.Record(np.sin(np.arange(60) * 0.4) * 3, time_step=0.05)

    def call(period, friction_coefficient, damping_ratio):
        return ss.spectrum(record, period=period, friction_coefficient=friction_coefficient, damping_ratio=damping_ratio)

    bounds = {"period": (0.2, 3.0), "friction_coefficient": (0.0, 0.2), "damping_ratio": (0.0, 0.5)}
    compared, refused = tried(3000, bounds, call, one_call(call), ["max_displacement", "path", "slides"])
    assert compared > 3000 and 5 < refused < TRIES // 3, (compared, refused)


def test_a_series_lies_along_the_axis_of_a_frame_whose_labels_it_has():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame([[0.5, 0.6]], columns=["a", "b"])
    found = ss.response(frame, pandas.Series([9.0, 3.0], index=["b", "a"])).max_displacement
    assert found["a"][0] == ss.response(0.5, 3.0).max_displacement or math.isnan(ss.response(0.5, 3.0).max_displacement)
    assert found["b"][0] == ss.response(0.6, 9.0).max_displacement
    square = pandas.DataFrame([[1.5, 1.6], [1.7, 1.8]])
    with pytest.raises(ss.Error, match="both the rows and the columns of omega"):
        ss.response(square, pandas.Series([3.0, 4.0]))
    with pytest.raises(ss.Error, match="neither the rows nor the columns"):
        ss.response(square, pandas.Series([3.0, 4.0], index=["x", "y"]))


def test_what_aligns_in_other_questions():
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    tested = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0, damping_ratio=0.05)
    hertz = pandas.Series(tested.natural_frequency * np.linspace(0.7, 1.4, 20), index=[f"p{i}" for i in range(20)])
    curve = tested.response(ss.Drive(force=9.0, frequency=hertz)).max_displacement
    found = ss.identify(2.0, 800.0, 9.0, frequency=hertz, amplitude=curve.sample(frac=1.0, random_state=3))
    assert found.friction.value == pytest.approx(3.0, rel=1e-6) and found.residuals.index.equals(hertz.index)
    with pytest.raises(ss.Error, match="have different labels"):
        ss.identify(2.0, 800.0, 9.0, frequency=hertz, amplitude=curve.rename({"p0": "q"}))
    # Points that were not measured are left out, in their place.
    gaps = curve.copy()
    gaps.iloc[[3, 11]] = np.nan
    found = ss.identify(2.0, 800.0, 9.0, frequency=hertz, amplitude=gaps)
    assert found.residuals.isna().tolist() == gaps.isna().tolist() and found.friction.value == pytest.approx(3.0, rel=1e-6)
    masked = np.ma.masked_invalid(gaps.to_numpy())
    assert ss.identify(2.0, 800.0, 9.0, frequency=hertz.to_numpy(), amplitude=masked).friction == found.friction
    # A record and its times.
    times = pandas.Series([0.0, 0.1, 0.3], index=list("abc"))
    record = ss.Record(pandas.Series([3.0, 1.0, 2.0], index=list("cab")), times=times)
    assert record.samples.tolist() == [1.0, 2.0, 3.0]
    assert record == ss.Record(pandas.Series([1.0, 2.0, 3.0], index=pandas.Index([0.0, 0.1, 0.3], name="t")))
    assert record == ss.Record(xarray.DataArray([1.0, 2.0, 3.0], dims="t", coords={"t": [0.0, 0.1, 0.3]}).rename(t="t"))
    with pytest.raises(ss.Error, match="have different labels"):
        ss.Record(pandas.Series([3.0, 1.0, 2.0], index=list("xyz")), times=times)
    # Samples of a decay.
    decay = tested.motion(ss.Record([0.0, 0.0], time_step=3.0), displacement=0.03, interval=0.004)
    frame = decay.to_frame().drop_duplicates("time").set_index("time", drop=False)
    whole = ss.identify_decay(frame["displacement"], frame["time"].sample(frac=1.0, random_state=2))
    plain = ss.identify_decay(frame["displacement"].to_numpy(), frame["time"].to_numpy())
    assert whole.turning_points.tolist() == plain.turning_points.tolist() and whole.residuals.index.equals(frame.index)
    # Starts along an axis of their own.
    displacement = xarray.DataArray([0.0, 0.02], dims="start")
    period = xarray.DataArray([0.5, 1.0, 2.0], dims="period", coords={"period": [0.5, 1.0, 2.0]})
    many = ss.Machine(mass=1.0, period=period, friction=0.4)
    record = ss.Record(np.sin(np.arange(100) * 0.3), time_step=0.05)
    followed = many.follow(record, displacement=displacement).max_displacement
    assert followed.dims in (("period", "start"), ("start", "period"))
    alone = ss.Machine(mass=1.0, period=1.0, friction=0.4).follow(record, displacement=0.02).max_displacement
    assert float(followed.sel(period=1.0).isel(start=1)) == alone


def test_labels_of_pandas_and_of_xarray_do_not_mix():
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    with pytest.raises(ss.Error, match="do not mix"):
        ss.response(pandas.Series([0.7]), xarray.DataArray([3.0], dims="x"))
    with pytest.raises(ss.Error, match="without dims gives another shape"):
        ss.response(xarray.DataArray([0.7, 0.8], dims="x"), [[3.0], [4.0]])
    with pytest.raises(ss.Error, match="has 2 values along x"):
        ss.response(xarray.DataArray([0.7], dims="x"), xarray.DataArray([3.0, 4.0], dims="x"))


def test_results_become_frames_and_data_sets_with_units():
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    machine = ss.Machine(mass="2 kg", stiffness="800 N/m", friction=pandas.Series([3.0, 4.0], index=["dry", "worn"]), units="N,mm")
    found = machine.steady(ss.Drive(force="9 N", frequency="3 Hz"), outputs=["regime", "max_displacement", "energy_out"])
    frame = pandas.DataFrame(found)
    assert frame.index.tolist() == ["dry", "worn"] and frame["max_displacement"].equals(found.max_displacement)
    assert found.to_frame()["energy_out"].equals(frame["energy_out"]) and found.to_frame().attrs["units"]["energy_out"] == "N·mm"
    assert pandas.DataFrame(ss.steady([0.4, 0.7], 6)).shape == (2, len(ss.STEADY_OUTPUTS) + 3)
    data = found.to_xarray()
    assert data["max_displacement"].attrs == {"units": "mm", "long_name": "Peak displacement Δ₀, as a length"}
    assert data["max_displacement"].sel(index="worn") == found.max_displacement["worn"]
    grid = ss.response(xarray.DataArray([0.7, 1.5], dims="w", coords={"w": [0.7, 1.5]}), xarray.DataArray([2.0, 3.0, 4.0], dims="a"))
    assert grid.max_displacement.dims == ("w", "a") and grid.max_displacement.attrs["units"] == "B"
    assert grid.to_xarray()["margin"].sel(w=1.5).shape == (3,) and len(grid.to_frame()) == 6
    assert grid.to_frame().index.names == ["w", "a"]
    plane = ss.response([[0.7], [1.5]], [2.0, 3.0], outputs=["margin"]).to_frame()
    assert plane["omega"].tolist() == [0.7, 0.7, 1.5, 1.5] and plane["margin"][3] == ss.response(1.5, 3.0).margin
    one = ss.steady(0.4, 6).to_frame()
    assert len(one) == 1 and one["multipliers_1"][0] == ss.steady(0.4, 6).multipliers[0]
    waveform = ss.steady(0.4, 6).waveform(8)
    assert waveform.to_frame().shape == (9, 4) and waveform.to_xarray()["velocity"].dims == ("phase",)


def test_a_frequency_in_hertz_has_a_column_of_its_own():
    pandas = pytest.importorskip("pandas")
    machine, hertz = ss.Machine(mass="2 kg", stiffness="800 N/m", friction="3 N"), [2.0, 3.0]
    for drive in (ss.Drive(force="9 N", frequency=hertz), ss.Drive(force="9 N", frequency=pandas.Series(hertz, index=["a", "b"]))):
        for found in (machine.steady(drive), machine.response(drive, outputs=["max_displacement"])):
            frame = found.to_frame()
            assert frame["frequency"].tolist() == pytest.approx(hertz, rel=1e-15) and frame.attrs["units"]["frequency"] == "Hz"
    angular = machine.steady(ss.Drive(force="9 N", angular_frequency=hertz)).to_frame()
    assert "frequency" not in angular and angular["angular_frequency"].tolist() == hertz


def test_coordinates_that_contradict_each_other_are_left_out():
    xarray = pytest.importorskip("xarray")

    def along(values, labels, **coords):
        own = {name: ("w", value) if isinstance(value, list) else value for name, value in coords.items()}
        return xarray.DataArray(values, dims="w", coords={"w": labels, **own})

    omega = along([0.7, 1.5], [1, 2], run=3, site="A", tag=["x", "y"], mark=["p", "q"])
    alpha = along([4.0, 3.0], [2, 1], run=3, site="B", tag=["y", "x"], mark=["p", "q"])
    found = ss.response(omega, alpha).max_displacement
    # The labels of the second argument are in another order: its tags agree, and its marks do not.
    assert set(found.coords) == {"w", "run", "tag"} and found.coords["tag"].values.tolist() == ["x", "y"]
    assert "site" not in found.coords["run"].coords
    assert set(ss.response(omega, 3.0).max_displacement.coords) == {"w", "run", "site", "tag", "mark"}
