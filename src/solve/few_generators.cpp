#include "solve/few_generators.hpp"

#include <algorithm>

#include "solve/basis_values.hpp"
#include "solve/newton_start.hpp"

namespace lcpush::desktop {

bool FewGenerators::helps(const Problem<double>& problem) {
  const Span<const ConeGroup<double>>& cones = problem.factored->cones;
  return std::any_of(cones.begin(), cones.end(),
                     [](const ConeGroup<double>& cone) { return cone.generators >= 2 * coarse; });
}

void FewGenerators::choose(const Flags& active) {
  for (Index i = 0; i < points(); ++i) {
    const Index stride = std::max<Index>(1, cone(i).generators / coarse);
    for (Index k = 0; k < cone(i).size(); ++k) {
      const bool is_generator = k >= cone(i).normals && k < cone(i).forces();
      const Index unknown = cone(i).variable + k;
      if (!is_generator || (k - cone(i).normals) % stride == 0 ||
          active[static_cast<std::size_t>(unknown)] != 0)
        chosen(unknown) = 1;
    }
  }
}

/// The generator and its neighbours. False: they have been chosen before.
bool FewGenerators::take(Index i, Index generator) {
  const Index g = cone(i).generators, first = cone(i).variable + cone(i).normals;
  bool any = false;
  for (const Index k : {generator, generator + 1, generator + g - 1}) {
    unsigned char& flag = chosen(first + k % g);
    any = any || flag == 0;
    flag = 1;
  }
  return any;
}

/// Points whose slip another generator opposes more take it, and turn to it if they slide along
/// one; `rates`: w_i where z_i is not basic. False: there are none.
bool FewGenerators::join(const std::vector<double>& rates, Flags& active) {
  constexpr double clearly = 1e-12;
  bool any = false;
  for (Index i = 0; i < points(); ++i) {
    const Index first = cone(i).variable + cone(i).normals, g = cone(i).generators;
    Index opposed = -1, rubs = -1, count = 0;
    double least = -clearly;
    for (Index k = 0; k < g; ++k) {
      const auto unknown = static_cast<std::size_t>(first + k);
      if (active[unknown] != 0) {
        rubs = k;
        ++count;
      } else if (rates[unknown] < least) {
        least = rates[unknown];
        opposed = k;
      }
    }
    if (opposed < 0 || !take(i, opposed)) continue;
    any = true;
    if (count != 1 || active[static_cast<std::size_t>(cone(i).slip())] == 0) continue;
    active[static_cast<std::size_t>(first + rubs)] = 0;
    active[static_cast<std::size_t>(first + opposed)] = 1;
  }
  return any;
}

/// A few points against the basis that has turned are a few pivots, or hundreds: who slips between
/// two generators turns at all points. So Newton's method has a try before those.
Status FewGenerators::pivot(Part& part, const LemkeOptions<double>& options,
                            const std::vector<double>& z, const Flags& active) const {
  constexpr Index few = 8, patience = 16; // points, pivots
  LemkeOptions<double> own = options;
  own.covers = 1;
  own.max_pivots = patience;
  Flags known = part_of(active);
  std::vector<double> values;
  Status status = part.lemke.init(part.problem, own, known.data(), Guess::near);
  if (status == Status::running && points_against(part.lemke, part.problem, values) <= few &&
      part.lemke.solve() == Status::solved)
    return Status::solved;
  values.clear();
  for (const Index i : origin_) values.push_back(z[static_cast<std::size_t>(i)]);
  (void)settle_pads(part.problem, values, known);
  own.covers = 2;
  own.max_pivots = part.problem.size;
  status = part.lemke.init(part.problem, own, known.data(), Guess::near);
  return status == Status::running ? part.lemke.solve() : status;
}

bool FewGenerators::solve(const LemkeOptions<double>& options, const std::vector<double>& values,
                          Guess guess, std::vector<double>& z, Flags& active) {
  constexpr int most_joins = 20;
  choose(active);
  if (guess == Guess::basis) (void)join(values, active);
  for (int joins = 0; joins <= most_joins; ++joins) {
    gather();
    Part part(*this);
    if (pivot(part, options, z, active) != Status::solved) return false;
    active = basis_of(part.lemke);
    std::fill(z.begin(), z.end(), 0.0);
    for (std::size_t i = 0; i < origin_.size(); ++i)
      z[static_cast<std::size_t>(origin_[i])] = part.lemke.z()[i];
    std::vector<double> rates(z.size());
    multiply(whole_, z.data(), rates.data());
    for (std::size_t i = 0; i < rates.size(); ++i) rates[i] += whole_.q[i];
    if (!join(rates, active)) return true;
  }
  return false;
}

} // namespace lcpush::desktop
