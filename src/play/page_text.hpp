// The playground's files as text, embedded by src/cmake/embed_text.cmake.
#pragma once

#include <string>

namespace lcpush::desktop {

/// The page, with the explorer's places /*LOOKS*/ and /*DRAWING*/, and /*STYLE*/, /*SCRIPT*/,
/// /*SOLVER*/ and /*SCENE*/.
std::string play_template();
/// The same places, without /*SCENE*/.
std::string lcp_template();
std::string play_style();
std::string play_script();
/// With the places /*STYLE*/ and /*SCENES*/.
std::string gallery_template();
/// wasm/solver.txt: made by wasm/refresh.py, which says how it is packed.
std::string solver_text();

} // namespace lcpush::desktop
