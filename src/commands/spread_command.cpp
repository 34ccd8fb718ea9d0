// spread: all answers of a scene.
#include "commands/listener.hpp"
#include "commands/values.hpp"
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

Result run_spread(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const SpreadOptions options = spread_options(values, listener);
  const SceneFile file = values.scene(Needs::matrix);
  if (options.breaking) values.refuse_still(file);
  values.refuse_unknowns(file, limits::unknowns_spread, "faces can be bounded");
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
          "force that breaks the grasp.\n\n"
          "Example:\n  lcpush spread fixtures/scenes/straight_slide.toml\n",
          with_scene_options(
              {{"break", "", "the force that just moves the object, and how it begins to move"},
               {"enumerate", "", "look longer, a minute or so, for all contact modes"},
               {"paths", "", "only what the covering vectors reach"},
               {"seconds", "S",
                "stop after so much processor time, with what is found; so does Ctrl-C"},
               {"covers", "N", "covering vectors of Lemke's method to start from (32)"},
               verbose_option}),
          run_spread,
          {"text", "json"},
          1,
          true};
}

} // namespace lcpush::commands
