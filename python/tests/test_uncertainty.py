"""Monte-Carlo and sensitivities: what is counted, what is refused, and which values are held."""

import copy
import math
import pickle

import numpy as np
import pytest

import stickslip as ss

MACHINE, DRIVE = ss.Machine(mass=50, stiffness=1000, friction=5), ss.Drive(force=12, frequency=1)


@pytest.fixture(scope="module")
def drawn():
    """With draws of negative friction, which are outside the domain."""
    return ss.monte_carlo(MACHINE, DRIVE, {"friction": 0.9}, draws=400, seed=7)


def test_a_probability_is_among_the_valid_draws(drawn):
    friction = drawn.drawn["friction"]
    assert drawn.draws == 400 and drawn.invalid == np.count_nonzero(friction <= 0) > 20
    assert repr(drawn) == f"MonteCarlo(400 draws of friction, {drawn.invalid} invalid)"
    regime = np.asarray(drawn.answer.regime)
    valid = regime[friction > 0]
    for name in ("sticking", "non-sticking", "stuck"):
        assert drawn.probability(name).value == np.mean(valid == name)
    large = np.asarray(drawn.answer.max_displacement) > 0.01
    assert drawn.probability(large) == drawn.probability(lambda answer: answer.max_displacement > 0.01)
    assert drawn.probability(large).value == np.mean(large[friction > 0])
    # Wilson's interval, from its quadratic equation (p − share)² = z² p (1 − p)/n.
    share = drawn.probability(large)
    for end in share.interval:
        z2 = (end - share.value) ** 2 * valid.size / (end * (1 - end))
        assert z2 == pytest.approx(1.959963984540054**2, rel=1e-9)
    whole = ss.monte_carlo(MACHINE, DRIVE, {"friction": 0.01}, draws=20, seed=1)
    assert repr(whole) == "MonteCarlo(20 draws of friction)"


def test_the_ends_of_an_interval_of_none_or_all_are_exact():
    for draws in range(1, 200):
        found = ss.MonteCarlo({}, ss.MachineSteady({"regime": np.full(draws, "stuck")}))
        assert found.probability("sticking").interval[0] == 0.0 and found.probability("stuck").interval[1] == 1.0


def test_a_record_has_draws_outside_the_domain_too():
    record = ss.Record(np.sin(np.arange(100) * 0.2), time_step=0.05)
    found = ss.monte_carlo(MACHINE, record, {"friction": 0.9}, draws=200, seed=7)
    assert found.invalid == np.count_nonzero(found.drawn["friction"] < 0) > 10
    moved = found.probability(lambda answer: answer.path > 0)
    assert moved.value == np.mean(np.asarray(found.answer.path)[found.drawn["friction"] > 0] > 0)
    with pytest.raises(ss.Error, match="no regime"):
        found.probability("sticking")


@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("outputs", [None, "max_displacement", ["regime", "transmissibility"]])
def test_many_draws_are_answered_in_pieces_with_the_same_numbers(monkeypatch, exact, outputs):
    vary = {"friction": 0.6, "frequency": (0.9, 1.1)}
    whole = ss.monte_carlo(MACHINE, DRIVE, vary, draws=1050, seed=3, exact=exact, outputs=outputs)
    monkeypatch.setattr("stickslip._uncertainty._MANY", 1000)
    monkeypatch.setattr("stickslip._result._BLOCK", 100)
    found = ss.monte_carlo(MACHINE, DRIVE, vary, draws=1050, seed=3, exact=exact, outputs=outputs)
    assert set(found.answer._values) == (set() if outputs is None else set(found.answer))
    restored = pickle.loads(pickle.dumps(found))
    assert whole.invalid == found.invalid > 30 and found == whole == restored
    assert list(found.answer) == list(whole.answer) and found.answer.units == whole.answer.units
    for name in {*whole.answer, "mean_displacement", "max_velocity"}:
        np.testing.assert_array_equal(found.answer[name], whole.answer[name], name)
    for name in whole.answer.ratios:
        np.testing.assert_array_equal(found.answer.ratios[name], whole.answer.ratios[name], name)
    assert found.probability("sticking") == whole.probability("sticking") and found.mean("max_displacement") == whole.mean("max_displacement")
    assert np.isnan(found.answer.max_displacement[found.drawn["friction"] < 0]).all()
    none = ss.monte_carlo(MACHINE, DRIVE, {"friction": np.full(1001, -1.0)}, draws=1001, seed=3, exact=exact, outputs=outputs)
    assert none.invalid == 1001
    with pytest.raises(ValueError, match="read-only"):
        # What is computed later is of these draws.
        found.drawn["friction"][0] = 1.0


def test_draws_are_copied_pickled_and_compared_by_value(drawn):
    assert pickle.loads(pickle.dumps(drawn)) == drawn == copy.deepcopy(drawn) and not drawn != copy.copy(drawn)
    other = ss.monte_carlo(MACHINE, DRIVE, {"friction": 0.9}, draws=400, seed=8)
    assert drawn != other and not drawn == other and drawn != "draws"


@pytest.mark.parametrize(
    ("is_met", "why"),
    [
        ("slipping", "is_met = 'slipping' must be one of stuck, sticking, non-sticking"),
        ("stiking", "Did you mean 'sticking'"),
        ("invalid", "must be one of"),
        (True, "a flag for each"),
        (None, "flags"),
        (0.5, "flags"),
        (np.zeros(400), "type float64"),
        ([True, False], "a flag for each of the 400 draws, not the shape"),
        (np.ones((1, 400), dtype=bool), "the shape"),
        (lambda answer: 1.0, "flags"),
        (lambda answer: answer.max_displacement, "type float64"),
    ],
)
def test_conditions_that_are_none_are_refused(drawn, is_met, why):
    with pytest.raises(ss.Error, match=why):
        drawn.probability(is_met)


def test_several_quantiles_at_once(drawn):
    found = drawn.quantile("max_displacement", [0.05, 0.5, 0.95])
    assert found.tolist() == [drawn.quantile("max_displacement", share) for share in (0.05, 0.5, 0.95)]
    for share, why in (([0.5, 1.5], "share = 1.5"), (np.nan, "share = nan"), (True, "share = True"), (["5%"], "share")):
        with pytest.raises(ss.Error, match=why):
            drawn.quantile("max_displacement", share)


MANY = ss.Machine(mass=50, stiffness=1000, friction=[4.0, 5.0])


@pytest.mark.parametrize(
    ("call", "why"),
    [
        (lambda _: ss.sensitivities(MANY, DRIVE, "max_displacement"), "machine: must be one machine"),
        (lambda _: ss.monte_carlo(MANY, DRIVE, {"mass": 0.1}, draws=10, seed=1), "machine: must be one machine"),
        (lambda _: ss.sensitivities(MACHINE, ss.Drive(force=[1.0, 2.0], frequency=1), "max_displacement"), "load: must be one drive"),
        (lambda _: ss.sensitivities(MACHINE, DRIVE, "regime"), "output 'regime': must be a number, not a word"),
        (lambda _: ss.sensitivities(MACHINE, DRIVE, "max_displacment"), "must be one of .*Did you mean 'max_displacement'"),
        (lambda _: ss.sensitivities(MACHINE, DRIVE, "max_displacement", by=["friction_backward"]), "friction_backward = None"),
        (lambda drawn: drawn.mean("regime"), "output 'regime': must be a number, not a word"),
        (lambda drawn: drawn.mean("x"), "output 'x' must be one of"),
        (lambda drawn: drawn.quantile("multipliers", 0.5), "must be a number"),
        (lambda _: ss.monte_carlo(MACHINE, DRIVE, {"friction_backward": 0.1}, draws=10, seed=1), "friction_backward = None"),
    ],
)
def test_questions_without_an_answer_are_refused_in_words(drawn, call, why):
    with pytest.raises(ss.Error, match=why):
        call(drawn)


@pytest.mark.parametrize("damper", ["damping", "damping_ratio"])
def test_the_damper_is_held_as_it_was_given(damper):
    ratio = 0.08
    given = ratio if damper == "damping_ratio" else 2 * ratio * math.sqrt(50 * 1000)
    body = {"mass": 50.0, "stiffness": 1000.0, "friction": 5.0, damper: given}

    def displacement(**changed):
        return ss.Machine(**{**body, **changed}).response(DRIVE).max_displacement

    found = ss.sensitivities(ss.Machine(**body), DRIVE, "max_displacement", exact=False)
    assert set(found) == {"mass", "stiffness", "friction", damper, "amplitude", "frequency"}
    for name in ("mass", "stiffness", damper):
        h = 1e-5
        slope = (displacement(**{name: body[name] * (1 + h)}) - displacement(**{name: body[name] * (1 - h)})) / (2 * h * body[name])
        assert found[name].derivative == pytest.approx(slope, rel=1e-7), name
    # A step of the ratio is one of the constant, as mass and stiffness stay.
    both = ss.sensitivities(ss.Machine(**body), DRIVE, "max_displacement", by=["damping", "damping_ratio", "mass"], exact=False)
    assert both["damping"].elasticity == pytest.approx(both["damping_ratio"].elasticity, rel=1e-12)
    assert both["mass"] == found["mass"]
    drawn = ss.monte_carlo(ss.Machine(**body), DRIVE, {"mass": np.array([40.0, 60.0])}, draws=2, seed=1, exact=False)
    assert drawn.answer.max_displacement.tolist() == [displacement(mass=40.0), displacement(mass=60.0)]


def test_sensitivity_to_the_frequency_in_either_unit():
    found = ss.sensitivities(MACHINE, DRIVE, "max_displacement", by=["frequency", "angular_frequency"], exact=False)
    assert found["frequency"].elasticity == pytest.approx(found["angular_frequency"].elasticity, rel=1e-12)
    assert found["frequency"].derivative == pytest.approx(2 * math.pi * found["angular_frequency"].derivative, rel=1e-12)
