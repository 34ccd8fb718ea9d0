// Linear programs one after the other over the same set: every program starts from the corner
// where the one before ended, a few pivots away. The primal simplex method on a full tableau.
#pragma once

#include <optional>
#include <vector>

#include "dense/settings.hpp"
#include "lcpush/types.hpp"

namespace lcpush::desktop {

/// The set A v = b with v_j >= 0 for all j >= free. The caller's units: numbers near 1.
class Simplex {
public:
  /// `price`: a smaller reduced cost gains nothing.
  Simplex(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, Index free,
          double price = SimplexSettings::price);

  enum class Ending {
    found,     ///< a point; of `minimise` one with the smallest c v
    none,      ///< proved: no point is nearer than `contradicts` to the set
    unbounded, ///< of `minimise` only: c v falls without end
    failed,    ///< out of pivots, a proof that does not hold, or too near to tell
  };
  [[nodiscard]] Ending find_point();
  /// Pre: find_point, or an earlier call of this, has not failed or found none.
  [[nodiscard]] Ending minimise(const Eigen::VectorXd& c);
  /// More variables >= 0, at the end: zero until a program takes them up.
  void add(const Eigen::MatrixXd& columns);

  const Eigen::VectorXd& point() const { return point_; } ///< v of the present corner
  const Eigen::VectorXd& ray() const { return ray_; }     ///< of `unbounded`: from there, largest 1

  /// y of the last program's costs, c over their largest: c - A' y are the reduced costs.
  Eigen::VectorXd multipliers() const;

  Index programs() const { return programs_; }
  double work() const { return work_; } ///< multiplications, about

private:
  using Tableau = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Eigen::MatrixXd A_;
  Eigen::VectorXd b_;
  double price_;
  Index free_, helper_;      // helper: the column that lifts every row to a value >= 0
  Index multipliers_;        // first of the columns that were the identity: now the basis's inverse
  Index value_;              // column of the basic variables' values
  Tableau table_;            // the last row: reduced costs
  std::vector<Index> basic_; // per row; -1: the row follows from others
  std::vector<bool> is_basic_;
  Eigen::VectorXd point_, ray_;
  Index programs_ = 0;
  double work_ = 0;

  Index rows() const { return A_.rows(); }
  bool has_sign(Index row) const { return basic_[static_cast<std::size_t>(row)] >= free_; }
  void pivot(Index row, Index column);
  bool start();
  void refine_prices(const Eigen::VectorXd& c);
  void price(const Eigen::VectorXd& c);
  Index entering(bool first) const;
  Index leaving(Index column, bool first) const;
  Ending descend();
  void read_point();
  bool is_point() const;
  bool is_proved(const Eigen::VectorXd& c) const;
  bool is_ray(const Eigen::VectorXd& c);
};

/// Of the set A v = b, v_j >= 0 for j >= free, a point with the smallest c v; none: the set is
/// empty, c v has no end, or it is not proved that nothing is smaller.
std::optional<Eigen::VectorXd> cheapest_point(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                              const Eigen::VectorXd& c, Index free);

} // namespace lcpush::desktop
