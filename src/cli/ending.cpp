#include "cli/ending.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <initializer_list>

#include <sys/time.h>
#include <unistd.h>

#include "cli/shell.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {
namespace {

// A sanitized program takes several times as long for the same.
#ifndef __has_feature
#define __has_feature(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
constexpr double slowness = 6;
#else
constexpr double slowness = 1;
#endif

// Made beforehand: a signal's handler may neither allocate nor format.
std::string last_words;

extern "C" void say_last_words(int) {
  const ssize_t written = write(STDERR_FILENO, last_words.data(), last_words.size());
  _exit(written < 0 ? 2 : 1);
}

void set_timer(double seconds) {
  itimerval timer{};
  const double whole = std::floor(seconds);
  timer.it_value.tv_sec = static_cast<time_t>(whole);
  timer.it_value.tv_usec = static_cast<suseconds_t>(1e6 * (seconds - whole));
  setitimer(ITIMER_PROF, &timer, nullptr);
}

volatile std::sig_atomic_t is_asked = 0;

extern "C" void note_signal(int) { is_asked = 1; }

} // namespace

void limit_time(const std::string& command, double seconds) {
  last_words = wrapped("lcpush " + command + ": stopped after " + shown(seconds) +
                           " s of processor time, nothing is written. --seconds " +
                           shown(std::ceil(10 * seconds)) +
                           " gives it more; fewer points, facets or --steps and a narrower range "
                           "take less.",
                       columns_of(Stream::errors)) +
               "\n";
  struct sigaction action {};
  action.sa_handler = say_last_words;
  sigaction(SIGPROF, &action, nullptr);
  set_timer(slowness * seconds);
}

bool is_over(double seconds) {
  // Processor time is a system call; a clock on the wall is not, and is never behind it.
  using Clock = std::chrono::steady_clock;
  static Clock::time_point next = Clock::now();
  static std::clock_t used = 0;
  if (const Clock::time_point now = Clock::now(); now >= next) {
    next = now + std::chrono::milliseconds(1);
    used = std::clock();
  }
  return static_cast<double>(used) > slowness * seconds * static_cast<double>(CLOCKS_PER_SEC);
}

void lift_time_limit() { set_timer(0); }

void listen_for_signals() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
}

bool is_asked_to_end() { return is_asked != 0; }

} // namespace lcpush::cli
