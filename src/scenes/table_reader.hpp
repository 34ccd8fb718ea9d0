// One TOML table of a scene file: typed, checked access to its keys.
#pragma once

#include "lcpush/desktop/rational.hpp"
#include "lcpush/types.hpp"
#include "scenes/scene_schema.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

/// What is typed with three or four digits may miss by so much what it has to satisfy: a thin plate
/// I_z = I_x + I_y, a patch's points their plane.
constexpr double typing_slack = 1e-3;

/// Numbers beyond 1e12, and positive ones below 1e-24, are refused as slips of the unit.
enum class Sign { any, not_negative, positive };

/// `finger "left"`, or `finger 2` while it has no usable name: how messages call a table.
std::string table_label(const TomlSection& section, std::size_t index);
/// "entry 2 of points", from 1.
std::string entry_of(const std::string& what, std::size_t index);

/// As if it were typed.
TomlValue typed_vector(int line, const Vector3<Rational>& vector);

/// Every reading function throws InputError, with file, line and the table's label, if the key is
/// missing or its value is of another type, length or range. Optional keys: ask has() first.
/// Numbers come as S = double, or as S = Rational exactly as typed; both pass the same checks.
class TableReader {
public:
  /// Refuses keys that `schema` does not list. `label` starts every message, e.g. `finger "left"`;
  /// it may be empty. `file`, `table` and `schema` must outlive the reader.
  TableReader(const std::string& file, const TomlTable& table, std::string label,
              const Schema& schema);

  bool has(const std::string& key) const { return table_.find(key) != nullptr; }
  int line() const { return table_.line; }
  /// Of the first of these keys that the table has, else its own.
  int line_of(const std::vector<std::string>& keys) const;
  const std::string& label() const { return label_; }

  /// Is it there, and a text?
  bool is_text(const std::string& key) const;
  /// Is it there, with a number that no decimals say, such as one of degrees?
  bool is_irrational(const std::string& key) const;
  bool boolean(const std::string& key) const;
  /// Neither empty nor with control characters, so that every report can print it.
  std::string text(const std::string& key) const;
  /// The index of the text among `choices`.
  std::size_t choice(const std::string& key, const std::vector<std::string>& choices) const;
  template <class S> S number(const std::string& key, Sign sign) const {
    return as_number<S>(key, require(key), sign);
  }
  Index whole(const std::string& key, Index smallest, Index largest) const;
  /// A list whose length is one of `lengths`.
  template <class S>
  std::vector<S> numbers(const std::string& key, const std::vector<std::size_t>& lengths,
                         Sign sign) const {
    return as_numbers<S>(key, require(key), lengths, sign);
  }
  template <class S> Vector3<S> vector3(const std::string& key, Sign sign = Sign::any) const {
    const std::vector<S> list = numbers<S>(key, {3}, sign);
    return {list[0], list[1], list[2]};
  }
  /// A list of one to `most` texts.
  std::vector<std::string> texts(const std::string& key, std::size_t most) const;
  /// A list of one to `most` lists of `width` numbers each.
  template <class S>
  std::vector<std::vector<S>> rows(const std::string& key, std::size_t width,
                                   std::size_t most) const {
    std::vector<std::vector<S>> result;
    for (const TomlValue& element : list(key, most))
      result.push_back(as_numbers<S>(entry_of(key, result.size()), element, {width}, Sign::any));
    return result;
  }
  /// A list of `size` whole numbers within the range.
  std::vector<Index> wholes(const std::string& key, std::size_t size, Index smallest,
                            Index largest) const;

  /// Throws; the line is the key's if the table has it, else the table's.
  [[noreturn]] void fail(const std::string& key, const std::string& message) const;
  [[noreturn]] void fail_at(int line, const std::string& message) const;

private:
  const TomlValue& require(const std::string& key) const;
  void refuse_unknown_keys() const;
  const TomlArray& list(const std::string& key, std::size_t most) const;
  const TomlArray& as_list(const std::string& what, const TomlValue& value,
                           const std::vector<std::size_t>& lengths) const;
  std::string as_text(const std::string& what, const TomlValue& value) const;
  double checked_number(const std::string& what, const TomlValue& value, Sign sign) const;
  template <class S> S as_number(const std::string& what, const TomlValue& value, Sign sign) const;
  Index as_whole(const std::string& what, const TomlValue& value, Index smallest,
                 Index largest) const;
  template <class S>
  std::vector<S> as_numbers(const std::string& what, const TomlValue& value,
                            const std::vector<std::size_t>& lengths, Sign sign) const {
    std::vector<S> result;
    for (const TomlValue& element : as_list(what, value, lengths))
      result.push_back(as_number<S>(entry_of(what, result.size()), element, sign));
    return result;
  }

  const std::string& file_;
  const TomlTable& table_;
  std::string label_;
  const Schema& schema_;
};

} // namespace lcpush::desktop
