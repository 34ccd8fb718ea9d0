#include "scenes/scene_tables.hpp"

#include "scenes/exact_frame.hpp"

#include "lcpush/mechanics/model/contact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace lcpush::desktop {
namespace {

// Below this ratio of principal moments, rounding decides the sign of the smallest.
constexpr double thinnest = 1e-12;

template <class S>
Matrix3<S> box_inertia(const TableReader& table, const S& mass, ObjectShape& shape) {
  const Vector3<S> edges = table.vector3<S>("box", Sign::positive);
  const Vector3<S> squares = edges.array().square();
  const Vector3<S> moments = mass / S(12) * (squares.sum() - squares.array());
  shape = {ObjectShape::Kind::box, as_doubles(edges), 2};
  return moments.asDiagonal();
}

template <class S>
Matrix3<S> cylinder_inertia(const TableReader& table, const S& mass, ObjectShape& shape) {
  const S radius = table.number<S>("cylinder_radius", Sign::positive);
  const S length = table.number<S>("cylinder_length", Sign::positive);
  const auto axis =
      static_cast<Index>(table.has("axis") ? table.choice("axis", {"x", "y", "z"}) : 2);
  Vector3<S> moments;
  moments.setConstant(mass * (S(3) * radius * radius + length * length) / S(12));
  moments[axis] = mass * radius * radius / S(2);
  shape = {ObjectShape::Kind::cylinder, Vector3<double>::Constant(2 * as_double(radius)), axis};
  shape.size[axis] = as_double(length);
  return moments.asDiagonal();
}

template <class S>
Matrix3<S> ball_inertia(const TableReader& table, const S& mass, ObjectShape& shape) {
  const S radius = table.number<S>("sphere_radius", Sign::positive);
  shape = {ObjectShape::Kind::ball, Vector3<double>::Constant(2 * as_double(radius)), 2};
  const S moment = S(2) * mass * radius * radius / S(5);
  return Vector3<S>(moment, moment, moment).asDiagonal();
}

template <class S>
Matrix3<S> typed_inertia(const TableReader& table, const S& mass, ObjectShape& shape) {
  std::vector<S> entries = table.numbers<S>("inertia", {3, 6}, Sign::any);
  entries.resize(6, S(0));
  const S xx = entries[0], yy = entries[1], zz = entries[2];
  const S xy = entries[3], xz = entries[4], yz = entries[5];
  Matrix3<S> inertia;
  inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  // A box has I_x = m/12 (b^2 + c^2) and so on: a^2 = 6/m (I_y + I_z - I_x).
  const Vector3<double> moments = as_doubles<S>(inertia.diagonal());
  const Eigen::Array3d squares = 6 / as_double(mass) * (moments.sum() - 2 * moments.array());
  shape = {ObjectShape::Kind::unknown, squares.max(0).sqrt().matrix(), 2};
  return inertia;
}

/// The eigenvalues, the smallest first: the roots of the characteristic polynomial as cosines.
Vector3<double> principal_moments(const Matrix3<double>& inertia) {
  const double middle = inertia.trace() / 3;
  const Matrix3<double> off = inertia - middle * Matrix3<double>::Identity();
  const double spread = std::sqrt(off.squaredNorm() / 6);
  if (!(spread > 0)) return Vector3<double>::Constant(middle);
  const double third_turn = std::acos(-0.5);
  const double cosine =
      off.col(0).dot(cross<double>(off.col(1), off.col(2))) / (2 * spread * spread * spread);
  const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) / 3;
  const double least = middle + 2 * spread * std::cos(angle + third_turn);
  const double most = middle + 2 * spread * std::cos(angle);
  return {least, inertia.trace() - least - most, most};
}

void check_inertia(const TableReader& table, const std::string& key,
                   const Matrix3<double>& inertia) {
  const double scale = inertia.cwiseAbs().maxCoeff();
  if (!(scale > 0)) table.fail(key, key + " gives no inertia; check its units (SI)");
  const Vector3<double> moments = principal_moments(inertia / scale);
  if (!(moments[0] > thinnest * moments[2]) && key != "inertia")
    table.fail(key, key + " gives an object far too thin for its length; check its units (SI)");
  if (!(moments[0] > thinnest * moments[2]))
    table.fail(key, key + " must be positive definite; check its signs and order "
                          "(xx, yy, zz, xy, xz, yz)");
  if (moments[0] + moments[1] < moments[2] * (1 - typing_slack))
    table.fail(key, key + " belongs to no solid body: the largest principal moment exceeds the sum "
                          "of the other two; check its units and order (xx, yy, zz, xy, xz, yz)");
}

/// The key that says how the mass is spread: exactly one of them.
std::string shape_key(const TableReader& table) {
  const std::string choices =
      "box, cylinder_radius with cylinder_length, sphere_radius, or inertia";
  std::string found;
  for (const char* key : {"box", "cylinder_radius", "sphere_radius", "inertia"}) {
    if (!table.has(key)) continue;
    if (!found.empty()) table.fail(key, found + " is given already; keep one of " + choices);
    found = key;
  }
  if (found.empty() && table.has("cylinder_length")) found = "cylinder_radius";
  if (found.empty()) table.fail("", "missing the shape of the object; add one of " + choices);
  for (const char* key : {"cylinder_length", "axis"})
    if (found != "cylinder_radius" && table.has(key))
      table.fail(key, std::string(key) + " goes with cylinder_radius only; remove it");
  return found;
}

/// What is applied beside the weight: a force `at` a point (the centre of mass without a word) and
/// a moment, as a wrench at the centre of mass.
template <class S>
Vector6<S> applied_wrench(const TableReader& table, const Vector3<S>& center_of_mass) {
  Vector3<S> force = Vector3<S>::Zero(), moment = force;
  if (table.has("force")) force = table.vector3<S>("force");
  if (table.has("moment")) moment = table.vector3<S>("moment");
  if (table.has("at")) {
    if (!table.has("force")) table.fail("at", "at is where a force acts; add force or remove at");
    moment += cross<S>(table.vector3<S>("at") - center_of_mass, force);
  }
  Vector6<S> wrench;
  wrench << force, moment;
  return wrench;
}

} // namespace

template <class S> Object<S> read_object(const TableReader& table, ObjectShape& shape) {
  Object<S> object;
  object.mass = table.number<S>("mass", Sign::positive);
  const std::string key = shape_key(table);
  if (key == "box") {
    object.inertia = box_inertia(table, object.mass, shape);
  } else if (key == "sphere_radius") {
    object.inertia = ball_inertia(table, object.mass, shape);
  } else if (key == "inertia") {
    object.inertia = typed_inertia(table, object.mass, shape);
  } else {
    object.inertia = cylinder_inertia(table, object.mass, shape);
  }
  Matrix3<double> rounded;
  for (Index i = 0; i < 3; ++i) rounded.col(i) = as_doubles<S>(object.inertia.col(i));
  check_inertia(table, key, rounded);
  object.center_of_mass.setZero();
  if (table.has("center_of_mass")) object.center_of_mass = table.vector3<S>("center_of_mass");
  object.wrench = applied_wrench(table, object.center_of_mass);
  return object;
}

template Object<double> read_object(const TableReader& table, ObjectShape& shape);
template Object<Rational> read_object(const TableReader& table, ObjectShape& shape);

} // namespace lcpush::desktop
