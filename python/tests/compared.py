"""Comparisons of an answer of the package with a number of another origin, as `tests/compared` of the library has them: each that ran leaves a row, from
which `.ci/evidence --python --write` makes the rows of docs/development/evidence.md. Without the variable STICKSLIP_EVIDENCE, a folder, none is left.
"""

import os
import pathlib


def compared(output, ours, other, origin, bound):
    """Fails where a number is further than the bound from one of another origin: "small steps" or "by hand"."""
    assert abs(ours - other) <= bound, f"{output}: {ours} for {other} of {origin}, beyond {bound}"
    _leave(output, float(ours), float(other), origin, float(bound))


def near(output, ours, other, origin, part):
    """Fails where a number is off by more than a part of one of another origin."""
    compared(output, ours, other, origin, part * abs(other))


def agreed(output, ours, other, origin):
    """Fails where a count or a word is not that of another origin."""
    assert ours == other, f"{output}: {ours!r} for {other!r} of {origin}"
    _leave(output, repr(ours), repr(other), origin, 0.0)


def _leave(output, ours, other, origin, bound):
    folder = os.environ.get("STICKSLIP_EVIDENCE")
    if folder:
        # "tests/test_evidence.py::name (call)"
        file, _, test = os.environ["PYTEST_CURRENT_TEST"].partition("::")
        name = f"python::{pathlib.Path(file).stem}::{test.split(' ')[0].split('[')[0]}"
        with (pathlib.Path(folder) / f"{os.getpid()}.tsv").open("a", encoding="utf-8") as rows:
            print(output, ours, other, origin, bound, name, sep="\t", file=rows)
