// The friction of each body and of each contact point in its contact plane, within the section of
// its friction cone.
#include <algorithm>
#include <cmath>

#include "picture/contact_figures.hpp"
#include "report/pictures.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

constexpr std::size_t columns = 6;
constexpr Index most_cells = 48;
constexpr double cell_width = 140, cell_height = 158, heading = 30,
                 radius = 40; // the polygon's, in pixels

/// Of a point that has friction, or of all of a body together.
struct Cell {
  Index point; ///< the body's first
  const Body<double>* body;
  std::string name, short_name, does;
  Mode mode;
  double bound;             ///< N, mu |lambda|
  Vector3<double> friction; ///< N, on the object
  Vector3<double> slip;     ///< m/s^2, where the contact slips
};

double friction_bound(const Body<double>& body, Index point, const PushReport& report) {
  return body.friction * std::abs(report.answer.contacts[point].normal_force);
}

bool has_friction(const Body<double>& body, Index point, const PushReport& report) {
  return friction_bound(body, point, report) > report.noise.force;
}

/// "left.3", the body's name cut where it is long.
std::string cell_name(const SceneFile& file, Index point) {
  const Index b = file.body_of(point);
  const std::string number = "." + std::to_string(point - file.body(b).first_point + 1);
  return shortened(file.body_name(b), 15 - number.size()) + number;
}

Cell point_cell(const SceneFile& file, const Body<double>& body, Index i,
                const PushReport& report) {
  const ContactAnswer<double>& answer = report.answer.contacts[i];
  const bool slips = answer.mode == Mode::slide;
  const double opening = answer.acceleration.dot(body.normal);
  return {i,
          &body,
          point_name(file, i),
          cell_name(file, i),
          mode_verb(answer.mode),
          answer.mode,
          friction_bound(body, i, report),
          answer.friction_force,
          slips ? Vector3<double>(answer.acceleration - opening * body.normal)
                : Vector3<double>(Vector3<double>::Zero())};
}

/// What its points bear together. A pad that turns has little friction in sum though each of its
/// points is at its limit: no slip is drawn where its points slip differently.
Cell body_cell(const SceneFile& file, const Body<double>& body, const PushReport& report) {
  Cell cell = point_cell(file, body, body.first_point, report);
  if (body.point_count == 1) return cell;
  cell.name = file.body_name(file.body_of(body.first_point));
  cell.short_name = shortened(cell.name, 15);
  cell.does = modes_text(report.answer, body);
  for (Index i = body.first_point + 1; i < body.first_point + body.point_count; ++i) {
    const Cell point = point_cell(file, body, i, report);
    cell.bound += point.bound;
    cell.friction += point.friction;
    if ((point.slip - cell.slip).norm() > report.noise.acceleration) cell.slip.setZero();
  }
  return cell;
}

/// The first points of each body, as many of each as there is room for.
std::vector<Cell> cells_of(const SceneFile& file, const PushReport& report) {
  std::vector<Cell> cells;
  const Scene<double> scene = file.view();
  const Index room = std::max<Index>(columns, most_cells / scene.bodies.size);
  for (const Body<double>& body : scene.bodies) {
    Index drawn = 0;
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i)
      if (has_friction(body, i, report) && drawn++ < room)
        cells.push_back(point_cell(file, body, i, report));
  }
  return cells;
}

/// t to the right, o up, as seen along the normal from inside the object.
Pixel in_plane(const Body<double>& body, const Vector3<double>& v) {
  return {v.dot(body.tangent), -v.dot(cross(body.normal, body.tangent))};
}

std::string amounts(const Cell& cell, const PushReport& report) {
  const double friction = cell.friction.norm();
  return (friction > report.noise.force ? brief(friction) : "0") + " of " + brief(cell.bound) +
         " N";
}

std::string cell_elements(const SceneFile& file, const Cell& cell, const PushReport& report) {
  const Body<double>& body = *cell.body;
  const Pixel center(cell_width / 2, 88);
  std::vector<Pixel> rim;
  const Index corners = drawn_facets(file, body);
  for (Index j = 0; j < corners; ++j)
    rim.push_back(center + radius * in_plane(body, generator(body, j, corners).force));
  const Vector3<double> other = cross(body.normal, body.tangent);
  std::string text = text_element("strong", {cell_width / 2, 16}, cell.short_name, "middle");
  if (cell.does == mode_verb(cell.mode))
    text += mode_mark(cell.mode, {cell_width / 2 - 36, 28}) +
            text_element("", {cell_width / 2 - 26, 32}, cell.does);
  else
    text += text_element("", {cell_width / 2, 32}, cell.does, "middle");
  text += (body.in_plane ? "" : circle_element("coulomb", center, radius)) +
          polygon_element("cone", rim) +
          line_element("tick", center - Pixel(radius, 0), center + Pixel(radius, 0)) +
          line_element("tick", center - Pixel(0, radius), center + Pixel(0, radius));
  for (const auto& [at, along] : {std::pair(Pixel(radius + 5, 4), direction_text(body.tangent)),
                                  std::pair(Pixel(5, -radius - 2), direction_text(other))})
    if (along.size() < 4) text += text_element("quiet", center + at, along); // "+x" has room
  if (cell.slip.norm() > report.noise.acceleration)
    text += arrow_element("motion thin", center,
                          center + 0.8 * radius *
                                       in_plane(body, Vector3<double>(cell.slip.normalized())));
  text += arrow_element("force friction", center,
                        center + radius / cell.bound * in_plane(body, cell.friction));
  text += circle_element("center", center, 2);
  return text +
         text_element("", {cell_width / 2, cell_height - 10}, amounts(cell, report), "middle");
}

Drawing panel_of(const SceneFile& file, const Cell& cell, const PushReport& report) {
  return {cell.name,  cell.name,   cell.does + ", friction " + amounts(cell, report) + ".",
          cell_width, cell_height, cell_elements(file, cell, report)};
}

} // namespace

std::vector<std::string> without_friction(const SceneFile& file, const PushReport& report) {
  enum Reason : std::size_t { drawn, no_room, no_force, frictionless };
  constexpr const char* words[] = {"", "no room", "no normal force", "frictionless"};
  const Scene<double> scene = file.view();
  const std::vector<Cell> cells = cells_of(file, report);
  const auto reason = [&](const Body<double>& body, Index i) {
    for (const Cell& cell : cells)
      if (cell.point == i) return drawn;
    return has_friction(body, i, report) ? no_room : body.friction > 0 ? no_force : frictionless;
  };
  std::vector<std::string> list;
  for (const Body<double>& body : scene.bodies) {
    const Index end = body.first_point + body.point_count;
    for (Index i = body.first_point; i < end;) {
      const Reason why = reason(body, i);
      Index last = i;
      while (last + 1 < end && reason(body, last + 1) == why) ++last;
      if (why != drawn)
        list.push_back(point_name(file, i) + (last > i ? " to " + point_name(file, last) : "") +
                       " (" + words[why] + ")");
      i = last + 1;
    }
  }
  return list;
}

std::vector<FrictionGroup> friction_panels(const SceneFile& file, const PushReport& report) {
  std::vector<FrictionGroup> groups;
  const Body<double>* last = nullptr;
  for (const Cell& cell : cells_of(file, report)) {
    if (cell.body != last) {
      const Cell whole = body_cell(file, file.body(file.body_of(cell.point)), report);
      groups.push_back(
          {file.body_name(file.body_of(cell.point)), panel_of(file, whole, report), {}});
    }
    last = cell.body;
    if (cell.body->point_count > 1) groups.back().points.push_back(panel_of(file, cell, report));
  }
  return groups;
}

Drawing friction_picture(const SceneFile& file, const PushReport& report) {
  Drawing drawing{"friction", "Friction within its cone, point by point",
                  "",         static_cast<double>(columns) * cell_width,
                  50,         ""};
  const std::vector<FrictionGroup> groups = friction_panels(file, report);
  if (groups.empty()) {
    drawing.description = "No contact point has friction.";
    drawing.elements = text_element("quiet", {16, 30}, drawing.description);
    return drawing;
  }
  drawing.description = "The section of each friction cone at its normal force, seen along the "
                        "normal from inside the object, and the friction force in it.";
  drawing.height = 0;
  for (const FrictionGroup& group : groups) {
    drawing.elements += text_element("strong", {16, drawing.height + 22}, group.body);
    drawing.height += heading;
    const std::vector<Drawing> panels =
        group.points.empty() ? std::vector{group.whole} : group.points;
    for (std::size_t k = 0; k < panels.size(); ++k) {
      const std::size_t column = k % columns;
      if (column == 0 && k > 0) drawing.height += cell_height;
      drawing.elements +=
          shifted(panels[k].elements, {static_cast<double>(column) * cell_width, drawing.height});
      drawing.description += " " + panels[k].title + " " + panels[k].description;
    }
    drawing.height += cell_height;
  }
  return drawing;
}

} // namespace lcpush::desktop
