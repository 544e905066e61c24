"""What people give: arrays of every kind, results that are copied, processes and threads."""

import copy
import multiprocessing
import os
import pickle
import subprocess
import sys
import threading

import numpy as np
import pytest

import stickslip as ss

OMEGA = np.array([0.4, 0.7, 1.5, 2.0])


def plain(name="max_displacement"):
    return getattr(ss.response(OMEGA, 2.5), name)


def test_masked_places_have_no_answer():
    masked = np.ma.masked_array(OMEGA, [False, True, False, False])
    found = ss.response(masked, 2.5)
    assert found.regime.data.tolist() == ["sticking", "invalid", "non-sticking", "non-sticking"]
    assert ss.steady(masked, 2.5).limit.data[1] == "invalid"
    # The mask is that of the arguments: places without a displacement are NaN, and not masked.
    assert isinstance(found.max_displacement, np.ma.MaskedArray)
    assert found.max_displacement.mask.tolist() == [False, True, False, False] and np.isnan(found.max_displacement.data[0])


def test_numbers_of_other_types():
    thirds = np.array([0.4, 0.75, 1.5], dtype=np.float32)
    np.testing.assert_array_equal(
        ss.response(thirds, 2.5).max_displacement, ss.response(thirds.astype(float), 2.5).max_displacement
    )
    assert ss.response(np.array(1.5), np.float32(2.5)).max_displacement == ss.response(1.5, 2.5).max_displacement
    assert isinstance(ss.response(np.array(1.5), 2.5).max_displacement, float)
    assert ss.response(np.array([2], dtype=np.uint8), 3).max_displacement[0] == ss.response(2, 3).max_displacement
    assert ss.response(np.array([1.5, 2.0], dtype=object), 3).max_displacement.shape == (2,)
    for array in (OMEGA[::-1], np.asfortranarray(np.tile(OMEGA, (3, 1))), OMEGA.astype(">f8")):
        expected = np.broadcast_to(plain() if array.ndim == 2 else plain()[:: 1 if array is not None and array[0] == 0.4 else -1], array.shape)
        np.testing.assert_array_equal(ss.response(array, 2.5).max_displacement, expected)


def test_series_of_pandas():
    pandas = pytest.importorskip("pandas")
    frame = pandas.DataFrame({"omega": OMEGA, "alpha": 2.5})
    np.testing.assert_array_equal(ss.response(frame.omega, frame.alpha).max_displacement, plain())
    gaps = pandas.Series([0.7, None], dtype="Float64")
    assert list(ss.response(gaps, 2.5).regime) == ["non-sticking", "invalid"]


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ss.response(np.ones(3), np.ones(4)), "do not broadcast: omega \\(3,\\), alpha \\(4,\\)"),
        (lambda: ss.response(1 + 2j, 2), "omega: must be numbers, not of type complex128"),
        (lambda: ss.response([1j], 2), "omega: must be numbers"),
        (lambda: ss.response("fast", 2), "omega: must be numbers, not 'fast'"),
        (lambda: ss.response(["fast"], 2), "omega: must be numbers"),
        (lambda: ss.response(None, 2), "omega: must be numbers"),
        (lambda: ss.response(np.array(["2020-01-01"], dtype="M8[D]"), 2), "omega: must be numbers"),
        (lambda: ss.steady(0.4, 6, start=(0, 0)), "must be \\(phase, displacement, velocity\\)"),
        (lambda: ss.steady(0.4, 6, start=3), "must be \\(phase, displacement, velocity\\)"),
        (lambda: ss.simulate([0.4], 6), "samples: must be given with arrays"),
        (lambda: ss.decay("far"), "displacement"),
    ],
)
def test_what_is_no_number_is_refused_in_words(call, words):
    with pytest.raises(ss.Error, match=words):
        call()


def test_out_must_not_be_an_input():
    omega = OMEGA.copy()
    with pytest.raises(ss.Error, match="must not overlap omega"):
        ss.response(omega, 2.5, out={"margin": omega})
    closed = np.zeros(4)
    closed.flags.writeable = False
    with pytest.raises(ss.Error, match="writeable"):
        ss.response(omega, 2.5, out={"margin": closed})
    assert list(omega) == list(OMEGA)


def test_a_result_does_not_reach_into_what_was_given():
    omega = OMEGA.copy()
    found = ss.response(omega, 2.5)
    with pytest.raises(ValueError):
        found.omega[0] = 7.0
    assert omega[0] == 0.4


@pytest.mark.parametrize(
    "make",
    [
        lambda: ss.response(OMEGA, 2.5),
        lambda: ss.steady(0.4, 6),
        lambda: ss.steady(OMEGA, 6),
        lambda: ss.Machine("2 kg", "800 N/m", "3 N").response(ss.Drive(force="9 N", frequency="3 Hz")),
        lambda: ss.attractors(0.5, 4, 0.02, 1.3, starts=5),
        lambda: ss.Machine(1, 2, 3),
        lambda: ss.Drive(force=[1, 2], frequency=3),
        lambda: ss.simulate(0.4, 6),
    ],
)
def test_results_are_copied_and_sent(make):
    found = make()
    for other in (pickle.loads(pickle.dumps(found)), copy.copy(found), copy.deepcopy(found)):
        assert repr(other) == repr(found) and type(other) is type(found)


def test_high_precision_without_the_extra_says_what_to_install(monkeypatch):
    monkeypatch.setitem(sys.modules, "stickslip_mp._native", None)
    for call in (lambda: ss.response("0.7", 2, bits=100), lambda: ss.steady("0.7", 2, bits=100), lambda: ss.enclosed.border("0.4")):
        with pytest.raises(ss.Error, match=r"pip install stickslip\[mp\]") as caught:
            call()
        assert isinstance(caught.value, ImportError)


def test_errors_are_sent():
    with pytest.raises(ss.Error) as caught:
        ss.response(-1, 2)
    error = pickle.loads(pickle.dumps(caught.value))
    assert type(error) is ss.Error and str(error) == str(caught.value)


def test_one_omega_and_one_alpha_are_the_same_bits():
    random = np.random.default_rng(5)
    alpha = np.exp(random.uniform(0, 4, 20_000))
    for omega in (0.2, 0.4, 0.7, 1.0, 1.5, 300.0, 1e7, -1.0):
        row, points = ss.response(omega, alpha), ss.response(np.full(alpha.size, omega), alpha)
        for name in ("max_displacement", "velocity_phase", "min_force_ratio", "contraction"):
            np.testing.assert_array_equal(getattr(row, name), getattr(points, name))
        np.testing.assert_array_equal(row.regime, points.regime)
    omega = np.exp(random.uniform(-2, 2, 20_000))
    np.testing.assert_array_equal(ss.response(omega, 3).deviation, ss.response(omega, np.full(omega.size, 3.0)).deviation)


def test_large_arrays_are_the_points():
    random = np.random.default_rng(9)
    n = 300_001
    omega, alpha = np.exp(random.uniform(-2, 2, n)), np.exp(random.uniform(0, 4, n))
    whole = ss.response(omega, alpha)
    for part in (slice(0, 4000), slice(8190, 8194), slice(n - 5, n)):
        piece = ss.response(omega[part], alpha[part])
        np.testing.assert_array_equal(whole.max_velocity[part], piece.max_velocity)
        np.testing.assert_array_equal(whole.regime[part], piece.regime)


def test_threads_beside_each_other():
    found, expected = {}, ss.steady(np.linspace(0.3, 2, 3000), 5).max_displacement

    def work(number):
        found[number] = ss.steady(np.linspace(0.3, 2, 3000), 5).max_displacement

    threads = [threading.Thread(target=work, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(found[number], expected) for number in range(4))


FORKED = """
import multiprocessing, numpy as np, stickslip as ss
def work(n):
    return ss.response(np.linspace(0.6, 2, n), 3.0).max_displacement.sum(), ss.steady(np.linspace(0.6, 2, 100), 3.0).periods.sum()
if __name__ == "__main__":
    due = work(50_000)
    with multiprocessing.get_context("{way}").Pool(2) as pool:
        assert pool.map(work, [50_000] * 4) == [due] * 4
    print("done")
"""


@pytest.mark.parametrize("way", [way for way in ("fork", "spawn") if way in multiprocessing.get_all_start_methods()])
def test_processes_after_threads_were_used(way, tmp_path):
    script = tmp_path / "forked.py"
    script.write_text(FORKED.format(way=way))
    run = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=60)
    assert run.stdout == "done\n", run.stderr


#: Questions of each way to work: on all threads, and on one beside the interpreter.
WORK = """
import os, resource, sys, threading, numpy as np, stickslip as ss
RECORD = ss.Record(np.sin(np.arange(200) * 0.2), time_step=0.05)
MACHINE = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0)
SYSTEM = ss.System(
    masses={"m": 2.0}, springs=[{"between": ["ground", "m"], "stiffness": 300.0}],
    contacts=[{"name": "c", "between": ["ground", "m"], "friction": 1.0}], forces=[{"on": "m", "amplitude": 5.0, "frequency": 2}],
)
def work():
    drive = ss.Drive(force=[9.0, 12.0], frequency=3.0)
    return [
        ss.response(np.linspace(0.6, 2, 50_000), 3.0).max_displacement.sum(), ss.steady(np.linspace(0.6, 2, 100), 3.0).periods.sum(),
        MACHINE.max_friction(drive).tolist(), ss.spectrum(RECORD, period=[1.0, 2.0], friction_coefficient=0.05).path.tolist(),
        MACHINE.follow(RECORD).path, SYSTEM.steady().max_displacement.tolist(), SYSTEM.curve([1, 2])["c.rest_fraction"].tolist(),
        len(ss.attractors(0.5, 4.0, starts=20).attractors),
    ]
"""
#: In a process whose memory has no place for the stack of one more thread of Rust, of 1 GiB.
WITHOUT_THREADS = """
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + 2**29,) * 2)
"""
EACH = """
found, before = [], os.listdir("/proc/self/task")
if len(sys.argv) > 1:
    found.append(work())
    assert os.listdir("/proc/self/task") == before, "a thread was started"
others = [threading.Thread(target=lambda: found.append(work())) for _ in range(2)]
for thread in others:
    thread.start()
for thread in others:
    thread.join()
assert found == [found[0]] * len(found)
print(found[0])
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="limits and /proc are those of Linux")
def test_work_without_threads_runs_on_the_calling_one():
    environment = {**os.environ, "RUST_MIN_STACK": str(2**30)}

    def printed(*lines):
        run = subprocess.run([sys.executable, "-c", *lines], capture_output=True, text=True, timeout=120, env=environment)
        assert run.returncode == 0, run.stderr
        return run.stdout

    assert printed(WORK + WITHOUT_THREADS + EACH, "alone") == printed(WORK + EACH)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="limits and /proc are those of Linux")
def test_the_number_of_threads_is_limited():
    count = """
work()
print(len(os.listdir("/proc/self/task")))
"""
    most = 8 * (os.cpu_count() or 1)
    environment = {**os.environ, "RAYON_NUM_THREADS": str(most + 200), "OPENBLAS_NUM_THREADS": "1"}
    run = subprocess.run([sys.executable, "-c", WORK + count], capture_output=True, text=True, timeout=120, env=environment)
    assert run.returncode == 0, run.stderr
    # Beside those of the interpreter and of NumPy.
    assert int(run.stdout) <= most + 100


@pytest.mark.parametrize(
    "call",
    [
        lambda: ss.response(-1, 2),
        lambda: ss.response(1, 2, -0.1),
        lambda: ss.response(1, 2, 0, 0.5),
        lambda: ss.Machine("3 stone", "1 N/m", "1 N"),
        lambda: ss.Machine("1 kg", "1 N/m", "1 N", damping="-2 N*s/m"),
        lambda: ss.Record([1.0], time_step=1.0),
        lambda: ss.steady(1e-9, 2),
        lambda: ss.Machine(1, 2, 3, friction_coefficient=-1),
        lambda: ss.Block(1, 1, slope=2.0),
    ],
)
def test_errors_print_on_any_stream(call):
    with pytest.raises(ss.Error) as caught:
        call()
    str(caught.value).encode("ascii")


def test_texts_in_arrays_are_refused_with_the_way_out():
    for friction in (["5 N", "6 N"], np.array(["5 N", "6 N"]), np.array(["5 N", 6.0], dtype=object)):
        with pytest.raises(TypeError, match=r'friction: .* arrays are bare numbers. Pass floats, and their units as units="kN,m"'):
            ss.Machine(mass=1.0, stiffness=10.0, friction=friction)


def test_a_record_is_no_array():
    record = ss.Record([0.0, 0.3, 0.0], time_step=0.5, unit="g")
    with pytest.raises(TypeError, match="Take record.samples"):
        np.asarray(record)
    with pytest.raises(ss.Error, match="Take record.samples"):
        ss.Machine(mass=1.0, stiffness=10.0, friction=record)


def test_a_spectrum_takes_percentages():
    record = ss.Record(np.sin(np.arange(100) * 0.2), time_step=0.05)
    due = ss.spectrum(record, period=[1.0, 2.0], friction_coefficient=0.05, damping_ratio=0.02)
    found = ss.spectrum(record, period=[1.0, 2.0], friction_coefficient="5%", damping_ratio="2 %", static_friction_ratio="100%")
    assert found.max_displacement.tolist() == due.max_displacement.tolist()
    assert ss.spectrum(record, period=1.0, friction_coefficient="5%").friction_coefficient == 0.05
    for text in ("5 N", "much"):
        with pytest.raises(ss.Error, match="friction_coefficient"):
            ss.spectrum(record, period=1.0, friction_coefficient=text)


def test_help_says_what_a_transmitted_force_leaves_out():
    assert "without the mean force" in ss.MachineSteady.transmitted_force.__doc__
    machine = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0)
    pulled, free = (machine.steady(ss.Drive(force=9.0, frequency=3.0, mean_force=mean)) for mean in (1.0, 0.0))
    assert pulled.transmitted_force == pytest.approx(free.transmitted_force, rel=1e-12)


def test_a_free_vibration_without_friction_is_refused():
    with pytest.raises(ss.Error, match="friction = 0: must be > 0"):
        ss.Machine(mass=2.0, stiffness=800.0, friction=0.0).decay(1.0)
