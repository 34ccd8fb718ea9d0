// Contact problems of bodies that lean on each other: what is wrong is seen wherever it stands, and
// contacts are told by what they do. Judged here by laws written out once more.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "contacts/contact_order.hpp"
#include "lcpush/desktop/contacts.hpp"
#include <Eigen/Geometry>

using namespace lcpush;
using namespace lcpush::desktop;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

using Random = std::mt19937;

double uniform(Random& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

ContactProblem contact_problem(const MatrixXd& W, const VectorXd& b, const VectorXd& mu) {
  ContactProblem problem;
  problem.W.cols = W.cols();
  for (Index i = 0; i < W.rows(); ++i) problem.W.add_row(W.row(i));
  problem.b = b;
  problem.mu = mu;
  problem.V = MatrixXd::Zero(b.size(), 0);
  return problem;
}

/// Bodies of masses from 1 to `ratio` (kg) that touch each other and the ground anyhow, from above.
ContactProblem heap(Random& random, Index bodies, Index contacts, double ratio) {
  std::normal_distribution<double> normal;
  const auto vector = [&] { return Vector3d(normal(random), normal(random), normal(random)); };
  MatrixXd H = MatrixXd::Zero(6 * bodies, 3 * contacts), moved;
  VectorXd inverse(6 * bodies), pull = VectorXd::Zero(6 * bodies), mu(contacts);
  const double shake = std::floor(uniform(random, 0, 3)) * 2; // m/s^2
  for (Index i = 0; i < bodies; ++i) {
    const double mass = i == 0            ? 1
                        : i + 1 == bodies ? ratio
                                          : std::pow(ratio, uniform(random, 0, 1));
    for (Index k = 0; k < 6; ++k)
      inverse[6 * i + k] = 1 / (mass * (k < 3 ? 1 : uniform(random, 0.05, 0.5)));
    pull.segment<3>(6 * i) = shake * vector() - Vector3d(0, 0, 9.81);
    pull.segment<3>(6 * i + 3) = shake * vector();
  }
  for (Index c = 0; c < contacts; ++c) {
    Vector3d n = vector();
    n[2] = std::abs(n[2]) + 0.3;
    n.normalize();
    const Vector3d t = n.cross(Vector3d::UnitX()).normalized();
    const Index i = std::uniform_int_distribution<Index>(0, bodies - 1)(random),
                j = std::uniform_int_distribution<Index>(-1, i - 1)(random);
    for (const auto& [body, sign] : {std::pair<Index, double>(i, 1), {j, -1}}) {
      const Vector3d at = 0.5 * vector();
      Index column = 3 * c;
      for (const Vector3d& d : {n, t, Vector3d(n.cross(t))}) {
        if (body >= 0) {
          H.block<3, 1>(6 * body, column) = sign * d;
          H.block<3, 1>(6 * body + 3, column) = sign * at.cross(d);
        }
        ++column;
      }
    }
    mu[c] = uniform(random, 0.1, 1);
  }
  moved = inverse.asDiagonal() * H;
  return contact_problem(H.transpose() * moved, H.transpose() * pull, mu);
}

/// A block of `mass` (kg) at rest and another of 1 kg, of friction 1/2, that `push` (N) moves.
ContactProblem two_blocks(double mass, double push) {
  VectorXd w(6), b(6);
  w << 1 / mass, 1 / mass, 1 / mass, 1, 1, 1;
  b << -9.81, 0, 0, -9.81, push, 0;
  return contact_problem(w.asDiagonal(), b, VectorXd::Constant(2, 0.5));
}

/// One contact's force changed in one of its ways: turned, less or more, pulling, not there.
VectorXd changed(Random& random, const ContactProblem& problem, const ContactForces& answer) {
  const Index c = std::uniform_int_distribution<Index>(0, problem.contacts() - 1)(random);
  VectorXd r = answer.r;
  auto force = r.segment<3>(3 * c);
  if (answer.modes[static_cast<std::size_t>(c)] == ForceMode::open) {
    force[0] = 0.01 * r.maxCoeff() * (uniform(random, 0, 1) < 0.5 ? -1 : 1);
    return r;
  }
  const double a = uniform(random, 0.05, 3), x = force[1], y = force[2];
  switch (std::uniform_int_distribution<int>(0, 5)(random)) {
  case 0: force[0] *= -1; break;
  case 1:
    force.tail<2>() << std::cos(a) * x - std::sin(a) * y, std::sin(a) * x + std::cos(a) * y;
    break;
  case 2: force.tail<2>() *= uniform(random, 0, 0.95); break;
  case 3: force.tail<2>() *= 1.05 * problem.mu[c] * force[0] / force.tail<2>().norm(); break;
  case 4: force.setZero(); break;
  default:
    force *= 1 + (uniform(random, 0, 1) < 0.5 ? -1 : 1) * std::pow(10, uniform(random, -4, -1));
  }
  return r;
}

} // namespace

TEST_CASE("contacts of a chain, shuffled, are eliminated along the chain") {
  Random random(7);
  const Index k = 40;
  std::vector<Index> place(static_cast<std::size_t>(k)); // link i of the chain is contact place[i]
  for (Index i = 0; i < k; ++i) place[static_cast<std::size_t>(i)] = i;
  std::shuffle(place.begin(), place.end(), random);
  MatrixXd W = 2 * MatrixXd::Identity(3 * k, 3 * k);
  for (Index i = 0; i + 1 < k; ++i) {
    const Index a = 3 * place[static_cast<std::size_t>(i)],
                b = 3 * place[static_cast<std::size_t>(i) + 1];
    W(a, b) = W(b, a) = -1;
  }
  const std::vector<Index> order =
      contact_order(contact_problem(W, VectorXd::Zero(3 * k), VectorXd::Zero(k)).W);
  REQUIRE(order.size() == static_cast<std::size_t>(k));
  for (std::size_t i = 0; i + 1 < order.size(); ++i) CHECK(W(3 * order[i], 3 * order[i + 1]) == -1);
}

TEST_CASE("a heavy block elsewhere hides nothing of a light one") {
  for (const double mass : {1.0, 1e3, 1e6, 1e9, 1e12, 1e15}) {
    CAPTURE(mass);
    const ContactProblem slides = two_blocks(mass, 8), rests = two_blocks(mass, 3);
    const auto judged = [&](const ContactProblem& problem, double normal, double friction) {
      VectorXd r(6);
      r << 9.81 * mass, 0, 0, normal, friction, 0;
      return judge_contacts(problem, r, usual_contact_tolerance);
    };
    CHECK(judged(slides, 9.81, -4.905).is_good);
    CHECK(judged(rests, 9.81, -3).is_good);
    for (const double friction : {-4.905 * 1.0003, -4.905 * 0.9997, -7.9, 0.0, 4.905})
      CHECK_FALSE(judged(slides, 9.81, friction).is_good);
    CHECK_FALSE(judged(slides, 0, 0).is_good);
    CHECK_FALSE(judged(rests, 9.81, -3.001).is_good);
    CHECK(judged(slides, 9.81, 0).modes[1] == ForceMode::slip);
    const ContactForces found = solve_contacts(slides);
    CHECK(found.is_good);
    CHECK(found.r[4] == doctest::Approx(-4.905).epsilon(1e-12));
  }
}

TEST_CASE("of two thousand forces with one of them changed none is accepted") {
  Random random(5);
  Index told = 0;
  for (int k = 0; k < 50; ++k) {
    const ContactProblem problem =
        heap(random, 1 + k % 7, 1 + k % 15, std::pow(10, 1.5 * (k % 3))); // 1, 32 and 1000
    const ContactForces answer = solve_contacts(problem);
    if (!answer.is_good || !(answer.r.maxCoeff() > 0)) continue;
    CHECK(judge_contacts(problem, answer.r, usual_contact_tolerance).is_good);
    for (int change = 0; change < 40; ++change, ++told) {
      const VectorXd r = changed(random, problem, answer), change_of_r = r - answer.r;
      Index row = 0;
      change_of_r.cwiseAbs().maxCoeff(&row);
      const double moved = std::abs(problem.W(row, row) * change_of_r[row]);
      CAPTURE(moved);
      if (moved <= 1e-5 * problem.b.segment<3>(row - row % 3).cwiseAbs().maxCoeff()) continue;
      CHECK_FALSE(judge_contacts(problem, r, usual_contact_tolerance).is_good);
    }
  }
  CHECK(told >= 1000);
}

TEST_CASE("heaps with masses up to a million have an answer where no path leads there") {
  Random random(9);
  int solved = 0;
  for (int k = 0; k < 100; ++k) {
    const ContactProblem problem = heap(random, 1 + k % 10, 1 + k % 12, 1e6);
    solved += solve_contacts(problem).is_good;
  }
  CHECK(solved == 100); // 99 without those that begin at pyramids
}

TEST_CASE("friction is against every slip beyond rounding, and modes are what velocities say") {
  constexpr double rounding = 1e-14, pi = 3.14159265358979323846;
  Random random(7);
  Index slipping = 0;
  for (int k = 0; k < 60; ++k) {
    CAPTURE(k);
    const ContactProblem problem = heap(random, 2 + k % 10, 2 + k % 23, std::pow(10, 2 * (k % 4)));
    const ContactForces answer = solve_contacts(problem);
    if (!answer.is_good) continue;
    for (Index c = 0; c < problem.contacts(); ++c) {
      CAPTURE(c);
      VectorXd u = problem.b.segment<3>(3 * c), terms = u.cwiseAbs();
      for (Index i = 0; i < 3; ++i)
        for (const SparseEntry& entry : problem.W.row(3 * c + i)) {
          u[i] += entry.value * answer.r[entry.column];
          terms[i] += std::abs(entry.value * answer.r[entry.column]);
        }
      const double speed = u.tail<2>().norm(), unknown = rounding * terms.maxCoeff();
      const auto r = answer.r.segment<3>(3 * c);
      if (!(r[0] > 0) || r.tail<2>().norm() < (1 - 1e-9) * problem.mu[c] * r[0]) continue;
      if (speed <= 10 * unknown || answer.modes[static_cast<std::size_t>(c)] == ForceMode::open)
        continue;
      ++slipping;
      CHECK(answer.modes[static_cast<std::size_t>(c)] == ForceMode::slip);
      const double across = std::abs(r[1] * u[2] - r[2] * u[1]);
      CHECK(std::atan2(across, -r.tail<2>().dot(u.tail<2>())) <= 1e-6 + pi / 2 * unknown / speed);
    }
  }
  CHECK(slipping > 100);
}
