// Which unknowns are basic in an answer whose forces are nearly known.
#pragma once

#include <Eigen/Core>

#include <vector>

#include "lcpush/lcp/problem.hpp"

namespace lcpush::desktop {

/// Sweeps and Newton's method share forces over all points that may bear them; a basis has few more
/// of them than there are motions. Pads press as they give way, and what slides rubs against its
/// slip; how a slip between two generators rubs, who sticks and how rigid points press is open, and
/// is moved to a vertex of what does the same to object and actuators.
class ModesOfForces {
public:
  using Flags = std::vector<unsigned char>;

  /// Do no more actuators share forces than a usual hand has?
  static bool fits(const Problem<double>& problem) {
    return 6 + problem.factored->sums.size <= most_columns;
  }

  /// `z`: the problem's unknowns, multipliers too. Pre: it fits.
  ModesOfForces(const Problem<double>& problem, const double* z);

  /// 1 where z_i is basic for sure.
  Flags plain() const;
  /// 1 where z_i is basic.
  Flags vertex() const;

private:
  /// What a force does: the object's six accelerations, and the actuators' sums.
  static constexpr int most_columns = 12;
  using Column = Eigen::Matrix<double, most_columns, 1>;
  /// Of a force whose share may change from 0 to `most`.
  struct Share {
    Index point, generator, instead; ///< generator -1: none
    double value, most;
    Column column;
  };
  const Problem<double>& problem_;
  const double* z_;
  std::vector<double> w_;
  Eigen::MatrixXd coupling_; ///< sums x unknowns

  const ConeGroup<double>& cone(Index i) const { return problem_.factored->cones[i]; }
  Index points() const { return problem_.factored->cones.size; }
  double rubs(Index i, Index k) const { return z_[cone(i).variable + k]; }
  double friction(Index i) const {
    double sum = 0;
    for (Index k = cone(i).normals; k < cone(i).forces(); ++k) sum += rubs(i, k);
    return sum;
  }
  bool slides(Index i) const {
    if (cone(i).generators == 0 || !(z_[cone(i).slip()] > 1e-9)) return false;
    return friction(i) >= cone(i).friction_limit(z_) * (1 - 1e-9);
  }
  /// The generator that rubs most, or would.
  Index against(Index i) const {
    Index best = cone(i).normals;
    const auto rate = [&](Index k) { return w_[static_cast<std::size_t>(cone(i).variable + k)]; };
    for (Index k = best + 1; k < cone(i).forces(); ++k)
      if (rubs(i, k) > rubs(i, best) || (rubs(i, k) == rubs(i, best) && rate(k) < rate(best)))
        best = k;
    return best;
  }
  bool is_pad(Index i) const { return cone(i).compliance > 0; }
  Column along(const Vector6<double>& object, Index i, Index k) const;
  Column effect(Index i, Index k) const;
  /// The motion that a force feels.
  Column felt(Index i, Index k) const;

  std::vector<Share> open_shares() const;
  static void move_to_vertex(std::vector<Share>& shares);
};

} // namespace lcpush::desktop
