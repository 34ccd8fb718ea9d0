// solve, break and matrices: a scene's push, the force that breaks its grasp, and its matrices.
#include "commands/asked_push.hpp"
#include "commands/history.hpp"
#include "commands/values.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/matrices.hpp"
#include "lcpush/desktop/report.hpp"
#include "lcpush/desktop/spread.hpp"

#include <memory>

namespace lcpush::commands {
namespace {

const Option history_option{"history", "",
                            "instead of the answer, each law's residual sweep by sweep (also csv)"};

const Option sensitivity_option{
    "sensitivity", "", "with --format json: derivatives by each acceleration and grip force"};

/// Under --pressure and --facets. Certificates prove pyramids, whose directions are fractions: the
/// answer is theirs as well.
SceneFile scene_to_solve(const Values& values, Listener& listener) {
  const bool as_it_is = !values.has("pressure") && !values.has("facets");
  SceneFile file =
      as_it_is ? values.scene(Needs::scene) : values.varied_scene(Needs::scene).as_given();
  if (values.has("certify")) values.take_pyramids(file, listener);
  return file;
}

/// The scene whose middle is solved, if it is asked for every value of its ranges.
std::optional<VariedScene> scene_with_box(const Values& values) {
  if (!values.has("tolerance") && !values.has("box")) return std::nullopt;
  if (values.has("certify"))
    values.refuse("certify", values.label("certify") + " proves one answer, not those of a box");
  VariedScene scene = values.scene_of_middle(Needs::scene);
  if (scene.ranges().empty())
    values.refuse("box", values.label("box") + " is of a scene's ranges, and it has none; give " +
                             values.usage("tolerance"));
  return scene;
}

/// The verdict on all of them beside the answer of the middle.
std::string with_box(std::string text, const std::string& format, const SceneFile& file,
                     const BoxAnswer& box) {
  if (format == "json") {
    JsonWriter json;
    json.begin_object();
    write_box(json, box);
    return text.replace(0, 1, json.text() + ",");
  }
  return text + "\n" + modes_sentence(file, box) + "\n";
}

Result run_solve(const Values& values, Listener& listener) {
  const Solver solver = values.solver();
  const std::string format = values.format_with_history(solver);
  if (values.has("sensitivity") && (format != "json" || values.has("history")))
    values.refuse("sensitivity", values.label("sensitivity") + " is a key of the answer in " +
                                     values.label("format") + " json, without --history");
  const std::optional<VariedScene> ranges = scene_with_box(values);
  SceneFile file = ranges ? ranges->as_given() : scene_to_solve(values, listener);
  std::optional<BoxAnswer> box;
  if (ranges) box = judge_modes(*ranges);
  const auto asked = std::make_shared<AskedPush>(std::move(file), solver, listener);
  asked->options.record_history = values.has("history");
  if (values.has("sensitivity")) asked->options.study_commands = &find_sensitivity;
  const HoldReport hold = asked->push.holds_without_push(asked->options);
  const auto report = std::make_shared<PushReport>(asked->push.solve(asked->options));
  std::string text = values.has("history")
                         ? history_text(format, solver, report->status, report->history)
                     : format == "json" ? solve_json(asked->file, hold, *report)
                                        : solve_text(asked->file, hold, *report, values.telling());
  const bool is_one = report->unique_motion != Uniqueness::no && // else said already
                      report->unique_wrench != Uniqueness::no;
  if (!values.has("history") && format == "text" && report->status == Status::solved && is_one)
    text += sharing_sentence(asked->file, report->answer);
  if (box && !values.has("history")) text = with_box(std::move(text), format, asked->file, *box);
  return {report->status == Status::solved && (!box || box->verdict == BoxVerdict::always),
          std::move(text), [asked, report, &values] {
            return certify_push(values.scene_document().text, asked->file, *report);
          }};
}

Result run_break(const Values& values, Listener& listener) {
  const Solver solver = values.solver();
  const std::string format = values.format_with_history(solver);
  const auto asked =
      std::make_shared<AskedPush>(scene_to_solve(values, listener), solver, listener);
  const Index pusher = values.pusher(asked->file);
  values.refuse_still(asked->file);
  PushOptions& options = asked->options;
  const HoldReport hold = asked->push.holds_without_push(options);
  options.record_history = values.has("history");
  const auto report = std::make_shared<BreakReport>(asked->push.find_breaking(pusher, options));
  options.record_history = false;
  options.solver = Solver::lemke; // the search for the grip is its own
  GripReport grip;
  if (!values.has("history")) grip = find_smallest_grip(asked->file, hold, *report, options);
  return {report->status == Status::solved,
          values.has("history") ? history_text(format, solver, report->status, report->history)
          : format == "json"    ? break_json(asked->file, hold, grip, *report)
                                : break_text(asked->file, hold, grip, *report, values.telling()),
          [asked, pusher, report, &values] {
            return certify_break(values.scene_document().text, asked->file, asked->push, pusher,
                                 *report);
          }};
}

Result run_matrices(const Values& values, Listener& listener) {
  const std::string format = values.format();
  SceneFile file = values.scene(Needs::matrix);
  values.take_pyramids(file, listener);
  const PaperMatrices matrices = paper_matrices(file);
  return {true, format == "json" ? matrices_json(matrices, check_scene(file))
                                 : matrices_text(file, matrices)};
}

} // namespace

Command solve_command() {
  return {
      "solve",
      "SCENE.toml [OPTIONS]",
      "what a push does: forces, motion in the grip, contact modes",
      "Reads a scene, assembles its complementarity problem and solves it by Lemke's pivots.\n"
      "Accelerations are the object's, in the gripper's frame and SI units. With --tolerance the\n"
      "middle of the ranges is solved, and it is said whether the pusher sticks for every "
      "value.\n\n"
      "Example:\n  lcpush solve fixtures/scenes/straight_slide.toml\n",
      with_scene_options({verbose_option,
                          solver_option,
                          pressure_option,
                          facets_option,
                          tolerance_option,
                          {"box", "", "the same of the ranges that stand in the scene"},
                          history_option,
                          sensitivity_option,
                          certify_option}),
      run_solve};
}

Command break_command() {
  return {
      "break",
      "SCENE.toml [OPTIONS]",
      "the force that just moves the object in the grip",
      "The limit of an ever smaller push in the scene's direction: the force at which the object\n"
      "starts to move, how it then moves, and what a faster push adds.\n\n"
      "Example:\n  lcpush break fixtures/scenes/straight_slide.toml\n",
      with_scene_options({{"pusher", "NAME", "whose normal force is meant, among several"},
                          verbose_option,
                          solver_option,
                          pressure_option,
                          facets_option,
                          history_option,
                          certify_option}),
      run_break};
}

Command matrices_command() {
  return {"matrices",
          "SCENE.toml [OPTIONS]",
          "the paper's matrices: grasp matrix, hand Jacobian, ..",
          "Prints the object's inertia M and load w, the grasp matrix G and its polyhedral form\n"
          "G-bar, the hand Jacobian J with the pushers' blocks, what moves as prescribed (the\n"
          "right-hand side v of the contact accelerations r = G' a - J s - v), the friction\n"
          "generators D and, for each patch, its reference points, weights and number of\n"
          "independent rigidity conditions. SI units, scene axes, at the object's centre of mass;\n"
          "the scene as written, unsolved.\n\n"
          "Example:\n  lcpush matrices fixtures/scenes/straight_slide.toml\n",
          with_scene_options({}),
          run_matrices};
}

} // namespace lcpush::commands
