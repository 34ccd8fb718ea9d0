// [T.19] What friction and grip can hold: the balance of forces as a cone program. Round friction
// is met from both sides: by rays of its cones from inside, added where its supporting planes say
// that one is missing, and by the slack of those planes from outside.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "dense/simplex.hpp"
#include "lcpush/desktop/assembled_scene.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "solve/settings.hpp"

namespace lcpush::desktop {

/// The balance of an object and of the actuators: G f + D x = b, in the assembly's units. Its rows
/// are forces, moments (in a plane what lies in it), actuators, the sum of normal forces with its
/// slack; under the law of pads [T.7] also how pressure follows a displacement: of patches its
/// affine parts, and where the rim of what has parted may not press; of other points one each.
class GripStatics {
public:
  /// Of a hand at rest. The file outlives this. `touching`: which points do, under the law of pads;
  /// empty: any pressure will do.
  explicit GripStatics(const SceneFile& file, const std::vector<bool>& touching = {});

  /// A contact's cone: friction u, |u| <= friction * normal force, as columns of the balance. Of a
  /// pyramid its generators, of which each is a ray of its own.
  struct Cone {
    Index point;
    double friction;
    Eigen::VectorXd normal;
    Eigen::MatrixXd directions;
    bool is_round;
  };

  /// Under the law of pads: a patch whose pressure over weight is affine, sum_k P_k places(k).
  struct Pad {
    std::vector<std::size_t> cones; ///< of the points that touch
    Eigen::VectorXd weights;        ///< of these
    Eigen::MatrixXd places;         ///< 1 and coordinates in the plane, of these
    Eigen::MatrixXd pressures;      ///< P, one a column: of them a pressure that nowhere pulls is a
                                    ///< sum; of sum 1, or 0 everywhere
    Index row;                      ///< of P_0
  };

  const Scales<double>& scales() const { return assembled_.assembly.layout().scales; }
  const std::vector<Cone>& cones() const { return cones_; }
  const std::vector<Pad>& pads() const { return pads_; }
  Index rows() const { return rows_; }
  Index moving() const { return moving_; } ///< rows of the object: 6, in a plane 3
  Index sum_row() const { return sum_row_; }
  /// Do normal forces end at a limit of ours, as the grip's forces do not bound them?
  bool is_capped() const { return is_capped_; }

  /// b: what the contacts' forces have to be, at `factor` times the grip.
  Eigen::VectorXd load(double factor) const { return fixed_ - factor * grip_column_; }
  /// The factor that makes the largest grip force equal to the load; 0: there is no grip.
  double unit() const {
    const double grip = grip_column_.head(sum_row_).cwiseAbs().maxCoeff();
    return grip > 0 ? fixed_.head(sum_row_).cwiseAbs().maxCoeff() / grip : 0;
  }
  /// The column of the factor on the grip.
  const Eigen::VectorXd& grip_column() const { return grip_column_; }
  /// The column of a wrench at the centre of mass, [N; N m], as the unit of its unknown.
  Eigen::VectorXd wrench_column(const Vector6<double>& wrench) const;
  /// Are there points whose pressure is the law of pads' to choose?
  bool has_pads() const { return has_pads_; }
  /// Of pads: the columns of the displacement, any sign, one a row before sum_row.
  const Eigen::MatrixXd& displacement() const { return displacement_; }
  /// And of the gaps that points have opened, >= 0.
  const Eigen::MatrixXd& gaps() const { return gaps_; }
  /// A row's axis of the twist: 0 to 5.
  Index axis(Index row) const { return balance_axis(assembled_.scene, row); }

protected:
  const SceneFile& file_;
  AssembledScene assembled_;
  std::vector<Cone> cones_;
  std::vector<Pad> pads_;
  std::vector<bool> touching_;
  Index moving_, sum_row_, rows_;
  bool is_capped_ = true, has_pads_ = false;
  Eigen::VectorXd fixed_, grip_column_;
  Eigen::MatrixXd displacement_, gaps_;

  Eigen::VectorXd force_column(Index body, const Vector6<double>& column, bool presses) const;
  void add_cones(Index body, Index point, double sign);
  void bound_forces();
  double compliance(Index point) const { return assembled_.work.pressure.compliance[point]; }
  Eigen::VectorXd normal_of(Index body, Index point) const;
};

/// Normal force 1 at a point, with friction.
struct ConeRay {
  std::size_t cone;
  Eigen::VectorXd friction; ///< of a pyramid a unit vector among its generators; empty: none
};
/// A pressure of a pad, and all forces that go with it.
struct PadRay {
  std::size_t pad;
  Eigen::VectorXd forces, pressure;
};
/// Forces of which a program knows.
using ForceRay = std::variant<ConeRay, PadRay>;

/// Programs over the same set, { x, f : G f + D x = b }.
class StaticsProgram {
public:
  /// x: the first `free` of any sign, the others not negative. D and b may have rows more, of x
  /// alone. `known`: rays to begin with.
  StaticsProgram(const GripStatics& statics, Eigen::MatrixXd D, Index free, Eigen::VectorXd b,
                 const std::vector<ForceRay>& known = {});

  enum class Ending {
    found,
    unlimited, ///< only a limit on the contacts' normal forces ends it
    none,      ///< proved: the set is empty
    failed,
  };
  /// What presses and slips at a program's end.
  struct Contact {
    double normal = 0; ///< N over the scene's unit
  };
  struct Optimum {
    Ending ending = Ending::failed;
    double value = 0; ///< c x of forces that are found
    double bound = 0; ///< no smaller one exists
    Eigen::VectorXd x;
    Eigen::VectorXd motion; ///< the dual: in which motion of object and actuators it gives way
  };
  /// To be asked first.
  [[nodiscard]] Ending find_point();
  /// The least c x.
  [[nodiscard]] Optimum minimise(const Eigen::VectorXd& c);

  const std::vector<ForceRay>& rays() const { return rays_; }
  std::vector<Contact> contacts() const; ///< of the last program, one a cone
  double work() const { return work_ + (simplex_ ? simplex_->work() : 0); } ///< multiplications
  /// Of an empty set: a motion that nothing resists.
  const Eigen::VectorXd& motion() const { return motion_; }

private:
  const GripStatics& statics_;
  Eigen::MatrixXd D_;
  Index free_;
  Eigen::VectorXd b_, motion_;
  std::vector<ForceRay> rays_;
  std::vector<bool> is_padded_; ///< of the cones: their forces are a pad's
  std::optional<Simplex> simplex_;
  double work_ = 0; ///< before the present tableau

  Index first_ray() const { return D_.cols() + 1; }
  Eigen::VectorXd column(const ForceRay& ray) const;
  Eigen::MatrixXd pad_forces(const GripStatics::Pad& pad, const Eigen::VectorXd& motion) const;
  double add_pad_rays(std::size_t pad, const Eigen::VectorXd& motion);
  Eigen::MatrixXd columns(std::size_t from) const;
  bool restart();
  double add_missing(const Eigen::VectorXd& motion);
  double most_force(const Eigen::VectorXd& c, const Eigen::VectorXd& x) const;
  Ending approach();
  void drop_idle();
};

/// The least factor on the grip that holds the load; infinite: proved, none does; none: not known.
std::optional<double> least_factor(const GripStatics& statics);

} // namespace lcpush::desktop
