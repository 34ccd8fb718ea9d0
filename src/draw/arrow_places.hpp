// Keeps arrows that run along each other apart.
#pragma once

#include <utility>
#include <vector>

#include "draw/markup.hpp"

namespace lcpush::desktop {

class ArrowPlaces {
public:
  void add(const Pixel& from, const Pixel& to) { drawn_.emplace_back(from, to); }

  /// Where an arrow starts that would start at `from`: moved aside as little as keeps it from lying
  /// on one of those drawn. Arrows that cross it do not move it.
  Pixel clear_start(const Pixel& from, const Pixel& to) const;

private:
  std::vector<std::pair<Pixel, Pixel>> drawn_;

  bool lies_on_one(const Pixel& from, const Pixel& to) const;
};

} // namespace lcpush::desktop
