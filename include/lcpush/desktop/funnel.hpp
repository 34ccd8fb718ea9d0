// How a push with a flat edge aligns an object that lies in its grip anyhow: from which angles it
// ends flush, and how much smaller a box of poses is then (docs/guide/design.md).
#pragma once

#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/status.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace lcpush::desktop {

/// A pose in the hand's plane, beside that of the scene: along the edge's normal and along the
/// edge, m, and the turn, rad.
using EdgePose = std::array<double, 3>;

/// A push from one pose, until the object lies flush with the edge.
struct FlushPush {
  EdgePose begin{};
  Status status = Status::running; ///< solved: it ends flush or turns away; running: it has done
                                   ///< neither in all its steps; else why a step has no answer
  bool is_flush = false;
  double contact = 0; ///< m beyond its place in the scene, where the edge touches first
  double way = 0;     ///< m, how far it goes from there
  double along = 0;   ///< m, where the object is then, along the edge
};

struct FunnelReport {
  Index pusher = -1;
  EdgePose box{};               ///< half the sides of the box of poses
  double from = 0, until = 0;   ///< rad: from angles between these an object in the middle of the
                                ///< box turns to the edge
  bool is_capture_known = true; ///< beyond them it turns away; else that is not known
  bool stays = true;            ///< flush in the scene's pose, it is carried so
  double drift = 0; ///< m along the edge for each m that the edge goes, while it is flush
  std::vector<FlushPush> pushes; ///< from the corners of the box, and between
  bool is_flush = false;         ///< all are, then
  double way = 0;                ///< m, from the first touch of any to where all are flush
  double stop = 0;               ///< m, where the edge is then, beyond its place in the scene
  double along_from = 0, along_until = 0; ///< m, between which the object is then along the edge
};

/// The scene's text with its pusher's points on the object: the edge has no end.
std::string with_flat_edge(const std::string& text, const std::string& file_name,
                           const std::string& pusher);

/// Steps of the scene's own laws at the speed of its pusher. Pre: a file of with_flat_edge().
/// Throws InputError: no plane, no edge, or an edge that does not move along its normal. Cost: some
/// thousand steps.
FunnelReport find_funnel(const SceneFile& file, Index pusher, const EdgePose& box);

/// `goal`: where the object is to end.
std::string funnel_text(const SceneFile& file, const FunnelReport& report,
                        const std::optional<EdgePose>& goal);
std::string funnel_json(const SceneFile& file, const FunnelReport& report);

} // namespace lcpush::desktop
