#include "scenes/parameter_words.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

/// " along y", " about z", " no. 2": which number of a list; counted from 1 where it is no axis.
std::string index_words(const Parameter& parameter, const std::string& key) {
  std::string text;
  const std::vector<std::size_t>& indices = parameter.places.front().indices;
  for (const std::size_t& k : indices) {
    const bool is_last = &k == &indices.back();
    const bool is_plain = key == "size" || key == "weights" || key == "twists" || k > 2;
    const bool turns = key.find("angular") == 0 || key == "moment" || key == "inertia";
    if (is_last && parameter.kind == Parameter::Kind::number && parameter.axis > 0)
      text += std::string(" along ") + "xyz"[parameter.axis - 1];
    else if (is_last && !is_plain)
      text += std::string(turns ? " about " : " along ") + "xyz"[k];
    else
      text += " no. " + std::to_string(k + 1);
  }
  return text;
}

} // namespace

std::string parameter_words(const Parameter& parameter) {
  const std::string& owner = parameter.owner;
  const std::string rest = parameter.path.substr(owner.empty() ? 0 : owner.size() + 1);
  const std::string key = rest.substr(0, rest.find('['));
  std::string words = key;
  std::replace(words.begin(), words.end(), '_', ' ');
  if (owner == "object")
    words += " of the object";
  else if (!owner.empty() && owner != "*")
    words += " of " + owner;
  return words + index_words(parameter, key);
}

std::string parameter_label(const Parameter& parameter) {
  if (!parameter.label.empty()) return parameter.label;
  return parameter_words(parameter) + (parameter.unit.empty() ? "" : ", " + parameter.unit);
}

} // namespace lcpush::desktop
