// Whoever asked is told how far the work is, and may end it.
#pragma once

#include <string>

#include "lcpush/desktop/stop.hpp"
#include "lcpush/desktop/watcher.hpp"

namespace lcpush::desktop {
struct PivotTrace;
}

namespace lcpush::commands {

/// Watches pivots and sweeps, too.
class Listener : public desktop::Watcher {
public:
  /// `done`, 0 to 1, of what: "of the motion".
  virtual void progress(double done, const std::string& of) = 0;
  /// Is the work, or a part of it that may take `part` of the time, to end with what there is?
  virtual desktop::Stop stop(double part) = 0;
  /// Throws if it is to end where nothing is there yet.
  virtual void end_if_cancelled() {}
  /// What the work will take, before it begins.
  virtual void announce(const std::string& /*sentence*/) {}
  /// The row that leaves, where a student is asked for it.
  virtual Index choose_row(const desktop::PivotTrace& trace) = 0;
};

} // namespace lcpush::commands
