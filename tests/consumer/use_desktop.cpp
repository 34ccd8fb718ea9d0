// A project that links the compiled desktop library.
#include <lcpush/desktop/push.hpp>

#include <cstdio>

namespace {
constexpr const char* scene = R"(
[object]
mass = 1
box = [0.1, 0.1, 0.1]
[[pusher]]
name = "hand"
shape = "point"
center = [-0.05, 0, 0]
normal = [1, 0, 0]
friction = 0.5
acceleration = [2, 0, 0]
)";
} // namespace

int main() {
  using namespace lcpush;
  const desktop::SceneFile file = desktop::parse_scene(scene, "scene");
  desktop::Push push(file);
  const desktop::PushReport report = push.solve({});
  const double force = report.answer.contacts[0].normal_force; // F = m a
  std::printf("%s, %.3f N\n", status_text(report.status), force);
  return report.status == Status::solved && force > 1.999999 && force < 2.000001 ? 0 : 1;
}
