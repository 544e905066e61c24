// Charts as SVG: axes with round numbers, lines, marks and areas of cells.
"use strict";

const SVG = "http://www.w3.org/2000/svg";

function node(name, attributes = {}, text = undefined) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

// A number on an axis.
function tick(x) {
  const size = Math.abs(x);
  if (size === 0) return "0";
  if (size >= 1e5 || size < 1e-4) return x.toExponential(1).replace(".0e", "e").replace("e+", "e");
  return String(Number(x.toPrecision(6)));
}

// Round numbers within a range, about `count` of them and at least three.
function ticks(low, high, count) {
  const raw = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((n) => n * power >= raw) * power;
  const all = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) all.push(i * step);
  return all.length < 3 ? ticks(low, high, 1.5 * count) : all;
}

function powers(low, high, count) {
  const decades = Math.log10(high / low);
  if (decades < 0.5) return ticks(low, high, count);
  const parts = decades > count ? [1] : decades > 1.5 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 7, 8];
  const all = [];
  for (let e = Math.floor(Math.log10(low)); e <= Math.log10(high); e++) {
    for (const part of parts) {
      const x = part * 10 ** e;
      if (x >= low * (1 - 1e-9) && x <= high * (1 + 1e-9)) all.push(x);
    }
  }
  const every = Math.ceil(all.length / (2 * count));
  return all.filter((_, i) => i % every === 0);
}

// An axis from numbers to places on the page.
function scale(low, high, from, to, logarithmic = false) {
  if (!(high > low)) [low, high] = logarithmic ? [low / 2, low * 2] : [low - 1, high + 1];
  const of = logarithmic ? Math.log : (x) => x;
  const [a, b] = [of(low), of(high)];
  const place = (x) => from + ((of(x) - a) / (b - a)) * (to - from);
  place.back = (at) => {
    const x = a + ((at - from) / (to - from)) * (b - a);
    return logarithmic ? Math.exp(x) : x;
  };
  place.low = low;
  place.high = high;
  place.ticks = (count) => (logarithmic ? powers(low, high, count) : ticks(low, high, count));
  return place;
}

// The least and the greatest finite number, with room beside them.
function range(values, room = 0.06) {
  let [low, high] = [Infinity, -Infinity];
  for (const x of values) {
    if (x !== null && Number.isFinite(x)) {
      if (x < low) low = x;
      if (x > high) high = x;
    }
  }
  if (!(low <= high)) return [0, 1];
  const more = (high - low) * room || Math.abs(high) * room || 1;
  return [low - more, high + more];
}

// Charts on paper have one width, which its style scales, whatever the width of the screen.
let isOnPaper = false;
const widthOf = (host) => (!isOnPaper ? host.clientWidth : host.parentElement.className === "pair" ? 345 : 700);

class Chart {
  constructor(host, { title, label, height = 240, left = 70 }) {
    this.host = host;
    this.title = title;
    this.height = height;
    this.left = left;
    this.svg = node("svg", { role: "img", "aria-label": label || title });
    host.append(this.svg);
    this.reading = null;
    this.pointer = null;
    this.svg.addEventListener("pointermove", (event) => this.cross(event));
    this.svg.addEventListener("pointerdown", (event) => this.cross(event));
    this.svg.addEventListener("pointerleave", () => {
      this.pointer = null;
      this.uncross();
    });
  }

  // The values under the pointer, for a chart that has some. A chart that is drawn anew under a still pointer keeps them.
  set read(reading) {
    this.reading = reading;
    if (this.pointer) this.cross(this.pointer);
  }

  // The place of an event in the units of the axes, if it is within the frame.
  at(event) {
    if (!this.box) return null;
    const box = this.svg.getBoundingClientRect();
    const part = this.svg.viewBox.baseVal.width / box.width;
    const [x, y] = [(event.clientX - box.left) * part, (event.clientY - box.top) * part];
    const { left, right, top, bottom } = this.box;
    return x < left || x > right || y < top || y > bottom ? null : { x, y };
  }

  // A line at the pointer, with the values there: `read` gives the place on the x-axis and a text.
  cross(event) {
    this.pointer = { clientX: event.clientX, clientY: event.clientY };
    const place = this.reading && this.at(event);
    if (!place) return this.uncross();
    const found = this.reading(this.x.back(place.x), this.y.back(place.y));
    if (!found) return this.uncross();
    if (!this.hair) {
      this.hair = node("g", { class: "cursor", "pointer-events": "none" });
      this.hair.append(node("path", { "stroke-width": 1, fill: "none" }), node("rect", { height: 17, rx: 3, "fill-opacity": 0.92 }), node("text", { "font-size": 11, "font-family": "system-ui, sans-serif" }));
    }
    if (this.hair.parentNode !== this.svg) this.svg.append(this.hair);
    const [line, back, text] = this.hair.children;
    const { left, right, top, bottom } = this.box;
    const x = Math.min(Math.max(this.x(found.x), left), right);
    line.setAttribute("d", `M${x} ${top}V${bottom}`);
    line.setAttribute("stroke", this.ink.border);
    text.textContent = found.text;
    text.setAttribute("fill", this.ink.text);
    const width = 6.1 * found.text.length + 8;
    const from = Math.max(left, Math.min(x + 6, right - width));
    back.setAttribute("x", from);
    back.setAttribute("y", top + 2);
    back.setAttribute("width", width);
    back.setAttribute("fill", this.ink.paper);
    text.setAttribute("x", from + 4);
    text.setAttribute("y", top + 14);
  }

  uncross() {
    this.hair?.remove();
  }

  // Begins a picture with its axes.
  begin({ x, y, xlabel, ylabel, xlog = false, ylog = false, legend = [] }) {
    const width = Math.max(200, widthOf(this.host));
    const { left } = this;
    // A legend stands above the frame, where it covers nothing, in as many lines as it needs.
    const places = this.arrange(legend, width - left - 14);
    const height = this.height + Math.max(0, places.lines - 1) * 17;
    const [right, top, bottom] = [14, legend.length ? 14 + 17 * places.lines : 12, 40];
    this.box = { left, top, right: width - right, bottom: height - bottom };
    this.x = scale(x[0], x[1], left, width - right, xlog);
    this.y = scale(y[0], y[1], height - bottom, top, ylog);
    this.hair = null;
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.svg.setAttribute("width", width);
    this.svg.setAttribute("height", height);
    const ink = palette();
    const all = node("g", { "font-family": "system-ui, sans-serif", "font-size": "11", fill: ink.text });
    const grid = [];
    for (const value of this.x.ticks(Math.max(3, Math.floor(width / 80)))) {
      const at = this.x(value).toFixed(1);
      grid.push(`M${at} ${top}V${this.box.bottom}`);
      all.append(node("text", { x: at, y: this.box.bottom + 15, "text-anchor": "middle" }, tick(value)));
    }
    for (const value of this.y.ticks(Math.max(4, Math.floor(height / 38)))) {
      const at = this.y(value).toFixed(1);
      grid.push(`M${left} ${at}H${this.box.right}`);
      all.append(node("text", { x: left - 6, y: Number(at) + 4, "text-anchor": "end" }, tick(value)));
    }
    all.append(node("path", { d: grid.join(""), stroke: ink.grid, fill: "none" }));
    const middle = (left + this.box.right) / 2;
    all.append(node("text", { x: middle, y: height - 6, "text-anchor": "middle" }, xlabel));
    const across = (top + this.box.bottom) / 2;
    const turned = { x: 13, y: across, "text-anchor": "middle", transform: `rotate(-90 13 ${across})` };
    all.append(node("text", turned, ylabel));
    this.marks = node("g");
    this.svg.replaceChildren(node("title", {}, this.title), all, this.marks);
    this.ink = ink;
    this.legend(legend, places);
  }

  // The places of the rows of a legend within a width.
  arrange(rows, width) {
    const places = [];
    let [x, line] = [8, 0];
    for (const [text] of rows) {
      const length = 33 + 6.2 * text.length;
      if (x > 8 && x + length > width) [x, line] = [8, line + 1];
      places.push([x, line]);
      x += length;
    }
    places.lines = line + 1;
    return places;
  }

  // The line through points; it breaks where one is not a number, and is cut at the frame.
  path(xs, ys, shown = () => true) {
    let d = "";
    let down = false;
    const { top, bottom } = this.box;
    for (let i = 0; i < xs.length; i++) {
      const y = ys[i];
      if (y === null || !Number.isFinite(y) || !shown(i)) {
        down = false;
        continue;
      }
      const at = Math.min(Math.max(this.y(y), top - 60), bottom + 60);
      // Rounding is several times faster than toFixed.
      d += `${down ? "L" : "M"}${Math.round(10 * this.x(xs[i])) / 10} ${Math.round(10 * at) / 10}`;
      down = true;
    }
    return d;
  }

  line(xs, ys, colour, { width = 2, dash = "", shown } = {}) {
    const d = this.path(xs, ys, shown);
    if (d) this.add("path", { d, fill: "none", stroke: colour, "stroke-width": width, "stroke-dasharray": dash, "stroke-linejoin": "round", "clip-path": this.clip() });
  }

  clip() {
    const id = `frame-${this.host.id}`;
    if (!this.svg.querySelector(`#${id}`)) {
      const path = node("clipPath", { id });
      const { left, top, right, bottom } = this.box;
      path.append(node("rect", { x: left, y: top, width: right - left, height: bottom - top }));
      this.svg.insertBefore(path, this.marks);
    }
    return `url(#${id})`;
  }

  add(name, attributes, text) {
    const made = node(name, attributes, text);
    this.marks.append(made);
    return made;
  }

  dot(x, y, colour, radius = 5) {
    const at = Math.min(Math.max(this.y(y), this.box.top), this.box.bottom);
    return this.add("circle", { cx: this.x(x).toFixed(1), cy: at.toFixed(1), r: radius, fill: colour, stroke: this.ink.paper, "stroke-width": 1.5 });
  }

  // Each row has a text, a colour, and a dash, or the word "thick" or "dot", or else a picture of its own.
  legend(rows, places) {
    rows.forEach(([text, colour, dash, picture], i) => {
      const [x, y] = [this.box.left + places[i][0], 9 + 17 * places[i][1]];
      if (picture) this.add("image", { x, y: y - 6, width: 18, height: 12, href: picture });
      else if (dash === "dot") this.add("circle", { cx: x + 9, cy: y, r: 5, fill: colour });
      else this.add("path", { d: `M${x} ${y}h18`, stroke: colour, "stroke-width": dash === "thick" ? 6 : 3, "stroke-dasharray": /\d/.test(dash) ? dash : "" });
      this.add("text", { x: x + 23, y: y + 4, "font-size": 11, "font-family": "system-ui, sans-serif", fill: this.ink.text }, text);
    });
  }
}

// The colours of the theme that is shown; they are told apart in grey and without red and green, too.
function palette() {
  const dark = document.documentElement.dataset.theme === "dark";
  return dark
    ? { text: "#e6e6e6", grid: "#3a3f47", paper: "#1b1e23", slide: "#6cb6ff", stick: "#ffb454", border: "#c9c9c9", here: "#ff7b72", second: "#a5d6a7", ghost: "#8b949e" }
    : { text: "#24292f", grid: "#dfe3e8", paper: "#ffffff", slide: "#0b61a4", stick: "#c65d00", border: "#444444", here: "#c1121f", second: "#2e7d32", ghost: "#6e7781" };
}

function saved(name, type, text) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

// Pictures below each other as one file, without what moves in them.
function svgFile(pictures, paper) {
  const size = (svg, name) => Number(svg.getAttribute(name));
  const seen = pictures.filter((svg) => svg.childElementCount);
  const width = Math.max(...seen.map((svg) => size(svg, "width")));
  const height = seen.reduce((sum, svg) => sum + size(svg, "height"), 0);
  const all = node("svg", { width, height, viewBox: `0 0 ${width} ${height}` });
  all.append(node("rect", { width, height, fill: paper }));
  let y = 0;
  for (const svg of seen) {
    const copy = svg.cloneNode(true);
    for (const moving of copy.querySelectorAll(".cursor")) moving.remove();
    copy.setAttribute("y", y);
    y += size(svg, "height");
    all.append(copy);
  }
  return { width, height, text: `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(all)}\n` };
}

// A picture as an image of twice its size.
async function asImage({ width, height, text }) {
  const image = new Image();
  image.src = URL.createObjectURL(new Blob([text], { type: "image/svg+xml" }));
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: 2 * width, height: 2 * height });
  canvas.getContext("2d").drawImage(image, 0, 0, 2 * width, 2 * height);
  URL.revokeObjectURL(image.src);
  return new Promise((resolve) => canvas.toBlob(resolve, "image/png"));
}

// A force over times or over displacements, in which a change between two samples that is a jump is drawn as one: where
// the speed changes its sign, at the instant that it is 0; where the body stops, and where a greater static friction lets
// go, at the later sample. Returns the places, the forces and the samples that they belong to.
function withJumps(times, speed, xs, ys, isTime) {
  const found = [[xs[0]], [ys[0]], [0]];
  const add = (x, y, i) => [x, y, i].forEach((own, k) => found[k].push(own));
  for (let i = 1; i < xs.length; i++) {
    const [a, b, dt] = [speed[i - 1], speed[i], times[i] - times[i - 1]];
    const isDrop = a === 0 && b !== 0 && Math.abs(ys[i]) < Math.abs(ys[i - 1]);
    if (a * b < 0 || (a !== 0 && b === 0) || isDrop) {
      const part = (dt * Math.abs(a)) / (Math.abs(a) + Math.abs(b));
      const x = a * b < 0 ? xs[i - 1] + (isTime ? part : (a * part) / 2) : xs[i];
      add(x, ys[i - 1], i - 1);
      add(x, ys[i], i);
    }
    add(xs[i], ys[i], i);
  }
  return found;
}

// The index of the entry of a rising list that is nearest to a number.
function nearest(list, x) {
  let [low, high] = [0, list.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (list[middle] <= x) low = middle;
    else high = middle;
  }
  return Math.abs(list[low] - x) <= Math.abs(list[high] - x) ? low : high;
}
