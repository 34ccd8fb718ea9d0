#include "scenes/planar_squeeze.hpp"

#include "lcpush/mechanics/model/contact.hpp"
#include "scenes/exact_frame.hpp"

#include <cmath>

namespace lcpush::desktop {

template <class S> Index squeezes_out_of_plane(const SceneOf<S>& scene) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body<S>& body = scene.bodies[b];
    for (const Index i : points_of(body)) {
      const Vector3<S>& p = scene.points[static_cast<std::size_t>(i)];
      const Vector6<S> column = wrench_column<S>(p, body.normal);
      const double in_plane = std::hypot(as_double(column[0]), as_double(column[1]));
      const double turning = std::abs(as_double(column[5]));
      const bool moves_it =
          in_plane > direction_slack || turning > direction_slack * as_doubles(p).norm();
      const S closing = column.dot(body.acceleration);
      if (!moves_it && (body.bilateral ? closing != S(0) : closing > S(0)))
        return static_cast<Index>(b);
    }
  }
  return -1;
}
template Index squeezes_out_of_plane(const SceneOf<double>& scene);
template Index squeezes_out_of_plane(const SceneOf<Rational>& scene);

} // namespace lcpush::desktop
