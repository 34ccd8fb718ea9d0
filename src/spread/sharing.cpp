// Do stiff supports share a load in more than one way? What `solve` says of its answer.
#include "lcpush/desktop/spread.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "spread/settings.hpp"
#include "text/wording.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

/// Feet, rails of two points, corners, a V: rigid bodies that stand still and bear the object at so
/// few points that no law of pads says how they share it; none where patches press beside them.
std::vector<Index> stiff_supports(const SceneFile& file) {
  std::vector<Index> supports;
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    const Body<double>& body = file.body(b);
    if (body.point_count > SpreadSettings::few_points) return {};
    if (body.role != Role::finger || is_driven(file.view(), b) || body.preload > 0) continue;
    supports.push_back(b);
  }
  return supports.size() > 1 ? supports : std::vector<Index>();
}

} // namespace

std::string sharing_sentence(const SceneFile& file) {
  const std::vector<Index> supports = stiff_supports(file);
  if (supports.empty()) return "";
  SpreadOptions options;
  options.covering_vectors = SpreadSettings::sharing_covers;
  options.enumeration = Enumeration::none;
  options.most_faces = SpreadSettings::sharing_faces;
  const SpreadReport spread = find_spread(file, options);
  if (spread.status != Status::solved) return "";
  std::vector<std::string> names;
  for (const Index b : supports) {
    const auto is_open = [&](Index i) {
      return !is_single(spread.contacts[static_cast<std::size_t>(i)].normal, same_force(spread));
    };
    const Indices points = points_of(file.body(b));
    if (std::any_of(points.begin(), points.end(), is_open)) names.push_back(file.body_name(b));
  }
  return names.size() < 2 ? ""
                          : "\nThe laws leave open how " + listed(names, "and") +
                                " share their load: one way of it is shown.\nSee: lcpush spread " +
                                file.lines.file + "\n";
}

} // namespace lcpush::desktop
