"""This package on the case file, from rest, as one call for each case.

    python benches/peers/cases/by_stickslip.py tests/data/cases.json
"""

import stickslip

from common import main


def steady(omega, alpha, zeta, eta, setting):
    found = stickslip.steady(omega, alpha, zeta, eta)
    return max(found.max_displacement, -found.min_displacement), found.sticks_per_cycle, 0


steady(1.5, 2.5, 0, 1, "")  # loads the library
main("stickslip", {"steady": steady}, [""])
