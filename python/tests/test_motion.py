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


#: The greatest memory of a process. On Linux the measure of `resource` begins with that of the process that started it.
PEAK = """
import pathlib, resource, sys
def peak():
    status = pathlib.Path("/proc/self/status")
    if status.exists():
        return 1024 * int(status.read_text().partition("VmHWM:")[2].split()[0])
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * (1 if sys.platform == "darwin" else 1024)
"""

MEMORY = PEAK + """
import numpy as np, stickslip as ss
ss.steady([0.4, 0.7], 6)
before = peak()
{work}
ratios = getattr(getattr(found, "_ratios", None), "_values", {{}})
values = [getattr(value, "places", value) for value in (*found._values.values(), *ratios.values())]
values = [value for value in values if isinstance(value, np.ndarray)]
size = sum(value.nbytes for value in values if value.flags.writeable)
print((peak() - before) / size, size)
"""


def test_many_points_are_computed_when_they_are_read():
    omega = np.linspace(0.3, 2, 200_000)
    found, few = ss.response(omega, 3.0), ss.response(omega[:1000], 3.0)
    assert set(found._values) == set(few._values) - set(ss.OUTPUTS) and "regime" in few._values
    np.testing.assert_array_equal(found.max_displacement[:1000], few.max_displacement)
    assert set(found._values) & set(ss.OUTPUTS) == {"max_displacement"}
    machine = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0)
    many = machine.response(ss.Drive(force=9.0, frequency=np.linspace(1, 9, 200_000)))
    assert not set(many.ratios._values) & set(ss.OUTPUTS)
    assert many.max_velocity.shape == (200_000,) and set(many.ratios._values) & set(ss.OUTPUTS) == {"max_velocity"}
    # A table has all of them, and computes what is missing at once.
    assert set(dict(found.items())) == set(found)
    much = ss.steady(np.full(1 << 20, 1.5), 2.5)
    assert not set(much._values) & set(ss.STEADY_OUTPUTS) and np.ptp(much.max_displacement) == 0.0
    assert much.max_displacement[0] == ss.steady(1.5, 2.5).max_displacement


@pytest.mark.parametrize(
    "work",
    [
        "found = ss.steady(np.linspace(0.3, 2, 1000), np.linspace(1.1, 6, 1000)[:, None])",
        "found = ss.response(np.linspace(0.3, 2, 10**6), 3.0, outputs=ss.OUTPUTS[:10])",
        "found = ss.response(np.linspace(0.3, 2, 3000), np.linspace(1.1, 6, 3000)[:, None], outputs=['margin'])",
        "found = ss.spectrum(ss.Record([0, 1.0, 0], time_step=0.1), period=np.linspace(0.3, 2, 500_000), friction_coefficient=0.05)",
        "drive = ss.Drive(force=9.0, frequency=np.linspace(1, 9, 10**6)); found = ss.Machine(2, 800, 3).steady(drive); found.max_velocity",
    ],
)
def test_a_result_takes_little_more_memory_than_its_values(work):
    pytest.importorskip("resource", reason="the measure of memory is that of Unix")
    run = subprocess.run([sys.executable, "-c", MEMORY.format(work=work)], capture_output=True, text=True, check=True)
    share, size = map(float, run.stdout.split())
    assert 0.5 < share < 2.2 and size > 5e7, run.stdout


COLUMNS = PEAK + """
import numpy as np, stickslip as ss
n, random = 2_000_000, np.random.default_rng(1)
machine, drive = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0), ss.Drive(force=9.0, frequency=3.0)
machine.replace(mass=[1.0, 2.0]).response(drive).max_displacement
mass, friction = random.uniform(1, 2, n), random.uniform(2, 3, n)
before = peak()
{work}
print((peak() - before) / (8 * n))
"""


@pytest.mark.parametrize(
    ("work", "most"),
    [
        # The draws, the values of the bodies, the ratios, and an output in ratios and in units.
        ("ss.Machine(mass=mass, stiffness=800.0, friction=friction).response(drive).max_displacement", 10),
        # The draws and the output, and copies of a column on the way.
        ("ss.monte_carlo(machine, drive, {'mass': 0.1, 'friction': 0.1}, draws=n, seed=1, exact=False).interval('max_displacement')", 7),
    ],
)
def test_millions_of_machines_take_the_memory_of_few_columns(work, most):
    pytest.importorskip("resource", reason="the measure of memory is that of Unix")
    run = subprocess.run([sys.executable, "-c", COLUMNS.format(work=work)], capture_output=True, text=True, check=True)
    assert 1 < float(run.stdout) < most, run.stdout


def test_free_vibrations_of_many_machines_are_those_of_each():
    x, ratio = np.array([12.0, 20.0, 0.5]), np.array([[0.0], [0.05]])
    found = ss.decay(x, 6.0, ratio)
    for row in range(2):
        for column in range(3):
            alone = ss.decay(x[column], 6.0, ratio[row, 0])
            assert {name: found[name][row, column] for name in alone} == dict(alone)
    outside = ss.decay([12.0, np.nan, 5.0], 0.0, [0.0, 0.0, -1.0])
    assert np.isnan(outside.path).tolist() == [False, True, True] and np.isnan(outside.half_cycles).tolist() == [False, True, True]
    many = ss.Machine(mass=[50.0, 60.0, 1.0], stiffness=1000.0, friction=[5.0, 4.0, 0.0], damping_ratio=0.02, static_friction_ratio=1.2)
    found = many.decay(0.1, [0.0, 1.0, 0.0])
    for place, v in enumerate([0.0, 1.0]):
        alone = ss.Machine(mass=float(many.mass[place]), stiffness=1000.0, friction=float(many.friction[place]), damping_ratio=0.02, static_friction_ratio=1.2).decay(0.1, v)
        assert {name: found[name][place] for name in alone} == pytest.approx(dict(alone), rel=1e-15)
    assert np.isnan(found.rest_time[2]) and found.ratios.path.shape == (3,)
    pandas = pytest.importorskip("pandas")
    labelled = ss.decay(pandas.Series({"a": 12.0, "b": 20.0}))
    assert labelled.to_frame().loc["b", "path"] == ss.decay(20.0).path and labelled.half_cycles["a"] == ss.decay(12.0).half_cycles


def test_motions_of_many_machines_are_those_of_each():
    many = ss.Machine(mass=[50.0, 60.0], stiffness=1000.0, friction=5.0)
    drive = ss.Drive(force=np.array([[12.0], [9.0], [20.0]]), frequency=1.0)
    found = many.simulate(drive, phase=0.3, displacement=0.02, cycles=2, samples=7)
    assert found.displacement.shape == (3, 2, 15) and found.time.shape == (3, 2, 15) and found.phase.shape == (15,)
    for row in range(3):
        for column in range(2):
            one = ss.Machine(mass=float(many.mass[column]), stiffness=1000.0, friction=5.0)
            alone = one.simulate(ss.Drive(force=float(drive.amplitude[row, 0]), frequency=1.0), phase=0.3, displacement=0.02, cycles=2, samples=7)
            for name in ("displacement", "velocity", "friction_force", "time"):
                np.testing.assert_allclose(found[name][row, column], alone[name], rtol=1e-15)
            assert found.phase.tolist() == alone.phase.tolist()
    assert ss.simulate([0.4, -1.0], 6, samples=4).displacement[0].tolist() == ss.simulate(0.4, 6, samples=4).displacement.tolist()
    assert np.isnan(ss.simulate([0.4, -1.0], 6, samples=4).displacement[1]).all()
    xarray = pytest.importorskip("xarray")
    omega = xarray.DataArray([0.4, 0.7], dims="speed", coords={"speed": ["slow", "fast"]})
    data = ss.simulate(omega, 6, samples=4).to_xarray()
    assert data["displacement"].dims == ("speed", "phase") and data["velocity"].attrs["units"] == "B ω_d"
    assert data["displacement"].sel(speed="fast").values.tolist() == ss.simulate(0.7, 6, samples=4).displacement.tolist()
    plain = ss.simulate([0.4, 0.7], 6, samples=4)
    assert plain.to_xarray()["friction"].dims == ("dim_0", "phase") and len(plain.to_frame()) == 10
    with pytest.raises(ss.Error, match="samples: must be given with arrays"):
        ss.simulate([0.4, 0.7], 6)
    with pytest.raises(ss.Error, match="must be one number with arrays"):
        ss.simulate([0.4, 0.7], 6, start=([0.0, 1.0], 0.0, 0.0), samples=4)
    pytest.importorskip("matplotlib").use("Agg")
    assert len(plain.plot("velocity").lines) == 2


def test_help_names_the_unit_of_each_value():
    assert ss.Response.max_displacement.__doc__.endswith("(B)") and ss.Samples.velocity.__doc__ == "Velocity (B ω_d)"
    assert ss.Followed.path.__doc__ == "Length of the way to rest (length)" and ss.MachineSamples.time.__doc__ == "Time (time)"
    assert ss.Decay.rest_time.__doc__ == "Time until rest (√(m/k))"


def test_what_is_printed_is_plain():
    system = ss.System(masses={f"m{i}": 1.0 for i in range(9)}, springs=[{"between": ["ground", f"m{i}"], "stiffness": 1.0} for i in range(9)])
    for shown in (ss.steady(0.4, 6), system, system.simulate(0.1), system.states([0.0]), ss.steady([0.4], 6)):
        assert repr(shown).isascii()
