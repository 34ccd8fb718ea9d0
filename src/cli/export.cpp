#include "commands.hpp"
namespace lcpush::cli {
Command export_command() {
  return {"export", "", "", "", {}, 1, [](const Arguments&) {return 2; }};
}
} // namespace lcpush::cli
