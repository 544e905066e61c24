"""The results of systems as tables of pandas and xarray, grids with named axes, and systems made step by step."""

import json
import pickle

import numpy as np
import pytest

import stickslip as ss

pd = pytest.importorskip("pandas")
xr = pytest.importorskip("xarray")


def frame():
    return (
        ss.System(units="N,mm")
        .mass("block", "1 t")
        .mass("roof", "500 kg", start="3 mm")
        .spring("ground", "block", "200 N/mm", damping="0.3 N*s/mm")
        .spring("block", "roof", "300 N/mm")
        .contact("ground", "block", "450 N", name="bearing")
        .force("roof", "1.5 kN", frequency="3 Hz")
    )


def by_dicts():
    return ss.System(
        units="N,mm",
        masses={"block": "1 t", "roof": {"mass": "500 kg", "start": "3 mm"}},
        springs=[
            {"between": ["ground", "block"], "stiffness": "200 N/mm", "damping": "0.3 N*s/mm"},
            {"between": ["block", "roof"], "stiffness": "300 N/mm"},
        ],
        contacts=[{"name": "bearing", "between": ["ground", "block"], "friction": "450 N"}],
        forces=[{"on": "roof", "amplitude": "1.5 kN", "frequency": "3 Hz"}],
    )


def test_states_are_a_table_over_the_time_with_units():
    states = frame().states(np.linspace(0, 1, 5))
    columns = ["block.displacement", "roof.displacement", "block.velocity", "roof.velocity", "bearing.force"]
    table = states.to_frame()
    assert list(table) == columns and table.index.name == "time" and table.index.tolist() == states.time.tolist()
    assert table.attrs["units"] == {"time": "s", **dict(zip(columns, ("mm", "mm", "mm/s", "mm/s", "N")))}
    assert table["roof.velocity"].tolist() == states.velocity[:, 1].tolist()
    plain = pd.DataFrame(states)
    assert list(plain) == list(states) == ["time", *columns] and plain["bearing.force"].tolist() == states.force[:, 0].tolist()
    data = states.to_xarray()
    assert data["displacement"].dims == ("time", "body") and data["force"].dims == ("time", "element")
    assert data["velocity"].sel(body="roof", time=0.5).item() == states.velocity[2, 1] and data["force"].attrs["units"] == "N"
    assert data["time"].attrs["units"] == "s" and "absolute_acceleration" not in data
    assert json.loads(json.dumps(states.to_dict()))["displacement"] == states.displacement.tolist()
    assert pickle.loads(pickle.dumps(states)) == states != frame().states([0.0, 1.0])
    with pytest.raises(KeyError):
        states["roof.force"]
    shaken = ss.System(masses={"m": "1 kg"}, springs=[{"between": ["ground", "m"], "stiffness": "9 N/m"}], base={"acceleration": {"amplitude": 1, "frequency": "1 Hz"}}, units="N,m")
    assert shaken.states([0, 0.1]).to_frame().attrs["units"]["m.absolute_acceleration"] == "m/s²"


def test_a_table_of_machines_has_what_differs_among_them():
    friction = np.array([10.0, 15.0, 18.0])
    machines = ss.Machine(mass="12 kg", stiffness="30 kN/m", friction=friction[:, None], units="N,mm")
    found = machines.steady(ss.Drive(force="40 N", frequency=[4.0, 6.0]), outputs=["max_displacement"])
    table = found.to_frame()
    assert list(table)[:3] == ["frequency", "friction", "angular_frequency"] and "mass" not in table
    assert table.friction.tolist() == np.repeat(friction, 2).tolist() and table.frequency.tolist() == [4.0, 6.0] * 3
    assert table.attrs["units"]["friction"] == "N" and table.attrs["units"]["frequency"] == "Hz"
    assert table.pivot(index="frequency", columns="friction", values="max_displacement").to_numpy().T.tolist() == found.max_displacement.tolist()
    data = found.to_xarray()
    assert data["friction"].values.tolist() == [[own] * 2 for own in friction] and data["friction"].attrs == {"units": "N"}
    labelled = machines.replace(friction=xr.DataArray(friction, dims="friction", coords={"friction": friction})).steady(ss.Drive(force="40 N", frequency=4.0)).to_xarray()
    assert labelled["friction"].dims == ("friction",) and labelled["max_displacement"].sel(friction=15.0).item() == found.max_displacement[1, 0]
    shaken = ss.Machine(mass=1.0, stiffness=[100.0, 200.0], friction=1.0, damping=[1.0, 2.0], units="N,m").steady(ss.Drive(base_acceleration=[1.0, 2.0], frequency=1.0, units="N,m"))
    columns = shaken.to_frame()
    assert columns[["stiffness", "damping", "base_acceleration"]].to_numpy().tolist() == [[100, 1, 1], [200, 2, 2]]
    assert columns.attrs["units"]["base_acceleration"] == "m/s²" and "frequency" in columns and "friction" not in columns
    one = ss.Machine(mass=1.0, stiffness=100.0, friction=1.0).steady(ss.Drive(force=2.0, frequency=5.0)).to_frame()
    assert one.frequency.tolist() == [5.0] and "mass" not in one
    none = ss.Machine(mass=[], stiffness=1.0, friction=1.0).steady(ss.Drive(force=2.0, frequency=5.0)).to_frame()
    assert len(none) == 0 and "mass" not in none


def test_motions_are_tables_of_bodies_elements_and_events():
    motion = frame().simulate("2 s")
    table = motion.to_frame()
    assert table.index.tolist() == ["block", "roof"] and table.index.name == "body"
    assert table.loc["roof", "max_displacement"] == motion.max_displacement[1] and set(table.attrs["units"].values()) == {"mm", "mm/s"}
    assert list(table) == list(table.attrs["units"])
    events = motion.events.to_frame()
    assert events.index.tolist() == motion.event_time.tolist() and events["kind"].tolist() == motion.event_kind.tolist()
    assert events.attrs["units"] == {"time": "s", "velocity_before": "mm/s", "velocity_after": "mm/s"} and list(pd.DataFrame(motion.events)) == ["time", "element", "kind", "velocity_before", "velocity_after"]
    elements = motion.elements.to_frame()
    assert elements.loc["bearing", "work"] == motion.elements["bearing"].work and elements.attrs["units"] == {"time_at_rest": "s", "work": "N·mm"}
    steady = frame().steady()
    data = steady.to_xarray()
    assert data["max_displacement"].sel(body="block").item() == steady.max_displacement[0] and data["max_displacement"].attrs["units"] == "mm"
    assert data["element_stops"].sel(element="bearing").item() == steady.elements["bearing"].stops
    assert data["event_time"].dims == ("event",) and data["load_work"].item() == steady.load_work and data["load_work"].attrs["units"] == "N·mm"
    sampled = steady.states(100)
    assert sampled.time[-1] == steady.duration and np.abs(sampled.displacement).max(axis=0) == pytest.approx(steady.max_displacement, rel=1e-2)
    # A steady motion begins at the phase 0, where the values of the start are.
    assert sampled.displacement[0].tolist() == steady.start_displacement.tolist()
    assert pickle.loads(pickle.dumps(steady)).states(3).displacement.tolist() == steady.states(3).displacement.tolist()


def test_motions_states_and_grids_are_drawn_by_name():
    pytest.importorskip("matplotlib").use("Agg")
    system = frame()
    motion = system.steady()
    axes = motion.plot()
    assert [line.get_label() for line in axes.lines] == ["block", "roof"] and axes.get_ylabel() == "displacement (mm)"
    assert axes.get_xlabel() == "time (s)"
    loop = motion.plot("bearing.force", over="block.displacement", samples=50)
    states = motion.states(50)
    assert loop.lines[0].get_ydata().tolist() == states.force[:, 0].tolist()
    assert loop.lines[0].get_xdata().tolist() == states.displacement[:, 0].tolist() and loop.get_xlabel() == "block.displacement (mm)"
    with pytest.raises(ss.Error, match="Did you mean 'displacement'"):
        motion.plot("displacements")
    grid = system.curve([2, 3, 4], {"bearing.friction": ["300 N", "0.6 kN"]})
    axes = grid.plot("roof.max_displacement")
    assert [line.get_label() for line in axes.lines] == ["roof.max displacement (bearing.friction = 300)", "roof.max displacement (bearing.friction = 600)"]
    assert axes.lines[1].get_ydata().tolist() == grid["roof.max_displacement[mm]"][3:].tolist() and axes.get_xlabel() == "frequency (Hz)"


@pytest.mark.parametrize(
    "typed",
    [["300 N", "600 N"], ["300 N", "0.6 kN"], [300, 600], ["300 N", 600], [300, "600 N"], np.array([300.0, 600.0]), "300N:600N:2", "300:600:2", "300,600"],
)
def test_a_column_has_its_quantity_and_its_unit_however_it_was_typed(typed):
    system = frame()
    due = system.grid({"bearing.friction": ["300 N", "600 N"]})
    found = system.grid({"bearing.friction": typed})
    assert list(found) == list(due) and found["bearing.friction[N]"].tolist() == [300.0, 600.0]
    assert found["bearing.friction"] is found["bearing.friction[N]"] and found.units["bearing.friction"] == "N"
    assert found["roof.max_displacement"].tolist() == due["roof.max_displacement[mm]"].tolist()


def test_each_kind_of_value_has_its_unit():
    system = frame()
    units = {"block.mass": "t", "springs[1].stiffness": "N/mm", "springs[1].damping": "N·s/mm", "roof.start": "mm", "forces[1].amplitude": "N", "bearing.peak": ""}
    for path, unit in units.items():
        grid = system.grid({path: [1.0, 2.0]})
        assert next(iter(grid)) == (f"{path}[{unit}]" if unit else path)
        if unit:
            same = system.grid({path: [f"1 {unit}", f"2 {unit}"]})
            assert list(same) == list(grid) and same["roof.max_velocity"].tolist() == grid["roof.max_velocity"].tolist()


def test_a_grid_has_named_axes():
    system = frame()
    grid = system.grid({"bearing.friction": ["300 N", "600 N"]}, frequency="1Hz:2Hz:3")
    assert grid.shape == (2, 3) and [axis.name for axis in grid.axes] == ["bearing.friction", "frequency"]
    table, data = grid.to_frame(), grid.to_xarray()
    assert table.index.names == ["bearing.friction", "frequency"] and table.attrs["units"]["roof.max_displacement"] == "mm"
    assert data["max_displacement"].dims == ("bearing.friction", "frequency", "body")
    one = system.with_values({"bearing.friction": "600 N", "forces[1].frequency": "1.5 Hz"}).steady()
    at = {"bearing.friction": 600.0, "frequency": 1.5}
    assert data["max_displacement"].sel({**at, "body": "roof"}).item() == one.max_displacement[1] == table.loc[(600.0, 1.5), "roof.max_displacement"]
    assert data["work"].sel({**at, "element": "bearing"}).item() == one.elements["bearing"].work and data["work"].attrs["units"] == "N·mm"
    assert data["frequency"].attrs["units"] == "Hz"
    assert pickle.loads(pickle.dumps(grid)).to_xarray().equals(data)


def test_values_with_the_same_labels_lie_along_one_axis():
    system = frame()
    friction, amplitude = [300.0, 600.0, 900.0], [1000.0, 1500.0, 2000.0]
    due = [system.with_values({"bearing.friction": f, "forces[1].amplitude": a}).steady().max_displacement[1] for f, a in zip(friction, amplitude)]
    pads = pd.Index(["soft", "middle", "hard"], name="pad")
    paths = ("bearing.friction", "forces[1].amplitude")
    series = {paths[0]: pd.Series(friction, pads), paths[1]: pd.Series(amplitude, pads)}
    arrays = {path: xr.DataArray(own.to_numpy(), dims="pad", coords={"pad": list(pads)}) for path, own in series.items()}
    for values in (series, arrays, pd.DataFrame(series), {paths: np.transpose([friction, amplitude])}):
        grid = system.grid(values)
        assert grid.shape == (3,) and grid["roof.max_displacement"].tolist() == due
        if not isinstance(next(iter(values)), tuple):
            assert grid.to_frame().loc["hard", "roof.max_displacement"] == due[2] and grid.to_frame()["bearing.friction"].tolist() == friction
            assert grid.to_xarray()["max_displacement"].sel(pad="middle", body="roof").item() == due[1]
    crossed = system.grid({paths[0]: pd.Series(friction, pads), paths[1]: amplitude})
    assert crossed.shape == (3, 3) and crossed.to_xarray()["max_displacement"].dims == ("pad", paths[1], "body")
    with pytest.raises(ss.Error, match="must have as many as"):
        system._handle.grid([(paths[0], ["1", "2"], False), (paths[1], ["1", "2", "3"], True)], [], "steady", None)
    with pytest.raises(ss.Error, match="must have a column for each of the 2 paths"):
        system.grid({paths: [1.0, 2.0]})
    with pytest.raises(ss.Error, match="values: must be a dict"):
        system.grid([1, 2])


def test_records_are_an_axis():
    record = ss.Record(np.sin(0.3 * np.arange(100)), time_step=0.05, unit="g")
    system = by_dicts()
    named = system.grid({"bearing.friction": [300, 600]}, records={"weak": record / 3, "strong": record})
    data = named.to_xarray()
    assert data["max_displacement"].dims == ("record", "bearing.friction", "body")
    one = system.with_values({"bearing.friction": 600}).follow(record).max_displacement[0]
    assert data["max_displacement"].sel({"record": "strong", "bearing.friction": 600, "body": "block"}).item() == one
    listed = system.grid({"bearing.friction": [300, 600]}, records=[record / 3, record])
    assert listed["record"].tolist() == ["1", "1", "2", "2"] and listed["block.max_displacement"].tolist() == named["block.max_displacement"].tolist()
    assert system.grid(records=pd.Series({"a": record})).to_frame().index.tolist() == ["a"]
    with pytest.raises(ss.Error, match=r"records\['1'\]: must be a Record"):
        system.grid(records=[3])


def test_a_system_is_made_step_by_step_by_the_rules_of_its_file(tmp_path):
    made, due = frame(), by_dicts()
    assert made.coordinates == due.coordinates and made.elements == due.elements
    assert made.simulate(2).end_displacement.tolist() == due.simulate(2).end_displacement.tolist()
    made.write(tmp_path / "made.json")
    read = ss.System.read(tmp_path / "made.json")
    assert read.simulate(2) == made.simulate(2) and json.loads(made.to_json())["contacts"][0]["friction"] == "450 N"
    # A file, and a system with changes, are gone on with in the same way.
    toml = tmp_path / "one.toml"
    toml.write_text('units = "N,mm"\n[masses]\nblock = "1 t"\n[[springs]]\nbetween = ["ground", "block"]\nstiffness = 200\n')
    more = ss.System.read(toml).with_values({"block.mass": "2 t"}).stop("ground", "block", gap="5 mm", stiffness="1 kN/mm", name="buffer")
    assert more.elements == ("buffer",) and json.loads(more.to_json())["masses"] == {"block": "2 t"}
    assert pickle.loads(pickle.dumps(more)) == more
    bare = ss.System(units="N,mm").mass("m", 1).spring("ground", "m", 4).force("m", 3, frequency=2)
    assert json.loads(bare.to_json())["forces"][0]["frequency"] == "2.0 Hz"
    angular = ss.System(units="N,mm").mass("m", 1).spring("ground", "m", 4).force("m", 3, angular_frequency=4 * np.pi)
    assert angular.simulate(1).end_displacement == pytest.approx(bare.simulate(1).end_displacement, rel=1e-12)
    level = bare.level("m", displacement=0.1)
    assert "m" in level.simulate(2).events.element.tolist()[0] or len(level.simulate(2).events.time) > 0
    assert "not complete" in repr(ss.System()) and "not complete" in repr(ss.System().spring("ground", "m", 1))
    shaken = ss.System(units="N,m").mass("m", 1).spring("ground", "m", 4).base(acceleration={"amplitude": "0.1 g", "frequency": 2})
    assert shaken.simulate(1).max_absolute_acceleration is not None
    for wrong, words in (
        (lambda: ss.System().simulate(1), "masses is missing"),
        (lambda: frame().spring("block", "rof", 3).coordinates, "Did you mean roof"),
        (lambda: frame().contact("ground", "roof").coordinates, "needs one of friction"),
        (lambda: frame().spring("ground", "roof", 3, stifness=4).coordinates, "stifness is unknown"),
        (lambda: frame().force("roof", 3, frequency=1, angular_frequency=1), "give one of frequency"),
        (lambda: frame().under(ss.Record([0, 1], time_step=1, unit="g")).to_json(), "a record in memory"),
    ):
        with pytest.raises(ss.Error, match=words):
            wrong()
    with pytest.raises(OSError):
        made.write(tmp_path / "none" / "made.json")


def test_matrices_of_pandas_xarray_and_scipy_are_taken_in_one_order():
    mass, stiffness = np.diag([1.0, 2.0]), np.array([[5.0, -1.0], [-1.0, 3.0]])
    due = ss.System(mass=mass, stiffness=stiffness).natural_angular_frequencies()
    names = ["roof", "block"]
    of_mass = pd.DataFrame(mass, names, names)
    turned = pd.DataFrame(stiffness, names, names).loc[names[::-1], names[::-1]]
    array = xr.DataArray(turned.to_numpy(), dims=("row", "column"), coords={"row": names[::-1], "column": names[::-1]})
    for own in (turned, array, stiffness, pd.DataFrame(stiffness)):
        assert ss.System(mass=of_mass, stiffness=own).natural_angular_frequencies() == pytest.approx(due, rel=1e-14)
        # The labels of the first name the coordinates.
        system = ss.System(mass=of_mass, stiffness=own, constant=pd.Series({"block": 0.0, "roof": 5.0}), start={"velocity": [1, 0]})
        frame = system.states([0.0, 1.0]).to_frame()
        assert list(frame) == ["roof.displacement", "block.displacement", "roof.velocity", "block.velocity"]
        assert frame["roof.velocity"].iloc[0] == 1 and frame["roof.displacement"].iloc[1] > frame["block.displacement"].iloc[1] > 0
        labelled = own is turned or own is array
        assert ss.System(mass=of_mass.to_numpy(), stiffness=own).coordinates == (("block", "roof") if labelled else ("q1", "q2"))
    scipy = pytest.importorskip("scipy.sparse")
    assert ss.System(mass=scipy.diags([1.0, 2.0]), stiffness=scipy.csr_array(stiffness)).natural_angular_frequencies() == pytest.approx(due, rel=1e-14)
    with pytest.raises(ss.Error, match="constant: its values must have the labels of mass"):
        ss.System(mass=of_mass, constant=pd.Series({"top": 5.0, "block": 0.0}))
    given = ss.System(mass=np.eye(2), stiffness=stiffness, coordinates=["a b", "c"])
    assert given.coordinates == ("a b", "c") and ss.System(**json.loads(given.to_json())).coordinates == ("a b", "c")
    for wrong, why in ((["a"], "coordinates: has 1 names, must have 2"), (["a", "a"], "used twice"), (["a", "ground"], "the ground does not move"), ([1, 2], "must be a text")):
        with pytest.raises(ss.Error, match=why):
            ss.System(mass=np.eye(2), coordinates=wrong)
    with pytest.raises(ss.Error, match="stiffness: its rows and columns must have the labels of mass"):
        ss.System(mass=of_mass, stiffness=turned.rename(index={"roof": "top"}))
