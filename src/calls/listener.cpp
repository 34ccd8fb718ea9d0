#include "calls/listener.hpp"

#include <ctime>

namespace lcpush::calls {
namespace {

constexpr std::chrono::milliseconds between_calls(20);

} // namespace

double ForeignListener::processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

desktop::Stop ForeignListener::stop(double part) {
  return is_cancelled()                                 ? desktop::Stop::signal
         : processor_time() - begin_ >= part * seconds_ ? desktop::Stop::time
                                                        : desktop::Stop::none;
}

bool ForeignListener::is_cancelled() {
  if (was_cancelled_ || other_ == nullptr || other_->is_cancelled == nullptr) return was_cancelled_;
  const Clock::time_point now = Clock::now();
  if (now < next_look_) return false;
  next_look_ = now + between_calls;
  was_cancelled_ = other_->is_cancelled(other_->context) != 0;
  return was_cancelled_;
}

void ForeignListener::progress(double done, const std::string&) {
  if (other_ == nullptr || other_->progress == nullptr) return;
  const Clock::time_point now = Clock::now();
  if (now < next_note_) return;
  next_note_ = now + between_calls;
  other_->progress(other_->context, done);
}

} // namespace lcpush::calls
