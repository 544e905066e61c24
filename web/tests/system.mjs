// Two masses in the module against the command at $STICKSLIP_COMMAND: every number at $STICKSLIP_SYSTEMS random systems
// (250), digit for digit.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { random } from "./machines.mjs";
import { asker } from "./module.mjs";

const command = process.env.STICKSLIP_COMMAND || "stickslip";
const count = Number(process.env.STICKSLIP_SYSTEMS || 250);
const ask = await asker();
const folder = mkdtempSync(join(tmpdir(), "stickslip-system-"));
test.after(() => rmSync(folder, { recursive: true }));

// The description that the page writes.
const source = readFileSync(new URL("../page/system.js", import.meta.url), "utf8");
const body = [/const isStribeck = .*\n/, /const isCut = .*\n/, /function systemText\(of = two\) {[^]*?\n}\n/].map((part) => part.exec(source)[0]).join("");
const zero = (text) => Number.parseFloat(text) === 0;
const systemText = new Function("two", "isZero", `${body}; return systemText;`)({}, zero);
const columnsBody = /function systemColumns\(samples\) {[^]*?\n}\n/.exec(source)[0];
const systemColumns = new Function(`${columnsBody}; return systemColumns;`)();

function run(words) {
  const ran = spawnSync(command, words, { encoding: "utf8", maxBuffer: 1 << 28 });
  return ran.status === 0 ? ran.stdout : `error ${ran.stderr}`;
}

test("two masses are those of the command", (t) => {
  const next = random(7);
  const between = (low, high) => Number((low * (high / low) ** next()).toPrecision(6));
  const some = (part, text) => (next() < part ? text() : "");
  // Blows, Stribeck's law and loads of other shapes, beside the draws of the rest.
  const own = random(11);
  const span = (low, high) => Number((low * (high / low) ** own()).toPrecision(6));
  let [numbers, steady, borders, blows, curves, shapes, kinds, sampled] = [0, 0, 0, 0, 0, 0, new Map(), new Map()];
  for (let i = 0; i < count; i++) {
    const force = next() < 0.7;
    const of = {
      units: "N,mm", m1: `${between(50, 5000)} kg`, m2: `${between(50, 5000)} kg`, k1: some(0.85, () => `${between(20, 2000)} N/mm`), k2: `${between(20, 2000)} N/mm`,
      c1: some(0.7, () => `${between(0.02, 5)} N*s/mm`), c2: `${between(0.02, 5)} N*s/mm`, contact: ["ground,lower", "lower,upper", "ground,upper"][Math.floor(3 * next())],
      friction: `${between(20, 2000)} N`, elastic: some(0.3, () => `${between(50, 5000)} N/mm`), peak: "", stop: ["lower,upper", "ground,lower"][Math.floor(2 * next())],
      gap: some(0.25, () => `${between(0.1, 5)} mm`), stop_stiffness: `${between(500, 20000)} N/mm`, load: force ? ["lower", "upper"][Math.floor(2 * next())] : "base",
      amplitude: force ? `${between(100, 5000)} N` : `${between(0.02, 0.5)} g`, frequency: `${between(0.5, 12)} Hz`,
    };
    if (!of.elastic && next() < 0.25) of.peak = String(between(1.01, 1.8));
    // Without a belt the law alone: a friction that falls, and stays from a speed on.
    if (!of.elastic && next() < 0.15) Object.assign(of, { falls: `${between(10, 1000)} N`, over: `${between(0.01, 2)} m/s` });
    if (of.gap && own() < 0.5) Object.assign(of, { restitution: String(Number(own().toPrecision(3))), gap: `${span(0.01, 1)} mm` });
    if (of.falls && own() < 0.4) Object.assign(of, { law: "stribeck", exponent: own() < 0.5 ? "" : "1", viscous: own() < 0.5 ? "" : `${span(0.001, 0.1)} N*s/mm` });
    if (own() < 0.1) Object.assign(of, { shape: ["square", "triangle", "sawtooth", "pulse"][Math.floor(4 * own())], duty: String(Number((0.1 + 0.8 * own()).toPrecision(3))) });
    if (own() < 0.1) of.constant = force ? `${span(1, 200)} N` : `${span(0.001, 0.02)} g`;
    const text = systemText(of);
    const file = join(folder, "two.toml");
    writeFileSync(file, text);
    const due = run(["system", file, "steady", "--format", "json"]);
    let found;
    try {
      found = ask({ ask: "system", text, count: 3 });
    } catch (error) {
      assert.ok(due.startsWith("error") && due.includes(error.message.replace(/^system/, "").slice(0, 40)), `${error.message}\n${due}\n${text}`);
      continue;
    }
    const line = JSON.parse(due);
    assert.deepEqual(found.motion, line, text);
    kinds.set(line.kind, (kinds.get(line.kind) || 0) + 1);
    numbers += 4 * line.coordinates.length + 3 * line.elements.length + 2 * line.events.length + 2 * (line.multipliers?.length || 0) + 8;
    const ofBlows = line.events.filter((event) => event.velocity_before !== undefined).length;
    numbers += 2 * ofBlows;
    blows += ofBlows;
    if (line.laws) curves += 1;
    if (of.shape) shapes += 1;
    steady += 1;
    if (i % 10 === 0) {
      const rows = run(["system", file, "steady", "--samples", "3"]).trimEnd().split("\n").map((line) => line.split(","));
      if (found.samples) {
        const columns = systemColumns(found.samples);
        assert.deepEqual(Object.keys(columns), rows[0], text);
        Object.values(columns).forEach((list, k) => assert.deepEqual(list, rows.slice(1).map((row) => Number(row[k])), text));
        sampled.set(force, (sampled.get(force) || 0) + 1);
      }
      // The command begins a line with what is known of the digits.
      assert.ok(run(["system", file, "steady"]).replace("\n", " ").startsWith(found.verdict), found.verdict);
      const border = run(["system", file, "border", "--format", "json"]);
      if (found.border === null) assert.ok(border.startsWith("error"), border);
      else {
        assert.deepEqual(found.border, JSON.parse(border), text);
        assert.ok(run(["system", file, "border"]).startsWith(found.border_verdict));
        borders += 1;
      }
    }
  }
  assert.ok(steady > 0.9 * count, `${steady} of ${count}`);
  assert.ok(borders > count / 40, String(borders));
  assert.ok(sampled.get(true) > 0 && sampled.get(false) > 0, JSON.stringify([...sampled]));
  assert.ok(blows > count / 20 && curves > count / 100 && shapes > count / 40, `${blows} blows, ${curves} curves, ${shapes} shapes`);
  t.diagnostic(`${numbers} numbers of ${steady} systems, ${borders} borders, ${blows} blows, ${curves} curves, ${shapes} shapes; ${[...kinds].map(([kind, n]) => `${kind}: ${n}`).join(", ")}`);
});

test("two masses under a record are those of the command", () => {
  const text = systemText({ units: "N,mm", m1: "1 t", m2: "500 kg", k1: "200 N/mm", k2: "300 N/mm", c1: "0.3 N*s/mm", c2: "", contact: "ground,lower", friction: "450 N", stop: "lower,upper", gap: "1 mm", restitution: "0.3", load: "record", amplitude: "1 g", frequency: "1 Hz", constant: "1 g" });
  assert.doesNotMatch(text, /base|forces/);
  const [file, shake] = ["two-shaken.toml", "shake.csv"].map((name) => join(folder, name));
  const record = `Time (s);Acc (g)\n${Array.from({ length: 301 }, (_, i) => `${(i / 50).toFixed(2)};${(0.2 * Math.sin(i / 7) * Math.sin(i / 60)).toFixed(5)}`).join("\n")}\n`;
  writeFileSync(file, text);
  writeFileSync(shake, record);
  const found = ask({ ask: "system", text, record, name: shake, count: 3 });
  const due = JSON.parse(run(["system", file, "record", shake, "--format", "json"]));
  for (const [name, value] of Object.entries(found.motion)) assert.deepEqual(value, due[name], name);
  assert.ok(found.motion.duration === 6 && found.motion.events.some((event) => event.kind === "blow"), JSON.stringify(found.motion.events));
  const rows = run(["system", file, "record", shake, "--samples", "3"]).trimEnd().split("\n").map((line) => line.split(","));
  Object.values(systemColumns(found.samples)).forEach((list, k) => assert.deepEqual(list, rows.slice(1).map((row) => Number(row[k]))));
  const said = run(["system", file, "record", shake]);
  assert.ok(said.includes(found.verdict) && said.startsWith(found.read.slice(0, 60)), `${found.read}\n${said.slice(0, 300)}`);
});

test("a curve of two masses is that of the command", () => {
  const text = 'units = "kN,mm"\nmasses = { first = "20 t", second = "20 t" }\n[[springs]]\nbetween = ["ground", "first"]\nstiffness = "20 kN/mm"\ndamping = "0.02 kN*s/mm"\n[[springs]]\nbetween = ["first", "second"]\nstiffness = "20 kN/mm"\n[[contacts]]\nname = "damper"\nbetween = ["first", "second"]\nfriction = "100 kN"\nstiffness = "40 kN/mm"\n[base]\nacceleration = { amplitude = "0.2 g", frequency = "3 Hz" }\n';
  const file = join(folder, "curve.toml");
  writeFileSync(file, text);
  const rows = run(["system", file, "curve", "--frequency", "2Hz:5Hz:13"]).trimEnd().split("\n").map((line) => line.split(","));
  const column = (name) => rows[0].indexOf(name);
  const found = ask({ ask: "system-curve", text, frequencies: rows.slice(1).map((row) => Number(row[0])) });
  // Further places beside the peak, which none of these thirteen shows.
  const at = rows.slice(1).map((row) => found.frequency.findIndex((x) => Math.abs(x - Number(row[0])) < 1e-12));
  assert.ok(found.frequency.length > 30 && at.every((i) => i >= 0), String(found.frequency.length));
  const fine = run(["system", file, "curve", "--frequency", "2Hz:5Hz:601"]).trimEnd().split("\n").map((line) => line.split(","));
  found.coordinates.forEach((name, k) => {
    rows.slice(1).forEach((row, i) => {
      const [most, least] = [`${name}.max_displacement[mm]`, `${name}.min_displacement[mm]`].map((of) => Math.abs(Number(row[column(of)])));
      const due = Math.max(most, least);
      // Hertz become rad/s by another product of π.
      assert.ok(Math.abs(found.displacement[k][at[i]] / due - 1) < 1e-9, `${name} ${row[0]}: ${found.displacement[k][at[i]]} ${due}`);
    });
    const size = (row) => Math.max(...[`${name}.max_displacement[mm]`, `${name}.min_displacement[mm]`].map((of) => Math.abs(Number(row[column(of)]))));
    const [top, sampled] = [Math.max(...found.displacement[k]), Math.max(...fine.slice(1).map(size))];
    assert.ok(top >= sampled * (1 - 1e-9) && top < sampled * 1.002, `${name}: ${top} ${sampled}`);
    assert.ok(top > 1.002 * Math.max(...at.map((i) => found.displacement[k][i])), `${name}: ${top}`);
  });
});

test("a curve that is asked for in parts is that which is asked for at once", async () => {
  const text = systemText({ units: "N,mm", m1: "1 t", m2: "500 kg", k1: "200 N/mm", k2: "300 N/mm", c1: "0.3 N*s/mm", c2: "", contact: "ground,lower", friction: "450 N", stop: "lower,upper", gap: "", load: "upper", amplitude: "1.5 kN", frequency: "3 Hz" });
  const frequencies = Array.from({ length: 33 }, (_, i) => 1 + i / 8);
  const whole = { ask: "system-curve", text, frequencies };
  const at = (list) => ({ ...whole, frequencies: list, resolved: false });
  const coarse = ask(at(frequencies.filter((_, i) => i % 8 === 0)));
  assert.equal(coarse.frequency.length, 5);
  // Another system in between leaves nothing behind.
  const other = ask({ ...at([3]), text: text.replace("450 N", "500 N") });
  assert.notEqual(other.displacement[0][0], ask(at([3])).displacement[0][0]);
  ask(at(frequencies));
  const fresh = (await asker())(whole);
  assert.deepEqual(ask(whole), fresh);
  assert.ok(fresh.frequency.length > frequencies.length);
  for (const [i, frequency] of coarse.frequency.entries()) assert.equal(coarse.displacement[1][i], fresh.displacement[1][fresh.frequency.indexOf(frequency)]);
});

test("what is wrong with two masses is said by name", () => {
  const of = (change) => () => ask({ ask: "system", text: systemText({ units: "N,mm", m1: "1 t", m2: "1 t", k1: "1 N/mm", k2: "1 N/mm", c1: "", c2: "", contact: "ground,lower", friction: "1 N", elastic: "", peak: "", gap: "", stop: "lower,upper", stop_stiffness: "", load: "upper", amplitude: "2 N", frequency: "1 Hz", ...change }) });
  assert.throws(of({ m1: "-1 t" }), /masses\.lower -1 t: must be ≥ 0/);
  assert.throws(of({ friction: "1 kg" }), /friction 1 kg/);
  assert.throws(of({ peak: "0.5" }), /static_ratio 0\.5/);
  assert.throws(of({ m2: "1,200 kg" }), /1,200 kg/);
  assert.throws(() => ask({ ask: "system", text: "nonsense" }), /system/);
});
