"""Pictures with matplotlib, which is not needed otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Optional

import numpy as np

from ._labels import module


def axes_of(ax: Any) -> Any:
    if ax is not None:
        return ax
    return module("matplotlib.pyplot").subplots(layout="constrained")[1]


def lines(ax: Any, x: Any, curves: Mapping[str, Any], x_label: str, y_label: str, style: Mapping[str, Any]) -> Any:
    """Curves over a common axis."""
    ax = axes_of(ax)
    for name, y in curves.items():
        ax.plot(x, y, **{"label": name.replace("_", " "), **style})
    ax.set(xlabel=x_label, ylabel=y_label)
    if len(curves) > 1:
        ax.legend()
    return ax


def plane(ax: Any, x: Any, y: Any, values: Any, x_label: str, y_label: str, label: Optional[str] = None) -> Any:
    """A map of values over two axes."""
    ax = axes_of(ax)
    mesh = ax.pcolormesh(np.asarray(x), np.asarray(y), np.asarray(values), shading="nearest", rasterized=True)
    if label is not None:
        ax.figure.colorbar(mesh, ax=ax, label=label)
    ax.set(xlabel=x_label, ylabel=y_label)
    return ax


def titled(name: str, unit: str) -> str:
    words = name.replace("_", " ")
    return f"{words} ({unit})" if unit not in ("", "1") else words
