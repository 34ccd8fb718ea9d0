#include "solve/part_of_problem.hpp"

namespace lcpush::desktop {

PartOfProblem::PartOfProblem(const Problem<double>& whole)
    : whole_(whole), is_chosen_(static_cast<std::size_t>(whole.size)) {}

PartOfProblem::Part::Part(const PartOfProblem& chosen)
    : factored{chosen.whole_.factored->mobility, span_of(chosen.wrenches_),
               span_of(chosen.cones_),           span_of(chosen.sums_),
               span_of(chosen.coupled_),         span_of(chosen.coupling_)},
      problem{static_cast<Index>(chosen.origin_.size()),
              static_cast<Index>(chosen.origin_.size() - chosen.sums_.size()),
              nullptr,
              &factored,
              chosen.q_.data(),
              chosen.push_.empty() ? nullptr : chosen.push_.data()},
      lemke(structured_lemke_scalars(problem.size, factored.cones.size, shared_actuators(factored)),
            structured_lemke_integers(problem.size, factored.cones.size)) {}

void PartOfProblem::gather() {
  wrenches_.clear();
  cones_.clear();
  origin_.clear();
  for (Index i = 0; i < points(); ++i) {
    if (!is_chosen(cone(i).variable)) continue;
    ConeGroup<double> part = cone(i);
    part.force = static_cast<Index>(wrenches_.size());
    part.variable = static_cast<Index>(origin_.size());
    part.generators = 0;
    for (Index k = 0; k < cone(i).size(); ++k) {
      if (!is_chosen(cone(i).variable + k)) continue;
      origin_.push_back(cone(i).variable + k);
      if (k >= cone(i).forces()) continue; // the slip
      wrenches_.push_back(whole_.factored->wrenches[cone(i).force + k]);
      if (k >= cone(i).normals) ++part.generators;
    }
    cones_.push_back(part);
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

void PartOfProblem::gather_sums() {
  std::vector<int> place(static_cast<std::size_t>(whole_.size), -1);
  for (std::size_t i = 0; i < origin_.size(); ++i)
    place[static_cast<std::size_t>(origin_[i])] = static_cast<int>(i);
  sums_.clear();
  coupled_.clear();
  coupling_.clear();
  for (SumGroup<double> sum : whole_.factored->sums) {
    const Index first = sum.first, end = first + sum.count;
    sum.first = static_cast<Index>(coupled_.size());
    for (Index e = first; e < end; ++e) {
      const auto unknown = static_cast<std::size_t>(whole_.factored->coupled_variable[e]);
      if (place[unknown] < 0) continue;
      coupled_.push_back(place[unknown]);
      coupling_.push_back(whole_.factored->coupling[e]);
    }
    sum.count = static_cast<Index>(coupled_.size()) - sum.first;
    sums_.push_back(sum);
  }
}

PartOfProblem::Flags PartOfProblem::part_of(const Flags& flags) const {
  Flags part;
  part.reserve(origin_.size());
  for (const Index i : origin_) part.push_back(flags[static_cast<std::size_t>(i)]);
  return part;
}

PartOfProblem::Flags PartOfProblem::basis_of(const StructuredLemke<double>& lemke) const {
  Flags active(static_cast<std::size_t>(whole_.size));
  for (std::size_t i = 0; i < origin_.size(); ++i)
    active[static_cast<std::size_t>(origin_[i])] = lemke.is_basic(static_cast<Index>(i)) ? 1 : 0;
  return active;
}

} // namespace lcpush::desktop
