"""Values with units: those of the command, by its parser."""

import json
import math
import os
import subprocess

import numpy as np
import pytest

import stickslip as ss

COMMAND = os.environ.get("STICKSLIP_COMMAND")


def test_units_are_what_they_are_defined_to_be():
    machine = ss.Machine(mass="1 lb", stiffness="1 lbf/in", friction="1 kip", damping="2 N*s/m")
    assert machine.mass == 0.45359237
    assert machine.stiffness == pytest.approx(4.4482216152605 / 0.0254, rel=1e-15)
    assert (machine.friction, machine.damping, machine.units) == (4448.2216152605, 2.0, "N,m")
    drive = ss.Drive(base_acceleration="0.15 g", frequency="120 rpm")
    assert drive.amplitude == pytest.approx(0.15 * 9.80665, rel=1e-15)
    assert drive.angular_frequency == pytest.approx(4 * math.pi, rel=1e-15)


def test_a_named_system_is_that_of_bare_numbers_and_of_the_answers():
    of_units = ss.Machine(mass="50 t", stiffness="1000 kN/m", friction="5 kN")
    named = ss.Machine(mass=50, stiffness=1000, friction="5000 N", units="kN,m")
    assert (named.friction, named.units) == (5.0, "kN,m")
    small, large = ss.Drive(force="12 kN", frequency="1 Hz"), ss.Drive(force=12.0, frequency=1.0, units="kN,m")
    found = [machine.response(drive) for machine in (of_units, named) for drive in (small, large)]
    assert [answer.units["energy_per_cycle"] for answer in found] == ["N·m"] * 2 + ["kN·m"] * 2
    for answer, unit in zip(found, (1.0, 1.0, 1e-3, 1e-3)):
        assert answer.energy_per_cycle == pytest.approx(found[0].energy_per_cycle * unit, rel=1e-13)
        assert answer.max_displacement == pytest.approx(0.009914465, rel=1e-6)
    assert "max_displacement=0.0099144" in repr(found[0]) and " m," in repr(found[0])
    assert found[0].units["force_amplitude"] == "N"
    bare = ss.Machine(50, 1000, 5).response(ss.Drive(force=12, frequency=1))
    assert bare.units is None and bare.max_displacement == found[2].max_displacement


def test_arrays_are_in_the_named_system():
    machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05, units="kN,mm")
    drive = ss.Drive(force=np.array([0.9, 1.2]), frequency=[1.7, 2.0], units="kN,mm")
    strokes = machine.response(drive)
    alone = machine.response(ss.Drive(force="1.2 kN", frequency="2 Hz"))
    assert strokes.max_displacement[1] == pytest.approx(alone.max_displacement, rel=1e-12)
    assert strokes.units["max_displacement"] == "mm"


def test_questions_of_design_take_units():
    machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient="5 %")
    assert machine.min_force(frequency="1.7 Hz") == machine.min_force(frequency=1.7)
    assert machine.min_force(frequency=1.7) == pytest.approx(machine.min_force(angular_frequency=1.7 * 2 * math.pi), rel=1e-14)
    assert machine.force_for_displacement("10 mm", frequency="1.7 Hz") == pytest.approx(
        machine.force_for_displacement("0.01 m", angular_frequency=1.7 * 2 * math.pi), rel=1e-12
    )
    assert machine.bands(frequency=("0.2 Hz", "5 Hz"), force="0.9 kN") == machine.bands(frequency=(0.2, 5.0), force="900 N")
    frequency = np.linspace(14.0, 28.0, 20)
    tested = ss.Machine("2 kg", "0.8 kN/m", "3 N", damping_ratio=0.05)
    curve = tested.response(ss.Drive(force="9 N", angular_frequency=frequency)).max_displacement
    found = ss.identify("2 kg", "0.8 kN/m", "9 N", angular_frequency=frequency, amplitude=curve, units="N,m")
    assert found.friction == ss.identify(2.0, 800.0, 9.0, angular_frequency=frequency, amplitude=curve).friction
    assert found.friction.value == pytest.approx(3.0, rel=1e-6)
    with pytest.raises(ss.Error, match="amplitude .*: has no unit beside mass 2 kg"):
        ss.identify("2 kg", "0.8 kN/m", "9 N", angular_frequency=frequency, amplitude=curve)


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ss.Machine("3 s", "1 N/m", "1 N"), "mass 3 s: must be a mass .*, but .s. is a unit of time"),
        (lambda: ss.Machine("3 stone", "1 N/m", "1 N"), "must be a mass .*, but .stone. is not a known unit"),
        (lambda: ss.Machine("3 kg", 1000.0, "1 N"), 'stiffness 1000.0: has no unit beside mass 3 kg.*units="kN,m"'),
        (lambda: ss.Machine("0,3 kg", "1 N/m", "1 N"), "mass 0,3 kg"),
        (lambda: ss.Machine(1, 2, 3, units="kN"), "units kN: must be a unit of force and one of length"),
        (lambda: ss.Machine(1, 2, 3, period=2), "stiffness and period: give one of the two, because it determines the other"),
        (lambda: ss.Machine("1 kg", "2 N/m", "3 N", damping="-2 N*s/m"), "damping -2 N.s/m: damping constant c = -2 must be"),
        (lambda: ss.Machine(1, 2), "friction .or friction_coefficient. is missing"),
        (lambda: ss.Machine(1, 2, 3, gravity=9), "gravity: must be left out without friction_coefficient"),
        (lambda: ss.Machine([1, 2], 2, 3).motion(ss.Record([0, 1.0], time_step=1)), "takes one body, not an array"),
        (lambda: ss.Machine([1, 2], "2 N/m", 3), "mass 1.0: has no unit beside stiffness 2 N/m"),
        (lambda: ss.Machine([1, 2], 2, 3, period=[1, 2]), "stiffness and period: give one of the two"),
        (lambda: ss.Drive(force="12 kN", frequency="2 s"), "frequency 2 s: must be a frequency .*, but .s. is a unit of time"),
        (lambda: ss.Drive(force="12 kN", frequency=1, angular_frequency=2), "give one of frequency"),
        (lambda: ss.Drive(force=[1.0, 2.0], frequency=1, mean_force="2 N"), "force 1.0: has no unit beside mean_force 2 N"),
        (lambda: ss.Machine(1, 2, 3).response(ss.Drive(force="1 N", frequency=1)), "the machine: has no unit beside the drive"),
        (lambda: ss.Machine("1 kg", "2 N/m", "3 N").response(ss.Drive(force=1, frequency=1)), "the drive: has no unit"),
        (lambda: ss.Machine(1, 2, 3).force_for_displacement("3 mm", frequency=1.0), "the machine: has no unit beside max_displacement 3 mm"),
    ],
)
def test_bad_input_is_refused_in_words(call, words):
    with pytest.raises(ss.Error, match=words):
        call()


def test_a_moving_foot_is_felt_as_inertia():
    machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.02)
    foot = ss.Drive(foot_displacement="80 mm", frequency="0.9 Hz")
    in_units = machine.response(foot)
    closed, exact = in_units.ratios, machine.steady(foot).ratios
    assert closed.transmitted_force == pytest.approx(closed.omega**2 * closed.max_acceleration, rel=1e-15)
    assert closed.transmissibility == pytest.approx(closed.max_acceleration / closed.alpha, rel=1e-15)
    assert exact.transmitted_force == pytest.approx(closed.transmitted_force, rel=1e-9)
    assert exact.max_absolute_displacement == pytest.approx(closed.max_displacement, rel=1e-12)
    assert in_units.transmitted_force == pytest.approx(800 * in_units.max_acceleration, rel=1e-12)


def test_a_damper_on_the_foot_leaves_the_accelerations_of_body_and_foot():
    machine = ss.Machine(mass=2.0, stiffness=8.0, friction=4.0, damping=3.0)
    foot = ss.Drive(damped_foot_displacement=1.5, angular_frequency=4.0)
    closed, exact = machine.response(foot), machine.steady(foot)
    for answer in (closed, exact):
        assert answer.transmissibility == pytest.approx(answer.max_acceleration / (1.5 * 16.0), rel=1e-12)
        assert answer.transmitted_force == pytest.approx(2.0 * answer.max_acceleration, rel=1e-12)


def test_a_damping_ratio_is_that_which_was_given():
    """The damping constant rounds: 2ζ√(km) over 2√(km) is not always ζ."""
    machine = ss.Machine(mass=0.02280560845493773, stiffness=416.0284432487476, friction=0.08436456982001318, damping_ratio=0.05)
    drive = ss.Drive(force=0.3766760654387355, frequency=12.67078367069528)
    answer = machine.response(drive)
    assert answer.damping_ratio == 0.05
    assert answer.ratios.max_displacement == ss.response(answer.omega, answer.alpha, 0.05).max_displacement
    assert ss.Machine(1, 4, 1, damping=0.3).response(drive).damping_ratio == 0.3 / 4
    # The drive is in the units of the answer as it was given.
    physical = ss.Machine(mass=3, stiffness=7, friction=0.7).response(ss.Drive(force=1.3, angular_frequency=0.7))
    assert (physical.force_amplitude, physical.angular_frequency) == (1.3, 0.7)


@pytest.mark.skipif(COMMAND is None, reason="STICKSLIP_COMMAND names the command")
@pytest.mark.parametrize("drive", [{"base_acceleration": "0.15 g"}, {"force": "1.2kN"}, {"foot_displacement": "250 mm"}])
@pytest.mark.parametrize("units", [None, "kN,mm"])
@pytest.mark.parametrize("question", ["response", "steady"])
def test_the_bits_are_those_of_the_command(question, units, drive):
    given = {"mass": "800kg", "period": "2.2 s", "friction_coefficient": "5%", "damping_ratio": "0.02", "static_friction_ratio": "1.2"}
    options = [f"--{name.replace('_', '-')}={text}" for name, text in {**given, **drive, "frequency": "2Hz"}.items()]
    run = [COMMAND, question, *options, "--format", "json", *([] if units is None else ["--units", units])]
    told = json.loads(subprocess.run(run, capture_output=True, text=True, check=True).stdout)
    found = getattr(ss.Machine(**given, units=units), question)(ss.Drive(**drive, frequency="2Hz"))
    physical = found
    compared = 0
    for name, value in told["physical"].items():
        own = getattr(physical, name, None) if name != "units" else None
        if own is not None and value is not None:
            assert own == value, name
            assert physical.units[name] == told["physical"]["units"][name], name
            compared += 1
    assert compared >= 6
    assert found.regime == told["regime"]
