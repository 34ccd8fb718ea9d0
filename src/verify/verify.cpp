#include "lcpush/desktop/verify.hpp"

#include "lcpush/desktop/input_error.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"
#include "verify/answer_completer.hpp"
#include "verify/foreign_point.hpp"
#include "verify/settings.hpp"
#include "verify/verify_rows.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// An Answer with its arrays.
struct OwnedAnswer : Answer<double> {
  explicit OwnedAnswer(const Layout<double>& layout)
      : contact_list(static_cast<std::size_t>(layout.points)),
        closing_list(static_cast<std::size_t>(layout.actuators)) {
    Index generators = 0;
    for (const ConeGroup<double>& cone : layout.cones) generators += cone.generators;
    friction_list.resize(static_cast<std::size_t>(generators));
    contacts = span_of(contact_list);
    friction = span_of(friction_list);
    closing = span_of(closing_list);
  }
  OwnedAnswer(const OwnedAnswer&) = delete;
  OwnedAnswer& operator=(const OwnedAnswer&) = delete;

private:
  std::vector<ContactAnswer<double>> contact_list;
  std::vector<double> friction_list, closing_list;
};

/// The scaled unknowns of the assembly's problem that make this answer.
Eigen::VectorXd unknowns_of(const Layout<double>& layout, const Answer<double>& answer) {
  Eigen::VectorXd z(layout.size);
  const double* beta = answer.friction.data;
  for (Index i = 0; i < layout.points; ++i) {
    const ConeGroup<double>& cone = layout.cones[i];
    const double lambda = answer.contacts[i].normal_force / layout.scales.force;
    z[cone.variable] = cone.normals == 2 ? std::max(lambda, 0.0) : lambda;
    if (cone.normals == 2) z[cone.variable + 1] = std::max(-lambda, 0.0);
    for (Index j = 0; j < cone.generators; ++j)
      z[layout.friction_index(i, j)] = *beta++ / layout.scales.force;
    if (cone.generators > 0)
      z[layout.slip_index(i)] = answer.contacts[i].slip / layout.scales.acceleration;
  }
  for (Index a = 0; a < layout.actuators; ++a)
    z[layout.closing_index(a)] = answer.closing[a] * layout.reach[a] / layout.scales.acceleration;
  return z;
}

/// The largest difference among the contact forces that the file gives, and the bodies'.
double force_difference(const Scene<double>& scene, const ForeignAnswer& given,
                        const Answer<double>& a, const Answer<double>& b) {
  double most = 0;
  for (Index k = 0; k < static_cast<Index>(given.bodies.size()); ++k) {
    const ForeignBody& body = given.bodies[static_cast<std::size_t>(k)];
    const Vector6<double> off =
        body_wrench(scene, a, scene.bodies[k]) - body_wrench(scene, b, scene.bodies[k]);
    if (body.force) most = std::max(most, off.head<3>().norm());
    if (body.normal_force)
      most =
          std::max(most, std::abs(normal_sum(a, scene.bodies[k]) - normal_sum(b, scene.bodies[k])));
  }
  for (Index i = 0; i < static_cast<Index>(given.contacts.size()); ++i) {
    const ForeignContact& contact = given.contacts[static_cast<std::size_t>(i)];
    const ContactAnswer<double>&x = a.contacts[i], &y = b.contacts[i];
    if (contact.normal_force) most = std::max(most, std::abs(x.normal_force - y.normal_force));
    if (contact.friction_force) most = std::max(most, (x.friction_force - y.friction_force).norm());
  }
  return most;
}

double motion_difference(const Answer<double>& a, const Answer<double>& b,
                         const Scales<double>& scales) {
  return motion_size<double>(a.acceleration - b.acceleration, scales) * scales.acceleration;
}

class Verification {
public:
  Verification(const SceneFile& file, const ForeignAnswer& given, const VerifyOptions& options)
      : given_(given), push_(file), own_(file), layout_(push_.layout()), answer_(layout_) {
    report_.tolerance = options.tolerance;
  }

  VerifyReport run() {
    if (!given_.not_this_scene.empty()) {
      report_.because = given_.not_this_scene;
      return report_;
    }
    for (const double part : VerifySettings::moves) {
      complete(part * report_.tolerance);
      if (!has_forces_ || report_.residual <= report_.tolerance) break;
    }
    study_point();
    return report_;
  }

private:
  /// `least`: what is slower, in scaled units, does not move.
  void complete(double least) {
    const Completion completion = AnswerCompleter(push_, own_, given_, least, answer_).run();
    if (!completion.missing.empty())
      throw InputError(given_.file + ": what is given leaves the rest open; give also " +
                       completion.missing);
    has_forces_ = completion.has_forces;
    report_.completed = completion.completed;
    report_.rows = broken_rows(push_, given_, answer_, has_forces_);
    report_.residual = worst_row().scaled;
  }

  const ForeignAnswer& given_;
  Push push_;
  OwnSolution own_;
  const Layout<double>& layout_;
  OwnedAnswer answer_;
  VerifyReport report_;
  bool has_forces_ = false; // filled in

  void study_point() {
    const DenseProblem problem = dense(push_.assembly().problem());
    const Eigen::VectorXd z = unknowns_of(layout_, answer_);
    report_.metrics = measure_point(problem, z);
    report_.objective =
        report_.metrics.products * layout_.scales.force * layout_.scales.acceleration;
    if (!push_.file().is_round) report_.basis = study_final_basis(push_.assembly(), answer_);
    report_.motion_proved = motion_is_determined(push_.scene());
    OwnedAnswer nearest(layout_);
    refine(problem, z, nearest);
    const double tolerance = report_.tolerance;
    if (report_.residual <= tolerance) {
      // Of an answer with few digits, the exact one next to it; a motion alone stands as it is.
      const bool closer =
          !has_forces_ && report_.refined.found && report_.refined.residual < report_.residual;
      compare((closer ? nearest : answer_));
      return;
    }
    report_.verdict = Verdict::not_a_solution;
    report_.because = std::string(law_text(worst_row())) + ": " + worst_row().name;
    bool feasible = z.allFinite();
    const Eigen::VectorXd w = problem.w(z);
    for (Index i = 0; i < z.size(); ++i)
      feasible = feasible && (problem.is_free(i) ? std::abs(w[i]) <= tolerance
                                                 : std::min(z[i], w[i]) >= -tolerance);
    for (const BrokenRow& row : report_.rows) {
      const bool linear =
          !row.law || row.law == Law::newton || row.law == Law::grip || row.law == Law::rigidity;
      feasible = feasible && !(linear && !(row.scaled <= tolerance));
    }
    if (feasible && is_stationary(problem, z)) report_.verdict = Verdict::spurious_minimum;
  }

  void refine(const DenseProblem& problem, const Eigen::VectorXd& z, Answer<double>& refined) {
    const auto point = refine_point(problem, z);
    if (!point) return;
    report_.refined.found = true;
    read_answer(push_.assembly(), point->data(), refined, 1.0);
    report_.refined.residual = check(push_.scene(), layout_.scales, refined, 1.0).max();
    report_.refined.moved = (*point - z).cwiseAbs().maxCoeff();
    report_.refined.force = force_difference(push_.scene(), given_, answer_, refined);
    report_.refined.acceleration = motion_difference(answer_, refined, layout_.scales);
  }

  void compare(const Answer<double>& nearest) {
    const PushReport& own = own_.report();
    report_.own.status = own.status;
    report_.verdict = Verdict::other_solution;
    if (own.status != Status::solved) return;
    const Scales<double>& scales = layout_.scales;
    report_.own.force = force_difference(push_.scene(), given_, nearest, own.answer);
    report_.own.acceleration = motion_difference(nearest, own.answer, scales);
    const double close = close_by(report_.tolerance);
    double largest = scales.force;
    for (const ContactAnswer<double>& contact : own.answer.contacts)
      largest = std::max(largest, std::abs(contact.normal_force));
    const bool same_motion =
        lcpush::same_motion<double>({nearest.acceleration, {}}, {own.answer.acceleration, {}},
                                    scales, push_size(push_.scene()), close);
    if (!same_motion) return;
    report_.verdict =
        report_.own.force <= close * largest ? Verdict::same_solution : Verdict::other_forces;
  }

  const BrokenRow& worst_row() const {
    return *std::max_element(report_.rows.begin(), report_.rows.end(),
                             [](const BrokenRow& a, const BrokenRow& b) {
                               return !(b.scaled <= a.scaled); // NaN is the worst
                             });
  }
};

Index pusher_of(const SceneFile& file, const ForeignAnswer& given) {
  std::vector<std::string> names;
  Index pusher = -1;
  for (Index b = 0; b < static_cast<Index>(file.bodies.size()); ++b) {
    if (file.body(b).role != Role::pusher) continue;
    names.push_back(file.body_name(b));
    if (given.pusher.empty() || given.pusher == names.back()) pusher = b;
  }
  if (pusher < 0 || (given.pusher.empty() && names.size() > 1))
    throw InputError(given.file + ": \"break_force\" is of a pusher" +
                     (names.empty() ? ", and the scene has none"
                                    : ": give also \"pusher\", " + listed(names, "or")));
  return pusher;
}

/// Of the force that just moves the object: beside lcpush's own, and others that obey the laws.
VerifyReport verify_break(const SceneFile& file, const ForeignAnswer& given,
                          const VerifyOptions& options) {
  Push push(file);
  const BreakReport own = push.find_breaking(pusher_of(file, given), PushOptions());
  VerifyReport report;
  report.tolerance = options.tolerance;
  report.own.status = own.status;
  report.verdict = Verdict::other_solution;
  if (own.status != Status::solved) return report;
  const double lawful = own.breaking.break_force, size = std::abs(lawful) + own.scales.force;
  const auto off = [&](double force) { return std::abs(*given.break_force - force); };
  double least = off(lawful);
  for (const OtherBreak& other : own.others) least = std::min(least, off(other.break_force));
  report.own.force = off(lawful);
  report.residual = least / size;
  report.rows = {{std::nullopt, "lcpush's own push breaks the grasp at " + brief(lawful) + " N",
                  report.residual, least, "N"}};
  const double close = close_by(options.tolerance) * size;
  if (report.own.force <= close)
    report.verdict = Verdict::same_solution;
  else if (!(least <= close) || !own.breaking.breaks)
    report.verdict = Verdict::not_a_solution;
  if (report.verdict == Verdict::not_a_solution)
    report.because = std::string(law_text(report.rows[0])) + ": " + report.rows[0].name;
  return report;
}

} // namespace

const char* verdict_text(Verdict verdict) {
  constexpr const char* texts[] = {"same solution",
                                   "same motion, other forces",
                                   "another valid solution",
                                   "not a solution",
                                   "a spurious local minimum of the quadratic form",
                                   "not this scene's data"};
  return texts[static_cast<int>(verdict)];
}

VerifyReport verify_answer(const SceneFile& file, const ForeignAnswer& answer,
                           const VerifyOptions& options) {
  return answer.break_force && answer.not_this_scene.empty()
             ? verify_break(file, answer, options)
             : Verification(file, answer, options).run();
}

} // namespace lcpush::desktop
