#include "formats/json_writer.hpp"
#include "lcpush/desktop/pivots.hpp"
#include "pivots/explorer.hpp"
#include "scenes/warnings_json.hpp"

namespace lcpush::desktop {

// JsonWriter finds these by their types.

static void write(JsonWriter& json, const TraceNumber& x) {
  x.fraction.empty() ? json.value(x.value) : json.value(x.fraction);
}

static void write(JsonWriter& json, const TraceValue& value) {
  if (value.has_S())
    json.begin_array().value(value.times_S).value(value.finite).end_array();
  else
    json.value(value.finite);
}

namespace {

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
      if (!tableaus) json.member("grows", variable.growth).member("ends", variable.end);
    });
    json.objects("pivots", trace_.pivots,
                 [&](const TracedPivot& pivot) { write_pivot(pivot, tableaus); });
    json.objects("runs", trace_.runs, [&](const TracedRun& run) { write_run(run); });
    write_end();
    if (push != nullptr) write_warnings(json, check_scene(push->file()));
    json.key("scene");
    push != nullptr ? write_scene(json, *push, !tableaus) : void(json.value(nullptr));
    return json.end_object().text();
  }

private:
  const PivotTrace& trace_;
  JsonWriter json;

  /// The key and an object, `write_members` its members; null if there is no such thing.
  template <class T, class Write>
  void object(const char* key, const T* data, const Write& write_members) {
    json.key(key);
    if (data == nullptr) return void(json.value(nullptr));
    json.begin_object();
    write_members(*data);
    json.end_object();
  }
  template <class T, class Write>
  void object(const char* key, const std::optional<T>& data, const Write& write_members) {
    object(key, data ? &*data : nullptr, write_members);
  }

  const char* rule() const {
    for (const TracedPivot& pivot : trace_.pivots)
      if (pivot.chosen) return "chosen";
    if (trace_.rule == TieRule::first_row) return "first_row";
    return trace_.rule == TieRule::lexicographic ? "lexicographic" : "generic";
  }

  void write_tableau(const Tableau& tableau) {
    json.member("rows", trace_.names(tableau.rows))
        .member("columns", trace_.names(tableau.columns));
    json.member("values", tableau.values);
    json.list("entries", tableau.rows.size(), [&](std::size_t i) {
      std::vector<double> values;
      std::vector<std::string> fractions;
      for (std::size_t j = 0; j < tableau.columns.size(); ++j) {
        values.push_back(tableau.entry(i, j).value);
        fractions.push_back(tableau.entry(i, j).fraction);
      }
      fractions[0].empty() ? json.value(values) : json.value(fractions);
    });
  }

  void write_pivot(const TracedPivot& pivot, bool tableaus) {
    json.member("entering", trace_.name(pivot.entering));
    json.member("leaving", trace_.name(pivot.leaving)).member("ratios", pivot.ratios);
    json.member("ties", trace_.names(pivot.ties)).member("tie_break", tie_words(pivot).name);
    json.member("z0", pivot.z0).member("basis", trace_.names(pivot.basis));
    json.member("sentence", pivot.sentence).member("run", pivot.run);
    object("tableau", tableaus && pivot.before ? &*pivot.before : nullptr,
           [&](const Tableau& before) {
             write_tableau(before);
             json.member("row", pivot.row).member("column", pivot.column);
           });
  }

  void write_run(const TracedRun& run) {
    json.member("title", run.title).member("first_pivot", run.first_pivot);
    json.member("units", run.unit).key("start").begin_object();
    write_tableau(run.start);
    json.end_object();
  }

  void write_end() {
    object("final", trace_.last, [&](const Tableau& last) {
      json.member("basis", trace_.names(last.rows)).key("tableau").begin_object();
      write_tableau(last);
      json.end_object().member("z", unless_empty(trace_.z)).member("w", unless_empty(trace_.w));
    });
    object("ray", trace_.ray, [&](const TracedRay& ray) {
      json.member("entering", trace_.name(ray.entering)).member("v", ray.v).member("v0", ray.v0);
      json.member("words", ray.words);
    });
    object("cycle", trace_.cycle, [&](const Cycle& cycle) {
      json.member("from_pivot", cycle.first).member("length", cycle.length);
    });
  }
};

} // namespace

std::string pivots_json(const PivotTrace& trace, const Push* push, bool tableaus) {
  return Writer(trace).write_trace(push, tableaus);
}

} // namespace lcpush::desktop
