#include "sweep/sweep_solver.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solve/noise.hpp"
#include "solve/push_rounds.hpp"
#include "solve/rest_verdict.hpp"
#include "solve/word_settings.hpp"
#include "sweep/proven_jam.hpp"
#include "sweep/remembered_rounds.hpp"
#include "sweep/settings.hpp"

namespace lcpush::desktop {
namespace {

constexpr SweepSettings settings;

std::vector<Parameter> parameters_of(const std::vector<Variation>& variations) {
  std::vector<Parameter> parameters;
  for (const Variation& variation : variations) parameters.push_back(variation.parameter);
  return parameters;
}

/// The states of work.answer's contacts.
DetailedAnswer read_contacts(const ScenePoint& p, DetailedAnswer answer) {
  const Answer<double>& solved = p.work.answer;
  const Scales<double>& scales = p.assembly.layout().scales;
  const double pressed = settings.pressed * Tolerances<double>().tie * scales.force;
  answer.zero = noise_below(p.file, scales, word_settings.rounding);
  answer.force_noise = settings.rounding * scales.force;
  answer.motion_noise = settings.rounding * scales.acceleration;
  answer.turning_noise = answer.motion_noise / scales.length;
  const double fastest = fastest_contact(solved);
  // What the residual leaves open of slips is no event of the sweep; nor is anything where nothing
  // moves.
  const double open =
      std::max(answer.motion_noise, settings.residuals * answer.residual * scales.acceleration);
  const double rounded = fastest <= answer.zero.acceleration
                             ? answer.zero.acceleration
                             : std::min(open, settings.slowest_slip * fastest);
  Index entry = 0;
  for (Index i = 0; i < solved.contacts.size; ++i) {
    const ContactAnswer<double>& contact = solved.contacts[i];
    const Vector3<double>& n = p.scene.bodies[contact.body].normal;
    ContactState state;
    state.mode = contact.mode;
    state.pressed = std::abs(contact.normal_force) > pressed;
    const Vector3<double> slip = contact.acceleration - contact.acceleration.dot(n) * n;
    const double sliding =
        slip.norm() + p.scene.bodies[contact.body].torsion_radius * std::abs(contact.spin);
    if (state.mode == Mode::slide && sliding <= rounded) state.mode = Mode::stick;
    if (state.mode == Mode::separate && contact.acceleration.norm() + sliding <= rounded)
      state.mode = Mode::stick; // rests there without a force
    if (state.mode == Mode::slide && slip.norm() > 0) state.slip = slip.normalized();
    for (Index j = 0; j < p.assembly.layout().cones[i].generators; ++j, ++entry)
      if (solved.friction[entry] > pressed) state.with_friction.push_back(j);
    answer.contacts.push_back(state);
  }
  return answer;
}

DetailedAnswer read_push(ScenePoint& p, const double* z) {
  read_answer(p.assembly, z, p.work.answer, 1.0);
  DetailedAnswer answer;
  answer.status = Status::solved;
  answer.normal = normal_sum(p.work.answer, p.pusher);
  answer.force = body_wrench(p.scene, p.work.answer, p.pusher).head<3>();
  answer.twist = p.work.answer.acceleration;
  answer.residual = check(p.scene, p.assembly.layout().scales, p.work.answer, 1.0).max();
  if (!(answer.residual <= Tolerances<double>().residual))
    answer.status = Status::numerical_breakdown;
  return read_contacts(p, std::move(answer));
}

DetailedAnswer judge_breaking(const ScenePoint& p, Status status,
                              const Breaking<double>& breaking) {
  BreakReport report;
  report.status = status;
  report.breaking = breaking;
  report.pusher = static_cast<Index>(&p.pusher - p.file.bodies.data());
  report.scales = p.assembly.layout().scales;
  DetailedAnswer answer;
  answer.status = holding_verdict(p.file, report, {});
  if (answer.status != Status::solved && answer.status != Status::does_not_hold) return answer;
  answer.normal = breaking.break_force;
  answer.force = breaking.force.head<3>();
  answer.twist = breaking.twist;
  answer.breaks = breaking.breaks;
  answer.residual = breaking.residuals.max();
  answer = read_contacts(p, std::move(answer));
  // Of a unit push: what the smallest one's residual leaves open.
  answer.motion_noise /= push_size(p.scene);
  answer.turning_noise = answer.motion_noise / report.scales.length;
  if (breaking.small_push > 0)
    answer.zero.acceleration =
        std::max(word_settings.rounding, settings.residuals * answer.residual *
                                             report.scales.acceleration / breaking.small_push);
  // What extrapolating from finite pushes leaves open.
  answer.force_noise += settings.line_errors * breaking.line_error * report.scales.force;
  return answer;
}

DetailedAnswer read_breaking(ScenePoint& p, const PushLimit<double>& limit) {
  Breaking<double> breaking;
  PressureRun run;
  Status status = lcpush::read_breaking(p.assembly, limit.z, limit.z_push, limit.valid_to, p.work,
                                        p.pusher, push_size(p.scene), breaking, run);
  if (status == Status::solved) status = judge(breaking, p.pusher, p.assembly.layout().scales, run);
  return judge_breaking(p, status, breaking);
}

} // namespace

/// Every cover would end in a ray, each after pivots of its own.
bool ScenePoint::has_no_answer() {
  if (!jammed_) jammed_ = is_proven_jam(assembly);
  return *jammed_;
}

SweepSolver::SweepSolver(const VariedScene& scene, const std::vector<Variation>& variations,
                         Index pusher, const ParameterSweepOptions& options)
    : variations_(variations), scene_(scene), pusher_(pusher), is_warm_(options.warm),
      watcher_(options.stop) {}

void SweepSolver::go_to(const std::vector<double>& values) {
  watcher_.look();
  point_ = std::make_unique<ScenePoint>(scene_.at(parameters_of(variations_), values), pusher_);
}

/// Memory for as many unknowns as there are here.
void SweepSolver::make_lemke() {
  if (const Index n = point_->assembly.layout().size; !lemke_ || lemke_->unknowns < n)
    lemke_.emplace(n);
}

void SweepSolver::make_structured() {
  const Assembly<double>& assembly = point_->assembly;
  const Index n = assembly.layout().size, points = assembly.layout().points;
  const Index shared = shared_actuators(assembly.factored());
  with_room(structured_, structured_lemke_scalars(n, points, shared),
            structured_lemke_integers(n, points));
  with_room(held_, held_basis_scalars(n, points, shared), held_basis_integers(n, points));
}

/// From the basis `from`, if there is one; solved: `basis` receives the last one.
Status SweepSolver::pivot(Question question, const LemkeOptions<double>& options,
                          const unsigned char* from, Basis& basis) {
  make_lemke();
  const Problem<double> problem = point_->problem(question);
  Status status =
      from == nullptr ? lemke_->init(problem, options) : lemke_->init(problem, options, from);
  if (status == Status::running) status = lemke_->solve<Watcher>(watcher_);
  if (status != Status::solved) return status;
  basis = basis_of(*lemke_, problem.size);
  return status;
}

Status SweepSolver::solve_cold(Question question, Basis& basis) {
  ++cold_;
  return pivot(question, {}, nullptr, basis);
}

bool SweepSolver::stand_on(Question question, const Basis& basis) {
  make_lemke();
  LemkeOptions<double> options;
  options.covers = 1;
  const Problem<double> problem = point_->problem(question);
  if (static_cast<Index>(basis.size()) != problem.size) return false;
  if (lemke_->init(problem, options, basis.data()) != Status::running) return false;
  return lemke_->step() == Status::solved && lemke_->pivots() == 0;
}

DetailedAnswer SweepSolver::on_basis(Question question, const Basis& basis) {
  if (!has(question)) return {};
  make_structured();
  const Problem<double> problem = point_->problem(question);
  PushLimit<double> limit;
  if (static_cast<Index>(basis.size()) != problem.size) return {};
  if (held_->look(problem, basis.data()) == Status::solved)
    limit = {held_->z(), held_->z_push(), held_->valid_to()};
  else if (stand_on(question, basis)) // the dictionary may be better conditioned
    limit = {lemke_->z(), lemke_->z_push(), lemke_->valid_to()};
  else
    return {};
  return question == Question::push ? read_push(*point_, limit.z) : read_breaking(*point_, limit);
}

DetailedAnswer SweepSolver::solve(Question question, RoundBases& bases) {
  if (!has(question)) return {};
  if (bases.empty() && point_->has_no_answer()) {
    ++cold_;
    DetailedAnswer none;
    none.status = Status::ray;
    return none;
  }
  if (takes_rounds(point_->file)) {
    if (is_from_nothing(question)) bases.clear();
    const bool is_cold = bases.empty();
    DetailedAnswer answer = solve_pad(question, bases);
    if (answer.status == Status::not_settled && !is_cold) answer = solve_pad(question, bases);
    if (is_from_nothing(question)) bases.clear();
    return answer;
  }
  if (!bases.empty()) {
    DetailedAnswer answer = on_basis(question, bases.front());
    if (answer.is_known()) {
      ++warm_;
      return answer;
    }
    // A few pivots from there, if they lead anywhere.
    const Index n = point_->assembly.layout().size;
    LemkeOptions<double> options;
    options.covers = 1;
    options.max_pivots = n;
    Basis& basis = bases.front();
    if (static_cast<Index>(basis.size()) == n &&
        pivot(question, options, basis.data(), basis) == Status::solved) {
      answer = on_basis(question, basis);
      ++warm_;
      if (answer.is_known()) return answer;
    }
  }
  bases.resize(1);
  DetailedAnswer answer;
  answer.status = solve_cold(question, bases.front());
  if (answer.status == Status::solved) return on_basis(question, bases.front());
  bases.clear();
  return answer;
}

DetailedAnswer SweepSolver::solve_pad(Question question, RoundBases& bases) {
  const Problem<double> problem = point_->problem(question);
  RoundMemory memory{bases};
  DetailedAnswer answer;
  const bool structured = problem.size >= SolveSettings().structured; // as a solve
  make_structured();
  if (structured) answer = solve_rounds(question, rounds_by(*structured_, memory));
  // A ray has been verified: the whole dictionary would find it again.
  const bool is_open = !answer.is_known() && answer.status != Status::ray;
  if (is_open && (!structured || problem.size <= limits::unknowns_dense)) {
    make_lemke();
    if (structured) memory.begin_again();
    answer = solve_rounds(question, rounds_by(*lemke_, memory));
  }
  memory.end();
  ++(memory.cold > 0 ? cold_ : warm_);
  if (!answer.is_known()) bases.clear();
  return answer;
}

template <class Pivots> AnyRounds SweepSolver::rounds_by(Pivots& pivots, RoundMemory& memory) {
  return AnyRounds(RememberedRounds<Pivots>(pivots, memory, watcher_, *held_, *structured_));
}

DetailedAnswer SweepSolver::solve_rounds(Question question, const AnyRounds& rounds) {
  ScenePoint& p = *point_;
  PressureRun run;
  DetailedAnswer answer;
  if (question == Question::push) {
    p.assembly.push_by(1.0);
    const auto options = pressure_options(p.assembly, 1.0);
    answer.status = solve_pressure(p.assembly, rounds, p.work.pressure, options, run,
                                   p.work.friction_memory(p.scene));
    if (answer.is_solved()) answer = read_push(p, p.work.pressure.z.data);
  } else {
    Breaking<double> breaking;
    const Status status = find_breaking(p.assembly, rounds, p.work, p.pusher, {}, breaking, run);
    answer = judge_breaking(p, status, breaking);
    p.assembly.push_by(1.0);
  }
  return answer;
}

} // namespace lcpush::desktop
