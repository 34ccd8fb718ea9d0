#include "exact/lifted_rest.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

using limbs::Limb;

/// prime times it is 1 modulo 2^64, by Newton's method: every step doubles the bits that are right.
constexpr Limb inverse_of_prime() {
  Limb inverse = modular::prime; // right to 3 bits, of any odd number
  for (int step = 0; step < 5; ++step) inverse *= 2 - modular::prime * inverse;
  return inverse;
}

} // namespace

void LimbRows::add_row(const std::vector<std::pair<Index, BigInteger>>& row) {
  std::size_t longest = 0, room = 1;
  for (const auto& [column, value] : row) {
    entries_.push_back({column, value.sign() < 0, limbs_.size(), value.limb_count()});
    limbs_.insert(limbs_.end(), value.magnitude(), value.magnitude() + value.limb_count());
    longest = std::max(longest, value.bit_length());
  }
  while ((std::size_t{1} << room) < row.size()) ++room;
  most_bits_ = std::max(most_bits_, longest + room);
  ends_.push_back(entries_.size());
}

LiftedRest::LiftedRest(const LimbRows& rows, const std::vector<BigInteger>& c) : rows_(rows) {
  std::size_t most = rows.most_bits() + modular::bits; // the rest falls to less than a row's sum
  for (const BigInteger& value : c) most = std::max(most, value.bit_length());
  width_ = (most + 2) / limbs::limb_bits + 1; // the larger of two, doubled, and a sign
  rest_.assign(c.size() * width_, 0);
  for (std::size_t i = 0; i < c.size(); ++i) {
    Limb* const out = &rest_[i * width_];
    if (c[i].sign() < 0)
      limbs::subtract_multiple(out, width_, c[i].magnitude(), c[i].limb_count(), 1);
    else
      limbs::add_multiple(out, width_, c[i].magnitude(), c[i].limb_count(), 1);
  }
}

std::vector<Limb> LiftedRest::remainders() const {
  // 2^64 is 8 modulo the prime; what is negative stands 2^(64 width) too high.
  const auto eight_times = [](Limb a) {
    return modular::remainder(((a << 3U) & modular::prime) + (a >> (modular::bits - 3)));
  };
  Limb wrapped = 1;
  for (std::size_t k = 0; k < width_; ++k) wrapped = eight_times(wrapped);
  std::vector<Limb> result;
  for (const Limb* rest = rest_.data(); rest != rest_.data() + rest_.size(); rest += width_) {
    Limb sum = 0;
    for (std::size_t k = width_; k-- > 0;)
      sum = modular::remainder(eight_times(sum) + modular::remainder(rest[k]));
    const bool is_negative = (rest[width_ - 1] >> (limbs::limb_bits - 1)) != 0;
    result.push_back(is_negative ? modular::minus(sum, wrapped) : sum);
  }
  return result;
}

void LiftedRest::take(const std::vector<Limb>& digits) {
  static constexpr Limb inverse = inverse_of_prime();
  static_assert(inverse * modular::prime == 1);
  std::size_t entry = 0;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Limb* const rest = &rest_[i * width_];
    for (; entry < rows_.ends_[i]; ++entry) {
      const LimbRows::Entry& at = rows_.entries_[entry];
      const Limb by = digits[static_cast<std::size_t>(at.column)];
      if (by == 0) continue;
      (at.is_negative ? limbs::add_multiple : limbs::subtract_multiple)(
          rest, width_, &rows_.limbs_[at.begin], at.count, by);
    }
    limbs::divide_exactly(rest, width_, modular::prime, inverse);
  }
}

} // namespace lcpush::desktop
