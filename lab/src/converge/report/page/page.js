// The slider, the choice of a variant, tooltips of the plot's points, and marks of worst pixels.
"use strict";
(() => {
  const root = document.documentElement;
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];
  const form = document.querySelector(".controls");
  const slider = document.querySelector("#step");
  const output = form.querySelector("output");
  const radios = all("input[name=variant]", form);
  const spp = slider.dataset.spp.split(" ");

  root.classList.add("scripted");
  form.hidden = false;
  form.addEventListener("submit", (event) => event.preventDefault());

  const chosen = () => radios.find((radio) => radio.checked) ?? radios[0];

  // One step of one variant, next to its reference.
  function show() {
    const { value: variant, dataset: { reference } } = chosen();
    const step = slider.value;
    for (const each of all(".step")) {
      each.hidden = each.dataset.variant !== variant || each.dataset.step !== step;
    }
    for (const each of all(".reference")) {
      each.hidden = each.dataset.reference !== reference;
    }
    for (const each of all(".worst")) {
      each.hidden = each.dataset.variant !== variant;
    }
    output.textContent = spp[step] + " spp";
    slider.setAttribute("aria-valuetext", spp[step] + " samples per pixel");
  }
  slider.addEventListener("input", show);
  for (const radio of radios) {
    radio.addEventListener("change", () => {
      pick(null);
      show();
    });
  }

  // A point of the plot: its figures next to it, and its picture below.
  const graph = document.querySelector(".graph");
  const tip = graph.querySelector(".tip");
  function tell(target) {
    tip.textContent = target.getAttribute("aria-label");
    tip.hidden = false;
    const frame = graph.getBoundingClientRect();
    const point = target.querySelector("circle").getBoundingClientRect();
    const middle = point.left + point.width / 2 - frame.left;
    const left = Math.min(Math.max(middle - tip.offsetWidth / 2, 0), frame.width - tip.offsetWidth);
    const above = point.top - frame.top - tip.offsetHeight - 6;
    tip.style.left = left + "px";
    tip.style.top = (above >= 0 ? above : point.bottom - frame.top + 6) + "px";
  }
  function choose(target) {
    const { variant, step } = target.dataset;
    radios[variant].checked = true;
    slider.value = step;
    pick(null);
    show();
  }
  for (const target of all(".target")) {
    // The browser would show the same again.
    target.querySelector("title").remove();
    target.addEventListener("pointerenter", () => tell(target));
    target.addEventListener("focus", () => tell(target));
    target.addEventListener("pointerleave", () => { tip.hidden = true; });
    target.addEventListener("blur", () => { tip.hidden = true; });
    target.addEventListener("click", () => {
      tell(target);
      choose(target);
    });
    target.addEventListener("keydown", (event) => {
      if (event.key === "Enter" || event.key === " ") {
        event.preventDefault();
        choose(target);
      }
    });
  }
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      tip.hidden = true;
    }
  });

  // A worst pixel: a ring around it in every picture, and its place in the command line.
  const picks = all(".pick");
  function pick(button) {
    for (const each of picks) {
      each.setAttribute("aria-pressed", each === button);
    }
    for (const mark of all(".mark")) {
      mark.hidden = button === null;
      if (button !== null) {
        mark.style.left = button.dataset.left + "%";
        mark.style.top = button.dataset.top + "%";
      }
    }
    if (button !== null) {
      button.closest(".worst").querySelector(".pixel").textContent = button.dataset.pixel;
    }
  }
  for (const button of picks) {
    button.addEventListener("click", () => {
      const again = button.getAttribute("aria-pressed") === "true";
      pick(again ? null : button);
    });
  }

  show();
})();
