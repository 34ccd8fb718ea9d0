// A design in words, as JSON and as a picture.
#include "draw/plot_svg.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/design.hpp"
#include "lcpush/desktop/naming.hpp"
#include "scenes/warnings_json.hpp"
#include "solve/push_words.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

constexpr int digits = 4;

std::string percent(const std::optional<double>& margin) {
  return margin ? in_digits(100 * *margin, digits) : "-";
}

std::string choice_words(const DesignReport& report) {
  std::vector<std::string> words;
  for (const DesignReport::Choice& choice : report.choices)
    words.push_back(choice.path + " = " + in_digits(choice.value, digits));
  return listed(words, "and");
}

std::string answer_sentence(const DesignReport& report) {
  const BoxAnswer& chosen = report.chosen;
  if (!chosen.margin && !chosen.is_indifferent)
    return "Not known: with " + choice_words(report) + " " + report.binds + ".";
  if (!report.sticks())
    return "Nothing sticks in these ranges; the nearest is " + choice_words(report) + ", where " +
           report.binds + ".";
  const std::string was = !report.given.margin ? ""
                          : *report.given.margin > 0
                              ? " (" + percent(report.given.margin) + " % as it is)"
                              : " (as it is, it slips)";
  std::string text = "With " + choice_words(report) + " the push sticks";
  if (!chosen.margin) return text + was + "; it does not depend on what is not known.";
  text += " while what is not known is at most " + percent(chosen.margin) + " % off" + was;
  if (report.asks_ranges)
    text += chosen.verdict == BoxVerdict::always ? ", so for every value asked"
                                                 : ", which is less than was asked";
  return text + "; " +
         (report.binds.empty() ? "nothing makes it slip" : "beyond, " + report.binds) + ".";
}

} // namespace

std::string design_text(const SceneFile& file, const DesignReport& report) {
  TableRows rows{{"choice", "from", "to", "as it is", "chosen", "alone", "then % off"}};
  for (const DesignReport::Choice& choice : report.choices)
    rows.push_back({choice.path, brief(choice.from), brief(choice.to),
                    in_digits(choice.given, digits), in_digits(choice.value, digits),
                    in_digits(choice.alone, digits), percent(choice.alone_margin)});
  std::vector<std::string> numbers;
  for (const BoxRange& range : report.chosen.box) numbers.push_back(range.path);
  return title_line(file) + answer_sentence(report) + "\n\n" + table_text(rows) + "\n" +
         facts_text({{"Not known", listed(numbers, "and")}, {"Friction", friction_law_text(file)}});
}

std::string design_json(const DesignReport& report) {
  JsonWriter json;
  json.begin_object().key("choice").begin_object();
  for (const DesignReport::Choice& choice : report.choices) json.member(choice.path, choice.value);
  json.end_object()
      .member("margin", report.chosen.margin)
      .member("binds", unless_empty(report.binds));
  json.objects("alone", report.choices, [&](const DesignReport::Choice& choice) {
    json.member("path", choice.path)
        .member("value", choice.alone)
        .member("margin", choice.alone_margin);
  });
  write_warnings(json, report.doubts);
  return json.member("scene", report.scene).end_object().text();
}

std::string design_svg(const SceneFile& file, const DesignReport& report) {
  Plot plot;
  plot.title = file.title.empty() ? "A design" : file.title;
  plot.description = answer_sentence(report);
  const bool is_one = report.choices.size() == 1;
  plot.x_label =
      is_one ? report.choices[0].label : "from the low end of each choice to the high one";
  if (is_one) {
    plot.x_from = report.choices[0].from;
    plot.x_to = report.choices[0].to;
  }
  plot.panels.push_back({"margin, %", {}});
  for (const DesignReport::Choice& choice : report.choices) {
    const auto at = [&](double value) {
      return is_one ? value : (value - choice.from) / (choice.to - choice.from);
    };
    PlotLine line;
    line.label = choice.path;
    line.colour = plot.panels[0].lines.size();
    line.pieces.emplace_back();
    for (const auto& [value, margin] : choice.curve)
      line.pieces[0].emplace_back(at(value), 100 * margin);
    plot.panels[0].lines.push_back(std::move(line));
    const auto mark = [&](double value, const std::string& what, bool strong) {
      plot.marks.push_back(
          {at(value), choice.path + " = " + in_digits(value, digits), what, strong});
    };
    mark(choice.value, "chosen", true);
    for (const auto& [value, what] : choice.breaks) mark(value, "from here on " + what, false);
  }
  return plot_svg(plot);
}

} // namespace lcpush::desktop
