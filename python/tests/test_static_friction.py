"""A static friction above the kinetic one, against an independent simulation, whose values are written out."""

import numpy as np
import pytest

import stickslip as ss


@pytest.mark.parametrize(
    "point, greatest, stops, share",
    [
        ((0.3, 4.0, 0.1, 1.0), 3.3398818, 2, 0.408975651),
        ((0.8, 1.5, 0.05, 1.25), 2.1458525899, 0, 0.0),
    ],
)
def test_the_limit_from_rest(point, greatest, stops, share):
    found = ss.steady(*point)
    assert found.max_displacement == pytest.approx(greatest, abs=1e-8)
    assert (found.sticks_per_cycle, found.static_friction_ratio) == (stops, point[3])
    assert found.stick_fraction == pytest.approx(share, abs=1e-8)


def test_arrays_are_points_and_broadcast():
    omega, eta = np.linspace(0.3, 1.5, 40), np.array([[1.0], [1.3], [2.5]])
    table = ss.steady(omega, 4.0, 0.02, eta)
    closed = ss.response(omega, 4.0, 0.02, eta, outputs=["regime", "margin", "max_velocity", "reversals_per_cycle"])
    assert table.max_displacement.shape == closed.margin.shape == (3, 40)
    assert table.turns_per_cycle.max() > 1 or (table.symmetric == 0).any()
    for i in range(3):
        for j in range(40):
            point = (omega[j], 4.0, 0.02, eta[i, 0])
            alone, answer = ss.steady(*point), ss.response(*point)
            for name in ("max_displacement", "turns_per_cycle", "limit", "lyapunov_exponent", "symmetric"):
                value, got = getattr(alone, name), getattr(table, name)[i, j]
                assert got == value or (value is None and got == -1) or (value != value and np.isnan(got)), (name, point)
            for name in ("regime", "margin", "max_velocity", "reversals_per_cycle"):
                value, got = getattr(answer, name), getattr(closed, name)[i, j]
                assert got == value or (value != value and np.isnan(got)), (name, point)


def test_it_raises_the_border_and_leaves_the_cycle():
    plain, held = ss.response(1.5, 4.0), ss.response(1.5, 4.0, 0.0, 1.3)
    assert held.min_force_ratio > plain.min_force_ratio
    assert held.max_displacement == plain.max_displacement
    least = ss.border(1.5, 0.05, 1.3).min_force_ratio
    above, below = ss.response(1.5, least * (1 + 1e-12), 0.05, 1.3), ss.response(1.5, least * (1 - 1e-12), 0.05, 1.3)
    assert (above.motion_without_stop, below.motion_without_stop) == (True, False)
    assert (above.regime, below.regime) == ("depends-on-start", "depends-on-start" if least < 1.3 else "sticking")
    assert ss.border(0.331, static_friction_ratio=1.3).no_stop_force_ratios is None


def test_three_statements():
    """From rest nothing moves up to alpha = 2.07, though the cycle without a stop exists from 1.302564 on."""
    for alpha in (1.31, 1.7, 2.06):
        found = ss.response(1.036, alpha, 0.0, 2.07)
        assert (found.regime, found.motion_without_stop, found.moves_from_rest) == ("depends-on-start", True, False)
        assert ss.steady(1.036, alpha, 0.0, 2.07).regime == "stuck"
    table = ss.response(1.036, [1.0, 1.2, 1.31, 2.08], 0.0, 2.07, outputs=["regime", "motion_without_stop", "moves_from_rest"])
    assert list(table.regime) == ["stuck", "depends-on-start", "depends-on-start", "depends-on-start"]
    assert list(table.motion_without_stop) == [0, 0, 1, 1] and list(table.moves_from_rest) == [0, 0, 0, 1]
    # Six reversals without a stop beside the pole 1/3.
    six = ss.response(0.331, 100, 0.0005, 1.01)
    assert (six.regime, six.reversals_per_cycle, six.moves_from_rest) == ("depends-on-start", 6, True)


def test_several_limits():
    found = ss.attractors(0.573, 3.92, 0.005, 1.87, starts=60, reach=10)
    seen = sorted((a.max_displacement, a.min_displacement, a.symmetric) for a in found.attractors)
    due = [(5.496536, -6.22143, False), (5.77082, -5.77082, True), (6.22143, -5.496536, False)]
    assert np.allclose(seen, due, atol=1e-6)
    assert sum(a.starts for a in found.attractors) == 60 and found.unsettled == 0
    assert [np.sum(found.of_start == a.attractor) for a in found.attractors] == [a.starts for a in found.attractors]
    # The limit of a start is the one that steady finds from it.
    starts = [(0.0, 0.0, 0.0), (0.0, 6.0, -3.0), (0.7, -2.0, 5.0)]
    few = ss.attractors(0.573, 3.92, 0.005, 1.87, starts=starts)
    assert np.isnan(few.reach)
    for start, place in zip(starts, few.of_start):
        alone = ss.steady(0.573, 3.92, 0.005, 1.87, start=start)
        assert few.attractors[place].max_displacement == pytest.approx(alone.max_displacement, abs=1e-9)


def test_an_irregular_motion():
    found = ss.steady(0.47, 7.44, 0.023, 2.48)
    assert found.limit == "irregular" and np.isnan(found.turns_per_cycle) and np.isnan(found.symmetric)
    assert np.isnan(found.multipliers).all() and found.multipliers.shape == (2,)
    assert 9.9 < found.max_displacement < 10.2 and -9.5 < found.min_displacement < -9.2
    assert abs(found.lyapunov_exponent) < 0.01 and found.lyapunov_exponent_error > 0 and found.turns_observed > 1000


def test_the_motion_itself():
    limit = ss.steady(0.45, 5.0, 0.02, 1.4)
    # On the limit from the start: it is approached slowly.
    start = (limit.max_displacement_phase, limit.max_displacement, 0.0)
    samples = ss.simulate(0.45, 5.0, 0.02, 1.4, start=start, cycles=3, samples=2000)
    phases = ss.simulate(0.45, 5.0, 0.02, 1.4, start=start, cycles=3)
    assert 1.2 < np.abs(samples.friction).max() <= 1.4
    assert "stick" in phases.kind
    assert samples.displacement.max() == pytest.approx(limit.max_displacement, rel=1e-12)
    assert samples.displacement[-2000:].max() == pytest.approx(limit.max_displacement, abs=1e-5)


def test_free_vibration():
    # Without a drive each half cycle takes 2 B, until it is within the static friction.
    assert ss.decay(10.0, static_friction_ratio=3.0).rest_position == 2.0
    assert ss.decay(9.0, static_friction_ratio=3.0).half_cycles == 3
    assert np.isnan(ss.decay(3.0, damping_ratio=1.5).rest_time)
    machine = ss.Machine(mass=2.0, stiffness=8.0, friction=4.0, static_friction=6.0)
    found = machine.decay(5.0, 0.0)
    assert found.rest_position == pytest.approx(0.5 * ss.decay(10.0, static_friction_ratio=1.5).rest_position)
    assert found.rest_time == pytest.approx(found.ratios.rest_time / 2)


def test_machines_and_design():
    machine = ss.Machine(mass=2.0, stiffness=8.0, friction=4.0, damping_ratio=0.02, static_friction_ratio=1.3)
    assert machine == ss.Machine(mass=2.0, stiffness=8.0, friction=4.0, damping_ratio=0.02, static_friction=5.2)
    drive = ss.Drive(force=16.0, angular_frequency=[1.0, 1.2])
    found = machine.steady(drive)
    assert found.multipliers.shape == (2, 2) and found.multipliers.dtype == complex
    np.testing.assert_allclose(found.ratios.max_displacement, ss.steady(drive.angular_frequency / 2, 4, 0.02, 1.3).max_displacement, rtol=1e-12)
    least = machine.min_force(angular_frequency=3.0)
    found = lambda share: machine.response(ss.Drive(force=least * share, angular_frequency=3.0))
    assert (found(1 + 1e-12).motion_without_stop, found(1 - 1e-12).motion_without_stop) == (True, False)
    assert len(machine.attractors(ss.Drive(force=16.0, angular_frequency=1.0), starts=40).attractors) == 2
    with pytest.raises(ss.Error, match="static friction"):
        machine.best_friction(ss.Drive(force=16.0, angular_frequency=3.0))


def test_any_precision():
    pytest.importorskip("stickslip_mp._native", reason="the extra mp")
    six = ss.response("0.331", 100, "0.0005", "1.01", bits=100)
    assert (six.regime, six.reversals_per_cycle, six.motion_without_stop) == ("depends-on-start", 6, True)
    wide = ss.steady("0.45", 5, "0.02", "1.4", bits=128)
    # By small steps of the equation, 2000 turns.
    assert float(wide.max_displacement) == pytest.approx(6.1366513, abs=1e-7)
    assert (wide.turns_per_cycle, wide.symmetric) == (1, True)
    assert str(ss.border("0.4", static_friction_ratio="1.5", bits=100).min_force_ratio).startswith("8.15019171553651245")


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ss.response(1.5, 2, 0, 0.5), "static_friction_ratio = 0.5 must be >= 1"),
        (lambda: ss.steady(1.5, 2, 0, float("nan")), "static_friction_ratio = NaN must be finite"),
        (lambda: ss.Machine(1, 2, 3, static_friction=1), "static_friction_ratio = 0.333"),
        (lambda: ss.Machine(1, 2, 3, static_friction=4, static_friction_ratio=2), "give one of the two"),
        (lambda: ss.attractors(0.5, 4, starts=0), "starts = 0 must be >= 1"),
        (lambda: ss.attractors(0.5, 4, starts=[]), "give one or more"),
        (lambda: ss.attractors(0.5, 4, reach=-1), "reach = -1 must be > 0"),
        (lambda: ss.attractors(0.5, 4, starts=[(0, 0)]), "start = \\(0, 0\\): must be"),
        (lambda: ss.attractors([0.5, 1], 4), "omega: must be one number"),
    ],
)
def test_bad_input_is_refused_in_words(call, words):
    with pytest.raises(ss.Error, match=words):
        call()
    assert list(ss.response([1.5], 2, 0, [0.5]).regime) == ["invalid"]
