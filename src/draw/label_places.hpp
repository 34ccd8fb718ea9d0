// Places labels one after the other where they cover nothing placed before.
#pragma once

#include <string>
#include <vector>

#include "draw/markup.hpp"

namespace lcpush::desktop {

class LabelPlaces {
public:
  static constexpr double line_height = 16;

  LabelPlaces(double width, double height) : width_(width), height_(height) {}

  /// Something drawn that labels should stay clear of, the more the heavier.
  void block(const Frame& frame, double weight);
  /// A square that reaches this far to each side.
  void block_around(const Pixel& at, double reach, double weight);
  void block_line(const Pixel& from, const Pixel& to, double weight);

  /// Where lines of text near `at` cover least. `away`: the side on which they should lie, or zero.
  /// Cost: O(what is blocked). The frame is blocked for later labels.
  Frame place(const std::vector<std::string>& lines, const Pixel& at, const Pixel& away);

  /// What the labels placed so far cover, and how far away they stand.
  double cost() const { return cost_; }

private:
  struct Taken {
    Frame frame;
    double weight;
  };
  double width_, height_, cost_ = 0;
  std::vector<Taken> taken_;
};

} // namespace lcpush::desktop
