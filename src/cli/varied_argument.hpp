// --vary, --steps and --pressure: what sweeps take, and how far one has come.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <unistd.h>

#include "cli/arguments.hpp"
#include "formats/read_number.hpp"
#include "lcpush/desktop/sweep.hpp"
#include "text/wording.hpp"

namespace lcpush::cli {

/// PATH=FROM:TO.
inline desktop::Variation read_variation(const desktop::VariedScene& scene,
                                         const std::string& text) {
  const std::size_t equals = text.find('='), colon = text.rfind(':');
  if (equals == std::string::npos || colon == std::string::npos || colon < equals)
    throw UsageError("--vary needs PATH=FROM:TO, such as left.grip_force=5:40, not " +
                     desktop::quoted(text));
  desktop::Variation variation;
  variation.parameter = scene.find(text.substr(0, equals));
  const auto number = [&](std::size_t begin, std::size_t end) {
    const desktop::NumberText read = desktop::read_finite_number(text.substr(begin, end - begin));
    if (read.error) throw UsageError("--vary " + desktop::quoted(text) + ": " + *read.error);
    return read.value;
  };
  variation.from = number(equals + 1, colon);
  variation.to = number(colon + 1, text.size());
  if (variation.from == variation.to)
    throw UsageError("--vary " + desktop::quoted(text) + ": from and to are the same");
  return variation;
}

inline Index read_steps(const Arguments& arguments, Index most) {
  const std::optional<std::string> text = arguments.value("--steps");
  if (!text) return 0;
  const auto steps = desktop::whole_number(*text);
  if (!steps || *steps < 2 || *steps > static_cast<std::uint64_t>(most))
    throw UsageError("--steps is a whole number from 2 to " + std::to_string(most) + ", not " +
                     desktop::quoted(*text));
  return static_cast<Index>(*steps);
}

inline Option pressure_option() {
  return {"--pressure", "LAW", "pad, even or rigid instead of the scene's own"};
}

/// The law of --pressure, if it is given.
inline void set_pressure(const Arguments& arguments, desktop::VariedScene& scene) {
  const auto law = arguments.value("--pressure");
  if (!law) return;
  const std::vector<std::string> laws = desktop::pressure_names();
  if (std::find(laws.begin(), laws.end(), *law) == laws.end())
    throw UsageError("--pressure is " + desktop::listed(laws, "or") + ", not " +
                     desktop::quoted(*law) + desktop::suggestion(*law, laws));
  scene.set_pressure(*law);
}

/// How much of the sweep is done, once a second.
class SweepMeter {
public:
  ~SweepMeter() {
    if (shown_ && terminal_) std::fprintf(stderr, "\r\033[K");
  }
  void show(double done) {
    const Clock::time_point now = Clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::seconds(1);
    shown_ = true;
    std::fprintf(stderr, "%slcpush: %.0f %% of the sweep%s", terminal_ ? "\r\033[K" : "",
                 100 * done, terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point next_ = Clock::now() + std::chrono::seconds(1);
  bool shown_ = false, terminal_ = isatty(STDERR_FILENO) != 0;
};

} // namespace lcpush::cli
