// What a scene file may contain.
#pragma once

#include "formats/toml.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

/// A key that a table may have.
struct Key {
  const char* name;
  const char* example;           ///< a value that it may have
  const char* unit = "";         ///< of its numbers
  bool is_linear = false;        ///< they enter the right-hand side alone, and linearly
  const char* turning = nullptr; ///< their unit, of an actuator that turns its bodies
};
using Schema = std::vector<Key>;

/// The keys of [section], or of each [[section]]; "" stands for those above the first header.
const Schema& schema_of(const std::string& section);

/// Does [[section]] touch the object?
inline bool is_body(const std::string& section) {
  return section == "finger" || section == "pusher";
}

/// The key of this section (as for schema_of) called `name`; nullptr if there is none.
const Key* key_called(const std::string& section, const std::string& name);

/// What to write instead of `word`, which `schema` does not have: a key that looks like it or means
/// the same, the table that it belongs to, or else the keys there are. Goes on in the sentence.
std::string key_hint(const Schema& schema, const std::string& word);

/// Refuses unknown sections, [name] for [[name]] and the reverse, a missing [object].
void check_sections(const TomlDocument& document);

} // namespace lcpush::desktop
