"""The functions of high precision, from the package `stickslip-mp`."""

from __future__ import annotations

import importlib
import os
from typing import Any

from ._native import Error, plain


class MissingExtra(Error, ImportError):
    """The package of high precision is not installed."""


def _module() -> Any:
    try:
        return importlib.import_module("stickslip_mp._native")
    except ImportError:
        raise MissingExtra(
            "bits and enclosures need the package stickslip-mp, which links GMP and MPFR (LGPL): pip install stickslip[mp]"
        ) from None


def _forked() -> None:
    try:
        importlib.import_module("stickslip_mp._native").forked()
    except ImportError:
        pass


if hasattr(os, "register_at_fork"):
    os.register_at_fork(after_in_child=_forked)


def wide(name: str, *arguments: Any) -> Any:
    """Calls a function of high precision by its name."""
    module = _module()
    try:
        return getattr(module, name)(*arguments)
    except module.Error as error:
        raise Error(plain(str(error))) from None
