#include "calls/listener.hpp"

namespace lcpush::desktop {
namespace {

constexpr std::chrono::milliseconds between_calls(20);

} // namespace

bool Listener::is_cancelled() {
  if (cancelled_ || other_ == nullptr || other_->is_cancelled == nullptr) return cancelled_;
  const Clock::time_point now = Clock::now();
  if (now < next_ask_) return false;
  next_ask_ = now + between_calls;
  cancelled_ = other_->is_cancelled(other_->context) != 0;
  return cancelled_;
}

void Listener::pass_on(double done) {
  if (other_ == nullptr || other_->progress == nullptr) return;
  const Clock::time_point now = Clock::now();
  if (now < next_tell_) return;
  next_tell_ = now + between_calls;
  other_->progress(other_->context, done);
}

} // namespace lcpush::desktop
