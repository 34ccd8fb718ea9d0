// What standard error says while the work takes longer than a second, and when that is to end.
#pragma once

#include <chrono>

#include "commands/listener.hpp"

namespace lcpush::cli {

/// At most one line a second. On a terminal it is rewritten, and wiped at the end.
class ShellListener : public commands::Listener {
public:
  /// The work is to end with what there is after so much processor time.
  explicit ShellListener(double seconds) : seconds_(seconds) {}
  ~ShellListener() override;

  void progress(double done, const std::string& of) override;
  desktop::Stop stop(double part) override;
  void announce(const std::string& sentence) override;
  Index choose_row(const desktop::PivotTrace& trace) override;
  void stepped(const Lemke<double>& lemke) override {
    progressed(lemke.dictionary().size(), lemke.covers_tried());
  }
  void progressed(Index unknowns, Index covers) override;
  void swept(Index sweep, const double* z, double residual) override;

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin_ = Clock::now(), next_ = begin_ + std::chrono::seconds(1);
  bool was_shown_ = false;
  long pivots_ = 0;
  double seconds_;

  bool is_due();
  void show(const std::string& text);
};

/// Shows the tableau before the trace's last pivot on standard error, where it does not mix with
/// the trace, and reads the name of a variable, or a row's number, from standard input until it is
/// one that may leave; a wrong one is explained. At the end of the input the rule's own row is
/// taken from then on.
Index ask_for_row(const desktop::PivotTrace& trace);

} // namespace lcpush::cli
