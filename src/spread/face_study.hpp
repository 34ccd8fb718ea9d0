// What the answers on a face say of every quantity that is asked for: of the push as it is, or of
// the instant at which a smaller and smaller one breaks the grasp.
#pragma once

#include "spread/spread_face.hpp"
#include "spread/spread_quantities.hpp"

namespace lcpush::desktop {

class FaceStudy {
public:
  FaceStudy(LiteralProblem& problem, SpreadReport& report, bool breaking);

  /// Not refuted: some assignment of modes to the undecided contacts may have an answer, with a
  /// motion that only modes as decided have.
  bool may_have_answers(const FaceModes& part);

  enum class Result { studied, empty, failed, out_of_work };
  /// Widens the report's intervals by all answers of the face. `corners`: answers to finite pushes
  /// on it. Stops at `most_work`.
  Result study(const FaceModes& modes, double most_work, std::vector<Face::Answer>& corners);

  /// Takes an answer to the push as it is, if the referee does.
  bool accept(Face::Answer answer);

  double work() const { return work_; }

private:
  LiteralProblem& problem_;
  SpreadReport& report_;
  bool breaking_;
  std::vector<Quantity> quantities_;
  double work_ = 0;

  bool is_answer(Face::Answer answer);
  bool reaches_down(const FaceModes& modes, const ModeMotions& motions, Face::Answer& pushed,
                    bool& failed);
  Result bound_all(Face& face, const Face::Answer* pushed, double most_work,
                   std::vector<Face::Answer>& corners);
  bool bound(Face& face, const Face::Answer* pushed, const Quantity& quantity, double sign,
             std::vector<Face::Answer>& corners);
  bool bound_first_motion(Face& rest, const ModeMotions& motions);
  void take(const Face& face);
};

/// The answer to a part `share` of the larger push, between an answer without one and it.
Face::Answer between(const Face::Answer& rest, const Face::Answer& pushed, double share);

} // namespace lcpush::desktop
