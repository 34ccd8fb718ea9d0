#include "play/answers.hpp"

#include "formats/json_writer.hpp"
#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/matrix_market.hpp"
#include "lcpush/desktop/move.hpp"
#include "lcpush/desktop/report.hpp"
#include "move/move_words.hpp"
#include "picture/grasp_figures.hpp"
#include "pivots/explorer.hpp"
#include "pivots/subject.hpp"
#include "play/instant.hpp"
#include "play/state_picture.hpp"
#include "solve/grip_statics.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

const std::string scene_name = "scene";

/// {"answer": .., "sentence": .., more}: `answer` and `more` are JSON.
std::string with_words(const std::string& answer, const std::string& sentence,
                       const std::string& more = {}) {
  JsonWriter text;
  text.value(sentence);
  return "{\"answer\": " + answer + ", \"sentence\": " + text.text() + more + "}\n";
}

SceneFile small_scene(std::string_view text, Strokes strokes = Strokes::first) {
  SceneFile file = parse_scene(text, scene_name, strokes);
  if (size_of(file.view()).unknowns() > limits::unknowns_searched)
    throw InputError(scene_name + ": more than the " + std::to_string(limits::unknowns_searched) +
                     " unknowns that are solved while you look; use fewer points or facets");
  return file;
}

/// The grip over the least with which statics holds the object, [T.12]; of pads of several points
/// it is at most that.
std::string margin_of_grip(const SceneFile& file) {
  const SceneFile hand = hand_at_rest(file);
  if (hand.bodies.empty()) return {};
  const GripStatics statics(hand);
  const std::optional<double> least = least_factor(statics);
  if (!least || !(*least > 0)) return {};
  const bool is_bound = statics.has_pads() && hand.points.size() > hand.bodies.size();
  return ", \"grip_margin\": " + shown(1 / *least) +
         ", \"is_bound\": " + (is_bound ? "true" : "false");
}

/// While a hand drags, only what is looked at.
PushOptions options_of(bool in_full) {
  PushOptions options;
  if (!in_full) {
    options.other_paths = 0;
    options.study_existence = false;
    options.explain_jams = false;
  }
  return options;
}

/// What a hand can take, and what moves with it.
void write_page_scene(JsonWriter& json, const DrawnScene& drawn) {
  const SceneFile& file = drawn.file;
  json.begin_object().member("title", file.title);
  json.member("center_of_mass", drawn.center()).member("reach", drawn.reach());
  json.key("shape").begin_object().member("size", file.shape.size);
  json.member("axis", file.shape.axis).end_object();
  json.objects("bodies", drawn.scene.bodies.size, [&](Index b) {
    const Body<double>& body = drawn.scene.bodies[b];
    json.member("name", file.body_name(b));
    json.member("role", body.role == Role::finger ? "finger" : "pusher");
    json.member("normal", body.normal).member("middle", drawn.middle(body));
  });
  json.end_object();
}

void write_picture(JsonWriter& json, const StatePicture& picture) {
  json.member("picture", picture.svg).member("meters", picture.sight.meters);
  json.member("right", picture.sight.view.right).member("up", picture.sight.view.up);
}

/// The pusher whose force is meant: the first.
Index first_pusher(const SceneFile& file) {
  for (std::size_t b = 0; b < file.bodies.size(); ++b)
    if (file.bodies[b].role == Role::pusher) return static_cast<Index>(b);
  throw InputError(scene_name + ": no [[pusher]]: nothing can break the grasp");
}

std::string break_answer(std::string_view text) {
  const SceneFile file = small_scene(text);
  const Index pusher = first_pusher(file);
  if (!(push_size(file.view()) > 0))
    throw InputError(scene_name + ": no body moves: give a pusher an acceleration");
  Push push(file);
  PushOptions options;
  const HoldReport hold = push.holds_without_push(options);
  const BreakReport report = push.find_breaking(pusher, options);
  const GripReport grip = find_smallest_grip(file, hold, report, options);
  return with_words(break_json(file, hold, grip, report),
                    report.status == Status::solved ? break_sentence(file, report) : std::string());
}

/// Where a body presses: the middle of its points that touch, and their normal; 0 of none.
struct PressingPlace {
  Vector3<double> middle = Vector3<double>::Zero(), normal = Vector3<double>::Zero();
};
PressingPlace pressing_place(const Body<double>& body, const MotionFrame& frame) {
  PressingPlace place;
  int count = 0;
  for (const Index i : points_of(body)) {
    const PointState& point = frame.contacts[static_cast<std::size_t>(i)];
    if (!is_touching(point.touch)) continue;
    place.middle += point.position;
    place.normal = point.normal;
    ++count;
  }
  if (count > 0) place.middle /= count;
  return place;
}

std::string move_answer(std::string_view text, std::string_view time, std::string_view frames) {
  const SceneFile file = small_scene(text, Strokes::all);
  MoveOptions options;
  options.most_steps = limits::motion_solves;
  const double seconds = read_finite_number(time).value;
  if (seconds > 0) options.time = seconds;
  options.frames = static_cast<Index>(read_finite_number(frames).value);
  if (options.frames < 2 || options.frames > limits::motion_frames)
    throw InputError("move: frames must be 2 .. " + std::to_string(limits::motion_frames));
  const MotionReport report = move(file, options);
  JsonWriter poses;
  poses.begin_array();
  for (const MotionFrame& frame : report.frames)
    for (std::size_t b = 0; b < file.bodies.size(); ++b) {
      const Pose<double>& pose = frame.body_poses[b];
      const Eigen::Map<const Eigen::Matrix<double, 9, 1>> columns(pose.rotation.data());
      const PressingPlace pressing = pressing_place(file.bodies[b], frame);
      poses.value(pose.position).value(Eigen::Matrix<double, 9, 1>(columns));
      poses.value(pressing.middle).value(pressing.normal);
    }
  poses.end_array();
  return with_words(move_json(file, report), move_sentence(file, report),
                    ", \"poses\": " + poses.text());
}

/// As `pivots --format html` asks, but for what the playground's page has itself.
std::string traced(const PivotSubject& subject) {
  PivotTrace trace =
      trace_pivots(subject.problem, pivot_options(subject, false, true), *subject.story);
  finish_trace(trace, subject, false);
  return open_pivots_html(trace, subject.push.get());
}

/// After `seconds` of its motion, if that is positive.
std::string pivots_answer(std::string_view text, double seconds) {
  SceneFile file = small_scene(text, seconds > 0 ? Strokes::all : Strokes::first);
  if (seconds > 0) {
    MoveOptions options;
    options.most_steps = limits::motion_solves;
    options.time = seconds;
    options.frames = 2;
    file = scene_at(file, move(file, options).frames.back());
    file.title += (file.title.empty() ? "After " : ", after ") + brief(seconds) + " s";
  }
  file.facets = 4;
  file.is_round = false;
  return traced(rounded_subject(std::move(file), scene_name));
}

/// M on the first line, its rows divided by semicolons; q on the second.
std::string typed_answer(std::string_view text) {
  const std::vector<std::string_view> lines = split_at(text, '\n');
  if (lines.size() != 2) throw InputError("two lines are needed: M such as 2 1; 1 2, and q");
  ExactMatrix M = parse_inline_matrix<Rational>(lines[0], "M");
  ExactMatrix q = parse_inline_vector<Rational>(lines[1], "q");
  if (M.cols != M.rows || q.rows != M.rows)
    throw InputError("M must be square and q as long as its rows: M is " + std::to_string(M.rows) +
                     " x " + std::to_string(M.cols) + ", q has " + std::to_string(q.rows));
  return traced(raw_subject({std::move(M), std::move(q), 0}, "M", false));
}

} // namespace

std::string first_sentence(const SceneFile& file, const PushReport& report) {
  if (report.status == Status::solved) return push_sentence(file, report);
  if (report.ray.empty()) return failure_text(file, report);
  return "No answer. " + jam_sentences(file, report.jam).front();
}

Playground::Solved::Solved(std::string_view scene, bool is_in_full)
    : text(scene), in_full(is_in_full), file(small_scene(scene)), drawn(file), push(file),
      hold(push.holds_without_push(options_of(in_full))), report(push.solve(options_of(in_full))) {}

const Playground::Solved& Playground::solved(std::string_view text, bool in_full) {
  last_ = std::make_unique<const Solved>(text, in_full);
  return *last_;
}

std::string Playground::solve(std::string_view text, bool in_full, std::string_view look) {
  const Solved& now = solved(text, in_full);
  const SceneFile& file = now.file;
  const std::string answer = solve_json(file, now.hold, now.report);
  const std::string sentence = first_sentence(file, now.report);
  const std::string margin = margin_of_grip(file);
  if (look.empty()) return with_words(answer, sentence, margin);
  const StatePicture picture =
      state_picture(now.drawn, now.report, read_picture_request(look), sentence);
  JsonWriter more;
  more.begin_object().key("scene");
  write_page_scene(more, now.drawn);
  write_picture(more, picture);
  more.end_object();
  return with_words(answer, sentence,
                    margin + ", " + more.text().substr(1, more.text().rfind('}') - 1));
}

std::string Playground::look(std::string_view text, std::string_view look) {
  const PictureRequest wanted = read_picture_request(look);
  const bool is_last = last_ && last_->text == text && last_->in_full == wanted.in_full;
  const Solved& now = is_last ? *last_ : solved(text, wanted.in_full);
  JsonWriter json;
  json.begin_object();
  write_picture(json,
                state_picture(now.drawn, now.report, wanted, first_sentence(now.file, now.report)));
  json.end_object();
  return json.text();
}

std::string Playground::answer_to(std::string_view question, std::string_view text) {
  const std::size_t end = std::min(question.find(' '), question.size());
  const std::string_view asked = question.substr(0, end);
  const std::string_view more = question.substr(std::min(end + 1, question.size()));
  const std::vector<std::string_view> words = split_words(more);
  if (asked == "solve" || asked == "drag") return solve(text, asked == "solve", more);
  if (asked == "look") return look(text, more);
  if (asked == "break") return break_answer(text);
  if (asked == "move" && words.size() == 2) return move_answer(text, words[0], words[1]);
  if (asked == "pivots")
    return pivots_answer(text, words.empty() ? 0 : read_finite_number(words[0]).value);
  if (asked == "lcp") return typed_answer(text);
  throw InputError("no question of the page: " + quoted(question));
}

} // namespace lcpush::desktop
