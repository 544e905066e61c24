// The page in Chromium, as a person uses it, opened from its file. $CHROMIUM names the browser (/usr/bin/chromium), and
// $SCREENSHOTS a folder for pictures at three sizes.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { chromium } from "playwright-core";
import { machines } from "./machines.mjs";
import { asker } from "./module.mjs";

const address = new URL("../dist/stickslip.html", import.meta.url).href;
const folder = mkdtempSync(join(tmpdir(), "stickslip-page-"));
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM || "/usr/bin/chromium",
  args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
test.after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

const verdict = (page) => page.textContent("#verdict");
const answered = (page, what) => page.waitForFunction((text) => document.getElementById("verdict").textContent.includes(text), what);

// A page that has answered; every request that leaves it and every fault in it fails the test.
async function opened(link = "", { width = 1440, height = 1000, ...more } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true, ...more });
  const page = await context.newPage();
  page.faults = [];
  page.on("pageerror", (error) => page.faults.push(error.message));
  page.on("console", (message) => message.type() === "error" && page.faults.push(message.text()));
  page.on("request", (request) => /^(file|blob|data):/.test(request.url()) || page.faults.push(request.url()));
  await page.goto(address + link);
  await page.waitForFunction(() => document.querySelectorAll("#key dt").length > 0);
  return page;
}

async function closed(page) {
  assert.deepEqual(page.faults, []);
  await page.context().close();
}

test("the module gives the same bytes in Chromium and in Node", async () => {
  const page = await opened();
  const ask = await asker();
  for (const { columns, rows } of machines(Number(process.env.STICKSLIP_MACHINES || 10000))) {
    const questions = rows.map((row) => ({ ask: "answer", inputs: Object.fromEntries(columns.map((name, j) => [name, String(row[j])])) }));
    const found = await page.evaluate(async (questions) => {
      const ask = await load(await WebAssembly.compile(await unpacked(document.getElementById("wasm").textContent.trim())));
      return questions.map((question) => JSON.stringify(ask(question)));
    }, questions);
    questions.forEach((question, i) => assert.equal(found[i], JSON.stringify(ask(question)), JSON.stringify(question)));
  }
  await closed(page);
});

test("typing changes the answer, and wrong input is named", async () => {
  const page = await opened();
  assert.match(await verdict(page), /^Non-sticking: the body never stops\. The force is 1\.564775 times/);
  await page.fill("#in-force", "6");
  await answered(page, "Sticking: the body stops in each cycle.");
  await answered(page, "2 stops in a cycle");
  await page.fill("#in-force", "3 kN");
  await answered(page, "Stuck");
  await page.fill("#in-mass", "-3 t");
  await page.waitForFunction(() => document.getElementById("error").textContent === "mass -3 t: mass m = -3 must be > 0");
  assert.equal(await verdict(page), "");
  await page.fill("#in-mass", "");
  await page.waitForFunction(() => document.getElementById("error").textContent === "mass is missing");
  await page.fill("#in-mass", "50 t");
  await answered(page, "Stuck");
  assert.equal(await page.textContent("#error"), "");
  await closed(page);
});

test("units and kinds of input are switched", async () => {
  const page = await opened();
  const first = await page.textContent("#key");
  assert.match(first, /0\.009527638 m = 1\.905528 B/);
  await page.fill("#in-stiffness", "1000 kN/m");
  await page.fill("#in-friction", "5 kN");
  await page.fill("#in-force", "12 kN");
  await page.fill("#units", "N,mm");
  await page.waitForFunction(() => document.getElementById("key").textContent.includes("9.527638 mm"));
  await page.selectOption("select[aria-label='kind of force p₀']", "base_acceleration");
  await page.fill("#in-force", "0.03 g");
  await page.waitForFunction(() => document.getElementById("key").textContent.includes("greatest absolute displacement"));
  await page.selectOption("select[aria-label='kind of stiffness k']", "period");
  await page.fill("#in-stiffness", "1.4 s");
  await answered(page, "Non-sticking");
  await page.selectOption("#mode", "ratios");
  await page.waitForFunction(() => document.querySelectorAll("#fields .row").length === 4);
  await page.fill("#in-omega", "1.5");
  await page.fill("#in-alpha", "2.5");
  await page.fill("#in-damping_ratio", "0");
  await page.waitForFunction(() => document.getElementById("key").textContent.includes("1.632993 B"));
  await closed(page);
});

test("a machine that takes long does not hold up the next", async () => {
  const page = await opened("#mode=ratios&omega=1.5&alpha=2.5");
  const ended = Promise.any(page.workers().map((worker) => new Promise((resolve) => worker.on("close", resolve))));
  await page.fill("#in-omega", "1e-6");
  await answered(page, "Computing");
  await page.waitForFunction(() => live.running && performance.now() - live.since > 1200, null, { polling: 20 });
  await page.fill("#in-omega", "0.4");
  await page.fill("#in-alpha", "6");
  await answered(page, "2 stops in a cycle");
  await Promise.race([ended, page.waitForTimeout(20_000).then(() => assert.fail("no worker was replaced"))]);
  await closed(page);
});

test("a link holds the state", async () => {
  const page = await opened();
  await page.fill("#in-force", "6.5 kN");
  await page.fill("#in-friction", "4.5 kN");
  await page.waitForFunction(() => location.hash.includes("6.5"));
  await page.waitForTimeout(300);
  const [link, found] = [new URL(page.url()).hash, await verdict(page)];
  const other = await opened(link);
  await answered(other, found.slice(0, 40));
  assert.equal(await verdict(other), found);
  assert.equal(await other.inputValue("#in-force"), "6.5 kN");
  // A link that is opened in the page itself.
  await other.evaluate(() => (location.hash = "#mode=ratios&omega=0.1&alpha=3"));
  await answered(other, "4 stops in a cycle");
  await closed(other);
  await closed(page);
});

test("a link with nonsense is refused in words", async () => {
  const page = await (async () => {
    const context = await browser.newContext();
    const page = await context.newPage();
    await page.goto(`${address}#mode=machine&units=kN,parsec&mass=<b>x</b>&force=1e999`);
    return page;
  })();
  await page.waitForFunction(() => document.getElementById("error").textContent.includes("parsec"));
  await page.fill("#units", "kN,m");
  await page.waitForFunction(() => document.getElementById("error").textContent.includes("<b>x</b>"));
  await page.context().close();
});

test("the point of the map is dragged, and moved by the keyboard", async () => {
  const page = await opened();
  const knob = page.locator("#map .here");
  await knob.waitFor();
  await page.locator("#map svg").scrollIntoViewIfNeeded();
  const box = await page.locator("#map svg").boundingBox();
  await page.mouse.move(box.x + box.width * 0.7, box.y + box.height * 0.5);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.35, box.y + box.height * 0.7, { steps: 12 });
  await page.mouse.up();
  await answered(page, "Sticking");
  const at = await knob.getAttribute("aria-valuetext");
  // It lies where it was dropped, and the fields have its frequency.
  const place = [box.x + box.width * 0.35, box.y + box.height * 0.7];
  await page.waitForFunction(([x, y]) => {
    const box = document.querySelector("#map .here circle").getBoundingClientRect();
    return Math.abs(box.x + box.width / 2 - x) < 3 && Math.abs(box.y + box.height / 2 - y) < 3;
  }, place);
  await knob.focus();
  for (let i = 0; i < 20; i++) await page.keyboard.press("Shift+ArrowUp");
  await answered(page, "Non-sticking");
  await page.waitForFunction((at) => document.querySelector("#map .here").getAttribute("aria-valuetext") !== at, at);
  assert.ok(await page.evaluate(() => document.activeElement.classList.contains("here")));
  await closed(page);
});

test("labels and sliders scale a number", async () => {
  const page = await opened();
  const label = page.locator("label[for='in-mass']");
  const box = await label.boundingBox();
  await page.mouse.move(box.x + 10, box.y + 5);
  await page.mouse.down();
  await page.mouse.move(box.x + 160, box.y + 5, { steps: 5 });
  await page.mouse.up();
  assert.equal(await page.inputValue("#in-mass"), "500 t");
  await page.focus("[aria-label='friction r_y, scaled']");
  for (let i = 0; i < 3; i++) await page.keyboard.press("PageUp");
  assert.ok(parseFloat(await page.inputValue("#in-friction")) > 5);
  await closed(page);
});

test("the keyboard alone reaches and changes everything", async () => {
  const page = await opened();
  const seen = new Set();
  for (let i = 0; i < 80; i++) {
    await page.keyboard.press("Tab");
    seen.add(await page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute("aria-label") || document.activeElement.className.baseVal || document.activeElement.tagName));
  }
  for (const name of ["link", "theme", "mode", "units", "in-mass", "in-force", "kind of force p₀", "force p₀, scaled", "SUMMARY", "values-csv", "curve as SVG", "play", "file", "step"]) {
    assert.ok(seen.has(name), `${name} of ${[...seen].join(", ")}`);
  }
  await page.focus("#in-force");
  await page.keyboard.press("Control+A");
  await page.keyboard.type("6 kN");
  await answered(page, "Sticking");
  await page.focus("summary");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelectorAll("#all tr").length > 40);
  await closed(page);
});

test("answers and pictures are downloaded", async () => {
  const page = await opened();
  const saved = async (selector) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(selector)]);
    return [download.suggestedFilename(), readFileSync(await download.path(), "utf8")];
  };
  await page.waitForSelector("#map .here");
  const [name, values] = await saved("#values-csv");
  assert.equal(name, "stickslip-values.csv");
  assert.match(values, /^part,name,value,unit\n/);
  assert.match(values, /response,physical\.max_displacement,0\.0095276376318175\d*,m\n/);
  const [, curve] = await saved("[aria-label='curve as CSV']");
  assert.match(curve, /^frequency\[Hz\],displacement\[m\],regime,border\[m\]\n/);
  assert.ok(curve.trim().split("\n").length > 200);
  const [, map] = await saved("[aria-label='map as CSV']");
  assert.equal(map.trim().split("\n").length, 96 * 64 + 1);
  const [file, svg] = await saved("[aria-label='curve as SVG']");
  assert.equal(file, "stickslip-curve.svg");
  assert.match(svg, /^<\?xml[^]*<svg[^]*greatest displacement \(m\)[^]*<\/svg>/);
  const valid = await page.evaluate((svg) => new DOMParser().parseFromString(svg, "image/svg+xml").querySelector("parsererror") === null, svg);
  assert.ok(valid);
  await closed(page);
});

test("a wrong input leaves no number and no download of another machine", async () => {
  const page = await opened();
  await page.fill("#in-mass", "-3 t");
  await page.waitForFunction(() => document.getElementById("error").textContent !== "");
  assert.equal(await page.textContent("#key"), "");
  assert.equal(await page.getAttribute("#in-mass", "aria-invalid"), "true");
  assert.ok(await page.isDisabled("#values-csv"));
  assert.ok(await page.isDisabled("[aria-label='curve as SVG']"));
  await page.fill("#in-mass", "50 t");
  await answered(page, "Non-sticking");
  assert.ok(await page.isEnabled("#values-csv"));
  await closed(page);
});

test("the kind of an input is changed for the same machine", async () => {
  const page = await opened();
  for (const [role, kind, field] of [["stiffness k", "period", "stiffness"], ["friction r_y", "friction_coefficient", "friction"], ["damping ratio ζ", "damping", "damping_ratio"], ["force p₀", "base_displacement", "force"]]) {
    const before = await page.inputValue(`#in-${field}`);
    await page.selectOption(`select[aria-label='kind of ${role}']`, kind);
    await page.waitForFunction(([field, before]) => document.getElementById(`in-${field}`).value !== before, [field, before]);
    await page.waitForTimeout(300);
  }
  // Four digits of each are kept.
  const [omega, alpha] = (await page.textContent("#key dd")).split(", ").map(Number);
  assert.ok(Math.abs(omega / 1.404963 - 1) < 2e-3 && Math.abs(alpha / 2.4 - 1) < 2e-3, `${omega} ${alpha}`);
  await closed(page);
});

test("ratios that are edited are those of the machine", async () => {
  const page = await opened();
  await page.selectOption("#mode", "ratios");
  await page.waitForFunction(() => document.querySelectorAll("#fields .row").length === 4);
  await page.fill("#in-omega", "0.5");
  await answered(page, "2 stops in a cycle");
  await page.selectOption("#mode", "machine");
  // The key has Ω = 0.5 from before: the field shows when the machine follows.
  await page.waitForFunction(() => document.getElementById("in-frequency").value !== "1 Hz");
  assert.match(await page.inputValue("#in-frequency"), /^0\.355\d Hz$/);
  await page.waitForFunction(() => document.querySelector("#key dd")?.textContent.startsWith("0.49") || document.querySelector("#key dd")?.textContent.startsWith("0.5"));
  await closed(page);
});

test("what is not the whole answer is said", async () => {
  const page = await opened("#mode=ratios&omega=0.5&alpha=4&damping_ratio=0&x0=3");
  await page.waitForFunction(() => document.getElementById("notes").textContent.includes("form a family"));
  assert.equal(await page.textContent("#note"), "Not used from the link: x0.");
  assert.match(await page.textContent("#key"), /displacement from-5\.66\d* Bto5\.0\d* B|displacement from/);
  await page.evaluate(() => (location.hash = "#mode=machine&units=kN,m&mass=50+t&stiffness=1000&friction=5&force=12&frequency=1+Hz&mean_force=3"));
  await page.waitForFunction(() => document.getElementById("notes").textContent === "Displacements are measured from the mean displacement of 0.003 m.");
  await page.evaluate(() => (location.hash = "#mode=ratios&omega=0.3333&alpha=200"));
  await page.waitForFunction(() => /68\.57039 r_y to 12636\.5 r_y/.test(document.getElementById("design").textContent));
  await closed(page);
});

test("static friction shows the limits of several starts", async () => {
  const page = await opened("#mode=ratios&omega=0.5&alpha=4&damping_ratio=0.02&static_friction_ratio=1.3");
  await page.waitForFunction(() => document.querySelectorAll("#limits li").length === 2);
  assert.match(await page.textContent("#limits"), /mirror image/);
  await page.fill("#in-static_friction_ratio", "1");
  await page.waitForFunction(() => document.getElementById("limits-section").hidden);
  await closed(page);
});

test("a dropped record plays and gives its spectrum", async () => {
  const page = await opened();
  const text = `time[s],acceleration[g]\n${Array.from({ length: 500 }, (_, i) => `${(i * 0.02).toFixed(2)},${(0.3 * Math.sin(i * 0.15) * Math.exp(-i / 200)).toFixed(6)}`).join("\n")}\n`;
  const file = join(folder, "shake.csv");
  writeFileSync(file, text);
  await page.setInputFiles("#file", file);
  await page.waitForFunction(() => document.querySelectorAll("#record-values dt").length >= 20);
  await page.waitForFunction(() => document.querySelectorAll("#spectrum path").length >= 2);
  await page.click("#play-record");
  await page.waitForFunction(() => Number(document.querySelector("#shaken circle").getAttribute("cx")) > 70);
  writeFileSync(file, "time[s],acceleration[g]\n0,1\n0.1,x\n");
  await page.setInputFiles("#file", file);
  await page.waitForFunction(() => document.getElementById("record-error").textContent.includes("shake.csv line 3"));
  assert.ok(await page.evaluate(() => document.getElementById("record-shown").hidden));
  await closed(page);
});

test("axe finds nothing serious, in light and dark, wide and narrow", async () => {
  const axe = readFileSync(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
  for (const [width, dark] of [[1440, false], [1440, true], [390, false]]) {
    const page = await opened("#mode=ratios&omega=0.5&alpha=4&damping_ratio=0.02&static_friction_ratio=1.3", { width });
    if (dark) await page.click("#theme");
    await page.click("summary");
    await page.waitForTimeout(600);
    await page.evaluate(axe);
    const found = await page.evaluate(async () => (await axe.run()).violations.map(({ id, impact, nodes }) => `${impact} ${id}: ${nodes[0].html.slice(0, 120)}`));
    assert.deepEqual(found.filter((text) => /^(serious|critical)/.test(text)), [], found.join("\n"));
    await closed(page);
  }
});

test("phones and wide screens show it without sideways scrolling", async () => {
  for (const [name, width, height] of [["wide", 1440, 1000], ["middle", 900, 1000], ["phone", 390, 800]]) {
    const page = await opened("", { width, height });
    await page.waitForSelector("#map .here");
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), name);
    if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `${name}.png`), fullPage: true });
    await closed(page);
  }
});
