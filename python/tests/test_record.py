"""The motion under records: closed forms, agreement of the ways to ask, refusals."""

import errno
import math
import os
import pickle
import re

import numpy as np
import pytest

import stickslip as ss

G = 9.80665


def quake(n=1200):
    t = 0.01 * np.arange(n)
    return 0.3 * np.exp(-(((t - 4) / 2) ** 2)) * np.sin(9 * t) * np.cos(2 * t)


def test_newmarks_block():
    a, r, t = 0.4 * G, 0.1 * G, 2.0
    record = ss.Record(np.full(5, -0.4), time_step=t / 4, unit="g")
    found = ss.Block(mass="3 t", friction_coefficient=0.1, units="kN,mm").follow(record)
    exact = a * (a - r) * t * t / (2 * r)
    assert found.residual_displacement == pytest.approx(1000 * exact, rel=1e-13)
    assert (found.slides, found.stops) == (1, 1)
    assert found.units["residual_displacement"] == "mm" and found.units["friction_work"] == "kN·mm"
    # On a slope, downhill only.
    angle = np.radians(3)
    r, along = 0.1 * G * np.cos(angle), G * np.sin(angle)
    block = ss.Block(mass=1.0, friction_coefficient=0.1, slope="3 deg", one_way=True, units="N,m")
    found = block.follow(record)
    up, down = a + along - r, r - along
    assert found.residual_displacement == pytest.approx(up * t * t / 2 * (1 + up / down), rel=1e-13)


def test_a_spectrum_has_the_bits_of_each_machine():
    record = ss.Record(quake(), time_step="10 ms", unit="g")
    # A mass whose root is no number of few digits, and one whose product with the stiffness leaves the range of numbers.
    periods, mu, zeta = np.linspace(0.3, 3, 9), np.array([0.02, 0.1]), "5.7%"
    for mass, units in (("2 t", "kN,mm"), ("1e200 kg", "N,m")):
        given = {"damping_ratio": zeta, "mass": mass, "units": units}
        found = ss.spectrum(record, period=periods[:, None], friction_coefficient=mu, **given)
        assert found.max_displacement.shape == found.slides.shape == (9, 2)
        for i, period in enumerate(periods):
            for j, coefficient in enumerate(mu):
                alone = ss.Machine(period=period, friction_coefficient=coefficient, **given).follow(record)
                single = ss.spectrum(record, period=period, friction_coefficient=coefficient, **given)
                for name in ("max_displacement", "residual_displacement", "path", "stick_time", "slides"):
                    assert getattr(alone, name) == getattr(single, name) == getattr(found, name)[i, j], name


def test_the_damping_ratio_is_of_one_rule():
    """A body without friction, with friction, and one of an array have the same damper, by its ratio and by its constant."""
    for zeta in np.linspace(0.01, 0.4, 40):
        given = {"mass": 2000.0, "period": 1.7, "damping_ratio": zeta, "units": "N,m"}
        bare, body = ss.Machine(friction=0.0, **given), ss.Machine(friction=3.0, **given)
        many = ss.Machine(friction=[0.0, 3.0], **given)
        assert bare.damping == body.damping == many.damping[0] == many.damping[1]
        back = [ss.Machine(mass=2000.0, stiffness=body.stiffness, friction=friction, damping=body.damping) for friction in (0.0, 3.0, [0.0, 3.0])]
        assert back[0].damping_ratio == back[1].damping_ratio == back[2].damping_ratio[0] == pytest.approx(zeta, rel=1e-15)


def test_a_zero_of_one_is_that_of_many():
    """A friction or a drive of 0 is the same in an array as alone, and as ratios eps^2 apart."""
    drive = ss.Drive(force=[0.0, 3.0], frequency=1.3)
    machines = ss.Machine(mass=2.0, period=0.7, friction=[[0.0], [4.0]], damping_ratio=0.02, units="N,m")
    found = machines.response(drive)
    tiny = np.finfo(float).eps ** 2
    np.testing.assert_allclose(found.alpha, [[tiny, 1 / tiny], [tiny, 0.75]], rtol=1e-15)
    for i, friction in enumerate((0.0, 4.0)):
        for j, force in enumerate((0.0, 3.0)):
            alone = ss.Machine(mass=2.0, period=0.7, friction=friction, damping_ratio=0.02, units="N,m")
            assert alone.response(ss.Drive(force=force, frequency=1.3)).alpha == found.alpha[i, j]


def test_states_and_events_are_those_of_the_answer():
    record = ss.Record(quake(), times=0.01 * np.arange(1200), unit="g")
    machine = ss.Machine(mass="800 kg", period="2.5 s", friction_coefficient=0.06, damping_ratio="5%")
    motion = machine.motion(record, displacement="1 mm", interval=0.002)
    answer = machine.follow(record, displacement="1 mm")
    assert motion.displacement[0] == 0.001
    assert motion.displacement.max() == pytest.approx(answer.max_displacement, rel=1e-9)
    assert np.count_nonzero(motion.event_direction) == answer.slides == motion.answer.slides
    assert np.count_nonzero(motion.event_direction == 0) == answer.stops + answer.reversals
    assert np.all(motion.velocity[motion.direction == 0] == 0)
    assert np.all(motion.velocity * motion.direction >= -1e-12)
    assert np.all(np.diff(motion.time) >= -1e-12)


@pytest.mark.parametrize(
    "make, said",
    [
        (lambda: ss.Record([1.0], time_step=1.0), "number of samples = 1 must be >= 2"),
        (lambda: ss.Record([1.0, np.nan], time_step=1.0), "sample 2"),
        (lambda: ss.Record([1.0, 2.0], time_step=0.0), "time_step 0.0: must be > 0"),
        (lambda: ss.Record([1.0, 2.0], times=[1.0, 1.0]), "sample 2"),
        (lambda: ss.Record([1.0, 2.0], times=[1.0, 2.0, 3.0]), "times"),
        (lambda: ss.Record([1.0, 2.0]), "either time_step or times"),
        (lambda: ss.Record([1.0, 2.0], time_step=1.0, of="velocity"), "of = velocity"),
        (lambda: ss.Record([1.0, 2.0], time_step=1.0, unit="kg"), "must be an acceleration"),
        (lambda: ss.Record([[1.0, 2.0]], time_step=1.0), "one dimension"),
        (lambda: ss.Block(mass=1.0, friction_coefficient=0.1, slope=2.0), "slope"),
        (lambda: ss.spectrum(ss.Record([1, 2], time_step=1), period=0.0, friction_coefficient=0.1), "period"),
        (lambda: ss.spectrum(ss.Record([1, 2], time_step=1), period=1.0, friction_coefficient=-1.0), "= -1 must be"),
        (lambda: ss.spectrum(ss.Record([1, 2], time_step=1), period=[1e300, 1e-300], friction_coefficient=0.1), "period 1e300: stiffness k = 0 must be > 0"),
    ],
)
def test_what_is_wrong_is_named(make, said):
    with pytest.raises(ss.Error, match=re.escape(said)):
        make()


def test_a_record_can_be_scaled():
    record = ss.Record(quake(), time_step=0.01, unit="g")
    machine = ss.Machine(mass="1 kg", period="1 s", friction="0.5 N")
    assert machine.follow(record.scaled(0.0)).path == 0.0
    assert machine.follow(record.scaled(2.0)).path > machine.follow(record).path > 0.0
    assert len(record) == 1200


def test_a_record_is_read_from_a_file_or_from_bytes(tmp_path):
    samples = quake()
    words = "\n".join(f"{value:.7E}" for value in samples)
    text = f"A\nB\nACCELERATION TIME HISTORY IN UNITS OF G\nNPTS= {len(samples)}, DT= .01 SEC\n{words}\n"
    path = tmp_path / "quake.at2"
    path.write_text(text)
    one, other = ss.Record.read(path), ss.Record.read(text.encode())
    assert one == other
    assert one.summary == other.summary
    assert (one.summary["kind"], one.summary["samples"], one.summary["time_step"]) == ("PEER", len(samples), 0.01)
    np.testing.assert_allclose(one.samples, samples * 9.80665, rtol=1e-7, atol=1e-9)
    # Columns without names take the rest from arguments.
    plain = ss.Record.read(words.encode(), time_step="10 ms", record_units="g")
    np.testing.assert_array_equal(plain.samples, one.samples)
    for make, said in (
        (lambda: ss.Record.read(words.encode(), record_units="g"), "time_step"),
        (lambda: ss.Record.read(words.encode(), time_step=1.0), "record_units, such as g"),
        (lambda: ss.Record.read(tmp_path / "none.at2"), "none.at2"),
        (lambda: ss.Record.read(text.replace("NPTS= ", "NPTS= 1").encode()), "NPTS = 1"),
    ):
        with pytest.raises(ss.Error, match=said):
            make()


def test_a_mirrored_record_has_the_mirrored_answer():
    samples = np.random.default_rng(3).normal(size=(20, 60))
    machine = ss.Machine(mass=2.0, stiffness=80.0, friction=1.5, damping=0.6, units="N,m")
    for row in samples:
        one = machine.follow(ss.Record(3 * row, time_step=0.05, of="force"))
        two = machine.follow(ss.Record(-3 * row, time_step=0.05, of="force"))
        assert (one.max_displacement, one.residual_displacement) == (-two.min_displacement, -two.residual_displacement)
        assert (one.path, one.slides, one.stops, one.reversals) == (two.path, two.slides, two.stops, two.reversals)
        assert one.max_transmitted_force == two.max_transmitted_force


def test_a_block_that_turns_transmits_no_more_than_friction():
    found = ss.Block(mass=1.0, friction=1.0, units="N,m").follow(ss.Record([-3.0, 3.0], time_step=1.0, of="force"))
    assert found.max_transmitted_force == pytest.approx(1.0, rel=1e-14)
    assert found.residual_displacement == pytest.approx(-1 / 18, rel=1e-13)
    assert (found.slides, found.stops, found.reversals, found.stick_time) == (2, 1, 1, 0.0)
    assert np.isnan(found.cut_time)


def test_what_follows_a_record():
    machine = ss.Machine(mass=2.0, stiffness=40.0, friction=1.0, units="N,m")
    pull = {"samples": [0.0, 0.5], "time_step": 2.0, "of": "foot_displacement"}
    rest = {after: machine.follow(ss.Record(**pull, after=after)).residual_displacement for after in ("zero", "hold", "free")}
    # Beside the foot within r/k, beside 0 within r/k, and thrown off.
    assert abs(rest["hold"] - 0.5) <= 0.025 + 1e-12 and abs(rest["zero"]) <= 0.025 + 1e-12 and rest["free"] > 0.5
    by_default = ss.Record(**pull)
    assert by_default.after == "hold" and machine.follow(by_default).residual_displacement == rest["hold"]
    assert ss.Record(**pull, after="zero").scaled(2.0).after == "zero"
    text = b"time[s],acc[g]\n0,0\n1,1\n"
    assert (ss.Record.read(text).after, ss.Record.read(text, after="hold").after) == ("zero", "hold")
    with pytest.raises(ss.Error, match="after = later: must be zero, hold or free"):
        ss.Record(**pull, after="later")


def test_histories_obey_the_laws_of_their_parts():
    record = ss.Record(quake(), time_step=0.01, unit="g")
    machine = ss.Machine(mass=800.0, stiffness=5000.0, friction=470.0, damping=200.0, units="N,m")
    found = machine.motion(record)
    sliding = found.direction != 0
    np.testing.assert_allclose(found.friction[sliding], -470.0 * found.direction[sliding])
    assert np.all(np.abs(found.friction) <= 470.0 * (1 + 1e-12))
    support = 5000.0 * found.displacement + 200.0 * found.velocity - found.friction
    np.testing.assert_allclose(found.transmitted_force, support, atol=1e-9)
    np.testing.assert_allclose(800.0 * found.acceleration, found.load - support, atol=1e-9)
    np.testing.assert_allclose(found.absolute_acceleration, found.acceleration - found.load / 800.0, atol=1e-12)
    greatest = np.abs(found.absolute_acceleration).max() / found.answer.max_absolute_acceleration
    assert 0.99 < greatest <= 1 + 1e-12
    answer = found.answer
    assert answer.peak_displacement == max(answer.max_displacement, -answer.min_displacement)
    assert answer.equivalent_stiffness == pytest.approx(5000.0 + 470.0 / answer.cycle_amplitude, rel=1e-12)
    assert answer.units["equivalent_stiffness"] == "N/m" and 0.1 < answer.equivalent_damping_ratio < 1.0


def test_floor_spectra_are_those_of_small_steps():
    record = ss.Record(quake(900), time_step=0.01, unit="g")
    machine = ss.Machine(mass="800 kg", period="2.5 s", friction_coefficient=0.06, damping_ratio="5%")
    periods = [0.1, 0.7]
    found = machine.floor_spectrum(record, period=periods, damping_ratio=0.02)
    history = machine.motion(record, interval=1e-4)
    for i, period in enumerate(periods):
        square, rate, y, u, most = (2 * np.pi / period) ** 2, 0.08 * np.pi / period, 0.0, 0.0, 0.0
        steps = zip(np.diff(history.time), history.absolute_acceleration, history.absolute_acceleration[1:])
        for h, one, two in steps:
            slope = -one - rate * u - square * y
            middle = (y + h / 2 * u, u + h / 2 * slope)
            y, u = y + h * middle[1], u + h * (-(one + two) / 2 - rate * middle[1] - square * middle[0])
            most = max(most, abs(rate * u + square * y))
        assert found.max_absolute_acceleration[i] == pytest.approx(most, rel=1e-3)
    np.testing.assert_allclose(found.pseudo_acceleration, (2 * np.pi / found.period) ** 2 * found.max_displacement)
    assert (found.damping_ratio, found.units["max_displacement"]) == (0.02, "m")
    with pytest.raises(ss.Error, match="damping ratio"):
        machine.floor_spectrum(record, period=1.0, damping_ratio=1.0)
    with pytest.raises(ss.Error, match="period = 0.0: must be > 0"):
        machine.floor_spectrum(record, period=0.0)


def test_polarities_are_a_record_and_its_mirror_image():
    record = ss.Record(quake(), time_step=0.01, unit="g")
    block = ss.Block(mass="1 t", friction_coefficient=0.3, slope="10 deg", one_way=True)
    both = block.polarities(record)
    assert both.recorded == block.follow(record) and both.mirrored == block.follow(record.scaled(-1.0))
    assert both.greater.peak_displacement == max(both.recorded.peak_displacement, both.mirrored.peak_displacement)
    assert both.recorded.peak_displacement != both.mirrored.peak_displacement
    # Without a slope they are each other's mirror image.
    even = ss.Machine(mass=1.0, stiffness=20.0, friction=0.5, units="N,m").polarities(record)
    assert even.recorded.max_displacement == -even.mirrored.min_displacement and even.polarity == "recorded"
    # A block by its yield acceleration.
    by_name = ss.Block(mass="1 t", yield_acceleration="0.1 g").follow(record)
    by_coefficient = ss.Block(mass="1 t", friction_coefficient=0.1).follow(record)
    assert by_name.peak_displacement == pytest.approx(by_coefficient.peak_displacement, rel=1e-9)
    with pytest.raises(ss.Error, match="yield_acceleration"):
        ss.Block(mass=1.0, friction=1.0, yield_acceleration=1.0)


def test_a_file_is_read_as_it_is_and_described():
    rows = "".join(f"{i / 50:.2f};{5 + math.sin(0.7 * i) * (i > 40):.6f}\n" for i in range(120))
    text = f"Zeit [s];U (V)\n{rows}".encode()
    record = ss.Record.read(text, column="U", scale="2.5 N/V", remove_mean="before", resample=0.01)
    assert (record.of, record.unit, len(record.samples), record.time_step) == ("force", "N", 239, 0.01)
    due = [2.5 * math.sin(0.7 * i) * (i > 40) for i in range(120)]
    np.testing.assert_allclose(record.samples[::2], due, atol=1e-5)
    mean, step = record.summary["notes"]
    assert mean.startswith("The mean 12.5 N of the 41 samples from 0 s to 0.8 s was removed")
    assert step == "Resampled on straight lines from 0.02 s to 0.01 s."
    about = record.describe()
    assert (about["kind"], about["channel"], about["gaps"]) == ("columns", "U", [])
    assert about["peak"] == max(record.samples, key=abs) and about["steps"] == pytest.approx((0.01, 0.01))
    assert about["peak_frequency"] == pytest.approx(0.7 / (2 * math.pi * 0.02), abs=0.1)
    with pytest.raises(ss.Error, match="resample 0.0: must be > 0 and finite"):
        ss.Record.read(text, column="U", scale="2.5 N/V", resample=0)
    with pytest.raises(ss.Error, match="time_column x: must be a column of record: Zeit, U"):
        ss.Record.read(text, column="U", scale="2.5 N/V", time_column="x")
    gap = ss.Record([1, 2, 1, 2, 1], times=[0, 1, 2, 5, 6])
    assert gap.describe()["gaps"] == [(2.0, 5.0)]


def test_records_add_and_subtract():
    one, other = (ss.Record(samples, time_step=0.5, unit="g") for samples in ([0.0, 0.3, 0.1], [0.1, -0.3, 0.2]))
    assert (one + other).samples.tolist() == [0.1, 0.0, 0.30000000000000004] and (one - other).samples.tolist() == [-0.1, 0.6, -0.1]
    assert (one - one).peak == 0.0 and (one - other) == one + -other
    assert sum([one, other, one]) == one + other + one and sum([one]) == one
    later = ss.Record([0.0, 0.3, 0.1], times=[0.0, 0.5, 1.1], unit="g")
    for wrong in (lambda: one - 1, lambda: 1 + one, lambda: one + later, lambda: one - ss.Record([0, 0.3, 0.1], time_step=0.5), lambda: sum([one, later]), lambda: False + one):
        with pytest.raises(ss.Error, match="record"):
            wrong()


def test_a_missing_file_is_an_error_of_files_and_ours(tmp_path):
    (tmp_path / "folder").mkdir()
    for read in (ss.Record.read, ss.System.read):
        with pytest.raises(FileNotFoundError) as caught:
            read(tmp_path / "none.csv")
        assert isinstance(caught.value, ss.Error) and isinstance(caught.value, ss.FileError)
        with pytest.raises(ss.FileError) as other:
            read(tmp_path / "folder")
        for error, number in ((caught.value, errno.ENOENT), (other.value, errno.EISDIR)):
            again = pickle.loads(pickle.dumps(error))
            assert type(again) is type(error) and str(again) == str(error) == f"{error.filename}: {os.strerror(number)}"
            assert (again.errno, again.filename) == (error.errno, error.filename) == (number, str(error.filename))
