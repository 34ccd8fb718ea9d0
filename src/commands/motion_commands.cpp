// move, cone and plan: where pushes take the object: in time, while they stick, and by a plan.
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/cone.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/move.hpp"
#include "lcpush/desktop/plan.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <cmath>

namespace lcpush::commands {
namespace {

constexpr double most_turn = 6.2832; // rad, once round

MoveOptions move_options(const Values& values, const SceneFile& file, Listener& listener) {
  constexpr double largest_length = 1e6; // m
  MoveOptions options;
  options.time = values.number("time", longest_time, ", in seconds, such as 2.5", "s");
  options.step = values.number("step", longest_time, ", in seconds, such as 0.001", "s");
  options.tolerance = values.number("tolerance", largest_length, ", in metres, such as 1e-4", "m");
  options.distance = values.number("stop-after", largest_length, ", in metres, such as 0.03", "m")
                         .value_or(options.distance);
  options.frames = values.whole("frames", {2, limits::motion_frames}).value_or(options.frames);
  options.most_steps =
      values.whole("most-steps", {1, limits::motion_solves}).value_or(limits::motion_solves);
  if (options.step && options.tolerance)
    values.refuse("tolerance", values.label("step") + " is a fixed step, " +
                                   values.label("tolerance") +
                                   " chooses steps; give one of the two");
  const double time = options.time.value_or(motion_time(file));
  if (options.step && time / *options.step > static_cast<double>(limits::motion_solves))
    values.refuse("step", values.label("step") + " " + shown(*options.step) + " over " +
                              shown(time) + " s makes more than the " +
                              std::to_string(limits::motion_solves) +
                              " steps that are made; ask for a longer step or less time");
  options.progress = [&listener](double done, double at) {
    listener.progress(done, "of the motion, at " + printed("%.3g s", at));
  };
  options.stop = [&listener](double part) { return listener.stop(part); };
  return options;
}

Result run_move(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const SceneFile file = values.scene(Needs::scene, Strokes::all);
  const MotionReport report = move(file, move_options(values, file, listener));
  return {report.status == Status::solved,
          format == "json"        ? move_json(file, report)
          : format == "csv"       ? move_csv(file, report)
          : format == "svg"       ? move_svg(file, report)
          : format == "animation" ? move_animation(file, report)
          : format == "html"      ? move_html(file, report)
                                  : move_text(file, report, values.telling() == Telling::full),
          {},
          report.stop};
}

std::optional<Vector6<double>> asked_twist(const Values& values) {
  const auto numbers =
      values.numbers("twist", twist_units, "vx vy wz (m/s and rad/s, of the centre of mass)");
  if (!numbers) return std::nullopt;
  Vector6<double> twist = Vector6<double>::Zero();
  twist[0] = (*numbers)[0];
  twist[1] = (*numbers)[1];
  twist[5] = (*numbers)[2];
  if (twist.isZero(0))
    values.refuse("twist", values.label("twist") + " is no motion: all three numbers are 0");
  return twist;
}

/// A cut, where --vary asks for one.
Result run_slice(const Values& values, const std::string& format, const VariedScene& scene,
                 Listener& listener) {
  if (values.has("twist"))
    values.refuse("twist", values.label("vary") + " cuts the cone, " + values.label("twist") +
                               " judges one motion; give one of the two");
  const std::vector<Variation> variations = values.variations(scene);
  if (variations.size() != 1)
    values.refuse("vary", values.label("vary") + " cuts the cone along one number");
  const SceneFile file = scene.as_given();
  const ConeSlice slice = find_slice(scene, variations[0], values.pusher(file),
                                     [&](double part) { return listener.stop(part); });
  return {true,
          format == "json"  ? slice_json(file, slice)
          : format == "svg" ? slice_svg(file, slice)
                            : slice_text(file, slice),
          {},
          slice.stop};
}

Result run_cone(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const std::optional<Vector6<double>> twist = asked_twist(values);
  VariedScene scene = values.with_only_pusher(values.scene_with_ranges(Needs::scene), listener);
  if (!values.has("vary") && values.lies_in_plane(scene.as_given(), listener)) scene.set_planar();
  if (values.has("vary")) return run_slice(values, format, scene, listener);
  SceneFile file = scene.as_given();
  if (values.has("tolerance") && scene.ranges().empty())
    values.refuse("tolerance", values.label("tolerance") +
                                   " is of a pusher that is left out; name one that pushes");
  if (!scene.ranges().empty() && format != "svg") {
    file.lines.ranges = 0; // they are answered
    const Index pusher = values.pusher(file);
    const BoxAnswer box = judge_push(scene, twist);
    Result result{box.verdict == BoxVerdict::always,
                  format == "json"   ? cone_json(file, find_cone(file, pusher, twist), &box)
                  : format == "toml" ? values.corner_scene(box)
                                     : box_text(file, box, "This push", "sticks", "may slip")};
    if (values.has("certify"))
      result.box_certificate = result.is_good
                                   ? certify_box(values.scene_document().text, scene, twist)
                                   : BoxCertificate{"", "the push does not stick for every value"};
    return result;
  }
  if (values.has("certify"))
    values.refuse("certify", values.label("certify") +
                                 " proves a push for every value of a box; give " +
                                 values.usage("tolerance"));
  if (format == "toml") (void)values.corner_scene({});
  const ConeReport report = find_cone(file, values.pusher(file), twist);
  return {report.status == Status::solved, format == "json" ? cone_json(file, report)
                                           : format == "svg"
                                               ? cone_svg(file, report)
                                               : cone_text(file, report, values.telling())};
}

Result run_plan(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const auto to = values.numbers("to", {"m", "m", "rad"}, "x y angle (m, m and rad)");
  if (!to)
    values.refuse("to", values.usage("to") + " says where the object is to go, in m, m and rad");
  if (std::abs((*to)[2]) > most_turn)
    values.refuse("to", values.label("to") + ": a turn of " + brief((*to)[2]) +
                            " rad is more than once round; it is in rad, not in degrees");
  Document scene = values.scene_document();
  SceneFile file = values.scene(Needs::scene, Strokes::all);
  VariedScene box = values.scene_with_ranges(Needs::scene);
  if (values.lies_in_plane(file, listener)) {
    scene.text = with_values(std::move(scene.text), scene.name, "", {"planar=true"});
    file = parse_scene(scene.text, scene.name, Strokes::all);
    box.set_planar();
  }
  PlanOptions options;
  if (!box.ranges().empty()) {
    options.box = box;
    file.lines.ranges = 0; // they are answered
  }
  options.progress = [&listener](double done) {
    listener.progress(done, "of the places that are tried");
  };
  options.stop = [&listener](double part) { return listener.stop(part); };
  const PlanReport report =
      find_plan(scene.text, scene.name, {(*to)[0], (*to)[1], (*to)[2]}, options);
  if ((format == "html" || format == "toml") && report.pushes.empty())
    throw InputError(scene.name + (report.found
                                       ? ": no push is needed, so there is none to show"
                                       : ": no plan was found, so there is none to show; `lcpush "
                                         "plan` without " +
                                             values.label("format") + " says how near it came"));
  return {report.found,
          format == "json"   ? plan_json(file, report)
          : format == "html" ? move_html(report.scene, report.replay)
          : format == "toml" ? report.scene_text
                             : plan_text(file, report, values.telling() == Telling::full),
          {},
          report.stop};
}

} // namespace

Command move_command() {
  return {
      "move",
      "SCENE.toml [OPTIONS]",
      "where the object ends up: the push goes on, step by step",
      "Follows the object while the pushers move on: each step in time is a push of its own, over\n"
      "the contacts as they then are. Points leave faces and come back, patches let go, a "
      "cylinder\n"
      "rolls. Pushers move with their velocity, or speed up from rest by their acceleration.\n\n"
      "Steps are halved until a step agrees with two of half the length, and where a contact\n"
      "begins to slip, sticks, parts or leaves its face. A step without an answer ends the motion\n"
      "there, and the answer says why.\n\n"
      "Examples:\n"
      "  lcpush move fixtures/scenes/pivot.toml --time 0.8\n"
      "  lcpush move fixtures/scenes/pivot.toml --format html -o pivot.html\n",
      with_scene_options(
          {{"time", "S",
            "how long, in seconds or \"300 ms\" (to the end of the last stroke, else 1 s)"},
           {"stop-after", "M", "end once a contact point's place on the object has gone so far"},
           {"step", "S", "steps of this length, without control"},
           {"tolerance", "M", "error of the whole path (a thousandth of the object's size)"},
           {"frames", "N", "moments that are kept, evenly spread, ends included (101)"},
           verbose_option,
           {"seconds", "S",
            "stop after so much processor time (8), with what there is; so does Ctrl-C"},
           format_option("text (default), json, csv, svg, animation (an SVG that moves) or html; "
                         "--json for short")}),
      run_move,
      {"text", "json", "csv", "svg", "animation", "html"},
      1,
      true,
      {"most_steps"}};
}

Command cone_command() {
  return {"cone",
          "SCENE.toml [OPTIONS]",
          "the motion cone: pushes with which the pusher sticks",
          "In the plane, for fingers that press across it: the motions in which the pusher takes\n"
          "the object along without slipping, in the limit of a slow push. Each edge is a wrench\n"
          "that the pusher can just exert, with the motion that it makes; other pushers are left\n"
          "out. The scene's own push, or that of --twist, is judged: by how much it sticks, and\n"
          "from which grip force on. In space, or where fingers press in the plane, --vary cuts\n"
          "the cone along one number of the pusher's motion.\n\n"
          "With --tolerance, or where numbers of the scene are ranges, one motion is judged for\n"
          "every value: by the corners of that box, in fractions.\n\n"
          "Examples:\n"
          "  lcpush cone docs/guide/square.toml --pusher east\n"
          "  lcpush cone docs/guide/square.toml --pusher east --tolerance \"*.friction=10%\"\n"
          "  lcpush cone docs/guide/square.toml --pusher east --twist \"-0.01 0.002 0.1\"\n",
          with_scene_options(
              {{"twist", "V", "the motion that is judged, \"vx vy wz\" at the centre of mass"},
               {"vary", "PATH=FROM:TO",
                "any scene: where along this, such as wall.acceleration[1]=-1:1, it sticks"},
               {"pusher", "NAME", "which one, among several; the others are left out"},
               pressure_option,
               facets_option,
               tolerance_option,
               {"certify", "FILE", "also write an exact proof for docs/check/lcpush_check_box.py",
                false, true},
               verbose_option,
               format_option("text (default), json, svg or toml (a scene: the corner of a box at "
                             "which it slips); --json for short")}),
          run_cone,
          {"text", "json", "svg", "toml"},
          1,
          true};
}

Command plan_command() {
  return {
      "plan",
      "SCENE.toml --to \"X Y ANGLE\" [OPTIONS]",
      "pushes that take the object to another place in the grip",
      "Takes the scene's pushers for fixed features of the environment, against which the hand\n"
      "can push the object, each where the scene has it touch. Looks for places on the way\n"
      "that are joined by pushes in which the pusher sticks (see `lcpush cone`), the shortest\n"
      "way with few changes of pusher. The plan is replayed by `lcpush move`, and what is\n"
      "printed is where that ends. With --tolerance, or where numbers of the scene are ranges,\n"
      "every push sticks for every value.\n\n"
      "Examples:\n"
      "  lcpush plan docs/guide/square.toml --to \"-0.04 0.02 0.1\"\n"
      "  lcpush plan docs/guide/square.toml --to \"-0.04 0.02 0.1\" \\\n"
      "    --tolerance \"*.friction=10%\"\n"
      "  lcpush plan docs/guide/square.toml --to \"-0.04 0.02 0.1\" --format html \\\n"
      "    -o p.html\n",
      with_scene_options(
          {{"to", "\"X Y ANGLE\"",
            "where the centre of mass is to go from where it is, and the turn: in m and rad, or "
            "with units"},
           tolerance_option,
           verbose_option,
           {"seconds", "S", "search for so much processor time at most (8)"},
           format_option(
               "text (default), json, html (the replay as a page) or toml (a scene with the plan's "
               "strokes); --json for short")}),
      run_plan,
      {"text", "json", "html", "toml"},
      1,
      true};
}

} // namespace lcpush::commands
