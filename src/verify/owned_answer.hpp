// An Answer with its arrays.
#pragma once

#include "lcpush/desktop/owned.hpp"
#include "lcpush/mechanics/model/answer.hpp"
#include "lcpush/mechanics/model/layout.hpp"

namespace lcpush::desktop {

class OwnedAnswer {
public:
  explicit OwnedAnswer(const Layout<double>& layout)
      : contacts_(static_cast<std::size_t>(layout.points)),
        closing_(static_cast<std::size_t>(layout.actuators)) {
    std::size_t generators = 0;
    for (const ConeGroup<double>& cone : layout.cones)
      generators += static_cast<std::size_t>(cone.generators);
    friction_.resize(generators);
    answer_ = {Vector6<double>::Zero(), span_of(contacts_), span_of(friction_), span_of(closing_)};
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
