#include "certify/mixed_problem.hpp"

#include "lcpush/mechanics/model/laws.hpp"

namespace lcpush::desktop {
namespace {

const Scales<Rational> si = {1, 1, 1};

/// The laws in the paper's order, one row each.
class SceneRows {
public:
  explicit SceneRows(const Scene<Rational>& scene) : scene_(scene) {
    for (Index b = 0; b < scene.bodies.size; ++b) {
      const Body<Rational>& body = scene.bodies[b];
      pairs_ += body.point_count * (generator_count(scene, body) + (body.bilateral ? 2 : 1) +
                                    (generator_count(scene, body) > 0 ? 1 : 0));
    }
    twist_ = pairs_ + scene.actuators.size;
    axes_ = scene.planar ? std::vector<Index>{0, 1, 5} : std::vector<Index>{0, 1, 2, 3, 4, 5};
    const auto size = static_cast<std::size_t>(twist_) + axes_.size();
    problem_.rows.resize(size);
    problem_.q.resize(size);
    problem_.free.assign(size, 0);
    for (auto i = static_cast<std::size_t>(pairs_); i < size; ++i) problem_.free[i] = 1;
  }

  MixedProblem build() {
    newton();
    for (Index a = 0; a < scene_.actuators.size; ++a) grip(a);
    for (Index b = 0; b < scene_.bodies.size; ++b)
      for (Index k = 0; k < scene_.bodies[b].point_count; ++k) point(b, k);
    return std::move(problem_);
  }

private:
  const Scene<Rational>& scene_;
  MixedProblem problem_;
  std::vector<Index> axes_; // of the twist that may move
  Index pairs_ = 0, twist_ = 0, next_ = 0;

  void add(Index row, Index column, const Rational& value) {
    if (value.sign() != 0) problem_.rows[static_cast<std::size_t>(row)].push_back({column, value});
  }
  void constant(Index row, const Rational& value) {
    problem_.q[static_cast<std::size_t>(row)] += value;
  }

  /// [T.1] M a - load; the forces are added point by point.
  void newton() {
    Matrix6<Rational> M = Matrix6<Rational>::Zero();
    for (Index i = 0; i < 3; ++i) M(i, i) = scene_.object.mass;
    M.bottomRightCorner<3, 3>() = scene_.object.inertia;
    const Vector6<Rational> load = laws::load(scene_, si);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const Index row = twist_ + static_cast<Index>(i);
      for (std::size_t j = 0; j < axes_.size(); ++j)
        add(row, twist_ + static_cast<Index>(j), M(axes_[i], axes_[j]));
      constant(row, -load[axes_[i]]);
    }
  }

  /// [T.5] m s - tau; the forces are added point by point.
  void grip(Index a) {
    add(pairs_ + a, pairs_ + a, scene_.actuators[a].inertia);
    constant(pairs_ + a, -scene_.actuators[a].force);
  }

  /// A force along `column` of body b: its row of relative acceleration, and what it does to the
  /// object and the actuators.
  void force(Index b, Index unknown, const Vector6<Rational>& column) {
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      add(unknown, twist_ + static_cast<Index>(i), column[axes_[i]]);
      add(twist_ + static_cast<Index>(i), unknown, -column[axes_[i]]);
    }
    for (const Drive<Rational>& drive : scene_.drives) {
      if (drive.body != b) continue;
      const Rational power = laws::grip_coefficient(drive, column, Rational(1), si);
      add(unknown, pairs_ + drive.actuator, -power);
      add(pairs_ + drive.actuator, unknown, power);
    }
    constant(unknown, -column.dot(scene_.bodies[b].acceleration));
  }

  /// [T.2], [T.3] and [T.4] of one point.
  void point(Index b, Index k) {
    const Body<Rational>& body = scene_.bodies[b];
    const Vector3<Rational>& p = scene_.points[body.first_point + k];
    const Index lambda = next_, normals = body.bilateral ? 2 : 1;
    const Vector6<Rational> normal = laws::normal_direction(body, p, si);
    force(b, next_++, normal);
    if (body.bilateral) force(b, next_++, -normal);
    const Index generators = generator_count(scene_, body);
    if (generators == 0) return;
    const Index slip = next_ + generators;
    for (Index i = 0; i < normals; ++i) add(slip, lambda + i, body.friction);
    for (Index j = 0; j < generators; ++j, ++next_) {
      force(b, next_, laws::friction_direction(body, p, generator(body, j, scene_.facets), si));
      add(next_, slip, 1);
      add(slip, next_, -1);
    }
    ++next_;
  }
};

} // namespace

MixedProblem scene_problem(const SceneOf<Rational>& scene) {
  const Scene<Rational> view = scene.view();
  return SceneRows(view).build();
}

MixedProblem raw_mixed_problem(const ExactMatrix& M, const ExactMatrix& q,
                               const std::vector<unsigned char>& free) {
  MixedProblem problem;
  problem.rows.resize(static_cast<std::size_t>(M.rows));
  for (Index j = 0; j < M.cols; ++j)
    for (Index i = 0; i < M.rows; ++i)
      if (M(i, j).sign() != 0) problem.rows[static_cast<std::size_t>(i)].push_back({j, M(i, j)});
  problem.q = q.values;
  problem.free = free;
  return problem;
}

// All over one denominator, so that no divisors of long numbers are sought.
Column times(const MixedProblem& problem, Column x, const Column& constant) {
  BigInteger below = 1;
  for (const Rational& number : x) below = common_multiple(below, number.denominator());
  for (Rational& number : x)
    number = Rational(number.numerator() * (below / number.denominator()), 1);
  Column result;
  for (std::size_t i = 0; i < problem.size(); ++i) {
    Rational sum = constant.empty() ? Rational(0) : constant[i] * Rational(below, 1);
    for (const ExactEntry& entry : problem.rows[i]) {
      const Rational& by = x[static_cast<std::size_t>(entry.column)];
      if (by.sign() != 0) sum += entry.value * by;
    }
    result.push_back(
        sum.sign() == 0 ? sum : Rational::unreduced(sum.numerator(), sum.denominator() * below));
  }
  return result;
}

std::vector<ExactRow> cut(const MixedProblem& problem, const std::vector<std::size_t>& rows,
                          const std::vector<std::size_t>& columns) {
  std::vector<Index> place(problem.size(), -1);
  for (std::size_t j = 0; j < columns.size(); ++j) place[columns[j]] = static_cast<Index>(j);
  std::vector<ExactRow> result;
  for (const std::size_t i : rows) {
    ExactRow& row = result.emplace_back();
    for (const ExactEntry& entry : problem.rows[i])
      if (place[static_cast<std::size_t>(entry.column)] >= 0)
        row.push_back({place[static_cast<std::size_t>(entry.column)], entry.value});
  }
  return result;
}

} // namespace lcpush::desktop
