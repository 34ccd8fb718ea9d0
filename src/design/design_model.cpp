#include "design/design_model.hpp"

#include "boxes/settings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace lcpush::desktop {

DesignModel::DesignModel(const DesignSpace& space, std::vector<bool> open, Values at)
    : open_(std::move(open)), at_(std::move(at)), scene_(space.scene_over(open_, at_)),
      box_(scene_, space.sides_over(open_, at_)), model_(box_, std::nullopt) {
  for (const BoxSide& side : box_.sides()) {
    Side mine;
    for (std::size_t j = 0; j < open_.size(); ++j)
      for (const Parameter& parameter : space.choices()[j].parameters)
        if (open_[j] && parameter.path == side.parameters[0].path &&
            space.choices()[j].slopes.empty() == side.slopes.empty() &&
            (side.slopes.empty() || side.low.value() == space.choices()[j].from))
          mine.choice = static_cast<int>(j);
    if (const DesignSpace::Uncertain* const one = space.uncertain(side.parameters[0].path)) {
      mine.is_relative = one->is_relative;
      mine.off = one->is_relative ? 0 : one->off;
    }
    sides_.push_back(mine);
  }
}

bool DesignModel::depends_on(std::size_t choice) const {
  for (std::size_t k = 0; k < sides_.size(); ++k)
    if (sides_[k].choice == static_cast<int>(choice) && model_.counts()[k]) return true;
  return false;
}

BoxEnds DesignModel::ends(const Values& values, double margin) const {
  BoxEnds ends;
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    const Side& side = sides_[k];
    const double middle = side.choice < 0 ? box_.sides()[k].middle.value()
                                          : values[static_cast<std::size_t>(side.choice)];
    const double off = side.is_relative ? margin * std::abs(middle) : side.off;
    ends.low.push_back(middle - off);
    ends.high.push_back(middle + off);
  }
  return ends;
}

double DesignModel::margin(const Values& values) const {
  return sticking_margin(box_, model_, [&](double margin) { return ends(values, margin); });
}

double DesignModel::hold_room(const Values& values, double margin) const {
  std::vector<double> worst;
  if (!model_.has_load()) return std::numeric_limits<double>::infinity();
  return 1 - box_settings.holding - holding_share(box_, model_, ends(values, margin), worst);
}

bool DesignModel::chooses_load() const {
  for (std::size_t k = 0; k < sides_.size(); ++k)
    if (sides_[k].choice >= 0 && is_load(box_.sides()[k])) return true;
  return false;
}

std::string DesignModel::first_beyond(const Values& values, double margin) const {
  const SceneFile file = scene_.as_given();
  if (hold_room(values, margin) < 0) return falls_words(file);
  const std::array<double, 4> room = rooms(values, margin);
  const auto worst = std::min_element(room.begin(), room.end()) - room.begin();
  return slip_words(file, model_, static_cast<std::size_t>(worst));
}

std::array<double, 4> DesignModel::rooms(const Values& values, double margin) const {
  const BoxEnds there = ends(values, margin);
  return model_.rooms(there.low, there.high);
}

bool DesignModel::narrow(Values& low, Values& high, double margin) const {
  const BoxEnds a = ends(low, margin), b = ends(high, margin);
  Box::Corner wide = 0;            // sides with two ends
  std::vector<std::size_t> chosen; // and with two choices
  for (std::size_t k = 0; k < sides_.size(); ++k) {
    if (!model_.counts()[k]) continue;
    if (a.low[k] < a.high[k] || b.low[k] < b.high[k]) wide |= Box::Corner{1} << k;
    if (sides_[k].choice >= 0 && a.low[k] < b.low[k]) chosen.push_back(k);
  }
  std::vector<double> from(chosen.size(), 0), to(chosen.size(), 1); // what is left of each
  std::vector<std::array<double, 4>> values(std::size_t{1} << chosen.size());
  for (Box::Corner corner = wide;; corner = (corner - 1) & wide) { // each subset once
    std::vector<double> at(sides_.size());
    for (std::size_t choice = 0; choice < values.size(); ++choice) {
      for (std::size_t k = 0, i = 0; k < sides_.size(); ++k) {
        const bool is_chosen = i < chosen.size() && chosen[i] == k;
        const BoxEnds& there = is_chosen && (choice >> i & 1U) != 0 ? b : a;
        at[k] = (corner >> k & 1U) != 0 ? there.high[k] : there.low[k];
        i += is_chosen ? 1 : 0;
      }
      values[choice] = model_.conditions(at).values;
    }
    for (std::size_t condition = 0; condition < 4; ++condition) {
      bool fails = true;
      for (const auto& one : values) fails = fails && one[condition] < 0;
      if (fails) return false;
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        double first = 1, last = 0; // where it may hold
        for (std::size_t choice = 0; choice < values.size(); ++choice) {
          if ((choice >> i & 1U) != 0) continue;
          const double x = values[choice][condition],
                       y = values[choice | std::size_t{1} << i][condition];
          if (x >= 0 || y >= 0) {
            first = std::min(first, x >= 0 ? 0 : x / (x - y));
            last = std::max(last, y >= 0 ? 1 : x / (x - y));
          }
        }
        from[i] = std::max(from[i], first);
        to[i] = std::min(to[i], last);
      }
    }
    if (corner == 0) break;
  }
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const auto j = static_cast<std::size_t>(sides_[chosen[i]].choice);
    if (from[i] > to[i]) return false;
    const double begin = low[j], end = high[j];
    low[j] = std::max(low[j], begin + from[i] * (end - begin));
    high[j] = std::min(high[j], begin + to[i] * (end - begin));
    if (low[j] > high[j]) return false;
  }
  return true;
}

} // namespace lcpush::desktop
