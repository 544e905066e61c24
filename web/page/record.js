// A record as the load: its file with the first lines, and the motion under it on one time axis.
"use strict";

let record = null;
// The panel of the record is to be shown when its answer is there.
let isSought = false;

// A record to try: a shake that grows and dies away.
function sampleRecord() {
  const rows = Array.from({ length: 1501 }, (_, i) => {
    const t = i / 100;
    return `${t.toFixed(2)};${(0.3 * Math.exp(-(((t - 6) / 3) ** 2)) * Math.sin(12 * t) * Math.cos(2 * t)).toFixed(6)}`;
  });
  return `Time (s);Acc (g)\n${rows.join("\n")}\n`;
}

// A record that is chosen takes the place of the one before, whose answer goes at once.
async function take(name, file, caption = "") {
  const own = { name };
  record = own;
  // What was asked for stands first.
  const panel = $("record-section");
  if (panel.previousElementSibling !== $("machine")) {
    const isFocused = panel.contains(document.activeElement) && document.activeElement;
    $("machine").after(panel);
    document.body.classList.add("with-record");
    if (isFocused) isFocused.focus({ preventScroll: true });
  }
  $("record-caption").textContent = caption;
  $("record-name").textContent = name;
  $("record-error").textContent = "";
  $("record-read").textContent = `Reading ${name}, ${four(file.size / 1e6)} MB …`;
  $("record-preview").hidden = true;
  forget();
  let [text, copy] = ["", null];
  try {
    // A copy stays when the file changes.
    copy = new Blob([await file.arrayBuffer()]);
    text = await copy.slice(0, 20000).text();
  } catch (error) {
    if (record === own) $("record-error").textContent = `${name}: ${error.message}`;
    return;
  }
  if (record !== own) return;
  own.file = copy;
  // The first lines, as they are, without what no screen shows.
  const lines = text.slice(0, 4000).split(/\r?\n/).slice(0, 8);
  $("record-preview").textContent = lines.map((line) => line.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\ufffd]/g, "·").slice(0, 120)).join("\n");
  $("record-preview").hidden = false;
  const rows = text.split(/\r?\n/).filter((line) => /\d.*\d/.test(line));
  const last = rows.at(Math.min(rows.length - 2, 30)) || "";
  own.sign = last.includes(";") ? "semicolons" : last.includes("\t") ? "tabs" : last.includes(",") ? "commas" : "blanks";
  $("columns").replaceChildren();
  askRecord();
}

// Removes the answer of another record.
function forget() {
  shown.record = shown.spectrum = undefined;
  charts.spectrum.svg.replaceChildren();
  $("record-shown").hidden = true;
  fileButtons();
}

// Dims the answer of another machine.
function staleRecord() {
  if (!record) return;
  record.asked = record.answered = undefined;
  for (const id of ["record-shown", "spectrum"]) $(id).classList.add("stale");
  fileButtons();
}

const isRecordOfNow = () => Boolean(record?.answered);
const recordInputs = () => ({ file: record.file, name: record.name, time_step: $("step").value, column: $("column").value, record_units: $("record-units").value });

function seek() {
  if (isSought) $("record-section").scrollIntoView({ behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth" });
  isSought = false;
}

function askRecord() {
  $("record-fields").hidden = false;
  if (state.mode !== "machine") {
    $("record-error").textContent = "A record needs a machine in units, with its mass: choose “a machine” above.";
    $("record-read").textContent = "";
    forget();
    seek();
    return;
  }
  staleRecord();
  const asked = (record.asked = {});
  const more = recordInputs();
  // The answer to the last question alone is shown.
  const ask = (kind, more, done) => slow.ask(kind, question(kind, more), (found) => record.asked === asked && done(found));
  clearTimeout(record.late);
  record.late = setTimeout(() => record.asked === asked && ($("record-verdict").textContent = "Computing …"), 1000);
  ask("record", more, ({ ok, error }) => {
    clearTimeout(record.late);
    $("record-error").textContent = error ?? "";
    if (error !== undefined) forget();
    $("record-shown").classList.remove("stale");
    sentence("record-read", ok ? `${ok.read} ${ok.follows}${ok.read.startsWith("Record (columns") ? ` Columns are separated by ${record.sign}.` : ""}${ok.unused.length ? ` Columns not used: ${ok.unused.join(", ")}.` : ""}` : "");
    for (const [id, name] of [["step", "Time step"], ["column", "Column"], ["record-units", "Unit"]]) {
      if (error !== undefined && error.includes(`the field ${name}`)) $(id).setAttribute("aria-invalid", "true");
      else $(id).removeAttribute("aria-invalid");
    }
    if (ok) {
      const names = [...(ok.channel ? [ok.channel] : []), ...ok.unused];
      if (names.length > $("columns").children.length) $("columns").replaceChildren(...names.map((name) => new Option(name)));
      shown.record = { ...ok, most: largest(ok.displacement) };
      $("record-shown").hidden = false;
      $("record-drawn").textContent = ok.count > ok.time.length ? `The pictures show ${ok.time.length} of ${ok.count} states, with the extremes of each short time; the file has all.` : "";
      showRecord(shown.record);
    }
    seek();
  });
  // Points at equal ratios, then two rounds beside the peaks, which would be cut.
  const round = (periods, before, left) => ask("spectrum", { ...more, periods }, ({ ok }) => {
    const found = ok && before ? joined(before, ok) : ok;
    const finer = ok && left ? besidePeaks(found) : [];
    if (finer.length) return round(finer, found, left - 1);
    record.answered = asked;
    fileButtons();
    $("spectrum").classList.remove("stale");
    shown.spectrum = found;
    if (found) showSpectrum(found);
    else charts.spectrum.svg.replaceChildren();
  });
  round(Array.from({ length: 100 }, (_, i) => 0.05 * 100 ** (i / 99)), null, 2);
}

const sizes = ({ answers }) => answers.max_displacement.map((x, i) => Math.max(Math.abs(x), Math.abs(answers.min_displacement[i])));

// Two parts of a spectrum in the order of their periods.
function joined(first, second) {
  const periods = [...first.periods, ...second.periods];
  const order = periods.map((_, i) => i).sort((a, b) => periods[a] - periods[b]);
  const names = ["max_displacement", "min_displacement"];
  const answers = Object.fromEntries(names.map((name) => [name, order.map((i) => [...first.answers[name], ...second.answers[name]][i])]));
  return { ...first, periods: order.map((i) => periods[i]), answers };
}

// Four periods within each interval beside a greatest value.
function besidePeaks(found) {
  const [{ periods }, size] = [found, sizes(found)];
  const tops = size.flatMap((x, i) => (i && i < size.length - 1 && x >= size[i - 1] && x >= size[i + 1] ? [i] : []));
  const intervals = [...new Set(tops.flatMap((i) => [i - 1, i]))];
  return intervals.flatMap((i) => [1, 2, 3, 4].map((n) => periods[i] * (periods[i + 1] / periods[i]) ** (n / 5)));
}

const RECORD_KEY = ["max_displacement", "min_displacement", "residual_displacement", "max_absolute_acceleration", "max_transmitted_force", "slides", "stops", "reversals", "stick_time", "friction_work"];

function showRecord(found) {
  const { load, shaken, speed } = charts;
  const legend = restLegend(found.rest);
  const axis = [Math.min(found.load.time[0], found.time[0]), Math.max(found.time.at(-1), found.load.time.at(-1))];
  const rows = [[load, found.load.time, fitted(found.load.value, found.load.unit), "load"], [shaken, found.time, fitted(found.displacement, found.units.displacement), "displacement"], [speed, found.time, fitted(found.velocity, found.units.velocity), "velocity"]];
  rows.forEach(([chart, times, { values, unit }, words], i) => {
    chart.begin({ x: axis, y: range(values), xlabel: i === 2 ? "time (s)" : "", ylabel: `${words} (${unit})`, legend: chart === load ? [] : legend });
    if (chart === load) chart.line(times, values, chart.ink.second, { width: 1.2 });
    else withRests(chart, times, values, found.rest);
    cursor(chart, times, values);
    chart.cursor.setAttribute("cx", -20);
    chart.read = (x) => {
      const at = nearest(times, x);
      return { x: times[at], text: `${four(times[at])} s: ${four(values[at])} ${unit}${chart !== load && found.rest[at] ? ", at rest" : ""}` };
    };
  });
  showHysteresis(found);
  if (!playingRecord) recordSketch(found, 0);
  const value = (name) => found.values.find((row) => row.name === name)?.value;
  const [slides, rest] = [value("slides"), value("residual_displacement")];
  const times = slides === 1 ? "once" : `${slides} times`;
  $("record-verdict").textContent = slides === 0 ? "The body rests throughout."
    : rest === null || rest === undefined ? `The body slides ${times}, and never comes to rest; its motion is cut at ${readable(value("cut_time"), "s")}.`
      : `The body slides ${times}, and ${found.comes_to} rest at ${readable(rest, found.units.displacement)}.`;
  const list = $("record-values");
  list.replaceChildren();
  for (const { name, value, unit } of found.values) if (RECORD_KEY.includes(name) && value !== null) entry(list, label(name), readable(value, unit), `${value} ${unit}`);
}

// The loops of spring, damper and friction together.
function showHysteresis(found) {
  const chart = charts.hysteresis;
  const [way, force] = [fitted(found.displacement, found.units.displacement), fitted(found.force, found.units.force)];
  chart.begin({ x: range(way.values), y: range(force.values), xlabel: `displacement (${way.unit})`, ylabel: `force on the support (${force.unit})` });
  // Of a long record only some states are drawn, which are no neighbours.
  const isWhole = found.count === found.time.length;
  const [places, forces] = isWhole ? withJumps(found.time, found.velocity, found.displacement, found.force, false) : [found.displacement, found.force];
  chart.line(places.map((x) => x * way.factor), forces.map((x) => x * force.factor), chart.ink.slide, { width: 1.2 });
  chart.read = (x, y) => ({ x, text: `${four(x)} ${way.unit}, ${four(y)} ${force.unit}` });
}

function showSpectrum(found) {
  const chart = charts.spectrum;
  const { values, unit } = fitted(sizes(found), found.unit);
  const positive = values.filter((x) => x > 0);
  chart.begin({
    x: [found.periods[0], found.periods.at(-1)], y: positive.length ? [Math.min(...positive) / 1.4, Math.max(...positive) * 1.4] : [0.1, 1],
    xlog: true, ylog: true, xlabel: "natural period (s)", ylabel: `peak displacement (${unit})`,
  });
  chart.line(found.periods, values, chart.ink.slide);
  chart.read = (x) => {
    const i = nearest(found.periods, x);
    return { x: found.periods[i], text: `${four(found.periods[i])} s: ${four(values[i])} ${unit}` };
  };
}

// ---- the record plays in its own time, stops, and begins anew where it is to be repeated

let recordTime = 0;

function recordAt(time) {
  const found = shown.record;
  const i = nearest(found.time, time);
  charts.shaken.put(i);
  charts.speed.put(i);
  if (time <= found.load.time.at(-1)) charts.load.put(nearest(found.load.time, time));
  recordSketch(found, i);
}

// The body of the record's motion, in a sketch of its own.
const recordBar = (() => {
  const svg = node("svg", { viewBox: "0 0 520 34", "aria-hidden": "true", height: 34, width: "100%" });
  const floor = node("path", { d: "M10 30H510M260 24v6", fill: "none", "stroke-width": 1.5 });
  const body = node("rect", { y: 6, width: 36, height: 22, rx: 3 });
  svg.append(floor, body);
  $("record-body").append(svg);
  return { floor, body };
})();

function recordSketch(found, i) {
  const ink = palette();
  recordBar.floor.setAttribute("stroke", ink.border);
  recordBar.body.setAttribute("x", 242 + (found.most ? (220 * found.displacement[i]) / found.most : 0));
  recordBar.body.setAttribute("fill", found.rest[i] ? ink.stick : ink.slide);
}

function playRecord(on) {
  playingRecord = on;
  $("play-record").textContent = on ? "Pause" : "Play";
  $("play-record").setAttribute("aria-pressed", String(on));
  if (!on) return;
  const [begin, end] = [shown.record.time[0], shown.record.time.at(-1)];
  if (recordTime >= end || recordTime < begin) recordTime = begin;
  let before = performance.now();
  const step = (now) => {
    if (!playingRecord || $("record-shown").hidden) {
      playRecord(false);
      return;
    }
    recordTime += (now - before) / 1000;
    before = now;
    if (recordTime > end) {
      if (!$("repeat").checked) {
        recordAt(end);
        playRecord(false);
        return;
      }
      recordTime = begin;
    }
    recordAt(recordTime);
    requestAnimationFrame(step);
  };
  requestAnimationFrame(step);
}

$("play-record").onclick = () => playRecord(!playingRecord);
$("file").onchange = () => {
  const [file] = $("file").files;
  if (!file) return;
  take(file.name, file);
  // So that the same file can be chosen again after a change.
  $("file").value = "";
};
$("sample").onclick = () => {
  isSought = true;
  // An example brings its own machine.
  remember();
  VIEWS.one.put(structuredClone(VIEWS.one.start()));
  remember();
  take("sample.csv", new Blob([sampleRecord()]), "The example: a shake of 15 s below 0.3 g, which grows and dies away, moves the base of the machine in place of its vibration.");
};
$("own").onclick = () => {
  isSought = true;
  $("file").click();
};
for (const id of ["step", "column", "record-units"]) $(id).oninput = () => record?.file && askRecord();
document.body.addEventListener("dragover", (event) => {
  event.preventDefault();
  $("drop").classList.add("over");
});
document.body.addEventListener("dragleave", () => $("drop").classList.remove("over"));
document.body.addEventListener("drop", (event) => {
  event.preventDefault();
  $("drop").classList.remove("over");
  const [file] = event.dataTransfer.files;
  if (!file) return;
  show("one");
  take(file.name, file);
});
