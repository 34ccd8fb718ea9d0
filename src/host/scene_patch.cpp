#include "scene_patch.hpp"

#include "lcpush/mechanics/contact_frame.hpp"
#include "lcpush/mechanics/patch.hpp"
#include "message.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace lcpush::host {
namespace {

constexpr Index most_points = 10000;
constexpr Index default_round_points = 8;
// Points nearer than this, relative to the patch, are a slip, and make its equations singular.
constexpr double coincidence = 1e-9;
// Typed with three or four digits, a point of the contact plane may miss it by so much.
constexpr double typing_slack = 1e-3;
constexpr double shortest_direction = 1e-24;

struct Shape {
  std::string name;
  std::vector<std::string> keys;
};

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> list = {
      {"point", {"center"}},
      {"line", {"ends", "points"}},
      {"disc", {"center", "radius", "points"}},
      {"ring", {"center", "radius", "points"}},
      {"rectangle", {"center", "size", "points"}},
      {"points", {"points"}},
  };
  return list;
}

const Shape& read_shape(const TableReader& table) {
  std::vector<std::string> names;
  for (const Shape& shape : shapes()) names.push_back(shape.name);
  const Shape& shape = shapes()[table.choice("shape", names)];
  for (const char* key : {"center", "ends", "radius", "size", "points"})
    if (table.has(key) && std::find(shape.keys.begin(), shape.keys.end(), key) == shape.keys.end())
      table.fail(key, std::string(key) + " does not go with the shape " + quoted(shape.name) +
                          ", which takes " + listed(shape.keys, "and"));
  return shape;
}

void read_frame(const TableReader& table, Patch& patch) {
  const Vector3<double> normal = table.vector3("normal");
  if (normal.norm() < shortest_direction)
    table.fail("normal", "normal must not be zero; give the direction into the object");
  patch.normal = normal.normalized();
  patch.tangent = default_tangent(patch.normal);
  if (!table.has("tangent")) return;
  const Vector3<double> direction = table.vector3("tangent").normalized();
  if (cross(patch.normal, direction).norm() < typing_slack)
    table.fail("tangent", "tangent must be neither zero nor parallel to the normal");
  patch.tangent = tangent_along(patch.normal, direction);
}

std::vector<Vector3<double>> read_vectors(const TableReader& table, const std::string& key,
                                          Index most) {
  std::vector<Vector3<double>> vectors;
  for (const std::vector<double>& row : table.rows(key, 3, static_cast<std::size_t>(most)))
    vectors.push_back({row[0], row[1], row[2]});
  return vectors;
}

/// Makes room for `count` points.
Span<Vector3<double>> resized(Patch& patch, Index count) {
  patch.positions.resize(static_cast<std::size_t>(count));
  return {patch.positions.data(), count};
}

Index point_count(const TableReader& table, Index smallest, Index otherwise) {
  return table.has("points") ? table.whole("points", smallest, most_points) : otherwise;
}

void sample_line_shape(const TableReader& table, Patch& patch) {
  const std::vector<Vector3<double>> ends = read_vectors(table, "ends", 2);
  if (ends.size() != 2) table.fail("ends", "ends must be a list of 2 points, got 1");
  sample_line(ends[0], ends[1], resized(patch, point_count(table, 2, 2)));
}

void sample_round_shape(const TableReader& table, bool is_disc, Patch& patch) {
  const Vector3<double> center = table.vector3("center"), t = patch.tangent;
  const Vector3<double> o = cross(patch.normal, t);
  const double radius = table.number("radius", Sign::positive);
  const Index count = point_count(table, is_disc ? 1 : 2, default_round_points);
  const auto sample = is_disc ? sample_disc<double> : sample_ring<double>;
  sample(center, t, o, radius, resized(patch, count));
}

void sample_rectangle_shape(const TableReader& table, Patch& patch) {
  const Vector3<double> center = table.vector3("center"), t = patch.tangent;
  const Vector3<double> o = cross(patch.normal, t);
  const std::vector<double> size = table.numbers("size", {2}, Sign::positive);
  std::vector<Index> counts = {2, 2};
  if (table.has("points")) counts = table.wholes("points", 2, 1, most_points);
  const Index count = counts[0] * counts[1];
  if (count > most_points)
    table.fail("points", "points must make at most " + std::to_string(most_points) +
                             " altogether, got " + std::to_string(count));
  sample_rectangle(center, t, o, size[0], size[1], counts[0], counts[1], resized(patch, count));
}

void sample_shape(const TableReader& table, const std::string& shape, Patch& patch) {
  if (shape == "point") {
    patch.positions = {table.vector3("center")};
  } else if (shape == "line") {
    sample_line_shape(table, patch);
  } else if (shape == "rectangle") {
    sample_rectangle_shape(table, patch);
  } else if (shape == "points") {
    patch.positions = read_vectors(table, "points", most_points);
  } else {
    sample_round_shape(table, shape == "disc", patch);
  }
}

void check_points(const TableReader& table, const std::string& key, const Patch& patch) {
  const std::vector<Vector3<double>>& points = patch.positions;
  double size = 0;
  for (const Vector3<double>& p : points) size = std::max(size, (p - points[0]).norm());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    for (std::size_t j = 0; j < i; ++j)
      if ((points[i] - points[j]).norm() <= coincidence * size)
        table.fail(key, "points " + std::to_string(j + 1) + " and " + number +
                            " coincide; move them apart or remove one");
  }
}

} // namespace

const Schema& patch_schema() {
  static const Schema schema = {
      {"shape", "shape = \"disc\""},
      {"center", "center = [0, 0, 0.005]  # m"},
      {"ends", "ends = [[-0.05, -0.015, 0], [-0.05, 0.015, 0]]  # m"},
      {"radius", "radius = 0.005  # m"},
      {"size", "size = [0.01, 0.02]  # m"},
      {"points", "points = [[0, 0, 0], [0.01, 0, 0]]  # m"},
      {"normal", "normal = [0, 0, -1]"},
      {"tangent", "tangent = [1, 0, 0]"},
  };
  return schema;
}

Patch read_patch(const TableReader& table) {
  const Shape& shape = read_shape(table);
  Patch patch;
  read_frame(table, patch);
  sample_shape(table, shape.name, patch);
  check_points(table, shape.name == "line" ? "ends" : "points", patch);
  return patch;
}

} // namespace lcpush::host
