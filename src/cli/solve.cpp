#include "commands.hpp"
namespace lcpush::cli {
Command solve_command() {
  return {"solve", "", "", "", {}, 1, [](const Arguments&) {return 2; }};
}
} // namespace lcpush::cli
