// The command line: what the user typed, as values of a command's options.
#pragma once

#include <map>
#include <stdexcept>

#include "commands/values.hpp"
#include "lcpush/desktop/scene_check.hpp"

namespace lcpush::cli {

using namespace desktop;
using commands::Command;
using commands::Document;
using commands::Option;

/// The command line itself is wrong; what() says how and what to type instead.
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// The names of the commands that take an option of this name, such as "--steps".
std::vector<std::string> commands_with(const std::string& option);

/// In single quotes.
std::string quoted_for_shell(std::string word);

class Arguments : public commands::Values {
public:
  /// Throws UsageError. `-o` and `--output`, `--json` and `--format json` are the same.
  Arguments(const Command& command, const std::vector<std::string>& words);

  const std::vector<std::string>& files() const { return files_; }
  /// What looks odd about the scenes that were read, unless JSON has it.
  const std::vector<std::string>& doubts() const { return doubts_; }

  bool has(const std::string& option) const override { return values_.count(option) > 0; }
  std::optional<std::string> text(const std::string& option) const override;
  std::vector<std::string> texts(const std::string& option) const override;
  std::optional<Written> written(const std::string& option, const std::string& unit) const override;
  std::optional<std::vector<double>> numbers(const std::string& option,
                                             const std::vector<std::string>& units,
                                             const std::string& what) const override;
  std::string label(const std::string& option) const override { return "--" + option; }
  std::string usage(const std::string& option) const override;
  std::string row_name(Index row) const override { return "row " + std::to_string(row + 1); }
  /// An InputError of a matrix' file, a UsageError of everything else.
  void throw_refusal(const std::string& option, const std::string& sentence) const override;
  using Values::format;
  std::string format(const std::vector<std::string>& known) const override;
  Telling telling() const override { return has("verbose") ? Telling::full : Telling::brief; }
  std::string command_line() const override { return command_line_; }

  /// The files of a command about scenes; of pivots, which also takes matrices, its scene.
  std::size_t scene_count() const override;
  Document given_scene(std::size_t k = 0) const override;
  std::size_t variation_count() const override { return texts("vary").size(); }
  std::vector<Variation> variations(const VariedScene& scene) const override;
  std::optional<std::vector<Variation>> each(const VariedScene& scene) const override;

  commands::ExactMatrices exact_matrices() const override;
  RawProblem raw_problem() const override;
  std::optional<commands::NumberList> list(const std::string& option, Index n) const override;
  Document answer() const override;
  Document trajectory() const override;
  Document contacts() const override;
  std::vector<double> z(const RawProblem& problem) const override;
  void inspect(const SceneFile& file) const override;
  void doubt(const std::vector<SceneDoubt>& doubts) const override;

private:
  std::string command_line_;
  std::vector<std::string> files_;
  std::map<std::string, std::vector<std::string>> values_;
  mutable std::vector<std::string> scenes_; ///< texts: standard input is read only once
  mutable std::vector<std::string> doubts_;

  void follow_ending();
  void read_option(const std::vector<std::string>& words, std::size_t& at);
  bool is_typed() const { return has("M") || has("q"); }
  std::vector<std::string> matrix_files() const;
};

} // namespace lcpush::cli
