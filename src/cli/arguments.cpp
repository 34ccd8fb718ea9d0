#include "cli/arguments.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "cli/shell.hpp"
#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "scenes/scene_units.hpp"
#include "scenes/shipped_scenes.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {
namespace {

/// A negative number is a value, not an option.
bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         (word[1] == '-' || word == "-o" || word == "-h" || (word[1] >= 'A' && word[1] <= 'z'));
}

/// "--vary X 5 25", "--vary X=5 25" or "--vary X=5,25": refused with what is meant.
void refuse_apart(const std::vector<std::string>& words) {
  std::vector<std::string> parts;
  for (std::string word : words) {
    if (parts.size() >= 3) break;
    std::replace_if(
        word.begin(), word.end(), [](char c) { return c == '=' || c == ':' || c == ','; }, ' ');
    for (const std::string_view part : split_words(word))
      if (parts.empty() || !read_finite_number(part).error)
        parts.emplace_back(part);
      else
        return;
  }
  if (parts.size() == 3)
    throw UsageError("--vary takes one word: write --vary " +
                     desktop::quoted(parts[0] + "=" + parts[1] + ":" + parts[2]));
}

/// Of --OPTION TEXT.
double value_of(const SiNumber& number, const std::string& option, const std::string& text) {
  if (!number.refusal.empty())
    throw UsageError("--" + option + " " + desktop::quoted(text) + ": " + number.refusal);
  return number.value();
}

double number_of(std::string_view word, const std::string& unit, const std::string& option,
                 const std::string& text) {
  return value_of(typed_number(word, unit), option, text);
}

} // namespace

std::vector<std::string> commands_with(const std::string& option) {
  std::vector<std::string> names;
  for (const Command& command : all_commands())
    for (const Option& known : command.options)
      if (known.label() == option) names.push_back(command.name);
  return names;
}

void Arguments::read_option(const std::vector<std::string>& words, std::size_t& at) {
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
  for (const Option& option : command().options) {
    known.push_back(option.label());
    if (known.back() != name) continue;
    if (has(option.name) && !option.repeats) throw UsageError(name + " is given twice");
    if (option.is_flag()) {
      if (inline_value) throw UsageError(name + " takes no value");
      values_[option.name] = {""};
      return;
    }
    if (!inline_value) {
      if (at + 1 >= words.size())
        throw UsageError(words[at] + " needs a value: " + words[at] + " " + option.value);
      inline_value = words[++at];
    }
    if (name == "--vary" && inline_value->find(':') == std::string::npos) {
      std::vector<std::string> rest(words.begin() + static_cast<std::ptrdiff_t>(at), words.end());
      rest.front() = *inline_value; // also of --vary=X
      refuse_apart(rest);
    }
    if (name == "--set" && inline_value->find('=') == std::string::npos)
      throw UsageError("--set takes one word: write --set \"" + *inline_value + "=0.4\"");
    if (name == "--output" && inline_value->empty())
      throw UsageError("the file to write to has an empty name");
    values_[option.name].push_back(*inline_value);
    if (name == "--game") { // two matrices
      if (at + 1 >= words.size() || is_option(words[at + 1]))
        throw UsageError("--game takes what each player gets, two matrices of one size: --game " +
                         std::string(option.value));
      values_[option.name].push_back(words[++at]);
    }
    return;
  }
  const std::vector<std::string> others = commands_with(name);
  throw UsageError("unknown option " + desktop::quoted(words[at]) +
                   (others.empty() ? suggestion(name, known)
                                   : "; lcpush " + listed(others, "and") + " would take it"));
}

std::string quoted_for_shell(std::string word) {
  for (std::size_t at = 0; (at = word.find('\'', at)) != std::string::npos; at += 4)
    word.replace(at, 1, "'\\''");
  return "'" + word + "'";
}

namespace {

/// Quoted only where a shell would take it apart.
std::string in_a_shell(const std::string& word) {
  const bool is_plain = word.find_first_of(" \t*?[]$&|;<>()'\"\\`~#") == std::string::npos;
  return is_plain ? word : quoted_for_shell(word);
}

} // namespace

Arguments::Arguments(const Command& command, const std::vector<std::string>& words)
    : Values(command), command_line_("lcpush " + command.name) {
  bool only_files = false;
  for (std::size_t at = 0; at < words.size(); ++at) {
    const std::size_t first = at;
    const bool had_output = has("output");
    if (!only_files && words[at] == "--") {
      only_files = true;
    } else if (!only_files && is_option(words[at])) {
      read_option(words, at);
    } else {
      if (words[at].empty()) throw UsageError("the name of a file is empty");
      files_.push_back(words[at]);
      if (files_.size() > command.most_files) {
        std::string hint;
        for (const Option& option : command.options)
          if (option.value[0] == '"' && at >= 2 && words[at - 2] == option.label())
            hint = "; what " + option.label() + " takes stands in quotes: " + option.value;
        throw UsageError("one name too many: " + desktop::quoted(words[at]) + hint);
      }
      if (words[at] == "-" && std::count(files_.begin(), files_.end(), "-") > 1)
        throw UsageError("standard input can be read only once; name a file for the other");
    }
    // Where an answer goes is no part of what was asked.
    if (had_output == has("output"))
      for (std::size_t k = first; k <= at; ++k) command_line_ += " " + in_a_shell(words[k]);
  }
  std::error_code ignored;
  for (const std::string& file : files_)
    if (has("output") && std::filesystem::is_regular_file(file, ignored) &&
        std::filesystem::equivalent(file, *text("output"), ignored))
      throw UsageError("--output is " + desktop::quoted(file) +
                       ", which is read; write to another file");
  if (has("output")) follow_ending();
}

/// Where no format is given, the file's name says it.
void Arguments::follow_ending() {
  if (has("format") || command().find("format") == nullptr) return;
  constexpr const char* known[][2] = {{".svg", "svg"}, {".html", "html"}, {".json", "json"},
                                      {".csv", "csv"}, {".tex", "latex"}, {".toml", "toml"}};
  const std::string path = *text("output");
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  for (const auto& [written, format] : known) {
    if (ending != written) continue;
    const std::vector<std::string>& formats = command().formats;
    const bool has_more = has("history") || has("all"); // formats, which they judge themselves
    if (!has_more && std::find(formats.begin(), formats.end(), format) == formats.end())
      throw UsageError("-o " + desktop::quoted(path) + ": " + command().name + " writes " +
                       listed(formats, "or") + ", not " + format);
    values_["format"] = {format};
    if (format != formats.front()) command_line_ += std::string(" --format ") + format;
  }
}

std::vector<std::string> Arguments::texts(const std::string& option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::vector<std::string>() : found->second;
}

std::optional<std::string> Arguments::text(const std::string& option) const {
  const auto found = values_.find(option);
  return found == values_.end() ? std::nullopt : std::optional(found->second.front());
}

std::optional<commands::Values::Written> Arguments::written(const std::string& option,
                                                            const std::string& unit) const {
  const std::optional<std::string> word = text(option);
  if (!word) return std::nullopt;
  if (!unit.empty() && decimal_prefix(*word).is_whole)
    return Written{number_of(*word, unit, option, *word), *word};
  const NumberText number = read_finite_number(*word);
  return Written{number.error ? std::numeric_limits<double>::quiet_NaN() : number.value, *word};
}

std::optional<std::vector<double>> Arguments::numbers(const std::string& option,
                                                      const std::vector<std::string>& units,
                                                      const std::string& what) const {
  const std::optional<std::string> given = text(option);
  if (!given) return std::nullopt;
  std::vector<std::string> words; // each with the unit that follows it
  for (const std::string_view part : split_at(*given, ','))
    for (const std::string_view word : split_words(part))
      if (words.empty() || decimal_prefix(word).length > 0 || !read_finite_number(word).error)
        words.emplace_back(word);
      else
        words.back() += " " + std::string(word);
  std::vector<double> numbers;
  for (const std::string& word : words)
    numbers.push_back(
        number_of(word, units[std::min(numbers.size(), units.size() - 1)], option, *given));
  if (numbers.size() != units.size())
    throw UsageError(label(option) + " takes " + what + ", " + std::to_string(units.size()) +
                     " numbers in quotes, not " + std::to_string(numbers.size()));
  return numbers;
}

std::string Arguments::usage(const std::string& option) const {
  return command().find(option)->usage();
}

void Arguments::throw_refusal(const std::string& option, const std::string& sentence) const {
  if ((option == "M" || option == "q") && !is_typed())
    throw InputError(matrix_files()[option == "M" ? 0 : 1] + ": " + sentence);
  throw UsageError(sentence);
}

std::string Arguments::format(const std::vector<std::string>& known) const {
  return one_of("format", text("format").value_or(known.front()), known);
}

std::size_t Arguments::scene_count() const {
  if (is_typed()) return 0;
  if (!files_.empty() || !command().find("cover")) return files_.size();
  if (format() != "html") throw UsageError("name a scene, two files M.mtx q.mtx, or --M and --q");
  return 1; // the example
}

Document Arguments::given_scene(std::size_t k) const {
  if (files_.empty() && command().find("cover"))
    return {*scene_called(example_scenes(), "coin"), "the example"};
  if (files_.empty())
    throw UsageError("a scene file is needed; `lcpush new box -o mine.toml` writes one");
  scenes_.resize(files_.size());
  const std::filesystem::path path = files_[k];
  std::error_code ignored;
  if (const std::string name = path.stem().string();
      !std::filesystem::exists(path, ignored) && scene_called(example_scenes(), name) != nullptr)
    throw UsageError("there is no file " + desktop::quoted(files_[k]) +
                     ", but a shipped scene of this name: `lcpush example " + name + " -o " + name +
                     ".toml` writes it");
  if (scenes_[k].empty()) scenes_[k] = read_scene_text(files_[k]);
  return {scenes_[k], scene_label(files_[k])};
}

void Arguments::inspect(const SceneFile& file) const {
  std::vector<SceneDoubt> doubts = check_scene(file);
  const commands::Option* const tolerance = command().find("tolerance");
  const bool asks_box = tolerance != nullptr && tolerance->repeats && text("format") != "svg" &&
                        !has("vary") && command().find("box") == nullptr;
  const bool takes_middle = has("strict") || asks_box; // a range is nothing odd, or a box is asked
  const bool is_instant = // nothing moves so far that it leaves its table
      command().name == "solve" || command().name == "break" || command().name == "hold";
  const auto is_meant = [&](const SceneDoubt& doubt) {
    return (takes_middle && doubt.doubt == Doubt::middle) ||
           (is_instant && doubt.doubt == Doubt::small_table);
  };
  doubts.erase(std::remove_if(doubts.begin(), doubts.end(), is_meant), doubts.end());
  doubt(doubts);
  const std::string refusal = asks_box ? "" : uncertified_law(file); // of a box its own proof
  if (has("certify") && !refusal.empty()) throw UsageError("--certify " + refusal);
}

void Arguments::doubt(const std::vector<SceneDoubt>& doubts) const {
  std::vector<std::string> sentences;
  for (const SceneDoubt& doubt : doubts) sentences.push_back(doubt_text(doubt));
  if (has("strict") && !doubts.empty()) throw InputError(joined(sentences, "\n"));
  for (std::string& sentence : sentences) // a command may look at its scene more than once
    if (text("format") != "json" &&
        std::find(doubts_.begin(), doubts_.end(), sentence) == doubts_.end())
      doubts_.push_back(std::move(sentence));
}

std::vector<Variation> Arguments::variations(const VariedScene& scene) const {
  std::vector<Variation> list;
  for (const std::string& text : texts("vary")) {
    const std::vector<std::string_view> sides = split_at(text, '=');
    const std::vector<std::string_view> ends = split_at(sides.back(), ':');
    if (sides.size() != 2 || ends.size() != 2)
      throw UsageError("--vary needs PATH=FROM:TO, such as edge.friction=0.2:0.8, not " +
                       desktop::quoted(text) +
                       (ends.size() > 2 ? "; --steps says how many values" : ""));
    Parameter parameter = scene.find(std::string(trimmed(sides.front())));
    if (const std::vector<std::string> labels = texts("label"); list.size() < labels.size())
      parameter.label = labels[list.size()];
    const auto typed = typed_ends(ends.front(), ends.back(), parameter.unit);
    const double from = value_of(typed.first, "vary", text),
                 to = value_of(typed.second, "vary", text);
    parameter.typed_unit = typed.second.unit;
    if (!parameter.typed_unit.empty())
      parameter.typed_size = typed_number("1 " + parameter.typed_unit, parameter.unit).value();
    if (from == to)
      throw UsageError("--vary " + desktop::quoted(text) + ": from and to are the same");
    list.push_back({parameter, from, to});
  }
  return list;
}

std::optional<std::vector<Variation>> Arguments::each(const VariedScene& scene) const {
  const std::optional<std::string> given = text("each");
  if (!given) return std::nullopt;
  const std::size_t equals = given->find('=');
  if (equals == std::string::npos)
    throw UsageError("--each needs PATH=V,V,.. such as facets=4,8,16, not " +
                     desktop::quoted(*given));
  const Parameter parameter = scene.find(std::string(trimmed(given->substr(0, equals))));
  std::vector<Variation> list;
  for (const std::string_view part : split_at(std::string_view(*given).substr(equals + 1), ',')) {
    const double value = number_of(part, parameter.unit, "each", *given);
    list.push_back({parameter, value, value});
  }
  return list;
}

Document Arguments::answer() const {
  if (files_.size() != 2)
    throw UsageError(files_.size() == 3 ? "three files are M.mtx q.mtx ANSWER.json: say --lcp"
                                        : "two files are needed: SCENE.toml ANSWER.json");
  return {read_text_file(files_[1], limits::answer_bytes), files_[1]};
}

Document Arguments::contacts() const {
  if (files_.empty())
    throw UsageError(
        "name a JSON file with W, b and mu, or a directory of W.mtx, q.mtx and mu.mtx");
  return {"", files_.front()};
}

Document Arguments::trajectory() const {
  if (files_.size() != 1) throw UsageError("--trajectory needs one file beside it: SCENE.toml");
  const std::string path = *text("trajectory");
  return {read_text_file(path, limits::answer_bytes), file_label(path)};
}

} // namespace lcpush::cli
