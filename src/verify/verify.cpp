#include "lcpush/desktop/verify.hpp"

#include "lcpush/desktop/input_error.hpp"
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

/// The largest difference among the contact forces that the file gives.
double force_difference(const ForeignAnswer& given, const Answer<double>& a,
                        const Answer<double>& b) {
  double most = 0;
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
      : given_(given), push_(file), layout_(push_.layout()), answer_(layout_) {
    if (file.is_round) push_.linearize_cones(friction_directions());
    report_.tolerance = options.tolerance;
  }

  VerifyReport run() {
    if (!given_.not_this_scene.empty()) {
      report_.because = given_.not_this_scene;
      return report_;
    }
    const Completion completion = AnswerCompleter(push_, given_, report_.tolerance, answer_).run();
    if (!completion.missing.empty())
      throw InputError(given_.file + ": what is given leaves the rest open; give also " +
                       completion.missing);
    has_forces_ = completion.has_forces;
    report_.completed = completion.completed;
    report_.rows = broken_rows(push_, given_, answer_);
    report_.residual = worst_row().scaled;
    study_point();
    return report_;
  }

private:
  const ForeignAnswer& given_;
  Push push_;
  const Layout<double>& layout_;
  OwnedAnswer answer_;
  VerifyReport report_;
  bool has_forces_ = false; // filled in

  /// Of round friction: where each point's force acts as far as the file tells, else against its
  /// slip.
  std::vector<Vector3<double>> friction_directions() const {
    const Scene<double>& scene = push_.scene();
    std::vector<Vector3<double>> list;
    for (Index i = 0; i < layout_.points; ++i) {
      const Body<double>& body = scene.bodies[layout_.body[i]];
      const ForeignContact contact =
          given_.contacts.empty() ? ForeignContact() : given_.contacts[static_cast<std::size_t>(i)];
      ContactAnswer<double> known;
      if (contact.friction_force) known.friction_force = *contact.friction_force;
      if (contact.torsion) known.torsion = *contact.torsion;
      if (contact.friction_force || !given_.acceleration)
        list.push_back(friction_of(body, known));
      else
        list.push_back(
            -slip_of<double>(body, scene.points[i], *given_.acceleration - body.acceleration));
    }
    return list;
  }

  /// Everything that needs the literal problem, before a pressure law changes it.
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
    report_.refined.force = force_difference(given_, answer_, refined);
    report_.refined.acceleration = motion_difference(answer_, refined, layout_.scales);
  }

  void compare(const Answer<double>& nearest) {
    PushOptions options;
    options.explain_jams = false;
    options.other_covers = 0;
    const PushReport own = push_.solve(options);
    report_.own.status = own.status;
    report_.verdict = Verdict::other_solution;
    if (own.status != Status::solved) return;
    const Scales<double>& scales = layout_.scales;
    report_.own.force = force_difference(given_, nearest, own.answer);
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
  return Verification(file, answer, options).run();
}

} // namespace lcpush::desktop
