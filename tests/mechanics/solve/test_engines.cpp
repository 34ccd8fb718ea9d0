// Every engine on every kind of grasp under every law: what is called solved obeys the laws, and
// engines agree wherever the motion is one.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "support/engines.hpp"
#include "support/grasp_families.hpp"
#include "support/scenes.hpp"
#include "support/seeds.hpp"

using namespace lcpush;
using namespace lcpush::test;

namespace {

enum class Model { rigid, even, pad, round_rigid, round_even, round_pad };
constexpr const char* model_names[] = {"rigid",       "even",       "pad",
                                       "rigid round", "even round", "pad round"};

bool is_round(Model law) { return law >= Model::round_rigid; }

/// A kind of grasp under a law, and how many of a hundred have an answer that engines must find.
struct Kind {
  const char* name;
  OwnedScene<double> (*grasp)(std::uint64_t seed);
  Model law;
  int by_pivots = 100;
  int by_sweeps = 85; ///< Gauss-Seidel alone
  int agree = 90;     ///< with the dictionary's motion: some problems have several answers
};

template <Family family> OwnedScene<double> of(std::uint64_t seed) {
  return grasp_of<double>(family, seed);
}

constexpr int open = 0; // a rigid patch may share its force in many ways

// Wedges end pushes of two pushers and of stops; bilateral points may pull against each other
// without bound; locked fingers are covered by no theorem.
const Kind kinds[] = {
    {"plain", of<Family::plain>, Model::rigid, 100, 85, open},
    {"plain", of<Family::plain>, Model::pad},
    {"plain", of<Family::plain>, Model::round_rigid, 90, 85, open},
    {"plain", of<Family::plain>, Model::round_pad, 90, 85},
    {"planar", of<Family::planar>, Model::rigid, 100, 85, open},
    {"planar", of<Family::planar>, Model::pad},
    {"even", of<Family::even>, Model::even},
    {"even", of<Family::even>, Model::round_even, 90, 85},
    {"soft", of<Family::soft>, Model::rigid, 100, 85, open},
    {"soft", of<Family::soft>, Model::pad},
    {"soft", of<Family::soft>, Model::round_pad, 90, 85},
    {"parallel", of<Family::parallel>, Model::rigid, 100, 85, open},
    {"parallel", of<Family::parallel>, Model::pad},
    {"crooked drives", of<Family::jacobian>, Model::rigid, 100, 85, open},
    {"crooked drives", of<Family::jacobian>, Model::pad},
    {"weighted", of<Family::weighted>, Model::rigid, 100, 85, open},
    {"weighted", of<Family::weighted>, Model::pad},
    {"bilateral", of<Family::bilateral>, Model::rigid, 95, 95, open},
    {"bilateral", of<Family::bilateral>, Model::pad, 95},
    {"two pushers", of<Family::two_pushers>, Model::rigid, 95, 90, open},
    {"two pushers", of<Family::two_pushers>, Model::pad, 95, 90},
    {"stop", of<Family::stop>, Model::rigid, 95, 90, open},
    {"stop", of<Family::stop>, Model::pad, 95, 90},
    {"locked", of<Family::locked>, Model::pad, 95, 90},
    {"unique motion", determined_grasp, Model::rigid, 100, 100, 100},
    {"unique motion", determined_grasp, Model::pad, 100, 100, 100},
};

template <class S> OwnedScene<S> under(Model law, OwnedScene<S> scene) {
  const Pressure pressures[] = {Pressure::rigid, Pressure::even, Pressure::pad};
  scene.base.pressure = pressures[static_cast<int>(law) % 3];
  if (is_round(law)) scene.base.facets = 8;
  return scene;
}

/// |f| <= mu lambda with f against the slip, by this test's own arithmetic.
template <class Push> double off_the_cone(const Push& push) {
  using S = std::decay_t<decltype(push.scales.force)>;
  double fastest = 0, worst = 0;
  const auto slip = [&](const ContactAnswer<S>& contact, const Body<S>& body) {
    const Vector3<S>& a = contact.acceleration;
    const Vector3<S> along = a - a.dot(body.normal) * body.normal;
    return std::hypot(double(along.norm()), double(body.torsion_radius * contact.spin));
  };
  for (const ContactAnswer<S>& contact : push.answer().contacts)
    fastest = std::max(fastest, slip(contact, push.scene.bodies[contact.body]));
  for (const ContactAnswer<S>& contact : push.answer().contacts) {
    const Body<S>& body = push.scene.bodies[contact.body];
    const Vector3<S> v = in_friction_space(body, contact.acceleration, contact.spin);
    const Vector3<S> f = friction_of(body, contact);
    const double room = double(body.friction) * std::abs(double(contact.normal_force));
    worst = std::max(worst, (double(f.norm()) - room) / double(push.scales.force));
    if (slip(contact, body) < 1e-5 * fastest) continue;
    worst = std::max(worst, double((f + S(room) * v / v.norm()).norm() / push.scales.force));
  }
  return worst;
}

using SmallPush = EnginePush<float, Engine::small>;

using Counts = std::array<int, engine_count>;

/// Each engine's answer to one push, judged.
void judge(const OwnedScene<double>& scene, bool round, Counts& solved, Counts& agreeing) {
  const EnginePush<double, Engine::dense> reference(scene, round);
  for_every_engine([&](auto choice) {
    constexpr Engine engine = choice;
    const auto at = static_cast<std::size_t>(engine);
    CAPTURE(std::string(engine_names[at]));
    const EnginePush<double, engine> push(scene, round);
    CHECK(push.status != Status::bad_input);
    if (push.status != Status::solved) return;
    ++solved[at];
    CHECK(push.residuals.max() <= (engine == Engine::gauss_seidel ? 1e-8 : 1e-9));
    if (round) CHECK(off_the_cone(push) <= 1e-8);
    if (reference.status != Status::solved) return;
    const double size = std::max(reference.scales.acceleration, reference.motion().norm());
    if ((push.motion() - reference.motion()).norm() <= 1e-5 * size) ++agreeing[at];
  });
}

} // namespace

TEST_CASE("[T.1] to [T.7], [T.16]: every engine on every kind of grasp under every law") {
  const auto total = static_cast<int>(seeds(20));
  for (const Kind& kind : kinds) {
    CAPTURE(std::string(kind.name));
    CAPTURE(std::string(model_names[static_cast<int>(kind.law)]));
    Counts solved{}, agreeing{};
    for (int seed = 1; seed <= total; ++seed) {
      CAPTURE(seed);
      judge(under(kind.law, kind.grasp(static_cast<std::uint64_t>(seed))), is_round(kind.law),
            solved, agreeing);
    }
    for (std::size_t at = 0; at < engine_count; ++at) {
      CAPTURE(std::string(engine_names[at]));
      const bool by_sweeps = at == static_cast<std::size_t>(Engine::gauss_seidel);
      CHECK(100 * solved[at] >= (by_sweeps ? kind.by_sweeps : kind.by_pivots) * total);
      CHECK(100 * agreeing[at] >= kind.agree * solved[at]);
    }
  }
}

TEST_CASE("in float, as devices have it, what is called solved obeys the laws") {
  for (const Model law : {Model::rigid, Model::pad, Model::even, Model::round_even}) {
    CAPTURE(std::string(model_names[static_cast<int>(law)]));
    const bool even = law == Model::even || law == Model::round_even;
    int solved = 0, worse = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      CAPTURE(seed);
      const SmallPush push(under(law, grasp_of<float>(even ? Family::even : Family::plain, seed)),
                           is_round(law));
      if (push.status != Status::solved) continue;
      ++solved;
      // The solver measures its equilibrated rows, the laws each row by its own terms: of 2,000
      // seeds a law four answers exceed 4 tolerances (friction against the slip), the worst is 7.
      const float in_tolerances = push.residuals.max() / Tolerances<float>().residual;
      CHECK(in_tolerances <= 16);
      worse += in_tolerances > 4 ? 1 : 0;
      if (is_round(law)) CHECK(off_the_cone(push) <= 1e-2);
    }
    CHECK(solved >= 90);
    CHECK(worse <= 1);
  }
}
