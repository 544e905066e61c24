"""References of enclosures: motions under records and steady motions, at 40 digits by mpmath.

    python3 tests/data/enclosed.py > tests/data/enclosed.json

Its text is its own. A slide is x = p + qt + ae^{λ₁t} + be^{λ₂t} with the complex roots λ of mλ² + cλ + k, or a power series in t
where there is no spring; its stop is the first sign change of x' among dense samples, bisected and polished by Newton's
method. A rest ends where the force, linear in t or a sine, reaches static friction. Extremes are the sign changes of derivatives
among the same samples. Works are integrals in closed form of products of exponentials. Inputs are binary fractions, so that
every reader has the same numbers.
"""

import json
import random

from mpmath import mp, mpc, mpf, pi

mp.dps = 50
random.seed(20)


def fraction(low, high, bits=10):
    """A binary fraction."""
    return mpf(random.randint(int(low * 2**bits), int(high * 2**bits))) / 2**bits


class Sum:
    """A real function Σ c e^{λt}·t^n, as a dictionary from (λ, n) to c."""

    def __init__(self, terms):
        self.terms = {}
        for key, value in terms:
            self.terms[key] = self.terms.get(key, mpc(0)) + value

    def at(self, t):
        return sum((c * mp.e ** (l * t) * t**n for (l, n), c in self.terms.items()), mpc(0)).real

    def derivative(self):
        new = []
        for (l, n), c in self.terms.items():
            new.append(((l, n), c * l))
            if n > 0:
                new.append(((l, n - 1), c * n))
        return Sum(new)

    def times(self, other):
        return Sum(
            [((l + m, n + o), c * d) for (l, n), c in self.terms.items() for (m, o), d in other.terms.items()]
        )

    def plus(self, other, factor=1):
        return Sum(list(self.terms.items()) + [(k, c * factor) for k, c in other.terms.items()])

    def integral(self, t):
        """∫₀ᵗ."""
        total = mpc(0)
        for (l, n), c in self.terms.items():
            if abs(l) < mpf(10) ** -30:
                total += c * mpf(t) ** (n + 1) / (n + 1)
            else:
                # ∫ tⁿe^{lt} = tⁿe^{lt}/l − n/l ∫ tⁿ⁻¹e^{lt}
                def part(n):
                    end = mp.e ** (l * t) * mpf(t) ** n - (1 if n == 0 else 0)
                    return end / l - (n / l * part(n - 1) if n > 0 else 0)

                total += c * part(n)
        return total.real


def first_sign_change(f, g, length, count, start):
    """The first time in (0, length] at which f falls below 0; g is its derivative. f ≥ 0 at first."""
    step = mpf(length) / count
    before = mpf(0)
    for i in range(1, count + 1):
        t = step * i
        if f.at(t) < 0:
            low, high = before, t
            if low == 0 and start:
                # It begins at 0 and rises: below its first zero it is positive.
                low = high / 2
                while f.at(low) < 0:
                    high, low = low, low / 2
            for _ in range(60):
                middle = (low + high) / 2
                if f.at(middle) >= 0:
                    low = middle
                else:
                    high = middle
            t = (low + high) / 2
            for _ in range(4):
                t -= f.at(t) / g.at(t)
            return t
        before = t
    return None


class Body:
    def __init__(self, m, c, k, r, eta, kind):
        self.m, self.c, self.k, self.r, self.held, self.kind = m, c, k, r, eta * r, kind
        disc = mp.sqrt(mpc(c * c - 4 * m * k))
        self.roots = [(-c + disc) / (2 * m), (-c - disc) / (2 * m)]

    def slide(self, x, v, load, sign):
        """x(t) of a slide from (x, v) under a load Σ, a force."""
        m, c, k = self.m, self.c, self.k
        force = load.plus(Sum([((mpc(0), 0), mpc(-sign * self.r))]))
        special = []
        for (l, n), value in force.terms.items():
            # m y″ + c y′ + k y = value tⁿ e^{lt}, n ≤ 1, l no root unless 0.
            a = m * l * l + c * l + k
            b = 2 * m * l + c
            if abs(a) > mpf(10) ** -30:
                if n == 0:
                    special.append(((l, 0), value / a))
                else:
                    special += [((l, 1), value / a), ((l, 0), -value * b / (a * a))]
            elif abs(b) > mpf(10) ** -30:
                # No spring: y′ = value (t/c − m/c²) for n = 1.
                if n == 0:
                    special.append(((l, 1), value / b))
                else:
                    special += [((l, 2), value / (2 * b)), ((l, 1), -value * m / (b * b))]
            else:
                special.append(((l, n + 2), value / (m * (n + 1) * (n + 2))))
        y = Sum(special)
        dx, dv = x - y.at(mpf(0)), v - y.derivative().at(mpf(0))
        l1, l2 = self.roots
        if abs(l1 - l2) > mpf(10) ** -15:
            a = (dv - l2 * dx) / (l1 - l2)
            free = [((l1, 0), a), ((l2, 0), dx - a)]
        else:
            free = [((l1, 0), mpc(dx)), ((l1, 1), dv - l1 * dx)]
        return Sum(list(y.terms.items()) + free)

    def rate(self):
        return max(mp.sqrt(self.k / self.m), self.c / self.m)


class Answer:
    def __init__(self, x, v, t):
        self.values = {}
        self.see("displacement", x, t)
        self.see("velocity", v, t)
        self.path = self.friction = self.damper = self.load = self.rest = mpf(0)
        self.slides = self.stops = self.reversals = 0
        # Places at which the body rests, and the work of a damper on the ground up to there.
        self.on_ground = mpf(0)
        self.turns = [] if v else [(x, mpf(0))]

    def see(self, name, value, t):
        # A velocity at a stop is zero.
        if name == "velocity" and abs(value) < mpf(10) ** -40:
            value = mpf(0)
        for key, better in (("max_" + name, lambda a, b: a > b), ("min_" + name, lambda a, b: a < b)):
            if key not in self.values or better(value, self.values[key][0]):
                self.values[key] = (value, t)

    def follow(self, name, f, length, count, time):
        """Sees f over a time: its ends and the sign changes of its derivative."""
        g = f.derivative()
        h = g.derivative()
        self.see(name, f.at(mpf(0)), time)
        self.see(name, f.at(length), time + length)
        values = [g.at(length * i / count) for i in range(count + 1)]
        for i in range(count):
            if values[i] * values[i + 1] < 0:
                low, high = length * i / count, length * (i + 1) / count
                sign = 1 if values[i] > 0 else -1
                for _ in range(30):
                    middle = (low + high) / 2
                    if sign * g.at(middle) > 0:
                        low = middle
                    else:
                        high = middle
                t = (low + high) / 2
                for _ in range(4):
                    t -= g.at(t) / h.at(t)
                self.see(name, f.at(t), time + t)


def motion(body, pieces, start, after, foot):
    """The motion through pieces (length, load, foot's velocity), and after them under a constant load to rest."""
    (x, v), time = start, mpf(0)
    answer = Answer(x, v, mpf(0))
    sign = (v > 0) - (v < 0)
    last_sign, rested = 0, mpf(0)
    if sign:
        answer.slides += 1
    end = None
    queue = list(pieces)
    while True:
        if queue:
            length, load, speed = queue.pop(0)
        elif end is None:
            end = (x, v, answer.rest)
            length, load, speed = None, Sum([((mpc(0), 0), mpc(after))]), mpf(0)
        else:
            break
        left = length
        shift = mpf(0)
        while left is None or left > mpf(10) ** -40:
            here = moved(load, shift)
            if sign == 0:
                pull = here.plus(Sum([((mpc(0), 0), mpc(-body.k * x))]))
                now = pull.at(mpf(0))
                wait = None
                if abs(now) > body.held * (1 + mpf(10) ** -35):
                    wait, sign = mpf(0), (1 if now > 0 else -1)
                elif left is None:
                    break
                else:
                    slope = pull.derivative().at(mpf(0))
                    target = 1 if slope > 0 else -1
                    if slope != 0:
                        t = (target * body.held - now) / slope
                        if t < left:
                            wait, sign = t, target
                span = left if wait is None else wait
                if span > 0:
                    rested += span
                    if end is None:
                        answer.rest += span
                    see_forces(answer, body, None, here, span, time, 1, 0)
                    answer.damper += body.c * speed**2 * span
                    time, shift, left = time + span, shift + span, left - span
                if wait is None:
                    break
                if last_sign and rested < mpf(10) ** -25:
                    answer.reversals += 1
                answer.slides += 1
                rested = mpf(0)
                continue
            f = body.slide(x, v, here, sign)
            g = f.derivative()
            h = g.derivative()
            period = 2 * pi / body.rate() if body.rate() > 0 else mpf(1)
            span = left if left is not None else (period * 20 if body.k > 0 else (abs(v) * body.m / body.r * 2))
            count = max(12, int(mp.ceil(span / period * 40)))
            forward = Sum([(key, sign * value) for key, value in g.terms.items()])
            slope = Sum([(key, sign * value) for key, value in h.terms.items()])
            t = first_sign_change(forward, slope, span, count, abs(v) < mpf(10) ** -45)
            passed = span if t is None else t
            if left is None and t is None:
                return None
            parts = max(6, int(mp.ceil(passed / period * 40)))
            answer.follow("velocity", g, passed, parts, time)
            see_forces(answer, body, f, here, passed, time, parts, sign)
            nx = f.at(passed)
            answer.path += abs(nx - x)
            answer.friction += body.r * abs(nx - x)
            between = g.plus(Sum([((mpc(0), 0), mpc(-speed))]))
            answer.damper += body.c * between.times(between).integral(passed)
            answer.load += here.times(g).integral(passed)
            answer.on_ground += body.c * g.times(g).integral(passed)
            x, v = nx, (g.at(passed) if t is None else mpf(0))
            time, shift = time + passed, shift + passed
            left = None if left is None else left - passed
            answer.see("displacement", x, time)
            if t is not None:
                last_sign, sign, rested = sign, 0, mpf(0)
                answer.stops += 1
                answer.turns.append((x, answer.on_ground))
    answer.stops -= answer.reversals
    return answer, end, x


def moved(load, shift):
    """A load as a function of the time since `shift`."""
    terms = []
    for (l, n), c in load.terms.items():
        factor = mp.e ** (l * shift)
        if n == 0:
            terms.append(((l, 0), c * factor))
        else:
            terms += [((l, 1), c * factor), ((l, 0), c * factor * shift)]
    return Sum(terms)


def see_forces(answer, body, f, load, length, time, parts, sign):
    """Acceleration in space and force on the support."""
    a = f.derivative().derivative() if f is not None else Sum([])
    if body.kind == "force":
        answer.follow("absolute", a, length, parts, time)
        answer.follow("transmitted", load.plus(a, -body.m), length, parts, time)
    elif body.kind == "surface":
        space = a.plus(load, -1 / body.m)
        answer.follow("absolute", space, length, parts, time)
        answer.follow("transmitted", Sum([(k, c * body.m) for k, c in space.terms.items()]), length, parts, time)
    else:
        answer.follow("absolute", a, length, parts, time)
        answer.follow("transmitted", Sum([(k, c * body.m) for k, c in a.terms.items()]), length, parts, time)


def greatest_cycle(body, answer):
    """The oscillator with a viscous damper of the longest swing between turning points and its mirror image."""
    kept = []
    for turn in answer.turns:
        if kept and turn[0] == kept[-1][0]:
            continue
        if len(kept) > 1 and (kept[-1][0] - kept[-2][0]) * (turn[0] - kept[-1][0]) > 0:
            kept.pop()
        kept.append(turn)
    names = ("cycle_amplitude", "equivalent_stiffness", "equivalent_damping_ratio")
    if len(kept) < 2:
        return dict.fromkeys(names)
    one, two = max(zip(kept, kept[1:]), key=lambda pair: abs(pair[1][0] - pair[0][0]))
    low, high = min(one[0], two[0]), max(one[0], two[0])
    secant = ((body.k * high + body.r) - (body.k * low - body.r)) / (high - low)
    amplitude = (high - low) / 2
    work = 2 * body.r * (high - low) + 2 * (two[1] - one[1])
    return dict(zip(names, map(digits, (amplitude, secant, work / (2 * pi * secant * amplitude**2)))))


def digits(x):
    return mp.nstr(x, 40)


def record_answer(kind, m, c, k, r, eta, step, samples, start):
    """The answers of a body under samples of a load; `None` where it does not come to rest."""
    body = Body(m, c, k, r, eta, kind)
    pieces = []
    for one, two in zip(samples, samples[1:]):
        slope = (two - one) / step
        factor = {"force": mpf(1), "surface": -m}.get(kind, k)
        rate = slope if kind == "damped-foot" else mpf(0)
        load = Sum([((mpc(0), 0), mpc(factor * one + c * rate)), ((mpc(0), 1), mpc(factor * slope))])
        pieces.append((step, load, rate))
    after = k * samples[-1] if kind in ("foot", "damped-foot") else mpf(0)
    found = motion(body, pieces, start, after, kind)
    if found is None:
        return None
    answer, end, last = found
    v = answer.values
    # A time is known where its extreme is the only one.
    result = {
        name + "_" + of: digits(v[name + "_" + of][0]) for name in ("max", "min") for of in ("displacement", "velocity")
    }
    for name in ("max_displacement", "min_displacement", "max_velocity", "min_velocity"):
        result[name + "_time"] = digits(v[name][1])
    result["max_absolute_acceleration"] = digits(max(abs(v["max_absolute"][0]), abs(v["min_absolute"][0])))
    result["max_transmitted_force"] = digits(max(abs(v["max_transmitted"][0]), abs(v["min_transmitted"][0])))
    result["end_displacement"], result["end_velocity"] = digits(end[0]), digits(end[1])
    result["residual_displacement"], result["path"] = digits(last), digits(answer.path)
    result["stick_time"] = digits(end[2])
    result["friction_work"], result["damper_work"] = digits(answer.friction), digits(answer.damper)
    result["load_work"] = digits(answer.load)
    result |= greatest_cycle(body, answer)
    result["peak_displacement"] = digits(max(abs(v["max_displacement"][0]), abs(v["min_displacement"][0])))
    result["slides"], result["stops"], result["reversals"] = answer.slides, answer.stops, answer.reversals
    return result


def record_case():
    kind = random.choice(["force", "surface", "foot", "damped-foot"])
    m = fraction(0.5, 4)
    has_spring = kind in ("foot", "damped-foot") or random.random() < 0.8
    k = fraction(20, 200) if has_spring else mpf(0)
    natural = mp.sqrt(k / m) if has_spring else mpf(5)
    zeta = random.choice([0, 0.05, 0.3, 0.7])
    c = fraction(0, 1) + mpf(round(float(2 * zeta * m * natural) * 64)) / 64 if zeta else mpf(0)
    r = fraction(1, 6)
    eta = random.choice([mpf(1), mpf(1), mpf("1.25")])
    step = mpf(random.choice([1, 2, 3, 5])) / 16
    count = random.randint(4, 8)
    size = {"force": 20, "surface": 10, "foot": 0.5, "damped-foot": 0.5}[kind]
    samples = [fraction(-size, size) for _ in range(count)]
    start = [fraction(-0.3, 0.3), fraction(-2, 2)] if random.random() < 0.5 else [mpf(0), mpf(0)]
    result = record_answer(kind, m, c, k, r, eta, step, samples, start)
    if result is None:
        return None
    number = lambda x: float(x)
    return {
        "kind": kind, "mass": number(m), "damping": number(c), "stiffness": number(k), "friction": number(r),
        "static_friction_ratio": number(eta), "time_step": number(step), "samples": [number(x) for x in samples],
        "start": [number(x) for x in start], "answer": result,
    }


def steady_case():
    """A steady motion in ratios: the cycle of two reversals by its own equation, or stops by following it."""
    omega = fraction(0.3, 2.5)
    zeta = random.choice([mpf(0), mpf("0.0625"), mpf("0.25"), mpf("1.5")])
    alpha = fraction(1.25, 4) if random.random() < 0.6 else fraction(2, 9)
    if abs(omega - 1) < 0.1 or (zeta == 0 and any(abs(omega - mpf(1) / n) < 0.01 for n in (1, 2, 3))):
        return None
    body = Body(mpf(1), 2 * zeta, mpf(1), mpf(1), mpf(1), "force")
    drive = lambda phase: Sum(
        [((mpc(0, omega), 0), alpha * mp.expj(phase) / mpc(0, 2)), ((mpc(0, -omega), 0), -alpha * mp.expj(-phase) / mpc(0, 2))]
    )
    period = 2 * pi / omega

    def half(x, v, phase, answer=None):
        """Half a turn of the drive from a state."""
        time, left, rests, zeros = mpf(0), period / 2, mpf(0), 0
        sign = (v > 0) - (v < 0)
        sticks = 0
        while left > mpf(10) ** -40:
            here = drive(phase + omega * time)
            if sign == 0:
                pull = here.plus(Sum([((mpc(0), 0), mpc(-x))]))
                if abs(pull.at(mpf(0))) > 1:
                    sign = 1 if pull.at(mpf(0)) > 0 else -1
                    continue
                times = []
                for s in (1, -1):
                    guard = Sum([(key, -s * value) for key, value in pull.terms.items()]).plus(Sum([((mpc(0), 0), mpc(1))]))
                    t = first_sign_change(guard, guard.derivative(), left, 40, False)
                    if t is not None:
                        times.append((t, s))
                span = min(times)[0] if times else left
                sign = min(times)[1] if times else 0
                sticks += 1
                rests += span
                if answer:
                    see_forces(answer, body, None, here, span, time, 40, 0)
                time, left = time + span, left - span
                continue
            f = body.slide(x, v, here, sign)
            g = f.derivative()
            h = g.derivative()
            count = max(16, int(mp.ceil(left * 20)))
            t = first_sign_change(
                Sum([(k, sign * c) for k, c in g.terms.items()]), Sum([(k, sign * c) for k, c in h.terms.items()]),
                left, count, abs(v) < mpf(10) ** -45,
            )
            passed = left if t is None else t
            if answer:
                answer.follow("velocity", g, passed, count, time)
                see_forces(answer, body, f, here, passed, time, count, sign)
                answer.friction += abs(f.at(passed) - x)
                answer.damper += 2 * zeta * g.times(g).integral(passed)
            x, v = f.at(passed), (g.at(passed) if t is None else mpf(0))
            time, left = time + passed, left - passed
            if t is not None:
                sign, zeros = 0, zeros + 1
            if answer:
                answer.see("displacement", x, time)
        return x, v, rests, zeros, sticks

    # Floats find the limit; Newton's method on the half turn makes it exact.
    # A phase at which the body slides serves it.
    mp.dps = 20
    for phase in (mpf(0), mpf(3) / 4, mpf(3) / 2, mpf(9) / 4):
        x, v = mpf(0), mpf(0)
        for i in range(16):
            nx, nv, *_ = half(x, v, phase)
            x, v = -nx, -nv
        if v != 0:
            break
    mp.dps = 50
    for i in range(12):
        nx, nv, *_ = half(x, v, phase)
        e = [-nx - x, -nv - v]
        if abs(e[0]) + abs(e[1]) < mpf(10) ** -44:
            break
        d = mpf(10) ** -22
        ax, av, *_ = half(x + d, v, phase)
        bx, bv, *_ = half(x, v + d if v >= 0 else v - d, phase)
        db = d if v >= 0 else -d
        j = [[(-ax + nx) / d - 1, (-bx + nx) / db], [(-av + nv) / d, (-bv + nv) / db - 1]]
        det = j[0][0] * j[1][1] - j[0][1] * j[1][0]
        if det == 0:
            return None
        x -= (e[0] * j[1][1] - e[1] * j[0][1]) / det
        v -= (j[0][0] * e[1] - j[1][0] * e[0]) / det
        if v == 0 or i > 10:
            break
    else:
        return None
    nx, nv, *_ = half(x, v, phase)
    if abs(-nx - x) + abs(-nv - v) > mpf(10) ** -42 or v == 0:
        return None
    answer = Answer(x, v, mpf(0))
    _, _, rests, zeros, sticks = half(x, v, phase, answer)
    vals = answer.values
    most = lambda of: max(abs(vals["max_" + of][0]), abs(vals["min_" + of][0]))
    reach = most("displacement")
    result = {
        "max_displacement": digits(reach),
        "max_velocity": digits(most("velocity") / omega),
        "stick_fraction": digits(2 * rests / period),
        "velocity_zeros_per_cycle": 2 * zeros,
        "sticks_per_cycle": 2 * sticks,
        "max_acceleration": digits(most("absolute") / omega**2),
        "transmitted_force": digits(most("transmitted")),
        "energy": digits(2 * answer.friction),
        "damper_work": digits(2 * answer.damper),
    }
    return {"omega": float(omega), "alpha": float(alpha), "damping_ratio": float(zeta), "answer": result}


def several(of, count):
    found = []
    while len(found) < count:
        case = of()
        if case is not None:
            found.append(case)
    return found


if __name__ == "__main__":
    import sys

    records, steady = (int(x) for x in (sys.argv[1:] or ("260", "60")))
    text = ",\n".join(json.dumps(case) for case in several(record_case, records))
    print('{"records": [\n' + text + '\n],\n"steady": [')
    print(",\n".join(json.dumps(case) for case in several(steady_case, steady)) + "\n]}")
