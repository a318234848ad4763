// The visible part of the picture, and the selected pixel. All places are in CSS pixels of the canvas.
const canvas = document.querySelector("#picture");
const view = { fits: true, zoom: 1, left: 0, top: 0 };
// The selected pixel, counted in this film.
let read = null;

const SMALLEST = 1 / 16;
const LARGEST = 64;

function fit() {
  const zoom = Math.min(canvas.clientWidth / film.width, canvas.clientHeight / film.height);
  // Small pictures are enlarged by whole numbers, so that their pixels are equal.
  view.zoom = Math.min(zoom > 1 ? Math.floor(zoom) : zoom, LARGEST);
  view.left = (canvas.clientWidth - film.width * view.zoom) / 2;
  view.top = (canvas.clientHeight - film.height * view.zoom) / 2;
}

// Zooms by a factor; the place x, y stays where it is.
function zoomBy(factor, x = canvas.clientWidth / 2, y = canvas.clientHeight / 2) {
  if (film.width === 0) return;
  const zoom = Math.min(Math.max(view.zoom * factor, SMALLEST), LARGEST);
  view.left = x - (x - view.left) * (zoom / view.zoom);
  view.top = y - (y - view.top) * (zoom / view.zoom);
  view.zoom = zoom;
  view.fits = false;
  draw();
}

let isDue = false;
function draw() {
  if (isDue) return;
  isDue = true;
  requestAnimationFrame(() => {
    isDue = false;
    paint();
  });
}

function paint() {
  const dense = window.devicePixelRatio;
  canvas.width = Math.round(canvas.clientWidth * dense);
  canvas.height = Math.round(canvas.clientHeight * dense);
  if (film.width === 0) return;
  if (view.fits) fit();
  const context = canvas.getContext("2d");
  context.scale(dense, dense);
  context.imageSmoothingEnabled = view.zoom * dense < 1;
  const { left, top, zoom } = view;
  context.drawImage(developed, left, top, film.width * zoom, film.height * zoom);
  if (read !== null) mark(context, read, Math.max(zoom, 5));
  document.querySelector("#zoom").textContent = (100 * zoom).toFixed(0) + " %";
  tellPixel();
}

// A frame around a pixel, at least this many CSS pixels wide: light within dark, visible on any background.
function mark(context, [x, y], side) {
  const left = view.left + (x + 0.5) * view.zoom - side / 2;
  const top = view.top + (y + 0.5) * view.zoom - side / 2;
  for (const [grow, colour] of [[1.5, "#000"], [0.5, "#fff"]]) {
    context.strokeStyle = colour;
    context.strokeRect(left - grow, top - grow, side + 2 * grow, side + 2 * grow);
  }
}

function tellPixel() {
  if (read === null || film.width === 0) return;
  const [x, y] = read;
  const [red, green, blue] = [...valueOf(x, y)].map((v) => v.toPrecision(5));
  document.querySelector("#pixel").textContent =
    `x ${x + film.origin[0]}, y ${y + film.origin[1]}: R ${red}, G ${green}, B ${blue}`;
}

// Selects the pixel there, if any.
function readAt(x, y) {
  const at = [(x - view.left) / view.zoom, (y - view.top) / view.zoom].map(Math.floor);
  if (at[0] >= 0 && at[1] >= 0 && at[0] < film.width && at[1] < film.height) {
    read = at;
    draw();
  }
}

// Moves the selection by an offset, and scrolls it into view.
function readBy(right, down) {
  const [x, y] = read ?? [(film.width >> 1) - right, (film.height >> 1) - down];
  read = [
    Math.min(Math.max(x + right, 0), film.width - 1),
    Math.min(Math.max(y + down, 0), film.height - 1),
  ];
  const into = (offset, at, size) => Math.min(Math.max(offset, -at * view.zoom), size - (at + 1) * view.zoom);
  view.left = into(view.left, read[0], canvas.clientWidth);
  view.top = into(view.top, read[1], canvas.clientHeight);
  draw();
}

let grip = null;
canvas.addEventListener("pointerdown", (event) => {
  grip = [event.offsetX - view.left, event.offsetY - view.top];
  canvas.setPointerCapture(event.pointerId);
  readAt(event.offsetX, event.offsetY);
});
canvas.addEventListener("pointermove", (event) => {
  if (grip === null) return readAt(event.offsetX, event.offsetY);
  view.left = event.offsetX - grip[0];
  view.top = event.offsetY - grip[1];
  view.fits = false;
  draw();
});
for (const end of ["pointerup", "pointercancel"]) {
  canvas.addEventListener(end, () => { grip = null; });
}
canvas.addEventListener("wheel", (event) => {
  event.preventDefault();
  zoomBy(2 ** (-Math.sign(event.deltaY) / 2), event.offsetX, event.offsetY);
}, { passive: false });
new ResizeObserver(draw).observe(canvas);
