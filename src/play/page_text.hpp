// The playground's files as text, embedded by src/cmake/embed_text.cmake.
#pragma once

#include <string>

namespace lcpush::desktop {

/// Around either page: the explorer's places /*LOOKS*/ and /*DRAWING*/, and /*TITLE*/, /*STYLE*/,
/// /*BODY*/, /*SOLVER*/ and /*SCRIPT*/.
std::string play_frame();
/// With the places <!--KEY--> and /*SCENE*/.
std::string play_body();
std::string lcp_body();
std::string play_style();
std::string play_script();
/// With the places /*STYLE*/ and /*SCENES*/.
std::string gallery_template();
/// wasm/solver.txt: made by wasm/refresh.py, which says how it is packed.
std::string solver_text();

} // namespace lcpush::desktop
