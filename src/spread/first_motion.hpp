// How the object begins to move on a face of the instant of breaking: to first order in the push.
#pragma once

#include "spread/spread_face.hpp"

namespace lcpush::desktop {

/// Of all answers to arbitrarily small pushes p: a = p a1, forces f0 + p f1. An edge that carries
/// some force f0 may lose by f1, one that carries none may only gain.
class FirstMotion {
public:
  /// `carries`: of the face's edges, whether they can carry a force at rest.
  FirstMotion(const LiteralProblem& problem, const ModeMotions& motions,
              const std::vector<ConeEdge>& edges, const std::vector<bool>& carries);

  struct Answer {
    double rate = 0;                  ///< entry k of a1, per unit of p
    Eigen::VectorXd forces, closings; ///< f1 over all unknowns, s of each actuator
  };
  /// The smallest `sign` times entry k of a1.
  Simplex::Ending lowest(Index k, double sign, Answer& answer);

  Index programs() const { return program_->programs(); }
  double work() const { return program_->work(); }

private:
  const LiteralProblem& problem_;
  Eigen::MatrixXd span_;
  std::vector<ConeEdge> edges_; // in the order of the columns
  std::optional<Simplex> program_;
  Simplex::Ending first_ = Simplex::Ending::failed;
};

} // namespace lcpush::desktop
