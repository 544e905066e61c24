"""One body as a system: without a spring it drifts, beside the balance of impulses; under a cycle that repeats itself, by hand."""

import math

import numpy as np
import pytest

import stickslip as ss

G = 9.80665


def test_a_constant_force_makes_a_body_without_a_spring_drift():
    alpha, d = 3.0, 0.2
    # It slides forward for π(1 + d) of each cycle, and the reversals follow from 2α sin(θ + τ/2) sin(τ/2) = (1 − d) τ.
    forward = math.pi * (1 + d)
    start = math.asin((1 - d) * forward / (2 * alpha * math.sin(forward / 2))) - forward / 2
    if alpha * math.sin(start) + d <= 1:
        start = math.pi - forward - start

    def travelled(begin, time, push):
        return alpha * (math.cos(begin) * time - math.sin(begin + time) + math.sin(begin)) + push * time * time / 2

    drift = travelled(start, forward, d - 1) + travelled(start + forward, 2 * math.pi - forward, d + 1)
    body = ss.Machine(mass=2.0, stiffness=0.0, friction=4.0)
    for drive, machine in [
        (ss.Drive(force=4 * alpha, angular_frequency=3.0, mean_force=4 * d), body),
        (ss.Drive(base_acceleration=2 * alpha, angular_frequency=3.0, mean_force=4 * d), body),
        (
            ss.Drive(force=4 * alpha, angular_frequency=3.0),
            ss.Machine(mass=2.0, stiffness=0.0, friction=4 * (1 - d), friction_backward=4 * (1 + d)),
        ),
    ]:
        steady = machine.system(drive).steady()
        assert steady.kind == "periodic"
        assert steady.drift[0] == pytest.approx(drift * 4 / 18, rel=1e-10)
    with pytest.raises(ss.Error, match=r"Machine\.system\(drive\)\.steady\(\) answers with the drift"):
        body.steady(ss.Drive(force=12.0, angular_frequency=3.0, mean_force=1.0))


def test_a_cycle_that_repeats_itself():
    cycle = ss.Record([0.3, 0.3, -0.9, -0.9], times=[0, 0.06, 0.06, 0.08], unit="g")
    speed = 0.4 * G * 0.02
    drift = speed**2 / 2 * (1 / (0.4 * G) + 1 / (0.8 * G))
    part = ss.Block(mass="1 kg", friction_coefficient=0.5)
    assert part.system(cycle).steady().drift[0] == pytest.approx(drift, rel=1e-12)
    # On a spring the last of many cycles is the steady one.
    body = ss.Machine(mass=2.0, stiffness=9.0, friction=1.3, friction_backward=0.8, damping=0.7)
    samples, times = np.array([0, 3.0, 2.0, -3.5, -1.0, 0]), np.array([0, 0.4, 0.7, 1.1, 1.4, 1.6])
    many = ss.Record(
        np.concatenate([samples, *[samples[1:]] * 59]), times=np.concatenate([times, *[1.6 * i + times[1:] for i in range(1, 60)]]), of="force"
    )
    steady = body.system(ss.Record(samples, times=times, of="force")).steady()
    motion = body.motion(many, interval=0.001)
    last = (motion.time >= 59 * 1.6) & (motion.time <= 60 * 1.6)
    assert steady.max_displacement[0] == pytest.approx(motion.displacement[last].max(), abs=1e-8)
    assert steady.min_displacement[0] == pytest.approx(motion.displacement[last].min(), abs=1e-8)
    for wrong in ("force", 3.0):
        with pytest.raises((ss.Error, TypeError), match="must be a Drive or a Record"):
            body.system(wrong)


def test_a_response_curve_without_a_spring():
    w = np.linspace(3, 15, 12)
    amplitude = np.sqrt(81 - (1.5 * math.pi) ** 2) / (2 * w**2)
    found = ss.identify(2.0, 0.0, 9.0, angular_frequency=w, amplitude=amplitude)
    assert found.friction.value == pytest.approx(3.0, abs=1e-6)
    with pytest.raises(ss.Error):
        ss.identify(2.0, 0.0, angular_frequency=w, amplitude=amplitude)
