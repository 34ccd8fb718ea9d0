#include <algorithm>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/all_solutions.hpp"

namespace lcpush::desktop {
namespace {

class Writer {
public:
  Writer(const AllSolutions& found, const AllWording& wording) : found_(found), wording_(wording) {}

  std::string text() {
    const auto& sets = found_.sets;
    const auto by_component = [](const SolutionSet& a, const SolutionSet& b) {
      return a.component < b.component;
    };
    auto set = std::upper_bound(sets.begin(), sets.end(), SolutionSet(), by_component);
    json_.begin_object();
    json_.list(
        wording_.rows > 0 ? "equilibria" : "solutions", set - sets.begin(),
        [&](std::ptrdiff_t k) { point(sets[static_cast<std::size_t>(k)].vertices[0], true); });
    json_.key("components").begin_array();
    while (set != sets.end()) {
      const auto end = std::upper_bound(set, sets.end(), *set, by_component);
      component({set, end});
      set = end;
    }
    json_.end_array();
    json_.member("complete", found_.complete()).member("cases", found_.cases);
    json_.member("most", when(found_.most > 0, found_.most));
    json_.member("stopped", unless_empty(std::string(stop_text(found_.stop))));
    return json_.end_object().text();
  }

private:
  using Numbers = std::vector<Index>;
  const AllSolutions& found_;
  const AllWording& wording_;
  JsonWriter json_;

  void list(const ExactVector& numbers) {
    std::vector<std::string> fractions;
    std::vector<double> decimals;
    for (const Rational& x : numbers)
      wording_.is_exact ? fractions.push_back(x.text()) : decimals.push_back(x.value());
    wording_.is_exact ? json_.value(fractions) : json_.value(decimals);
  }

  /// A vertex of a component is its z alone.
  void point(Index number, bool has_w) {
    const auto& [z, w] = found_.points[static_cast<std::size_t>(number)];
    const auto member = [this](const char* key, const ExactVector& numbers) {
      json_.key(key);
      list(numbers);
    };
    const auto middle = z.begin() + wording_.rows;
    if (wording_.rows == 0 && !has_w) return list(z);
    json_.begin_object();
    if (wording_.rows > 0) {
      member("row", {z.begin(), middle});
      member("column", {middle, z.end()});
    } else {
      member("z", z);
    }
    member(wording_.rows > 0 ? "payoffs" : "w", w);
    json_.end_object();
  }

  /// Its cells count their vertices and rays from 0, in the component's order.
  void component(const std::vector<SolutionSet>& sets) {
    const auto all = [&sets](Numbers SolutionSet::*of) {
      Numbers numbers;
      for (const SolutionSet& set : sets)
        numbers.insert(numbers.end(), (set.*of).begin(), (set.*of).end());
      std::sort(numbers.begin(), numbers.end());
      numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
      return numbers;
    };
    const Numbers vertices = all(&SolutionSet::vertices), rays = all(&SolutionSet::rays);
    const auto places = [](const Numbers& some, const Numbers& among) {
      Numbers found;
      for (const Index k : some)
        found.push_back(std::lower_bound(among.begin(), among.end(), k) - among.begin());
      return found;
    };
    json_.begin_object();
    json_.list("vertices", vertices, [this](Index k) { point(k, false); });
    json_.list("rays", rays, [this](Index k) { list(found_.rays[static_cast<std::size_t>(k)]); });
    json_.objects("cells", sets, [&](const SolutionSet& set) {
      json_.member("dimension", set.dimension);
      json_.member("vertices", places(set.vertices, vertices));
      json_.member("rays", places(set.rays, rays));
    });
    json_.end_object();
  }
};

} // namespace

std::string all_solutions_json(const AllSolutions& found, const AllWording& wording) {
  return Writer(found, wording).text();
}

} // namespace lcpush::desktop
