// One cycle of the motion, or its beginning: over time, as loops, and as a machine that moves.
"use strict";

const charts = {
  curve: new Chart($("curve"), { title: "Response curve", label: "Peak displacement over the frequency, with the sticking threshold", height: 300 }),
  displacement: new Chart($("displacement"), { title: "Displacement over time", height: 180 }),
  velocity: new Chart($("velocity"), { title: "Velocity over time", height: 180 }),
  friction: new Chart($("friction"), { title: "Friction force and load over time", height: 200 }),
  loop: new Chart($("loop"), { title: "Friction force over displacement", height: 200 }),
  phase: new Chart($("phase"), { title: "Velocity over displacement", height: 180 }),
  map: new Chart($("map"), { title: "Stops in a cycle over Ω and α", height: 330, left: 48 }),
  load: new Chart($("load"), { title: "The record", height: 150 }),
  shaken: new Chart($("shaken"), { title: "Displacement under the record", height: 190 }),
  speed: new Chart($("speed"), { title: "Velocity under the record", height: 150 }),
  hysteresis: new Chart($("hysteresis"), { title: "Force on the support over the displacement under the record", height: 260 }),
  spectrum: new Chart($("spectrum"), { title: "Peak displacement over the natural period", height: 230 }),
};
charts.map.svg.removeAttribute("role");

const largest = (values) => values.reduce((most, x) => Math.max(most, Math.abs(x)), 0);

// A column of numbers in a unit that fits their size.
function fitted(values, unit) {
  const to = fitting(largest(values), unit);
  return { values: to.factor === 1 ? values : values.map((x) => x * to.factor), unit: to.unit, factor: to.factor };
}

let motion = null;

function showMotion(found) {
  const { time, units, turns, steady, rest } = found;
  const own = Object.fromEntries(["displacement", "velocity", "friction", "load"].map((name) => [name, fitted(found[name], units[name] ?? units.friction)]));
  // The load is drawn in the unit of the friction.
  const both = fitting(Math.max(largest(found.friction), largest(found.load), found.bound), units.friction);
  for (const name of ["friction", "load"]) own[name] = { values: found[name].map((x) => x * both.factor), unit: both.unit };
  const ticks = fitting(time.at(-1), units.time);
  const times = ticks.factor === 1 ? time : time.map((x) => x * ticks.factor);
  motion = { ...found, most: largest(found.displacement), own, times };
  $("motion-title").textContent = !steady ? (shown.answer?.is_free ? "The motion from the start" : `The first ${turns} turns of the drive`) : turns === 1 ? "One cycle of the motion" : `One cycle of the motion, ${turns} turns of the drive`;
  const isStill = motion.most === 0 && rest.every(Boolean);
  const bound = found.bound * both.factor;
  $("motion-note").textContent = isStill ? `The body never moves: the load of at most ${four(largest(own.load.values))} ${both.unit} stays below the friction that holds it, ${four(bound)} ${both.unit}.` : "";
  const xlabel = units.time === "rad" ? "ω_d t (rad)" : `time (${ticks.unit})`;
  const range0 = [times[0], times.at(-1)];
  for (const [name, words] of [["displacement", "displacement"], ["velocity", "velocity"]]) {
    const chart = charts[name];
    chart.begin({ x: range0, y: range(own[name].values), xlabel, ylabel: `${words} (${own[name].unit})`, legend: restLegend(rest) });
    withRests(chart, times, own[name].values, rest);
    cursor(chart, times, own[name].values);
    chart.read = (x) => {
      const i = nearest(times, x);
      return { x: times[i], text: `${four(times[i])} ${ticks.unit}: ${four(own[name].values[i])} ${own[name].unit}${rest[i] ? ", at rest" : ""}` };
    };
  }
  const { friction } = charts;
  const ink = palette();
  const legend = [["friction", ink.slide], ...restLegend(rest).slice(1), ["load", ink.second, "5 3"]];
  if (isStill) legend.push(["the friction holds up to", ink.border, "2 3"]);
  friction.begin({ x: range0, y: range([...own.friction.values, ...own.load.values, ...(isStill ? [bound, -bound] : [])]), xlabel, ylabel: `force (${both.unit})`, legend });
  if (isStill) for (const of of [bound, -bound]) friction.line(range0, [of, of], ink.border, { width: 1.5, dash: "2 3" });
  friction.line(times, own.load.values, ink.second, { width: 1.5, dash: "5 3" });
  const jumps = (isTime) => {
    const [places, forces, of] = withJumps(time, found.velocity, isTime ? time : found.displacement, found.friction, isTime);
    const factor = isTime ? ticks.factor : own.displacement.factor;
    return [places.map((x) => x * factor), forces.map((x) => x * both.factor), of.map((i) => rest[i])];
  };
  withRests(friction, ...jumps(true));
  cursor(friction, times, own.friction.values);
  friction.read = (x) => {
    const i = nearest(times, x);
    return { x: times[i], text: `${four(times[i])} ${ticks.unit}: friction ${four(own.friction.values[i])}, load ${four(own.load.values[i])} ${both.unit}` };
  };
  for (const [name, down, words, unit] of [["loop", "friction", "friction", both.unit], ["phase", "velocity", "velocity", own.velocity.unit]]) {
    const chart = charts[name];
    chart.begin({ x: range(own.displacement.values), y: range(own[down].values), xlabel: `displacement (${own.displacement.unit})`, ylabel: `${words} (${unit})`, legend: restLegend(rest) });
    withRests(chart, ...(name === "loop" ? jumps(false) : [own.displacement.values, own[down].values, rest]));
    cursor(chart, own.displacement.values, own[down].values);
    chart.read = (x, y) => ({ x, text: `${four(x)} ${own.displacement.unit}, ${four(y)} ${unit}` });
  }
  sketch.machine();
  if (!playing) place(0);
}

// What the thick line means, where there is one.
const restLegend = (rest, words = "at rest") => (rest.some(Boolean) ? [["slides", palette().slide], [words, palette().stick, "thick"]] : []);

function withRests(chart, xs, ys, rest) {
  chart.line(xs, ys, chart.ink.slide);
  if (rest.some(Boolean)) chart.line(xs, ys, chart.ink.stick, { width: 5, shown: (i) => rest[i] });
}

// The dot that plays along a line.
function cursor(chart, xs, ys) {
  chart.cursor = chart.add("circle", { class: "cursor", r: 5, fill: chart.ink.here });
  const { cursor, x, y } = chart;
  chart.put = (i) => {
    cursor.setAttribute("cx", x(xs[i]));
    cursor.setAttribute("cy", y(ys[i]));
  };
  return chart.put;
}

$("from-start").onchange = () => changed();

// ---- the sketch: the machine, its parts by name, and a bar for the scale

const sketch = (() => {
  const [width, height] = [520, 132];
  const svg = node("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": "The machine: a body on a spring, on a floor with friction" });
  const make = (name, attributes = {}, text) => {
    const made = node(name, attributes, text);
    svg.append(made);
    return made;
  };
  const line = { fill: "none", "stroke-width": 2 };
  const hatch = (x1, y1, x2, y2, count, dx, dy) => Array.from({ length: count }, (_, i) => `M${x1 + ((x2 - x1) * (i + 0.5)) / count} ${y1 + ((y2 - y1) * (i + 0.5)) / count}l${dx} ${dy}`).join("");
  const floor = make("g");
  floor.append(node("path", { ...line, d: "M30 96H440" }), node("path", { "stroke-width": 1, fill: "none", d: hatch(30, 96, 440, 96, 34, -7, 8) }));
  const wall = make("g");
  wall.append(node("path", { ...line, d: "M30 32V96" }), node("path", { "stroke-width": 1, fill: "none", d: hatch(30, 34, 30, 96, 6, -8, 6) }));
  const spring = make("path", line);
  const damper = make("path", line);
  const block = make("rect", { y: 42, width: 76, height: 54, rx: 3 });
  const text = { "font-size": 13, "font-family": "system-ui, sans-serif", "text-anchor": "middle" };
  const mass = make("text", { ...text, y: 66, "font-weight": 600 });
  const stateText = make("text", { ...text, y: 84, "font-size": 11 });
  const k = make("text", { ...text, y: 40, x: 120 });
  const arrow = make("path", { "stroke-width": 3, fill: "none" });
  const force = make("text", { ...text, y: 22 });
  const rub = make("text", { ...text, x: 400, y: 122, "font-size": 12 });
  const moved = make("text", { ...text, x: 120, y: 122, "font-size": 12 });
  const bar = make("path", { "stroke-width": 2, fill: "none" });
  const scaleText = make("text", { ...text, y: 122, "font-size": 11 });
  $("body").append(svg);
  // Pixels in a unit of the displacement.
  let pixels = 0;
  let support = null;
  const typed = (names) => (names ? state[inRole(names)] : "") || "";
  const REACH = 84;
  const show = (x, u, load, isAtRest) => {
    const ink = palette();
    const shift = u * pixels;
    const at = 222 + x * pixels + (support?.moves === "base" ? shift : 0);
    const foot = 30 + (support ? shift : 0);
    floor.setAttribute("transform", `translate(${support?.moves === "base" ? shift.toFixed(1) : 0} 0)`);
    wall.setAttribute("transform", `translate(${(foot - 30).toFixed(1)} 0)`);
    for (const host of [floor, wall]) for (const path of host.children) path.setAttribute("stroke", ink.border);
    block.setAttribute("x", at);
    block.setAttribute("fill", isAtRest ? ink.stick : ink.slide);
    const step = (at - foot) / 16;
    let d = `M${foot} 56`;
    for (let i = 1; i < 16; i++) d += `L${(foot + i * step).toFixed(1)} ${i % 2 ? 49 : 63}`;
    spring.setAttribute("d", spring.on ? `${d}L${at} 56` : "");
    wall.setAttribute("visibility", spring.on || damper.on ? "visible" : "hidden");
    spring.setAttribute("stroke", ink.border);
    const middle = (foot + at) / 2;
    damper.setAttribute("d", damper.on ? `M${foot} 82H${middle - 6}M${middle - 6} 75v14M${middle + 10} 73h-22v18h22M${middle - 6} 82M${middle - 12} 82M${middle + 10} 82H${at}` : "");
    damper.setAttribute("stroke", ink.border);
    for (const own of [mass, stateText]) {
      own.setAttribute("x", at + 38);
      own.setAttribute("fill", ink.paper);
    }
    stateText.textContent = isAtRest ? "at rest" : "slides";
    k.setAttribute("x", middle);
    const length = 70 * load;
    const from = at + 38;
    arrow.setAttribute("d", Math.abs(length) < 3 || support ? "" : `M${from} 31h${length.toFixed(1)}m${length > 0 ? -8 : 8} -5l${length > 0 ? 8 : -8} 5l${length > 0 ? -8 : 8} 5`);
    arrow.setAttribute("stroke", ink.second);
    force.setAttribute("x", support ? 400 : from);
    for (const own of [k, force, rub, scaleText, moved]) own.setAttribute("fill", ink.text);
    bar.setAttribute("stroke", ink.border);
  };
  show.machine = () => {
    const { most, units } = motion;
    support = motion.support?.amplitude > 0 ? motion.support : null;
    const reach = Math.max(most, support ? Math.min(support.amplitude, 4 * (most || Infinity)) : 0);
    pixels = reach > 0 ? REACH / reach / (support?.moves === "base" && most > 0 ? 2 : 1) : 0;
    const isMachine = state.mode === "machine";
    const base = ROLES[state.mode];
    mass.textContent = isMachine ? typed(base[0]) : "m";
    spring.on = !(isMachine && inRole(base[1]) === "stiffness" && isZero(typed(base[1])));
    k.textContent = !spring.on ? "" : isMachine ? (inRole(base[1]) === "stiffness" ? `k = ${typed(base[1])}` : typed(base[1])) : "k";
    damper.on = shown.answer ? (shown.answer.damping_ratio ?? parts(state.damping)?.[0]) > 0 : true;
    rub.textContent = isMachine ? `friction ${inRole(base[2]) === "friction" ? "" : "µ = "}${typed(base[2])}` : "friction r_y";
    const drive = isMachine ? typed(DRIVES) : "p₀ sin ω_d t";
    force.textContent = isMachine ? `${{ force: "force", unbalance: "unbalance" }[inRole(DRIVES)] || ""} ${support ? "" : drive}`.trim() : drive;
    if (isMachine && parts(state.mean_force)?.[0]) force.textContent += `${force.textContent && " + "}${state.mean_force.trim()} constant`;
    moved.textContent = support ? `${support.moves === "base" ? "floor" : "wall"} moves: ${drive}` : "";
    // A round length of at most 100 pixels.
    const unit = 100 / (pixels || 1);
    const round = 10 ** Math.floor(Math.log10(unit));
    const length = [5, 2, 1].map((n) => n * round).find((n) => n <= unit) || round;
    bar.setAttribute("d", pixels ? `M${500 - length * pixels} 108v5h${length * pixels}v-5` : "");
    scaleText.setAttribute("x", 500 - (length * pixels) / 2);
    scaleText.setAttribute("y", 127);
    rub.setAttribute("x", pixels ? 330 : 400);
    scaleText.textContent = pixels ? readable(length, units.displacement) : "";
  };
  return show;
})();

// ---- the animation: a cycle takes three seconds

let playing = !matchMedia("(prefers-reduced-motion: reduce)").matches;
// Whether the record plays instead.
let playingRecord = false;

function place(part) {
  if (!motion) return;
  const last = motion.time.length - 1;
  const i = Math.min(last, Math.round(part * last));
  for (const name of ["displacement", "velocity", "friction", "loop", "phase"]) charts[name].put(i);
  const { support } = motion;
  const angle = part * 2 * Math.PI * motion.turns;
  const top = largest(motion.load);
  sketch(motion.displacement[i], support ? support.amplitude * Math.sin(angle - support.lead) : 0, top ? motion.load[i] / top : 0, motion.rest[i]);
}

function placeAll(now) {
  const length = 3000 * Math.min(motion?.turns || 1, 8);
  if (tab === "two") placeSystem(now);
  else if (!playingRecord) place((now % length) / length);
}

function animate(now) {
  if (!playing) return;
  placeAll(now);
  requestAnimationFrame(animate);
}

function play(on) {
  playing = on;
  for (const button of document.querySelectorAll(".play")) {
    button.textContent = on ? "Pause" : "Play";
    button.setAttribute("aria-pressed", String(on));
  }
  if (on) requestAnimationFrame(animate);
}
for (const button of document.querySelectorAll(".play")) button.onclick = () => play(!playing);
