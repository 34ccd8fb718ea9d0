// A cut through a motion cone: where along one number of its motion a pusher sticks.
#include "formats/json_writer.hpp"
#include "lcpush/desktop/cone.hpp"
#include "lcpush/desktop/naming.hpp"
#include "lcpush/desktop/push.hpp"
#include "scenes/warnings_json.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <utility>

namespace lcpush::desktop {
namespace {

/// What `break` finds at one value.
ConeSlice::Range looked_at(const VariedScene& scene, const Parameter& parameter, double value,
                           Index pusher) {
  const SceneFile file = scene.at({parameter}, {value});
  Push push(file);
  PushOptions options;
  options.other_covers = 0;
  options.explain_jams = false;
  options.study_existence = false;
  ConeSlice::Range range;
  range.status =
      push_size(file.view()) > 0 ? push.find_breaking(pusher, options).status : Status::bad_input;
  if (range.status != Status::solved) return range;
  range.sticks = true;
  for (const Index i : points_of(file.body(pusher)))
    range.sticks = range.sticks && push.last_answer().contacts[i].mode == Mode::stick;
  return range;
}

std::vector<Index> changing(const SweepChange& change) {
  std::vector<Index> contacts;
  for (const AnswerChange& one : change.breaking)
    for (const ContactChange& contact : one.contacts)
      if (contact.from != contact.to) contacts.push_back(contact.contact);
  std::sort(contacts.begin(), contacts.end());
  contacts.erase(std::unique(contacts.begin(), contacts.end()), contacts.end());
  return contacts;
}

bool is_like(const ConeSlice::Range& one, const ConeSlice::Range& two) {
  return one.status == two.status && one.sticks == two.sticks;
}

const char* range_words(const ConeSlice::Range& range) {
  return range.status == Status::solved ? (range.sticks ? "sticks" : "slips") : "no breaking force";
}

} // namespace

ConeSlice find_slice(const VariedScene& scene, const Variation& variation, Index pusher) {
  ParameterSweepOptions options;
  options.pusher = pusher;
  options.both_ways = false;
  const Sweep sweep = sweep_parameter(scene, {variation}, options);
  ConeSlice slice{variation, pusher, true, {}};
  for (const SweepSegment& segment : sweep.segments) {
    slice.is_exact = slice.is_exact && segment.kind != SegmentKind::bisected;
    ConeSlice::Range range =
        looked_at(scene, variation.parameter, (segment.from + segment.to) / 2, pusher);
    range.from = segment.from;
    range.to = segment.to;
    range.changing = changing(segment.change);
    if (slice.ranges.empty() || !is_like(slice.ranges.back(), range)) {
      slice.ranges.push_back(std::move(range));
    } else {
      slice.ranges.back().to = range.to;
      slice.ranges.back().changing = std::move(range.changing);
    }
  }
  return slice;
}

std::string slice_text(const SceneFile& file, const ConeSlice& slice) {
  const std::string& path = slice.variation.parameter.path;
  std::vector<std::string> sticking;
  for (const ConeSlice::Range& range : slice.ranges)
    if (range.sticks) sticking.push_back(brief(range.from) + " to " + brief(range.to));
  const std::string unit = slice.variation.parameter.unit;
  std::string text = title_line(file) + file.body_name(slice.pusher) +
                     (sticking.empty() ? " sticks nowhere"
                                       : " sticks for " + path + " of " + listed(sticking, "and") +
                                             (unit.empty() ? "" : " " + unit)) +
                     ".\n\n";
  TableRows rows{{"from", "to", "there", "then changes"}};
  for (const ConeSlice::Range& range : slice.ranges) {
    std::vector<std::string> names;
    for (const Index i : range.changing) names.push_back(point_name(file, i));
    rows.push_back(
        {number(range.from), number(range.to), range_words(range),
         names.size() > 3 ? std::to_string(names.size()) + " contacts" : joined(names, " ")});
  }
  return text + table_text(rows) + "\n" +
         facts_text({{"Ends", slice.is_exact ? "exact, by parametric pivots"
                                             : "by bisection: pads settle round by round"}});
}

std::string slice_json(const SceneFile& file, const ConeSlice& slice) {
  JsonWriter json;
  json.begin_object()
      .member("pusher", file.body_name(slice.pusher))
      .member("vary", slice.variation.parameter.path)
      .member("exact", slice.is_exact);
  json.objects("ranges", slice.ranges, [&](const ConeSlice::Range& range) {
    json.member("from", range.from)
        .member("to", range.to)
        .member("status", status_text(range.status))
        .member("sticks", when(range.status == Status::solved, range.sticks));
    json.list("changing", range.changing, [&](Index i) { json.value(point_name(file, i)); });
  });
  write_warnings(json, check_scene(file));
  return json.end_object().text();
}

} // namespace lcpush::desktop
