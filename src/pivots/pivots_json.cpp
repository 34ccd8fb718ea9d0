#include "formats/json_writer.hpp"
#include "lcpush/desktop/pivots.hpp"
#include "pivots/explorer_scene.hpp"

namespace lcpush::desktop {
namespace {

void write(JsonWriter& json, const TraceNumber& x) {
  if (x.fraction.empty())
    json.value(x.value);
  else
    json.value(x.fraction);
}

void write(JsonWriter& json, const TraceValue& value) {
  if (!value.has_S()) return write(json, value.finite);
  json.begin_array();
  write(json, value.times_S);
  write(json, value.finite);
  json.end_array();
}

template <class T> void write(JsonWriter& json, const std::optional<T>& data) {
  data ? write(json, *data) : void(json.value(nullptr));
}

template <class T> void write(JsonWriter& json, const std::vector<T>& list) {
  json.begin_array();
  for (const T& x : list) write(json, x);
  json.end_array();
}

class Writer {
public:
  explicit Writer(const PivotTrace& trace) : trace_(trace) {}

  std::string write_trace(const Push* push, bool tableaus) {
    json.begin_object();
    json.member("status", trace_.cycle ? "cycle" : status_text(trace_.status));
    json.member("reason", unless_empty(trace_.reason));
    json.member("arithmetic", trace_.has_fractions ? "fractions" : "decimals");
    if (!tableaus) json.member("prefers_decimals", trace_.prefers_decimals); // the page asks
    json.member("rule", rule()).member("title", trace_.title);
    json.member("as_solved", trace_.is_as_solved).member("proved", trace_.is_proved);
    json.member("size", trace_.size).member("free", trace_.free_count);
    json.member("notes", trace_.notes);
    json.objects("variables", trace_.variables, [&](const Variable& variable) {
      json.member("name", variable.name).member("meaning", variable.meaning);
    });
    json.objects("pivots", trace_.pivots,
                 [&](const TracedPivot& pivot) { write_pivot(pivot, tableaus); });
    json.objects("runs", trace_.runs, [&](const TracedRun& run) { write_run(run); });
    write_end();
    json.key("scene");
    push != nullptr ? write_scene(json, *push, !tableaus) : null();
    json.end_object();
    return json.text();
  }

private:
  const PivotTrace& trace_;
  JsonWriter json;

  void null() { json.value(nullptr); }

  const char* rule() const {
    for (const TracedPivot& pivot : trace_.pivots)
      if (pivot.chosen) return "chosen";
    if (trace_.rule == TieRule::first_row) return "first_row";
    return trace_.rule == TieRule::lexicographic ? "lexicographic" : "generic";
  }

  std::vector<std::string> names(const std::vector<Index>& variables) const {
    std::vector<std::string> result;
    for (const Index variable : variables) result.push_back(trace_.name(variable));
    return result;
  }

  void write_tableau(const Tableau& tableau, const TracedPivot* pivot) {
    json.begin_object().member("rows", names(tableau.rows));
    json.member("columns", names(tableau.columns));
    json.key("values");
    write(json, tableau.values);
    json.key("entries").begin_array();
    for (std::size_t i = 0; i < tableau.rows.size(); ++i) {
      std::vector<double> values;
      std::vector<std::string> fractions;
      for (std::size_t j = 0; j < tableau.columns.size(); ++j) {
        values.push_back(tableau.entry(i, j).value);
        fractions.push_back(tableau.entry(i, j).fraction);
      }
      fractions[0].empty() ? json.value(values) : json.value(fractions);
    }
    json.end_array();
    if (pivot != nullptr) json.member("row", pivot->row).member("column", pivot->column);
    json.end_object();
  }

  void write_pivot(const TracedPivot& pivot, bool tableaus) {
    json.member("entering", trace_.name(pivot.entering));
    json.member("leaving", trace_.name(pivot.leaving)).key("ratios");
    write(json, pivot.ratios);
    json.member("ties", names(pivot.ties)).member("tie_break", tie_words(pivot).name);
    json.key("z0");
    write(json, pivot.z0);
    json.member("basis", names(pivot.basis)).member("sentence", pivot.sentence);
    json.member("run", pivot.run).key("tableau");
    pivot.before&& tableaus ? write_tableau(*pivot.before, &pivot) : null();
  }

  void write_run(const TracedRun& run) {
    json.member("title", run.title).member("first_pivot", run.first_pivot);
    json.member("units", run.unit).key("start");
    write_tableau(run.start, nullptr);
  }

  void write_end() {
    json.key("final");
    trace_.last ? write_final(*trace_.last) : null();
    json.key("ray");
    trace_.ray ? write_ray(*trace_.ray) : null();
    json.key("cycle");
    trace_.cycle ? write_cycle(*trace_.cycle) : null();
  }

  void write_final(const Tableau& last) {
    json.begin_object().member("basis", names(last.rows)).key("tableau");
    write_tableau(last, nullptr);
    json.key("z");
    trace_.z.empty() ? null() : write(json, trace_.z);
    json.key("w");
    trace_.w.empty() ? null() : write(json, trace_.w);
    json.end_object();
  }

  void write_ray(const TracedRay& ray) {
    json.begin_object().member("entering", trace_.name(ray.entering)).key("v");
    write(json, ray.v);
    json.key("v0");
    write(json, ray.v0);
    json.member("words", ray.words).end_object();
  }

  void write_cycle(const Cycle& cycle) {
    json.begin_object().member("from_pivot", cycle.first).member("length", cycle.length);
    json.end_object();
  }
};

} // namespace

std::string pivots_json(const PivotTrace& trace, const Push* push, bool tableaus) {
  return Writer(trace).write_trace(push, tableaus);
}

} // namespace lcpush::desktop
