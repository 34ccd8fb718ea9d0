// The numbers of designs.
#pragma once

namespace lcpush::desktop {

struct DesignSettings {
  /// Of a margin: what is no better by this part is as good. And the least margin that counts.
  double better = 1e-7, least_margin = 1e-9;
  double finest = 1e-12; ///< of a range: cells are not cut smaller
  /// Looks at a corner, for all choices, about a second; and what else costs so many: a model, a
  /// margin (of each corner), whether the load is held. Measured.
  double work = 4e6, model_work = 12000, margin_work = 60, hold_work = 400, few_work = 1e5;
  /// Places on a grid over choices in which no condition is linear: of one, of two, of each of
  /// more.
  int grid[3] = {33, 7, 4};
  int halvings = 24;       ///< of the grid's step around the best one
  double beyond = 1e-6;    ///< over a margin: there it surely slips
  int curve_steps = 80;    ///< of a picture
  int break_halvings = 40; ///< of such a step, to where another condition binds
};

constexpr DesignSettings design_settings;

} // namespace lcpush::desktop
