"""Values that carry a unit: quantities of pint and of astropy, and arrays with a unit in their attributes or their names."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np

from . import _native
from ._native import Error

#: The name of a column with a unit, as in ``force[kN]`` and ``Time (s)``.
_NAME = re.compile(r"(.*?)\s*(\[|\()([^][()]*)[])]\s*", re.DOTALL)
#: The units of a plain number.
_NONE = ("", "1", "-", "dimensionless", "none")
#: The root units of pint, and the irreducible ones of astropy, by the names of this package.
_ROOTS = {"gram": "kg", "kilogram": "kg", "meter": "m", "second": "s", "radian": "rad"}
_HERTZ = re.compile("hertz|hz", re.IGNORECASE)


def parted(name: str, value: Any) -> tuple[Any, str]:
    """The number or the array of a value, and its unit as text, which is empty where it has none.

    Quantities become numbers in SI units. A frequency in neither hertz nor angles is refused: it may count cycles or radians.
    """
    if value is None or isinstance(value, (str, bytes, int, float)):
        return value, ""
    if isinstance(value, (list, tuple)) or isinstance(value, np.ndarray) and value.dtype.kind == "O":
        return _of_sequence(name, value)
    if hasattr(value, "to_numpy"):
        return _of_labelled(name, value)
    # A column of astropy.
    value = value if getattr(value, "quantity", None) is None else value.quantity
    if hasattr(value, "to_root_units"):
        roots = {str(unit): power for unit, power in value.to_root_units().unit_items()}
        return _in_roots(name, value, roots, str(value.units), "magnitude")
    if hasattr(value, "decompose") and hasattr(value, "unit"):
        unit = value.decompose().unit
        return _in_roots(name, value, dict(zip(map(str, unit.bases), unit.powers)), str(value.unit), "value")
    own = getattr(value, "units", getattr(value, "unit", None))
    if own is not None and str(own) not in _NONE:
        raise Error(f"{name} [{own}]: is a {type(value).__module__}.{type(value).__name__}, whose units are not read. Give a quantity of pint or astropy, or text")
    return value, ""


def _in_roots(name: str, value: Any, roots: Mapping[str, Any], typed: str, number: str) -> tuple[Any, str]:
    """A quantity in SI units, of which it has these powers."""
    powers = {_ROOTS.get(root, root): power for root, power in roots.items() if power != 0}
    if powers == {"s": -1}:
        if not _HERTZ.search(typed):
            raise Error(f"{name} [{typed}]: may count cycles or radians. Convert it to Hz or to rad/s")
        return getattr(value.to("Hz"), number), "Hz"
    if not powers:
        return getattr(value.to(""), number), ""
    over, under = ([(unit, abs(power)) for unit, power in powers.items() if (power > 0) is up] for up in (True, False))
    text = "*".join(_power(*part) for part in over) or "1"
    unit = "/".join((text, *(_power(*part) for part in under)))
    if not _native.is_unit(unit):
        # It is named as it was given.
        return getattr(value, number), typed
    return getattr(value.to(unit.replace("^", "**")), number), unit


def _power(unit: str, power: Any) -> str:
    return unit if power == 1 else f"{unit}^{power}"


def _of_sequence(name: str, values: Any) -> tuple[Any, str]:
    """A sequence, whose elements may have units."""
    flat = list(values.flat) if isinstance(values, np.ndarray) else values
    if {type(value) for value in flat} <= {int, float, str, np.float64}:
        return values, ""
    parts = [parted(name, value) for value in flat]
    units = {unit for _, unit in parts}
    if units <= {""}:
        return values, ""
    if len(units) > 1:
        raise Error(f"{name}: must have one unit for all elements, not {', '.join(unit or 'none' for unit in sorted(units))}")
    array = np.array([number for number, _ in parts])
    return array.reshape(np.shape(values)) if isinstance(values, np.ndarray) else array, units.pop()


def _of_labelled(name: str, value: Any) -> tuple[Any, str]:
    """An array of pandas, xarray or polars, with a unit in its attributes, its name or the names of its columns."""
    columns = list(value.columns) if hasattr(value, "columns") else [getattr(value, "name", None)]
    attributes = getattr(value, "attrs", None) or {}
    named = [_named(column) if isinstance(column, str) else (column, "") for column in columns]
    units = {unit or _of_attributes(attributes, column) for (_, unit), column in zip(named, columns)}
    # A data array of xarray and a column of pandas may hold a quantity.
    inner = getattr(value, "data", None) if hasattr(value, "dims") else getattr(getattr(value, "array", None), "quantity", None)
    inner = value.to_numpy() if getattr(getattr(value, "dtype", None), "kind", "") == "O" else inner
    numbers, unit = (None, "") if inner is None else parted(name, inner)
    if unit:
        units = units - {""} | {unit}
    if len(units) > 1:
        raise Error(f"{name}: must have one unit, not {', '.join(unit or 'none' for unit in sorted(units))}")
    unit = units.pop() if units else ""
    if unit == "":
        return value, ""
    names = [own for own, _ in named]
    if not hasattr(value, "attrs"):
        return value.to_numpy(), unit
    if hasattr(value, "columns"):
        new = value.set_axis(names, axis=1)
    elif hasattr(value, "dims"):
        new = value.copy(deep=False, data=value.data if numbers is None else numbers)
        new.name = names[0]
    else:
        new = value.rename(names[0]) if numbers is None else type(value)(numbers, index=value.index, name=names[0])
    new.attrs = {key: text for key, text in attributes.items() if key != "units"}
    return new, unit


def _named(text: str) -> tuple[str, str]:
    """A name without its unit, and the unit."""
    found = _NAME.fullmatch(text)
    if found is None:
        return text, ""
    own, bracket, unit = (part.strip() for part in found.groups())
    # A place is none, nor is a remark.
    if bracket == "[" and not unit.isdigit() or _native.is_unit(unit):
        return own, "" if unit in _NONE else unit
    return text, ""


def _of_attributes(attributes: Mapping[Any, Any], name: Any) -> str:
    units = attributes.get("units")
    unit = units.get(name) if isinstance(units, Mapping) else units
    return "" if unit is None or str(unit) in _NONE else str(unit)
