#include "cli/arguments.hpp"

#include "cli/commands.hpp"
#include "cli/time_limit.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include <sys/ioctl.h>
#include <unistd.h>

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/text_file.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {

namespace {

/// A negative number is a value, not an option.
bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         (word[1] == '-' || word == "-o" || word == "-h" || (word[1] >= 'A' && word[1] <= 'z'));
}

/// lcpush writes text: no name should promise another kind of file.
void refuse_foreign_format(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  for (const char* foreign : {".pdf", ".png", ".jpg", ".jpeg", ".gif", ".docx", ".xlsx"})
    if (ending == foreign)
      throw UsageError("-o " + desktop::quoted(path) + ": lcpush does not write " + ending +
                       " files; it writes text, JSON, CSV, SVG and HTML");
}

/// The names of those that take an option of this name.
std::vector<std::string> commands_with(const std::string& option) {
  std::vector<std::string> names;
  for (const Command& command : all_commands())
    for (const Option& known : command.options)
      if (known.name == option) names.push_back(command.name);
  return names;
}

} // namespace

void Arguments::read_option(const Command& command, const std::vector<std::string>& words,
                            std::size_t& at) {
  std::string name = words[at] == "-o" ? "--output" : words[at] == "-v" ? "--verbose" : words[at];
  std::optional<std::string> inline_value;
  if (const std::size_t equals = name.find('='); equals != std::string::npos) {
    inline_value = name.substr(equals + 1);
    name.resize(equals);
  }
  if (name == "--json") {
    name = "--format";
    inline_value = "json";
  }
  std::vector<std::string> known{"--json"};
  for (const Option& option : command.options) {
    known.push_back(option.name);
    if (option.name != name) continue;
    if (values_.count(name) > 0 && !option.repeats) throw UsageError(name + " is given twice");
    if (option.value.empty()) {
      if (inline_value) throw UsageError(name + " takes no value");
      values_[name] = {""};
      return;
    }
    if (!inline_value) {
      if (at + 1 >= words.size())
        throw UsageError(words[at] + " needs a value: " + words[at] + " " + option.value);
      inline_value = words[++at];
    }
    if (name == output_option.name && inline_value->empty())
      throw UsageError("the file to write to has an empty name");
    values_[name].push_back(*inline_value);
    return;
  }
  const std::vector<std::string> others = commands_with(name);
  throw UsageError("unknown option " + desktop::quoted(words[at]) +
                   (others.empty() ? suggestion(name, known)
                                   : "; lcpush " + listed(others, "and") + " would take it"));
}

Arguments::Arguments(const Command& command, const std::vector<std::string>& words) {
  bool only_files = false;
  for (std::size_t at = 0; at < words.size(); ++at) {
    if (!only_files && words[at] == "--") {
      only_files = true;
    } else if (!only_files && is_option(words[at])) {
      read_option(command, words, at);
    } else {
      if (words[at].empty()) throw UsageError("the name of a file is empty");
      files_.push_back(words[at]);
      if (files_.size() > command.most_files)
        throw UsageError("one name too many: " + desktop::quoted(words[at]));
      if (words[at] == "-" && std::count(files_.begin(), files_.end(), "-") > 1)
        throw UsageError("standard input can be read only once; name a file for the other");
    }
  }
}

std::optional<std::string> Arguments::value(const std::string& option) const {
  const std::vector<std::string> all = values(option);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

std::vector<std::string> Arguments::values(const std::string& option) const {
  const auto found = values_.find(option);
  if (found == values_.end()) return {};
  return found->second;
}

std::string Arguments::format(const std::vector<std::string>& known) const {
  return one_of("--format", value("--format").value_or("text"), known);
}

std::optional<Index> Arguments::whole(const std::string& option, const Range& range) const {
  const std::optional<std::string> word = value(option);
  if (!word) return std::nullopt;
  const std::optional<Index> number = whole_number<Index>(*word);
  if (!number || *number < range.smallest || *number > range.largest ||
      (range.even && *number % 2 != 0))
    refuse_value(
        option, *word,
        (range.even ? "an even number from " : "a whole number from ") +
            std::to_string(range.smallest) +
            (range.largest < Range{0}.largest ? " to " + std::to_string(range.largest) : " on"));
  return number;
}

std::optional<double> Arguments::number(const std::string& option, double end,
                                        const std::string& hint) const {
  const std::optional<std::string> word = value(option);
  if (!word) return std::nullopt;
  const NumberText number = read_finite_number(*word);
  if (number.error || !(number.value > 0) || !(number.value < end))
    refuse_value(option, *word, "a number between 0 and " + shown(end) + hint);
  return number.value;
}

std::optional<std::vector<double>> Arguments::numbers(const std::string& option, std::size_t count,
                                                      const std::string& what) const {
  const std::optional<std::string> text = value(option);
  if (!text) return std::nullopt;
  std::vector<double> numbers;
  for (const std::string_view part : split_at(*text, ','))
    for (const std::string_view word : split_words(part)) {
      const NumberText number = read_finite_number(word);
      if (number.error) throw UsageError(option + ": " + *number.error);
      numbers.push_back(number.value);
    }
  if (numbers.size() != count)
    throw UsageError(option + " takes " + what + ", " + std::to_string(count) +
                     " numbers in quotes, not " + std::to_string(numbers.size()));
  return numbers;
}

void refuse_value(const std::string& option, const std::string& word, const std::string& rule,
                  const std::vector<std::string>& known) {
  throw UsageError(option + " is " + rule + ", not " + desktop::quoted(word) +
                   suggestion(word, known));
}

const std::string& one_of(const std::string& what, const std::string& word,
                          const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), word) == known.end())
    refuse_value(what, word, listed(known, "or"), known);
  return word;
}

std::vector<Option> with_common_options(std::vector<Option> own) {
  const auto is_format = [](const Option& option) { return option.name == "--format"; };
  if (std::none_of(own.begin(), own.end(), is_format))
    own.push_back(
        {"--format", "text|json", "for people (default) or for programs; --json for short"});
  own.push_back(output_option);
  return own;
}

std::string help_text(const Command& command) {
  std::string text = "lcpush " + command.name + ": " + command.summary + "\n\nUsage: lcpush " +
                     command.name + " " + command.synopsis + "\n\n" + reflowed(command.details) +
                     "\nOptions:\n";
  for (const Option& option : command.options) {
    std::string left = "  " + option.name + (option.value.empty() ? "" : " " + option.value);
    left.resize(std::max<std::size_t>(left.size() + 2, 28), ' ');
    text += left + option.help + "\n";
  }
  return wrapped(text +
                     "  --help                    this text\n\nExit status: 0 solved, 1 not solved "
                     "(the output says why), 2 bad input or usage.\nMemory: about 1 GB at most; "
                     "what would take more is refused before it begins.\n",
                 columns_of(Stream::output));
}

std::size_t columns_of(Stream stream) {
  winsize size{};
  const int descriptor = stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO;
  const bool is_known = isatty(descriptor) != 0 && ioctl(descriptor, TIOCGWINSZ, &size) == 0;
  return is_known && size.ws_col > 0 ? size.ws_col : usual_width;
}

void write_text(const Arguments& arguments, const std::string& text) {
  write_output(arguments,
               wrapped(text, arguments.has("--output") ? usual_width : columns_of(Stream::output)));
}

void write_output(const Arguments& arguments, const std::string& text) {
  lift_time_limit();
  const std::optional<std::string> path = arguments.value("--output");
  if (path) {
    refuse_foreign_format(*path);
    return write_file(*path, text);
  }
  errno = 0;
  std::cout << text << std::flush;
  if (!std::cout) refuse_file("standard output", "written", errno);
}

void write_file(const std::string& path, const std::string& text) {
  lift_time_limit();
  errno = 0;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path + ": is a directory; name a file inside it");
  // A device or a pipe cannot be renamed over.
  const bool direct =
      std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  const std::string partial = direct ? path : path + ".part";
  std::ofstream stream(partial, std::ios::binary);
  if (!stream) refuse_file(path, "written", errno);
  stream << text << std::flush;
  if (!stream) {
    const int reason = errno;
    if (!direct) std::remove(partial.c_str());
    refuse_file(path, "written", reason);
  }
  stream.close();
  if (direct) return;
  std::error_code failure;
  std::filesystem::rename(partial, path, failure);
  if (!failure) return;
  std::remove(partial.c_str());
  refuse_file(path, "written", failure.value());
}

Solver chosen_solver(const Arguments& arguments) {
  const std::string solver = arguments.value("--solver").value_or("lemke");
  if (solver == "pgs") return Solver::gauss_seidel; // as many call it
  for (const Solver known : {Solver::lemke, Solver::gauss_seidel, Solver::hybrid})
    if (solver == solver_text(known)) return known;
  refuse_value("--solver", solver, "lemke, gauss-seidel or hybrid",
               {"lemke", "gauss-seidel", "hybrid"});
}

} // namespace lcpush::cli
