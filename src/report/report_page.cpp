#include "lcpush/desktop/report_page.hpp"

#include <algorithm>

#include "lcpush/lcp/tolerances.hpp"
#include "lcpush/version.hpp"
#include "report/page_elements.hpp"
#include "report/pictures.hpp"
#include "report/report_style.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// A part of the page; `inside` is HTML.
struct Section {
  std::string id, title, inside;
};

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
         "<details>\n<summary>The ray in numbers</summary>\n" +
         table_html("The ray, largest entry 1", rows) + "</details>\n";
}

std::string legend(const SceneFile& file, const PushReport& push) {
  const std::string wide = "0 0 30 16";
  const auto arrow = [&](const std::string& kind) {
    return sample(wide, arrow_element(kind, {1, 8}, {29, 8}));
  };
  const auto mark = [&](Mode mode) { return sample(wide, mode_mark(mode, {15, 8})); };
  KeyItems items;
  const bool solved = push.status == Status::solved;
  if (solved)
    items = {{mark(Mode::stick), "square: the contact sticks"},
             {mark(Mode::slide), "triangle: it slides"},
             {mark(Mode::separate), "ring: it separates"},
             {arrow("force normal"), "solid: normal force, ends at the contact"},
             {arrow("force friction"), "dashed: friction force, on the object"},
             {sample(wide, "<g class=\"force normal\">" + circle_element("ring", {15, 8}, 6) +
                               path_element("ring", "M11 4l8 8m0 -8l-8 8") + "</g>"),
              "crossed ring: normal force into the picture; plain: out of it"},
             {sample(wide, polygon_element("cone", {{29, 8}, {3, 1}, {3, 15}})),
              "friction pyramid, where the contact's force can come from"}};
  else
    items = {{sample(wide, circle_element("mark", {15, 8}, 3)), "contact point"}};
  if (!solved && !push.jam.bodies.empty())
    items.emplace_back(arrow("force normal"), "squeezes the object (a direction, no size)");
  if (solved && file.gravity.norm() > 0)
    items.emplace_back(arrow("force weight"), "dotted: weight");
  if (solved && push.motion.kind != MotionKind::rest)
    items.emplace_back(arrow("motion"), "thick: acceleration of the object's centre of mass");
  items.emplace_back(arrow("motion thin"), "thin, dotted: acceleration of a body");
  if (solved && push.motion.rotation > 0 && push.motion.kind != MotionKind::slide) {
    items.emplace_back(sample(wide, circle_element("turning", {15, 8}, 4) +
                                        path_element("turning", "M8 8h14M15 1v14")),
                       "instantaneous centre: the point that stays");
    items.emplace_back(sample(wide, line_element("screw", {0, 8}, {30, 8})),
                       "axis that the object turns about");
  }
  return key_html(items);
}

std::string verdict(const PageContent& content) {
  const PushReport& push = content.push;
  if (push.status != Status::solved) return failure_html(content.file, push);
  const bool holds =
      content.breaking == nullptr || content.breaking->status != Status::does_not_hold;
  return (holds ? "" : failure_box(paragraph(does_not_hold_text(*content.breaking)))) +
         paragraph("The push as prescribed is solved. The largest scaled residual is " +
                       residual_text(push.residuals.max()) + ", checked apart from the solver.",
                   "verdict");
}

Section answer_section(const PageContent& content) {
  std::vector<Fact> facts{content.breaking != nullptr ? grip_fact(content.file, content.hold,
                                                                  *content.grip, *content.breaking)
                                                      : hold_fact(content.file, content.hold)};
  for (Fact& fact : push_facts(content.file, content.push)) facts.push_back(std::move(fact));
  return {"answer", content.push.status == Status::solved ? "The answer" : "No answer was found",
          verdict(content) + facts_html(facts)};
}

Section grasp_section(const PageContent& content) {
  std::string text = "<div class=\"views\">\n";
  for (const Drawing& drawing : scene_pictures(content.file, content.push))
    text += figure(drawing, drawing.title);
  text += "</div>\n" + legend(content.file, content.push);
  if (content.file.shape.kind == ObjectShape::Kind::unknown)
    text += paragraph("The scene gives the object's inertia alone; the dashed outline is the box "
                      "with these principal moments.",
                      "aside");
  return {"grasp",
          content.push.status == Status::solved ? "The grasp as it is pushed" : "The grasp", text};
}

Section friction_section(const PageContent& content) {
  const std::vector<std::string> others = without_friction(content.file, content.push);
  std::string caption = "Dashed: Coulomb's circle of radius friction times normal force. Polygon: "
                        "what " +
                        std::to_string(content.file.facets) +
                        " facets keep of it. Arrow: the friction force on the object; thin, "
                        "dotted: the direction of slip.";
  if (!others.empty()) caption += " Not drawn: " + listed(others, "and") + ".";
  return {"friction", "Friction, point by point",
          "<div class=\"single\">\n" +
              figure(friction_picture(content.file, content.push), caption) + "</div>\n"};
}

Section contacts_section(const PageContent& content) {
  std::vector<std::vector<std::string>> rows = contact_rows(content.file, content.push);
  for (auto& row : rows)
    for (std::string& cell : row) cell = escaped(cell);
  for (std::size_t r = 1; r < rows.size(); ++r) // the second column is the mode
    rows[r][1] =
        sample("0 0 14 12",
               mode_mark(content.push.answer.contacts[static_cast<Index>(r) - 1].mode, {7, 6})) +
        rows[r][1];
  std::string text = table_html("What each contact does, in SI units and scene axes", rows);
  const auto add = [&text](const char* title, const std::vector<std::string>& sentences) {
    if (!sentences.empty()) text += std::string("<h3>") + title + "</h3>\n" + list_html(sentences);
  };
  add("Soft contacts", torsion_sentences(content.file, content.push));
  add("Bodies whose actuators move them", closing_sentences(content.file, content.push));
  return {"contacts", "Contacts", text};
}

/// Do the same bodies squeeze at the same points? Their numbers differ by rounding.
bool is_same_jam(const Jam& a, const Jam& b) {
  const auto is_same_body = [](const JamBody& one, const JamBody& other) {
    return one.body == other.body && one.points == other.points;
  };
  return a.running_away == b.running_away && a.uses_friction == b.uses_friction &&
         std::equal(a.bodies.begin(), a.bodies.end(), b.bodies.begin(), b.bodies.end(),
                    is_same_body);
}

Section breaking_section(const PageContent& content) {
  const BreakReport& report = *content.breaking;
  std::string text;
  if (report.status == Status::does_not_hold)
    text = failure_box(paragraph(does_not_hold_text(report)));
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

std::string sweep_title(const Sweep& sweep) {
  std::string title = "Push by " + sweep.pusher + " over " + sweep.variations[0].parameter.path;
  if (sweep.is_map()) title += " and " + sweep.variations[1].parameter.path;
  return title;
}

/// Where modes change, and where there are two answers.
std::vector<std::string> sweep_changes(const Sweep& sweep) {
  std::vector<std::string> list;
  const auto add = [&list](double value, const std::string& change) {
    if (!change.empty()) list.push_back("At " + number(value) + ": " + change);
  };
  for (const SweepSegment& segment : sweep.segments) add(segment.to, change_text(sweep, segment));
  for (const SweepPoint& point : sweep.points) add(point.value, change_text(sweep, point));
  for (const BistableRange& range : sweep.bistable)
    list.push_back("Bistable from " + number(range.from) + " to " + number(range.to) +
                   ": the way back ends in another answer there");
  return list;
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
    if (!sweep.complete)
      text += failure_box(paragraph("Some values have no answer; the numbers below say which."));
    text += list_html(sweep_changes(sweep));
    text +=
        "<details>\n<summary>The same in numbers</summary>\n" +
        scrolling(title + ", in numbers", "<pre>" + with_breaks(sweep_text(sweep)) + "</pre>\n") +
        "</details>\n";
  }
  return {"sweeps", "What changes it", text};
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

} // namespace

bool is_solved(const PageContent& content) {
  return content.push.status == Status::solved &&
         (content.breaking == nullptr || content.breaking->status == Status::solved) &&
         std::all_of(content.sweeps.begin(), content.sweeps.end(),
                     [](const Sweep& sweep) { return sweep.complete; });
}

std::vector<Picture> report_pictures(const PageContent& content) {
  std::vector<Drawing> drawings = scene_pictures(content.file, content.push);
  if (content.push.status == Status::solved) {
    drawings.push_back(friction_picture(content.file, content.push));
    drawings.push_back(residual_picture(content.push.residuals));
  }
  std::vector<Picture> pictures;
  for (const Drawing& drawing : drawings)
    pictures.push_back({drawing.name, drawing.title, svg_document(drawing)});
  for (const Sweep& sweep : content.sweeps) {
    const std::string title = sweep_title(sweep);
    pictures.push_back({"sweep" + std::to_string(&sweep - content.sweeps.data() + 1), title,
                        sweep_svg(sweep, title)});
  }
  return pictures;
}

std::string report_html(const PageContent& content) {
  const bool solved = content.push.status == Status::solved;
  std::vector<Section> sections{answer_section(content), grasp_section(content)};
  if (solved) {
    sections.push_back(friction_section(content));
    sections.push_back(contacts_section(content));
  }
  if (content.breaking != nullptr) sections.push_back(breaking_section(content));
  if (!content.sweeps.empty()) sections.push_back(sweeps_section(content));
  if (solved) sections.push_back(residual_section(content));
  const std::string title =
      escaped(content.file.title.empty() ? "A push without a title" : content.file.title);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<meta name=\"color-scheme\" content=\"light dark\"/>\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'\"/>\n<link rel=\"icon\" href=\"data:,\"/>\n<title>" +
      title + "</title>\n<style>\n" + palette(":root") + drawing_style() + page_style +
      "</style>\n</head>\n<body>\n<header>\n<h1>" + title +
      "</h1>\n<p class=\"aside\">What happens when this grasp is pushed. SI units, the scene's "
      "axes; "
      "accelerations are the object's, seen from the gripper.</p>\n</header>\n"
      "<nav aria-label=\"On this page\">\n<ul>\n";
  std::string main;
  for (const Section& section : sections) {
    page += "<li><a href=\"#" + section.id + "\">" + escaped(section.title) + "</a></li>\n";
    main += "<section id=\"" + section.id + "\" aria-labelledby=\"" + section.id +
            "-title\">\n<h2 id=\"" + section.id + "-title\">" + escaped(section.title) + "</h2>\n" +
            section.inside + "</section>\n";
  }
  return page + "</ul>\n</nav>\n<main>\n" + main + "</main>\n<footer>\n<p>" +
         escaped(run_words(content.file, content.push)) + ". Written by lcpush " + version_text +
         ".</p>\n</footer>\n</body>\n</html>\n";
}

} // namespace lcpush::desktop
