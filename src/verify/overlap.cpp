// Do the object and what it touches go into each other? The laws' own steps do not ask: a point
// that begins deep inside its face is none that they know.
#include "verify/settings.hpp"
#include "verify/trajectory_steps.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

/// How deep a point is in its face, step by step, since it was last in front of it.
struct Depth {
  bool is_known = false; ///< a point that came round an edge is none that its face stops
  double first = 0;      ///< m, when it was first known
  double most = 0;       ///< m, deeper than that
  double until = 0;      ///< s, when it was
};

} // namespace

Overlap find_overlap(const SceneFile& file, const std::vector<TrajectoryFrame>& frames) {
  SeenMotion seen(file, frames);
  const double size = object_size(file), nothing = VerifySettings::digits * size;
  Overlap worst;
  std::vector<Depth> depths(file.points.size());
  for (std::size_t k = 1; k < frames.size(); ++k) {
    const SeenStep step = seen.step(k);
    for (std::size_t i = 0; i < depths.size(); ++i) {
      const SeenContact& contact = step.contacts[i];
      Depth& depth = depths[i];
      const bool is_seen = step.is_whole && contact.touches && contact.gap && contact.gap_before;
      const double before = is_seen ? std::max(0.0, -*contact.gap_before) : 0,
                   now = is_seen ? std::max(0.0, -*contact.gap) : 0;
      const bool was_known = depth.is_known;
      depth.is_known = is_seen && (was_known || before <= nothing || k == 1);
      if (!depth.is_known) continue;
      if (!was_known) depth.first = before;
      if (now - depth.first > depth.most) {
        depth.most = now - depth.first;
        depth.until = step.time;
      }
      const double deeper = now - before - contact.missed - nothing;
      const bool is_geometry = now - depth.first <= VerifySettings::gap * size; // of two programs
      if (is_geometry || !(deeper > worst.speed * step.h)) continue;
      worst.point = static_cast<Index>(i);
      worst.speed = deeper / step.h;
      worst.time = step.time;
    }
  }
  if (worst.point < 0) return worst;
  worst.depth = depths[static_cast<std::size_t>(worst.point)].most;
  worst.until = depths[static_cast<std::size_t>(worst.point)].until;
  return worst;
}

} // namespace lcpush::desktop
