"""The exact motion, against an integration by hand, against the closed forms, and interrupted."""

import math
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import stickslip as ss


def stepped(omega, alpha, cycles, per_cycle=40_000):
    """The motion from rest by small steps of the equation itself, velocity Verlet with a stick test."""
    step = 2 * math.pi / per_cycle
    x = v = 0.0
    greatest, stuck = 0.0, 0
    for i in range(cycles * per_cycle):
        force = alpha * math.sin(i * step) - x
        if v == 0.0 and abs(force) <= 1.0:
            stuck += i >= (cycles - 1) * per_cycle
            continue
        side = math.copysign(1.0, v if v != 0.0 else force)
        faster = v + step * (force - side) / omega**2
        if v != 0.0 and faster * v < 0.0:
            faster = 0.0
        v = faster
        x += step * v
        if i >= (cycles - 1) * per_cycle:
            greatest = max(greatest, x)
    return greatest, stuck / per_cycle


@pytest.mark.parametrize("omega, alpha", [(0.4, 6.0), (0.7, 1.2)])
def test_a_limit_with_stops_is_that_of_small_steps(omega, alpha):
    found = ss.steady(omega, alpha)
    greatest, stuck = stepped(omega, alpha, 12 if omega == 0.7 else 60)
    assert found.regime == "sticking" and found.limit == "periodic"
    assert found.max_displacement == pytest.approx(greatest, rel=2e-3)
    assert found.stick_fraction == pytest.approx(stuck, abs=5e-3)
    assert found.energy_in == pytest.approx(found.energy_out, rel=1e-12)


def test_without_stops_it_is_the_closed_form():
    omega, alpha = np.array([0.7, 1.5, 3.0]), 3.0
    closed, exact = ss.response(omega, alpha), ss.steady(omega, alpha)
    np.testing.assert_allclose(exact.max_displacement, closed.max_displacement, rtol=1e-13)
    np.testing.assert_allclose(exact.max_velocity, closed.max_velocity, rtol=1e-13)
    np.testing.assert_allclose(exact.contraction, closed.contraction**2, rtol=1e-9)
    assert list(exact.velocity_zeros_per_cycle) == [2, 2, 2]


def test_arrays_are_points():
    random = np.random.default_rng(3)
    omega, alpha = np.exp(random.uniform(-1.5, 1.5, 300)), np.exp(random.uniform(-0.2, 2, 300))
    table = ss.steady(omega, alpha)
    for i in range(300):
        point = ss.steady(omega[i], alpha[i])
        for name in ("regime", "limit", "max_displacement", "min_velocity", "sticks_per_cycle", "periods", "rest_position"):
            expected, got = getattr(point, name), getattr(table, name)[i]
            if expected != expected:
                assert math.isnan(got), name
            else:
                assert got == expected, (name, omega[i], alpha[i])
    assert ss.steady([-1.0, 0.7], 2.0).limit[0] == "invalid"


def test_the_start_matters_at_a_family_and_nowhere_else():
    near, far = ss.steady(0.5, 8.0), ss.steady(0.5, 8.0, start=(0.0, 3.0, 0.2))
    assert near.limit == far.limit == "family"
    assert near.max_displacement != pytest.approx(far.max_displacement, rel=1e-3)
    same = ss.steady(0.4, 6.0, start=(1.0, -2.0, 5.0))
    assert same.max_displacement == pytest.approx(ss.steady(0.4, 6.0).max_displacement, rel=1e-12)


def test_samples_lie_on_the_phases():
    phases = ss.simulate(0.4, 6.0, cycles=3)
    samples = ss.simulate(0.4, 6.0, cycles=3, samples=500)
    assert samples.phase.size == 1501
    np.testing.assert_allclose(samples.phase, 2 * np.pi / 500 * np.arange(1501), rtol=1e-15)
    assert np.all(np.abs(samples.friction) <= 1.0)
    np.testing.assert_array_equal(phases.start_phase[1:], phases.end_phase[:-1])
    for start, end, kind in zip(phases.start_phase, phases.end_phase, phases.kind):
        within = (samples.phase > start) & (samples.phase < end)
        moving = samples.velocity[within]
        assert np.all(moving == 0 if kind == "stick" else moving * (1 if kind == "slide-forward" else -1) > 0)


def test_free_vibration_ends_where_friction_holds():
    found = ss.decay(12, 6)
    assert found.rest_position == pytest.approx(15 - math.sqrt(205), rel=1e-13)
    assert ss.decay(0.5).half_cycles == 0


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ss.steady(1e-9, 2), "omega = 1e-9 must be"),
        (lambda: ss.steady(0.4, 6, max_periods=0), "max_periods = 0 must be >= 1"),
        (lambda: ss.steady([0.4], 6, start=(0.0, math.inf, 0.0)), "must be finite"),
        (lambda: ss.simulate(0.4, 6, cycles=-1), "cycles = -1 must be > 0"),
        (lambda: ss.simulate(0.4, 6, samples=0), "samples = 0 must be >= 1"),
        (lambda: ss.decay(math.nan), "must be finite"),
    ],
)
def test_bad_input_is_refused_in_words(call, words):
    with pytest.raises(ss.Error, match=words):
        call()


@pytest.mark.parametrize(
    "work",
    [
        "ss.steady(np.full(10**7, 1e-4), 50.0)",
        "ss.steady(1e-6, 1e9)",
        "ss.steady(np.linspace(0.2, 1.6, 2000), np.linspace(1.02, 5, 2000)[:, None], 0.02, outputs=['transmissibility'])",
        "ss.steady(1e-6, 1e6).transmissibility",
        "ss.response(np.linspace(0.2, 3, 10**6), 3.0, 0.05, outputs=ss.OUTPUTS)",
        "ss.attractors(0.573, 3.92, 0.005, 1.87, starts=10**6)",
        "ss.spectrum(ss.Record(np.sin(np.arange(4000.0)), time_step=0.01), period=np.linspace(0.2, 4, 10**5), friction_coefficient=0.05)",
        "ss.spectrum(ss.Record(np.sin(np.arange(6e6)), time_step=0.01), period=[0.5, 1.0], friction_coefficient=0.05)",
        "ss.Machine(1, 9, 1, damping_ratio=0.05).best_friction_over(ss.Drive(base_displacement=9, frequency=1), frequency=(0.05, 5))",
        "ss.simulate(0.4, 6.0, cycles=1e8)",
        "ss.simulate(0.4, 6.0, cycles=1e5, samples=1000)",
    ],
)
def test_ctrl_c_is_heard(work):
    # A shell that runs tests in the background has its children ignore the signal.
    hear = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
    code = f"""{hear}
import time, stickslip as ss, numpy as np
print('ready', flush=True)
try:
    while True: {work}
except KeyboardInterrupt:
    print(time.time(), flush=True)
    raise
"""
    run = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        assert run.stdout.readline() == "ready\n"
        time.sleep(0.3)
        sent = time.time()
        run.send_signal(signal.SIGINT)
        heard, words = run.communicate(timeout=20)
    finally:
        run.kill()
    # A thread waits for as many others as there are for each processor.
    load = os.getloadavg()[0] / (os.cpu_count() or 1) if hasattr(os, "getloadavg") else 4.0
    assert float(heard) - sent < 0.3 * (1 + load), work
    assert run.returncode != 0 and words.rstrip().endswith("KeyboardInterrupt")


def test_friction_and_damper_take_what_the_drive_gives():
    alone = ss.steady(0.8, 3, 0.1)
    assert alone.damper_work > 0
    assert alone.energy_in == pytest.approx(alone.energy_out + alone.damper_work, rel=1e-12)
    several = ss.steady([0.8, 0.4], 3, 0.1)
    assert several.damper_work[0] == alone.damper_work
    machine = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0, damping_ratio=0.1)
    physical = machine.steady(ss.Drive(force=9.0, angular_frequency=16.0))
    assert physical.energy_in == pytest.approx(physical.energy_out + physical.damper_energy_per_cycle, rel=1e-12)


MEMORY = """
import resource, sys, numpy as np, stickslip as ss
peak = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)
ss.steady([0.4, 0.7], 6)
before = peak()
{work}
ratios = getattr(getattr(found, "_ratios", None), "_values", {{}})
values = [getattr(value, "places", value) for value in (*found._values.values(), *ratios.values())]
values = [value for value in values if isinstance(value, np.ndarray)]
size = sum(value.nbytes for value in values if value.flags.writeable)
print((peak() - before) / size, size)
"""


@pytest.mark.parametrize(
    "work",
    [
        "found = ss.steady(np.linspace(0.3, 2, 1000), np.linspace(1.1, 6, 1000)[:, None])",
        "found = ss.response(np.linspace(0.3, 2, 10**6), 3.0)",
        "found = ss.response(np.linspace(0.3, 2, 3000), np.linspace(1.1, 6, 3000)[:, None], outputs=['margin'])",
        "found = ss.spectrum(ss.Record([0, 1.0, 0], time_step=0.1), period=np.linspace(0.3, 2, 500_000), friction_coefficient=0.05)",
        "drive = ss.Drive(force=9.0, frequency=np.linspace(1, 9, 10**6)); found = ss.Machine(2, 800, 3).steady(drive); found.max_velocity",
    ],
)
def test_a_result_takes_little_more_memory_than_its_values(work):
    pytest.importorskip("resource", reason="the measure of memory is that of Unix")
    run = subprocess.run([sys.executable, "-c", MEMORY.format(work=work)], capture_output=True, text=True, check=True)
    share, size = map(float, run.stdout.split())
    assert share < 2.2 and size > 5e7, run.stdout
