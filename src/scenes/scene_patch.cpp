#include "scenes/scene_tables.hpp"

#include "lcpush/mechanics/model/patch.hpp"
#include "scenes/exact_frame.hpp"
#include "scenes/object_surface.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <string>

namespace lcpush::desktop {
namespace {

constexpr Index default_line_points = 4, default_disc_points = 12, default_ring_points = 8;
// Points nearer than this, relative to the patch, are a slip, and make its equations singular.
constexpr double coincidence = 1e-9;
constexpr double shortest_direction = 1e-24;

/// The sentence that a report gives to something irrational.
std::string irrational(const TableReader& table, const std::string& what, bool is_plural) {
  return "the " + what + " of " + table.label() + (is_plural ? " are" : " is") + " irrational: " +
         (is_plural ? "fractions within 1e-12 of them are used"
                    : "a fraction within 1e-12 of it is used");
}

template <class S> ContactFrame<S> read_frame(const TableReader& table) {
  const Vector3<S> normal = table.vector3<S>("normal");
  const Vector3<double> rounded = as_doubles(normal);
  if (rounded.norm() < shortest_direction)
    table.fail("normal", "normal must not be zero; give the direction into the object");
  std::optional<Vector3<S>> direction;
  if (table.has("tangent")) {
    direction = table.vector3<S>("tangent");
    if (cross<double>(rounded.normalized(), as_doubles(*direction).normalized()).norm() <
        typing_slack)
      table.fail("tangent", "tangent must be neither zero nor parallel to the normal");
  }
  return contact_frame(normal, direction);
}

template <class S>
std::vector<Vector3<S>> read_vectors(const TableReader& table, const std::string& key, Index most) {
  std::vector<Vector3<S>> vectors;
  for (const std::vector<S>& row : table.rows<S>(key, 3, static_cast<std::size_t>(most)))
    vectors.push_back({row[0], row[1], row[2]});
  return vectors;
}

/// Makes room for `count` points.
template <class S> Span<Vector3<S>> resized(Patch<S>& patch, Index count) {
  patch.positions.resize(static_cast<std::size_t>(count));
  patch.weights.resize(static_cast<std::size_t>(count));
  return {patch.positions.data(), count};
}

template <class S> Span<S> weights_of(Patch<S>& patch) {
  return {patch.weights.data(), static_cast<Index>(patch.weights.size())};
}

Index point_count(const TableReader& table, Index smallest, Index otherwise) {
  return table.has("points") ? table.whole("points", smallest, limits::patch_points) : otherwise;
}

/// What is known beside the contact's own table.
template <class S> struct Placing {
  const ContactFrame<S>& frame;
  const ObjectBox<S>* box; ///< of the object; may be null
  double cut_beyond;       ///< m: more overhang does not belong to the patch
};

template <class S> void sample_point(const TableReader& table, const Placing<S>&, Patch<S>& patch) {
  resized(patch, 1)[0] = table.vector3<S>("center");
  equal_weights(weights_of(patch));
}

template <class S>
void sample_points(const TableReader& table, const Placing<S>&, Patch<S>& patch) {
  patch.positions = read_vectors<S>(table, "points", limits::patch_points);
  const std::size_t count = patch.positions.size();
  resized(patch, static_cast<Index>(count));
  if (!table.has("weights")) return equal_weights(weights_of(patch));
  patch.weights = table.numbers<S>("weights", {count}, Sign::positive);
  S sum(0);
  for (const S& weight : patch.weights) sum += weight;
  for (S& weight : patch.weights) weight /= sum;
}

/// The axis that the direction lies along, < 0 if none.
template <class S> Index axis_of(const Vector3<S>& direction) {
  for (Index k = 0; k < 3; ++k)
    if (as_doubles(direction).cwiseAbs()[k] == 1) return k;
  return -1;
}

/// Is the place, seen from the box' middle, on the face across `axis`?
template <class S> bool is_on_face(const ObjectBox<S>& box, const Vector3<S>& place, Index axis) {
  const double height = std::abs(as_double(place[axis])) - as_double(box.half[axis]);
  return std::abs(height) <= surface_slack * 2 * as_doubles(box.half).maxCoeff();
}

/// What of the line from a to b lies over the face.
template <class S>
void cut_line(const Placing<S>& placing, Patch<S>& patch, Vector3<S>& a, Vector3<S>& b) {
  const ObjectBox<S>& box = *placing.box;
  const Index across = axis_of(patch.normal);
  const Vector3<S> at = a - box.middle, d = b - a;
  if (across < 0 || !is_on_face<S>(box, at, across) || !is_on_face<S>(box, at + d, across)) return;
  S from(0), to(1);
  for (Index k = 0; k < 3; ++k) {
    if (k == across || d[k] == S(0)) continue;
    const S low = (-box.half[k] - at[k]) / d[k], high = (box.half[k] - at[k]) / d[k];
    from = std::max(from, std::min(low, high));
    to = std::min(to, std::max(low, high));
  }
  for (Index k = 0; k < 3; ++k)
    if (k != across && d[k] == S(0) && (at[k] > box.half[k] || at[k] < -box.half[k])) return;
  if (!(from < to)) return;
  patch.overhang = as_doubles(d).norm() * std::max(as_double(from), 1 - as_double(to));
  if (patch.overhang <= placing.cut_beyond) return;
  b = a + to * d;
  a += from * d;
}

/// What of the rectangle lies over the face, its sides along the box' edges.
template <class S>
void cut_rectangle(const Placing<S>& placing, Patch<S>& patch, Vector3<S>& center,
                   std::vector<S>& size) {
  const ObjectBox<S>& box = *placing.box;
  const Index across = axis_of(patch.normal), first = axis_of(patch.tangent);
  if (across < 0 || first < 0 || !is_on_face<S>(box, center - box.middle, across)) return;
  const Index axes[] = {first, 3 - across - first};
  S low[2], high[2];
  double overhang = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Index k = axes[i];
    const S from = center[k] - size[i] / S(2), to = center[k] + size[i] / S(2);
    low[i] = std::max(from, S(box.middle[k] - box.half[k]));
    high[i] = std::min(to, S(box.middle[k] + box.half[k]));
    if (!(low[i] < high[i])) return;
    overhang = std::max({overhang, as_double(S(low[i] - from)), as_double(S(to - high[i]))});
  }
  patch.overhang = overhang;
  for (std::size_t i = 0; overhang > placing.cut_beyond && i < 2; ++i) {
    center[axes[i]] = (low[i] + high[i]) / S(2);
    size[i] = high[i] - low[i];
  }
}

template <class S>
void sample_line_shape(const TableReader& table, const Placing<S>& placing, Patch<S>& patch) {
  std::vector<Vector3<S>> ends = read_vectors<S>(table, "ends", 2);
  if (ends.size() != 2) table.fail("ends", "ends must be a list of 2 points, got 1");
  if (placing.box != nullptr) cut_line(placing, patch, ends[0], ends[1]);
  sample_line<S>(ends[0], ends[1], resized(patch, point_count(table, 2, default_line_points)));
  line_weights(weights_of(patch));
  patch.shape = PatchShape::line;
}

template <class S, bool is_disc>
void sample_round_shape(const TableReader& table, const Placing<S>& placing, Patch<S>& patch) {
  const Vector3<S> center = table.vector3<S>("center");
  const S radius = table.number<S>("radius", Sign::positive);
  const Index count = is_disc ? point_count(table, 1, default_disc_points)
                              : point_count(table, 2, default_ring_points);
  if (!sample_round(is_disc, center, placing.frame, radius, resized(patch, count)))
    patch.inexact.push_back(irrational(table, "points", true));
  is_disc ? disc_weights(weights_of(patch)) : equal_weights(weights_of(patch));
  patch.shape = is_disc ? PatchShape::disc : PatchShape::ring;
}

template <class S>
void sample_rectangle_shape(const TableReader& table, const Placing<S>& placing, Patch<S>& patch) {
  Vector3<S> center = table.vector3<S>("center");
  const Vector3<S> t = patch.tangent;
  const Vector3<S> o = cross(patch.normal, t);
  std::vector<S> size = table.numbers<S>("size", {2}, Sign::positive);
  if (placing.box != nullptr) cut_rectangle(placing, patch, center, size);
  std::vector<Index> counts = {default_line_points, default_line_points};
  if (table.has("points")) counts = table.wholes("points", 2, 1, limits::patch_points);
  const Index count = counts[0] * counts[1];
  if (count > limits::patch_points)
    table.fail("points", "points must make at most " + std::to_string(limits::patch_points) +
                             " altogether, got " + std::to_string(count));
  sample_rectangle<S>(center, t, o, size[0], size[1], counts[0], counts[1], resized(patch, count));
  rectangle_weights(counts[0], counts[1], weights_of(patch));
  patch.shape = PatchShape::rectangle;
}

/// A shape of the scene file: the keys that it takes, and how its points are sampled.
template <class S> struct Shape {
  std::string name;
  std::vector<std::string> keys;
  void (*sample)(const TableReader& table, const Placing<S>& placing, Patch<S>& patch);
};

template <class S> const Shape<S>& read_shape(const TableReader& table) {
  static const std::vector<Shape<S>> shapes = {
      {"point", {"center"}, sample_point<S>},
      {"line", {"ends", "points"}, sample_line_shape<S>},
      {"disc", {"center", "radius", "points"}, sample_round_shape<S, true>},
      {"ring", {"center", "radius", "points"}, sample_round_shape<S, false>},
      {"rectangle", {"center", "size", "points"}, sample_rectangle_shape<S>},
      {"points", {"points", "weights"}, sample_points<S>},
  };
  std::vector<std::string> names;
  for (const Shape<S>& shape : shapes) names.push_back(shape.name);
  const Shape<S>& shape = shapes[table.choice("shape", names)];
  for (const char* key : {"center", "ends", "radius", "size", "points", "weights"})
    if (table.has(key) && std::find(shape.keys.begin(), shape.keys.end(), key) == shape.keys.end())
      table.fail(key, std::string(key) + " does not go with the shape " + quoted(shape.name) +
                          ", which takes " + listed(shape.keys, "and"));
  return shape;
}

template <class S>
void check_points(const TableReader& table, const std::string& key, const Patch<S>& patch) {
  std::vector<Vector3<double>> points;
  for (const Vector3<S>& p : patch.positions) points.push_back(as_doubles(p));
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

template <class S>
Patch<S> read_patch(const TableReader& table, const ObjectBox<S>* box, double cut_beyond) {
  for (const char* key : {"along", "length"})
    if (table.has(key))
      table.fail(key, std::string(key) + " goes with a face of the object; add on = \"-x\", say");
  const Shape<S>& shape = read_shape<S>(table);
  const ContactFrame<S> frame = read_frame<S>(table);
  Patch<S> patch{frame.normal, frame.tangent, {}, {}, {}, 0};
  if (!frame.normal_exact) patch.inexact.push_back(irrational(table, "normal", false));
  if (!frame.tangent_exact) patch.inexact.push_back(irrational(table, "tangent", false));
  shape.sample(table, {frame, box, cut_beyond}, patch);
  check_points(table, table.has("ends") ? "ends" : "points", patch);
  return patch;
}

template Patch<double> read_patch(const TableReader& table, const ObjectBox<double>* box,
                                  double cut_beyond);
template Patch<Rational> read_patch(const TableReader& table, const ObjectBox<Rational>* box,
                                    double cut_beyond);

} // namespace lcpush::desktop
