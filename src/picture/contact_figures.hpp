// What happens at a contact point, drawn: its forces, its friction cone and its mode.
#pragma once

#include "draw/marks.hpp"
#include "picture/grasp_figures.hpp"

namespace lcpush::desktop {

/// Forces end at the contact; the cone opens where they come from. A normal force along the line of
/// sight is a ring.
struct ContactFigure {
  std::string elements;
  std::vector<Pixel> cone;                     ///< its corners; none without a cone
  std::vector<std::pair<Pixel, Pixel>> shafts; ///< of the arrows, from tail to tip
};

/// At the pixel `tip`. `newtons`: pixels a newton; a normal force up to `no_force` [N] is none.
ContactFigure contact_figure(const SceneFile& file, const View& view, const Body<double>& body,
                             const ContactAnswer<double>& answer, const Pixel& tip, double newtons,
                             double no_force);

/// The corners of a drawn friction cone; of round friction enough for the eye.
inline Index drawn_facets(const SceneFile& file, const Body<double>& body) {
  return facets_of(body, file.is_round ? 64 : file.facets);
}

/// Square, triangle or ring.
std::string mode_mark(Mode mode, const Pixel& at);

} // namespace lcpush::desktop
