// The map of stops over Ω and α. Its colours are the places that the module gives, by the code that counts the stops of
// the verdict.
"use strict";

let mapOf = "";
let dragged = null;
// Cells of the first picture, and into how many each is divided along the borders between colours.
const [ACROSS, UP, FINER] = [96, 64, 3];
// Periods of the first answer, and points in a question of the later ones.
const [FEW, MANY] = [300, 400];

function mapRange() {
  const { omega, alpha, static_friction_ratio } = shown.answer;
  return dragged || { omega: Math.max(2, 1.2 * omega), alpha: Math.max(6, 1.2 * alpha, 3 * static_friction_ratio) };
}

const centres = (n, high) => Array.from({ length: n }, (_, i) => ((i + 0.5) / n) * high);

function askMap() {
  const answer = shown.answer;
  const isPlain = answer.is_free || answer.is_frictionless;
  $("map-section").hidden = isPlain && !embedded;
  for (const part of document.querySelectorAll("#map-section > :not(h2, #map-note)")) part.hidden = answer.is_without_spring;
  $("map-section").classList.toggle("bare", Boolean(answer.is_without_spring));
  if (answer.is_without_spring) {
    mapOf = "";
    $("map-note").textContent = "Without a spring there is no natural frequency and no Ω: this map does not exist.";
  }
  if (isPlain || answer.is_without_spring) return;
  const { omega, alpha } = mapRange();
  const { damping_ratio, static_friction_ratio, start } = answer;
  // A velocity in units stays what it is at other frequencies; one in B ω_d changes with them.
  const from = state.mode === "machine" ? { x: start[0], w: start[1] * answer.omega } : { x: start[0], v: start[1] };
  const same = { ask: "map", damping_ratio, static_friction_ratio, ...(static_friction_ratio > 1 ? from : {}) };
  const key = JSON.stringify([omega, alpha, same]);
  if (key === mapOf) return;
  mapOf = key;
  fileButtons();
  // The border has poles, and needs more points than the colours.
  const border = centres(1000, omega);
  $("map-note").textContent = "Computing …";
  charts.map.host.classList.add("stale");
  const cells = Array.from({ length: ACROSS * UP }, (_, cell) => cell);
  // Every eighth row first, then those between.
  const row = (cell) => Math.floor(cell / ACROSS);
  const turn = (cell) => [0, 4, 2, 6, 1, 5, 3, 7].indexOf(row(cell) % 8);
  cells.sort((a, b) => turn(a) - turn(b) || a - b);
  const grid = { omega, alpha, key, same, width: ACROSS, height: UP, places: border, border: [], stops: new Array(ACROSS * UP).fill(OPEN), open: new Set(cells) };
  answerCells(grid, cells, FEW, () => {
    charts.map.host.classList.remove("stale");
    $("map-note").textContent = "";
    refine({ ...grid, open: undefined });
  });
}

// Finer cells, first where neighbours differ and then the others, each by its own motion: a colour may have islands
// smaller than a rough cell. Last come the cells that the first periods left open.
function refine(grid) {
  const [width, height] = [ACROSS * FINER, UP * FINER];
  const stops = new Array(width * height);
  const [asked, inner] = [[], []];
  const of = (i, j) => grid.stops[Math.min(Math.max(j, 0), UP - 1) * ACROSS + Math.min(Math.max(i, 0), ACROSS - 1)];
  for (let j = 0; j < height; j++) {
    for (let i = 0; i < width; i++) {
      const [a, b] = [Math.floor(i / FINER), Math.floor(j / FINER)];
      const own = of(a, b);
      stops[j * width + i] = own;
      const isInner = [[-1, 0], [1, 0], [0, -1], [0, 1], [-1, -1], [1, 1], [-1, 1], [1, -1]].every(([x, y]) => of(a + x, b + y) === own);
      // The middle of a rough cell has its answer.
      if (!(i % FINER === 1 && j % FINER === 1)) (isInner ? inner : asked).push(j * width + i);
    }
  }
  const fine = { ...grid, width, height, stops };
  answerCells(fine, [...asked, ...inner], FEW, () => {
    const open = fine.stops.flatMap((n, cell) => (n === -2 || n === -3 ? [cell] : []));
    fine.open = new Set(open);
    answerCells(fine, open, undefined, () => {
      fine.open = undefined;
      fine.isFinal = true;
      $("map-note").textContent = "";
      later("map", fine);
    });
  });
}

// Says how much of the map is computed, in steps that a screen reader can follow.
function progress(grid, part) {
  const text = `Computing ${grid.width > ACROSS ? "in detail " : ""}… ${10 * Math.floor(10 * part)} %`;
  if ($("map-note").textContent !== text) $("map-note").textContent = text;
}

// Asks some cells in parts, as long as the map is of the same machine, and draws what is there.
function answerCells(grid, cells, periods, done, total = cells.length) {
  const part = cells.slice(0, periods ? (grid.same.static_friction_ratio > 1 ? 800 : 6200) : MANY);
  if (grid.key !== mapOf) return;
  if (!part.length) {
    done();
    return;
  }
  const isFirst = !grid.border.length;
  const points = part.flatMap((cell) => [(((cell % grid.width) + 0.5) / grid.width) * grid.omega, ((Math.floor(cell / grid.width) + 0.5) / grid.height) * grid.alpha]);
  mapper.ask("map", { ...grid.same, points, ...(isFirst ? { border: grid.places } : {}), ...(periods ? { periods } : {}) }, ({ ok }) => {
    if (grid.key !== mapOf) return;
    if (isFirst) grid.border = ok?.border ?? grid.places.map(() => null);
    part.forEach((cell, i) => {
      grid.stops[cell] = ok ? ok.stops[i] : -4;
      grid.open?.delete(cell);
    });
    later("map", { ...grid });
    progress(grid, 1 - (cells.length - part.length) / total);
    answerCells(grid, cells.slice(part.length), periods, done, total);
  });
}

// A file has the answer of every cell, of the machine of now.
const isMapFinal = () => Boolean(shown.map?.isFinal && shown.map.key === mapOf);

// The colours: lighter and darker, so that grey tells them apart; patterns tell what is no count. A cell that is still
// computed has a code of its own.
const OPEN = "open";
function shadeOf(n) {
  if (n === 0) return { colour: [16, 68, 128] };
  if (n === -1) return { colour: [226, 229, 233] };
  if (n === 1) return { colour: [250, 206, 122] };
  if (n === 2) return { colour: [217, 135, 38], dots: [120, 62, 6] };
  if (n > 0 && n <= 4) return { colour: [163, 86, 12] };
  if (n > 0 && n <= 8) return { colour: [112, 50, 6], dots: [236, 190, 120] };
  if (n > 0) return { colour: [62, 24, 2] };
  if (n === -2) return { colour: [205, 180, 235], lines: [104, 58, 160] };
  if (n === -3) return { colour: [240, 240, 240], lines: [90, 90, 90] };
  if (n === -5) return { colour: [150, 190, 225], dots: [16, 68, 128] };
  if (n === -6) return { colour: [217, 135, 38], lines: [255, 240, 210] };
  if (n === OPEN) return { colour: [246, 246, 246], dots: [170, 170, 170] };
  return { colour: [255, 255, 255], lines: [190, 20, 30] };
}
const NAMED = { 0: "no stop", "-1": "at rest", "-2": "irregular", "-3": "not settled", "-4": "not computed", "-5": "grows without bound", "-6": "stops too short to count", [OPEN]: "still computed" };
// The row of the key that a number of stops belongs to.
const classOf = (n) => (n === OPEN || n <= 2 ? n : n <= 4 ? 4 : n <= 8 ? 8 : 9);
const nameOf = (n) => (n > 0 && n !== OPEN ? { 1: "1 stop", 2: "2 stops", 4: "3–4 stops", 8: "5–8 stops", 9: "more stops" }[n] : NAMED[n]);

// Fills pixels: `of` gives the code of each.
function painted(width, height, of) {
  const canvas = Object.assign(document.createElement("canvas"), { width, height });
  const context = canvas.getContext("2d");
  const image = context.createImageData(width, height);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const { colour, dots, lines } = shadeOf(of(x, y));
      const isDot = dots && x % 6 < 2 && (y + 3 * (Math.floor(x / 6) % 2)) % 6 < 2;
      const isLine = lines && (x + y) % 7 < 2;
      const own = isDot ? dots : isLine ? lines : colour;
      image.data.set([own[0], own[1], own[2], 255], 4 * (y * width + x));
    }
  }
  context.putImageData(image, 0, 0);
  return canvas.toDataURL();
}

function showMap(grid) {
  fileButtons();
  const chart = charts.map;
  const focused = document.activeElement?.classList.contains("knob");
  const codes = new Set();
  const code = (cell) => (grid.open?.has(cell) ? OPEN : classOf(grid.stops[cell]));
  for (let cell = 0; cell < grid.stops.length; cell++) codes.add(code(cell));
  const order = [0, 1, 2, 4, 8, 9, -6, -1, -5, -2, -3, -4, OPEN];
  const legend = order.filter((n) => codes.has(n)).map((n) => [nameOf(n), "", "", painted(18, 12, () => n)]);
  legend.push(["sticking threshold", palette().border]);
  chart.begin({ x: [0, grid.omega], y: [0, grid.alpha], xlabel: "frequency ratio Ω", ylabel: "force ratio α", legend });
  const { left, right, top, bottom } = chart.box;
  const [width, height] = [Math.round(right - left), Math.round(bottom - top)];
  const href = painted(width, height, (x, y) => code(Math.floor(((height - 0.5 - y) / height) * grid.height) * grid.width + Math.floor(((x + 0.5) / width) * grid.width)));
  chart.add("image", { x: left, y: top, width: right - left, height: bottom - top, href, preserveAspectRatio: "none" });
  chart.line(grid.places, grid.border, "#ffffff", { width: 4 });
  chart.line(grid.places, grid.border, "#222222", { width: 1.6 });
  const knob = chart.add("g", { class: "knob cursor", tabindex: 0, role: "slider", "aria-label": "Point on the map: the arrow keys change Ω and α", "aria-valuemin": 0, "aria-valuemax": grid.omega });
  knob.append(node("circle", { r: 14, fill: "transparent" }), node("circle", { r: 7, fill: "#ffffff", stroke: "#111111", "stroke-width": 2.5 }), node("circle", { r: 2.5, fill: "#c1121f" }));
  knob.onkeydown = (event) => {
    const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!step || !shown.answer) return;
    event.preventDefault();
    const { omega, alpha } = aim || shown.answer;
    const size = event.shiftKey ? 0.1 : 0.01;
    moveTo(Math.max(omega + step[0] * size, 0.001), Math.max(alpha + step[1] * size * 3, 0.001));
  };
  knob.onkeyup = () => {
    clearTimeout(keyed);
    keyed = setTimeout(remember, 600);
  };
  chart.knob = knob;
  chart.read = (x, y) => {
    const [i, j] = [Math.min(grid.width - 1, Math.floor((x / grid.omega) * grid.width)), Math.min(grid.height - 1, Math.floor((y / grid.alpha) * grid.height))];
    const cell = j * grid.width + i;
    const n = grid.stops[cell];
    return { x, text: `Ω ${four(x)}, α ${four(y)}: ${grid.open?.has(cell) ? NAMED[OPEN] : n > 0 ? `${n} ${n === 1 ? "stop" : "stops"}` : NAMED[n]}` };
  };
  putKnob();
  if (focused) knob.focus();
}

function putKnob() {
  const { knob, x, y } = charts.map;
  if (!knob || !shown.answer || !shown.map || shown.answer.is_without_spring) return;
  const { omega, alpha } = shown.answer;
  const grid = shown.map;
  knob.setAttribute("transform", `translate(${x(Math.min(omega, grid.omega)).toFixed(1)} ${y(Math.min(alpha, grid.alpha)).toFixed(1)})`);
  knob.setAttribute("aria-valuenow", digits(omega));
  knob.setAttribute("aria-valuetext", `Ω = ${digits(omega)}, α = ${digits(alpha)}: ${placeWords(shown.answer.place).toLowerCase()}`);
}

// A mouse moves the point anywhere in the frame; a finger holds the point itself.
held(charts.map.svg, {
  begins: (event) => {
    if (!shown.map || !shown.answer || !charts.map.at(event)) return false;
    if (event.pointerType !== "mouse") {
      const box = charts.map.knob.getBoundingClientRect();
      if (Math.hypot(event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2) > 24) return false;
    }
    dragged = { omega: shown.map.omega, alpha: shown.map.alpha };
    return true;
  },
  moves: (event) => {
    const { svg, x, y } = charts.map;
    const box = svg.getBoundingClientRect();
    const part = svg.viewBox.baseVal.width / box.width;
    const within = (value, high) => Math.min(Math.max(value, high / 1000), high);
    moveTo(within(x.back((event.clientX - box.left) * part), dragged.omega), within(y.back((event.clientY - box.top) * part), dragged.alpha));
  },
  ends: () => {
    dragged = null;
    remember();
  },
});
for (const name of ["pointerup", "pointercancel"]) addEventListener(name, () => (dragged = null));
