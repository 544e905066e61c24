"""Systems of several bodies, against the command, SciPy and closed forms."""

import copy
import errno
import json
import os
import pickle
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import stickslip as ss

FILE = """
units = "N,mm"
[masses]
block = "1 t"
roof = { mass = "500 kg", start = "3 mm" }
[[springs]]
between = ["ground", "block"]
stiffness = "200 N/mm"
damping = "0.3 N*s/mm"
[[springs]]
between = ["block", "roof"]
stiffness = "300 N/mm"
[[contacts]]
name = "bearing"
between = ["ground", "block"]
friction = "450 N"
[[forces]]
on = "roof"
amplitude = "1.5 kN"
frequency = "3 Hz"
"""

COMMAND = os.environ.get("STICKSLIP_COMMAND") or shutil.which("stickslip")


@pytest.fixture
def machine(tmp_path):
    file = tmp_path / "machine.toml"
    file.write_text(FILE)
    return file


def by_names(**changed):
    fields = {
        "units": "N,mm",
        "masses": {"block": "1 t", "roof": {"mass": "500 kg", "start": "3 mm"}},
        "springs": [
            {"between": ["ground", "block"], "stiffness": "200 N/mm", "damping": "0.3 N*s/mm"},
            {"between": ["block", "roof"], "stiffness": 300},
        ],
        "contacts": [{"name": "bearing", "between": ["ground", "block"], "friction": 450}],
        "forces": [{"on": "roof", "amplitude": "1.5 kN", "frequency": "3 Hz"}],
    }
    return ss.System(**{**fields, **changed})


def by_matrices():
    return ss.System(
        mass=np.diag([1.0, 0.5]),
        damping=[[0.3, 0], [0, 0]],
        stiffness=np.array([[500, -300], [-300, 300]]),
        elements=[{"name": "bearing", "type": "contact", "direction": [1, 0], "friction": 450}],
        harmonics=[{"angular_frequency": 6 * np.pi, "sin": [0, 1500]}],
        start={"displacement": [0, 3], "velocity": [0, 0]},
    )


LOADED = {
    "moves": lambda wave: {"contacts": [{"name": "bearing", "between": ["ground", "block"], "friction": 450, "moves": {"amplitude": 5, **wave}}], "forces": []},
    "normal_load": lambda wave: {
        "contacts": [
            {"name": "bearing", "between": ["ground", "block"], "coefficient": 0.1, "normal_load": {"constant": 9000, "amplitude": 50, **wave}}
        ],
        "forces": [],
    },
    "forces": lambda wave: {"forces": [{"on": "roof", "amplitude": 1500, **wave}]},
    "base": lambda wave: {"forces": [], "base": {"acceleration": {"amplitude": 3000, **wave}}},
}


@pytest.mark.parametrize("load", LOADED)
def test_a_bare_frequency_is_in_hertz(load):
    def end(**wave):
        return by_names(**LOADED[load](wave)).simulate(0.7).end_displacement.tolist()

    due = end(frequency="3 Hz")
    assert end(frequency=3) == end(frequency=3.0) == end(frequency="3") == end(frequency=np.float64(3)) == due
    assert end(angular_frequency="3 Hz") == due
    np.testing.assert_allclose(end(angular_frequency=6 * np.pi), due, rtol=1e-9)
    with pytest.raises(ss.Error, match=r"give one of frequency .in Hz. and angular_frequency .in rad/s."):
        end(frequency=3, angular_frequency=18)
    with pytest.raises(ss.Error, match=r"frequency -3.0 Hz: must be > 0"):
        end(frequency=-3)


def test_a_bare_frequency_is_in_hertz_beside_values_with_units_and_without():
    bare = {"masses": {"m": 2.0}, "springs": [{"between": ["ground", "m"], "stiffness": 300.0}]}
    typed = {"masses": {"m": "2 kg"}, "springs": [{"between": ["ground", "m"], "stiffness": "300 N/m"}]}
    loads = [{"forces": [{"on": "m", "amplitude": 5.0, "frequency": 2}]}, {"forces": [{"on": "m", "amplitude": "5 N", "frequency": 2}]}]
    one, other = (ss.System(**body, **load) for body, load in zip((bare, typed), loads))
    assert one.simulate(3).end_displacement == other.simulate(3).end_displacement
    # Matrices have cycles per unit of time.
    matrices = {"mass": [[2.0]], "stiffness": [[300.0]]}
    cycles = ss.System(**matrices, harmonics=[{"frequency": 2, "sin": [5.0]}])
    assert cycles.simulate(3).end_displacement == one.simulate(3).end_displacement
    # A body may have the name of a field.
    named = ss.System(masses={"frequency": 2.0, "angular_frequency": {"mass": 1.0}})
    assert named.coordinates == ("frequency", "angular_frequency")


def test_frequencies_of_grids_are_in_hertz(machine, tmp_path):
    column, place = "frequency[Hz]", "forces[1].frequency[Hz]"
    for system in (by_names(), ss.System.read(machine)):
        due = system.curve("1Hz:3Hz:2")
        for axis in ([1, 3], [1.0, 3.0], "1:3:2", "1,3", np.array([1, 3]), ["1", "3 Hz"], ["1 Hz", "3"]):
            for found in (system.curve(axis), system.grid(frequency=axis)):
                assert found[column].tolist() == [1, 3] and found["roof.max_displacement[mm]"].tolist() == due["roof.max_displacement[mm]"].tolist()
        found = system.curve(angular_frequency=[6.0, 12.0])
        assert found["frequency[rad/s]"].tolist() == [6, 12]
        assert system.curve(angular_frequency="6:12:2") == system.curve(angular_frequency="6rad/s:12rad/s:2")
        assert system.curve(angular_frequency="1Hz:3Hz:2") == due
        for path in ("forces[1].frequency", "forces[1].angular_frequency"):
            found = system.grid({path: ["1 Hz", "3 Hz"]})
            assert found[place].tolist() == [1, 3] and found["roof.max_displacement[mm]"].tolist() == due["roof.max_displacement[mm]"].tolist()
        assert system.grid({"forces[1].frequency": [1, 3]})[place].tolist() == [1, 3]
        assert system.grid({"forces[1].angular_frequency": [6, 12]})["forces[1].frequency[rad/s]"].tolist() == [6, 12]
        other = system.with_values({"forces[1].frequency": 1}).steady().max_displacement.tolist()
        assert other == system.with_values({"forces[1].frequency": "1 Hz"}).steady().max_displacement.tolist()
        for both in (lambda: system.grid(frequency=[1], angular_frequency=[1]), lambda: system.curve()):
            with pytest.raises(ss.Error, match="give one of frequency"):
                both()
    # A bare frequency of a file is in radians per second, as for the command.
    file = tmp_path / "bare.toml"
    file.write_text('masses = { m = 2 }\n[[springs]]\nbetween = ["ground", "m"]\nstiffness = 300\n[[forces]]\non = "m"\namplitude = 5\nfrequency = 12\n')
    by_file = ss.System.read(file)
    named = ss.System(masses={"m": 2}, springs=[{"between": ["ground", "m"], "stiffness": 300}], forces=[{"on": "m", "amplitude": 5, "angular_frequency": 12}])
    assert by_file.simulate(3).end_displacement == named.simulate(3).end_displacement
    assert by_file.with_values({"forces[1].frequency": 2}).simulate(3).end_displacement == named.with_values({"forces[1].frequency": "2 Hz"}).simulate(3).end_displacement


def test_a_bare_natural_frequency_is_in_hertz():
    due = ss.Machine(mass=2.0, natural_frequency="1.5 Hz", friction=3.0, units="N,m")
    for natural in (1.5, "1.5", np.float64(1.5)):
        assert ss.Machine(mass=2.0, natural_frequency=natural, friction=3.0, units="N,m").stiffness == pytest.approx(due.stiffness, rel=1e-15)


def test_a_file_names_and_matrices_are_one_system(machine):
    file, names, matrices = ss.System.read(machine), by_names(), by_matrices()
    assert file.coordinates == names.coordinates == ("block", "roof") and matrices.coordinates == ("q1", "q2")
    for one, other in ((file.steady(), names.steady()), (file.simulate("2 s"), names.simulate(2))):
        assert one.max_displacement.tolist() == other.max_displacement.tolist()
        assert one.event_time.tolist() == other.event_time.tolist()
    np.testing.assert_allclose(matrices.steady().max_displacement, file.steady().max_displacement, rtol=1e-12)
    assert repr(names) == "System(block, roof; bearing)" and names.units == "N,mm" and matrices.units is None
    # ω² of [[500, −300], [−300, 300]] and diag(1, ½).
    due = np.sqrt((1100 + np.array([-1, 1]) * np.sqrt(1100**2 - 480000)) / 2)
    np.testing.assert_allclose(file.natural_angular_frequencies(), due, rtol=1e-12)
    np.testing.assert_allclose(file.natural_angular_frequencies("bearing"), [np.sqrt(600)], rtol=1e-12)


def test_damping_is_given_by_modes(tmp_path):
    mass, stiffness, ratios = np.diag([2.0, 3.0, 1.0]), np.array([[700.0, -300, 0], [-300, 500, -200], [0, -200, 200]]), [0.02, 0.05]
    linalg = pytest.importorskip("scipy.linalg")
    sparse, io = pytest.importorskip("scipy.sparse"), pytest.importorskip("scipy.io")
    squares, shapes = linalg.eigh(stiffness, mass)
    left = mass @ shapes
    own = np.diag([0.1, 0.0, 0.0])
    by_modes = left @ np.diag(2 * np.array([0.02, 0.05, 0.05]) * np.sqrt(squares)) @ left.T
    start = {"displacement": [1.0, -1.0, 2.0]}
    due = ss.System(mass=mass, stiffness=stiffness, damping=own + by_modes + 0.3 * mass + 0.002 * stiffness, start=start).simulate(3).end_displacement
    labels = ["a", "b", "c"]
    pd = pytest.importorskip("pandas")
    frame = pd.DataFrame(own, labels, labels).loc[["c", "a", "b"], ["c", "a", "b"]]
    for matrix in (own, sparse.csr_array(own), sparse.coo_matrix(own), frame):
        named = {"coordinates": labels} if matrix is frame else {}
        table = {"matrix": matrix, "ratio": ratios, "rayleigh": [0.3, "2 ms"]}
        of_mass = pd.DataFrame(mass, labels, labels) if matrix is frame else mass
        found = ss.System(mass=of_mass, stiffness=stiffness, damping=table, start=start, **named)
        np.testing.assert_allclose(found.simulate(3).end_displacement, due, rtol=1e-11)
    made = ss.System(mass=mass, stiffness=stiffness, damping=own, start=start).damping(ratio=ratios).damping(rayleigh=[0.3, 0.002])
    np.testing.assert_allclose(made.simulate(3).end_displacement, due, rtol=1e-11)
    io.mmwrite(tmp_path / "k.mtx", sparse.coo_array(stiffness))
    filed = ss.System(mass=mass, stiffness="k.mtx", damping={"matrix": own, "ratio": ratios, "rayleigh": [0.3, 0.002]}, start=start, folder=tmp_path)
    np.testing.assert_allclose(filed.simulate(3).end_displacement, due, rtol=1e-11)
    bodies = by_names(damping={"ratio": "2 %"})
    assert bodies.simulate(2) == by_names().damping(ratio=0.02).simulate(2) != by_names().simulate(2)
    for wrong, why in (({"ratio": -1}, "damping.ratio -1: must be (≥|>=) 0"), ({}, "damping: needs one of rayleigh and ratio"), ({"ratios": 1}, "Did you mean ratio")):
        with pytest.raises(ss.Error, match=why):
            by_names(damping=wrong)
    np.savez(tmp_path / "k.npz", K=stiffness)
    with pytest.raises(ss.Error, match="stiffness: k.npz: must be a file .mtx here"):
        ss.System(mass=mass, stiffness="k.npz", folder=tmp_path)


def test_two_modes_couple_over_a_belt():
    pad = {"type": "contact", "direction": [1, 0], "friction": 0.84, "belt": 5}
    pad["normal"] = {"const": 1, "displacement": [0, -3]}
    stiffness, damping = np.array([[7.0, -2], [-2, 5]]), 0.02 * np.eye(2)
    system = ss.System(mass=np.eye(2), damping=damping, stiffness=stiffness, elements=[pad])
    found = system.sliding()
    own = stiffness + np.array([[0, 3 * 0.84], [0, 0]])
    roots = np.linalg.eigvals(np.block([[np.zeros((2, 2)), np.eye(2)], [-own, -damping]]))
    np.testing.assert_allclose(found["growth"], roots.real.max(), rtol=1e-9)
    np.testing.assert_allclose(system.natural_angular_frequencies(), np.sqrt(np.linalg.eigvals(own + 0j)).real, rtol=1e-9)
    # The product of the entries beside the diagonal is −1 at 5/6 without dampers.
    np.testing.assert_allclose(found["threshold"]["coefficient"], 5 / 6 + 0.0004, rtol=1e-9)
    assert found["threshold"]["kind"] == "flutter" and by_names().sliding() is None


def test_the_motion_between_events_is_that_of_an_integration():
    scipy = pytest.importorskip("scipy.integrate")
    system = by_matrices()
    times = np.linspace(0, 3, 400)
    states = system.states(times)
    motion = system.simulate(3)
    mass, stiffness = np.diag([1.0, 0.5]), np.array([[500.0, -300], [-300, 300]])
    state = np.array([0.0, 3, 0, 0])
    at = 0.0
    ends = [*motion.event_time, 3.0]
    for end in ends:
        middle = system.states([at, (at + end) / 2]).velocity[1, 0] if end > at else 0.0
        sign = np.sign(middle)

        def slope(t, z, sign=sign):
            force = np.array([-450.0 * sign - 0.3 * z[2], 1500 * np.sin(6 * np.pi * t)]) - stiffness @ z[:2]
            acceleration = np.linalg.solve(mass, force)
            if sign == 0:
                acceleration[0] = 0
            return [*z[2:], *acceleration]

        if end > at:
            found = scipy.solve_ivp(slope, (at, end), state, method="DOP853", rtol=1e-12, atol=1e-12, dense_output=True)
            inside = (times >= at) & (times <= end)
            np.testing.assert_allclose(states.displacement[inside], found.sol(times[inside])[:2].T, atol=1e-7)
            state = found.y[:, -1]
        at = end
    np.testing.assert_allclose(motion.end_displacement, state[:2], atol=1e-7)
    works = sum(element.work for element in motion.elements.values())
    assert motion.load_work == pytest.approx(motion.damper_work + motion.stored_energy + works, rel=1e-11)


@pytest.mark.skipif(COMMAND is None, reason="needs the command")
def test_the_numbers_are_those_of_the_command(machine):
    def command(*arguments):
        run = subprocess.run([COMMAND, "system", str(machine), *arguments], capture_output=True, text=True, check=True)
        return run.stdout

    system = ss.System.read(machine)
    random = np.random.default_rng(5)
    for _ in range(20):
        friction, amplitude = random.uniform(50, 900), random.uniform(200, 3000)
        one = system.with_values({"bearing.friction": f"{friction}N", "forces[1].amplitude": amplitude})
        set_ = ("--set", f"bearing.friction={friction}N", "--set", f"forces[1].amplitude={amplitude}")
        due, found = json.loads(command("steady", "--format", "json", *set_)), one.steady()
        for name in ("max_displacement", "min_velocity"):
            assert due[name] == getattr(found, name).tolist()
        assert [event["time"] for event in due["events"]] == found.event_time.tolist()
        due, found = json.loads(command("simulate", "--until", "1.5s", "--format", "json", *set_)), one.simulate(1.5)
        assert due["end"]["velocity"] == found.end_velocity.tolist()
        assert due["elements"][0]["work"] == found.elements["bearing"].work
    rows = command("curve", "--frequency", "1Hz:5Hz:3", "--set", "bearing.friction=400N,-1N").splitlines()
    grid = system.curve("1Hz:5Hz:3", {"bearing.friction": ["400N", "-1N"]})
    assert rows[0].split(",") == list(grid)
    assert [row.split(",")[4] for row in rows[1:4]] == [str(x) for x in grid["block.max_displacement[mm]"][:3]]
    assert sorted(grid.errors) == [3, 4, 5] and "must be ≥ 0" in grid.errors[3]
    assert np.isnan(grid["block.max_displacement[mm]"][3:]).all()


def test_a_grid_over_records_has_each_motion():
    time = np.arange(300) * 0.01
    records = {
        name: ss.Record(factor * np.sin(11 * time), time_step=0.01, unit="g")
        for name, factor in (("weak", 0.1), ("strong", 0.4))
    }
    system = by_names(forces=[])
    grid = system.grid({"bearing.friction": [300, 600]}, records=records)
    assert grid["record"].tolist() == ["weak", "weak", "strong", "strong"]
    one = system.with_values({"bearing.friction": 600}).follow(records["strong"])
    assert grid["roof.max_displacement[mm]"][3] == one.max_displacement[1]
    assert grid["duration[s]"][0] == pytest.approx(2.99)
    longer = system.follow(records["weak"], until="4 s")
    assert longer.duration == 4
    frame = pytest.importorskip("pandas").DataFrame(grid)
    assert len(frame) == 4 and frame["bearing.friction[N]"].tolist() == [300, 600, 300, 600]


def test_just_above_the_border_nothing_sticks():
    system = by_names()
    border = system.border()
    for factor, stops in ((0.999, 2), (1.001, 0)):
        steady = system.with_values({"forces[1].amplitude": 1500 * border.least_load_factor * factor}).steady()
        assert steady.elements["bearing"].stops == stops
    assert border.cycle is not None
    assert border.cycle["max_displacement"] == pytest.approx(system.steady().max_displacement[0], rel=1e-11)


@pytest.mark.parametrize(
    ("wrong", "parts"),
    [
        (lambda: ss.System(masses={"m": "-1 kg"}), ["masses.m -1 kg", ">= 0"]),
        (lambda: ss.System(masses={"m": float("nan")}), ["masses.m", "finite"]),
        (lambda: ss.System(masses={}), ["masses", ">= 1"]),
        (lambda: ss.System().steady(), ["masses is missing"]),
        (lambda: ss.System(mass=[[1, 2], [3, 4]]), ["mass"]),
        (lambda: by_names(stops=[{"between": ["block", "rof"]}]), ["rof", "Did you mean roof?"]),
        (lambda: by_names(masses={"m": object()}), ["masses.m", "must be"]),
        (lambda: by_names().with_values({"bearin.friction": 5}), ["bearin"]),
        (lambda: by_names().simulate(-1), ["until", "> 0"]),
        (lambda: by_names().simulate(1e300), ["until", "<="]),
        (lambda: by_names().states([2.0, 1.0]), ["time"]),
        (lambda: by_names().grid({"bearing.friction": []}), ["bearing.friction", "at least one"]),
        (lambda: by_names().grid(question="what"), ["question what"]),
        (lambda: by_names().follow(ss.Record([1, 2], time_step=1, of="force", unit="N")), ["acceleration"]),
        (lambda: by_names().follow(ss.Record([1, 2], time_step=1, unit="g", after="hold")), ["must end after it"]),
        (lambda: ss.System.read("none.toml"), ["none.toml"]),
    ],
)
def test_each_mistake_is_one_line(wrong, parts):
    with pytest.raises((ss.Error, OSError)) as caught:
        wrong()
    text = str(caught.value)
    assert "\n" not in text and all(part in text for part in parts), text


def test_systems_are_copied_pickled_and_compared_by_value(machine):
    record = ss.Record(np.sin(np.arange(50) * 0.3), time_step=0.05, unit="g")
    whole = (by_names(), by_matrices(), ss.System.read(machine), by_names().with_values({"bearing.friction": "600 N"}), by_names().under(record))
    for system in whole:
        for twin in (pickle.loads(pickle.dumps(system)), copy.copy(system), copy.deepcopy({"of": system})["of"]):
            assert twin == system and hash(twin) == hash(system) and repr(twin) == repr(system)
            assert twin.simulate(2).max_displacement.tolist() == system.simulate(2).max_displacement.tolist()
    assert by_names() == by_names() and by_names().under(record) == by_names().under(record)
    for place, system in enumerate(whole):
        assert [system == other for other in whole] == [place == own for own in range(len(whole))]
    assert by_names() != by_names().under(record) != by_names().under(2 * record) and by_names() != "system"
    grid, wider = (by_names().grid(frequency=axis) for axis in ("1Hz:2Hz:2", "1Hz:3Hz:2"))
    assert pickle.loads(pickle.dumps(grid)) == grid == copy.deepcopy(grid) and not grid != copy.copy(grid) and grid != wider
    softer = by_names().with_values({"bearing.friction": "500 N"})
    assert softer != by_names().with_values({"bearing.friction": "600 N"})


def test_absolute_accelerations_are_those_of_the_velocity_and_the_base():
    still = by_names()
    assert still.steady().max_absolute_acceleration is None and still.states([0.1]).absolute_acceleration is None
    assert still.states([0.1]).units == {"time": "s", "displacement": "mm", "velocity": "mm/s", "force": "N"}
    shaken = by_names(forces=[], base={"acceleration": {"amplitude": "0.2 g", "frequency": "2 Hz"}})
    motion = shaken.simulate(3)
    assert motion.units["acceleration"] == "mm/s²"
    times = np.linspace(0, 3, 30001)
    states = shaken.states(times)
    assert states.units == {"time": "s", "displacement": "mm", "velocity": "mm/s", "acceleration": "mm/s²", "force": "N"}
    seen = states.absolute_acceleration
    most = motion.max_absolute_acceleration
    assert seen.shape == (30001, 2) and np.all(np.abs(seen) <= most * (1 + 1e-12))
    assert np.abs(seen).max(axis=0) == pytest.approx(most, rel=1e-3)
    base = 0.2 * 9806.65 * np.sin(2 * np.pi * 2 * times)
    due = (states.velocity[2:] - states.velocity[:-2]) / (times[2:] - times[:-2])[:, None] + base[1:-1, None]
    events = np.searchsorted(times, motion.event_time)
    smooth = np.ones(len(due), dtype=bool)
    for by in (-2, -1, 0):
        smooth[np.clip(events + by, 0, len(due) - 1)] = False
    assert smooth.sum() > 29_800 and len(motion.event_time) > 3
    # ω² of the fastest vibration is 977 s⁻², and (0.1 ms)²/6 of it 2·10⁻⁶ of the acceleration.
    assert np.all(np.abs(seen[1:-1] - due)[smooth] < 4e-6 * most)


def test_states_take_times_with_units():
    system = by_names()
    due = system.states([0.1, 0.25])
    for times in (["0.1 s", "250 ms"], ["100 ms", 0.25], ("0.1 s", "0.25")):
        assert system.states(times).displacement.tolist() == due.displacement.tolist()
    assert system.states("0.1 s").displacement.tolist() == system.states(0.1).displacement.tolist() == due.displacement[:1].tolist()
    for times in ("0.1 N", "soon", ["0.1 s", "soon"], None, [True]):
        with pytest.raises(ss.Error, match="times"):
            system.states(times)


def test_blows_have_their_velocities():
    """A ball that falls 0.4 m comes to rest after v/g + 2 e v/(g (1 - e))."""
    e, g = 0.5, 9.80665
    ball = ss.System(
        masses={"ball": {"mass": "1 kg", "start": "-0.4 m"}},
        stops=[{"name": "floor", "between": ["ground", "ball"], "gap": 0, "restitution": e}],
        forces=[{"on": "ball", "constant": "9.80665 N"}],
        units="N,m",
    )
    motion = ball.simulate("2 s")
    blows = motion.event_kind == "blow"
    assert motion.elements["floor"].blows == blows.sum()
    before, after = motion.event_velocity_before, motion.event_velocity_after
    np.testing.assert_allclose(after[blows], -e * before[blows], rtol=1e-14)
    assert np.isnan(before[~blows]).all()
    v = (2 * g * 0.4) ** 0.5
    assert abs(before[0] - v) < 1e-14
    assert motion.event_kind[-1] == "close"
    assert abs(motion.event_time[-1] - (v / g + 2 * e * v / (g * (1 - e)))) < 1e-13


@pytest.mark.parametrize(
    "place, fields",
    [
        ("mass", {"masses": None, "mass": "no.mtx", "stiffness": [[1.0]]}),
        ("base.acceleration", {"base": {"acceleration": "no.mtx"}}),
        ("springs[1].law", {"springs": [{"between": ["ground", "a"], "law": "no.mtx"}]}),
        ("forces[1].record", {"forces": [{"on": "a", "record": "no.mtx"}]}),
    ],
)
def test_files_that_a_system_names(place: str, fields: dict[str, Any], tmp_path: Path) -> None:
    """A missing one is an error of the system, too, with the place that names it; so is a folder in its place."""
    given = {"masses": {"a": "1 t"}, "units": "kN,m", "folder": tmp_path, **fields}
    file = str(tmp_path / "no.mtx")
    with pytest.raises(FileNotFoundError) as missing:
        ss.System(**given)
    text = f"{place}: {'no.mtx' if place == 'mass' else file}: "
    assert isinstance(missing.value, ss.Error) and str(missing.value) == text + os.strerror(errno.ENOENT)
    again = pickle.loads(pickle.dumps(missing.value))
    for error in (missing.value, again):
        assert (error.errno, error.strerror, error.filename) == (errno.ENOENT, os.strerror(errno.ENOENT), file)
        assert str(error) == str(missing.value)
    (tmp_path / "no.mtx").mkdir()
    with pytest.raises(OSError) as folder:
        ss.System(**given)
    assert isinstance(folder.value, ss.Error) and str(folder.value) == text + "must be a regular file"
    assert (folder.value.errno, folder.value.filename) == (errno.EISDIR, file)


def test_a_file_of_a_changed_system(tmp_path: Path) -> None:
    (tmp_path / "quake.csv").write_text("time [s],acceleration [m/s^2]\n0,0\n1,1\n2,0\n")
    (tmp_path / "frame.toml").write_text('units = "kN,m"\nmasses = {a = 1}\nbase = {acceleration = "quake.csv"}\n')
    system = ss.System.read(tmp_path / "frame.toml")
    with pytest.raises(FileNotFoundError) as missing:
        system.with_values({"base.acceleration": "no.csv"})
    assert isinstance(missing.value, ss.Error) and missing.value.filename == str(tmp_path / "no.csv")
    assert "base.acceleration=no.csv" in str(missing.value)
    kept = pickle.dumps(system)
    (tmp_path / "quake.csv").unlink()
    with pytest.raises(FileNotFoundError) as gone:
        pickle.loads(kept).steady()
    assert gone.value.filename == str(tmp_path / "quake.csv") and "frame.toml: base.acceleration" in str(gone.value)
