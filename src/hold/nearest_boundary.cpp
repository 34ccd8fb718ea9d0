#include "hold/nearest_boundary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "hold/settings.hpp"
#include "lcpush/mechanics/model/contact.hpp"

namespace lcpush::desktop {
namespace {

using Edge = std::pair<std::size_t, std::size_t>;

/// The triangles of the polytope inside, those that are gone infinitely far.
struct Facets {
  std::vector<std::array<std::size_t, 3>> corners;
  std::vector<Vector3<double>> normal; ///< unit, outward; zero: rounding has left it no area
  std::vector<double> height, nearness;
  std::map<Edge, std::size_t> behind; ///< an edge, as the facet runs through it

  double over(std::size_t facet, const Vector3<double>& point) const {
    return normal[facet].dot(point) - height[facet];
  }
};

class InnerPolytope {
public:
  InnerPolytope(const SupportQuestion& support, const Nearness& nearness, double bracket)
      : support_(support), nearness_(nearness), bracket_(bracket) {}

  std::optional<NearestBoundary> find(const std::function<bool()>& is_used_up) {
    if (!span()) return has_failed_ ? std::nullopt : std::optional(best_);
    for (Index k = 0; k < hold_settings.most_directions && !is_used_up(); ++k) {
      const auto thinnest = static_cast<std::size_t>(
          std::min_element(facets_.nearness.begin(), facets_.nearness.end()) -
          facets_.nearness.begin());
      best_.lower = std::min(facets_.nearness[thinnest], best_.upper);
      if (best_.upper - best_.lower <= bracket_ * std::abs(best_.upper)) break;
      const std::optional<SupportPoint> there = ask(facets_.normal[thinnest]);
      if (!there || facets_.over(thinnest, there->point) <= rounding()) break;
      grow(there->point, thinnest);
    }
    return best_;
  }

private:
  const SupportQuestion& support_;
  const Nearness& nearness_;
  double bracket_;
  NearestBoundary best_;
  std::vector<Vector3<double>> points_;
  Facets facets_;
  double size_ = 0;
  bool has_failed_ = false;

  double rounding() const { return hold_settings.rounding * size_; }

  std::optional<SupportPoint> ask(const Vector3<double>& along) {
    std::optional<SupportPoint> there = support_(along);
    has_failed_ = has_failed_ || !there;
    if (!there) return there;
    size_ = std::max(size_, there->point.norm());
    if (const double near = nearness_(along, there->height); near < best_.upper) {
      best_.upper = near;
      best_.direction = along;
    }
    return there;
  }

  /// Four points that are in no plane. False: there are none, or a question failed.
  bool span() {
    std::vector<Vector3<double>> axes;
    while (axes.size() < 3) {
      const Vector3<double> along = across(axes);
      std::optional<SupportPoint> ends[] = {ask(along), ask(-along)};
      if (!ends[0] || !ends[1]) return false;
      if (points_.empty()) points_.push_back(ends[1]->point);
      const auto off = [&](const std::optional<SupportPoint>& end) {
        return std::abs(along.dot(end->point - points_[0]));
      };
      const auto& end = off(ends[0]) > off(ends[1]) ? ends[0] : ends[1];
      if (!(off(end) > statics_settings.flat * size_) || size_ == 0) {
        best_.direction = along;
        best_.lower = best_.upper = std::max(nearness_(along, 0), nearness_(-along, 0));
        return false;
      }
      Vector3<double> axis = end->point - points_[0];
      for (const Vector3<double>& other : axes) axis -= other.dot(axis) * other;
      axes.push_back(axis.normalized());
      points_.push_back(end->point);
    }
    constexpr std::array<std::size_t, 3> faces[] = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    for (const auto& face : faces) add_facet(face, &points_[6 - face[0] - face[1] - face[2]]);
    return true;
  }

  /// A unit vector orthogonal to all of them.
  static Vector3<double> across(const std::vector<Vector3<double>>& axes) {
    if (axes.empty()) return Vector3<double>::UnitX();
    if (axes.size() == 2) return cross<double>(axes[0], axes[1]).normalized();
    return default_tangent(axes[0]);
  }

  /// Its corners in the order that has the normal point outward; `inside`: a point behind it.
  void add_facet(std::array<std::size_t, 3> corners, const Vector3<double>* inside = nullptr) {
    const Vector3<double>& a = points_[corners[0]];
    const Vector3<double> b = points_[corners[1]] - a, c = points_[corners[2]] - a;
    Vector3<double> normal = cross<double>(b, c);
    if (inside != nullptr && normal.dot(*inside - a) > 0) {
      std::swap(corners[1], corners[2]);
      normal = -normal;
    }
    const double area = normal.norm();
    const bool has_area = area > hold_settings.rounding * b.norm() * c.norm();
    normal = has_area ? Vector3<double>(normal / area) : Vector3<double>::Zero();
    const double height = normal.dot(a);
    for (std::size_t k = 0; k < 3; ++k)
      facets_.behind[{corners[k], corners[(k + 1) % 3]}] = facets_.corners.size();
    facets_.corners.push_back(corners);
    facets_.normal.push_back(normal);
    facets_.height.push_back(height);
    facets_.nearness.push_back(has_area ? nearness_(normal, height)
                                        : std::numeric_limits<double>::infinity());
  }

  /// The hull of the polytope and a point, which sees `first` from outside. What else it sees is
  /// looked for next to that, so that rounding leaves one rim.
  void grow(const Vector3<double>& point, std::size_t first) {
    std::vector<std::size_t> seen{first};
    std::vector<Edge> rim;
    std::set<std::size_t> gone{first};
    for (std::size_t k = 0; k < seen.size(); ++k)
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& corners = facets_.corners[seen[k]];
        const Edge edge{corners[c], corners[(c + 1) % 3]};
        const std::size_t next = facets_.behind.at({edge.second, edge.first});
        if (gone.count(next) > 0) continue;
        if (facets_.over(next, point) > rounding()) {
          gone.insert(next);
          seen.push_back(next);
        } else {
          rim.push_back(edge);
        }
      }
    for (const std::size_t facet : seen) {
      facets_.nearness[facet] = std::numeric_limits<double>::infinity();
      const auto& corners = facets_.corners[facet];
      for (std::size_t c = 0; c < 3; ++c) facets_.behind.erase({corners[c], corners[(c + 1) % 3]});
    }
    points_.push_back(point);
    for (const Edge& edge : rim) add_facet({edge.first, edge.second, points_.size() - 1});
  }
};

} // namespace

std::optional<NearestBoundary> nearest_boundary(const SupportQuestion& support,
                                                const Nearness& nearness, double bracket,
                                                const std::function<bool()>& is_used_up) {
  return InnerPolytope(support, nearness, bracket).find(is_used_up);
}

} // namespace lcpush::desktop
