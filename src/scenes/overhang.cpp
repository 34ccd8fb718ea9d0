#include "scenes/overhang.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "lcpush/desktop/scene_check.hpp"
#include "lcpush/mechanics/model/patch.hpp"
#include "scenes/object_surface.hpp"
#include "scenes/scene_tables.hpp"
#include "scenes/table_changes.hpp"
#include "scenes/table_reader.hpp"
#include "scenes/unit_doubts.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace lcpush::desktop {
namespace {

/// A face ends at `low` and `high` along the unit vector `axis`; a curved side, which is touched in
/// its middle alone, has no width.
struct Range {
  Vector3<double> axis;
  double low, high; ///< m, in the scene's frame
};

struct Points {
  std::vector<Vector3<double>> positions;
  std::vector<double> weights;
};

class PatchCutter {
public:
  PatchCutter(const SceneFile& file, std::size_t b)
      : file_(file), body_(file.bodies[b]), slack_(typing_slack * size()) {
    const auto first = file.positions.begin() + body_.first_point;
    points_.positions.assign(first, first + body_.point_count);
    const auto weight = file.weights.begin() + body_.first_point;
    points_.weights.assign(weight, weight + body_.point_count);
    if (!find_face()) return;
    for (const Vector3<double>& p : points_.positions)
      overhang_ = std::max(overhang_, (p - clamped(p)).norm());
  }

  /// m; 0 where the patch lies within its face, or on no face at all.
  double overhang() const { return overhang_ > slack_ && is_on_surface() ? overhang_ : 0; }

  /// Pre: overhang() > 0. Empty: nothing touches.
  Points cut(const std::string& shape, Index first_count) const {
    const Vector3<double>&a = points_.positions.front(), &z = points_.positions.back();
    if (shape == "line") return cut_line(a, z);
    const Vector3<double> o = cross(body_.normal, body_.tangent);
    const bool is_area = shape == "rectangle" || shape == "disc";
    if (is_area && radius_ > 0 && covers(shape, a, z)) return sampled_end();
    if (is_area && ranges_.size() == 2 && covers(shape, a, z))
      return sampled(ranges_[0], ranges_[1], default_line_points, default_line_points);
    if (shape == "rectangle" && radius_ == 0)
      if (const auto both = aligned_ranges(a, z, o))
        return sampled(both->first, both->second, first_count, body_.point_count / first_count);
    return remaining();
  }

private:
  double size() const { return file_.shape.size.maxCoeff(); }
  const Vector3<double>& middle() const { return file_.object.center_of_mass; }

  void add_range(const Vector3<double>& axis, double width) {
    const double at = axis.dot(middle());
    ranges_.push_back({axis, at - width / 2, at + width / 2});
  }

  /// The face that the normal points into, by where it ends.
  bool find_face() {
    const ObjectShape& shape = file_.shape;
    const Vector3<double>& n = body_.normal;
    const auto lies_along = [&](Index i) { return std::abs(n[i]) < least_into; };
    if (shape.kind == ObjectShape::Kind::box) {
      for (Index i = 0; i < 3; ++i)
        if (lies_along(i)) add_range(Vector3<double>::Unit(i), shape.size[i]);
      return true;
    }
    const bool is_ball = shape.kind == ObjectShape::Kind::ball;
    if (!is_ball && std::abs(n[shape.axis]) > 1 - typing_slack) {
      radius_ = shape.size[(shape.axis + 1) % 3] / 2;
      return true;
    }
    if (!is_ball && !lies_along(shape.axis)) return false; // on the rim
    const Vector3<double> along =
        is_ball ? body_.tangent : Vector3<double>(Vector3<double>::Unit(shape.axis));
    if (!is_ball) add_range(along, shape.size[shape.axis]);
    if (is_on_surface()) return true; // a pad bends so far
    if (is_ball) add_range(along, 0);
    add_range(cross(along, n), 0);
    return true;
  }

  Vector3<double> clamped(Vector3<double> p) const {
    for (const Range& range : ranges_)
      p += (std::clamp(range.axis.dot(p), range.low, range.high) - range.axis.dot(p)) * range.axis;
    if (radius_ == 0) return p;
    Vector3<double> out = p - middle();
    out[file_.shape.axis] = 0;
    return out.norm() <= radius_ ? p : Vector3<double>(p - out * (1 - radius_ / out.norm()));
  }

  /// Does what of the patch lies over the face touch it?
  bool is_on_surface() const {
    if (file_.planar && std::abs(body_.normal[2]) > 0.5) return true; // at whatever height
    return std::all_of(points_.positions.begin(), points_.positions.end(), [&](const auto& p) {
      return lies_on_surface(file_, nearest_on_surface(file_, clamped(p), 0).distance);
    });
  }

  bool is_within(const Vector3<double>& p) const { return (p - clamped(p)).norm() <= slack_; }

  Points cut_line(const Vector3<double>& a, const Vector3<double>& z) const {
    const Vector3<double> d = z - a;
    double from = 0, to = 1;
    const auto keep = [&](double first, double last) {
      from = std::max(from, std::min(first, last));
      to = std::min(to, std::max(first, last));
    };
    for (const Range& range : ranges_) {
      const double at = range.axis.dot(a), by = range.axis.dot(d);
      if (std::abs(by) > slack_) keep((range.low - at) / by, (range.high - at) / by);
    }
    if (radius_ > 0) {
      Vector3<double> across = d, out = a - middle();
      across[file_.shape.axis] = out[file_.shape.axis] = 0;
      const double dd = across.squaredNorm(), half = across.dot(out) / dd;
      const double root = half * half - (out.squaredNorm() - radius_ * radius_) / dd;
      if (!(root > 0)) return {};
      keep(-half - std::sqrt(root), -half + std::sqrt(root));
    }
    if (to < from || !is_within(a + from * d)) return {};
    Points points = sized((to - from) * d.norm() > slack_ ? body_.point_count : 1);
    sample_line<double>(a + from * d, a + to * d, span(points.positions));
    line_weights(span(points.weights));
    return points;
  }

  /// Is the whole face under the patch, whose outermost points are `a` and `z`?
  bool covers(const std::string& shape, const Vector3<double>& a, const Vector3<double>& z) const {
    Vector3<double> center = Vector3<double>::Zero();
    for (std::size_t i = 0; i < points_.positions.size(); ++i)
      center += points_.weights[i] * points_.positions[i];
    const Vector3<double> o = cross(body_.normal, body_.tangent);
    const auto is_under = [&](const Vector3<double>& p, double reach) {
      const double t = std::abs(body_.tangent.dot(p - center)), u = std::abs(o.dot(p - center));
      return shape == "disc" ? std::hypot(t, u) + reach <= (z - center).norm() + slack_
                             : t + reach <= std::abs(body_.tangent.dot(z - a)) / 2 + slack_ &&
                                   u + reach <= std::abs(o.dot(z - a)) / 2 + slack_;
    };
    if (radius_ > 0) return is_under(middle(), radius_);
    for (const double s : {ranges_[0].low, ranges_[0].high})
      for (const double t : {ranges_[1].low, ranges_[1].high})
        if (!is_under(s * ranges_[0].axis + t * ranges_[1].axis, 0)) return false;
    return true;
  }

  /// The rectangle from `a` to `z` where its sides lie along the face's: what is common to both.
  std::optional<std::pair<Range, Range>> aligned_ranges(const Vector3<double>& a,
                                                        const Vector3<double>& z,
                                                        const Vector3<double>& o) const {
    std::pair<Range, Range> both{{body_.tangent, 0, 0}, {o, 0, 0}};
    for (Range* range : {&both.first, &both.second})
      std::tie(range->low, range->high) = std::minmax({range->axis.dot(a), range->axis.dot(z)});
    for (const Range& face : ranges_) {
      const double along = face.axis.dot(body_.tangent);
      if (std::abs(along) > typing_slack && std::abs(along) < 1 - typing_slack) return {};
      Range& range = std::abs(along) > 0.5 ? both.first : both.second;
      const double sign = face.axis.dot(range.axis) > 0 ? 1 : -1;
      range.low = std::max(range.low, std::min(sign * face.low, sign * face.high));
      range.high = std::min(range.high, std::max(sign * face.low, sign * face.high));
    }
    return both;
  }

  /// A rectangle in the patch's plane.
  Points sampled(const Range& s, const Range& t, Index count_s, Index count_t) const {
    const double width = s.high - s.low, height = t.high - t.low;
    if (width < -slack_ || height < -slack_) return {};
    if (width < slack_) count_s = 1;
    if (height < slack_) count_t = 1;
    Points points = sized(count_s * count_t);
    const Vector3<double>& n = body_.normal;
    const Vector3<double> center = (s.low + s.high) / 2 * s.axis + (t.low + t.high) / 2 * t.axis +
                                   n.dot(points_.positions.front()) * n;
    sample_rectangle<double>(center, s.axis, t.axis, width, height, count_s, count_t,
                             span(points.positions));
    rectangle_weights(count_s, count_t, span(points.weights));
    return points;
  }

  Points sampled_end() const {
    Points points = sized(default_disc_points);
    const Vector3<double>& n = body_.normal;
    sample_disc<double>(middle() + n.dot(points_.positions.front() - middle()) * n, body_.tangent,
                        cross(n, body_.tangent), radius_, span(points.positions));
    disc_weights(span(points.weights));
    return points;
  }

  /// Those of its points that touch.
  Points remaining() const {
    Points points;
    for (std::size_t i = 0; i < points_.positions.size(); ++i) {
      if (!is_within(points_.positions[i])) continue;
      points.positions.push_back(points_.positions[i]);
      points.weights.push_back(points_.weights[i]);
    }
    return points;
  }

  static Points sized(Index count) {
    const auto n = static_cast<std::size_t>(count);
    return {std::vector<Vector3<double>>(n), std::vector<double>(n)};
  }
  template <class T> static Span<T> span(std::vector<T>& list) {
    return {list.data(), static_cast<Index>(list.size())};
  }

  const SceneFile& file_;
  const Body<double>& body_;
  const double slack_;
  Points points_; ///< as given
  std::vector<Range> ranges_;
  double radius_ = 0; ///< of a cylinder's end, m
  double overhang_ = 0;
};

void list_points(TomlTable& table, const Points& points) {
  const auto is_place = [](const TomlEntry& entry) {
    return std::string("center ends radius size points weights").find(entry.key) !=
           std::string::npos;
  };
  const int line = std::find_if(table.entries.begin(), table.entries.end(), is_place)->value.line;
  table.entries.erase(std::remove_if(table.entries.begin(), table.entries.end(), is_place),
                      table.entries.end());
  const auto number = [&](double x) {
    TomlValue value{line, x, {}};
    set_number(value, x);
    return value;
  };
  TomlArray places, weights;
  for (const Vector3<double>& p : points.positions)
    places.push_back({line, TomlArray{number(p[0]), number(p[1]), number(p[2])}});
  for (const double w : points.weights) weights.push_back(number(w));
  table.entries.push_back({"points", {line, places}});
  table.entries.push_back({"weights", {line, weights}});
  table.find("shape")->data = std::string("points");
}

/// Where the file says what the body is.
TomlTable& table_of(TomlDocument& document, const std::string& name) {
  for (TomlSection& section : document.sections)
    for (TomlTable& table : section.tables)
      if ((section.name == "finger" || section.name == "pusher") && *table.name() == name)
        return table;
  return document.root;
}

/// Along the patch's tangent, of a rectangle.
Index first_count(const TomlTable& table, Index otherwise) {
  const TomlValue* const points = table.find("points");
  return points == nullptr ? otherwise
                           : static_cast<Index>(*std::get<TomlArray>(points->data)[0].number());
}

[[noreturn]] void refuse(const SceneFile& file, std::size_t b) {
  const Vector3<double>& p = file.positions[static_cast<std::size_t>(file.bodies[b].first_point)];
  throw InputError(file.lines.file, file.lines.bodies[b].place,
                   body_label(file, b) + "it lies beside " + shape_name(file) +
                       " and touches nothing; the surface point nearest to its first is " +
                       typed_vector(nearest_on_surface(file, p, 0).at) +
                       ". Move it there, or give inertia instead if the object has another shape");
}

} // namespace

std::optional<CutScene> cut_overhang(const TomlDocument& document, const SceneFile& file) {
  if (file.shape.kind == ObjectShape::Kind::unknown || !file.faces.empty() || is_particle(file))
    return {};
  CutScene cut{document, {}};
  std::vector<std::size_t> reaching;
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    // A later stroke comes to an object that has moved; a point has nothing to cut.
    if (file.strokes[b].from > 0 || file.bodies[b].point_count == 1) continue;
    const double overhang = PatchCutter(file, b).overhang();
    if (!(overhang > 0)) continue;
    cut.overhang[file.body_names[b]] = overhang;
    reaching.push_back(b);
  }
  if (reaching.empty()) return {};
  const std::vector<SceneDoubt> doubts = check_scene(file);
  const auto is_found = [&](const auto& kind) {
    return std::any_of(doubts.begin(), doubts.end(), kind);
  };
  if (is_found([](const SceneDoubt& found) { // a cut would hide it
        return found.doubt == Doubt::center_of_mass || found.doubt == Doubt::density;
      }))
    return {};
  for (const std::size_t b : reaching) {
    TomlTable& table = table_of(cut.document, file.body_names[b]);
    const std::string shape = std::get<std::string>(table.find("shape")->data);
    const Points points = PatchCutter(file, b).cut(
        shape, shape == "rectangle" ? first_count(table, default_line_points) : 1);
    const int line = file.lines.bodies[b].place;
    if (!points.positions.empty())
      list_points(table, points);
    else if (!is_found([&](const SceneDoubt& found) {
               return found.doubt == Doubt::far_from_object && found.line == line;
             }))
      refuse(file, b);
    else
      cut.overhang.erase(file.body_names[b]);
  }
  return cut;
}

} // namespace lcpush::desktop
