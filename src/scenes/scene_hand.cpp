// The hand: what drives the fingers that have a grip_force.
#include "scenes/exact_frame.hpp"
#include "scenes/scene_tables.hpp"
#include "text/wording.hpp"

#include <array>

namespace lcpush::desktop {
namespace {

// Rounding of two normals that are typed as opposites, or turned by a root: in every coordinate, as
// docs/check/lcpush_check.py has it.
constexpr double opposed_slack = 1e-9;

/// The fingers that have a grip force, as indices.
std::vector<std::size_t> gripping_fingers(const HandTables& tables) {
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < tables.fingers.size(); ++i)
    if (tables.fingers[i].has("grip_force")) list.push_back(i);
  return list;
}

template <class S> S grip_force(const TableReader& finger) {
  return finger.number<S>("grip_force", Sign::positive);
}

/// Two fingers that press against each other with one force, as a parallel jaw's do.
template <class S>
bool is_jaw(const HandTables& tables, const std::vector<std::size_t>& gripping,
            const SceneOf<S>& scene) {
  if (gripping.size() != 2) return false;
  const Vector3<double> between = as_doubles<S>(scene.bodies[gripping[0]].normal) +
                                  as_doubles<S>(scene.bodies[gripping[1]].normal);
  return between.cwiseAbs().maxCoeff() < opposed_slack &&
         grip_force<S>(tables.fingers[gripping[0]]) == grip_force<S>(tables.fingers[gripping[1]]);
}

/// The hand that the file asks for; without a word, the one that such fingers belong to.
template <class S>
Hand chosen_hand(const HandTables& tables, const std::vector<std::size_t>& gripping,
                 std::optional<Hand> unsaid, const SceneOf<S>& scene) {
  if (tables.gripper && tables.gripper->has("jaws"))
    return std::array{Hand::independent, Hand::parallel,
                      Hand::locked}[tables.gripper->choice("jaws", jaws_names())];
  if (unsaid) return *unsaid;
  if (tables.actuator_line > 0) return Hand::actuators;
  if (gripping.empty()) return Hand::fixed;
  return scene.pressure != Pressure::even && is_jaw(tables, gripping, scene) ? Hand::parallel
                                                                             : Hand::independent;
}

/// What both fingers of a jaw press with.
template <class S>
S jaw_force(const HandTables& tables, const std::vector<std::size_t>& gripping,
            const SceneOf<S>& scene, const std::string& jaws) {
  if (scene.pressure == Pressure::even)
    tables.gripper->fail(
        "jaws", jaws + " jaws share one force over both fingers, so no point's even share of it is "
                       "known; use jaws = \"independent\" or another pressure than \"even\"");
  if (gripping.size() != 2)
    tables.gripper->fail("jaws", jaws +
                                     " jaws need exactly two [[finger]]s with a grip_force, got " +
                                     std::to_string(gripping.size()));
  const TableReader &first = tables.fingers[gripping[0]], &second = tables.fingers[gripping[1]];
  const S force = grip_force<S>(first), other = grip_force<S>(second);
  if (force != other)
    second.fail("grip_force", jaws + " jaws share one grip_force; got " + shown(as_double(other)) +
                                  ", but " + shown(as_double(force)) +
                                  " on the other finger; --vary and --set change both as "
                                  "\"*.grip_force\"");
  return force;
}

} // namespace

std::vector<std::string> jaws_names() { return {"independent", "parallel", "locked"}; }

template <class S>
void drive_hand(const HandTables& tables, std::optional<Hand> unsaid, SceneOf<S>& scene) {
  const std::vector<std::size_t> gripping = gripping_fingers(tables);
  if (tables.gripper && tables.actuator_line > 0)
    tables.gripper->fail("", "[gripper] and the [[actuator]] on line " +
                                 std::to_string(tables.actuator_line) +
                                 " exclude each other; remove one of them");
  if (tables.actuator_line > 0 && !gripping.empty())
    tables.fingers[gripping[0]].fail("grip_force",
                                     "grip_force and [[actuator]] exclude each other; give the "
                                     "force to an [[actuator]] that drives this finger");
  scene.hand = chosen_hand(tables, gripping, unsaid, scene);
  switch (scene.hand) {
  case Hand::fixed:
  case Hand::actuators: return;
  case Hand::independent:
    for (const std::size_t i : gripping)
      drive_along_normal(
          scene, static_cast<Index>(i),
          add_actuator<S>(scene, scene.body_names[i], grip_force<S>(tables.fingers[i]), S(0)));
    return;
  case Hand::parallel: {
    const S force = jaw_force(tables, gripping, scene, "parallel");
    const Index jaws = add_actuator<S>(scene, "jaws", S(2) * force, S(0));
    for (const std::size_t i : gripping) drive_along_normal(scene, static_cast<Index>(i), jaws);
    return;
  }
  case Hand::locked: {
    if (scene.pressure == Pressure::rigid)
      tables.gripper->fail("jaws",
                           "locked jaws keep what they closed with under pressure = \"pad\" "
                           "alone; under \"rigid\" nothing says how hard they press");
    const S force = jaw_force(tables, gripping, scene, "locked");
    for (const std::size_t i : gripping) scene.bodies[i].preload = force;
  }
  }
}

template void drive_hand(const HandTables& tables, std::optional<Hand> unsaid,
                         SceneOf<double>& scene);
template void drive_hand(const HandTables& tables, std::optional<Hand> unsaid,
                         SceneOf<Rational>& scene);

} // namespace lcpush::desktop
