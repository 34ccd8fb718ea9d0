// contacts: the field's own contact problem.
#include "commands/listener.hpp"
#include "commands/values.hpp"
#include "lcpush/desktop/contacts.hpp"

namespace lcpush::commands {
namespace {

Result run_contacts(const Values& values, Listener&) {
  const std::string format = values.format();
  const std::string normal =
      values.one_of("normal", values.text("normal").value_or("first"), {"first", "last"});
  const auto facets = values.whole("facets", {4, 256, true});
  const Document given = values.contacts();
  const bool is_last = normal == "last";
  ContactProblem problem = given.text.empty() ? read_contacts(given.name, is_last)
                                              : parse_contacts(given.text, given.name, is_last);
  if (const auto forces = values.text("forces")) read_contact_forces(*forces, problem);
  if (facets && problem.r)
    values.refuse("facets", values.label("facets") + " is about solving; forces are judged by "
                                                     "round cones");
  const double tolerance =
      values.number("tolerance", 1, ", such as 1e-6").value_or(usual_contact_tolerance);
  const ContactForces answer = problem.r ? judge_contacts(problem, *problem.r, tolerance)
                               : facets  ? solve_contact_pyramids(problem, *facets)
                                         : solve_contacts(problem);
  return {answer.is_good, format == "json" ? contacts_json(problem, answer)
                                           : contacts_text(problem, answer, values.has("verbose"))};
}

} // namespace

Command contacts_command() {
  return {
      "contacts",
      "FILE.json | DIRECTORY [OPTIONS]",
      "solve W r + b with round cones, or judge forces",
      "Finds contact forces r, three a contact, with velocities u = W r + b by Signorini's and\n"
      "Coulomb's laws: 0 <= r_n _|_ u_n >= 0, |r_t| <= mu r_n, friction against the slip. The\n"
      "file has W (or G), b (or g, q) and mu, or M, H, f, w and mu; a directory has them as\n"
      "Matrix Market files, such as fclib/ of `lcpush export`. The normal comes first, then\n"
      "two tangents. Forces r in the file, or of --forces, are judged by each law instead:\n"
      "exit status 1 if one is broken.\n\n"
      "Example:\n  lcpush contacts docs/check/incline.json\n"
      "  lcpush contacts docs/check/incline.json --facets 8\n",
      with_common_options(
          {{"forces", "FILE", "judge these: JSON with r, an array, or Matrix Market", false, true},
           {"facets", "N", "pyramids of N sides instead of round cones"},
           {"normal", "first|last", "where a contact's normal stands among its three (first)"},
           {"tolerance", "T", "what judged forces may be off by, scaled (default 1e-6)"},
           {"seconds", "S", "stop after so much processor time (8)", false, true},
           {"verbose", "", "all contacts, not twenty; -v for short", false, true}}),
      run_contacts,
      {"text", "json"},
      1,
      false,
      {"problem"},
      "0 solved, or the forces are right, 1 not (the output says why)"};
}

} // namespace lcpush::commands
