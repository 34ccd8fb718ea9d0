#include "commands/history.hpp"
#include "formats/json_writer.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::commands {
namespace {

std::string as_json(Solver solver, Status status, const std::vector<std::string>& columns,
                    const std::vector<HistoryRow>& rows) {
  JsonWriter json;
  json.begin_object().member("solver", solver_text(solver)).member("status", status_text(status));
  json.objects("history", rows, [&](const HistoryRow& row) {
    json.member("sweep", row.sweep);
    for (std::size_t c = 0; c < columns.size(); ++c) json.member(columns[c], row.values[c]);
  });
  return json.end_object().text();
}

} // namespace

std::string history_text(const std::string& format, Solver solver, Status status,
                         const std::vector<std::string>& columns,
                         const std::vector<HistoryRow>& rows) {
  if (format == "json") return as_json(solver, status, columns, rows);
  const bool is_csv = format == "csv";
  TableRows table{{"sweep"}};
  table[0].insert(table[0].end(), columns.begin(), columns.end());
  for (const HistoryRow& row : rows) {
    table.push_back({std::to_string(row.sweep)});
    for (const double value : row.values)
      table.back().push_back(is_csv ? shown(value) : printed("%.4e", value));
  }
  if (!is_csv)
    return std::string("Solver ") + solver_text(solver) + ", " + status_text(status) + ".\n\n" +
           table_text(table);
  std::string text;
  for (const std::vector<std::string>& line : table) text += joined(line, ",") + "\n";
  return text;
}

std::string history_text(const std::string& format, Solver solver, Status status,
                         const std::vector<SweepRecord>& records) {
  std::vector<std::string> columns;
  for (const Law law : all_laws) columns.emplace_back(law_text(law));
  columns.emplace_back("max");
  std::vector<HistoryRow> rows;
  for (const SweepRecord& record : records) {
    Residuals<double> residuals = record.residuals;
    rows.push_back({record.sweep, {}});
    for (const Law law : all_laws) rows.back().values.push_back(residuals[law]);
    rows.back().values.push_back(residuals.max());
  }
  return history_text(format, solver, status, columns, rows);
}

} // namespace lcpush::commands
