#include "solve/self_stress.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush::desktop {
namespace {

/// Columns of a cone's rays: of a round one as many as stand around it, each so much longer that
/// the circle is inside their hull, and torsion beside them.
void add_rays(const GripStatics::Cone& cone, std::vector<Eigen::VectorXd>& rays) {
  const Index count = cone.directions.cols();
  if (count == 0) return rays.push_back(cone.normal);
  if (!cone.is_round) {
    for (Index k = 0; k < count; ++k)
      rays.emplace_back(cone.normal + cone.friction * cone.directions.col(k));
    return;
  }
  const Index steps = statics_settings.stress_rays;
  const double reach = cone.friction / circle_cosine<double>(1, 2 * steps);
  for (Index k = 0; k < steps; ++k) {
    Eigen::VectorXd along = circle_cosine<double>(k, steps) * cone.directions.col(0);
    if (count > 1) along += circle_sine<double>(k, steps) * cone.directions.col(1);
    rays.emplace_back(cone.normal + reach * along);
  }
  for (Index axis = 2; axis < count; ++axis)
    for (const double sign : {1.0, -1.0})
      rays.emplace_back(cone.normal + sign * cone.friction * cone.directions.col(axis));
}

} // namespace

bool has_self_stress(const GripStatics& statics) {
  if (!statics.is_capped()) return false;
  std::vector<Eigen::VectorXd> rays;
  for (const GripStatics::Cone& cone : statics.cones()) add_rays(cone, rays);
  if (rays.empty()) return false;
  // Their balance, and a sum of 1.
  Eigen::MatrixXd A(statics.sum_row() + 1, static_cast<Index>(rays.size()));
  for (std::size_t k = 0; k < rays.size(); ++k)
    A.col(static_cast<Index>(k)) << rays[k].head(statics.sum_row()), 1;
  const Eigen::VectorXd b = Eigen::VectorXd::Unit(A.rows(), statics.sum_row());
  return Simplex(A, b, 0).find_point() == Simplex::Ending::found;
}

} // namespace lcpush::desktop
