// The literal laws of a scene, whatever pressure law its file asks for, and what a contact can do
// in an answer to them.
#pragma once

#include <vector>

#include "lcpush/desktop/assembled_scene.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/check.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"

namespace lcpush::desktop {

/// One complementary choice for the unknowns of a contact. Every answer's contact is in one of:
/// open       lambda = beta = 0, the gap opens or stays;  xi has no meaning
/// stick      lambda, beta >= 0, gap and slip 0 (without friction: the gap alone)
/// slide      lambda >= 0, gap 0, friction at its limit on the generators `active` alone, which
///            oppose the slip as well as each other and not worse than the rest
/// undecided  nothing chosen yet: the gap does not close, any force of the cone
struct ContactMode {
  enum class Kind { open, stick, slide, undecided };
  Kind kind = Kind::undecided;
  bool pulls = false;        ///< of a bilateral contact, which is never open
  std::vector<Index> active; ///< ascending
};
using FaceModes = std::vector<ContactMode>; ///< one a contact point

/// What decides the mode of one contact at an answer, in the assembly's units.
struct ContactReading {
  bool pressed, pulls, gap_closed, slips, at_limit;
  std::vector<Index> carrying; ///< generators with a force
  std::vector<Index> opposing; ///< generators that oppose the slip best
};

/// An edge of a contact's friction cone: the unknowns that are 1 and mu along it. The forces that a
/// cone holds are the sums of its edges with factors >= 0.
struct ConeEdge {
  Index normal;   ///< or the pull
  Index friction; ///< -1: no friction
  double mu;
};

/// What there is to know of the problem, in the units of its layout. Motions are columns
/// x = (a, s, p): the object's acceleration along what can move, the actuators' closings, the size
/// of the push; prescribed motions are p times those of a push whose fastest point moves at 1.
class LiteralProblem {
public:
  explicit LiteralProblem(const SceneFile& file);
  LiteralProblem(const LiteralProblem&) = delete;
  LiteralProblem& operator=(const LiteralProblem&) = delete;

  const SceneFile& file() const { return file_; } ///< with pressure = "rigid"
  const Scene<double>& scene() const { return assembled_.scene; }
  const Layout<double>& layout() const { return assembled_.assembly.layout(); }
  const FactoredProblem<double>& factored() const { return assembled_.assembly.factored(); }
  /// The problem pushed by p; valid until the next call.
  Problem<double> problem(double push);
  /// At rest, with the push of the scene as an infinitesimal one; the same.
  Problem<double> breaking_problem() { return assembled_.assembly.breaking_problem(); }

  double push() const { return push_; } ///< p of the scene as it is; 1 if nothing is pushed
  Index moving() const { return static_cast<Index>(axes_.size()); }        ///< size of a
  Index axis(Index k) const { return axes_[static_cast<std::size_t>(k)]; } ///< of a twist
  Index actuators() const { return layout().actuators; }
  Index motions() const { return moving() + actuators() + 1; } ///< size of x

  /// Row of force unknown i over x: the acceleration of the object's point along it, relative to
  /// the body.
  const Eigen::MatrixXd& rates() const { return rates_; }
  /// a = effects.top f + load.top; effects.bottom f + inertia s = load.bottom.
  const Eigen::MatrixXd& effects() const { return effects_; }
  const Eigen::VectorXd& load() const { return load_; }
  const Eigen::VectorXd& inertia() const { return inertia_; } ///< of the actuators

  /// The edges of the cone that a mode leaves to contact i.
  std::vector<ConeEdge> edges_of(Index i, const ContactMode& mode) const;

  /// x at forces and closings z, pushed by p.
  Eigen::VectorXd motion_of(const Eigen::VectorXd& z, double push) const;
  /// Gives all slips the smallest value that the laws allow.
  void complete(double push, Eigen::VectorXd& z) const;
  /// The referee's word on z, pushed by p; the answer is valid until the next call.
  const Answer<double>& read(const Eigen::VectorXd& z, double push);
  Residuals<double> check(const Answer<double>& answer, double push) const;
  /// No law broken by more than the tolerance, nor than a small part of the push.
  bool passes(const Residuals<double>& residuals, double push) const;

  std::vector<ContactReading> readings_at(const Eigen::VectorXd& z, double push) const;
  /// What every contact does there, ties resolved towards more unknowns.
  FaceModes face_of(const std::vector<ContactReading>& readings) const;
  /// All that a contact may be said to do there: several at the limit of two modes.
  std::vector<ContactMode> modes_of(Index i, const ContactReading& at) const;
  /// All that it can do at all; not for soft points.
  std::vector<ContactMode> every_mode(Index i) const;
  bool is_soft(Index i) const;
  bool has_soft_points() const;

private:
  SceneFile file_;
  AssembledScene assembled_;
  double unit_ = 1; // m/s^2: the push of p = 1
  double push_ = 1;
  std::vector<Index> axes_; // of a twist: those that move
  Eigen::MatrixXd rates_, effects_;
  Eigen::VectorXd load_, inertia_;
};

/// What a unit force along the edge does, as a column of effects().
inline Eigen::VectorXd effect_of(const LiteralProblem& problem, const ConeEdge& edge) {
  Eigen::VectorXd effect = problem.effects().col(edge.normal);
  if (edge.friction >= 0) effect += edge.mu * problem.effects().col(edge.friction);
  return effect;
}

} // namespace lcpush::desktop
