// The command line: what a command takes, what the user typed, and where the output goes.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "lcpush/desktop/solver.hpp"
#include "lcpush/types.hpp"

namespace lcpush::cli {

using namespace desktop;

/// The command line itself is wrong; what() says how and what to type instead.
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

struct Option {
  std::string name;  ///< "--json"
  std::string value; ///< placeholder of its value, empty for a flag
  std::string help;
  bool repeats = false; ///< may be given several times
};

struct Command {
  std::string name;
  std::string synopsis; ///< what follows the name
  std::string summary;  ///< one line for the list of commands
  std::string details;  ///< paragraphs for --help, an example included
  std::vector<Option> options;
  std::size_t most_files;
  int (*run)(const class Arguments&);
};

class Arguments {
public:
  /// Throws UsageError. `-o` and `--output`, `--json` and `--format json` are the same.
  Arguments(const Command& command, const std::vector<std::string>& words);

  const std::vector<std::string>& files() const { return files_; }
  bool has(const std::string& option) const { return values_.count(option) > 0; }
  std::optional<std::string> value(const std::string& option) const;
  /// All of an option that repeats, in the order given.
  std::vector<std::string> values(const std::string& option) const;

  /// The format asked for, one of `known`.
  std::string format(const std::vector<std::string>& known = {"text", "json"}) const;

  struct Range {
    Index smallest;
    Index largest = std::numeric_limits<Index>::max(); ///< or no limit
    bool even = false;
  };
  /// The whole number of an option, if it is given.
  std::optional<Index> whole(const std::string& option, const Range& range) const;
  /// The number of an option, between 0 and `end` without the two; `hint` goes on with what it is.
  std::optional<double> number(const std::string& option, double end,
                               const std::string& hint) const;
  /// The `count` numbers of an option, between blanks or commas; `what` goes on with what they are.
  std::optional<std::vector<double>> numbers(const std::string& option, std::size_t count,
                                             const std::string& what) const;

private:
  std::vector<std::string> files_;
  std::map<std::string, std::vector<std::string>> values_;

  void read_option(const Command& command, const std::vector<std::string>& words, std::size_t& at);
};

/// Throws a UsageError: the option is `rule`, not `word`; `known` are the words that it may be.
[[noreturn]] void refuse_value(const std::string& option, const std::string& word,
                               const std::string& rule, const std::vector<std::string>& known = {});

/// `word`, which is one of `known`. Throws a UsageError that names them: `what` is the option.
const std::string& one_of(const std::string& what, const std::string& word,
                          const std::vector<std::string>& known);

inline const Option output_option{"--output", "FILE",
                                  "write there instead of to standard output; -o for short"};

/// Options that every command with an answer has.
std::vector<Option> with_common_options(std::vector<Option> own);

std::string help_text(const Command& command);

enum class Stream { output, errors };
/// Of the terminal behind it; 80 where there is none.
std::size_t columns_of(Stream stream);

/// Text for people: wrapped to the terminal, or to 80 columns.
void write_text(const Arguments& arguments, const std::string& text);

/// Writes to the file of -o (whole or not at all), or to standard output. Throws InputError.
void write_output(const Arguments& arguments, const std::string& text);

/// The same to the file at `path`.
void write_file(const std::string& path, const std::string& text);

/// Refuses solvers that do not exist; returns the one asked for.
Solver chosen_solver(const Arguments& arguments);
inline const Option solver_option{"--solver", "NAME",
                                  "lemke (default), gauss-seidel (sweeps) or hybrid (both)"};

} // namespace lcpush::cli
