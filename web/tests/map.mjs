// The map against the verdict, at $STICKSLIP_POINTS random points (10,000): the code of the map and the sentences of the
// answer say the same.
import assert from "node:assert/strict";
import test from "node:test";
import { random } from "./machines.mjs";
import { asker } from "./module.mjs";

const count = Number(process.env.STICKSLIP_POINTS || 10000);
const ask = await asker();

// The code of a place, from the sentences alone.
function said(steady) {
  const text = steady.verdict;
  if (text === undefined) return -4;
  const stops = /Sticking: (\d+) stops? in a cycle/.exec(text);
  if (stops) return Number(stops[1]);
  if (text.startsWith("Sticking:")) return -6;
  if (text.startsWith("Non-sticking:")) return 0;
  if (text.startsWith("Stuck:")) return -1;
  if (text.startsWith("Irregular:")) return -2;
  if (text.startsWith("Undecided:")) return -3;
  if (text.startsWith("Unbounded:")) return -5;
  return assert.fail(text);
}

test("the map agrees with the verdict at every point", (t) => {
  const next = random(97);
  const seen = new Map();
  for (let i = 0; i < count; i++) {
    const omega = i % 7 === 0 ? Number((1 / Math.ceil(1 + 9 * next())).toPrecision(12)) : Number((2.4 * next() + 0.02).toPrecision(12));
    const alpha = Number((6 * next() + 0.05).toPrecision(12));
    const zeta = next() < 0.4 ? 0 : Number((0.2 * next()).toPrecision(12));
    const eta = next() < 0.6 ? 1 : Number((1 + 1.5 * next()).toPrecision(12));
    const [x, v] = next() < 0.7 ? [0, 0] : [Number((3 * next()).toPrecision(12)), Number((3 * next()).toPrecision(12))];
    const inputs = { omega: String(omega), alpha: String(alpha), damping_ratio: String(zeta), static_friction_ratio: String(eta), x0: String(x), v0: String(v) };
    const map = ask({ ask: "map", points: [omega, alpha], damping_ratio: zeta, static_friction_ratio: eta, x, v });
    const answer = ask({ ask: "answer", inputs });
    const where = `${JSON.stringify(inputs)}: ${answer.steady.verdict}`;
    assert.equal(map.stops[0], answer.place, where);
    assert.equal(map.stops[0], said(answer.steady), where);
    seen.set(map.stops[0], (seen.get(map.stops[0]) || 0) + 1);
  }
  for (const code of [0, -1, 1, 2, 4]) assert.ok(seen.get(code) > 0, `no point has ${code}`);
  t.diagnostic([...seen].sort(([a], [b]) => a - b).map(([code, n]) => `${code}: ${n}`).join(", "));
});

test("the machine of which the map spoke otherwise", () => {
  const inputs = { omega: "0.97", alpha: "4", damping_ratio: "0", static_friction_ratio: "1.3" };
  assert.match(ask({ ask: "answer", inputs }).steady.verdict, /never stops/);
  assert.deepEqual(ask({ ask: "map", omegas: [0.97], alphas: [4], static_friction_ratio: 1.3 }).stops, [0]);
  // Few periods leave it open, and say so.
  assert.deepEqual(ask({ ask: "map", omegas: [0.97], alphas: [4], static_friction_ratio: 1.3, periods: 3 }).stops, [-3]);
});
