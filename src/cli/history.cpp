#include "cli/history.hpp"

#include "formats/json_writer.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

std::string as_json(const std::string& solver, Status status,
                    const std::vector<std::string>& columns, const std::vector<HistoryRow>& rows) {
  JsonWriter json;
  json.begin_object().member("solver", solver).member("status", status_text(status));
  json.objects("history", rows, [&](const HistoryRow& row) {
    json.member("sweep", row.sweep);
    for (std::size_t c = 0; c < columns.size(); ++c) json.member(columns[c], row.values[c]);
  });
  return json.end_object().text();
}

std::string as_csv(const std::vector<std::string>& columns, const std::vector<HistoryRow>& rows) {
  std::string text = "sweep";
  for (const std::string& column : columns) text += "," + column;
  text += "\n";
  for (const HistoryRow& row : rows) {
    text += std::to_string(row.sweep);
    for (const double value : row.values) text += "," + shown(value);
    text += "\n";
  }
  return text;
}

std::string as_table(const std::string& solver, Status status,
                     const std::vector<std::string>& columns, const std::vector<HistoryRow>& rows) {
  std::vector<std::vector<std::string>> table{{"sweep"}};
  table[0].insert(table[0].end(), columns.begin(), columns.end());
  for (const HistoryRow& row : rows) {
    table.push_back({std::to_string(row.sweep)});
    for (const double value : row.values) table.back().push_back(printed("%.4e", value));
  }
  return "Solver " + solver + ", " + status_text(status) + ".\n\n" + table_text(table);
}

} // namespace

std::string history_text(const std::string& format, const std::string& solver, Status status,
                         const std::vector<std::string>& columns,
                         const std::vector<HistoryRow>& rows) {
  if (format == "json") return as_json(solver, status, columns, rows);
  return format == "csv" ? as_csv(columns, rows) : as_table(solver, status, columns, rows);
}

std::string push_format(const Arguments& arguments, Solver solver) {
  if (!arguments.has("--history")) return arguments.format();
  if (solver == Solver::lemke)
    throw UsageError("--history goes with --solver gauss-seidel or hybrid; lemke has no sweeps");
  return arguments.format({"text", "csv", "json"});
}

std::string push_history(const std::string& format, Solver solver, Status status,
                         const std::vector<SweepRecord>& records) {
  std::vector<HistoryRow> rows;
  for (const SweepRecord& record : records) {
    Residuals<double> residuals = record.residuals;
    rows.push_back({record.sweep, {}});
    for (const Law law : all_laws) rows.back().values.push_back(residuals[law]);
    rows.back().values.push_back(residuals.max());
  }
  std::vector<std::string> columns;
  for (const Law law : all_laws) columns.emplace_back(law_text(law));
  columns.emplace_back("max");
  return history_text(format, solver_text(solver), status, columns, rows);
}

} // namespace lcpush::cli
