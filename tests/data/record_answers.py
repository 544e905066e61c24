"""Writes record_answers.csv: bodies under records with their answers to 30 digits, for `tests/records/references.rs`.

The motion is a power series of x in time on each of many short parts of a step, at 60 digits: its coefficients follow from
the equation of motion. A sign that changes between samples of a part leads to a zero by Newton's method inside a bisection.
Nothing here is a closed form of a slide.
"""

import random
import sys

from mpmath import mp, mpf, nstr

mp.dps = 60
TERMS = 44
SAMPLES = 4


def at(series, t, order):
    """The derivative of this order at t."""
    value = mpf(0)
    for n in range(len(series) - 1, order - 1, -1):
        factor = 1
        for k in range(order):
            factor *= n - k
        value = value * t + factor * series[n]
    return value


def zero(f, slope, low, high):
    """The zero of a function that changes its sign once between two times."""
    is_up = f(high) > 0
    t = (low + high) / 2
    for _ in range(300):
        value = f(t)
        if value == 0:
            return t
        if (value > 0) == is_up:
            high = t
        else:
            low = t
        steep = slope(t)
        following = t - value / steep if steep != 0 else low
        if not low < following < high:
            following = (low + high) / 2
        if abs(following - t) < mpf(10) ** -55 * (1 + abs(t)):
            return following
        t = following
    return t


class Body:
    def __init__(self, case):
        self.kind = case["excitation"]
        number = {k: mpf(v) for k, v in case.items() if k not in ("excitation", "samples")}
        self.m, self.k, self.c = number["mass"], number["stiffness"], number["damping"]
        self.r, self.eta, self.h = number["friction"], number["static_friction_ratio"], number["time_step"]
        self.samples = [mpf(s) for s in case["samples"].split()]
        self.x, self.v = number["x"], number["v"]
        self.sign = (self.v > 0) - (self.v < 0)
        self.before, self.has_rested = 0, False
        self.in_record = True
        self.most = {"x": self.x, "v": self.v, "a": mpf(0), "f": mpf(0)}
        self.least = {"x": self.x, "v": self.v}
        self.sums = dict.fromkeys(("path", "stick_time", "damper_work", "load_work"), mpf(0))
        self.counts = {"slides": int(self.sign != 0), "stops": 0, "reversals": 0}
        self.margin = mpf(1)

    def see(self, x, v, a, load):
        for name, value in (("x", x), ("v", v)):
            self.most[name] = max(self.most[name], value)
            self.least[name] = min(self.least[name], value)
        absolute, force = a, self.m * a
        if self.kind == "base_acceleration":
            absolute, force = a - load, self.m * (a - load)
        elif self.kind == "force":
            force = self.m * (a - load)
        self.most["a"] = max(self.most["a"], abs(absolute))
        self.most["f"] = max(self.most["f"], abs(force))

    def rest(self, load, slope, foot, left):
        """Rests for a time, at most that left, and is released then; the time."""
        held = self.eta * self.r / self.m
        g = load - self.k / self.m * self.x
        last = g + slope * left
        for value in (g, last):
            self.margin = min(self.margin, abs(abs(value) - held))
        after, sign = left, 0
        if abs(g) > held:
            after, sign = mpf(0), 1 if g > 0 else -1
        elif abs(last) > held:
            sign = 1 if last > 0 else -1
            after = (sign * held - g) / slope
        if after > 0:
            self.has_rested = True
            for t in (mpf(0), after):
                self.see(self.x, mpf(0), mpf(0), load + slope * t)
            if self.in_record:
                self.sums["stick_time"] += after
            self.sums["damper_work"] += self.c * foot**2 * after
        if sign:
            self.sign = sign
            self.counts["slides"] += 1
            if self.before and not self.has_rested:
                self.counts["reversals"] += 1
                self.counts["stops"] -= 1
        return after

    def step(self, length, load, slope, foot):
        rate, square = self.c / self.m, self.k / self.m
        part = min(length / 2, 1 / max(mp.sqrt(square), rate, mpf("1e-3") / length))
        t = mpf(0)
        while t < length:
            left = length - t
            if not self.sign:
                t += self.rest(load + slope * t, slope, foot, left)
                continue
            h, sign = min(part, left), self.sign
            push = load + slope * t - sign * self.r / self.m
            series = [self.x, self.v]
            for n in range(TERMS - 2):
                force = (push, slope)[n] if n < 2 else 0
                force -= rate * (n + 1) * series[n + 1] + square * series[n]
                series.append(force / ((n + 1) * (n + 2)))
            stop = self.stop(series, h, sign)
            h = h if stop is None else stop
            self.sample(series, h, load + slope * t, slope, foot)
            self.x, self.v = at(series, h, 0), at(series, h, 1)
            t += h
            if stop is not None:
                self.v, self.sign, self.before, self.has_rested = mpf(0), 0, sign, False
                self.counts["stops"] += 1

    def stop(self, series, h, sign):
        def f(t):
            return at(series, t, 1)

        def slope(t):
            return at(series, t, 2)

        start, end = sign * f(mpf(0)), sign * f(h)
        if start == 0:
            if end > 0:
                return None
            return zero(f, slope, h / 1000, h)
        if end <= 0:
            return zero(f, slope, mpf(0), h)
        if sign * slope(mpf(0)) < 0 < sign * slope(h):
            turn = zero(slope, lambda t: at(series, t, 3), mpf(0), h)
            least = sign * f(turn)
            self.margin = min(self.margin, abs(least))
            if least < 0:
                return zero(f, slope, mpf(0), turn)
        return None

    def sample(self, series, h, load, slope, foot):
        def state(t):
            values = [at(series, t, n) for n in range(4)]
            # The velocity at a stop is zero, but for the last digits of its time.
            return [mpf(0) if n == 1 and abs(value) < mpf(10) ** -50 else value for n, value in enumerate(values)]

        now, before = mpf(0), state(mpf(0))
        self.see(*before[:3], load)
        for i in range(1, SAMPLES + 1):
            t = h * i / SAMPLES
            after = state(t)
            self.see(*after[:3], load + slope * t)
            for order, shift in ((2, 0), (3, 0), (3, slope)):
                if (before[order] - shift) * (after[order] - shift) < 0 and self.in_reach(before, after):
                    turn = zero(
                        lambda t: at(series, t, order) - shift, lambda t: at(series, t, order + 1), now, t
                    )
                    self.see(*state(turn)[:3], load + slope * turn)
            now, before = t, after
        moved = before[0] - series[0]
        self.sums["path"] += abs(moved)
        # The integrals of v² and of (load + slope t) v, term by term.
        velocity = [(n + 1) * series[n + 1] for n in range(TERMS - 1)]
        relative = [velocity[0] - foot, *velocity[1:]]
        square = [sum(relative[i] * relative[n - i] for i in range(n + 1)) for n in range(TERMS - 1)]
        power = [load * velocity[n] + (slope * velocity[n - 1] if n else 0) for n in range(TERMS - 1)]
        self.sums["damper_work"] += self.c * sum(square[n] * h ** (n + 1) / (n + 1) for n in range(TERMS - 1))
        self.sums["load_work"] += self.m * sum(power[n] * h ** (n + 1) / (n + 1) for n in range(TERMS - 1))

    def in_reach(self, before, after):
        """Whether an extreme between these may be one of the whole motion."""
        speed = max(abs(before[1]), abs(after[1]))
        return self.in_record or 2 * speed > min(self.most["v"], -self.least["v"])

    def follow(self):
        factor = {"force": 1 / self.m, "base_acceleration": mpf(-1)}.get(self.kind, self.k / self.m)
        is_damped = self.kind == "damped_foot_displacement"
        for one, two in zip(self.samples, self.samples[1:]):
            slope = (two - one) / self.h
            foot = slope if is_damped else mpf(0)
            self.step(self.h, one * factor + self.c / self.m * foot, slope * factor, foot)
        self.end = (self.x, self.v)
        self.in_record = False
        load = self.samples[-1] * factor if "foot" in self.kind else mpf(0)
        if self.k == 0:
            pace = abs(self.v) * self.m / self.r + self.h
        else:
            pace = mp.sqrt(self.m / self.k)
        for _ in range(4000):
            counts = dict(self.counts)
            self.step(pace, load, mpf(0), mpf(0))
            if not self.sign and counts == self.counts:
                return self.x
            limit = (load - self.sign * self.r / self.m) * self.m / self.k if self.k else None
            if self.sign and self.k and abs(self.x - limit) + abs(self.v) * pace < mpf(10) ** -42:
                return limit
        return None


def drawn(rng):
    def number(low, high, digits=3):
        return f"{rng.uniform(low, high):.{digits}f}"

    kind = rng.choice(["force", "base_acceleration", "foot_displacement", "damped_foot_displacement"])
    mass = number(0.5, 4)
    has_spring = rng.random() < 0.8 or "foot" in kind
    stiffness = number(1, 60, 2) if has_spring else "0"
    critical = 2 * (float(mass) * float(stiffness)) ** 0.5 if has_spring else 2.0
    zeta = rng.choice([0, 0, rng.uniform(0.02, 0.3), rng.uniform(0.3, 0.9), rng.uniform(1.1, 2)])
    damping = f"{zeta * critical:.3f}" if zeta else "0"
    level = rng.uniform(1, 5)
    friction = number(0.05 * level, 0.6 * level)
    eta = rng.choice(["1", "1", number(1.05, 1.5, 2)])
    size = {"force": 1, "base_acceleration": 1 / float(mass)}.get(kind, 1 / float(stiffness) if has_spring else 1)
    samples = " ".join(number(-level * size, level * size, 4) for _ in range(rng.randint(3, 8)))
    x, v = (number(-0.3, 0.3), number(-0.5, 0.5)) if rng.random() < 0.3 else ("0", "0")
    names = "excitation mass stiffness damping friction static_friction_ratio time_step x v samples".split()
    values = [kind, mass, stiffness, damping, friction, eta, number(0.1, 0.6), x, v, samples]
    return dict(zip(names, values))


def main():
    rng = random.Random(6)
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 220
    rows = 0
    while rows < count:
        case = drawn(rng)
        body = Body(case)
        rest = body.follow()
        if rest is None or body.margin < mpf("1e-9"):
            continue
        answers = {
            "max_displacement": body.most["x"],
            "min_displacement": body.least["x"],
            "max_velocity": body.most["v"],
            "min_velocity": body.least["v"],
            "max_absolute_acceleration": body.most["a"],
            "max_transmitted_force": body.most["f"],
            "end_displacement": body.end[0],
            "end_velocity": body.end[1],
            "residual_displacement": rest,
            "path": body.sums["path"],
            "stick_time": body.sums["stick_time"],
            "friction_work": body.r * body.sums["path"],
            "damper_work": body.sums["damper_work"],
            "load_work": body.sums["load_work"],
        }
        if rows == 0:
            print(",".join([*case, *body.counts, *answers]))
        counts = [str(count) for count in body.counts.values()]
        print(",".join([*case.values(), *counts, *(nstr(value, 40) for value in answers.values())]))
        rows += 1


if __name__ == "__main__":
    main()
