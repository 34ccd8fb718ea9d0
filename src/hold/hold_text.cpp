#include "hold/give_way.hpp"
#include "hold/settings.hpp"
#include "lcpush/desktop/naming.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"
#include "text/wording.hpp"

#include <algorithm>
#include <cmath>

namespace lcpush::desktop {
namespace {

constexpr const char* units[] = {"N", "N m", "m/s^2"};

/// m/s^2: what accelerates the object by less is what rounding leaves of no hold at all.
constexpr double unfelt = 1e-12;

/// With 0 for such limits.
HoldStudy without_rounding(const SceneFile& file, HoldStudy study) {
  const double force = unfelt * file.object.mass;
  const double least[] = {force, force * object_size(file), unfelt};
  const auto clean = [&](HoldLimit& limit) {
    if (limit.limit < least[static_cast<int>(limit.what.kind)]) limit.limit = 0;
  };
  std::for_each(study.limits.begin(), study.limits.end(), clean);
  std::for_each(study.weakest.begin(), study.weakest.end(), clean);
  return study;
}

/// A grip that holds: the least is rounded up, the most down.
enum class Bound { least, most };

std::string grip_text(const HoldStudy& study, double factor, Bound bound = Bound::least) {
  const std::string force = brief_within(factor * study.grip.force, bound == Bound::least,
                                         statics_settings.closed * study.grip.force);
  if (study.grip.of_actuator) return "a force of " + force + " " + study.grip.of;
  return force + " N " + study.grip.of;
}

/// Where more than so much grip does not hold.
bool has_most(const HoldStudy& study) { return std::isfinite(study.most); }

std::string falls_words(const SceneFile& file, const HoldStudy& study) {
  const std::string object = object_name(file);
  if (study.grip.force == 0 && study.statics_factor < no_limit && study.falls.along.isZero(0))
    return "Not held by what presses " + object +
           ". Bodies that stand still may also squeeze it, and hold it; nobody says how hard.";
  if (study.grip.force == 0) return "Not held: the load " + give_way_words(file, study.falls) + ".";
  if (study.factor == no_limit)
    return "No grip force holds " + object + ": whatever the grip, the load " +
           give_way_words(file, study.falls) + ".";
  if (std::isnan(study.factor))
    return "Not held, and the grip that would hold " + object + " is not known" +
           (study.statics_factor > 1
                ? ": it takes more than " + grip_text(study, study.statics_factor)
                : "") +
           ".";
  if (study.most == 0) return "Not held: its grip pushes " + object + " away, however weak it is.";
  if (study.factor <= 1 && !(study.most < 1))
    return "Not held, by the answer of its laws that was found, though " +
           grip_text(study, study.factor) + " may hold " + object + ".";
  if (study.factor <= 1)
    return "Not held: the grip is too hard; from " + grip_text(study, study.factor) + " to " +
           grip_text(study, study.most, Bound::most) + " would hold " + object + ".";
  return "Not held: it takes " + told_apart(study.factor, 1).first + " times the grip, " +
         grip_text(study, study.factor) + "; with less the load " +
         give_way_words(file, study.falls) + ".";
}

std::string against(const HoldLimit& limit) {
  const std::string way = direction_text(limit.what.direction);
  switch (limit.what.kind) {
  case Disturbance::force: return "a force along " + way;
  case Disturbance::moment: return "a twist about " + way;
  case Disturbance::acceleration: return "an acceleration along " + way;
  }
  return way;
}

/// The axes that are as weak as the weakest direction of a kind, to what words tell.
std::vector<const HoldLimit*> weak_axes(const HoldStudy& study, Disturbance kind) {
  const double weakest = study.weakest[static_cast<std::size_t>(kind)].limit;
  std::vector<const HoldLimit*> axes;
  for (std::size_t k = 0; k < 6 && !study.limits.empty(); ++k) {
    const HoldLimit& limit = study.limits[6 * static_cast<std::size_t>(kind) + k];
    const auto is_alike = [&](const GiveWay& a, const GiveWay& b) {
      return a.slips == b.slips && a.opens == b.opens && a.yields == b.yields;
    };
    if (limit.limit <= (1 + hold_settings.told) * weakest &&
        (axes.empty() || is_alike(axes.front()->gives, limit.gives)))
      axes.push_back(&limit);
  }
  return axes;
}

/// Such an axis rather than any other direction.
const HoldLimit& weakest_of(const HoldStudy& study, Disturbance kind) {
  const std::vector<const HoldLimit*> axes = weak_axes(study, kind);
  return axes.empty() ? study.weakest[static_cast<std::size_t>(kind)] : *axes.front();
}

/// "a force along x, -x or y": with the other axes that are as weak.
std::string against_weakest(const HoldStudy& study, const HoldLimit& weakest) {
  std::string text = against(weakest);
  const std::vector<const HoldLimit*> axes = weak_axes(study, weakest.what.kind);
  if (axes.empty() || axes.front() != &weakest) return text;
  for (std::size_t k = 1; k < axes.size(); ++k)
    text += (k + 1 == axes.size() ? " or " : ", ") + direction_text(axes[k]->what.direction);
  return text;
}

/// The force or moment that is least, a moment over the length at which it acts.
const HoldLimit* least_of(const SceneFile& file, const HoldStudy& study) {
  const double size = object_size(file) / 2;
  const HoldLimit* least = nullptr;
  double smallest = no_limit;
  for (const Disturbance kind : {Disturbance::force, Disturbance::moment}) {
    const auto look = [&](const HoldLimit& limit) {
      const double force = limit.limit / (kind == Disturbance::moment ? size : 1);
      if (!(force > 0) || !(force < smallest)) return;
      smallest = force;
      least = &limit;
    };
    look(weakest_of(study, kind));
    if (study.weakest[static_cast<std::size_t>(kind)].limit > 0) continue;
    for (const HoldLimit& limit : study.limits) // a direction that nothing resists says little
      if (limit.what.kind == kind) look(limit);
  }
  return least;
}

bool loads(const SceneFile& file, const HoldStudy& study) {
  return (study.presses && !presses_of(file).empty()) || !file.gravity.isZero(0) ||
         !file.object.wrench.isZero(0);
}

std::string cell(double value, bool is_held) {
  return std::isnan(value) ? "-" : std::isinf(value) ? is_held ? "any" : "-" : brief(value);
}

/// "<5.8" where statics bounds it and the scene's law has not said how far, "?" where nothing does;
/// nothing across a plane.
std::string limit_cell(const HoldLimit& limit) {
  if (!std::isnan(limit.limit)) return cell(limit.limit, true);
  return std::isnan(limit.statics)   ? ""
         : std::isinf(limit.statics) ? "?"
                                     : "<" + brief(limit.statics);
}

/// Is a limit not known that statics knows?
bool has_unknown(const HoldStudy& study) {
  const auto is_unknown = [](const HoldLimit& limit) {
    return std::isnan(limit.limit) && !std::isnan(limit.statics);
  };
  return std::any_of(study.limits.begin(), study.limits.end(), is_unknown) ||
         std::any_of(study.weakest.begin(), study.weakest.end(), is_unknown);
}

TableRows limit_rows(const HoldStudy& study) {
  TableRows rows{{"beyond the load", "+x", "-x", "+y", "-y", "+z", "-z", "weakest"}};
  for (std::size_t kind = 0; kind < 3; ++kind) {
    std::vector<std::string> row = {std::string(disturbance_texts[kind]) + " " + units[kind]};
    for (std::size_t k = 0; k < 6; ++k) row.push_back(limit_cell(study.limits[6 * kind + k]));
    row.push_back(limit_cell(study.weakest[kind]));
    rows.push_back(row);
  }
  return rows;
}

/// How it gives way, told for all axes that are as weak.
std::string gives_words(const SceneFile& file, const HoldStudy& study, const HoldLimit& weakest) {
  const std::vector<const HoldLimit*> axes = weak_axes(study, weakest.what.kind);
  std::string way;
  if (axes.size() > 1 && axes.front() == &weakest) {
    const std::string along = direction_text(weakest.gives.along);
    if (along == direction_text(weakest.what.direction))
      way = "that way";
    else if (weakest.gives.turns && along.size() == 2) // "+z"
      way = "about " + along.substr(1);
  }
  return give_way_words(file, weakest.gives, way);
}

/// "along (0, 0.6, 0.8): slides it along -z over left and right".
std::string weakest_text(const SceneFile& file, const HoldStudy& study) {
  std::string text;
  for (const Disturbance kind : {Disturbance::force, Disturbance::moment}) {
    const HoldLimit& limit = weakest_of(study, kind);
    if (!(limit.limit < no_limit)) continue;
    if (!text.empty()) text += "\n";
    text += limit.limit > 0
                ? against_weakest(study, limit) + ", which " + gives_words(file, study, limit)
                : against(limit) + ", which nothing resists";
  }
  return text;
}

/// Where statics would allow more than the scene's law.
std::string statics_text(const SceneFile& file, const HoldStudy& study) {
  std::string text;
  const auto compare = [&](const HoldLimit& limit) {
    if (std::isnan(limit.statics) ||
        std::abs(limit.statics - limit.limit) <= hold_settings.told * limit.limit ||
        limit.statics == limit.limit || (limit.limit == 0 && std::isinf(limit.statics)))
      return;
    text += (text.empty() ? "" : ", ") + against(limit) + " " +
            (std::isinf(limit.statics)
                 ? "any"
                 : brief(limit.statics) + " " + units[static_cast<int>(limit.what.kind)]);
  };
  for (std::size_t k = 0; k < 2; ++k) compare(study.weakest[k]);
  if (std::abs(study.factor - study.statics_factor) > hold_settings.told * study.factor &&
      study.grip.force > 0)
    text =
        "least grip " + grip_text(study, study.statics_factor) + (text.empty() ? "" : "; ") + text;
  return text.empty() || !has_patches(file) ? text : text + "; pressure would have to shift";
}

/// "wall, which presses with 3 N".
std::vector<Fact> press_facts(const SceneFile& file, const HoldStudy& study) {
  std::vector<std::string> list;
  for (const Press& press : presses_of(file))
    list.push_back(file.body_name(press.body) +
                   (study.presses ? " with " : ", which presses with ") + brief(press.force) +
                   " N");
  if (list.empty()) return {};
  return {{study.presses ? "Pressed by" : "Left out",
           listed(list, "and") +
               (study.presses ? ", without friction" : "; --press counts it as a load")}};
}

/// Of pads their statics is asked, and the law of few points may turn a little earlier; but gravity
/// that turns changes by twice the weight at most, and the law may bear that whichever way it acts.
std::string tilt_words(const SceneFile& file, const HoldStudy& study) {
  const bool is_any = study.tilt >= std::acos(-1.0);
  if (!is_any)
    return (study.is_statics ? "" : "at most ") + brief(study.tilt * degrees_a_radian) +
           " degrees of gravity, any way";
  const bool is_borne = study.at == file.object.center_of_mass &&
                        study.weakest[0].limit >= 2 * file.object.mass * file.gravity.norm();
  return std::string("gravity may point any way") +
         (study.is_statics || is_borne ? "" : ", by statics");
}

std::vector<Fact> hold_facts(const SceneFile& file, const HoldStudy& study) {
  std::vector<Fact> facts{hand_fact(file)};
  for (const Fact& fact : press_facts(file, study)) facts.push_back(fact);
  if (study.grip.force > 0 && std::isfinite(study.factor))
    facts.push_back(
        {"Least grip",
         grip_text(study, study.factor) + " (of " + brief(study.grip.force) + ")" +
             (has_most(study) ? ", and at most " + grip_text(study, study.most, Bound::most) +
                                    ": more drives it out"
                              : "")});
  const bool could_hold = !study.is_statics && study.grip.force > 0 && study.statics_factor <= 1;
  if (study.held == false && could_hold)
    facts.push_back(
        {"By statics", "forces that hold it exist from " + grip_text(study, study.statics_factor) +
                           " on" +
                           (has_patches(file) ? "; pressure would have to shift"
                                              : ": the laws leave open which forces there are")});
  if (!study.held.value_or(false)) return facts;
  if (study.other)
    facts.push_back(
        {"Not certain",
         "the laws leave forces open; with others of them it accelerates "
         "at " +
             acceleration_text(study.other->acceleration, study.other->length, Telling::brief)});
  if (const std::string text = weakest_text(file, study); !text.empty())
    facts.push_back({"Weakest against", text});
  if (has_unknown(study))
    facts.push_back({"Not known",
                     "where the table has < (or ?): contacts may bear so much (or any load), "
                     "and how much of it their law lets them bear took too long to find out"});
  if (study.may_bear_more)
    facts.push_back({"At least", "so much is borne; whether more is took too long to find out. "
                                 "Fewer points a pad, of the same surface, tell it"});
  for (std::size_t k = 18; k < study.limits.size(); ++k) {
    const HoldLimit& limit = study.limits[k];
    facts.push_back(
        {k == 18 ? "Asked" : "",
         against(limit) + ": " + (std::isnan(limit.statics) ? "-" : limit_cell(limit)) + " " +
             units[static_cast<int>(limit.what.kind)] +
             (std::isfinite(limit.limit) ? ", which " + give_way_words(file, limit.gives) : "")});
  }
  if (!std::isnan(study.added_mass))
    facts.push_back(
        {"Added mass",
         (std::isinf(study.added_mass) ? "as much as you like," : brief(study.added_mass) + " kg") +
             (study.at == file.object.center_of_mass ? " at its centre" : " at that point")});
  if (!std::isnan(study.tilt)) facts.push_back({"Tilt", tilt_words(file, study)});
  if (const std::string text = statics_text(file, study); !text.empty())
    facts.push_back({"By statics", text});
  return facts;
}

} // namespace

std::string hold_answer(const SceneFile& file, const HoldStudy& given) {
  const HoldStudy study = without_rounding(file, given);
  const std::string object = object_name(file);
  if (!study.held)
    return "It is not known whether the grasp holds " + object +
           (study.reason.empty() ? "" : ": " + study.reason) + ".";
  if (!*study.held)
    return study.reason.empty() ? falls_words(file, study) : "Not held: " + study.reason + ".";
  std::string text = "Held";
  if (!std::isnan(study.margin()))
    text += " with " + told_apart(study.margin(), 1).first + " times the grip it needs";
  else if (study.factor == 0 && study.grip.force > 0)
    text += loads(file, study)
                ? " without any grip force"
                : " without any grip force, as nothing loads it (no gravity, no force)";
  else if (study.grip.force == 0)
    text += " where it rests";
  const HoldLimit* const least = study.limits.empty() ? nullptr : least_of(file, study);
  std::string beside =
      has_unknown(study) ? "; of what is known weakest against " : "; weakest against ";
  for (const Disturbance kind : {Disturbance::moment, Disturbance::force})
    if (const HoldLimit& free = study.weakest[static_cast<std::size_t>(kind)]; free.limit == 0) {
      text += "; nothing resists " + against(free);
      beside = has_unknown(study) ? ", and of what is known the weakest else is "
                                  : ", and the weakest else is ";
    }
  if (least == nullptr) return text + ".";
  return text + beside + against_weakest(study, *least) + ": " + brief(least->limit) + " " +
         units[static_cast<int>(least->what.kind)] + " " + gives_words(file, study, *least) + ".";
}

std::string hold_text(const SceneFile& file, const HoldStudy& given) {
  const HoldStudy study = without_rounding(file, given);
  std::string text = title_line(file) + hold_answer(file, study) + "\n\n";
  if (study.held.value_or(false) && !study.limits.empty())
    text += table_text(limit_rows(study)) +
            (file.planar ? "In a plane nothing is asked across it.\n\n" : "\n");
  return text + facts_text(hold_facts(file, study));
}

} // namespace lcpush::desktop
