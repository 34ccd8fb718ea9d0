// A contact problem's answer in words and in JSON; and pyramids, which Lemke's pivots solve.
#include "contacts/settings.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/contacts.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lcpush::desktop {
namespace {

using Eigen::VectorXd;

struct LawWords {
  const char *key, *name, *breaks;
};
constexpr LawWords laws[contact_law_count] = {
    {"signorini", "Signorini", "Signorini's law"},
    {"cone", "cone", "the friction cone"},
    {"dissipation", "dissipation", "the law of sliding"},
    {"natural_map", "natural map", "the laws together, by their natural map"},
    {"equalities", "equalities", "an equality, V' r + R l + s = 0"}};

bool has_equalities(const ContactProblem& problem) { return problem.s.size() > 0; }

/// In the order of the file.
VectorXd as_given(const ContactProblem& problem, const VectorXd& x) {
  VectorXd given = x;
  for (Index i = 0; problem.normal_last && i < x.size(); ++i) given[i] = x[i - i % 3 + (i + 1) % 3];
  return given;
}

/// A contact's force and velocity, as the laws see them.
struct SlipAndForce {
  Eigen::Vector3d r, u;
  double friction, limit, along, across; ///< the last two: of friction and slip

  SlipAndForce(const ContactProblem& problem, const ContactForces& answer, Index c)
      : r(answer.r.segment<3>(3 * c)), u(answer.u.segment<3>(3 * c)), friction(r.tail<2>().norm()),
        limit(problem.mu[c] * std::max(r[0], 0.0)), along(r.tail<2>().dot(u.tail<2>())),
        across(std::abs(r[1] * u[2] - r[2] * u[1])) {}

  double off_slip() const { return std::atan2(across, -along); } ///< rad

  bool is_misdirected(double tolerance) const {
    return friction > tolerance * limit && off_slip() > (limit - friction) / limit;
  }
};

/// What is wrong there: ": friction is 0, where 0.5 against the slip is due".
std::string fault_text(const SlipAndForce& at, Index law, double tolerance) {
  if (law == 0 && at.r[0] < 0) return ": it pulls with " + brief(-at.r[0]);
  if (law == 0 && at.u[0] < 0) return ": it goes into the other body at " + brief(-at.u[0]);
  if (law == 0) return ": it presses with " + brief(at.r[0]) + " and parts at " + brief(at.u[0]);
  if (law == 1) {
    const auto [friction, limit] = told_apart(at.friction, at.limit);
    return ": friction is " + friction + ", and mu r_n is " + limit;
  }
  if (law != 2) return "";
  const std::string due = brief(at.limit) + " against the slip is due";
  if (!at.is_misdirected(tolerance))
    return ": friction is " + brief(at.friction, tolerance * at.limit) + ", where " + due;
  if (std::atan2(at.across, at.along) < ContactSettings::along_slip)
    return ": friction of " + brief(at.friction) + " goes along with the slip, where " + due +
           "; its sign looks turned";
  return ": friction is " + brief(at.off_slip()) + " rad off the direction against the slip";
}

std::string hint_of(const ContactProblem& problem, const ContactForces& answer) {
  return problem.r && !answer.is_good ? contact_hint(problem, answer) : "";
}

/// "1 and 2", or how many.
std::string contradiction_text(const ContactProblem& problem, const VectorXd& none) {
  std::vector<std::string> which;
  double closes = 0;
  for (Index c = 0; c < none.size(); ++c)
    if (none[c] > 0) {
      which.push_back(std::to_string(c + 1));
      closes += none[c] * problem.b[3 * c];
    }
  if (which.size() == 1)
    return "There are no such forces: contact " + which[0] + " closes at " + brief(-closes) +
           ", whatever presses.\n";
  double least = 1;
  for (const double weight : none)
    if (weight > 0) least = std::min(least, weight);
  const std::string contacts = which.size() <= static_cast<std::size_t>(ContactSettings::shown)
                                   ? "contacts " + listed(which, "and")
                                   : counted(static_cast<Index>(which.size()), "contact");
  return "There are no such forces: of " + contacts + " the normal velocities sum up to " +
         brief(closes) +
         (least < 1 - usual_contact_tolerance ? " (with the weights of \"none\" in --json)" : "") +
         ", whatever presses, and each has to be 0 or more.\n";
}

/// What is said first.
std::string verdict(const ContactProblem& problem, const ContactForces& answer) {
  std::array<Index, 3> count{};
  for (const ForceMode mode : answer.modes) ++count[static_cast<std::size_t>(mode)];
  std::vector<std::string> modes;
  const auto tell = [&](std::size_t mode, const char* one, const char* more) {
    if (count[mode] > 0)
      modes.push_back(std::to_string(count[mode]) + " " + (count[mode] == 1 ? one : more));
  };
  tell(1, "sticks", "stick");
  tell(2, "slips", "slip");
  tell(0, "is open", "are open");
  const std::string of =
      "of " + counted(problem.contacts(), "contact") + " " + listed(modes, "and") + ".\n";
  if (answer.none.size() > 0)
    return (problem.r ? "The forces are refused. " : "") + contradiction_text(problem, answer.none);
  if (answer.is_good) return (problem.r ? "The forces are right: " : "Solved: ") + of;
  std::string text = problem.r ? "The forces are refused.\n"
                               : "Not solved: the solver did not end. There may be forces that "
                                 "obey the laws, or none: these are the nearest it came to.\n";
  Index count_broken = 0;
  for (Index law = 0; law < contact_law_count; ++law) {
    const ContactResidual& worst = answer.worst[law];
    const double most =
        law == 2 ? std::max(answer.tolerance, ContactSettings::off_slip) : answer.tolerance;
    const bool is_said = law == 3 && count_broken > 0; // it has all laws in one
    const bool is_told = (answer.facets == 0 || law < 2 || law == 4) && !is_said;
    if (!is_told || worst.size <= most) continue;
    ++count_broken;
    text += (law == 4 ? "Row " : "Contact ") + std::to_string(worst.contact + 1) + " breaks " +
            laws[law].breaks +
            (law < 3 ? fault_text({problem, answer, worst.contact}, law, answer.tolerance)
                     : ", by " + residual_text(worst.size)) +
            ".\n";
  }
  const std::string hint = hint_of(problem, answer);
  return text + (hint.empty() ? "" : hint + "\n");
}

} // namespace

std::string contacts_text(const ContactProblem& problem, const ContactForces& answer, bool all) {
  const std::string unread = problem.unread.empty()
                                 ? ""
                                 : "Not read of the file: " + listed(problem.unread, "and") +
                                       ". Forces to be judged are called \"r\".\n";
  std::string text = verdict(problem, answer);
  if (answer.none.size() > 0) return text + unread;
  text += "\n";
  const Index k = problem.contacts(), shown = all ? k : std::min(k, ContactSettings::shown);
  const double zero = ContactSettings::solved * answer.r.cwiseAbs().maxCoeff(),
               still = ContactSettings::solved * problem.b.cwiseAbs().maxCoeff();
  TableRows rows = {{"contact", "normal force", "friction", "slip speed", "mode"}};
  for (Index c = 0; c < shown; ++c) {
    const auto r = answer.r.segment<3>(3 * c), u = answer.u.segment<3>(3 * c);
    const bool is_open = answer.modes[static_cast<std::size_t>(c)] == ForceMode::open;
    const double none = is_open ? zero : ContactSettings::solved * r.norm(); // beside heavier ones
    rows.push_back(
        {std::to_string(c + 1), number(r[0], none), number(r.tail<2>().norm(), none),
         number(u.tail<2>().norm(), still),
         force_mode_texts[static_cast<std::size_t>(answer.modes[static_cast<std::size_t>(c)])]});
  }
  text += table_text(rows);
  if (shown < k) text += ".. and " + std::to_string(k - shown) + " more: -v shows all\n";
  std::vector<std::string> parts;
  for (Index law = 0; law < contact_law_count - (has_equalities(problem) ? 0 : 1); ++law)
    parts.push_back(laws[law].name + (" " + residual_text(answer.worst[law].size)));
  text += "\nResiduals: " + joined(parts, ", ");
  if (answer.lcp)
    text += "; of the pyramids' complementarity problem " + residual_text(*answer.lcp);
  return text + ".\n" + unread;
}

std::string contacts_json(const ContactProblem& problem, const ContactForces& answer) {
  JsonWriter json;
  json.begin_object().member("status", problem.r        ? answer.is_good ? "valid" : "refused"
                                       : answer.is_good ? "solved"
                                       : answer.none.size() > 0 ? "no_solution"
                                                                : "stagnated");
  json.key("friction").begin_object().member("law", answer.facets > 0 ? "pyramids" : "round");
  json.member("facets", when(answer.facets > 0, answer.facets)).end_object();
  json.member("normal", problem.normal_last ? "last" : "first");
  json.member("r", as_given(problem, answer.r)).member("u", as_given(problem, answer.u));
  if (has_equalities(problem)) json.member("l", answer.l);
  if (answer.none.size() > 0) json.member("none", answer.none);
  if (!problem.unread.empty()) json.member("unread", problem.unread);
  std::vector<std::string> modes;
  for (const ForceMode mode : answer.modes)
    modes.emplace_back(force_mode_texts[static_cast<std::size_t>(mode)]);
  json.member("hint", unless_empty(hint_of(problem, answer)));
  json.member("modes", modes).member("tolerance", answer.tolerance);
  json.key("residuals").begin_object();
  for (Index law = 0; law < contact_law_count; ++law)
    json.member(laws[law].key, answer.worst[law].size);
  json.member("lcp", answer.lcp).end_object();
  json.key("worst").begin_object(); // from 1
  for (Index law = 0; law < contact_law_count; ++law)
    json.member(laws[law].key, when(answer.worst[law].contact >= 0, answer.worst[law].contact + 1));
  return json.end_object().end_object().text();
}

} // namespace lcpush::desktop
