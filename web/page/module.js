// The library as a module: a question as an object goes in, its answer comes out. An error of the library is thrown.
"use strict";

async function load(module) {
  const instance = await WebAssembly.instantiate(module, {});
  const { memory, question, ask, answer } = instance.exports;
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();
  return (asked) => {
    const text = encoder.encode(JSON.stringify(asked));
    const place = question(text.length);
    new Uint8Array(memory.buffer, place, text.length).set(text);
    const length = ask();
    const found = JSON.parse(decoder.decode(new Uint8Array(memory.buffer, answer(), length)));
    if (found.error !== undefined) throw new Error(found.error);
    return found.ok;
  };
}

// The bytes of a text with five letters for four of them: the digits of base 85, as in RFC 1924 but with "." for "<".
function bytesOf(text) {
  const values = new Uint8Array(128);
  [..."0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz!#$%&()*+-;.=>?@^_`{|}~"].forEach((letter, i) => {
    values[letter.charCodeAt(0)] = i;
  });
  const missing = (5 - (text.length % 5)) % 5;
  const whole = text + "~".repeat(missing);
  const found = new DataView(new ArrayBuffer((whole.length / 5) * 4));
  for (let i = 0, place = 0; i < whole.length; i += 5, place += 4) {
    let word = 0;
    for (let k = i; k < i + 5; k++) word = word * 85 + values[whole.charCodeAt(k)];
    found.setUint32(place, word);
  }
  return new Uint8Array(found.buffer, 0, found.byteLength - missing);
}

// The module's bytes from the text in the page, which are compressed.
async function unpacked(text) {
  const bytes = bytesOf(text);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// As the command writes a number: seven significant digits without trailing zeros.
function digits(x) {
  if (x === null || x === undefined) return "–";
  if (typeof x !== "number") return String(x);
  const rounded = Number(x.toPrecision(7));
  const size = Math.abs(rounded);
  if (size === 0 || (size >= 1e-4 && size < 1e7)) {
    const text = String(rounded);
    return text.includes("e") ? rounded.toFixed(20).replace(/\.?0+$/, "") : text;
  }
  return rounded.toExponential().replace("e+", "e");
}

// Columns by their names as a file.
function csvText(columns) {
  const names = Object.keys(columns);
  const rows = columns[names[0]].map((_, i) => names.map((name) => columns[name][i] ?? "").join(","));
  return `${names.map((name) => (name.includes(",") ? `"${name}"` : name)).join(",")}\n${rows.join("\n")}\n`;
}
