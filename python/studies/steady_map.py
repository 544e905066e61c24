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
import json
import os
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

import stickslip as ss

#: Number of parts, rows and columns of the map, and the output directory.
Options = tuple[int, int, int, str]


def part(number: int, parts: int, rows: int, columns: int, out: str) -> dict[str, float]:
    """Computes the rows of one part, writes them to a file, and returns their reductions."""
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
    """The reductions of all parts, combined in their order."""
    total = {name: 0.0 for name in parts[0]}
    for found in parts:
        for name, value in found.items():
            total[name] = max(total[name], value) if name.startswith("greatest") else total[name] + value
    return total


def on_dask(workers: int, options: Options) -> list[dict[str, float]]:
    """Computes all parts on worker processes of Dask."""
    from distributed import Client, LocalCluster

    with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            tasks = client.map(lambda number: part(number, *options), range(options[0]), pure=False)
            return list(client.gather(tasks))


def on_ray(workers: int, options: Options) -> list[dict[str, float]]:
    """Computes all parts as the rows of a dataset of Ray Data."""
    import ray

    def row(batch: dict[str, Any]) -> dict[str, Any]:
        (number,) = batch["id"]
        return {"id": [number], **{name: [value] for name, value in part(int(number), *options).items()}}

    ray.init(num_cpus=workers, include_dashboard=False, log_to_driver=False)
    try:
        numbers = ray.data.range(options[0], override_num_blocks=options[0])
        rows = numbers.map_batches(row, batch_size=1).take_all()
    finally:
        ray.shutdown()
    rows.sort(key=lambda found: found["id"])
    return [{name: value for name, value in found.items() if name != "id"} for found in rows]


def main() -> None:
    parser = argparse.ArgumentParser(description="A map of steady states on Dask or Ray")
    parser.add_argument("--engine", choices=["dask", "ray"], default="dask")
    parser.add_argument("--workers", type=int, default=2, help="worker processes; 0 computes in this process")
    parser.add_argument("--parts", type=int, default=16)
    parser.add_argument("--rows", type=int, default=160)
    parser.add_argument("--columns", type=int, default=100)
    parser.add_argument("--out", required=True, help="directory for the files of the parts")
    args = parser.parse_args()
    Path(args.out).mkdir(parents=True, exist_ok=True)
    options = (args.parts, args.rows, args.columns, args.out)
    if args.workers == 0:
        found = [part(number, *options) for number in range(args.parts)]
    else:
        found = {"dask": on_dask, "ray": on_ray}[args.engine](args.workers, options)
    print(json.dumps(whole(found)))


if __name__ == "__main__":
    main()
