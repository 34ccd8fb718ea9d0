// A problem with some of its unknowns left out, for the solver.
#pragma once

#include <vector>

#include "lcpush/desktop/owned.hpp"
#include "lcpush/lcp/pivots/structured_lemke.hpp"

namespace lcpush::desktop {

/// Points, or generators of points, that are taken into a smaller problem; free unknowns always
/// are.
class PartOfProblem {
public:
  using Flags = std::vector<unsigned char>;

protected:
  /// `whole` outlives the part.
  explicit PartOfProblem(const Problem<double>& whole);

  const Problem<double>& whole_;
  Flags is_chosen_; // unknowns

  // The problem of the unknowns that are chosen, and where they come from.
  std::vector<Vector6<double>> wrenches_;
  std::vector<ConeGroup<double>> cones_;
  std::vector<SumGroup<double>> sums_;
  std::vector<int> coupled_;
  std::vector<double> coupling_, q_, push_;
  std::vector<Index> origin_;

  /// That problem as the solver takes it.
  struct Part {
    FactoredProblem<double> factored;
    Problem<double> problem;
    Owned<StructuredLemke<double>> lemke;
    explicit Part(const PartOfProblem& chosen);
    Part(const Part&) = delete; // it looks into itself
    Part& operator=(const Part&) = delete;
  };

  const ConeGroup<double>& cone(Index i) const { return whole_.factored->cones[i]; }
  Index points() const { return whole_.factored->cones.size; }
  unsigned char& chosen(Index unknown) { return is_chosen_[static_cast<std::size_t>(unknown)]; }
  bool is_chosen(Index unknown) const { return is_chosen_[static_cast<std::size_t>(unknown)] != 0; }
  /// Fills what the part is made of. A point whose normal force is not chosen is left out.
  void gather();
  /// Those of the whole, of the unknowns that are chosen.
  Flags part_of(const Flags& flags) const;
  /// 1 where z_i of the whole is basic in the part.
  Flags basis_of(const StructuredLemke<double>& lemke) const;

private:
  void gather_sums();
};

} // namespace lcpush::desktop
