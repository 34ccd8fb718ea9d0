#include <algorithm>
#include <set>

#include "lcpush/desktop/push.hpp"
#include "solve/word_settings.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/wording.hpp"

namespace lcpush::desktop {
namespace {

/// Names of the file's bodies that carry a part of the witness.
std::vector<std::string> names_of(const SceneFile& file, const Assembly<double>& assembly,
                                  Existence verdict, const std::vector<double>& witness) {
  const Scene<double>& scene = assembly.scene();
  const Layout<double>& layout = assembly.layout();
  const double largest = *std::max_element(witness.begin(), witness.end());
  std::set<Index> takes_part;
  const auto mark = [&](Index body) {
    takes_part.insert(file.body_of(scene.bodies[body].first_point));
  };
  if (verdict == Existence::closes_on_nothing)
    for (const Drive<double>& drive : scene.drives)
      if (witness[static_cast<std::size_t>(drive.actuator)] > word_settings.witness * largest)
        mark(drive.body);
  if (verdict == Existence::can_be_squeezed)
    for (Index i = 0; i < layout.points; ++i)
      for (Index k = 0; k < layout.cones[i].normals; ++k)
        if (witness[static_cast<std::size_t>(layout.cones[i].force + k)] >
            word_settings.witness * largest)
          mark(layout.body[i]);
  std::vector<std::string> names;
  for (const Index b : takes_part) names.push_back(file.body_name(b));
  return names;
}

} // namespace

ExistenceFound find_existence(const SceneFile& file, const Assembly<double>& assembly) {
  ExistenceFound found;
  const ExistenceSize size = existence_size(assembly);
  if (size.scalars() > limits::scalars_existence) return found;
  SolverMemory<double> memory(size.scalars(), size.integers());
  const Layout<double>& layout = assembly.layout();
  std::vector<double> witness(static_cast<std::size_t>(layout.forces + layout.actuators), 0.0);
  found.studied = true;
  found.verdict = study_existence<double>(
      assembly, size, {span_of(memory.scalars), span_of(memory.integers)}, witness.data());
  found.bodies = names_of(file, assembly, found.verdict, witness);
  return found;
}

Statement existence_statement(const SceneFile& file, const ExistenceFound& found) {
  if (!found.studied) return {"", {"not studied: the scene has too many unknowns"}};
  const std::string who = listed(found.bodies, "and");
  Statement said;
  switch (found.verdict) {
  case Existence::proved:
    said = {"an answer exists, whatever the loads", {"(H1) and (H2) of theory 5.3 hold"}};
    break;
  case Existence::closes_on_nothing:
    said.reasons = {"(H1) of theory 5.3 fails: the actuator of " + who +
                    " can close on no contact"};
    break;
  case Existence::can_be_squeezed:
    said.reasons = {"(H2) of theory 5.3 fails: " + who +
                    " can squeeze the object, and the prescribed motions tighten that"};
    break;
  case Existence::may_retreat:
    said.reasons = {"an actuator has no force, shares a body, or moves a contact along its plane "
                    "only (theory 5.4)"};
    break;
  case Existence::not_known:
    return {"", {"not known: a linear program for theory 5.3 was not settled"}};
  }
  if (std::any_of(file.bodies.begin(), file.bodies.end(),
                  [](const Body<double>& body) { return body.bilateral; }))
    said.reasons.emplace_back(
        "bilateral pushers leave the common class: their pulls were looked at too (5.7)");
  return said;
}

std::string tied_words(Index contacts) {
  return counted(contacts, "contact") + (contacts == 1 ? " is" : " are") + " between two modes";
}

Statement uniqueness_statement(const PushReport& report) {
  if (report.unique_motion == Uniqueness::yes)
    return {"the motion is unique", {"every normal force with friction is known (theory 7)"}};
  const FinalBasis& basis = report.final_basis;
  Statement said;
  if (!report.undetermined.empty())
    said.reasons.push_back(report.undetermined +
                           " has friction and no known normal force (theory 7)");
  std::string near = "no other motion next to it";
  if (basis.motion_open)
    near = "other motions lie next to it";
  else if (basis.tied_contacts > 0)
    near = tied_words(basis.tied_contacts) + ", which leaves it undecided";
  said.reasons.push_back(basis.studied
                             ? "this answer's neighbourhood was studied (final basis): " + near
                             : "this answer's neighbourhood was not studied");
  return said;
}

} // namespace lcpush::desktop
