// The answer: the verdict, the key numbers in four digits, and all values.
"use strict";

const KEY = [
  ["max_velocity", "peak velocity"], ["max_acceleration", "peak acceleration"], ["transmitted_force", "transmitted force"],
  ["transmissibility", "transmissibility"], ["max_absolute_displacement", "peak absolute displacement"],
  ["sticks_per_cycle", "stops in a cycle"], ["stick_fraction", "part of the time at rest"],
  ["energy_out", "work against friction"], ["damper_work", "work against the damper"],
];

// A value in its unit and in ratios, with all its digits.
const valueText = ({ value, unit, physical }) => {
  const own = Array.isArray(value) ? value.map(([re, im]) => `${digits(re)} ${digits(im)} i`).join(", ") : digits(value === true ? "yes" : value === false ? "no" : value);
  const ratio = unit && unit !== "1" && value !== null ? `${own} ${unit}` : own;
  return [physical ? `${digits(physical.value)}${physical.value === null ? "" : ` ${physical.unit}`}` : ratio, physical ? ratio : ""];
};

// All digits of a value, for those who hover.
const allDigits = ({ value, unit, physical }) => {
  const ratio = `${value}${unit && unit !== "1" ? ` ${unit}` : ""}`;
  return physical ? `${physical.value} ${physical.unit}${value === null ? "" : ` = ${ratio}`}` : ratio;
};

// The value in units, where it has one: without friction or a spring there may be none in ratios.
const valueOf = (row) => (row?.physical ? row.physical.value : row?.value) ?? null;

const readableValue = (row) => (row.physical ? readable(row.physical.value, row.physical.unit) : typeof row.value === "number" ? `${four(row.value)}${row.unit && row.unit !== "1" ? ` ${row.unit}` : ""}` : valueText(row)[0]);

// A sentence with four digits of each number; all of them stay at hand.
function sentence(id, text) {
  $(id).textContent = fourIn(text);
  $(id).title = text;
}

// The line at the bottom of a phone, of the machine that is seen.
const bar = (own, text) => tab === own && ($("bar-text").textContent = text);

function entry(list, name, text, all) {
  const [term, value] = [document.createElement("dt"), document.createElement("dd")];
  term.textContent = name;
  value.textContent = text;
  if (all) value.title = all;
  list.append(term, value);
}

// What the motion from rest adds to the verdict, without the kind of motion that the verdict states.
function after(first, second, isMany) {
  const rest = second.replace(/^(Stuck|Sticking|Non-sticking|Unbounded|Irregular|Undecided): /, "");
  if (!isMany && (first.includes(rest) || (/never stops/.test(first) && /never stops/.test(second)))) return "";
  const isSame = isMany || first.split(":")[0] === second.split(":")[0];
  if (!isSame) return second;
  const from = shown.answer?.has_start ? "From this start" : "From rest";
  return isMany ? `${from}: ${rest.charAt(0).toLowerCase()}${rest.slice(1)}` : rest.charAt(0).toUpperCase() + rest.slice(1);
}

// The verdict on a machine. The closed forms say why, the motion says how often.
function verdictOf(answer) {
  const { steady } = answer;
  if (answer.is_free) return `Free vibration: ${answer.is_frictionless && steady.verdict?.startsWith("Undecided") ? "neither friction nor a damper ends it." : (steady.verdict ?? steady.error).replace("Stuck: ", "")}`;
  if (answer.is_frictionless) return `Without friction: ${answer.verdict.startsWith("Unbounded") ? "at Ω = 1 without a damper the displacement grows without bound." : "a linear oscillator, which never stops."}`;
  const more = steady.error === undefined ? after(answer.verdict, steady.verdict, answer.static_friction_ratio > 1) : steady.error;
  return `${answer.verdict} ${more}`.trim();
}

// The kind of motion in a word or two, by the place in the map.
const PLACES = { "-1": "Stuck", "-2": "Irregular", "-3": "Not settled", "-4": "Not computed", "-5": "Grows without bound", "-6": "Sticks" };
const placeWords = (n) => (n < 0 ? PLACES[n] : n === 0 ? "Never stops" : `Stops ${n === 1 ? "once" : n === 2 ? "twice" : `${n} times`} a cycle`);

// The peak displacement of the steady motion in either direction, as the curve has it.
function greatest(answer) {
  const [most, least] = ["max_displacement", "min_displacement"].map((name) => answer?.steady.values?.find((row) => row.name === name));
  return valueOf(most) === null ? null : Math.max(Math.abs(valueOf(most)), least ? Math.abs(valueOf(least)) : NaN);
}

function showAnswer(answer) {
  if (isOfNow(answer)) aim = null;
  $("curve-section").hidden = answer.is_free || Boolean(answer.drift);
  if (answer.drift) {
    showDrift(answer);
    return;
  }
  if (wanted && state.mode === "machine" && answer.machine) {
    const { omega, alpha } = wanted;
    wanted = null;
    const isSame = (a, b) => Math.abs(a / b - 1) < 1e-9;
    if (!isSame(omega, answer.omega) || !isSame(alpha, answer.alpha)) moveTo(omega, alpha);
  }
  const { steady } = answer;
  const isMany = answer.static_friction_ratio > 1;
  const isPlain = answer.is_free || answer.is_frictionless;
  sentence("verdict", verdictOf(answer));
  const origin = isPlain || !steady.origin || steady.origin === "One periodic motion, from every start." ? "" : steady.origin;
  sentence("notes", [...answer.notes, origin].join(" ").trim());
  const list = $("key");
  list.replaceChildren();
  const natural = answer.machine?.find((own) => own.name === "period");
  if (natural && isPlain) entry(list, "natural period", readable(natural.value, natural.unit), `${natural.value} ${natural.unit}`);
  if (!answer.is_free && !answer.is_without_spring) entry(list, "Ω, frequency / natural frequency", four(answer.omega), String(answer.omega));
  if (!isPlain) entry(list, "α, force / friction", four(answer.alpha), String(answer.alpha));
  const rows = steady.values || answer.values;
  const row = (name) => rows.find((own) => own.name === name);
  const [most, least] = [row("max_displacement"), row("min_displacement")];
  let size = "";
  // A body that comes to rest for good has a place and nothing else of a motion.
  const isStuck = answer.place === -1;
  if (isStuck && most) {
    if (valueOf(most) !== 0) entry(list, "rests at", readableValue(most), allDigits(most));
    size = valueOf(most) === 0 ? "" : readableValue(most);
  } else if (valueOf(most) !== null) {
    size = readableValue(most);
    if (!least || valueOf(most) === -valueOf(least)) entry(list, "peak displacement", size, allDigits(most));
    else for (const [name, own] of [["displacement from", least], ["to", most]]) entry(list, name, readableValue(own), allDigits(own));
  }
  for (const [name, words] of KEY) {
    const own = row(name);
    // Only a moving base gives the body a displacement in space of its own.
    if (name === "max_absolute_displacement" && !(state.mode === "machine" && inRole(DRIVES).startsWith("base_"))) continue;
    if (answer.is_frictionless && name === "energy_out") continue;
    if (isStuck && (answer.is_free || !["transmitted_force", "transmissibility"].includes(name))) continue;
    if (valueOf(own) !== null) entry(list, words, name === "stick_fraction" ? `${four(100 * own.value)} %` : readableValue(own), allDigits(own));
  }
  if (!isPlain) {
    const border = answer.values.find((own) => own.name === "min_force_ratio");
    // With a higher static friction the border is that of a cycle, which not every start reaches.
    const name = answer.six_reversals ? "two-reversal threshold" : isMany ? "cycle without a stop from" : "sticking threshold, force";
    const size = answer.machine?.find((own) => own.name === "friction");
    entry(list, name, size ? readable(border.value * size.value, size.unit) : `${four(border.value)} r_y`, `${border.value} r_y`);
    if (answer.six_reversals) entry(list, "six reversals, no stop", `${answer.six_reversals.map(four).join(" to ")} r_y`, answer.six_reversals.join(" to "));
  }
  bar("one", `${placeWords(answer.place)}${size ? ` · ${size}` : ""}`);
  $("map-here").textContent = isPlain || answer.is_without_spring ? "" : `The point: Ω = ${four(answer.omega)}, α = ${four(answer.alpha)}: ${placeWords(answer.place).toLowerCase()}.`;
  if ($("all").parentElement.open) showAll();
  $("command").textContent = commandLine();
  putKnob();
}

// A body without a spring that a constant force moves on: the answer of a system of this one body.
function showDrift(answer) {
  sentence("verdict", answer.verdict);
  sentence("notes", answer.notes.join(" "));
  $("key").replaceChildren();
  showMotionOf($("key"), answer.drift);
  bar("one", fourIn(answer.verdict.replace(/:.*/s, "")));
  $("map-here").textContent = "";
  if ($("all").parentElement.open) showAll();
  $("command").textContent = commandLine();
}

function showAll() {
  const answer = shown.answer;
  if (!answer) return;
  const table = document.createElement("table");
  const row = (cells, of = "td") => {
    const line = table.insertRow();
    for (const text of cells) {
      const cell = document.createElement(text ? of : "td");
      cell.textContent = text;
      line.append(cell);
    }
  };
  row(["", "in units", "in ratios", "meaning"], "th");
  const section = (title, rows) => {
    row([title, "", "", ""], "th");
    for (const own of rows) {
      const [first, second] = own.meaning === undefined ? [`${digits(own.value)} ${own.unit === "1" ? "" : own.unit}`, ""] : valueText(own);
      row([`${label(own.name)}${own.symbol ? ` (${own.symbol})` : ""}`, own.physical || own.meaning === undefined ? first : "", own.physical ? second : own.meaning === undefined ? "" : first, own.meaning || ""]);
    }
  };
  const values = allowed(answer);
  if (answer.machine) section("machine", answer.machine);
  if (values.response.length) section("closed forms", values.response);
  if (values.steady.length) section("steady motion", values.steady);
  $("all").replaceChildren(table);
}
$("all").parentElement.ontoggle = showAll;

// The values that mean something: without friction or drive those in ratios, and the borders, do not.
function allowed(answer) {
  if (answer.drift) {
    const { drift } = answer;
    const units = { ...drift.units, period: "s", drift: drift.units.displacement };
    const names = ["period", "drift", "mean_velocity", "min_displacement", "max_displacement", "min_velocity", "max_velocity"];
    return { response: [], steady: names.map((name) => ({ name, value: [drift[name]].flat()[0], unit: units[name] ?? units[name.replace(/^[a-z]+_/, "")] })) };
  }
  const isPlain = answer.is_free || answer.is_frictionless;
  const steady = answer.steady.values || [];
  if (!isPlain) return { response: answer.values, steady };
  const own = steady.filter((row) => row.physical && !/energy|equivalent|friction/.test(row.name));
  return { response: [], steady: own.map((row) => ({ ...row, unit: row.physical.unit, value: row.physical.value, physical: undefined })) };
}

$("values-csv").onclick = () => {
  const answer = shown.answer;
  if (!answer) return;
  const rows = Object.entries(answer.inputs).map(([name, text]) => ["input", name, text, ""]);
  const values = allowed(answer);
  if (values.response.length) for (const name of RATIOS) rows.push(["ratios", name, answer[name], "1"]);
  rows.push(...(answer.machine || []).map((row) => ["machine", row.name, row.value, row.unit]));
  for (const [part, list] of Object.entries(values)) {
    for (const row of list) {
      rows.push([part, row.name, row.value, row.unit]);
      if (row.physical) rows.push([part, `physical.${row.physical.name}`, row.physical.value, row.physical.unit]);
    }
  }
  const cell = (x) => (x === null ? "" : /[",\n]/.test(String(x)) ? `"${x}"` : x);
  saved("stickslip-values.csv", "text/csv", `part,name,value,unit\n${rows.map((row) => row.map(cell).join(",")).join("\n")}\n`);
};

// ---- design and limits

// Each sentence with the answers that it has, and one that it has not.
const SENTENCES = [
  [["six_reversals_from", "six_reversals_to", "two_reversals_from"], "The body does not stop at a force of {} to {}, where it reverses six times a cycle, and of {} or more."],
  [["force", "unbalance", "foot_displacement", "base_displacement"], "WHO at a force of {} or more: an unbalance of {}, a motion of {} of the spring's support, or of {} of a base that carries the surface."],
  [["force", "unbalance", "base_displacement"], "WHO at a force of {} or more: an unbalance of {}, or a motion of {} of a base that carries the surface.", "foot_displacement"],
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
  $("design-section").hidden = error !== undefined || !rows.length;
  if (error !== undefined) return;
  // With six reversals the least force of the cycle of two is not that of the body.
  const who = rows.some((row) => row.name === "six_reversals_from") ? "The cycle of two reversals does not stick" : "The body never sticks";
  for (const [names, sentence, without] of SENTENCES) {
    if (rows.some((row) => row.name === without)) continue;
    const found = names.map((name) => rows.find((row) => row.name === name));
    if (!found.every(Boolean)) continue;
    const item = document.createElement("li");
    const wrong = found.find((row) => row.error !== undefined);
    item.textContent = wrong ? `No answer: ${wrong.error}.` : found.reduce((text, row) => text.replace("{}", readable(row.value, row.unit)), sentence.replace("WHO", who));
    if (!wrong) item.title = found.map((row) => `${row.value} ${row.unit}`).join(", ");
    if (item.textContent !== list.lastChild?.textContent) list.append(item);
  }
}

function showLimits(found, error) {
  const list = $("limits");
  list.replaceChildren();
  $("limits-text").textContent = error !== undefined ? error : `${found.limits.length} ${found.limits.length === 1 ? "limit" : "limits"} from ${found.starts} starts with |x| ≤ ${four(found.reach)} B and |v| ≤ ${four(found.reach)} B ω_d${found.unsettled ? `; ${found.unsettled} had not settled` : ""}.`;
  for (const row of found?.limits || []) {
    const item = document.createElement("li");
    const text = ([low, high]) => `${readable(low, found.unit)} to ${readable(high, found.unit)}`;
    const range = row.range ? ` ${row.is_family ? "Mean positions" : "Positions"} from ${text(row.range)}.` : "";
    const extrema = row.extrema && !row.range ? ` Displacement from ${text(row.extrema)}.` : "";
    const stops = row.stops ? ` ${row.stops} ${row.stops === 1 ? "stop" : "stops"} in a cycle.` : "";
    item.textContent = `${four(100 * row.share)} % of the starts: ${row.description}.${stops}${extrema}${range}`;
    list.append(item);
  }
}
