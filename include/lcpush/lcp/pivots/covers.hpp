// Covering vectors, and what happens when one has failed. Included by lemke.hpp.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"

namespace lcpush {

/// Each try has a covering vector and tie columns of its own.
template <class S, class B> std::uint32_t Lemke<S, B>::seed(Index column) const {
  const Index cover = options_.first_cover + tries_;
  return static_cast<std::uint32_t>((1 + detail::tie_columns) * cover + column);
}

template <class S, class B> bool Lemke<S, B>::is_last_try() const {
  return options_.cover != nullptr || tries_ + 1 >= options_.covers;
}

template <class S, class B> void Lemke<S, B>::draw_ties() {
  for (Index k = 0; k < detail::tie_columns; ++k) {
    VectorMap<S> ties = tie_column(k);
    for (Index i = 0; i < n_; ++i) ties[i] = generic_number<S>(seed(k + 1), i);
  }
}

/// A cold start: the basis of all w, z = 0, under a generic covering vector or the caller's.
template <class S, class B> void Lemke<S, B>::cover_cold() {
  for (Index i = 0; i < n_; ++i)
    covering_[i] = options_.cover != nullptr ? S(options_.cover[i] * row_scale_[i])
                                             : generic_number<S>(seed(0), i);
  draw_ties();
  load_values();
  basis_.load(row_scale_, column_scale_, covering_);
  covered_ = true;
  entering_ = -1;
  tie_tolerance_ = options_.tolerances.tie;
  pivots_of_try_ = repairs_ = 0;
}

/// A covering vector and tie columns that are generic and positive in the present complementary
/// basis. In the problem as given the vector is w - M z of the point (z, w) that it describes.
template <class S, class B> void Lemke<S, B>::cover_here() {
  covered_ = true;
  trial_.setZero();
  covering_.setZero();
  VectorMap<S> here = tie_column(0);
  for (Index i = 0; i < n_; ++i) {
    const Index variable = basis_.dictionary.basic[i];
    here[i] = generic_number<S>(seed(0), i);
    (variable < n_ ? covering_[variable] : trial_[variable - n_]) = here[i];
  }
  scaled_product(trial_.data(), product_.data());
  covering_ -= product_;
  basis_.set_covering_vector(covering_, [&](Index i) { return here[i]; });
  draw_ties();
}

/// This covering vector has failed: a generic one that has not been tried may do better. If none is
/// left, the failure that says most is reported: a verified ray, else the last.
template <class S, class B> Status Lemke<S, B>::try_next_covering_vector() {
  if (worst_ != Status::ray) {
    worst_ = status_;
    worst_reason_ = reason_;
  }
  if (is_last_try()) return end(worst_, worst_reason_);
  ++tries_;
  cover_cold();
  return status_ = Status::running;
}

} // namespace lcpush
