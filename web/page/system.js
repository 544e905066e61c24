// Two masses: their description as a file of the command, and its answers.
"use strict";

const SYSTEM_FIELDS = [
  ["Masses", [["m1", "lower mass", "1 t"], ["m2", "upper mass", "500 kg"]]],
  ["Springs", [["k1", "ground – lower", "200 N/mm"], ["k2", "lower – upper", "300 N/mm"]]],
  ["Dampers", [["c1", "ground – lower", "0.3 N*s/mm"], ["c2", "lower – upper", ""]]],
  ["Contact", [["contact", "between", "ground,lower"], ["friction", "friction", "450 N"], ["elastic", "its stiffness, if elastic", ""], ["peak", "static ratio, if > 1", ""]]],
  ["End stop", [["stop", "between", "lower,upper"], ["gap", "gap, if there is one", ""], ["stop_stiffness", "stiffness", "10 kN/mm"]]],
  ["Load", [["load", "kind", "upper"], ["amplitude", "amplitude", "1.5 kN"], ["frequency", "frequency", "3 Hz"]]],
];
const CHOICES = {
  contact: [["ground,lower", "ground, lower"], ["lower,upper", "lower, upper"], ["ground,upper", "ground, upper"]],
  stop: [["lower,upper", "lower, upper"], ["ground,lower", "ground, lower"], ["ground,upper", "ground, upper"]],
  load: [["upper", "force, upper"], ["lower", "force, lower"], ["base", "base moves"]],
};
const BARE_TWO = {
  m1: "F*s^2/L", m2: "F*s^2/L", k1: "F/L", k2: "F/L", c1: "F*s/L", c2: "F*s/L", friction: "F", elastic: "F/L", gap: "L", stop_stiffness: "F/L", amplitude: "F",
};
const SYSTEM_PRESETS = {
  machine: ["Machine on a slide", {}],
  storeys: ["Friction damper between storeys", { units: "kN,mm", m1: "20 t", m2: "20 t", k1: "20 kN/mm", k2: "20 kN/mm", c1: "0.02 kN*s/mm", c2: "0.02 kN*s/mm", contact: "lower,upper", friction: "100 kN", elastic: "40 kN/mm", load: "base", amplitude: "0.2 g", frequency: "3 Hz" }],
  building: ["Building on a slider", { units: "kN,mm", m1: "100 t", m2: "100 t", k1: "", k2: "50 kN/mm", c1: "", c2: "0.2 kN*s/mm", friction: "157 kN", load: "base", amplitude: "0.15 g", frequency: "1.5 Hz" }],
  rattle: ["Rattle against a stop", { gap: "1 mm", load: "lower", amplitude: "1.5 kN", frequency: "4 Hz" }],
};
const BASE_SYSTEM = { units: "N,mm", ...Object.fromEntries(SYSTEM_FIELDS.flatMap(([, rows]) => rows.map(([name, , first]) => [name, first]))) };
let two = { ...BASE_SYSTEM };
let twoAnswer = null;

function systemFields() {
  const host = $("system-fields");
  host.replaceChildren();
  const units = document.createElement("div");
  units.className = "row";
  units.append(Object.assign(document.createElement("label"), { htmlFor: "two-units", textContent: "units" }));
  const input = (name) => {
    const made = CHOICES[name] ? document.createElement("select") : Object.assign(document.createElement("input"), { autocomplete: "off", spellcheck: false });
    made.id = `two-${name}`;
    for (const [value, text] of CHOICES[name] || []) made.append(new Option(text, value, two[name] === value, two[name] === value));
    made.value = two[name];
    made.oninput = () => {
      if (name === "units") {
        withUnits(two, two.units, { ...BARE_TWO, amplitude: two.load === "base" ? "L/s^2" : "F" });
        for (const own of Object.keys(BARE_TWO)) $(`two-${own}`).value = two[own];
      }
      two[name] = made.value;
      // A force and an acceleration are not of one kind.
      if (name === "load" && (made.value === "base") !== /g$|m\/s/.test(two.amplitude)) {
        two.amplitude = made.value === "base" ? "0.2 g" : "1.5 kN";
        $("two-amplitude").value = two.amplitude;
      }
      changedSystem();
    };
    made.onchange = remember;
    return made;
  };
  units.append(input("units"));
  $("two-units")?.setAttribute("list", "systems");
  host.append(units);
  for (const [title, rows] of SYSTEM_FIELDS) {
    const set = document.createElement("fieldset");
    set.append(Object.assign(document.createElement("legend"), { textContent: title }));
    for (const [name, words] of rows) {
      const row = Object.assign(document.createElement("div"), { className: "row" });
      row.append(Object.assign(document.createElement("label"), { htmlFor: `two-${name}`, textContent: words }), input(name));
      set.append(row);
    }
    host.append(set);
  }
}

// The file of the command that describes the two masses.
function systemText(of = two) {
  const quoted = (text) => JSON.stringify(text.trim());
  const has = (name) => of[name]?.trim();
  const between = (name) => `between = [${of[name].split(",").map(quoted).join(", ")}]`;
  const lines = [`units = ${quoted(of.units)}`, `masses = { lower = ${quoted(of.m1)}, upper = ${quoted(of.m2)} }`];
  for (const [ends, k, c] of [['["ground", "lower"]', "k1", "c1"], ['["lower", "upper"]', "k2", "c2"]]) {
    if (!has(k) && !has(c)) continue;
    lines.push("[[springs]]", `between = ${ends}`);
    if (has(k)) lines.push(`stiffness = ${quoted(of[k])}`);
    if (has(c)) lines.push(`damping = ${quoted(of[c])}`);
  }
  if (has("friction") && !(isZero(of.friction) && !has("elastic"))) {
    lines.push("[[contacts]]", 'name = "contact"', between("contact"), `friction = ${quoted(of.friction)}`);
    if (has("elastic")) lines.push(`stiffness = ${quoted(of.elastic)}`);
    if (has("peak")) lines.push(`static_ratio = ${quoted(of.peak)}`);
  }
  if (has("gap")) lines.push("[[stops]]", 'name = "stop"', between("stop"), `gap = ${quoted(of.gap)}`, `stiffness = ${quoted(of.stop_stiffness)}`);
  if (of.load === "base") lines.push("[base]", `acceleration = { amplitude = ${quoted(of.amplitude)}, frequency = ${quoted(of.frequency)} }`);
  else if (has("amplitude")) lines.push("[[forces]]", `on = ${quoted(of.load)}`, `amplitude = ${quoted(of.amplitude)}`, `frequency = ${quoted(of.frequency)}`);
  return `${lines.join("\n")}\n`;
}

let systemTimer = 0;

function changedSystem() {
  const text = systemText();
  $("system-file").textContent = text;
  if (tab === "two") history.replaceState(null, "", currentHash());
  if (!live) return;
  live.ask("system", { ask: "system", text, count: 600 }, ({ ok, error }) => {
    if (systemText() !== text) return;
    $("system-error").textContent = error ?? "";
    $("system-shown").hidden = error !== undefined;
    twoAnswer = ok ?? null;
    if (ok) showSystem(ok);
  });
  clearTimeout(systemTimer);
  systemTimer = setTimeout(() => {
    const own = parts(two.frequency);
    if (!own || systemText() !== text || !twoAnswer) return;
    const modes = [...twoAnswer.description.natural_frequencies, ...twoAnswer.description.natural_frequencies_stuck, ...twoAnswer.description.harmonics].filter((x) => x > 0).map((x) => x / (2 * Math.PI));
    const [low, high] = [Math.min(...modes) / 2, Math.max(...modes) * 1.6];
    const even = Array.from({ length: 160 }, (_, i) => low * (high / low) ** (i / 159));
    const frequencies = [...even, ...modes].sort((a, b) => a - b);
    slow.ask("system-curve", { ask: "system-curve", text, frequencies }, ({ ok }) => {
      if (ok && systemText() === text) showSystemCurve(ok);
    });
  }, 200);
}

const systemHash = (more) => `#${new URLSearchParams({ system: 1, ...more, ...Object.fromEntries(Object.entries(two).filter(([name, text]) => text !== BASE_SYSTEM[name])) })}`;

function systemFromHash(text) {
  const all = new URLSearchParams(text);
  if (!all.has("system")) return false;
  two = { ...BASE_SYSTEM };
  for (const name of Object.keys(two)) if (all.has(name)) two[name] = all.get(name);
  return true;
}

const systemCharts = {
  places: new Chart($("two-motion"), { title: "Displacements of the two masses over time", height: 220 }),
  force: new Chart($("two-force"), { title: "Force of the contact over its displacement", height: 220 }),
  curve: new Chart($("two-curve"), { title: "Peak displacements over the frequency of the load", height: 260 }),
};

function showSystem(found) {
  const { motion, samples } = found;
  for (const [id, text] of [["system-verdict", found.verdict], ["system-border", found.border_verdict]]) {
    $(id).textContent = fourIn(text);
    $(id).title = text;
  }
  const list = $("system-values");
  list.replaceChildren();
  const { units } = motion;
  motion.coordinates.forEach((name, i) => {
    const [low, high] = [motion.min_displacement[i], motion.max_displacement[i]];
    entry(list, `${name}: displacement`, `${readable(low, units.displacement)} to ${readable(high, units.displacement)}`, `${low} to ${high} ${units.displacement}`);
    const speed = Math.max(Math.abs(motion.min_velocity[i]), Math.abs(motion.max_velocity[i]));
    entry(list, `${name}: peak velocity`, readable(speed, units.velocity), `${speed} ${units.velocity}`);
    const most = motion.max_absolute_acceleration?.[i];
    if (most !== undefined) entry(list, `${name}: peak absolute acceleration`, readable(most, units.acceleration), `${most} ${units.acceleration}`);
  });
  for (const element of motion.elements) {
    const words = { contact: "sticks", elastic: "holds", stop: "open" }[element.kind];
    const part = motion.period > 0 ? ` (${four((100 * element.time_at_rest) / motion.period)} %)` : "";
    entry(list, `${element.name}: ${words}`, `${readable(element.time_at_rest, "s")}${part}, ${element.stops} ${element.stops === 1 ? "time" : "times"}`, `${element.time_at_rest} s`);
    entry(list, `${element.name}: work`, readable(element.work, units.work), `${element.work} ${units.work}`);
  }
  const hertz = (own) => own.map((omega) => four(omega / (2 * Math.PI))).join(", ");
  entry(list, "natural frequencies, sliding", `${hertz(found.description.natural_frequencies)} Hz`);
  entry(list, "natural frequency with the contact stuck", `${hertz(found.description.natural_frequencies_stuck)} Hz`);
  motion.coordinates.forEach((name, i) => {
    const speed = motion.mean_velocity?.[i];
    if (speed) entry(list, `${name}: drift`, `${readable(speed, units.velocity)} in the mean`, `${speed} ${units.velocity}`);
  });
  if (motion.multipliers?.length) {
    const most = Math.max(...motion.multipliers.map(([re, im]) => Math.hypot(re, im)));
    entry(list, "a disturbance", `${most < 1 ? "shrinks" : "grows"} to ${four(most)} of its size in each period`, String(most));
  }
  const isMoving = Boolean(samples);
  for (const host of ["two-motion", "two-force"]) $(host).hidden = !isMoving;
  if (!isMoving) return;
  const ink = palette();
  const columns = motion.coordinates.map((_, i) => samples.displacement.map((row) => row[i]));
  const to = fitting(Math.max(...columns.map(largest)), units.displacement);
  const sized = columns.map((list) => list.map((x) => x * to.factor));
  const { places, force } = systemCharts;
  places.begin({ x: [samples.time[0], samples.time.at(-1)], y: range(sized.flat()), xlabel: "time (s)", ylabel: `displacement (${to.unit})`, legend: motion.coordinates.map((name, i) => [name, i ? ink.stick : ink.slide, i ? "7 3" : ""]) });
  sized.forEach((list, i) => places.line(samples.time, list, i ? ink.stick : ink.slide, { dash: i ? "7 3" : "" }));
  places.read = (x) => {
    const i = nearest(samples.time, x);
    return { x: samples.time[i], text: `${four(samples.time[i])} s: ${sized.map((list) => four(list[i])).join(", ")} ${to.unit}` };
  };
  // The contact's displacement is that of its second end over its first.
  const contact = motion.elements.findIndex((element) => !["stop", "spring"].includes(element.kind));
  $("two-force").hidden = contact < 0;
  if (contact >= 0) {
    const ends = two.contact.split(",").map((name) => motion.coordinates.indexOf(name));
    const across = samples.time.map((_, i) => ends.map((end) => (end < 0 ? 0 : sized[end][i]))).map(([a, b]) => b - a);
    const forces = fitted(samples.force.map((row) => -row[contact]), unitOfForce());
    force.begin({ x: range(across), y: range(forces.values), xlabel: `displacement across the contact (${to.unit})`, ylabel: `friction (${forces.unit})` });
    force.line(across, forces.values, force.ink.slide);
    force.read = (x, y) => ({ x, text: `${four(x)} ${to.unit}, ${four(y)} ${forces.unit}` });
  }
  twoSketch.most = Math.max(...columns.map(largest));
}

const unitOfForce = () => two.units.split(",")[0].trim();

function showSystemCurve(found) {
  const chart = systemCharts.curve;
  const ink = palette();
  const all = found.displacement.flat().filter((x) => x > 0);
  $("two-curve").hidden = !all.length;
  if (!all.length) return;
  const to = fitting(Math.max(...all), found.unit);
  const top = Math.max(...all) * 2 * to.factor;
  const low = Math.max(Math.min(...all) * to.factor, top * 1e-4) / 1.3;
  chart.begin({ x: [found.frequency[0], found.frequency.at(-1)], y: [low, top], xlog: true, ylog: true, xlabel: "frequency of the load (Hz)", ylabel: `peak displacement (${to.unit})`, legend: found.coordinates.map((name, i) => [name, i ? ink.stick : ink.slide, i ? "7 3" : ""]) });
  found.displacement.forEach((list, i) => chart.line(found.frequency, list.map((x) => (x === null ? null : x * to.factor)), i ? ink.stick : ink.slide, { dash: i ? "7 3" : "" }));
  chart.read = (x) => {
    const i = nearest(found.frequency, x);
    const rests = found.rests[i];
    return { x: found.frequency[i], text: `${four(found.frequency[i])} Hz: ${found.displacement.map((list) => readable(list[i], found.unit)).join(", ")}${rests === null ? "" : `, ${rests} ${rests === 1 ? "rest" : "rests"}`}` };
  };
  shown.systemCurve = found;
}

// ---- the sketch of the two masses

const twoSketch = (() => {
  const svg = node("svg", { viewBox: "0 0 520 120", width: "100%", role: "img", "aria-label": "Two masses on a floor, joined by springs" });
  const floor = node("path", { d: "M20 104H500M30 30V104", fill: "none", "stroke-width": 2 });
  const springs = [node("path", { fill: "none", "stroke-width": 2 }), node("path", { fill: "none", "stroke-width": 2 })];
  const blocks = [140, 330].map(() => node("rect", { y: 46, width: 70, height: 52, rx: 3 }));
  const names = ["lower", "upper"].map((name) => node("text", { y: 76, "font-size": 13, "font-family": "system-ui, sans-serif", "text-anchor": "middle" }, name));
  const mark = node("text", { y: 30, "font-size": 12, x: 260, "font-family": "system-ui, sans-serif", "text-anchor": "middle" });
  svg.append(floor, ...springs, ...blocks, ...names, mark);
  $("two-body").append(svg);
  return { svg, floor, springs, blocks, names, mark, most: 0 };
})();

function placeSystem(now) {
  const samples = twoAnswer?.samples;
  const ink = palette();
  const { floor, springs, blocks, names, mark, most } = twoSketch;
  const part = samples ? (now % 3000) / 3000 : 0;
  const i = samples ? Math.round(part * (samples.time.length - 1)) : 0;
  const homes = [140, 330];
  const places = homes.map((home, k) => home + (samples && most ? (50 * samples.displacement[i][k]) / most : 0));
  floor.setAttribute("stroke", ink.border);
  mark.setAttribute("fill", ink.text);
  mark.textContent = `contact between ${two.contact.replace(",", " and ")}: ${two.friction || "none"}${two.gap?.trim() ? `; stop after ${two.gap}` : ""}`;
  places.forEach((x, k) => {
    blocks[k].setAttribute("x", x);
    blocks[k].setAttribute("fill", k ? ink.stick : ink.slide);
    names[k].setAttribute("x", x + 35);
    names[k].setAttribute("fill", ink.paper);
    const from = k ? places[0] + 70 : 30;
    const step = (x - from) / 14;
    const has = two[k ? "k2" : "k1"]?.trim();
    springs[k].setAttribute("d", has ? `M${from} 70${Array.from({ length: 13 }, (_, n) => `L${(from + (n + 1) * step).toFixed(1)} ${n % 2 ? 77 : 63}`).join("")}L${x} 70` : "");
    springs[k].setAttribute("stroke", ink.border);
  });
}

$("system-download").onclick = () => saved("two-masses.toml", "text/plain", systemText());
// The samples in columns, with the names and in the order of the command's.
function systemColumns(samples) {
  const { units, coordinates, elements } = samples;
  const columns = { [`time[${units.time}]`]: samples.time };
  const add = (names, what, unit) => names.forEach((name, i) => (columns[`${name}.${what}[${unit}]`] = samples[what].map((row) => row[i])));
  add(coordinates, "displacement", units.displacement);
  add(coordinates, "velocity", units.velocity);
  add(elements, "force", units.force);
  if (samples.absolute_acceleration) add(coordinates, "absolute_acceleration", units.acceleration);
  return columns;
}
$("system-csv").onclick = () => {
  if (twoAnswer?.samples) saved("stickslip-two-masses.csv", "text/csv", csvText(systemColumns(twoAnswer.samples)));
};
