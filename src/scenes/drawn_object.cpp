#include "scenes/drawn_object.hpp"

namespace lcpush::desktop {

Prism object_prism(const SceneFile& file) {
  const Vector3<double>& center = file.object.center_of_mass;
  return file.shape.kind == ObjectShape::Kind::cylinder
             ? cylinder_prism(center, file.shape.size, file.shape.axis)
             : box_prism(center, file.shape.size);
}

std::vector<Vector3<double>> drawn_positions(const SceneFile& file) {
  return positions_beside(object_prism(file), file.object.center_of_mass, file.positions,
                          file.bodies);
}

} // namespace lcpush::desktop
