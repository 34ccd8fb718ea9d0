// Times and their statistics.
#pragma once

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

namespace lcpush::bench {

/// Processor time of this thread, in ms: what else runs on the machine counts only through the
/// caches.
inline double cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Calls `run` for about `budget` ms (once at least) and appends the time of a call. Short calls
/// are timed in batches of at least 20 us.
template <class Run> void sample(Run run, double budget, std::vector<double>& times) {
  const double start = cpu_ms();
  run();
  const double first = std::max(cpu_ms() - start, 1e-5);
  if (first > budget) {
    times.push_back(first);
    return;
  }
  const int batch = std::max(1, static_cast<int>(0.02 / first));
  const int count = std::clamp(static_cast<int>(budget / (first * batch)), 3, 50);
  for (int k = 0; k < count; ++k) {
    const double begin = cpu_ms();
    for (int i = 0; i < batch; ++i) run();
    times.push_back((cpu_ms() - begin) / batch);
  }
}

/// The value below which a fraction of them lies; NaN of none.
inline double quantile(std::vector<double> values, double fraction) {
  if (values.empty()) return std::nan("");
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(fraction * static_cast<double>(values.size() - 1) + 0.5);
  return values[at];
}
inline double median(const std::vector<double>& values) { return quantile(values, 0.5); }

/// The slope of log y over log x by least squares; NaN of fewer than two points.
inline double growth(const std::vector<double>& x, const std::vector<double>& y) {
  double count = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(y[i] > 0)) continue;
    const double u = std::log(x[i]), v = std::log(y[i]);
    count += 1, sx += u, sy += v, sxx += u * u, sxy += u * v;
  }
  return count < 2 ? std::nan("") : (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

} // namespace lcpush::bench
