// The picture: linear values as received, and as shown on the screen.
const film = { width: 0, height: 0, origin: [0, 0], values: new Float32Array(), bits: new Uint32Array() };
const developed = document.createElement("canvas");
let stops = 0;

// Codes of sRGB (IEC 61966-2-1) by the leading 20 bits of a float: its sign, its exponent and 11 bits of 23. Negative values
// and NaN are black.
const SHIFT = 12;
const INFINITE = 0x7f800000 >>> SHIFT;
function codes(exposure) {
  const table = new Uint8Array(1 << (32 - SHIFT));
  const value = new Float32Array(1);
  const bits = new Uint32Array(value.buffer);
  const scale = 2 ** exposure;
  // Below, all are 0.
  value[0] = 1e-4 / scale;
  for (let i = bits[0] >>> SHIFT; i <= INFINITE; i++) {
    bits[0] = (i << SHIFT) | (1 << (SHIFT - 1));
    const linear = value[0] * scale;
    if (!(linear < 1)) {
      table.fill(255, i, INFINITE + 1);
      break;
    }
    table[i] = Math.round(255 * (linear > 0.0031308 ? 1.055 * linear ** (1 / 2.4) - 0.055 : 12.92 * linear));
  }
  return table;
}

let table = codes(stops);
function develop() {
  const image = new ImageData(film.width, film.height);
  const { data } = image;
  const { bits } = film;
  for (let i = 0, to = 0; i < bits.length; i += 3, to += 4) {
    data[to] = table[bits[i] >>> SHIFT];
    data[to + 1] = table[bits[i + 1] >>> SHIFT];
    data[to + 2] = table[bits[i + 2] >>> SHIFT];
    data[to + 3] = 255;
  }
  developed.width = film.width;
  developed.height = film.height;
  developed.getContext("2d").putImageData(image, 0, 0);
}

// A newer picture.
function take({ width, height, origin }, buffer) {
  Object.assign(film, { width, height, origin, values: new Float32Array(buffer), bits: new Uint32Array(buffer) });
  develop();
}

function expose(to) {
  stops = Math.min(Math.max(to, -10), 10);
  table = codes(stops);
  if (film.width > 0) develop();
}

// Red, green and blue of a pixel, counted in this film.
function valueOf(x, y) {
  const at = 3 * (y * film.width + x);
  return film.values.subarray(at, at + 3);
}
