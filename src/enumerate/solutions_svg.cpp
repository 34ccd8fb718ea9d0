// Every solution of two or three unknowns, drawn: among the complementary cones of two, and where
// they lie in the space of z.
#include <algorithm>
#include <cmath>

#include "draw/cone_plane.hpp"
#include "draw/view.hpp"
#include "lcpush/desktop/all_solutions.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

using Places = std::vector<double>; // of z, an entry an unknown

// Lengths in pixels.
constexpr double side = ConeView::side, margin = 70, top = 40;
constexpr std::size_t most_labels = 12;

Places places_of(const ExactVector& z) {
  Places places;
  for (const Rational& x : z) places.push_back(x.value());
  return places;
}

/// The space of z: two unknowns as a plane, three from a corner with all axes equally long.
class SolutionSpace {
public:
  explicit SolutionSpace(const AllSolutions& found, std::size_t n) : n_(n) {
    for (const SolutionPoint& point : found.points) points_.push_back(places_of(point.z));
    for (const ExactVector& ray : found.rays) rays_.push_back(places_of(ray));
    std::vector<Pixel> shown{flat(Places(n, 0))};
    for (const Places& point : points_)
      for (const double x : point) longest_ = std::max(longest_, std::abs(x));
    longest_ = longest_ > 0 ? longest_ : 1;
    for (std::size_t k = 0; k < n; ++k) shown.push_back(flat(axis(k)));
    for (const Places& point : points_) shown.push_back(flat(point));
    const Frame frame = bounds(shown);
    unit_ = fitting_scale(frame, side - 2 * margin, side - 2 * margin);
    middle_ = {(frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2};
  }

  std::string axes() const {
    std::string text;
    for (std::size_t k = 0; k < n_; ++k) {
      const Pixel from = at(Places(n_, 0)), to = at(axis(k));
      text += arrow_element("axis", from, to) +
              text_element("quiet", to + 12 * (to - from).normalized() + Pixel(0, 5),
                           "z" + std::to_string(k + 1), "middle");
    }
    return text;
  }

  std::string set(const SolutionSet& set) const {
    std::vector<Pixel> corners;
    for (const Index v : set.vertices) {
      const Places& vertex = points_[static_cast<std::size_t>(v)];
      corners.push_back(at(vertex));
      for (const Index r : set.rays) corners.push_back(at(beyond(vertex, r)));
    }
    if (set.dimension >= 2) return polygon_element("sector zz solution", hull(corners));
    std::string text;
    for (std::size_t k = 1; k < corners.size(); ++k)
      text += set.rays.empty() ? line_element("way", corners[0], corners[k])
                               : arrow_element("way", corners[0], corners[k]);
    return text;
  }

  /// Isolated solutions and vertices.
  std::string dots(const AllSolutions& found) const {
    std::string text;
    for (std::size_t k = 0; k < points_.size(); ++k) {
      text += circle_element("dot", at(points_[k]), 5);
      if (k >= most_labels) continue;
      std::string name;
      for (const Rational& x : found.points[k].z)
        name += (name.empty() ? "(" : ", ") + (x.bit_length() < 12 ? x.text() : brief(x.value()));
      text += text_element("label", at(points_[k]) + Pixel(9, -9), name + ")");
    }
    return text;
  }

private:
  std::size_t n_;
  std::vector<Places> points_, rays_;
  double longest_ = 0, unit_ = 1;
  Pixel middle_;

  Pixel flat(const Places& z) const {
    if (n_ == 2) return {z[0], -z[1]};
    const double across = std::sqrt(0.75); // of 30 degrees
    return {across * (z[1] - z[0]), (z[0] + z[1]) / 2 - z[2]};
  }
  Pixel at(const Places& z) const {
    return Pixel(side / 2, side / 2) + unit_ * (flat(z) - middle_);
  }
  Places axis(std::size_t k) const {
    Places end(n_, 0);
    end[k] = 1.2 * longest_;
    return end;
  }
  /// So far along a direction that it is seen to go on.
  Places beyond(Places from, Index ray) const {
    for (std::size_t k = 0; k < n_; ++k)
      from[k] += 0.6 * longest_ * rays_[static_cast<std::size_t>(ray)][k];
    return from;
  }
};

/// q among the cones: as many solutions, as a rule, as cones that hold it.
std::string cones_of(const ExactMatrix& M, const ExactMatrix& q) {
  ConeColumns cones{{{1, 0}, {0, 1}}, {"w1", "w2", "z1", "z2"}};
  for (Index j = 0; j < 2; ++j) cones.columns.emplace_back(-M(0, j).value(), -M(1, j).value());
  const Plane place(q(0, 0).value(), q(1, 0).value());
  const double size = place.norm() > 0 ? place.norm() : 1;
  std::vector<Plane> shown{place};
  for (const Plane& column : cones.columns)
    if (column.norm() > 0) shown.push_back(size / 2 * column.normalized());
  const ConeView view(shown);
  return cone_elements(cones, view) + circle_element("dot", view(place), 5) +
         text_element("label", view(place) + Pixel(9, -9), "q");
}

} // namespace

std::string all_solutions_svg(const AllSolutions& found, const ExactMatrix& M, const ExactMatrix& q,
                              bool has_cones) {
  const auto n = static_cast<std::size_t>(M.rows);
  const SolutionSpace space(found, n);
  std::string elements;
  for (const SolutionSet& set : found.sets) elements += space.set(set);
  elements = space.axes() + elements + space.dots(found);
  Drawing drawing{"solutions", all_solutions_sentence(found), "", side, side + top, ""};
  drawing.description = "The space of z, with its solutions.";
  if (n == 2 && has_cones) {
    drawing.description = "Left the plane of q: each cone belongs to one choice of w or z in both "
                          "pairs. Right the plane of z, with the solutions.";
    drawing.width = 2 * side;
    elements = "<svg width=\"" + pixels(side) + "\" height=\"" + pixels(side) + "\">\n" +
               cones_of(M, q) + "</svg>\n" + shifted(elements, {side, 0});
  }
  drawing.elements =
      shifted(elements, {0, top}) + text_element("strong", {14, 26}, shortened(drawing.title, 100));
  return svg_element(drawing, "<style>\n" + palette(".drawing") + drawing_style() + cone_style() +
                                  ".drawing .way .shaft { stroke: var(--friction); }\n"
                                  ".drawing .solution { stroke: var(--normal); }\n</style>\n");
}

} // namespace lcpush::desktop
