#include "calls/request.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/read_number.hpp"
#include "text/limits.hpp"

namespace lcpush::calls {
namespace {

std::string key_of(std::string option) {
  std::replace(option.begin(), option.end(), '-', '_');
  return option;
}

} // namespace

Request::Request(const Command& command, const std::string& text)
    : Values(command), root_(parse_json(text, name_)) {
  const JsonObject* const object = root_.as<JsonObject>();
  if (object == nullptr)
    fields_.refuse(root_, std::string("a question is a JSON object, got ") + root_.type());
  std::vector<std::string> keys = {"format"};
  if (command.synopsis.find("SCENE") != std::string::npos) keys = {"scene", "file", "format"};
  for (const commands::Option& option : command.options)
    if (!option.in_shell_only) keys.push_back(key_of(option.name));
  keys.insert(keys.end(), command.more_keys.begin(), command.more_keys.end());
  for (const auto& [key, value] : *object)
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      fields_.refuse(value, "no option is called " + desktop::quoted(key) + suggestion(key, keys) +
                                "; there are " + listed(keys, "and"));
}

const JsonValue* Request::find(const std::string& option) const {
  return root_.find(key_of(option).c_str());
}

bool Request::has(const std::string& option) const {
  const JsonValue* const value = find(option);
  const commands::Option* const known = command().find(option);
  if (value == nullptr || known == nullptr || !known->is_flag()) return value != nullptr;
  if (value->as<bool>() == nullptr)
    refuse(option, label(option) + " must be true or false, got " + value->type());
  return *value->as<bool>();
}

std::optional<std::string> Request::text(const std::string& option) const {
  if (find(option) == nullptr) return std::nullopt;
  return fields_.text(root_, key_of(option).c_str());
}

std::optional<commands::Values::Written> Request::written(const std::string& option,
                                                          const std::string&) const {
  const std::optional<double> number = fields_.number(root_, key_of(option).c_str());
  return number ? std::optional(Written{*number, shown(*number)}) : std::nullopt;
}

std::optional<std::vector<double>> Request::numbers(const std::string& option,
                                                    const std::vector<std::string>& units,
                                                    const std::string&) const {
  return fields_.numbers(root_, key_of(option).c_str(), static_cast<Index>(units.size()));
}

std::vector<std::string> Request::texts(const std::string& option) const {
  std::vector<std::string> list;
  const JsonValue* const given = find(option);
  if (given == nullptr) return list;
  if (const auto* const one = given->as<std::string>()) return {*one};
  const JsonArray* const array = given->as<JsonArray>();
  if (array == nullptr) refuse(option, label(option) + " must be an array of strings");
  for (const JsonValue& entry : *array) {
    if (entry.as<std::string>() == nullptr)
      refuse(option, label(option) + " must hold strings, got " + entry.type());
    list.push_back(*entry.as<std::string>());
  }
  return list;
}

std::string Request::label(const std::string& option) const {
  return desktop::quoted(key_of(option));
}

void Request::throw_refusal(const std::string& option, const std::string& sentence) const {
  if (option == "scene" && scene_count() > 0) throw InputError(scene_name() + ": " + sentence);
  const JsonValue* const value = find(option);
  fields_.refuse(value != nullptr ? *value : root_, sentence);
}

std::string Request::format(const std::vector<std::string>& known) const {
  std::vector<std::string> formats = known;
  if (command().find("verbose") != nullptr) formats.emplace_back("full_text");
  const bool has_json = std::find(known.begin(), known.end(), "json") != known.end();
  const std::string wanted = text("format").value_or(has_json ? "json" : known.front());
  one_of("format", wanted, formats);
  return wanted == "full_text" ? "text" : wanted;
}

std::string Request::needed(const std::string& option, const std::string& what) const {
  const std::optional<std::string> found = text(option);
  if (!found) refuse(option, label(option) + " is missing: " + what);
  return *found;
}

Document Request::given_scene(std::size_t) const {
  return {needed("scene", "the text of a scene file"), text("file").value_or("scene")};
}

std::size_t Request::variation_count() const {
  if (find("vary") == nullptr) return 0;
  const JsonArray* const given = fields_.objects(*find("vary"), "list");
  return given == nullptr ? 0 : given->size();
}

/// "vary": {"list": [{"path", "from", "to"}]}.
std::vector<Variation> Request::variations(const VariedScene& scene) const {
  std::vector<Variation> list;
  if (variation_count() == 0)
    refuse("vary", label("vary") + " needs a \"list\" of {\"path\", \"from\", \"to\"}");
  for (const JsonValue& entry : *fields_.objects(*find("vary"), "list")) {
    const Parameter parameter = scene.find(fields_.text(entry, "path"));
    const auto from = fields_.number(entry, "from"), to = fields_.number(entry, "to");
    if (!from || !to) fields_.refuse(entry, "a variation needs \"from\" and \"to\"");
    if (*from == *to) fields_.refuse(entry, "\"from\" and \"to\" are the same");
    list.push_back({parameter, *from, *to});
  }
  return list;
}

/// "each": {"path", "values"}.
std::optional<std::vector<Variation>> Request::each(const VariedScene& scene) const {
  const JsonValue* const each = find("each");
  if (each == nullptr) return std::nullopt;
  const auto values = fields_.numbers(*each, "values", -1);
  if (!values || values->empty()) fields_.refuse(*each, "\"each\" needs \"path\" and \"values\"");
  if (values->size() > limits::curves)
    fields_.refuse(*each, "\"each\" has " + std::to_string(values->size()) + " values; more than " +
                              std::to_string(limits::curves) + " curves cannot be told apart");
  const Parameter parameter = scene.find(fields_.text(*each, "path"));
  std::vector<Variation> list;
  for (const double value : *values) list.push_back({parameter, value, value});
  return list;
}

/// "M" and "q" as they are typed in place: "2 1; 1 2" and "-5 -6", or "1/3 ..".
commands::ExactMatrices Request::exact_matrices() const {
  ExactMatrix M = parse_inline_matrix<Rational>(needed("M", "rows, or a scene"), "M");
  ExactMatrix q = parse_inline_vector<Rational>(needed("q", "a number a row of M"), "q");
  if (M.cols != M.rows) refuse("M", "\"M\" must be square");
  if (q.rows != M.rows)
    refuse("q", "\"q\" must have a number a row of M, " + std::to_string(M.rows) + ", not " +
                    std::to_string(q.rows));
  std::vector<unsigned char> free = free_rows(M.rows);
  return {std::move(M), std::move(q), "M", std::move(free)};
}

/// "free": rows counted from 1.
std::vector<unsigned char> Request::free_rows(Index n) const {
  std::vector<unsigned char> free(static_cast<std::size_t>(n), 0);
  for (const double row : fields_.numbers(root_, "free", -1).value_or(std::vector<double>())) {
    if (!(row >= 1 && row <= static_cast<double>(n)) || row != std::floor(row))
      refuse("free",
             "\"free\" must hold rows from 1 to " + std::to_string(n) + ", not " + shown(row));
    free[static_cast<std::size_t>(row) - 1] = 1;
  }
  return free;
}

std::vector<double> Request::needed_numbers(const std::string& option, Index count) const {
  const auto found = fields_.numbers(root_, option.c_str(), count);
  if (!found)
    refuse(option, label(option) + " must be an array of " + std::to_string(count) + " numbers");
  return *found;
}

std::vector<double> Request::z(const RawProblem& problem) const {
  return needed_numbers("z", problem.size());
}

/// "M": {"rows", "row", "column", "value"}, its entries that are not zero, counted from 0, in the
/// order of rows and columns.
SparseRows Request::matrix() const {
  const JsonValue* const given = find("M");
  if (given == nullptr || given->as<JsonObject>() == nullptr)
    refuse("M", "\"M\" must be an object with \"rows\", \"row\", \"column\" and \"value\"");
  const double size = fields_.number(*given, "rows").value_or(-1);
  if (!(size >= 1) || size != std::floor(size) || size > largest_sparse_dimension)
    fields_.refuse(*given, "\"rows\" must be a whole number from 1 to " +
                               std::to_string(largest_sparse_dimension));
  const auto values = fields_.numbers(*given, "value", -1);
  if (!values) fields_.refuse(*given, "\"value\" must be an array of numbers");
  const auto count = static_cast<Index>(values->size());
  const auto rows = fields_.numbers(*given, "row", count),
             columns = fields_.numbers(*given, "column", count);
  if (!rows || !columns) fields_.refuse(*given, "\"row\" and \"column\" must be arrays of numbers");
  SparseRows M;
  M.cols = static_cast<Index>(size);
  double last_row = 0, last_column = -1;
  for (std::size_t k = 0; k < values->size(); ++k) {
    const double i = (*rows)[k], j = (*columns)[k];
    const bool is_inside =
        i >= 0 && j >= 0 && i < size && j < size && i == std::floor(i) && j == std::floor(j);
    const bool is_next = i > last_row || (i == last_row && j > last_column);
    if (!is_inside || !is_next)
      fields_.refuse(*given, "entry " + std::to_string(k) + " of \"M\" is at row " + shown(i) +
                                 ", column " + shown(j) +
                                 ": entries come in order, once each, counted from 0, below " +
                                 shown(size));
    for (; last_row < i; ++last_row) M.end_row();
    M.add(static_cast<Index>(j), (*values)[k]);
    last_column = j;
    if (last_row < i) last_row = i;
  }
  while (M.rows() < M.cols) M.end_row();
  return M;
}

RawProblem Request::raw_problem() const {
  RawProblem problem;
  problem.M = matrix();
  const Index n = problem.size();
  problem.q = needed_numbers("q", n);
  problem.free = free_rows(n);
  problem.bounds = bounds(n);
  return problem;
}

/// null stands for no end, or for no row.
std::optional<commands::NumberList> Request::list(const std::string& option, Index n) const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (find(option) == nullptr) return std::nullopt;
  const JsonArray* const array = find(option)->as<JsonArray>();
  if (array == nullptr || static_cast<Index>(array->size()) != n)
    refuse(option, label(option) + " must be an array of " + std::to_string(n) + " numbers");
  commands::NumberList list{{}, label(option)};
  for (const JsonValue& entry : *array) {
    const double none = option == "lo" ? -infinity : option == "hi" ? infinity : -1;
    const std::string* const word = entry.as<std::string>();
    const std::optional<double> infinite = word != nullptr ? read_infinite(*word) : std::nullopt;
    if (!entry.is_null() && !infinite && entry.as<double>() == nullptr)
      fields_.refuse(entry, label(option) + " must hold numbers, \"inf\", or null for none");
    list.numbers.push_back(entry.is_null() ? none : infinite ? *infinite : *entry.as<double>());
  }
  return list;
}

} // namespace lcpush::calls
