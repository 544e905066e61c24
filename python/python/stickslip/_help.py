"""Short answers of `help`."""

from __future__ import annotations

from typing import Any, TypeVar, cast

_Tuple = TypeVar("_Tuple", bound="tuple[Any, ...]")


class Brief(type):
    """A class whose help is its text and its own methods, without those of `dict`, `tuple` and `object`."""

    def __dir__(cls) -> list[str]:
        described = getattr(cls, "_names", ())
        return [
            name
            for name in super().__dir__()
            if not (name.startswith("_") or hasattr(dict, name) or hasattr(tuple, name) or name in described)
        ]


def brief(cls: type[_Tuple]) -> type[_Tuple]:
    """A named tuple with a short help."""
    return cast("type[_Tuple]", Brief(cls.__name__, cls.__bases__, dict(cls.__dict__)))
