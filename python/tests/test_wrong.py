"""Each keyword and each field, wrong in every way: the message names it."""

import copy
import inspect
import json
import math
import os

import numpy as np
import pytest
import stickslip as ss

MACHINE = {"mass": 50.0, "stiffness": 1000.0, "friction": 5.0}
ROLES = {
    "weight": "mass",
    "natural_frequency": "stiffness",
    "period": "stiffness",
    "pendulum_radius": "stiffness",
    "friction_coefficient": "friction",
}
WRONG = [math.nan, math.inf, "inf", "abc", "", "5 furlong", "1e400 m", object(), -3.0, "-3"]


def keywords(of):
    return [name for name in inspect.signature(of).parameters if name not in ("self", "units")]


def names(error, keyword):
    """Whether a message has the keyword, or the quantity in words."""
    return keyword in str(error.value) or keyword.replace("_", " ") in str(error.value)


@pytest.mark.parametrize("keyword", keywords(ss.Machine))
@pytest.mark.parametrize("wrong", WRONG, ids=repr)
def test_a_keyword_of_a_machine_is_named(keyword, wrong):
    given = {name: value for name, value in MACHINE.items() if name != ROLES.get(keyword)}
    if keyword == "pendulum_radius":
        given["mass"] = 50.0
    with pytest.raises(ss.Error) as error:
        ss.Machine(**{**given, keyword: wrong}).steady(ss.Drive(force=12.0, angular_frequency=6.0))
    assert names(error, keyword), error.value


#: What no keyword takes but `mean_force` and `slope`, which may be negative.
NO_NUMBER = [math.nan, math.inf, -math.inf, "inf", "-inf", "nan", "abc", "", "5 furlong", "-1 furlong", object()]
WRONG_NUMBERS = [*NO_NUMBER, -1.0, "-1", np.float64(-1)]
#: Arrays without any number that is right.
WRONG_ARRAYS = [[x, x] for x in (math.nan, math.inf, -1.0)]
RECORD = ss.Record([0.0, -3.0, -3.0, 0.0], time_step=0.5)


def wrongs(of):
    return [
        pytest.param(keyword, wrong, id=f"{keyword}-{wrong!r:.9}")
        for keyword in keywords(of)
        for wrong in (NO_NUMBER if keyword in ("mean_force", "slope") else WRONG_NUMBERS)
    ]


@pytest.mark.parametrize("keyword, wrong", wrongs(ss.Drive))
def test_a_keyword_of_a_drive_is_named(keyword, wrong):
    given = {"frequency": 2.0} if "frequency" not in keyword and keyword != "mean_force" else {"force": 12.0}
    given |= {"frequency": 2.0} if keyword == "mean_force" else {}
    with pytest.raises(ss.Error) as error:
        ss.Drive(**{**given, keyword: wrong})
    assert str(error.value).startswith(keyword), error.value


def block(keyword, wrong):
    given = {"mass": 50.0, "friction": 5.0}
    if keyword in ("friction_coefficient", "yield_acceleration", "gravity"):
        del given["friction"]
        given |= {"friction_coefficient": 0.1} if keyword == "gravity" else {}
    return ss.Block(**{**given, keyword: wrong})


@pytest.mark.parametrize("keyword, wrong", wrongs(ss.Block))
def test_a_keyword_of_a_block_is_named(keyword, wrong):
    if keyword == "one_way" or (keyword, wrong) == ("mean_force", ""):
        wrong = "abc"
    with pytest.raises(ss.Error) as error:
        block(keyword, wrong)
    assert keyword in str(error.value), error.value


@pytest.mark.parametrize("keyword", ["mass", "friction", "friction_coefficient", "yield_acceleration", "gravity", "friction_backward", "damping", "static_friction_ratio"])
@pytest.mark.parametrize("wrong", WRONG_ARRAYS, ids=repr)
def test_a_keyword_of_an_array_of_bodies_is_named(keyword, wrong):
    bodies = [block(keyword, wrong)]
    if keyword not in ROLES and keyword not in ("yield_acceleration", "gravity"):
        bodies.append(ss.Machine(**{**MACHINE, keyword: wrong}))
    for body in bodies:
        for start in (0.0, 1.0):
            with pytest.raises(ss.Error) as error:
                body.follow(RECORD, displacement=start)
            assert keyword in str(error.value), error.value


@pytest.mark.parametrize("keyword, wrong", wrongs(ss.Record))
def test_a_keyword_of_a_record_is_named(keyword, wrong):
    given = {"samples": [0.0, -3.0, -3.0, 0.0], "time_step": 0.5}
    if keyword == "times":
        del given["time_step"]
    with pytest.raises(ss.Error) as error:
        ss.Record(**{**given, keyword: wrong})
    assert keyword in str(error.value), error.value


@pytest.mark.parametrize("keyword", keywords(ss.Drive))
def test_an_array_of_a_drive_is_named(keyword):
    given = {"force": 12.0} if keyword in ("frequency", "angular_frequency", "mean_force") else {}
    given |= {"frequency": 2.0} if "frequency" not in keyword else {}
    for wrong in ([object(), object()], ["1 N", "2 N"], [1.0, [2.0]], np.array([1j, 2j])):
        with pytest.raises(ss.Error) as error:
            ss.Drive(**{**given, keyword: wrong})
        assert str(error.value).startswith(f"{keyword}: "), error.value


@pytest.mark.parametrize("wrong", WRONG_ARRAYS[:2], ids=repr)
@pytest.mark.parametrize("keyword", ["samples", "times"])
def test_an_array_of_a_record_is_named(keyword, wrong):
    given = {"samples": [0.0, 1.0], **({"time_step": 0.5} if keyword == "samples" else {})}
    with pytest.raises(ss.Error, match=keyword.removesuffix("s")):
        ss.Record(**{**given, keyword: wrong})


@pytest.mark.parametrize("of", [ss.Machine, ss.Drive, ss.System])
def test_an_unknown_keyword_is_named(of):
    with pytest.raises(TypeError, match="zzzz"):
        of(zzzz=1)


SYSTEM = {
    "units": "N,mm",
    "masses": {"block": "1 t", "roof": {"mass": "500 kg", "start": "3 mm", "velocity": "1 mm/s"}},
    "springs": [{"between": ["ground", "block"], "stiffness": "200 N/mm", "damping": "0.3 N*s/mm"}],
    "contacts": [{"name": "bearing", "between": ["ground", "block"], "friction": "450 N", "peak": 1.2}],
    "stops": [{"between": ["ground", "roof"], "gap": "9 mm", "stiffness": "1 kN/mm", "damping": 0.1}],
    "forces": [{"on": "roof", "amplitude": "1.5 kN", "frequency": "3 Hz", "phase": "30deg"}],
}


def leaves(value, path=()):
    if isinstance(value, dict):
        return [leaf for name, inner in value.items() for leaf in leaves(inner, (*path, name))]
    if isinstance(value, list):
        return [leaf for place, inner in enumerate(value) for leaf in leaves(inner, (*path, place))]
    return [path]


def place(path):
    text = "".join(f"[{step + 1}]" if isinstance(step, int) else f".{step}" for step in path)
    return text.removeprefix(".")


@pytest.mark.parametrize("path", leaves(SYSTEM), ids=place)
def test_a_field_of_a_system_is_named(path):
    numbers = ["mass", "start", "velocity", "stiffness", "damping", "friction", "peak", "gap", "amplitude", "frequency", "phase", "block"]
    signed = ["start", "velocity", "amplitude", "phase", "damping", "stiffness", "gap"]
    negative = [-1.0, "-1"] if path[-1] in numbers and path[-1] not in signed else []
    for wrong in [math.nan, math.inf, True, [], {}, "5 furlong", "", *negative]:
        if path[-1] == "name" and wrong == "5 furlong":
            continue
        value = copy.deepcopy(SYSTEM)
        inner = value
        for step in path[:-1]:
            inner = inner[step]
        inner[path[-1]] = wrong
        with pytest.raises(ss.Error) as error:
            ss.System(**value)
        assert place(path) in str(error.value), (wrong, error.value)


def test_a_value_that_was_set_is_named():
    system = ss.System(**SYSTEM)
    for typed, due in [
        ({"bearing.friction": -1}, "bearing.friction=-1.0: contacts[1].friction -1.0: must be >= 0"),
        ({"contacts.0.friction": 1}, "contacts.0.friction=1.0: 0 is no place of the list, which has [1] to [1]"),
        ({"forces[2].amplitude": 1}, "[2] is no place of the list"),
        ({"bearing.friction": b"1"}, "bearing.friction = b'1': must be a number, or a text with a unit"),
    ]:
        with pytest.raises(ss.Error) as error:
            system.with_values(typed)
        assert due in str(error.value)
    with pytest.raises(ss.Error) as error:
        system.grid({}, frequency=[-3.0])
    assert "frequency -3Hz: must be > 0 and finite" in str(error.value)
    with pytest.raises(ss.Error, match="times: must increase, but 0.0 follows 1.0"):
        system.states([0, 1, 0])


def test_a_missing_file_is_one_exception(tmp_path):
    for read in [ss.Record.read, ss.System.read]:
        missing = tmp_path / "none.csv"
        with pytest.raises(ss.FileError, match="No such file") as error:
            read(missing)
        assert isinstance(error.value, (ss.Error, OSError)) and isinstance(error.value, FileNotFoundError)
        assert isinstance(error.value, ss.Error) and str(missing) in str(error.value)
        with pytest.raises(ss.Error):
            read(tmp_path)


def test_a_text_of_sixteen_bits_is_named(tmp_path):
    file = tmp_path / "wide"
    file.write_text("masses = { a = 1 }\n", encoding="utf-16")
    with pytest.raises(ss.Error, match="must be text in UTF-8, but is UTF-16"):
        ss.System.read(file)
    file.write_text("time[s],acceleration[g]\n0,0\n1,0.1\n", encoding="utf-16")
    with pytest.raises(ss.Error, match="must be text in UTF-8, but is UTF-16"):
        ss.Record.read(file)


def test_two_values_of_one_name_are_refused(tmp_path):
    file = tmp_path / "twice.json"
    file.write_text('{"masses": {"a": 1, "a": 2}}')
    with pytest.raises(ss.Error, match="a must be given once"):
        ss.System.read(file)
    file.write_text(json.dumps({"masses": {"a": 1}}))
    assert ss.System.read(os.fspath(file)).coordinates == ("a",)
