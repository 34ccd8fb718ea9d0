// The same pushes through the headers alone, every pivot watched: prints a hash over the variables
// that entered and left, in their order.
#include "lcpush/lcpush.hpp"
#include "lcpush/mechanics/model/contact.hpp"

#include "scenes.h"

using namespace lcpush;

namespace {

/// Hashes a run's path.
struct Path {
  std::uint32_t hash = HASH_START;

  template <class L> void starts(const L&) {}
  template <class L> Index choose_leaving_row(const L& lemke, const PendingPivot& pending) {
    hash = hash_bits(hash, static_cast<std::uint32_t>(pending.entering));
    hash =
        hash_bits(hash, static_cast<std::uint32_t>(lemke.dictionary().basic[pending.blocking.row]));
    return pending.blocking.row;
  }
  template <class L> void stepped(const L&) {}
  template <class Sweeps> void checked(const Sweeps&) {}
};

template <class S, int n> Eigen::Matrix<S, n, 1> vector(const S (&numbers)[n]) {
  return Eigen::Map<const Eigen::Matrix<S, n, 1>>(numbers);
}

/// A scene and its arrays.
template <class S> struct Copy {
  Body<S> bodies[3], even_bodies[10];
  Vector3<S> points[10];
  Actuator<S> actuators[2], even_actuators[8];
  Drive<S> drives[2], even_drives[8];
  Scene<S> scene, spread;

  template <class CScene> void take(const CScene& given, Pressure pressure) {
    scene.object.mass = given.object.mass;
    for (Index i = 0; i < 9; ++i) scene.object.inertia(i / 3, i % 3) = given.object.inertia[i];
    scene.object.center_of_mass.setZero();
    scene.gravity = vector(given.gravity);
    scene.facets = given.facets;
    scene.pressure = pressure;
    scene.planar = given.planar != 0;
    for (Index b = 0; b < given.body_count; ++b) {
      const auto& from = given.bodies[b];
      const Vector3<S> tangent = vector(from.tangent);
      Body<S>& body = bodies[b] = Body<S>();
      body.role = from.role == LCPUSH_PUSHER ? Role::pusher : Role::finger;
      body.normal = vector(from.normal);
      body.tangent = tangent.squaredNorm() > S(0) ? tangent : default_tangent(body.normal);
      body.friction = from.friction;
      body.torsion_radius = from.torsion_radius;
      body.first_point = from.first_point;
      body.point_count = from.point_count;
      body.acceleration = vector(from.acceleration);
      lie_in_plane(body, scene.planar);
    }
    for (Index i = 0; i < given.point_count; ++i)
      points[i] = {given.points[i].x, given.points[i].y, given.points[i].z};
    for (Index a = 0; a < given.actuator_count; ++a)
      actuators[a] = {given.actuators[a].force, given.actuators[a].inertia};
    for (Index d = 0; d < given.drive_count; ++d)
      drives[d] = {given.drives[d].body, given.drives[d].actuator, vector(given.drives[d].twist)};
    scene.bodies = {bodies, given.body_count};
    scene.points = {points, given.point_count};
    scene.actuators = {actuators, given.actuator_count};
    scene.drives = {drives, given.drive_count};
  }

  bool spread_it() {
    return spread_evenly(scene, {{even_bodies, 10}, {even_actuators, 8}, {even_drives, 8}},
                         spread) == Status::solved;
  }
};

// All there is: the largest of the scenes below, spread evenly.
constexpr AssemblySize largest{10, 80, 8, 64};
alignas(8) unsigned char memory[push_bytes<REAL>(largest)];
Copy<REAL> copy;

const LCPUSH(scene) * given;
Pressure pressure;
bool is_break;
struct Result {
  Status status;
  PressureRun run;
  REAL residual, force;
  std::uint32_t path;
} result;

/// From the scene to the checked answer.
void push() {
  result = {};
  result.status = Status::bad_input;
  copy.take(*given, pressure);
  if (!copy.spread_it()) return;
  const Scene<REAL>& scene = copy.spread;
  const Body<REAL>& pusher = scene.bodies[scene.bodies.size - 1];
  Workspace<REAL> work = make_workspace<REAL>({memory, sizeof memory}, size_of(scene));
  Assembly<REAL> assembly(work.assembly);
  if (!work.complete || assembly.assemble(scene) != Status::running) return;
  Lemke<REAL> lemke(work.lemke_scalars, work.lemke_integers);
  Path path;
  LemkeRounds<REAL, Path> rounds{lemke, {}, path};
  if (is_break) {
    Breaking<REAL> breaking;
    result.status = find_breaking(assembly, rounds, work, pusher, PressureOptions<REAL>(), breaking,
                                  result.run);
    result.residual = breaking.residuals.max();
    result.force = breaking.break_force;
  } else {
    result.status =
        solve_pressure(assembly, rounds, work.pressure, PressureOptions<REAL>(), result.run);
    read_answer(assembly, work.pressure.z.data, work.answer, REAL(1));
    result.residual = check(scene, assembly.layout().scales, work.answer, REAL(1)).max();
    result.force = normal_sum(work.answer, pusher);
  }
  result.path = path.hash;
}

Lemke<REAL>* running;
void step() { result.status = running->step(); }

/// Lemke's steps on the literal problem, one by one: what those that pivot take, and the last one,
/// which refines the answer and has it checked.
void report_steps(const char* name, const LCPUSH(scene) & scene) {
  copy.take(scene, Pressure::rigid);
  Workspace<REAL> work = make_workspace<REAL>({memory, sizeof memory}, size_of(copy.scene));
  Assembly<REAL> assembly(work.assembly);
  Lemke<REAL> lemke(work.lemke_scalars, work.lemke_integers);
  running = &lemke;
  cost most{0, 0}, last{0, 0};
  result.status = assembly.assemble(copy.scene);
  if (result.status == Status::running) result.status = lemke.init(assembly.problem());
  while (result.status == Status::running) {
    if (last.ticks > most.ticks) most.ticks = last.ticks;
    if (last.stack > most.stack) most.stack = last.stack;
    last = measure(step);
  }
  put("run ");
  put(name);
  put(" status ");
  put(status_text(result.status));
  put_number(" pivots ", static_cast<std::uint32_t>(lemke.pivots()));
  put_number(" ticks ", most.ticks);
  put_number(" stack ", most.stack);
  put_number(" last_ticks ", last.ticks);
  put_number(" last_stack ", last.stack);
  put("\n");
}

void report(const char* name, const LCPUSH(scene) & scene, Pressure law, bool breaks) {
  given = &scene;
  pressure = law;
  is_break = breaks;
  const cost costs = measure(push);
  put("run ");
  put(name);
  put(" status ");
  put(status_text(result.status));
  put_number(" pivots ", static_cast<std::uint32_t>(result.run.pivots));
  put_real(" residual ", result.residual);
  put_real(" force ", result.force);
  put_hex(" path ", result.path);
  put_number(" ticks ", costs.ticks);
  put_number(" stack ", costs.stack);
  put("\n");
}

} // namespace

int main() {
  report("squeeze.rigid.path", squeeze, Pressure::rigid, false);
  report("soft_fingers.pad.path", soft_fingers, Pressure::pad, false);
  report("straight_slide.rigid.path", straight_slide, Pressure::rigid, false);
  report("straight_slide.even.path", straight_slide, Pressure::even, false);
  report("straight_slide.pad.path", straight_slide, Pressure::pad, false);
  report("straight_slide.even.break_path", straight_slide, Pressure::even, true);
  report("straight_slide.pad.break_path", straight_slide, Pressure::pad, true);
  report("rolling.pad.path", rolling, Pressure::pad, false);
  report_steps("squeeze.lemke", squeeze);
  report_steps("soft_fingers.lemke", soft_fingers);
  report_steps("straight_slide.lemke", straight_slide);
  put_number("memory ", sizeof memory);
  put("\nend\n");
  return 0;
}
