#include "spread/spread_problem.hpp"

#include <algorithm>

#include "lcpush/mechanics/solve/breaking.hpp"
#include "text/limits.hpp"

namespace lcpush::desktop {
namespace {

using Kind = ContactMode::Kind;

constexpr double tie = 1e-9; // of the largest force, or motion: at the limit

SceneFile literal(SceneFile file) {
  file.pressure = Pressure::rigid;
  return file;
}

/// What decides the mode of one contact, in the assembly's units.
struct Look {
  bool pressed, pulls, gap_closed, slips, at_limit;
  std::vector<Index> carrying; ///< generators with a force
  std::vector<Index> opposing; ///< generators that oppose the slip best
};

Look look_at(const LiteralProblem& problem, Index i, const Eigen::VectorXd& z,
             const Eigen::VectorXd& w) {
  const Layout<double>& layout = problem.layout();
  const DenseProblem& dense = problem.dense();
  const double terms = (dense.M.cwiseAbs() * z.cwiseAbs() + dense.q.cwiseAbs()).maxCoeff();
  double force = 0, motion = 1e-5 * terms; // below it all motion is rounding's
  for (Index k = 0; k < layout.points; ++k) {
    const ConeGroup<double>& cone = layout.cones[k];
    force = std::max(force, std::abs(cone.normal_force(z.data())));
    motion = std::max(motion, std::abs(w[cone.variable]));
    for (Index j = 0; j < cone.generators; ++j)
      motion = std::max(motion, std::abs(w[layout.friction(k, j)] - z[cone.slip()]));
  }
  const ConeGroup<double>& cone = layout.cones[i];
  const double lambda = cone.normal_force(z.data());
  Look look;
  look.pressed = std::abs(lambda) > tie * force;
  look.pulls = lambda < 0;
  look.gap_closed = std::abs(w[cone.variable]) <= tie * motion;
  double fastest = 0;
  const auto against = [&](Index j) { return z[cone.slip()] - w[layout.friction(i, j)]; };
  for (Index j = 0; j < cone.generators; ++j) {
    fastest = std::max(fastest, against(j));
    if (z[layout.friction(i, j)] > tie * force) look.carrying.push_back(j);
  }
  for (Index j = 0; j < cone.generators; ++j)
    if (against(j) >= fastest - tie * motion) look.opposing.push_back(j);
  look.slips = fastest > tie * motion;
  look.at_limit = cone.generators > 0 && w[cone.slip()] <= tie * force;
  return look;
}

} // namespace

LiteralProblem::LiteralProblem(const SceneFile& file)
    : file_(literal(file)), assembled_(file_.view()), dense_(desktop::dense(problem())) {}

void LiteralProblem::complete(const FaceModes& modes, Eigen::VectorXd& z) const {
  for (Index i = 0; i < layout().points; ++i) {
    const ConeGroup<double>& cone = layout().cones[i];
    if (modes[static_cast<std::size_t>(i)].kind != Kind::open || cone.generators == 0) continue;
    z[cone.slip()] = 0;
    double needed = 0;
    for (Index j = 0; j < cone.generators; ++j) {
      const Index row = layout().friction(i, j);
      needed = std::max(needed, -(dense_.M.row(row).dot(z) + dense_.q[row]));
    }
    z[cone.slip()] = needed;
  }
}

const Answer<double>& LiteralProblem::read(const Eigen::VectorXd& z) {
  read_answer(assembled_.assembly, z.data(), assembled_.work.answer, 1.0);
  return assembled_.work.answer;
}

bool LiteralProblem::passes(const Residuals<double>& residuals) const {
  constexpr double smallest_part = 1e-5; // as for an answer of Push::solve
  const double push = push_size(scene()) / layout().scales.acceleration;
  const double worst = residuals.max();
  return worst <= Tolerances<double>().residual && (!(push > 0) || worst <= smallest_part * push);
}

FaceModes LiteralProblem::face_of(const Eigen::VectorXd& z, const Eigen::VectorXd& w) const {
  FaceModes modes;
  for (Index i = 0; i < layout().points; ++i) {
    const Look at = look_at(*this, i, z, w);
    if (!at.gap_closed)
      modes.push_back({Kind::open, false, {}});
    else if (layout().cones[i].generators == 0 || !at.slips)
      modes.push_back({Kind::stick, at.pulls, {}});
    else
      modes.push_back({Kind::slide, at.pulls, at.opposing});
  }
  return modes;
}

bool LiteralProblem::has_soft_points() const {
  for (const Body<double>& body : scene().bodies)
    if (body.torsion_radius > 0 && body.friction > 0) return true;
  return false;
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
    for (Index j = 0; j < g; ++j) {
      const Index next = (j + 1) % g;
      modes.push_back({Kind::slide, pulls, {std::min(j, next), std::max(j, next)}});
    }
  }
  return modes;
}

std::vector<ContactMode> LiteralProblem::modes_at(Index i, const Eigen::VectorXd& z,
                                                  const Eigen::VectorXd& w) const {
  const Look at = look_at(*this, i, z, w);
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
    if (!at.slips && scene().bodies[layout().body[i]].torsion_radius > 0) {
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
