#include "scenes/parameter_words.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

/// " along y", " about z", " no. 2": which number of a list; counted from 1 where it is no axis.
std::string index_words(const Parameter& parameter, const std::string& key,
                        const std::string& indices) {
  std::string text;
  for (std::size_t at = 0; at < indices.size(); at = indices.find(']', at) + 1) {
    const std::size_t end = indices.find(']', at);
    const int k = std::stoi(indices.substr(at + 1, end - at - 1));
    const bool is_last = end + 1 == indices.size();
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
  const std::string& path = parameter.path;
  const std::size_t bracket = std::min(path.find('[', path.rfind('.') + 1), path.size());
  const std::size_t dot = path.rfind('.', bracket);
  const std::string owner = dot == std::string::npos ? "" : path.substr(0, dot);
  const std::string key = path.substr(dot + 1, bracket - dot - 1);
  std::string words = key;
  std::replace(words.begin(), words.end(), '_', ' ');
  if (owner == "object")
    words += " of the object";
  else if (!owner.empty() && owner != "*")
    words += " of " + owner;
  return words + index_words(parameter, key, path.substr(bracket));
}

std::string parameter_label(const Parameter& parameter) {
  if (!parameter.label.empty()) return parameter.label;
  return parameter_words(parameter) + (parameter.unit.empty() ? "" : ", " + parameter.unit);
}

} // namespace lcpush::desktop
