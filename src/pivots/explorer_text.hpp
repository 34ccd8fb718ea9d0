// The explorer's files as text, embedded by src/cmake/embed_text.cmake.
#pragma once

#include <string>

namespace lcpush::desktop {

struct PivotTrace;
class Push;

/// The page, with the places /*LOOKS*/ (palette, drawing_style), /*DRAWING*/ (drawing_script),
/// /*STYLE*/ and /*SCRIPT*/ for the other two, and /*TRACE*/.
std::string explorer_template();
std::string explorer_style();
std::string explorer_script();

/// pivots_html with the places /*LOOKS*/ and /*DRAWING*/ left open, for a page that has both.
std::string open_pivots_html(const PivotTrace& trace, const Push* push);

} // namespace lcpush::desktop
