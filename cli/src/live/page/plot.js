// Error over time, both logarithmic.
const plot = document.querySelector("#plot");
const latest = document.querySelector("#latest");
const FRAME = { left: 58, right: 468, top: 12, bottom: 258 };

function element(name, attributes, text = "") {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.textContent = text;
  return made;
}

// From values to places between two ends.
function scale(values, from, to) {
  const logs = values.filter((v) => v > 0).map(Math.log10);
  const [low, high] = [Math.min(...logs), Math.max(...logs)];
  // Some margin, and at least a third of a decade.
  const room = Math.max(0.05 * (high - low), (0.33 - (high - low)) / 2);
  const [least, most] = [low - room, high + room];
  const at = (v) => from + (to - from) * (Math.log10(v) - least) / (most - least);
  // Values below the plot, such as an interval's end at 0, are drawn on its edge.
  return { at: (v) => (v > 10 ** least ? at(v) : from), ticks: ticks(10 ** least, 10 ** most) };
}

// 1, 2, 5, 10 … if they are few, else the powers of ten, or every nth of them.
function ticks(low, high) {
  const first = Math.floor(Math.log10(low));
  const last = Math.ceil(Math.log10(high));
  const within = (all) => all.filter((v) => v >= low && v <= high);
  const powers = Array.from({ length: last - first + 1 }, (_, i) => first + i);
  const all = within(powers.flatMap((e) => [1, 2, 5].map((m) => Number(`${m}e${e}`))));
  if (all.length <= 6) return all;
  const tens = within(powers.map((e) => Number(`1e${e}`)));
  const step = Math.ceil(tens.length / 6);
  return tens.filter((_, i) => i % step === 0);
}

const brief = (v) => (v >= 0.01 && v < 1e4 ? String(v) : v.toExponential(0).replace("e+", "e"));

function axes(x, y) {
  const { left, right, top, bottom } = FRAME;
  for (const v of x.ticks) {
    plot.append(element("line", { class: "grid", x1: x.at(v), x2: x.at(v), y1: top, y2: bottom }));
    plot.append(element("text", { x: x.at(v), y: bottom + 16, "text-anchor": "middle" }, brief(v)));
  }
  for (const v of y.ticks) {
    plot.append(element("line", { class: "grid", x1: left, x2: right, y1: y.at(v), y2: y.at(v) }));
    plot.append(element("text", { x: left - 6, y: y.at(v) + 4, "text-anchor": "end" }, brief(v)));
  }
  plot.append(element("text", { x: (left + right) / 2, y: bottom + 34, "text-anchor": "middle" }, "seconds"));
  plot.append(element("text", { x: 12, y: (top + bottom) / 2, "text-anchor": "middle", transform: `rotate(-90 12 ${(top + bottom) / 2})` }, "relMSE"));
}

// Runs of consecutive errors with intervals.
function runs(errors) {
  const all = [[]];
  for (const e of errors) {
    if (e.interval === null) all.push([]);
    else all[all.length - 1].push(e);
  }
  return all.filter((run) => run.length > 1);
}

// The curve of errors from the server.
function drawPlot(errors) {
  const known = errors.filter((e) => e.estimate > 0 && e.seconds > 0);
  if (known.length === 0) return;
  plot.replaceChildren();
  const x = scale(known.map((e) => e.seconds), FRAME.left, FRAME.right);
  const y = scale(known.flatMap((e) => [e.estimate, ...(e.interval ?? [])]), FRAME.bottom, FRAME.top);
  axes(x, y);
  const place = (e, v) => `${x.at(e.seconds).toFixed(1)},${y.at(v).toFixed(1)}`;
  for (const run of runs(known)) {
    const band = [...run.map((e) => place(e, e.interval[0])), ...run.map((e) => place(e, e.interval[1])).reverse()];
    plot.append(element("polygon", { class: "band", points: band.join(" ") }));
  }
  for (const e of known.filter((each) => each.interval !== null)) {
    const [x1, y1] = place(e, e.interval[0]).split(",");
    plot.append(element("line", { class: "bar", x1, x2: x1, y1, y2: y.at(e.interval[1]) }));
  }
  plot.append(element("polyline", { class: "curve", points: known.map((e) => place(e, e.estimate)).join(" ") }));
  for (const e of known) {
    const dot = element("circle", { class: "dot", cx: x.at(e.seconds), cy: y.at(e.estimate), r: 3 });
    dot.append(element("title", {}, words(e)));
    plot.append(dot);
  }
  latest.textContent = words(known[known.length - 1]);
}

// `relMSE 3.1e-3 (95 %: 2.8e-3 to 3.5e-3) at 64 samples, 12.3 s`
function words({ spp, seconds, estimate, interval }) {
  const digits = (v) => v.toExponential(1);
  const between = interval === null ? "?" : ` (95 %: ${digits(interval[0])} to ${digits(interval[1])})`;
  return `relMSE ${digits(estimate)}${between} at ${spp.toLocaleString("en")} samples, ${duration(seconds)}`;
}
