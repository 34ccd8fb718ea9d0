#include "draw/cone_plane.hpp"

#include <limits>
#include <utility>

namespace lcpush::desktop {
namespace {

/// The cone of two columns, and its name where its middle leaves the picture; nothing without an
/// inside.
std::pair<std::string, std::string> sector(const ConeColumns& cones, const ConeView& view,
                                           std::size_t a, std::size_t b) {
  const Plane one = cones.columns[a].normalized(), other = cones.columns[b].normalized();
  const Plane between = one + other;
  if (!(between.norm() > 1e-9) || !(one.norm() * other.norm() > 0)) return {};
  const char* const kind = a > 1   ? b > 1 ? "sector zz" : "sector zw"
                           : b > 1 ? "sector wz"
                                   : "sector";
  const Pixel end = view.end_of(between, 0), origin = view(Plane::Zero());
  const Pixel name = (origin + 0.7 * (end - origin))
                         .cwiseMax(ConeView::edge)
                         .cwiseMin(ConeView::side - ConeView::edge);
  return {
      polygon_element(kind, {origin, view(view.far() * one),
                             view(view.far() * between.normalized()), view(view.far() * other)}),
      text_element("label strong", name, cones.names[a] + " and " + cones.names[b], "middle")};
}

} // namespace

ConeView::ConeView(const std::vector<Plane>& shown) {
  Plane low = Plane::Zero(), high = Plane::Zero();
  for (const Plane& p : shown) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  middle_ = (low + high) / 2;
  unit_ = (side - 2 * edge) / (high - low).maxCoeff();
}

Pixel ConeView::end_of(const Plane& ray, double margin) const {
  const Pixel from = (*this)(Plane::Zero()), along(ray.x(), -ray.y());
  double reach = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 2; ++k)
    if (along[k] != 0)
      reach = std::min(reach, ((along[k] > 0 ? side - margin : margin) - from[k]) / along[k]);
  return from + reach * along;
}

std::string cone_elements(const ConeColumns& cones, const ConeView& view) {
  std::string text, names;
  for (const auto& [a, b] :
       std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {2, 1}, {0, 3}, {2, 3}}) {
    const auto [cone, name] = sector(cones, view, a, b);
    text += cone;
    names += name;
  }
  for (std::size_t k = 0; k < cones.columns.size(); ++k) {
    if (!(cones.columns[k].norm() > 0)) continue;
    text += line_element("border", view(Plane::Zero()), view.end_of(cones.columns[k], 30));
    names += text_element("label", view.end_of(cones.columns[k], 16) + Pixel(0, 5), cones.names[k],
                          "middle");
  }
  return text + names;
}

std::string cone_style() {
  return ".drawing .sector { fill: var(--soft); fill-opacity: 0.08; }\n"
         ".drawing .zw { fill: var(--move); fill-opacity: 0.17; }\n"
         ".drawing .wz { fill: var(--cone); fill-opacity: 0.2; }\n"
         ".drawing .zz { fill: var(--normal); fill-opacity: 0.17; }\n"
         ".drawing .border { stroke: var(--ink); stroke-width: 1.6; }\n"
         ".drawing .way { color: var(--friction); stroke: var(--friction); stroke-width: 2.6;"
         " fill: none; }\n"
         ".drawing .dot { fill: var(--friction); stroke: var(--raised); }\n";
}

} // namespace lcpush::desktop
