// The vertices and rays of a face by the double description method [Motzkin et al. 1953; Fukuda and
// Prodon 1996]: a cone with one more coordinate, t, its inequalities taken one after the other.
#include "enumerate/polyhedron_face.hpp"

namespace lcpush::desktop {
namespace {

/// On an edge both are on all inequalities but for a plane's; no other generator is on all of
/// those.
bool are_neighbours(const std::vector<FaceGenerator>& all, const FaceGenerator& a,
                    const FaceGenerator& b, std::size_t coordinates) {
  const Variables common = a.zero & b.zero;
  if (common.count() + 2 < coordinates) return false;
  for (const FaceGenerator& other : all)
    if (&other != &a && &other != &b && (common & ~other.zero).none()) return false;
  return true;
}

/// The part of the cone on which variable v >= 0; false: it is to end.
bool cut(std::vector<FaceGenerator>& all, std::size_t v, std::size_t coordinates,
         const EndCheck& is_over) {
  std::vector<FaceGenerator> kept;
  for (const FaceGenerator& above : all) {
    if (above.values[v].sign() <= 0) continue;
    if (is_over(kept.size())) return false;
    for (const FaceGenerator& below : all) {
      if (below.values[v].sign() >= 0 || !are_neighbours(all, above, below, coordinates)) continue;
      const Rational by = -below.values[v] / above.values[v];
      FaceGenerator edge{below.values, above.zero & below.zero};
      for (std::size_t k = 0; k < edge.values.size(); ++k) edge.values[k] += by * above.values[k];
      kept.push_back(std::move(edge));
    }
  }
  for (FaceGenerator& one : all)
    if (one.values[v].sign() >= 0) kept.push_back(std::move(one));
  for (FaceGenerator& one : kept) one.zero.set(v, one.values[v].sign() == 0);
  all = std::move(kept);
  return true;
}

} // namespace

std::optional<std::vector<FaceGenerator>>
PolyhedronFace::generators(const EndCheck& is_over) const {
  const auto t = static_cast<std::size_t>(2 * size());
  std::vector<FaceGenerator> all;
  Variables coordinates;
  const auto begin_with = [&](Index variable, const auto& column) {
    all.push_back({ExactVector(t + 1), {}});
    const auto value = [&](Index v) -> Rational& {
      return all.back().values[static_cast<std::size_t>(v)];
    };
    value(variable) = 1;
    for (Index i = 0; i < size(); ++i) value(basic_[i]) = column(i);
    all.back().zero.flip(static_cast<std::size_t>(variable)); // of all coordinates it alone is not
    add(coordinates, variable);
  };
  begin_with(2 * size(), values_.col(0));
  for (Index c = 0; c < size(); ++c)
    if (!has(fixed_, nonbasic_[c])) begin_with(nonbasic_[c], table_.col(c));
  for (FaceGenerator& one : all) one.zero ^= coordinates;
  for (Index i = 0; i < size(); ++i)
    if (!has(free_ | fixed_, basic_[i]) &&
        !cut(all, static_cast<std::size_t>(basic_[i]), coordinates.count(), is_over))
      return std::nullopt;
  for (FaceGenerator& one : all) {
    const ExactVector z(one.values.begin() + size(), one.values.end() - 1);
    divide_by(one.values, one.is_ray() ? largest_size(z) : Rational(one.values[t]));
    one.zero |= fixed_;
  }
  return all;
}

} // namespace lcpush::desktop
