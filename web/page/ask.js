// The questions to the workers, and the answers, which wait for the next frame.
"use strict";

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
    this.waiting.set(kind, { kind, question, done });
    const { running } = this;
    if (running && performance.now() - this.since > PATIENCE) {
      this.worker.terminate();
      this.start();
      // A question of another kind is still wanted.
      if (!this.waiting.has(running.kind)) this.waiting.set(running.kind, running);
    }
    if (!this.running) this.next();
  }

  next() {
    for (const [kind, request] of this.waiting) {
      this.waiting.delete(kind);
      this.running = request;
      this.since = performance.now();
      this.begun ??= this.since;
      this.worker.postMessage({ id: kind, question: request.question });
      busy.soon();
      return;
    }
    this.begun = undefined;
  }

  // Leaves a question of a kind unanswered.
  drop(kind) {
    this.waiting.delete(kind);
    if (this.running?.kind !== kind) return;
    this.worker.terminate();
    this.start();
    this.next();
  }

  // Ends the work; each question is answered with that.
  stop() {
    const left = [...(this.running ? [this.running] : []), ...this.waiting.values()];
    this.waiting.clear();
    this.begun = undefined;
    if (!left.length) return;
    this.worker.terminate();
    this.start();
    for (const { done } of left) done({ error: "Stopped." });
  }
}

// ---- long work: what is computed, for how long, and a button that ends it

const DOING = {
  answer: "the answer", motion: "the motion", curve: "the response curve", ghost: "the curve without friction", design: "the design",
  limits: "the limits", record: "the motion under the record", spectrum: "the spectrum", "record-table": "the file", map: "the map",
  system: "the two masses", "system-curve": "the curve of the two masses",
};

function busy() {
  busy.timer = 0;
  const working = [live, slow, mapper].filter((asker) => asker?.running);
  const long = working.filter((asker) => performance.now() - asker.begun > PATIENCE);
  if (working.length) busy.soon();
  else busy.isStopped &&= !$("busy").hidden;
  if (busy.isStopped) return;
  $("busy").hidden = !long.length;
  if (!long.length) return;
  const words = `Computing ${long.map((asker) => DOING[asker.running.kind]).join(" and ")} …`;
  if ($("busy-text").textContent !== words) $("busy-text").textContent = words;
  const most = Math.max(...long.map((asker) => performance.now() - asker.begun));
  $("busy-time").textContent = `${Math.round(most / 1000)} s`;
}
busy.soon = () => (busy.timer ||= setTimeout(busy, 500));

function stopped(on) {
  busy.isStopped = on;
  $("stop").textContent = on ? "Compute again" : "Stop";
  $("busy-text").textContent = on ? "Stopped." : "";
  $("busy-time").textContent = "";
  $("busy").hidden = !on;
}

$("stop").onclick = () => {
  if (busy.isStopped) {
    stopped(false);
    if (tab === "two") changedSystem();
    else changed(true);
    return;
  }
  // A map that is not whole is begun anew.
  if (mapper.running) [mapOf, $("map-note").textContent] = ["", "Stopped."];
  for (const asker of [live, slow, mapper]) asker.stop();
  still.asked = "";
  stopped(true);
};

let live = null;
let slow = null;
// The map has a worker of its own, which may be busy for long.
let mapper = null;
let settled = 0;
let late = 0;

// Asks anew whatever depends on the inputs.
function changed(isLink = false) {
  if (!isLink) $("note").textContent = "";
  if (!live) return;
  if (busy.isStopped) stopped(false);
  const asked = question("answer");
  // Nothing that takes longer is there for other inputs, which no caption of an example describes.
  if (keyOf(asked) !== changed.key) {
    changed.key = keyOf(asked);
    [still.asked, still.resolved] = ["", false];
    $("about").textContent = "";
    staleRecord();
  }
  clearTimeout(late);
  late = setTimeout(() => {
    $("verdict").textContent = "Computing …";
    stale(true);
  }, 1000);
  live.ask("answer", asked, ({ ok, error }) => later("answer", ok && { ...ok, inputs: asked.inputs, units: asked.units }, error));
  live.ask("motion", question("motion", { from_start: $("from-start").checked }), ({ ok }) => later("motion", ok));
  // The resolved curve, which has the point in its range, may be there before this one.
  live.ask("curve", question("curve", span()), ({ ok }) => still.resolved || later("curve", ok));
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

// The inputs of a question or of an answer.
const keyOf = ({ inputs, units }) => JSON.stringify([inputs, units]);
const isOfNow = (answer) => Boolean(answer) && keyOf(answer) === keyOf(question(""));

// What takes longer is asked when the inputs are still and their answer is there, on which the range of the curve depends.
function still() {
  if (tab === "one") history.replaceState(null, "", currentHash());
  const asked = keyOf(question(""));
  if (!isOfNow(shown.answer) || asked === still.asked) return;
  still.asked = asked;
  // The inputs may have changed when the answer is there.
  const ask = (kind, more, done) => slow.ask(kind, question(kind, more), (found) => still.asked === asked && done(found));
  if (shown.answer.drift) {
    for (const id of ["design-section", "limits-section"]) $(id).hidden = true;
    if (record?.file) askRecord();
    askMap();
    return;
  }
  // The curve whose range has the present point, with its peaks.
  ask("curve", { ...span(), resolved: true }, ({ ok }) => {
    still.resolved = ok !== undefined;
    later("curve", ok);
  });
  askGhost();
  ask("design", {}, ({ ok, error }) => showDesign(ok, error));
  const isMany = shown.answer.static_friction_ratio > 1 && !shown.answer.is_without_spring;
  $("limits-section").hidden = !isMany;
  if (isMany) {
    $("limits-text").textContent = "Computing …";
    $("limits").replaceChildren();
    ask("limits", { count: 64 }, ({ ok, error }) => showLimits(ok, error));
  }
  if (record?.file) askRecord();
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
  for (const section of document.querySelectorAll("#one section")) section.classList.toggle("stale", on && !section.contains($("error")) && !section.contains($("drop")));
}

function draw() {
  frame = 0;
  const all = [...drawn];
  drawn.clear();
  for (const [kind, [ok, error]] of all) {
    if (kind === "answer") {
      clearTimeout(late);
      failed(error);
    }
    if (ok === undefined) continue;
    shown[kind] = ok;
    // The slow questions depend on the answer, which may be late.
    if (kind === "answer") soon();
    ({ answer: showAnswer, motion: showMotion, curve: showCurve, map: showMap })[kind](ok);
  }
}

// Files hold what is finished: nothing of a wrong input, and no map whose cells are still computed.
function fileButtons() {
  const isFailed = document.body.classList.contains("failed");
  const isThere = { map: isMapFinal, record: isRecordOfNow, "two-masses": () => Boolean(twoAnswer?.samples), "two-masses-curve": () => Boolean(shown.systemCurve) };
  for (const button of document.querySelectorAll("#values-csv, #one .files button")) button.disabled = isFailed || !(isThere[button.parentElement.dataset.of]?.() ?? true);
  for (const button of document.querySelectorAll("#two .files button")) button.disabled = !isThere[button.parentElement.dataset.of]();
  if ($("map-unfinished")) $("map-unfinished").hidden = isFailed || isMapFinal();
}

// Says what is wrong with an input, and leaves no number of another machine.
function failed(error) {
  const isFailed = error !== undefined;
  // Of the inputs that may be given instead, the field names the one that is chosen.
  if (/ is missing$/.test(error)) error = `${label([...document.querySelectorAll("[data-input]")].find((typed) => !typed.value.trim() && !MORE.includes(typed.dataset.input))?.dataset.input ?? error.replace(/ .*/, ""))} is missing`;
  document.body.classList.remove("loading");
  $("error").textContent = isFailed ? error : "";
  document.body.classList.toggle("failed", isFailed);
  fileButtons();
  for (const typed of document.querySelectorAll("[data-input]")) {
    const name = label(typed.dataset.input);
    const isNamed = isFailed && error.startsWith(name);
    if (isNamed) typed.setAttribute("aria-invalid", "true");
    else typed.removeAttribute("aria-invalid");
  }
  stale(isFailed);
  if (!isFailed) return;
  for (const id of ["key", "all"]) $(id).replaceChildren();
  for (const id of ["verdict", "notes", "map-here"]) $(id).textContent = "";
  bar("one", error);
  $("limits-section").hidden = true;
  shown.answer = undefined;
  still.asked = "";
}
