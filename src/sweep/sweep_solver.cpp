#include "sweep/sweep_solver.hpp"

#include <utility>

#include "solve/holding_verdict.hpp"
#include "solve/push_rounds.hpp"
#include "sweep/remembered_rounds.hpp"

namespace lcpush::desktop {
namespace {

std::vector<Parameter> parameters_of(const std::vector<Variation>& variations) {
  std::vector<Parameter> parameters;
  for (const Variation& variation : variations) parameters.push_back(variation.parameter);
  return parameters;
}

} // namespace

SweepSolver::SweepSolver(const VariedScene& scene, const std::vector<Variation>& variations,
                         Index pusher)
    : variations_(variations),
      series_(scene, parameters_of(variations), variations.front().from, variations.front().to),
      pusher_(pusher) {}

void SweepSolver::go_to(const std::vector<double>& values) {
  point_ = std::make_unique<ScenePoint>(series_.at(values));
}

/// Memory for as many unknowns as there are here.
void SweepSolver::make_lemke() {
  if (const Index n = point_->assembly.layout().size; !lemke_ || lemke_->unknowns < n)
    lemke_.emplace(n);
}

Status SweepSolver::solve_cold(Quantity quantity, Basis& basis) {
  ++cold_;
  make_lemke();
  Status status = lemke_->init(point_->problem(quantity), LemkeOptions<double>{});
  if (status == Status::running) status = lemke_->solve();
  if (status != Status::solved) return status;
  const Index n = point_->assembly.layout().size;
  basis.resize(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) basis[static_cast<std::size_t>(i)] = lemke_->is_basic(i) ? 1 : 0;
  return status;
}

bool SweepSolver::stand_on(Quantity quantity, const Basis& basis) {
  const Problem<double> problem = point_->problem(quantity);
  if (static_cast<Index>(basis.size()) != problem.size) return false;
  make_lemke();
  LemkeOptions<double> options;
  options.covers = 1;
  if (lemke_->init(problem, options, basis.data()) != Status::running) return false;
  return lemke_->step() == Status::solved && lemke_->pivots() == 0;
}

Outputs SweepSolver::on_basis(Quantity quantity, const Basis& basis, bool thorough) {
  if (!has(quantity)) return {};
  BasisSolution solution;
  if (!solve_on_basis(point_->problem(quantity), basis, solution)) {
    // The small system may be worse conditioned than the dictionary.
    if (!thorough || !stand_on(quantity, basis)) return {};
    const Index n = point_->assembly.layout().size;
    solution.z = Eigen::Map<const Eigen::VectorXd>(lemke_->z(), n);
    if (quantity == Quantity::breaking) {
      solution.z_push = Eigen::Map<const Eigen::VectorXd>(lemke_->z_push(), n);
      solution.valid_to = lemke_->valid_to();
    }
  }
  return quantity == Quantity::push ? read_push(solution.z.data()) : read_breaking(solution);
}

/// The states of work.answer's contacts.
Outputs SweepSolver::read_contacts(Outputs outputs) const {
  const Answer<double>& answer = point_->work.answer;
  const Scales<double>& scales = point_->assembly.layout().scales;
  const double pressed = 1000 * Tolerances<double>().tie * scales.force;
  outputs.force_noise = 1e-11 * scales.force;
  outputs.motion_noise = 1e-11 * scales.acceleration;
  outputs.turning_noise = outputs.motion_noise / scales.length;
  Index entry = 0;
  for (Index i = 0; i < answer.contacts.size; ++i) {
    const ContactAnswer<double>& contact = answer.contacts[i];
    const Vector3<double>& n = point_->scene.bodies[contact.body].normal;
    ContactState state;
    state.mode = contact.mode;
    state.pressed = std::abs(contact.normal_force) > pressed;
    const Vector3<double> slip = contact.acceleration - contact.acceleration.dot(n) * n;
    if (state.mode == Mode::slide && slip.norm() > 0) state.slip = slip.normalized();
    for (Index j = 0; j < point_->assembly.layout().cones[i].generators; ++j, ++entry)
      if (answer.friction[entry] > pressed) state.rubs.push_back(j);
    outputs.contacts.push_back(state);
  }
  return outputs;
}

Outputs SweepSolver::read_push(const double* z) {
  ScenePoint& p = *point_;
  read_answer(p.assembly, z, p.work.answer, 1.0);
  Outputs outputs;
  outputs.status = Status::solved;
  outputs.normal = normal_sum(p.work.answer, pusher_body());
  outputs.force = body_wrench(p.scene, p.work.answer, pusher_body()).head<3>();
  outputs.twist = p.work.answer.acceleration;
  outputs.residual = check(p.scene, p.assembly.layout().scales, p.work.answer, 1.0).max();
  if (!(outputs.residual <= Tolerances<double>().residual))
    outputs.status = Status::numerical_breakdown;
  return read_contacts(std::move(outputs));
}

Outputs SweepSolver::judge_breaking(Status status, const Breaking<double>& breaking) {
  BreakReport report;
  report.status = status;
  report.breaking = breaking;
  report.scales = point_->assembly.layout().scales;
  Outputs outputs;
  outputs.status = holding_verdict(point_->file, point_->scene, report, {});
  if (status != Status::solved && status != Status::does_not_hold) return outputs;
  outputs.normal = breaking.break_force;
  outputs.force = breaking.force.head<3>();
  outputs.twist = breaking.twist;
  outputs.residual = breaking.residuals.max();
  outputs = read_contacts(std::move(outputs));
  outputs.motion_noise /= push_size(point_->scene); // of a unit push
  // What extrapolating from finite pushes leaves open.
  outputs.force_noise += 10 * breaking.line_error * report.scales.force;
  return outputs;
}

Outputs SweepSolver::read_breaking(const BasisSolution& solution) {
  ScenePoint& p = *point_;
  Breaking<double> breaking;
  PressureRun run;
  Status status = lcpush::read_breaking(p.assembly, solution.z.data(), solution.z_push.data(),
                                        solution.valid_to, p.work, pusher_body(),
                                        push_size(p.scene), breaking, run);
  if (status == Status::solved && !(breaking.residuals.max() <= Tolerances<double>().residual))
    status = Status::numerical_breakdown;
  if (status == Status::solved &&
      motion_size(breaking.rest, p.assembly.layout().scales) > at_rest<double>())
    status = Status::does_not_hold;
  return judge_breaking(status, breaking);
}

Outputs SweepSolver::solve(Quantity quantity, RoundBases& bases, const RoundBases* others) {
  if (!has(quantity)) return {};
  if (point_->scene.pressure == Pressure::pad) return solve_pad(quantity, bases);
  if (others != nullptr && !others->empty() && !bases.empty()) {
    for (const RoundBases* candidate : {static_cast<const RoundBases*>(&bases), others}) {
      const Outputs outputs = on_basis(quantity, candidate->front(), false);
      if (!outputs.is_solved() && outputs.status != Status::does_not_hold) continue;
      ++warm_;
      if (candidate == others) bases = *others;
      return outputs;
    }
  }
  if (!bases.empty()) {
    Outputs outputs = on_basis(quantity, bases.front());
    if (outputs.is_solved() || outputs.status == Status::does_not_hold) {
      ++warm_;
      return outputs;
    }
    // A few pivots from there, if they lead anywhere.
    const Problem<double> problem = point_->problem(quantity);
    LemkeOptions<double> options;
    options.covers = 1;
    options.max_pivots = problem.size;
    if (static_cast<Index>(bases.front().size()) == problem.size) {
      make_lemke();
      Status status = lemke_->init(problem, options, bases.front().data());
      if (status == Status::running) status = lemke_->solve();
      if (status == Status::solved) {
        for (Index i = 0; i < problem.size; ++i)
          bases.front()[static_cast<std::size_t>(i)] = lemke_->is_basic(i) ? 1 : 0;
        outputs = on_basis(quantity, bases.front());
        ++warm_;
        if (outputs.is_solved() || outputs.status == Status::does_not_hold) return outputs;
      }
    }
  }
  bases.resize(1);
  Outputs outputs;
  outputs.status = solve_cold(quantity, bases.front());
  if (outputs.status == Status::solved) return on_basis(quantity, bases.front());
  bases.clear();
  return outputs;
}

Outputs SweepSolver::solve_pad(Quantity quantity, RoundBases& bases) {
  ScenePoint& p = *point_;
  make_lemke();
  RoundMemory memory{bases};
  const RememberedRounds rounds(*lemke_, memory);
  PressureRun run;
  Outputs outputs;
  if (quantity == Quantity::push) {
    p.assembly.push_by(1.0);
    const auto options = pressure_options(p.scene, p.assembly.layout().scales, 1.0);
    outputs.status = solve_pressure(p.assembly, rounds, p.work.pressure, options, run);
    if (outputs.is_solved()) outputs = read_push(p.work.pressure.z.data);
  } else {
    Breaking<double> breaking;
    const Status status =
        find_breaking(p.assembly, rounds, p.work, pusher_body(), {}, breaking, run);
    outputs = judge_breaking(status, breaking);
    p.assembly.push_by(1.0);
  }
  ++(memory.cold > 0 ? cold_ : warm_);
  if (!outputs.is_solved() && outputs.status != Status::does_not_hold) bases.clear();
  return outputs;
}

} // namespace lcpush::desktop
