// Do stiff supports share a load in more than one way? What `solve` says of its answer.
#include "lcpush/desktop/spread.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "spread/settings.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <functional>

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

/// Of three contacts or more, all of them single points: what sticks may share its friction.
bool are_points(const SceneFile& file) {
  constexpr std::size_t least = 3;
  return file.bodies.size() >= least &&
         std::all_of(file.bodies.begin(), file.bodies.end(),
                     [](const Body<double>& body) { return body.point_count == 1; });
}

using IsOpen = std::function<bool(const ContactSpread&)>;

std::string open_words(const SceneFile& file, const SpreadReport& spread,
                       const std::vector<Index>& bodies, const char* what, const IsOpen& is_open) {
  std::vector<std::string> names;
  for (const Index b : bodies) {
    const Indices points = points_of(file.body(b));
    if (std::any_of(points.begin(), points.end(),
                    [&](Index i) { return is_open(spread.contacts[static_cast<std::size_t>(i)]); }))
      names.push_back(file.body_name(b));
  }
  return names.size() < 2
             ? ""
             : "\nThe laws leave open how " + listed(names, "and") + " share their " + what +
                   ": one way of it is shown.\nSee: lcpush spread " + file.lines.file + "\n";
}

} // namespace

std::string sharing_sentence(const SceneFile& file, const Answer<double>& answer) {
  const std::vector<Index> supports = stiff_supports(file);
  if (supports.empty() && !are_points(file)) return "";
  SpreadOptions options;
  options.covering_vectors = SpreadSettings::sharing_covers;
  options.enumeration = Enumeration::none;
  options.most_faces = SpreadSettings::sharing_faces;
  const SpreadReport spread = find_spread(file, options);
  if (spread.status != Status::solved) return "";
  const double same = same_force(spread);
  const std::string load = open_words(file, spread, supports, "load", [&](const ContactSpread& at) {
    return !is_single(at.normal, same);
  });
  if (!load.empty() || !are_points(file)) return load;
  std::vector<Index> sticking;
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b)
    if (answer.contacts[file.body(b).first_point].mode == Mode::stick) sticking.push_back(b);
  return open_words(file, spread, sticking, "friction", [&](const ContactSpread& at) {
    return is_single(at.normal, same) &&
           (!is_single(at.tangential[0], same) || !is_single(at.tangential[1], same));
  });
}

} // namespace lcpush::desktop
