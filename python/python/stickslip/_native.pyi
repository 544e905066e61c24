"""The compiled part, in Rust."""

from typing import Any, Optional, Sequence, Union, final

import numpy as np
from numpy.typing import NDArray

_Column = NDArray[np.float64]
_Body = tuple[float, float, float, float, float, float]
_Start = tuple[float, float, float]
_Sliding = tuple[float, float, float, float, float, float, float, bool]
_Ratios = Sequence[Union[float, _Column]]

__version__: str
RESPONSE: list[tuple[str, str, str, str, bool]]
STEADY: list[tuple[str, str, str, str, bool]]
OUTPUTS: list[str]
REGIMES: list[str]
LIMITS: list[str]
FIGURES: list[str]
EXCITATIONS: list[tuple[str, str]]
MAX_PERIODS: int

class Error(ValueError): ...

def forked() -> None: ...
def plain(text: str) -> str: ...
def response_at(point: Sequence[Any], kind: Optional[str], outputs: list[str]) -> dict[str, Any]: ...
def response_into(
    points: _Ratios, n: int, kind: Optional[str], outputs: list[str], arrays: list[NDArray[Any]]
) -> None: ...
def no_stop(omega: float, damping_ratio: float) -> list[tuple[float, Optional[float]]]: ...
def steady_at(
    point: Sequence[Any], kind: Optional[str], outputs: list[str], start: _Start, max_periods: int
) -> dict[str, Any]: ...
def steady_into(
    points: _Ratios,
    n: int,
    kind: Optional[str],
    outputs: list[str],
    arrays: list[NDArray[Any]],
    start: _Ratios,
    max_periods: int,
) -> None: ...
def phases(point: Sequence[float], start: _Start, cycles: float) -> dict[str, NDArray[Any]]: ...
def samples(
    point: Sequence[float], start: _Start, cycles: float, per_cycle: int, whole_turns: bool
) -> dict[str, NDArray[Any]]: ...
def on_limit(
    point: Sequence[float], kind: Optional[str], start: _Start, max_periods: int
) -> Optional[tuple[_Start, int]]: ...
def attractors_at(point: Sequence[float], starts: Any, reach: Optional[float], max_periods: int) -> dict[str, Any]: ...
def decay_at(
    displacement: float, velocity: float, damping_ratio: float, static_friction_ratio: float
) -> dict[str, Any]: ...
def machine(
    values: list[tuple[str, str]], units: Optional[str]
) -> tuple[_Body, Optional[float], Optional[str]]: ...
def machines(
    values: list[tuple[str, str]], columns: list[tuple[str, _Column]], n: int, units: Optional[str]
) -> tuple[dict[str, _Column], Optional[str]]: ...
def drive(
    values: list[tuple[str, str]], units: Optional[str]
) -> tuple[str, float, float, Optional[str]]: ...
def read_values(values: list[tuple[str, str, str]], units: Optional[str]) -> tuple[list[float], Optional[str]]: ...
def block(
    values: list[tuple[str, str]], units: Optional[str], slope: Optional[str], one_way: bool
) -> tuple[_Sliding, Optional[str]]: ...
def blocks(
    values: list[tuple[str, str]],
    columns: list[tuple[str, _Column]],
    n: int,
    units: Optional[str],
    slope: Optional[str],
) -> tuple[dict[str, _Column], Optional[str]]: ...
def record_read(
    name: str,
    bytes: Optional[bytes],
    time_step: Optional[float],
    column: Optional[str],
    skip: int,
    record_units: Optional[str],
) -> tuple[tuple[str, list[float], list[float], str], dict[str, Any]]: ...
def record_check(of: str, times: _Column, samples: _Column, after: Optional[str]) -> str: ...
def record_follow(
    of: _Sliding, kind: str, times: _Column, samples: _Column, after: str, start: tuple[float, float]
) -> dict[str, NDArray[Any]]: ...
def record_motion(
    of: _Sliding,
    kind: str,
    times: _Column,
    samples: _Column,
    after: str,
    start: tuple[float, float],
    interval: float,
) -> list[dict[str, NDArray[Any]]]: ...
def record_floor_spectrum(
    of: _Sliding,
    kind: str,
    times: _Column,
    samples: _Column,
    after: str,
    start: tuple[float, float],
    periods: _Column,
    damping_ratio: float,
) -> dict[str, NDArray[Any]]: ...
def record_follow_each(
    columns: _Ratios,
    one_way: bool,
    kind: str,
    times: _Column,
    samples: _Column,
    after: str,
    starts: _Ratios,
    n: int,
) -> tuple[dict[str, NDArray[Any]], list[tuple[int, str]]]: ...
def unit_of(units: str, of: str) -> str: ...
def physical_outputs(excited: str) -> dict[str, tuple[str, str, str]]: ...
def machine_columns(
    of: _Ratios, kind: str, drives: _Ratios, n: int, many: bool, names: list[str]
) -> dict[str, _Column]: ...
def design_each(
    question: str,
    of: _Ratios,
    excited: str,
    target: Union[float, _Column],
    frequency: Union[float, _Column],
    n: int,
    many: bool,
) -> tuple[list[_Column], NDArray[np.uint8]]: ...
def best_stiffness(
    of: _Body, kind: str, amplitude: float, angular_frequency: float, low: float, high: float
) -> tuple[float, float, str]: ...
def frictions_for_displacement(
    of: _Body, kind: str, amplitude: float, angular_frequency: float, target: float
) -> list[tuple[float, str, float]]: ...
def bands(
    of: _Body, kind: str, amplitude: float, low: float, high: float
) -> list[tuple[float, float, bool, bool]]: ...
def best_friction_over(
    of: _Body, excitation: str, amplitude: float, low: float, high: float, aim: str
) -> tuple[float, float, list[tuple[float, float]], str, float]: ...
def identify_decay(displacement: _Column, time: Optional[_Column], turns: Optional[str]) -> dict[str, Any]: ...
def identify(
    of: _Body,
    force: Optional[float],
    angular_frequency: _Column,
    amplitude: _Column,
    phase: Optional[_Column],
    amplitude_kind: str,
    phase_kind: Optional[str],
) -> dict[str, Any]: ...
def identify_motion(
    mass: float, stiffness: Optional[float], load: tuple[str, _Column, _Column], displacement: _Column
) -> dict[str, Any]: ...
def figure(name: str) -> tuple[str, str, str]: ...
def arrow_response(input: Any, outputs: list[str]) -> Any: ...
def arrow_steady(input: Any, outputs: list[str], start: _Start, max_periods: int) -> Any: ...

def system_text(bytes: bytes, name: str) -> str: ...
@final
class NativeSystem:
    def __new__(cls, text: str, name: str, folder: str, units: Optional[str]) -> "NativeSystem": ...
    def with_values(self, set: list[tuple[str, str]]) -> "NativeSystem": ...
    def names(self) -> tuple[list[str], list[str], Optional[str]]: ...
    def describe(self) -> str: ...
    def time(self, name: str, text: str) -> float: ...
    def with_record(self, name: str, of: str, times: _Column, samples: _Column) -> "NativeSystem": ...
    def end_of_records(self) -> float: ...
    def steady(self) -> str: ...
    def simulate(self, until: float) -> str: ...
    def units_of_states(self) -> str: ...
    def states(self, times: _Column, is_steady: bool) -> list[_Column]: ...
    def border(self) -> str: ...
    def grid(
        self,
        axes: list[tuple[Optional[str], list[str]]],
        records: list[tuple[str, str, _Column, _Column]],
        question: str,
        until: Optional[float],
    ) -> tuple[dict[str, Any], list[tuple[int, str]]]: ...
