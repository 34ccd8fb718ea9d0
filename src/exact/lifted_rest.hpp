// What p-adic digits have not yet explained of a right-hand side.
#pragma once

#include "exact/modular.hpp"
#include "lcpush/desktop/big_integer.hpp"
#include "lcpush/types.hpp"

#include <vector>

namespace lcpush::desktop {

/// Sparse rows of whole numbers with their limbs side by side: products with short numbers are what
/// lifting spends its time on.
class LimbRows {
public:
  void add_row(const std::vector<std::pair<Index, BigInteger>>& row);
  std::size_t size() const { return ends_.size(); }
  /// Bits of the largest sum of a row's magnitudes, at most.
  std::size_t most_bits() const { return most_bits_; }

private:
  friend class LiftedRest;
  struct Entry {
    Index column;
    bool is_negative;
    std::size_t begin, count; // of its limbs
  };
  std::vector<Entry> entries_;
  std::vector<std::size_t> ends_; // of the rows' entries
  std::vector<limbs::Limb> limbs_;
  std::size_t most_bits_ = 0;
};

/// c, then (c - A d) / p, and so on: numbers of one length, in two's complement.
class LiftedRest {
public:
  LiftedRest(const LimbRows& rows, const std::vector<BigInteger>& c);
  /// Modulo the prime.
  std::vector<limbs::Limb> remainders() const;
  /// Pre: A d = the remainders, modulo the prime.
  void take(const std::vector<limbs::Limb>& digits);

private:
  const LimbRows& rows_;
  std::size_t width_ = 0; // limbs of a number
  std::vector<limbs::Limb> rest_;
};

} // namespace lcpush::desktop
