// What a part of an answer determines of the rest.
#pragma once

#include "lcpush/desktop/foreign_answer.hpp"
#include "lcpush/desktop/push.hpp"

#include <optional>

namespace lcpush::desktop {

using Rows = std::vector<std::pair<Eigen::VectorXd, double>>;

struct Completion {
  bool has_forces = false;            ///< were forces filled in?
  std::vector<std::string> completed; ///< a phrase for each thing that was not given
  std::string missing;                ///< what would have to be given as well; empty: it is whole
};

/// Fills `answer` from what is given and what follows from it: the object's acceleration from all
/// forces or from the motion of its points; the closings from the motion; forces from the motion,
/// as those that fit the laws best (nonnegative least squares); what generators and slips make of
/// them. Numbers that are given stay as they are. `push` is only asked for its scene and its
/// assembly. `tolerance`: in scaled units, below this nothing moves. Cost: least squares of 6 +
/// actuators + 4 points rows.
class AnswerCompleter {
public:
  AnswerCompleter(Push& push, const ForeignAnswer& given, double tolerance, Answer<double>& answer)
      : scene_(push.scene()), layout_(push.layout()), factored_(push.assembly().factored()),
        given_(given), file_(push.file()), tolerance_(tolerance), answer_(answer) {}

  Completion run();

private:
  const Scene<double>& scene_;
  const Layout<double>& layout_;
  const FactoredProblem<double>& factored_;
  const ForeignAnswer& given_;
  const SceneFile& file_;
  double tolerance_;
  Answer<double>& answer_;
  Completion completion_;

  const Body<double>& body_of(Index i) const { return scene_.bodies[layout_.body[i]]; }
  ForeignContact contact_of(Index i) const {
    return given_.contacts.empty() ? ForeignContact()
                                   : given_.contacts[static_cast<std::size_t>(i)];
  }
  bool normal_known(Index i) const { return contact_of(i).normal_force.has_value(); }
  bool has_friction(Index i) const { return layout_.cones[i].generators > 0; }
  bool friction_known(Index i) const;
  bool forces_known() const;

  bool find_acceleration();
  Rows point_rows(bool with_acceleration) const;
  Eigen::VectorXd drive_speeds(Index point, const Vector3<double>& direction) const;
  Eigen::VectorXd closing_speeds(Index point) const;
  double opening(Index point) const;
  void find_closings();
  std::optional<Eigen::VectorXd> closings_given() const;
  std::optional<Eigen::VectorXd> closings_from_forces() const;
  std::optional<Eigen::VectorXd> closings_from_openings() const;
  void find_slips();
  Vector6<double> relative_twist(Index point) const;
  double slides_against(Index point, Index j) const;
  double gap(Index point) const;
  struct ForceRows {
    Eigen::MatrixXd A; // columns: the forces, then what each cone has left
    Eigen::VectorXd b;
  };
  ForceRows force_rows();
  Eigen::VectorXd fitting_forces(const ForceRows& rows) const;
  void find_forces();
  void split_friction(Index point, double* beta);
  void split_soft(Index point, double* beta);
  void find_motions();
};

} // namespace lcpush::desktop
