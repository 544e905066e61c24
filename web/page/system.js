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

let [systemTimer, systemLate] = [0, 0];

function changedSystem() {
  const text = systemText();
  $("system-file").textContent = text;
  if (tab === "two") history.replaceState(null, "", currentHash());
  if (!live) return;
  if (busy.isStopped) stopped(false);
  // What is of another system is dimmed, gives no file, and after a moment has no verdict.
  if (twoAnswer?.text !== text) {
    shown.systemCurve = undefined;
    $("system-shown").classList.add("stale");
    clearTimeout(systemLate);
    systemLate = setTimeout(() => {
      $("system-verdict").textContent = "Computing …";
      $("system-border").textContent = "";
    }, 1000);
  }
  fileButtons();
  live.ask("system", { ask: "system", text, count: 600 }, ({ ok, error }) => {
    if (systemText() !== text) return;
    clearTimeout(systemLate);
    $("system-error").textContent = error ?? "";
    $("system-shown").hidden = error !== undefined;
    $("system-shown").classList.remove("stale");
    $("two-curve").classList.toggle("stale", !shown.systemCurve);
    twoAnswer = ok ? { ...ok, text } : null;
    if (ok) showSystem(ok);
    fileButtons();
    askSystemCurve(text);
  });
}

// The curve about the natural frequencies, when the fields are still.
function askSystemCurve(text) {
  clearTimeout(systemTimer);
  systemTimer = setTimeout(() => {
    const own = parts(two.frequency);
    if (!own || systemText() !== text || !twoAnswer) return;
    const modes = [...twoAnswer.description.natural_frequencies, ...twoAnswer.description.natural_frequencies_stuck, ...twoAnswer.description.harmonics].filter((x) => x > 0).map((x) => x / (2 * Math.PI));
    const [low, high] = [Math.min(...modes) / 2, Math.max(...modes) * 1.6];
    const even = Array.from({ length: 160 }, (_, i) => low * (high / low) ** (i / 159));
    const frequencies = [...even, ...modes].sort((a, b) => a - b);
    slow.ask("system-curve", { ask: "system-curve", text, frequencies }, ({ ok }) => {
      if (!ok || systemText() !== text) return;
      showSystemCurve(ok);
      $("two-curve").classList.remove("stale");
      fileButtons();
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

Object.assign(charts, {
  places: new Chart($("two-motion"), { title: "Displacements of the two masses over time", height: 220 }),
  force: new Chart($("two-force"), { title: "Force of the contact over its displacement", height: 220 }),
  systemCurve: new Chart($("two-curve"), { title: "Peak displacements over the frequency of the load", height: 260 }),
});

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
  // What is below the rounding of the works has no digit that is right.
  const works = motion.elements.reduce((sum, { work }) => sum + Math.abs(work), Math.abs(motion.load_work ?? 0));
  for (const element of motion.elements) {
    const words = { contact: "sticks", elastic: "holds", stop: "open" }[element.kind];
    const part = motion.period > 0 ? ` (${four((100 * element.time_at_rest) / motion.period)} %)` : "";
    entry(list, `${element.name}: ${words}`, `${readable(element.time_at_rest, "s")}${part}, ${element.stops} ${element.stops === 1 ? "time" : "times"}`, `${element.time_at_rest} s`);
    // A stop of the page has no damper, and does no work in a period.
    if (element.kind !== "stop") entry(list, `${element.name}: work`, readable(Math.abs(element.work) < 1e-12 * works ? 0 : element.work, units.work), `${element.work} ${units.work}`);
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
  const { places, force } = charts;
  places.begin({ x: [samples.time[0], samples.time.at(-1)], y: range(sized.flat()), xlabel: "time (s)", ylabel: `displacement (${to.unit})`, legend: motion.coordinates.map((name, i) => [name, i ? ink.stick : ink.slide, i ? "7 3" : ""]) });
  sized.forEach((list, i) => places.line(samples.time, list, i ? ink.stick : ink.slide, { dash: i ? "7 3" : "" }));
  places.read = (x) => {
    const i = nearest(samples.time, x);
    return { x: samples.time[i], text: `${four(samples.time[i])} s: ${sized.map((list) => four(list[i])).join(", ")} ${to.unit}` };
  };
  // The contact's displacement is that of its second end over its first.
  const contact = motion.elements.findIndex((element) => element.kind !== "stop");
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
  const chart = charts.systemCurve;
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

// ---- the sketch of the two masses: bodies on wheels or on plates that rub, and what is between them

const twoSketch = (() => {
  const svg = node("svg", { viewBox: "0 0 560 196", width: "100%", role: "img", "aria-label": "Two masses on a floor, with the springs, dampers, contact, stop and load of the fields" });
  $("two-body").append(svg);
  return { svg, most: 0 };
})();
// Metres in the units of a gap.
const METRES = { m: 1, cm: 1e-2, mm: 1e-3, "µm": 1e-6, in: 0.0254, ft: 0.3048 };

// Symbols from one place to another at a height, as paths.
const zigzag = (from, to, y) => `M${from} ${y}${Array.from({ length: 13 }, (_, n) => `L${(from + ((n + 1) * (to - from)) / 14).toFixed(1)} ${y + (n % 2 ? 6 : -6)}`).join("")}L${to} ${y}`;
const dashpot = (from, to, y) => {
  const middle = (from + to) / 2;
  return `M${from} ${y}H${middle - 4}m0 -6v12M${middle + 10} ${y - 8}h-20m20 16h-20M${middle + 10} ${y - 8}v16m0 -8H${to}`;
};
const plates = (from, to, y, isElastic) => {
  const middle = (from + to) / 2;
  const arm = isElastic ? zigzag(from, middle - 14, y + 4) : `M${from} ${y + 4}H${middle - 14}`;
  return `${arm}H${middle + 14}M${to} ${y - 3}H${middle - 14}${Array.from({ length: 7 }, (_, n) => `M${middle - 12 + 4 * n} ${y + 4}l3 -7`).join("")}`;
};

function placeSystem(now) {
  const samples = twoAnswer?.text === systemText() ? twoAnswer.samples : null;
  const ink = palette();
  const part = samples ? (now % 3000) / 3000 : 0;
  const i = samples ? Math.round(part * (samples.time.length - 1)) : 0;
  const [homes, width, floor, wall] = [[150, 370], 84, 160, 30];
  const pixels = samples && twoSketch.most ? 46 / twoSketch.most : 0;
  const places = homes.map((home, k) => home + (samples ? pixels * samples.displacement[i][k] : 0));
  const of = { ground: [wall, wall], lower: [places[0], places[0] + width], upper: [places[1], places[1] + width] };
  const has = (name) => Boolean(two[name]?.trim());
  const parts = [];
  const path = (d, colour = ink.border, more = {}) => parts.push(node("path", { d, fill: "none", stroke: colour, "stroke-width": 2, ...more }));
  const words = (x, y, text, more = {}) => parts.push(node("text", { x, y, "font-size": 11, "font-family": "system-ui, sans-serif", "text-anchor": "middle", fill: ink.text, ...more }, text));
  path(`M12 ${floor}H548M${wall} 24V${floor}`);
  path(Array.from({ length: 40 }, (_, n) => `M${24 + 13.2 * n} ${floor}l-7 7`).join(""), ink.border, { "stroke-width": 1 });
  [["ground", "lower", "k1", "c1"], ["lower", "upper", "k2", "c2"]].forEach(([first, second, k, c]) => {
    const [from, to] = [of[first][1], of[second][0]];
    if (has(k)) {
      path(zigzag(from, to, 76));
      words((from + to) / 2, 65, two[k]);
    }
    if (has(c)) {
      path(dashpot(from, to, 106));
      words((from + to) / 2, 92, two[c]);
    }
  });
  const isRubbing = has("friction") && !(isZero(two.friction) && !has("elastic"));
  const [below, above] = two.contact.split(",");
  const friction = `friction ${two.friction}${has("elastic") ? `, elastic ${two.elastic}` : ""}`;
  if (isRubbing && below === "lower") {
    path(plates(of.lower[1], of.upper[0], 138, has("elastic")), ink.stick);
    words((of.lower[1] + of.upper[0]) / 2, 127, two.friction);
  }
  ["lower", "upper"].forEach((name, k) => {
    const [left, right] = of[name];
    parts.push(node("rect", { x: left, y: 54, width, height: 94, rx: 3, fill: k ? ink.stick : ink.slide }));
    words(left + width / 2, 98, name, { "font-size": 13, "font-weight": 600, fill: ink.paper });
    words(left + width / 2, 115, two[`m${k + 1}`], { fill: ink.paper });
    if (isRubbing && below === "ground" && above === name) {
      path(`M${left + 4} 154H${right - 4}`, ink.second, { "stroke-width": 9, "stroke-dasharray": "5 2" });
      words(left + width / 2, 182, friction);
    } else for (const x of [left + 18, right - 18]) parts.push(node("circle", { cx: x, cy: 154, r: 5, fill: ink.paper, stroke: ink.border, "stroke-width": 2 }));
  });
  // The stop is an arm of its first body, which the second meets when it is beyond the gap.
  if (has("gap")) {
    const [first, second] = two.stop.split(",");
    const own = /^\s*([\d.eE+-]+)\s*(\S*)/.exec(two.gap);
    const unit = twoAnswer?.motion.units.displacement;
    const size = own && unit ? (Number(own[1]) * (METRES[own[2] || two.units.split(",")[1]?.trim()] ?? NaN)) / METRES[unit] : NaN;
    const room = Math.min(Number.isFinite(size) && pixels ? size * pixels : 20, 60);
    const shift = first === "ground" ? 0 : places[0] - homes[0];
    const at = homes[second === "lower" ? 0 : 1] + width + room + shift;
    path(`M${first === "ground" ? wall : of[first][0] + 12} ${first === "ground" ? 40 : 54}V40H${at}V70`, ink.here, { "stroke-width": 3 });
    words(Math.min(Math.max(at, of[second][1]) + 6, 490), 84, `gap ${two.gap}`, { "text-anchor": "start" });
  }
  // The load to and fro: on a body above it, of the base below the floor.
  if (has("amplitude") && !isZero(two.amplitude)) {
    const isBase = two.load === "base";
    const [x, y] = isBase ? [60, 178] : [of[two.load][0] + width / 2, 28];
    path(`M${x - 26} ${y}h52m-8 -5l8 5l-8 5M${x - 18} ${y - 5}l-8 5l8 5`, ink.text, { "stroke-width": 2.5 });
    words(x, isBase ? 194 : 16, `${isBase ? "base " : ""}${two.amplitude}, ${two.frequency}`, isBase ? { x: 12, "text-anchor": "start" } : {});
  }
  twoSketch.svg.replaceChildren(...parts);
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
