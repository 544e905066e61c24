// The form: a typed text and a slider for each input. Nothing but a key, a mouse, or a finger that was held first
// changes a number.
"use strict";

// The decades of a slider.
const DECADES = 4;
// The time that a finger rests on a thumb before it drags it: a swipe goes on at once.
const HOLD = 150;
let keyed = 0;

function fields() {
  $("mode").value = state.mode;
  $("units").value = state.units ?? "";
  $("units-row").hidden = state.mode !== "machine";
  for (const host of [$("fields"), $("more")]) host.querySelectorAll(".row").forEach((row) => row.remove());
  for (const names of ROLES[state.mode]) (MORE.includes(roleName(names)) ? $("more") : $("fields")).append(field(names));
  // Inputs that are set are in sight.
  if (["static_friction_ratio", "static_friction", "mean_force", "x0", "v0"].some((name) => inputs()[name] && !(name === "static_friction_ratio" && Number(state[name]) === 1))) $("more").open = true;
}

// The range of a slider: whole decades about a number, which stay while the number is within them.
function decades(text, name) {
  const own = parts(text);
  // A mean force is compared with the friction, and lengths of ratios are in B.
  const first = state.mode === "ratios" && /^[xv]0$/.test(name) ? "1" : name === "mean_force" && parts(state.friction)?.[0] > 0 ? state.friction : CENTRES[name];
  const centre = own && own[0] !== 0 ? own : parts(first) || [1, ""];
  const size = Math.abs(centre[0]) || 1;
  const unit = own && own[1] ? own[1] : own && own[0] !== 0 ? "" : centre[1];
  if (name === "static_friction_ratio") return { low: 1, high: 10, unit: "" };
  const middle = Math.round(Math.log10(size));
  return { low: 10 ** (middle - DECADES / 2), high: 10 ** (middle + DECADES / 2), unit };
}

function field(names) {
  const name = inRole(names);
  if (state[name] === undefined) state[name] = ROLES[state.mode].some((of) => of.length > 1 && of.includes(name)) || !MORE.includes(name) ? FIRST[name] ?? "" : "";
  const row = document.createElement("div");
  row.className = "row";
  const typed = Object.assign(document.createElement("input"), { id: `in-${roleName(names)}`, value: state[name], autocomplete: "off", spellcheck: false });
  typed.dataset.input = name;
  if (MORE.includes(name)) typed.placeholder = FIRST[name];
  row.append(heading(names, name, typed), typed, slider(names, name, typed));
  return row;
}

// The label of an input, or the choice of its kind.
function heading(names, name, typed) {
  if (names.length === 1) return Object.assign(document.createElement("label"), { htmlFor: typed.id, textContent: WORDS[name] });
  const head = document.createElement("select");
  head.setAttribute("aria-label", `kind of ${WORDS[roleName(names)]}`);
  for (const own of names) head.append(new Option(WORDS[own], own, own === name, own === name));
  head.onchange = () => {
    changeKind(names, name, head.value);
    fields();
    document.querySelector(`select[aria-label="kind of ${WORDS[roleName(names)]}"]`).focus();
    changed();
    remember();
  };
  typed.setAttribute("aria-label", WORDS[name]);
  return head;
}

// The same machine, given by another quantity. The way back gives the text that was left, if nothing changed meanwhile.
function changeKind(names, from, to) {
  const role = roleName(names);
  const others = () => JSON.stringify([state.mode, state.units, ROLES[state.mode].map(inRole).filter((own) => !names.includes(own)).map((own) => [own, state[own]])]);
  const left = back.get(role);
  const isBack = left && left.from === to && left.to === from && left.became === state[from] && left.others === others();
  const same = shown.answer?.kinds?.[to];
  const text = state[from];
  const untouched = isOfNow(shown.answer);
  chosen[role] = to;
  if (isBack) {
    state[to] = left.text;
    back.delete(role);
    return;
  }
  if (isZero(text)) state[to] = "0";
  else if (!untouched || !same || !Number.isFinite(same.value)) state[to] = FIRST[to] ?? "";
  else state[to] = `${short(same.value, 7)} ${same.unit}`.trim();
  if (names !== DRIVES || !shown.answer?.is_free) back.set(role, { from, to, text, became: state[to], others: others() });
}

// A slider on a logarithmic scale of its own, with the ends written below; the least place of an input that may be 0 is 0.
function slider(names, name, typed) {
  const host = document.createElement("div");
  host.className = "slider";
  const range = Object.assign(document.createElement("input"), { type: "range", min: 0, max: 1000, step: 1 });
  range.setAttribute("aria-label", `${WORDS[name]}, slider`);
  const [low, high] = [document.createElement("span"), document.createElement("span")];
  const ends = document.createElement("div");
  ends.className = "ends";
  ends.setAttribute("aria-hidden", "true");
  ends.append(low, ...(SIGNED.has(name) ? [Object.assign(document.createElement("span"), { textContent: "0" })] : []), high);
  host.append(range, ends);
  const hasZero = ZERO.has(name);
  let span = decades(state[name], name);
  const least = hasZero ? 40 : 0;
  // The place of a number, and the number of a place; those of either sign lie on either side of a 0 in the middle.
  const isSigned = SIGNED.has(name);
  const placed = (x) => {
    if (!isSigned) return placedUp(x);
    return 500 + (Math.sign(x) * Math.min(placedUp(x), 1000)) / 2;
  };
  const numbered = (at) => (isSigned ? Math.sign(at - 500) * numberedUp(2 * Math.abs(at - 500)) : numberedUp(at));
  const placedUp = (x) => (hasZero && x === 0 ? 0 : least + ((1000 - least) * Math.log(Math.abs(x) / span.low)) / Math.log(span.high / span.low));
  const numberedUp = (at) => (hasZero && at < least / 2 ? 0 : span.low * (span.high / span.low) ** ((Math.max(at, least) - least) / (1000 - least)));
  const show = () => {
    const own = parts(state[name]);
    const text = (x) => `${short(x, 1)}${span.unit ? ` ${span.unit}` : ""}`;
    const empty = !state[name]?.trim();
    range.disabled = !own && !empty;
    if (own && own[1] !== span.unit) span = decades(state[name], name);
    if (own && own[0] !== 0 && !(Math.abs(own[0]) >= span.low * 0.999 && Math.abs(own[0]) <= span.high * 1.001)) span = decades(state[name], name);
    low.textContent = isSigned ? text(-span.high) : hasZero ? "0" : text(span.low);
    high.textContent = text(span.high);
    range.value = own ? placed(own[0]) : isSigned ? 500 : 0;
    range.setAttribute("aria-valuetext", empty ? (FIRST[name] ?? "empty") : state[name]);
  };
  const put = (at) => {
    const number = numbered(Number(at));
    const sign = !isSigned && (parts(state[name])?.[0] ?? 1) < 0 ? -1 : 1;
    const digits3 = short(sign * number, 3);
    state[name] = span.unit ? `${digits3} ${span.unit}` : digits3;
    typed.value = state[name];
    range.setAttribute("aria-valuetext", state[name]);
    changed();
  };
  range.oninput = () => put(range.value);
  // Several keys in a row are one step.
  range.onchange = () => {
    clearTimeout(keyed);
    keyed = setTimeout(remember, 600);
  };
  typed.oninput = () => {
    state[name] = typed.value;
    show();
    changed();
  };
  typed.onchange = remember;
  typed.refresh = show;
  held(host, {
    // A finger must lie on the thumb; a mouse may be anywhere on the track.
    begins: (event) => {
      if (range.disabled) return false;
      const box = range.getBoundingClientRect();
      if (event.clientY > box.bottom + 4) return false;
      const thumb = box.left + 8 + ((box.width - 16) * range.value) / 1000;
      return event.pointerType === "mouse" || Math.abs(event.clientX - thumb) < 24;
    },
    moves: (event) => {
      const box = range.getBoundingClientRect();
      range.value = ((event.clientX - box.left - 8) / (box.width - 16)) * 1000;
      put(range.value);
    },
    ends: () => {
      range.focus({ preventScroll: true });
      remember();
    },
  });
  show();
  return host;
}

// Dragging that a scroll or a swipe cannot begin: a mouse drags at once, a finger after it rested.
function held(host, { begins, moves, ends }) {
  let active = null;
  host.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !event.isPrimary || !begins(event)) return;
    const id = event.pointerId;
    const at = [event.clientX, event.clientY];
    active = { id, is: event.pointerType === "mouse" };
    if (active.is) {
      event.preventDefault();
      host.setPointerCapture(id);
      moves(event);
    } else {
      active.timer = setTimeout(() => {
        if (active?.id !== id) return;
        active.is = true;
        host.classList.add("held");
        try {
          host.setPointerCapture(id);
        } catch {
          active = null;
        }
      }, HOLD);
    }
    active.at = at;
  });
  const stop = (event) => {
    if (!active || event.pointerId !== active.id) return;
    clearTimeout(active.timer);
    const was = active.is;
    active = null;
    host.classList.remove("held");
    if (was) ends();
  };
  host.addEventListener("pointermove", (event) => {
    if (!active || event.pointerId !== active.id) return;
    if (active.is) moves(event);
    else if (Math.hypot(event.clientX - active.at[0], event.clientY - active.at[1]) > 6) {
      clearTimeout(active.timer);
      active = null;
    }
  });
  host.addEventListener("pointerup", stop);
  host.addEventListener("pointercancel", stop);
  // A finger that drags does not scroll.
  host.addEventListener("touchmove", (event) => active?.is && event.preventDefault(), { passive: false });
}

// The texts of the fields after a change of the inputs elsewhere.
function refresh() {
  for (const typed of document.querySelectorAll("[data-input]")) {
    const text = state[typed.dataset.input] ?? "";
    if (text === typed.value) continue;
    typed.value = text;
    typed.refresh();
  }
}

// The ratios of the machine when the mode changed to them, and the machine that was left.
let left = null;
// The ratios that the machine is to have after a change of the mode.
let wanted = null;

function changeMode(mode) {
  const before = JSON.stringify({ state, chosen });
  if (mode === "ratios" && shown.answer && !shown.answer.is_without_spring) {
    const { omega, alpha } = shown.answer;
    state = { ...state, mode };
    for (const name of RATIOS) state[name] = String(shown.answer[name]);
    // In ratios lengths are in B, and nothing else has a start.
    state.x0 = shown.answer.has_start && shown.answer.start[0] ? String(shown.answer.start[0]) : "";
    state.v0 = shown.answer.has_start && shown.answer.start[1] ? String(shown.answer.start[1]) : "";
    left = { before, ratios: JSON.stringify([...RATIOS, "x0", "v0"].map((name) => state[name])), omega, alpha };
  } else if (mode === "machine" && left && JSON.stringify([...RATIOS, "x0", "v0"].map((name) => state[name])) === left.ratios) {
    ({ state, chosen } = JSON.parse(left.before));
  } else {
    if (mode === "machine" && left) {
      const { omega, alpha } = shown.answer || {};
      ({ state, chosen } = JSON.parse(left.before));
      if (omega) wanted = { omega, alpha };
    }
    state.mode = mode;
    for (const names of ROLES[mode]) if (!MORE.includes(roleName(names)) && names.every((name) => !state[name])) state[names[0]] = FIRST[names[0]];
  }
  fields();
  changed();
  remember();
}

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
    if (!frequency || !amplitude || answer.is_frictionless || answer.is_free) return;
    const ratio = omega / answer.omega;
    let size = alpha / answer.alpha / ratio ** (POWERS[name] || 0);
    if (name === "damped_foot_displacement") {
      const zeta = answer.damping_ratio;
      size *= Math.hypot(1, 2 * zeta * answer.omega) / Math.hypot(1, 2 * zeta * omega);
    }
    state.frequency = withNumber(answer.inputs.frequency, frequency[0] * ratio);
    state[name] = withNumber(answer.inputs[name], amplitude[0] * size);
  }
  refresh();
  changed();
}
