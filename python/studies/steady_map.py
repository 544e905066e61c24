"""A study too large for one process: steady states over frequency and force ratio, on Dask or on Ray Data.

Each part is a separate file, computed from the part's number alone. It is written to a temporary file and then
renamed, so that a repeated task, or a worker that dies while writing, leaves a complete file or none. The reductions
of the parts are small and return to the client, which combines them in the order of the parts. The result is
therefore bit for bit the same on any number of workers.

    python steady_map.py --workers 2 --parts 16 --out map
    python steady_map.py --workers 2 --parts 16 --out map --engine ray
"""

from __future__ import annotations

import argparse

import numpy as np

import stickslip as ss
from engines import keep, run

def part(number: int, parts: int, rows: int, columns: int, out: str) -> dict[str, float]:
    """Computes the rows of one part, writes them to a file, and returns their reductions."""
    omega = np.geomspace(0.1, 2.0, rows)[number::parts]
    alpha = np.geomspace(1.05, 10.0, columns)
    found = ss.steady(omega[:, None], alpha)
    keep(
        out,
        number,
        omega=omega,
        alpha=alpha,
        sticks_per_cycle=found.sticks_per_cycle,
        max_displacement=found.max_displacement,
        energy_out=found.energy_out,
    )
    return {
        "points": float(found.omega.size),
        "sticking": float(np.count_nonzero(found.regime == "sticking")),
        "greatest_energy": float(np.nanmax(found.energy_out)),
        "stick_time": float(np.nansum(found.stick_fraction)),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description="A map of steady states on Dask or Ray")
    parser.add_argument("--rows", type=int, default=160)
    parser.add_argument("--columns", type=int, default=100)
    run(parser, part, lambda args: (args.rows, args.columns))


if __name__ == "__main__":
    main()
