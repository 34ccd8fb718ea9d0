#include "sweep/proven_jam.hpp"

#include <algorithm>
#include <vector>

#include "lcpush/desktop/owned.hpp"
#include "lcpush/mechanics/study/existence.hpp"
#include "lcpush/mechanics/study/jam.hpp"
#include "sweep/settings.hpp"

namespace lcpush::desktop {
bool is_proven_jam(const Assembly<double>& assembly) {
  const Layout<double>& layout = assembly.layout();
  const ExistenceSize size = existence_size(assembly);
  std::vector<double> scalars(static_cast<std::size_t>(size.scalars()));
  std::vector<int> integers(static_cast<std::size_t>(size.integers()));
  std::vector<double> forces(static_cast<std::size_t>(layout.forces));
  const StudyMemory<double> memory{span_of(scalars), span_of(integers)};
  if (find_smooth_squeeze(assembly, size, memory, forces.data()) != Status::solved) return false;
  // The same as a ray of the whole problem, by whose reading a solve calls it a jam.
  std::vector<double> v(static_cast<std::size_t>(layout.size), 0.0);
  double total = 0;
  for (const ConeGroup<double>& cone : layout.cones)
    for (Index k = 0; k < cone.normals; ++k) {
      const double force = forces[static_cast<std::size_t>(cone.force + k)];
      v[static_cast<std::size_t>(cone.variable + k)] = force;
      total += force;
    }
  std::vector<Squeeze<double>> bodies(static_cast<std::size_t>(assembly.scene().bodies.size));
  const RaySum<double> sum = read_ray(assembly, v.data(), span_of(bodies));
  return sum.proves_no_answer() &&
         sum.power > SweepSettings::proven_squeeze * total * std::max(sum.motion, 1.0);
}

} // namespace lcpush::desktop
