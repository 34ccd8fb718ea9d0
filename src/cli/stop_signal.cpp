#include "cli/stop_signal.hpp"

#include <csignal>
#include <initializer_list>

namespace lcpush::cli {
namespace {

volatile std::sig_atomic_t is_asked = 0;

void note_signal(int) { is_asked = 1; }

} // namespace

void listen_for_signals() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

bool is_asked_to_end() { return is_asked != 0; }

} // namespace lcpush::cli
