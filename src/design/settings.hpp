// The numbers of designs.
#pragma once

#include <cstddef>

namespace lcpush::desktop {

struct DesignSettings {
  /// Of a margin: what is no better by this part is as good. And the least margin that counts.
  double better = 1e-7, least_margin = 1e-9;
  double joint = 0.6;    ///< of the work is for all choices together, the rest for each alone
  double finest = 1e-12; ///< of a range: cells are not cut smaller
  /// Looks at a corner, for all choices, about a second; and what else costs so many: a model, a
  /// margin (of each corner), whether the load is held. Measured.
  double work = 3e6, model_work = 6000, margin_work = 60, hold_work = 400, few_work = 1e5;
  /// Places on a grid over choices in which no condition is linear: of one, of each of two, ..
  int grid[5] = {17, 5, 3, 2, 2};
  int halvings = 24;       ///< of a step from the best one
  double enough = 1e6;     ///< N: room that does not matter
  int ways[2] = {9, 3};    ///< that each of a few choices, or of many, may go in a step
  std::size_t most = 12;   ///< choices
  double beyond = 1e-6;    ///< over a margin: there it surely slips
  int curve_steps = 80;    ///< of a picture
  int break_halvings = 40; ///< of such a step, to where another condition binds

  // Funnels. Angles of a box; steps of the edge over what the far end of its face is away, and in
  // all; of the width, what is flush; of an angle, what shows which way it turns: 1/100 has closed
  // forms to 0.1 per cent.
  int angles = 5, flush_steps = 100, most_flush_steps = 1000, capture_halvings = 10;
  double flush = 1e-6, turned_away = 2e-3;
  /// Of the width: so far, in so many steps, what is flush shows whether it stays so.
  double carried = 0.1;
  int carried_steps = 10;
  /// Of a step in which round friction does not settle: the first of two in its place, so often. Of
  /// 24 pushes of turns up to 0.36 rad fourteen had such steps.
  double first_part = 0.45;
  int step_halvings = 4;
};

constexpr DesignSettings design_settings;

} // namespace lcpush::desktop
