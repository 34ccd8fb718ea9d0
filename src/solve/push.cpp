#include "lcpush/desktop/push.hpp"

#include <cmath>
#include <new>

#include "solve/push_rounds.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {
constexpr double ray_noise = 1e-9; // of its largest entry
} // namespace

std::string point_name(const SceneFile& file, Index point) {
  for (std::size_t b = 0; b < file.bodies.size(); ++b) {
    const Index offset = point - file.bodies[b].first_point;
    if (offset >= 0 && offset < file.bodies[b].point_count)
      return file.body_names[b] + "." + std::to_string(offset + 1);
  }
  return "?";
}

std::string direction_text(const Vector3<double>& direction) {
  constexpr double slack = 5e-4;
  for (Index axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0})
      if ((direction - sign * Vector3<double>::Unit(axis)).norm() < slack)
        return std::string(sign > 0 ? "+" : "-") + "xyz"[axis];
  const auto rounded = [](double x) { return shown(std::round(x * 1000) / 1000 + 0.0); };
  return "(" + rounded(direction[0]) + ", " + rounded(direction[1]) + ", " + rounded(direction[2]) +
         ")";
}

std::string Push::variable_name(Index i) const {
  const Name name = name_of(layout(), i);
  switch (name.meaning) {
  case Meaning::normal: return "normal of " + point_name(file_, name.of);
  case Meaning::pull: return "pull of " + point_name(file_, name.of);
  case Meaning::slip: return "slip of " + point_name(file_, name.of);
  case Meaning::closing: return "closing of " + actuator_name(name.of);
  case Meaning::friction: break;
  }
  const Body<double>& body = assembly_.scene().bodies[layout().body[name.of]];
  const Generator<double> d = generator(body, name.generator, file_.facets);
  return "friction of " + point_name(file_, name.of) + generator_text(d, body.torsion_radius);
}

std::string generator_text(const Generator<double>& generator, double torsion_radius) {
  const auto rounded = [](double x) { return shown(std::round(x * 1000) / 1000 + 0.0); };
  const double slide = generator.force.norm();
  std::string text;
  if (slide > 0) text = " along " + direction_text(generator.force / slide);
  if (generator.torque == 0) return text;
  if (slide > 0) text += " times " + rounded(slide) + " and";
  return text + " twisting by " + rounded(generator.torque / torsion_radius);
}

std::string Push::actuator_name(Index actuator) const {
  if (file_.pressure != Pressure::even)
    return file_.actuator_names[static_cast<std::size_t>(actuator)];
  const Drive<double>& drive = scene_.drives[actuator];
  return point_name(file_, scene_.bodies[drive.body].first_point);
}

Push::Push(const SceneFile& file)
    : file_(file), even_(file.view()), scene_(even_.scene),
      bytes_(static_cast<std::size_t>(sweep_bytes<double>(size_of(scene_)))),
      work_(make_sweep_workspace<double>({bytes_.data(), static_cast<Index>(bytes_.size())},
                                         size_of(scene_))),
      assembly_(work_.assembly), sweeps_(work_.sweep_scalars, work_.sweep_integers) {
  assembly_.assemble(scene_);
}

/// The pivots' dictionary is large: only who pivots pays for it.
Lemke<double>& Push::pivots() {
  if (pivot_scalars_.empty()) {
    const Index n = size_of(scene_).unknowns();
    pivot_scalars_.resize(static_cast<std::size_t>(lemke_scalars(n)));
    pivot_integers_.resize(static_cast<std::size_t>(lemke_integers(n)));
    lemke_ = Lemke<double>({pivot_scalars_.data(), static_cast<Index>(pivot_scalars_.size())},
                           {pivot_integers_.data(), static_cast<Index>(pivot_integers_.size())});
  }
  return lemke_;
}

/// From this many unknowns on the structured basis is the faster one (docs/theory/numerics.md).
bool Push::takes_structure(const PushOptions& options) const {
  constexpr Index smallest = 200;
  return !options.dense && layout().size >= smallest &&
         StructuredBasis<double>::supports(assembly_.problem(), options.lemke.tie_rule);
}

/// Sized for the largest problem so far: the scene is also solved without its pushers.
StructuredLemke<double>& Push::structured_pivots() {
  const Index n = layout().size, points = layout().points;
  const Index shared = shared_actuators(assembly_.factored());
  const auto scalars = static_cast<std::size_t>(structured_lemke_scalars(n, points, shared));
  const auto integers = static_cast<std::size_t>(structured_lemke_integers(n, points));
  if (structured_scalars_.size() < scalars || structured_integers_.size() < integers) {
    structured_scalars_.resize(scalars);
    structured_integers_.resize(integers);
    // Assigning would copy through its views of the old memory.
    new (&structured_) StructuredLemke<double>(
        {structured_scalars_.data(), static_cast<Index>(structured_scalars_.size())},
        {structured_integers_.data(), static_cast<Index>(structured_integers_.size())});
  }
  return structured_;
}

void Push::record(Index sweep, const double* z) {
  const bool new_round = !history_.empty() && swept_before_ + sweep < history_.back().sweep;
  if (new_round) swept_before_ = history_.back().sweep;
  read_answer(assembly_, z, work_.answer, assembly_.sigma());
  history_.push_back({swept_before_ + sweep,
                      check(assembly_.scene(), layout().scales, work_.answer, assembly_.sigma())});
}

Status Push::run(const PushOptions& options, double sigma, PressureRun& spent) {
  const PressureOptions<double> pressure = pressure_options(scene_, layout().scales, sigma);
  assembly_.push_by(sigma);
  const Status status = with_rounds(options, [&](const auto& rounds) {
    return solve_pressure(assembly_, rounds, work_.pressure, pressure, spent);
  });
  if (status != Status::solved) return status;
  read_answer(assembly_, work_.pressure.z.data, work_.answer, sigma);
  // Sweeps stop at a residual that large forces make look small: the laws may ask for more.
  const bool can_improve = options.solver == Solver::gauss_seidel &&
                           options.sweeps.tolerance > 64 * Eigen::NumTraits<double>::epsilon();
  const double worst = check(assembly_.scene(), layout().scales, work_.answer, sigma).max();
  if (!can_improve || worst <= Tolerances<double>().residual) return status;
  PushOptions stricter = options;
  stricter.sweeps.tolerance /= 100;
  PressureRun again;
  const Status improved = run(stricter, sigma, again);
  spent.sweeps += again.sweeps;
  return improved;
}

/// Points speak of the file's bodies, even where each is a body of its own.
void Push::name_file_bodies() {
  Index body = 0;
  for (Index i = 0; i < work_.answer.contacts.size; ++i) {
    while (i >= file_.bodies[static_cast<std::size_t>(body)].first_point +
                    file_.bodies[static_cast<std::size_t>(body)].point_count)
      ++body;
    work_.answer.contacts[i].body = body;
  }
}

std::string Push::explain(Status status, const PressureRun& run) const {
  bool squeezes = false;
  for (Index i = 0; status == Status::ray && i < layout().points; ++i)
    squeezes = squeezes || ray()[layout().normal(i)] > ray_noise;
  switch (status) {
  case Status::ray:
    return squeezes ? "a ray: forces that squeeze the object and that nothing relieves"
                    : "a ray that presses no contact: an actuator that nothing holds back, or an "
                      "object whose mass, size and contacts do not fit together";
  case Status::pivot_limit: return "the limit of pivots was reached";
  case Status::sweep_limit:
    return "the limit of sweeps was reached; --solver hybrid goes on with pivots";
  case Status::stagnated:
    return sweeps_.runs_away()
               ? "the forces of the sweeps grow without bound, as in a jam; --solver "
                 "lemke ends in the ray that names it"
               : "the sweeps make no more progress; --solver hybrid goes on with "
                 "pivots";
  case Status::numerical_breakdown:
    if (run.reason == Reason::none)
      return "the pad rounds did not converge, though the rigid problem is solvable; try "
             "pressure = \"rigid\"";
    break;
  default: break;
  }
  return reason_text(run.reason);
}

/// Trying what would free a jam costs a solve each: not where solves are long.
Jam Push::read_jam(const PushOptions& options) const {
  constexpr Index largest_tried = 1000; // unknowns
  return explain_jam(file_, assembly_, ray(),
                     options.explain_jams && layout().size <= largest_tried);
}

std::vector<NamedValue> Push::named_ray() const {
  std::vector<NamedValue> named;
  for (Index i = 0; i < layout().size; ++i)
    if (ray()[i] > ray_noise) named.push_back({variable_name(i), ray()[i], i});
  return named;
}

/// The object's acceleration and the total wrench of all pushers.
Outcome<double> Push::outcome() const {
  Outcome<double> outcome{work_.answer.acceleration, Vector6<double>::Zero()};
  for (Index b = 0; b < scene_.bodies.size; ++b)
    if (scene_.bodies[b].role == Role::pusher)
      outcome.wrench += body_wrench(scene_, work_.answer, scene_.bodies[b]);
  return outcome;
}

/// What the tests together say: a proof, an answer next to this one, or other covers' answers.
void Push::conclude(PushReport& report, bool proved, bool same_motion, bool same_wrench) {
  const bool searched = report.covers_compared > 0 || report.final_basis.studied;
  const auto verdict = [&](bool none_other) {
    if (!none_other) return Uniqueness::no;
    return searched ? Uniqueness::none_other_found : Uniqueness::not_tested;
  };
  report.unique_motion =
      proved ? Uniqueness::yes : verdict(same_motion && !report.final_basis.motion_open);
  report.unique_wrench = verdict(same_wrench && !report.final_basis.wrench_open);
}

void Push::search_others(const PushOptions& options, PushReport& report) {
  constexpr double tolerance = 1e-5;
  const Index open = undetermined_body(scene_);
  const bool proved = open < 0;
  if (!proved)
    report.undetermined =
        file_.body_names[static_cast<std::size_t>(file_.body_of(scene_.bodies[open].first_point))];
  constexpr Index largest_searched = 2000; // unknowns; beyond, a search costs minutes
  bool same_a = true, same_f = true;
  const Outcome<double> first = outcome();
  report.final_basis = study_final_basis(assembly_, work_.answer);
  PushOptions other = options;
  other.solver = Solver::lemke; // covers are its own; after sweeps they are a second opinion too
  other.record_history = false;
  other.watcher = nullptr;
  for (Index k = 1; k <= options.other_covers && layout().size <= largest_searched; ++k) {
    other.lemke.first_cover = options.lemke.first_cover + k * options.lemke.covers;
    PressureRun ignored;
    if (run(other, 1.0, ignored) != Status::solved) continue;
    ++report.covers_compared;
    const Outcome<double> second = outcome();
    same_a = same_a && same_motion(first, second, report.scales, push_size(scene_), tolerance);
    same_f = same_f && same_wrench(first, second, report.scales, tolerance);
  }
  conclude(report, proved, same_a, same_f);
}

PushReport Push::solve(const PushOptions& options) {
  PushReport report;
  report.solver = options.solver;
  assembly_.assemble(scene_);
  report.scales = layout().scales;
  if (options.study_existence) report.existence = find_existence(file_, assembly_);
  history_.clear();
  swept_before_ = 0;
  report.status = run(options, 1.0, report.run);
  report.history = history_;
  if (report.status == Status::solved) {
    const std::vector<double> z(work_.pressure.z.begin(), work_.pressure.z.end());
    search_others(options, report);
    read_answer(assembly_, z.data(), work_.answer, 1.0); // the search has overwritten it
  }
  if (report.status != Status::solved) {
    report.reason = explain(report.status, report.run);
    if (report.status == Status::ray) {
      report.ray = named_ray();
      report.jam = read_jam(options);
    }
    return report;
  }
  report.answer = work_.answer;
  report.residuals = check(scene_, report.scales, report.answer, 1.0);
  const double push = push_size(scene_);
  name_file_bodies();
  report.motion = describe_motion(file_.view(), report.answer, report.scales.length,
                                  push > 0 ? push : report.scales.acceleration);
  // The solver has checked its own equations; this is the laws' own word, in SI units.
  if (!(report.residuals.max() <= Tolerances<double>().residual)) {
    report.status = Status::numerical_breakdown;
    report.reason = reason_text(Reason::residual);
  }
  // What the push does must stand out from what rounding does.
  constexpr double smallest_part = 1e-5;
  const double relative_push = push / report.scales.acceleration;
  if (relative_push > 0 && !(report.residuals.max() <= smallest_part * relative_push)) {
    report.status = Status::numerical_breakdown;
    report.reason = "the push, " + shown(push) + " m/s^2, is too slow beside the grip (" +
                    shown(report.scales.force) + " N on " + shown(scene_.object.mass) +
                    " kg) to be told from rounding; lcpush break gives the limit of slow pushes";
  }
  return report;
}

} // namespace lcpush::desktop
