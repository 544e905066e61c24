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
  // Work counts in N·m.
  const share = { "N·mm": 1e-3, "kN·mm": 1, "MN·mm": 1e3 }[unit];
  if (share) {
    const to = fitting(size * share, "N·m");
    return { unit: to.unit, factor: share * to.factor };
  }
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

// The kilograms, or for an unbalance the kg·m, in the units of mass that follow from force and length.
const MASSES = {
  t: 1e3, "N·s²/m": 1, "N·s²/mm": 1e3, "kN·s²/m": 1e3, "kN·s²/mm": 1e6, "t·m": 1e3, "t·mm": 1, "N·s²": 1, "kN·s²": 1e3, "MN·s²": 1e6,
};

// A value with its unit in four digits.
function readable(x, unit) {
  if (typeof x !== "number" || !unit || unit === "1") return four(x);
  const mass = MASSES[unit];
  if (mass) {
    const [size, length] = [Math.abs(x) * mass, unit.endsWith("m") || unit.endsWith("s²") ? "·m" : ""];
    return length || size < 1000 ? `${four(x * mass)} kg${length}` : `${four((x * mass) / 1000)} t`;
  }
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
