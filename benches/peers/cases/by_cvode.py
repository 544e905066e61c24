"""CVODE of SUNDIALS on the case file, by scikit-sundae: modes with events at stops and releases.

Needs scikit-sundae:

    python benches/peers/cases/by_cvode.py tests/data/cases.json
"""

from sksundae.cvode import CVODE

from common import by_modes, main


def integrate(slope, event, direction, span, state, max_step, setting):
    # CVODE's own estimate of the first step is below the rounding of the time after a few hundred periods, and it prints a warning.
    tight = {"method": "Adams", "rtol": 1e-10, "atol": 1e-12, "first_step": 1e-6}
    options = {"default": {}, "tight": tight}[setting]

    def rhs(t, y, yp):
        yp[:] = slope(t, y)

    def events(t, y, found):
        found[0] = event(t, y)

    events.terminal, events.direction = [True], [int(direction)]
    limit = max_step if max_step < span[1] - span[0] else 0
    solver = CVODE(rhs, eventsfn=events, num_events=1, max_step=limit, max_num_steps=100_000, **options)
    found = solver.solve(span, state)
    return found.t[-1], found.y[-1], found.t_events is not None and len(found.t_events) > 0


main("CVODE", {"events": lambda *machine: by_modes(*machine, integrate)})
