#include "commands/command.hpp"

#include "commands/values.hpp"
#include "formats/json_writer.hpp"

namespace lcpush::commands {
namespace {

void add_unless_there(std::vector<Option>& options, const Option& option) {
  for (const Option& known : options)
    if (known.label() == option.label()) return;
  options.push_back(option);
}

} // namespace

const Option* Command::find(const std::string& option) const {
  for (const Option& known : options)
    if (known.name == option) return &known;
  return nullptr;
}

Result run(const Command& command, const Values& values, Listener& listener) {
  Result result = command.run(values, listener);
  const std::vector<std::string> set = values.texts("set");
  if (set.empty() || result.text[0] != '{') return result;
  JsonWriter json;
  json.begin_object().member("set", set);
  result.text.replace(0, 1, json.text() + ",");
  return result;
}

std::vector<Option> with_raw_options(std::vector<Option> before, const std::vector<Option>& after) {
  before.insert(before.end(),
                {{"M", "MATRIX", "rows by semicolons, numbers by blanks"},
                 {"q", "VECTOR", "n numbers"},
                 {"free", "I,J,..", "1-based rows that are equalities, or a file of them"},
                 {"lo", "ENDS", "lower ends of z: a file, numbers, or one for all"},
                 {"hi", "ENDS", "upper ends; friction where --findex names a row"},
                 {"findex", "ROWS", "-1, or from 0 the row j with ends -hi z_j and hi z_j"}});
  before.insert(before.end(), after.begin(), after.end());
  return before;
}

std::vector<Option> with_common_options(std::vector<Option> own) {
  add_unless_there(
      own, format_option("for people (default) or for programs; --json for short", "text|json"));
  own.push_back(output_option);
  return own;
}

std::vector<Option> with_scene_options(std::vector<Option> own) {
  own.push_back(set_option);
  own.push_back({"strict", "", "what looks odd about the scene is an error", false, true});
  add_unless_there(own, seconds_option);
  return with_common_options(std::move(own));
}

Option format_option(const char* help, const char* placeholder) {
  return {"format", placeholder, help, false, true};
}

} // namespace lcpush::commands
