"""Closed forms against values written out, and against what an array of any shape must not change."""

import math
import re
from typing import Any

import numpy as np
import pytest

import stickslip as ss


def test_a_point_has_the_values_of_the_formulae():
    # T = tan(pi/3) = sqrt(3), K = (1 - 9/4) sqrt(3)/1.5, so that max_displacement is sqrt(8/3).
    found = ss.response(omega=1.5, alpha=2.5)
    k = 1.25 * math.sqrt(3) / 1.5
    assert found.max_displacement == pytest.approx(math.sqrt(2.5**2 - k**2) / 1.25, rel=1e-15)
    assert found.loop_size_stiffness == pytest.approx(8 * found.max_displacement / 2.5**2, rel=1e-15)
    assert (found.regime, found.reversals_per_cycle) == ("non-sticking", 2)


def test_what_does_not_exist_is_nan():
    assert math.isnan(ss.response(0.4, 6).max_displacement)
    assert math.isnan(ss.response(1.0, 2.0).best_loop_size)
    machine = ss.Machine(mass=1.0, stiffness=1.0, friction=1.0)
    assert math.isnan(machine.response(ss.Drive(force=6.0, angular_frequency=0.4)).max_displacement)
    table = ss.response([0.4, 0.4, -1.0], [6.0, 7.0, 2.0])
    assert list(table.regime) == ["sticking", "non-sticking", "invalid"]
    assert list(np.isnan(table.max_displacement)) == [True, False, True]
    assert list(np.isnan(table.min_force_ratio)) == [False, False, True]


@pytest.mark.parametrize("zeta", [0.0, 0.03])
def test_arrays_of_any_shape_have_the_values_of_points(zeta):
    random = np.random.default_rng(1)
    omega = np.exp(random.uniform(-3, 3, (31, 1)))
    alpha = np.exp(random.uniform(0, 4, (1, 23)))
    names = ["regime", "margin", "reversals_per_cycle", "border_phase", "max_velocity", "best_loop_size"]
    table = ss.response(omega, alpha, zeta, outputs=names)
    assert table.omega.shape == table.max_velocity.shape == (31, 23)
    assert list(table) == ["omega", "alpha", "damping_ratio", "static_friction_ratio", *names]
    # Every other output is computed when it is read.
    np.testing.assert_array_equal(table.deviation, ss.response(omega, alpha, zeta).deviation)
    for i in range(31):
        for j in range(23):
            point = ss.response(omega[i, 0], alpha[0, j], zeta)
            for name in names:
                expected, got = getattr(point, name), getattr(table, name)[i, j]
                if expected != expected:
                    assert math.isnan(got), name
                else:
                    assert got == expected, (name, omega[i, 0], alpha[0, j])


def test_every_choice_of_outputs_is_the_same_numbers():
    random = np.random.default_rng(2)
    omega, alpha = np.exp(random.uniform(-2, 2, 700)), np.exp(random.uniform(0, 3, 700))
    whole = ss.response(omega, alpha)
    assert len(ss.OUTPUTS) > 25
    for name in ss.OUTPUTS:
        single = ss.response(omega, alpha, outputs=[name])
        np.testing.assert_array_equal(getattr(single, name), getattr(whole, name))
        assert list(single)[4:] == [name]


def test_strides_and_types_do_not_matter():
    omega = np.linspace(0.6, 3, 20)
    plain = ss.response(omega[::2].copy(), 3).max_displacement
    np.testing.assert_array_equal(ss.response(omega[::2], 3).max_displacement, plain)
    np.testing.assert_array_equal(ss.response(list(omega[::2]), np.int64(3)).max_displacement, plain)
    assert ss.response(np.empty((0, 3)), 3.0).max_displacement.shape == (0, 3)


def test_the_border_is_where_the_regime_changes():
    for omega in (0.22, 0.4, 0.7, 1.5, 30.0):
        least = ss.border(omega).min_force_ratio
        assert ss.response(omega, least * (1 + 1e-12)).regime == "non-sticking"
        assert ss.response(omega, least * (1 - 1e-12)).regime == "sticking"
    table = ss.border([[0.4, 0.7], [1.0, 2.0]])
    assert table.min_force_ratio[1, 0] == pytest.approx(4 / math.pi, rel=1e-15)
    assert ss.border(0.331).no_stop_force_ratios[0][1] == pytest.approx(155.36188887727886, rel=1e-13)


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ss.response(-1, 2), "omega = -1 must be > 0"),
        (lambda: ss.response(1, math.nan), "alpha = NaN must be finite"),
        (lambda: ss.response(1, 2, -0.1), "damping_ratio = -0.1 must be >= 0"),
        (lambda: ss.response([1], 2, outputs=["max_speed"]), "'max_speed' must be one of"),
        (lambda: ss.border(0), "omega = 0 must be > 0"),
    ],
)
def test_bad_input_is_refused_in_words(call, words):
    with pytest.raises(ss.Error, match=words):
        call()
    assert issubclass(ss.Error, ValueError)


def test_arrays_that_do_not_broadcast_are_refused():
    with pytest.raises(ValueError):
        ss.response(np.ones(3), np.ones(4))


def test_a_result_is_read_only_and_says_what_it_holds():
    found = ss.response(1.5, 2.5)
    assert repr(found).startswith("Response(omega=1.5, alpha=2.5,")
    assert found.to_dict()["contraction"] == found.contraction
    with pytest.raises(AttributeError):
        found.contraction = 1.0


def test_out_is_filled_and_returned() -> None:
    omega, alpha = np.linspace(0.2, 3.0, 6).reshape(2, 3), 2.5
    due = ss.response(omega, alpha)
    out = {name: np.full((2, 3), 7.0) for name in ("max_displacement", "min_force_ratio", "margin")}
    found = ss.response(omega, alpha, out=out)
    assert found.max_displacement is out["max_displacement"] and "contraction" not in found
    assert np.array_equal(out["max_displacement"], due.max_displacement, equal_nan=True)
    assert np.array_equal(out["min_force_ratio"], due.min_force_ratio)
    damped = ss.response(omega, alpha, 0.05, out=out)
    assert np.array_equal(damped.margin, ss.response(omega, alpha, 0.05, outputs=["margin"]).margin)


@pytest.mark.parametrize(
    ("out", "text"),
    [
        ({"regime": np.zeros(3)}, "'regime' must be one of"),
        ({"speed": np.zeros(3)}, "'speed' must be one of"),
        ({"margin": np.zeros(4)}, "float64 of shape (3,)"),
        ({"margin": np.zeros(3, dtype=np.float32)}, "float64 of shape (3,)"),
        ({"margin": np.zeros(6)[::2]}, "C-contiguous"),
    ],
)
def test_out_of_the_wrong_kind(out: dict[str, Any], text: str) -> None:
    with pytest.raises(ss.Error, match=re.escape(text)):
        ss.response(np.array([0.7, 1.0, 1.5]), 2.0, out=out)


def test_out_beside_others() -> None:
    room = np.zeros(3)
    with pytest.raises(ss.Error, match="outputs and bits must be left out"):
        ss.response(np.ones(3), 2.0, outputs=["margin"], out={"margin": room})
    with pytest.raises(ss.Error, match="single numbers"):
        ss.response(0.7, 2.0, out={"margin": room})
    with pytest.raises(ss.Error, match="overlap"):
        ss.response(np.ones(3), 2.0, out={"margin": room, "deviation": room})
