#include "commands.hpp"
namespace lcpush::cli {
Command break_command() {
  return {"break", "", "", "", {}, 1, [](const Arguments&) {return 2; }};
}
} // namespace lcpush::cli
