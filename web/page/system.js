// Two masses: their description as a file of the command, and its answers.
"use strict";

const SYSTEM_FIELDS = [
  ["Masses", [["m1", "lower mass", "1 t"], ["m2", "upper mass", "500 kg"]]],
  ["Springs", [["k1", "ground – lower", "200 N/mm"], ["k2", "lower – upper", "300 N/mm"]]],
  ["Dampers", [["c1", "ground – lower", "0.3 N*s/mm"], ["c2", "lower – upper", ""]]],
  ["Contact", [["contact", "between", "ground,lower"], ["friction", "friction", "450 N"], ["elastic", "its stiffness, if elastic", ""], ["peak", "static ratio, if > 1", ""], ["falls", "friction at speed", ""], ["over", "from a speed of", ""], ["law", "on the way", ""], ["exponent", "its exponent, if not 2", ""], ["viscous", "viscous part", ""], ["belt", "belt: ground moves", ""]]],
  ["End stop", [["stop", "between", "lower,upper"], ["gap", "gap, if there is one", ""], ["stop_stiffness", "stiffness", "10 kN/mm"], ["restitution", "or restitution, 0 to 1", ""]]],
  ["Load", [["load", "kind", "upper"], ["amplitude", "amplitude", "1.5 kN"], ["frequency", "frequency", "3 Hz"], ["shape", "shape", "sine"], ["duty", "part that is up", "0.5"], ["constant", "constant part", ""], ["column", "column of the file", ""], ["record_units", "its unit, such as g", ""], ["time_step", "time step", ""]]],
];
const CHOICES = {
  contact: [["ground,lower", "ground, lower"], ["lower,upper", "lower, upper"], ["ground,upper", "ground, upper"]],
  stop: [["lower,upper", "lower, upper"], ["ground,lower", "ground, lower"], ["ground,upper", "ground, upper"]],
  load: [["upper", "force, upper"], ["lower", "force, lower"], ["base", "base moves"], ["record", "base: a record"]],
  law: [["", "in a straight line"], ["stribeck", "by Stribeck's law"]],
  shape: [["sine", "sine"], ["square", "square"], ["triangle", "triangle"], ["sawtooth", "sawtooth"], ["pulse", "pulse"]],
};
// Fields that are there for a choice alone.
const isStribeck = (of) => Boolean(of.law) && Boolean(of.falls?.trim());
const isCut = (of) => /square|pulse/.test(of.shape ?? "");
const isRecorded = (of) => of.load === "record";
const isWave = (of) => !isRecorded(of);
const FOR = {
  exponent: isStribeck, viscous: isStribeck, amplitude: isWave, frequency: isWave, shape: isWave, constant: isWave, duty: (of) => isWave(of) && isCut(of),
  column: isRecorded, record_units: isRecorded, time_step: isRecorded,
};
// The record of the base: a file that is chosen, or the sample.
let twoRecord = null;
const BARE_TWO = {
  m1: "F*s^2/L", m2: "F*s^2/L", k1: "F/L", k2: "F/L", c1: "F*s/L", c2: "F*s/L", friction: "F", elastic: "F/L", gap: "L", stop_stiffness: "F/L", falls: "F", over: "L/s", viscous: "F*s/L", belt: "L/s", amplitude: "F", constant: "F",
};
const SYSTEM_PRESETS = {
  machine: ["Machine on a slide", {}],
  storeys: ["Friction damper between storeys", { units: "kN,mm", m1: "20 t", m2: "20 t", k1: "20 kN/mm", k2: "20 kN/mm", c1: "0.02 kN*s/mm", c2: "0.02 kN*s/mm", contact: "lower,upper", friction: "100 kN", elastic: "40 kN/mm", load: "base", amplitude: "0.2 g", frequency: "3 Hz" }],
  building: ["Building on a slider", { units: "kN,mm", m1: "100 t", m2: "100 t", k1: "", k2: "50 kN/mm", c1: "", c2: "0.2 kN*s/mm", friction: "157 kN", load: "base", amplitude: "0.15 g", frequency: "1.5 Hz" }],
  brake: ["Squealing brake", { m1: "2 kg", m2: "5 kg", k1: "2 kN/mm", k2: "3 kN/mm", c1: "0.05 N*s/mm", c2: "0.1 N*s/mm", friction: "500 N", falls: "300 N", over: "2 m/s", belt: "0.5 m/s", peak: "1.2", amplitude: "" }, "A pad on a disc: friction falls with speed, and the pad drives itself."],
  drill: ["Drill string", { units: "N,m", m1: "2122 kg", m2: "472 kg", k1: "4000 N/m", k2: "861.5 N/m", c1: "425 N*s/m", c2: "20 N*s/m", contact: "ground,upper", friction: "8000 N", falls: "5000 N", over: "3 m/s", law: "stribeck", exponent: "1", viscous: "10 N*s/m", belt: "5 m/s", amplitude: "" }, "A drive above and a bit below on a string that twists, seen from the drive: the metres are arcs at a radius of 1 m. The friction at the bit falls with speed, and it sticks and slips."],
  hammer: ["Hammer", { m1: "40 kg", m2: "2 kg", k1: "20 N/mm", k2: "8 N/mm", c1: "0.4 N*s/mm", c2: "0.02 N*s/mm", contact: "lower,upper", friction: "4 N", stop: "lower,upper", gap: "2 mm", restitution: "0.4", amplitude: "60 N", frequency: "9 Hz" }, "A ram in a housing beats its end, and comes back with two fifths of its speed."],
  conveyor: ["Conveyor", { m1: "20 kg", m2: "2 kg", k1: "80 N/mm", k2: "", c1: "0.2 N*s/mm", contact: "lower,upper", friction: "5.9 N", load: "lower", amplitude: "400 N", frequency: "6 Hz", shape: "pulse", duty: "0.25" }, "A tray on leaf springs is pushed forward in pulses: the part on it drifts."],
  belt: ["Block on a belt", { m1: "20 kg", m2: "5 kg", k1: "20 N/mm", k2: "5 N/mm", c1: "0.01 N*s/mm", c2: "0.005 N*s/mm", friction: "100 N", falls: "60 N", over: "0.3 m/s", belt: "0.05 m/s", amplitude: "" }],
  free: ["Block without a spring", { k1: "", c1: "", m2: "50 kg", k2: "20 N/mm", c2: "0.05 N*s/mm", friction: "450 N", load: "lower", amplitude: "1.5 kN", frequency: "3 Hz" }],
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
        const load = two.load === "base" ? "L/s^2" : "F";
        withUnits(two, two.units, { ...BARE_TWO, amplitude: load, constant: load });
        for (const own of Object.keys(BARE_TWO)) $(`two-${own}`).value = two[own];
      }
      two[name] = made.value;
      // A force and an acceleration are not of one kind.
      if (name === "load" && (made.value === "base") !== /g$|m\/s/.test(two.amplitude)) {
        two.amplitude = made.value === "base" ? "0.2 g" : "1.5 kN";
        two.constant = "";
        for (const own of ["amplitude", "constant"]) $(`two-${own}`).value = two[own];
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
  // Where the file of a record is chosen.
  const row = Object.assign(document.createElement("p"), { id: "two-record" });
  const file = Object.assign(document.createElement("input"), { type: "file", id: "two-file" });
  file.setAttribute("aria-label", "Record of the base's acceleration");
  file.onchange = async () => file.files[0] && takeTwo(file.files[0].name, new Blob([await file.files[0].arrayBuffer()]));
  const sample = Object.assign(document.createElement("button"), { type: "button", id: "two-sample", textContent: "Sample record", onclick: () => takeTwo("sample.csv", new Blob([sampleRecord()])) });
  row.append(file, " ", sample, " ", Object.assign(document.createElement("strong"), { id: "two-record-name" }));
  host.lastChild.append(row);
}

function takeTwo(name, file) {
  twoRecord = { name, file };
  changedSystem();
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
    const [friction, falls, over] = ["friction", "falls", "over"].map((name) => quoted(of[name] ?? ""));
    const more = ["exponent", "viscous"].filter(has).map((name) => `, ${name} = ${quoted(of[name])}`).join("");
    // A friction that falls with speed is straight from rest to the speed from which it stays, or a curve.
    const law = isStribeck(of) ? `law = { static = ${friction}, kinetic = ${falls}, speed = ${over}${more} }` : `law = [["0 m/s", ${friction}], [${over}, ${falls}], ["1e6 m/s", ${falls}]]`;
    lines.push("[[contacts]]", 'name = "contact"', between("contact"), has("falls") ? law : `friction = ${friction}`);
    if (has("belt")) lines.push(`moves = ${quoted(of.belt)}`);
    if (has("elastic")) lines.push(`stiffness = ${quoted(of.elastic)}`);
    if (has("peak")) lines.push(`${has("falls") ? "peak" : "static_ratio"} = ${quoted(of.peak)}`);
  }
  if (has("gap")) lines.push("[[stops]]", 'name = "stop"', between("stop"), `gap = ${quoted(of.gap)}`, has("restitution") ? `restitution = ${quoted(of.restitution)}` : `stiffness = ${quoted(of.stop_stiffness)}`);
  // A record is another file, and no part of this one.
  const load = of.load === "record" ? [] : has("amplitude") ? ["amplitude", "frequency", ...((of.shape ?? "sine") === "sine" ? [] : ["shape"]), ...(isCut(of) ? ["duty"] : [])] : [];
  if (has("constant") && of.load !== "record") load.push("constant");
  const values = load.map((name) => `${name} = ${quoted(of[name])}`);
  if (values.length && of.load === "base") lines.push("[base]", `acceleration = { ${values.join(", ")} }`);
  else if (values.length) lines.push("[[forces]]", `on = ${quoted(of.load)}`, ...values);
  return `${lines.join("\n")}\n`;
}

let [systemTimer, systemLate] = [0, 0];

function changedSystem() {
  const text = systemText();
  if (text !== changedSystem.text) $("system-about").textContent = "";
  changedSystem.text = text;
  for (const [name, is] of Object.entries(FOR)) $(`two-${name}`).parentElement.hidden = !is(two);
  $("two-record").hidden = !isRecorded(two);
  $("two-record-name").textContent = twoRecord?.name ?? "";
  $("system-of").textContent = isRecorded(two) ? `record ${twoRecord?.name ?? "RECORD"}` : "steady";
  $("two-stop_stiffness").disabled = Boolean(two.restitution.trim());
  $("system-file").textContent = text;
  if (tab === "two") history.replaceState(null, "", currentHash());
  if (!live) return;
  if (busy.isStopped) stopped(false);
  // What is of another system is dimmed, gives no file, and after a moment has no verdict.
  if (twoAnswer?.text !== text) {
    shown.systemCurve = undefined;
    slow.drop("system-curve");
    $("system-shown").classList.add("stale");
    clearTimeout(systemLate);
    systemLate = setTimeout(() => {
      $("system-verdict").textContent = "Computing …";
      $("system-border").textContent = "";
    }, 1000);
  }
  fileButtons();
  const asked = { ask: "system", text, count: isRecorded(two) ? 4000 : 600, ...(isRecorded(two) ? { ...twoRecord, column: two.column, record_units: two.record_units, time_step: two.time_step } : {}) };
  if (isRecorded(two) && !twoRecord) {
    clearTimeout(systemLate);
    $("system-error").textContent = "Choose a record, or the sample.";
    $("system-shown").hidden = true;
    twoAnswer = null;
    return;
  }
  changedSystem.asked = asked;
  live.ask("system", asked, ({ ok, error }) => {
    if (systemText() !== text || changedSystem.asked !== asked) return;
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
    if (systemText() !== text || !twoAnswer) return;
    const { description, motion } = twoAnswer;
    // A load of another shape is no harmonic, and repeats itself in a part of the period.
    const loads = /^\[base]|^amplitude/m.test(text) && !isZero(two.amplitude) ? [...description.harmonics, ...(two.shape === "sine" || !motion.period ? [] : [(2 * Math.PI * motion.periods) / motion.period])] : [];
    // Without a load there is nothing over its frequency.
    for (const id of ["two-curve", "two-curve-files"]) $(id).hidden = !own || !loads.length;
    if ($("two-curve").hidden) return;
    const modes = [...description.natural_frequencies, ...description.natural_frequencies_stuck, ...loads].filter((x) => x > 0).map((x) => x / (2 * Math.PI));
    const [low, high] = [Math.min(...modes) / 2, Math.max(...modes) * 1.6];
    const even = Array.from({ length: 160 }, (_, i) => low * (high / low) ** (i / 159));
    // Every eighth place first, then those between, and the peaks at last: a curve that takes long is seen as it comes. The
    // worker knows the places that it has answered.
    const next = (part) => {
      const frequencies = [...even.filter((_, i) => i % part === 0), ...modes].sort((a, b) => a - b);
      slow.ask("system-curve", { ask: "system-curve", text, frequencies, resolved: part < 1 }, ({ ok }) => {
        if (!ok || systemText() !== text) return;
        $("two-curve").classList.remove("stale");
        // A file has the whole curve.
        if (part < 1) shown.systemCurve = ok;
        showSystemCurve(ok);
        fileButtons();
        if (part >= 1) next(part / 2);
      });
    };
    next(8);
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

// The ranges of the bodies, the rests, blows and works of the elements, and the drift of an answer for a system.
function showMotionOf(list, motion) {
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
    if (element.blows !== undefined) entry(list, `${element.name}: blows`, String(element.blows));
    // An elastic stop of the page has no damper, and does no work in a period.
    if (element.kind !== "stop" || element.blows !== undefined) entry(list, `${element.name}: work`, readable(Math.abs(element.work) < 1e-12 * works ? 0 : element.work, units.work), `${element.work} ${units.work}`);
  }
  motion.coordinates.forEach((name, i) => {
    const speed = motion.mean_velocity?.[i];
    if (speed) entry(list, `${name}: drift`, `${readable(speed, units.velocity)} in the mean`, `${speed} ${units.velocity}`);
  });
}

// The greatest displacement of a body in either direction.
const greatestOf = ({ min_displacement, max_displacement }, i) => Math.max(Math.abs(min_displacement[i]), Math.abs(max_displacement[i]));

function showSystem(found) {
  const { motion, samples } = found;
  const below = found.read ? `${found.read} The pictures have ${samples.time.length} states at equal times, the extremes are those of the whole motion.` : found.border_verdict;
  sentence("system-verdict", found.verdict);
  sentence("system-border", below);
  bar("two", `${found.verdict.replace(/:.*/s, "")} · ${motion.coordinates.map((name, i) => `${name} ${readable(greatestOf(motion, i), motion.units.displacement)}`).join(", ")}`);
  const list = $("system-values");
  list.replaceChildren();
  const { units } = motion;
  showMotionOf(list, motion);
  const hertz = (own) => own.map((omega) => four(omega / (2 * Math.PI))).join(", ");
  entry(list, "natural frequencies, sliding", `${hertz(found.description.natural_frequencies)} Hz`);
  entry(list, "natural frequency with the contact stuck", `${hertz(found.description.natural_frequencies_stuck)} Hz`);
  // Without a load a motion that begins later is the same motion: the multiplier of that is 1, and tells nothing.
  const multipliers = [...(motion.multipliers ?? [])].sort((a, b) => Math.hypot(b[0] - 1, b[1]) - Math.hypot(a[0] - 1, a[1]));
  if (!found.description.harmonics.length) multipliers.pop();
  if (multipliers.length) {
    const most = Math.max(...multipliers.map(([re, im]) => Math.hypot(re, im)));
    entry(list, "a disturbance", `${most < 1 ? "shrinks" : "grows"} to ${four(most)} of its size in each period`, String(most));
  }
  const events = motion.events.map(({ time, name, kind, velocity_before, velocity_after }) => {
    const item = document.createElement("li");
    const blow = velocity_before === undefined ? "" : ` from ${readable(velocity_before, units.velocity)} to ${readable(velocity_after, units.velocity)}`;
    item.textContent = `${four(time)} s, ${name}: ${kind}${blow}`;
    item.title = [time, velocity_before, velocity_after].filter((x) => x !== undefined).join(", ");
    return item;
  });
  $("system-events").replaceChildren(...events);
  $("system-events").parentElement.hidden = !events.length;
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
  twoSketch.dots = sized.map((list) => cursor(places, samples.time, list));
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
    const element = motion.elements[contact];
    const rest = restsOf(element, motion.events, samples.time);
    force.begin({ x: range(across), y: range(forces.values), xlabel: `displacement across the contact (${to.unit})`, ylabel: `friction (${forces.unit})`, legend: restLegend(rest, element.kind === "elastic" ? "holds" : "sticks") });
    withRests(force, across, forces.values, rest);
    twoSketch.dots.push(cursor(force, across, forces.values));
    force.read = (x, y) => ({ x, text: `${four(x)} ${to.unit}, ${four(y)} ${forces.unit}` });
  }
  twoSketch.most = Math.max(...columns.map(largest));
  if (!playing) placeSystem(0);
}

// Whether a contact is at rest at each of the times: from an event that begins a rest to one that ends it.
function restsOf({ name, time_at_rest }, events, times) {
  const turns = events.filter((event) => event.name === name && /^(stick|lock|slip|yield)$/.test(event.kind));
  const begins = ({ kind }) => kind === "stick" || kind === "lock";
  if (!turns.length) return times.map(() => time_at_rest > 0);
  let [next, isAtRest] = [0, !begins(turns[0])];
  return times.map((time) => {
    while (next < turns.length && turns[next].time <= time) isAtRest = begins(turns[next++]);
    return isAtRest;
  });
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
  // The motion of now.
  const motion = twoAnswer?.motion;
  const here = motion?.period > 0 ? motion.coordinates.map((_, i) => greatestOf(motion, i)).filter((x) => x > 0) : [];
  chart.begin({ x: [found.frequency[0], found.frequency.at(-1)], y: [low, top], xlog: true, ylog: true, xlabel: "frequency of the load (Hz)", ylabel: `peak displacement (${to.unit})`, legend: [...found.coordinates.map((name, i) => [name, i ? ink.stick : ink.slide, i ? "7 3" : ""]), ...(here.length ? [["this load", ink.here, "dot"]] : [])] });
  found.displacement.forEach((list, i) => chart.line(found.frequency, list.map((x) => (x === null ? null : x * to.factor)), i ? ink.stick : ink.slide, { dash: i ? "7 3" : "" }));
  for (const size of here) chart.dot(motion.periods / motion.period, size * to.factor, ink.here);
  chart.read = (x) => {
    const i = nearest(found.frequency, x);
    const rests = found.rests[i];
    return { x: found.frequency[i], text: `${four(found.frequency[i])} Hz: ${found.displacement.map((list) => readable(list[i], found.unit)).join(", ")}${rests === null ? "" : `, ${rests} ${rests === 1 ? "rest" : "rests"}`}` };
  };
}

// ---- the sketch of the two masses: bodies on wheels or on plates that rub, and what is between them

const twoSketch = (() => {
  const svg = node("svg", { viewBox: "0 0 560 200", width: "100%", role: "img", "aria-label": "Two masses on a floor, with the springs, dampers, contact, stop and load of the fields" });
  $("two-body").append(svg);
  return { svg, most: 0, dots: [] };
})();
const hasTwo = (name) => Boolean(two[name]?.trim());
// The load in words: its wave and its constant part.
const loadWords = () => isRecorded(two) ? (twoRecord?.name ?? "record") : [hasTwo("amplitude") ? `${two.amplitude}, ${two.frequency}${two.shape === "sine" ? "" : ` ${two.shape}`}` : "", hasTwo("constant") ? `${two.constant} constant` : ""].filter(Boolean).join(" + ");
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
  // A period takes three seconds, and a record its own time.
  const length = twoAnswer?.motion.duration ? 1000 * twoAnswer.motion.duration : 3000;
  const part = samples ? (now % length) / length : 0;
  const i = samples ? Math.round(part * (samples.time.length - 1)) : 0;
  if (samples) for (const put of twoSketch.dots) put(i);
  const [homes, width, floor, wall] = [[150, 370], 84, 160, 30];
  const pixels = samples && twoSketch.most ? 46 / twoSketch.most : 0;
  const places = homes.map((home, k) => home + (samples ? pixels * samples.displacement[i][k] : 0));
  const of = { ground: [wall, wall], lower: [places[0], places[0] + width], upper: [places[1], places[1] + width] };
  const parts = [];
  const path = (d, colour = ink.border, more = {}) => parts.push(node("path", { d, fill: "none", stroke: colour, "stroke-width": 2, ...more }));
  const words = (x, y, text, more = {}) => parts.push(node("text", { x, y, "font-size": 11, "font-family": "system-ui, sans-serif", "text-anchor": "middle", fill: ink.text, ...more }, text));
  path(`M12 ${floor}H548M${wall} 24V${floor}`);
  path(Array.from({ length: 40 }, (_, n) => `M${24 + 13.2 * n} ${floor}l-7 7`).join(""), ink.border, { "stroke-width": 1 });
  [["ground", "lower", "k1", "c1"], ["lower", "upper", "k2", "c2"]].forEach(([first, second, k, c]) => {
    const [from, to] = [of[first][1], of[second][0]];
    if (hasTwo(k)) {
      path(zigzag(from, to, 70));
      words((from + to) / 2, 59, two[k]);
    }
    if (hasTwo(c)) {
      path(dashpot(from, to, 108));
      words((from + to) / 2, 94, two[c]);
    }
  });
  const isRubbing = hasTwo("friction") && !(isZero(two.friction) && !hasTwo("elastic"));
  const [below, above] = two.contact.split(",");
  const friction = `friction ${two.friction}${hasTwo("falls") ? ` to ${two.falls}` : ""}${hasTwo("elastic") ? `, elastic ${two.elastic}` : ""}`;
  if (isRubbing && below === "lower") {
    path(plates(of.lower[1], of.upper[0], 138, hasTwo("elastic")), ink.stick);
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
  if (isRubbing && hasTwo("belt")) {
    // A belt is named beside the friction, where there is room.
    const x = below !== "ground" ? 440 : above === "lower" ? of[above][1] + 40 : of[above][0] - 190;
    path(`M${x} 178h48m-8 -5l8 5l-8 5`, ink.second, { "stroke-width": 2.5 });
    words(x + 56, 182, `belt ${two.belt}`, { "text-anchor": "start" });
  }
  // The stop is an arm of its first body, which the second meets when it is beyond the gap.
  if (hasTwo("gap")) {
    const [first, second] = two.stop.split(",");
    const own = /^\s*([\d.eE+-]+)\s*(\S*)/.exec(two.gap);
    const unit = twoAnswer?.motion.units.displacement;
    const size = own && unit ? (Number(own[1]) * (METRES[own[2] || two.units.split(",")[1]?.trim()] ?? NaN)) / METRES[unit] : NaN;
    const room = Math.min(Number.isFinite(size) && pixels ? size * pixels : 20, 60);
    const shift = first === "ground" ? 0 : places[0] - homes[0];
    const at = homes[second === "lower" ? 0 : 1] + width + room + shift;
    path(`M${first === "ground" ? wall : of[first][0] + 12} ${first === "ground" ? 40 : 54}V40H${at}V70`, ink.here, { "stroke-width": 3 });
    words(Math.min(Math.max(at, of[second][1]) + 6, 490), 84, `gap ${two.gap}`, { "text-anchor": "start" });
    // A stop that gives no way has a thick end.
    if (hasTwo("restitution")) {
      path(`M${at} 48V70`, ink.here, { "stroke-width": 8 });
      words(Math.min(Math.max(at, of[second][1]) + 6, 490), 68, `e = ${two.restitution}`, { "text-anchor": "start" });
    }
  }
  // The load to and fro: on a body above it, of the base below the floor.
  if (isRecorded(two) || (hasTwo("amplitude") && !isZero(two.amplitude)) || hasTwo("constant")) {
    const isBase = !["upper", "lower"].includes(two.load);
    const [x, y] = isBase ? [60, 178] : [of[two.load][0] + width / 2, 28];
    path(`M${x - 26} ${y}h52m-8 -5l8 5l-8 5M${x - 18} ${y - 5}l-8 5l8 5`, ink.text, { "stroke-width": 2.5 });
    words(x, isBase ? 194 : 16, `${isBase ? "base " : ""}${loadWords()}`, isBase ? { x: 12, "text-anchor": "start" } : {});
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
