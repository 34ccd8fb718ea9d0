#include "lcpush/desktop/move.hpp"

#include "move/motion_painter.hpp"
#include "move/move_words.hpp"

namespace lcpush::desktop {

std::string move_svg(const SceneFile& file, const MotionReport& report) {
  constexpr std::size_t most_ghosts = 6;
  const MotionPainter painter(file, report);
  std::vector<std::size_t> ghosts = spread_out(report.frames.size(), most_ghosts + 1);
  ghosts.pop_back(); // the object itself stands there
  Drawing drawing{"move",
                  file.title.empty() ? "Where the object goes" : file.title,
                  move_sentence(file, report) + " Seen in " + painter.view().title +
                      "; dashed, the object on its way; the line is that of its centre of mass.",
                  MotionPainter::width,
                  MotionPainter::height,
                  ""};
  drawing.elements = painter.surroundings() + painter.ghosts(ghosts) +
                     painter.moment(report.frames.back()) + painter.way();
  return svg_document(drawing);
}

} // namespace lcpush::desktop
