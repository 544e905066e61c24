"""A building on a friction slider under 40 synthetic records, for each of many frictions and mass ratios, on Dask or on Ray Data.

Each part is a run of rows of one table, whose rows are the buildings under each record, one record after another. A part is
computed from its number alone and is a separate file, as in `record_suite.py`.

    python system_suite.py --workers 2 --parts 80 --out buildings
    python system_suite.py --workers 2 --parts 80 --out buildings --engine ray
"""

from __future__ import annotations

import argparse

import numpy as np

import stickslip as ss
from engines import keep, run
from record_suite import quake

#: The building: a slab on the slider, a storey above it, and a soft spring that brings the slab back.
BUILDING = ss.System(
    units="kN,m",
    masses={"slab": "100 t", "storey": "100 t"},
    springs=[
        {"name": "restoring", "between": ["ground", "slab"], "stiffness": "600 kN/m"},
        {"between": ["slab", "storey"], "stiffness": "30 MN/m", "damping": "100 kN*s/m"},
    ],
    contacts=[{"name": "slider", "between": ["ground", "slab"], "friction": "100 kN"}],
)


def part(number: int, parts: int, records: int, frictions: int, samples: int, out: str) -> dict[str, float]:
    """Computes the rows of one part, writes them to a file, and returns their reductions."""
    grid = np.meshgrid(np.geomspace(40.0, 400.0, frictions), np.geomspace(20.0, 200.0, 4), indexing="ij")
    friction, mass = (values.ravel() for values in grid)
    rows = range(*(records * friction.size * edge // parts for edge in (number, number + 1)))
    drift, residual, stops = [], [], []
    for row in rows:
        record, place = divmod(row, friction.size)
        values = {"slider.friction": friction[place], "masses.storey": mass[place]}
        motion = BUILDING.with_values(values).follow(quake(record, samples))
        drift.append(np.abs([motion.max_displacement[0], motion.min_displacement[0]]).max())
        residual.append(motion.end_displacement[0])
        stops.append(motion.elements["slider"].stops)
    columns = {"row": np.array(rows), "drift": np.array(drift), "residual": np.array(residual), "stops": np.array(stops)}
    keep(out, number, **columns)
    return {
        "rows": float(columns["row"].size),
        "stops": float(columns["stops"].sum()),
        "greatest_displacement": float(columns["drift"].max(initial=0.0)),
        "residual": float(np.abs(columns["residual"]).sum()),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description="A building on a slider under a suite of records, on Dask or Ray")
    parser.add_argument("--records", type=int, default=40)
    parser.add_argument("--frictions", type=int, default=10, help="frictions; each with four masses of the storey")
    parser.add_argument("--samples", type=int, default=2000)
    run(parser, part, lambda args: (args.records, args.frictions, args.samples))


if __name__ == "__main__":
    main()
