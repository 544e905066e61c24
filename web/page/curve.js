// The response curve, with one that is pinned, the curve without friction, and its point, which a mouse drags.
"use strict";

let pinned = null;

$("pin").onclick = () => {
  pinned = pinned ? null : shown.curve;
  $("pin").textContent = pinned ? "Unpin" : "Pin this curve";
  $("pin").setAttribute("aria-pressed", String(Boolean(pinned)));
  if (shown.curve) showCurve(shown.curve);
};

// The curve of the same machine without friction.
function askGhost() {
  const isOn = $("ghost").checked && state.mode === "machine";
  const isLinear = shown.answer?.is_without_spring;
  $("ghost").disabled = state.mode !== "machine" || isLinear;
  if (!isOn || isLinear) {
    shown.ghost = undefined;
    return;
  }
  const asked = question("curve", { ...span(), resolved: true });
  const without = { ...asked, inputs: { ...asked.inputs, friction: "0" } };
  delete without.inputs.friction_coefficient;
  delete without.inputs.static_friction;
  slow.ask("ghost", without, ({ ok }) => {
    shown.ghost = ok;
    if (shown.curve) later("curve", shown.curve);
  });
}
$("ghost").onchange = () => {
  askGhost();
  if (shown.curve) showCurve(shown.curve);
};

function showCurve(curve) {
  const chart = charts.curve;
  const { frequency, displacement, border, regime } = curve;
  const isMachine = state.mode === "machine";
  const here = shown.answer;
  const at = here ? (here.omega ?? 1) * curve.natural : NaN;
  const height = greatest(here);
  const positive = displacement.filter((x) => x > 0);
  const most = Math.max(...positive, height || 0);
  const to = fitting(most, curve.unit);
  const sized = (list) => list.map((x) => (x === null ? null : x * to.factor));
  const top = most * 2.4 * to.factor;
  const least = (Math.min(...positive, height > 0 ? height : Infinity) / 1.4) * to.factor;
  const low = Math.max(least, top * 1e-4);
  const ink = palette();
  const legend = [["slides", ink.slide], ["stops", ink.stick]];
  if (border.some((x) => x !== null)) legend.push(["sticking threshold", ink.border, "6 4"]);
  if (at >= frequency[0] && at <= frequency.at(-1) && height > 0) legend.push(["this machine", ink.here, "dot"]);
  const others = [];
  if (shown.ghost && isMachine) others.push([shown.ghost, "without friction", ink.ghost, "2 3"]);
  if (pinned && (pinned.unit === curve.unit)) others.push([pinned, "pinned", ink.second, "9 3"]);
  for (const [, name, colour, dash] of others) legend.push([name, colour, dash]);
  chart.begin({
    x: [frequency[0], frequency.at(-1)], y: positive.length ? [low, top] : [0.1, 1], xlog: true, ylog: true,
    xlabel: isMachine ? "frequency (Hz)" : "frequency ratio Ω", ylabel: `peak displacement (${to.unit})`, legend,
  });
  for (const [other, , colour, dash] of others) chart.line(other.frequency, sized(other.displacement), colour, { width: 1.6, dash });
  chart.line(frequency, sized(border), ink.border, { width: 1.3, dash: "6 4" });
  const sticks = (i) => regime[i] === "sticking" || regime[i] === "stuck";
  // A part reaches its neighbour, so that the curve has no gaps.
  const part = (of) => (i) => of(i) || (i > 0 && of(i - 1));
  const own = sized(displacement);
  chart.line(frequency, own, ink.stick, { width: 4, shown: part(sticks) });
  chart.line(frequency, own, ink.slide, { shown: part((i) => !sticks(i)) });
  const first = regime.indexOf("unbounded");
  if (first >= 0) chart.add("text", { x: chart.x(frequency[first]).toFixed(1), y: chart.box.top + 14, "text-anchor": "middle", "font-size": 13, fill: ink.slide }, "∞");
  const isWithin = height > 0 && at >= frequency[0] && at <= frequency.at(-1);
  $("curve-note").textContent = here && height === 0 ? "The machine does not move at this frequency: it has no point on a logarithmic axis."
    : here && height !== null && !isWithin ? `The machine's point, ${four(at)} ${isMachine ? "Hz" : ""} and ${readable(height, curve.unit)}, is outside these axes.`
      : regime.every((name) => name === "stuck") ? "The body is stuck at every frequency of this range." : here?.is_without_spring ? "Without a spring there is no natural frequency, and no peak." : "";
  if (isWithin) {
    const sizedHeight = height * to.factor;
    const dot = chart.dot(at, Math.max(sizedHeight, low), ink.here, 6.5);
    dot.setAttribute("class", "here");
    if (sizedHeight < low) $("curve-note").textContent = `The machine's point, ${readable(height, curve.unit)}, is below this axis.`;
  }
  const unit = isMachine ? "Hz" : "";
  chart.read = (x) => {
    const i = nearest(frequency, x);
    const value = displacement[i] === null ? "no bound" : readable(displacement[i], curve.unit);
    return { x: frequency[i], text: `${four(frequency[i])} ${unit}: ${value}, ${{ "non-sticking": "slides", sticking: "stops" }[regime[i]] || regime[i]}` };
  };
}

// The point is dragged along the frequencies, at the same drive.
held(charts.curve.svg, {
  begins: (event) => {
    const dot = charts.curve.svg.querySelector(".here");
    if (!dot || !shown.answer || shown.answer.is_free) return false;
    const box = dot.getBoundingClientRect();
    const reach = event.pointerType === "mouse" ? 12 : 24;
    return Math.hypot(event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2) < reach;
  },
  moves: (event) => {
    const box = charts.curve.svg.getBoundingClientRect();
    const x = ((event.clientX - box.left) * charts.curve.svg.viewBox.baseVal.width) / box.width;
    const { left, right } = charts.curve.box;
    const frequency = charts.curve.x.back(Math.min(Math.max(x, left), right));
    if (state.mode === "ratios") state.omega = short(frequency);
    else {
      const unit = parts(state.frequency);
      const now = (shown.answer.omega ?? 1) * shown.curve.natural;
      const own = parts(shown.answer.inputs.frequency);
      if (!unit || !own) return;
      state.frequency = withNumber(state.frequency, (own[0] * frequency) / now);
    }
    refresh();
    changed();
  },
  ends: remember,
});
