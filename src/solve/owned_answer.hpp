// An Answer with its arrays.
#pragma once

#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/layout.hpp"

#include <vector>

namespace lcpush::desktop {

class OwnedAnswer {
public:
  explicit OwnedAnswer(const Layout<double>& layout)
      : contacts_(static_cast<std::size_t>(layout.points)),
        closing_(static_cast<std::size_t>(layout.actuators)) {
    Index generators = 0;
    for (const ConeGroup<double>& cone : layout.cones) generators += cone.generators;
    friction_.resize(static_cast<std::size_t>(generators));
    answer_.contacts = {contacts_.data(), layout.points};
    answer_.friction = {friction_.data(), generators};
    answer_.closing = {closing_.data(), layout.actuators};
  }
  OwnedAnswer(const OwnedAnswer&) = delete;
  OwnedAnswer& operator=(const OwnedAnswer&) = delete;

  Answer<double>& get() { return answer_; }

private:
  std::vector<ContactAnswer<double>> contacts_;
  std::vector<double> friction_, closing_;
  Answer<double> answer_;
};

} // namespace lcpush::desktop
