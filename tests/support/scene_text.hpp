// Small scene files, and checks of how they are refused.
#pragma once

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/scene_io.hpp"

#include <doctest/doctest.h>

#include <string>

namespace lcpush::desktop {

inline const std::string object_table = "[object]\nmass = 0.2\nbox = [0.1, 0.03, 0.01]\n";
inline const std::string finger_table =
    "[[finger]]\nname = \"left\"\nshape = \"point\"\n"
    "center = [0, 0, 0.005]\nnormal = [0, 0, -2]\nfriction = 0.5\n";
inline const std::string pusher_table =
    "[[pusher]]\nname = \"wall\"\nshape = \"point\"\n"
    "center = [-0.05, 0, 0]\nnormal = [1, 0, 0]\nfriction = 0.3\n";

inline SceneFile parsed(const std::string& text) { return parse_scene(text, "s.toml"); }

inline std::string refusal(const std::string& text) {
  try {
    parsed(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// The tables' line with `from` replaced by `to`; `from` must occur.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

inline std::string with_finger(const std::string& from, const std::string& to) {
  return object_table + with(finger_table, from, to);
}
inline std::string with_finger(const std::string& more) {
  return object_table + finger_table + more;
}
inline std::string with_pusher(const std::string& more) {
  return object_table + pusher_table + more;
}
inline std::string with_object(const std::string& shape) {
  return "[object]\nmass = 2\n" + shape + "\n" + finger_table;
}
inline std::string named(const std::string& table, const std::string& name) {
  const std::size_t at = table.find("name = \"") + 8;
  return std::string(table).replace(at, table.find('"', at) - at, name);
}

inline void check_refusal(const std::string& text, const std::string& message) {
  CAPTURE(text);
  CHECK(refusal(text) == "s.toml:" + message);
}
inline void check_says(const std::string& text, const std::string& part) {
  const std::string message = refusal(text);
  CAPTURE(text);
  CAPTURE(message);
  CHECK(message.rfind("s.toml:", 0) == 0);
  CHECK(message.find(part) != std::string::npos);
}

} // namespace lcpush::desktop
