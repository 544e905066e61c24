"""The parts of a study, computed in this process, on worker processes of Dask, or on Ray Data."""

from __future__ import annotations

import argparse
import json
import os
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

#: A part by its number, the number of parts, and the options of the study: a few sums and greatest values.
Part = Callable[..., dict[str, float]]


def whole(parts: list[dict[str, float]]) -> dict[str, float]:
    """The reductions of all parts, combined in their order."""
    total = {name: 0.0 for name in parts[0]}
    for found in parts:
        for name, value in found.items():
            total[name] = max(total[name], value) if name.startswith("greatest") else total[name] + value
    return total


def keep(out: str, number: int, **columns: np.ndarray) -> None:
    """Writes the columns of a part to its file, which appears whole or not at all."""
    with tempfile.NamedTemporaryFile(dir=out, suffix=".tmp", delete=False) as file:
        np.savez(file, **columns)
    os.replace(file.name, Path(out) / f"part-{number:05}.npz")


def on_dask(workers: int, part: Part, options: tuple[Any, ...]) -> list[dict[str, float]]:
    """Computes all parts on worker processes of Dask."""
    from distributed import Client, LocalCluster

    with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            tasks = client.map(lambda number: part(number, *options), range(options[0]), pure=False)
            return list(client.gather(tasks))


def on_ray(workers: int, part: Part, options: tuple[Any, ...]) -> list[dict[str, float]]:
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


def run(parser: argparse.ArgumentParser, part: Part, own: Callable[[argparse.Namespace], tuple[Any, ...]]) -> None:
    """Computes a study by its command line and prints its reductions; `own` gives its own options."""
    parser.add_argument("--engine", choices=["dask", "ray"], default="dask")
    parser.add_argument("--workers", type=int, default=2, help="worker processes; 0 computes in this process")
    parser.add_argument("--parts", type=int, default=16)
    parser.add_argument("--out", required=True, help="directory for the files of the parts")
    args = parser.parse_args()
    Path(args.out).mkdir(parents=True, exist_ok=True)
    options = (args.parts, *own(args), args.out)
    if args.workers == 0:
        found = [part(number, *options) for number in range(args.parts)]
    else:
        found = {"dask": on_dask, "ray": on_ray}[args.engine](args.workers, part, options)
    print(json.dumps(whole(found)))
