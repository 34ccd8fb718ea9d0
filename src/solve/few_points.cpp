#include "solve/few_points.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {

FewPoints::FewPoints(const Problem<double>& whole, Span<const Index> body)
    : PartOfProblem(whole), body_(body), sums_of_(static_cast<std::size_t>(whole.size)) {
  const FactoredProblem<double>& factored = *whole.factored;
  for (Index a = 0; a < factored.sums.size; ++a)
    for (Index e = factored.sums[a].first; e < factored.sums[a].first + factored.sums[a].count; ++e)
      sums_of_[static_cast<std::size_t>(factored.coupled_variable[e])].emplace_back(
          a, factored.coupling[e]);
}

void FewPoints::take(Index i) {
  std::fill_n(&chosen(cone(i).variable), cone(i).size(), static_cast<unsigned char>(1));
}

/// The points of a body lie in order along it, so that steps of a golden section spread.
void FewPoints::choose() {
  constexpr Index each = 6;
  for (Index first = 0, end = 0; first < points(); first = end) {
    while (end < points() && body_[end] == body_[first]) ++end;
    const Index count = end - first;
    for (Index k = 0; k < std::min(count, each); ++k) {
      const Index at = count <= each ? k : (k * (1 + 382 * count / 1000)) % count;
      take(first + at);
    }
  }
  // What is held both ways takes no one's place.
  for (Index i = 0; i < points(); ++i)
    if (cone(i).normals == 2) take(i);
}

void FewPoints::read_motions(const StructuredLemke<double>& lemke) {
  motions_.assign(whole_.push != nullptr ? 2 : 1, {});
  const double* const solutions[] = {lemke.z(), lemke.z_push()};
  for (std::size_t part = 0; part < motions_.size(); ++part) {
    const double* const z = solutions[part];
    Vector6<double> wrench = Vector6<double>::Zero();
    double sizes = 0;
    for (const ConeGroup<double>& few : cones_)
      for (Index k = 0; k < few.forces(); ++k) {
        const Vector6<double> part_of =
            wrenches_[static_cast<std::size_t>(few.force + k)] * z[few.variable + k];
        wrench += part_of;
        sizes += part_of.norm();
      }
    motions_[part].size = whole_.factored->mobility.norm() * sizes;
    motions_[part].object = whole_.factored->mobility.lazyProduct(wrench);
    const std::size_t free_begin = origin_.size() - sums_.size();
    motions_[part].closing.assign(z + free_begin, z + origin_.size());
  }
}

/// The rate of force k of point i, at rest and by the push; and its sign, of the first that counts.
int FewPoints::sign_of_rate(Index i, Index k, double (&rate)[2]) const {
  constexpr double clearly = 1e-12;
  const Index variable = cone(i).variable + k;
  int sign = 0;
  for (std::size_t part = 0; part < motions_.size(); ++part) {
    const double* const q = part == 0 ? whole_.q : whole_.push;
    const double moved = whole_.factored->wrenches[cone(i).force + k].dot(motions_[part].object);
    rate[part] = moved + q[variable];
    double size = motions_[part].size + std::abs(q[variable]);
    for (const auto& [sum, coupling] : sums_of_[static_cast<std::size_t>(variable)]) {
      const double closes = coupling * motions_[part].closing[static_cast<std::size_t>(sum)];
      rate[part] -= closes;
      size += std::abs(closes);
    }
    if (!(std::abs(rate[part]) > clearly * size)) rate[part] = 0;
    if (sign == 0) sign = rate[part] < 0 ? -1 : rate[part] > 0 ? 1 : 0;
  }
  return sign;
}

/// The points that are pressed into their bodies most, one a body. False: there are none.
bool FewPoints::join() {
  bool any = false;
  for (Index first = 0, end = 0; first < points(); first = end) {
    while (end < points() && body_[end] == body_[first]) ++end;
    Index worst = -1;
    double least[2] = {};
    for (Index i = first; i < end; ++i) {
      double rate[2] = {};
      if (is_chosen(cone(i).variable) || sign_of_rate(i, 0, rate) >= 0) continue;
      if (!std::lexicographical_compare(rate, rate + 2, least, least + 2)) continue;
      worst = i;
      std::copy(rate, rate + 2, least);
    }
    if (worst < 0) continue;
    take(worst);
    any = true;
  }
  return any;
}

/// The generator that friction would act along; -1: the point does not slip.
Index FewPoints::most_opposed(Index i) const {
  Index best = -1;
  double least[2] = {};
  for (Index k = cone(i).normals; k < cone(i).forces(); ++k) {
    double rate[2] = {};
    if (sign_of_rate(i, k, rate) >= 0) continue;
    if (!std::lexicographical_compare(rate, rate + 2, least, least + 2)) continue;
    best = k;
    std::copy(rate, rate + 2, least);
  }
  return best;
}

void FewPoints::mark(const StructuredLemke<double>& lemke, Flags& active) const {
  active = basis_of(lemke);
  for (Index i = 0; i < points(); ++i) {
    if (is_chosen(cone(i).variable) || cone(i).generators == 0) continue;
    const Index against = most_opposed(i);
    if (against < 0) continue;
    active[static_cast<std::size_t>(cone(i).variable + against)] = 1;
    active[static_cast<std::size_t>(cone(i).slip())] = 1;
  }
}

/// The points chosen so far go on from where the others' answer has them.
Status FewPoints::pivot(Part& few, const LemkeOptions<double>& options, const Flags& active) const {
  if (active.empty()) {
    const Status status = few.lemke.init(few.problem, options);
    return status == Status::running ? few.lemke.solve() : status;
  }
  const Flags known = part_of(active);
  const Status status = few.lemke.init(few.problem, options, known.data(), Guess::basis);
  return status == Status::running ? few.lemke.solve() : status;
}

bool FewPoints::solve(const LemkeOptions<double>& options, Flags& active) {
  constexpr int most_joins = 40;
  active.clear();
  choose();
  for (int joins = 0; joins <= most_joins; ++joins) {
    gather();
    Part few(*this);
    if (pivot(few, options, active) != Status::solved) return false;
    const bool is_settled =
        joins > 0 && few.lemke.pivots() == 0; // the last to join did so by rounding
    read_motions(few.lemke);
    mark(few.lemke, active);
    if (is_settled || !join()) return true;
  }
  return false;
}

} // namespace lcpush::desktop
