// Ctrl-C as a wish: to end early with what there is.
#pragma once

namespace lcpush::cli {

/// From now on the first SIGINT or SIGTERM is noted; the next one ends the process, as it would
/// without this.
void listen_for_signals();
bool is_asked_to_end();

} // namespace lcpush::cli
