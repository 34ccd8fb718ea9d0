#include "lcpush/desktop/varied_scene.hpp"

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "scenes/on_face.hpp"
#include "scenes/scene_builder.hpp"
#include "scenes/scene_schema.hpp"
#include "scenes/scene_units.hpp"
#include "scenes/table_changes.hpp"
#include "scenes/table_reader.hpp"
#include "text/whole_number.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <optional>

namespace lcpush::desktop {
namespace {

/// As TOML has it: words and numbers with a unit are in quotes there, here they need none.
std::string quoted_words(std::string_view typed) {
  const bool is_list = typed.substr(0, 1) == "[";
  std::string text;
  for (std::size_t at = 0; at < typed.size();) {
    const std::size_t end =
        is_list ? std::min(typed.find_first_of("[],", at), typed.size()) : typed.size();
    const std::string word(trimmed(typed.substr(at, end - at)));
    TomlValue number{1, 0.0};
    const bool is_toml = word.empty() || word[0] == '"' || word == "true" || word == "false" ||
                         !read_toml_number(word, number);
    const NumberText typed_otherwise = read_finite_number(word); // .4
    text += is_toml                  ? word
            : !typed_otherwise.error ? shown(typed_otherwise.value)
                                     : toml_text({1, word});
    if (end < typed.size()) text += typed[end];
    at = end + 1;
  }
  return text;
}

/// The text of a scene in which values change.
class EditedText {
  struct Edit {
    std::size_t begin, end;
    std::string text;
  };

public:
  EditedText(std::string text, const std::string& file)
      : document(parse_toml(text, file)), text_(std::move(text)) {
    check_sections(document);
  }

  const TomlDocument document; ///< before any change

  void write(const TomlTable& table, const std::string& key, const TomlValue& value) {
    const std::string entry = key + " = " + toml_text(value);
    for (const TomlEntry& old : table.entries)
      if (old.key == key) return replace(old, entry);
    const std::size_t top = text_.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0; // a byte order mark
    const bool is_first = table.end == 0;
    const std::size_t at = is_first ? top : std::min(text_.find('\n', table.end), text_.size());
    // In the place of a blank line, if there is one: the lines below keep their numbers.
    const std::size_t next = is_first ? top : at + 1;
    const std::size_t end = std::min(text_.find('\n', next), text_.size());
    const bool is_free = next < text_.size() && trimmed(text_.substr(next, end - next)).empty() &&
                         std::none_of(edits_.begin(), edits_.end(),
                                      [at](const Edit& edit) { return edit.begin == at; });
    edits_.push_back(
        {at, is_free ? end : at, is_first ? entry + (is_free ? "" : "\n") : "\n" + entry});
  }

  std::string text() {
    std::stable_sort(edits_.begin(), edits_.end(),
                     [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
    for (const Edit& edit : edits_) text_.replace(edit.begin, edit.end - edit.begin, edit.text);
    return text_;
  }

private:
  void replace(const TomlEntry& old, std::string entry) {
    const std::string_view before = std::string_view(text_).substr(old.begin, old.end - old.begin);
    entry.append(static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')), '\n');
    edits_.push_back({old.begin, old.end, std::move(entry)});
  }

  std::string text_;
  std::vector<Edit> edits_;
};

/// Sets one value in the text of a scene.
class ValueSetter {
public:
  ValueSetter(std::string text, const std::string& file, const std::string& label,
              const std::string& given)
      : given_text_(text), edited_(std::move(text), file),
        said_(label + " " + quoted(given) + ": ") {
    const std::size_t equals = given.find('=');
    if (equals == std::string::npos || trimmed(given.substr(equals + 1)).empty())
      fail("PATH=VALUE is meant, such as wall.friction=0.4");
    path_ = std::string(trimmed(given.substr(0, equals)));
    refuse_range(given.substr(equals + 1));
    value_ = value(given.substr(equals + 1));
    const std::size_t bracket = std::min(path_.find('[', path_.rfind('.') + 1), path_.size());
    const std::size_t dot = path_.rfind('.', bracket);
    owner_ = dot == std::string::npos ? "" : path_.substr(0, dot);
    key_ = path_.substr(dot + 1, bracket - dot - 1);
    for (const std::string_view part : split_at(std::string_view(path_).substr(bracket), '[')) {
      if (part.empty()) continue;
      const auto index = whole_number<std::size_t>(part.substr(0, part.size() - 1));
      if (part.back() != ']' || !index) fail("vectors are counted so: center[0], center[1]");
      indices_.push_back(*index);
    }
  }

  std::string text() {
    for (const auto& [section, table] : targets()) {
      if (is_turn()) {
        turn(*table);
        continue;
      }
      const TomlValue* const old = table->find(key_);
      TomlValue now = old != nullptr ? *old : indices_.empty() ? value_ : zeros(*table);
      at_indices(now) = value_;
      edited_.write(*table, key_, now);
    }
    return edited_.text();
  }

private:
  [[noreturn]] void fail(const std::string& message) const { throw InputError(said_ + message); }

  TomlValue value(std::string_view typed) const {
    const std::string is = "value = ";
    try {
      return parse_toml(is + std::string(typed), "").root.entries.front().value;
    } catch (const InputError&) { // a word without quotes
    }
    if (trimmed(typed)[0] != '[' && typed.find(',') != std::string_view::npos)
      fail("a decimal number has a point, such as 0.3; a vector stands in brackets");
    try {
      return parse_toml(is + quoted_words(trimmed(typed)), "").root.entries.front().value;
    } catch (const InputError& error) {
      const std::string what = error.what();
      fail(what.substr(std::min(what.find(": ") + 2, what.size())));
    }
  }

  /// "0.5:0.9", as --vary and --tolerance have it.
  void refuse_range(std::string_view typed) const {
    const std::vector<std::string_view> ends = split_at(typed, ':');
    if (ends.size() != 2 || path_ == "title") return;
    std::string from(trimmed(ends[0]));
    const std::string_view to = trimmed(ends[1]);
    const std::size_t first = decimal_prefix(from).length, second = decimal_prefix(to).length;
    if (first == 0 || second == 0) return;
    if (first == from.size()) from += to.substr(second); // "50:70 g"
    fail("a range is written " + quoted(path_ + "=[" + from + ", " + std::string(to) + "]") +
         "; does an answer hold for all of it? --tolerance " +
         quoted(path_ + "=" + std::string(trimmed(typed))));
  }

  bool is_turn() const { return key_ == "turn" || key_ == "tangent_turn"; }

  bool is_called(const std::string& section, const TomlTable& table) const {
    if (owner_ == "*")
      return is_body(section) && (table.find(key_) != nullptr || is_turn() || key_ == "shift");
    return owner_ == (table.name() != nullptr ? *table.name() : section);
  }

  /// The tables that the path speaks of, with their sections' names.
  std::vector<std::pair<std::string, const TomlTable*>> targets() const {
    std::vector<std::pair<std::string, const TomlTable*>> found;
    std::vector<std::string> owners = {"*"}, with_key;
    if (owner_.empty()) found.emplace_back("", &edited_.document.root);
    if (key_called("", key_) != nullptr) with_key.push_back(key_);
    for (const TomlSection& section : edited_.document.sections)
      for (const TomlTable& table : section.tables) {
        owners.push_back(table.name() != nullptr ? *table.name() : section.name);
        if (key_called(section.name, key_) != nullptr)
          with_key.push_back(owners.back() + "." + key_);
        if (!owner_.empty() && is_called(section.name, table))
          found.emplace_back(section.name, &table);
      }
    if (found.empty()) {
      std::string near = suggestion(owner_, owners);
      if (owner_ == "*") near = ": no finger or pusher has a " + key_;
      fail("nothing is called " + quoted(owner_) +
           (near.empty() ? "; there are " + listed(owners, "and") : near));
    }
    const Schema& schema = schema_of(found.front().first);
    if (is_turn() ? is_body(found.front().first) : key_called(found.front().first, key_) != nullptr)
      return found;
    if (with_key.size() > 1 && key_called("finger", key_) != nullptr)
      with_key = {"*." + key_ + " for all of them", with_key.front()};
    fail("no key " + quoted(key_) +
         (with_key.empty() ? key_hint(schema, key_) : "; write " + listed(with_key, "or")));
  }

  /// Of a vector that may be left out.
  TomlValue zeros(const TomlTable& table) const {
    static const std::vector<std::string> vectors = {
        "gravity",      "center_of_mass",       "force", "moment", "velocity", "angular_velocity",
        "acceleration", "angular_acceleration", "about", "shift"};
    const bool is_offset = key_ == "center" && table.find("on") != nullptr;
    if (!is_offset && std::find(vectors.begin(), vectors.end(), key_) == vectors.end())
      fail("the scene gives no " + key_ + "; set all of it, " + key_ + "=[..]");
    return {0, TomlArray(is_offset ? 2 : 3, TomlValue{0, std::int64_t{0}, "0"})};
  }

  TomlValue& at_indices(TomlValue& now) const {
    TomlValue* at = &now;
    for (const std::size_t i : indices_) {
      auto* const list = std::get_if<TomlArray>(&at->data);
      if (list == nullptr || i >= list->size())
        fail(key_ +
             (list == nullptr ? " is no such list"
                              : " ends at [" + std::to_string(list->size() - 1) + "]") +
             ", counted from [0]");
      at = &(*list)[i];
    }
    return *at;
  }

  /// A motion or a tangent turned (degrees), as a sweep does it.
  void turn(const TomlTable& original) {
    const std::optional<double> by = value_.number();
    if (!by || !indices_.empty())
      fail("a turn is a number, in degrees: " + owner_ + "." + key_ + "=30");
    const bool is_motion = key_ == "turn", is_fast = original.find("velocity") != nullptr;
    if (is_motion && !is_fast && original.find("acceleration") == nullptr)
      fail("it has neither a velocity nor an acceleration that could turn");
    const char* const key = !is_motion ? "tangent" : is_fast ? "velocity" : "acceleration";
    TomlDocument turned = parse_scene_tables(given_text_, edited_.document.file);
    if (has_contacts_on_faces(turned)) turned = with_typed_places(std::move(turned));
    for (TomlSection& section : turned.sections)
      for (TomlTable& table : section.tables) {
        if (table.line != original.line) continue;
        (is_motion ? turn_motion : turn_tangent)(table, *by);
        if (const TomlValue* const value = table.find(key)) edited_.write(original, key, *value);
      }
  }

  const std::string given_text_;
  EditedText edited_;
  std::string said_, path_, owner_, key_;
  std::vector<std::size_t> indices_;
  TomlValue value_{1, 0.0};
};

/// What a scene refuses is not in its file's lines where it came from here.
void expect_scene(const std::string& text, const std::string& before, const std::string& file,
                  const std::string& said) {
  try {
    parse_scene(text, file);
  } catch (const InputError& error) {
    try {
      parse_scene(before, file);
    } catch (const InputError&) {
      return; // so does the file
    }
    const std::string what = error.what();
    const std::size_t line = what.compare(0, file.size() + 1, file + ":") == 0
                                 ? what.find(": ", file.size() + 1) + 2
                                 : 0;
    throw InputError(said + ": " + what.substr(line));
  }
}

} // namespace

std::string with_values(std::string text, const std::string& file, const std::string& label,
                        const std::vector<std::string>& given) {
  const auto begins = [](const std::string& one, const char* key) { return one.find(key) == 0; };
  const bool is_gripped = std::any_of(given.begin(), given.end(), [](const std::string& one) {
    return one.find("grip_force") < one.find('=');
  });
  const auto hand = [&] { return build_scene<double>(parse_scene_tables(text, file)).hand; };
  const Hand before = is_gripped ? hand() : Hand::fixed;
  const std::string original = text;
  bool is_hand_chosen = false;
  std::vector<std::string> said;
  for (const std::string& one : given) {
    if (begins(one, "gripper.") && EditedText(text, file).document.find("gripper") == nullptr)
      text += "\n[gripper]\n";
    is_hand_chosen |= begins(one, "gripper.");
    text = ValueSetter(std::move(text), file, label, one).text();
    if (!begins(one, "title")) said.push_back(one);
  }
  if (before == Hand::parallel && !is_hand_chosen && hand() != before)
    throw InputError(label + ": the two fingers are a parallel jaw, with one grip force; write " +
                     label + " \"*.grip_force=..\", or add " + label + " gripper.jaws=independent");
  if (given.empty()) return text;
  expect_scene(text, original, file,
               label + (given.size() == 1 ? " " + quoted(given.front()) : ""));
  if (said.empty()) return text;
  EditedText titled(std::move(text), file);
  const TomlValue* const title = titled.document.root.find("title");
  const auto* const words = title != nullptr ? std::get_if<std::string>(&title->data) : nullptr;
  titled.write(titled.document.root, "title",
               {1, (words != nullptr ? *words : file) + ", with " + joined(said, ", ")});
  return titled.text();
}

} // namespace lcpush::desktop
