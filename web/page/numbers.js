// Numbers as people read them: four digits with a prefix; all digits stay at hand.
"use strict";

// The prefixes of a unit that is counted in thousands.
const PREFIXES = [["n", -9], ["µ", -6], ["m", -3], ["", 0], ["k", 3], ["M", 6], ["G", 9]];

// The unit without its prefix, and the power of ten of the prefix; nothing for units that take none.
function prefixed(unit) {
  // A unit of a force, a length or what is made of them; the rest of the name stays as it is.
  const found = /^([nµmkMG]?)(N·m|N|m)(\/s²?|\/m|·s\/m)?$/u.exec(unit) || /^([nµmk]?)(s)()$/.exec(unit);
  if (!found) return null;
  const power = PREFIXES.find(([name]) => name === found[1])[1];
  return { power, rest: `${found[2]}${found[3] || ""}` };
}

// The unit in which a size has one to three digits before its point, and the factor to it.
function fitting(size, unit) {
  const own = prefixed(unit);
  if (!own || !(size > 0) || !Number.isFinite(size)) return { unit, factor: 1 };
  const places = Math.floor(Math.log10(size) + own.power + 1e-12);
  // Lengths and speeds below a metre are read in millimetres.
  let power = Math.min(9, Math.max(-9, 3 * Math.floor(places / 3)));
  if (own.rest[0] === "m" && power > 0) power = places >= 4 ? power : 0;
  if (own.rest[0] === "m" && places === -4) power = -3;
  const name = PREFIXES.find(([, of]) => of === power)[0];
  return { unit: `${name}${own.rest}`, factor: 10 ** (own.power - power) };
}

// A number with four digits.
function four(x) {
  if (x === null || x === undefined) return "–";
  if (typeof x !== "number") return String(x);
  const rounded = Number(x.toPrecision(4));
  const size = Math.abs(rounded);
  if (size === 0 || (size >= 1e-3 && size < 1e5)) return String(rounded);
  return rounded.toExponential().replace("e+", "e");
}

// A value with its unit in four digits.
function readable(x, unit) {
  if (typeof x !== "number" || !unit || unit === "1") return four(x);
  const to = fitting(Math.abs(x), unit);
  return `${four(x * to.factor)} ${to.unit}`;
}

// The number and the unit of a typed value; nothing where a comma or another text makes it doubtful.
function parts(text) {
  const found = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\d,.\s].*?)?\s*$/.exec((text || "").replace("−", "-"));
  return found ? [Number(found[1]), found[2] || ""] : null;
}

const short = (x, count = 4) => String(Number(x.toPrecision(count)));

// A text with another number and the same unit.
function withNumber(text, number, count = 4) {
  const unit = parts(text)?.[1] || "";
  return unit ? `${short(number, count)} ${unit}` : short(number, count);
}

// A sentence whose numbers have four digits; beside 1 all of them count.
const fourIn = (text) => text.replace(/\d+\.\d{4,}(?:e-?\d+)?|\d+\.\d+e-?\d+/g, (number) => (Math.abs(number - 1) < 5e-3 ? number : four(Number(number))));
