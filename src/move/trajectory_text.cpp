#include "formats/json_writer.hpp"
#include "lcpush/desktop/trajectory.hpp"
#include "solve/push_words.hpp"
#include "solve/sentence.hpp"
#include "text/format.hpp"

namespace lcpush::desktop {
namespace {

/// "155 um/s": speeds of every size, in three digits.
std::string speed_text(double speed) {
  if (speed >= 1e-2) return brief(speed) + " m/s";
  if (speed >= 1e-5) return brief(1e3 * speed) + " mm/s";
  return brief(1e6 * speed) + " um/s";
}

std::string verdict_sentence(const SceneFile& file, const TrajectoryReport& report) {
  const std::string worst = speed_text(report.worst) + " at " + brief(report.worst_time) + " s";
  switch (report.verdict) {
  case TrajectoryVerdict::follows:
    return "The motion obeys the laws: step by step it goes where they lead, within " +
           speed_text(report.worst) + ".";
  case TrajectoryVerdict::creeps: {
    std::string text = "The motion creeps: Coulomb's law holds " + object_name(file);
    if (report.held) text += ", with " + brief(*report.held) + " times the grip that it takes";
    return text + "; " + speed_text(report.creep) + " is the simulator's, not friction's.";
  }
  case TrajectoryVerdict::stopped:
    return "The laws have no step to " + brief(report.worst_time) +
           " s from where the motion is (" + std::string(status_text(report.status)) + ").";
  case TrajectoryVerdict::differs: break;
  }
  return "The motion breaks the laws: they lead elsewhere by " + worst + ".";
}

} // namespace

std::string trajectory_text(const SceneFile& file, const TrajectoryReport& report) {
  return title_line(file) + verdict_sentence(file, report) + "\n\n" +
         facts_text(
             {{"Compared", counted(report.steps, "step") +
                               ", each begun where the motion is and made in the 1 to 64 "
                               "parts that come nearest"},
              {"Difference", speed_text(report.worst) + " at most (at " + brief(report.worst_time) +
                                 " s), " + speed_text(report.mean) + " on average"},
              {"Beside", speed_text(report.fastest) + ", the fastest that moves; allowed are " +
                             brief(report.tolerance) + " of it"}});
}

std::string trajectory_json(const TrajectoryReport& report) {
  JsonWriter json;
  json.begin_object()
      .member("verdict", verdict_text(report.verdict))
      .member("steps", report.steps)
      .member("tolerance", report.tolerance)
      .member("fastest", report.fastest)
      .member("worst", report.worst)
      .member("worst_time", report.worst_time)
      .member("mean", report.mean)
      .member("status", status_text(report.status))
      .member("creep", report.creep)
      .member("held", report.held)
      .end_object();
  return json.text();
}

} // namespace lcpush::desktop
