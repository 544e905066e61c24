// The time of frames while the point of the map is dragged, by the browser's own tracing, the time to the first answer, and
// the size of the file. It prints figures and tests nothing: node tests/frames.mjs
import { statSync } from "node:fs";
import { chromium } from "playwright-core";

const file = new URL("../dist/stickslip.html", import.meta.url);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking"] });
const page = await browser.newPage({ viewport: { width: 1440, height: 1600 } });
const begin = Date.now();
await page.goto(file.href);
await page.waitForFunction(() => document.querySelectorAll("#key dt").length > 0);
const first = Date.now() - begin;
await page.waitForSelector("#map .knob");
await page.waitForTimeout(500);

const session = await page.context().newCDPSession(page);
const events = [];
session.on("Tracing.dataCollected", ({ value }) => events.push(...value));
await session.send("Tracing.start", { transferMode: "ReportEvents", traceConfig: { includedCategories: ["devtools.timeline", "toplevel", "disabled-by-default-devtools.timeline"] } });
const box = await page.locator("#map svg").boundingBox();
const at = (t) => [box.x + box.width * (0.55 + 0.35 * Math.cos(t)), box.y + box.height * (0.45 + 0.3 * Math.sin(1.7 * t))];
await page.mouse.move(...at(0));
await page.mouse.down();
const length = 10_000;
const from = Date.now();
for (let now = 0; now < length; now = Date.now() - from) await page.mouse.move(...at(now / 900));
await page.mouse.up();
const done = new Promise((resolve) => session.once("Tracing.tracingComplete", resolve));
await session.send("Tracing.end");
await done;
await browser.close();

// A frame is a task of the page's main thread that fires animation frames; style, layout and paint are in it.
const fired = events.filter(({ name }) => name === "FireAnimationFrame");
const main = `${fired[0].pid}/${fired[0].tid}`;
const tasks = events.filter(({ name, ph, pid, tid }) => name === "RunTask" && ph === "X" && `${pid}/${tid}` === main).sort((a, b) => a.ts - b.ts);
const frames = tasks.filter(({ ts, dur }) => fired.some((own) => own.ts >= ts && own.ts < ts + dur));
for (const [words, of] of [["", ({ dur }) => dur], [" of processor", ({ tdur }) => tdur]]) {
  const times = frames.map(of).filter((time) => time !== undefined).map((time) => time / 1000).sort((a, b) => a - b);
  const part = (p) => times[Math.min(times.length - 1, Math.floor(p * times.length))]?.toFixed(1);
  console.log(`${times.length} frames in ${length / 1000} s: median ${part(0.5)} ms${words}, 95 % ${part(0.95)} ms, greatest ${part(1)} ms`);
}
console.log(`first answer ${first} ms after opening; the file has ${statSync(file).size} bytes`);
