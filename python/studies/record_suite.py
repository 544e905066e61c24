"""A suite of records: 40 synthetic records on 10,000 isolators each, on Dask or on Ray Data.

Each part is a run of rows of one table, whose rows are the bodies under each record, one record after another. A part is
computed from its number alone and is a separate file, as in `steady_map.py`, so that the files are the same byte for byte
on any number of workers, one of which may die.

    python record_suite.py --workers 2 --parts 80 --out suite
    python record_suite.py --workers 2 --parts 80 --out suite --engine ray
"""

from __future__ import annotations

import argparse

import numpy as np

import stickslip as ss
from engines import keep, run

#: Seconds between samples.
STEP = 0.01


def quake(number: int, samples: int) -> ss.Record:
    """A synthetic record of 0.1 g to 0.4 g: five frequencies that depend on its number, under a bell-shaped envelope."""
    t = STEP * np.arange(samples)
    envelope = np.exp(-(((t - 0.4 * t[-1]) / (0.2 * t[-1])) ** 2))
    waves = sum(np.sin(2 * np.pi * (0.5 + 0.11 * number + 0.7 * k) * t + number * k) / (1 + k) for k in range(5))
    return ss.Record((0.1 + 0.3 * number / 40) * envelope * waves / 1.5, time_step=STEP, unit="g")


def part(number: int, parts: int, records: int, periods: int, samples: int, out: str) -> dict[str, float]:
    """Computes the rows of one part, writes them to a file, and returns their reductions."""
    grid = np.meshgrid(np.geomspace(0.3, 4.0, periods), np.geomspace(0.01, 0.2, 100), indexing="ij")
    period, friction = (values.ravel() for values in grid)
    first, end = (records * period.size * edge // parts for edge in (number, number + 1))
    found: dict[str, list[np.ndarray]] = {"record": [], "max_displacement": [], "residual_displacement": [], "stops": []}
    for record in range(first // period.size, -(-end // period.size)):
        rows = slice(max(first - record * period.size, 0), min(end - record * period.size, period.size))
        answer = ss.spectrum(
            quake(record, samples), period=period[rows], friction_coefficient=friction[rows], damping_ratio=0.05
        )
        found["record"].append(np.full(answer.stops.shape, record))
        for name in ("max_displacement", "residual_displacement", "stops"):
            found[name].append(np.asarray(getattr(answer, name)))
    columns = {name: np.concatenate(values) for name, values in found.items()}
    keep(out, number, **columns)
    return {
        "rows": float(columns["stops"].size),
        "stops": float(columns["stops"].sum()),
        "greatest_displacement": float(columns["max_displacement"].max()),
        "residual": float(np.abs(columns["residual_displacement"]).sum()),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description="Spectra of a suite of records on Dask or Ray")
    parser.add_argument("--records", type=int, default=40)
    parser.add_argument("--periods", type=int, default=100, help="periods; each with a hundred frictions")
    parser.add_argument("--samples", type=int, default=2000)
    run(parser, part, lambda args: (args.records, args.periods, args.samples))


if __name__ == "__main__":
    main()
