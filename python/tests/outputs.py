"""The typed outputs of results, from the library's table.

    python tests/outputs.py          # prints them
    python tests/outputs.py --write python/stickslip/_outputs.py
"""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path

from stickslip import _native

HEAD = '''"""The outputs of results by name, with their types and meanings.

Written by `tests/outputs.py` from the library's table; the tests compare the two.
"""

from __future__ import annotations

from typing import Generic, Optional

import numpy as np
from numpy.typing import NDArray

from ._result import Physical, Result, V, W
'''
RATIOS = {
    "omega": "Frequency ratio.",
    "alpha": "Force ratio.",
    "damping_ratio": "Damping ratio of the viscous damper.",
    "static_friction_ratio": "Ratio of static to kinetic friction.",
}
TYPES = {"number": "V", "count": "V", "flag": "V", "text": "W", "pairs": "NDArray[np.complex128]"}
OF_BORDER = ("min_force_ratio", "min_force_ratio_turning_point", "border_phase", "least_displacement", "best_force_ratio")


def attribute(name: str, kind: str, text: str) -> list[str]:
    lines = textwrap.wrap(f'"""{text[:1].upper()}{text[1:].rstrip(".")}."""', 112)
    return [f"    {name}: {kind}", *(f"    {line}" for line in lines)]


def of_row(row: tuple[str, str, str, str, bool]) -> list[str]:
    name, kind, unit, text, _ = row
    ending = {"count": " (a count)", "flag": " (True or False; 1 or 0 in an array)"}.get(kind, f" ({unit})" if unit not in ("", "1") else "")
    return attribute(name, TYPES[kind], text + ending)


def class_of(name: str, base: str, text: str, lines: list[list[str]]) -> str:
    body = "\n".join(line for of in lines for line in of)
    return f'\n\nclass {name}({base}):\n    """{text}"""\n\n{body}\n'


def physical(rows: list[tuple[str, str, str, str, bool]]) -> list[list[str]]:
    names: dict[str, str] = {}
    for excitation, _ in _native.EXCITATIONS:
        known = _native.physical_outputs(excitation)
        for row in rows:
            if row[0] in known:
                own, _, kind = known[row[0]]
                names.setdefault(own, f"{row[3]}, as {'an' if kind[0] in 'aeiou' else 'a'} {kind}")
    return [attribute(name, "V", text) for name, text in names.items()]


def text() -> str:
    ratios = {name: attribute(name, "V", meaning) for name, meaning in RATIOS.items()}
    rows = {row[0]: row for row in _native.RESPONSE}
    no_stop = [
        "    no_stop_force_ratios: Optional[list[tuple[V, Optional[V]]]]",
        '    """The intervals of the force ratio without any stop, for a single omega with one friction."""',
    ]
    border = [*(ratios[name] for name in ratios if name != "alpha"), *(of_row(rows[name]) for name in OF_BORDER), no_stop]
    generic, of_units = "Result, Generic[V, W]", "Physical[V]"
    closed, exact = list(_native.RESPONSE), list(_native.STEADY)
    return HEAD + "".join(
        [
            class_of("ResponseOutputs", generic, "The ratios and outputs of `response`.", [*ratios.values(), *map(of_row, closed)]),
            class_of("BorderOutputs", "Result, Generic[V]", "The ratios and outputs of `border`.", border),
            class_of("SteadyOutputs", generic, "The ratios and outputs of `steady`.", [*ratios.values(), *map(of_row, exact)]),
            class_of("PhysicalResponse", of_units, "The outputs of `response` in a machine's units.", physical(closed)),
            class_of("PhysicalSteady", of_units, "The outputs of `steady` in a machine's units.", physical(exact)),
        ]
    )


if __name__ == "__main__":
    if "--write" in sys.argv:
        Path(sys.argv[-1]).write_text(text(), encoding="utf-8")
    else:
        print(text(), end="")
