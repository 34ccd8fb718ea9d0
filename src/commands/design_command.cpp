// design: the numbers of a scene with which a push sticks for the widest box.
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/design.hpp"
#include "lcpush/desktop/funnel.hpp"
#include "scenes/mirror.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::commands {
namespace {

constexpr double same_motion = 1e-9;

/// The scene in which the pusher moves as --push says.
VariedScene with_push(const Values& values, const VariedScene& scene) {
  const auto push =
      values.numbers("push", twist_units, "vx vy wz (m/s and rad/s, of the centre of mass)");
  if (!push) return scene;
  const SceneFile file = scene.as_given();
  const Index pusher = values.pusher(file);
  const bool is_fast = file.strokes[static_cast<std::size_t>(pusher)].is_velocity;
  const std::string motion = is_fast ? "velocity" : "acceleration";
  Vector3<double> arm = file.object.center_of_mass; // from where the pusher's velocity is meant
  const std::vector<std::string> paths = scene.paths();
  const std::string name = file.body_name(pusher);
  for (Index i = 0; i < 3; ++i)
    if (const std::string about = name + ".about[" + std::to_string(i) + "]";
        std::find(paths.begin(), paths.end(), about) != paths.end())
      arm[i] -= scene.find(about).value;
  const double turn = (*push)[2];
  const double own[] = {(*push)[0] + turn * arm.y(), (*push)[1] - turn * arm.x(), 0, 0, 0, turn};
  VariedScene pushed = scene;
  for (int i = 0; i < 6; ++i)
    pushed = pushed.with({pushed.find(name + (i < 3 ? "." : ".angular_") + motion + "[" +
                                      std::to_string(i % 3) + "]")},
                         {own[i]});
  const Vector6<double> made = pushed.as_given().body(pusher).acceleration;
  if (!(std::abs(made[0] - (*push)[0]) + std::abs(made[1] - (*push)[1]) <=
        same_motion * (std::abs(made[0]) + std::abs(made[1]) + std::abs(turn))))
    values.refuse("push", values.label("push") +
                              ": the object is turned, and with it the axes of " +
                              "the pusher's motion; give that in the scene");
  return pushed;
}

EdgePose edge_pose(const Values& values, const char* option) {
  const auto pose = values.numbers(option, {"m", "m", "rad"},
                                   "x y angle (m along the push, m along the edge, rad)");
  return {(*pose)[0], (*pose)[1], (*pose)[2]};
}

/// From which poses an edge leaves the object flush.
Result run_funnel(const Values& values, Listener&) {
  const std::string format = values.one_of("format", values.format(), {"text", "json"});
  for (const char* option : {"choose", "push", "tolerance"})
    if (values.has(option))
      values.refuse(option, values.label(option) + " does not go with " + values.label("from-box"));
  const EdgePose box = edge_pose(values, "from-box");
  if (!(std::min({box[0], box[1], box[2]}) >= 0) || !(std::max({box[0], box[1], box[2]}) > 0))
    values.refuse("from-box", values.label("from-box") + " takes half the sides of a box, >= 0");
  std::optional<EdgePose> goal;
  if (values.has("goal")) goal = edge_pose(values, "goal");
  if (goal && (*goal)[2] != 0)
    values.refuse("goal", values.label("goal") + ": an edge leaves the object at the angle of the "
                                                 "scene, 0");
  const Document document = values.scene_document();
  const SceneFile given = values.scene(Needs::scene);
  const std::string name = given.body_name(values.pusher(given));
  SceneFile file = parse_scene(with_flat_edge(document.text, document.name, name), document.name);
  file.title = given.title;
  const FunnelReport report = find_funnel(file, values.pusher(file), box);
  return {report.is_flush,
          format == "json" ? funnel_json(file, report) : funnel_text(file, report, goal)};
}

/// Of a scene that is plane by its own symmetry: a choice would leave that.
void refuse_leaving_plane(const VariedScene& scene, const Values& values) {
  const auto leaves = leaves_plane(scene, values.texts("choose"), values.texts("tolerance"));
  if (!leaves) return;
  const auto& [path, end] = *leaves;
  values.refuse("choose", values.label("choose") + " " + path + ": with " + shown(end) +
                              " the scene is no longer its own image across z, and a design is "
                              "one of motions in the plane. Choose the same of its image with it "
                              "(\"*.NUMBER\" is that of all bodies), or say planar = true if the "
                              "object cannot leave the plane");
}

Result run_design(const Values& values, Listener& listener) {
  if (values.has("from-box")) return run_funnel(values, listener);
  if (values.has("goal"))
    values.refuse("goal", values.label("goal") + " goes with " + values.label("from-box"));
  const std::string format = values.format();
  if (!values.has("choose"))
    values.refuse("choose", values.usage("choose") + " says what may be chosen, such as " +
                                values.label("choose") + " wall.shift[1]=-0.005:0.005");
  VariedScene scene = values.varied_scene(Needs::scene);
  for (const char* option : {"choose", "tolerance"})
    values.refuse_later_in(scene.as_given(), option);
  if (const SceneFile file = scene.as_given(); !file.planar && file.is_round && is_plane(file)) {
    refuse_leaving_plane(scene, values);
    listener.announce("The scene is its own image across z: taken as planar = true.");
    scene.set_planar();
  }
  scene = with_push(values, values.with_only_pusher(scene, listener));
  const DesignReport report =
      find_design(scene, values.texts("choose"), values.texts("tolerance"), format == "svg");
  values.doubt(report.doubts);
  SceneFile file = scene.as_given();
  return {report.sticks() && !(report.asks_ranges && report.chosen.verdict != BoxVerdict::always),
          format == "json"   ? design_json(report)
          : format == "svg"  ? design_svg(file, report)
          : format == "toml" ? report.scene
                             : design_text(file, report)};
}

} // namespace

Command design_command() {
  return {
      "design",
      "SCENE.toml --choose PATH=FROM:TO | --from-box \"X Y ANGLE\" [OPTIONS]",
      "numbers of the scene with which a push sticks most surely",
      "Looks for the places, sizes, frictions and grips in these ranges with which the scene's\n"
      "push, or that of --push, sticks while the numbers that you do not know are as far off as\n"
      "possible: all frictions, grips and the mass, or those of --tolerance. Says what makes it\n"
      "slip beyond, and what each choice gives alone; the others are as in the file then.\n"
      "With --from-box: does a push with a flat edge leave the object flush from every pose so\n"
      "near the scene's, how far does the edge go, and what is left of the box?\n\n"
      "Examples:\n"
      "  lcpush design docs/guide/narrow_wall.toml \\\n"
      "    --choose \"wall.center[1]=-0.012:0.012\"\n"
      "  lcpush design docs/guide/narrow_wall.toml --choose wall.width=0.004:0.02 \\\n"
      "    --choose \"*.grip_force=10:40\" --tolerance \"*.friction=10%\" --format toml\n"
      "  lcpush design docs/check/block.toml --from-box \"1 mm 2 mm 5 deg\"\n",
      with_scene_options(
          {{"choose", "PATH=FROM:TO",
            "what may be chosen: a number, *.NUMBER as one, BODY.width or center[1] of a line",
            true},
           {"from-box", "\"X Y ANGLE\"",
            "half the sides of a box of poses: along the push and along the edge (m), rad"},
           {"goal", "\"X Y 0\"", "where the object is to end, beside the scene's pose"},
           {"push", "V", "the motion that is to stick, \"vx vy wz\" at the centre of mass"},
           {"pusher", "NAME", "which one, among several; the others are left out"},
           pressure_option,
           facets_option,
           tolerance_option,
           format_option("text (default), json, svg or toml (the scene as chosen); --json for "
                         "short")}),
      run_design,
      {"text", "json", "svg", "toml"}};
}

} // namespace lcpush::commands
