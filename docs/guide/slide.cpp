#include <cstdio>
#include <lcpush/desktop/input_error.hpp>
#include <lcpush/desktop/push.hpp>

using namespace lcpush;

int main(int count, char** words) {
  const char* const path = count > 1 ? words[1] : "fixtures/scenes/straight_slide.toml";
  try {
    const desktop::SceneFile file = desktop::read_scene(path);
    desktop::Push push(file);
    const desktop::PushReport report = push.solve({});
    std::printf("%s%s%s\n", status_text(report.status), report.reason.empty() ? "" : ": ",
                report.reason.c_str());
    if (report.status != Status::solved) return 1;
    for (Index i = 0; i < report.answer.contacts.size; ++i) {
      const ContactAnswer<double>& contact = report.answer.contacts[i];
      if (push.scene().bodies[contact.body].role == Role::pusher)
        std::printf("%s  %.3f N  %s\n", desktop::point_name(file, i).c_str(), contact.normal_force,
                    mode_text(contact.mode));
    }
    return 0;
  } catch (const desktop::InputError& error) { // "FILE:LINE: what is wrong, and what to do"
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
