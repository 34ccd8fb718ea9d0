// The looks of drawings: kinds are told apart by shape and line as well as by colour.
#include "draw/markup.hpp"

namespace lcpush::desktop {

std::string palette(const std::string& selector) {
  return selector +
         " {\n"
         "  --paper: #fcfbf8; --raised: #ffffff; --ink: #1c1e21; --soft: #575c63;\n"
         "  --line: #d8d3c8; --faint: #716c63; --normal: #1a5796; --friction: #a2390f;\n"
         "  --cone: #695100; --cone-wash: #f7efd2; --move: #23663a; --object: #ece7db;\n"
         "  --pad: #d9d9df; --bad: #a11b12; --bad-wash: #fbe9e7;\n"
         "}\n"
         "@media screen and (prefers-color-scheme: dark) {\n" +
         selector +
         " {\n"
         "  --paper: #17181a; --raised: #1f2124; --ink: #e9e6df; --soft: #b3afa6;\n"
         "  --line: #3b3d41; --faint: #99968e; --normal: #8bbcf2; --friction: #f2a283;\n"
         "  --cone: #e3c65f; --cone-wash: #3a3217; --move: #86cf9c; --object: #2c2e31;\n"
         "  --pad: #43464c; --bad: #ff9d92; --bad-wash: #43211d;\n"
         "} }\n";
}

std::string drawing_style() {
  return R"css(.drawing { display: block; background: var(--raised); color: var(--ink);
  font: 13.5px system-ui, -apple-system, "Segoe UI", Roboto, Arial, "DejaVu Sans", sans-serif; }
.drawing text { fill: var(--ink); }
.drawing .quiet { fill: var(--soft); }
.drawing .strong { font-weight: 600; }
.drawing .label { paint-order: stroke; stroke: var(--raised);
  stroke-width: 4px; stroke-linejoin: round; }
.drawing .leader-end { fill: var(--soft); }
.drawing .leader { stroke: var(--soft); stroke-width: 0.8; }
.drawing .object { fill: var(--object); stroke: var(--ink); stroke-width: 1.3;
  stroke-linejoin: round; }
.drawing .face { fill: var(--ink); fill-opacity: 0.05; stroke: var(--soft); stroke-width: 0.8;
  stroke-linejoin: round; }
.drawing .thing { fill: var(--pad); stroke: var(--soft); stroke-width: 1.2;
  stroke-linejoin: round; }
.drawing .thing.pusher { stroke: var(--ink); stroke-width: 1.6; }
.drawing .ghost { fill: none; stroke: var(--move); stroke-width: 1.6; stroke-dasharray: 6 4;
  stroke-linejoin: round; }
.drawing .ghost.inner { stroke-width: 0.7; }
.drawing .guessed { stroke-dasharray: 6 4; }
.drawing .pad { fill: var(--pad); stroke: var(--soft); fill-opacity: 0.75; }
.drawing .pad.pusher { stroke: var(--ink); stroke-width: 1.6; }
.drawing .pad.behind { fill: none; stroke-dasharray: 3 3; }
.drawing .cone { fill: var(--cone-wash); fill-opacity: 0.6; stroke: var(--cone);
  stroke-width: 0.9; }
.drawing .cone.behind { fill: none; stroke-dasharray: 2 3; }
.drawing .coulomb { fill: none; stroke: var(--soft); stroke-dasharray: 3 3; }
.drawing .force .shaft { stroke: currentColor; stroke-width: 2.2; }
.drawing .force.bold .shaft { stroke-width: 3.4; }
.drawing .ring { stroke: currentColor; fill: none; stroke-width: 1.4; }
.drawing .head { fill: currentColor; }
.drawing .normal { color: var(--normal); }
.drawing .friction { color: var(--friction); }
.drawing .friction .shaft { stroke-dasharray: 5 2.5; }
.drawing .weight { color: var(--soft); }
.drawing .weight .shaft { stroke-dasharray: 1 2.5; }
.drawing .behind .shaft { stroke-width: 1.3; }
.drawing .motion { color: var(--move); }
.drawing .motion .shaft { stroke: currentColor; stroke-width: 4; }
.drawing .motion.thin .shaft { stroke-width: 2; stroke-dasharray: 1.5 3; }
.drawing .motion .tip .shaft { stroke-width: 2.6; }
.drawing .arc { fill: none; stroke: currentColor; stroke-width: 2.6; }
.drawing .mark { fill: var(--ink); stroke: var(--raised); }
.drawing .mark.slide { fill: var(--friction); }
.drawing .mark.separate { fill: var(--raised); stroke: var(--ink); stroke-width: 1.6; }
.drawing .center { fill: var(--move); stroke: var(--raised); }
.drawing .turning { fill: none; stroke: var(--move); stroke-width: 1.8; }
.drawing .screw { stroke: var(--move); stroke-width: 1.6; stroke-dasharray: 12 3 2 3; }
.drawing .axis { color: var(--soft); }
.drawing .axis .shaft { stroke: currentColor; stroke-width: 1.2; }
.drawing .scale { fill: none; stroke: var(--soft); stroke-width: 1.4; }
.drawing .tick { stroke: var(--soft); stroke-width: 0.8; }
.drawing .bar { fill: var(--normal); }
.drawing .bar.broken { fill: var(--bad); }
.drawing .limit { stroke: var(--bad); stroke-width: 1.6; stroke-dasharray: 6 3; }
.drawing .grid { stroke: var(--line); }
)css";
}

} // namespace lcpush::desktop
