#include "cli/shell_listener.hpp"

#include <cmath>
#include <cstdio>

#include <unistd.h>

#include "cli/ending.hpp"
#include "cli/shell.hpp"
#include "text/format.hpp"

namespace lcpush::cli {
namespace {

bool is_terminal() { return isatty(STDERR_FILENO) != 0; }

} // namespace

ShellListener::~ShellListener() {
  if (was_shown_ && is_terminal()) std::fprintf(stderr, "\r\033[K");
}

bool ShellListener::is_due() {
  const Clock::time_point now = Clock::now();
  if (now < next_) return false;
  next_ = now + std::chrono::seconds(1);
  return true;
}

void ShellListener::show(const std::string& text) {
  const auto passed = std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - begin_);
  was_shown_ = true;
  std::fprintf(stderr, "%slcpush: %ld s, %s%s", is_terminal() ? "\r\033[K" : "",
               static_cast<long>(passed.count()), text.c_str(), is_terminal() ? "" : "\n");
  std::fflush(stderr);
}

void ShellListener::progress(double done, const std::string& of) {
  if (is_due()) show(std::to_string(std::lround(100 * done)) + " % " + of);
}

desktop::Stop ShellListener::stop(double part) {
  return is_asked_to_end()          ? desktop::Stop::signal
         : is_over(part * seconds_) ? desktop::Stop::time
                                    : desktop::Stop::none;
}

void ShellListener::announce(const std::string& sentence) {
  std::fputs(desktop::wrapped("lcpush: " + sentence + "\n", columns_of(Stream::errors)).c_str(),
             stderr);
}

Index ShellListener::choose_row(const desktop::PivotTrace& trace) { return ask_for_row(trace); }

void ShellListener::progressed(Index, Index) {
  ++pivots_;
  if (is_due()) show("still at work, " + std::to_string(pivots_) + " pivots");
}

void ShellListener::swept(Index sweep, const double*, double residual) {
  if (is_due())
    show("sweep " + std::to_string(sweep) + desktop::printed(", residual %.1e", residual));
}

} // namespace lcpush::cli
