// sweep and report: a scene solved many times, or shown.
#include "commands/asked_push.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/boxes.hpp"
#include "lcpush/desktop/hold.hpp"
#include "lcpush/desktop/report_page.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <cmath>

namespace lcpush::commands {
namespace {

ParameterSweepOptions sweep_options(const Values& values, Listener& listener, Index most) {
  ParameterSweepOptions options;
  options.steps = values.whole("steps", {2, most}).value_or(0);
  options.stop = [&listener](double part) { return listener.stop(part); };
  return options;
}

/// Exact segments are those of pyramids: they are taken where a scene does not say how friction is.
void take_pyramids(std::vector<VariedScene>& scenes, const std::vector<SweepCurve>& curves,
                   Listener& listener) {
  bool is_said = false;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    const SceneFile file = scenes[k].as_given();
    const std::vector<Variation>& variations = curves[k].sweep.variations;
    if (!file.is_round || file.lines.facets > 0 || file.pressure == Pressure::pad ||
        variations.size() > 1 || !variations.front().parameter.linear)
      continue;
    scenes[k].set_facets(file.facets);
    if (!std::exchange(is_said, true))
      listener.announce("Pyramids of " + std::to_string(file.facets) +
                        " facets stand for round friction: so the sweep is exact.");
  }
}

/// All that is known before the first solve, so that bad input costs no time.
std::vector<SweepCurve> read_curves(const Values& values, Listener& listener,
                                    std::vector<VariedScene>& scenes) {
  std::vector<SweepCurve> curves;
  for (std::size_t k = 0; k < values.scene_count(); ++k) {
    const VariedScene scene =
        values.with_only_pusher(values.varied_scene(Needs::matrix, k), listener);
    const std::string given = scene.as_given().title,
                      title = given.empty() ? values.scene_name(k) : given,
                      mine = values.scene_count() > 1 ? title : "";
    if (const auto each = values.each(scene)) {
      for (const Variation& value : *each) {
        curves.push_back(curve_at(value, title, mine));
        scenes.push_back(scene.with({value.parameter}, {value.from}));
      }
    } else {
      curves.push_back({mine, title, std::nullopt, {}});
      scenes.push_back(scene);
    }
  }
  for (std::size_t k = 0; k < curves.size(); ++k) {
    curves[k].sweep.variations = values.variations(scenes[k]);
    for (const Variation& variation : curves[k].sweep.variations)
      values.refuse_later(scenes[k].as_given(), "vary", variation.parameter.owner);
  }
  for (std::size_t k = 0; k < curves.size(); ++k)
    values.doubt(doubts_at_ends(scenes[k], curves[k].sweep));
  if (values.variation_count() > 0) take_pyramids(scenes, curves, listener);
  refuse_overwritten(curves);
  return curves;
}

std::vector<SweepQuantity> shown_quantities(const Values& values, const std::string& format) {
  std::vector<SweepQuantity> shown;
  const auto names = values.text("show");
  if (!names) return shown;
  if (format != "svg")
    values.refuse("show", values.label("show") + " goes with " + values.label("format") +
                              " svg; the other formats have everything");
  for (const std::string_view name : split_at(*names, ','))
    shown.push_back(sweep_quantity(std::string(name)));
  return shown;
}

ParameterSweepOptions options_of_curves(const Values& values, Listener& listener,
                                        const std::vector<SweepCurve>& curves,
                                        const SceneFile& file) {
  const bool is_map = values.variation_count() > 1;
  if (is_map && curves.size() > 1)
    values.refuse("each", "a map is of one scene: leave out the second " + values.label("vary") +
                              ", or " + values.label("each") + " and the other scenes");
  const ParameterSweepOptions options =
      sweep_options(values, listener, is_map ? limits::map_steps : limits::sweep_steps);
  const double samples = std::pow(options.steps, values.variation_count());
  const std::string refusal = too_many_samples(samples * static_cast<double>(curves.size()), file);
  if (!refusal.empty())
    values.refuse("steps", refusal + "; ask for fewer " + values.label("steps"));
  return options;
}

bool has_pusher(const Values& values) {
  return values.varied_scene(Needs::scene).as_given().bodies.back().role == Role::pusher;
}

bool pushes(const SceneFile& file, const std::string& name) {
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b)
    if (file.body(b).role == Role::pusher && file.body_name(b) == name) return true;
  return false;
}

/// Of the grasp without a push.
Result run_hold_sweep(const Values& values, Listener& listener, const std::string& curve) {
  const std::string format = values.format();
  const VariedScene scene = values.varied_scene(Needs::scene);
  const std::vector<Variation> variations = values.variations(scene);
  for (const char* const other : {"each", "show", "pusher"})
    if (values.has(other))
      values.refuse(other, values.label(other) + " is about pushes: leave it out with " +
                               values.label("curve") + " " + curve);
  if (variations.size() != 1 || values.scene_count() != 1)
    values.refuse("vary", values.label("curve") + " " + curve + " is one scene's along one number");
  const SceneFile file = scene.as_given();
  const bool presses = values.has("press");
  values.refuse_no_press(file);
  if (const std::string& owner = variations[0].parameter.owner; !presses && pushes(file, owner))
    values.refuse("vary",
                  "a hold is what the grasp bears without " + owner + ", which pushes" +
                      (presses_of(file).empty()
                           ? ""
                           : "; " + values.label("press") + " counts forces of pushers as a load"));
  constexpr Index usual_steps = 51;
  HoldSweep sweep = sweep_hold(scene, variations[0], presses,
                               values.whole("steps", {2, limits::map_steps}).value_or(usual_steps),
                               [&listener](double part) { return listener.stop(part); });
  sweep.of_margin = curve != "hold.least_grip";
  return {sweep.stop == Stop::none,
          format == "json"  ? hold_sweep_json(sweep)
          : format == "csv" ? hold_sweep_csv(sweep)
          : format == "svg" ? hold_sweep_svg(sweep)
                            : hold_sweep_text(sweep),
          {},
          sweep.stop};
}

Result run_sweep(const Values& values, Listener& listener) {
  const std::string format = values.format();
  const std::size_t count = values.variation_count();
  if (count == 0) values.refuse("vary", "say what to vary: " + values.usage("vary"));
  if (count > 2)
    values.refuse("vary", values.label("vary") + " is given once, or twice for a map, not " +
                              std::to_string(count) + " times");
  if (const auto curve = values.text("curve"))
    return run_hold_sweep(values, listener,
                          values.one_of("curve", *curve, {"hold.margin", "hold.least_grip"}));
  if (!has_pusher(values)) {
    listener.announce("Nothing pushes in this scene: the sweep is of hold.margin, as of --curve.");
    return run_hold_sweep(values, listener, "hold.margin");
  }
  if (values.has("press"))
    values.refuse("press", values.label("press") + " goes with " + values.label("curve") +
                               " hold.margin or hold.least_grip");
  const std::vector<SweepQuantity> shown = shown_quantities(values, format);
  std::vector<VariedScene> scenes;
  std::vector<SweepCurve> curves = read_curves(values, listener, scenes);
  ParameterSweepOptions options =
      options_of_curves(values, listener, curves, scenes.front().as_given());
  bool is_complete = true;
  Stop stop = Stop::none;
  for (std::size_t k = 0; k < curves.size(); ++k) {
    options.progress = [&listener, &curves, k](double done) {
      listener.progress((static_cast<double>(k) + done) / static_cast<double>(curves.size()),
                        "of the sweep");
    };
    options.pusher = values.pusher(scenes[k].as_given());
    curves[k].sweep = sweep_parameter(scenes[k], curves[k].sweep.variations, options);
    is_complete = is_complete && curves[k].sweep.complete;
    stop = curves[k].sweep.stop;
    if (stop != Stop::none) curves.resize(k + 1); // with what there is
  }
  std::vector<SceneDoubt> doubts;
  const std::size_t curves_a_scene = scenes.size() / values.scene_count();
  for (std::size_t k = 0; k < scenes.size() && format == "json"; k += curves_a_scene)
    for (const auto& found :
         {check_scene(scenes[k].as_given()), doubts_at_ends(scenes[k], curves[k].sweep)})
      doubts.insert(doubts.end(), found.begin(), found.end());
  return {is_complete,
          format == "json"  ? sweep_json(curves, doubts)
          : format == "csv" ? sweep_csv(curves)
          : format == "svg" ? sweep_svg(curves, sweep_title(curves), shown)
                            : sweep_text(curves, values.telling()),
          {},
          stop};
}

std::vector<Variation> report_variations(const Values& values, const VariedScene& scene) {
  if (values.has("vary")) return values.variations(scene);
  if (values.has("steps"))
    values.refuse("steps", values.label("steps") + " goes with " + values.usage("vary"));
  return {};
}

/// One after the other, until they are stopped; what has no value by then is left out.
std::vector<Sweep> swept(const std::vector<Variation>& variations, const VariedScene& scene,
                         Listener& listener, ParameterSweepOptions options) {
  options.progress = [&listener](double done) { listener.progress(done, "of the sweep"); };
  std::vector<Sweep> sweeps;
  for (const Variation& variation : variations) {
    Sweep sweep = sweep_parameter(scene, {variation}, options);
    const Stop stop = sweep.stop;
    if (!sweep.segments.empty() || !sweep.points.empty()) sweeps.push_back(std::move(sweep));
    if (stop != Stop::none) break;
  }
  return sweeps;
}

/// Whose breaking force is asked for, or -1: nothing pushes, or nothing moves.
Index breaking_pusher(const Values& values, const SceneFile& file) {
  const bool has_pusher = file.bodies.back().role == Role::pusher;
  if (!has_pusher && !values.has("pusher") && !values.has("vary")) return -1;
  const Index pusher = values.pusher(file);
  return push_size(file.view()) > 0 ? pusher : -1;
}

std::string one_picture(const Values& values, const PageContent& content) {
  const std::string wanted = values.text("picture").value_or("front");
  std::vector<std::string> names;
  for (const Picture& picture : report_pictures(content)) {
    if (picture.name == wanted) return picture.svg;
    names.push_back(picture.name);
  }
  values.refuse_value("picture", wanted, listed(names, "or") + " for this scene", names);
}

Result run_report(const Values& values, Listener& listener) {
  const std::string format = values.format();
  if (values.has("picture") && format != "svg")
    values.refuse("picture",
                  values.label("picture") + " goes with " + values.label("format") + " svg");
  const VariedScene scene = values.varied_scene(values.has("vary") ? Needs::matrix : Needs::scene);
  const SceneFile file = scene.as_given();
  const Index pusher = breaking_pusher(values, file);
  const std::vector<Variation> variations = report_variations(values, scene);
  ParameterSweepOptions options = sweep_options(values, listener, limits::report_steps);
  if (!variations.empty()) options.pusher = values.pusher(file);
  AskedPush asked(file, Solver::lemke, listener);
  const HoldReport hold = asked.push.holds_without_push(asked.options);
  BreakReport breaking;
  GripReport grip;
  const bool breaks = pusher >= 0 && listener.stop(1) == Stop::none;
  if (breaks) {
    breaking = asked.push.find_breaking(pusher, asked.options);
    grip = find_smallest_grip(asked.file, hold, breaking, asked.options);
  }
  const PushReport report = asked.push.solve(asked.options); // last: its answer lives in the Push
  PageContent content{asked.file,
                      hold,
                      report,
                      breaks ? &breaking : nullptr,
                      breaks ? &grip : nullptr,
                      swept(variations, scene, listener, options)};
  std::optional<HoldStudy> held;
  if (format == "html" && file.body(0).role == Role::finger && listener.stop(1) == Stop::none)
    content.held = &held.emplace(find_hold(file, {}, asked.options));
  if (format == "html" && !scene.ranges().empty()) {
    const BoxAnswer box = judge_modes(scene);
    if (box.verdict != BoxVerdict::not_known) content.box = modes_sentence(file, box);
  }
  content.scene_text = values.scene_document().text;
  content.command = values.command_line();
  const bool is_whole = content.sweeps.size() == variations.size() && breaks == (pusher >= 0);
  const Stop stop = is_whole && (content.sweeps.empty() || content.sweeps.back().stop == Stop::none)
                        ? Stop::none
                        : listener.stop(1);
  return {is_whole && is_solved(content),
          format == "svg" ? one_picture(values, content) : report_html(content),
          {},
          stop};
}

} // namespace

Command sweep_command() {
  return {
      "sweep",
      "SCENE.toml.. --vary PATH=FROM:TO [OPTIONS]",
      "how the push changes with grip, friction, place, motion, ..",
      R"(Varies one number of the scene, or two for a map. PATH is a name and a key of the file,
vectors counted from [0]: wall.friction, wall.ends[0][1], object.mass, gravity[1]; *.KEY of
all bodies that have it, as *.grip_force of both fingers of a jaw; wall.shift[1] moves a body
along an axis (m), wall.turn turns its acceleration in the x-y plane, wall.tangent_turn its
friction generators about the normal (degrees). A path that does not exist lists those that do. Several scenes, or several values
with --each, give a curve each; what counts something (facets, points) varies there alone.

Forces and accelerations give exact segments under pressure "rigid" or "even" and friction
pyramids, with their breakpoints in words; everything else is sampled, more closely where
modes change.

Examples:
  lcpush sweep fixtures/scenes/straight_slide.toml --pressure rigid \
    --vary "*.grip_force=2:30"
  lcpush sweep fixtures/scenes/pivot.toml --vary "edge.shift[0]=0:0.03" \
    --steps 31 --each facets=4,8,16 --show "force,twist[5]" --format svg \
    -o pivot.svg
)",
      with_scene_options(
          {{"vary", "PATH=FROM:TO", "what varies, and how far, such as 0:30 mm; twice for a map",
            true},
           {"each", "PATH=V,V,..", "one curve for each of these values of another number"},
           {"steps", "N", "points evenly spread, ends included (51; a map 11 each way)"},
           pressure_option,
           facets_option,
           {"pusher", "NAME", "which one pushes, among several; the others are left out"},
           {"curve", "NAME", "of the grasp without a push: hold.margin or hold.least_grip"},
           press_option,
           {"show", "NAME,NAME,..",
            "what the picture shows: break_force, force, force[0], twist[5], break_twist[5], .."},
           {"label", "WORDS", "what the picture's axis says of --vary; again for a map's second",
            true, true},
           verbose_option,
           format_option("text (default), csv, json or svg; --json for short")}),
      run_sweep,
      {"text", "csv", "json", "svg"},
      limits::curves,
      true};
}

Command report_command() {
  return {
      "report",
      "SCENE.toml [OPTIONS]",
      "one page: the grasp in pictures, the answer in words, plots",
      "Writes a page for a browser that needs nothing else: the grasp in three views with forces,\n"
      "friction cones, contact modes and the axis that the object turns about; the answers of\n"
      "`solve` and `break` in words; contacts, residuals, and a plot for each --vary (as in\n"
      "`sweep`). A push without an answer gives a page that says why.\n\n"
      "With --format svg one picture alone: isometric, front, top or side, friction, residuals,\n"
      "sweep1, ..\n\n"
      "Examples:\n"
      "  lcpush report fixtures/scenes/pivot.toml -o report.html\n"
      "  lcpush report fixtures/scenes/pivot.toml --vary edge.friction=0:1 -o r.html\n"
      "  lcpush report fixtures/scenes/pivot.toml --format svg --picture front -o f.svg\n",
      with_scene_options(
          {{"vary", "PATH=FROM:TO", "also a plot of a sweep; may be given several times", true},
           {"steps", "N", "points of the sweeps, evenly spread, ends included"},
           pressure_option,
           facets_option,
           {"pusher", "NAME", "whose breaking force is meant, among several"},
           {"seconds", "S",
            "stop after so much processor time, with what is found; so does Ctrl-C"},
           format_option("html (default), or svg for one picture"),
           {"picture", "NAME", "which one, with --format svg (front)"}}),
      run_report,
      {"html", "svg"},
      1,
      true};
}

} // namespace lcpush::commands
