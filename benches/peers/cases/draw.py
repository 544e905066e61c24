"""Draws the errors of every tool on the case file, and prints the table of docs/development/comparison.md.

    python benches/peers/cases/draw.py tests/data/cases.json docs/figures/cases.svg ANSWERS.tsv …
"""

import json
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "stickslip", "svg.fonttype": "none", "font.family": "sans-serif"})
import matplotlib.pyplot as plt

#: The marker and the grey of each tool: white, grey or black inside, so that they differ in print, too.
STYLES = {
    "SciPy, smoothed": ("s", "0.75"),
    "diffsol, smoothed": ("D", "white"),
    "OpenSees, stiff slider": ("P", "0.5"),
    "Siconos, relay": ("v", "white"),
    "SciPy, events": ("^", "0.75"),
    "CVODE, events": ("X", "white"),
    "diffsol, events": ("o", "0.75"),
    "stickslip, steady": ("*", "black"),
}
SETTINGS = ("default", "tight")
#: Smaller errors are drawn here.
LEAST = 1e-16


def read(cases, paths):
    """For each tool and setting the error, the surplus of stops and the time of each case."""
    answers = {}
    for path in paths:
        for line in open(path):
            tool, setting, name, greatest, stops, _, took = line.rstrip("\n").split("\t")
            exact = cases[name]["answer"]
            size = max(float(exact["max_displacement"]), -float(exact["min_displacement"]))
            answer = abs(float(greatest) / size - 1), int(stops) - exact["sticks_per_cycle"], float(took)
            answers.setdefault((tool, setting), {})[name] = answer
    return answers


def group(case):
    stops = case["answer"]["sticks_per_cycle"] > 0
    return stops + (stops and float(case["static_friction_ratio"]) > 1)


def draw(cases, answers, path):
    order = sorted(cases.values(), key=group)
    names = [case["name"] for case in order]
    figure, panels = plt.subplots(2, 1, figsize=(9, 9.5), sharex=True, sharey=True)
    for axes, setting in zip(panels, SETTINGS):
        for tool, (marker, inside) in STYLES.items():
            found = answers.get((tool, setting), answers.get((tool, "")))
            if found is None:
                continue
            errors = [max(found[name][0], LEAST) for name in names]  # NaN is not drawn
            axes.semilogy(names, errors, marker, ms=6, mfc=inside, mec="black", mew=0.7, label=tool)
        for edge in range(1, len(order)):
            if group(order[edge]) > group(order[edge - 1]):
                axes.axvline(edge - 0.5, color="black", lw=0.8)
        axes.set(ylabel=f"relative error, {setting} settings", ylim=(LEAST / 3, 3), xlim=(-0.7, len(names) - 0.3))
        axes.grid(axis="x", color="0.9", lw=0.5)
        axes.set_axisbelow(True)
    labels = ("without stops", "with stops", "with stops, η > 1")
    for number, label in enumerate(labels):
        places = [place for place, case in enumerate(order) if group(case) == number]
        panels[0].text((places[0] + places[-1]) / 2, 5, label, ha="center", va="bottom")
    panels[1].tick_params(axis="x", labelrotation=90, labelsize=7)
    panels[1].set_xlabel("case of tests/data/cases.json: Ω, α, ζ, η")
    figure.legend(*panels[0].get_legend_handles_labels(), loc="lower center", ncols=4, frameon=False)
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    figure.savefig(path, metadata={"Date": None})


def main():
    cases = {case["name"]: case for case in json.load(open(sys.argv[1]))["cases"]}
    answers = read(cases, sys.argv[3:])
    print("| tool and method | settings | within 10⁻³ | within 10⁻⁶ | stops right | time |\n|---|---|---|---|---|---|")
    for tool in STYLES:
        for setting in (*SETTINGS, ""):
            if (tool, setting) in answers:
                errors, stops, times = zip(*answers[tool, setting].values())
                within = [sum(error <= bound for error in errors) for bound in (1e-3, 1e-6)]
                print(f"| {tool} | {setting} | {within[0]} | {within[1]} | {stops.count(0)} | {float(f'{sum(times):.2g}'):g} s |")
    draw(cases, answers, sys.argv[2])


main()
