#!/usr/bin/env python3
"""Recomputes the answers of tests/data/records.json to 25 digits, and fails where one differs from the file.

    python3 tests/data/records.py        # needs mpmath; `.ci/slow references` runs it

The motion is that of record_answers.py: power series of x in time at 60 digits, on short parts of each step.
"""

import json
import pathlib
import sys

from mpmath import mpf

from record_answers import Body as Symmetric


class Body(Symmetric):
    """The same with two frictions, whose difference is a constant force, and with the times of extremes."""

    def __init__(self, case):
        forward = mpf(str(case["friction"]))
        backward = forward if case["friction_backward"] is None else mpf(str(case["friction_backward"]))
        self.offset = (forward - backward) / 2
        names = ("mass", "stiffness", "damping", "static_friction_ratio", "time_step")
        given = {name: str(case[name]) for name in names}
        given |= {"excitation": "base_acceleration", "friction": str((forward + backward) / 2), "x": "0", "v": "0"}
        samples = [str(mpf(str(a)) / 1000) for a in case["base_acceleration_mm_s2"]]
        super().__init__(given | {"samples": " ".join(samples)})
        self.r = (forward + backward) / 2
        self.samples = [mpf(str(a)) / 1000 for a in case["base_acceleration_mm_s2"]]
        self.moved = [mpf(0), mpf(0)]

    def step(self, length, load, slope, foot):
        super().step(length, load - self.offset / self.m, slope, foot)

    def sample(self, series, h, load, slope, foot):
        before = self.x
        super().sample(series, h, load, slope, foot)
        end = sum(c * h**n for n, c in enumerate(series))
        self.moved[0 if end > before else 1] += abs(end - before)


def main():
    file = pathlib.Path(__file__).parent / "records.json"
    worst, wrong = mpf(0), 0
    for number, case in enumerate(json.loads(file.read_text(encoding="utf-8"))):
        body = Body(case)
        rest = body.follow()
        due = case["answer"]
        # The work of the load is that of the base's acceleration alone, without the constant part of friction.
        shift = body.offset * rest
        length = max(body.most["x"], -body.least["x"])
        speed = max(body.most["v"], -body.least["v"])
        work = abs(body.sums["load_work"] + shift)
        found = {
            "max_x": (body.most["x"], length),
            "min_x": (body.least["x"], length),
            "max_v": (body.most["v"], speed),
            "min_v": (body.least["v"], speed),
            "end_x": (body.end[0], length),
            "residual_x": (rest, length),
            "path": (body.sums["path"], length),
            "friction_work": (body.r * body.sums["path"] + shift, work),
            "damper_work": (body.sums["damper_work"], work),
            "load_work": (body.sums["load_work"] + shift, work),
        }
        off = {name: abs(value - mpf(str(due[name]))) / size for name, (value, size) in found.items()}
        ends = body.counts["stops"] + body.counts["reversals"]
        same = (body.counts["slides"], ends) == (due["slides"], due["stops"])
        name, most = max(off.items(), key=lambda item: item[1])
        print(f"record {number}: {name} is off by {float(most):.1e}")
        if not (same and most < mpf("1e-22")):
            wrong += 1
            print(f"  differs: {body.counts} for {due['slides']}, {due['stops']}", file=sys.stderr)
        worst = max(worst, most)
    print(f"{wrong} differ; {float(worst):.1e} at most")
    sys.exit(bool(wrong))


main()
