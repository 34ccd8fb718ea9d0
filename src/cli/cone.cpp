// lcpush cone: the pushes that stick.
#include "lcpush/desktop/cone.hpp"
#include "cli/commands.hpp"
#include "cli/scene_arguments.hpp"

namespace lcpush::cli {
namespace {

std::optional<Vector6<double>> asked_twist(const Arguments& arguments) {
  const auto numbers =
      arguments.numbers("--twist", 3, "vx vy wz (m/s and rad/s, of the centre of mass)");
  if (!numbers) return std::nullopt;
  Vector6<double> twist = Vector6<double>::Zero();
  twist[0] = (*numbers)[0];
  twist[1] = (*numbers)[1];
  twist[5] = (*numbers)[2];
  if (twist.isZero(0)) throw UsageError("--twist is no motion: all three numbers are 0");
  return twist;
}

/// A cut, where --vary asks for one.
int run_slice(const Arguments& arguments, const VariedScene& scene, const std::string& vary) {
  const std::string format = arguments.format({"text", "json", "svg"});
  if (arguments.has("--twist"))
    throw UsageError("--vary cuts the cone, --twist judges one motion; give one of the two");
  const SceneFile all = scene.as_given();
  const VariedScene alone = scene.with_only_pusher(all.body_name(chosen_pusher(arguments, all)));
  const SceneFile file = alone.as_given();
  const ConeSlice slice = find_slice(alone, read_variation(alone, vary),
                                     static_cast<Index>(chosen_pusher(arguments, file)));
  write_answer(arguments, format,
               format == "json"  ? slice_json(file, slice)
               : format == "svg" ? slice_svg(file, slice)
                                 : slice_text(file, slice),
               file);
  return 0;
}

int run_cone(const Arguments& arguments) {
  const std::string format = arguments.format({"text", "json", "svg"});
  const std::optional<Vector6<double>> twist = asked_twist(arguments);
  if (arguments.files().empty()) refuse_no_scene();
  const VariedScene scene = read_varied_scene(arguments, arguments.files()[0], Needs::scene);
  if (const auto vary = arguments.value("--vary")) return run_slice(arguments, scene, *vary);
  const SceneFile file = scene.as_given();
  const ConeReport report = find_cone(file, chosen_pusher(arguments, file), twist);
  write_answer(arguments, format,
               format == "json"  ? cone_json(file, report)
               : format == "svg" ? cone_svg(file, report)
                                 : cone_text(file, report, telling(arguments)),
               file);
  return report.status == Status::solved ? 0 : 1;
}

} // namespace

Command cone_command() {
  return {"cone",
          "SCENE.toml [OPTIONS]",
          "the motion cone: all pushes with which the pusher sticks to the object",
          "In the plane, for fingers that press across it: the motions in which the pusher takes\n"
          "the object along without slipping, in the limit of a slow push. Each edge is a wrench\n"
          "that the pusher can just exert, with the motion that it makes; other pushers are left\n"
          "out. The scene's own push, or that of --twist, is judged: by how much it sticks, and\n"
          "from which grip force on. In space, or where fingers press in the plane, --vary cuts\n"
          "the cone along one number of the pusher's motion.\n\n"
          "Examples:\n"
          "  lcpush cone docs/guide/square.toml\n"
          "  lcpush cone docs/guide/square.toml --twist \"0.002 0.01 1\"\n",
          with_scene_options(
              {{"--twist", "V", "the motion that is judged, \"vx vy wz\" at the centre of mass"},
               {"--vary", "PATH=FROM:TO",
                "any scene: where along this, such as wall.acceleration[1]=-1:1, it sticks"},
               {"--pusher", "NAME", "which one, among several"},
               pressure_option,
               verbose_option,
               {"--format", "FORMAT", "text (default), json or svg; --json for short"}}),
          1,
          run_cone};
}

} // namespace lcpush::cli
