// Texts whose contrast with what they stand on is below 4.5 (WCAG 2.2, success criterion 1.4.3), as a list of words.
(() => {
  const parts = (colour) => colour.match(/[\d.]+/g).map(Number);
  const linear = (c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);
  const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
  const ground = (element) => {
    for (let e = element; e; e = e.parentElement) {
      const colour = parts(getComputedStyle(e).backgroundColor);
      if (colour.length < 4 || colour[3] > 0) return colour;
    }
    return [255, 255, 255];
  };
  const low = [];
  for (const e of document.body.querySelectorAll("*")) {
    const words = [...e.childNodes].filter((n) => n.nodeType === 3).map((n) => n.data.trim()).join("");
    if (words === "" || !e.checkVisibility({ visibilityProperty: true }) || e.closest("script, style, title, option")) continue;
    const style = getComputedStyle(e);
    const text = luminance(parts(e instanceof SVGElement ? style.fill : style.color));
    const behind = luminance(ground(e));
    const contrast = (Math.max(text, behind) + 0.05) / (Math.min(text, behind) + 0.05);
    if (contrast < 4.5) low.push(contrast.toFixed(2) + ": " + words.slice(0, 40));
  }
  return low;
})()
