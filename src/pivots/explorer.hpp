// What the explorer's page is made of.
#pragma once

#include <string>

namespace lcpush::desktop {

struct PivotTrace;
class JsonWriter;
class Push;

/// Its files as text, embedded by src/cmake/embed_text.cmake: the page, with the places /*LOOKS*/
/// (palette, drawing_style), /*DRAWING*/ (drawing_script),
/// /*STYLE*/ and /*SCRIPT*/ for the other two, and /*TRACE*/.
std::string explorer_template();
std::string explorer_style();
std::string explorer_script();

/// pivots_html with the places /*LOOKS*/ and /*DRAWING*/ left open, for a page that has both.
std::string open_pivots_html(const PivotTrace& trace, const Push* push);

/// A scene as one object, SI units and scene axes: geometry, generators, and where each contact's
/// unknowns stand among z. `draws` adds what of its pictures is as in a report (projections,
/// outlines, pads, cones), so that the page's scripts draw only what changes.
void write_scene(JsonWriter& json, const Push& push, bool draws);

} // namespace lcpush::desktop
