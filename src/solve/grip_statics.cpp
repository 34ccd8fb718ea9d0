#include "solve/grip_statics.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lcpush/desktop/smallest_grip.hpp"
#include "lcpush/mechanics/solve/pad_law.hpp"

namespace lcpush::desktop {

GripStatics::GripStatics(const SceneFile& file, const std::vector<bool>& touching)
    : file_(file), assembled_(file.view()), touching_(touching), moving_(file.planar ? 3 : 6),
      sum_row_(moving_ + assembled_.scene.actuators.size),
      rows_(sum_row_ + 1 + static_cast<Index>(touching.size())) {
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
  for (Index i = 0; i < scene.points.size; ++i)
    has_pads_ = has_pads_ || assembled_.work.pressure.compliance[i] > 0;
  if (!touching_.empty()) add_pads();
}

/// [T.7] c (lambda - lambda_0) + W(n)' m = 0 where a point touches, >= 0 where it has parted.
void GripStatics::add_pads() {
  const Scene<double>& scene = assembled_.scene;
  displacement_ = Eigen::MatrixXd::Zero(rows_, sum_row_);
  for (Index b = 0; b < scene.bodies.size; ++b)
    for (const Index i : points_of(scene.bodies[b])) {
      const Index row = sum_row_ + 1 + i;
      const double c = assembled_.work.pressure.compliance[i];
      const Eigen::VectorXd normal =
          force_column(b, laws::normal_direction(scene.bodies[b], scene.points[i], scales()), true);
      displacement_.row(row) = normal.head(sum_row_).transpose();
      grip_column_[row] = -c * assembled_.work.pressure.preload[i];
      for (Cone& cone : cones_)
        if (cone.point == i)
          cone.normal[row] = cone.normal.head(sum_row_).dot(normal.head(sum_row_)) > 0 ? c : -c;
    }
}

Eigen::MatrixXd GripStatics::gaps() const {
  const auto count = std::count(touching_.begin(), touching_.end(), false);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows_, count);
  Index gap = 0;
  for (std::size_t i = 0; i < touching_.size(); ++i)
    if (!touching_[i]) columns(sum_row_ + 1 + static_cast<Index>(i), gap++) = -1;
  return columns;
}

/// A force's column: its wrench, what it does to the actuators, and its share of the sum.
Eigen::VectorXd GripStatics::force_column(Index body, const Vector6<double>& column,
                                          bool presses) const {
  const Scene<double>& scene = assembled_.scene;
  const Layout<double>& layout = assembled_.assembly.layout();
  Eigen::VectorXd does = Eigen::VectorXd::Zero(rows_);
  for (Index row = 0; row < moving_; ++row) does[row] = column[axis(row)];
  for (const Drive<double>& drive : scene.drives)
    if (drive.body == body)
      does[moving_ + drive.actuator] +=
          laws::grip_coefficient(drive, column, layout.reach[drive.actuator], layout.scales);
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

StaticsProgram::StaticsProgram(const GripStatics& statics, Eigen::MatrixXd D, Index free,
                               Eigen::VectorXd b, const std::vector<ForceRay>& known)
    : statics_(statics), D_(std::move(D)), free_(free), b_(std::move(b)), rays_(known) {
  if (!rays_.empty()) return;
  for (std::size_t i = 0; i < statics.cones().size(); ++i) {
    const GripStatics::Cone& cone = statics.cones()[i];
    const Index count = cone.directions.cols();
    if (count == 0) rays_.push_back({i, Eigen::VectorXd()});
    for (Index k = 0; k < count; ++k)
      for (const double sign : {1.0, -1.0})
        if (sign > 0 || cone.is_round) rays_.push_back({i, sign * Eigen::VectorXd::Unit(count, k)});
  }
}

Eigen::VectorXd StaticsProgram::column(const ForceRay& ray) const {
  const GripStatics::Cone& cone = statics_.cones()[ray.cone];
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(b_.size());
  sum.head(statics_.rows()) = cone.normal;
  for (Index k = 0; k < ray.friction.size(); ++k)
    sum.head(statics_.rows()) += cone.friction * ray.friction[k] * cone.directions.col(k);
  return sum;
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
    if (!cone.is_round || cone.directions.cols() == 0) continue;
    Eigen::VectorXd slip(cone.directions.cols());
    for (Index k = 0; k < slip.size(); ++k) slip[k] = cone.directions.col(k).dot(motion);
    const double speed = slip.norm();
    const double lacks = cone.friction * speed - cone.normal.dot(motion);
    most = std::max(most, lacks);
    if (lacks > statics_settings.missing) rays_.push_back({i, -slip / speed});
  }
  if (rays_.size() > before) simplex_->add(columns(before));
  return most;
}

StaticsProgram::Ending StaticsProgram::find_point() {
  return restart() ? Ending::found : approach();
}

/// No forces of the known rays carry the demand: by those of the cones, as much of it as they can.
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
      if (is_fresh || !restart()) return best;
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
  if (statics_.is_capped() && best.motion[statics_.sum_row()] > statics_settings.slips * unit)
    best.ending = Ending::unlimited;
  return best;
}

std::vector<StaticsProgram::Contact> StaticsProgram::contacts() const {
  std::vector<Contact> all(statics_.cones().size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i].friction = Eigen::VectorXd::Zero(statics_.cones()[i].directions.cols());
  for (std::size_t k = 0; k < rays_.size(); ++k) {
    const Index place = first_ray() + static_cast<Index>(k);
    const double force = place < simplex_->point().size() ? simplex_->point()[place] : 0;
    Contact& contact = all[rays_[k].cone];
    contact.normal += force;
    if (rays_[k].friction.size() > 0)
      contact.friction += force * statics_.cones()[rays_[k].cone].friction * rays_[k].friction;
  }
  return all;
}

std::optional<double> least_factor(const GripStatics& statics) {
  StaticsProgram program(statics, statics.grip_column(), 0, statics.demand(0));
  using Ending = StaticsProgram::Ending;
  const Ending ending = program.find_point();
  if (ending == Ending::none) return std::numeric_limits<double>::infinity();
  if (ending != Ending::found) return std::nullopt;
  const StaticsProgram::Optimum least = program.minimise(Eigen::VectorXd::Ones(1));
  if (least.ending != Ending::found) return std::nullopt;
  return least.value > statics_settings.closed * statics.unit() ? least.value : 0;
}

} // namespace lcpush::desktop
