// The C interface: lcpush.h on top of the templates, once a precision.
#include "lcpush/lcpush.h"

#include "c_pivot_push.hpp"
#include "c_sweep_push.hpp"

#include <cstring>
#include <limits>

namespace lcpush::c {
namespace {

// The enumerations of lcpush.h count as ours do.
static_assert(static_cast<int>(Status::bad_input) == LCPUSH_BAD_INPUT, "");
static_assert(static_cast<int>(Status::ray) == LCPUSH_RAY, "");
static_assert(static_cast<int>(Mistake::weights) == LCPUSH_BAD_WEIGHTS, "");
static_assert(static_cast<int>(Mistake::index) == LCPUSH_BAD_INDEX, "");
static_assert(static_cast<int>(Mode::separate) == LCPUSH_SEPARATE, "");
static_assert(static_cast<int>(Pressure::rigid) == LCPUSH_RIGID, "");
static_assert(static_cast<int>(Role::pusher) == LCPUSH_PUSHER, "");

// The bounds of lcpush/c/bytes.h hold here: for a push, and for what its arena gives out.
template <class S, class Push>
constexpr bool covers(std::size_t bytes, Index bodies, const AssemblySize& size, Index work) {
  constexpr Index alignment_slack = 3 * widest_alignment<S>();
  const Index structs = bodies * static_cast<Index>(sizeof(Body<S>)) +
                        size.points * static_cast<Index>(sizeof(Vector3<S>) + sizeof(S)) +
                        size.actuators * static_cast<Index>(sizeof(Actuator<S>)) +
                        size.drives * static_cast<Index>(sizeof(Drive<S>)) + size.unknowns() +
                        size.points * static_cast<Index>(sizeof(ContactAnswer<S>)) +
                        (size.generators + size.actuators) * static_cast<Index>(sizeof(S));
  return sizeof(Push) + sizeof(Scene<S>) <= LCPUSH_STATE_BYTES_(S) &&
         sizeof(Body<S>) <= LCPUSH_BODY_BYTES_(S) && sizeof(Drive<S>) <= LCPUSH_DRIVE_BYTES_(S) &&
         static_cast<Index>(bytes) >=
             static_cast<Index>(sizeof(Push) + sizeof(Scene<S>)) + structs + work + alignment_slack;
}

lcpush_status as_c(Status status) { return static_cast<lcpush_status>(status); }

template <class S, class Vector> void read(const S* numbers, Vector& vector) {
  std::memcpy(vector.data(), numbers, sizeof(S) * static_cast<std::size_t>(vector.size()));
}
template <class S, int n> void write(const Eigen::Matrix<S, n, 1>& vector, S* out) {
  for (Index i = 0; i < n; ++i) out[i] = vector[i];
}

template <class S, class CBody> void read_body(const CBody& given, bool is_planar, Body<S>& body) {
  body.role = given.role == LCPUSH_PUSHER ? Role::pusher : Role::finger;
  // A zero normal stays zero, and find_mistake says so.
  read(given.normal, body.normal);
  body.normal.normalize();
  read(given.tangent, body.tangent);
  if (body.tangent == Vector3<S>::Zero()) body.tangent[least_aligned_axis(body.normal)] = S(1);
  body.tangent = tangent_along(body.normal, body.tangent);
  body.friction = given.friction;
  body.torsion_radius = given.torsion_radius;
  body.bilateral = given.bilateral != 0;
  body.first_point = given.first_point;
  body.point_count = given.point_count;
  read(given.acceleration, body.acceleration);
  body.preload = given.preload;
  lie_in_plane(body, is_planar);
}

/// As shares of their body's sum, which find_mistake judges. Pre: the bodies lie within the points.
template <class S> void normalise(const Span<const Body<S>>& bodies, const Span<S>& weights) {
  for (const Body<S>& body : bodies) {
    S sum(0);
    for (Index i = 0; i < body.point_count; ++i) sum += weights[body.first_point + i];
    for (Index i = 0; i < body.point_count; ++i) weights[body.first_point + i] /= sum;
  }
}

/// Can so many of each be counted in bytes, on 32 bits too? Every force takes a byte or more by
/// every drive, and all together a few hundred each.
inline bool is_countable(const Capacity& most, std::size_t bytes) {
  constexpr Index most_of_one = 8191;
  for (const Index count :
       {most.bodies, most.points, most.facets, most.actuators, most.drives, most.pulls})
    if (count < 0 || count > most_of_one) return false;
  const std::size_t end = std::numeric_limits<Index>::max() / 512;
  const Index forces = (most.points + most.pulls) * (most.facets + 1);
  return static_cast<std::size_t>(forces) <=
         (bytes < end ? bytes : end) / static_cast<std::size_t>(most.drives + 1);
}

/// A push in the caller's memory; null if that is too short.
template <class Push> Push* make(void* memory, std::size_t bytes, const lcpush_size* size) {
  if (memory == nullptr || size == nullptr) return nullptr;
  const Capacity most{size->bodies,    size->points, size->facets,
                      size->actuators, size->drives, size->pulls};
  if (!is_countable(most, bytes)) return nullptr;
  Arena arena(static_cast<unsigned char*>(memory), static_cast<Index>(bytes));
  void* const place = arena.take_bytes(static_cast<Index>(sizeof(Push)), alignof(Push));
  if (place == nullptr) return nullptr;
  Push* const push = new (place) Push(arena, most);
  return push->complete() ? push : nullptr;
}

/// The scene over the push's own arrays; nothing is allocated.
template <class S, class CScene> Status describe(CPush<S>& push, const CScene& given) {
  if (!push.holds(given.body_count, given.point_count, given.actuator_count, given.drive_count))
    return push.refuse(Mistake::memory_too_small);
  const bool is_round = given.facets == LCPUSH_ROUND;
  bool is_known = given.pressure >= LCPUSH_PAD && given.pressure <= LCPUSH_RIGID;
  const Span<Body<S>> bodies = push.new_bodies(given.body_count);
  const Span<Vector3<S>> points = push.new_points(given.point_count);
  const Span<Actuator<S>> actuators = push.new_actuators(given.actuator_count);
  const Span<Drive<S>> drives = push.new_drives(given.drive_count);
  for (Index b = 0; b < bodies.size; ++b) {
    const auto& body = given.bodies[b];
    is_known &= body.role == LCPUSH_FINGER || body.role == LCPUSH_PUSHER;
    read_body(body, given.planar != 0, bodies[b]);
  }
  if (!is_known) return push.refuse(Mistake::unsupported);
  for (Index i = 0; i < points.size; ++i) read(&given.points[i].x, points[i]);
  for (Index a = 0; a < actuators.size; ++a)
    actuators[a] = {given.actuators[a].force, given.actuators[a].inertia};
  for (Index d = 0; d < drives.size; ++d) {
    drives[d].body = given.drives[d].body;
    drives[d].actuator = given.drives[d].actuator;
    read(given.drives[d].twist, drives[d].twist);
  }

  Scene<S>& scene = *push.new_scene();
  scene.object.mass = given.object.mass;
  read(given.object.inertia, scene.object.inertia); // symmetric
  read(given.object.wrench, scene.object.wrench);
  scene.object.center_of_mass.setZero();
  scene.object.turning.setZero();
  read(given.gravity, scene.gravity);
  scene.facets = is_round ? -given.facets : given.facets;
  scene.pressure = static_cast<Pressure>(given.pressure);
  scene.planar = given.planar != 0;
  scene.bodies = {bodies.data, bodies.size};
  scene.points = {points.data, points.size};
  scene.actuators = {actuators.data, actuators.size};
  scene.drives = {drives.data, drives.size};
  scene.weights = {};
  scene.clearances = {};
  scene.round_cones = {};
  if (given.weights == nullptr || find_mistake(scene) != Mistake::none)
    return push.accept(is_round);
  // The bodies' points lie where they should.
  const Span<S> weights = push.new_weights(given.point_count);
  for (Index i = 0; i < weights.size; ++i) weights[i] = given.weights[i];
  normalise(scene.bodies, weights);
  scene.weights = {weights.data, weights.size};
  return push.accept(is_round);
}

template <class S> Status command(CPush<S>& push, const S* forces, const S* accelerations) {
  push.begin_command();
  const Mistake mistake = push.mistake_of(forces, accelerations);
  if (mistake != Mistake::none) return push.refuse(mistake);
  bool changes = false;
  const auto take = [&](S& number, const S& commanded) {
    changes |= number != commanded;
    number = commanded;
  };
  for (Index a = 0; forces != nullptr && a < push.given().actuators.size; ++a)
    take(push.force(a), forces[a]);
  const bool grips_anew = changes;
  changes |= !push.is_under_way();
  for (Index i = 0; accelerations != nullptr && i < 6 * push.given().bodies.size; ++i)
    take(push.acceleration(i / 6)[i % 6], accelerations[i]);
  return changes ? push.take_command(grips_anew) : Status::running;
}

/// The body of the scene as it was described: under even pressure every point is a body of its own.
template <class S> Index described_body(const CPush<S>& push, Index point) {
  const Span<const Body<S>>& bodies = push.given().bodies;
  Index b = 0;
  while (b < bodies.size && point >= bodies[b].first_point + bodies[b].point_count) ++b;
  return b;
}

template <class S> Vector6<S> wrench_of(const CPush<S>& push, Index body) {
  if (!push.has_answer() || body < 0 || body >= push.given().bodies.size) return Vector6<S>::Zero();
  return body_wrench(push.scene(), push.answer(), push.given().bodies[body]);
}

/// The mean over an actuator's shares.
template <class S> S closing_of(const CPush<S>& push, Index actuator) {
  const typename CPush<S>::Given& given = push.given();
  if (!push.has_answer() || actuator < 0 || actuator >= given.actuators.size) return S(0);
  if (!push.is_spread()) return push.answer().closing[actuator];
  S sum(0);
  Index shares = 0, share = 0;
  for (Index b = 0; b < given.bodies.size; ++b)
    for (Index i = 0; i < given.bodies[b].point_count; ++i)
      for (const Drive<S>& drive : given.drives) {
        if (drive.body != b) continue;
        if (drive.actuator == actuator) {
          sum += push.answer().closing[share];
          ++shares;
        }
        ++share;
      }
  return shares > 0 ? S(sum / S(shares)) : S(0);
}

/// `ask(hand)` of the fingers at rest.
template <class Push, class CHeld, class Question>
lcpush_status hold(Push& push, CHeld& out, const Question& ask) {
  const Held<typename Push::Scalar> held = push.hold(ask);
  out.value = held.value;
  write(held.twist, out.twist);
  out.exchanges = static_cast<int>(held.exchanges);
  return as_c(held.status);
}

} // namespace
} // namespace lcpush::c

const char* lcpush_status_text(lcpush_status status) {
  return lcpush::status_text(static_cast<lcpush::Status>(status));
}
const char* lcpush_mistake_text(lcpush_mistake mistake) {
  return lcpush::mistake_text(static_cast<lcpush::Mistake>(mistake));
}
const char* lcpush_mode_text(lcpush_mode mode) {
  if (mode < LCPUSH_STICK || mode > LCPUSH_SEPARATE) return "unknown";
  return lcpush::mode_text(static_cast<lcpush::Mode>(mode));
}

#define LCPUSH_REAL double
#define LCPUSH_NAME(name) lcpush_##name
#include "c_functions.hpp"
#include "c_hold_functions.hpp"
#include "c_motion_functions.hpp"
#undef LCPUSH_REAL
#undef LCPUSH_NAME

#define LCPUSH_REAL float
#define LCPUSH_NAME(name) lcpushf_##name
#include "c_functions.hpp"
#include "c_hold_functions.hpp"
#include "c_motion_functions.hpp"

namespace lcpush::c {
namespace {

/// All sizes of a small grid: the bounds are polynomials, and their terms grow one by one.
template <class S, class Push> constexpr bool all_covered() {
  for (const Index b : {1, 3, 40})
    for (const Index p : {1, 2, 7, 40})
      for (const Index g : {4, 8, 42})
        for (const Index a : {0, 1, 9})
          for (const Index d : {0, 1, 2, 9}) {
            const AssemblySize size{p, p * g, a, d};
            if (!covers<S, CPivotPush<Push>>(
                    LCPUSH_BYTES(S, b, p, g, a, d), b, size,
                    small_bytes<S>(size, size.actuators, exchanges_of(size))) ||
                !covers<S, CSweepPush<Push>>(LCPUSH_SWEEP_BYTES(S, b, p, g, a, d), b, size,
                                             sweep_bytes<S>(size)))
              return false;
          }
  return true;
}
static_assert(all_covered<double, lcpush_push>(), "LCPUSH_BYTES is too small");
static_assert(all_covered<float, lcpushf_push>(), "LCPUSH_BYTES is too small");

} // namespace
} // namespace lcpush::c
