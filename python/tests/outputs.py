"""The typed outputs of results, from the library's table.

    python tests/outputs.py          # prints them
    python tests/outputs.py --write python/stickslip/_outputs.py
"""

from __future__ import annotations

import sys
import textwrap
from pathlib import Path

from stickslip import _native, _rows

HEAD = '''"""The outputs of results by name, with their types and meanings.

Written by `tests/outputs.py` from the library's table; the tests compare the two.
"""

from __future__ import annotations

from typing import Generic, Literal, Optional

import numpy as np
from numpy.typing import NDArray

from . import _rows
from ._result import PhysicalResult, Result, V, W
'''
TYPES = {"number": "V", "count": "V", "flag": "V", "text": "W", "pairs": "NDArray[np.complex128]"}
OF_BORDER = ("min_force_ratio", "min_force_ratio_turning_point", "border_phase", "least_displacement", "best_force_ratio")


def attribute(name: str, kind: str, unit: str, text: str) -> list[str]:
    ending = f" ({unit})" if unit not in ("", "1") and unit not in KINDS else ""
    lines = textwrap.wrap(f'"""{text}{ending}."""', 112)
    return [f"    {name}: {kind}", *(f"    {line}" for line in lines)]


KINDS = {kind for _, _, kind in _rows.physical_names().values()} | {kind for kind, _ in _rows.DRIVE_ROWS.values()}


def class_of(name: str, base: str, text: str, rows: str, lines: list[list[str]]) -> str:
    body = "\n".join(line for of in lines for line in of)
    return f'\n\nclass {name}({base}):\n    """{text}"""\n\n    _rows = _rows.{rows}\n{body}\n'


def literal(name: str, names: list[str], text: str) -> str:
    body = "\n".join(f'    "{own}",' for own in names)
    return f"\n\n#: {text}\n{name} = Literal[\n{body}\n]"


def text() -> str:
    kinds = {row[0]: TYPES[row[1]] for row in [*_native.RESPONSE, *_native.STEADY]}

    def lines(rows: dict[str, tuple[str, str]], sources: dict[str, str]) -> list[list[str]]:
        return [attribute(name, kinds.get(sources.get(name, name), "V"), *row) for name, row in rows.items()]

    no_stop = [
        "    no_stop_force_ratios: Optional[list[tuple[V, Optional[V]]]]",
        '    """The intervals of the force ratio without any stop, for a single omega with one friction."""',
    ]
    of_border = {name: row for name, row in _rows.BORDER.items() if name in _rows.RATIO_ROWS or name in OF_BORDER}
    border = [*lines({name: of_border[name] for name in of_border}, {}), no_stop]
    generic, of_units = "Result, Generic[V, W]", "PhysicalResult, Generic[V, W]"
    literals = [
        literal("ResponseOutput", [row[0] for row in _native.RESPONSE], "The names of the outputs of `response`."),
        literal("SteadyOutput", [row[0] for row in _native.STEADY], "The names of the outputs of `steady`."),
        literal("MachineResponseOutput", list(_rows.MACHINE_RESPONSE), "The names of the values of `Machine.response`."),
        literal("MachineSteadyOutput", list(_rows.MACHINE_STEADY), "The names of the values of `Machine.steady`."),
    ]
    return (
        HEAD
        + "".join(literals)
        + "".join(
            [
                class_of("ResponseOutputs", generic, "The ratios and outputs of `response`.", "RESPONSE", lines(_rows.RESPONSE, {})),
                class_of("BorderOutputs", "Result, Generic[V]", "The ratios and outputs of `border`.", "BORDER", border),
                class_of("SteadyOutputs", generic, "The ratios and outputs of `steady`.", "STEADY", lines(_rows.STEADY, {})),
                class_of(
                    "MachineResponseOutputs",
                    of_units,
                    "The outputs of `Machine.response`, in its units.",
                    "MACHINE_RESPONSE",
                    lines(_rows.MACHINE_RESPONSE, _rows.RESPONSE_SOURCES),
                ),
                class_of(
                    "MachineSteadyOutputs",
                    of_units,
                    "The outputs of `Machine.steady`, in its units.",
                    "MACHINE_STEADY",
                    lines(_rows.MACHINE_STEADY, _rows.STEADY_SOURCES),
                ),
            ]
        )
    )


if __name__ == "__main__":
    if "--write" in sys.argv:
        Path(sys.argv[-1]).write_text(text(), encoding="utf-8")
    else:
        print(text(), end="")
