// What a part of an answer determines of the rest.
#pragma once

#include "lcpush/desktop/foreign_answer.hpp"
#include "lcpush/desktop/push.hpp"

#include <optional>

namespace lcpush::desktop {

/// Linear equations: coefficients, and what they sum up to.
using Rows = std::vector<std::pair<Eigen::VectorXd, double>>;

/// lcpush's own answer, solved when it is first asked for: beside the Push that is judged, whose
/// problem a solve would change.
class OwnSolution {
public:
  explicit OwnSolution(const SceneFile& file) : file_(file) {}
  const PushReport& report();

private:
  const SceneFile& file_;
  std::optional<Push> push_;
  std::optional<PushReport> report_;
};

struct Completion {
  bool has_forces = false;            ///< were forces filled in?
  std::vector<std::string> completed; ///< a phrase for each thing that was not given
  std::string missing;                ///< what would have to be given as well; empty: it is whole
};

/// Fills `answer` from what is given and what follows from it: the object's acceleration from all
/// forces or from the motion of its points, and where these leave it open the one next to lcpush's
/// own; the closings from the motion; forces from the motion and from the sums that are given of
/// bodies, as those that fit the laws best (nonnegative least squares). Numbers that are given stay
/// as they are. `tolerance`: in scaled units, below this nothing moves. Turns the cones of `push`
/// to the forces if its friction is round. Cost: least squares of 6 + actuators + 7 bodies + 4
/// points rows.
class AnswerCompleter {
public:
  AnswerCompleter(Push& push, OwnSolution& own, const ForeignAnswer& given, double tolerance,
                  Answer<double>& answer)
      : push_(push), own_(own), scene_(push.scene()), layout_(push.layout()), given_(given),
        file_(push.file()), tolerance_(tolerance), answer_(answer) {}

  Completion run();

private:
  /// Of a body on the object, as far as it is known.
  struct KnownWrench {
    std::optional<Vector3<double>> force, moment; ///< N, N m
  };
  /// A unit of force that a point may have: along its normal, or in its friction space.
  struct PointForce {
    Index point;
    double sign;               ///< of a normal force; 0: friction
    Vector3<double> direction; ///< of friction
  };

  Push& push_;
  OwnSolution& own_;
  const Scene<double>& scene_;
  const Layout<double>& layout_;
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
  bool friction_known(Index i) const;
  bool forces_known(const Body<double>& body) const;
  bool forces_known() const;
  KnownWrench wrench_of(const Body<double>& body) const;
  double least() const { return tolerance_ * layout_.scales.acceleration; } ///< m/s^2

  // The motion: rows on the object's acceleration, its angular part times the scene's length, and
  // on the closings times their reach, m/s^2.
  Eigen::VectorXd drive_speeds(Index point, const Vector3<double>& direction) const;
  Rows newton_rows() const;
  Rows point_rows() const;
  Rows closing_rows() const;
  Rows pressed_rows() const;
  void set_acceleration(const Eigen::VectorXd& scaled);
  void set_closings(const Eigen::VectorXd& scaled);
  double opening(Index point) const;
  bool find_motion();
  bool find_closings();
  std::optional<Eigen::VectorXd> closings_from_openings() const;
  Vector6<double> relative_twist(Index point) const;
  Vector3<double> slip(Index point) const;
  double gap(Index point) const;
  double slides_against(Index point, Index j) const;
  void find_slips();
  void find_motions();

  // The forces.
  Index force_rows() const {
    return 6 + layout_.actuators + 7 * static_cast<Index>(file_.bodies.size());
  }
  Eigen::VectorXd column(const PointForce& force) const;
  Eigen::VectorXd targets() const;
  std::vector<PointForce> possible_forces() const;
  std::optional<PointForce> steepest(Index point, const Eigen::VectorXd& off) const;
  Eigen::VectorXd fitting(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                          const std::vector<PointForce>& forces) const;
  void find_forces();
  double split_friction(Index point, double* beta) const;
  void split_frictions();
};

} // namespace lcpush::desktop
