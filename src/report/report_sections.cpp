// The parts of the page below its first screen.
#include <algorithm>

#include "lcpush/lcp/tolerances.hpp"
#include "picture/contact_figures.hpp"
#include "report/page_elements.hpp"
#include "report/pictures.hpp"
#include "report/report_sections.hpp"
#include "scenes/parameter_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// Do the same bodies squeeze at the same points? Their numbers differ by rounding.
bool is_same_jam(const Jam& a, const Jam& b) {
  const auto is_same_body = [](const JamBody& one, const JamBody& other) {
    return one.body == other.body && one.points == other.points;
  };
  return a.running_away == b.running_away && a.uses_friction == b.uses_friction &&
         std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(),
                    is_same_body);
}

/// Where modes change, and where there are two answers.
std::vector<std::string> sweep_changes(const Sweep& given) {
  const Sweep sweep = in_typed_units(given);
  const std::string& name = sweep.variations[0].parameter.unit;
  const std::string unit = name.empty() ? "" : " " + name;
  std::vector<std::string> list;
  const auto add = [&](double value, const std::string& change) {
    if (!change.empty()) list.push_back("At " + number(value) + unit + ": " + change);
  };
  for (const SweepSegment& segment : sweep.segments) add(segment.to, change_text(sweep, segment));
  for (const SweepPoint& point : sweep.points) add(point.value, change_text(sweep, point));
  for (const BistableRange& range : sweep.bistable)
    list.push_back("Bistable from " + number(range.from) + " to " + number(range.to) + unit +
                   ": the way back ends in another answer there");
  return list;
}

} // namespace

std::string failure_box(const std::string& inside) {
  return "<div class=\"failure\">\n" + inside + "</div>\n";
}

std::string not_solved(Status status, const std::string& reason) {
  return std::string("<p><strong>NOT SOLVED (") + status_text(status) +
         ")</strong>: " + escaped(reason) + ".</p>\n";
}

std::string failure_html(const SceneFile& file, const RunReport& report) {
  const std::string failure = not_solved(report.status, report.reason);
  if (report.ray.empty()) return failure_box(failure);
  std::vector<std::vector<std::string>> rows{{"unknown", "value"}};
  for (const NamedValue& entry : report.ray)
    rows.push_back({escaped(entry.name), number(entry.value)});
  return failure_box(failure + paragraphs_html(jam_findings(file, report.jam)) +
                     list_html(jam_remedies(report.jam))) +
         fold("The ray in numbers", table_html("The ray, largest entry 1", rows));
}

std::string sweep_title(const Sweep& sweep) {
  std::string title =
      "Push by " + sweep.pusher + " over " + parameter_words(sweep.variations[0].parameter);
  if (sweep.is_map()) title += " and " + parameter_words(sweep.variations[1].parameter);
  return title;
}

Section friction_section(const PageContent& content) {
  const std::vector<std::string> others = without_friction(content.file, content.push);
  const std::string circle = "Coulomb's circle of radius friction times normal force. ";
  std::string cone = content.push.friction == FrictionLaw::round
                         ? circle
                         : "Dashed: " + circle + "Polygon: what " +
                               std::to_string(content.file.facets) + " facets keep of it. ";
  if (!content.file.has_cones()) cone.clear();
  if (content.file.planar) cone += "A line across: friction along the plane alone. ";
  std::string text = paragraph(
      cone + "Arrow: the friction force on the object; thin, dotted: the direction of slip.",
      "aside");
  std::string wholes, points;
  for (const FrictionGroup& group : friction_panels(content.file, content.push)) {
    wholes += svg_element(group.whole);
    if (group.points.empty()) continue;
    points += "<h3>" + escaped(group.body) + "</h3>\n<div class=\"panels\">\n";
    for (const Drawing& panel : group.points) points += svg_element(panel);
    points += "</div>\n";
  }
  text += "<div class=\"panels\">\n" + wholes + "</div>\n";
  if (!points.empty())
    text += paragraph("A body of several points: their sum. A pad that turns has little of it "
                      "though each of its points is at its limit.",
                      "aside") +
            fold("Point by point", points);
  if (!others.empty()) text += paragraph("Not drawn: " + listed(others, "and") + ".", "aside");
  return {"friction", "Friction", text};
}

Section contacts_section(const PageContent& content) {
  const auto rows_of = [&content](Telling telling) {
    std::vector<std::vector<std::string>> rows = contact_rows(content.file, content.push, telling);
    for (auto& row : rows)
      for (std::string& cell : row) cell = escaped(cell);
    return rows;
  };
  std::vector<std::vector<std::string>> points = rows_of(Telling::full);
  points[0][1] = "does"; // the mode, as the pictures say it
  for (std::size_t r = 1; r < points.size(); ++r) {
    const Mode mode = content.push.answer.contacts[static_cast<Index>(r) - 1].mode;
    points[r][1] = sample("0 0 14 12", mode_mark(mode, {7, 6})) + mode_verb(mode);
  }
  std::string text = table_html("What each body does: its forces summed, its fastest slip",
                                rows_of(Telling::brief)) +
                     fold("Point by point", table_html("SI units and scene axes", points));
  const auto add = [&text](const char* title, const std::vector<std::string>& sentences) {
    if (!sentences.empty()) text += std::string("<h3>") + title + "</h3>\n" + list_html(sentences);
  };
  add("Soft contacts", torsion_sentences(content.file, content.push, Telling::full));
  add("Bodies whose actuators move them",
      closing_sentences(content.file, content.push, Telling::full));
  return {"contacts", "Contacts", text};
}

Section breaking_section(const PageContent& content) {
  const BreakReport& report = *content.breaking;
  std::string text;
  if (report.status == Status::does_not_hold)
    text = failure_box(paragraph(does_not_hold_text(content.file, report)));
  else if (report.status == content.push.status && report.status != Status::solved &&
           is_same_jam(report.jam, content.push.jam))
    text = failure_box(not_solved(report.status, "it ends as the push itself does, above"));
  else if (report.status != Status::solved)
    text = failure_html(content.file, report);
  else
    text = facts_html(break_facts(content.file, report));
  return {"breaking", "The force that breaks the grasp",
          paragraph("The limit of an ever weaker push in the scene's direction.", "aside") + text};
}

Section holding_section(const PageContent& content) {
  SceneFile untitled = content.file;
  untitled.title.clear();
  const std::string text = hold_text(untitled, *content.held);
  const std::size_t sentence = text.find("\n\n");
  return {"holding", "How well the grasp holds",
          paragraph("Without a push, pushers absent.", "aside") +
              paragraph(text.substr(0, sentence)) +
              scrolling("What the grasp bears",
                        "<pre>" + with_breaks(text.substr(sentence + 2)) + "</pre>\n")};
}

Section sweeps_section(const PageContent& content) {
  std::string text;
  for (const Sweep& sweep : content.sweeps) {
    const std::string title = sweep_title(sweep);
    text += "<h3>" + escaped(title) + "</h3>\n<figure>\n" +
            scrolling(title, plot_image(sweep_svg(sweep, title),
                                        title + ", a plot; the same stands below in words and "
                                                "numbers")) +
            "</figure>\n";
    if (sweep.stop != Stop::none)
      text += failure_box(
          paragraph("It was stopped before its range was done: this is what there was."));
    else if (!sweep.complete)
      text += failure_box(paragraph("Some values have no answer; the numbers below say which."));
    text += list_html(sweep_changes(sweep));
    text += fold(
        "The same in numbers",
        scrolling(title + ", in numbers", "<pre>" + with_breaks(sweep_text(sweep)) + "</pre>\n"));
  }
  return {"sweeps", "What changes it", text};
}

Section inputs_section(const PageContent& content) {
  const SceneFile& file = content.file;
  const Vector3<double>& size = file.shape.size;
  constexpr const char* kinds[] = {", a box of ", ", a cylinder within ", ", a ball within "};
  std::string object = number(file.object.mass) + " kg";
  if (file.shape.kind == ObjectShape::Kind::unknown)
    object += ", given by its inertia";
  else
    object += kinds[static_cast<int>(file.shape.kind)] + number(size[0]) + " x " + number(size[1]) +
              " x " + number(size[2]) + " m";
  const double g = file.gravity.norm();
  std::vector<Fact> facts;
  if (!content.command.empty()) facts.push_back({"Asked", content.command});
  facts.push_back({"Object", object});
  facts.push_back(
      {"Gravity", g > 0 ? number(g) + " m/s^2 along " + direction_text(file.gravity / g) : "none"});
  facts.push_back(hand_fact(file));
  facts.push_back({"Laws", std::string("pressure ") + pressure_text(file.pressure) + "; " +
                               friction_law_text(file) +
                               (file.planar ? "; in the x-y plane" : "")});
  std::vector<std::vector<std::string>> rows{{"contact", "is a", "points", "friction", "normal"}};
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    const Body<double>& body = file.bodies[b];
    rows.push_back({escaped(file.body_names[b]), body.role == Role::finger ? "finger" : "pusher",
                    std::to_string(body.point_count), number(body.friction),
                    direction_text(body.normal)});
  }
  std::string text =
      facts_html(facts) + table_html("Contacts; the normal is into the object", rows);
  if (!content.scene_text.empty())
    text +=
        fold("The scene file",
             scrolling("The scene file", "<pre>" + with_breaks(content.scene_text) + "</pre>\n"));
  return {"inputs", "What was asked", text};
}

Section residual_section(const PageContent& content) {
  const double tolerance = Tolerances<double>().residual;
  std::vector<std::vector<std::string>> rows{{"law", "equation"}};
  for (const LawRow& law : law_rows(content.push.residuals)) rows.push_back({law.name, law.tag});
  std::vector<bool> holds(rows.size(), true);
  const auto add = [&](const char* what, const Residuals<double>& residuals) {
    rows[0].emplace_back(what);
    std::size_t k = 0;
    for (const LawRow& law : law_rows(residuals)) {
      rows[++k].push_back(residual_text(law.residual));
      holds[k] = holds[k] && law.residual <= tolerance;
    }
  };
  add("push", content.push.residuals);
  if (content.breaking != nullptr && content.breaking->status == Status::solved)
    add("breaking", content.breaking->breaking.residuals);
  rows[0].insert(rows[0].end(), {"tolerance", "verdict"});
  for (std::size_t k = 1; k < rows.size(); ++k)
    rows[k].insert(rows[k].end(), {residual_text(tolerance), holds[k] ? "holds" : "BROKEN"});
  return {"laws", "How well the laws hold",
          "<div class=\"single\">\n" +
              figure(residual_picture(content.push.residuals),
                     "Of the push, forces in units of the grip, accelerations in what that "
                     "force gives the object.") +
              "</div>\n" + table_html("Largest scaled residuals", rows)};
}

} // namespace lcpush::desktop
