#include "solve/contact_system.hpp"

#include <algorithm>

#include "dense/decompositions.hpp"

namespace lcpush::desktop {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double rounding = 1e-9;   // of a direction's largest entry
constexpr double dependent = 1e-11; // of the largest pivot

/// L, square, of A = L O' with orthonormal columns O.
MatrixXd compressed(const MatrixXd& A) {
  MatrixXd L = MatrixXd::Zero(A.rows(), A.rows());
  const Index k = std::min(A.rows(), A.cols());
  L.leftCols(k) = PivotedQr(A.transpose()).R().topRows(k).transpose();
  return L;
}

double largest_entry(const MatrixXd& A) { return A.size() > 0 ? A.cwiseAbs().maxCoeff() : 0; }

} // namespace

ContactSystem::ContactSystem(const Assembly<double>& assembly)
    : assembly_(assembly), motions_(6 + assembly.layout().actuators), stays_{motions_},
      pushes_{motions_ + 6}, pads_{motions_}, pads_push_{motions_ + 6} {}

/// The motion along `wrench` is this times a'; a force along it moves a' by it.
VectorXd ContactSystem::along(Index i, const Vector6<double>& wrench) const {
  const Layout<double>& layout = assembly_.layout();
  VectorXd column = VectorXd::Zero(motions_);
  column.head<6>() = wrench;
  for_each_grip(assembly_.scene(), layout, layout.body[i], wrench,
                [&](Index a, double grip) { column[6 + a] -= grip; });
  return column;
}

VectorXd ContactSystem::with_pushers(Index i, const Vector6<double>& wrench) const {
  const bool pushes = assembly_.scene().bodies[assembly_.layout().body[i]].role == Role::pusher;
  VectorXd column(motions_ + 6);
  column << along(i, wrench), (pushes ? wrench : Vector6<double>(Vector6<double>::Zero()));
  return column;
}

void ContactSystem::stay(Index i, const Vector6<double>& wrench) { stays_.add(along(i, wrench)); }

void ContactSystem::push(Index i, const Vector6<double>& wrench) {
  pushes_.add(with_pushers(i, wrench));
}

void ContactSystem::press(Index i, const Vector6<double>& normal, const Vector6<double>& force) {
  const double c = assembly_.layout().cones[i].compliance;
  if (!(c > 0)) {
    stay(i, normal);
    push(i, force);
    return;
  }
  compliance_.push_back(c);
  pads_.add(along(i, normal));
  pads_push_.add(with_pushers(i, force));
}

/// Accelerations from forces: the object's by its mobility.
MatrixXd ContactSystem::balance_rows(const MatrixXd& effect) const {
  MatrixXd moved = effect.topRows(motions_);
  moved.topRows(6) = product(assembly_.factored().mobility, effect.topRows(6));
  return moved;
}

/// Of motions: the object's rows stay, those of the actuators take their inertia.
MatrixXd ContactSystem::inertial(MatrixXd motion) const {
  for (Index k = 6; k < motions_; ++k) motion.row(k) *= assembly_.factored().sums[k - 6].inertia;
  return motion;
}

/// In the limit of stiff pads they press by v where they yield by W v times a compliance that
/// vanishes, and a' = Z u is what no pad resists; f = O y of what does not yield.
OpenDirections ContactSystem::open_directions() const {
  const Eigen::Map<const MatrixXd> pads = pads_.matrix();
  const PivotedQr yielding(pads, dependent * largest_entry(pads));
  const MatrixXd basis = yielding.Q(); // [W Z]
  const Index r = yielding.rank(), still = motions_ - r;
  const MatrixXd Z = basis.rightCols(still),
                 J = product(compressed(stays_.matrix()).transpose(), basis);
  const double softest =
      compliance_.empty() ? 0 : *std::max_element(compliance_.begin(), compliance_.end());
  const VectorXd stiffness =
      Eigen::Map<const VectorXd>(compliance_.data(), pads.cols()).cwiseInverse() * softest;
  const MatrixXd pressures =
      -(stiffness.asDiagonal() * product(pads.transpose(), basis.leftCols(r)));
  const MatrixXd squeezed = product(pads_push_.matrix(), pressures);
  const MatrixXd pushed = compressed(pushes_.matrix());

  // What J says of u holds to the first order; where it says nothing, of what pads yield.
  const PivotedQr first_order(J.rightCols(still), dependent * largest_entry(J));
  const Index firm = first_order.rank();
  const MatrixXd JQ = product(first_order.Q().transpose(), J);
  MatrixXd K = MatrixXd::Zero(2 * motions_, motions_ + pushed.cols());
  K.topRows(motions_) << -balance_rows(squeezed), inertial(Z), -balance_rows(pushed);
  K.block(motions_, r, firm, still) = JQ.topRightCorner(firm, still);
  K.bottomLeftCorner(motions_ - firm, r) = JQ.bottomLeftCorner(motions_ - firm, r);

  OpenDirections open;
  const MatrixXd unresisted = PivotedQr(K, dependent * largest_entry(K)).kernel();
  if (unresisted.cols() == 0) return open;
  // A small inertia counts as much as a large one; rows of J have been mixed.
  VectorXd size = K.cwiseAbs().rowwise().maxCoeff();
  size.tail(motions_).setConstant(size.tail(motions_).maxCoeff());
  for (Index k = 0; k < unresisted.cols(); ++k) {
    const VectorXd x = unresisted.col(k), force = product(pushed, x.tail(pushed.cols())),
                   motion = product(Z, x.segment(r, still));
    const double largest =
        std::max({largest_entry(motion), largest_entry(product(pressures, x.head(r))),
                  largest_entry(force)});
    // Forces that hold each other, or what rounding makes of no solution, say nothing.
    const VectorXd violation = product(K, x).cwiseAbs() - rounding * largest * size;
    if (!(largest > rounding * largest_entry(x) && violation.maxCoeff() <= 0)) continue;
    open.motion = open.motion || motion.head<6>().norm() > rounding * largest;
    const Vector6<double> pushers = (force + product(squeezed, x.head(r))).tail<6>();
    open.wrench = open.wrench || pushers.norm() > rounding * largest;
  }
  return open;
}

} // namespace lcpush::desktop
