#include "lcpush/desktop/report_page.hpp"

#include <algorithm>

#include "draw/page_style.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "lcpush/version.hpp"
#include "picture/contact_figures.hpp"
#include "report/page_elements.hpp"
#include "report/pictures.hpp"
#include "report/report_sections.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

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
             {mark(Mode::slide), "triangle: it slips"},
             {mark(Mode::separate), "ring: it opens"},
             {arrow("force normal"), "solid: normal force, ends at the contact"},
             {arrow("force friction"), "dashed: friction force, on the object"},
             {sample(wide, "<g class=\"force normal\">" + circle_element("ring", {15, 8}, 6) +
                               path_element("ring", "M11 4l8 8m0 -8l-8 8") + "</g>"),
              "crossed ring: normal force into the picture; plain: out of it"},
             {sample(wide, polygon_element("cone", {{29, 8}, {3, 1}, {3, 15}})),
              "friction cone, where the contact's force can come from"}};
  else
    items = {{sample(wide, circle_element("mark", {15, 8}, 3)), "contact point"}};
  if (!solved && !push.jam.bodies.empty())
    items.emplace_back(arrow("force normal"), "squeezes the object (a direction, no size)");
  if (solved && file.gravity.norm() > 0)
    items.emplace_back(arrow("force weight"), "dotted: weight");
  if (solved && push.motion.kind != MotionKind::rest)
    items.emplace_back(arrow("motion"), "thick: acceleration of the object's centre of mass");
  if (solved && push.motion.kind != MotionKind::rest)
    items.emplace_back(sample(wide, polygon_element("ghost", {{3, 2}, {27, 2}, {27, 14}, {3, 14}})),
                       "dashed: where the object goes, in the isometric view");
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

/// The isometric view, then the other two.
std::vector<Drawing> grasp_pictures(const PageContent& content) {
  const DrawnScene drawn(content.file);
  std::vector<Drawing> drawings{isometric_picture(drawn, content.push)};
  for (Drawing& drawing : scene_pictures(drawn, content.push))
    drawings.push_back(std::move(drawing));
  return drawings;
}

/// What happens, in sentences; without an answer why not.
std::string lead(const PageContent& content) {
  const BreakReport* breaking = content.breaking;
  std::string text;
  if (content.push.status != Status::solved)
    text = failure_html(content.file, content.push);
  else
    text = paragraph(push_sentence(content.file, content.push), "lead");
  if (content.hold.status == Status::solved && !content.hold.holds && has_pusher(content.file))
    text += paragraph(hold_sentence(content.file, content.hold), "lead");
  if (breaking != nullptr && breaking->status == Status::does_not_hold)
    text += failure_box(paragraph(does_not_hold_text(content.file, *breaking)));
  else if (breaking != nullptr && breaking->status == Status::solved)
    text += paragraph(break_sentence(content.file, *breaking), "lead");
  if (content.push.status == Status::solved)
    if (const std::string others = others_sentences(content.file, content.push); !others.empty())
      text += paragraph(others + "lcpush spread says between which bounds.");
  if (!content.box.empty()) text += paragraph(content.box, "lead");
  for (const SceneDoubt& doubt : check_scene(content.file))
    text += "<p class=\"check\"><strong>Check</strong> " + escaped(doubt_text(doubt)) + ".</p>\n";
  return text;
}

std::string views(const PageContent& content) {
  const std::vector<Drawing> drawings = grasp_pictures(content);
  std::string text = "<div class=\"views\">\n<div>\n" + figure(drawings[0], drawings[0].title) +
                     "<details open=\"open\">\n<summary>What the drawings mean</summary>\n" +
                     legend(content.file, content.push) + "</details>\n</div>\n<div>\n";
  for (std::size_t k = 1; k < drawings.size(); ++k) text += figure(drawings[k], drawings[k].title);
  text += "</div>\n</div>\n";
  if (content.file.shape.kind == ObjectShape::Kind::unknown)
    text += paragraph("The scene gives the object's inertia alone; the dashed outline is the box "
                      "with these principal moments.",
                      "aside");
  return text;
}

/// The first screen: sentence and picture.
Section answer_section(const PageContent& content) {
  const bool is_solved = content.push.status == Status::solved;
  return {"answer", is_solved ? "The answer" : "No answer was found",
          lead(content) + views(content)};
}

Section facts_section(const PageContent& content) {
  const PushReport& push = content.push;
  std::vector<Fact> facts{content.breaking != nullptr ? grip_fact(content.file, content.hold,
                                                                  *content.grip, *content.breaking)
                                                      : hold_fact(content.file, content.hold)};
  for (Fact& fact : push_facts(content.file, push)) facts.push_back(std::move(fact));
  const bool same_motion = push.unique_motion != Uniqueness::no;
  if (push.status == Status::solved && (!same_motion || push.unique_wrench == Uniqueness::no))
    facts.push_back({"Other answers", std::string("the laws allow another ") +
                                          (same_motion ? "push force" : "motion") +
                                          " as well; lcpush spread says between which bounds"});
  std::string text;
  if (push.status == Status::solved)
    text = paragraph("The push as prescribed is solved. The largest scaled residual is " +
                         residual_text(push.residuals.max()) + ", checked apart from the solver.",
                     "verdict");
  return {"facts", "The answer in numbers", text + facts_html(facts)};
}

std::string section_html(const Section& section) {
  return "<section id=\"" + section.id + "\" aria-labelledby=\"" + section.id +
         "-title\">\n<h2 id=\"" + section.id + "-title\">" + escaped(section.title) + "</h2>\n" +
         section.inside + "</section>\n";
}

} // namespace

bool is_solved(const PageContent& content) {
  return content.push.status == Status::solved &&
         (content.breaking == nullptr || content.breaking->status == Status::solved) &&
         std::all_of(content.sweeps.begin(), content.sweeps.end(),
                     [](const Sweep& sweep) { return sweep.complete; });
}

std::vector<Picture> report_pictures(const PageContent& content) {
  std::vector<Drawing> drawings = grasp_pictures(content);
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
  std::vector<Section> sections{facts_section(content)};
  if (solved) {
    sections.push_back(friction_section(content));
    sections.push_back(contacts_section(content));
  }
  if (content.breaking != nullptr) sections.push_back(breaking_section(content));
  if (content.held != nullptr) sections.push_back(holding_section(content));
  if (!content.sweeps.empty()) sections.push_back(sweeps_section(content));
  if (solved) sections.push_back(residual_section(content));
  sections.push_back(inputs_section(content));
  const std::string& path = content.file.lines.file;
  const std::string title =
      escaped(content.file.title.empty() ? path.substr(path.rfind('/') + 1) : content.file.title);
  std::string page = page_head(title) + section_html(answer_section(content)) +
                     "<nav aria-label=\"On this page\">\n<ul>\n";
  std::string main;
  for (const Section& section : sections) {
    page += "<li><a href=\"#" + section.id + "\">" + escaped(section.title) + "</a></li>\n";
    main += section_html(section);
  }
  return page + "</ul>\n</nav>\n" + main +
         "</main>\n<footer>\n<p>SI units, the scene's axes; accelerations are the object's, seen "
         "from the gripper. " +
         escaped(run_words(content.file, content.push)) + ". Written by lcpush " + version_text +
         ".</p>\n</footer>\n</body>\n</html>\n";
}

} // namespace lcpush::desktop
