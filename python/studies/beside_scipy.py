"""Compares this package with SciPy's `solve_ivp` on ten machines: processor time and error of the displacement.

`solve_ivp` is also given the number of periods after which the motion has settled to a millionth, which it cannot
know. The sign function of friction is smoothed to tanh(v/eps), because with the sign itself the step size collapses
wherever the body stops.

    python beside_scipy.py
"""

from __future__ import annotations

import time
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

import stickslip as ss

#: Frequency ratio, force ratio and damping ratio.
MACHINES = [
    (1.5, 2.5, 0.0),
    (0.7, 3.0, 0.0),
    (1.1, 2.0, 0.0),
    (2.0, 4.0, 0.0),
    (0.8, 2.0, 0.05),
    (1.0, 3.0, 0.1),
    (1.3, 1.3, 0.0),
    (0.4, 6.0, 0.0),
    (0.3, 4.0, 0.1),
    (0.15, 3.0, 0.0),
]


def by_scipy(omega: float, alpha: float, damping: float, periods: int, eps: float, rtol: float) -> float:
    """The maximum displacement in the last of a number of periods from rest."""

    def slope(t: float, y: NDArray[np.float64]) -> tuple[float, float]:
        return y[1], alpha * np.sin(omega * t) - y[0] - 2 * damping * y[1] - np.tanh(y[1] / eps)

    period = 2 * np.pi / omega
    last = np.linspace((periods - 1) * period, periods * period, 2001)
    span = (0.0, periods * period)
    found = solve_ivp(slope, span, (0.0, 0.0), method="LSODA", t_eval=last, rtol=rtol, atol=1e-3 * rtol)
    return float(found.y[0].max())


def timed(call: Any, repeats: int) -> tuple[Any, float]:
    """The result of the call, and its minimum processor time in seconds."""
    least = float("inf")
    for _ in range(repeats):
        start = time.process_time()
        answer = call()
        least = min(least, time.process_time() - start)
    return answer, least


def main() -> None:
    print("| Ω, α, ζ | stops | periods | here | LSODA, rtol 1e-6, eps 1e-3 | LSODA, rtol 1e-9, eps 1e-5 |")
    print("|---|---|---|---|---|---|")
    for omega, alpha, damping in MACHINES:
        # The time of a single answer is too short to measure.
        found, here = timed(lambda: ss.steady(np.full(1000, omega), alpha, damping), 5)
        left = found.contraction[0]
        periods = 3 if left < 1e-6 else int(np.ceil(np.log(1e-6) / np.log(left))) + 3
        stops = str(found.sticks_per_cycle[0])
        columns = [f"{omega:g}, {alpha:g}, {damping:g}", stops, str(periods), f"{here * 1e3:.1f} µs"]
        for eps, rtol in ((1e-3, 1e-6), (1e-5, 1e-9)):
            value, there = timed(lambda: by_scipy(omega, alpha, damping, periods, eps, rtol), 1)
            error = abs(value / found.max_displacement[0] - 1)
            columns.append(f"{there * 1e3:.0f} ms, error {error:.0e}")
        print("| " + " | ".join(columns) + " |", flush=True)


if __name__ == "__main__":
    main()
