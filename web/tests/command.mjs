// The module against the command at $STICKSLIP_COMMAND: every number at $STICKSLIP_MACHINES random machines (10,000), digit
// for digit.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { machines, random } from "./machines.mjs";
import { asker, glue } from "./module.mjs";

const command = process.env.STICKSLIP_COMMAND || "stickslip";
const count = Number(process.env.STICKSLIP_MACHINES || 10000);
const ask = await asker();
const folder = mkdtempSync(join(tmpdir(), "stickslip-page-"));

// The lines that the command prints for machines of one kind, one for each.
function answers(name, columns, rows) {
  const file = join(folder, "points.csv");
  writeFileSync(file, `${columns.join(",")}\n${rows.map((row) => row.join(",")).join("\n")}\n`);
  const ran = spawnSync(command, [name, "--points", file, "--format", "jsonl"], { encoding: "utf8", maxBuffer: 1 << 30 });
  assert.equal(ran.status, 0, ran.stderr);
  return ran.stdout.trimEnd().split("\n").map((line) => JSON.parse(line));
}

// The fields of a line that the page has, too.
function compared(values, line, where) {
  let fields = 0;
  for (const { name, value, physical } of values) {
    assert.ok(name in line, `${where}: the command has no ${name}`);
    assert.deepEqual(value, line[name], `${where}: ${name}`);
    fields += 1;
    if (physical) {
      assert.deepEqual(physical.value, line.physical[physical.name], `${where}: ${physical.name}`);
      assert.equal(physical.unit, line.physical.units[physical.name], `${where}: unit of ${physical.name}`);
      fields += 1;
    }
  }
  return fields;
}

test.after(() => rmSync(folder, { recursive: true }));

test("every number is that of the command", (t) => {
  let [points, fields] = [0, 0];
  for (const { columns, rows } of machines(count)) {
    const [response, steady] = ["response", "steady"].map((name) => answers(name, columns, rows));
    assert.equal(response.length, rows.length);
    rows.forEach((row, i) => {
      const inputs = Object.fromEntries(columns.map((name, j) => [name, String(row[j])]));
      const where = JSON.stringify(inputs);
      const found = ask({ ask: "answer", inputs });
      fields += compared(found.values, response[i], where);
      fields += compared(found.steady.values, steady[i], where);
      for (const name of ["omega", "alpha"]) assert.equal(found[name], response[i][name], where);
      for (const { name, value, unit } of found.machine || []) {
        assert.equal(value, response[i].physical[name], `${where}: ${name}`);
        assert.equal(unit, response[i].physical.units[name], `${where}: unit of ${name}`);
        fields += 1;
      }
      points += 1;
    });
  }
  assert.ok(fields > 50 * points, String(fields));
  t.diagnostic(`${fields} numbers of ${points} machines`);
});

test("a machine in units is that of the command, whichever inputs give it", () => {
  const base = { mass: "2 t", stiffness: "80 kN/m", friction: "0.5 kN", force: "1.6 kN", frequency: "1.5 Hz" };
  const without = (...names) => Object.fromEntries(Object.entries(base).filter(([name]) => !names.includes(name)));
  const all = [
    { ...base, friction_backward: "0.3 kN" },
    { ...base, friction_backward: "0.3 kN", mean_force: "0.1 kN", static_friction_ratio: "1.2", damping_ratio: "2 %" },
    { ...base, friction: "0 kN", damping_ratio: "2 %" },
    { ...without("friction", "force"), friction_coefficient: "0.02", base_velocity: "20 mm/s" },
    { ...without("force"), unbalance: "6 kg*m", static_friction: "0.6 kN" },
    { ...without("force"), damped_foot_displacement: "30 mm", damping: "3 kN*s/m" },
    { ...base, force: "0 N", x0: "50 mm" },
  ];
  for (const inputs of all) {
    const options = Object.entries(inputs).flatMap(([name, text]) => [`--${name.replaceAll("_", "-")}`, text.replace(" ", "")]);
    const ran = spawnSync(command, ["steady", ...options, "--format", "json"], { encoding: "utf8" });
    assert.equal(ran.status, 0, `${options}: ${ran.stderr}`);
    const { physical } = JSON.parse(ran.stdout);
    const { machine, kinds } = ask({ ask: "answer", inputs });
    for (const { name, value, unit } of machine) {
      assert.equal(value, physical[name], `${JSON.stringify(inputs)}: ${name}`);
      assert.equal(unit, physical.units[name], `${JSON.stringify(inputs)}: unit of ${name}`);
    }
    // The friction against forward motion is the typed one.
    if (inputs.friction_backward) assert.equal(machine.find(({ name }) => name === "friction").value, 500);
    // So is the one that a switch from another kind of friction writes into its field.
    if (inputs.friction_backward) assert.equal(kinds.friction.value, 500);
    for (const name of Object.keys(inputs)) if (name in physical) assert.ok(machine.some((row) => row.name === name), name);
  }
});

test("sentences and numbers are written as the command writes them", () => {
  let texts = 0;
  for (const { columns, rows } of machines(80)) {
    for (const row of rows) {
      const options = columns.flatMap((name, j) => [`--${name.replaceAll("_", "-")}`, String(row[j])]);
      const ran = spawnSync(command, ["steady", ...options], { encoding: "utf8" });
      assert.equal(ran.status, 0, ran.stderr);
      const inputs = Object.fromEntries(columns.map((name, j) => [name, String(row[j])]));
      const { verdict, values } = ask({ ask: "answer", inputs }).steady;
      assert.ok(ran.stdout.includes(verdict), `${verdict}\n${ran.stdout}`);
      const velocity = values.find(({ name }) => name === "max_velocity");
      // The text of a body at rest has no velocity.
      if (!velocity.value) continue;
      const written = /maximum velocity +(\S+)[^=\n]*(?:= (\S+))?/.exec(ran.stdout);
      assert.equal(glue.digits(velocity.value), written[1], ran.stdout);
      if (velocity.physical) assert.equal(glue.digits(velocity.physical.value), written[2], ran.stdout);
      texts += 1;
    }
  }
  assert.ok(texts > 30, String(texts));
});

test("designs are those of the command", () => {
  const machine = { mass: "50 t", stiffness: "1000 kN/m", friction: "5 kN", damping_ratio: "2 %", force: "12 kN", frequency: "1 Hz" };
  const found = ask({ ask: "design", inputs: machine, units: "kN,m" });
  const value = (name) => found.find((row) => row.name === name).value;
  const run = (question, leave) => {
    const given = Object.entries(machine).filter(([name]) => name !== leave);
    const options = given.flatMap(([name, text]) => [`--${name.replaceAll("_", "-")}`, text.replaceAll(" ", "")]);
    const ran = spawnSync(command, ["design", question, ...options, "--units", "kN,m", "--format", "json"], { encoding: "utf8" });
    assert.equal(ran.status, 0, ran.stderr);
    return JSON.parse(ran.stdout);
  };
  const [force, friction, best] = [run("force", "force"), run("friction", "friction"), run("dissipation", "friction")];
  assert.equal(value("force"), force.force);
  assert.equal(value("unbalance"), force.unbalance);
  assert.equal(value("foot_displacement"), force.foot_displacement);
  assert.equal(value("base_displacement"), force.base_displacement);
  assert.equal(value("friction"), friction.friction);
  assert.equal(value("best_friction"), best.friction);
  assert.equal(value("energy"), best.energy);
  // With a higher static friction the words are others, and the numbers are those of the command.
  const held = ask({ ask: "design", inputs: { ...machine, static_friction_ratio: "1.3" }, units: "kN,m" });
  machine.static_friction_ratio = "1.3";
  const [more, less] = [run("force", "force"), run("friction", "friction")];
  const heldValue = (name) => held.find((row) => row.name === name).value;
  assert.equal(heldValue("cycle_force"), more.force);
  assert.equal(heldValue("release_force"), more.release_force);
  assert.equal(heldValue("every_start_force"), more.every_start_force);
  assert.equal(held.find((row) => row.name === "force"), undefined);
  assert.equal(heldValue("cycle_friction"), less.friction);
});

test("curves, maps and limits are those of the command", () => {
  const run = (...words) => {
    const ran = spawnSync(command, words, { encoding: "utf8", maxBuffer: 1 << 28 });
    assert.equal(ran.status, 0, ran.stderr);
    return ran.stdout;
  };
  const rows = (text) => text.trimEnd().split("\n").slice(1).map((line) => line.split(","));
  let points = 0;
  for (const [alpha, zeta] of [[1.3, 0.02], [2.5, 0], [4, 0.05], [20, 0.7]]) {
    const inputs = { omega: "0.7", alpha: String(alpha), damping_ratio: String(zeta) };
    const options = ["--alpha", String(alpha), "--damping-ratio", String(zeta)];
    const curve = ask({ ask: "curve", inputs, from: 0.2, to: 3, count: 60 });
    const due = new Map(rows(run("response-curve", "displacement", "--omega", curve.omega.join(","), ...options)).map((row) => [Number(row[1]), row]));
    curve.omega.forEach((omega, i) => {
      const [, , regime, value] = due.get(omega);
      assert.equal(curve.regime[i], regime, `${omega} ${alpha}`);
      if (value !== "") assert.equal(curve.displacement[i] / alpha, Number(value), `${omega} ${alpha} ${zeta}`);
      else assert.equal(curve.displacement[i], null);
      points += 1;
    });
    const [omegas, alphas] = [[0.1, 0.25, 0.4, 0.7, 1, 1.9], [0.5, 1.2, 2.5, 4.5]];
    const map = ask({ ask: "map", omegas, alphas, border: omegas, damping_ratio: zeta });
    rows(run("map", "stops", "--omega", omegas.join(","), "--alpha", alphas.join(","), "--damping-ratio", String(zeta))).forEach(([omega, height, stops], i) => {
      assert.deepEqual([omegas[i % 6], alphas[Math.floor(i / 6)]], [Number(omega), Number(height)]);
      assert.equal(map.stops[i] < 0 ? "" : String(map.stops[i]), stops, `${omega} ${height} ${zeta}`);
    });
    omegas.forEach((omega, i) => {
      assert.equal(map.border[i], JSON.parse(run("border", "--omega", String(omega), "--damping-ratio", String(zeta), "--format", "json")).min_force_ratio);
    });
  }
  assert.ok(points > 230, String(points));
  for (const [omega, alpha, zeta, eta] of [[0.5, 4, 0.02, 1.3], [0.5, 4, 0, 5], [0.3, 1.2, 0, 1.5], [2, 3, 0.1, 1.8], [1.2, 8, 0.01, 2]]) {
    const inputs = { omega: String(omega), alpha: String(alpha), damping_ratio: String(zeta), static_friction_ratio: String(eta) };
    const options = Object.entries(inputs).flatMap(([name, value]) => [`--${name.replaceAll("_", "-")}`, value]);
    const due = JSON.parse(run("attractors", ...options, "--starts", "64", "--format", "json"));
    const found = ask({ ask: "limits", inputs, count: 64 });
    assert.deepEqual([found.starts, found.reach, found.unsettled, found.limits.length], [due.starts, due.reach, due.unsettled, due.attractors.length]);
    found.limits.forEach((row, i) => {
      const own = due.attractors[i];
      assert.deepEqual([row.limit, row.share, row.stops], [own.limit, own.share, own.sticks_per_cycle]);
      if (row.extrema) assert.deepEqual(row.extrema, [own.min_displacement, own.max_displacement]);
      if (row.range) assert.deepEqual(row.range, [own.rest_from, own.rest_to]);
      assert.equal(row.mirror === null ? null : row.mirror + 1, own.mirror);
    });
  }
});

test("a curve is resolved where the command resolves it", (t) => {
  let [peaks, onsets, most] = [0, 0, 0];
  const machines = [
    [{ omega: "0.7", alpha: "1.3", damping_ratio: "0.002" }, [0.2, 3]], [{ omega: "0.7", alpha: "4", damping_ratio: "0" }, [0.1, 5]],
    [{ omega: "0.7", alpha: "20", damping_ratio: "0.01" }, [0.1, 5]],
    [{ mass: "53.27", stiffness: "86.8", friction: "1.263", damping: "2.72", damped_foot_displacement: "0.0873", frequency: "1" }, [0.05, 3]],
    [{ mass: "800", stiffness: "6525", friction: "392", damping: "40", base_displacement: "0.01", frequency: "12" }, [0.1, 8]],
  ];
  for (const [inputs, [from, to]] of machines) {
    const plain = ask({ ask: "curve", inputs, from, to, count: 40 });
    const found = ask({ ask: "curve", inputs, omegas: plain.omega, from, to, resolved: true });
    const given = Object.entries(inputs).filter(([name]) => name !== "frequency" && name !== "omega");
    const options = given.flatMap(([name, value]) => [`--${name.replaceAll("_", "-")}`, value]);
    const isMachine = "mass" in inputs;
    const natural = 2 * Math.PI * found.natural;
    const axis = isMachine ? ["--frequency", `${from * natural}:${to * natural}:40:log`] : ["--omega", `${from}:${to}:40:log`];
    const ran = spawnSync(command, ["response-curve", "displacement", ...axis, ...options], { encoding: "utf8" });
    assert.equal(ran.status, 0, ran.stderr);
    const rows = ran.stdout.trimEnd().split("\n").slice(1).map((line) => line.split(","));
    const scale = isMachine ? 1 : Number(inputs.alpha);
    const of = (name) => rows.filter((row) => row[5] === name).map((row) => [isMachine ? Number(row[1]) / found.natural : Number(row[1]), row[3] === "" ? Infinity : Number(row[3]) * scale]);
    const own = (name) => found.omega.flatMap((omega, i) => (found.point[i] === name ? [[omega, found.displacement[i] ?? Infinity]] : []));
    for (const name of ["peak", "onset"]) {
      const [due, here] = [of(name), own(name)];
      assert.equal(here.length, due.length, `${name} of ${JSON.stringify(inputs)}`);
      due.forEach(([omega, value], i) => {
        // The place of a smooth maximum is known to the root of its height's rounding; that of an onset to the rounding of
        // the frequency, which the two have in different units. The motion begins at 0 there.
        assert.ok(Math.abs(here[i][0] / omega - 1) < (name === "peak" ? 1e-4 : 1e-14), `${name} ${omega} ${here[i][0]}`);
        if (name === "peak" && Number.isFinite(value)) {
          const off = Math.abs(here[i][1] / value - 1);
          most = Math.max(most, off);
          // The tolerance of the search, in the height.
          assert.ok(off < 1e-9, `${name} ${value} ${here[i][1]}`);
        }
        if (name === "peak") peaks += 1;
        else onsets += 1;
      });
    }
  }
  assert.ok(peaks > 8 && onsets >= 2, `${peaks} ${onsets}`);
  t.diagnostic(`${peaks} peaks and ${onsets} onsets; heights agree to ${most}`);
});

test("a body that drifts is that of the command", () => {
  const next = random(6);
  const between = (low, high) => Number((low * (high / low) ** next()).toPrecision(6));
  let drifting = 0;
  for (let i = 0; i < 12; i++) {
    const [name, size] = [["force", `${between(6, 40)} N`], ["base_acceleration", `${between(3, 30)} m/s^2`], ["unbalance", `${between(0.1, 1)} kg*m`]][i % 3];
    const inputs = { mass: `${between(1, 4)} kg`, stiffness: "0", friction: `${between(1, 8)} N`, [name]: size, frequency: `${between(0.5, 9)} Hz`, mean_force: `${i % 2 ? "-" : ""}${between(0.05, 0.9)} N` };
    if (i % 4 === 1) inputs.damping = `${between(0.1, 9)} N*s/m`;
    if (i % 4 === 2) inputs.static_friction_ratio = String(between(1.05, 1.6));
    const options = Object.entries(inputs).map(([own, text]) => `--${own.replaceAll("_", "-")}=${text}`);
    const where = JSON.stringify(inputs);
    const run = (...more) => {
      const ran = spawnSync(command, [...more, ...options], { encoding: "utf8" });
      assert.equal(ran.status, 0, `${where}: ${ran.stderr}`);
      return ran.stdout;
    };
    const found = ask({ ask: "answer", inputs });
    assert.deepEqual(found.drift, JSON.parse(run("steady", "--format", "json")), where);
    assert.ok(run("steady").startsWith(found.verdict), where);
    drifting += found.drift.drift?.[0] !== 0;
    // The motion ends where the drift says, and its load, friction and velocity balance over the cycle.
    const motion = ask({ ask: "motion", inputs, count: 2000 });
    if (!motion.steady) continue;
    const [from, to] = [motion.displacement[0], motion.displacement.at(-1)];
    assert.ok(Math.abs(to - from - found.drift.drift[0]) <= 1e-9 * (1 + Math.abs(to)), `${where}: ${to - from}`);
    const mean = motion.friction.slice(1).reduce((sum, x) => sum + x, 0) / (motion.friction.length - 1);
    const damper = (parseFloat(inputs.damping ?? "0") * (to - from)) / motion.time.at(-1);
    assert.ok(Math.abs(mean + damper - parseFloat(inputs.mean_force)) < 0.01 * parseFloat(inputs.friction), `${where}: ${mean}`);
  }
  assert.ok(drifting > 6, String(drifting));
});

test("a body without a spring is that of the command", (t) => {
  const next = random(5);
  const between = (low, high) => Number((low * (high / low) ** next()).toPrecision(6));
  let fields = 0;
  for (let i = 0; i < 12; i++) {
    const [name, size] = [["force", `${between(2, 40)} N`], ["base_acceleration", `${between(1, 30)} m/s^2`], ["unbalance", `${between(0.05, 1)} kg*m`]][i % 3];
    const inputs = { mass: `${between(1, 4)} kg`, stiffness: "0", friction: `${between(1, 8)} N`, [name]: size, frequency: `${between(0.5, 9)} Hz` };
    if (i % 4 === 1) inputs.damping = `${between(0.1, 9)} N*s/m`;
    if (i % 4 === 2) inputs.static_friction_ratio = String(between(1.05, 1.6));
    const options = Object.entries(inputs).flatMap(([own, text]) => [`--${own.replaceAll("_", "-")}`, text]);
    const line = (ask) => {
      const ran = spawnSync(command, [ask, ...options, "--format", "json"], { encoding: "utf8" });
      assert.equal(ran.status, 0, ran.stderr);
      return JSON.parse(ran.stdout);
    };
    const where = JSON.stringify(inputs);
    const found = ask({ ask: "answer", inputs });
    assert.ok(found.is_without_spring && found.omega === null && found.damping_ratio === null, where);
    fields += compared(found.values, line("response"), where);
    const steady = line("steady");
    fields += compared(found.steady.values, steady, where);
    for (const { name, value } of found.machine) assert.equal(value, steady.physical[name], `${where}: ${name}`);
    assert.ok(!found.machine.some((own) => ["period", "natural_frequency", "friction_displacement"].includes(own.name)));
    const text = spawnSync(command, ["steady", ...options], { encoding: "utf8" }).stdout;
    assert.ok(text.includes(found.steady.verdict) && found.notes.every((note) => text.includes(note)), `${found.steady.verdict}\n${text}`);
    // The curve is about the frequency of the drive. The command has none with a static friction.
    if (inputs.static_friction_ratio) continue;
    const curve = ask({ ask: "curve", inputs, from: 0.5, to: 2, count: 5 });
    const without = options.filter((_, k) => !(options[k] === "--frequency" || options[k - 1] === "--frequency"));
    const ran = spawnSync(command, ["response-curve", "displacement", ...without, "--frequency", curve.frequency.map((f) => `${f}Hz`).join(",")], { encoding: "utf8" });
    assert.equal(ran.status, 0, ran.stderr);
    const due = ran.stdout.trimEnd().split("\n").slice(1).map((row) => row.split(",")).filter((row) => row.at(-1) === "grid");
    assert.equal(due.length, curve.frequency.length);
    due.forEach((row, k) => assert.ok(Math.abs(curve.displacement[k] - Number(row[3])) <= 1e-12 * Math.abs(Number(row[3])), `${where}: ${row} ${curve.displacement[k]}`));
  }
  // In closed form, without a stop: √(α² − π²/4) r_y/(m ω_d²).
  const found = ask({ ask: "answer", inputs: { mass: "2", stiffness: "0", friction: "3", force: "9", frequency: "5" } });
  const peak = found.steady.values.find((row) => row.name === "max_displacement");
  assert.ok(Math.abs(peak.physical.value / ((Math.sqrt(9 - Math.PI ** 2 / 4) * 3) / 50) - 1) < 1e-14 && peak.value === null);
  const rows = ask({ ask: "design", inputs: { mass: "2", stiffness: "0", friction: "3", force: "9", frequency: "5" } });
  assert.ok(Math.abs(rows.find((row) => row.name === "force").value / (3 * Math.hypot(1, Math.PI / 2)) - 1) < 1e-14);
  assert.ok(!rows.some((row) => row.name === "foot_displacement"));
  assert.throws(() => ask({ ask: "limits", inputs: { mass: "2", stiffness: "0", friction: "3", static_friction_ratio: "1.2", force: "9", frequency: "5" } }), /Without a spring a limit has any place/);
  t.diagnostic(`${fields} numbers`);
});

test("friction of 0, a force of 0 and a start are ordinary", () => {
  const run = (name, inputs, ...more) => {
    const options = Object.entries(inputs).flatMap(([name, text]) => [`--${name.replaceAll("_", "-")}`, text.replaceAll(" ", "")]);
    const ran = spawnSync(command, [name, ...options, "--units", "kN,m", ...more], { encoding: "utf8" });
    assert.equal(ran.status, 0, ran.stderr);
    return ran.stdout;
  };
  const base = { mass: "50 t", stiffness: "1000 kN/m", friction: "5 kN", damping_ratio: "2 %", force: "12 kN", frequency: "1 Hz" };
  let values = 0;
  for (const change of [{ friction: "0" }, { friction: "0", frequency: "0.7 Hz" }, { x0: "30 mm" }, { x0: "30 mm", v0: "1 m/s", static_friction_ratio: "1.6" }, { static_friction_ratio: "2.2", v0: "0.2 m/s", frequency: "0.5 Hz" }]) {
    const inputs = { ...base, ...change };
    const due = JSON.parse(run("steady", inputs, "--format", "json"));
    const found = ask({ ask: "answer", inputs, units: "kN,m" });
    assert.equal(found.is_frictionless, change.friction === "0");
    for (const { name, value, physical } of found.steady.values) {
      assert.deepEqual(value, due[name], `${JSON.stringify(change)} ${name}`);
      if (physical) assert.deepEqual(physical.value, due.physical[physical.name]);
      values += 1;
    }
  }
  assert.ok(values > 150, String(values));
  // Without friction the motion is the linear oscillator's: p₀/k over the hypotenuse of 1 − Ω² and 2ζΩ.
  const linear = ask({ ask: "answer", inputs: { ...base, friction: "0" }, units: "kN,m" });
  const omega = 2 * Math.PI / Math.sqrt(1000 / 50);
  const due = 12 / 1000 / Math.hypot(1 - omega ** 2, 2 * 0.02 * omega);
  const peak = linear.steady.values.find(({ name }) => name === "max_displacement").physical.value;
  assert.ok(Math.abs(peak / due - 1) < 1e-14, `${peak} ${due}`);
  // A free vibration comes to rest where the command says.
  const free = { mass: "2 kg", stiffness: "1.5 N/mm", friction: "1 N", damping_ratio: "1 %", x0: "12 mm" };
  const decay = JSON.parse(run("decay", free, "--format", "json"));
  const rest = ask({ ask: "answer", inputs: { ...free, force: "0", frequency: "4 Hz" }, units: "kN,m" });
  assert.ok(rest.is_free && rest.place === -1);
  const place = rest.steady.values.find(({ name }) => name === "max_displacement").physical.value;
  assert.ok(Math.abs(place / decay.physical.rest_position - 1) < 1e-12, `${place} ${JSON.stringify(decay)}`);
  assert.match(rest.steady.verdict, new RegExp(`after ${decay.half_cycles} slides`));
  // The motion begins at its start, and ends at this rest.
  const motion = ask({ ask: "motion", inputs: { ...free, force: "0", frequency: "4 Hz" }, units: "kN,m" });
  assert.equal(motion.displacement[0], 0.012);
  assert.equal(motion.displacement.at(-1), place);
  assert.ok(motion.rest.at(-1) && motion.load.every((x) => x === 0));
  // Neither friction nor a force: the vibration is a cosine that the damper lets die away.
  const bare = ask({ ask: "motion", inputs: { mass: "2 kg", stiffness: "1.5 N/mm", friction: "0", damping_ratio: "1 %", force: "0", frequency: "4 Hz", x0: "12 mm" }, units: "kN,m" });
  const [w, z] = [Math.sqrt(1500 / 2), 0.01];
  const d = w * Math.sqrt(1 - z * z);
  bare.time.slice(0, 400).forEach((t, i) => {
    const x = 0.012 * Math.exp(-z * w * t) * (Math.cos(d * t) + (z / Math.sqrt(1 - z * z)) * Math.sin(d * t));
    assert.ok(Math.abs(bare.displacement[i] - x) < 1e-14, `${t} ${bare.displacement[i]} ${x}`);
  });
});

test("a record is followed as the command follows it", () => {
  const times = Array.from({ length: 400 }, (_, i) => i * 0.02);
  const text = `time[s],acceleration[g]\n${times.map((t) => `${t.toFixed(2)},${(0.3 * Math.sin(7 * t) * Math.exp(-t / 5)).toFixed(6)}`).join("\n")}\n`;
  const file = join(folder, "shake.csv");
  writeFileSync(file, text);
  const inputs = { mass: "2 t", period: "0.8 s", friction_coefficient: "0.05", damping_ratio: "2 %" };
  const found = ask({ ask: "record", inputs, text, name: "shake.csv" });
  const options = Object.entries(inputs).flatMap(([name, value]) => [`--${name.replaceAll("_", "-")}`, value.replaceAll(" ", "")]);
  const ran = spawnSync(command, ["record", file, ...options, "--format", "json"], { encoding: "utf8" });
  assert.equal(ran.status, 0, ran.stderr);
  const due = JSON.parse(ran.stdout);
  const own = due.physical || due;
  for (const { name, value, unit } of found.values) {
    assert.equal(value, own[name], name);
    if (unit) assert.equal(unit, own.units[name], name);
  }
  const count = (wanted) => found.values.find(({ name }) => name === wanted).value;
  assert.ok(count("stops") + count("reversals") > 3);
  // The loops: their greatest force, and their area, which is what friction and damper dissipate and the spring stores.
  const [most, friction, damper, end] = ["max_transmitted_force", "friction_work", "damper_work", "end_displacement"].map(count);
  assert.ok(Math.abs(Math.max(...found.force.map(Math.abs)) / most - 1) < 1e-4, String(most));
  const last = found.time.findIndex((t) => t >= times.at(-1) - 1e-9);
  const area = found.force.slice(1, last + 1).reduce((sum, f, i) => sum + ((f + found.force[i]) / 2) * (found.displacement[i + 1] - found.displacement[i]), 0);
  const stored = (2000 * (2 * Math.PI / 0.8) ** 2 * end ** 2) / 2;
  assert.ok(Math.abs(area / (friction + damper + stored) - 1) < 0.02, `${area} ${friction} ${damper} ${stored}`);
  // A body that a damper alone stops only tends to rest.
  assert.equal(found.comes_to, "comes to");
  const bare = Object.entries(inputs).filter(([name]) => name !== "friction_coefficient");
  assert.equal(ask({ ask: "record", inputs: { ...Object.fromEntries(bare), friction: "0" }, text }).comes_to, "only tends to");
  // A body of the spectrum is the same as one alone.
  const alone = ask({ ask: "record", inputs: { ...inputs, period: "0.5 s" }, text });
  const spectrum = ask({ ask: "spectrum", inputs, text, periods: [0.25, 0.5] });
  for (const { name, value } of alone.values) assert.equal(spectrum.answers[name][1], value, name);
});

test("wrong input gets a line of the library", () => {
  const base = { mass: "1", stiffness: "1", friction: "1", force: "2", frequency: "1" };
  const said = (question) => {
    try {
      ask({ ask: "answer", ...question });
    } catch (error) {
      return error.message;
    }
    return "";
  };
  assert.match(said({ inputs: { ...base, mass: "-3" } }), /^mass -3: mass m = -3 must be > 0/);
  assert.match(said({ inputs: { ...base, mass: "3 kg", units: "" } }), /kg|units/);
  assert.match(said({ inputs: { ...base, mass: "three" } }), /^mass three: /);
  assert.match(said({ inputs: { omega: "0", alpha: "2" } }), /must be/);
  assert.match(said({ inputs: { omega: "1" } }), /alpha/);
  assert.match(said({ inputs: { ...base, wheel: "1" } }), /wheel: is unknown/);
  assert.match(said({ inputs: base, units: "kN,parsec" }), /^units kN,parsec: /);
  assert.match(said({ ask: "fortune" }), /is unknown/);
  for (const text of ["", "x", "time[s],acceleration[g]\n0,1\n", "time[s],acceleration[g]\n0,1\n0.1,NaN\n", "a,b\n1,2\n"]) {
    assert.throws(() => ask({ ask: "record", inputs: base, text, name: "a.csv" }), /a\.csv/, text);
  }
  // The module answers on.
  assert.equal(ask({ ask: "answer", inputs: { omega: "1.5", alpha: "2.5" } }).values.find(({ name }) => name === "max_displacement").value, 1.632993161855452);
});
