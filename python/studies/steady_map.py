"""A study that outgrows one process: steady states over frequency and force ratio, on Dask.

Each part is a file of its own, computed from the part's number alone. It is written under a name of its own and then
renamed, so that a task tried twice, or a worker that dies while writing, leaves a whole file or none. The reductions
of the parts are small and come back to the client, which adds them up in the order of the parts: the result is the
same, bit for bit, on any number of workers.

    python steady_map.py --workers 2 --parts 16 --out map
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
from pathlib import Path

import numpy as np

import stickslip as ss


def part(number: int, parts: int, rows: int, columns: int, out: str) -> dict[str, float]:
    """Computes the rows of one part, writes them as a file, and gives what the whole study needs of them."""
    omega = np.geomspace(0.1, 2.0, rows)[number::parts]
    alpha = np.geomspace(1.05, 10.0, columns)
    found = ss.steady(omega[:, None], alpha)
    path = Path(out) / f"part-{number:05}.npz"
    with tempfile.NamedTemporaryFile(dir=out, suffix=".tmp", delete=False) as file:
        np.savez(
            file,
            omega=omega,
            alpha=alpha,
            sticks_per_cycle=found.sticks_per_cycle,
            max_displacement=found.max_displacement,
            energy_out=found.energy_out,
        )
    os.replace(file.name, path)
    return {
        "points": float(found.omega.size),
        "sticking": float(np.count_nonzero(found.regime == "sticking")),
        "greatest_energy": float(np.nanmax(found.energy_out)),
        "stick_time": float(np.nansum(found.stick_fraction)),
    }


def whole(parts: list[dict[str, float]]) -> dict[str, float]:
    """The reductions of all parts, in their order."""
    total = {name: 0.0 for name in parts[0]}
    for found in parts:
        for name, value in found.items():
            total[name] = max(total[name], value) if name.startswith("greatest") else total[name] + value
    return total


def main() -> None:
    parser = argparse.ArgumentParser(description="A map of steady states on Dask")
    parser.add_argument("--workers", type=int, default=2, help="worker processes; 0 computes in this one")
    parser.add_argument("--parts", type=int, default=16)
    parser.add_argument("--rows", type=int, default=160)
    parser.add_argument("--columns", type=int, default=100)
    parser.add_argument("--out", required=True, help="a directory for the parts")
    args = parser.parse_args()
    Path(args.out).mkdir(parents=True, exist_ok=True)
    options = (args.parts, args.rows, args.columns, args.out)
    if args.workers == 0:
        found = [part(number, *options) for number in range(args.parts)]
    else:
        from distributed import Client, LocalCluster

        with LocalCluster(n_workers=args.workers, threads_per_worker=1, dashboard_address=None) as cluster:
            with Client(cluster) as client:
                tasks = client.map(lambda number: part(number, *options), range(args.parts), pure=False)
                found = client.gather(tasks)
    print(json.dumps(whole(found)))


if __name__ == "__main__":
    main()
