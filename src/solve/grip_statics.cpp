#include "solve/grip_statics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lcpush/desktop/smallest_grip.hpp"
#include "lcpush/mechanics/solve/pad_law.hpp"

namespace lcpush::desktop {

GripStatics::GripStatics(const SceneFile& file, const std::vector<bool>& touching)
    : file_(file), assembled_(file.view()), touching_(touching), moving_(file.planar ? 3 : 6),
      sum_row_(moving_ + assembled_.scene.actuators.size), rows_(sum_row_ + 1) {
  const Scene<double>& scene = assembled_.scene;
  const Layout<double>& layout = assembled_.assembly.layout();
  for (Index b = 0; b < scene.bodies.size; ++b)
    for (const Index i : points_of(scene.bodies[b]))
      for (const double sign : {1.0, -1.0})
        if ((sign > 0 || scene.bodies[b].bilateral) &&
            (touching_.empty() || touching_[static_cast<std::size_t>(i)]))
          add_cones(b, i, sign);
  fixed_ = grip_column_ = Eigen::VectorXd::Zero(rows_);
  const Vector6<double> load = laws::load(scene, layout.scales);
  for (Index row = 0; row < moving_; ++row) fixed_[row] = -load[axis(row)];
  for (Index a = 0; a < scene.actuators.size; ++a) {
    const double target = assembled_.assembly.factored().sums[a].target;
    if (grips(scene, a))
      grip_column_[moving_ + a] = -target;
    else
      fixed_[moving_ + a] = target;
  }
  bound_forces();
  if (file.pressure != Pressure::pad) return;
  pad_preload(assembled_.assembly, assembled_.work.pressure);
  for (Index i = 0; i < scene.points.size; ++i) has_pads_ = has_pads_ || compliance(i) > 0;
}

Eigen::VectorXd GripStatics::normal_of(Index b, Index point) const {
  const Scene<double>& scene = assembled_.scene;
  return force_column(b, laws::normal_direction(scene.bodies[b], scene.points[point], scales()),
                      true)
      .head(sum_row_);
}

/// A force's column: its wrench, what it does to the actuators, and its share of the sum.
Eigen::VectorXd GripStatics::force_column(Index body, const Vector6<double>& column,
                                          bool presses) const {
  Eigen::VectorXd does = Eigen::VectorXd::Zero(rows_);
  for (Index row = 0; row < moving_; ++row) does[row] = column[axis(row)];
  for_each_grip(assembled_.scene, assembled_.assembly.layout(), body, column,
                [&](Index a, double grip) { does[moving_ + a] += grip; });
  for (Index a = moving_; a < sum_row_; ++a)
    if (std::abs(does[a]) <= ModelSettings<double>::across_drive()) does[a] = 0;
  does[sum_row_] = presses ? 1 : 0;
  return does;
}

void GripStatics::add_cones(Index b, Index point, double sign) {
  const Scene<double>& scene = assembled_.scene;
  const Body<double>& body = scene.bodies[b];
  const Vector3<double>& p = scene.points[point];
  const bool is_round = file_.is_round && !body.in_plane;
  const Index axes = body.torsion_radius > 0 ? 3 : 2;
  Cone cone{point,
            body.friction,
            force_column(b, sign * laws::normal_direction(body, p, scales()), true),
            {},
            is_round};
  const Index count = !(body.friction > 0) ? 0 : is_round ? axes : generator_count(scene, body);
  cone.directions.resize(rows_, count);
  for (Index k = 0; k < count; ++k) {
    const Generator<double> d =
        is_round ? generator_along(body, Vector3<double>(Vector3<double>::Unit(k)))
                 : generator(scene, body, point, k);
    cone.directions.col(k) = force_column(b, laws::friction_direction(body, p, d, scales()), false);
  }
  cones_.push_back(std::move(cone));
}

/// Where every contact's force works on the actuators, their forces bound it.
void GripStatics::bound_forces() {
  const Index actuators = sum_row_ - moving_;
  double least = 1;
  for (const Cone& cone : cones_) {
    double works = cone.normal.segment(moving_, actuators).sum();
    for (Index k = 0; k < cone.directions.cols(); ++k)
      works -= cone.friction * std::abs(cone.directions.col(k).segment(moving_, actuators).sum());
    least = std::min(least, works);
  }
  const double given = fixed_.segment(moving_, actuators).sum();
  const double grip = -grip_column_.segment(moving_, actuators).sum();
  is_capped_ = !(least > statics_settings.flat);
  const double most = statics_settings.most_force * std::max(1.0, std::abs(given + grip));
  const auto bound = [&](double part) {
    return is_capped_ ? most : statics_settings.beyond_sum * part / least;
  };
  fixed_[sum_row_] = bound(given);
  grip_column_[sum_row_] = -bound(grip);
}

Eigen::VectorXd GripStatics::wrench_column(const Vector6<double>& wrench) const {
  Eigen::VectorXd column = Eigen::VectorXd::Zero(rows_);
  for (Index row = 0; row < moving_; ++row)
    column[row] = wrench[axis(row)] / (axis(row) < 3 ? 1 : scales().length);
  return column;
}

/// Of a unit of normal force the friction, over mu, that resists a motion most.
static Eigen::VectorXd friction_against(const GripStatics::Cone& cone,
                                        const Eigen::VectorXd& motion) {
  Eigen::VectorXd slip(cone.directions.cols());
  for (Index k = 0; k < slip.size(); ++k) slip[k] = cone.directions.col(k).dot(motion);
  if (cone.is_round) return -slip / std::max(slip.norm(), std::numeric_limits<double>::min());
  Index most = 0;
  return slip.size() == 0 || slip.minCoeff(&most) >= 0 ? Eigen::VectorXd(0 * slip)
                                                       : Eigen::VectorXd::Unit(slip.size(), most);
}

/// The force per unit of normal force that resists a motion most.
static Eigen::VectorXd force_against(const GripStatics::Cone& cone, const Eigen::VectorXd& motion) {
  return cone.normal + cone.friction * (cone.directions * friction_against(cone, motion));
}

StaticsProgram::StaticsProgram(const GripStatics& statics, Eigen::MatrixXd D, Index free,
                               Eigen::VectorXd b, const std::vector<ForceRay>& known)
    : statics_(statics), D_(std::move(D)), free_(free), b_(std::move(b)), rays_(known),
      is_padded_(statics.cones().size(), false) {
  for (const GripStatics::Pad& pad : statics.pads())
    for (const std::size_t c : pad.cones) is_padded_[c] = true;
  if (!rays_.empty()) return;
  for (std::size_t p = 0; p < statics.pads().size(); ++p) add_pad_rays(p, Eigen::VectorXd());
  for (std::size_t i = 0; i < statics.cones().size(); ++i) {
    if (is_padded_[i]) continue;
    const GripStatics::Cone& cone = statics.cones()[i];
    const Index count = cone.directions.cols();
    if (count == 0) rays_.push_back(ConeRay{i, Eigen::VectorXd()});
    for (Index k = 0; k < count; ++k)
      for (const double sign : {1.0, -1.0})
        if (sign > 0 || cone.is_round)
          rays_.push_back(ConeRay{i, sign * Eigen::VectorXd::Unit(count, k)});
  }
}

Eigen::VectorXd StaticsProgram::column(const ForceRay& ray) const {
  Eigen::VectorXd column = Eigen::VectorXd::Zero(b_.size());
  auto forces = column.head(statics_.rows());
  if (const PadRay* const of_pad = std::get_if<PadRay>(&ray)) {
    forces = of_pad->forces;
    return column;
  }
  const auto& [c, friction] = std::get<ConeRay>(ray);
  const GripStatics::Cone& cone = statics_.cones()[c];
  forces = cone.normal;
  for (Index k = 0; k < friction.size(); ++k)
    forces += cone.friction * friction[k] * cone.directions.col(k);
  return column;
}

/// The forces of a pad's points against a motion, by the parts of its pressure; without a motion
/// they press alone.
Eigen::MatrixXd StaticsProgram::pad_forces(const GripStatics::Pad& pad,
                                           const Eigen::VectorXd& motion) const {
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(statics_.rows(), pad.places.rows());
  for (std::size_t i = 0; i < pad.cones.size(); ++i) {
    const GripStatics::Cone& cone = statics_.cones()[pad.cones[i]];
    const auto k = static_cast<Index>(i);
    forces.noalias() += (motion.size() == 0 ? cone.normal : force_against(cone, motion)) *
                        (pad.weights[k] * pad.places.col(k)).transpose();
  }
  forces.middleRows(pad.row, pad.places.rows()).diagonal().array() += 1;
  return forces;
}

/// Of the rays from this one on.
Eigen::MatrixXd StaticsProgram::columns(std::size_t from) const {
  Eigen::MatrixXd matrix(b_.size(), static_cast<Index>(rays_.size() - from));
  for (std::size_t k = from; k < rays_.size(); ++k)
    matrix.col(static_cast<Index>(k - from)) = column(rays_[k]);
  return matrix;
}

/// From the rays alone.
bool StaticsProgram::restart() {
  Eigen::MatrixXd A(b_.size(), first_ray() + static_cast<Index>(rays_.size()));
  A.leftCols(D_.cols()) = D_;
  A.col(D_.cols()) = Eigen::VectorXd::Unit(b_.size(), statics_.sum_row()); // slack
  A.rightCols(static_cast<Index>(rays_.size())) = columns(0);
  work_ = work();
  simplex_.emplace(A, b_, free_, statics_settings.price);
  return simplex_->find_point() == Simplex::Ending::found;
}

/// The rays along which a motion meets less than no resistance, from each round cone the one where
/// it is least. Returns by how much, of a unit of normal force: what the motion's plane lacks.
double StaticsProgram::add_missing(const Eigen::VectorXd& motion) {
  double most = 0;
  const std::size_t before = rays_.size();
  for (std::size_t i = 0; i < statics_.cones().size(); ++i) {
    const GripStatics::Cone& cone = statics_.cones()[i];
    if (!cone.is_round || cone.directions.cols() == 0 || is_padded_[i]) continue;
    const double lacks = -force_against(cone, motion).dot(motion);
    most = std::max(most, lacks);
    if (lacks > statics_settings.missing)
      rays_.push_back(ConeRay{i, friction_against(cone, motion)});
  }
  for (std::size_t p = 0; p < statics_.pads().size(); ++p)
    most = std::max(most, add_pad_rays(p, motion));
  if (rays_.size() > before) simplex_->add(columns(before));
  return most;
}

/// Those of a pad's pressures that a motion meets with less than no resistance; without a motion
/// all of them.
double StaticsProgram::add_pad_rays(std::size_t p, const Eigen::VectorXd& motion) {
  const GripStatics::Pad& pad = statics_.pads()[p];
  const Eigen::MatrixXd forces = pad_forces(pad, motion) * pad.pressures;
  const bool is_first = motion.size() == 0;
  const Eigen::VectorXd lacks = is_first ? Eigen::VectorXd::Ones(forces.cols())
                                         : Eigen::VectorXd(-forces.transpose() * motion);
  const double most = lacks.maxCoeff();
  for (Index k = 0; k < forces.cols(); ++k)
    if (lacks[k] > statics_settings.missing && lacks[k] >= statics_settings.worth * most)
      rays_.push_back(PadRay{p, forces.col(k), pad.pressures.col(k)});
  return most;
}

StaticsProgram::Ending StaticsProgram::find_point() {
  return restart() ? Ending::found : approach();
}

/// No forces of the known rays carry the load: by those of the cones, as much of it as they can.
StaticsProgram::Ending StaticsProgram::approach() {
  Eigen::MatrixXd with_rest(b_.size(), D_.cols() + 1);
  with_rest << D_, b_;
  with_rest(statics_.sum_row(), D_.cols()) = 0;
  StaticsProgram program(statics_, with_rest, free_, b_, rays_);
  if (!program.restart()) return Ending::failed;
  const Optimum least = program.minimise(Eigen::VectorXd::Unit(D_.cols() + 1, D_.cols()));
  work_ += program.work();
  if (least.ending == Ending::failed) return Ending::failed;
  motion_ = least.motion;
  if (least.bound > statics_settings.carries) return Ending::none;
  rays_ = program.rays_;
  return restart() ? Ending::found : Ending::failed;
}

/// Programs of many rays cost what they know.
void StaticsProgram::drop_idle() {
  if (static_cast<Index>(rays_.size()) <=
      statics_settings.most_rays +
          statics_settings.rays_a_cone * static_cast<Index>(statics_.cones().size()))
    return;
  std::vector<ForceRay> kept = StaticsProgram(statics_, D_, free_, b_).rays_;
  for (std::size_t k = kept.size(); k < rays_.size(); ++k)
    if (simplex_->point()[first_ray() + static_cast<Index>(k)] > 0) kept.push_back(rays_[k]);
  std::vector<ForceRay> all = std::exchange(rays_, kept);
  if (restart()) return;
  rays_ = std::move(all);
  (void)restart();
}

/// What all normal forces may come to: a motion that lacks so much a unit of them is amended by
/// giving up its part of the sum's row. An unknown with a cost grows no more, one without may.
double StaticsProgram::most_force(const Eigen::VectorXd& c, const Eigen::VectorXd& x) const {
  const Index sum = statics_.sum_row();
  double most = std::abs(b_[sum]);
  for (Index k = 0; k < D_.cols(); ++k) {
    const bool has_cost = k < c.size() && c[k] != 0;
    most += std::abs(D_(sum, k)) * (has_cost ? 1 + std::abs(x[k]) : statics_settings.most_force);
  }
  return most;
}

StaticsProgram::Optimum StaticsProgram::minimise(const Eigen::VectorXd& c) {
  Optimum best;
  drop_idle();
  bool is_fresh = false;
  const double unit = c.cwiseAbs().maxCoeff();
  for (Index round = 0; round < statics_settings.most_rounds; ++round) {
    const std::size_t known = rays_.size();
    Eigen::VectorXd costs = Eigen::VectorXd::Zero(first_ray() + static_cast<Index>(known));
    costs.head(c.size()) = c;
    const Simplex::Ending ending = simplex_->minimise(costs);
    if (ending == Simplex::Ending::unbounded) {
      best.ending = Ending::unlimited;
      return best;
    }
    if (ending != Simplex::Ending::found) {
      if (is_fresh || !restart()) break; // what the rounds before have found holds
      is_fresh = true;
      continue;
    }
    best.ending = Ending::found;
    best.x = simplex_->point().head(D_.cols());
    best.value = c.dot(best.x.head(c.size()));
    best.motion = -unit * simplex_->multipliers().head(statics_.rows());
    const double lacks = add_missing(best.motion / unit) * unit;
    best.bound = best.value - lacks * most_force(c, best.x);
    if (best.value - best.bound <= statics_settings.closed * std::abs(best.value) ||
        rays_.size() == known)
      break;
  }
  if (best.ending == Ending::found && statics_.is_capped() &&
      best.motion[statics_.sum_row()] > statics_settings.slips * unit)
    best.ending = Ending::unlimited;
  return best;
}

std::vector<StaticsProgram::Contact> StaticsProgram::contacts() const {
  std::vector<Contact> all(statics_.cones().size());
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    const Index place = first_ray() + static_cast<Index>(k);
    const double force = place < simplex_->point().size() ? simplex_->point()[place] : 0;
    if (const ConeRay* const ray = std::get_if<ConeRay>(&rays_[k])) {
      all[ray->cone].normal += force;
      continue;
    }
    const PadRay& ray = std::get<PadRay>(rays_[k]);
    const GripStatics::Pad& pad = statics_.pads()[ray.pad];
    for (std::size_t i = 0; force > 0 && i < pad.cones.size(); ++i) {
      const auto at = static_cast<Index>(i);
      all[pad.cones[i]].normal += force * pad.weights[at] * ray.pressure.dot(pad.places.col(at));
    }
  }
  return all;
}

std::optional<double> least_factor(const GripStatics& statics) {
  StaticsProgram program(statics, statics.grip_column(), 0, statics.load(0));
  using Ending = StaticsProgram::Ending;
  const Ending ending = program.find_point();
  if (ending == Ending::none) return std::numeric_limits<double>::infinity();
  if (ending != Ending::found) return std::nullopt;
  const StaticsProgram::Optimum least = program.minimise(Eigen::VectorXd::Ones(1));
  if (least.ending != Ending::found) return std::nullopt;
  return least.value > statics_settings.closed * statics.unit() ? least.value : 0;
}

} // namespace lcpush::desktop
