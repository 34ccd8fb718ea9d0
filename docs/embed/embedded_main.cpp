// Runs embedded.cpp on the desktop: a block between two point fingers, pushed by a point.
#include <cstdio>

#include "embedded.cpp"

int main() {
  using V = Vector3<float>;
  Body<float> bodies[3] = {};
  const V normal[3] = {{0, 0, -1}, {0, 0, 1}, {1, 0, 0}};
  const V tangent[3] = {{1, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (Index b = 0; b < 3; ++b) {
    bodies[b].role = b < 2 ? Role::finger : Role::pusher;
    bodies[b].normal = normal[b];
    bodies[b].tangent = tangent[b];
    bodies[b].friction = 0.5F;
    bodies[b].first_point = b;
    bodies[b].point_count = 1;
    bodies[b].acceleration.setZero();
  }
  bodies[2].acceleration[0] = 0.1F;
  const V points[3] = {{0, 0, 0.005F}, {0, 0, -0.005F}, {-0.05F, 0, 0}};
  const Actuator<float> actuators[2] = {{20, 0}, {20, 0}};
  Drive<float> drives[2] = {{0, 0, {}}, {1, 1, {}}};
  drives[0].twist << 0, 0, -1, 0, 0, 0;
  drives[1].twist << 0, 0, 1, 0, 0, 0;
  Scene<float> scene{};
  scene.object = {0.2F, 1e-4F * Matrix3<float>::Identity(), V::Zero()};
  scene.gravity.setZero();
  scene.facets = 4;
  scene.pressure = Pressure::pad;
  scene.bodies = {bodies, 3};
  scene.points = {points, 3};
  scene.actuators = {actuators, 2};
  scene.drives = {drives, 2};
  std::printf("%zu bytes, %.2f N\n", sizeof arena, static_cast<double>(push_force(scene, 2)));
}
