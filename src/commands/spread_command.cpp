// spread: all answers of a scene.
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/contact_modes.hpp"
#include "lcpush/desktop/spread.hpp"
#include "text/limits.hpp"

namespace lcpush::commands {
namespace {

SpreadOptions spread_options(const Values& values, Listener& listener) {
  SpreadOptions options;
  options.covering_vectors =
      values.whole("covers", {1, limits::covers}).value_or(options.covering_vectors);
  options.breaking = values.has("break");
  if (values.has("enumerate") && values.has("paths"))
    values.refuse("paths", values.label("enumerate") + " or " + values.label("paths") +
                               ": all contact modes, or the paths alone");
  if (values.has("enumerate")) options.enumeration = Enumeration::thorough;
  if (values.has("paths")) options.enumeration = Enumeration::none;
  options.by_time = values.has("seconds");
  options.watcher = &listener;
  options.stop = [&listener](double part) { return listener.stop(part); };
  options.progress = [&listener](double done) { listener.progress(done, "of the work"); };
  return options;
}

/// All modes of the push, one after the other.
Result run_modes(const Values& values, const SceneFile& file, const SpreadOptions& options,
                 const std::string& format) {
  for (const char* other : {"break", "paths"})
    if (values.has(other))
      values.refuse(other, values.label("modes") + " or " + values.label(other) + ": not both");
  const Scene<double> scene = file.view();
  if (scene.points.size > limits::points_told_by_mode)
    values.refuse("modes", values.label("modes") + ": the scene has " +
                               std::to_string(scene.points.size) +
                               " contact points, more than the " +
                               std::to_string(limits::points_told_by_mode) +
                               " that are told mode by mode; give its bodies fewer points, or make "
                               "the scene planar");
  for (const Body<double>& body : scene.bodies)
    if (body.torsion_radius > 0 && body.friction > 0)
      values.refuse("modes", values.label("modes") + ": " +
                                 file.body_name(file.body_of(body.first_point)) +
                                 " is soft, and twists as well as slips; give it a ring of points "
                                 "instead of torsion_radius");
  const ModesReport report = find_modes(file, options);
  return {report.status == Status::solved,
          format == "json"  ? contact_modes_json(file, report)
          : format == "svg" ? contact_modes_svg(file, report)
                            : contact_modes_text(file, report, values.telling()),
          {},
          report.stop};
}

Result run_spread(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const SpreadOptions options = spread_options(values, listener);
  const SceneFile file = values.scene(Needs::matrix);
  if (options.breaking) values.refuse_still(file);
  values.refuse_unknowns(file, limits::unknowns_spread, "faces can be bounded");
  if (values.has("modes")) return run_modes(values, file, options, format);
  if (format == "svg")
    values.refuse("format",
                  values.label("format") + " svg draws modes: ask with " + values.label("modes"));
  const SpreadReport report = find_spread(file, options);
  return {report.status == Status::solved,
          format == "json" ? spread_json(file, report)
                           : spread_text(file, report, values.telling()),
          {},
          report.stop};
}

} // namespace

Command spread_command() {
  return {"spread",
          "SCENE.toml [OPTIONS]",
          "the answer as a set: bounds of push, motion and forces",
          "Rigid contact often leaves forces open, and now and then the motion. This takes the\n"
          "literal laws (pressure = \"rigid\", whatever the file says), goes through all contact\n"
          "modes that may have an answer, and bounds every quantity over each by linear programs:\n"
          "the ranges of every answer. Where that would take long, it says \"at least\": of the\n"
          "answers next to those that many covering vectors reach. With --break the same for the\n"
          "force that breaks the grasp. With --modes each combination of sticking,\n"
          "slipping and opening contacts by itself, and which one solve takes.\n\n"
          "Example:\n  lcpush spread fixtures/scenes/straight_slide.toml\n",
          with_scene_options(
              {{"break", "", "the force that just moves the object, and how it begins to move"},
               {"enumerate", "", "look longer, a minute or so, for all contact modes"},
               {"modes", "", "which contacts can stick, slip or open, in which combinations"},
               {"paths", "", "only what the covering vectors reach"},
               {"seconds", "S",
                "stop after so much processor time, with what is found; so does Ctrl-C"},
               {"covers", "N", "covering vectors of Lemke's method to start from (32)"},
               verbose_option}),
          run_spread,
          {"text", "json", "svg"},
          1,
          true};
}

} // namespace lcpush::commands
