#!/usr/bin/env python3
"""Recomputes the motions of tests/data/drives.json by the steps of systems.py, and fails where one differs from the file.

    python3 tests/data/drives.py        # needs numpy and scipy; `.ci/slow references` runs it
"""

import json
import math
import pathlib
import sys

from systems import System

GRAVITY = 9.80665
LATER = 1e6


def options(text):
    """The options of a command line, as numbers or words; those without a value are true."""
    given, words = {}, text.replace("=", " ").split()
    while words:
        name = words.pop(0).removeprefix("--")
        has_value = words and not words[0].startswith("--")
        given[name] = words.pop(0) if has_value else True
    return given


def system(given):
    def number(name, otherwise=0.0):
        text = str(given.get(name, otherwise))
        return math.radians(float(text[:-3])) if text.endswith("deg") else float(text.removesuffix("Hz"))

    mass, stiffness = number("mass"), number("stiffness")
    forward = number("friction")
    backward = number("friction-backward", forward)
    friction = (forward + backward) / 2
    contact = {"type": "contact", "direction": [1], "friction": friction}
    contact["peak"] = number("static-friction", friction) / friction
    model = {"mass": [[mass]], "damping": [[number("damping")]], "stiffness": [[stiffness]], "elements": [contact]}
    # Half the difference of the frictions is a constant force, and so is the weight along the slope, which falls forwards.
    constant = number("mean-force") - (forward - backward) / 2 + mass * GRAVITY * math.sin(number("slope"))
    force, shape = number("force"), given.get("shape", "sine")
    if shape == "sine":
        # Displacements count from that under the constant force.
        constant, phase = 0.0, number("phase")
        turned = {"sin": [force * math.cos(phase)], "cos": [force * math.sin(phase)]}
        model["harmonics"] = [{"frequency": number("frequency"), **turned}]
    elif shape == "step":
        constant += force
    elif shape == "ramp":
        rise = number("rise")
        model["record"] = {"times": [0, rise, LATER], "values": [0, force, force], "force": [1]}
    elif shape == "pull":
        pulled = stiffness * number("speed")
        model["record"] = {"times": [0, LATER], "values": [0, pulled * LATER], "force": [1]}
    return System(model, [constant], "one-way" in given), number


def main():
    file = pathlib.Path(__file__).parent / "drives.json"
    wrong = 0
    for case in json.loads(file.read_text(encoding="utf-8"))["cases"]:
        given = options(case["arguments"])
        body, number = system(given)
        worst = 0.0
        for place, due in enumerate(case["states"]):
            mode, z = body.begin([number("x0")], [number("v0")])
            if place:
                mode, z = body.follow(mode, z, place / number("rate"))
            worst = max(worst, *(abs(a - b) / size for a, b, size in zip(z[:2], due, case["scale"])))
        print(f"{case['arguments']}: {worst:.1e} of the scale")
        if not worst <= 1e-10:
            wrong += 1
    print(f"{wrong} differ")
    sys.exit(bool(wrong))


main()
