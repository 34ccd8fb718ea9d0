// A complementary face: the answers in which every contact keeps its mode. They are a polyhedron,
// here with its equations solved: z = origin + directions t, over which signs are all that is left.
#pragma once

#include "solve/owned_program.hpp"
#include "spread/spread_problem.hpp"

namespace lcpush::desktop {

class Face {
public:
  Face(const LiteralProblem& problem, const FaceModes& modes);

  Index dimension() const { return directions_.cols(); }

  /// Moves the origin to z, a point of the face up to rounding. False if it is none.
  bool start_at(const Eigen::VectorXd& z);

  enum class Point {
    found,
    none,      ///< proved: no point of the face
    unbounded, ///< of `lowest` only: the value falls without end
    failed,    ///< the linear program's pivots, or a proof, or too near to tell
  };
  /// Some point of the face becomes the origin.
  Point find_point();
  Eigen::VectorXd origin() const { return whole(origin_); }
  /// Does the functional f z vary on the face's equations?
  bool varies(const Eigen::VectorXd& f) const;
  /// The point where f z is smallest, or a point far out in the direction that has no end.
  /// Pre: the origin is a point of the face.
  Point lowest(const Eigen::VectorXd& f, Eigen::VectorXd& z);

  Index programs() const { return programs_; } ///< linear programs solved
  double work() const { return work_; }        ///< their multiplications, about

private:
  const LiteralProblem& problem_;
  std::vector<Index> unknowns_; // which may differ from 0
  Eigen::MatrixXd equations_;   // E: E z = right_, z of unknowns_
  Eigen::VectorXd right_;
  Eigen::MatrixXd signs_; // C: C z + constant_ >= 0
  Eigen::VectorXd constant_;
  Eigen::MatrixXd basis_, triangle_; // of E', rank columns
  std::vector<Index> order_;
  Eigen::VectorXd origin_;
  Eigen::MatrixXd directions_;
  Eigen::MatrixXd rows_;     // signs_ * directions_, rows scaled to length 1
  Eigen::VectorXd room_;     // what the rows have at the origin, in the same scale
  std::vector<Index> first_; // of rows_: those that may bind
  bool contradictory_ = false;
  Index programs_ = 0;
  double work_ = 0;

  void choose(const FaceModes& modes);
  void eliminate();
  void settle(Eigen::VectorXd& x) const;
  void look_around();
  void dual(OwnedProgram& program) const;
  Eigen::VectorXd polished(const Eigen::VectorXd& t, const Eigen::VectorXd& room,
                           const Eigen::VectorXd& multipliers) const;
  Eigen::VectorXd whole(const Eigen::VectorXd& x) const;
  Status minimise(OwnedProgram& program);
};

} // namespace lcpush::desktop
