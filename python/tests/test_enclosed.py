"""Enclosures: what they contain, and how sharp they are."""

from decimal import Decimal

import pytest

import stickslip as ss
from stickslip import enclosed


def test_the_closed_forms_contain_what_more_bits_say():
    found = enclosed.response("0.4", 9, bits=64)
    wide = ss.response("0.4", 9, bits=256)
    assert (found.regime, found.bits >= 64) == ("non-sticking", True)
    for name in ("max_displacement", "max_velocity", "velocity_phase", "deviation", "min_force_ratio", "contraction"):
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


def test_a_steady_motion_is_proved():
    motion = enclosed.steady("0.4", 6, bits=128)
    assert motion is not None and motion.sticks_per_cycle == 2
    assert ss.steady("0.4", "6", bits=256).max_displacement in motion.max_displacement
    assert motion.max_displacement.rad < Decimal("1e-30") and motion.only_within > 1e-7
    with_both = enclosed.steady("0.6", "2.2", "0.05", "1.3")
    assert with_both is not None and with_both.sticks_per_cycle == 2
    assert enclosed.steady("0.5", 3) is None


def test_bad_input():
    with pytest.raises(ss.Error, match="omega = x"):
        enclosed.response("x", 2)
    with pytest.raises(ss.Error, match="must be > 0"):
        enclosed.border(-1)
    with pytest.raises(ss.Error, match="bits"):
        enclosed.border("0.4", bits=0)
    with pytest.raises(ss.Error, match="0.9 must be ≥ 1"):
        enclosed.steady("0.5", 3, 0, "0.9")
