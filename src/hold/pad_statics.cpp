#include "hold/pad_statics.hpp"

#include <utility>

#include "hold/patch_pressures.hpp"

namespace lcpush::desktop {

/// What a load adds to one locked finger it takes from those across: where their normals cancel
/// they press, together, with what they were closed with. More would be a wedge, which no one
/// counts on.
void PadStatics::bound_locked_forces() {
  Vector3<double> closes = Vector3<double>::Zero();
  double sum = 0;
  for (const Body<double>& body : assembled_.scene.bodies) {
    if (!(body.preload > 0)) return;
    closes += body.preload * body.normal;
    for (const Index i : points_of(body)) sum += assembled_.work.pressure.preload[i];
  }
  if (closes.norm() > statics_settings.flat * sum * scales().force) return;
  is_capped_ = false;
  fixed_[sum_row_] = 0;
  grip_column_[sum_row_] = -sum;
}

/// [T.7] c (lambda - lambda_0) + W(n)' m = 0 where a point touches, >= 0 where it has parted.
void PadStatics::add_pads() {
  bound_locked_forces();
  displacement_ = Eigen::MatrixXd::Zero(rows_, sum_row_);
  for (Index b = 0; b < assembled_.scene.bodies.size; ++b) {
    const Body<double>& body = assembled_.scene.bodies[b];
    if (compliance(body.first_point) > 0 && !body.bilateral) {
      add_patch(b);
      continue;
    }
    for (const Index i : points_of(body)) {
      const double c = compliance(i);
      const Eigen::VectorXd normal = normal_of(b, i);
      for (Cone& cone : cones_)
        if (cone.point == i) {
          cone.normal.conservativeResizeLike(Eigen::VectorXd::Zero(rows_ + 1));
          cone.normal[rows_] = cone.normal.head(sum_row_).dot(normal) > 0 ? c : -c;
        }
      follow(normal, c * assembled_.work.pressure.preload[i],
             !touching_[static_cast<std::size_t>(i)]);
    }
  }
  for (Cone& cone : cones_) {
    cone.normal.conservativeResizeLike(Eigen::VectorXd::Zero(rows_));
    cone.directions.conservativeResizeLike(Eigen::MatrixXd::Zero(rows_, cone.directions.cols()));
  }
  gaps_.conservativeResizeLike(Eigen::MatrixXd::Zero(rows_, gaps_.cols()));
}

/// One more row: normal' m = preload at the scene's own grip, or no less.
void PadStatics::follow(const Eigen::VectorXd& normal, double preload, bool parts) {
  const Index row = rows_++;
  for (Eigen::VectorXd* const part : {&fixed_, &grip_column_})
    part->conservativeResizeLike(Eigen::VectorXd::Zero(rows_));
  displacement_.conservativeResize(rows_, Eigen::NoChange);
  displacement_.row(row) = normal.transpose();
  grip_column_[row] = -preload;
  if (!parts) return;
  gaps_.conservativeResizeLike(Eigen::MatrixXd::Zero(rows_, gaps_.cols() + 1));
  gaps_(row, gaps_.cols() - 1) = -1;
}

/// Over w_i and the softness s of its body, lambda_i / w_i = F - W(n_i)' m / s is affine in the
/// place: its coefficients are those of W(n).
void PadStatics::add_patch(Index b) {
  const Body<double>& body = assembled_.scene.bodies[b];
  const PatchPlaces patch = patch_places(assembled_.scene, body);
  const double pressed = assembled_.work.pressure.preload[body.first_point] / patch.weights[0];
  const double softness = compliance(body.first_point) * patch.weights[0];
  Eigen::MatrixXd normals(sum_row_, body.point_count);
  std::vector<Index> touch, parted;
  for (Index i = 0; i < body.point_count; ++i) {
    normals.col(i) = normal_of(b, body.first_point + i) / softness;
    (touching_[static_cast<std::size_t>(body.first_point + i)] ? touch : parted).push_back(i);
  }
  if (!touch.empty()) {
    Pad pad;
    pad.row = rows_;
    pad.weights = patch.weights(touch);
    pad.places = patch.places(Eigen::all, touch);
    pad.pressures = nonnegative_pressures(pad.places, pad.weights);
    for (std::size_t c = 0; c < cones_.size(); ++c)
      if (cones_[c].point >= body.first_point &&
          cones_[c].point < body.first_point + body.point_count)
        pad.cones.push_back(c);
    pads_.push_back(std::move(pad));
    const Eigen::MatrixXd affine = normals * patch.weights.asDiagonal() * patch.places.transpose();
    for (Index k = 0; k < affine.cols(); ++k) follow(affine.col(k), k == 0 ? pressed : 0, false);
  }
  for (const Index i : rim(patch.places(Eigen::all, parted)))
    follow(normals.col(parted[static_cast<std::size_t>(i)]), pressed, true);
}

double PadStatics::presses(Index point, const Eigen::VectorXd& displacement, double factor) const {
  return factor * compliance(point) * assembled_.work.pressure.preload[point] -
         normal_of(file_.body_of(point), point).dot(displacement);
}

} // namespace lcpush::desktop
