#include "solve/modes_of_forces.hpp"

#include <limits>

#include "dense/decompositions.hpp"

namespace lcpush::desktop {
namespace {

/// Columns that do not depend on each other.
class Independent {
public:
  template <class Column> bool take(const Column& column) {
    constexpr double smallest = 1e-3;
    Eigen::VectorXd rest = column;
    for (const Eigen::VectorXd& taken : taken_) rest -= taken.dot(rest) * taken;
    const double size = rest.norm();
    if (!(size > smallest * column.norm())) return false;
    taken_.push_back(rest / size);
    return true;
  }

private:
  std::vector<Eigen::VectorXd> taken_;
};

} // namespace

ModesOfForces::ModesOfForces(const Problem<double>& problem, const double* z)
    : problem_(problem), z_(z), w_(static_cast<std::size_t>(problem.size)),
      coupling_(Eigen::MatrixXd::Zero(problem.factored->sums.size, problem.size)) {
  multiply(problem, z, w_.data());
  for (Index i = 0; i < problem.size; ++i) w_[static_cast<std::size_t>(i)] += problem.q[i];
  const FactoredProblem<double>& factored = *problem.factored;
  for (Index a = 0; a < factored.sums.size; ++a)
    for (Index e = factored.sums[a].first; e < factored.sums[a].first + factored.sums[a].count; ++e)
      coupling_(a, factored.coupled_variable[e]) += factored.coupling[e];
}

ModesOfForces::Column ModesOfForces::along(const Vector6<double>& object, Index i, Index k) const {
  Column column = Column::Zero();
  column.head<6>() = object;
  column.segment(6, coupling_.rows()) = -coupling_.col(cone(i).variable + k);
  return column;
}
ModesOfForces::Column ModesOfForces::felt(Index i, Index k) const {
  return along(problem_.factored->wrenches[cone(i).force + k], i, k);
}
ModesOfForces::Column ModesOfForces::effect(Index i, Index k) const {
  const Vector6<double>& wrench = problem_.factored->wrenches[cone(i).force + k];
  return along(problem_.factored->mobility.lazyProduct(wrench), i, k);
}

ModesOfForces::Flags ModesOfForces::plain() const {
  Flags active(static_cast<std::size_t>(problem_.size));
  const auto set = [&](Index i) { active[static_cast<std::size_t>(i)] = 1; };
  for (Index i = problem_.free_begin; i < problem_.size; ++i) set(i);
  for (Index i = 0; i < points(); ++i) {
    if (is_pad(i) && z_[cone(i).variable] > 0) set(cone(i).variable);
    if (!slides(i)) continue;
    set(cone(i).slip());
    set(cone(i).variable + against(i));
  }
  return active;
}

std::vector<ModesOfForces::Share> ModesOfForces::open_shares() const {
  std::vector<Share> shares;
  for (Index i = 0; i < points(); ++i) {
    const ConeGroup<double>& of = cone(i);
    const double limit = of.friction_limit(z_), none = std::numeric_limits<double>::infinity();
    const bool slips = slides(i);
    const Index most = slips ? against(i) : -1;
    double pressure = of.normal_force(z_);
    for (Index k = of.normals; k < of.forces(); ++k) {
      const double here = rubs(i, k);
      if (!(here > 1e-9 * limit)) continue;
      if (!is_pad(i)) {
        shares.push_back(
            {i, k, -1, here / of.friction, none, effect(i, 0) + of.friction * effect(i, k)});
        pressure -= here / of.friction;
      } else if (!slips) {
        shares.push_back({i, k, -1, here / limit, 1, limit * effect(i, k)});
      } else if (k != most) {
        shares.push_back({i, k, most, here / limit, 1, limit * (effect(i, k) - effect(i, most))});
      }
    }
    if (!is_pad(i) && pressure > 1e-9 * of.normal_force(z_))
      shares.push_back({i, -1, -1, pressure, none, effect(i, 0)});
  }
  return shares;
}

/// All but a few become 0 or `most`, and the sum of value times column stays. [Caratheodory]
void ModesOfForces::move_to_vertex(std::vector<Share>& shares) {
  constexpr double dependent = 1e-7;
  std::vector<Share*> inside;
  for (Share& share : shares) {
    for (bool is_open = true; is_open;) {
      const auto count = static_cast<Eigen::Index>(inside.size());
      Eigen::MatrixXd columns(most_columns, count);
      for (Eigen::Index k = 0; k < count; ++k)
        columns.col(k) = inside[static_cast<std::size_t>(k)]->column;
      Eigen::VectorXd y;
      if (count > 0) y = least_squares(columns, share.column);
      const Column rest = count > 0 ? Column(share.column - columns * y) : share.column;
      if (count < most_columns && rest.norm() > dependent * share.column.norm()) {
        inside.push_back(&share);
        break;
      }
      // Its share falls, the others take it over, until one of them ends.
      double step = share.value;
      std::size_t blocks = inside.size();
      for (std::size_t k = 0; k < inside.size(); ++k) {
        const double rate = y[static_cast<Eigen::Index>(k)];
        const double reach = rate < 0   ? inside[k]->value / -rate
                             : rate > 0 ? (inside[k]->most - inside[k]->value) / rate
                                        : std::numeric_limits<double>::infinity();
        if (!(reach < step)) continue;
        step = reach;
        blocks = k;
      }
      share.value -= step;
      for (std::size_t k = 0; k < inside.size(); ++k)
        inside[k]->value += step * y[static_cast<Eigen::Index>(k)];
      is_open = blocks < inside.size();
      if (!is_open) {
        share.value = 0;
        continue;
      }
      Share& ends = *inside[blocks];
      ends.value = y[static_cast<Eigen::Index>(blocks)] < 0 ? 0 : ends.most;
      inside.erase(inside.begin() + static_cast<std::ptrdiff_t>(blocks));
    }
  }
}

ModesOfForces::Flags ModesOfForces::vertex() const {
  Flags active = plain();
  std::vector<Share> shares = open_shares();
  move_to_vertex(shares);
  const auto flag = [&](Index i, Index k) -> unsigned char& {
    return active[static_cast<std::size_t>(cone(i).variable + k)];
  };
  Independent independent;
  for (const Share& share : shares) {
    if (!(share.value > 0) || is_pad(share.point) || flag(share.point, 0) != 0) continue;
    flag(share.point, 0) = 1;
    (void)independent.take(felt(share.point, 0));
  }
  for (const Share& share : shares) {
    const Index i = share.point, k = share.generator;
    if (!(share.value > 0) || k < 0) continue;
    if (share.instead >= 0) {
      flag(i, k) = 1;
      if (share.value == share.most) flag(i, share.instead) = 0;
    } else if (!slides(i) && independent.take(felt(i, k))) {
      flag(i, k) = 1;
    }
  }
  return active;
}

} // namespace lcpush::desktop
