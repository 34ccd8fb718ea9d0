// What the variables and pivots of a scene's problem mean.
#pragma once

#include "lcpush/desktop/pivots.hpp"
#include "lcpush/desktop/push.hpp"

namespace lcpush::desktop {

class PushStory : public Story {
public:
  /// `push` outlives the story.
  explicit PushStory(const Push& push) : push_(push) {}

  bool is_physical() const override { return true; }
  std::string meaning(Index variable) const override;
  std::string sentence(const TracedPivot& pivot, const std::vector<bool>& basic) const override;
  std::string ray_sentence(Index entering, const std::vector<double>& v) const override;

private:
  const Push& push_;

  Index size() const { return push_.layout().size; }
  /// `the`: "the", or "The" where a sentence begins.
  std::string grows(Index variable, const std::string& the) const;
  std::string ends(Index variable, const std::vector<bool>& basic) const;
  std::string point(const Name& name) const { return point_name(push_.file(), name.of); }
  std::string along(const Name& name, double sign) const;
  std::string sliding(Index point, const std::vector<bool>& basic) const;
};

} // namespace lcpush::desktop
