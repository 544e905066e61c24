#!/usr/bin/env python3
"""Motions of random machines with one body without mass, a joint, beside tests/data/joints.json: fails where one differs.

    python3 tests/data/joints.py                      # needs numpy and scipy; `.ci/slow references` runs it
    python3 tests/data/joints.py --write FILE COUNT   # COUNT machines into another file, as `.ci/slow joints` does

The joint stands between two other bodies, or between a body and the ground. Its velocity w is no state of its own: it is the root of a scalar equation,

    stuck to a neighbour        w is the neighbour's velocity
    held by dampers             C w = f - sum k (y - x) - sum T + sum c v
    held by springs             K w = f' + sum K v, the derivative of the balance; elastic contacts that hold are springs

Between events DOP853 follows the displacements, the velocities of the bodies with mass and the forces of elastic contacts at 1e-13. Each event is the zero of
a guard by Brent's method on the dense output. The state of all contacts after it is found by trying every one: it is taken if the forces
balance where the joint is, and a millionth of a second later no sliding contact has turned back and no force is beyond its bound.
"""

import itertools
import json
import pathlib
import random
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

TINY = 1e-6


class Machine:
    """A chain from the ground: link i joins the bodies i - 1 and i, with a spring, a damper and perhaps a contact."""

    def __init__(self, draw):
        self.n = 2 + draw.randrange(2)
        self.joint = draw.randrange(self.n)
        self.mass = [0.0 if i == self.joint else draw.uniform(0.5, 2.0) for i in range(self.n)]
        self.k = [draw.uniform(1.0, 5.0) for _ in range(self.n)]
        self.c = [draw.uniform(0.1, 0.6) if draw.random() < (0.25 if self.joint in (i, i - 1) else 0.7) else 0.0 for i in range(self.n)]
        # (link, friction, stiffness of an elastic contact)
        self.contacts = []
        for i in range(self.n):
            at_joint = self.joint in (i, i - 1)
            if draw.random() < (0.85 if at_joint else 0.5):
                self.contacts.append((i, draw.uniform(0.1, 0.8), draw.uniform(1.0, 6.0) if draw.random() < 0.3 else None))
        self.loads = [
            (draw.uniform(0.8, 1.2) * omega, [draw.uniform(-2.0, 2.0) if draw.random() < 0.6 else 0.0 for _ in range(self.n)]) for omega in (0.7, 1.3)
        ]
        self.heavy = [i for i in range(self.n) if i != self.joint]
        self.elastic = [e for e, (_, _, stiffness) in enumerate(self.contacts) if stiffness]

    def system(self):
        n = self.n
        matrices = {"damping": self.c, "stiffness": self.k}
        result = {"mass": np.diag(self.mass).tolist()}
        for name, values in matrices.items():
            matrix = np.zeros((n, n))
            for i, value in enumerate(values):
                b = self.direction(i)
                matrix += value * np.outer(b, b)
            result[name] = matrix.tolist()
        result["elements"] = [
            {"type": "elastic" if stiffness else "contact", "direction": self.direction(i).tolist(), "friction": friction} | ({"stiffness": stiffness} if stiffness else {})
            for i, friction, stiffness in self.contacts
        ]
        result["harmonics"] = [{"frequency": omega, "sin": sin} for omega, sin in self.loads]
        return result

    def direction(self, link):
        b = np.zeros(self.n)
        b[link] = 1.0
        if link:
            b[link - 1] = -1.0
        return b

    def load(self, t):
        return sum(np.array(sin) * np.sin(omega * t) for omega, sin in self.loads)

    def load_rate(self, t):
        return sum(np.array(sin) * omega * np.cos(omega * t) for omega, sin in self.loads)

    # The state: displacements of all, velocities of bodies with mass, forces of elastic contacts.
    def parts(self, z):
        n, h = self.n, len(self.heavy)
        velocity = np.zeros(n)
        velocity[self.heavy] = z[n : n + h]
        forces = dict(zip(self.elastic, z[n + h :]))
        return z[:n], velocity, forces

    def across(self, x, link):
        return x[link] - (x[link - 1] if link else 0.0)

    def solved(self, t, z, modes):
        """Velocities of all, accelerations, and the forces of all contacts: modes are 0 for stuck or holding, else the direction."""
        q, v, own = self.parts(z)
        j = self.joint
        links = [j] + ([j + 1] if j + 1 < self.n else [])
        other = {link: (j - 1 if link == j else j + 1) for link in links}
        speed = {link: (v[other[link]] if other[link] >= 0 else 0.0) for link in links}
        force = {}
        stuck = []
        for e, (link, friction, stiffness) in enumerate(self.contacts):
            if stiffness:
                force[e] = own[e] if modes[e] == 0 else modes[e] * friction
            elif modes[e]:
                force[e] = modes[e] * friction
            else:
                stuck.append(e)
        load, rate = self.load(t), self.load_rate(t)
        # What acts on each body but the contacts that are stuck, without the dampers of the joint.
        push = load.copy()
        for link in range(self.n):
            pull = self.k[link] * self.across(q, link)
            if link not in links:
                pull += self.c[link] * self.across(v, link)
            pull += sum(force[e] for e, (own_link, *_) in enumerate(self.contacts) if own_link == link and e in force)
            push[link] -= pull
            if link:
                push[link - 1] += pull
        at_joint = [e for e in stuck if self.contacts[e][0] in links]
        dampers = sum(self.c[link] for link in links)
        if at_joint:
            w = speed[self.contacts[at_joint[0]][0]]
        elif dampers:
            w = (push[j] + sum(self.c[link] * speed[link] for link in links)) / dampers
        else:
            hold = {link: self.k[link] + sum(s for e, (l, _, s) in enumerate(self.contacts) if l == link and s and modes[e] == 0) for link in links}
            w = (rate[j] + sum(hold[link] * speed[link] for link in links)) / sum(hold.values())
        self.unbalanced = 0.0 if at_joint or dampers else abs(push[j])
        v = v.copy()
        v[j] = w
        for link in links:
            pull = self.c[link] * self.across(v, link)
            push[link] -= pull
            if link:
                push[link - 1] += pull
        # M a + B T = push for the bodies with mass and, where a contact is stuck at it, the joint; what is stuck together accelerates together.
        h, count = len(self.heavy), len(stuck)
        rows, right = [], []
        for place, i in enumerate(self.heavy):
            row = np.zeros(h + count)
            row[place] = self.mass[i]
            row[h:] = [self.direction(self.contacts[e][0])[i] for e in stuck]
            rows.append(row)
            right.append(push[i])
        if at_joint:
            row = np.zeros(h + count)
            row[h:] = [self.direction(self.contacts[e][0])[j] for e in stuck]
            rows.append(row)
            right.append(push[j])
        constraints = [self.direction(self.contacts[e][0]) for e in stuck if e not in at_joint]
        if len(at_joint) == 2:
            constraints.append(sum(self.direction(self.contacts[e][0]) for e in at_joint))
        for b in constraints:
            row = np.zeros(h + count)
            row[:h] = b[self.heavy]
            rows.append(row)
            right.append(0.0)
        found = np.linalg.solve(np.array(rows), np.array(right)) if rows else np.zeros(0)
        force |= dict(zip(stuck, found[h:]))
        return v, found[:h], force

    def rates(self, t, z, modes):
        v, a, _ = self.solved(t, z, modes)
        springs = [self.contacts[e][2] * self.across(v, self.contacts[e][0]) if modes[e] == 0 else 0.0 for e in self.elastic]
        return np.concatenate([v, a, springs])

    def guards(self, t, z, modes):
        """Positive as long as the modes last: for each contact one number."""
        v, _, force = self.solved(t, z, modes)
        return np.array([
            modes[e] * self.across(v, link) if modes[e] else friction - abs(force[e]) for e, (link, friction, _) in enumerate(self.contacts)
        ])

    def stepped(self, t, z, modes, h):
        """A step of Runge and Kutta."""
        a = self.rates(t, z, modes)
        b = self.rates(t + h / 2, z + h / 2 * a, modes)
        c = self.rates(t + h / 2, z + h / 2 * b, modes)
        d = self.rates(t + h, z + h * c, modes)
        return z + h / 6 * (a + 2 * b + 2 * c + d)

    def at_bounds(self, z, modes):
        """The state with the forces of elastic contacts that yield at their bounds."""
        z = z.copy()
        for place, e in enumerate(self.elastic):
            if modes[e]:
                z[self.n + len(self.heavy) + place] = modes[e] * self.contacts[e][1]
        return z

    def next_modes(self, t, z):
        """The modes that last from this instant on."""
        q, v, own = self.parts(z)
        found = []
        for modes in itertools.product((0, 1, -1), repeat=len(self.contacts)):
            # What does not touch the joint keeps its velocity; an elastic contact yields at its bound only.
            if any(modes[e] and modes[e] * own[e] < self.contacts[e][1] - 1e-9 for e in self.elastic):
                continue
            is_wrong = False
            for e, (link, _, stiffness) in enumerate(self.contacts):
                speed = self.across(v, link)
                if self.joint in (link, link - 1):
                    continue
                is_wrong |= (modes[e] == 0 and not stiffness and abs(speed) > 1e-8) or (modes[e] != 0 and modes[e] * speed < -1e-8)
            stuck_joint = [e for e, (link, _, s) in enumerate(self.contacts) if not s and modes[e] == 0 and self.joint in (link, link - 1)]
            if len(stuck_joint) == 2:
                left = v[self.joint - 1] if self.joint else 0.0
                is_wrong |= abs(v[self.joint + 1] - left) > 1e-8
            if is_wrong:
                continue
            start = self.at_bounds(z, modes)
            # Springs alone hold the joint where the forces balance.
            self.solved(t, start, modes)
            if self.unbalanced > 1e-9:
                continue
            # Twice, so that what has only begun is seen, too.
            later = [(t + h, self.stepped(t, start, modes, h)) for h in (TINY / 4, TINY)]
            worst = [self.guards(*there, modes) for there in later]
            if all((guard > -1e-11).all() for guard in worst) and (worst[1] > worst[0] - 1e-11)[worst[0] < 1e-9].all():
                found.append((modes, start))
        return found

    def motion(self, until):
        t = 0.0
        z = np.zeros(self.n + len(self.heavy) + len(self.elastic))
        modes, z = self.next_modes(t, z)[0]
        events = []
        while t < until:
            watched = range(len(self.contacts))

            def lowest(time, state, which):
                return self.guards(time, state, modes)[which]

            def ends(which):
                def guard(time, state):
                    return lowest(time, state, which) + 1e-10
                guard.terminal, guard.direction = True, -1
                return guard

            # The guards are a little above 0, as those that begin at 0 are.
            done = solve_ivp(lambda time, state: self.rates(time, state, modes), (t, until), z, "DOP853", rtol=3e-14, atol=1e-15, dense_output=True, max_step=0.05, events=[ends(e) for e in watched])
            if done.status == 0:
                return done.y[:, -1], modes, events
            which = next(e for e in watched if len(done.t_events[e]))
            late = done.t[-1]
            early = max(t, late - 0.05)
            dense = done.sol
            # From the last place where the guard was certainly positive.
            while early > t and lowest(early, dense(early), which) <= 0:
                early = max(t, early - 0.01)
            if lowest(early, dense(early), which) > 0 > lowest(late, dense(late), which):
                late = brentq(lambda time: lowest(time, dense(time), which), early, late, xtol=1e-15, rtol=4e-15)
            t, z = late, dense(late)
            link = self.contacts[which][0]
            if modes[which] and self.joint not in (link, link - 1):
                z[self.n + self.heavy.index(link)] = self.parts(z)[1][link - 1] if link else 0.0
            before = modes
            found = self.next_modes(t, z)
            if not found:
                raise ArithmeticError(f"no modes at {t}")
            # The one that changes least, where several are within rounding.
            modes, z = min(found, key=lambda own: sum(a != b for a, b in zip(own[0], before)))
            if modes == before and len(found) > 1:
                modes, z = found[1]
            for e, (a, b) in enumerate(zip(before, modes)):
                if a != b:
                    names = ("yield", "lock") if self.contacts[e][2] else ("slip", "stick")
                    events.append([t, e, names[0] if a == 0 else names[1] if b == 0 else "reverse"])
        raise ArithmeticError("past the end")


def case(number):
    draw = random.Random(7_500 + number)
    machine = Machine(draw)
    while not machine.contacts or not any(any(sin) for _, sin in machine.loads):
        machine = Machine(draw)
    until = 8.0
    z, modes, events = machine.motion(until)
    v, _, _ = machine.solved(until, z, modes)
    return {
        "name": f"joint {number}",
        "system": machine.system(),
        "run": {"kind": "transient", "until": until},
        "answer": {"displacement": z[: machine.n].tolist(), "velocity": v.tolist(), "events": events},
    }


def all_of(count):
    for number in range(count):
        try:
            yield case(number)
        except ArithmeticError as error:
            print(f"joint {number}: {error}", file=sys.stderr)


def main():
    if "--write" in sys.argv:
        place = sys.argv.index("--write")
        file, count = sys.argv[place + 1 : place + 3]
        lines = ",\n".join(json.dumps(own) for own in all_of(int(count)))
        pathlib.Path(file).write_text(f"[\n{lines}\n]\n")
        return
    file = pathlib.Path(__file__).with_suffix(".json")
    kept = json.loads(file.read_text())
    worst = 0.0
    for own in kept:
        found = case(int(own["name"].split()[1]))["answer"]
        if [event[1:] for event in found["events"]] != [event[1:] for event in own["answer"]["events"]]:
            sys.exit(f"{own['name']}: other events")
        for name in ("displacement", "velocity"):
            worst = max(worst, np.abs(np.array(found[name]) - np.array(own["answer"][name])).max())
    print(f"{len(kept)} machines with joints, at most {worst:.1e} apart")
    if worst > 1e-11:
        sys.exit("beyond 1e-11")


if __name__ == "__main__":
    main()
