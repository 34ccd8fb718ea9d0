// Every solution of a small linear complementarity problem, and every equilibrium of a bimatrix
// game, in fractions: no tolerance decides anything.
#pragma once

#include <string>
#include <vector>

#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/stop.hpp"
#include "lcpush/desktop/telling.hpp"

namespace lcpush::desktop {

using ExactVector = std::vector<Rational>;

/// w = M z + q; of a game z holds the probabilities, the row player's first, and w what the two
/// players get.
struct SolutionPoint {
  ExactVector z, w;
};

/// A convex set of solutions that is part of no larger one.
struct SolutionSet {
  std::vector<Index> vertices, rays; ///< numbers of points and rays
  Index dimension = 0;
  Index component = -1; ///< sets that hang together have one number; -1: an isolated solution
};

struct AllSolutions {
  std::vector<SolutionPoint> points;
  std::vector<ExactVector> rays; ///< directions of z, largest entry 1; a line is two of them
  std::vector<SolutionSet> sets; ///< in the order of components
  Index cases = 0;               ///< choices of w_i = 0 or z_i = 0 that were followed
  Index most = 0;                ///< the search ended at so many sets, or vertices
  Stop stop = Stop::none;

  bool complete() const { return most == 0 && stop == Stop::none; }
};

struct AllOptions {
  Index most = 10000; ///< sets, or vertices and rays: 20 pairs can have a million
  StopCheck stop;
};

/// A set of variables is so many pairs of bits.
constexpr Index largest_enumerated = 64;

/// Of w = M z + q, 0 <= z _|_ w >= 0; rows that are marked free: w = 0, z free.
/// Pre: M is n x n, q has n numbers, n <= largest_enumerated.
AllSolutions all_solutions(const ExactMatrix& M, const ExactMatrix& q,
                           const std::vector<unsigned char>& free, const AllOptions& options);

/// Of the game in which the row player gets A, the column player B.
/// Pre: of one size, rows + columns <= largest_enumerated, neither of them 0.
AllSolutions all_equilibria(const ExactMatrix& A, const ExactMatrix& B, const AllOptions& options);

/// How the answer is told: of a game the row player has `rows` actions, else 0.
struct AllWording {
  Index rows = 0;
  bool is_exact = false; ///< fractions; else the nearest doubles
};
/// "3 solutions, and that is all."
std::string all_solutions_sentence(const AllSolutions& found, const AllWording& wording = {});
std::string all_solutions_text(const AllSolutions& found, const AllWording& wording,
                               Telling telling);
std::string all_solutions_json(const AllSolutions& found, const AllWording& wording);
/// Of w = M z + q with two or three unknowns; of two without a free row q among its cones as well.
std::string all_solutions_svg(const AllSolutions& found, const ExactMatrix& M, const ExactMatrix& q,
                              bool has_cones);

} // namespace lcpush::desktop
