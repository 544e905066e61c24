// The module of the built page, as the page loads it.
import { readFileSync } from "node:fs";

const page = readFileSync(new URL("../dist/stickslip.html", import.meta.url), "utf8");
const part = (id) => new RegExp(`<script id="${id}"[^>]*>([\\s\\S]*?)</script>`).exec(page)[1];

export const glue = new Function(`${part("module-source")}; return { load, unpacked, digits };`)();

export async function asker() {
  return glue.load(await WebAssembly.compile(await glue.unpacked(part("wasm").trim())));
}
