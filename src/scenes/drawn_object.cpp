#include "scenes/drawn_object.hpp"

namespace lcpush::desktop {

Prism object_prism(const SceneFile& file) {
  const Vector3<double>& center = file.object.center_of_mass;
  switch (file.shape.kind) {
  case ObjectShape::Kind::cylinder: return cylinder_prism(center, file.shape.size, file.shape.axis);
  case ObjectShape::Kind::ball: return ball_prism(center, file.shape.size[0] / 2);
  default: return box_prism(center, file.shape.size);
  }
}

bool is_round_in(const View& view, const ObjectShape& shape) {
  return shape.kind == ObjectShape::Kind::ball ||
         (shape.kind == ObjectShape::Kind::cylinder && view.toward[shape.axis] != 0);
}

std::vector<Vector3<double>> drawn_positions(const SceneFile& file) {
  return positions_beside(object_prism(file), file.object.center_of_mass, file.positions,
                          file.bodies);
}

} // namespace lcpush::desktop
