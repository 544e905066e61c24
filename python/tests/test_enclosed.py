"""Enclosures: what they contain, and how sharp they are."""

import copy
import pickle
from decimal import Decimal

import pytest

import stickslip as ss
from stickslip import enclosed

pytest.importorskip("stickslip_mp._native", reason="the extra mp")


def test_the_closed_forms_contain_what_more_bits_say():
    found = enclosed.response("0.4", 9, bits=64)
    wide = ss.response("0.4", 9, bits=256)
    assert (found.regime, found.bits >= 64) == ("non-sticking", True)
    names = ("max_displacement", "max_velocity", "velocity_phase", "deviation", "min_force_ratio")
    for name in (*names, "contraction"):
        enclosure = getattr(found, name)
        assert getattr(wide, name) in enclosure, name
        assert 0 < enclosure.rad < Decimal("1e-17"), name
    assert wide.max_absolute_displacement in found.max_absolute_displacement
    # A third is a third, and a float is the number that it is.
    assert enclosed.border("2/3").min_force_ratio.mid != enclosed.border(2 / 3).min_force_ratio.mid


def test_the_border_and_what_is_undecided():
    border = enclosed.border("0.4", bits=128).min_force_ratio
    assert ss.border("0.4", bits=256).min_force_ratio in border
    assert border.rad < Decimal("1e-37")
    assert float(border.mid) + 1e-9 not in border
    # On the border to the last digit nothing is decided.
    assert enclosed.response("0.5", 3).regime is None
    assert enclosed.response("0.5", "2.9").regime == "below the border"
    damped = enclosed.response("0.7", 3, "0.05", "1.2", bits=96)
    wide = ss.response("0.7", "3", damping_ratio="0.05", static_friction_ratio="1.2", bits=256)
    assert wide.max_displacement in damped.max_displacement
    assert enclosed.border("0.7", "0.05", "1.2").min_force_ratio.mid > enclosed.border("0.7").min_force_ratio.mid


def test_a_steady_motion_is_proved():
    motion = enclosed.steady("0.4", 6, bits=128)
    assert isinstance(motion, enclosed.Steady) and motion.sticks_per_cycle == 2
    assert ss.steady("0.4", "6", bits=256).max_displacement in motion.max_displacement
    assert motion.max_displacement.rad < Decimal("1e-30") and motion.only_within > 1e-7
    with_both = enclosed.steady("0.6", "2.2", "0.05", "1.3")
    assert isinstance(with_both, enclosed.Steady) and with_both.sticks_per_cycle == 2
    pair = enclosed.steady("0.5", 4, "0.02", "1.3")
    assert isinstance(pair, enclosed.Steady) and not pair.symmetric and pair.turns_per_cycle == 1
    wide = ss.steady("0.5", "4", damping_ratio="0.02", static_friction_ratio="1.3", bits=256)
    assert wide.min_displacement in pair.min_displacement
    unproved = enclosed.steady("0.7", "0.9")
    assert isinstance(unproved, enclosed.Unproved) and not unproved
    assert "does not become periodic" in unproved.reason


def test_results_are_copied_and_sent():
    found = enclosed.border("0.4")
    for other in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
        assert other == found and repr(other) == repr(found)
    assert enclosed.border("0.4").max_displacement is None and "min_force_ratio" in found


def test_bad_input():
    with pytest.raises(ss.Error, match="omega = x"):
        enclosed.response("x", 2)
    with pytest.raises(ss.Error, match="must be > 0"):
        enclosed.border(-1)
    with pytest.raises(ss.Error, match="bits"):
        enclosed.border("0.4", bits=0)
    with pytest.raises(ss.Error, match="0.9 must be >= 1"):
        enclosed.steady("0.5", 3, 0, "0.9")


def test_the_motion_under_a_record_is_enclosed():
    import numpy as np

    # A pulse of 4 m/s² for 2 s and a yield acceleration of 1 m/s²: a(a − r)t²/(2r) = 24 m.
    block = ss.Block(mass=3.0, friction=3.0, units="N,m")
    pulse = ss.Record([-4.0, -4.0], time_step=2.0)
    found = enclosed.follow(block, pulse)
    assert 24 in found.residual_displacement and found.residual_displacement.rad < 1e-17
    assert 25 not in found.residual_displacement and (found.slides, found.stops) == (1, 1)
    assert found.units["residual_displacement"] == "m"
    # Answers of 64-bit floats differ from the enclosures by their rounding.
    machine = ss.Machine("2 kg", "800 N/m", "3 N", damping_ratio=0.03, units="N,mm")
    record = ss.Record(0.4 * np.sin(np.arange(80) * 0.35), time_step="20 ms", unit="g")
    exact, floats = enclosed.follow(machine, record, displacement="1 mm"), machine.follow(record, displacement="1 mm")
    compared = 0
    for name, value in exact.items():
        if isinstance(value, enclosed.Enclosure):
            assert float(value.mid) == pytest.approx(floats[name], rel=1e-10, abs=1e-10), name
            compared += 1
        elif value is not None:
            assert value == floats[name], name
            compared += 1
    assert compared > 18
    with pytest.raises(ss.Error, match="uncertain|bound|undecided|certain"):
        enclosed.follow(ss.Block(mass=1.0, friction=1.0), ss.Record([0.0, 1.0, 1.0], time_step=1.0))
