// The page's looks and its player: it shows one drawing of many, and nothing else.
#pragma once

namespace lcpush::desktop {

constexpr const char* player_style = R"css(
.stage { max-width: 860px; margin: 0 auto; }
.stage .moment { display: none; }
.stage .moment.shown { display: inline; }
@media (max-width: 600px) { .stage .drawing { font-size: 21px; } }
.player { display: flex; flex-wrap: wrap; align-items: center; gap: 10px 14px; margin: 10px 0; }
.player button { font: inherit; min-width: 5.4em; min-height: 44px; color: var(--ink);
  background: var(--raised); border: 1px solid var(--faint); border-radius: 6px; }
.player input { flex: 1 1 220px; min-height: 44px; accent-color: var(--normal); }
.player output { font-variant-numeric: tabular-nums; min-width: 7em; }
.over { position: relative; }
.over .cursor { position: absolute; top: 0; height: 0; width: 2px; background: var(--friction); }
.plot { display: block; width: 100%; height: auto; }
td { font-variant-numeric: tabular-nums; }
)css";

constexpr const char* player_script = R"js(
"use strict";
(function () {
  const data = JSON.parse(document.getElementById("frames").textContent);
  const moments = document.querySelectorAll(".moment");
  const slider = document.getElementById("time"), clock = document.getElementById("clock");
  const button = document.getElementById("play"), cursor = document.getElementById("cursor");
  const cells = document.querySelectorAll("#now td"), place = document.getElementById("place");
  let shown = moments.length - 1, timer = 0;
  function show(k) {
    moments[shown].classList.remove("shown");
    shown = Math.max(0, Math.min(moments.length - 1, k));
    moments[shown].classList.add("shown");
    const frame = data[shown];
    slider.value = String(shown);
    slider.setAttribute("aria-valuetext", frame.clock + ", " + frame.place);
    clock.textContent = frame.clock;
    place.textContent = frame.place;
    if (cursor) cursor.style.left = frame.left + "%";
    cells.forEach(function (cell, i) { cell.textContent = frame.cells[i]; });
  }
  function stop() {
    clearInterval(timer);
    timer = 0;
    button.textContent = "Play";
  }
  function play() {
    if (shown === moments.length - 1) show(0);
    button.textContent = "Pause";
    timer = setInterval(function () {
      if (shown < moments.length - 1) show(shown + 1);
      if (shown === moments.length - 1) stop();
    }, 50);
  }
  function toggle() { timer ? stop() : play(); }
  button.addEventListener("click", toggle);
  slider.addEventListener("input", function () { stop(); show(Number(slider.value)); });
  document.addEventListener("keydown", function (event) {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const steps = { ArrowLeft: -1, ArrowRight: 1, PageUp: -10, PageDown: 10 };
    if (event.key === " " && event.target !== button) toggle();
    else if (event.key in steps && event.target !== slider) { stop(); show(shown + steps[event.key]); }
    else if (event.key === "Home" && event.target !== slider) { stop(); show(0); }
    else if (event.key === "End" && event.target !== slider) { stop(); show(moments.length - 1); }
    else return;
    event.preventDefault();
  });
  document.getElementById("controls").hidden = false;
  show(0);
  if (moments.length > 1 && !matchMedia("(prefers-reduced-motion: reduce)").matches) play();
})();
)js";

} // namespace lcpush::desktop
