// The numbers of this room. None but the samples' is a tolerance of an answer: each is what
// rounding leaves, or where a search ends. "Not measured": no recorded figure chose it.
#pragma once

namespace lcpush::desktop {

struct ConeSettings {
  /// Directions that are typed along z, or in the plane, are so to this.
  double typed_direction = 1e-6;
  /// Twists nearer than this (rad) are one, and a ray goes by so much of its size beside itself, so
  /// that rounding cannot take it to another facet; `aside` of that across, so that no axis is met.
  double same_twist = 1e-9, aside = 0.6;
  /// rad: a curved boundary is drawn by flat parts so long, by at most so many halvings. Not
  /// measured.
  double drawn_finely = 1e-2;
  int most_halvings = 64;
  /// Shares of two wrenches, crossings that lie on the line of their neighbours, and determinants
  /// over their sizes: zero to rounding.
  double share = 1e-12, same_line = 1e-10, parallel = 1e-14, flat = 1e-12;
  /// Portal refinement ends where the body reaches by less than this beyond the portal, of its
  /// distance: facets are met, smooth bodies refined by Newton's method after it. And after so many
  /// steps: a facet is met in tens. Not measured.
  double facet_slack = 1e-12, smooth_slack = 1e-9;
  int most_steps = 500;
  /// Newton's method: steps at most, the shortest one that counts, and the least part of one.
  int newton_steps = 50;
  double newton_step = 1e-15, newton_part = 1e-3;
  /// The least grip of a pusher at one place: looked for in factors of `grip_step` up to
  /// `grip_most` times what holds the load, beside which the load counts little, then by bisection.
  /// Not measured.
  double grip_step = 1.25, grip_most = 1e4, grip_found = 1e-12, beside_holding = 1e-9;
  /// A cut where a sweep has no segments: samples of the range, to what part of it their bisection
  /// goes, and from how far inside a piece its end is seen. Not measured.
  int samples = 48;
  double sampled_to = 1e-9, inside = 1e-9;
  /// Of the push: a slower slip of a pusher is none. The rounds of pads leave 6e-8 of it.
  double creeps = 2e-7;
  /// What is sampled is not told of pieces narrower than this part of the range: between two
  /// answers the rounds of a law end on one side or the other. Not measured.
  double sliver = 1e-3;
  /// Of what is printed, below which it is rounding.
  double noise = 1e-9;
};

constexpr ConeSettings cone_settings;

} // namespace lcpush::desktop
