#include "spread/spread_face.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dense/decompositions.hpp"

namespace lcpush::desktop {
namespace {

using Kind = ContactMode::Kind;

constexpr double dependent = 1e-10; // of the largest pivot: a row that follows from the others
constexpr double contradicts = 1e-7, agrees = 1e-9; // what is left of an equation
constexpr double flat = 1e-10;                      // of a row's size: does not vary
constexpr double rounding = 1e-14;                  // of a row's size: nothing
constexpr double far = 1000;                        // units of force, for what has no end

} // namespace

Face::Face(const LiteralProblem& problem, const FaceModes& modes) : problem_(problem) {
  choose(modes);
  eliminate();
}

/// Unknowns, equations and signs of the modes.
void Face::choose(const FaceModes& modes) {
  const Layout<double>& layout = problem_.layout();
  const Index free_begin = layout.size - layout.actuators;
  std::vector<Index> zero, sign;
  for (Index i = 0; i < layout.points; ++i) {
    const ConeGroup<double>& cone = layout.cones[i];
    const ContactMode& mode = modes[static_cast<std::size_t>(i)];
    const Index normal = cone.variable;
    if (mode.kind == Kind::open) {
      sign.push_back(normal);
      continue;
    }
    const bool undecided = mode.kind == Kind::undecided;
    (undecided && cone.normals == 1 ? sign : zero).push_back(normal);
    if (undecided || !mode.pulls) unknowns_.push_back(normal);
    if (cone.normals == 2 && (undecided || mode.pulls)) unknowns_.push_back(normal + 1);
    if (cone.generators == 0) continue;
    for (Index j = 0; j < cone.generators; ++j) {
      const Index row = layout.friction_index(i, j);
      const bool active = std::binary_search(mode.active.begin(), mode.active.end(), j);
      if (mode.kind != Kind::slide || active) unknowns_.push_back(row);
      (mode.kind == Kind::stick || active ? zero : sign).push_back(row);
    }
    if (mode.kind != Kind::stick) unknowns_.push_back(cone.slip());
    (mode.kind == Kind::slide ? zero : sign).push_back(cone.slip());
  }
  const Index bounded = static_cast<Index>(unknowns_.size());
  for (Index a = free_begin; a < layout.size; ++a) {
    unknowns_.push_back(a);
    zero.push_back(a);
  }
  const DenseProblem& dense = problem_.dense();
  equations_ = dense.M(zero, unknowns_);
  right_ = -dense.q(zero);
  const Index signs = static_cast<Index>(sign.size());
  signs_ = Eigen::MatrixXd::Zero(signs + bounded, equations_.cols());
  constant_ = Eigen::VectorXd::Zero(signs_.rows());
  signs_.topRows(signs) = dense.M(sign, unknowns_);
  constant_.head(signs) = dense.q(sign);
  signs_.bottomLeftCorner(bounded, bounded).setIdentity();
}

/// Origin and directions of E z = right, rows scaled to length 1.
void Face::eliminate() {
  for (Index r = 0; r < equations_.rows(); ++r) {
    const double size = equations_.row(r).norm();
    if (!(size > 0)) continue;
    equations_.row(r) /= size;
    right_[r] /= size;
  }
  const Index columns = equations_.cols();
  directions_ = Eigen::MatrixXd::Identity(columns, columns);
  if (equations_.size() > 0) {
    RowSpace space = row_space(equations_, dependent);
    basis_ = std::move(space.basis);
    directions_ = std::move(space.complement);
    triangle_ = std::move(space.triangle);
    order_ = std::move(space.order);
  }
  origin_ = Eigen::VectorXd::Zero(columns);
  settle(origin_);
  const double size = 1 + right_.cwiseAbs().sum();
  const Eigen::VectorXd off = equations_ * origin_ - right_;
  contradictory_ = off.size() > 0 && off.cwiseAbs().maxCoeff() > contradicts * size;
  rows_ = signs_ * directions_;
  for (Index r = 0; r < rows_.rows(); ++r) {
    const double length = rows_.row(r).norm(), own = signs_.row(r).norm();
    if (length <= flat * own || !(length > 0)) {
      rows_.row(r).setZero();
      continue;
    }
    signs_.row(r) /= length;
    constant_[r] /= length;
    rows_.row(r) =
        (rows_.row(r).array().abs() > rounding * length).select(rows_.row(r) / length, 0);
  }
  look_around();
}

/// The nearest point that solves the equations.
void Face::settle(Eigen::VectorXd& x) const {
  for (int turn = 0; turn < 2; ++turn) {
    if (order_.empty()) return;
    const Eigen::VectorXd off = right_ - equations_ * x, picked = off(order_);
    x += basis_ * triangle_.transpose().triangularView<Eigen::Lower>().solve(picked);
  }
}

/// The room at the origin, and which rows bind first: of several that are parallel one is enough,
/// and linear programs are less degenerate without the others.
void Face::look_around() {
  room_ = signs_ * origin_ + constant_;
  first_.clear();
  for (Index r = 0; r < rows_.rows(); ++r) {
    if (rows_.row(r).isZero(0)) continue;
    bool new_row = true;
    for (Index& other : first_) {
      if ((rows_.row(r) - rows_.row(other)).cwiseAbs().maxCoeff() > 100 * rounding) continue;
      if (room_[r] < room_[other]) other = r;
      new_row = false;
      break;
    }
    if (new_row) first_.push_back(r);
  }
}

/// The columns of the dual: rows_ of first_, and their room as costs without rounding's digits.
void Face::dual(OwnedProgram& program) const {
  const double size = 1 + room_.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < first_.size(); ++k) {
    const auto column = static_cast<Index>(k);
    program.A.col(column).head(dimension()) = rows_.row(first_[k]).transpose();
    const double room = room_[first_[k]] / size;
    program.c[column] = std::abs(room) <= rounding ? 0 : room;
  }
}

bool Face::start_at(const Eigen::VectorXd& z) {
  const Eigen::VectorXd given = z(unknowns_);
  origin_ = given;
  settle(origin_);
  look_around();
  const double size = 1 + given.cwiseAbs().sum();
  return (origin_ - given).cwiseAbs().maxCoeff() <= agrees * size &&
         (equations_ * origin_ - right_).cwiseAbs().maxCoeff() <= agrees * size &&
         (room_.size() == 0 || room_.minCoeff() >= -agrees * size);
}

Eigen::VectorXd Face::whole(const Eigen::VectorXd& x) const {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(problem_.layout().size);
  const Index free_begin = problem_.layout().size - problem_.layout().actuators;
  for (std::size_t k = 0; k < unknowns_.size(); ++k) {
    const double value = x[static_cast<Index>(k)];
    z[unknowns_[k]] = unknowns_[k] < free_begin ? std::max(value, 0.0) : value;
  }
  return z;
}

/// Where one cover fails others have a try, then costs a little larger, which part ties: the signs
/// that hold such a corner hold the true one, and the referee sees what comes of it.
Status Face::minimise(OwnedProgram& program) {
  constexpr Index tries = 3;
  constexpr double apart = 1e-8;
  const Eigen::VectorXd costs = program.c;
  const auto n = static_cast<double>(program.A.cols());
  Status status = Status::bad_input;
  LemkeOptions<double> options;
  ++programs_;
  for (Index k = 0; k < 2 * tries; ++k) {
    options.first_cover = k * options.covers;
    for (Index j = 0; k >= tries && j < costs.size(); ++j)
      program.c[j] = costs[j] + apart * generic_number<double>(static_cast<std::uint32_t>(k), j);
    status = program.solve(options);
    work_ += n * n * static_cast<double>(program.pivots + 10) +
             n * static_cast<double>(program.A.rows() * program.A.rows());
    if (status == Status::solved || status == Status::ray) break;
  }
  return status;
}

/// t moved onto the signs rows t + room >= 0 that bind it, so that the point is exact to rounding.
/// `multipliers` > 0 mark those of first_ that the linear program holds it with. Room 0: a
/// direction.
Eigen::VectorXd Face::polished(const Eigen::VectorXd& t, const Eigen::VectorXd& room,
                               const Eigen::VectorXd& multipliers) const {
  const double size = 1 + room.cwiseAbs().maxCoeff();
  std::vector<bool> held(static_cast<std::size_t>(room.size()), false);
  for (Index k = 0; k < multipliers.size(); ++k)
    if (multipliers[k] > 1e-6)
      held[static_cast<std::size_t>(first_[static_cast<std::size_t>(k)])] = true;
  Eigen::VectorXd result = t;
  for (int turn = 0; turn < 2; ++turn) {
    const Eigen::VectorXd at = rows_ * result + room;
    std::vector<Index> binding;
    for (const Index r : first_)
      if (held[static_cast<std::size_t>(r)] || at[r] <= agrees * size) binding.push_back(r);
    if (binding.empty()) return result;
    result += shortest_solution(rows_(binding, Eigen::all), -at(binding), dependent);
  }
  return result;
}

bool Face::varies(const Eigen::VectorXd& f) const {
  const Eigen::VectorXd own = f(unknowns_);
  return (directions_.transpose() * own).norm() > flat * own.norm();
}

/// The smallest r >= 0 with rows t + room + r >= 0: its dual is always solvable.
Face::Point Face::find_point() {
  if (contradictory_) return Point::none;
  if (room_.size() == 0 || room_.minCoeff() >= 0) return Point::found;
  const double size = 1 + room_.cwiseAbs().maxCoeff();
  for (Index r = 0; r < room_.size(); ++r) // constant on the face
    if (rows_.row(r).isZero(0) && room_[r] < -contradicts * size) return Point::none;
  const Index K = static_cast<Index>(first_.size()), d = dimension();
  if (K > 0) {
    OwnedProgram program(K + 1, d + 1);
    dual(program);
    program.A.row(d).setOnes();
    program.b[d] = 1;
    if (minimise(program) != Status::solved) return Point::failed;
    const Eigen::VectorXd& nu = program.multipliers;
    if (-nu[d] > contradicts) return Point::none;
    if (-nu[d] > agrees) return Point::failed;
    origin_ += directions_ * polished(-size * nu.head(d), room_, program.x.head(K));
    settle(origin_);
    look_around();
  }
  return room_.minCoeff() >= -agrees * size ? Point::found : Point::failed;
}

Face::Point Face::lowest(const Eigen::VectorXd& f, Eigen::VectorXd& z) {
  const double size = 1 + room_.cwiseAbs().maxCoeff();
  const Eigen::VectorXd own = f(unknowns_);
  Eigen::VectorXd slope = directions_.transpose() * own;
  slope /= slope.norm();
  // min slope t over rows t + room >= 0 has the dual: min room y over rows' y = slope, y >= 0.
  OwnedProgram program(static_cast<Index>(first_.size()), dimension());
  dual(program);
  program.b = slope;
  program.c = program.c.cwiseMax(0);
  const Status status = minimise(program);
  const Eigen::VectorXd& nu = program.multipliers;
  Eigen::VectorXd x = origin_;
  if (status == Status::solved) {
    x += directions_ * polished(-size * nu, room_, program.x);
    settle(x);
    z = whole(x);
    return Point::found;
  }
  if (status != Status::ray) return Point::failed;
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(room_.size());
  x += far / nu.norm() * (directions_ * polished(-nu, none, Eigen::VectorXd()));
  settle(x);
  z = whole(x);
  return Point::unbounded;
}

} // namespace lcpush::desktop
