// The page in Chromium, as a person uses it, opened from its file. $CHROMIUM names the browser (/usr/bin/chromium), and
// $SCREENSHOTS a folder for pictures at three sizes.
import assert from "node:assert/strict";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { chromium } from "playwright-core";
import { machines, random } from "./machines.mjs";
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

// The verdict with all its digits.
const verdict = (page) => page.getAttribute("#verdict", "title");
const answered = (page, what) => page.waitForFunction((text) => document.getElementById("verdict").textContent.includes(text), what);
// Every question of the inputs has its answer, and the page shows it. The map, which may take long, is not waited for.
const quiet = (page) => page.waitForFunction(() => [live, slow].every((asker) => !asker.running && asker.waiting.size === 0) && drawn.size === 0 && (document.body.classList.contains("failed") || (isOfNow(shown.answer) && still.asked === keyOf(question("")))));
// Ω and α with all their digits.
const titles = (page) => page.evaluate(() => [...document.querySelectorAll("#key dd")].slice(0, 2).map((own) => own.title));
// The machine as it is typed.
const machine = (page) => page.evaluate(() => JSON.stringify([state, chosen, [...document.querySelectorAll("[data-input]")].map((typed) => typed.value)]));

// A page that has answered; every request that leaves it and every fault in it fails the test.
async function opened(link = "", { width = 1440, height = 1000, ...more } = {}) {
  const context = await browser.newContext({ viewport: { width, height }, acceptDownloads: true, ...more });
  // A limit for a hang: beside much other work a whole map has taken more than two minutes.
  context.setDefaultTimeout(600_000);
  const page = await context.newPage();
  page.faults = [];
  page.on("pageerror", (error) => page.faults.push(error.message));
  page.on("console", (message) => message.type() === "error" && page.faults.push(message.text()));
  page.on("request", (request) => /^(file|blob|data):/.test(request.url()) || page.faults.push(request.url()));
  await page.goto(address + link);
  await page.waitForFunction(() => document.querySelectorAll("#key dt").length > 0 || document.getElementById("system-verdict").textContent !== "");
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
  assert.match(await page.textContent("#key"), /^Ω, frequency \/ natural frequency1\.405α, force \/ friction2\.4peak/);
  await page.fill("#in-force", "6");
  await answered(page, "Sticking: the body stops in each cycle.");
  await answered(page, "2 stops in a cycle");
  await page.fill("#in-force", "3 kN");
  await answered(page, "Stuck");
  await page.fill("#in-mass", "-3 t");
  await page.waitForFunction(() => document.getElementById("error").textContent === "mass -3 t: mass m = -3 must be > 0");
  assert.equal(await page.textContent("#verdict"), "");
  await page.fill("#in-mass", "");
  await page.waitForFunction(() => document.getElementById("error").textContent === "mass is missing");
  await page.fill("#in-mass", "50 t");
  await answered(page, "Stuck");
  assert.equal(await page.textContent("#error"), "");
  await closed(page);
});

test("units and kinds of input are switched", async () => {
  const page = await opened();
  assert.match(await page.textContent("#key"), /peak displacement9\.528 mm/);
  assert.match(await page.getAttribute("#key dd:nth-of-type(3)", "title"), /^0\.0095276376318175\d* m = 1\.9055275263635\d* B$/);
  await page.fill("#in-stiffness", "1000 kN/m");
  await page.fill("#in-friction", "5 kN");
  await page.fill("#in-force", "12 kN");
  await page.fill("#units", "N,mm");
  await page.waitForFunction(() => document.getElementById("key").textContent.includes("9.528 mm"));
  await page.selectOption("select[aria-label='kind of force p₀']", "base_acceleration");
  await page.fill("#in-force", "0.03 g");
  await page.waitForFunction(() => document.getElementById("key").textContent.includes("peak absolute displacement"));
  await page.selectOption("select[aria-label='kind of stiffness k']", "period");
  await page.fill("#in-stiffness", "1.4 s");
  await answered(page, "Non-sticking");
  await page.selectOption("#mode", "ratios");
  await page.waitForFunction(() => document.querySelectorAll("#fields .row").length === 3);
  await page.fill("#in-omega", "1.5");
  await page.fill("#in-alpha", "2.5");
  await page.fill("#in-damping_ratio", "0");
  await page.waitForFunction(() => document.getElementById("key").textContent.includes("1.633 B"));
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

test("a question that takes long is answered when one of another kind comes meanwhile", async () => {
  const page = await opened("#mode=ratios&omega=0.3&alpha=4&static_friction_ratio=1.2");
  await page.evaluate(() => {
    window.order = [];
    const done = (kind) => () => order.push(kind);
    slow.worker.terminate();
    slow.waiting.clear();
    slow.start();
    slow.ask("first", question("limits", { count: 64 }), done("first"));
    slow.since -= 2 * PATIENCE;
    slow.ask("second", question("design"), done("second"));
  });
  await page.waitForFunction(() => order.length === 2);
  assert.deepEqual(await page.evaluate(() => order.sort()), ["first", "second"]);
  await closed(page);
});

test("a link holds the state", async () => {
  const page = await opened();
  await page.fill("#in-force", "6.5 kN");
  await page.fill("#in-friction", "4.5 kN");
  await page.waitForFunction(() => location.hash.includes("6.5"));
  await quiet(page);
  const [link, found] = [new URL(page.url()).hash, await verdict(page)];
  const other = await opened(link);
  await answered(other, found.slice(0, 40));
  assert.equal(await verdict(other), found);
  assert.equal(await other.inputValue("#in-force"), "6.5 kN");
  // A link that is opened in the page itself.
  await other.evaluate(() => (location.hash = "#mode=ratios&omega=0.1&alpha=3"));
  await answered(other, "4 stops in a cycle");
  // One that is opened just before the page writes its own address.
  await other.evaluate(() => {
    location.hash = "#mode=ratios&omega=0.5&alpha=6";
    still();
  });
  await answered(other, "Non-sticking");
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
  const knob = page.locator("#map .knob");
  await knob.waitFor();
  await page.locator("#map svg").scrollIntoViewIfNeeded();
  // The map stays where it is whether or not the line above it says something.
  const under = (text) => page.evaluate((text) => {
    $("map-note").textContent = text;
    return charts.map.svg.getBoundingClientRect().toJSON();
  }, text);
  const box = await under("");
  assert.deepEqual(await under("Computing …"), box);
  await page.mouse.move(box.x + box.width * 0.7, box.y + box.height * 0.5);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.35, box.y + box.height * 0.7, { steps: 12 });
  await page.mouse.up();
  await answered(page, "Sticking");
  const at = await knob.getAttribute("aria-valuetext");
  // It lies where it was dropped, and the fields have its frequency.
  const place = [box.x + box.width * 0.35, box.y + box.height * 0.7];
  await page.waitForFunction(([x, y]) => {
    const box = document.querySelector("#map .knob circle").getBoundingClientRect();
    return Math.abs(box.x + box.width / 2 - x) < 3 && Math.abs(box.y + box.height / 2 - y) < 3;
  }, place);
  await knob.focus();
  for (let i = 0; i < 20; i++) await page.keyboard.press("Shift+ArrowUp");
  await answered(page, "Non-sticking");
  await page.waitForFunction((at) => document.querySelector("#map .knob").getAttribute("aria-valuetext") !== at, at);
  assert.ok(await page.evaluate(() => document.activeElement.classList.contains("knob")));
  await closed(page);
});

test("sliders have a scale of their own, with their ends and a spoken value", async () => {
  const page = await opened();
  const mass = page.locator("[aria-label='mass m, slider']");
  assert.equal(await mass.getAttribute("aria-valuetext"), "50 t");
  const ends = () => page.locator("#in-mass + .slider .ends span").allTextContents();
  assert.deepEqual(await ends(), ["1 t", "10000 t"]);
  const box = await page.locator("#in-mass + .slider input").boundingBox();
  // A quarter of four decades.
  await page.mouse.click(box.x + 8 + (box.width - 16) / 4, box.y + box.height / 2);
  const text = await page.inputValue("#in-mass");
  assert.match(text, /^\d+(\.\d+)? t$/);
  assert.ok(Math.abs(parseFloat(text) / 10 - 1) < 0.05, text);
  assert.equal(await mass.getAttribute("aria-valuetext"), text);
  assert.deepEqual(await ends(), ["1 t", "10000 t"]);
  await page.focus("[aria-label='friction r_y, slider']");
  for (let i = 0; i < 3; i++) await page.keyboard.press("PageUp");
  assert.ok(parseFloat(await page.inputValue("#in-friction")) > 5);
  // The least place of an input that may be 0 is 0.
  await page.keyboard.press("Home");
  assert.equal(await page.inputValue("#in-friction"), "0 kN");
  await answered(page, "Without friction: a linear oscillator");
  await page.click("#undo");
  assert.equal(await page.inputValue("#in-friction"), "5 kN");
  await page.click("#undo");
  assert.equal(await page.inputValue("#in-mass"), "50 t");
  await page.click("#redo");
  assert.equal(await page.inputValue("#in-mass"), text);
  await page.click("#reset");
  assert.equal(await page.inputValue("#in-mass"), "50 t");
  await closed(page);
});

test("a typed text stays as it was typed", async () => {
  const page = await opened();
  const before = await machine(page);
  for (const text of ["1,200 kg", "1.2e3 kg", "0.05e6kg", "50 000 kg", "50 t "]) {
    await page.fill("#in-mass", text);
    await page.locator("#in-mass").blur();
    await quiet(page);
    assert.equal(await page.inputValue("#in-mass"), text);
  }
  // A comma is not guessed at, and its slider waits.
  await page.fill("#in-mass", "1,200 kg");
  await page.waitForFunction(() => document.getElementById("error").textContent.startsWith("mass 1,200 kg: must be a number"));
  assert.ok(await page.isDisabled("[aria-label='mass m, slider']"));
  await page.fill("#in-mass", "50 t");
  await answered(page, "Non-sticking");
  assert.equal(await machine(page), before);
  // Each kind of an input and back gives the same text.
  for (const [role, kinds] of [["stiffness k", ["period", "pendulum_radius"]], ["friction r_y", ["friction_coefficient"]], ["damping ratio ζ", ["damping"]], ["force p₀", ["base_acceleration", "unbalance"]]]) {
    const own = page.locator(`select[aria-label='kind of ${role}']`);
    const first = await own.inputValue();
    for (const kind of kinds) {
      const text = await machine(page);
      await own.selectOption(kind);
      await quiet(page);
      assert.notEqual(await machine(page), text);
      await own.selectOption(first);
      await quiet(page);
      assert.equal(JSON.parse(await machine(page))[2].join(), JSON.parse(text)[2].join());
    }
  }
  const texts = JSON.parse(await machine(page))[2].join();
  await page.selectOption("#mode", "ratios");
  await quiet(page);
  await page.selectOption("#mode", "machine");
  await quiet(page);
  assert.equal(JSON.parse(await machine(page))[2].join(), texts);
  await closed(page);
});

test("no swipe, no scroll and no touch in passing changes the machine", async (t) => {
  const next = random(5);
  let [swipes, taps, scrolls] = [0, 0, 0];
  for (const link of ["", "#mode=ratios&omega=0.5&alpha=4&damping_ratio=0.02&static_friction_ratio=1.3"]) {
    const page = await opened(link, { width: 390, height: 844, hasTouch: true, isMobile: true });
    await page.waitForSelector("#map .knob");
    const session = await page.context().newCDPSession(page);
    const touch = (type, x, y) => session.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y }] });
    const before = await machine(page);
    for (let i = 0; i < Number(process.env.STICKSLIP_SWIPES || 100) / 2; i++) {
      const top = await page.evaluate((part) => {
        scrollTo(0, part * (document.documentElement.scrollHeight - innerHeight));
        return scrollY;
      }, next());
      const at = [10 + 370 * next(), 10 + 770 * next()];
      const [angle, length] = [2 * Math.PI * next(), 40 + 300 * next()];
      // A third of them begin on a slider, on the map or on a label.
      const places = await page.evaluate(() => [...document.querySelectorAll(".slider, .slider input, #map svg, #map .knob, #curve svg, .row label, legend")].map((own) => own.getBoundingClientRect()).filter((box) => box.top > 0 && box.bottom < innerHeight - 50).map((box) => [box.left, box.top, box.width, box.height]));
      const place = i % 3 === 0 && places.length ? places[Math.floor(next() * places.length)] : null;
      const [x, y] = place ? [place[0] + place[2] * next(), place[1] + place[3] * next()] : at;
      await touch("touchStart", x, y);
      for (let step = 1; step <= 6; step++) await touch("touchMove", Math.min(388, Math.max(1, x + (length * step * Math.cos(angle)) / 6)), Math.min(842, Math.max(1, y + (length * step * Math.sin(angle)) / 6)));
      await touch("touchEnd");
      swipes += 1;
      const now = await machine(page);
      assert.equal(now, before, `swipe ${i} from ${x} ${y} at ${top}, ${angle}`);
      if (i % 10 === 0) {
        await page.mouse.move(x, y);
        await page.mouse.wheel(0, 300 * (next() - 0.5));
        scrolls += 1;
      }
    }
    // A touch of the map beside its point, of its key and of its margins.
    await page.locator("#map svg").scrollIntoViewIfNeeded();
    const box = await page.locator("#map svg").boundingBox();
    for (const [x, y] of [[0.5, 0.04], [0.02, 0.5], [0.6, 0.98], [0.9, 0.3], [0.4, 0.8]]) {
      await page.touchscreen.tap(box.x + box.width * x, Math.min(780, box.y + box.height * y));
      taps += 1;
    }
    assert.equal(await machine(page), before);
    // A finger that rests on a thumb drags it.
    await page.locator(link ? "[aria-label='α = p₀/r_y, slider']" : "[aria-label='mass m, slider']").scrollIntoViewIfNeeded();
    const slider = page.locator(link ? "#in-alpha + .slider input" : "#in-mass + .slider input");
    const track = await slider.boundingBox();
    const thumb = track.x + 8 + ((track.width - 16) * Number(await slider.inputValue())) / 1000;
    await touch("touchStart", thumb, track.y + track.height / 2);
    await page.waitForTimeout(300);
    for (let step = 1; step <= 5; step++) await touch("touchMove", thumb + 8 * step, track.y + track.height / 2);
    await touch("touchEnd");
    await quiet(page);
    assert.notEqual(await machine(page), before);
    await closed(page);
  }
  t.diagnostic(`${swipes} swipes, ${scrolls} scrolls and ${taps} touches`);
});

test("a mouse in the margins and the key of the map moves nothing", async () => {
  const page = await opened();
  await page.waitForSelector("#map .knob");
  const before = await machine(page);
  const box = await page.locator("#map svg").boundingBox();
  for (const [x, y] of [[0.5, 0.03], [0.01, 0.5], [0.6, 0.99], [0.995, 0.4]]) await page.mouse.click(box.x + box.width * x, box.y + box.height * y);
  await page.locator("label[for='in-mass']").click();
  assert.equal(await machine(page), before);
  await closed(page);
});

test("the keyboard alone reaches and changes everything", async () => {
  const page = await opened();
  const seen = new Set();
  for (let i = 0; i < 110; i++) {
    await page.keyboard.press("Tab");
    seen.add(await page.evaluate(() => document.activeElement.id || document.activeElement.getAttribute("aria-label") || document.activeElement.className.baseVal || document.activeElement.tagName));
  }
  for (const name of ["link", "theme", "mode", "units", "in-mass", "in-force", "kind of force p₀", "force p₀, slider", "SUMMARY", "values-csv", "curve as SVG", "play", "file", "sample", "Point on the map: the arrow keys change Ω and α"]) {
    assert.ok(seen.has(name), `${name} of ${[...seen].join(", ")}`);
  }
  await page.focus("#in-force");
  await page.keyboard.press("Control+A");
  await page.keyboard.type("6 kN");
  await answered(page, "Sticking");
  await quiet(page);
  await page.focus("#answer summary");
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
  // The map has come to its end.
  await page.waitForFunction(() => shown.map?.isFinal);
  const [name, values] = await saved("#values-csv");
  assert.equal(name, "stickslip-values.csv");
  assert.match(values, /^part,name,value,unit\n/);
  assert.match(values, /response,physical\.max_displacement,0\.0095276376318175\d*,m\n/);
  const [, curve] = await saved("[aria-label='curve as CSV']");
  assert.match(curve, /^frequency\[Hz\],displacement\[m\],regime,border\[m\],point\n/);
  assert.ok(curve.trim().split("\n").length > 200);
  const [, map] = await saved("[aria-label='map as CSV']");
  assert.equal(map.trim().split("\n").length, 288 * 192 + 1);
  const [file, svg] = await saved("[aria-label='curve as SVG']");
  assert.equal(file, "stickslip-curve.svg");
  assert.match(svg, /^<\?xml[^]*<svg[^]*peak displacement \(mm\)[^]*<\/svg>/);
  const valid = await page.evaluate((svg) => new DOMParser().parseFromString(svg, "image/svg+xml").querySelector("parsererror") === null, svg);
  assert.ok(valid);
  // No dot that plays, and black on white from the dark theme, too.
  await page.click("#theme");
  const [whole, motion] = await saved("[aria-label='motion as SVG']");
  assert.equal(whole, "stickslip-motion.svg");
  assert.doesNotMatch(motion, /class="cursor"|<circle/);
  assert.match(motion, /fill="#ffffff"/);
  // The five pictures of the motion are one file.
  for (const words of ["force (kN)", "displacement (mm)", "velocity (mm/s)", "friction (kN)"]) assert.ok(motion.includes(words), words);
  assert.equal(motion.match(/<svg/g).length, 6);
  // As an image it is as large as that twice, white at its corner and not empty.
  for (const of of ["motion", "curve", "map"]) {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(`[aria-label='${of} as PNG']`)]);
    assert.equal(download.suggestedFilename(), `stickslip-${of}.png`);
    const bytes = readFileSync(await download.path()).toString("base64");
    const { width, height, corner, colours } = await page.evaluate(async (bytes) => {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${bytes}`)).blob());
      const context = Object.assign(document.createElement("canvas"), { width: image.width, height: image.height }).getContext("2d");
      context.drawImage(image, 0, 0);
      const pixels = new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer);
      return { width: image.width, height: image.height, corner: pixels[0], colours: new Set(pixels).size };
    }, bytes);
    const due = await page.evaluate((of) => FILES[of][0].map((name) => charts[name].svg).map((svg) => [Number(svg.getAttribute("width")), Number(svg.getAttribute("height"))]), of);
    assert.deepEqual([width, height], [2 * Math.max(...due.map(([x]) => x)), 2 * due.reduce((sum, [, y]) => sum + y, 0)]);
    assert.equal(corner, 0xffffffff);
    assert.ok(colours > 10, `${of} ${colours}`);
  }
  assert.equal(await page.getAttribute("html", "data-theme"), "dark");
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
    await quiet(page);
  }
  // Seven digits of each are kept.
  const [omega, alpha] = (await titles(page)).map(Number);
  assert.ok(Math.abs(omega / 1.4049629462081452 - 1) < 1e-6 && Math.abs(alpha / 2.4 - 1) < 1e-6, `${omega} ${alpha}`);
  await closed(page);
});

test("ratios that are edited are those of the machine", async () => {
  const page = await opened();
  await page.selectOption("#mode", "ratios");
  await page.waitForFunction(() => document.querySelectorAll("#fields .row").length === 3);
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
  const page = await opened("#mode=ratios&omega=0.5&alpha=4&damping_ratio=0&wheel=3");
  await page.waitForFunction(() => document.getElementById("notes").textContent.includes("form a family"));
  assert.equal(await page.textContent("#note"), "Not used from the link: wheel.");
  assert.match(await page.textContent("#key"), /displacement from-5\.66\d* Bto5\.0\d* B|displacement from/);
  await page.evaluate(() => (location.hash = "#mode=machine&units=kN,m&mass=50+t&stiffness=1000&friction=5&force=12&frequency=1+Hz&mean_force=3"));
  await page.waitForFunction(() => document.getElementById("notes").textContent === "Displacements are measured from the mean displacement of 0.003 m.");
  await page.evaluate(() => (location.hash = "#mode=ratios&omega=0.3333&alpha=200"));
  await page.waitForFunction(() => /68\.57 r_y to 12640 r_y/.test(document.getElementById("design").textContent));
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
  await page.waitForFunction(() => document.querySelectorAll("#record-values dt").length >= 8);
  await page.waitForFunction(() => document.querySelectorAll("#spectrum path").length >= 2);
  await page.click("#play-record");
  await page.waitForFunction(() => Number(document.querySelector("#shaken circle").getAttribute("cx")) > 90);
  await page.click("#play-record");
  const at = await page.getAttribute("#shaken circle", "cx");
  await page.waitForTimeout(300);
  assert.equal(await page.getAttribute("#shaken circle", "cx"), at);
  assert.match(await page.textContent("#record-preview"), /^time\[s\],acceleration\[g\]\n0\.00,/);
  assert.match(await page.textContent("#record-read"), /500 samples of acceleration 0\.02 s apart.*separated by commas/);
  writeFileSync(file, "time[s],acceleration[g]\n0,1\n0.1,x\n");
  await page.setInputFiles("#file", file);
  await page.waitForFunction(() => document.getElementById("record-error").textContent.includes("shake.csv line 3"));
  assert.match(await page.textContent("#record-error"), /x/);
  assert.ok(await page.evaluate(() => document.getElementById("record-shown").hidden));
  await closed(page);
});

test("records of other layouts are read, by column and unit where the file states none", async () => {
  const page = await opened();
  const file = join(folder, "layout.txt");
  const rows = (sign, times = true) => Array.from({ length: 300 }, (_, i) => [...(times ? [(i * 0.02).toFixed(2)] : []), (i % 7).toFixed(1), (2 * Math.sin(i * 0.15)).toFixed(5)].join(sign)).join("\n");
  const shown = () => page.waitForFunction(() => !document.getElementById("record-shown").hidden && document.getElementById("record-error").textContent === "");
  writeFileSync(file, `Time (s);Humidity;Acc (m/s^2)\n${rows(";")}\n`);
  await page.setInputFiles("#file", file);
  await shown();
  assert.match(await page.textContent("#record-read"), /semicolons.*not used: Humidity/);
  assert.deepEqual(await page.locator("#columns option").allTextContents(), ["Acc", "Humidity"]);
  writeFileSync(file, `${rows("\t", false)}\n`);
  await page.setInputFiles("#file", file);
  await page.waitForFunction(() => document.getElementById("record-error").textContent.includes("the field"));
  await page.fill("#step", "0.02s");
  await page.fill("#column", "2");
  await page.fill("#record-units", "m/s^2");
  await shown();
  assert.match(await page.textContent("#record-read"), /300 samples/);
  // A file that is no text stays within the page.
  writeFileSync(file, Buffer.from(Array.from({ length: 4000 }, (_, i) => (i * 7919) % 256)));
  await page.setInputFiles("#file", file);
  await page.waitForFunction(() => document.getElementById("record-error").textContent.includes("layout.txt"));
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  // The sample plays to its end and begins anew.
  for (const id of ["step", "column", "record-units"]) await page.fill(`#${id}`, "");
  await page.click("#sample");
  await shown();
  assert.match(await page.textContent("#record-verdict"), /slides 35 times, and comes to rest/);
  await closed(page);
});

test("a machine that does not move has a picture that says so", async () => {
  const page = await opened("#mode=machine&units=kN,m&mass=50+t&stiffness=1000&friction=5&force=3&frequency=1+Hz");
  await page.waitForFunction(() => /load of at most 3 kN stays below the friction that holds it, 5 kN/.test(document.getElementById("motion-note").textContent));
  assert.match(await page.textContent("#friction"), /the friction holds up to/);
  assert.match(await page.textContent("#curve-note"), /does not move at this frequency|outside|stuck/);
  assert.equal(await page.textContent("#bar-text"), "Stuck");
  // A point beyond the axes is said, too; here the curve's axis grows to it.
  await page.evaluate(() => (location.hash = "#mode=ratios&omega=30&alpha=4"));
  await page.waitForFunction(() => document.querySelector("#curve .here") || document.getElementById("curve-note").textContent.includes("below this axis"));
  await closed(page);
});

test("the curve has the point in its range, however late the answers are", async () => {
  for (const [late, of] of [[400, ["answer"]], [1500, ["curve"]], [0, []]]) {
    const page = await opened();
    await page.waitForFunction(() => shown.curve?.point.includes("peak") && !live.running && !slow.running);
    await page.evaluate(([late, of]) => {
      window.delivered = [];
      for (const { worker } of [live, slow]) {
        const { onmessage } = worker;
        worker.onmessage = (event) => setTimeout(() => {
          onmessage(event);
          delivered.push(`${worker === live.worker ? "live" : "slow"} ${event.data.id}`);
        }, worker === live.worker && of.includes(event.data.id) ? late : 0);
      }
      location.hash = "#mode=ratios&omega=30&alpha=4";
    }, [late, of]);
    // The answer, the motion and the curve are there and drawn, and the curve with its peaks.
    await page.waitForFunction(() => ["live answer", "live motion", "live curve", "slow curve"].every((name) => delivered.includes(name)));
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
    const found = await page.evaluate(() => [shown.answer.omega, shown.curve.frequency.length > 240, shown.curve.frequency.at(-1), $("curve-note").textContent.includes("outside")]);
    assert.deepEqual(found, [30, true, 45, false], `${of} ${late} ms late`);
    await closed(page);
  }
});

test("undo, reset, embed, link and caption are those of the machine that is seen", async () => {
  const page = await opened();
  await page.evaluate(() => {
    window.copies = [];
    Object.defineProperty(navigator, "clipboard", { value: { writeText: async (text) => copies.push(text) } });
  });
  const copy = async (id) => {
    await page.click(`#${id}`);
    return page.evaluate(() => copies.at(-1));
  };
  const caption = () => page.textContent("#caption");
  await page.fill("#in-mass", "40 t");
  await page.locator("#in-mass").blur();
  const one = await machine(page);
  const words = await caption();
  await page.click("#tab-two");
  assert.notEqual(await caption(), words);
  assert.ok(await page.isDisabled("#undo"));
  await page.fill("#two-friction", "300 N");
  await page.locator("#two-friction").blur();
  await page.fill("#two-k1", "250 N/mm");
  await page.locator("#two-k1").blur();
  for (const [id, hidden] of [["link", ""], ["embed", "embed=1&amp;"]]) assert.match(await copy(id), new RegExp(`stickslip.html#system=1&(amp;)?${hidden}k1=250`), id);
  const field = (name) => page.inputValue(`#two-${name}`);
  await page.click("#undo");
  assert.deepEqual([await field("k1"), await field("friction")], ["200 N/mm", "300 N"]);
  await page.click("#tab-two");
  await page.keyboard.press("Control+z");
  assert.deepEqual([await field("k1"), await field("friction")], ["200 N/mm", "450 N"]);
  assert.ok(await page.isDisabled("#undo"));
  await page.click("#redo");
  await page.click("#redo");
  assert.deepEqual([await field("k1"), await field("friction")], ["250 N/mm", "300 N"]);
  await page.click("#reset");
  assert.deepEqual([await field("k1"), await field("friction")], ["200 N/mm", "450 N"]);
  await page.click("#undo");
  assert.equal(await field("friction"), "300 N");
  // The example is a step, too, and what was done here leaves the other machine as it was.
  await page.click("#system-presets button:nth-of-type(2)");
  await page.click("#undo");
  assert.equal(await field("friction"), "300 N");
  await page.click("#tab-one");
  assert.equal(await machine(page), one);
  assert.equal(await caption(), words);
  assert.match(await copy("embed"), /#mode=machine&amp;.*mass=40\+t.*embed=1/);
  await page.click("#undo");
  assert.equal(await page.inputValue("#in-mass"), "50 t");
  await closed(page);
  // The embedded page stays one when it is loaded again.
  const embedded = await opened("#system=1&embed=1&friction=300+N");
  await embedded.waitForFunction(() => document.getElementById("system-verdict").textContent !== "");
  assert.match(new URL(embedded.url()).hash, /embed=1/);
  for (const id of ["system-presets-row", "two-units", "undo"]) assert.ok(!(await embedded.locator(`#${id}`).isVisible()), id);
  assert.ok(await embedded.locator("#two-body svg").isVisible());
  await closed(embedded);
});

test("the caption of an example goes with an edit of its machine", async () => {
  const page = await opened();
  for (const edit of [() => page.fill("#in-mass", "900 kg"), () => page.click("#undo"), () => page.click("#reset"), () => page.evaluate(() => (location.hash = "#mode=ratios&omega=2&alpha=4"))]) {
    await page.click("[data-preset=isolator]");
    assert.match(await page.textContent("#about"), /^An 800 kg unit/);
    await page.waitForFunction(() => shown.answer?.inputs.mass === "800 kg");
    await page.check("#from-start");
    await page.uncheck("#from-start");
    assert.match(await page.textContent("#about"), /^An 800 kg unit/);
    await edit();
    await page.waitForFunction(() => document.getElementById("about").textContent === "");
  }
  await closed(page);
});

test("no answer of another record or machine is shown as that of the present one", async () => {
  const page = await opened();
  await page.click("#sample");
  await page.waitForFunction(() => isRecordOfNow());
  const panel = () => page.evaluate(() => [$("record-shown").hidden, $("record-shown").classList.contains("stale"), isRecordOfNow()]);
  assert.deepEqual(await panel(), [false, false, true]);
  // Answers to records wait until they are let through.
  await page.evaluate(() => {
    window.held = [];
    const { onmessage } = slow.worker;
    slow.worker.onmessage = (event) => (/record|spectrum/.test(event.data.id) ? held.push(() => onmessage(event)) : onmessage(event));
    window.release = () => held.shift()();
  });
  const waits = () => page.waitForFunction(() => held.length === 1);
  const file = (name, count) => ({ name, mimeType: "text/csv", buffer: Buffer.from(`time[s],acceleration[g]\n${Array.from({ length: count }, (_, i) => `${(i * 0.01).toFixed(2)},${(0.3 * Math.sin(i * 0.1)).toFixed(6)}`).join("\n")}\n`) });
  await page.setInputFiles("#file", file("first.csv", 300));
  await page.waitForFunction(() => /^Reading first\.csv, .* MB …$/.test($("record-read").textContent));
  await waits();
  assert.deepEqual((await panel())[0], true);
  await page.setInputFiles("#file", file("second.csv", 400));
  await page.waitForFunction(() => /^Reading second\.csv/.test($("record-read").textContent) && slow.waiting.size >= 2);
  // The first record's answers are dropped; the second's are shown when they are there.
  await page.evaluate(() => release());
  await waits();
  assert.equal((await panel())[0], true);
  await page.evaluate(() => release());
  await page.waitForFunction(() => /^Record .* 400 samples/.test($("record-read").textContent));
  assert.deepEqual(await panel(), [false, false, false]);
  assert.equal(await page.evaluate(() => charts.spectrum.svg.childElementCount), 0);
  // The spectrum comes in rounds.
  const all = async () => {
    while (!(await page.evaluate(() => isRecordOfNow()))) {
      await page.waitForFunction(() => held.length === 1 || isRecordOfNow());
      await page.evaluate(() => held.length && release());
    }
  };
  await all();
  assert.deepEqual(await panel(), [false, false, true]);
  // Of another machine it is dimmed at once, gives no file, and says that it is computed.
  const verdict = await page.textContent("#record-verdict");
  await page.fill("#in-friction", "0.5 kN");
  assert.deepEqual(await panel(), [false, true, false]);
  assert.ok(await page.isDisabled("[aria-label='record as CSV']"));
  await page.waitForFunction(() => $("record-verdict").textContent === "Computing …");
  await all();
  assert.deepEqual(await panel(), [false, false, true]);
  assert.notEqual(await page.textContent("#record-verdict"), verdict);
  await closed(page);
});

test("a long record is drawn with its extremes, and its file has all states", async () => {
  const page = await opened();
  const count = 60_000;
  const next = random(3);
  const value = (i) => 0.2 * Math.sin(i * 0.03) * (1 + Math.sin(i * 0.0007)) + (i % 9973 === 5000 ? 3 : 0) + 0.01 * next();
  writeFileSync(join(folder, "long.csv"), `time[s],acceleration[g]\n${Array.from({ length: count }, (_, i) => `${(i * 0.01).toFixed(2)},${value(i).toFixed(6)}`).join("\n")}\n`);
  await page.setInputFiles("#file", join(folder, "long.csv"));
  await page.waitForFunction(() => isRecordOfNow() && /60000 samples/.test($("record-read").textContent));
  const found = await page.evaluate(() => ({ drawn: shown.record.time.length, count: shown.record.count, most: Math.max(...shown.record.displacement), least: Math.min(...shown.record.displacement), speed: Math.max(...shown.record.velocity), force: Math.max(...shown.record.force.map(Math.abs)), load: Math.max(...shown.record.load.value), loads: shown.record.load.value.length, values: Object.fromEntries(shown.record.values.map(({ name, value }) => [name, value])) }));
  assert.ok(found.count > count && found.drawn < 12_000 && found.loads < 12_000, JSON.stringify(found));
  assert.match(await page.textContent("#record-drawn"), new RegExp(`show ${found.drawn} of ${found.count} states`));
  const [download] = await Promise.all([page.waitForEvent("download"), page.click("[aria-label='record as CSV']")]);
  const [head, ...rows] = readFileSync(await download.path(), "utf8").trim().split("\n");
  assert.equal(head, "time[s],displacement[m],velocity[m/s],transmitted_force[kN]");
  assert.equal(rows.length, found.count);
  const column = (place) => rows.map((row) => Number(row.split(",")[place]));
  const largest = (list) => list.reduce((most, x) => Math.max(most, x), -Infinity);
  // The extremes of all states are drawn, and so is that of the load.
  assert.deepEqual([found.most, -found.least, found.speed, found.force], [largest(column(1)), largest(column(1).map((x) => -x)), largest(column(2)), largest(column(3).map(Math.abs))]);
  assert.ok(found.load > 3 * 9.8, String(found.load));
  await closed(page);
});

test("a page that plays is printed in the light theme, and shows its own again", async () => {
  for (const [link, texts] of [["", "#body svg text"], ["#system=1", "#two-body svg text:last-of-type"]]) {
    const page = await opened(link, { colorScheme: "dark" });
    await page.waitForFunction(() => playing && (tab === "two" ? twoAnswer : motion));
    const look = (event) => page.evaluate(([texts, event]) => {
      dispatchEvent(new Event(event));
      const { text, paper } = palette();
      return [document.documentElement.dataset.theme, [...document.querySelectorAll(texts)].every((own) => !own.textContent || [text, paper].includes(own.getAttribute("fill")))];
    }, [texts, event]);
    assert.deepEqual(await look("beforeprint"), ["light", true]);
    // Charts have the width of paper, and nothing of the hidden machine is printed.
    const widths = await page.evaluate(() => [...document.querySelectorAll(".chart svg[width]")].filter((svg) => svg.getClientRects().length).map((svg) => Number(svg.getAttribute("width"))));
    assert.ok(widths.length > 1 && widths.every((width) => width === 700 || width === 345), String(widths));
    await page.emulateMedia({ media: "print" });
    assert.deepEqual(await page.evaluate(() => ["one", "two"].map((id) => getComputedStyle($(id)).display)), link ? ["none", "block"] : ["block", "none"]);
    await page.emulateMedia({ media: null });
    assert.deepEqual(await look("afterprint"), ["dark", true]);
    await closed(page);
  }
});

test("the sample record after an example in ratios has a machine", async () => {
  const page = await opened();
  await page.click("[data-preset=textbook]");
  await page.waitForFunction(() => shown.answer?.alpha === 6);
  await page.click("#sample");
  await page.waitForFunction(() => isRecordOfNow());
  assert.equal(await page.textContent("#record-error"), "");
  assert.ok(await page.locator("#record-verdict").isVisible());
  assert.equal(await page.inputValue("#mode"), "machine");
  await closed(page);
});

test("sliders, check boxes and buttons are at least 24 pixels high", async () => {
  const page = await opened();
  await page.click("#more summary");
  await page.click("#sample");
  await page.waitForFunction(() => isRecordOfNow());
  const small = await page.evaluate(() => [...document.querySelectorAll("input, select, button")].filter((own) => own.offsetParent).map((own) => [own.id || own.getAttribute("aria-label"), own.getBoundingClientRect()]).filter(([, box]) => box.height < 24 || box.width < 24).map(([name, box]) => `${name}: ${box.width} × ${box.height}`));
  assert.deepEqual(small, []);
  await closed(page);
});

test("each example has an answer, and two masses have theirs", async () => {
  const page = await opened();
  const due = { isolator: /Non-sticking/, dither: /Non-sticking/, feeder: /Non-sticking/, damper: /./, slope: /./, decay: /Free vibration: the body comes to rest/, crate: /Sticking: .*2 stops in a cycle, 15\.65 % of the time/, textbook: /Sticking: .*2 stops/ };
  for (const [name, words] of Object.entries(due)) {
    await page.click(`[data-preset=${name}]`);
    await page.waitForFunction(() => shown.answer && JSON.stringify(shown.answer.inputs) === JSON.stringify(inputs()));
    await quiet(page);
    assert.match(await page.textContent("#verdict"), words, name);
    assert.equal(await page.textContent("#error"), "", name);
  }
  await page.click("#tab-two");
  await page.waitForFunction(() => document.getElementById("system-verdict").textContent.startsWith("Periodic: it repeats itself after 0.3333 s, with no rest"));
  assert.match(await page.getAttribute("#system-border", "title"), /if the load on upper is at least 0\.3040677 times this one/);
  assert.match(await page.textContent("#system-values"), /-6\.057 mm to 6\.057 mm/);
  for (const button of await page.locator("#system-presets button").all()) {
    await button.click();
    await page.waitForFunction(() => twoAnswer?.text === systemText() && !document.getElementById("system-shown").hidden);
    assert.equal(await page.textContent("#system-error"), "");
    // No text of the sketch is cut at its edges, and none covers another.
    const faults = await page.evaluate(() => {
      play(false);
      placeSystem(0);
      const { width, height } = twoSketch.svg.viewBox.baseVal;
      const boxes = [...twoSketch.svg.querySelectorAll("text")].map((own) => [own.textContent, own.getBBox()]);
      const isCut = (box) => box.x < 0 || box.y < 0 || box.x + box.width > width || box.y + box.height > height;
      const meet = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height - 2 && b.y < a.y + a.height - 2;
      return [...boxes.filter(([, box]) => isCut(box)).map(([text]) => text), ...boxes.flatMap(([first, a], i) => boxes.slice(i + 1).filter(([, b]) => meet(a, b)).map(([second]) => `${first} / ${second}`))];
    });
    assert.deepEqual(faults, [], await button.textContent());
  }
  await page.fill("#two-gap", "-1 km/h");
  await page.waitForFunction(() => /gap/.test(document.getElementById("system-error").textContent));
  const link = new URL(page.url()).hash;
  assert.match(link, /system=1/);
  await closed(page);
  const other = await opened("#system=1&friction=2+kN");
  await other.waitForFunction(() => document.getElementById("system-verdict").textContent !== "" && document.getElementById("two-friction").value === "2 kN");
  await closed(other);
});

test("the key of the map names its colours, and tells stops apart in grey and without red and green", async () => {
  const page = await opened("#mode=ratios&omega=0.97&alpha=4&damping_ratio=0&static_friction_ratio=1.3");
  await page.waitForFunction(() => shown.map?.width > 96);
  const found = await page.evaluate(() => {
    const codes = new Set(shown.map.stops.map(classOf));
    const texts = [...document.querySelectorAll("#map svg text")].map((own) => own.textContent);
    // The eyes' response to light, and the projection of Viénot (1999) for those without the second pigment.
    const linear = ([r, g, b]) => [r, g, b].map((x) => (x / 255) ** 2.2);
    const grey = (rgb) => linear(rgb).reduce((sum, x, i) => sum + x * [0.2126, 0.7152, 0.0722][i], 0) ** (1 / 2.2);
    const deuteranope = (rgb) => {
      const [r, g, b] = linear(rgb);
      const [y, z] = [0.29275 * r + 0.70725 * g, -0.02234 * r + 0.02234 * g + b];
      return [y, y, z].map((x) => Math.max(x, 0) ** (1 / 2.2));
    };
    const all = [0, -1, 1, 2, 4, 8, 9];
    const pairs = all.flatMap((a, i) => all.slice(i + 1).map((b) => [a, b]));
    const apart = pairs.map(([a, b]) => {
      const [one, two] = [shadeOf(a), shadeOf(b)];
      const patterned = Boolean(one.dots || one.lines) !== Boolean(two.dots || two.lines);
      const [p, q] = [deuteranope(one.colour), deuteranope(two.colour)];
      return { a, b, grey: Math.abs(grey(one.colour) - grey(two.colour)), deuteranope: Math.hypot(...p.map((x, i) => x - q[i])), patterned };
    });
    return { missing: [...codes].filter((code) => !texts.includes(nameOf(code))), apart };
  });
  assert.deepEqual(found.missing, []);
  for (const { a, b, grey, deuteranope, patterned } of found.apart) {
    assert.ok(grey > 0.06 || patterned, `${a} and ${b} in grey: ${grey}`);
    assert.ok(deuteranope > 0.1 || patterned, `${a} and ${b} for a deuteranope: ${deuteranope}`);
  }
  const [one] = found.apart.filter(({ a, b }) => a === 1 && b === 2);
  assert.ok(one.grey > 0.15 && one.deuteranope > 0.2, JSON.stringify(one));
  await closed(page);
});

test("curves are compared, and read under the pointer", async () => {
  const page = await opened();
  await page.waitForFunction(() => shown.curve?.point.includes("peak"));
  await page.click("#pin");
  await page.check("#ghost");
  await page.fill("#in-friction", "8 kN");
  await answered(page, "Sticking");
  await page.waitForFunction(() => /pinned/.test(document.getElementById("curve").textContent) && /without friction/.test(document.getElementById("curve").textContent));
  await quiet(page);
  await page.locator("#curve").scrollIntoViewIfNeeded();
  const box = await page.locator("#curve svg").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const reading = await page.textContent("#curve .cursor text");
  assert.match(reading, /Hz: .*mm, (slides|stops)/);
  // A curve that is drawn anew under a still pointer is read anew.
  await page.fill("#in-friction", "1 kN");
  await page.waitForFunction((reading) => ![null, undefined, reading].includes(document.querySelector("#curve .cursor text")?.textContent), reading);
  // The point is dragged along the frequencies.
  await quiet(page);
  const dot = await page.locator("#curve .here").boundingBox();
  const before = await page.inputValue("#in-frequency");
  await page.mouse.move(dot.x + dot.width / 2, dot.y + dot.height / 2);
  await page.mouse.down();
  await page.mouse.move(dot.x + 80, dot.y, { steps: 5 });
  await page.mouse.up();
  await page.waitForFunction((before) => document.getElementById("in-frequency").value !== before, before);
  await closed(page);
});

test("axe finds no violation of WCAG 2.2 AA, in light and dark, wide and narrow", async () => {
  const axe = readFileSync(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");
  for (const [width, dark, two] of [[1440, false], [1440, true], [1024, false], [390, false], [390, true], [1440, true, true], [390, false, true]]) {
    const page = await opened("#mode=ratios&omega=0.5&alpha=4&damping_ratio=0.02&static_friction_ratio=1.3", { width });
    if (dark) await page.click("#theme");
    if (two) {
      await page.click("#tab-two");
      await page.waitForFunction(() => document.getElementById("system-verdict").textContent !== "");
    } else {
      await page.click("#answer summary");
      await page.click("#sample");
      // What is computed anew is pale until it is there.
      await page.waitForFunction(() => isRecordOfNow() && !$("record-shown").classList.contains("stale"));
      await quiet(page);
    }
    await page.waitForTimeout(600);
    await page.evaluate(axe);
    const found = await page.evaluate(async () => (await axe.run({ runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"], rules: { "target-size": { enabled: true } } })).violations.map(({ id, impact, nodes }) => `${impact} ${id}: ${nodes[0].html.slice(0, 120)}`));
    assert.deepEqual(found, [], `${width} ${dark} ${two}\n${found.join("\n")}`);
    await closed(page);
  }
});

test("phones and wide screens show it without sideways scrolling", async () => {
  for (const [name, width, height] of [["wide", 1440, 900], ["middle", 1024, 768], ["phone", 390, 844]]) {
    for (const dark of [false, true]) {
      for (const link of ["", "#system=1"]) {
        const page = await opened(link, { width, height, colorScheme: dark ? "dark" : "light", hasTouch: name === "phone", isMobile: name === "phone" });
        await page.waitForFunction((isTwo) => (isTwo ? document.getElementById("system-verdict").textContent !== "" : document.querySelector("#map .knob")), Boolean(link));
        assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), name);
        if (name !== "phone" && !link) {
          // Verdict, sketch and map are on the first screen.
          for (const id of ["verdict", "body", "map"]) assert.ok(await page.evaluate((id) => document.getElementById(id).getBoundingClientRect().bottom <= innerHeight, id), id);
        }
        if (name === "phone") assert.match(await page.textContent("#bar"), link ? /^Periodic · lower 6\.057 mm, upper 3\.432 mm$/ : /^Never stops · 9\.528 mm$/);
        assert.equal(await page.locator("#bar").isVisible(), name === "phone");
        if (process.env.SCREENSHOTS) await page.screenshot({ path: join(process.env.SCREENSHOTS, `${name}${dark ? "-dark" : ""}${link ? "-two" : ""}.png`), fullPage: name !== "wide" });
        await closed(page);
      }
    }
  }
});

test("the sample record comes into sight with a caption", async () => {
  const page = await opened("", { height: 900 });
  await page.click("#sample");
  await page.waitForFunction(() => {
    const box = document.getElementById("record-verdict").getBoundingClientRect();
    return /slides 35 times/.test(document.getElementById("record-verdict").textContent) && box.top > 0 && box.bottom < innerHeight;
  });
  assert.match(await page.textContent("#record-caption"), /^The example: a shake of 15 s/);
  await closed(page);
});

test("each cell of the finished map is the verdict at it, and no file has fewer", async (t) => {
  const ask = await asker();
  let compared = 0;
  for (const link of ["#mode=ratios&omega=1.4&alpha=2.4&damping_ratio=0.02", "#mode=ratios&omega=0.97&alpha=4&damping_ratio=0&static_friction_ratio=1.3"]) {
    const page = await opened(link);
    const csv = page.locator("[aria-label='map as CSV']");
    const final = () => page.waitForFunction(() => shown.map?.isFinal && shown.map.key === mapOf);
    await final();
    await page.waitForFunction(() => document.getElementById("map-unfinished").hidden);
    assert.ok(await csv.isEnabled());
    const { stops, width, height, omega, alpha, same } = await page.evaluate(() => shown.map);
    const next = random(11);
    // A third of them is in the strip of slow drives, where islands are small.
    for (let i = 0; i < 3000; i++) {
      const [column, row] = [Math.floor(next() * width * (i % 3 ? 1 : 0.12)), Math.floor(next() * height)];
      const found = ask({ ask: "map", points: [((column + 0.5) / width) * omega, ((row + 0.5) / height) * alpha], ...same });
      assert.equal(stops[row * width + column], found.stops[0], `${link} ${column} ${row}`);
      compared += 1;
    }
    // Another damping has another map; until it is there the file is that of no machine.
    await page.fill("#in-damping_ratio", "0.03");
    await page.waitForFunction(() => shown.map.key !== mapOf);
    assert.ok(await csv.isDisabled());
    assert.match(await page.textContent("#map-unfinished"), /still computing/);
    await final();
    await page.waitForFunction(() => !document.querySelector("[aria-label='map as CSV']").disabled);
    await closed(page);
  }
  t.diagnostic(`${compared} cells`);
});

test("a change of the units leaves the machine as it is", async () => {
  const link = "#mode=machine&units=kN,m&mass=50&stiffness=1000&friction=5&damping=9&force=12 kN&frequency=1&x0=0.01&v0=0.02&mean_force=1";
  const page = await opened(link);
  const before = await titles(page);
  for (const units of ["N,mm", "lbf,in"]) {
    await page.fill("#units", units);
    await page.waitForFunction((units) => shown.answer?.units === units, units);
    (await titles(page)).forEach((x, i) => assert.ok(Math.abs(x / before[i] - 1) < 1e-12, `${units} ${x}`));
  }
  assert.equal(await page.inputValue("#in-friction"), "5 kN");
  assert.equal(await page.inputValue("#in-mass"), "50 kN*s^2/m");
  assert.equal(await page.inputValue("#in-frequency"), "1");
  await closed(page);
  const two = await opened("#system=1&units=N,mm&friction=450&k1=200&m1=1&amplitude=1500&gap=5");
  const verdicts = () => two.evaluate(() => JSON.stringify([document.getElementById("system-verdict").title, twoAnswer.border?.least_load_factor ?? null, twoAnswer.motion.work]));
  const was = await verdicts();
  await two.fill("#two-units", "N,m");
  await two.waitForFunction(() => twoAnswer?.motion.units.displacement === "m");
  assert.equal(await two.inputValue("#two-friction"), "450 N");
  assert.equal(await two.inputValue("#two-gap"), "5 mm");
  assert.equal((await verdicts()).split(",")[0], was.split(",")[0]);
  await closed(two);
});

test("the slope has the normal force of its angle", async () => {
  const page = await opened();
  await page.click("[data-preset=slope]");
  const weight = 2 * 9.80665;
  const angle = (10 * Math.PI) / 180;
  assert.ok(Math.abs(parseFloat(await page.inputValue("#in-friction")) / (0.3 * weight * Math.cos(angle)) - 1) < 1e-4);
  assert.ok(Math.abs(parseFloat(await page.inputValue("#in-mean_force")) / (weight * Math.sin(angle)) - 1) < 1e-4);
  assert.match(await page.textContent("#about"), /µ m g cos 10°/);
  await closed(page);
});

test("before the computation is loaded the page says so", async () => {
  for (const [link, words] of [["", "verdict"], ["#system=1", "system-verdict"]]) {
    const context = await browser.newContext();
    const page = await context.newPage();
    await page.addInitScript(() => (WebAssembly.compile = () => new Promise(() => {})));
    await page.goto(address + link);
    const found = await page.evaluate((id) => `${document.getElementById(id).textContent}${getComputedStyle(document.getElementById(id), "::before").content}`, words);
    assert.match(found, /Computing …/);
    assert.ok(!(await page.locator("#body svg").isVisible()));
    await context.close();
  }
  const page = await opened();
  assert.ok(await page.locator("#body svg").isVisible());
  await closed(page);
});

test("sliders of either sign go both ways from 0", async () => {
  const page = await opened();
  await page.click("#more summary");
  for (const [name, words] of [["x0", "start x₀"], ["v0", "start v₀"], ["mean_force", "mean force"]]) {
    const slider = page.locator(`[aria-label='${words}, slider']`);
    assert.equal(await slider.inputValue(), "500");
    await slider.focus();
    await page.keyboard.press("Home");
    const least = await page.inputValue(`#in-${name}`);
    await page.keyboard.press("End");
    const most = await page.inputValue(`#in-${name}`);
    assert.ok(parseFloat(most) > 0);
    assert.equal(least, `-${most}`);
    assert.equal((await page.locator(`#in-${name} + .slider .ends span`).allTextContents()).length, 3);
    await page.fill(`#in-${name}`, "0");
    assert.equal(await slider.inputValue(), "500");
  }
  await closed(page);
});

test("a reason is given where two masses have no least load", async () => {
  const page = await opened("#system=1");
  const values = await page.textContent("#system-values");
  assert.match(values, /a disturbanceshrinks to 0\.8115 of its size in each period/);
  assert.match(values, /natural frequency with the contact stuck3\.898/);
  for (const [name, text, words] of [["friction", "0", /^There is no contact with friction/], ["friction", "450 N", /^The contact never sticks if the load on upper is at least/], ["amplitude", "0 N", /^There is no load/], ["amplitude", "", /^There is no load/]]) {
    await page.fill(`#two-${name}`, text);
    await page.waitForFunction((source) => new RegExp(source).test(document.getElementById("system-border").textContent), words.source);
  }
  await closed(page);
});

test("no choice is cut, and a phone has the inputs below the sketch", async () => {
  for (const width of [1440, 1024, 800, 390]) {
    for (const link of ["", "#system=1"]) {
      const page = await opened(link, { width, height: 844 });
      const cut = await page.evaluate(() => {
        const context = document.createElement("canvas").getContext("2d");
        return [...document.querySelectorAll("select")].filter((own) => own.offsetParent).flatMap((own) => {
          const style = getComputedStyle(own);
          context.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
          // The arrow takes 18 pixels.
          const room = own.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - 18;
          return [...own.options].filter((option) => context.measureText(option.text).width > room).map((option) => `${option.text}: ${context.measureText(option.text).width} of ${room}`);
        });
      });
      assert.deepEqual(cut, [], `${width} ${link}`);
      if (width === 390) {
        const edges = await page.evaluate(() => [...document.querySelectorAll("header button, #presets-row button, #system-presets-row button")].filter((own) => own.offsetParent).map((own) => own.getBoundingClientRect()).map(({ left, right }) => [left, right]));
        for (const [left, right] of edges) assert.ok(left >= 0 && right <= width, `${left} ${right}`);
        assert.equal(await page.evaluate(() => new Set([...document.querySelectorAll("header h1, .actions button")].filter((own) => own.offsetParent).map((own) => Math.round((own.getBoundingClientRect().top + own.getBoundingClientRect().bottom) / 20))).size), 1);
        const top = await page.evaluate(() => [...document.querySelectorAll("form")].find((form) => form.offsetParent).getBoundingClientRect().top / innerHeight);
        assert.ok(top < 0.75, `${link} ${top}`);
      }
      await closed(page);
    }
  }
});

test("every axis has at least three numbers", async () => {
  const page = await opened();
  const count = () => page.evaluate(() => {
    const found = [];
    for (const [name, chart] of Object.entries(charts)) {
      if (!chart.x || chart.host.offsetParent === null || !chart.svg.childElementCount) continue;
      const texts = [...chart.svg.querySelectorAll("text")].filter((own) => /^-?[\d.e-]+$/.test(own.textContent));
      const down = texts.filter((own) => own.getAttribute("text-anchor") === "end").length;
      const across = texts.filter((own) => own.getAttribute("text-anchor") === "middle").length;
      if (down < 3 || across < 3) found.push(`${name}: ${across} across, ${down} down`);
    }
    return found;
  });
  let pictures = 0;
  for (const link of ["", "[data-preset=isolator]", "[data-preset=dither]", "[data-preset=feeder]", "[data-preset=damper]", "[data-preset=decay]", "[data-preset=textbook]", "#sample"]) {
    if (link) await page.click(link);
    if (link === "#sample") await page.waitForFunction(() => isRecordOfNow());
    await quiet(page);
    assert.deepEqual(await count(), [], link);
    pictures += 1;
  }
  // Any range that a chart may have.
  const bad = await page.evaluate(() => {
    const bad = [];
    for (let i = 0; i < 2000; i++) {
      const [a, b] = [Math.sin(i * 12.9898) * 10 ** (i % 7 - 3), Math.abs(Math.cos(i * 78.233)) * 10 ** (i % 5 - 2)];
      for (const count of [3, 4, 8]) {
        if (ticks(a, a + b, count).length < 3) bad.push([a, b, count]);
        if (a > 0 && powers(a, a * (1.05 + b), count).length < 3) bad.push(["log", a, a * (1.05 + b), count]);
      }
    }
    return bad;
  });
  assert.deepEqual(bad.slice(0, 3), []);
  await closed(page);
});

test("rests, marks and the threshold have a name in the picture, and one", async () => {
  const page = await opened();
  await quiet(page);
  const texts = (id) => page.evaluate((id) => [...document.querySelectorAll(`#${id} svg text`)].map((own) => own.textContent), id);
  assert.ok((await texts("curve")).includes("this machine"));
  assert.ok((await texts("curve")).includes("sticking threshold"));
  await page.waitForSelector("#map .knob");
  assert.ok((await texts("map")).includes("sticking threshold"));
  assert.ok(!(await texts("displacement")).includes("at rest"));
  assert.doesNotMatch(await page.innerText("#one"), /border/i);
  assert.match(await page.textContent("#map-section"), /Ω is the frequency of the drive over the natural frequency, α the force of the drive over the friction/);
  await page.fill("#in-force", "6 kN");
  await answered(page, "Sticking");
  await quiet(page);
  for (const id of ["friction", "displacement", "velocity", "loop", "phase"]) assert.ok((await texts(id)).includes("at rest"), id);
  await closed(page);
});

test("a jump of the friction is vertical", async () => {
  for (const link of ["", "#mode=ratios&omega=0.4&alpha=6", "#mode=ratios&omega=0.5&alpha=4&damping_ratio=0.02&static_friction_ratio=1.3"]) {
    const page = await opened(link);
    await page.waitForFunction(() => motion);
    const found = await page.evaluate(() => {
      const { time, velocity, displacement, friction, bound } = motion;
      return [[true, time], [false, displacement]].map(([isTime, places]) => {
        const [xs, ys] = withJumps(time, velocity, places, friction, isTime);
        // The parts of the line that change the force by more than a fifth of the bound, and their run.
        const steep = ys.flatMap((y, i) => (i && Math.abs(y - ys[i - 1]) > 0.2 * bound ? [Math.abs(xs[i] - xs[i - 1])] : []));
        return { count: steep.length, run: Math.max(...steep, 0), extent: Math.max(...xs) - Math.max(...places), rising: !isTime || xs.every((x, i) => !i || x >= xs[i - 1]), step: Math.max(...places.map((x, i) => (i ? Math.abs(x - places[i - 1]) : 0))) };
      });
    });
    for (const { count, run, extent, rising, step } of found) {
      assert.ok(count >= 2, `${link} ${count}`);
      assert.equal(run, 0, link);
      // The reversal lies beside a sample, by less than one.
      assert.ok(rising && extent >= 0 && extent < step, `${link} ${extent}`);
    }
    await closed(page);
  }
});

test("long work says what it computes, is stopped, and is begun anew", async () => {
  const page = await opened("#mode=ratios&omega=1.5&alpha=2.5");
  await page.fill("#in-omega", "1e-6");
  await page.waitForFunction(() => !$("busy").hidden && /^Computing the answer/.test($("busy-text").textContent));
  await page.click("#stop");
  assert.equal(await page.textContent("#busy-text"), "Stopped.");
  await page.waitForFunction(() => $("error").textContent === "Stopped." && [live, slow, mapper].every((asker) => !asker.running && !asker.waiting.size));
  assert.equal(await page.textContent("#key"), "");
  await page.click("#stop");
  await page.waitForFunction(() => /^Computing the answer/.test($("busy-text").textContent) && live.running);
  await page.fill("#in-omega", "1.2");
  await answered(page, "Non-sticking");
  await quiet(page);
  // A map that is stopped is computed anew with the next change, and so are two masses. Its answers wait here.
  await page.evaluate(() => {
    mapOf = "";
    mapper.stop();
    mapper.worker.onmessage = () => {};
  });
  await page.fill("#in-damping_ratio", "0.01");
  await page.waitForFunction(() => !$("busy").hidden && /the map/.test($("busy-text").textContent));
  await page.click("#stop");
  assert.equal(await page.textContent("#map-note"), "Stopped.");
  await page.fill("#in-damping_ratio", "0.02");
  await page.waitForFunction(() => !busy.isStopped && /^Computing/.test($("map-note").textContent));
  await page.click("#tab-two");
  await page.waitForFunction(() => twoAnswer?.samples);
  await page.evaluate(() => {
    const { onmessage } = live.worker;
    live.worker.onmessage = (event) => (window.release = () => onmessage(event));
  });
  await page.fill("#two-friction", "460 N");
  assert.ok(await page.evaluate(() => $("system-shown").classList.contains("stale") && [...document.querySelectorAll("#two .files button")].at(-1).disabled));
  await page.waitForFunction(() => $("system-verdict").textContent === "Computing …" && $("system-border").textContent === "");
  await page.waitForFunction(() => !$("busy").hidden && /the two masses/.test($("busy-text").textContent));
  await page.click("#stop");
  assert.equal(await page.textContent("#system-error"), "Stopped.");
  await page.click("#stop");
  await page.waitForFunction(() => !$("system-shown").hidden && /^Periodic/.test($("system-verdict").textContent) && twoAnswer.text === systemText());
  await closed(page);
});

test("a curve of two masses is drawn in parts, and its file is the whole", async () => {
  const page = await opened("#system=1&gap=1+mm&load=lower&frequency=4+Hz");
  await page.waitForFunction(() => $("two-curve").querySelector("path[clip-path]") && !$("two-curve").classList.contains("stale"));
  assert.deepEqual(await page.evaluate(() => [shown.systemCurve, document.querySelector("[aria-label='two-masses-curve as CSV']").disabled]), [undefined, true]);
  // The motion of now is marked on the curve, and plays on its lines.
  assert.equal(await page.locator("#two-curve circle[cx]").count(), 3);
  assert.equal(await page.locator("#two-motion circle.cursor[cx]").count(), 2);
  await page.waitForFunction(() => shown.systemCurve?.frequency.length >= 160);
  assert.ok(await page.locator("[aria-label='two-masses-curve as CSV']").isEnabled());
  await closed(page);
});

test("the loop of a contact shows where it sticks or holds, for the part of the period that the answer has", async () => {
  const page = await opened("#system=1");
  for (const [i, words] of [[0, null], [1, "holds"], [2, "sticks"], [3, "sticks"], [4, "sticks"]]) {
    await page.locator("#system-presets button").nth(i).click();
    await page.waitForFunction(() => twoAnswer?.text === systemText() && !$("system-shown").classList.contains("stale"));
    const found = await page.evaluate(() => {
      const { motion, samples } = twoAnswer;
      const [element] = motion.elements;
      const rest = restsOf(element, motion.events, samples.time).slice(1);
      return { texts: [...$("two-force").querySelectorAll("text")].map((own) => own.textContent), share: rest.filter(Boolean).length / rest.length, due: element.time_at_rest / motion.period, step: 1 / rest.length, stops: Math.max(1, element.stops) };
    });
    assert.equal(found.texts.includes(words ?? "sticks"), words !== null, `${i}: ${found.texts}`);
    // Without a load there is no curve, and nothing to save of it.
    await page.waitForFunction((has) => $("two-curve-files").hidden !== has, i < 3);
    assert.ok(Math.abs(found.share - found.due) <= found.step * found.stops, JSON.stringify(found));
  }
  await closed(page);
});

test("the sketch of two masses has what their fields have", async () => {
  const page = await opened("#system=1");
  await page.waitForFunction(() => twoAnswer?.samples);
  const texts = () => page.evaluate(() => {
    placeSystem(0);
    return [...document.querySelectorAll("#two-body text")].map((own) => own.textContent);
  });
  assert.deepEqual((await texts()).sort(), ["200 N/mm", "300 N/mm", "0.3 N*s/mm", "friction 450 N", "lower", "1 t", "upper", "500 kg", "1.5 kN, 3 Hz"].sort());
  for (const [field, value, words, gone] of [
    ["c2", "0.1 N*s/mm", "0.1 N*s/mm"], ["c1", "", null, "0.3 N*s/mm"], ["contact", "lower,upper", "450 N", "friction 450 N"], ["gap", "20 mm", "gap 20 mm"], ["elastic", "90 N/mm", "450 N"],
    ["load", "base", "base 0.2 g, 3 Hz", "1.5 kN, 3 Hz"], ["k1", "", null, "200 N/mm"], ["friction", "", null, "450 N"],
  ]) {
    const own = page.locator(`#two-${field}`);
    if (await own.evaluate((own) => own.tagName === "SELECT")) await own.selectOption(value);
    else await own.fill(value);
    const found = await texts();
    if (words) assert.ok(found.includes(words), `${field}: ${found}`);
    if (gone) assert.ok(!found.includes(gone), `${field}: ${found}`);
  }
  await closed(page);
});

test("a belt and a friction that falls with speed are in the file, the sketch and the presets", async () => {
  const page = await opened("#system=1");
  for (const [name, words] of [["Squealing brake", /^Periodic: .*with one rest/], ["Block on a belt", /^Periodic: .*with one rest/]]) {
    await page.click(`#system-presets button:text-is("${name}")`);
    await page.waitForFunction(() => twoAnswer?.text === systemText());
    assert.match(await page.textContent("#system-verdict"), words, name);
    assert.match(await page.textContent("#system-file"), /law = \[\["0 m\/s", ".*"\], \[".*", "(300|60) N"\], \["1e6 m\/s", "(300|60) N"\]\]\nmoves = ".*m\/s"/);
    const sketch = await page.textContent("#two-body");
    assert.match(sketch, /friction \d+ N to \d+ N/);
    assert.match(sketch, /belt 0\.\d+ m\/s/);
    // Without a load there is no curve over its frequency.
    await page.waitForFunction(() => $("two-curve").hidden && !slow.running);
    // A disturbance of a motion that drives itself is told by the others than the shift in time.
    assert.match(await page.textContent("#system-values"), /a disturbanceshrinks to 0/);
  }
  await page.click('#system-presets button:text-is("Block without a spring")');
  await page.waitForFunction(() => twoAnswer?.text === systemText() && shown.systemCurve);
  assert.ok(await page.isVisible("#two-curve"));
  assert.doesNotMatch(await page.textContent("#system-file"), /"ground", "lower"\]\nstiffness/);
  await closed(page);
});

test("a stop with a restitution, Stribeck's law and loads of other shapes are in the file, the sketch, the answer, the link and undo", async () => {
  const page = await opened("#system=1");
  const example = async (name) => {
    await page.click(`#system-presets button:text-is("${name}")`);
    await page.waitForFunction(() => twoAnswer?.text === systemText());
    assert.notEqual(await page.textContent("#system-about"), "");
  };
  const sketch = () => page.textContent("#two-body");
  await example("Hammer");
  assert.match(await page.textContent("#system-verdict"), /^Periodic: .*2 blows in it/);
  assert.match(await page.textContent("#system-file"), /gap = "2 mm"\nrestitution = "0\.4"\n\[\[forces/);
  assert.match(await sketch(), /gap 2 mme = 0\.4/);
  assert.match(await page.textContent("#system-values"), /stop: blows2stop: work/);
  assert.match(await page.textContent("#system-events"), /s, stop: blow from [\d.]+ m?m\/s to -[\d.]+ m?m\/s/);
  assert.ok(await page.isDisabled("#two-stop_stiffness"));
  // The link has the stop, and so has the way back.
  const link = new URL(page.url()).hash;
  assert.match(link, /restitution=0\.4/);
  await page.fill("#two-restitution", "1.4");
  await page.waitForFunction(() => /restitution 1\.4: must be ≤ 1/.test($("system-error").textContent));
  await page.locator("#two-restitution").blur();
  await page.click("#undo");
  await page.waitForFunction(() => two.restitution === "0.4" && twoAnswer?.text === systemText());
  await example("Drill string");
  assert.match(await page.textContent("#system-verdict"), /^Periodic: .*with one rest in it\. The law of contact is a table of \d+ pieces, within .* N of the curve\. The digits are estimated/);
  assert.match(await page.textContent("#system-file"), /law = \{ static = "8000 N", kinetic = "5000 N", speed = "3 m\/s", exponent = "1", viscous = "10 N\*s\/m" \}\nmoves = "5 m\/s"/);
  assert.match(await sketch(), /friction 8000 N to 5000 N/);
  // No more digits than are known: those of the command.
  const known = await page.evaluate(() => twoAnswer.motion.max_displacement);
  for (const x of known) assert.ok(String(x).replace(/^-|\.|^0\.0*/g, "").length <= 6, String(x));
  assert.ok(await page.isVisible("#two-exponent"));
  await page.selectOption("#two-law", "");
  assert.ok(!(await page.isVisible("#two-exponent")));
  await example("Conveyor");
  assert.match(await page.textContent("#system-verdict"), /^Periodic: .*upper drifts by [\d.]+ mm a period/);
  assert.match(await page.textContent("#system-file"), /frequency = "6 Hz"\nshape = "pulse"\nduty = "0\.25"/);
  assert.match(await sketch(), /400 N, 6 Hz pulse/);
  assert.match(await page.textContent("#system-values"), /upper: drift/);
  await page.waitForFunction(() => shown.systemCurve && !$("two-curve").hidden);
  await page.fill("#two-constant", "20 N");
  assert.match(await page.textContent("#system-file"), /constant = "20 N"/);
  assert.match(await sketch(), /pulse \+ 20 N constant/);
  assert.equal(await page.textContent("#system-about"), "");
  await closed(page);
  const other = await opened(link);
  await other.waitForFunction(() => twoAnswer && two.restitution === "0.4");
  assert.match(await other.textContent("#system-verdict"), /2 blows in it/);
  await closed(other);
});

test("two masses take a record for their base", async () => {
  const page = await opened("#system=1");
  await page.selectOption("#two-load", "record");
  await page.waitForFunction(() => /Choose a record/.test($("system-error").textContent));
  assert.ok(!(await page.isVisible("#two-amplitude")));
  await page.click("#two-sample");
  await page.waitForFunction(() => /^The motion from the start to 15 s\./.test($("system-verdict").textContent));
  assert.equal(await page.textContent("#system-error"), "");
  assert.match(await page.textContent("#system-border"), /1501 samples.*The pictures have 4001 states/);
  assert.match(await page.textContent("#two-body"), /base sample\.csv/);
  assert.equal(await page.textContent("#system-of"), "record sample.csv");
  // The curve follows the answer after a pause.
  await page.waitForSelector("#two-curve", { state: "hidden" });
  await page.setInputFiles("#two-file", { name: "bare.csv", mimeType: "text/csv", buffer: Buffer.from("0\n0.1\n-0.2\n0.1\n0\n") });
  await page.waitForFunction(() => /bare\.csv/.test($("system-error").textContent));
  await page.fill("#two-time_step", "0.5 s");
  await page.fill("#two-record_units", "g");
  await page.waitForFunction(() => $("system-error").textContent === "" && /^The motion from the start to 2 s\./.test($("system-verdict").textContent));
  await closed(page);
});

test("a body without a spring has its answers, and the page says what it does not have", async () => {
  const page = await opened();
  await page.click("[data-preset=crate]");
  await page.waitForFunction(() => shown.answer?.is_without_spring);
  await quiet(page);
  assert.match(await page.textContent("#key"), /α, force \/ friction1\.53peak displacement5\.534 mmpeak velocity93\.39 mm\/s/);
  assert.match(await page.textContent("#notes"), /from the middle of the motion/);
  assert.match(await page.textContent("#map-note"), /no natural frequency and no Ω: this map does not exist/);
  assert.ok(!(await page.isVisible("#map")));
  await page.waitForFunction(() => /no natural frequency, and no peak/.test($("curve-note").textContent) && $("curve").querySelector(".here"));
  // √(1 + π²/4) times the friction of 0.2 m g.
  const due = Math.hypot(1, Math.PI / 2) * 0.2 * 200 * 9.80665;
  await page.waitForFunction(() => /^The body never sticks at a force of/.test($("design").textContent));
  const force = /at a force of ([\d.]+) N or more: an unbalance of .*, or a motion of .* of a base/.exec(await page.textContent("#design"))[1];
  assert.ok(Math.abs(force / due - 1) < 1e-3, `${force} ${due}`);
  assert.doesNotMatch(await page.textContent("#design"), /spring's support/);
  assert.match(await page.textContent("#command"), /--stiffness 0 /);
  // The sketch has no spring, and ratios do not exist.
  assert.equal(await page.evaluate(() => $("body").querySelectorAll("path")[4].getAttribute("d")), "");
  await page.fill("#in-stiffness", "20 N/mm");
  await page.waitForFunction(() => !shown.answer?.is_without_spring && isOfNow(shown.answer) && $("map").offsetHeight > 0);
  await quiet(page);
  assert.notEqual(await page.evaluate(() => $("body").querySelectorAll("path")[4].getAttribute("d")), "");
  await page.click("[data-preset=crate]");
  await page.fill("#in-damping_ratio", "2 %");
  await page.waitForFunction(() => /damping ratio.*must be left out without a spring/.test($("error").textContent));
  await closed(page);
});

test("a body without a spring under a constant force has its drift", async () => {
  const page = await opened("#mass=300kg&stiffness=0&friction_coefficient=0.15&mean_force=29.4N&unbalance=0.04kg*m&frequency=25Hz");
  await page.waitForFunction(() => shown.answer?.drift);
  await quiet(page);
  // 5.6 m in an hour, as the guide says.
  assert.match(await verdict(page), /body drifts by 6\.222971e-5 m a period, 0\.001555743 m\/s in the mean\.$/);
  assert.match(await page.textContent("#key"), /body: drift1\.556 mm\/s in the mean/);
  assert.match(await page.textContent("#motion-title"), /^One cycle of the motion$/);
  for (const id of ["curve-section", "design-section", "limits-section", "map"]) assert.ok(!(await page.isVisible(`#${id}`)), id);
  await page.click("summary:has-text('All values')");
  await page.waitForFunction(() => /mean velocity/.test($("all").textContent));
  // Another constant force is another drift, and none is no drift.
  await page.fill("#in-mean_force", "-29.4N");
  await page.waitForFunction(() => isOfNow(shown.answer) && /drifts by -/.test($("verdict").textContent));
  await page.fill("#in-mean_force", "");
  await page.waitForFunction(() => isOfNow(shown.answer) && !shown.answer.drift && $("curve-section").offsetHeight > 0);
  await quiet(page);
  assert.match(await page.textContent("#design"), /at a force of/);
  await closed(page);
});

test("the record that was asked for stands first, and the sample brings its own machine", async () => {
  const page = await opened("#mode=machine&units=kN,m&mass=40+t&stiffness=900+kN/m&friction=1+kN&force=3+kN&frequency=1+Hz");
  const above = () => page.evaluate(() => $("record-section").getBoundingClientRect().top < $("answer").getBoundingClientRect().top);
  assert.equal(await above(), false);
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.click("#own")]);
  await chooser.setFiles({ name: "mine.csv", mimeType: "text/csv", buffer: Buffer.from(`time[s],acceleration[g]\n${Array.from({ length: 200 }, (_, i) => `${(i * 0.02).toFixed(2)},${(0.3 * Math.sin(i * 0.2)).toFixed(5)}`).join("\n")}\n`) });
  await page.waitForFunction(() => isRecordOfNow());
  assert.equal(await above(), true);
  // A file leaves the machine as it is.
  assert.equal(await page.inputValue("#in-mass"), "40 t");
  await page.click("#sample");
  await page.waitForFunction(() => isRecordOfNow() && /slides 35 times/.test($("record-verdict").textContent));
  assert.equal(await page.inputValue("#in-mass"), "50 t");
  await page.click("#undo");
  assert.equal(await page.inputValue("#in-mass"), "40 t");
  await closed(page);
});

test("the spectrum of a record is fine beside its peaks", async () => {
  const page = await opened();
  await page.click("#sample");
  await page.waitForFunction(() => isRecordOfNow());
  const found = await page.evaluate(() => ({ periods: shown.spectrum.periods, sizes: sizes(shown.spectrum) }));
  assert.ok(found.periods.length > 110 && found.periods.every((x, i) => !i || x > found.periods[i - 1]));
  // At the peak the neighbours are as high, to a thousandth; of a hundred points they are not.
  const top = found.sizes.indexOf(Math.max(...found.sizes));
  assert.ok(found.sizes[top - 1] > 0.99 * found.sizes[top] && found.sizes[top + 1] > 0.99 * found.sizes[top], `${found.sizes.slice(top - 1, top + 2)}`);
  const coarse = 100 ** (1 / 99);
  assert.ok(found.periods[top + 1] / found.periods[top] - 1 < (coarse - 1) / 4);
  await closed(page);
});

test("an input that is missing or negative is named as the page has it", async () => {
  const page = await opened();
  const error = async (field, text, words) => {
    await page.fill(`#in-${field}`, text);
    await page.waitForFunction((words) => $("error").textContent === words, words);
  };
  await error("force", "-5 kN", "force -5 kN: must be ≥ 0");
  assert.equal(await page.getAttribute("#in-force", "aria-invalid"), "true");
  await error("force", "", "force is missing");
  await page.selectOption("select[aria-label='kind of force p₀']", "unbalance");
  await error("force", "", "unbalance is missing");
  await error("force", "-1 t*m", "unbalance -1 t*m: must be ≥ 0");
  await page.click("#undo");
  await closed(page);
  const base = await opened("#mode=machine&units=kN,m&mass=50+t&stiffness=1000&friction=5&base_acceleration=0.03+g&frequency=1+Hz");
  assert.equal(await base.textContent("#notes"), "The base carries the surface: p₀ = m ω_d² u₀, x relative to the base.");
  await closed(base);
});

test("the page has at most a million bytes", () => {
  const { size } = statSync(new URL("../dist/stickslip.html", import.meta.url));
  assert.ok(size <= 1_000_000, String(size));
});
