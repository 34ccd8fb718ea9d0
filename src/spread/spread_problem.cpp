#include "spread/spread_problem.hpp"

#include <algorithm>

#include "dense/decompositions.hpp"
#include "lcpush/mechanics/solve/breaking.hpp"
#include "spread/settings.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

using Kind = ContactMode::Kind;

constexpr double tie = SpreadSettings::tie;

SceneFile literal(SceneFile file) {
  file.pressure = Pressure::rigid;
  return file;
}

} // namespace

LiteralProblem::LiteralProblem(const SceneFile& file)
    : file_(literal(file)), assembled_(file_.view()) {
  const FactoredProblem<double>& given = factored();
  const double quickest = push_size(scene());
  unit_ = quickest > 0 ? layout().scales.acceleration / quickest : 1;
  push_ = 1 / unit_;
  for (Index k = 0; k < 6; ++k)
    if (given.mobility.row(k).norm() > 0) axes_.push_back(k);
  const Index a = moving(), n = layout().size, first_closing = n - actuators();
  const Eigen::Map<const Eigen::VectorXd> pushed(assembled_.assembly.breaking_problem().push, n);
  rates_ = Eigen::MatrixXd::Zero(n, motions());
  effects_ = Eigen::MatrixXd::Zero(a + actuators(), n);
  load_ = Eigen::VectorXd::Zero(a + actuators());
  inertia_ = Eigen::VectorXd::Zero(actuators());
  for (const ConeGroup<double>& cone : given.cones)
    for (Index k = 0; k < cone.forces(); ++k) {
      const Index i = cone.variable + k;
      const Vector6<double>& column = given.wrenches[cone.force + k];
      rates_.row(i).head(a) = column(axes_).transpose();
      rates_(i, motions() - 1) = pushed[i] * unit_;
      const Vector6<double> effect = given.mobility * column;
      effects_.col(i).head(a) = effect(axes_);
    }
  for (Index k = 0; k < actuators(); ++k) {
    const SumGroup<double>& sum = given.sums[k];
    load_[a + k] = sum.target;
    inertia_[k] = sum.inertia;
    for (Index entry = sum.first; entry < sum.first + sum.count; ++entry) {
      effects_(a + k, given.coupled_variable[entry]) += given.coupling[entry];
      rates_(given.coupled_variable[entry], a + k) -= given.coupling[entry];
    }
  }
  // Without contact forces the object falls as its loads have it.
  Vector6<double> fall = read(Eigen::VectorXd::Zero(first_closing + actuators()), 0).acceleration;
  fall.tail<3>() *= layout().scales.length;
  fall /= layout().scales.acceleration;
  load_.head(a) = fall(axes_);
}

Problem<double> LiteralProblem::problem(double push) {
  assembled_.assembly.push_by(push * unit_);
  return assembled_.assembly.problem();
}

bool LiteralProblem::is_soft(Index i) const {
  const Body<double>& body = scene().bodies[layout().body[i]];
  return body.torsion_radius > 0 && body.friction > 0;
}

bool LiteralProblem::has_soft_points() const {
  for (Index i = 0; i < layout().points; ++i)
    if (is_soft(i)) return true;
  return false;
}

std::vector<ConeEdge> LiteralProblem::edges_of(Index i, const ContactMode& mode) const {
  const ConeGroup<double>& cone = layout().cones[i];
  std::vector<ConeEdge> edges;
  if (mode.kind == Kind::open) return edges;
  for (Index side = 0; side < cone.normals; ++side) {
    if (mode.kind != Kind::undecided && mode.pulls != (side == 1)) continue;
    const Index normal = cone.variable + side;
    if (cone.generators == 0) edges.push_back({normal, -1, 0});
    for (Index j = 0; j < cone.generators; ++j)
      if (mode.kind != Kind::slide || std::binary_search(mode.active.begin(), mode.active.end(), j))
        edges.push_back({normal, layout().friction_index(i, j), cone.friction});
  }
  return edges;
}

Eigen::VectorXd LiteralProblem::motion_of(const Eigen::VectorXd& z, double push) const {
  const Index a = moving();
  Eigen::VectorXd x(motions());
  x.head(a) = load_.head(a);
  for (Index i = 0; i < z.size(); ++i)
    if (z[i] != 0) x.head(a) += z[i] * effects_.col(i).head(a);
  x.segment(a, actuators()) = z.tail(actuators());
  x[motions() - 1] = push;
  return x;
}

void LiteralProblem::complete(double push, Eigen::VectorXd& z) const {
  const Eigen::VectorXd rates = product(rates_, motion_of(z, push));
  for (const ConeGroup<double>& cone : layout().cones)
    if (cone.generators > 0)
      z[cone.slip()] =
          std::max(0.0, -rates.segment(cone.variable + cone.normals, cone.generators).minCoeff());
}

const Answer<double>& LiteralProblem::read(const Eigen::VectorXd& z, double push) {
  read_answer(assembled_.assembly, z.data(), assembled_.work.answer, push * unit_);
  return assembled_.work.answer;
}

Residuals<double> LiteralProblem::check(const Answer<double>& answer, double push) const {
  return lcpush::check(scene(), layout().scales, answer, push * unit_);
}

bool LiteralProblem::passes(const Residuals<double>& residuals, double push) const {
  const double worst = residuals.max();
  return worst <= Tolerances<double>().residual &&
         (!(push_size(scene()) > 0 && push > 0) ||
          residuals.beside <= SpreadSettings::smallest_part * push);
}

std::vector<ContactReading> LiteralProblem::readings_at(const Eigen::VectorXd& z,
                                                        double push) const {
  const Eigen::VectorXd x = motion_of(z, push), rates = product(rates_, x);
  Eigen::VectorXd terms = load_.head(moving()).cwiseAbs();
  double force = 0;
  for (const ConeGroup<double>& cone : layout().cones) {
    force = std::max(force, std::abs(cone.normal_force(z.data())));
    for (Index k = 0; k < cone.forces(); ++k)
      terms += z[cone.variable + k] * effects_.col(cone.variable + k).head(moving()).cwiseAbs();
  }
  // Below what rounding leaves of the accelerations that cancel there is no motion.
  const double motion =
      std::max(SpreadSettings::motion * terms.maxCoeff(), rates.cwiseAbs().maxCoeff());
  std::vector<ContactReading> readings;
  for (Index i = 0; i < layout().points; ++i) {
    const ConeGroup<double>& cone = layout().cones[i];
    const double lambda = cone.normal_force(z.data());
    ContactReading reading;
    reading.pressed = std::abs(lambda) > tie * force;
    reading.pulls = lambda < 0;
    reading.gap_closed = std::abs(rates[cone.variable]) <= tie * motion;
    double quickest = 0, used = 0;
    const auto against = [&](Index j) { return -rates[layout().friction_index(i, j)]; };
    for (Index j = 0; j < cone.generators; ++j) {
      const double beta = z[layout().friction_index(i, j)];
      quickest = std::max(quickest, against(j));
      used += beta;
      if (beta > tie * force) reading.carrying.push_back(j);
    }
    for (Index j = 0; j < cone.generators; ++j)
      if (against(j) >= quickest - tie * motion) reading.opposing.push_back(j);
    reading.slips = quickest > tie * motion;
    reading.at_limit = cone.generators > 0 && cone.friction_limit(z.data()) - used <= tie * force;
    readings.push_back(std::move(reading));
  }
  return readings;
}

FaceModes LiteralProblem::face_of(const std::vector<ContactReading>& readings) const {
  FaceModes modes;
  for (const ContactReading& at : readings) {
    const ConeGroup<double>& cone = layout().cones[static_cast<Index>(modes.size())];
    if (!at.gap_closed)
      modes.push_back({Kind::open, false, {}});
    else if (cone.generators == 0 || !at.slips)
      modes.push_back({Kind::stick, at.pulls, {}});
    else
      modes.push_back({Kind::slide, at.pulls, at.opposing});
  }
  return modes;
}

std::vector<ContactMode> LiteralProblem::every_mode(Index i) const {
  const ConeGroup<double>& cone = layout().cones[i];
  const Index g = cone.generators;
  std::vector<ContactMode> modes;
  if (cone.normals == 1) modes.push_back({Kind::open, false, {}});
  for (const bool pulls : {false, true}) {
    if (pulls && cone.normals == 1) continue;
    modes.push_back({Kind::stick, pulls, {}});
    for (Index j = 0; j < g; ++j) modes.push_back({Kind::slide, pulls, {j}});
    for (Index j = 0; g > 2 && j < g; ++j) { // an interval's two ends have nothing between them
      const Index next = (j + 1) % g;
      modes.push_back({Kind::slide, pulls, {std::min(j, next), std::max(j, next)}});
    }
  }
  return modes;
}

std::vector<ContactMode> LiteralProblem::modes_of(Index i, const ContactReading& at) const {
  const ConeGroup<double>& cone = layout().cones[i];
  std::vector<ContactMode> modes;
  if (!at.pressed && cone.normals == 1) modes.push_back({Kind::open, false, {}});
  if (!at.gap_closed) return modes;
  const auto carried_by = [&](const std::vector<Index>& active) {
    return std::includes(active.begin(), active.end(), at.carrying.begin(), at.carrying.end());
  };
  for (const bool pulls : {false, true}) {
    if (pulls ? cone.normals == 1 || (at.pressed && !at.pulls) : at.pressed && at.pulls) continue;
    if (cone.generators == 0 || !at.slips) modes.push_back({Kind::stick, pulls, {}});
    if (cone.generators == 0 || !at.at_limit) continue;
    if (!at.slips && is_soft(i)) {
      if (!at.carrying.empty()) modes.push_back({Kind::slide, pulls, at.carrying});
    } else if (!at.slips) { // about to slide, any way that its friction allows
      for (ContactMode& mode : every_mode(i))
        if (mode.kind == Kind::slide && mode.pulls == pulls && carried_by(mode.active))
          modes.push_back(std::move(mode));
    } else if (at.opposing.size() <= limits::generators_enumerated) {
      for (std::size_t set = 1; set < std::size_t{1} << at.opposing.size(); ++set) {
        std::vector<Index> active;
        for (std::size_t k = 0; k < at.opposing.size(); ++k)
          if ((set >> k & 1) != 0) active.push_back(at.opposing[k]);
        if (carried_by(active)) modes.push_back({Kind::slide, pulls, active});
      }
    } else {
      modes.push_back({Kind::slide, pulls, at.opposing});
    }
  }
  return modes;
}

} // namespace lcpush::desktop
