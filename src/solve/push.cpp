#include <utility>

#include "lcpush/desktop/smallest_grip.hpp"
#include "solve/grip_statics.hpp"
#include "solve/less_friction.hpp"
#include "solve/noise.hpp"
#include "solve/push_rounds.hpp"
#include "solve/push_words.hpp"
#include "solve/rest_verdict.hpp"
#include "solve/word_settings.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {

template struct EvenSceneOf<double>;

std::string Push::variable_name(Index i) const {
  const Name name = name_of(layout(), i);
  switch (name.meaning) {
  case Meaning::normal: return "normal of " + point_name(file_, name.of);
  case Meaning::pull: return "pull of " + point_name(file_, name.of);
  case Meaning::slip: return "slip of " + point_name(file_, name.of);
  case Meaning::closing: return "closing of " + actuator_name(name.of);
  case Meaning::friction: break;
  }
  return "friction of " + point_name(file_, name.of) + along(name, 1);
}

std::string Push::row_name(Index i) const {
  const Name name = name_of(layout(), i);
  switch (name.meaning) {
  case Meaning::normal: return "separation of " + point_name(file_, name.of);
  case Meaning::pull: return "approach of " + point_name(file_, name.of);
  case Meaning::slip: return "friction left unused in the cone of " + point_name(file_, name.of);
  case Meaning::closing: return "force of " + actuator_name(name.of) + " beyond its set force";
  case Meaning::friction: break;
  }
  return "slip of " + point_name(file_, name.of) + " minus the motion" + along(name, -1);
}

std::string Push::along(const Name& name, double sign) const {
  const Body<double>& body = scene_.bodies[layout().body[name.of]];
  const Generator<double> d = generator(scene_, body, name.of, name.generator);
  return generator_text({sign * d.force, sign * d.torque}, body.torsion_radius);
}

std::string Push::actuator_name(Index actuator) const {
  if (file_.pressure != Pressure::even)
    return file_.actuator_names[static_cast<std::size_t>(actuator)];
  const Drive<double>& drive = scene_.drives[actuator];
  return point_name(file_, scene_.bodies[drive.body].first_point);
}

Push::Push(const SceneFile& file)
    : file_(file), assembled_(file.view(), file.is_round),
      sweeps_(work_.sweep_scalars, work_.sweep_integers) {}

/// The pivots' dictionary is large: only who pivots pays for it.
Lemke<double>& Push::pivots() {
  if (!lemke_) lemke_.emplace(size_of(scene_).unknowns());
  return *lemke_;
}

bool Push::takes_structure(const PushOptions& options) const {
  return !options.dense && layout().size >= SolveSettings().structured &&
         StructuredBasis<double>::supports(assembly_.problem(), options.lemke.tie_rule);
}

/// Sized for the largest problem so far: the scene is also solved without its pushers.
StructuredLemke<double>& Push::structured_pivots() {
  const Index n = layout().size, points = layout().points;
  const Index shared = shared_actuators(assembly_.factored());
  return with_room(structured_, structured_lemke_scalars(n, points, shared),
                   structured_lemke_integers(n, points));
}

void Push::linearize_cones(const std::vector<Vector3<double>>& forces) {
  for (Index i = 0; i < scene_.round_cones.size; ++i) {
    work_.round_cones[i] = {};
    const Vector3<double>& f = forces[static_cast<std::size_t>(i)];
    if (f.norm() > 0 && has_round_friction(scene_, scene_.bodies[layout().body[i]]))
      work_.round_cones[i].along = f.normalized();
  }
  assembly_.assemble(scene_);
}

void Push::record(Index sweep, const double* z) {
  const bool new_round = !history_.empty() && swept_before_ + sweep < history_.back().sweep;
  if (new_round) swept_before_ = history_.back().sweep;
  read_answer(assembly_, z, work_.answer, assembly_.sigma());
  history_.push_back({swept_before_ + sweep,
                      check(assembly_.scene(), layout().scales, work_.answer, assembly_.sigma())});
}

/// m/s^2: the push, or where a load or a pressing pusher moves the object as well, that; 0: without
/// a push nothing has to stand out.
double Push::fastest_motion(double sigma) const {
  const double push = sigma * push_size(scene_);
  return push > 0 ? std::max(push, work_.answer.acceleration.head<3>().norm()) : 0;
}

Status Push::run(const PushOptions& options, double sigma, PressureRun& spent, double part) {
  PressureOptions<double> pressure = pressure_options(assembly_, sigma);
  pressure.tolerance *= part;
  assembly_.push_by(sigma);
  pressure.max_pivots = options.max_pivots;
  const Status status = with_rounds(options, [&](const AnyRounds& rounds) {
    return solve_pressure(assembly_, rounds, work_.pressure, pressure, spent,
                          work_.friction_memory(scene_));
  });
  const bool can_start_anew =
      options.solver == Solver::lemke && options.lemke.first_cover < 2 * options.lemke.covers;
  // Sweeps stop at a residual that large forces make look small: laws and slips may ask for more.
  const bool can_improve = options.solver == Solver::gauss_seidel &&
                           options.sweeps.tolerance > 64 * Eigen::NumTraits<double>::epsilon();
  if (status != Status::solved && !(can_improve && status == Status::not_settled)) return status;
  if (status == Status::solved) {
    read_answer(assembly_, work_.pressure.z.data, work_.answer, sigma);
    const Residuals<double> left = check(assembly_.scene(), layout().scales, work_.answer, sigma);
    const bool passes = left.max() <= Tolerances<double>().residual &&
                        !is_too_slow(fastest_motion(sigma), layout().scales, left.beside);
    if (passes || !(can_start_anew || can_improve)) return status;
  }
  // By other covers, or on the whole dictionary: pivots have ended on a poor basis.
  PushOptions stricter = options;
  stricter.sweeps.tolerance /= SolveSettings().stricter;
  stricter.dense = last_structured_ && layout().size <= limits::unknowns_dense;
  if (!stricter.dense) stricter.lemke.first_cover += options.lemke.covers;
  const Index sweeps = spent.sweeps;
  const Status improved = run(stricter, sigma, spent, part);
  spent.sweeps += sweeps;
  return improved;
}

/// Points speak of the file's bodies, even where each is a body of its own.
void Push::name_file_bodies() {
  for (Index i = 0; i < work_.answer.contacts.size; ++i)
    work_.answer.contacts[i].body = file_.body_of(i);
}

std::string Push::explain(Status status, const PressureRun& run) const {
  bool squeezes = false;
  for (Index i = 0; status == Status::ray && i < layout().points; ++i)
    squeezes = squeezes || ray()[layout().normal_index(i)] > SolveSettings().ray_noise;
  switch (status) {
  case Status::ray:
    return squeezes
               ? "forces squeeze the object, and nothing relieves them (a secondary ray)"
               : "nothing holds an actuator back, or the object's mass, size and contacts do not "
                 "fit together (a secondary ray that presses no contact)";
  case Status::pivot_limit: return "the limit of pivots was reached";
  case Status::sweep_limit:
    return "the limit of sweeps was reached; --solver hybrid goes on with pivots";
  case Status::stagnated:
    return sweeps_.runs_away()
               ? "the forces of the sweeps grow without bound, as in a jam; --solver lemke ends in "
                 "the ray that names it"
               : "the sweeps make no more progress; --solver hybrid goes on with pivots";
  case Status::numerical_breakdown:
    if (run.reason == Reason::none && file_.hand == Hand::locked)
      return "from their preload the locked fingers press ever harder, round by round: most often "
             "they wedge the object";
    if (run.reason == Reason::none || run.reason == Reason::unsettled)
      return "the pad rounds did not converge, though the rigid problem is solvable; try pressure "
             "= \"rigid\"";
    break;
  case Status::not_settled:
    return "friction did not become round: the slip of " + point_name(file_, run.worst_point) +
           " turns from round to round; take a number of facets instead, 32 for example";
  default: break;
  }
  return reason_text(run.reason);
}

/// A ray where a theorem promises an answer is none: rounding has hidden the answer.
void Push::find_reason(RunReport& report) const {
  report.reason = explain(report.status, report.run);
  if (report.status != Status::ray) return;
  if (find_existence(file_, assembly_).verdict != Existence::proved) return;
  report.status = Status::numerical_breakdown;
  report.reason = "an answer exists, whatever the loads (theory 5.3), but was lost to rounding: "
                  "contacts so near to each other, or so alike, take forces far beyond the push";
}

/// Names the ray and reads the jam. Trying what would free one costs a solve each: not where solves
/// are long.
void Push::read_ray(const PushOptions& options, RunReport& report) const {
  for (Index i = 0; i < layout().size; ++i)
    if (ray()[i] > SolveSettings().ray_noise) report.ray.push_back({variable_name(i), ray()[i], i});
  const bool tries = options.explain_jams && layout().size <= limits::unknowns_remedied;
  report.jam = explain_jam(file_, assembly_, ray(), tries ? has_answer : nullptr);
}

/// The object's acceleration and the total wrench of all pushers.
Outcome<double> Push::outcome() const {
  Outcome<double> outcome{work_.answer.acceleration, Vector6<double>::Zero()};
  for (Index b = 0; b < scene_.bodies.size; ++b)
    if (scene_.bodies[b].role == Role::pusher)
      outcome.wrench += body_wrench(scene_, work_.answer, scene_.bodies[b]);
  // Nothing in a plane says how an edge across it shares its force along z.
  stay_in_plane(scene_, outcome.wrench);
  return outcome;
}

/// How fast the driven bodies close, over `unit`; under even pressure the mean of a body's points.
std::vector<NamedValue> Push::closings(double unit) const {
  std::vector<NamedValue> list;
  const Scene<double> scene = file_.view();
  for (Index b = 0; b < scene.bodies.size; ++b)
    if (is_driven(scene, b))
      list.push_back({file_.body_name(b), mean_closing(work_.answer, scene.bodies[b]) / unit});
  return list;
}

/// Of the present answer's scene, with less friction where it sticks; at rest all do.
std::optional<Outcome<double>> Push::answer_by_less_friction(const PushOptions& options) const {
  for (const double part : SolveSettings().less_friction) {
    const auto less = with_less_friction(file_, work_.answer, part, layout().scales);
    if (!less || is_late(options)) break;
    Push push(less->file);
    push.assembled_.assemble(file_.is_round && has_round_friction(scene_));
    PressureRun ignored;
    if (push.run(search_options(options, layout().size), 1.0, ignored) != Status::solved) continue;
    Outcome<double> found = push.outcome();
    const double noise = rest_noise(file_, layout().scales, options.solver);
    const bool rests =
        !(push_size(scene_) > 0) && motion_size(found.acceleration, layout().scales) <= noise;
    if (rests) found.acceleration.setZero();
    if (!rests && !less->sticks(push.work_.answer)) continue;
    const Residuals<double> left = check(scene_, layout().scales, push.work_.answer, 1.0);
    if (left.max() <= Tolerances<double>().residual) return found;
  }
  return std::nullopt;
}

bool is_late(const PushOptions& options) {
  return stop_now(options.stop, SolveSettings().search_time) != Stop::none;
}

Index paths_to_search(const PushOptions& options, bool is_round) {
  return options.other_paths + (is_round && options.other_paths > 1 ? 1 : 0);
}

PushOptions search_options(const PushOptions& options, Index unknowns) {
  PushOptions search = options;
  search.solver = Solver::lemke;
  search.record_history = false;
  search.watcher = options.searching;
  search.max_pivots =
      std::max<Index>(1, limits::unknowns_pivoted_in_search / (unknowns * options.other_paths));
  // One covering vector that goes astray is not to use up the search.
  search.lemke.max_pivots = std::min(LemkeSettings::most_pivots(unknowns), search.max_pivots);
  return search;
}

OtherPath other_path(const SceneFile& file, const PushOptions& options, Index k, Index unknowns) {
  OtherPath other{std::nullopt, search_options(options, unknowns)};
  if (k <= options.other_paths) {
    other.options.lemke.first_cover += k * options.lemke.covers;
  } else {
    other.turned = file;
    for (Body<double>& body : other.turned->bodies) body.tangent = -body.tangent;
  }
  return other;
}

/// Who follows a path: `turned`, of the path's own scene, or this one.
Push& Push::on(const OtherPath& path, std::optional<Push>& turned) {
  if (!path.turned) return *this;
  turned.emplace(*path.turned).assembled_.assemble(true);
  return *turned;
}

void Push::search_others(const PushOptions& options, PushReport& report) {
  const double tolerance = SolveSettings().same;
  const Index open = undetermined_body(scene_);
  const bool proved = open < 0;
  if (!proved)
    report.undetermined = file_.body_name(file_.body_of(scene_.bodies[open].first_point));
  bool same_a = true, same_f = true;
  const Outcome<double> first = outcome();
  if (!has_round_friction(scene_)) report.final_basis = study_final_basis(assembly_, work_.answer);
  const bool affordable = layout().size <= limits::unknowns_searched;
  const auto compare = [&](const Outcome<double>& second) {
    const bool moves_alike =
        same_motion(first, second, report.scales, push_size(scene_), tolerance);
    const bool pushes_alike = same_wrench(first, second, report.scales, tolerance);
    if (!report.other && !(moves_alike && pushes_alike)) report.other = second;
    same_a = same_a && moves_alike;
    same_f = same_f && pushes_alike;
  };
  if (!proved && affordable && options.other_paths > 0)
    if (const auto other = answer_by_less_friction(options)) {
      compare(*other);
      report.is_friction_open = report.other.has_value();
    }
  const Index paths = paths_to_search(options, has_round_friction(scene_));
  for (Index k = 1; affordable && k <= paths; ++k) {
    if ((k > options.other_paths && report.other) || is_late(options)) break;
    PressureRun ignored;
    const OtherPath path = other_path(file_, options, k, layout().size);
    std::optional<Push> turned;
    Push& push = on(path, turned);
    if (push.run(path.options, 1.0, ignored) != Status::solved) continue;
    ++report.paths_compared;
    compare(push.outcome());
  }
  // A proof, an answer next to this one, or other paths' answers.
  const bool searched = report.paths_compared > 0 || report.final_basis.studied;
  const auto verdict = [&](bool none_other) {
    if (!none_other) return Uniqueness::no;
    return searched ? Uniqueness::none_other_found : Uniqueness::not_tested;
  };
  report.unique_motion =
      proved ? Uniqueness::yes : verdict(same_a && !report.final_basis.motion_open);
  report.unique_wrench = verdict(same_f && !report.final_basis.wrench_open);
}

/// Pivots begin without forces: an object between bodies that stand still falls. Where statics
/// finds forces that hold it, rest is an answer, too.
void Push::look_for_rest(PushReport& report) const {
  if (has_pusher(file_) || !file_.drives.empty() || report.motion.kind == MotionKind::rest) return;
  const std::optional<double> least = least_factor(GripStatics(file_));
  if (!least || *least > 0) return;
  report.unique_motion = Uniqueness::no;
  report.other = Outcome<double>{Vector6<double>::Zero(), Vector6<double>::Zero()};
}

/// The scene as the file has it, and nothing known about it.
void Push::begin(const PushOptions& options, RunReport& report) {
  assembled_.assemble(file_.is_round);
  report.friction = file_.is_round ? FrictionLaw::round : FrictionLaw::pyramids;
  report.solver = options.solver;
  report.scales = layout().scales;
  history_.clear();
  swept_before_ = 0;
}

/// Not settled is no verdict: pyramids have an answer where round friction finds none.
Status Push::with_friction(RunReport& report, const std::function<Status()>& run_once) {
  const Status status = run_once();
  const bool is_lost = status == Status::not_settled || status == Status::numerical_breakdown;
  if (!is_lost || !file_.is_round) return status;
  const PressureRun spent = report.run;
  report.run = {};
  assembled_.assemble(false);
  const Status instead = run_once();
  const bool is_jam = instead == Status::ray;
  if (instead == Status::solved || instead == Status::does_not_hold || is_jam) {
    report.friction = FrictionLaw::pyramids_instead;
    return instead;
  }
  report.run = spent;
  assembled_.assemble(true);
  return status;
}

/// Why an answer that the solver found fails the laws' check.
std::string Push::why_refused(const PushReport& report) const {
  const double passes = Tolerances<double>().residual;
  Violation<double> worst;
  bool beside = true;
  check_rows(scene_, report.scales, report.answer, 1.0, [&](const Violation<double>& row) {
    beside = beside && std::abs(row.scaled * row.unit) <= passes * row.common;
    if (!(std::abs(row.scaled) <= std::abs(worst.scaled))) worst = row;
  });
  if (!beside) return reason_text(Reason::residual);
  std::string text = reason_text(Reason::small_load) + std::string(": ");
  const Index lost = lost_actuator(file_, report.scales);
  const Index weak = lost >= 0 || worst.law != Law::grip ? lost : worst.of;
  if (weak >= 0)
    text += actuator_name(weak) + " holds " + shown(std::abs(scene_.actuators[weak].force)) + ", ";
  return text + "the largest force is " + shown(report.scales.force) + " N";
}

/// What was found is no answer.
static void refuse(PushReport& report, std::string reason) {
  report.status = Status::numerical_breakdown;
  report.reason = std::move(reason);
}

PushReport Push::solve(const PushOptions& options) & {
  PushReport report;
  begin(options, report);
  if (options.study_existence) report.existence = find_existence(file_, assembly_);
  report.status = with_friction(report, [&] { return run(options, 1.0, report.run); });
  report.history = history_;
  if (report.status != Status::solved) {
    find_reason(report);
    if (report.status == Status::ray) read_ray(options, report);
    return report;
  }
  const std::vector<double> z(work_.pressure.z.begin(), work_.pressure.z.end());
  const std::vector<LinearizedCone<double>> cones(work_.round_cones.begin(),
                                                  work_.round_cones.end());
  if (options.study_commands != nullptr)
    report.sensitivity = options.study_commands(file_, assembly_, work_);
  search_others(options, report);
  std::copy(cones.begin(), cones.end(), work_.round_cones.begin());
  assembly_.assemble(scene_);
  read_answer(assembly_, z.data(), work_.answer, 1.0); // the search has overwritten it
  report.answer = work_.answer;
  report.residuals = check(scene_, report.scales, report.answer, 1.0);
  const double push = push_size(scene_);
  name_file_bodies();
  find_noise(file_, report.answer, report);
  clear_noise(file_, report.scales, report.noise, report.answer);
  report.motion = describe_motion(file_.view(), report.answer, report.scales.length,
                                  report.noise.acceleration / word_settings.rounding, push);
  const double noise = rest_tolerance(options.solver) * report.scales.acceleration;
  if (report.unique_motion == Uniqueness::none_other_found) look_for_rest(report);
  report.hand_moves = any_moves(closings(std::max({push, report.motion.translation, noise})));
  // The solver has checked its own equations; this is the laws' own word, in SI units.
  if (!(report.residuals.max() <= Tolerances<double>().residual) ||
      lost_actuator(file_, report.scales) >= 0) {
    refuse(report, why_refused(report));
    report.unique_motion = report.unique_wrench = Uniqueness::not_tested; // of no answer
    report.final_basis = {};
    report.sensitivity.clear();
    report.other.reset();
  }
  const double load = lost_load(file_, report.scales, report.residuals.max());
  if (!(push > 0) && load > 0)
    refuse(report, reason_text(Reason::small_load) +
                       (": weight and applied forces are " + brief(load)) +
                       " N, the largest force is " + shown(report.scales.force) + " N");
  if (is_too_slow(fastest_motion(1.0), report.scales, report.residuals.beside))
    refuse(report,
           "the push, " + shown(push) + " m/s^2, is too slow beside the grip (" +
               shown(report.scales.force) + " N on " + shown(scene_.object.mass) +
               " kg) to be told from rounding; lcpush break gives the limit of slow pushes");
  return report;
}

bool has_answer(const SceneFile& file) {
  PushOptions options;
  options.other_paths = 0;
  options.explain_jams = false;
  options.study_existence = false;
  Push push(file);
  return push.solve(options).status == Status::solved;
}

} // namespace lcpush::desktop
