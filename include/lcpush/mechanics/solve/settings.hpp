// The numbers of this room, without units unless said: how pads become stiff, and how slow the
// pushes are that break a grasp.
#pragma once

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/types.hpp"

#include <Eigen/Core>

#include <limits>

namespace lcpush {

/// Of a pressure law's proximal iterations ("rounds").
struct PadSettings {
  static constexpr Index most_rounds = 60; ///< a median of 7 is enough (docs/theory/numerics.md)
  /// The factor of a round is no larger than this after rounds that were lost.
  template <class S> static constexpr S slowest() { return S(7) / S(10); }
  static constexpr Index stiff_starts = 2; ///< from the literal basis, if those from nothing fail
  /// The first compliance of each, beside the one before.
  template <class S> static constexpr S stiff_start() { return S(1) / S(100); }
  /// Rounds begin anew so often. Of 900 boxes dragged over four points, 29 went otherwise by more
  /// than 1e-3 where the scene was turned; after one such start 2, after three none.
  static constexpr Index retraces = 3;
  /// A squeeze that rounds only tighten: a normal force beyond this, in what the scene's forces and
  /// prescribed motions ask for.
  static constexpr int runaway = 1000;
};

/// What may be asked of them.
template <class S> struct PressureOptions {
  S first_compliance{S(1) / S(100)}; ///< eps of round 1: a hundredth of the grip's force over mass,
                                     ///< so that a pad's modes are nearly those of the end
  S factor{S(0.31622776601683794)};  ///< eps falls by this a round, 10^-1/2; the fewest pivots of
                                     ///< 10^-1/4 to 10^-1 on random grasps
  Index max_turns = 64; ///< of round friction's pyramids; Newton's method takes 4, loads within
                        ///< 1e-4 of the limit of friction up to 60
  Index max_pivots = 0; ///< of all rounds together; 0: the solver's limits alone
  S tolerance = Tolerances<S>().settled; ///< scaled violation of the literal [T.2] allowed
  Index fine_rounds = 0; ///< so many more at most, while the violation or the distance from
                         ///< [T.16] is above `finest`
  S finest{0};
  bool exact_limit = true; ///< a breaking force by an infinitesimal push, where rounds carry one
  bool goes_on = false;    ///< `pad`: from the memory's last answer, as if this were its next round
  bool keeps_cones =
      false; ///< round friction: from the cones as an interrupted solve has left them
};

/// Of round friction: which points' pyramids turn, by how much of mu lambda their friction takes
/// up.
struct RoundSettings {
  /// Cold attempts of a motion's step, and pivots an unknown in each: what takes more settles under
  /// no cover (a driver's ring of eight points that stick: 65,000 pivots in vain).
  static constexpr int step_attempts = 2, step_pivots = 20;
  template <class S> static constexpr S slides() { return S(0.5); } ///< less is on its way to stick
  template <class S> static constexpr S sticks() { return S(0.9); } ///< less is far from slipping
  /// Of so many turns each is as long as friction's power falls, the others are whole: then none of
  /// 164 slow pushes is left unsettled, and no more loads near the limit.
  static constexpr Index damped_turns = 48;
  /// The fastest slip beside that of the iteration before, below which points are about to stick.
  /// Of 2,600 loads near the limit of friction 0.25 leaves the fewest open of 0, 0.1, 0.25, 0.5.
  template <class S> static constexpr S halts() { return S(0.25); }
  template <class S> static constexpr S least_step() { return S(0.01); } ///< less is a stall
  template <class S> static constexpr S step_error() { return S(1) / S(1024); }
  /// Below this the force is on an edge of its pyramid, which gives way before the circle does.
  template <class S> static constexpr S corner() { return S(0.9999); }
};

/// The numbers of breaking; accelerations in units of F / m.
template <class S> struct BreakingSettings {
  static constexpr int most_pushes = 5; ///< three make a line; each of two more is a tenth again,
                                        ///< where a change of mode has bent it
  /// Of pads under round friction, a push from nothing: those that settle at once were seen to
  /// take up to one an unknown, the others five to fifty.
  static constexpr Index pivots_an_unknown = 4;
  S first_push{S(1) / S(1000)};      ///< below it the line's error is rounding's (theory 6)
  S first_swept_push{S(1) / S(100)}; ///< sweeps see less far down
  S fastest_push{S(1) / S(9)};       ///< the line is of smaller ones: beyond, inertia tells
  S step{10};                        ///< each push is a tenth of the one before
  /// A third push this near the line is on it, over the force of breaking, or over F times
  /// small_force where that is less: rounding leaves 1e-13 of F (numerics.md).
  S straight{S(1) / S(1000000)};
  S small_force{S(1) / S(1000)};
  S own_motion{16}; ///< what is left at rest, in smallest pushes, may be those pushes' own doing
  /// What rounding lets pads settle to: of a slow push's motion they may spoil little.
  S finest_pads = Eigen::numext::maxi(S(512 * std::numeric_limits<double>::epsilon()),
                                      S(16 * Eigen::NumTraits<S>::epsilon()));
  /// Of the push: a slower object does not move with it. Pads of 576 unknowns that a belt slides
  /// under have left 3e-5; a lever of 1 : 98 moves with 1e-2.
  S slowest_twist{S(1) / S(10000)};
};

/// Below this (in units of F / m) an acceleration counts as none: what rounding may leave, but
/// never what somebody would see.
template <class S> constexpr S at_rest() {
  const S rounding = S(1024) * Tolerances<S>().residual, seen = S(3) / S(1000);
  return rounding < seen ? rounding : seen;
}

/// In units of F / m: a slower push drowns in what the residual check lets pass.
template <class S> constexpr S smallest_push() { return S(256) * Tolerances<S>().residual; }

} // namespace lcpush
