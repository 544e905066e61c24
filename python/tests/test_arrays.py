"""Machines, drives and blocks as arrays, machines with other values, and uncertain machines."""

import copy
import dataclasses
import math
import sys
import time

import pickle
import numpy as np
import pytest

import stickslip as ss

BARE = {"mass": 2.0, "stiffness": 800.0, "friction": 3.0}


def test_machines_of_arrays_have_the_numbers_of_each():
    random = np.random.default_rng(3)
    n = 60
    given = {
        "mass": random.uniform(1, 4, n),
        "period": random.uniform(0.2, 2, n),
        "friction_coefficient": random.uniform(0.01, 0.3, n),
        "damping_ratio": random.uniform(0, 0.2, n),
        "static_friction_ratio": random.choice([1.0, 1.2], n),
    }
    force, frequency, mean = random.uniform(5, 60, n), random.uniform(0.3, 4, n), random.uniform(-2, 2, n)
    many = ss.Machine(**given, friction_backward=2.0)
    closed = many.response(ss.Drive(force=force, frequency=frequency, mean_force=mean))
    exact = many.steady(ss.Drive(force=force, frequency=frequency, mean_force=mean), start=(0.3, np.linspace(0, 0.1, n), 0.05))
    record = ss.Record(np.sin(np.arange(200) * 0.3), time_step=0.05)
    followed, moved = many.follow(record), many.follow(record, displacement=np.linspace(0, 0.1, n))
    least, best = many.min_force(frequency=frequency), many.best_friction(ss.Drive(force=force, frequency=frequency))
    for i in range(n):
        one = ss.Machine(**{name: float(values[i]) for name, values in given.items()}, friction_backward=2.0)
        assert (one.mass, one.stiffness, one.damping) == (many.mass[i], many.stiffness[i], many.damping[i])
        drive = ss.Drive(force=force[i], frequency=frequency[i], mean_force=mean[i])
        alone = one.response(drive)
        for name in ("max_displacement", "min_force", "mean_displacement", "energy_per_cycle", "best_force_energy", "omega"):
            np.testing.assert_equal(closed[name][i], alone[name])
        assert closed.regime[i] == alone.regime
        alone = one.steady(drive, start=(0.3, np.linspace(0, 0.1, n)[i], 0.05))
        for name in ("max_displacement", "energy_out", "transmitted_force", "stick_fraction"):
            np.testing.assert_equal(exact[name][i], alone[name])
        for found, answer in ((followed, one.follow(record)), (moved, one.follow(record, displacement=np.linspace(0, 0.1, n)[i]))):
            for name in ("max_displacement", "residual_displacement", "slides", "friction_work"):
                np.testing.assert_equal(found[name][i], answer[name])
        assert least[i] == one.min_force(frequency=frequency[i])
        try:
            assert best.friction[i] == one.best_friction(ss.Drive(force=force[i], frequency=frequency[i])).friction
        except ss.Error:
            assert math.isnan(best.friction[i]) and best.optimum[i] == "invalid"


def test_a_machine_outside_the_domain_is_one_invalid_point_of_many():
    many = ss.Machine(mass=[2.0, -1.0, np.nan, 2.0], stiffness=800.0, friction=[3.0, 3.0, 3.0, 4.0])
    found = many.response(ss.Drive(force=9.0, frequency=3.0))
    assert found.regime.tolist() == ["non-sticking", "invalid", "invalid", "non-sticking"]
    assert np.isnan(found.max_displacement).tolist() == [False, True, True, False]
    record = ss.Record(np.sin(np.arange(50.0)), time_step=0.05)
    path = many.follow(record)
    assert np.isnan(path.path).tolist() == [False, True, True, False] and set(path.errors) == {1, 2}
    masked = ss.Machine(mass=np.ma.masked_array([2.0, 2.0], [False, True]), stiffness=800.0, friction=3.0)
    assert masked.follow(record).path.mask.tolist() == [False, True]
    for call in (
        lambda: ss.Machine(mass=[1.0, 2.0], friction=1.0),
        lambda: ss.Machine(mass=[1.0, 2.0], stiffness=[1.0, 2.0, 3.0], friction=1.0),
        lambda: ss.Machine(mass=[1.0, 2.0], stiffness=1.0, friction=1.0, weight=3.0),
        lambda: many.motion(record),
        lambda: many.simulate(ss.Drive(force=9.0, frequency=3.0)),
    ):
        with pytest.raises(ss.Error):
            call()


def test_blocks_of_arrays_have_the_numbers_of_each():
    record = ss.Record(np.cos(np.arange(200) * 0.2), time_step=0.05, unit="g")
    slopes = ss.Block(mass="1 t", yield_acceleration=np.linspace(0.05, 0.3, 6), one_way=True, units="N,m")
    found = slopes.follow(record)
    for i, own in enumerate(np.linspace(0.05, 0.3, 6)):
        alone = ss.Block(mass="1 t", yield_acceleration=float(own), one_way=True, units="N,m").follow(record)
        assert (found.path[i], found.slides[i]) == (alone.path, alone.slides)
    steep = ss.Block(mass=1.0, friction_coefficient=[0.1, 0.2], slope="3 deg", units="N,m").follow(record)
    assert steep.path[1] == ss.Block(mass=1.0, friction_coefficient=0.2, slope="3 deg", units="N,m").follow(record).path
    assert slopes == copy.deepcopy(slopes) and "friction=<" not in repr(ss.Block(1.0, 2.0))


def test_a_machine_can_be_varied_in_one_value():
    machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05, damping_ratio="5%", units="kN,mm")
    assert machine.replace(friction=0.3) == ss.Machine(mass="800 kg", period="2.2 s", friction=0.3, damping_ratio="5%", units="kN,mm")
    assert machine.replace(stiffness="4 N/mm").friction == machine.friction
    assert machine.replace() == machine
    # What determines the same value is left out; all others stay as they were given.
    assert machine.replace(mass="400 kg").period == pytest.approx(2.2) and machine.replace(mass="400 kg").friction == machine.friction / 2
    bare = ss.Machine(**BARE, damping=1.5)
    assert bare.replace(damping_ratio=0.1).damping == pytest.approx(0.2 * math.sqrt(1600))
    assert dataclasses.replace(bare, friction=30.0) == bare.replace(friction=30.0) != bare
    assert ss.Machine(**dataclasses.asdict(bare)) == bare
    if sys.version_info >= (3, 13):
        assert copy.replace(bare, friction=30.0) == bare.replace(friction=30.0)
    drive = ss.Drive(force="9 N", frequency="3 Hz")
    assert drive.replace(frequency=[1.0, 2.0]).frequency.tolist() == [1.0, 2.0]
    assert drive.replace(base_acceleration="0.1 g").excitation == "base_acceleration"
    with pytest.raises(ss.Error, match="friction 30.0: has no unit beside mass 800 kg"):
        ss.Machine(mass="800 kg", period="2.2 s", friction="1 N").replace(friction=30.0)


def test_a_machine_is_varied_from_the_values_that_it_was_given():
    friction = np.array([3.0, 4.0])
    machine, drive, block = ss.Machine(2.0, 800.0, friction), ss.Drive(force=friction, frequency=1.0), ss.Block(1.0, friction)
    friction[0] = 99.0
    assert machine.replace(mass=1.0).friction.tolist() == drive.replace(frequency=2.0).amplitude.tolist() == block.replace(mass=2.0).friction.tolist() == [3.0, 4.0]
    for array in (machine.friction, drive.amplitude, block.friction):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0
    # The mass follows from the stiffness and the period.
    by_period = ss.Machine(stiffness=800.0, period=0.5, friction=3.0)
    assert by_period.replace(stiffness=1600.0).mass == pytest.approx(2 * by_period.mass)
    assert by_period.replace(period=1.0).mass == pytest.approx(4 * by_period.mass)


def test_only_mass_stiffness_and_friction_go_by_their_places():
    with pytest.raises(TypeError, match="positional"):
        ss.Machine(2.0, 800.0, 3.0, 1.0)


def test_values_with_and_without_units_follow_one_rule():
    named, known, bare = ss.Machine(**BARE, units="N,m"), ss.Machine("2 kg", "800 N/m", "3 N"), ss.Machine(**BARE)
    record, of_units = ss.Record([0.0, 5.0, 0.0], time_step=0.5), ss.Record([0.0, 0.5, 0.0], time_step=0.5, unit="g")
    asks = [
        (lambda m: m.response(ss.Drive(force=9.0, frequency=3.0)), lambda m: m.response(ss.Drive(force="9 N", frequency=3.0))),
        (lambda m: m.follow(record), lambda m: m.follow(of_units)),
        (lambda m: m.decay(0.05), lambda m: m.decay("50 mm")),
        (lambda m: m.follow(record if m.units is None or m is named else of_units, displacement=0.05), lambda m: m.follow(of_units, displacement="50 mm")),
        (lambda m: m.force_for_displacement(0.05, frequency=3.0), lambda m: m.force_for_displacement("50 mm", frequency=3.0)),
        (
            lambda m: m.steady(ss.Drive(force="9 N" if m is known else 9.0, frequency=3.0), start=(0, 0.05, 0)),
            lambda m: m.steady(ss.Drive(force="9 N", frequency=3.0), start=(0, "50 mm", 0)),
        ),
    ]
    for number, with_unit in asks:
        number(named), with_unit(named), with_unit(known), number(bare)
        with pytest.raises(ss.Error, match="has no unit beside the machine"):
            number(known)
        with pytest.raises(ss.Error, match="the machine: has no unit beside"):
            with_unit(bare)


def test_every_value_of_a_machine_has_its_unit():
    machine = ss.Machine("2 kg", "800 N/m", "3 N", damping_ratio=0.05, units="N,mm")
    drive = ss.Drive(base_acceleration="0.3 g", frequency="3 Hz")
    for found in (machine.response(drive), machine.steady(drive)):
        for name in found:
            value, in_ratios = found[name], getattr(found.ratios, name, None)
            if isinstance(value, float) and name not in found.units and not math.isnan(value):
                assert value == in_ratios, name
        assert found.units["max_displacement"] == "mm" and found.units["displacement_phase" if "displacement_phase" in found else "max_displacement_phase"] == "rad"
        assert found.max_displacement == pytest.approx(found.ratios.max_displacement * found.friction_displacement)
    assert ss.response(0.7, 3).units["max_velocity"] == "B ω_d" and "margin" not in ss.response(0.7, 3).units
    limits = ss.Machine(**BARE, damping_ratio=0.02, static_friction_ratio=1.3)
    found = limits.attractors(ss.Drive(force=12.0, angular_frequency=10.0), starts=30)
    for limit, bare in zip(found.attractors, found.ratios.attractors):
        assert limit.max_displacement == bare.max_displacement * 3.0 / 800.0
    start = [(0.0, 0.03, 0.1)]
    own = limits.attractors(ss.Drive(force=12.0, angular_frequency=10.0), starts=start)
    assert own.attractors[0].first_x == pytest.approx(0.03) and own.attractors[0].first_v == pytest.approx(0.1)


def test_a_waveform_is_one_cycle_of_the_steady_motion():
    for omega, alpha, zeta in ((0.4, 6.0, 0.0), (0.7, 3.0, 0.05), (1.5, 2.5, 0.0)):
        found = ss.steady(omega, alpha, zeta)
        cycle = found.waveform(2000)
        assert cycle.phase[0] == 0 and cycle.phase[-1] == pytest.approx(2 * math.pi) and cycle.displacement.size == 2001
        assert cycle.displacement[-1] == pytest.approx(cycle.displacement[0], abs=1e-9)
        np.testing.assert_allclose(cycle.displacement[1000:], -cycle.displacement[:1001], atol=1e-9)
        assert cycle.displacement.max() == pytest.approx(found.max_displacement, rel=1e-5)
        assert cycle.velocity.max() == pytest.approx(found.max_velocity, rel=1e-4)
        # The equation of motion, by differences of the velocity: x'' + 2ζx' + x + f = α sin Ωφ, with x' = Ω v.
        slope = np.gradient(cycle.velocity, cycle.phase)
        left = omega**2 * slope + 2 * zeta * omega * cycle.velocity + cycle.displacement + cycle.friction
        slides = np.abs(cycle.velocity) > 0.05
        assert np.abs(left - alpha * np.sin(cycle.phase))[slides].max() < 0.02
        x, force = cycle.loop()
        assert abs(np.sum((force[1:] + force[:-1]) / 2 * np.diff(x))) == pytest.approx(found.energy_out, rel=2e-3)
    machine = ss.Machine(**BARE)
    drive = ss.Drive(force=9.0, frequency=1.0)
    cycle = machine.steady(drive).waveform(500)
    assert cycle.time[-1] == pytest.approx(1.0) and cycle.displacement.max() == pytest.approx(machine.steady(drive).max_displacement, rel=1e-4)
    with pytest.raises(ss.Error, match="one point"):
        ss.steady([0.4, 0.7], 6).waveform()
    with pytest.raises(ss.Error, match="tends to no cycle, but to: rest"):
        ss.steady(0.4, 0.5).waveform()


def test_samples_begin_at_their_start():
    start = (1.0, 0.3, -0.2)
    found = ss.simulate(0.4, 6, start=start, samples=16, cycles=2)
    assert (found.phase[0], found.displacement[0], found.velocity[0]) == pytest.approx(start, rel=1e-14)
    assert found.phase.size == 33 and np.diff(found.phase) == pytest.approx(2 * math.pi / 16)


def test_a_record_is_a_value():
    record = ss.Record([0.0, 1.0, -3.0, 0.0], time_step="10 ms", unit="g")
    assert record.times == pytest.approx([0, 0.01, 0.02, 0.03]) and (record.duration, record.time_step, record.peak) == (0.03, 0.01, 3.0)
    with pytest.raises(ValueError, match="read-only"):
        record.samples[:] = 0
    given = np.array([0.0, 1.0])
    ss.Record(given, time_step=1.0)
    given[0] = 5.0
    assert record * 2 == 2 * record == np.float64(2) * record == record + record == record.scaled(2.0)
    assert (-record).samples.tolist() == [0, -1, 3, 0] and (record / 2).peak == 1.5
    assert record[1:].times == pytest.approx([0.01, 0.02, 0.03]) and record[::2].samples.tolist() == [0.0, -3.0]
    assert record.between(0.005, 0.02).samples.tolist() == [1.0, -3.0] and len(record.between(0.01, 0.03)) == 3
    # Times are decimals: six steps of 0.2 s are 1.2 s, which a product of doubles passes.
    assert len(ss.Record(range(8), time_step=0.2).between(0.2, 1.2)) == 6
    other = copy.deepcopy(record)
    assert other == record and not other.samples.flags.writeable
    machine = ss.Machine("2 kg", "800 N/m", "3 N")
    assert machine.follow(-record).max_displacement == -machine.follow(record).min_displacement
    for call, kind in (
        (lambda: record[0], TypeError),
        (lambda: record[:1], ss.Error),
        (lambda: record / 0, ss.Error),
        (lambda: record + record[1:], ss.Error),
        (lambda: record * True, TypeError),
        (lambda: record * math.nan, ss.Error),
    ):
        with pytest.raises(kind):
            call()


def test_histories_are_frames():
    pytest.importorskip("pandas")
    machine = ss.Machine("2 kg", "800 N/m", "3 N", units="N,mm")
    motion = machine.motion(ss.Record(np.sin(np.arange(200) * 0.2), time_step="20 ms", unit="g"), interval="5 ms")
    frame = motion.to_frame()
    assert frame["displacement"].tolist() == motion.displacement.tolist() and frame.attrs["units"]["velocity"] == "mm/s"
    assert len(motion.events()) == len(motion.event_time) != len(frame)
    assert motion.answer.units["path"] == "mm"
    for interval in (math.nan, 0.0, -1.0, "1 m"):
        with pytest.raises(ss.Error, match="interval"):
            machine.motion(ss.Record([0.0, 1.0], time_step=1.0, unit="g"), interval=interval)


def test_a_spectrum_has_units_and_reasons():
    record = ss.Record(np.sin(np.arange(300) * 0.2), time_step=0.02, unit="g")
    found = ss.spectrum(record, period=[0.5, 0.0, np.nan, 1.0], friction_coefficient=0.05, mass="2 t", units="kN,mm")
    assert np.isnan(found.path).tolist() == [False, True, True, False] and "= 0 must be > 0" in found.errors[1] and "NaN" in found.errors[2]
    alone = ss.Machine(mass="2 t", period="1 s", friction_coefficient=0.05, units="kN,mm").follow(record)
    for name in ("max_displacement", "max_transmitted_force", "friction_work", "slides"):
        assert found[name][3] == pytest.approx(alone[name], rel=1e-9), name
    assert (found.units["max_transmitted_force"], found.units["max_displacement"]) == ("kN", "mm")
    assert "max_transmitted_force" not in ss.spectrum(record, period=1.0, friction_coefficient=0.05)
    assert ss.spectrum(record, period="1 s", friction_coefficient=0.05).path == ss.spectrum(record, period=1.0, friction_coefficient=0.05).path


def test_pictures():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    machine = ss.Machine("2 kg", "800 N/m", "3 N", units="N,mm")
    curve = machine.steady(ss.Drive(force="9 N", frequency=np.linspace(1, 6, 20)))
    axes = curve.plot("max_displacement", "transmissibility")
    assert axes.get_xlabel() == "angular frequency (rad/s)" and len(axes.lines) == 2
    assert axes.lines[0].get_ydata().tolist() == curve.max_displacement.tolist()
    assert curve.plot(over="omega").get_xlabel() == "omega"
    plane = ss.response(np.linspace(0.5, 2, 5), np.linspace(2, 6, 4)[:, None]).plot("margin")
    assert (plane.get_xlabel(), plane.get_ylabel()) == ("omega", "alpha")
    assert machine.steady(ss.Drive(force="9 N", frequency=2.0)).waveform().plot().get_xlabel() == "time (s)"
    assert ss.Record([0.0, 1.0, 0.0], time_step=1.0, unit="g").plot().get_ylabel() == "base acceleration (g)"
    assert ss.basins(0.5, 4, 0.02, 1.3, displacement=[-9, 0, 9], velocity=[-9, 9]).plot().get_xlabel() == "displacement (B)"
    with pytest.raises(ss.Error, match="'stroke' must be one of"):
        curve.plot("stroke")


def test_results_fit_a_screen_and_a_notebook():
    import json

    machine = ss.Machine("2 kg", "800 N/m", "3 N")
    many = machine.replace(friction=None, friction_coefficient=np.linspace(0.1, 0.2, 50))
    for found in (machine.steady(ss.Drive(force="9 N", frequency=2.0)), ss.steady(0.4, 6), many.response(ss.Drive(force="9 N", frequency=2.0)), machine.follow(ss.Record([0, 1.0], time_step=1, unit="g"))):
        assert len(repr(found)) < 800 and "\n" not in repr(found)
        assert found._repr_html_().count("<tr>") > 8
        assert json.loads(json.dumps(found.to_dict()))["max_displacement"] is not None
    assert len(repr(many)) < 400
    assert "<th" not in found._repr_html_() and "&lt;" not in ss.steady(0.4, 6)._repr_html_()


def test_help_explains_every_output():
    import pydoc

    words = pydoc.render_doc(ss.MachineSteady, renderer=pydoc.plaintext)
    assert "max_displacement" in words and "Peak displacement Δ₀" in words
    for kind in (ss.Response, ss.Steady, ss.MachineResponse, ss.MachineSteady):
        for name in kind._names:
            assert getattr(kind, name).__doc__, (kind, name)
            assert name in kind.__doc__, (kind, name)


def test_the_formulae_of_the_help_are_those_of_the_answers():
    for omega, alpha, zeta in ((0.7, 3.0, 0.0), (1.5, 2.5, 0.04), (2.3, 4.0, 0.2)):
        found = ss.response(omega, alpha, zeta)
        T, d = math.pi / omega, math.sqrt(1 - zeta**2)
        q, delta = math.hypot(1 - omega**2, 2 * zeta * omega), math.atan2(2 * zeta * omega, 1 - omega**2)
        N = math.cosh(zeta * T) + math.cos(d * T)
        G, H = (math.sinh(zeta * T) - zeta / d * math.sin(d * T)) / N, math.sin(d * T) / (d * omega * N)
        K = q * H
        a, Q = math.sqrt(alpha**2 - K**2) / q, math.hypot(K, q * G)
        S = (1 + G + 2 * zeta * omega * H) / omega**2
        expected = {
            "max_displacement": a - G,
            "displacement_phase": (delta + math.atan2(q * a, K)) % (2 * math.pi),
            "loop_size_stiffness": 8 * (a - G) / alpha**2,
            "loop_size_inertia": omega**2 * 8 * (a - G) / alpha**2,
            "min_force_ratio": q * math.hypot(S, H),
            "margin": alpha / (q * math.hypot(S, H)),
            "best_force_ratio": max(math.sqrt(2 * Q * (Q + q * G)), q * math.hypot(S, H)) if found.best_force_ratio_slides else math.sqrt(2 * Q * (Q + q * G)),
            "dynamic_amplification": (a - G) / alpha,
        }
        for name, value in expected.items():
            if name != "best_force_ratio" or found.best_force_ratio_slides:
                assert found[name] == pytest.approx(value, rel=1e-11), name


def test_an_array_of_one_machine_outside_the_domain_has_no_answer_as_any_other():
    one = ss.Machine(mass=[-1.0], stiffness=800.0, friction=3.0)
    drive = ss.Drive(force=9.0, frequency=3.0)
    for found in (one.response(drive), one.steady(drive)):
        assert found.regime.tolist() == ["invalid"] and np.isnan(found.max_displacement).tolist() == [True]


def test_machines_in_parts_are_those_of_one_call(monkeypatch):
    mass, friction = np.linspace(1, 2, 1000), np.full(1000, 3.0)
    friction[950:] = 4.0
    mass[[0, 700]] = -1.0
    given = {"mass": mass, "stiffness": np.full(1000, 800.0), "friction": friction, "damping_ratio": 0.02}
    whole = ss.Machine(**given)
    monkeypatch.setattr("stickslip._result._BLOCK", 100)
    found = ss.Machine(**given)
    assert found == whole and vars(found)["_failed"] == vars(whole)["_failed"] and set(vars(found)["_failed"]) == {0, 700}
    assert found.stiffness.strides != (0,) and np.isnan(found.mass[[0, 700]]).all() and found.friction[[949, 950]].tolist() == [3.0, 4.0]
    assert ss.Machine(mass=mass[1:600], stiffness=800.0, friction=friction[1:600]).friction.strides == (0,)
    assert found.replace(friction=5.0).mass[1:700].tolist() == mass[1:700].tolist()


def test_a_machine_does_not_see_later_changes_of_an_array_that_is_shown_read_only():
    own = np.array([1.0, 2.0])
    shown = own.view()
    shown.flags.writeable = False
    machine, drive = ss.Machine(mass=shown, stiffness=800.0, friction=3.0), ss.Drive(force=9.0, frequency=np.broadcast_to(own[:1], 2))
    lazy = ss.response(shown, 3.0)
    own[:] = 7.0
    assert machine.mass.tolist() == machine.replace(friction=2.0).mass.tolist() == [1.0, 2.0]
    assert drive.frequency.tolist() == [1.0, 1.0] and lazy.omega.tolist() == [1.0, 2.0]


def test_monte_carlo_is_that_of_each_draw():
    machine = ss.Machine("800 kg", period="2.2 s", friction_coefficient=0.05, damping_ratio=0.02, units="N,mm")
    drive = ss.Drive(base_acceleration="0.15 g", frequency="1.2 Hz")
    vary = {"friction": 0.1, "frequency": (1.0, 1.4), "amplitude": lambda random, n: random.uniform(1000, 2000, n), "mass": np.linspace(700, 900, 300) * 1e-3}
    vary["mass"] = np.linspace(0.9, 1.1, 300) * machine.mass
    found = ss.monte_carlo(machine, drive, vary, draws=300, seed=5)
    again = ss.monte_carlo(machine, drive, vary, draws=300, seed=5)
    assert found.answer.max_displacement.tolist() == again.answer.max_displacement.tolist()
    for i in (0, 17, 299):
        at = {name: float(column[i]) for name, column in found.drawn.items()}
        one = ss.Machine(mass=at["mass"], stiffness=machine.stiffness, friction=at["friction"], damping_ratio=0.02, units="N,mm")
        alone = one.steady(ss.Drive(base_acceleration=at["amplitude"], frequency=at["frequency"], units="N,mm"))
        assert found.answer.max_displacement[i] == pytest.approx(alone.max_displacement, rel=1e-12)
    values = np.sort(found.answer.max_displacement)
    assert found.quantile("max_displacement", 0.0) == values[0] and found.interval("max_displacement", 0.5)[0] == np.quantile(values, 0.25)
    mean = found.mean("max_displacement")
    assert mean.value == pytest.approx(values.mean()) and mean.standard_error == pytest.approx(values.std(ddof=1) / math.sqrt(300))
    share = found.probability("non-sticking")
    assert share.value == np.mean(found.answer.regime == "non-sticking") and share.interval[0] <= share.value <= share.interval[1]
    for call in (
        lambda: ss.monte_carlo(machine, drive, {"colour": 0.1}, seed=1),
        lambda: ss.monte_carlo(machine, drive, {"friction": -0.1}, seed=1),
        lambda: ss.monte_carlo(machine, drive, {"friction": (2.0, 1.0)}, seed=1),
        lambda: ss.monte_carlo(machine, drive, {"friction": [1.0]}, seed=1),
        lambda: found.quantile("max_displacement", 1.5),
    ):
        with pytest.raises(ss.Error):
            call()


def test_sensitivities_are_the_derivatives():
    machine, drive = ss.Machine(mass=50, stiffness=1000, friction=5), ss.Drive(force=12, frequency=1)
    found = ss.sensitivities(machine, drive, "max_displacement", exact=False)
    # By dual numbers, in the documentation of the library.
    assert found["mass"].elasticity == pytest.approx(-2.084325, abs=1e-6)
    # Δ₀ is homogeneous: of degree 1 in all forces, and of degree 0 in mass, stiffness and the square of the frequency.
    assert found["stiffness"].elasticity + found["friction"].elasticity + found["amplitude"].elasticity + found["mass"].elasticity == pytest.approx(0.0, abs=1e-8)
    assert found["friction"].elasticity + found["amplitude"].elasticity == pytest.approx(1.0, abs=1e-9)
    assert found["mass"].elasticity == pytest.approx(-1.0 * found["stiffness"].elasticity - 1.0, abs=1e-8)
    assert all(own.error < 1e-8 for own in found.values())
    stops = ss.sensitivities(machine, ss.Drive(force=12, frequency=0.2), "max_displacement", by=["friction", "amplitude"])
    assert stops["friction"].elasticity + stops["amplitude"].elasticity == pytest.approx(1.0, abs=1e-6)
    record = ss.Record(np.sin(np.arange(100) * 0.2), time_step=0.05)
    follow = ss.sensitivities(machine, record, "path", by=["friction"])["friction"]
    step = [machine.replace(friction=5 * (1 + h)).follow(record).path for h in (1e-5, -1e-5)]
    assert follow.derivative == pytest.approx((step[0] - step[1]) / 1e-4, rel=1e-4)


def test_a_hundred_thousand_machines_take_no_loop_of_python():
    random = np.random.default_rng(1)
    n = 100_000
    begin = time.process_time()
    machines = ss.Machine(mass=50.0, stiffness=1000.0, friction=random.uniform(3, 8, n), damping_ratio=0.02)
    found = machines.response(ss.Drive(force=12.0, frequency=1.0))
    spent = time.process_time() - begin
    assert np.isfinite(found.max_displacement).sum() > n / 2
    # Builds without optimisation take some ten times as long; a loop of Python, 12 s.
    assert spent < 6.0
    i = int(random.integers(n))
    alone = ss.Machine(mass=50.0, stiffness=1000.0, friction=machines.friction[i], damping_ratio=0.02).response(ss.Drive(force=12.0, frequency=1.0))
    np.testing.assert_equal(found.max_displacement[i], alone.max_displacement)


def test_design_questions_of_the_command():
    machine = ss.Machine(mass=50.0, stiffness=1000.0, friction=5.0)
    drive = ss.Drive(force=12.0, angular_frequency=6.0)
    for found in machine.frictions_for_displacement(0.01, drive):
        assert machine.replace(friction=found.friction).steady(drive).max_displacement == pytest.approx(0.01, rel=1e-9)
    unbalance = ss.Drive(unbalance=0.4, frequency=1.0)
    held = machine.hold(unbalance)
    assert machine.steady(unbalance.replace(frequency=held * 0.999)).regime == "stuck" != machine.steady(unbalance.replace(frequency=held * 1.001)).regime
    assert (machine.hold(ss.Drive(force=4.0, frequency=1.0)), machine.hold(ss.Drive(force=6.0, frequency=1.0))) == (math.inf, 0.0)
    slow = ss.Drive(force=12.0, angular_frequency=1.0)
    best = machine.best_friction(slow, sticking=True)
    assert best.optimum == "sticking" and best.energy > machine.best_friction(slow).energy
    for share in (0.98, 1.02):
        worse = machine.replace(friction=best.friction * share).steady(slow)
        assert worse.energy_out < best.energy
    assert machine.replace(friction=best.friction).steady(slow).energy_out == pytest.approx(best.energy, rel=1e-6)


def test_a_curve_gives_the_natural_frequency_or_the_force():
    tested = ss.Machine(**BARE, damping_ratio=0.05)
    frequency = tested.natural_frequency * np.linspace(0.7, 1.4, 24)
    amplitude = tested.response(ss.Drive(force=9.0, frequency=frequency)).max_displacement
    by_frequency = ss.identify(2.0, force=9.0, frequency=frequency, amplitude=amplitude)
    assert by_frequency.natural_frequency.value == pytest.approx(tested.natural_frequency, rel=1e-6) and by_frequency.force is None
    assert by_frequency.friction.value == pytest.approx(3.0, rel=1e-4)
    by_force = ss.identify(2.0, 800.0, frequency=frequency, amplitude=amplitude)
    assert by_force.force.value == pytest.approx(9.0, rel=1e-4) and by_force.natural_frequency is None
    with pytest.raises(ss.Error, match="one of them can be found"):
        ss.identify(2.0, frequency=frequency, amplitude=amplitude)
    with pytest.raises(ss.Error, match="angular_frequency: must be an array of one dimension"):
        ss.identify(2.0, 800.0, 9.0, frequency=3.0, amplitude=0.1)


def machine_in_units():
    return ss.Machine(**BARE, units="N,m")


def test_basins_and_best_stiffness_in_units():
    machine = ss.Machine("2 kg", "8 N/m", "4 N", damping_ratio=0.02, static_friction_ratio=1.3)
    drive = ss.Drive(force="16 N", angular_frequency=1.0)
    found = machine.replace(units="N,mm").basins(drive, displacement=[-4500.0, 0.0, 4500.0], velocity=[0.0, 2000.0])
    bare = ss.basins(0.5, 4, 0.02, 1.3, displacement=[-9.0, 0.0, 9.0], velocity=[0.0, 4.0])
    assert found.attractor.tolist() == bare.attractor.tolist() and found.units["displacement"] == "mm"
    assert [own.max_displacement for own in found.attractors] == pytest.approx([500 * own.max_displacement for own in bare.attractors])
    drive = ss.Drive(force=12.0, frequency=1.0)
    machine = ss.Machine(mass=50.0, stiffness=1000.0, friction=5.0)
    best = machine.best_stiffness(drive, stiffness=(500.0, 1500.0))
    tried = machine.replace(stiffness=np.linspace(500, 1500, 2001)).response(drive)
    energies = np.where(tried.regime == "non-sticking", tried.energy_per_cycle, 0.0)
    assert best.energy == pytest.approx(energies.max(), rel=1e-4) and best.energy >= energies.max()


@pytest.mark.parametrize(
    "call",
    [
        lambda: ss.simulate(0.4, 6, samples=True),
        lambda: ss.simulate(0.4, 6, cycles="2"),
        lambda: machine_in_units().floor_spectrum(ss.Record([0, 1.0], time_step=1.0), period=[[1.0]]),
        lambda: ss.Drive(force=9.0, frequency=b"5"),
        lambda: ss.simulate(0.4, 6, cycles=True),
        lambda: ss.steady(0.4, 6, max_periods=True),
        lambda: ss.Block(1.0, 1.0, one_way=2),
    ],
)
def test_values_of_the_wrong_type_are_type_errors(call):
    with pytest.raises((TypeError, ss.Error)):
        call()


def test_arrays_of_frozen_objects_stay_frozen_in_copies():
    machine = ss.Machine(mass=[2.0, 3.0], stiffness=800.0, friction=3.0, damping_ratio=[0.1, 0.2])
    drive, block = ss.Drive(force=[9.0, 8.0], frequency=[3.0, 4.0]), ss.Block(mass=[2.0, 3.0], friction=1.0)
    record = ss.Record([0.0, 1.0, 0.0], time_step=0.1)
    for own in (machine, drive, block, record):
        for twin in (own, pickle.loads(pickle.dumps(own)), copy.copy(own), copy.deepcopy(own)):
            assert twin == own
            arrays = [value for value in (*vars(twin).values(), *vars(twin).get("_own", {}).values()) if isinstance(value, np.ndarray)]
            assert arrays and not any(array.flags.writeable for array in arrays)
            with pytest.raises(AttributeError):
                twin.mass = 3.0
    assert not pickle.loads(pickle.dumps(machine)).damping_ratio.flags.writeable
