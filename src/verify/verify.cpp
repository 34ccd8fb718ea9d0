#include "lcpush/desktop/verify.hpp"

#include "formats/read_number.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"
#include "verify/answer_completer.hpp"
#include "verify/foreign_point.hpp"
#include "verify/likely_mistakes.hpp"
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

/// The largest difference among the contact forces that the file gives, and the bodies'; none: it
/// gives no force.
std::optional<double> force_difference(const SceneFile& file, const ForeignAnswer& given,
                                       const Answer<double>& a, const Answer<double>& b) {
  std::optional<double> most;
  const auto note = [&](double off) { most = std::max(most.value_or(0), off); };
  const Scene<double> scene = file.view();
  for (Index k = 0; k < static_cast<Index>(given.bodies.size()); ++k) {
    const ForeignBody& body = given.bodies[static_cast<std::size_t>(k)];
    const Body<double>& points = scene.bodies[k];
    const Vector6<double> off = body_wrench(scene, a, points) - body_wrench(scene, b, points);
    if (body.force) note(off.head<3>().norm());
    if (body.normal_force) note(std::abs(normal_sum(a, points) - normal_sum(b, points)));
  }
  for (Index i = 0; i < static_cast<Index>(given.contacts.size()); ++i) {
    const ForeignContact& contact = given.contacts[static_cast<std::size_t>(i)];
    const ContactAnswer<double>&x = a.contacts[i], &y = b.contacts[i];
    if (contact.normal_force) note(std::abs(x.normal_force - y.normal_force));
    if (contact.friction_force) note((x.friction_force - y.friction_force).norm());
  }
  return most;
}

double motion_difference(const Answer<double>& a, const Answer<double>& b,
                         const Scales<double>& scales) {
  return motion_size<double>(a.acceleration - b.acceleration, scales) * scales.acceleration;
}

class Verification {
public:
  Verification(const SceneFile& file, const ForeignAnswer& given, const VerifyOptions& options,
               OwnSolution& own)
      : given_(given), push_(file), own_(own), layout_(push_.layout()), answer_(layout_) {
    report_.tolerance = options.tolerance;
  }

  VerifyReport run() {
    if (!given_.not_this_scene.empty()) {
      report_.because = given_.not_this_scene;
      return report_;
    }
    settle();
    study_point();
    if (!is_valid(report_.verdict)) look_for_mistakes();
    return report_;
  }

private:
  bool holds() const { return report_.residual <= report_.tolerance; }

  /// A force that is a little off, or has few digits, makes a motion that no contact allows. Beside
  /// lcpush's own motion it shows as what it is.
  void settle() {
    complete(given_);
    const bool is_open = !report_.completed.empty();
    if (!is_open || own_.report().status != Status::solved) return;
    if (holds() && has_own_motion(answer_)) return;
    const double as_given = report_.residual;
    ForeignAnswer beside = given_;
    beside.acceleration = own_.report().answer.acceleration;
    if (beside.closing.empty())
      for (const double closing : own_.report().answer.closing) beside.closing.push_back(closing);
    complete(beside);
    const bool is_better = as_given <= report_.tolerance
                               ? holds()
                               : report_.residual <= VerifySettings::own_first * as_given;
    if (!is_better) return complete(given_);
    report_.completed.insert(report_.completed.begin(),
                             "the motion, as lcpush's own answer has it");
  }

  /// `given`: what is given, or with another motion.
  void complete(const ForeignAnswer& given) {
    // What is slower than a part of the tolerance is at rest, but for half of the push.
    const double push = push_size(push_.scene()) / layout_.scales.acceleration;
    const double slow = push > 0 ? push / 2 : 1;
    for (const double part : VerifySettings::moves) {
      const double least = std::min(part * report_.tolerance, slow);
      const Completion completion = AnswerCompleter(push_, own_, given, least, answer_).run();
      if (!completion.missing.empty())
        throw InputError(given_.file + ": what is given leaves the rest open; give also " +
                         completion.missing);
      has_forces_ = completion.has_forces;
      report_.completed = completion.completed;
      report_.rows = broken_rows(push_, given_, answer_, has_forces_);
      report_.residual = worst_row()->scaled;
      if (!has_forces_ || holds()) return;
    }
  }

  /// Undone, a mistake lets all laws hold; one of signs may stand beside others.
  void look_for_mistakes() {
    if (own_.report().status != Status::solved) return;
    const double nearly = VerifySettings::nearly * report_.tolerance;
    if (report_.residual <= std::min(nearly, VerifySettings::rounded))
      return; // few digits, no slip
    for (const LikelyMistake& mistake : likely_mistakes(push_.file(), given_)) {
      if (mistake.is_of_moments && !has_own_moments(mistake.answer)) continue;
      Verification check(push_.file(), mistake.answer, {report_.tolerance}, own_);
      check.settle();
      if (mistake.beside && left_of(*mistake.beside) <= check.report_.residual) continue;
      const double left = check.report_.residual / report_.residual;
      const bool is_less = mistake.is_of_signs && left <= VerifySettings::turned;
      if (!check.holds() && !(is_less && report_.hint.empty())) continue;
      report_.hint =
          mistake.undone + " " +
          (check.holds() ? "all laws hold" : "the error is " + brief(left) + " times as large") +
          ": " + mistake.because + ".";
      if (check.holds()) return;
    }
  }

  double left_of(const ForeignAnswer& other) {
    Verification check(push_.file(), other, {report_.tolerance}, own_);
    check.settle();
    return check.report_.residual;
  }
  /// Is the largest moment about as large as in lcpush's own answer?
  bool has_own_moments(const ForeignAnswer& other) const {
    const Scene<double> scene = push_.file().view();
    double given = 0, own = 0;
    for (std::size_t b = 0; b < other.bodies.size(); ++b) {
      if (!other.bodies[b].moment) continue;
      given = std::max(given, other.bodies[b].moment->norm());
      own = std::max(own,
                     body_wrench(scene, own_.report().answer, scene.bodies[static_cast<Index>(b)])
                         .tail<3>()
                         .norm());
    }
    return std::abs(given - own) <= own / 2;
  }

  const ForeignAnswer& given_;
  Push push_;
  OwnSolution& own_;
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
    find_imbalance();
    if (report_.residual <= tolerance) {
      // Of an answer with few digits, the exact one next to it; a motion alone stands as it is.
      const bool closer =
          !has_forces_ && report_.refined.found && report_.refined.residual < report_.residual;
      compare((closer ? nearest : answer_));
      return;
    }
    report_.verdict = Verdict::not_a_solution;
    const bool is_given = !(report_.rows.front().scaled <= tolerance); // those come first
    report_.told = is_given ? 0 : static_cast<std::size_t>(worst_row() - report_.rows.begin());
    const BrokenRow& told = report_.rows[report_.told];
    report_.because = std::string(law_text(told)) + ": " + told.name;
    report_.acceleration = answer_.acceleration.head<3>();
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

  void find_imbalance() {
    const auto has_force = [](const ForeignBody& body) { return body.force.has_value(); };
    if (given_.bodies.empty() ||
        !std::all_of(given_.bodies.begin(), given_.bodies.end(), has_force))
      return;
    const Object<double>& object = push_.scene().object;
    Vector3<double> left = object.wrench.head<3>() + object.mass * push_.scene().gravity -
                           object.mass * answer_.acceleration.head<3>();
    for (const ForeignBody& body : given_.bodies) left += *body.force;
    if (push_.scene().planar) {
      if (std::abs(left[2]) > report_.tolerance * layout_.scales.force)
        report_.out_of_plane = left[2];
      left[2] = 0;
    }
    if (!holds()) report_.imbalance = left;
  }

  void refine(const DenseProblem& problem, const Eigen::VectorXd& z, Answer<double>& refined) {
    const auto point = refine_point(problem, z);
    if (!point) return;
    report_.refined.found = true;
    read_answer(push_.assembly(), point->data(), refined, 1.0);
    report_.refined.residual = check(push_.scene(), layout_.scales, refined, 1.0).max();
    report_.refined.moved = (*point - z).cwiseAbs().maxCoeff();
    report_.refined.force = force_difference(push_.file(), given_, answer_, refined);
    report_.refined.acceleration = motion_difference(answer_, refined, layout_.scales);
  }

  void compare(const Answer<double>& nearest) {
    const PushReport& own = own_.report();
    report_.own.status = own.status;
    report_.verdict = Verdict::other_solution;
    if (own.status != Status::solved) return;
    const Scales<double>& scales = layout_.scales;
    report_.own.force = force_difference(push_.file(), given_, nearest, own.answer);
    report_.own.acceleration = motion_difference(nearest, own.answer, scales);
    const double close = close_by(report_.tolerance);
    double largest = scales.force;
    for (const ContactAnswer<double>& contact : own.answer.contacts)
      largest = std::max(largest, std::abs(contact.normal_force));
    if (!has_own_motion(nearest)) return;
    report_.verdict = report_.own.force.value_or(0) <= close * largest ? Verdict::same_solution
                                                                       : Verdict::other_forces;
  }

  bool has_own_motion(const Answer<double>& answer) {
    return same_motion<double>({answer.acceleration, {}}, {own_.report().answer.acceleration, {}},
                               layout_.scales, push_size(push_.scene()),
                               close_by(report_.tolerance));
  }

  std::vector<BrokenRow>::const_iterator worst_row() const {
    return std::max_element(report_.rows.begin(), report_.rows.end(),
                            [](const BrokenRow& a, const BrokenRow& b) {
                              return !(b.scaled <= a.scaled); // NaN is the worst
                            });
  }
};

/// Has no number of the answer more digits than people print?
bool has_few_digits(const ForeignAnswer& given) {
  bool all = true;
  const auto look = [&all](double number) {
    const std::string text = in_digits(number, VerifySettings::printed_digits);
    const double rounding = std::abs(number - read_finite_number(text).value);
    all = all && rounding <= VerifySettings::negligible * std::abs(number);
  };
  const auto look_at = [&look](const auto& vector) {
    if (vector) std::for_each(vector->begin(), vector->end(), look);
  };
  look_at(given.acceleration);
  for (const ForeignContact& contact : given.contacts) {
    look_at(contact.friction_force);
    for (const auto& number : {contact.normal_force, contact.torsion})
      if (number) look(*number);
  }
  for (const ForeignBody& body : given.bodies) {
    look_at(body.force);
    look_at(body.moment);
    if (body.normal_force) look(*body.normal_force);
  }
  return all;
}

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
  if (own.status != Status::solved)
    throw InputError(given.file + ": a breaking force alone is judged beside lcpush's own, and " +
                     (own.status == Status::does_not_hold
                          ? "there is none: the object moves before it is pushed"
                          : "it found none: see lcpush break"));
  const double lawful = own.breaking.break_force, size = std::abs(lawful) + own.scales.force;
  const auto off = [&](double force) { return std::abs(*given.break_force - force); };
  double least = off(lawful);
  for (const OtherBreak& other : own.others) {
    const double low = std::min(lawful, other.break_force),
                 high = std::max(lawful, other.break_force);
    // With the same motion, what is between two answers is one, too.
    const bool is_between = own.unique_motion != Uniqueness::no && *given.break_force > low &&
                            *given.break_force < high;
    least = std::min(least, is_between ? 0 : off(other.break_force));
  }
  report.own.force = off(lawful);
  report.residual = least / size;
  report.rows = {{std::nullopt,
                  "lcpush's own push breaks the grasp at " + brief(lawful) +
                      (own.other_force ? " or " + brief(*own.other_force) : "") + " N",
                  report.residual, least, "N", given.break_force, lawful}};
  report.in_few_digits = true;
  const double close = std::max(options.tolerance, VerifySettings::same_answer) * size;
  if (off(lawful) <= close)
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
  if (answer.break_force && answer.not_this_scene.empty())
    return verify_break(file, answer, options);
  OwnSolution own(file);
  VerifyReport report = Verification(file, answer, options, own).run();
  report.in_few_digits = has_few_digits(answer);
  return report;
}

} // namespace lcpush::desktop
