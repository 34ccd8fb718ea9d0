// A face of the polyhedron { z : z >= 0, w = M z + q >= 0 }, in fractions.
#pragma once

#include <bitset>
#include <functional>
#include <optional>
#include <vector>

#include "lcpush/desktop/all_solutions.hpp"
#include "lcpush/desktop/exact_pivots.hpp"

namespace lcpush::desktop {

/// A set of variables: w_i is i, z_i is n + i, and of a cone t is 2n.
using Variables = std::bitset<2 * largest_enumerated + 1>;
inline bool has(const Variables& set, Index v) { return set[static_cast<std::size_t>(v)]; }
inline void add(Variables& set, Index v) { set.set(static_cast<std::size_t>(v)); }

/// In size.
Rational largest_size(const ExactVector& numbers);
void divide_by(ExactVector& numbers, const Rational& divisor);

/// A vertex, or the direction of an edge without end.
struct FaceGenerator {
  ExactVector values; ///< of all variables
  Variables zero;     ///< those >= 0 that are zero
  bool is_ray() const { return values.back().sign() == 0; }
};

/// Is the work to end, with so many generators?
using EndCheck = std::function<bool(std::size_t count)>;

/// The dictionary of one of its vertices, and the variables that are zero on all of it: "fixed".
class PolyhedronFace {
public:
  PolyhedronFace(const ExactMatrix& M, const ExactMatrix& q,
                 const std::vector<unsigned char>& free);

  /// The vertex to begin with, before anything else; false: w and z >= 0 have no point in common.
  [[nodiscard]] bool find_vertex();
  /// The face of it on which `variable` is zero; false: there is none.
  [[nodiscard]] bool fix(Index variable);
  /// False: it is zero on the whole face, and fixed from now on.
  [[nodiscard]] bool can_be_positive(Index variable);
  /// Its row of the dictionary says so.
  bool is_always_positive(Index variable) const;

  Index size() const { return table_.rows(); }
  /// Somewhere on the face both w_i and z_i are positive: such an i, whose choice leaves least to
  /// try. -1: the face is a set of solutions.
  Index open_pair();
  /// Fixes whatever is zero on the whole face, and counts what is left.
  Index dimension();
  /// Of the face; nothing if it was to end.
  std::optional<std::vector<FaceGenerator>> generators(const EndCheck& is_over) const;
  /// Directions of z along which nothing else changes.
  const std::vector<ExactVector>& lines() const { return lines_; }

private:
  Eigen::Matrix<Rational, Eigen::Dynamic, Eigen::Dynamic> table_, values_; // of the dictionary
  Eigen::VectorXi basic_, nonbasic_;
  Variables free_, fixed_;
  Variables positive_; // at a point of this face; so there is one where all of them are
  std::vector<ExactVector> lines_;

  void exchange(Index row, Index column);
  Index entering(Index row, int sign, bool by_bland) const;
  Index blocking(Index column, Index ending) const;
  void take_in_free();
  bool drive_to_zero(Index variable);
  void note_positive();
  void pin(Index variable);
  double distance(Index variable) const;
};

} // namespace lcpush::desktop
