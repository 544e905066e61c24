"""Machines in units: an isolator, design, identification, and figures."""

import json
import math
import os
import pickle
import pydoc
import re
import subprocess

import numpy as np
import pytest

import stickslip as ss

HERTZ = 2 * math.pi


def isolator(friction_coefficient=0.05, **options):
    return ss.Machine(mass=800, period=2.2, friction_coefficient=friction_coefficient, **options)


def test_an_isolator_under_a_base_that_carries_the_surface():
    shaken = ss.Drive(base_acceleration=0.15 * 9.80665, angular_frequency=2 * HERTZ)
    stroke = isolator().response(shaken).max_displacement
    assert stroke == pytest.approx(8.39737e-3, rel=1e-6)
    # The same by the equation itself: m x'' + k x + r sgn x' = -m a sin(w t), small steps.
    machine, step = isolator(), 1e-5
    x = v = greatest = 0.0
    for i in range(3_000_000):
        t = i * step
        push = -machine.mass * 0.15 * 9.80665 * math.sin(2 * HERTZ * t) - machine.stiffness * x
        v += step * (push - math.copysign(machine.friction, v if v else push)) / machine.mass
        x += step * v
        if t > 28.0:
            greatest = max(greatest, x)
    assert stroke == pytest.approx(greatest, rel=2e-2)
    # Over the ground the body moves with the base less than with its spring alone; without a moving base there is no such answer.
    assert isolator().response(shaken).max_absolute_displacement < 0.15 * 9.80665 / (2 * HERTZ) ** 2 + stroke
    # The other reading, that of the spring's support, is another machine.
    foot = ss.Drive(foot_displacement=0.15 * 9.80665 / (2 * HERTZ) ** 2, angular_frequency=2 * HERTZ)
    assert isolator().response(foot).regime == "stuck"
    forced = isolator().response(ss.Drive(force=1200.0, angular_frequency=2 * HERTZ))
    assert math.isnan(forced.max_absolute_displacement) and math.isnan(forced.max_absolute_displacement)
    # Ratios alone name no drive.
    assert ss.response(4.4, 3.0).max_absolute_displacement > 0


def test_the_physical_values_have_their_units():
    machine = ss.Machine(mass=2.0, stiffness=8.0, friction=4.0)
    answer = machine.response(ss.Drive(force=12.0, angular_frequency=4.0))
    ratios = ss.response(2.0, 3.0)
    physical = answer
    assert (physical.angular_frequency, physical.force_amplitude) == (4.0, 12.0)
    assert physical.max_displacement == pytest.approx(0.5 * ratios.max_displacement, rel=1e-15)
    assert physical.max_velocity == pytest.approx(2.0 * ratios.max_velocity, rel=1e-15)
    assert physical.velocity_time == pytest.approx(0.25 * ratios.velocity_phase, rel=1e-15)
    assert physical.min_force == pytest.approx(4.0 * ratios.min_force_ratio, rel=1e-15)
    energy = 4 * 4.0 * physical.max_displacement
    assert physical.energy_per_cycle == pytest.approx(energy, rel=1e-14)
    assert physical.max_acceleration == pytest.approx(8.0 * ratios.max_acceleration, rel=1e-15)
    # The energy of the largest loop is that of the cycle at its own force.
    best = machine.response(ss.Drive(force=physical.best_force, angular_frequency=4.0))
    assert physical.best_force_energy == pytest.approx(best.energy_per_cycle, rel=1e-13)
    with pytest.raises(AttributeError, match="no value stroke"):
        physical.stroke


def test_steady_in_units_is_the_closed_form():
    machine = ss.Machine(mass=2.0, stiffness=8.0, friction=4.0)
    drive = ss.Drive(force=[12.0, 20.0], angular_frequency=4.0)
    exact, closed = machine.steady(drive), machine.response(drive)
    np.testing.assert_allclose(exact.max_displacement, closed.max_displacement, rtol=1e-13)
    np.testing.assert_allclose(exact.energy_out, closed.energy_per_cycle, rtol=1e-12)
    np.testing.assert_allclose(exact.max_velocity_time, closed.velocity_time, rtol=1e-12)


def test_design_answers_hold_on_both_sides():
    machine = isolator()
    frequency = 1.7 * HERTZ
    for excitation in ("force", "base_acceleration", "foot_displacement", "base_displacement"):
        least = machine.min_force(angular_frequency=frequency, excitation=excitation)
        regime = lambda share: machine.response(
            ss.Drive(**{excitation: least * share}, angular_frequency=frequency)
        ).regime
        assert (regime(1 + 1e-12), regime(1 - 1e-12)) == ("non-sticking", "sticking")
    drive = ss.Drive(force=900.0, angular_frequency=frequency)
    greatest = machine.max_friction(drive)
    assert machine.response(ss.Drive(force=900.0, angular_frequency=frequency)).force_amplitude == 900.0
    softer = ss.Machine(machine.mass, machine.stiffness, greatest * (1 - 1e-12))
    assert softer.response(drive).regime == "non-sticking"
    best = machine.best_friction(drive)
    at = lambda friction: ss.Machine(machine.mass, machine.stiffness, friction).response(drive)
    assert at(best.friction).energy_per_cycle == pytest.approx(best.energy, rel=1e-12)
    assert at(best.friction * 0.99).energy_per_cycle < best.energy
    force = machine.force_for_displacement(0.01, angular_frequency=frequency)
    assert machine.response(ss.Drive(force=force, angular_frequency=frequency)).max_displacement == pytest.approx(0.01)
    force = machine.force_for_velocity(0.12, angular_frequency=frequency)
    assert machine.response(ss.Drive(force=force, angular_frequency=frequency)).max_velocity == pytest.approx(0.12)


def test_bands_are_where_it_does_not_stick():
    bands = isolator().bands(angular_frequency=(0.2 * HERTZ, 5 * HERTZ), force=900.0)
    frequencies = np.linspace(0.2 * HERTZ, 5 * HERTZ, 501)
    regime = isolator().response(ss.Drive(force=900.0, angular_frequency=frequencies)).regime
    inside = np.any([(frequencies >= b.low) & (frequencies <= b.high) for b in bands], axis=0)
    assert bands and np.array_equal(inside, np.isin(regime, ["non-sticking", "unbounded"]))


def test_friction_and_damping_are_found_again():
    machine = isolator(damping_ratio=0.04)
    frequency = machine.natural_angular_frequency * np.linspace(0.75, 1.5, 30)
    exact = machine.response(ss.Drive(force=900.0, angular_frequency=frequency)).max_displacement
    noisy = exact * (1 + 0.01 * np.random.default_rng(4).standard_normal(30))
    found = ss.identify(machine.mass, machine.stiffness, 900.0, angular_frequency=frequency, amplitude=noisy)
    assert abs(found.friction.value - machine.friction) < 4 * found.friction.standard_error
    assert abs(found.damping_ratio.value - 0.04) < 4 * found.damping_ratio.standard_error
    assert 0.005 < found.noise < 0.02
    with pytest.raises(ss.Error, match="different lengths"):
        ss.identify(1.0, 1.0, 1.0, frequency=[1.0, 2.0], amplitude=[1.0])


def test_wrong_and_other_readings_are_told():
    machine = isolator(damping_ratio=0.04)
    frequency = machine.natural_angular_frequency * np.linspace(0.75, 1.5, 30)
    motion = machine.response(ss.Drive(force=900.0, angular_frequency=frequency))
    exact, phase = motion.max_displacement, motion.displacement_phase
    wrong = exact.copy()
    wrong[[4, 20]] *= 2.0
    found = ss.identify(machine.mass, machine.stiffness, 900.0, angular_frequency=frequency, amplitude=wrong, phase=phase)
    assert np.flatnonzero(found.suspect).tolist() == [4, 20] and found.phase_kind == "peak"
    assert found.friction.value == pytest.approx(machine.friction, rel=1e-6)
    assert np.abs(found.phase_residuals).max() < 1e-6 and not found.stops.any()
    both = ss.identify(machine.mass, machine.stiffness, 900.0, angular_frequency=frequency, amplitude=2 * exact)
    assert both.better_amplitude_kind == "peak-to-peak"
    with pytest.raises(ss.Error, match="amplitude_kind size: must be one of peak, peak-to-peak, rms"):
        ss.identify(machine.mass, machine.stiffness, 900.0, angular_frequency=frequency, amplitude=exact, amplitude_kind="size")
    with pytest.raises(ss.Error, match="measurement 1: phase"):
        ss.identify(machine.mass, machine.stiffness, 900.0, angular_frequency=frequency, amplitude=exact, phase=90 + 0 * exact)


def test_friction_by_direction_and_a_mean_force_are_a_shift():
    machine = ss.Machine(mass=2.0, stiffness=8.0, friction=5.0, friction_backward=3.0)
    answer = machine.response(ss.Drive(force=12.0, angular_frequency=4.0, mean_force=9.0))
    assert answer.alpha == 3.0 and answer.mean_displacement == 1.0
    motion = machine.simulate(ss.Drive(force=12.0, angular_frequency=4.0, mean_force=9.0), cycles=2, samples=16)
    sliding = motion.velocity != 0
    due = np.where(motion.velocity > 0, 5.0, -3.0)
    assert sliding.sum() > 20 and (motion.friction_force == due)[sliding].all()


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ss.Machine(-1, 2, 3), "mass -1.0: mass m = -1 must be > 0"),
        (lambda: ss.Machine(1, 2, 3, damping=math.nan), "damping nan: must be a finite number, and is NaN"),
        (lambda: ss.Drive(angular_frequency=1), "force .or unbalance, base_acceleration, .*, damped_foot_displacement. is missing"),
        (lambda: ss.Drive(angular_frequency=1, force=1, base_velocity=2), "force and base_velocity: give one of the two, because"),
        (lambda: ss.Machine(1, 2, 3, friction_backward=0), "friction_backward 0.0: backward friction r- = 0 must be > 0"),
        (lambda: ss.Machine(mass=1, period=0, friction=1), "period 0.0: natural period T = 0 must be > 0"),
        (lambda: ss.Machine(mass=1, period=1), "friction .or friction_coefficient. is missing"),
        (lambda: isolator().response(ss.Drive(force=1, angular_frequency=-1)), "angular_frequency -1.0: must be > 0"),
        (lambda: ss.figure("11"), "figure 11: must be one of"),
    ],
)
def test_bad_input_is_refused_in_words(call, words):
    with pytest.raises(ss.Error, match=words):
        call()


def test_a_motion_in_units_is_that_in_ratios_times_its_scales():
    machine = ss.Machine(mass="50 kg", stiffness="1 kN/mm", friction="5 kN", damping_ratio=0.02, static_friction="6 kN")
    drive = ss.Drive(force="12 kN", frequency="20 Hz", mean_force="2 kN")
    at = machine.response(drive)
    # B = 5 mm, and B w.
    rate = 2 * math.pi * 20
    start = (0.3, -1.6, 0.25)
    begin = {"phase": 0.3, "displacement": "-8 mm", "velocity": f"{0.25 * 0.005 * rate!r} m/s"}
    ratios = (at.omega, at.alpha, at.damping_ratio, at.static_friction_ratio)
    for samples in (None, 7):
        bare = ss.simulate(*ratios, start=start, cycles=2, samples=samples)
        found = machine.simulate(drive, **begin, cycles=2, samples=samples)
        scales = {"phase": 1 / rate, "duration": 1 / rate, "displacement": 0.005, "velocity": 0.005 * rate, "friction": 5e3}
        names = {"phase": "time", "friction": "friction_force"}
        assert not hasattr(bare, "ratios") and found.mean_displacement == pytest.approx(0.002)
        for name in bare:
            values, kind = getattr(bare, name), name.removeprefix("start_").removeprefix("end_")
            if kind not in scales:
                assert (getattr(found, name) == values).all()
                continue
            np.testing.assert_allclose(getattr(found.ratios, name), values, rtol=1e-12, atol=1e-12)
            physical = getattr(found, names.get(name, name.replace("_phase", "_time")))
            np.testing.assert_allclose(physical, values * scales[kind], rtol=1e-12, atol=1e-15)
        assert found.units["velocity" if samples else "start_velocity"] == "m/s"
    with pytest.raises(ss.Error, match="samples: must be given with arrays"):
        machine.simulate(ss.Drive(force=np.array([1.0, 2.0]), angular_frequency=1.0, units="N,m"))


def test_every_figure_is_drawn():
    assert "8" in ss.FIGURES
    drawn = ss.figure("8")
    assert drawn._repr_svg_().startswith("<svg") and drawn.title and drawn.caption


COMMAND = os.environ.get("STICKSLIP_COMMAND")


@pytest.mark.skipif(COMMAND is None, reason="STICKSLIP_COMMAND names the command")
@pytest.mark.parametrize("question, ask", [("response", ss.response), ("steady", ss.steady)])
def test_the_bits_are_those_of_the_command(question, ask):
    random = np.random.default_rng(6)
    n = 20_000 if question == "response" else 3_000
    omega, alpha = np.exp(random.uniform(-1.6, 2, n)), np.exp(random.uniform(-0.3, 3, n))
    rows = "omega,alpha\n" + "".join(f"{o!r},{a!r}\n" for o, a in zip(omega.tolist(), alpha.tolist()))
    run = [COMMAND, question, "--points", "-", "--format", "jsonl"]
    told = [json.loads(line) for line in subprocess.run(run, input=rows, capture_output=True, text=True, check=True).stdout.splitlines()]
    found = ask(omega, alpha) if question == "steady" else None
    for i, line in enumerate(told):
        point = ask(omega[i], alpha[i]) if found is None else None
        for name, value in line.items():
            if point is not None and value is None:
                assert np.isnan(getattr(point, name, np.nan)), (name, omega[i], alpha[i])
            elif point is not None:
                assert getattr(point, name, value) == value, (name, omega[i], alpha[i])
            elif value is not None and name in found:
                value = np.ravel(value).view(complex) if name == "multipliers" else value
                assert np.all(getattr(found, name)[i] == value), (name, omega[i], alpha[i])


def test_an_unbalance_is_a_force_that_grows_with_the_square_of_the_speed():
    frequency = HERTZ * np.array([5.0, 8.0, 12.0])
    turning = isolator().response(ss.Drive(unbalance=3.5, angular_frequency=frequency))
    for i, omega in enumerate(frequency):
        force = isolator().response(ss.Drive(force=3.5 * omega**2, angular_frequency=omega))
        assert turning.max_displacement[i] == pytest.approx(force.max_displacement, rel=1e-12)
    bands = isolator().bands(frequency=(1.0, 30.0), unbalance=2.0)
    assert len(bands) >= 1 and not bands[0].low_is_end_of_range
    pendulum = ss.Machine(mass="800 kg", pendulum_radius="2 m", friction="1 N")
    assert pendulum.natural_angular_frequency == pytest.approx(np.sqrt(9.80665 / 2), rel=1e-12)


def test_the_best_friction_over_a_band_is_better_than_others():
    machine = isolator(damping_ratio=0.05)
    drive = ss.Drive(base_displacement=0.05, frequency=1.0)
    low, high = 0.3 * machine.natural_angular_frequency, 4 * machine.natural_angular_frequency
    best = machine.best_friction_over(drive, angular_frequency=(low, high))
    assert best.at == [(pytest.approx(2 * math.pi * a), pytest.approx(2 * math.pi * b)) for a, b in
        machine.best_friction_over(drive, frequency=(low / 2 / math.pi, high / 2 / math.pi)).at]
    assert best.optimum == "interior" and len(best.at) == 2
    assert best.greatest == pytest.approx(0.05, rel=1e-9)
    with pytest.raises(ss.Error, match="of nothing"):
        machine.best_friction_over(drive, angular_frequency=(low, high), of="nothing")


def test_a_decay_gives_friction_and_damping():
    kappa = np.exp(-0.02 * np.pi / np.sqrt(1 - 0.02**2))
    turns = [40.0]
    for _ in range(8):
        turns.append(-np.sign(turns[-1]) * (kappa * (abs(turns[-1]) - 1.5) - 1.5))
    found = ss.identify_decay(turns, time=np.arange(9) * 0.25, every="half-cycle")
    assert found.friction_displacement.value == pytest.approx(1.5, rel=1e-6)
    assert found.damping_ratio.value == pytest.approx(0.02, rel=1e-6)
    assert found.natural_angular_frequency.value == pytest.approx(np.pi / 0.25 / np.sqrt(1 - 0.02**2), rel=1e-6)
    assert found.natural_frequency.value == pytest.approx(2.0 / np.sqrt(1 - 0.02**2), rel=1e-6)
    one_side = ss.identify_decay(turns[::2], every="cycle")
    assert one_side.friction_displacement.value == pytest.approx(1.5, rel=1e-6) and one_side.natural_frequency is None
    with pytest.raises(ss.Error, match="times of samples"):
        ss.identify_decay(turns)
    with pytest.raises(ss.Error, match="must be >= 4"):
        ss.identify_decay([3.0, 2.0, 1.0], every="cycle")
    with pytest.raises(ss.Error, match="every third"):
        ss.identify_decay(turns, every="third")


def test_transmissibility_with_stops_over_frequency_is_one_call():
    machine = ss.Machine(mass="800 kg", period="2.2 s", friction_coefficient=0.05, damping_ratio="5%")
    frequency = np.linspace(0.3, 3, 7)
    for kind in ("base_acceleration", "force"):
        amplitude = {"base_acceleration": "0.15 g", "force": "600 N"}[kind]
        found = machine.steady(ss.Drive(**{kind: amplitude, "frequency": frequency}), outputs=["transmissibility", "max_acceleration"])
        for i, hertz in enumerate(frequency):
            alone = machine.steady(ss.Drive(**{kind: amplitude, "frequency": float(hertz)}))
            assert found.transmissibility[i] == alone.transmissibility
            assert found.max_acceleration[i] == alone.max_acceleration
    assert "stick_fraction" not in found and found.stick_fraction.shape == (7,)
    with pytest.raises(ss.Error, match="'stroke' must be one of"):
        ss.steady([0.4], 2, outputs=["stroke"])


def test_the_natural_frequency_is_that_of_a_drive():
    machine = ss.Machine(mass=2.0, stiffness=800.0, friction=3.0)
    assert machine.natural_angular_frequency == 20.0
    found = machine.response(ss.Drive(force=9.0, frequency=machine.natural_frequency))
    assert found.omega == pytest.approx(1.0, rel=1e-15)


def test_results_are_values():
    one, two = ss.response(1.5, 2.5), ss.response(1.5, 2.5)
    assert one == two and one != ss.response(1.5, 2.6) and ss.response(0.4, 6) == ss.response(0.4, 6)
    assert one["max_displacement"] == one.max_displacement and dict(one)["margin"] == one.margin and len(one) > 20
    many = ss.response(np.linspace(0.6, 2, 100), 2.5)
    assert many == ss.response(np.linspace(0.6, 2, 100), 2.5) and "regime" in dir(many)
    assert len(repr(many)) < 60 * len(many) and "(100,)" in repr(many)
    with pytest.raises(KeyError, match="stroke"):
        one["stroke"]


#: The amplitude of each drive, and what it is multiplied by for a displacement of the support or the base.
DRIVES = {
    "force": 12.0,
    "unbalance": 0.4,
    "foot_displacement": 0.012,
    "damped_foot_displacement": 0.012,
    "base_displacement": 0.007,
    "base_velocity": 0.04,
    "base_acceleration": 0.25,
}


def sampled(drive: str, amplitude: float, periods: int = 60, steps: int = 20_000) -> tuple[float, float, float]:
    """Force on the support, transmissibility and work of the damper in the last period, by small steps in time."""
    m, k, c, r, w = 50.0, 1000.0, 30.0, 5.0, 6.0
    moved = amplitude / {"base_velocity": w, "base_acceleration": w * w}.get(drive, 1.0)
    dt = 2 * math.pi / w / steps
    x = v = force = acceleration = heat = 0.0
    for i in range(periods * steps):
        t = (i + 0.5) * dt
        sine, cosine = math.sin(w * t), math.cos(w * t)
        load = {"force": amplitude * sine, "unbalance": amplitude * w * w * sine}.get(drive, 0.0)
        foot = moved * sine if "foot" in drive else 0.0
        other = moved * w * cosine if "damped" in drive else 0.0
        base = -moved * w * w * sine if "base" in drive else 0.0
        free = v + dt * (load - k * (x - foot) - c * (v - other) - m * base) / m
        lost = r * dt / m
        after = free - max(-lost, min(lost, free))
        if i >= (periods - 1) * steps:
            rate = (after - v) / dt
            force = max(force, abs(m * (rate + base) - load))
            acceleration = max(acceleration, abs(rate))
            heat += c * ((v + after) / 2 - other) ** 2 * dt
        v = after
        x += dt * v
    p0 = m * moved * w * w if "base" in drive else amplitude * (w * w if drive == "unbalance" else 1.0)
    return force, acceleration / (moved * w * w) if "foot" in drive else force / p0, heat


@pytest.mark.parametrize("drive", DRIVES)
def test_forces_on_the_support_and_heat_are_those_of_small_steps(drive: str) -> None:
    machine = ss.Machine(mass=50.0, stiffness=1000.0, friction=5.0, damping=30.0)
    at = ss.Drive(angular_frequency=6.0, **{drive: DRIVES[drive]})
    force, ratio, heat = sampled(drive, DRIVES[drive], periods=25, steps=4000)
    for answer in (machine.response(at), machine.steady(at)):
        assert answer.transmitted_force == pytest.approx(force, rel=4e-3)
        assert answer.transmissibility == pytest.approx(ratio, rel=4e-3)
        assert answer.damper_energy_per_cycle == pytest.approx(heat, rel=4e-3)
        moves = "foot" in drive or "base" in drive
        assert math.isnan(answer.max_absolute_displacement) != moves
        assert math.isnan(answer.max_absolute_displacement) != moves


def test_a_body_at_rest_has_its_known_values() -> None:
    machine = ss.Machine(mass=50.0, stiffness=1000.0, friction=5.0)
    stuck = machine.steady(ss.Drive(base_acceleration=0.05, angular_frequency=6.0))
    assert (stuck.regime, stuck.max_velocity, stuck.stick_fraction, stuck.transmissibility) == ("stuck", 0.0, 1.0, 1.0)
    assert stuck.transmitted_force == pytest.approx(50.0 * 0.05)
    assert stuck.max_absolute_displacement == pytest.approx(0.05 / 36.0)
    assert (stuck.max_displacement, stuck.energy_out) == (0.0, 0.0)
    assert math.isnan(stuck.max_displacement_phase)


def test_a_body_without_friction_follows_records() -> None:
    machine = ss.Machine(mass=1.0, stiffness=100.0, friction=0.0, damping_ratio=0.05)
    assert (machine.friction, machine.damping) == (0.0, 1.0)
    # A step of the force of 1 N: x = (1 − e^{−ζωt}(cos ω't + ζ/√(1 − ζ²) sin ω't))/100, greatest at ω't = π.
    record = ss.Record([1.0] * 2001, time_step=0.001, of="force")
    greatest = (1 + math.exp(-0.05 * math.pi / math.sqrt(1 - 0.05**2))) / 100
    assert machine.follow(record).max_displacement == pytest.approx(greatest, rel=1e-9)
    with pytest.raises(ss.Error, match="friction force r_y = 0 must be > 0"):
        machine.bands(frequency=(1.0, 2.0), force=1.0)


@pytest.mark.parametrize("excitation", ss._drive.EXCITATIONS)
def test_a_body_without_friction_is_the_linear_oscillator(excitation):
    body = {"mass": 12.0, "stiffness": 3e4, "damping_ratio": 0.05}
    drive = ss.Drive(**{excitation: 3.0}, frequency=5.0)
    free = ss.Machine(**body, friction=0.0)
    w = drive.angular_frequency
    for found in (free.response(drive), free.steady(drive), ss.Machine(**body, friction=0.0, friction_backward=0.0).steady(drive)):
        impedance = abs(3e4 - 12.0 * w * w + 1j * w * free.damping)
        assert found.max_displacement == pytest.approx(found.force_amplitude / impedance, rel=1e-12) and found.regime == "non-sticking"
    # Beside bodies with friction, too; and a drive of 0 leaves each at rest.
    many = ss.Machine(**body, friction=[0.0, 2.0]).steady(drive)
    alone = [free.steady(drive), ss.Machine(**body, friction=2.0).steady(drive)]
    assert many.max_displacement.tolist() == pytest.approx([one.max_displacement for one in alone], rel=1e-13)
    still = drive.replace(**{excitation: 0.0})
    for machine in (free, ss.Machine(**body, friction=2.0)):
        assert machine.steady(still).regime == "stuck" and machine.steady(still).max_displacement == 0.0


def test_no_friction_needs_no_force():
    bodies = ss.Machine(mass=2.0, stiffness=800.0, friction=[0.0, 4.0], damping_ratio=0.02)
    drive = ss.Drive(force=5.0, frequency=1.0)
    assert bodies.min_force(frequency=1.0)[0] == 0.0 < bodies.min_force(frequency=1.0)[1]
    assert bodies.replace(friction=0.0).min_force(frequency=1.0) == 0.0
    # These do not depend on the friction that the machine has.
    assert np.ptp(bodies.max_friction(drive)) <= 1e-14 * bodies.max_friction(drive)[1]
    assert np.ptp(bodies.best_friction(drive).friction) <= 1e-12
    # A linear body: p₀ = X |k − mω² + icω|, ω X of a velocity.
    w = 2 * np.pi
    stiff = abs(800.0 - 2.0 * w**2 + 1j * w * 2 * 0.02 * np.sqrt(1600.0))
    assert bodies.force_for_displacement(0.01, frequency=1.0)[0] == pytest.approx(0.01 * stiff, rel=1e-12)
    assert bodies.force_for_velocity(0.01, frequency=1.0)[0] == pytest.approx(0.01 / w * stiff, rel=1e-12)


@pytest.mark.parametrize("of", ["force", "base_acceleration", "foot_displacement"])
def test_friction_and_damping_of_a_motion(of):
    pd = pytest.importorskip("pandas")
    machine = ss.Machine(mass="2 t", stiffness="800 kN/m", friction="3 kN", damping_ratio="3 %", units="kN,mm")
    time = np.arange(0, 2, 0.02)
    size = {"force": ("kN", 9.0), "base_acceleration": ("g", 0.45), "foot_displacement": ("mm", 11.0)}[of]
    record = ss.Record(size[1] * np.sin(15 * time) + 0.5 * size[1] * np.sin(23 * time), time_step=0.02, of=of, unit=size[0])
    motion = machine.motion(record)
    measured = np.interp(time, motion.time, motion.displacement) + 4.0
    known = ss.identify_motion("2 t", "800 kN/m", record=record, displacement=measured, units="kN,mm")
    found = ss.identify_motion("2 t", record=record, displacement=pd.Series(measured, index=pd.Index(time, name="time")), units="kN,mm")
    assert known.stiffness is None and known.start_velocity is None
    for one in (known, found):
        for estimate, truth in ((one.friction, 3.0), (one.damping_ratio, 0.03), (one.friction_displacement, 3.75), (one.offset, 4.0)):
            assert estimate.value == pytest.approx(truth, rel=1e-6)
            assert estimate.interval[0] <= truth * (1 + 1e-6) and estimate.interval[1] >= truth * (1 - 1e-6)
    assert found.stiffness.value == pytest.approx(0.8, rel=1e-7)
    assert isinstance(found.residuals, pd.Series) and np.abs(found.residuals).max() < 1e-5
    for wrong, said in (
        (measured[1:], "must have 100 values"),
        (np.where(time > 1, np.nan, measured), "must have a number"),
        (pd.Series(measured, index=pd.Index(time + 1, name="time")), "labels must be the times"),
    ):
        with pytest.raises(ss.Error, match=said):
            ss.identify_motion("2 t", record=record, displacement=wrong, units="kN,mm")
    with pytest.raises(ss.Error, match="has no unit"):
        ss.identify_motion("2 t", record=record, displacement=measured)


def test_help_has_what_is_new_and_nothing_of_dict_or_tuple():
    for of in (ss.Response, ss.MachineSteady, ss.Motion, ss.Estimate):
        text = pydoc.plain(pydoc.render_doc(of))
        assert not re.search(r"popitem|setdefault|__contains__|__ror__|sizeof", text)
        assert len(text.splitlines()) < 130
    assert "max_displacement" in pydoc.plain(pydoc.render_doc(ss.Response))
    assert "max_displacement" in dir(ss.response(0.5, 4.0))
    assert len(pydoc.plain(pydoc.render_doc(ss)).splitlines()) < 4500
    estimate = ss.Estimate(1.0, 0.1, (0.8, 1.2))
    assert pickle.loads(pickle.dumps(estimate)) == estimate and estimate._replace(value=2.0).value == 2.0


def test_a_body_without_a_spring():
    """The limits for high frequencies: an amplitude of sqrt(alpha**2 - pi**2/4), a threshold of sqrt(1 + pi**2/4)."""
    machine = ss.Machine(mass=2.0, stiffness=0, friction=4.0)
    drive = ss.Drive(force=12.0, angular_frequency=3.0)
    found = machine.response(drive)
    assert found.max_displacement == pytest.approx(math.sqrt(9 - math.pi**2 / 4) * 2 / 9, rel=1e-14)
    assert found.min_force == pytest.approx(4 * math.hypot(1, math.pi / 2), rel=1e-14)
    assert math.isnan(found.max_spring_force) and machine.stiffness == 0
    assert machine.steady(drive).max_displacement == pytest.approx(found.max_displacement, rel=1e-13)
    many = ss.Machine(mass=2.0, stiffness=[0.0, 1e-9, 8.0], friction=4.0).response(drive)
    assert many.max_displacement[0] == pytest.approx(many.max_displacement[1], rel=1e-9)
    assert np.isnan(many.max_spring_force).tolist() == [True, False, False]
    for body, load in (
        ({"friction_backward": 5.0}, {}),
        ({}, {"mean_force": 1.0}),
    ):
        with pytest.raises(ss.Error, match="the body drifts"):
            ss.Machine(mass=2.0, stiffness=0, friction=4.0, **body).response(ss.Drive(force=12.0, angular_frequency=3.0, **load))
