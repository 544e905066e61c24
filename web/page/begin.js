// Presets, links, downloads, themes, and the beginning.
"use strict";

let embedded = false;

function show(name) {
  tab = name;
  VIEWS[tab].present ??= snapshot();
  historyButtons();
  $("caption").textContent = VIEWS[tab].title;
  for (const own of ["one", "two"]) {
    $(own).hidden = own !== name;
    $(`tab-${own}`).setAttribute("aria-selected", String(own === name));
    $(`tab-${own}`).tabIndex = own === name ? 0 : -1;
  }
  if (name === "two") {
    changedSystem();
    placeSystem(0);
  } else redraw();
}

for (const own of ["one", "two"]) {
  $(`tab-${own}`).onclick = () => {
    show(own);
    history.replaceState(null, "", currentHash());
  };
  $(`tab-${own}`).onkeydown = (event) => {
    if (!["ArrowLeft", "ArrowRight"].includes(event.key)) return;
    const other = own === "one" ? "two" : "one";
    $(`tab-${other}`).click();
    $(`tab-${other}`).focus();
  };
}

for (const [name, [words, link, about]] of Object.entries(PRESETS)) {
  const button = Object.assign(document.createElement("button"), { type: "button", textContent: words, title: about });
  button.dataset.preset = name;
  button.onclick = () => {
    remember();
    from(link);
    fields();
    changed();
    $("about").textContent = about;
    remember();
  };
  $("presets").append(button, " ");
}
for (const [words, changes, about = ""] of Object.values(SYSTEM_PRESETS)) {
  const button = Object.assign(document.createElement("button"), { type: "button", textContent: words, title: about });
  button.onclick = () => {
    remember();
    VIEWS.two.put({ ...BASE_SYSTEM, ...changes });
    $("system-about").textContent = about;
    remember();
  };
  $("system-presets").append(button, " ");
}

$("mode").onchange = () => changeMode($("mode").value);
$("units").oninput = () => {
  withUnits(state, state.units);
  state.units = $("units").value;
  refresh();
  changed();
};
$("units").onchange = remember;
for (const form of document.querySelectorAll("form")) form.onsubmit = (event) => event.preventDefault();
$("undo").onclick = () => step("past", "future");
$("redo").onclick = () => step("future", "past");
$("reset").onclick = () => {
  remember();
  VIEWS[tab].put(structuredClone(VIEWS[tab].start()));
  remember();
};
addEventListener("keydown", (event) => {
  if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z" || /^(text|)$/.test(event.target.type ?? "no")) return;
  event.preventDefault();
  $(event.shiftKey ? "redo" : "undo").click();
});

$("bar").onclick = () => $(tab === "one" ? "verdict" : "system-verdict").scrollIntoView();

// ---- links

// A page that was opened from a file has no address for others: they have the file.
const address = (tail) => (location.protocol === "file:" ? `stickslip.html${tail}` : `${location.href.split("#")[0]}${tail}`);

async function copied(button, text) {
  const words = button.textContent;
  try {
    await navigator.clipboard.writeText(text);
    button.textContent = "Copied";
  } catch {
    button.textContent = "Not allowed";
  }
  setTimeout(() => (button.textContent = words), 1500);
}

const currentHash = (more = embedded ? { embed: 1 } : {}) => (tab === "two" ? systemHash(more) : hash(more));
$("link").onclick = () => {
  history.replaceState(null, "", currentHash());
  copied($("link"), address(currentHash()));
};
$("embed").onclick = () => copied($("embed"), `<iframe src="${address(currentHash({ embed: 1 })).replaceAll("&", "&amp;")}" width="760" height="620" style="border:0" title="stickslip"></iframe>`);
$("copy-command").onclick = () => copied($("copy-command"), commandLine());

addEventListener("hashchange", ({ newURL }) => {
  // The address may have become that of the machine again before this event.
  const { hash: link } = new URL(newURL);
  if (link === currentHash()) return;
  const text = link.slice(1);
  const name = new URLSearchParams(text).has("system") ? "two" : "one";
  if (tab !== name) show(name);
  remember();
  if (systemFromHash(text)) VIEWS.two.put(two);
  else {
    from(text);
    fields();
    changed(true);
  }
  remember();
});

// ---- downloads

const FILES = {
  curve: [["curve"], () => ({ [`frequency[${state.mode === "machine" ? "Hz" : "1"}]`]: shown.curve.frequency, [`displacement[${shown.curve.unit}]`]: shown.curve.displacement, regime: shown.curve.regime, [`border[${shown.curve.unit}]`]: shown.curve.border, point: shown.curve.point })],
  motion: [["displacement", "velocity", "friction", "loop", "phase"], () => Object.fromEntries(["time", "displacement", "velocity", "friction", "load"].map((name) => [`${name}[${shown.motion.units[name] ?? shown.motion.units.friction}]`, shown.motion[name]]))],
  map: [["map"], () => {
    const { omega, alpha, width, height, stops } = shown.map;
    const [omegas, alphas] = [centres(width, omega), centres(height, alpha)];
    return { omega: alphas.flatMap(() => omegas), alpha: alphas.flatMap((own) => omegas.map(() => own)), sticks_per_cycle: stops.map((n) => (n < 0 ? NAMED[n] : n)) };
  }],
  record: [["load", "shaken", "speed", "hysteresis", "spectrum"]],
  "two-masses": [["places", "force"], () => systemColumns(twoAnswer.samples)],
  "two-masses-curve": [["systemCurve"], () => {
    const { frequency, displacement, coordinates, rests, kind, unit } = shown.systemCurve;
    return { "frequency[Hz]": frequency, ...Object.fromEntries(coordinates.map((name, i) => [`${name}.displacement[${unit}]`, displacement[i]])), rests, kind };
  }],
};

// Draws in the light theme, so that a file prints in black, and comes back to the theme that was.
function inLight(then) {
  const was = document.documentElement.dataset.theme;
  document.documentElement.dataset.theme = "light";
  drawAll();
  then();
  document.documentElement.dataset.theme = was;
  drawAll();
}

for (const host of document.querySelectorAll(".files")) {
  const { of } = host.dataset;
  const [names, columns] = FILES[of];
  const save = (text) => saved(`stickslip-${of}.csv`, "text/csv", text);
  const picture = () => {
    let file;
    inLight(() => (file = svgFile(names.map((name) => charts[name].svg), palette().paper)));
    return file;
  };
  const kinds = {
    CSV: () => (columns ? save(csvText(columns())) : slow.ask("record-table", question("record-table", recordInputs()), ({ ok }) => ok && save(ok))),
    SVG: () => saved(`stickslip-${of}.svg`, "image/svg+xml", picture().text),
    PNG: async () => saved(`stickslip-${of}.png`, "image/png", await asImage(picture())),
  };
  for (const [kind, onclick] of Object.entries(kinds)) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: kind, onclick });
    button.setAttribute("aria-label", `${of} as ${kind}`);
    host.append(button, " ");
  }
  if (of === "map") host.append(Object.assign(document.createElement("span"), { id: "map-unfinished", className: "hint", textContent: " still computing" }));
}
fileButtons();

// ---- theme, size, print, begin

function theme(name) {
  document.documentElement.dataset.theme = name;
  $("theme").textContent = name === "dark" ? "Light" : "Dark";
  $("theme").setAttribute("aria-pressed", String(name === "dark"));
  try {
    localStorage.setItem("theme", name);
  } catch {
    // A page from a file may have no storage.
  }
  redraw();
}

const DRAWERS = () => ({ answer: showAnswer, motion: showMotion, curve: showCurve, map: showMap });

// Draws all that is shown at once.
function drawAll() {
  if (tab === "one") {
    for (const [kind, show] of Object.entries(DRAWERS())) if (shown[kind]) show(shown[kind]);
    if (shown.record && !$("record-shown").hidden) showRecord(shown.record);
    if (shown.spectrum && !$("record-shown").hidden) showSpectrum(shown.spectrum);
  } else {
    if (twoAnswer) showSystem(twoAnswer);
    if (shown.systemCurve) showSystemCurve(shown.systemCurve);
  }
  // The sketch has the colours of the theme, too.
  placeAll(playing ? performance.now() : 0);
}

const redraw = () => requestAnimationFrame(drawAll);

$("theme").onclick = () => theme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
let width = innerWidth;
addEventListener("resize", () => {
  if (innerWidth !== width) redraw();
  width = innerWidth;
});
let printed = null;
addEventListener("beforeprint", () => {
  isOnPaper = true;
  printed = document.documentElement.dataset.theme;
  document.documentElement.dataset.theme = "light";
  drawAll();
});
addEventListener("afterprint", () => {
  isOnPaper = false;
  document.documentElement.dataset.theme = printed;
  drawAll();
});

async function begin() {
  const text = location.hash.slice(1);
  embedded = new URLSearchParams(text).has("embed");
  document.body.classList.toggle("embedded", embedded);
  from(text);
  fields();
  const isTwo = systemFromHash(text);
  systemFields();
  show(isTwo ? "two" : "one");
  let kept = null;
  try {
    kept = localStorage.getItem("theme");
  } catch {
    // As above.
  }
  theme(kept || (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));
  try {
    const module = await WebAssembly.compile(await unpacked($("wasm").textContent.trim()));
    [live, slow, mapper] = [new Asker(module), new Asker(module), new Asker(module)];
  } catch (error) {
    $("verdict").textContent = "";
    $("error").textContent = `This browser cannot run the page: ${error.message}`;
    return;
  }
  if (isTwo) show("two");
  changed(true);
  if (playing) requestAnimationFrame(animate);
  else play(false);
}

begin();
