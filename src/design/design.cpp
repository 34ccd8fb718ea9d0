// [T.21] The design with the widest box: cells of choices are cut where they may hold a better one.
#include "lcpush/desktop/design.hpp"

#include "boxes/settings.hpp"
#include "design/design_model.hpp"
#include "design/settings.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "scenes/parameter_words.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <queue>
#include <utility>

namespace lcpush::desktop {
namespace {

class Designer {
public:
  explicit Designer(const DesignSpace& space)
      : space_(space), linear_(space.choices().size(), false) {
    const DesignModel nothing_open(space, linear_, space.given());
    if (!nothing_open.obstacle().empty())
      throw InputError("no design is known: " + nothing_open.obstacle());
    for (std::size_t j = 0; j < linear_.size(); ++j) {
      if (space.choices()[j].parameters[0].kind != Parameter::Kind::number) continue;
      linear_[j] = true;
      if (!DesignModel(space, linear_, space.given()).obstacle().empty()) linear_[j] = false;
    }
  }

  struct Best {
    Values values;
    double margin = -1;                                     ///< < 0: it slips
    double room = -std::numeric_limits<double>::infinity(); ///< of one that slips
  };

  /// Of these choices, the others as the file has them, and no worse than the best of `known`.
  /// `share` of the work.
  Best find(const std::vector<bool>& chosen, double share, const std::vector<Values>& known = {}) {
    best_ = {};
    is_held_back_ = false;
    work_ = share * design_settings.work;
    open_ = rest_ = chosen;
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      open_[j] = chosen[j] && linear_[j];
      rest_[j] = chosen[j] && !linear_[j];
    }
    Values at = space_.given();
    for (std::size_t j = 0; j < chosen.size(); ++j)
      if (chosen[j]) at[j] = std::clamp(at[j], choice(j).from, choice(j).to);
    best_.values = at;
    const std::vector<bool> open = std::exchange(open_, std::vector<bool>(chosen.size(), false));
    for (const Values& one : known)
      if (const DesignModel* const model = is_allowed(one) ? possible_model_at(one) : nullptr)
        try_one(*model, one);
    open_ = open;
    search_few(2);
    search_few(3);
    search_at(best_.values);
    search_grid();
    search_few(2);
    settle(chosen);
    return best_;
  }

  /// The margin over one choice, and where another condition binds.
  void draw(const Values& values, std::size_t j, DesignReport::Choice& into) {
    open_.assign(linear_.size(), false);
    open_[j] = linear_[j];
    open_[j] = open_[j] && possible_model_at(values) != nullptr; // else place by place
    Values at = values;
    const auto look = [&](double value) {
      at[j] = value;
      const DesignModel* const model = possible_model_at(at);
      if (model == nullptr) return std::pair(0.0, std::string());
      const double margin = model->margin(at);
      return std::pair(margin, model->first_beyond(at, std::min(box_settings.no_margin,
                                                                margin + design_settings.beyond)));
    };
    std::pair<double, std::string> last;
    for (int step = 0; step <= design_settings.curve_steps; ++step) {
      const double width = (into.to - into.from) / design_settings.curve_steps;
      double from = into.from + (step - 1) * width, to = from + width;
      const auto now = look(to);
      const auto before = std::exchange(last, now);
      const bool is_break =
          step > 0 && now.second != before.second && std::min(now.first, before.first) > 0;
      const std::pair end(to, now.first);
      for (int k = 0; is_break && k < design_settings.break_halvings; ++k) {
        const double middle = (from + to) / 2;
        (look(middle).second == before.second ? from : to) = middle;
      }
      if (is_break) {
        into.curve.emplace_back(to, look(to).first);
        into.breaks.emplace_back(to, now.second);
      }
      into.curve.push_back(end);
    }
  }

private:
  const DesignSpace::Choice& choice(std::size_t j) const { return space_.choices()[j]; }

  bool is_allowed(const Values& at) const {
    for (std::size_t j = 0; j < at.size(); ++j)
      if (at[j] < choice(j).from || at[j] > choice(j).to) return false;
    return true;
  }

  /// What a better design has at least; near 1 masses and frictions are none.
  double wanted() const {
    const double better = best_.margin * (1 + design_settings.better);
    return best_.margin < 0
               ? 0
               : std::min(box_settings.no_margin, better + design_settings.least_margin);
  }

  /// Choices in which the conditions are not linear each have a model of their own.
  const DesignModel& model_at(const Values& at) {
    Values fixed = at;
    for (std::size_t j = 0; j < fixed.size(); ++j)
      if (open_[j]) fixed[j] = choice(j).given;
    if (model_ == nullptr || model_->at() != fixed || model_open_ != open_) {
      model_ = std::make_unique<DesignModel>(space_, open_, fixed);
      model_open_ = open_;
      work_ -= design_settings.model_work;
    }
    return *model_;
  }

  /// None where that is no scene, or none of which it is known whether it sticks.
  const DesignModel* possible_model_at(const Values& at) {
    try {
      const DesignModel& model = model_at(at);
      return model.obstacle().empty() ? &model : nullptr;
    } catch (const InputError&) {
      return nullptr;
    }
  }

  double try_one(const DesignModel& model, const Values& values) {
    work_ -= static_cast<double>(model.cost());
    double room = least(model.rooms(values, wanted()));
    if (room >= 0 || is_held_back_) {
      const double held = model.hold_room(values, wanted());
      is_held_back_ = is_held_back_ || held < 0;
      work_ -= design_settings.hold_work;
      room = std::min(room, held);
    }
    if (room >= 0) {
      work_ -= design_settings.margin_work * static_cast<double>(model.cost());
      if (const double margin = model.margin(values); margin > best_.margin)
        best_ = {values, margin, room};
    } else if (best_.margin < 0 && room > best_.room) {
      best_ = {values, -1, room};
    }
    return room;
  }

  struct Cell {
    Values low, high;
    double room; ///< of its middle
    bool operator<(const Cell& other) const { return room < other.room; }
  };

  /// Unless nothing better is in it.
  void add(const DesignModel& model, Cell cell, std::priority_queue<Cell>& cells) {
    work_ -= 2 * static_cast<double>(model.cost());
    if (!model.narrow(cell.low, cell.high, wanted())) return;
    if (is_held_back_ && !model.chooses_load() && model.hold_room(cell.high, wanted()) < 0) return;
    Values middle = cell.low;
    for (std::size_t j = 0; j < middle.size(); ++j) middle[j] = (cell.low[j] + cell.high[j]) / 2;
    cell.room = try_one(model, middle);
    cells.push(std::move(cell));
  }

  /// Branch and bound over the choices in which the conditions are linear.
  void search_at(const Values& at) {
    const DesignModel* const found = possible_model_at(at);
    if (found == nullptr) return;
    const DesignModel& model = *found;
    try_one(model, at);
    Cell all{at, at, 0};
    for (std::size_t j = 0; j < at.size(); ++j)
      if (open_[j] && model.depends_on(j)) {
        all.low[j] = choice(j).from;
        all.high[j] = choice(j).to;
      }
    std::priority_queue<Cell> cells;
    add(model, std::move(all), cells);
    while (!cells.empty() && work_ > reserve_ && wanted() < box_settings.no_margin) {
      Cell half = cells.top();
      cells.pop();
      std::size_t widest = 0;
      const auto width = [&](std::size_t j) {
        return (half.high[j] - half.low[j]) / (choice(j).to - choice(j).from);
      };
      for (std::size_t j = 1; j < at.size(); ++j)
        if (width(j) > width(widest)) widest = j;
      if (width(widest) < design_settings.finest) continue;
      Cell other = half;
      half.high[widest] = other.low[widest] = (half.low[widest] + half.high[widest]) / 2;
      add(model, std::move(half), cells);
      add(model, std::move(other), cells);
    }
  }

  /// So many choices at a time, which soon ends, as long as that helps.
  void search_few(std::size_t count) {
    const std::vector<bool> open = open_;
    for (bool is_better = true; is_better && work_ > 0;) {
      const double before = best_.margin;
      std::vector<bool> few(open.size(), false);
      std::fill_n(few.rbegin(), std::min(count, few.size()), true);
      do {
        open_ = few;
        bool is_open = few != open && work_ > 0; // all of them are looked at anyway
        for (std::size_t j = 0; j < few.size(); ++j) is_open = is_open && (open[j] || !few[j]);
        reserve_ = std::max(work_ - design_settings.few_work, 0.0);
        if (is_open) search_at(best_.values);
      } while (std::next_permutation(few.begin(), few.end()));
      is_better = best_.margin > std::max(before, before * (1 + design_settings.better));
    }
    reserve_ = 0;
    open_ = open;
  }

  /// Every list of so many places.
  template <class Visit> static void each_place(std::size_t size, int places, const Visit& visit) {
    std::vector<int> at(size, 0);
    for (std::size_t i = 0; i < size;) {
      visit(at);
      for (i = 0; i < size && ++at[i] == places; ++i) at[i] = 0;
    }
  }

  /// The others on a grid, and then from the best one.
  void search_grid() {
    std::vector<std::size_t> which;
    for (std::size_t j = 0; j < rest_.size(); ++j)
      if (rest_[j]) which.push_back(j);
    if (which.empty()) return;
    const int count = design_settings.grid[std::min<std::size_t>(which.size(), 5) - 1];
    each_place(which.size(), count, [&](const std::vector<int>& place) {
      Values at = best_.values;
      for (std::size_t i = 0; i < which.size(); ++i)
        at[which[i]] = choice(which[i]).from +
                       place[i] * (choice(which[i]).to - choice(which[i]).from) / (count - 1);
      if (work_ > 0) search_at(at);
    });
    climb(which, 1.0 / (count - 1));
    for (std::size_t i = 0; which.size() > 1 && i < which.size(); ++i)
      climb({which[i]}, 1.0 / (count - 1));
  }

  template <class Rooms> static double least(const Rooms& rooms) {
    return *std::min_element(rooms.begin(), rooms.end());
  }

  /// From the best one along what the conditions' slopes promise, in ever smaller steps: where two
  /// of them meet, no choice alone leads on.
  void climb(const std::vector<std::size_t>& which, double step) {
    using Rooms = std::array<double, 5>; // of the conditions, and of the grip before the push
    const int ways = design_settings.ways[which.size() > 4 ? 1 : 0]; // from - step to step
    for (int k = 0; k < design_settings.halvings && work_ > 0;) {
      const Best before = best_;
      const auto moved = [&](const Values& by) {
        Values at = before.values;
        for (std::size_t i = 0; i < which.size(); ++i) {
          const DesignSpace::Choice& c = choice(which[i]);
          at[which[i]] = std::clamp(at[which[i]] + by[i] * step * (c.to - c.from), c.from, c.to);
        }
        return at;
      };
      const auto rooms = [&](const Values& by) {
        const Values at = moved(by);
        const DesignModel* const model = possible_model_at(at);
        Rooms there{};
        if (model == nullptr) return there;
        const std::array<double, 4> sticks = model->rooms(at, wanted());
        std::copy(sticks.begin(), sticks.end(), there.begin());
        there[4] = is_held_back_ ? model->hold_room(at, wanted()) : design_settings.enough;
        return there;
      };
      const Values here(which.size(), 0);
      const Rooms middle = rooms(here);
      std::vector<Rooms> slopes(which.size());
      for (std::size_t i = 0; i < which.size(); ++i) {
        Values low = here, high = here;
        low[i] = -1;
        high[i] = 1;
        const Rooms a = rooms(low), b = rooms(high);
        const double width = (moved(high)[which[i]] - moved(low)[which[i]]) /
                             (step * (choice(which[i]).to - choice(which[i]).from));
        for (std::size_t c = 0; c < middle.size(); ++c) slopes[i][c] = (b[c] - a[c]) / width;
      }
      Values by = here, best_way = here;
      double most = -std::numeric_limits<double>::infinity();
      each_place(which.size(), ways, [&](const std::vector<int>& place) {
        Rooms there = middle;
        for (std::size_t i = 0; i < which.size(); ++i) {
          by[i] = 2.0 * place[i] / (ways - 1) - 1;
          for (std::size_t c = 0; c < middle.size(); ++c) there[c] += slopes[i][c] * by[i];
        }
        if (!(least(there) > most) || moved(by) == before.values) return;
        most = least(there);
        best_way = by;
      });
      search_at(moved(best_way));
      if (best_.margin > before.margin || (best_.margin < 0 && best_.room > before.room)) continue;
      step /= 2;
      ++k;
    }
  }

  /// What makes no difference stays as it is, or goes to an end. Each place has a model of its own:
  /// what holds there need not hold over a whole range.
  void settle(const std::vector<bool>& chosen) {
    open_.assign(chosen.size(), false);
    for (std::size_t k = 0; k < 2 * chosen.size() && best_.margin > 0; ++k) {
      const std::size_t j = k % chosen.size(); // twice: one may wait for another
      for (const double end : {choice(j).given, choice(j).from, choice(j).to}) {
        if (!chosen[j] || end < choice(j).from || end > choice(j).to) continue;
        Values at = best_.values;
        at[j] = end;
        const DesignModel* const model = possible_model_at(at);
        const double margin = model != nullptr ? model->margin(at) : 0;
        if (margin < best_.margin * (1 - design_settings.better)) continue;
        best_ = {at, margin, 0};
        break;
      }
    }
  }

  const DesignSpace& space_;
  std::vector<bool> linear_, open_, rest_, model_open_;
  std::unique_ptr<DesignModel> model_;
  Best best_;
  double work_ = 0, reserve_ = 0;
  bool is_held_back_ = false; ///< something better would stick, if the grip held the load
};

std::string binding_words(const DesignSpace& space, const Values& values, const BoxAnswer& there) {
  if (!there.margin || there.is_indifferent) return there.reason;
  const double beyond = *there.margin * (1 + design_settings.beyond) + design_settings.beyond;
  return beyond < 1 ? judge_push(space.box_at(values, beyond)).reason : "";
}

/// What is odd about the scene as chosen, and was not about the given one.
std::vector<SceneDoubt> doubts_as_chosen(const SceneFile& given, const std::string& chosen) {
  const std::vector<SceneDoubt> before = check_scene(given);
  std::vector<SceneDoubt> doubts;
  for (SceneDoubt& found : check_scene(parse_scene(chosen, given.lines.file))) {
    const bool is_old = std::any_of(before.begin(), before.end(), [&](const SceneDoubt& old) {
      return old.doubt == found.doubt;
    });
    if (is_old || found.doubt == Doubt::middle) continue;
    found.text = "as chosen, " + found.text;
    doubts.push_back(std::move(found));
  }
  return doubts;
}

} // namespace

DesignReport find_design(const VariedScene& scene, const std::vector<std::string>& choices,
                         const std::vector<std::string>& tolerances, bool with_curves) {
  const DesignSpace space(scene, choices, tolerances);
  DesignReport report;
  report.given = judge_push(space.box_at(space.given()));
  report.asks_ranges = space.asks_ranges();
  Designer designer(space);
  const std::size_t count = space.choices().size();
  std::vector<Values> alone;
  for (std::size_t j = 0; count > 1 && j < count; ++j) {
    std::vector<bool> one(count, false);
    one[j] = true;
    const double share = (1 - design_settings.joint) / static_cast<double>(count);
    alone.push_back(designer.find(one, share).values);
  }
  const std::vector<bool> all(count, true);
  const Designer::Best best = designer.find(all, design_settings.joint, alone);
  if (count == 1) alone.push_back(best.values);
  report.chosen = judge_push(space.box_at(best.values));
  report.binds = binding_words(space, best.values, report.chosen);
  report.scene = space.scene_at(best.values).text_at({}, {});
  report.doubts = doubts_as_chosen(scene.as_given(), report.scene);
  for (std::size_t j = 0; j < count; ++j) {
    const DesignSpace::Choice& choice = space.choices()[j];
    const Parameter& first = choice.parameters[0];
    report.choices.push_back({choice.path,
                              choice.slopes.empty() ? parameter_label(first) : choice.path + ", m",
                              choice.from,
                              choice.to,
                              choice.given,
                              best.values[j],
                              alone[j][j],
                              judge_push(space.box_at(alone[j])).margin,
                              {},
                              {}});
    if (with_curves) designer.draw(best.values, j, report.choices.back());
  }
  return report;
}

} // namespace lcpush::desktop
