#include <cstdio>
#include <lcpush/desktop/push.hpp>

int main() {
  using namespace lcpush;
  const desktop::SceneFile file = desktop::read_scene("fixtures/scenes/straight_slide.toml");
  desktop::Push push(file);
  const desktop::PushReport report = push.solve({});
  std::printf("%s, residual below 1e-9: %s\n", status_text(report.status),
              report.residuals.max() < 1e-9 ? "yes" : "no");
  for (Index i = 8; i < report.answer.contacts.size; ++i)
    std::printf("%s  %.3f N  %s\n", desktop::point_name(file, i).c_str(),
                report.answer.contacts[i].normal_force, mode_text(report.answer.contacts[i].mode));
}
