// A complementary face: the answers in which every contact keeps its mode. They are a polyhedron,
// over the edges of the friction cones and the motions that the modes allow.
#pragma once

#include <optional>

#include "dense/simplex.hpp"
#include "spread/mode_motions.hpp"

namespace lcpush::desktop {

/// Which of a face's answers.
enum class Instant {
  pushed,   ///< to the push as it is
  any_push, ///< to a push of any size p from 0 to 1, which is an unknown of its own
  at_rest,  ///< before the push: nothing moves, and nothing is asked of the motion
  begins,   ///< how the answers at rest change with a push of p = 1, to first order in p: forces
            ///< may fall where there are some, and grow anywhere
};

class Face {
public:
  using Ending = Simplex::Ending;

  Face(const LiteralProblem& problem, const FaceModes& modes, const ModeMotions& motions,
       Instant instant);
  /// `begins`, at an inner point of the face at rest. `carries`: of its edges, those that can carry
  /// a force.
  Face(const Face& rest, const ModeMotions& motions, const std::vector<bool>& carries);
  /// A point of the face: the unknowns z (slips left out), and the push that they answer.
  struct Answer {
    Eigen::VectorXd z;
    double push = 0;
  };

  Ending find_point();
  Answer point() const { return whole(program_->point()); }
  /// The point where f z is smallest, f a functional of the forces; or a point far out in the
  /// direction that has no end. Pre: find_point has found one.
  Ending lowest(const Eigen::VectorXd& f, Answer& answer);
  /// The same of `sign` times entry k of the motion; and that entry there.
  Ending slowest(Index k, double sign, Answer& answer);
  double motion(Index k) const;
  /// `any_push`: the point with the largest push, proved to be none other than 0 if it is.
  Ending largest_push(Answer& answer);

  /// After find_point: has some point all that only these modes have, no strict sign of `motions`
  /// 0? Then inner_point is one; else none.
  Ending find_own_point(const ModeMotions& motions);

  /// After `lowest` of some functionals: the mean of their points and more, such that an edge that
  /// can carry a force at all carries one there. False if a program fails.
  bool find_inner_point(std::vector<bool>& carries);
  Answer inner_point() const { return whole(corners_ / count_); }

  Index programs() const { return program_ ? program_->programs() : 0; }    ///< solved
  double work() const { return work_ + (program_ ? program_->work() : 0); } ///< multiplications

private:
  const LiteralProblem& problem_;
  Instant instant_;
  Eigen::MatrixXd span_; // of the motions: empty at rest
  std::vector<ConeEdge> edges_;
  std::optional<Simplex> program_; // none: the modes contradict each other
  Index moving_ = 0;               // columns of free motion, then the push if it is unknown
  Index first_edge_ = 0;
  double work_ = 0;
  Eigen::VectorXd corners_; // their sum
  double count_ = 0;

  void assemble(const ModeMotions& motions, Index carrying = 0);
  double push() const { return instant_ == Instant::begins ? 1 : problem_.push(); }
  Answer whole(const Eigen::VectorXd& v) const;
  Ending minimise(const Eigen::VectorXd& c, Answer& answer);
};

} // namespace lcpush::desktop
