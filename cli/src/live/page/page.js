// News of the rendering, and actions of keys and buttons.
const find = (id) => document.getElementById(id);
// This tab's own number, by which the server knows whether it has the last picture.
const tab = crypto.getRandomValues(new BigUint64Array(1))[0];
let has = 0;
let run = null;
const { title } = document;

// `85 ms`, `1.23 s`, `1 min 20 s`, `2 h 05 min`
function duration(seconds) {
  if (seconds < 0.9995) return (1000 * seconds).toFixed(0) + " ms";
  if (seconds < 59.95) return seconds.toFixed(seconds < 9.995 ? 2 : 1) + " s";
  const whole = Math.round(seconds);
  const two = (n) => String(n).padStart(2, "0");
  const minutes = Math.floor(whole / 60);
  return minutes < 60 ? `${minutes} min ${two(whole % 60)} s` : `${Math.floor(minutes / 60)} h ${two(minutes % 60)} min`;
}

// Write only changes: screen readers would announce the text again.
function write(id, text) {
  if (find(id).textContent !== text) find(id).textContent = text;
}

const PHASES = {
  rendering: "Rendering",
  stopping: "Stopping: finishing the current samples",
  writing: "Rendered: writing layers and files",
  ended: "Done: the files are written",
  failed: "Failed: see the terminal",
  nothing: "Stopped before the first sample: nothing was written",
};

function phaseOf({ phase, stopping, picture }) {
  if (phase === "rendering" && stopping) return "stopping";
  return phase === "ended" && picture === null ? "nothing" : phase;
}
const isLast = (phase) => phase === "ended" || phase === "failed";

function tell(state) {
  const { phase, stopping, samples, spp, seconds, seconds_left: left, fraction } = state;
  const renders = phase === "rendering";
  write("phase", PHASES[phaseOf(state)]);
  const of = spp === null ? "" : ` of ${spp.toLocaleString("en")}`;
  const rest = renders && left !== null ? `, about ${duration(left)} left` : "";
  const time = isLast(phase) ? "" : `, ${duration(seconds)}`;
  write("numbers", `${samples.toLocaleString("en")}${of} samples per pixel${time}${rest}`);
  find("fraction").value = fraction;
  document.title = (renders ? `${Math.floor(100 * fraction)} % – ` : "") + title;
  find("stop").disabled = !renders || stopping;
  if (!renders || stopping) find("sure").close();
  write("trouble", state.trouble ?? "");
  find("trouble").hidden = state.trouble === null;
  drawPlot(state.errors);
}

async function ask(path, how) {
  const answer = await fetch(path, { cache: "no-store", ...how });
  if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
  return answer;
}

const stateOf = (end) => ask(`/state?tab=${tab}&has=${has}&end=${end}`);

// Asks once; returns whether everything has arrived.
async function news() {
  const state = await (await stateOf(0)).json();
  if (run !== null && run !== state.run) {
    // Another rendering at the same port.
    location.reload();
    return true;
  }
  run = state.run;
  tell(state);
  const { phase, picture } = state;
  const hidden = document.hidden && phase === "rendering";
  if (picture !== null && picture.number !== has && !hidden) {
    const answer = await ask("/picture");
    take(picture, await answer.arrayBuffer());
    has = Number(answer.headers.get("vkpt-number"));
    draw();
  }
  pause = phase === "rendering" && !state.stopping && !(state.seconds_left < 3) ? 500 : 80;
  const all = isLast(phase) && has === (picture?.number ?? 0);
  // The server waits for this, and may be gone before it answers.
  if (all) await stateOf(1).catch(() => {});
  return all;
}

let pause = 500;
let timer = 0;
let ended = false;
let asking = false;
async function follow() {
  // One request at a time: answers could arrive in another order.
  if (asking) return;
  asking = true;
  clearTimeout(timer);
  try {
    ended = await news() || ended;
  } catch {
    pause = 1000;
    if (!ended) {
      write("phase", "The rendering has ended or is unreachable; retrying");
      find("stop").disabled = true;
    }
  }
  asking = false;
  // After the end, for another rendering at the same port.
  timer = setTimeout(follow, ended ? 2000 : pause);
}
document.addEventListener("visibilitychange", () => { if (!document.hidden) follow(); });

function exposeTo(to) {
  expose(to);
  find("exposure").value = stops;
  find("stops").textContent = `${stops > 0 ? "+" : ""}${stops} EV`;
  draw();
}
function fitAgain() {
  view.fits = true;
  draw();
}
function askToStop() {
  if (!find("stop").disabled) find("sure").showModal();
}

find("exposure").addEventListener("input", (event) => exposeTo(event.target.valueAsNumber));
find("in").addEventListener("click", () => zoomBy(Math.SQRT2));
find("out").addEventListener("click", () => zoomBy(Math.SQRT1_2));
find("fit").addEventListener("click", fitAgain);
find("stop").addEventListener("click", askToStop);
find("sure").addEventListener("close", async () => {
  if (find("sure").returnValue !== "stop") return;
  find("sure").returnValue = "";
  await ask("/stop", { method: "POST" }).catch(() => {});
  follow();
});

const KEYS = {
  e: () => exposeTo(stops + 0.5),
  E: () => exposeTo(stops - 0.5),
  0: () => exposeTo(0),
  "+": () => zoomBy(Math.SQRT2),
  "=": () => zoomBy(Math.SQRT2),
  "-": () => zoomBy(Math.SQRT1_2),
  f: fitAgain,
  s: askToStop,
};
document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.metaKey || event.altKey || find("sure").open) return;
  KEYS[event.key]?.();
});
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
canvas.addEventListener("keydown", (event) => {
  const step = ARROWS[event.key];
  if (step === undefined || film.width === 0) return;
  event.preventDefault();
  readBy(...step.map((s) => (event.shiftKey ? 10 * s : s)));
});

follow();
