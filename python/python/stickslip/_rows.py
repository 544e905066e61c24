"""The unit, the meaning and the formula of each output, from the library's table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from . import _native
from ._result import Meaning, Row

#: The ratios, which each answer repeats.
RATIO_ROWS: dict[str, Meaning] = {
    "omega": ("1", "Frequency ratio Ω = ω_d/ω_n"),
    "alpha": ("1", "Force ratio α = p₀/r_y"),
    "damping_ratio": ("1", "Damping ratio ζ of the viscous damper, c/(2√(k m))"),
    "static_friction_ratio": ("1", "Ratio η of static to kinetic friction"),
}
#: The values of a machine under its drive: kind and meaning.
DRIVE_ROWS: dict[str, Meaning] = {
    "angular_frequency": ("frequency", "Angular frequency ω_d of the drive"),
    "force_amplitude": ("force", "Amplitude of the drive as a force, p₀"),
    "friction_displacement": ("length", "Friction force over stiffness, B = r_y/k"),
    "mean_displacement": ("length", "The shift due to a mean force or to friction that depends on the direction"),
}
#: Formulae of closed forms, in the symbols that `SYMBOLS` explains.
FORMULAE: dict[str, str] = {
    "max_displacement": "a − G",
    "displacement_phase": "δ + atan2(q a, K)",
    "loop_size_stiffness": "8 (Δ₀/B)/α²",
    "loop_size_inertia": "Ω² A₁",
    "best_force_ratio": "√(2 Q (Q + q G)), and not below α_min",
    "min_force_ratio": "q hypot(S, H)",
    "dynamic_amplification": "(Δ₀/B)/α",
    "equivalent_damping_ratio": "c_eq/(2√(k m))",
}
#: Additions to the meanings of the table.
NOTES: dict[str, str] = {"transmitted_force": ", without the mean force"}
SYMBOLS = """T = π/Ω, d = √(1 − ζ²), q = √((1 − Ω²)² + 4 ζ² Ω²), δ = atan2(2 ζ Ω, 1 − Ω²), N = cosh ζT + cos dT,
    G = (sinh ζT − (ζ/d) sin dT)/N, H = sin dT/(d Ω N), K = q H, a = √(α² − K²)/q, Q = hypot(K, q G);
    S is the larger of (η + G + 2 ζ Ω H)/Ω² (eq. 61) and what the velocity needs to stay positive below Ω = 1/2."""
#: Units in ratios of outputs that mean the same for a machine.
_PLAIN = ("", "1", "rad", "2π/ω_d")


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:].rstrip(".")


def ratio_rows(table: Iterable[Row]) -> dict[str, Meaning]:
    """The unit and the meaning of each output in ratios."""
    found = dict(RATIO_ROWS)
    for name, kind, unit, text, _ in table:
        ending = {"count": " (a count)", "flag": " (True or False; 1 or 0 in an array)"}.get(kind, "")
        formula = f": {FORMULAE[name]}" if name in FORMULAE else ""
        found[name] = (unit, f"{_sentence(text)}{NOTES.get(name, '')}{formula}{ending}")
    return found


def physical_names() -> dict[str, tuple[str, str, str]]:
    """For each output that any excitation gives a value in units: its name, its scale and its kind."""
    found: dict[str, tuple[str, str, str]] = {}
    for excitation, _ in _native.EXCITATIONS:
        found = {**_native.physical_outputs(excitation), **found}
    return found


def machine_rows(table: Iterable[Row]) -> tuple[dict[str, Meaning], dict[str, str]]:
    """The kind and the meaning of each value of a machine, and the output that each follows from."""
    physical, rows = physical_names(), ratio_rows(table)
    meanings: dict[str, Meaning] = dict(DRIVE_ROWS)
    sources: dict[str, str] = {}
    for name, (unit, text) in rows.items():
        if name in RATIO_ROWS:
            continue
        own, _, kind = physical.get(name, (name, "", ""))
        if own != name and unit in _PLAIN:
            meanings[name], sources[name] = (unit, text), name
        if kind:
            meanings[own] = (kind, f"{text.partition(': ')[0]}, as {'an' if kind[0] in 'aeiou' else 'a'} {kind}")
        else:
            meanings[own] = (unit, text)
        sources[own] = name
    sources |= dict(zip(RATIO_ROWS, RATIO_ROWS))
    return {**meanings, **RATIO_ROWS}, sources


def explained(rows: Mapping[str, Meaning], indent: str = "    ") -> str:
    """The outputs as lines of a docstring."""
    width = max(map(len, rows))
    ending = {name: f" ({unit})" if unit not in ("", "1") else "" for name, (unit, _) in rows.items()}
    return "\n".join(f"{indent}{name:<{width}}  {text}{ending[name]}" for name, (_, text) in rows.items())


RESPONSE = ratio_rows(_native.RESPONSE)
STEADY = ratio_rows(_native.STEADY)
BORDER = {name: row for name, row in RESPONSE.items() if name != "alpha"}
MACHINE_RESPONSE, RESPONSE_SOURCES = machine_rows(_native.RESPONSE)
MACHINE_STEADY, STEADY_SOURCES = machine_rows(_native.STEADY)
