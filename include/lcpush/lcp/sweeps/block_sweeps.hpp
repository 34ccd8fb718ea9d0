// The moves of block Gauss-Seidel. Included by block_gauss_seidel.hpp.
#pragma once

#include "lcpush/lcp/sweeps/block_gauss_seidel.hpp"

namespace lcpush {

template <class S> bool BlockGaussSeidel<S>::carve() {
  const Index n = problem_.size, sums = factored().sums.size;
  Index couplings = 0;
  for (const SumGroup<S>& sum : factored().sums) couplings += sum.count;
  Block<S> scalars(scalars_);
  Block<int> integers(integers_);
  for (Span<S>* span : {&z_, &unit_, &check_w_}) *span = scalars.take(n);
  check_scratch_ = scalars.take(2 * n);
  cone_of_ = integers.take(n);
  sum_of_ = integers.take(n);
  newton_ = ProximalNewton<S>(scalars.take(proximal_scalars(n, couplings, sums)),
                              integers.take(proximal_integers(n, couplings, sums)));
  return !scalars.exhausted() && !integers.exhausted();
}

/// Which sum groups are simplices: of normals that only push, without inertia, each in one sum.
template <class S> void BlockGaussSeidel<S>::sort_groups() {
  for (Index i = 0; i < problem_.size; ++i) cone_of_[i] = sum_of_[i] = -1;
  for (Index c = 0; c < factored().cones.size; ++c)
    if (factored().cones[c].normals == 1)
      cone_of_[factored().cones[c].variable] = static_cast<int>(c);
  keeps_all_sums_ = true;
  for (Index a = 0; a < factored().sums.size; ++a) {
    const SumGroup<S>& sum = factored().sums[a];
    bool simplex = sum.count > 0 && !(sum.inertia > S(0));
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const Index i = factored().coupled_variable[k];
      simplex = simplex && factored().coupling[k] > S(0) && cone_of_[i] >= 0 && sum_of_[i] < 0;
      sum_of_[i] = static_cast<int>(a);
    }
    keeps_all_sums_ = keeps_all_sums_ && simplex;
  }
}

/// Forces to start from: each sum's target spread evenly over the normals that it couples.
template <class S> void BlockGaussSeidel<S>::share_evenly() {
  for (Index i = 0; i < problem_.size; ++i) z_[i] = S(0);
  for (const SumGroup<S>& sum : factored().sums) {
    S total(0);
    const auto counts = [&](Index k) {
      return cone_of_[factored().coupled_variable[k]] >= 0 && factored().coupling[k] > S(0);
    };
    for (Index k = sum.first; k < sum.first + sum.count; ++k)
      if (counts(k)) total += factored().coupling[k];
    for (Index k = sum.first; k < sum.first + sum.count; ++k)
      if (counts(k)) z_[factored().coupled_variable[k]] = sum.target / total;
  }
}

template <class S>
template <class Watcher>
Status BlockGaussSeidel<S>::init(const Problem<S>& problem, const SweepOptions<S>& options,
                                 const S* start, Watcher& watcher) {
  this->begin(problem, options);
  if (problem.factored == nullptr || !carve()) return status_ = Status::bad_input;
  sort_groups();
  if (start == nullptr)
    share_evenly();
  else
    for (Index i = 0; i < problem.size; ++i) z_[i] = start[i];
  for (Index i = 0; i < problem.size; ++i) unit_[i] = S(1);
  refresh();
  if (!keeps_all_sums_ && !options.accelerate) return status_ = Status::bad_input;
  status_ = Status::running;
  recover_multipliers();
  return check(watcher);
}

/// Moves force from entry l of a simplex to entry k, or back, to where their rates agree.
template <class S> void BlockGaussSeidel<S>::exchange(const SumGroup<S>& sum, Index k, Index l) {
  const Index i = factored().coupled_variable[sum.first + k];
  const Index j = factored().coupled_variable[sum.first + l];
  const S a = factored().coupling[sum.first + k], b = factored().coupling[sum.first + l];
  const ConeGroup<S>& to = factored().cones[cone_of_[i]];
  const ConeGroup<S>& from = factored().cones[cone_of_[j]];
  const Vector6<S> move = factored().wrenches[to.force] / a - factored().wrenches[from.force] / b;
  const Vector6<S> follows = factored().mobility.lazyProduct(move);
  const S slope = (rate(to.force, i) + to.compliance * z_[i]) / a -
                  (rate(from.force, j) + from.compliance * z_[j]) / b;
  const S curvature = move.dot(follows) + to.compliance / (a * a) + from.compliance / (b * b);
  const S most = z_[j] * b, least = -z_[i] * a;
  S amount(0);
  if (curvature > S(0))
    amount = -slope / curvature;
  else if (slope != S(0))
    amount = slope < S(0) ? most : least;
  if (amount > most) amount = most;
  if (amount < least) amount = least;
  if (amount == S(0)) return;
  u_ += follows * amount;
  z_[i] = amount == least ? S(0) : S(z_[i] + amount / a);
  z_[j] = amount == most ? S(0) : S(z_[j] - amount / b);
}

/// The normal force of a cone group that no sum holds, for its row alone: a closed form.
template <class S> void BlockGaussSeidel<S>::solve_normal(const ConeGroup<S>& cone) {
  const Vector6<S>& W = factored().wrenches[cone.force];
  const Vector6<S> follows = factored().mobility.lazyProduct(W);
  const S before = cone.normal_force(z_.data);
  const S curvature = W.dot(follows) + cone.compliance;
  if (!(curvature > S(0))) return; // nothing that this force does moves the object
  S lambda = before - (rate(cone.force, cone.variable) + cone.compliance * before) / curvature;
  if (cone.normals == 1 && !(lambda > S(0))) lambda = S(0);
  u_ += follows * (lambda - before);
  cone.set_normal_force(z_.data, lambda);
}

/// The normal force may have fallen below what friction rests on.
template <class S>
void BlockGaussSeidel<S>::shrink_to_cone(const ConeGroup<S>& cone, const S& most) {
  const Index first = cone.variable + cone.normals;
  S total(0);
  for (Index k = 0; k < cone.generators; ++k) total += z_[first + k];
  if (!(total > most)) return;
  const S share = most / total;
  Vector6<S> change = Vector6<S>::Zero();
  for (Index k = 0; k < cone.generators; ++k) {
    const S next = z_[first + k] * share;
    change += factored().wrenches[cone.force + cone.normals + k] * (next - z_[first + k]);
    z_[first + k] = next;
  }
  u_ += factored().mobility.lazyProduct(change);
}

/// Friction on its simplex: moves from the generator that loses most to the one that gains most,
/// the unused rest of the cone among them, until no move pays.
template <class S> void BlockGaussSeidel<S>::solve_friction(const ConeGroup<S>& cone) {
  const Index first = cone.variable + cone.normals, force = cone.force + cone.normals;
  const Index rest = cone.generators; // stands for what the cone leaves unused
  const S most = cone.friction_limit(z_.data);
  shrink_to_cone(cone, most);
  S unused = most;
  for (Index k = 0; k < cone.generators; ++k) unused -= z_[first + k];
  for (int move = 0; move < GaussSeidelSettings::friction_moves; ++move) {
    Index to = rest, from = unused > S(0) ? rest : -1;
    S least(0), largest(0);
    for (Index k = 0; k < cone.generators; ++k) {
      const S r = rate(force + k, first + k);
      if (r < least) {
        least = r;
        to = k;
      }
      if (z_[first + k] > S(0) && (from < 0 || r > largest)) {
        largest = r;
        from = k;
      }
    }
    if (from < 0 || from == to || !(largest > least)) return;
    Vector6<S> direction = Vector6<S>::Zero();
    if (to != rest) direction += factored().wrenches[force + to];
    if (from != rest) direction -= factored().wrenches[force + from];
    const Vector6<S> follows = factored().mobility.lazyProduct(direction);
    const S curvature = direction.dot(follows),
            available = from == rest ? unused : z_[first + from];
    S amount = curvature > S(0) ? S((largest - least) / curvature) : available;
    if (amount > available) amount = available;
    u_ += follows * amount;
    if (to != rest) z_[first + to] += amount;
    if (from != rest) z_[first + from] = amount == available ? S(0) : S(z_[first + from] - amount);
    unused += (from == rest ? -amount : S(0)) + (to == rest ? amount : S(0));
  }
}

template <class S> template <class Watcher> Status BlockGaussSeidel<S>::sweep(Watcher& watcher) {
  if (status_ != Status::running) return status_;
  if (!keeps_all_sums_) return status_ = Status::bad_input;
  for (const SumGroup<S>& sum : factored().sums) {
    // Neighbours at a distance that changes with the sweep, so that all pairs meet in time.
    const Index distance = sum.count > 1 ? 1 + sweeps_ % (sum.count - 1) : 0;
    for (Index k = 0; distance > 0 && k < sum.count; ++k)
      exchange(sum, k, (k + distance) % sum.count);
  }
  for (const ConeGroup<S>& cone : factored().cones) {
    if (sum_of_[cone.variable] < 0) solve_normal(cone);
    if (cone.generators > 0) solve_friction(cone);
  }
  ++sweeps_;
  if (!this->is_check_due()) return status_;
  refresh();
  recover_multipliers();
  return check(watcher);
}

/// xi and s of the present forces.
template <class S> void BlockGaussSeidel<S>::recover_multipliers() {
  for (const ConeGroup<S>& cone : factored().cones) {
    S xi(0);
    for (Index k = cone.normals; k < cone.forces(); ++k)
      xi = Eigen::numext::maxi(xi, S(-rate(cone.force + k, cone.variable + k)));
    if (cone.generators > 0) z_[cone.slip()] = xi;
  }
  for (Index a = 0; keeps_all_sums_ && a < factored().sums.size; ++a) {
    const SumGroup<S>& sum = factored().sums[a];
    bool first = true;
    S& s = z_[problem_.free_begin + a];
    for (Index k = sum.first; k < sum.first + sum.count; ++k) {
      const Index i = factored().coupled_variable[k];
      const ConeGroup<S>& cone = factored().cones[cone_of_[i]];
      const S closes = (rate(cone.force, i) + cone.compliance * z_[i]) / factored().coupling[k];
      if (first || closes < s) s = closes;
      first = false;
    }
  }
}

template <class S> template <class Watcher> Status BlockGaussSeidel<S>::check(Watcher& watcher) {
  this->ask_referee();
  if (runs_away())
    status_ = Status::stagnated;
  else if (passes())
    status_ = Status::solved;
  else
    this->go_on(GaussSeidelSettings::patience_of_groups);
  watcher.checked(*this);
  return status_;
}

/// The largest normal force by the largest number that the problem asks for; at least 1.
template <class S> S BlockGaussSeidel<S>::squeeze() const {
  S asked(1), largest(0);
  for (Index i = 0; i < problem_.size; ++i)
    asked = Eigen::numext::maxi(asked, Eigen::numext::abs(problem_.q[i]));
  for (const ConeGroup<S>& cone : factored().cones)
    for (Index k = 0; k < cone.normals; ++k)
      largest = Eigen::numext::maxi(largest, z_[cone.variable + k]);
  return largest > asked ? S(largest / asked) : S(1);
}

/// ProximalNewton with eps falling while it settles, and rising where it does not.
template <class S> template <class Watcher> Status BlockGaussSeidel<S>::finish(Watcher& watcher) {
  using Settings = ProximalSettings;
  using Eigen::numext::sqrt;
  const S most_eps(Settings::most), least_eps = Settings::least<S>();
  S eps(Settings::first), factor(Settings::factor);
  if (!newton_.init(problem_, z_.data)) return status_ = Status::bad_input;
  const Index swept = sweeps_;
  while (status_ == Status::running) {
    const bool settled = newton_.settle(eps, Settings::passes_each);
    sweeps_ = swept + newton_.passes();
    if (!settled) {
      eps = Eigen::numext::mini(most_eps, S(S(Settings::rise) * eps));
      factor = factor < S(Settings::slowest) ? S(sqrt(factor)) : S(Settings::factor);
    } else {
      newton_.recover(z_.data);
      eps = Eigen::numext::maxi(least_eps, S(factor * eps));
      (void)check(watcher);
    }
    if (status_ == Status::running && this->is_last()) status_ = Status::sweep_limit;
  }
  return status_;
}

template <class S> template <class Watcher> Status BlockGaussSeidel<S>::solve(Watcher& watcher) {
  while (status_ == Status::running &&
         !(options_.accelerate && sweeps_ >= GaussSeidelSettings::warming)) {
    if (options_.accelerate && !keeps_all_sums_) break;
    (void)sweep(watcher);
  }
  return status_ == Status::running ? finish(watcher) : status_;
}

} // namespace lcpush
