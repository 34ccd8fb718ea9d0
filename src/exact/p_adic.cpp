#include "exact/p_adic.hpp"

#include <algorithm>

namespace lcpush::desktop {
namespace {

using limbs::Limb;

/// The rows that are left, and which of them hold a column.
class Elimination {
public:
  explicit Elimination(std::vector<ModularFactors::Row>& rows)
      : rows_(rows), holders_(rows.size()), place_(rows.size(), none), is_left_(rows.size(), 1) {
    for (std::size_t i = 0; i < rows.size(); ++i)
      for (const ModularFactors::Entry& entry : rows[i]) holders_[index(entry)].push_back(i);
  }

  std::size_t shortest_row() const {
    std::size_t best = none;
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (is_left_[i] != 0 && (best == none || rows_[i].size() < rows_[best].size())) best = i;
    return best;
  }

  /// Its entry in the column of the fewest rows, taken out. Pre: the row is not empty.
  ModularFactors::Entry take_pivot(std::size_t row) {
    is_left_[row] = 0;
    for (const ModularFactors::Entry& entry : rows_[row]) {
      std::vector<std::size_t>& rows = holders_[index(entry)];
      rows.erase(std::find(rows.begin(), rows.end(), row));
    }
    const auto pivot =
        std::min_element(rows_[row].begin(), rows_[row].end(), [&](const auto& a, const auto& b) {
          return holders_[index(a)].size() < holders_[index(b)].size();
        });
    const ModularFactors::Entry result = *pivot;
    rows_[row].erase(pivot);
    return result;
  }

  /// The pivot's column vanishes from the rows that are left; how often each took the pivot's row.
  ModularFactors::Row clear(std::size_t pivot_row, std::size_t column, Limb inverse) {
    ModularFactors::Row factors;
    for (const std::size_t i : holders_[column]) {
      ModularFactors::Row& row = rows_[i];
      std::size_t at = none;
      for (std::size_t k = 0; k < row.size(); ++k) {
        place_[index(row[k])] = k;
        if (index(row[k]) == column) at = k;
      }
      const Limb factor = modular::times(row[at].value, inverse);
      factors.push_back({static_cast<Index>(i), factor});
      row[at].value = 0;
      for (const ModularFactors::Entry& entry : rows_[pivot_row]) {
        std::size_t& place = place_[index(entry)];
        if (place == none) {
          place = row.size();
          row.push_back({entry.at, 0});
          holders_[index(entry)].push_back(i);
        }
        row[place].value = modular::minus(row[place].value, modular::times(factor, entry.value));
      }
      drop_zeros(i, column);
    }
    return factors;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<ModularFactors::Row>& rows_;
  std::vector<std::vector<std::size_t>> holders_; // of a column: rows that are left
  std::vector<std::size_t> place_;                // of a column in the row at hand
  std::vector<unsigned char> is_left_;

  static std::size_t index(const ModularFactors::Entry& entry) {
    return static_cast<std::size_t>(entry.at);
  }
  void drop_zeros(std::size_t i, std::size_t pivot_column) {
    ModularFactors::Row& row = rows_[i];
    std::size_t kept = 0;
    for (const ModularFactors::Entry entry : row) {
      place_[index(entry)] = none;
      if (entry.value != 0) {
        row[kept++] = entry;
      } else if (index(entry) != pivot_column) { // whose holders are being gone through
        std::vector<std::size_t>& rows = holders_[index(entry)];
        rows.erase(std::find(rows.begin(), rows.end(), i));
      }
    }
    row.resize(kept);
  }
};

/// prime times it is 1 modulo 2^64, by Newton's method: every step doubles the bits that are right.
constexpr Limb inverse_of_prime() {
  Limb inverse = modular::prime; // right to 3 bits, of any odd number
  for (int step = 0; step < 5; ++step) inverse *= 2 - modular::prime * inverse;
  return inverse;
}

} // namespace

ModularFactors::ModularFactors(std::vector<Row> rows) : rows_(std::move(rows)) {
  Elimination elimination(rows_);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const std::size_t row = elimination.shortest_row();
    if (rows_[row].empty()) {
      is_singular_ = true;
      return;
    }
    const Entry pivot = elimination.take_pivot(row);
    const auto column = static_cast<std::size_t>(pivot.at);
    const Limb inverse = modular::inverse_of(pivot.value);
    steps_.push_back({row, column, inverse, elimination.clear(row, column, inverse)});
  }
}

void ModularFactors::solve(std::vector<Limb>& b) const {
  for (const Step& step : steps_)
    if (const Limb by = b[step.row]; by != 0)
      for (const Entry& entry : step.eliminates) {
        Limb& other = b[static_cast<std::size_t>(entry.at)];
        other = modular::minus(other, modular::times(entry.value, by));
      }
  std::vector<Limb> x(b.size(), 0);
  for (std::size_t k = steps_.size(); k-- > 0;) {
    Limb sum = b[steps_[k].row];
    for (const Entry& entry : rows_[steps_[k].row])
      sum = modular::minus(sum, modular::times(entry.value, x[static_cast<std::size_t>(entry.at)]));
    x[steps_[k].column] = modular::times(sum, steps_[k].inverse);
  }
  b.swap(x);
}

LiftedRest::LiftedRest(const std::vector<WholeRow>& rows, const std::vector<BigInteger>& c)
    : rows_(rows) {
  std::size_t most = 0;
  for (const BigInteger& value : c) most = std::max(most, value.bit_length());
  for (const WholeRow& row : rows) { // the rest falls to less than a row's sum
    std::size_t longest = modular::bits;
    while ((std::size_t{1} << (longest - modular::bits)) < row.size()) ++longest;
    std::size_t entry = 0;
    for (const auto& [column, value] : row) entry = std::max(entry, value.bit_length());
    most = std::max(most, longest + entry);
  }
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
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    Limb* const rest = &rest_[i * width_];
    for (const auto& [column, value] : rows_[i]) {
      const Limb by = digits[static_cast<std::size_t>(column)];
      if (by == 0) continue;
      (value.sign() < 0 ? limbs::add_multiple : limbs::subtract_multiple)(
          rest, width_, value.magnitude(), value.limb_count(), by);
    }
    limbs::divide_exactly(rest, width_, modular::prime, inverse);
  }
}

} // namespace lcpush::desktop
