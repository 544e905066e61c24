"""What the package answers beyond the command, beside small steps and arithmetic that share nothing with the library."""

import math

import numpy as np
import pytest
from compared import agreed, compared, near

import stickslip as ss

GIVEN = {"mass": 2.0, "stiffness": 50.0, "friction": 3.0, "damping_ratio": 0.05}
MASS, STIFFNESS, FRICTION, DAMPING = 2.0, 50.0, 3.0, 2 * 0.05 * math.sqrt(2.0 * 50.0)


def machine(**changes):
    return ss.Machine(**{**GIVEN, **changes})


def cycle(force, frequency, *, friction=FRICTION, stiffness=STIFFNESS, damping=None, turns=40, steps=1500):
    """Peak, peak velocity, work of friction and whether it stops, of the last turn of a motion from rest by the second order's midpoint rule. A change
    of sign of the velocity ends a step where its chord is zero."""
    damping = DAMPING if damping is None else damping
    h, x, v, sign = 2 * math.pi / frequency / steps, 0.0, 0.0, 0
    most = fastest = work = 0.0
    stops = False
    for i in range(turns * steps):
        if i == (turns - 1) * steps:
            most = fastest = work = 0.0
            stops = False
        t = i * h
        if sign == 0:
            push = force * math.sin(frequency * (t + h)) - stiffness * x
            if abs(push) <= friction:
                stops = True
                continue
            sign = 1 if push > 0 else -1
        a = (force * math.sin(frequency * t) - stiffness * x - damping * v - sign * friction) / MASS
        xm, vm = x + h / 2 * v, v + h / 2 * a
        am = (force * math.sin(frequency * (t + h / 2)) - stiffness * xm - damping * vm - sign * friction) / MASS
        nx, nv = x + h * vm, v + h * am
        if sign * nv <= 0:
            # To the zero of the velocity, and from there on in the direction in which the load moves the body, if it does.
            part = v / (v - nv) if v != nv else 0.0
            nx, rest = x + part * h * v / 2, (1 - part) * h
            push = force * math.sin(frequency * (t + part * h)) - stiffness * nx
            work += friction * abs(nx - x)
            sign = 0 if abs(push) <= friction else (1 if push > 0 else -1)
            a = (push - sign * friction) / MASS if sign else 0.0
            x, v = nx + rest * rest * a / 2, rest * a
            most = max(most, nx)
            continue
        work += friction * abs(nx - x)
        x, v = nx, nv
        most, fastest = max(most, x), max(fastest, v)
    return most, fastest, work, stops


def test_a_machine_by_its_definitions():
    found = machine()
    near("python machine natural_angular_frequency", found.natural_angular_frequency, 5.0, "by hand", 1e-15)
    near("python machine natural_frequency", found.natural_frequency, 5.0 / (2 * math.pi), "by hand", 1e-15)
    near("python machine period", found.period, 2 * math.pi / 5.0, "by hand", 1e-15)
    near("python machine damping_ratio", found.damping_ratio, 0.05, "by hand", 1e-15)
    near("python machine damping", found.damping, 1.0, "by hand", 1e-15)
    near("python machine friction_displacement", found.friction_displacement, 0.06, "by hand", 1e-15)
    drive = ss.Drive(force=8.0, angular_frequency=3.0)
    near("python drive frequency", drive.frequency, 3.0 / (2 * math.pi), "by hand", 1e-15)


def test_answers_are_those_of_small_steps():
    drive = ss.Drive(force=8.0, angular_frequency=3.0)
    most, fastest, work, stops = cycle(8.0, 3.0)
    response, steady = machine().response(drive), machine().steady(drive)
    agreed("python response regime", response.regime, "sticking" if stops else "non-sticking", "small steps")
    near("python response max_displacement", response.max_displacement, most, "small steps", 1e-4)
    near("python response max_velocity", response.max_velocity, fastest, "small steps", 1e-4)
    near("python response energy_per_cycle", response.energy_per_cycle, work, "small steps", 1e-3)
    near("python steady max_displacement", steady.max_displacement, most, "small steps", 1e-4)
    # With stops.
    most, fastest, work, stops = cycle(4.5, 3.0)
    steady = machine().steady(ss.Drive(force=4.5, angular_frequency=3.0))
    agreed("python steady regime", steady.regime, "sticking" if stops else "non-sticking", "small steps")
    near("python steady max_displacement", steady.max_displacement, most, "small steps", 1e-3)
    near("python steady max_velocity", steady.max_velocity, fastest, "small steps", 1e-3)
    near("python steady energy_out", steady.energy_out, work, "small steps", 5e-3)


def test_designs_divide_small_steps():
    """On one side of an answer the motion of small steps stops, and on the other one it does not."""

    def stops(force=8.0, frequency=3.0, **changes):
        return cycle(force, frequency, steps=4000, turns=25, **changes)[3]

    sides = (0.99, 1.01)
    drive = ss.Drive(force=8.0, angular_frequency=3.0)
    least = machine().min_force(angular_frequency=3.0)
    agreed("python design min_force", [stops(force=by * least) for by in sides], [True, False], "small steps")
    greatest = machine().max_friction(drive)
    agreed("python design max_friction", [stops(friction=by * greatest) for by in sides], [False, True], "small steps")
    (band,) = machine().bands(angular_frequency=(1.0, 9.0), force=8.0)
    agreed("python design bands", [stops(frequency=by * band.low) for by in sides], [True, False], "small steps")
    agreed("python design bands", (band.high, band.high_is_end_of_range, band.low_is_end_of_range), (9.0, True, False), "by hand")
    best = machine().best_friction(drive)
    works = [cycle(8.0, 3.0, friction=by * best.friction)[2] for by in (0.8, 0.9, 1 - 1e-3)]
    near("python design best_friction", best.energy, works[2], "small steps", 5e-3)
    agreed("python design best_friction", works == sorted(works), True, "small steps")
    stiffest = machine().best_stiffness(drive, stiffness=(10.0, 80.0))
    beside = {by: cycle(8.0, 3.0, stiffness=by * stiffest.stiffness, damping=DAMPING) for by in (0.9, 0.98, 1.0, 1.02, 1.1)}
    near("python design best_stiffness", stiffest.energy, beside[1.0][2], "small steps", 5e-3)
    # No other one that does not stop dissipates more.
    most = max(work for _, _, work, stops in beside.values() if not stops)
    agreed("python design best_stiffness", most <= stiffest.energy * (1 + 2e-3), True, "small steps")
    for name, quantity, place in (("displacement", 0.25, 0), ("velocity", 0.7, 1)):
        force = getattr(machine(), f"force_for_{name}")(quantity, angular_frequency=3.0)
        near(f"python design force_for_{name}", quantity, cycle(force, 3.0)[place], "small steps", 1e-3)
    frequency = machine().hold(ss.Drive(base_acceleration=1.0, angular_frequency=3.0), angular=True)
    # Under a base the greatest force on a body at rest is m a at every frequency: 2 N of 3 N.
    agreed("python design hold", math.isinf(frequency), True, "by hand")
    up_to = machine().hold(ss.Drive(base_displacement=0.2, angular_frequency=3.0), angular=True)
    near("python design hold", up_to, math.sqrt(FRICTION / MASS / 0.2), "by hand", 1e-12)


def test_the_answers_to_a_record_and_its_mirror_image():
    """Newmark's sliding block on a slope that is steeper for one of both: by hand, under a pulse of constant acceleration."""
    a, r, t = 0.4 * 9.80665, 0.1 * 9.80665, 2.0
    record = ss.Record(np.full(5, -0.4), time_step=t / 4, unit="g")
    block = ss.Block(mass=2.0, friction_coefficient=0.1, units="N,m")
    both = block.polarities(record)
    due = a * (a - r) * t * t / (2 * r)
    near("python record polarities", both.recorded.residual_displacement, due, "by hand", 1e-12)
    near("python record polarities", both.mirrored.residual_displacement, -due, "by hand", 1e-12)
    compared("python record duration", record.duration, t, "by hand", 0.0)
    compared("python record peak", (record * 2).peak, 0.8, "by hand", 1e-15)
    agreed("python record times", list(record.times), [0.0, 0.5, 1.0, 1.5, 2.0], "by hand")


@pytest.mark.parametrize("kind", ["curve", "decay", "motion"])
def test_what_made_the_measurements_is_identified(kind):
    if kind == "curve":
        frequencies = np.array([2.0, 3.0, 4.0, 4.5, 5.0, 5.5, 6.0, 7.0])
        amplitudes = [cycle(8.0, w, turns=60)[0] for w in frequencies]
        found = ss.identify(2.0, 50.0, 8.0, angular_frequency=frequencies, amplitude=amplitudes)
        values = [("friction", found.friction, FRICTION, 5e-3), ("damping_ratio", found.damping_ratio, 0.05, 2e-2)]
    elif kind == "decay":
        # A half cycle of the damped oscillator about the edge of its places of rest: x ↦ −q x + (1 + q) B.
        q, height, turns = math.exp(-math.pi * 0.05 / math.sqrt(1 - 0.05**2)), 1.5, [1.5]
        while len(turns) < 6:
            height = q * height - (1 + q) * 0.06
            turns.append(height * (-1) ** len(turns))
        found = ss.identify_decay(turns, every="half-cycle")
        values = [("friction_displacement", found.friction_displacement, 0.06, 1e-9), ("damping_ratio", found.damping_ratio, 0.05, 1e-9)]
    else:
        times = np.arange(0, 12, 0.02)
        load = 6 * np.sin(4 * times) + 4 * np.sin(6.5 * times)
        places, fine = [], 200
        x = v = 0.0
        sign, h = 0, 0.02 / fine
        for i in range((len(times) - 1) * fine):
            if i % fine == 0:
                places.append(x)
            j, part = divmod(i, fine)
            p = load[j] + part / fine * (load[j + 1] - load[j])
            if sign == 0 and abs(p - STIFFNESS * x) <= FRICTION:
                continue
            sign = sign or (1 if p > STIFFNESS * x else -1)
            v += h * (p - STIFFNESS * x - DAMPING * v - sign * FRICTION) / MASS
            x += h * v
            if sign * v < 0:
                v, sign = 0.0, 0
        places.append(x)
        record = ss.Record(load, times=times, of="force", unit="N")
        found = ss.identify_motion(2.0, 50.0, record=record, displacement=places, units="N,m")
        values = [("friction", found.friction, FRICTION, 1e-2), ("damping_ratio", found.damping_ratio, 0.05, 3e-2)]
    for name, estimate, truth, part in values:
        near(f"python identify_{kind} {name}", estimate.value, truth, "small steps" if kind != "decay" else "by hand", part)
