// The linear equations of contacts that all keep to their behaviour: which of their solutions are
// directions in which the answer could move?
#pragma once

#include "lcpush/mechanics/model/assemble.hpp"

#include <Eigen/Core>

#include <vector>

namespace lcpush::desktop {

struct OpenDirections {
  bool motion = false; ///< one changes the object's acceleration
  bool wrench = false; ///< one changes the pushers' total wrench
};

/// Unknowns are the motion a' = [a; s] of the object and the actuators and the contacts' forces f,
/// in the assembly's units; D a' = E f balances them, J a' + C f = 0 says what stays where. J and E
/// have few rows (columns) and many columns, so that orthogonal factors of both leave a system of
/// the size of a'. Cost: O(points (6 + actuators)^2).
class ContactSystem {
public:
  explicit ContactSystem(const Assembly<double>& assembly);

  /// The contact's motion along `wrench` is 0.
  void stay(Index i, const Vector6<double>& wrench);
  /// It may press by any force along `wrench`.
  void push(Index i, const Vector6<double>& wrench);
  /// Its motion along `normal` is what its pad yields to the force, `force` a unit.
  void press(Index i, const Vector6<double>& normal, const Vector6<double>& force);

  OpenDirections open_directions() const;

private:
  using MatrixXd = Eigen::MatrixXd;
  using VectorXd = Eigen::VectorXd;
  /// A matrix that is made column by column.
  struct Columns {
    Index rows;
    std::vector<double> numbers{};

    void add(const VectorXd& column) {
      numbers.insert(numbers.end(), column.begin(), column.end());
    }
    Eigen::Map<const MatrixXd> matrix() const {
      return {numbers.data(), rows, static_cast<Index>(numbers.size()) / rows};
    }
  };

  const Assembly<double>& assembly_;
  Index motions_;            // of a'
  Columns stays_;            // rows of J without compliance
  Columns pushes_;           // forces without it: what they do to a', and the pushers' wrench
  Columns pads_, pads_push_; // the same of yielding contacts
  std::vector<double> compliance_;

  VectorXd along(Index i, const Vector6<double>& wrench) const;
  VectorXd with_pushers(Index i, const Vector6<double>& wrench) const;
  MatrixXd balance_rows(const MatrixXd& effect) const;
  MatrixXd inertial(MatrixXd motion) const;
};

} // namespace lcpush::desktop
