// The inputs: what is typed, by the way the machine is given; their history, and their link.
"use strict";

const $ = (id) => document.getElementById(id);

// What the fields are. A role with several inputs has a choice.
const ROLES = {
  machine: [
    ["mass"],
    ["stiffness", "period", "pendulum_radius"],
    ["friction", "friction_coefficient"],
    ["damping_ratio", "damping"],
    ["force", "unbalance", "base_acceleration", "base_velocity", "base_displacement", "foot_displacement", "damped_foot_displacement"],
    ["frequency"],
    ["static_friction_ratio", "static_friction"],
    ["mean_force"],
    ["x0"],
    ["v0"],
  ],
  ratios: [["omega"], ["alpha"], ["damping_ratio"], ["static_friction_ratio"], ["x0"], ["v0"]],
};
const DRIVES = ROLES.machine[4];
// The roles that stand behind “more”.
const MORE = ["static_friction_ratio", "mean_force", "x0", "v0"];
// The names of the fields.
const WORDS = {
  mass: "mass m", stiffness: "stiffness k", period: "natural period", pendulum_radius: "pendulum radius", friction: "friction r_y",
  friction_coefficient: "coefficient µ", damping_ratio: "damping ratio ζ", damping: "damping c", static_friction_ratio: "static ratio η",
  static_friction: "static friction", force: "force p₀", unbalance: "unbalance", base_acceleration: "base acceleration",
  base_velocity: "base velocity", base_displacement: "base displacement", foot_displacement: "support motion",
  damped_foot_displacement: "support, damper", frequency: "frequency", mean_force: "mean force", omega: "Ω = ω_d/ω_n", alpha: "α = p₀/r_y",
  x0: "start x₀", v0: "start v₀",
};
// Inputs of either sign, and inputs that may be 0.
const SIGNED = new Set(["mean_force", "x0", "v0"]);
const ZERO = new Set(["stiffness", "friction", "friction_coefficient", "damping_ratio", "damping", "mean_force", "x0", "v0", ...DRIVES]);
// The power of the frequency that the force of a drive has.
const POWERS = { unbalance: 2, base_velocity: 1, base_displacement: 2 };
const START = {
  mode: "machine", units: "kN,m", mass: "50 t", stiffness: "1000 kN/m", friction: "5 kN", damping_ratio: "2 %", force: "12 kN", frequency: "1 Hz",
};
// What a field shows when it is first chosen.
const FIRST = {
  ...START, omega: "1.4", alpha: "2.4", static_friction_ratio: "1", mean_force: "0", x0: "0", v0: "0",
  period: "1.4 s", pendulum_radius: "0.5 m", friction_coefficient: "0.01", damping: "9 kN*s/m", static_friction: "6 kN", unbalance: "0.3 t*m",
  base_acceleration: "0.02 g", base_velocity: "50 mm/s", base_displacement: "6 mm", foot_displacement: "12 mm", damped_foot_displacement: "12 mm",
};
// The sizes about which the slider of an empty field, or of one that is 0, is centred.
const CENTRES = { ...FIRST, static_friction_ratio: "1", mean_force: "1 kN", x0: "10 mm", v0: "100 mm/s" };
// The unit of a bare number by the units F of force and L of length. Ratios and times have the same in all units.
const BARE = {
  mass: "F*s^2/L", stiffness: "F/L", pendulum_radius: "L", friction: "F", damping: "F*s/L", static_friction: "F", force: "F", unbalance: "F*s^2",
  base_acceleration: "L/s^2", base_velocity: "L/s", base_displacement: "L", foot_displacement: "L", damped_foot_displacement: "L", mean_force: "F",
  x0: "L", v0: "L/s",
};

// Writes the unit after each bare number, so that a change of the units leaves the machine as it is.
function withUnits(of, units, bare = BARE) {
  const found = /^\s*([nµmkMG]?N|lbf|kip|kgf|tf|dyn)\s*,\s*([nµmck]?m|in|ft)\s*$/u.exec(units ?? "");
  if (!found) return;
  for (const [name, form] of Object.entries(bare)) {
    const own = parts(of[name]);
    if (own && !own[1] && own[0] !== 0) of[name] = `${of[name].trim()} ${form.replace("F", found[1]).replace("L", found[2])}`;
  }
}

const RATIOS = ["omega", "alpha", "damping_ratio", "static_friction_ratio"];

const PRESETS = {
  isolator: ["Isolator", "mode=machine&units=N,mm&mass=800 kg&period=2.2 s&friction_coefficient=0.05&base_acceleration=0.15 g&frequency=2 Hz", "An 800 kg unit on a sliding isolator, floor shaken with 0.15 g at 2 Hz."],
  dither: ["Dither", "mode=machine&units=N,mm&mass=0.4 kg&stiffness=20 N/mm&friction=3 N&damping_ratio=3 %&force=12 N&frequency=90 Hz", "A valve spool kept moving by a small fast force, so that friction cannot hold it."],
  feeder: ["Feeder", "mode=machine&units=N,mm&mass=12 kg&stiffness=140 N/mm&friction=25 N&damping_ratio=2 %&unbalance=0.02 kg*m&frequency=1500 rpm", "A feeder trough on leaf springs, driven by a rotating unbalance."],
  damper: ["Friction damper", "mode=machine&units=kN,mm&mass=20 t&period=0.5 s&friction=40 kN&damping_ratio=1 %&base_acceleration=0.3 g&frequency=2 Hz", "A storey with a friction brace at resonance: the brace holds what the spring cannot."],
  slope: ["Slope", "mode=machine&units=N,mm&mass=2 kg&stiffness=1.5 N/mm&friction=5.795 N&mean_force=3.406 N&force=9 N&frequency=3 Hz", "A block on a slope of 10° with µ = 0.3: the friction is µ m g cos 10°, and gravity along the slope, m g sin 10°, is a constant force beside the shaking."],
  decay: ["Free decay", "mode=machine&units=N,mm&mass=2 kg&stiffness=1.5 N/mm&friction=1 N&damping_ratio=1 %&force=0 N&frequency=4 Hz&x0=12 mm", "Pulled aside and let go: friction takes the same amount of every swing."],
  crate: ["Crate on a truck", "mode=machine&units=N,mm&mass=200 kg&stiffness=0&friction_coefficient=0.2&base_acceleration=3 m/s^2&frequency=2 Hz", "A crate that nothing but friction holds, on a bed that shakes: a stiffness of 0 is no spring."],
  textbook: ["Textbook Ω = 0.4", "mode=ratios&omega=0.4&alpha=6", "Hong and Liu's case below half the natural frequency, where the printed border falls short."],
};

let state = { ...START };
// The chosen input of each role with a choice.
let chosen = {};
// What is shown: the last answers.
const shown = {};

const roleName = (names) => names[0];
const inRole = (names) => names.find((name) => name === chosen[roleName(names)]) || names.find((name) => state[name] !== undefined) || names[0];
const isZero = (text) => parts(text)?.[0] === 0;

// The inputs of the question.
function inputs() {
  const given = {};
  for (const names of ROLES[state.mode]) {
    const name = inRole(names);
    if (state[name] && !(["mean_force", "x0", "v0"].includes(name) && isZero(state[name]))) given[name] = state[name];
  }
  return given;
}

const question = (ask, more = {}) => ({ ask, inputs: inputs(), units: state.mode === "machine" ? state.units : "", ...more });

// ---- the history: a step is a machine that stood still for a moment

// Which of the page's two machines is seen; each has a history of its own.
let tab = "one";
const VIEWS = {
  one: {
    title: "A mass on a spring with dry friction, under vibration",
    start: () => ({ state: START, chosen: {} }),
    of: () => ({ state, chosen }),
    put: (machine) => {
      ({ state, chosen } = machine);
      back.clear();
      fields();
      changed();
    },
  },
  two: {
    title: "Two masses with dry friction, springs and an end stop, under vibration",
    start: () => BASE_SYSTEM,
    of: () => two,
    put: (machine) => {
      two = machine;
      systemFields();
      changedSystem();
    },
  },
};
for (const view of Object.values(VIEWS)) Object.assign(view, { past: [], future: [] });
const snapshot = () => JSON.stringify(VIEWS[tab].of());

// Keeps the present machine as a step, if it is another one.
function remember() {
  const view = VIEWS[tab];
  const now = snapshot();
  if (now === view.present) return;
  view.past.push(view.present);
  if (view.past.length > 200) view.past.shift();
  view.future.length = 0;
  view.present = now;
  historyButtons();
}

function historyButtons() {
  for (const [id, of] of [["undo", "past"], ["redo", "future"]]) $(id).disabled = !VIEWS[tab][of].length;
}

function step(from, to) {
  remember();
  const view = VIEWS[tab];
  if (!view[from].length) return;
  view[to].push(view.present);
  view.put(JSON.parse(view[from].pop()));
  // The form adds the fields that were not there yet.
  view.present = snapshot();
  historyButtons();
}

// ---- the link

// What was left for another kind of input, so that the way back leads to the same text.
const back = new Map();

function hash(more = {}) {
  const all = new URLSearchParams();
  all.set("mode", state.mode);
  if (state.mode === "machine") all.set("units", state.units);
  for (const [name, text] of Object.entries(inputs())) all.set(name, text);
  for (const [name, text] of Object.entries(more)) all.set(name, text);
  return `#${all}`;
}

function from(text) {
  const all = new URLSearchParams(text);
  if (all.has("system")) return;
  if (![...all.keys()].some((name) => name !== "embed")) return;
  const mode = all.get("mode") === "ratios" || (!all.has("mode") && all.has("omega") && !all.has("mass")) ? "ratios" : "machine";
  state = { mode, units: all.get("units") ?? "" };
  chosen = {};
  back.clear();
  const used = new Set(["mode", "units", "embed"]);
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

const label = (name) => name.replaceAll("_", " ");

// The words of the command that gives the same answer.
function commandLine(ask = "steady") {
  const words = Object.entries(inputs()).map(([name, text]) => {
    const value = text.trim();
    return `--${name.replaceAll("_", "-")}${value.startsWith("-") ? "=" : " "}${/[^\w.%/*²-]/u.test(value) ? `"${value}"` : value}`;
  });
  return `stickslip ${ask} ${words.join(" ")}${state.mode === "machine" && state.units ? ` --units ${state.units}` : ""}`;
}
