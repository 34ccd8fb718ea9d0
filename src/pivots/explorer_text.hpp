// The explorer's files as text, embedded by src/cmake/embed_text.cmake.
#pragma once

#include <string>

namespace lcpush::desktop {

/// The page, with the places /*STYLE*/, /*SCRIPT*/ and /*TRACE*/ for the other two and the trace.
std::string explorer_template();
std::string explorer_style();
std::string explorer_script();

} // namespace lcpush::desktop
