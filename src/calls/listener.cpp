#include "calls/listener.hpp"

namespace lcpush::calls {
namespace {

constexpr std::chrono::milliseconds between_calls(20);

} // namespace

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
