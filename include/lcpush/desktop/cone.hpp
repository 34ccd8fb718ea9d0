// The motion cone of a pusher: the twists with which it takes the object along without slipping, in
// the limit of a slow push (docs/theory/theory.md, [T.17] and [T.18]).
#pragma once

#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "lcpush/desktop/telling.hpp"
#include "lcpush/status.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace lcpush::desktop {

struct ConeReport {
  /// Where one extreme wrench of the pusher, one of its points alone at its limit of friction,
  /// takes the object. Twists in scene axes, of the object at its centre of mass, scaled such that
  /// the fastest point of the pusher moves at 1 m/s: [1; rad/m].
  struct Edge {
    Index point = -1;      ///< of the scene
    Vector3<double> slips; ///< unit: where the object is about to slip to at that point
    Vector6<double> twist;
    Vector6<double> wrench; ///< of the pusher on the object, [N; N m] at the centre of mass
  };

  /// The boundary between two edges.
  struct Side {
    std::size_t from = 0, to = 0; ///< edges
    /// What begins there: the object slips over the pusher along `slips`, or turns about `point`
    /// off its other points.
    bool is_slip = false;
    Vector3<double> slips = Vector3<double>::Zero();
    Index point = -1;
    std::vector<Vector6<double>> twists; ///< from edge to edge; flat between neighbours
  };

  /// How a given motion of the pusher fares.
  struct Verdict {
    Vector6<double> twist; ///< of the object at its centre of mass, as given
    bool sticks = false;   ///< inside the cone
    /// It moves away everywhere: it may leave, and where it sticks that is one of two answers.
    bool leaves = false;
    /// rad, of the twists (v_x, v_y, omega L): from it to the nearest twist of the boundary, < 0
    /// from outside; of a pusher that presses at one place, of that place's velocities.
    double margin = 0;
    std::size_t nearest = 0;    ///< the side; of a pusher at one place the edge
    std::optional<double> grip; ///< the least factor on all grip forces with which it sticks;
                                ///< none: with no grip
    double most_grip = 0;       ///< the largest, where there are any; infinite: none is known
  };

  Status status = Status::bad_input; ///< solved; does_not_hold: the load alone moves the object
  Index pusher = -1;
  double length = 1;            ///< m, the L of angles between twists
  bool is_single_place = false; ///< the pusher presses at one place, and turns the object as it may
  std::vector<Edge> edges;      ///< around the cone
  std::vector<Side> sides;
  double holding_grip = 0; ///< the factor on all grip forces that just holds the load
  std::optional<Verdict> verdict;
};

/// `twist`: the pusher's motion to be judged, at the object's centre of mass; none: the scene's
/// own. Throws InputError where the scene is not planar, a finger does not press across the plane
/// with a force of its own, or the pusher has no friction. Cost: O(points facets) for each flat
/// part.
ConeReport find_cone(const SceneFile& file, Index pusher,
                     const std::optional<Vector6<double>>& twist = std::nullopt);

/// A cut through the cone of any scene, in space as well: along one number of the pusher's motion,
/// where does it stick?
struct ConeSlice {
  /// What the push that breaks the grasp is, just inside an end of a range.
  struct End {
    Vector6<double> twist = Vector6<double>::Zero();  ///< the object's, of a unit push
    Vector6<double> wrench = Vector6<double>::Zero(); ///< the pusher's on the object, [N; N m]
  };
  struct Range {
    double from = 0, to = 0;
    Status status = Status::solved; ///< of `break` in its middle
    bool breaks = false;            ///< does the object move? Not where the pusher leaves it
    bool sticks = false;            ///< all its points, in the limit of a slow push
    End at_from, at_to;             ///< zero where it is not solved
    std::vector<Index> changing;    ///< contacts that do something else from `to` on
  };
  Variation variation;
  Index pusher = -1;
  bool is_exact = true;                          ///< ends by parametric pivots; else by bisection
  Stop stop = Stop::none;                        ///< what ended it early
  std::vector<Range> ranges;                     ///< from end to end; neighbours differ
  std::vector<std::pair<double, double>> forces; ///< (value, N) of the push at the ends of pieces
};

/// `pusher`: a body, the only pusher of the scene that moves. By a sweep of the breaking force
/// (sweep.hpp): exact where that is, and by bisection between samples where it has no segments.
/// Throws InputError as sweep_parameter does.
ConeSlice find_slice(const VariedScene& scene, const Variation& variation, Index pusher,
                     const StopCheck& stop = {});

std::string slice_text(const SceneFile& file, const ConeSlice& slice);
std::string slice_json(const SceneFile& file, const ConeSlice& slice);
/// Where it sticks, and how hard the push is that breaks the grasp.
std::string slice_svg(const SceneFile& file, const ConeSlice& slice);

std::string cone_text(const SceneFile& file, const ConeReport& report,
                      Telling telling = Telling::brief);
/// `box`: with what holds for every value; then the angle's margin is `angle_margin`.
std::string cone_json(const SceneFile& file, const ConeReport& report,
                      const BoxAnswer* box = nullptr);
/// The cone in space, and as velocities of the pusher where it presses.
std::string cone_svg(const SceneFile& file, const ConeReport& report);

} // namespace lcpush::desktop
