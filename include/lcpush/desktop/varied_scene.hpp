// lcpush: a scene file whose numbers can be given other values.
#pragma once

#include "lcpush/desktop/scene_io.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lcpush::desktop {

struct TomlDocument;
struct TomlValue;

/// A number of the file, or of several bodies at once, or a motion of a body. Made by
/// VariedScene::find.
struct Parameter {
  enum class Kind {
    number,       ///< takes the parameter's value
    turn,         ///< a pusher's acceleration turns by the value in the x-y plane
    tangent_turn, ///< a body's friction generators turn by the value about its normal
  };
  /// Where in the document: the keys above the first header (section -1), or a section's table.
  struct Place {
    int section, table;
    std::string key;
    std::vector<std::size_t> indices;
  };
  std::string path; ///< as typed
  Kind kind = Kind::number;
  std::vector<Place> places;          ///< of a turn: its table alone
  Index axis = 0;                     ///< of an offset in a face 1 + what it lies along
  std::string unit;                   ///< "N", "m/s^2", "" (a pure number), ..
  bool linear = false;                ///< enters the right-hand side alone, and linearly
  bool whole = false;                 ///< counts something: whole numbers alone
  double value = 0;                   ///< in the file; of a turn 0
  std::string typed = {};             ///< the same as digits; empty for a turn
  std::vector<std::string> ends = {}; ///< of a range, of which it is the middle, as typed
  std::string label = {};             ///< of an axis of a plot; empty: words for the path
  std::string typed_unit = {};        ///< in which its values are told; empty: `unit`
  double typed_size = 1;              ///< of that unit, in `unit`
  std::string owner = {}; ///< whose number: "left", "object", "*" of all bodies; or empty
};

/// The scene's text with these values in it, "wall.friction=0.4", one after the other; its title
/// says so. Other lines stay where they are, if there is a blank line below a table that gets a new
/// key. Throws InputError, which begins with `label` and the words that were given.
std::string with_values(std::string text, const std::string& file, const std::string& label,
                        const std::vector<std::string>& given);

/// Cheap to copy: copies share the document, which never changes.
class VariedScene {
public:
  /// Throws InputError as read_scene does.
  static VariedScene read(const std::string& path);
  static VariedScene parse(std::string_view text, const std::string& file_name);

  /// Another pressure law ("pad", "even" or "rigid") than the file's. Throws InputError.
  void set_pressure(const std::string& law);
  /// Other friction than the file's: pyramids of so many facets, or none: round.
  void set_facets(std::optional<Index> facets);
  void set_planar();

  /// The parameter called `path`: `left.friction`, `*.grip_force` (of every body that has one),
  /// `object.mass`, `gravity[1]`, `wall.ends[0][1]`, `facets`, `wall.shift[1]` (m), `wall.turn`
  /// (degrees), `*.tangent_turn` (degrees, about each body's own normal).
  /// Throws InputError with what is possible if there is none.
  Parameter find(const std::string& path) const;

  /// Every path that find() knows, in the file's order.
  std::vector<std::string> paths() const;

  /// The scene with these parameters at these values, in this order. Throws InputError if that is
  /// no scene.
  SceneFile at(const std::vector<Parameter>& parameters, const std::vector<double>& values) const;
  SceneFile as_given() const { return at({}, {}); }
  /// Pre: numbers alone.
  SceneOf<Rational> exactly_at(const std::vector<Parameter>& parameters,
                               const std::vector<Rational>& values) const;
  /// As a file's text. Pre: numbers alone.
  std::string text_at(const std::vector<Parameter>& parameters,
                      const std::vector<Rational>& values) const;
  /// Every number that has a range, one by one; and those that a path names.
  std::vector<Parameter> ranges() const;
  std::vector<Parameter> singles(const std::string& path) const;
  /// The same scene with these numbers in ranges. Throws InputError if that is no scene.
  VariedScene with_ranges(const std::vector<Parameter>& parameters,
                          const std::vector<std::pair<Rational, Rational>>& ends) const;
  /// The same scene with these numbers changed for good. Throws InputError if that is no scene.
  VariedScene with(const std::vector<Parameter>& parameters,
                   const std::vector<double>& values) const;
  /// The same scene without its other pushers. Before find(), whose parameters are places in it.
  VariedScene with_only_pusher(const std::string& name) const;

private:
  std::shared_ptr<const TomlDocument> document_; // with what a file may leave out
  Hand hand_; // as typed: no change of a number turns one hand into another

  explicit VariedScene(TomlDocument document);
  VariedScene with_document(TomlDocument document) const;
  void set(const std::string& key, const TomlValue& given);
};

} // namespace lcpush::desktop
