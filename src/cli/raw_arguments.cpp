// Raw problems: M and q from two files or typed in place, their free rows, lists of a box.
#include "cli/arguments.hpp"
#include "formats/json_fields.hpp"
#include "formats/read_number.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <filesystem>

namespace lcpush::cli {
namespace {

/// 1-based rows, as typed or in a file; nothing is free without the option, or if its file is
/// empty.
std::vector<unsigned char> read_free(const Arguments& arguments, Index n) {
  std::vector<unsigned char> free(static_cast<std::size_t>(n), 0);
  if (!arguments.has("free")) return free;
  std::string list = *arguments.text("free"), where = "--free";
  const bool is_typed = list.empty() || (list[0] >= '0' && list[0] <= '9') || list[0] == '-';
  std::error_code ignored;
  if (!is_typed && std::filesystem::is_regular_file(list, ignored)) {
    where = list + ": --free";
    list = read_text_file(list, limits::matrix_bytes);
    list.erase(list.find_last_not_of(" \t\r\n") + 1);
    if (list.empty()) return free;
  }
  for (const std::string_view word : split_at(list, ',')) {
    const auto row = whole_number<Index>(word);
    if (!row || *row < 1 || *row > n)
      throw UsageError(where + " is a list of rows from 1 to " + std::to_string(n) +
                       " such as 7,8, or a file of it, not " + desktop::quoted(list));
    unsigned char& is_free = free[static_cast<std::size_t>(*row - 1)];
    if (is_free != 0) throw UsageError(where + " names row " + std::to_string(*row) + " twice");
    is_free = 1;
  }
  return free;
}

/// M and q as messages name them, and the paths of files.
struct MatrixNames {
  std::string M, q;
};

void check_sizes(const MatrixNames& names, Index rows, Index cols, Index q_rows, Index q_cols) {
  const auto by = [](Index m, Index n) { return std::to_string(m) + " x " + std::to_string(n); };
  if (cols != rows) throw InputError(names.M + ": M must be square, but it is " + by(rows, cols));
  if (q_cols != 1 || q_rows != rows)
    throw InputError(names.q + ": q must be " + by(rows, 1) + " like M's rows, but it is " +
                     by(q_rows, q_cols));
}

/// "0 1 inf" or "[0; 1; Inf]": numbers by blanks, commas or semicolons. Nothing if a word is no
/// number: it names a file then.
std::optional<std::vector<double>> typed_numbers(const std::string& given) {
  std::vector<double> numbers;
  std::string text = without_brackets(given);
  std::replace(text.begin(), text.end(), ';', ',');
  for (const std::string_view part : split_at(text, ','))
    for (const std::string_view word : split_words(part)) {
      if (const auto infinite = read_infinite(word)) {
        numbers.push_back(*infinite);
        continue;
      }
      const NumberText number = read_finite_number(word);
      if (number.error) return std::nullopt;
      numbers.push_back(number.value);
    }
  return numbers.empty() ? std::nullopt : std::optional(numbers);
}

} // namespace

/// Two of them; none if M and q are typed.
std::vector<std::string> Arguments::matrix_files() const {
  std::vector<std::string> files = files_;
  if (command().find("lcp") != nullptr) { // verify's last file is the answer
    if (files.empty())
      throw UsageError("files are needed: M.mtx q.mtx ANSWER.json (or --M, --q and ANSWER.json)");
    files.pop_back();
  }
  if (has("M") != has("q")) throw UsageError("--M and --q go together");
  if (is_typed() && !files.empty()) throw UsageError("give either files or --M and --q, not both");
  if (!is_typed() && files.size() != 2)
    throw UsageError("two files are needed: M.mtx q.mtx (or --M \"2 1; 1 2\" --q \"-5 -6\")");
  return files;
}

commands::ExactMatrices Arguments::exact_matrices() const {
  const std::vector<std::string> files = matrix_files();
  commands::ExactMatrices raw;
  if (is_typed())
    raw = {parse_inline_matrix<Rational>(*text("M"), "--M"),
           parse_inline_vector<Rational>(*text("q"), "--q"),
           "--M",
           {}};
  else
    raw = {read_matrix_market<Rational>(files[0]),
           read_matrix_market<Rational>(files[1]),
           files[0],
           {}};
  check_sizes({raw.name, is_typed() ? "--q" : files[1]}, raw.M.rows, raw.M.cols, raw.q.rows,
              raw.q.cols);
  raw.free = read_free(*this, raw.M.rows);
  return raw;
}

RawProblem Arguments::raw_problem() const {
  const std::vector<std::string> files = matrix_files();
  RawProblem problem;
  problem.M =
      is_typed() ? rows_of(parse_inline_matrix(*text("M"), "--M")) : read_sparse_matrix(files[0]);
  HostMatrix q = is_typed() ? parse_inline_vector(*text("q"), "--q") : read_matrix_market(files[1]);
  check_sizes(is_typed() ? MatrixNames{"--M", "--q"} : MatrixNames{files[0], files[1]},
              problem.M.rows(), problem.M.cols, q.rows, q.cols);
  problem.q = std::move(q.values);
  problem.free = read_free(*this, problem.size());
  problem.bounds = bounds(problem.size());
  if (!has("certify")) return problem;
  if (is_typed())
    throw UsageError("--certify ties its proof to files: give M and q as M.mtx q.mtx");
  if (problem.bounds.given())
    throw UsageError("--certify proves problems without boxes; leave --lo, --hi and --findex out");
  if (problem.size() > limits::rows_certified)
    throw UsageError("--certify takes at most " + std::to_string(limits::rows_certified) +
                     " rows, and M has " + std::to_string(problem.size()));
  return problem;
}

/// A file's numbers, or typed ones, of which one may stand for all.
std::optional<commands::NumberList> Arguments::list(const std::string& option, Index n) const {
  const std::optional<std::string> given = text(option);
  if (!given) return std::nullopt;
  const auto count = static_cast<std::size_t>(n);
  commands::NumberList list{{}, label(option)};
  if (const auto typed = typed_numbers(*given)) {
    list.numbers = *typed;
    if (typed->size() == 1) list.numbers.assign(count, typed->front());
  } else {
    const HostMatrix file = read_matrix_market(*given, Entries::bounds);
    list = {file.values, *given};
    if (file.cols != 1 && file.rows != 1)
      throw InputError(*given + ": " + label(option) + " must be " + std::to_string(n) +
                       " x 1, but it is " + std::to_string(file.rows) + " x " +
                       std::to_string(file.cols));
  }
  if (list.numbers.size() != count)
    throw InputError(list.name + ": " + label(option) + " has " +
                     std::to_string(list.numbers.size()) + " numbers, M has " + std::to_string(n) +
                     " rows");
  return list;
}

/// The z of `lcpush lcp --json`, or of an object that has nothing else.
std::vector<double> Arguments::z(const RawProblem&) const {
  const std::string& path = files_.back();
  const JsonValue root = parse_json(read_text_file(path, limits::answer_bytes), path);
  const JsonFields fields(path);
  if (root.as<JsonObject>() == nullptr)
    fields.refuse(root, std::string("an answer is a JSON object, got ") + root.type());
  const auto z = fields.numbers(root, "z", -1);
  if (!z) fields.refuse(root, "nothing to verify: give \"z\": [n numbers]");
  return *z;
}

} // namespace lcpush::cli
