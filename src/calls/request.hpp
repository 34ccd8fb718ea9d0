// A question's keys, typed: what is wrong with them is said by name.
#pragma once

#include "formats/json_fields.hpp"
#include "lcpush/desktop/scene_io.hpp"
#include "lcpush/desktop/solver.hpp"
#include "lcpush/desktop/telling.hpp"
#include "lcpush/desktop/varied_scene.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

class Request {
public:
  /// Throws InputError if `text` is no object, or has a key that is none of `keys`.
  Request(const std::string& text, std::vector<std::string> keys);

  std::string text(const char* key) const { return fields_.text(root_, key); }
  std::string text(const char* key, const char* otherwise) const;
  bool flag(const char* key) const;
  std::optional<double> number(const char* key) const { return fields_.number(root_, key); }
  /// A number > 0.
  std::optional<double> positive(const char* key) const;
  std::optional<Index> whole(const char* key, Index least, Index most) const;
  std::optional<std::vector<double>> numbers(const char* key, Index count = -1) const {
    return fields_.numbers(root_, key, count);
  }
  /// Numbers in which null stands for `otherwise`; nothing if the key is not there.
  std::optional<std::vector<double>> numbers_or(const char* key, Index count,
                                                double otherwise) const;
  const JsonValue* find(const char* key) const { return root_.find(key); }
  const JsonFields& fields() const { return fields_; }
  /// "format": one of these, the first if there is none.
  std::string format(const std::vector<std::string>& known) const;
  std::string one_of(const char* key, const std::vector<std::string>& known) const;
  Solver solver() const;

  /// "scene" is the text of a scene file, which messages call "file".
  std::string scene_name() const { return text("file", "scene"); }
  SceneFile scene(Strokes strokes = Strokes::first) const;
  VariedScene varied_scene() const;
  /// Of several pushers the one that "pusher" names.
  Index pusher(const SceneFile& file) const;

  [[noreturn]] void refuse(const char* key, const std::string& message) const;

private:
  std::string name_ = "request";
  JsonFields fields_{name_};
  JsonValue root_;
};

/// "full_text" is words as -v has them.
Telling told_as(const std::string& format);
/// Keys of a question about a scene, beside its `own`.
std::vector<std::string> scene_keys(std::vector<std::string> own);
/// Throws InputError if nothing moves.
void refuse_still(const Request& request, const SceneFile& file);
/// Throws InputError if the scene has more unknowns than `most`, whose `what`.
void refuse_unknowns(const Request& request, const SceneFile& file, Index most, const char* what);

} // namespace lcpush::desktop
