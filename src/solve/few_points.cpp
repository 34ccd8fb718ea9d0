#include "solve/few_points.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {

FewPoints::FewPoints(const Problem<double>& whole, Span<const Index> body)
    : whole_(whole), body_(body), is_chosen_(static_cast<std::size_t>(whole.factored->cones.size)),
      sums_of_(static_cast<std::size_t>(whole.size)) {
  const FactoredProblem<double>& factored = *whole.factored;
  for (Index a = 0; a < factored.sums.size; ++a)
    for (Index e = factored.sums[a].first; e < factored.sums[a].first + factored.sums[a].count; ++e)
      sums_of_[static_cast<std::size_t>(factored.coupled_variable[e])].emplace_back(
          a, factored.coupling[e]);
}

FewPoints::Few::Few(const FewPoints& points)
    : factored{points.whole_.factored->mobility, span_of(points.wrenches_),
               span_of(points.cones_),           span_of(points.sums_),
               span_of(points.coupled_),         span_of(points.coupling_)},
      problem{static_cast<Index>(points.origin_.size()),
              static_cast<Index>(points.origin_.size() - points.sums_.size()),
              nullptr,
              &factored,
              points.q_.data(),
              points.push_.empty() ? nullptr : points.push_.data()},
      lemke(structured_lemke_scalars(problem.size, factored.cones.size, shared_actuators(factored)),
            structured_lemke_integers(problem.size, factored.cones.size)) {}

/// The points of a body lie in order along it, so that steps of a golden section spread.
void FewPoints::choose() {
  constexpr Index each = 6;
  const Index points = whole_.factored->cones.size;
  for (Index first = 0, end = 0; first < points; first = end) {
    while (end < points && body_[end] == body_[first]) ++end;
    const Index count = end - first;
    for (Index k = 0; k < std::min(count, each); ++k) {
      const Index at = count <= each ? k : (k * (1 + 382 * count / 1000)) % count;
      is_chosen_[static_cast<std::size_t>(first + at)] = 1;
    }
  }
  // What is held both ways takes no one's place.
  for (Index i = 0; i < points; ++i)
    if (cone(i).normals == 2) is_chosen_[static_cast<std::size_t>(i)] = 1;
}

void FewPoints::gather() {
  wrenches_.clear();
  cones_.clear();
  origin_.clear();
  for (Index i = 0; i < whole_.factored->cones.size; ++i) {
    if (is_chosen_[static_cast<std::size_t>(i)] == 0) continue;
    ConeGroup<double> few = cone(i);
    few.force = static_cast<Index>(wrenches_.size());
    few.variable = static_cast<Index>(origin_.size());
    for (Index k = 0; k < few.forces(); ++k)
      wrenches_.push_back(whole_.factored->wrenches[cone(i).force + k]);
    for (Index k = 0; k < few.size(); ++k) origin_.push_back(cone(i).variable + k);
    cones_.push_back(few);
  }
  gather_sums();
  for (Index i = whole_.free_begin; i < whole_.size; ++i) origin_.push_back(i);
  q_.clear();
  push_.clear();
  for (const Index i : origin_) {
    q_.push_back(whole_.q[i]);
    if (whole_.push != nullptr) push_.push_back(whole_.push[i]);
  }
}

void FewPoints::gather_sums() {
  sums_.clear();
  coupled_.clear();
  coupling_.clear();
  for (Index a = 0; a < whole_.factored->sums.size; ++a) {
    SumGroup<double> few = whole_.factored->sums[a];
    few.first = static_cast<Index>(coupled_.size());
    for (std::size_t i = 0; i < origin_.size(); ++i)
      for (const auto& [sum, coupling] : sums_of_[static_cast<std::size_t>(origin_[i])]) {
        if (sum != a) continue;
        coupled_.push_back(static_cast<int>(i));
        coupling_.push_back(coupling);
      }
    few.count = static_cast<Index>(coupled_.size()) - few.first;
    sums_.push_back(few);
  }
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
  const Index points = whole_.factored->cones.size;
  bool any = false;
  for (Index first = 0, end = 0; first < points; first = end) {
    while (end < points && body_[end] == body_[first]) ++end;
    Index worst = -1;
    double least[2] = {};
    for (Index i = first; i < end; ++i) {
      double rate[2] = {};
      if (is_chosen_[static_cast<std::size_t>(i)] != 0 || sign_of_rate(i, 0, rate) >= 0) continue;
      if (!std::lexicographical_compare(rate, rate + 2, least, least + 2)) continue;
      worst = i;
      std::copy(rate, rate + 2, least);
    }
    if (worst < 0) continue;
    is_chosen_[static_cast<std::size_t>(worst)] = 1;
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
  active.assign(static_cast<std::size_t>(whole_.size), 0);
  for (std::size_t i = 0; i < origin_.size(); ++i)
    active[static_cast<std::size_t>(origin_[i])] = lemke.is_basic(static_cast<Index>(i)) ? 1 : 0;
  for (Index i = 0; i < whole_.factored->cones.size; ++i) {
    if (is_chosen_[static_cast<std::size_t>(i)] != 0 || cone(i).generators == 0) continue;
    const Index against = most_opposed(i);
    if (against < 0) continue;
    active[static_cast<std::size_t>(cone(i).variable + against)] = 1;
    active[static_cast<std::size_t>(cone(i).slip())] = 1;
  }
}

/// The points chosen so far go on from where the others' answer has them.
Status FewPoints::pivot(Few& few, const LemkeOptions<double>& options, const Flags& active) const {
  if (active.empty()) {
    const Status status = few.lemke.init(few.problem, options);
    return status == Status::running ? few.lemke.solve() : status;
  }
  Flags known;
  for (const Index i : origin_) known.push_back(active[static_cast<std::size_t>(i)]);
  const Status status = few.lemke.init(few.problem, options, known.data(), Guess::basis);
  return status == Status::running ? few.lemke.solve() : status;
}

bool FewPoints::solve(const LemkeOptions<double>& options, Flags& active) {
  constexpr int most_joins = 40;
  active.clear();
  choose();
  for (int joins = 0; joins <= most_joins; ++joins) {
    gather();
    Few few(*this);
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
