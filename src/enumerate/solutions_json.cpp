#include <algorithm>
#include <set>

#include "formats/json_writer.hpp"
#include "lcpush/desktop/all_solutions.hpp"

namespace lcpush::desktop {
namespace {

using Sets = std::vector<SolutionSet>::const_iterator;

class Writer {
public:
  Writer(const AllSolutions& found, const AllWording& wording) : found_(found), wording_(wording) {}

  std::string text() {
    auto set = found_.sets.begin();
    const auto end = found_.sets.end();
    json_.begin_object().key(wording_.rows > 0 ? "equilibria" : "solutions").begin_array();
    for (; set != end && set->component < 0; ++set) point(set->vertices[0], true);
    json_.end_array().key("components").begin_array();
    while (set != end) {
      const auto next = std::find_if(
          set, end, [&set](const SolutionSet& other) { return other.component != set->component; });
      component(set, next);
      set = next;
    }
    json_.end_array().member("complete", found_.complete()).member("cases", found_.cases);
    json_.member("most", when(found_.most > 0, found_.most));
    json_.member("stopped", unless_empty(std::string(stop_text(found_.stop))));
    return json_.end_object().text();
  }

private:
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
  void member(const char* key, const ExactVector& numbers) {
    json_.key(key);
    list(numbers);
  }

  /// A component's vertex is its z alone; of a game it is all.
  void point(Index number, bool has_w) {
    const auto& [z, w] = found_.points[static_cast<std::size_t>(number)];
    const auto middle = z.begin() + wording_.rows;
    if (wording_.rows == 0 && !has_w) return list(z);
    json_.begin_object();
    if (wording_.rows > 0) member("row", {z.begin(), middle});
    member(wording_.rows > 0 ? "column" : "z", {middle, z.end()});
    member(wording_.rows > 0 ? "payoffs" : "w", w);
    json_.end_object();
  }

  /// Its cells count their vertices and rays from 0, in the component's order.
  void component(Sets begin, Sets end) {
    std::set<Index> vertices, rays;
    for (auto set = begin; set != end; ++set) {
      vertices.insert(set->vertices.begin(), set->vertices.end());
      rays.insert(set->rays.begin(), set->rays.end());
    }
    const auto places = [](const std::vector<Index>& some, const std::set<Index>& among) {
      std::vector<Index> found;
      for (const Index k : some) found.push_back(std::distance(among.begin(), among.find(k)));
      return found;
    };
    json_.begin_object();
    json_.list("vertices", vertices, [this](Index k) { point(k, false); });
    json_.list("rays", rays, [this](Index k) { list(found_.rays[static_cast<std::size_t>(k)]); });
    json_.objects("cells", std::vector<SolutionSet>(begin, end), [&](const SolutionSet& set) {
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
