// The literal laws of a scene as one dense problem, whatever pressure law its file asks for, and
// what a contact can do in an answer to them.
#pragma once

#include <tuple>
#include <vector>

#include "lcpush/desktop/assembled_scene.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/mechanics/model/check.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"
#include "solve/dense_problem.hpp"

namespace lcpush::desktop {

/// One complementary choice for the unknowns of a contact. Every answer's contact is in one of:
/// open       lambda = beta = 0, the gap opens or stays;  xi has no meaning
/// stick      lambda, beta >= 0, gap and slip 0 (without friction: the gap alone)
/// slide      lambda >= 0, gap 0, friction at its limit on the generators `active` alone, which
///            oppose the slip as well as each other and not worse than the rest
/// undecided  nothing chosen yet, signs only
struct ContactMode {
  enum class Kind { open, stick, slide, undecided };
  Kind kind = Kind::undecided;
  bool pulls = false;        ///< of a bilateral contact, which is never open
  std::vector<Index> active; ///< ascending

  friend bool operator<(const ContactMode& a, const ContactMode& b) {
    return std::tie(a.kind, a.pulls, a.active) < std::tie(b.kind, b.pulls, b.active);
  }
};
using FaceModes = std::vector<ContactMode>; ///< one a contact point

class LiteralProblem {
public:
  explicit LiteralProblem(const SceneFile& file);
  LiteralProblem(const LiteralProblem&) = delete;
  LiteralProblem& operator=(const LiteralProblem&) = delete;

  const SceneFile& file() const { return file_; } ///< with pressure = "rigid"
  const Scene<double>& scene() const { return assembled_.scene; }
  const Layout<double>& layout() const { return assembled_.assembly.layout(); }
  Problem<double> problem() { return assembled_.assembly.problem(); }
  const FactoredProblem<double>& factored() const { return assembled_.assembly.factored(); }
  const DenseProblem& dense() const { return dense_; }

  /// Gives the slips of open contacts, which are in no polyhedron, their smallest value.
  void complete(const FaceModes& modes, Eigen::VectorXd& z) const;
  /// The referee's word on z; valid until the next call.
  const Answer<double>& read(const Eigen::VectorXd& z);
  /// No law broken by more than the tolerance, nor than a small part of the push.
  bool passes(const Residuals<double>& residuals) const;

  /// What every contact does at the answer z with slacks w, ties resolved towards more unknowns.
  FaceModes face_of(const Eigen::VectorXd& z, const Eigen::VectorXd& w) const;
  /// All that contact i may be said to do there: several at the limit of two modes.
  std::vector<ContactMode> modes_at(Index i, const Eigen::VectorXd& z,
                                    const Eigen::VectorXd& w) const;
  /// All that it can do at all; not for soft points.
  std::vector<ContactMode> every_mode(Index i) const;
  bool has_soft_points() const;

private:
  SceneFile file_;
  AssembledScene assembled_;
  DenseProblem dense_;
};

} // namespace lcpush::desktop
