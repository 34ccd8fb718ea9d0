#include "scenes/table_changes.hpp"

#include <cmath>
#include <tuple>
#include <utility>

#include "lcpush/mechanics/model/contact.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// A fraction that no decimals say stays one.
std::string decimals(const Rational& number) {
  constexpr int most = 400;
  Rational whole = number;
  for (int k = 0; k < most; ++k, whole = whole * Rational(10))
    if (whole.is_whole()) return whole.text() + "e-" + std::to_string(k);
  return number.text();
}

/// Cosine and sine; of multiples of 90 degrees exactly.
std::pair<double, double> circle_point(double degrees) {
  const double quarters = std::floor(degrees / 90 + 0.5), rest = degrees - 90 * quarters;
  const double radians = rest * (std::acos(-1.0) / 180);
  double c = std::cos(radians), s = std::sin(radians);
  for (int k = static_cast<int>(std::fmod(std::fmod(quarters, 4) + 4, 4)); k > 0; --k)
    std::tie(c, s) = std::pair(-s, c);
  return {c, s};
}

Vector3<double> vector_in(const TomlValue& value) {
  const auto& list = std::get<TomlArray>(value.data);
  return {*list[0].number(), *list[1].number(), *list[2].number()};
}

void set_vector(TomlValue& value, const Vector3<double>& vector) {
  value.data = TomlArray(3, TomlValue{value.line, 0.0, "0"});
  for (std::size_t i = 0; i < 3; ++i)
    set_number(std::get<TomlArray>(value.data)[i], vector[static_cast<Index>(i)]);
}

} // namespace

void set_number(TomlValue& value, double number) {
  value.data = number;
  value.digits = shown(number);
  value.range.clear();
}

void set_number(TomlValue& value, const Rational& number) {
  set_number(value, number.value());
  if (Rational::parse(value.digits) != number) value.digits = decimals(number);
}

void set_count(TomlValue& value, double number) {
  set_number(value, number);
  constexpr double largest = 1e15;
  if (number == std::floor(number) && std::abs(number) < largest)
    value.data = static_cast<std::int64_t>(number);
}

bool is_count(const TomlEntry& entry) {
  if (entry.key == "facets") return true;
  if (entry.key != "points") return false;
  const auto* const list = std::get_if<TomlArray>(&entry.value.data);
  return list == nullptr || list->empty() || !std::holds_alternative<TomlArray>(list->front().data);
}

void turn_motion(TomlTable& table, double degrees) {
  TomlValue* const velocity = table.find("velocity");
  TomlValue& value = velocity != nullptr ? *velocity : *table.find("acceleration");
  const Vector3<double> v = vector_in(value);
  const auto [c, s] = circle_point(degrees);
  set_vector(value, {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]});
}

void turn_tangent(TomlTable& table, double degrees) {
  const Vector3<double> along = vector_in(*table.find("normal"));
  if (!(along.norm() > 0)) return; // the builder refuses it
  const Vector3<double> n = along.normalized();
  TomlValue* tangent = table.find("tangent");
  const Vector3<double> t =
      tangent != nullptr ? tangent_along<double>(n, vector_in(*tangent)) : default_tangent(n);
  const auto [c, s] = circle_point(degrees);
  const Vector3<double> turned = c * t + s * cross<double>(n, t);
  if (tangent == nullptr) {
    table.entries.push_back({"tangent", {table.line, TomlArray{}, ""}});
    tangent = &table.entries.back().value;
  }
  set_vector(*tangent, turned);
}

} // namespace lcpush::desktop
