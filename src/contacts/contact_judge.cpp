// The referee of contact problems: reads the problem as given, and shares no code with the solver.
#include "contacts/settings.hpp"
#include "dense/decompositions.hpp"
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

/// The laws of a contact, of force and velocity near 1. Slower than `slow` nothing slips.
Sizes laws_broken(const Vector3d& r, const Vector3d& u, double mu, double slow) {
  Sizes size = Sizes::Zero();
  const auto rt = r.tail<2>(), ut = u.tail<2>();
  const double friction = rt.norm(), speed = ut.norm(), limit = mu * std::max(r[0], 0.0);
  size[0] = std::abs(std::min(r[0], u[0]));
  size[1] = std::max(0.0, friction - limit);
  if (speed > slow && limit > slow) {
    const double across = std::abs(rt[0] * ut[1] - rt[1] * ut[0]);
    const double angle = friction > slow ? std::atan2(across, -rt.dot(ut)) : 0; // 0 has none
    size[2] = std::max(angle, (limit - friction) / limit);
  }
  const Vector3d dual = u + Vector3d(mu * speed, 0, 0);
  size[3] = (r - nearest_in_cone(r - dual, mu)).norm();
  return size;
}

/// l of given forces: from the equality where it has one, else as what presses does not part; u
/// without it, whose terms have `sizes`.
VectorXd fitted_l(const ContactProblem& p, const VectorXd& r, const VectorXd& u,
                  const VectorXd& sizes) {
  const Index e = p.s.size();
  const VectorXd lacks = product(p.V.transpose(), r) + p.s;
  std::vector<Index> rows;
  const double small = usual_contact_tolerance * r.cwiseAbs().maxCoeff();
  for (Index c = 0; c < p.contacts(); ++c) {
    const Vector3d f = r.segment<3>(3 * c);
    if (f[0] <= small) continue;
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
  const double enough = std::max(answer.tolerance, ContactSettings::turned * worst(answer));
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
  if (fits(other, *other.r)) return "With --normal " + order + " the laws hold.";
  if (fits(p, *other.r))
    return "The laws hold where the forces alone have the normal " + order + ".";
  return "";
}

ContactForces judge_contacts(const ContactProblem& p, const VectorXd& r, double tolerance,
                             const VectorXd* l) {
  ContactForces answer;
  answer.tolerance = tolerance;
  answer.r = r;
  const Index n = p.b.size(), k = p.contacts();
  VectorXd sizes = p.b.cwiseAbs(), units = VectorXd::Ones(k), diagonal = VectorXd::Zero(n);
  answer.u = p.b;
  for (Index i = 0; i < n; ++i)
    for (const SparseEntry& entry : p.W.row(i)) {
      const double term = entry.value * r[entry.column];
      answer.u[i] += term;
      sizes[i] += std::abs(term);
      if (entry.column == i) diagonal[i] = entry.value;
    }
  answer.l = l != nullptr ? *l : fitted_l(p, r, answer.u, sizes);
  answer.u += product(p.V, answer.l);
  sizes += product(p.V.cwiseAbs(), answer.l.cwiseAbs());
  // A contact's forces are measured beside the largest, both by what moves their contacts.
  double largest = 0;
  for (Index c = 0; c < k; ++c) {
    const double w = diagonal.segment<3>(3 * c).maxCoeff();
    if (w > 0) units[c] = 1 / std::sqrt(w);
    largest = std::max(largest, r.segment<3>(3 * c).norm() / units[c]);
  }
  const double moves = tolerance > ContactSettings::slips ? tolerance : ContactSettings::slips;
  const auto note = [&](Index law, double size, Index where) {
    if (size <= answer.worst[law].size) return; // never of nan: forces are finite
    answer.worst[law] = {size, where};
  };
  for (Index c = 0; c < k; ++c) {
    const double size = sizes.segment<3>(3 * c).maxCoeff();
    const Vector3d f = r.segment<3>(3 * c) / (largest > 0 ? largest * units[c] : 1),
                   v = answer.u.segment<3>(3 * c) / (size > 0 ? size : 1);
    answer.broken.push_back(laws_broken(f, v, p.mu[c], moves));
    for (Index law = 0; law < contact_law_count; ++law) note(law, answer.broken.back()[law], c);
    answer.modes.push_back(f[0] <= tolerance && f.tail<2>().norm() <= tolerance ? ForceMode::open
                           : v.tail<2>().norm() <= moves                        ? ForceMode::stick
                                                                                : ForceMode::slip);
  }
  for (Index a = 0; a < p.s.size(); ++a) {
    const double size =
        p.V.col(a).cwiseAbs().dot(r.cwiseAbs()) + std::abs(p.R[a] * answer.l[a]) + std::abs(p.s[a]);
    const double lacks = p.V.col(a).dot(r) + p.R[a] * answer.l[a] + p.s[a];
    note(contact_law_count - 1, size > 0 ? std::abs(lacks) / size : 0, a);
  }
  answer.is_good = n == r.size();
  for (Index law = 0; law < contact_law_count; ++law) {
    const bool is_angle = law == static_cast<Index>(ContactLaw::dissipation);
    answer.is_good = answer.is_good &&
                     answer.worst[law].size <=
                         (is_angle ? std::max(tolerance, ContactSettings::off_slip) : tolerance);
  }
  return answer;
}

} // namespace lcpush::desktop
