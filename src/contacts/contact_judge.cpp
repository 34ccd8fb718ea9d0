// The referee of contact problems: reads the problem as given, and shares no code with the solver.
#include "contacts/settings.hpp"
#include "dense/decompositions.hpp"
#include "dense/simplex.hpp"
#include "lcpush/desktop/contacts.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Sizes = Eigen::Matrix<double, contact_law_count, 1>;

/// The point of the round cone that is nearest.
Vector3d nearest_in_cone(const Vector3d& y, double mu) {
  const double t = y.tail<2>().norm();
  if (t <= mu * y[0]) return y;
  if (mu * t <= -y[0]) return Vector3d::Zero();
  const double n = (y[0] + mu * t) / (1 + mu * mu);
  Vector3d point(n, 0, 0);
  point.tail<2>() = y.tail<2>() * (mu * n / t);
  return point;
}

/// Of force and velocity near 1, told from each other by rounding; what slips within `tolerance`
/// sticks where friction bears it.
ForceMode mode_of(const Vector3d& r, const Vector3d& u, double mu, double tolerance) {
  if (r[0] <= std::max(u[0], ContactSettings::rounding)) return ForceMode::open;
  const double speed = u.tail<2>().norm();
  const bool is_borne = speed <= tolerance && (r - u).tail<2>().norm() <= mu * r[0];
  return speed <= ContactSettings::rounding || is_borne ? ForceMode::stick : ForceMode::slip;
}

/// The laws of a contact, of force and velocity near 1. Both are `known_to` as much, by which
/// directions may be off.
Sizes laws_broken(const Vector3d& r, const Vector3d& u, double mu, double known_to, bool may_slip) {
  Sizes size = Sizes::Zero();
  const auto rt = r.tail<2>(), ut = u.tail<2>();
  const double friction = rt.norm(), speed = ut.norm(), limit = mu * std::max(r[0], 0.0);
  size[0] = std::abs(std::min(r[0], u[0]));
  size[1] = std::max(0.0, friction - limit);
  if (may_slip && speed > known_to && limit > known_to) {
    const double across = std::abs(rt[0] * ut[1] - rt[1] * ut[0]);
    const double angle = friction > known_to ? std::atan2(across, -rt.dot(ut)) : 0; // 0 has none
    const double broken = std::max(angle, (limit - friction) / limit);
    if (broken > std::asin(known_to / std::min(speed, limit))) size[2] = broken;
  }
  const Vector3d dual = u + Vector3d(mu * speed, 0, 0);
  size[3] = (r - nearest_in_cone(r - dual, mu)).norm();
  return size;
}

/// What the last digit of printed forces stands for, as a part of them.
double last_digit(const VectorXd& r) {
  double digit = 1;
  for (const double x : r) {
    const double scale = x == 0 ? 1 : std::pow(10, std::floor(std::log10(std::abs(x))));
    const auto is_whole = [&] {
      const double digits = std::abs(x) / scale / digit;
      return std::abs(digits - std::round(digits)) <= ContactSettings::rounding * digits;
    };
    while (digit > ContactSettings::solved && !is_whole()) digit /= 10;
  }
  return digit;
}

/// l of given forces: from the equality where it has one, else as what presses does not part; u
/// without it, whose terms have `sizes`.
VectorXd fitted_l(const ContactProblem& p, const VectorXd& r, const VectorXd& u,
                  const VectorXd& sizes) {
  const Index e = p.s.size();
  const VectorXd lacks = product(p.V.transpose(), r) + p.s;
  std::vector<Index> rows;
  for (Index c = 0; c < p.contacts(); ++c) {
    const Vector3d f = r.segment<3>(3 * c);
    const double small = usual_contact_tolerance * sizes.segment<3>(3 * c).maxCoeff();
    if (const double w = p.W(3 * c, 3 * c); f[0] <= 0 || (w > 0 && w * f[0] <= small)) continue;
    rows.push_back(3 * c);
    if (f.tail<2>().norm() > (1 - usual_contact_tolerance) * p.mu[c] * f[0]) continue;
    rows.insert(rows.end(), {3 * c + 1, 3 * c + 2});
  }
  const auto count = static_cast<Index>(rows.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(count + e, e);
  VectorXd y = VectorXd::Zero(count + e);
  for (Index a = 0; a < e; ++a) {
    if (p.R[a] == 0) continue;
    A(count + a, a) = 1 / usual_contact_tolerance; // they hold first
    y[count + a] = -lacks[a] / p.R[a] / usual_contact_tolerance;
  }
  for (Index k = 0; k < count; ++k) {
    const Index i = rows[static_cast<std::size_t>(k)];
    if (!(sizes[i] > 0)) continue;
    A.row(k) = p.V.row(i) / sizes[i];
    y[k] = -u[i] / sizes[i];
  }
  return PivotedQr(A).solve(y);
}

} // namespace

std::string contact_hint(const ContactProblem& p, const ContactForces& answer) {
  const auto worst = [](const ContactForces& of) {
    return of.worst[static_cast<Index>(ContactLaw::natural_map)].size;
  };
  if (answer.r.isZero(0)) return ""; // forces of 0 are the same in every order
  const double enough = std::max(answer.tolerance, std::min(ContactSettings::turned * worst(answer),
                                                            ContactSettings::few_digits));
  const auto fits = [&](const ContactProblem& problem, const VectorXd& r) {
    return worst(judge_contacts(problem, r, answer.tolerance)) <= enough;
  };
  if (fits(p, -answer.r))
    return "With every force turned round the laws hold: forces on one of two bodies are asked "
           "for, "
           "these are on the other.";
  VectorXd turned = -answer.r;
  for (Index i = 0; i < turned.size(); i += 3) turned[i] = answer.r[i];
  if (fits(p, turned)) return "With every friction turned round the laws hold.";
  const ContactProblem other = in_other_order(p);
  const std::string order = other.normal_last ? "last" : "first";
  const auto holds = [&](const ContactProblem& problem, const VectorXd& r) {
    return worst(judge_contacts(problem, r, answer.tolerance)) <= answer.tolerance;
  };
  if (holds(other, *other.r)) return "With --normal " + order + " the laws hold.";
  if (holds(p, *other.r))
    return "The laws hold where the forces alone have the normal " + order + ".";
  for (const auto& [factor, text] : {std::pair(ContactSettings::thousand, "times 1000"),
                                     std::pair(1 / ContactSettings::thousand, "divided by 1000")})
    if (fits(p, factor * answer.r))
      return std::string("With every force ") + text +
             " the laws hold: another unit, or impulses of steps of a millisecond?";
  return "";
}

VectorXd contradiction(const ContactProblem& p, const VectorXd& r) {
  VectorXd v = VectorXd::Zero(r.size());
  for (Index i = 0; i < r.size(); i += 3) v[i] = std::max(0.0, r[i]);
  const double largest = v.size() > 0 ? v.maxCoeff() : 0;
  if (!(largest > 0)) return {};
  for (double& x : v) x = x < ContactSettings::weight * largest ? 0 : x / largest;
  const auto is_nothing = [](double sum, double terms) {
    return std::abs(sum) <= ContactSettings::balanced * terms;
  };
  for (Index i = 0; i < v.size(); ++i) {
    double sum = 0, terms = 0;
    for (const SparseEntry& entry : p.W.row(i)) {
      sum += entry.value * v[entry.column];
      terms += std::abs(entry.value * v[entry.column]);
    }
    if (!is_nothing(sum, terms)) return {};
  }
  for (Index a = 0; a < p.V.cols(); ++a)
    if (!is_nothing(p.V.col(a).dot(v), p.V.col(a).cwiseAbs().dot(v))) return {};
  const double closes = p.b.dot(v);
  if (!(closes < 0) || is_nothing(closes, p.b.cwiseAbs().dot(v))) return {};
  VectorXd weights(p.contacts());
  for (Index c = 0; c < weights.size(); ++c) weights[c] = v[3 * c];
  return weights;
}

VectorXd find_contradiction(const ContactProblem& p) {
  const Index k = p.contacts(), n = p.b.size(), e = p.V.cols();
  const double size = n > 0 ? p.b.cwiseAbs().maxCoeff() : 0;
  if (k > ContactSettings::most_refuted || !(size > 0)) return {};
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n + e + 1, k);
  for (Index i = 0; i < n; ++i)
    for (const SparseEntry& entry : p.W.row(i))
      if (entry.column % 3 == 0) A(i, entry.column / 3) = entry.value;
  for (Index c = 0; c < k; ++c) {
    A.block(n, c, e, 1) = p.V.row(3 * c).transpose();
    A(n + e, c) = p.b[3 * c] / size;
  }
  for (Index i = 0; i < n + e; ++i)
    if (const double largest = A.row(i).cwiseAbs().maxCoeff(); largest > 0) A.row(i) /= largest;
  VectorXd closes = VectorXd::Zero(n + e + 1);
  closes[n + e] = -1;
  const auto weights = cheapest_point(A, closes, VectorXd::Zero(k), 0);
  if (!weights) return {};
  VectorXd r = VectorXd::Zero(n);
  for (Index c = 0; c < k; ++c) r[3 * c] = (*weights)[c];
  return contradiction(p, r);
}

ContactForces judge_contacts(const ContactProblem& p, const VectorXd& r, double tolerance,
                             const VectorXd* l) {
  ContactForces answer;
  answer.tolerance = tolerance;
  answer.r = r;
  const Index n = p.b.size(), k = p.contacts();
  VectorXd sizes = p.b.cwiseAbs(), own = sizes, diagonal = VectorXd::Zero(n);
  answer.u = p.b;
  for (Index i = 0; i < n; ++i)
    for (const SparseEntry& entry : p.W.row(i)) {
      const double term = entry.value * r[entry.column];
      answer.u[i] += term;
      sizes[i] += std::abs(term);
      if (entry.column / 3 == i / 3) own[i] += std::abs(term);
      if (entry.column == i) diagonal[i] = entry.value;
    }
  answer.l = l != nullptr ? *l : fitted_l(p, r, answer.u, sizes);
  answer.u += product(p.V, answer.l);
  sizes += product(p.V.cwiseAbs(), answer.l.cwiseAbs());
  // Velocities are known to the tolerance of forces, or of exact ones to rounding.
  const double known_to =
      tolerance > ContactSettings::solved ? tolerance : ContactSettings::rounding;
  const double open = std::max(ContactSettings::solved, ContactSettings::digits * last_digit(r)),
               all = std::min(1.0, open / tolerance);
  const auto note = [&](Index law, double size, Index where) {
    if (size <= answer.worst[law].size) return; // never of nan: forces are finite
    answer.worst[law] = {size, where};
  };
  for (Index c = 0; c < k; ++c) {
    // Velocities beside b and what the contact's own force does, and all terms of its rows as far
    // as their digits leave them open; forces beside what makes such velocities.
    const double size = std::max(own.segment<3>(3 * c).maxCoeff(),
                                 all * sizes.segment<3>(3 * c).maxCoeff()),
                 w = diagonal.segment<3>(3 * c).maxCoeff();
    const Vector3d given = r.segment<3>(3 * c);
    const double unit = std::max(w > 0 ? size / w : 0, given.norm());
    const Vector3d f = given / (unit > 0 ? unit : 1),
                   v = answer.u.segment<3>(3 * c) / (size > 0 ? size : 1);
    answer.modes.push_back(mode_of(f, v, p.mu[c], tolerance));
    answer.broken.push_back(
        laws_broken(f, v, p.mu[c], known_to, answer.modes.back() != ForceMode::stick));
    for (Index law = 0; law < contact_law_count; ++law) note(law, answer.broken.back()[law], c);
  }
  for (Index a = 0; a < p.s.size(); ++a) {
    const double size =
        p.V.col(a).cwiseAbs().dot(r.cwiseAbs()) + std::abs(p.R[a] * answer.l[a]) + std::abs(p.s[a]);
    const double lacks = p.V.col(a).dot(r) + p.R[a] * answer.l[a] + p.s[a];
    note(contact_law_count - 1, size > 0 ? std::abs(lacks) / size : 0, a);
  }
  // Forces that are large enough beside b leave the velocities open; where none hold, they do not.
  if (tolerance > ContactSettings::solved) answer.none = contradiction(p, r);
  answer.is_good = n == r.size() && answer.none.size() == 0;
  for (Index law = 0; law < contact_law_count; ++law) {
    const bool is_angle = law == static_cast<Index>(ContactLaw::dissipation);
    answer.is_good = answer.is_good &&
                     answer.worst[law].size <=
                         (is_angle ? std::max(tolerance, ContactSettings::off_slip) : tolerance);
  }
  return answer;
}

} // namespace lcpush::desktop
