"""Answers at many bits: digits in and out without a loss."""

from decimal import Decimal, localcontext

import pytest

import stickslip as ss

mpmath = pytest.importorskip("mpmath")
pytest.importorskip("stickslip_mp._native", reason="the extra mp")


def test_the_displacement_of_the_formula_at_300_bits():
    with mpmath.workprec(400):
        omega, alpha = mpmath.mpf("0.7"), mpmath.mpf(2)
        k = (1 - omega**2) * mpmath.tan(mpmath.pi / (2 * omega)) / omega
        expected = mpmath.sqrt(alpha**2 - k**2) / (1 - omega**2)
        for first, second in (("0.7", "2"), (Decimal("0.7"), 2), ("0.7", mpmath.mpf(2))):
            found = ss.response(first, second, bits=300)
            assert abs(mpmath.mpf(str(found.max_displacement)) / expected - 1) < mpmath.mpf(2) ** -299
            assert found.regime == "non-sticking" and found.omega == Decimal("0.7")


def test_a_float_is_the_binary_number_that_it_is():
    binary, decimal = ss.border(0.7, bits=200), ss.border("0.7", bits=200)
    assert binary.omega == Decimal(0.7) != decimal.omega
    assert 0 < abs(binary.min_force_ratio - decimal.min_force_ratio) < Decimal("1e-15")
    assert float(binary.min_force_ratio) == pytest.approx(ss.border(0.7).min_force_ratio, rel=1e-15)


def test_numbers_of_mpmath_keep_their_bits():
    with mpmath.workprec(500):
        omega = mpmath.mpf(2) / 3
        found = ss.response(omega, -mpmath.mpf(-5), bits=500)
        with localcontext() as context:
            context.prec = 400
            assert abs(found.omega * 3 - 2) < Decimal(2) ** -498
        assert found.alpha == 5


def test_a_limit_with_stops_at_200_bits():
    wide, narrow = ss.steady("0.4", "6", bits=200), ss.steady(0.4, 6)
    assert (wide.regime, wide.sticks_per_cycle, wide.limit) == ("sticking", 2, "periodic")
    assert float(wide.max_displacement) == pytest.approx(narrow.max_displacement, rel=1e-14)
    assert abs(wide.energy_in - wide.energy_out) < Decimal("1e-55")
    assert abs(wide.max_displacement + wide.min_displacement) < Decimal("1e-55")


def test_every_output_is_there_and_nan_where_it_does_not_exist():
    """As for numbers of 64 bits, which the digits round to."""
    for ask, point, names in ((ss.response, ("0.4", 6), ss.OUTPUTS), (ss.steady, ("0.4", 6), ss.STEADY_OUTPUTS), (ss.steady, ("0.7", "0.5"), ss.STEADY_OUTPUTS)):
        wide, narrow = ask(*point, bits=100), ask(*map(float, point))
        for name in set(names) - {"periods", "distance"}:  # These are of the search.
            value, near = wide[name], narrow[name]
            if name == "multipliers":
                value = [complex(*pair) for pair in value] if isinstance(value, list) else value
                assert value == pytest.approx(list(near), abs=1e-9) if isinstance(value, list) else value.is_nan()
            elif isinstance(value, Decimal):
                assert float(value) == pytest.approx(near, rel=1e-9, abs=1e-9, nan_ok=True), name
            else:
                assert value == near, name
    assert ss.response("0.4", 6, bits=100).max_displacement.is_nan()


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: ss.response("0.7", 2, bits=0), "bits = 0 must be >= 1"),
        (lambda: ss.response("0.7", 2, bits=10**6), "bits = 1000000 must be"),
        (lambda: ss.response("0,7", 2, bits=100), "0,7"),
        (lambda: ss.response([0.7], 2, bits=100), "give one number"),
        (lambda: ss.border("-1", bits=100), "omega = -1 must be > 0"),
    ],
)
def test_bad_input_is_refused_in_words(call, words):
    with pytest.raises(ss.Error, match=words):
        call()
