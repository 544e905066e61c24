// The page: the inputs, the questions to the workers, and the pictures.
"use strict";

const $ = (id) => document.getElementById(id);

// What the fields are, by the way a machine is given. A role with several inputs has a choice.
const ROLES = {
  machine: [
    ["mass"],
    ["stiffness", "period", "pendulum_radius"],
    ["friction", "friction_coefficient"],
    ["damping_ratio", "damping"],
    ["static_friction_ratio", "static_friction"],
    ["force", "unbalance", "base_acceleration", "base_velocity", "base_displacement", "foot_displacement", "damped_foot_displacement"],
    ["frequency"],
    ["mean_force"],
  ],
  ratios: [["omega"], ["alpha"], ["damping_ratio"], ["static_friction_ratio"]],
};
const DRIVES = ROLES.machine[5];
// The names of the fields.
const WORDS = {
  mass: "mass m", stiffness: "stiffness k", period: "natural period", pendulum_radius: "pendulum radius", friction: "friction r_y",
  friction_coefficient: "coefficient µ", damping_ratio: "damping ratio ζ", damping: "damping c", static_friction_ratio: "static ratio η",
  static_friction: "static friction", force: "force p₀", unbalance: "unbalance", base_acceleration: "base acceleration",
  base_velocity: "base velocity", base_displacement: "base displacement", foot_displacement: "foot displacement",
  damped_foot_displacement: "foot with damper", frequency: "frequency", mean_force: "mean force", omega: "Ω = ω_d/ω_n", alpha: "α = p₀/r_y",
};
// The power of the frequency that the force of a drive has.
const POWERS = { unbalance: 2, base_velocity: 1, base_displacement: 2 };
const START = {
  mode: "machine", units: "kN,m", mass: "50 t", stiffness: "1000 kN/m", friction: "5 kN", damping_ratio: "2 %", static_friction_ratio: "1",
  force: "12 kN", frequency: "1 Hz", omega: "1.4", alpha: "2.4",
};
// What a field shows when it is first chosen.
const FIRST = {
  ...START,
  period: "1.4 s", pendulum_radius: "0.5 m", friction_coefficient: "0.01", damping: "9 kN*s/m", static_friction: "6 kN", unbalance: "0.3 t*m",
  base_acceleration: "0.02 g", base_velocity: "50 mm/s", base_displacement: "6 mm", foot_displacement: "12 mm", damped_foot_displacement: "12 mm",
};
const RATIOS = ["omega", "alpha", "damping_ratio", "static_friction_ratio"];

let state = { ...START };
// The chosen input of each role with a choice.
let chosen = {};
// What is shown: the last answers.
const shown = {};

// ---- the inputs

const roleName = (names) => names[0];
const inRole = (names) => names.find((name) => name === chosen[roleName(names)]) || names.find((name) => state[name] !== undefined) || names[0];

// The number and the unit of a typed value.
function parts(text) {
  const found = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*$/.exec(text || "");
  return found ? [Number(found[1]), found[2]] : null;
}

const short = (x) => String(Number(x.toPrecision(4)));

function withNumber(text, number) {
  const found = parts(text);
  const unit = found ? found[1] : "";
  return unit ? `${short(number)} ${unit}` : short(number);
}

// The inputs of the question.
function inputs() {
  const given = {};
  for (const names of ROLES[state.mode]) {
    const name = inRole(names);
    if (state[name]) given[name] = state[name];
  }
  return given;
}

const question = (ask, more = {}) => ({ ask, inputs: inputs(), units: state.mode === "machine" ? state.units : "", ...more });

function fields() {
  $("mode").value = state.mode;
  $("units").value = state.units;
  $("units-row").hidden = state.mode !== "machine";
  const host = $("fields");
  host.querySelectorAll(".row").forEach((row) => row.remove());
  for (const names of ROLES[state.mode]) host.append(field(names));
}

function field(names) {
  const name = inRole(names);
  if (state[name] === undefined) state[name] = FIRST[name] ?? "";
  const row = document.createElement("div");
  row.className = "row";
  const typed = Object.assign(document.createElement("input"), { id: `in-${roleName(names)}`, value: state[name], autocomplete: "off", spellcheck: false });
  typed.dataset.input = name;
  let head;
  if (names.length > 1) {
    head = document.createElement("select");
    head.setAttribute("aria-label", `kind of ${WORDS[roleName(names)]}`);
    for (const own of names) head.append(new Option(WORDS[own], own, own === name, own === name));
    head.onchange = () => {
      chosen[roleName(names)] = head.value;
      // The same machine, given by another quantity.
      const same = shown.answer?.kinds?.[head.value];
      state[head.value] = same ? `${short(same.value)} ${same.unit}`.trim() : FIRST[head.value] ?? "";
      fields();
      $(`in-${roleName(names)}`).focus();
      changed();
    };
    typed.setAttribute("aria-label", WORDS[name]);
  } else {
    head = document.createElement("label");
    head.htmlFor = typed.id;
    head.textContent = WORDS[name];
  }
  const slider = Object.assign(document.createElement("input"), { type: "range", min: -1.5, max: 1.5, step: 0.005, value: 0 });
  slider.setAttribute("aria-label", `${WORDS[name]}, scaled`);
  let home = state[name];
  typed.oninput = () => {
    state[name] = typed.value;
    home = typed.value;
    slider.value = 0;
    changed();
  };
  // A slider that is let go begins anew in its middle.
  slider.onchange = () => {
    home = state[name];
    slider.value = 0;
  };
  slider.oninput = () => {
    const found = parts(home);
    if (!found) {
      slider.value = 0;
      return;
    }
    // A number of 0 has no multiple: the slider begins at a size of its own.
    const size = found[0] === 0 ? 0.01 : found[0];
    const least = name === "static_friction_ratio" ? 1 : 0;
    const value = least + (size - least || 0.1) * 10 ** Number(slider.value);
    typed.value = state[name] = withNumber(home, least && Number(slider.value) <= -1.5 ? 1 : value);
    changed();
  };
  // Dragging the label moves the slider.
  head.addEventListener("pointerdown", (event) => {
    if (head.tagName === "SELECT") return;
    const [x, from] = [event.clientX, Number(slider.value)];
    head.setPointerCapture(event.pointerId);
    head.onpointermove = (move) => {
      slider.value = from + (move.clientX - x) / 150;
      slider.oninput();
    };
    head.onpointerup = head.onpointercancel = () => {
      head.onpointermove = null;
      slider.onchange();
    };
  });
  row.append(head, typed, slider);
  return row;
}

// The ratios that the machine is to have after a change of the mode.
let wanted = null;

$("mode").onchange = () => {
  if (state.mode === "ratios" && shown.answer) wanted = { omega: shown.answer.omega, alpha: shown.answer.alpha };
  state.mode = $("mode").value;
  if (state.mode === "ratios" && shown.answer) {
    for (const name of RATIOS) state[name] = String(shown.answer[name]);
  }
  fields();
  changed();
};
$("units").oninput = () => {
  state.units = $("units").value;
  changed();
};
$("machine").onsubmit = (event) => event.preventDefault();

// Where the last move leads, until its answer is there.
let aim = null;

// Moves the machine to Ω and α by its frequency and the amplitude of its drive.
function moveTo(omega, alpha) {
  const answer = shown.answer;
  if (!answer) return;
  aim = { omega, alpha };
  if (state.mode === "ratios") {
    state.omega = short(omega);
    state.alpha = short(alpha);
  } else {
    const name = inRole(DRIVES);
    // The inputs of the answer: those of now may be ahead of it.
    const [frequency, amplitude] = [parts(answer.inputs.frequency), parts(answer.inputs[name])];
    if (!frequency || !amplitude) return;
    const ratio = omega / answer.omega;
    let size = alpha / answer.alpha / ratio ** (POWERS[name] || 0);
    if (name === "damped_foot_displacement") {
      const zeta = answer.damping_ratio;
      size *= Math.hypot(1, 2 * zeta * answer.omega) / Math.hypot(1, 2 * zeta * omega);
    }
    state.frequency = withNumber(answer.inputs.frequency, frequency[0] * ratio);
    state[name] = withNumber(answer.inputs[name], amplitude[0] * size);
  }
  for (const typed of document.querySelectorAll("[data-input]")) {
    if (state[typed.dataset.input] !== typed.value) typed.value = state[typed.dataset.input];
  }
  changed();
}

// ---- the link

function hash() {
  const all = new URLSearchParams();
  all.set("mode", state.mode);
  if (state.mode === "machine") all.set("units", state.units);
  for (const [name, text] of Object.entries(inputs())) all.set(name, text);
  return `#${all}`;
}

function fromHash() {
  const all = new URLSearchParams(location.hash.slice(1));
  if (![...all.keys()].length) return;
  const mode = all.get("mode") === "ratios" || (!all.has("mode") && all.has("omega") && !all.has("mass")) ? "ratios" : "machine";
  state = { mode, units: all.get("units") ?? "" };
  chosen = {};
  const used = new Set(["mode", "units"]);
  for (const names of ROLES[mode]) {
    const name = names.find((own) => all.has(own));
    if (name) {
      used.add(name);
      state[name] = all.get(name);
      chosen[roleName(names)] = name;
    } else {
      state[names[0]] = "";
    }
  }
  const unused = [...all.keys()].filter((name) => !used.has(name));
  $("note").textContent = unused.length ? `Not used from the link: ${unused.map(label).join(", ")}.` : "";
}

window.addEventListener("hashchange", () => {
  if (location.hash === hash()) return;
  fromHash();
  fields();
  changed(true);
});
$("link").onclick = async () => {
  history.replaceState(null, "", hash());
  try {
    await navigator.clipboard.writeText(location.href);
    $("link").textContent = "Copied";
  } catch {
    $("link").textContent = "In the address";
  }
  setTimeout(() => ($("link").textContent = "Copy link"), 1500);
};

// ---- the questions

// A worker with the module. Of several questions of one kind that wait, only the last is asked. A worker that is still
// busy with an old question after a second is replaced when a new one comes.
const PATIENCE = 1000;

class Asker {
  constructor(module) {
    this.module = module;
    this.waiting = new Map();
    this.start();
  }

  start() {
    const source = $("module-source").textContent + $("worker-source").textContent;
    const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.running = null;
    this.worker = new Worker(address);
    this.worker.postMessage({ module: this.module });
    this.worker.onmessage = ({ data }) => {
      URL.revokeObjectURL(address);
      const done = this.running;
      this.running = null;
      // The next question runs while this answer is drawn.
      this.next();
      done.done(data);
    };
  }

  ask(kind, question, done) {
    this.waiting.delete(kind);
    this.waiting.set(kind, { question, done });
    if (this.running && performance.now() - this.since > PATIENCE) {
      this.worker.terminate();
      this.start();
    }
    if (!this.running) this.next();
  }

  next() {
    for (const [kind, request] of this.waiting) {
      this.waiting.delete(kind);
      this.running = request;
      this.since = performance.now();
      this.worker.postMessage({ id: kind, question: request.question });
      return;
    }
  }
}

let live = null;
let slow = null;
let settled = 0;
let late = 0;

// Asks anew whatever depends on the inputs.
function changed(isLink = false) {
  if (!isLink) $("note").textContent = "";
  if (!live) return;
  const asked = question("answer");
  clearTimeout(late);
  late = setTimeout(() => {
    $("verdict").textContent = "Computing …";
    stale(true);
  }, 1000);
  live.ask("answer", asked, ({ ok, error }) => later("answer", ok && { ...ok, inputs: asked.inputs }, error));
  live.ask("motion", question("motion"), ({ ok }) => later("motion", ok));
  live.ask("curve", question("curve", span()), ({ ok }) => later("curve", ok));
  soon();
}

// The range of the curve, with the present point.
function span() {
  const omega = shown.answer?.omega ?? 1;
  return { from: Math.min(0.1, omega / 1.5), to: Math.max(5, 1.5 * omega), count: 240 };
}

function soon() {
  clearTimeout(settled);
  settled = setTimeout(still, 150);
}

// What takes longer is asked when the inputs are still.
function still() {
  history.replaceState(null, "", hash());
  const asked = JSON.stringify(question("slow"));
  if (!shown.answer || asked === still.asked) return;
  still.asked = asked;
  slow.ask("design", question("design"), ({ ok, error }) => showDesign(ok, error));
  const isMany = shown.answer.static_friction_ratio > 1;
  $("limits-section").hidden = !isMany;
  if (isMany) {
    $("limits-text").textContent = "Computing …";
    $("limits").replaceChildren();
    slow.ask("limits", question("limits", { count: 64 }), ({ ok, error }) => {
      // The inputs may have changed meanwhile.
      if (still.asked === asked) showLimits(ok, error);
    });
  }
  if (record) askRecord();
  askMap();
}

// Answers wait for the next frame, and are drawn there.
const drawn = new Map();
let frame = 0;

function later(kind, ok, error) {
  drawn.set(kind, [ok, error]);
  if (!frame) frame = requestAnimationFrame(draw);
}

// Dims what belongs to other inputs than those of now.
function stale(on) {
  for (const section of document.querySelectorAll("main > section")) section.classList.toggle("stale", on && !section.contains($("error")) && !section.contains($("drop")));
}

function draw() {
  frame = 0;
  const all = [...drawn];
  drawn.clear();
  for (const [kind, [ok, error]] of all) {
    if (kind === "answer") {
      clearTimeout(late);
      const failed = error !== undefined;
      $("error").textContent = failed ? error : "";
      document.body.classList.toggle("failed", failed);
      for (const button of document.querySelectorAll("#values-csv, .files button")) button.disabled = failed;
      for (const typed of document.querySelectorAll("[data-input]")) {
        const isNamed = failed && error.includes(label(typed.dataset.input)) && error.startsWith(label(typed.dataset.input).slice(0, 4));
        if (isNamed) typed.setAttribute("aria-invalid", "true");
        else typed.removeAttribute("aria-invalid");
      }
      stale(failed);
      if (failed) {
        $("key").replaceChildren();
        $("all").replaceChildren();
        $("verdict").textContent = "";
        $("notes").textContent = "";
        $("limits-section").hidden = true;
        shown.answer = undefined;
        still.asked = "";
      }
    }
    if (ok === undefined) continue;
    shown[kind] = ok;
    // The slow questions depend on the answer, which may be late.
    if (kind === "answer") soon();
    ({ answer: showAnswer, motion: showMotion, curve: showCurve, map: showMap })[kind](ok);
  }
}

// ---- the answer

const KEY = [
  ["max_velocity", "greatest velocity"], ["max_acceleration", "greatest acceleration"], ["transmitted_force", "transmitted force"],
  ["transmissibility", "transmissibility"], ["max_absolute_displacement", "greatest absolute displacement"],
  ["sticks_per_cycle", "stops in a cycle"], ["stick_fraction", "part of the time at rest"],
  ["energy_out", "work against friction"], ["damper_work", "work against the damper"],
];

const valueText = ({ value, unit, physical }) => {
  const own = Array.isArray(value) ? value.map(([re, im]) => `${digits(re)} ${digits(im)} i`).join(", ") : digits(value === true ? "yes" : value === false ? "no" : value);
  const ratio = unit && unit !== "1" && value !== null ? `${own} ${unit}` : own;
  return [physical ? `${digits(physical.value)}${physical.value === null ? "" : ` ${physical.unit}`}` : ratio, physical ? ratio : ""];
};

const label = (name) => name.replaceAll("_", " ");

function entry(list, name, text) {
  const [term, value] = [document.createElement("dt"), document.createElement("dd")];
  term.textContent = name;
  value.textContent = text;
  list.append(term, value);
}

// What the motion from rest adds to the verdict, without the kind of motion that the verdict states.
function after(first, second, isMany) {
  const rest = second.replace(/^(Stuck|Sticking|Non-sticking|Unbounded|Irregular|Undecided): /, "");
  if (!isMany && (first.includes(rest) || (/never stops/.test(first) && /never stops/.test(second)))) return "";
  const isSame = isMany || first.split(":")[0] === second.split(":")[0];
  if (!isSame) return second;
  return isMany ? `From rest: ${rest.charAt(0).toLowerCase()}${rest.slice(1)}` : rest.charAt(0).toUpperCase() + rest.slice(1);
}

// The greatest displacement of the steady motion in either direction, as the curve has it.
function greatest(answer) {
  const [most, least] = ["max_displacement", "min_displacement"].map((name) => answer?.steady.values?.find((row) => row.name === name));
  const size = (row) => (row ? Math.abs(row.physical ? row.physical.value : row.value) : NaN);
  return most && most.value !== null ? Math.max(size(most), size(least)) : null;
}

function showAnswer(answer) {
  if (JSON.stringify(answer.inputs) === JSON.stringify(inputs())) aim = null;
  if (wanted && state.mode === "machine" && answer.machine) {
    const { omega, alpha } = wanted;
    wanted = null;
    const isSame = (a, b) => Math.abs(a / b - 1) < 1e-3;
    if (!isSame(omega, answer.omega) || !isSame(alpha, answer.alpha)) moveTo(omega, alpha);
  }
  const { steady } = answer;
  const isMany = answer.static_friction_ratio > 1;
  // The closed forms say why, the motion says how often.
  const more = steady.error === undefined ? after(answer.verdict, steady.verdict, isMany) : steady.error;
  $("verdict").textContent = `${answer.verdict} ${more}`.trim();
  $("notes").textContent = [...answer.notes, steady.origin && steady.origin !== "One periodic motion, from every start." ? steady.origin : ""].join(" ").trim();
  const list = $("key");
  list.replaceChildren();
  entry(list, "Ω, α", `${digits(answer.omega)}, ${digits(answer.alpha)}`);
  const rows = steady.values || answer.values;
  const row = (name) => rows.find((own) => own.name === name);
  const [most, least] = [row("max_displacement"), row("min_displacement")];
  if (most && most.value !== null) {
    if (!least || most.value === -least.value) entry(list, "greatest displacement", valueText(most).filter(Boolean).join(" = "));
    else for (const [name, own] of [["displacement from", least], ["to", most]]) entry(list, name, valueText(own).filter(Boolean).join(" = "));
  }
  for (const [name, words] of KEY) {
    const own = row(name);
    // Only a moving base gives the body a displacement in space of its own.
    if (name === "max_absolute_displacement" && !(state.mode === "machine" && inRole(DRIVES).startsWith("base_"))) continue;
    if (own && own.value !== null) entry(list, words, valueText(own).filter(Boolean).join(" = "));
  }
  const border = answer.values.find((own) => own.name === "min_force_ratio");
  // With a higher static friction the border is that of a cycle, which not every start reaches.
  const name = answer.six_reversals ? "two-reversal border" : isMany ? "cycle without a stop from" : "least force without sticking";
  entry(list, name, `${valueText(border).filter(Boolean).join(" = ")} r_y`);
  if (answer.six_reversals) entry(list, "six reversals, no stop", `${answer.six_reversals.map(digits).join(" to ")} r_y`);
  if ($("all").parentElement.open) showAll();
  putKnob();
}

function showAll() {
  const answer = shown.answer;
  if (!answer) return;
  const table = document.createElement("table");
  const row = (cells, of = "td") => {
    const line = table.insertRow();
    for (const text of cells) {
      const cell = document.createElement(of);
      cell.textContent = text;
      line.append(cell);
    }
  };
  row(["", "in units", "in ratios", "meaning"], "th");
  const section = (title, rows) => {
    row([title, "", "", ""], "th");
    for (const own of rows) {
      const [first, second] = own.meaning === undefined ? [`${digits(own.value)} ${own.unit}`, ""] : valueText(own);
      row([`${label(own.name)}${own.symbol ? ` (${own.symbol})` : ""}`, own.physical || own.meaning === undefined ? first : "", own.physical ? second : own.meaning === undefined ? "" : first, own.meaning || ""]);
    }
  };
  if (answer.machine) section("machine", answer.machine);
  section("closed forms", answer.values);
  if (answer.steady.values) section("steady motion from rest", answer.steady.values);
  $("all").replaceChildren(table);
}
$("all").parentElement.ontoggle = showAll;

$("values-csv").onclick = () => {
  const answer = shown.answer;
  if (!answer) return;
  const rows = Object.entries(answer.inputs).map(([name, text]) => ["input", name, text, ""]);
  for (const name of RATIOS) rows.push(["ratios", name, answer[name], "1"]);
  rows.push(...(answer.machine || []).map((row) => ["machine", row.name, row.value, row.unit]));
  for (const [part, values] of [["response", answer.values], ["steady", answer.steady.values || []]]) {
    for (const row of values) {
      rows.push([part, row.name, row.value, row.unit]);
      if (row.physical) rows.push([part, `physical.${row.physical.name}`, row.physical.value, row.physical.unit]);
    }
  }
  const cell = (x) => (x === null ? "" : /[",\n]/.test(String(x)) ? `"${x}"` : x);
  saved("stickslip-values.csv", "text/csv", `part,name,value,unit\n${rows.map((row) => row.map(cell).join(",")).join("\n")}\n`);
};

// ---- the pictures

const charts = {
  curve: new Chart($("curve"), { title: "Response curve", label: "Greatest displacement over the frequency, with the border of sticking", height: 300 }),
  displacement: new Chart($("displacement"), { title: "Displacement over time", height: 190 }),
  velocity: new Chart($("velocity"), { title: "Velocity over time", height: 190 }),
  friction: new Chart($("friction"), { title: "Friction force over time", height: 190 }),
  loop: new Chart($("loop"), { title: "Friction force over displacement", height: 190 }),
  map: new Chart($("map"), { title: "Stops in a cycle over Ω and α", height: 330 }),
  load: new Chart($("load"), { title: "The record", height: 190 }),
  shaken: new Chart($("shaken"), { title: "Displacement under the record", height: 190 }),
  spectrum: new Chart($("spectrum"), { title: "Greatest displacement over the natural period", height: 230 }),
};
charts.map.svg.removeAttribute("role");

const FILES = {
  curve: [["curve"], () => ({ [`frequency[${state.mode === "machine" ? "Hz" : "1"}]`]: shown.curve.frequency, [`displacement[${shown.curve.unit}]`]: shown.curve.displacement, regime: shown.curve.regime, [`border[${shown.curve.unit}]`]: shown.curve.border })],
  motion: [["displacement", "velocity", "friction", "loop"], () => Object.fromEntries(["time", "displacement", "velocity", "friction"].map((name) => [`${name}[${shown.motion.units[name]}]`, shown.motion[name]]))],
  map: [["map"], () => {
    const { omegas, alphas, stops } = shown.map;
    return { omega: alphas.flatMap(() => omegas), alpha: alphas.flatMap((alpha) => omegas.map(() => alpha)), sticks_per_cycle: stops.map((n) => (n === -1 ? "rest" : n === -2 ? "irregular" : n)) };
  }],
  record: [["load", "shaken", "spectrum"], () => ({ "time[s]": shown.record.time, [`displacement[${shown.record.units.displacement}]`]: shown.record.displacement, [`velocity[${shown.record.units.velocity}]`]: shown.record.velocity })],
};

for (const host of document.querySelectorAll(".files")) {
  const [names, columns] = FILES[host.dataset.of];
  const csv = Object.assign(document.createElement("button"), { type: "button", textContent: "CSV", onclick: () => saved(`stickslip-${host.dataset.of}.csv`, "text/csv", csvText(columns())) });
  csv.setAttribute("aria-label", `${host.dataset.of} as CSV`);
  const svg = Object.assign(document.createElement("button"), { type: "button", textContent: "SVG", onclick: () => names.forEach((name) => saved(`stickslip-${name}.svg`, "image/svg+xml", svgText(charts[name].svg, palette().paper))) });
  svg.setAttribute("aria-label", `${host.dataset.of} as SVG`);
  host.append(csv, " ", svg);
}

function showCurve(curve) {
  const chart = charts.curve;
  const { frequency, displacement, border } = curve;
  const isMachine = state.mode === "machine";
  const here = shown.answer;
  const at = here ? here.omega * curve.natural : NaN;
  const height = greatest(here);
  const finite = displacement.filter((x) => x > 0);
  const top = Math.max(...finite, height || 0) * 2.4;
  const least = Math.min(...finite, height > 0 ? height : Infinity) / 1.4;
  const low = Math.max(least, top * 1e-4);
  chart.begin({
    x: [frequency[0], frequency.at(-1)], y: finite.length ? [low, top] : [0.1, 1], xlog: true, ylog: true,
    xlabel: isMachine ? "frequency (Hz)" : "frequency ratio Ω", ylabel: `greatest displacement (${curve.unit})`, legend: true,
  });
  const ink = chart.ink;
  chart.line(frequency, border, ink.border, { width: 1.3, dash: "6 4" });
  const sticks = (i) => curve.regime[i] === "sticking" || curve.regime[i] === "stuck";
  // A part reaches its neighbour, so that the curve has no gaps.
  const part = (of) => (i) => of(i) || (i > 0 && of(i - 1));
  chart.line(frequency, displacement, ink.stick, { width: 4, shown: part(sticks) });
  chart.line(frequency, displacement, ink.slide, { shown: part((i) => !sticks(i)) });
  const first = curve.regime.indexOf("unbounded");
  if (first >= 0) chart.add("text", { x: chart.x(frequency[first]).toFixed(1), y: chart.box.top + 14, "text-anchor": "middle", "font-size": 13, fill: ink.slide }, "∞");
  chart.legend([["slides", ink.slide], ["stops", ink.stick], ["border", ink.border, "6 4"]]);
  if (height !== null && at >= frequency[0] && at <= frequency.at(-1)) chart.dot(at, height, ink.here, 6);
}

const largest = (values) => values.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

let motion = null;

function showMotion(found) {
  motion = { ...found, most: largest(found.displacement) };
  const { time, units, turns, steady } = found;
  $("motion-title").textContent = !steady ? `The first ${turns} turns of the drive` : turns === 1 ? "One cycle of the motion" : `One cycle of the motion, ${turns} turns of the drive`;
  const rows = [["displacement", "displacement"], ["velocity", "velocity"], ["friction", "friction force"]];
  for (const [name, words] of rows) {
    const chart = charts[name];
    chart.begin({ x: [0, time.at(-1)], y: range(found[name]), xlabel: units.time === "rad" ? "ω_d t (rad)" : `time (${units.time})`, ylabel: `${words} (${units[name]})` });
    withRests(chart, time, found[name], found.rest);
    chart.cursor = chart.add("circle", { r: 5, fill: chart.ink.here });
  }
  const loop = charts.loop;
  loop.begin({ x: range(found.displacement), y: range(found.friction), xlabel: `displacement (${units.displacement})`, ylabel: `friction (${units.friction})` });
  withRests(loop, found.displacement, found.friction, found.rest);
  loop.cursor = loop.add("circle", { r: 5, fill: loop.ink.here });
  if (!playing) place(0);
}

function withRests(chart, xs, ys, rest) {
  chart.line(xs, ys, chart.ink.slide);
  if (rest.some(Boolean)) chart.line(xs, ys, chart.ink.stick, { width: 5, shown: (i) => rest[i] });
}

// ---- the animation: a cycle takes three seconds

let playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;

const sketch = (() => {
  const svg = node("svg", { viewBox: "0 0 400 60", width: "100%", height: 60 });
  const spring = node("path", { fill: "none", "stroke-width": 2 });
  const ground = node("path", { d: "M10 52H390M10 10V52", fill: "none", "stroke-width": 2 });
  const block = node("rect", { y: 22, width: 56, height: 29, rx: 3 });
  svg.append(ground, spring, block);
  $("body").append(svg);
  return (part, isAtRest) => {
    const ink = palette();
    const x = 190 + 110 * part;
    block.setAttribute("x", x);
    block.setAttribute("fill", isAtRest ? ink.stick : ink.slide);
    for (const line of [ground, spring]) line.setAttribute("stroke", ink.border);
    const step = (x - 10) / 16;
    let d = "M10 36";
    for (let i = 1; i < 16; i++) d += `L${10 + i * step} ${i % 2 ? 29 : 43}`;
    spring.setAttribute("d", `${d}L${x} 36`);
  };
})();

function place(part) {
  if (!motion) return;
  const last = motion.time.length - 1;
  const i = Math.min(last, Math.round(part * last));
  for (const name of ["displacement", "velocity", "friction"]) {
    const chart = charts[name];
    chart.cursor.setAttribute("cx", chart.x(motion.time[i]));
    chart.cursor.setAttribute("cy", chart.y(motion[name][i]));
  }
  charts.loop.cursor.setAttribute("cx", charts.loop.x(motion.displacement[i]));
  charts.loop.cursor.setAttribute("cy", charts.loop.y(motion.friction[i]));
  sketch(motion.most ? motion.displacement[i] / motion.most : 0, motion.rest[i]);
}

function animate(now) {
  if (!playing) return;
  const length = 3000 * (motion?.turns || 1);
  place((now % length) / length);
  requestAnimationFrame(animate);
}

function play(on) {
  playing = on;
  $("play").textContent = on ? "Pause" : "Play";
  $("play").setAttribute("aria-pressed", String(on));
  if (on) requestAnimationFrame(animate);
}
$("play").onclick = () => play(!playing);

// ---- the map

let mapOf = "";
let dragged = null;

function mapRange() {
  const { omega, alpha, static_friction_ratio } = shown.answer;
  return dragged || { omega: Math.max(2, 1.2 * omega), alpha: Math.max(6, 1.2 * alpha, 3 * static_friction_ratio) };
}

function askMap() {
  const { omega, alpha } = mapRange();
  const { damping_ratio, static_friction_ratio } = shown.answer;
  const key = [omega, alpha, damping_ratio, static_friction_ratio].join();
  if (key === mapOf) return;
  mapOf = key;
  const places = (n, high) => Array.from({ length: n }, (_, i) => ((i + 0.5) / n) * high);
  const [omegas, alphas] = [places(96, omega), places(64, alpha)];
  // The border has poles, and needs more points than the colours.
  const border = places(1000, omega);
  $("map-note").textContent = shown.map ? "" : "Computing …";
  charts.map.host.classList.add("stale");
  slow.ask("map", { ask: "map", omegas, alphas, border, damping_ratio, static_friction_ratio }, ({ ok }) => {
    charts.map.host.classList.remove("stale");
    $("map-note").textContent = "";
    if (ok) later("map", { omegas, alphas, omega, alpha, places: border, ...ok });
  });
}

// The colour of a number of stops: more stops are darker.
function shade(stops) {
  const ink = palette();
  if (stops === -1) return ink.stuck;
  if (stops === -2) return ink.odd;
  if (stops === 0) return ink.slide;
  const light = Math.max(26, 74 - 8 * Math.ceil(stops / 2));
  return `hsl(30 85% ${light}%)`;
}

function showMap(grid) {
  const chart = charts.map;
  const focused = document.activeElement?.classList.contains("here");
  chart.begin({ x: [0, grid.omega], y: [0, grid.alpha], xlabel: "frequency ratio Ω", ylabel: "force ratio α", legend: true });
  const { omegas, alphas, stops } = grid;
  const [w, h] = [grid.omega / omegas.length, grid.alpha / alphas.length];
  const areas = new Map();
  for (let j = 0; j < alphas.length; j++) {
    for (let i = 0; i < omegas.length; ) {
      const n = stops[j * omegas.length + i];
      let end = i + 1;
      while (end < omegas.length && stops[j * omegas.length + end] === n) end++;
      const [x, y] = [chart.x(i * w), chart.y((j + 1) * h)];
      const rect = `M${x.toFixed(1)} ${y.toFixed(1)}H${chart.x(end * w).toFixed(1)}V${(chart.y(j * h) + 0.3).toFixed(1)}H${x.toFixed(1)}Z`;
      areas.set(n, (areas.get(n) || "") + rect);
      i = end;
    }
  }
  for (const [n, d] of areas) chart.add("path", { d, fill: shade(n), stroke: "none" });
  chart.line(grid.places, grid.border, chart.ink.paper, { width: 4 });
  chart.line(grid.places, grid.border, chart.ink.border, { width: 1.6 });
  const counts = [...areas.keys()].filter((n) => n > 0).sort((a, b) => a - b);
  const named = counts.length > 3 ? [counts[0], counts[1], counts.at(-1)] : counts;
  const rows = [["no stop", chart.ink.slide], ["rest", chart.ink.stuck], ...named.map((n) => [`${n} stop${n === 1 ? "" : "s"}`, shade(n)])];
  if (areas.has(-2)) rows.push(["irregular", chart.ink.odd]);
  chart.legend(rows);
  const knob = chart.add("g", { class: "here", tabindex: 0, role: "slider", "aria-label": "Point on the map: the arrow keys change Ω and α", "aria-valuemin": 0, "aria-valuemax": grid.omega });
  knob.append(node("circle", { r: 11, fill: "transparent" }), node("circle", { r: 6.5, fill: chart.ink.here, stroke: chart.ink.paper, "stroke-width": 2 }));
  knob.onkeydown = (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!step) return;
    event.preventDefault();
    const { omega, alpha } = aim || shown.answer;
    const size = event.shiftKey ? 0.1 : 0.01;
    moveTo(Math.max(omega + step[0] * size, 0.001), Math.max(alpha + step[1] * size * 3, 0.001));
  };
  chart.knob = knob;
  putKnob();
  if (focused) knob.focus();
}

function putKnob() {
  const { knob, x, y } = charts.map;
  if (!knob || !shown.answer) return;
  const { omega, alpha } = shown.answer;
  const grid = shown.map;
  knob.setAttribute("transform", `translate(${x(Math.min(omega, grid.omega)).toFixed(1)} ${y(Math.min(alpha, grid.alpha)).toFixed(1)})`);
  knob.setAttribute("aria-valuenow", digits(omega));
  knob.setAttribute("aria-valuetext", `Ω = ${digits(omega)}, α = ${digits(alpha)}`);
}

charts.map.svg.addEventListener("pointerdown", (event) => {
  const grid = shown.map;
  if (!grid) return;
  dragged = { omega: grid.omega, alpha: grid.alpha };
  charts.map.svg.setPointerCapture(event.pointerId);
  const move = (at) => {
    const box = charts.map.svg.getBoundingClientRect();
    const part = charts.map.svg.viewBox.baseVal.width / box.width;
    const within = (value, high) => Math.min(Math.max(value, high / 1000), high);
    moveTo(within(charts.map.x.back((at.clientX - box.left) * part), grid.omega), within(charts.map.y.back((at.clientY - box.top) * part), grid.alpha));
  };
  move(event);
  charts.map.svg.onpointermove = move;
  charts.map.svg.onpointerup = charts.map.svg.onpointercancel = () => {
    charts.map.svg.onpointermove = null;
    dragged = null;
  };
});

// ---- design and limits

// Each sentence with the answers that it has.
const SENTENCES = [
  [["six_reversals_from", "six_reversals_to", "two_reversals_from"], "The body does not stop at a force of {} to {}, where it reverses six times a cycle, and of {} or more."],
  [["force", "unbalance", "foot_displacement", "base_displacement"], "WHO at a force of {} or more: an unbalance of {}, a motion of {} of the spring's foot, or of {} of a base that carries the surface."],
  [["cycle_force", "release_force"], "A cycle without a stop exists at a force of {} or more; a body at rest is released above {}."],
  [["every_start_force"], "Every start slides without a stop in the long run above {}; this bound suffices and is not the least."],
  [["cycle_friction"], "Under this drive a cycle without a stop exists with a friction of {} or less."],
  [["friction"], "WHO under this drive with a friction of {} or less."],
  [["best_friction", "energy"], "Among motions without a stop, dissipation is greatest with a friction of {}: {} a cycle."],
  [["force_ratio"], "WHO at a force of {} or more."],
  [["friction_to_force"], "WHO with a friction of {} or less."],
  [["best_force_ratio"], "Among motions without a stop, dissipation is greatest at a force of {}."],
];

function showDesign(rows, error) {
  const list = $("design");
  list.replaceChildren();
  if (error !== undefined) return;
  // With six reversals the least force of the cycle of two is not that of the body.
  const who = rows.some((row) => row.name === "six_reversals_from") ? "The cycle of two reversals does not stick" : "The body never sticks";
  for (const [names, sentence] of SENTENCES) {
    const found = names.map((name) => rows.find((row) => row.name === name));
    if (!found.every(Boolean)) continue;
    const item = document.createElement("li");
    const failed = found.find((row) => row.error !== undefined);
    item.textContent = failed ? `No answer: ${failed.error}.` : found.reduce((text, row) => text.replace("{}", `${digits(row.value)} ${row.unit}`), sentence.replace("WHO", who));
    if (item.textContent !== list.lastChild?.textContent) list.append(item);
  }
}

function showLimits(found, error) {
  const list = $("limits");
  list.replaceChildren();
  $("limits-text").textContent = error !== undefined ? error : `${found.limits.length} ${found.limits.length === 1 ? "limit" : "limits"} from ${found.starts} starts with |x| ≤ ${digits(found.reach)} B and |v| ≤ ${digits(found.reach)} B ω_d${found.unsettled ? `; ${found.unsettled} had not settled` : ""}.`;
  for (const row of found?.limits || []) {
    const item = document.createElement("li");
    const unit = found.unit;
    const range = row.range ? ` ${row.is_family ? "Mean positions" : "Positions"} from ${digits(row.range[0])} to ${digits(row.range[1])} ${unit}.` : "";
    const extrema = row.extrema && !row.range ? ` Displacement from ${digits(row.extrema[0])} to ${digits(row.extrema[1])} ${unit}.` : "";
    const stops = row.stops ? ` ${row.stops} ${row.stops === 1 ? "stop" : "stops"} in a cycle.` : "";
    item.textContent = `${digits(Math.round(row.share * 1e4) / 100)} % of the starts: ${row.description}.${stops}${extrema}${range}`;
    list.append(item);
  }
}

// ---- a record

let record = null;

async function take(file) {
  record = { name: file.name, text: await file.text() };
  $("record-name").textContent = file.name;
  askRecord();
}

function askRecord() {
  if (state.mode !== "machine") {
    $("record-error").textContent = "A record needs a machine in units, with its mass.";
    $("record-shown").hidden = true;
    return;
  }
  const more = { text: record.text, name: record.name, time_step: $("step").value, column: $("column").value, record_units: $("record-units").value };
  slow.ask("record", question("record", more), ({ ok, error }) => {
    $("record-error").textContent = error === undefined ? (ok.unused.length ? `Columns not used: ${ok.unused.join(", ")}.` : "") : error;
    $("record-shown").hidden = error !== undefined;
    $("record-read").textContent = ok ? ok.read : "";
    if (ok) {
      shown.record = { ...ok, most: largest(ok.displacement) };
      showRecord(shown.record);
    }
  });
  const periods = Array.from({ length: 60 }, (_, i) => 0.05 * 100 ** (i / 59));
  slow.ask("spectrum", question("spectrum", { ...more, periods }), ({ ok }) => {
    if (ok) {
      shown.spectrum = ok;
      showSpectrum(ok);
    }
  });
}

function showRecord(found) {
  const { load, shaken } = charts;
  const end = Math.max(found.time.at(-1), found.load.time.at(-1));
  load.begin({ x: [found.load.time[0], end], y: range(found.load.value), xlabel: "time (s)", ylabel: `load (${found.load.unit})` });
  load.line(found.load.time, found.load.value, load.ink.second, { width: 1 });
  shaken.begin({ x: [found.time[0], end], y: range(found.displacement), xlabel: "time (s)", ylabel: `displacement (${found.units.displacement})` });
  withRests(shaken, found.time, found.displacement, found.rest);
  shaken.cursor = shaken.add("circle", { r: 5, fill: shaken.ink.here, cx: -20, cy: -20 });
  const list = $("record-values");
  list.replaceChildren();
  const value = (name) => found.values.find((row) => row.name === name).value;
  const [slides, rest] = [value("slides"), value("residual_displacement")];
  const times = slides === 1 ? "once" : `${slides} times`;
  $("record-verdict").textContent = slides === 0 ? "The body rests throughout."
    : `The body slides ${times}, and ${rest === null ? `never comes to rest; its motion is cut at ${digits(value("cut_time"))} s` : `comes to rest at ${digits(rest)} ${found.units.displacement}`}.`;
  for (const { name, value, unit } of found.values) entry(list, label(name), `${digits(value)} ${value === null ? "" : unit}`);
}

function showSpectrum(found) {
  const chart = charts.spectrum;
  const most = found.answers.max_displacement.map((x, i) => Math.max(Math.abs(x), Math.abs(found.answers.min_displacement[i])));
  const positive = most.filter((x) => x > 0);
  chart.begin({
    x: [found.periods[0], found.periods.at(-1)], y: positive.length ? [Math.min(...positive) / 1.4, Math.max(...positive) * 1.4] : [0.1, 1],
    xlog: true, ylog: true, xlabel: "natural period (s)", ylabel: `displacement (${found.unit})`,
  });
  chart.line(found.periods, most, chart.ink.slide);
}

$("play-record").onclick = () => {
  const begin = performance.now();
  play(false);
  const step = (now) => {
    const found = shown.record;
    const time = found.time[0] + (now - begin) / 1000;
    let i = found.time.findIndex((t) => t >= time);
    if (i < 0) i = found.time.length - 1;
    const { cursor, x, y } = charts.shaken;
    cursor.setAttribute("cx", x(found.time[i]));
    cursor.setAttribute("cy", y(found.displacement[i]));
    sketch(found.most ? found.displacement[i] / found.most : 0, found.rest[i]);
    if (!playing && i < found.time.length - 1) requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
};
$("file").onchange = async () => {
  const [file] = $("file").files;
  if (!file) return;
  await take(file);
  // So that the same file can be chosen again after a change.
  $("file").value = "";
};
for (const id of ["step", "column", "record-units"]) {
  $(id).oninput = () => record && askRecord();
}
document.body.addEventListener("dragover", (event) => {
  event.preventDefault();
  $("drop").classList.add("over");
});
document.body.addEventListener("dragleave", () => $("drop").classList.remove("over"));
document.body.addEventListener("drop", (event) => {
  event.preventDefault();
  $("drop").classList.remove("over");
  if (event.dataTransfer.files[0]) take(event.dataTransfer.files[0]);
});

// ---- theme, size, begin

function theme(name) {
  document.documentElement.dataset.theme = name;
  $("theme").textContent = name === "dark" ? "Light" : "Dark";
  $("theme").setAttribute("aria-pressed", String(name === "dark"));
  try {
    localStorage.setItem("theme", name);
  } catch {
    // A page from a file may have no storage.
  }
  redraw();
}

function redraw() {
  for (const kind of ["answer", "motion", "curve", "map"]) if (shown[kind]) later(kind, shown[kind]);
  if (shown.record) showRecord(shown.record);
  if (shown.spectrum) showSpectrum(shown.spectrum);
}

$("theme").onclick = () => theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
let width = innerWidth;
addEventListener("resize", () => {
  if (innerWidth !== width) redraw();
  width = innerWidth;
});

async function begin() {
  fromHash();
  fields();
  let kept = null;
  try {
    kept = localStorage.getItem("theme");
  } catch {
    // As above.
  }
  theme(kept || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));
  try {
    const module = await WebAssembly.compile(await unpacked($("wasm").textContent.trim()));
    live = new Asker(module);
    slow = new Asker(module);
  } catch (error) {
    $("error").textContent = `This browser cannot run the page: ${error.message}`;
    return;
  }
  changed(true);
  if (playing) requestAnimationFrame(animate);
  else play(false);
}

begin();
