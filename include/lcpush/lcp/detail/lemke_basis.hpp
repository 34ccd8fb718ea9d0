// Lemke's housekeeping: set-up, scaling, covers, factoring a basis from the problem as given,
// refining an answer and having it checked. Included by lemke.hpp.
#pragma once

#include "lcpush/lcp/lemke.hpp"

namespace lcpush {

template <class S> bool Lemke<S>::carve() {
  using detail::max_levels;
  using detail::tie_columns;
  Block<S> scalars(scalars_);
  Block<int> integers(integers_);
  const Index n = n_;
  // A Map cannot be assigned to: Eigen's documented way to re-seat one is placement new.
  const auto matrix = [&](MatrixMap<S>& map, Index columns) {
    new (&map) MatrixMap<S>(scalars.take(n * columns).data, n, columns);
  };
  const auto vector = [&](VectorMap<S>& map) { new (&map) VectorMap<S>(scalars.take(n).data, n); };
  matrix(dictionary_.table, n + 1);
  matrix(dictionary_.values, levels_ + tie_columns);
  matrix(cover_columns_, 1 + tie_columns);
  matrix(solution_, max_levels);
  for (VectorMap<S>* map : {&row_scale_, &column_scale_, &unit_, &rowsum_, &bound_, &ray_, &trial_,
                            &scratch_, &product_})
    vector(*map);
  check_scratch_ = scalars.take(2 * n);
  dictionary_.basic = integers.take(n);
  dictionary_.nonbasic = integers.take(n + 1);
  candidates_ = integers.take(n);
  target_ = integers.take(n);
  return !scalars.exhausted() && !integers.exhausted();
}

template <class S>
Status Lemke<S>::prepare(const Problem<S>& problem, const LemkeOptions<S>& options) {
  problem_ = problem;
  options_ = options;
  n_ = problem.size;
  levels_ = finite_level() + 1 + (problem.push != nullptr ? 1 : 0);
  cover_ = pivots_ = pivots_of_cover_ = repairs_ = 0;
  tie_tolerance_ = options.tolerances.tie;
  status_ = Status::running;
  reason_ = worst_reason_ = Reason::none;
  worst_ = Status::running;
  if (!carve()) return end(Status::bad_input, Reason::memory_too_small);

  MatrixMap<S> M(dictionary_.table.data(), n_, n_);
  fill_matrix(problem_, M);
  row_scale_.setOnes();
  column_scale_.setOnes();
  if (options_.equilibrate) equilibrate(M, row_scale_, column_scale_, scratch_);
  S finite_sum(0);
  rowsum_.setZero();
  bound_.setZero();
  for (Index j = 0; j < n_; ++j) {
    rowsum_ += M.col(j).cwiseAbs();
    finite_sum += M.col(j).sum() - M.col(j).sum();
    unit_[j] = column_scale_[j];
    if (j >= problem_.free_begin) bound_ -= M.col(j) / column_scale_[j];
  }
  for (Index i = 0; i < n_; ++i) {
    rowsum_[i] /= row_scale_[i];
    bound_[i] /= row_scale_[i];
    finite_sum += problem_.q[i] - problem_.q[i];
    if (problem_.push != nullptr) finite_sum += problem_.push[i] - problem_.push[i];
  }
  // x - x is NaN, not 0, for every x that is not finite.
  if (!(finite_sum == S(0))) return end(Status::bad_input, Reason::not_finite);
  for (Index k = 0; k < levels_; ++k) {
    S largest(0);
    for (Index i = 0; i < n_; ++i) {
      const S x = right_hand_side(k)[i] * row_scale_[i];
      largest = x > largest ? x : -x > largest ? S(-x) : largest;
    }
    level_scale_[k] = options_.equilibrate ? power_below(largest) : S(1);
  }
  return status_;
}

template <class S> const S* Lemke<S>::right_hand_side(Index level) const {
  if (level < finite_level()) return bound_.data();
  return level == finite_level() ? problem_.q : problem_.push;
}

/// The dictionary of the basis of all w, from the problem as given.
template <class S> void Lemke<S>::load() {
  using detail::tie_columns;
  fill_matrix(problem_, MatrixMap<S>(dictionary_.table.data(), n_, n_));
  for (Index j = 0; j < n_; ++j)
    dictionary_.table.col(j) = dictionary_.table.col(j).cwiseProduct(row_scale_) * column_scale_[j];
  dictionary_.table.col(n_) = cover_columns_.col(0);
  for (Index k = 0; k < levels_; ++k)
    for (Index i = 0; i < n_; ++i)
      dictionary_.values(i, k) = right_hand_side(k)[i] * row_scale_[i] / level_scale_[k];
  dictionary_.values.rightCols(tie_columns) = cover_columns_.rightCols(tie_columns);
  dictionary_.reset_basis();
}

/// Covers and tie columns for a start at z = 0.
template <class S> void Lemke<S>::cover_cold() {
  for (Index k = 0; k < cover_columns_.cols(); ++k)
    for (Index i = 0; i < n_; ++i)
      cover_columns_(i, k) = k == 0 && options_.cover != nullptr
                                 ? S(options_.cover[i] * row_scale_[i])
                                 : generic_number<S>(seed(k), i);
  dictionary_.table.col(n_) = cover_columns_.col(0);
  dictionary_.values.rightCols(detail::tie_columns) = cover_columns_.rightCols(detail::tie_columns);
  entering_ = -1;
  tie_tolerance_ = options_.tolerances.tie;
  pivots_of_cover_ = repairs_ = 0;
}

/// Covers and tie columns that are generic and positive in the present complementary basis. What
/// they are in the problem as given follows from the point (z, w) that they describe: w - M z.
template <class S> void Lemke<S>::cover_here() {
  const Index n = n_, cover = dictionary_.column_of(artificial(n));
  for (Index k = 0; k < cover_columns_.cols(); ++k) {
    auto here = k == 0 ? dictionary_.table.col(cover) : dictionary_.values.col(levels_ + k - 1);
    trial_.setZero();
    cover_columns_.col(k).setZero();
    for (Index i = 0; i < n; ++i) {
      here[i] = generic_number<S>(seed(k), i);
      const Index variable = dictionary_.basic[i];
      if (variable < n)
        cover_columns_(variable, k) = here[i];
      else
        trial_[variable - n] = here[i];
    }
    scaled_product(trial_.data(), product_.data());
    cover_columns_.col(k) -= product_;
  }
}

/// out = R M C z.
template <class S> void Lemke<S>::scaled_product(const S* z_scaled, S* out) {
  for (Index i = 0; i < n_; ++i) scratch_[i] = z_scaled[i] * column_scale_[i];
  multiply(problem_, scratch_.data(), out);
  for (Index i = 0; i < n_; ++i) out[i] *= row_scale_[i];
}

/// Gauss-Jordan with complete pivoting from the basis of all w to the one in target_ (basic
/// variables in any order). Returns how many of its z are left when pivots above `smallest_pivot`
/// end: then candidates_ holds the w that should have left, target_ the z that should have entered.
template <class S> Index Lemke<S>::factor_target(const S& smallest_pivot) {
  const Index n = n_;
  // candidates_: rows whose w is to leave; target_: columns whose variable is to enter.
  Index wanted = 0, leaving = 0;
  for (Index i = 0; i < n; ++i) candidates_[i] = 1;
  for (Index k = 0; k < n; ++k)
    if (target_[k] < n) candidates_[target_[k]] = 0;
  for (Index i = 0; i < n; ++i)
    if (candidates_[i] != 0) candidates_[leaving++] = static_cast<int>(i);
  for (Index k = 0; k < n; ++k)
    if (target_[k] >= n) target_[wanted++] = target_[k] - static_cast<int>(n);
  for (; wanted > 0; --wanted) {
    S largest = smallest_pivot;
    Index row = -1, column = -1;
    for (Index k = 0; k < wanted; ++k)
      for (Index i = 0; i < wanted; ++i) {
        const S x = dictionary_.table(candidates_[i], target_[k]);
        const S size = x < S(0) ? S(-x) : x;
        if (!(size > largest)) continue;
        largest = size;
        row = i;
        column = k;
      }
    if (row < 0) return wanted;
    dictionary_.exchange(candidates_[row], target_[column], scratch_);
    candidates_[row] = candidates_[wanted - 1];
    target_[column] = target_[wanted - 1];
  }
  return 0;
}

/// After factor_target has left some: makes the basis complementary again, without them. Where w_i
/// has stayed but z_i has entered, and z_j has not entered but w_j has left, z_i leaves for w_j.
/// False if that is singular too.
template <class S> bool Lemke<S>::drop_pairs(Index left, const S& smallest_pivot) {
  const Index n = n_;
  Index both = 0, neither = 0; // of a pair's two variables: basic
  for (Index k = 0; k < left; ++k) {
    const Index i = candidates_[k];
    if (dictionary_.row_of(unknown(i, n)) >= 0) candidates_[both++] = static_cast<int>(i);
  }
  for (Index k = 0; k < left; ++k) {
    const Index j = target_[k];
    if (dictionary_.column_of(slack(j)) >= 0) target_[neither++] = static_cast<int>(j);
  }
  for (; both > 0; --both) {
    S largest = smallest_pivot;
    Index at = -1, to = -1;
    for (Index k = 0; k < both; ++k)
      for (Index l = 0; l < both; ++l) {
        const S x = dictionary_.table(dictionary_.row_of(unknown(candidates_[k], n)),
                                      dictionary_.column_of(slack(target_[l])));
        const S size = x < S(0) ? S(-x) : x;
        if (!(size > largest)) continue;
        largest = size;
        at = k;
        to = l;
      }
    if (at < 0) return false;
    dictionary_.exchange(dictionary_.row_of(unknown(candidates_[at], n)),
                         dictionary_.column_of(slack(target_[to])), scratch_);
    candidates_[at] = candidates_[both - 1];
    target_[to] = target_[both - 1];
  }
  return true;
}

/// The present basis, factored afresh from the problem as given.
template <class S> bool Lemke<S>::refactorise() {
  for (Index i = 0; i < n_; ++i) target_[i] = dictionary_.basic[i];
  load();
  return fresh_ = factor_target(options_.tolerances.pivot * options_.tolerances.tie) == 0;
}

/// Has rounding in the dictionary moved the finite basic values away from w = q + M z + d z0?
template <class S> bool Lemke<S>::drifted() {
  const Index n = n_, k = finite_level();
  S z0(0), largest(1);
  trial_.setZero();
  for (Index i = 0; i < n; ++i) {
    const Index variable = dictionary_.basic[i];
    const S value = dictionary_.values(i, k);
    largest = value > largest ? value : largest;
    if (variable == artificial(n))
      z0 = value;
    else if (variable >= n)
      trial_[variable - n] = value;
  }
  scaled_product(trial_.data(), product_.data());
  for (Index i = 0; i < n; ++i)
    product_[i] += problem_.q[i] * row_scale_[i] / level_scale_[k] + cover_columns_(i, 0) * z0;
  for (Index i = 0; i < n; ++i)
    if (dictionary_.basic[i] < n) product_[dictionary_.basic[i]] -= dictionary_.values(i, k);
  const S allowed = S(100) * options_.tolerances.tie * largest;
  return !(product_.cwiseAbs().maxCoeff() <= allowed);
}

/// z at one level: read from the dictionary, then refined on the problem as given. The dictionary
/// holds the inverse of the basis (rows of basic z, columns of nonbasic w), so a residual r in
/// those w is removed by z -= inverse r.
template <class S> void Lemke<S>::refine(Index level) {
  const Index n = n_;
  const S scale = level_scale_[level];
  auto z = solution_.col(level);
  z.setZero();
  for (Index i = 0; i < n; ++i)
    if (dictionary_.basic[i] >= n && dictionary_.basic[i] < artificial(n)) {
      const Index j = dictionary_.basic[i] - n;
      z[j] = dictionary_.values(i, level) * scale * column_scale_[j];
    }
  S before(-1);
  for (int round = 0; round < 4; ++round) {
    multiply(problem_, z.data(), product_.data());
    scratch_.setZero();
    S largest(0);
    for (Index c = 0; c <= n; ++c) {
      const Index j = dictionary_.nonbasic[c];
      if (j >= n) continue;
      const S r = (product_[j] + right_hand_side(level)[j]) * row_scale_[j];
      largest = r > largest ? r : -r > largest ? S(-r) : largest;
      if (r != S(0)) scratch_ += dictionary_.table.col(c) * r;
    }
    if (!(largest > S(0)) || (before >= S(0) && !(largest < before))) return;
    before = largest;
    for (Index i = 0; i < n; ++i)
      if (dictionary_.basic[i] >= n && dictionary_.basic[i] < artificial(n)) {
        const Index j = dictionary_.basic[i] - n;
        z[j] -= scratch_[i] * column_scale_[j];
      }
  }
}

template <class S> WorstRow<S> Lemke<S>::referee(const S* q, const S* z) {
  return natural_residual(
      problem_, q, z, unit_.data(), [&](Index i) { return i >= problem_.free_begin; },
      product_.data(), check_scratch_.data);
}

/// Is every free unknown at S plus something finite, and nothing else of order S?
template <class S> bool Lemke<S>::bound_is_slack() const {
  for (Index i = 0; i < n_ && finite_level() > 0; ++i) {
    const S off = solution_(i, 0) - (i >= problem_.free_begin ? S(1) : S(0));
    if (!((off < S(0) ? S(-off) : off) <= options_.tolerances.residual)) return false;
  }
  return true;
}

/// The range 0 <= sigma <= valid_to_ in which this basis is feasible. False if it is empty: some
/// variable is 0 now and falls with the push.
template <class S> bool Lemke<S>::find_range() {
  const Index finite = finite_level(), push = finite + 1;
  valid_to_ = S(-1);
  for (Index i = 0; i < n_; ++i) {
    const bool is_free = dictionary_.basic[i] >= n_ + problem_.free_begin;
    const S rate = dictionary_.values(i, push), value = dictionary_.values(i, finite);
    if (is_free || !(rate < -tie_tolerance_)) continue;
    if (!(value > tie_tolerance_)) return false;
    const S reach = value * level_scale_[finite] / (-rate * level_scale_[push]);
    if (valid_to_ < S(0) || reach < valid_to_) valid_to_ = reach;
  }
  return true;
}

/// Every level against the referee. With a push, at rest and half-way through the range in which
/// this basis claims to hold: the answer is linear, and find_range has seen to its signs.
template <class S> bool Lemke<S>::passes_check() {
  const Index finite = finite_level(), push = finite + 1;
  const S tolerance = options_.tolerances.residual;
  reason_ = Reason::residual;
  if (!bound_is_slack()) {
    reason_ = Reason::retreat;
    return false;
  }
  for (Index i = 0; i < problem_.free_begin; ++i) {
    // Rounding may leave a basic value of zero on the wrong side of it.
    S& z = solution_(i, finite);
    if (z < S(0) && -z <= tolerance * unit_[i] * level_scale_[finite]) z = S(0);
  }
  residual_ = referee(problem_.q, solution_.col(finite).data());
  if (!(residual_.residual <= tolerance)) return false;
  if (problem_.push == nullptr) return true;
  if (!find_range()) return false;
  // Not the very end of the range: there the answer may be all zeros, and rounding its scale.
  const S sigma = valid_to_ < S(0) ? level_scale_[finite] / level_scale_[push] : valid_to_ / S(2);
  for (Index i = 0; i < n_; ++i) {
    trial_[i] = solution_(i, finite) + sigma * solution_(i, push);
    scratch_[i] = problem_.q[i] + sigma * problem_.push[i];
  }
  const WorstRow<S> pushed = referee(scratch_.data(), trial_.data());
  if (!(pushed.residual <= residual_.residual)) residual_ = pushed;
  return pushed.residual <= tolerance;
}

template <class S> S Lemke<S>::artificial_value() const {
  const Index row = dictionary_.row_of(artificial(n_));
  return row < 0 ? S(0) : S(dictionary_.values(row, finite_level()) * level_scale_[finite_level()]);
}

template <class S>
Status Lemke<S>::init(const Problem<S>& problem, const LemkeOptions<S>& options) {
  if (prepare(problem, options) != Status::running) return status_;
  load();
  cover_cold();
  return status_;
}

template <class S>
Status Lemke<S>::init(const Problem<S>& problem, const LemkeOptions<S>& options,
                      const unsigned char* active, Guess guess) {
  if (prepare(problem, options) != Status::running) return status_;
  cover_columns_.setOnes();
  load();
  for (Index i = 0; i < n_; ++i)
    target_[i] = static_cast<int>(active[i] != 0 ? unknown(i, n_) : slack(i));
  const Tolerances<S>& tolerances = options.tolerances;
  const S smallest =
      guess == Guess::basis ? S(tolerances.pivot * tolerances.tie) : tolerances.noise;
  const Index left = factor_target(smallest);
  if (left > 0 && (guess == Guess::basis || !drop_pairs(left, smallest)))
    return end(Status::numerical_breakdown, Reason::singular_basis);
  cover_here();
  entering_ = -1;
  return status_;
}

} // namespace lcpush
