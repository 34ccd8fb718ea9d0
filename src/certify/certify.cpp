#include "lcpush/desktop/certify.hpp"

#include "certify/exact_answer.hpp"
#include "certify/exact_cones.hpp"
#include "certify/settings.hpp"
#include "certify/sha256.hpp"
#include "solve/owned_assembly.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

/// The doubles next to which the exact answer is looked for.
struct Guess {
  std::vector<double> x, w;           ///< SI units
  std::vector<double> x_unit, w_unit; ///< what counts as large; 0 of the free ones
};

/// In the order of scene_problem.
Guess guess_of(const Scene<double>& scene, const MixedProblem& problem,
               const Answer<double>& answer) {
  double force = 0;
  for (const ContactAnswer<double>& contact : answer.contacts)
    force = std::max(force, std::abs(contact.normal_force));
  if (!(force > 0)) force = 1;
  const double acceleration = force / scene.object.mass;
  Guess guess;
  const auto add = [&](double x, bool is_force) {
    guess.x.push_back(x);
    guess.x_unit.push_back(is_force ? force : acceleration);
    guess.w_unit.push_back(is_force ? acceleration : force);
  };
  Index entry = 0;
  for (const Body<double>& body : scene.bodies)
    for (Index i = body.first_point; i < body.first_point + body.point_count; ++i) {
      const ContactAnswer<double>& contact = answer.contacts[i];
      add(std::max(contact.normal_force, 0.0), true);
      if (body.bilateral) add(std::max(-contact.normal_force, 0.0), true);
      const Index generators = generator_count(scene, body);
      for (Index j = 0; j < generators; ++j) add(answer.friction[entry++], true);
      if (generators > 0) add(contact.slip, false);
    }
  guess.x.insert(guess.x.end(), answer.closing.begin(), answer.closing.end());
  for (Index i = 0; i < 6; ++i)
    if (!scene.planar || i < 2 || i == 5) guess.x.push_back(answer.acceleration[i]);
  guess.x_unit.resize(guess.x.size(), 0);
  guess.w_unit.resize(guess.x.size(), 0);
  for (std::size_t i = 0; i < problem.size(); ++i) {
    double sum = problem.q[i].value();
    for (const ExactEntry& e : problem.rows[i])
      sum += e.value.value() * guess.x[static_cast<std::size_t>(e.column)];
    guess.w.push_back(sum);
  }
  return guess;
}

/// What stands out from rounding, and more than its partner.
std::vector<Part> acting_of(const Guess& guess, double tolerance) {
  std::vector<Part> acting;
  for (std::size_t i = 0; i < guess.x.size(); ++i) {
    const double x = guess.x_unit[i] > 0 ? guess.x[i] / guess.x_unit[i] : 0;
    const double w = guess.w_unit[i] > 0 ? guess.w[i] / guess.w_unit[i] : 0;
    acting.push_back(std::max(x, w) <= tolerance ? Part::neither : x > w ? Part::x : Part::w);
  }
  return acting;
}

std::optional<ExactAnswer> answer_near(const MixedProblem& problem, const Guess& guess) {
  std::optional<ExactAnswer> exact;
  for (const double zero : certify_settings.zeros)
    if (!exact) exact = answer_near(problem, acting_of(guess, zero), guess.x);
  return exact;
}

/// The final basis of Lemke's pivots on the literal problem in doubles, from this covering vector
/// on; empty if they end otherwise.
Basis pivoted_basis(const Scene<double>& scene, double push, Index first_cover, std::size_t size) {
  OwnedAssembly<double> assembly(scene);
  assembly.get().push_by(push);
  const Problem<double> problem = assembly.get().problem();
  if (problem.size > limits::unknowns_certified) return {};
  OwnedLemke<double> lemke(problem.size);
  LemkeOptions<double> options;
  options.first_cover = first_cover;
  (void)lemke.init(problem, options);
  if (lemke.solve() != Status::solved) return {};
  Basis basic(size, 0);
  for (Index i = 0; i < problem.free_begin; ++i)
    basic[static_cast<std::size_t>(i)] = lemke.is_basic(i) ? 1 : 0;
  return basic;
}

SceneOf<Rational> exact_scene(const std::string& text, const SceneFile& file,
                              const Rational& push) {
  SceneOf<Rational> scene = parse_scene<Rational>(text, file.lines.file);
  scene.facets = file.facets;
  scene.pressure = Pressure::rigid;
  for (Body<Rational>& body : scene.bodies) body.acceleration *= push;
  return scene;
}

Certificate scene_certificate(Proof proof, const std::string& text, const SceneFile& file) {
  Certificate certificate;
  certificate.proof = proof;
  certificate.law = "literal";
  certificate.facets = file.facets;
  certificate.add_fingerprint(text);
  return certificate;
}

void take_basis(const MixedProblem& problem, Certificate& certificate) {
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (!problem.is_free(i) && certificate.x[i].sign() > 0)
      certificate.basis.push_back(static_cast<Index>(i));
}

void take_answer(const MixedProblem& problem, const Guess& guess, ExactAnswer& exact,
                 Certificate& certificate) {
  certificate.x = std::move(exact.x);
  take_basis(problem, certificate);
  for (std::size_t i = 0; i < problem.size(); ++i)
    if (guess.x_unit[i] > 0)
      certificate.distance = std::max(
          certificate.distance, std::abs(certificate.x[i].value() - guess.x[i]) / guess.x_unit[i]);
}

double largest_of(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double x : numbers) largest = std::max(largest, std::abs(x));
  return largest;
}

} // namespace

void Certificate::add_fingerprint(const std::string& bytes) {
  fingerprints.push_back(sha256(bytes));
}

std::optional<Certificate> certify_answer(const std::string& text, const SceneFile& file,
                                          const Answer<double>& answer, double push) {
  Certificate certificate = scene_certificate(Proof::answer, text, file);
  certificate.push = Rational(push);
  const MixedProblem problem = scene_problem(exact_scene(text, file, certificate.push));
  const Guess guess = guess_of(file.view(), problem, answer);
  std::optional<ExactAnswer> exact = answer_near(problem, guess);
  // Another cover ends in another basis, where less may tie.
  std::vector<Basis> bases;
  for (Index k = 0; k < certify_settings.bases && !exact; ++k) {
    const Basis basic =
        pivoted_basis(file.view(), push, certify_settings.bases_apart * k, problem.size());
    if (basic.empty() || std::find(bases.begin(), bases.end(), basic) != bases.end()) continue;
    exact = answer_of_basis(problem, basic);
    bases.push_back(basic);
  }
  bases.resize(std::min(bases.size(), certify_settings.pivoted_bases));
  if (!exact) exact = answer_by_pivots(problem, bases);
  if (!exact) return std::nullopt;
  take_answer(problem, guess, *exact, certificate);
  return certificate;
}

std::optional<Certificate> certify_squeeze(const std::string& text, const SceneFile& file,
                                           const std::vector<NamedValue>& ray) {
  Certificate certificate = scene_certificate(Proof::squeeze, text, file);
  const MixedProblem problem = scene_problem(exact_scene(text, file, 1));
  std::vector<double> guess(problem.size(), 0.0);
  double largest = 0;
  for (const NamedValue& entry : ray) {
    const auto i = static_cast<std::size_t>(entry.unknown);
    if (problem.is_free(i) || problem.limits_forces(i)) continue;
    guess[i] = entry.value;
    largest = std::max(largest, entry.value);
  }
  if (!(largest > 0)) return std::nullopt;
  for (double& value : guess) value /= largest;
  std::optional<Column> forces = squeeze_near(problem, guess);
  if (!forces) return std::nullopt;
  certificate.x = std::move(*forces);
  take_basis(problem, certificate);
  return certificate;
}

std::optional<Certificate> certify_cannot_hold(const std::string& text, const SceneFile& file) {
  Certificate certificate = scene_certificate(Proof::cannot_hold, text, file);
  certificate.push = 0;
  std::vector<Column> columns;
  Column load;
  holding_question(scene_problem(exact_scene(text, file, 1)), columns, load);
  std::optional<Column> motion = separation(columns, load);
  if (!motion) return std::nullopt;
  certificate.x = std::move(*motion);
  return certificate;
}

std::optional<Certificate> certify_push(const std::string& text, const SceneFile& file,
                                        const PushReport& report) {
  if (report.status == Status::solved) return certify_answer(text, file, report.answer, 1);
  return certify_squeeze(text, file, report.ray);
}

std::optional<Certificate> certify_break(const std::string& text, const SceneFile& file, Push& push,
                                         Index pusher, const BreakReport& report) {
  if (report.status == Status::does_not_hold) return certify_cannot_hold(text, file);
  if (report.status != Status::solved) return certify_squeeze(text, file, report.ray);
  PushOptions again; // the answer at the small push; the search for others has overwritten it
  again.solver = report.solver;
  again.other_paths = 0;
  push.find_breaking(pusher, again);
  return certify_answer(text, file, push.last_answer(),
                        report.breaking.small_push / push_size(file.view()));
}

std::string uncertified_law(const SceneFile& file) {
  if (file.lines.ranges > 0)
    return "proves one scene, and in this one numbers are ranges: give them one value each";
  if (file.pressure == Pressure::even)
    return "proves the literal equations, which pressure = \"even\" replaces: use \"pad\" or "
           "\"rigid\"";
  if (const Index n = size_of(file.view()).unknowns(); n > limits::unknowns_proved)
    return "proves up to " + std::to_string(limits::unknowns_proved) +
           " unknowns, and the scene has " + std::to_string(n) + ": use fewer facets or points";
  return {};
}

std::optional<Certificate> certify_raw(const ExactMatrix& M, const ExactMatrix& q,
                                       const std::vector<unsigned char>& free,
                                       const RawAnswer& answer) {
  Certificate certificate;
  certificate.law = "raw";
  certificate.free = free;
  const MixedProblem problem = raw_mixed_problem(M, q, free);
  if (answer.status == Status::solved) {
    std::optional<ExactAnswer> exact = answer_of_basis(problem, answer.basic);
    Guess guess{answer.z, answer.w, {}, {}};
    guess.x_unit.assign(answer.z.size(), largest_of(answer.z));
    guess.w_unit.assign(answer.z.size(), largest_of(answer.w));
    if (!exact) exact = answer_near(problem, guess);
    if (!exact) exact = answer_by_pivots(problem, {answer.basic});
    if (!exact) return std::nullopt;
    take_answer(problem, guess, *exact, certificate);
    return certificate;
  }
  // q = w - M z with w, z >= 0 has no answer if a combination of the rows forbids it.
  const std::size_t n = problem.size();
  std::vector<Column> columns;
  for (std::size_t j = 0; j < n; ++j) {
    Column of_w(n), of_z(n);
    of_w[j] = 1;
    for (std::size_t i = 0; i < n; ++i) of_z[i] = -M(static_cast<Index>(i), static_cast<Index>(j));
    if (problem.is_free(j)) {
      Column other = of_z;
      for (Rational& x : other) x.negate();
      columns.push_back(std::move(other));
    } else {
      columns.push_back(std::move(of_w));
    }
    columns.push_back(std::move(of_z));
  }
  std::optional<Column> y = separation(columns, q.values);
  if (!y) return std::nullopt;
  for (Rational& x : *y) x.negate();
  certificate.proof = Proof::no_answer;
  certificate.push = 0;
  certificate.x = std::move(*y);
  return certificate;
}

} // namespace lcpush::desktop
