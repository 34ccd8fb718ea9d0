// Places labels one after the other where they cover nothing placed before.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "draw/markup.hpp"
#include "text/utf8.hpp"

namespace lcpush::desktop {

class LabelPlaces {
public:
  static constexpr double line_height = 16;

  LabelPlaces(double width, double height) : width_(width), height_(height) {}

  /// Something drawn that labels should stay clear of, the more the heavier.
  void block(const Frame& frame, double weight) { taken_.push_back({frame, weight}); }
  /// A square that reaches this far to each side.
  void block_around(const Pixel& at, double reach, double weight) {
    block({at.x() - reach, at.y() - reach, at.x() + reach, at.y() + reach}, weight);
  }
  void block_line(const Pixel& from, const Pixel& to, double weight) {
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from).norm() / 8)));
    for (int k = 0; k < pieces; ++k) {
      const Pixel a = from + (to - from) * k / pieces, b = from + (to - from) * (k + 1) / pieces;
      block({std::min(a.x(), b.x()) - 2, std::min(a.y(), b.y()) - 2, std::max(a.x(), b.x()) + 2,
             std::max(a.y(), b.y()) + 2},
            weight);
    }
  }

  /// Where lines of text near `at` cover least. `away`: the side on which they should lie, or zero.
  /// Cost: O(what is blocked). The frame is blocked for later labels.
  Frame place(const std::vector<std::string>& lines, const Pixel& at, const Pixel& away) {
    double width = 0;
    for (const std::string& line : lines)
      width = std::max(width, width_of(line, &line == lines.data()) + 6);
    const double height = line_height * static_cast<double>(lines.size()) + 2;
    Frame best{2, 2, 2 + width, 2 + height};
    double least = std::numeric_limits<double>::infinity();
    for (double radius = 12; radius <= 202; radius += 10)
      for (int k = 0; k < 24; ++k) {
        const double angle = 2 * 3.14159265358979 * (k + 0.5) / 24;
        const Pixel offset(std::cos(angle) * (radius + width / 2),
                           std::sin(angle) * (radius + height / 2));
        const Pixel center = at + offset;
        const Frame frame{center.x() - width / 2, center.y() - height / 2, center.x() + width / 2,
                          center.y() + height / 2};
        if (frame.left < 2 || frame.top < 2 || frame.right > width_ - 2 ||
            frame.bottom > height_ - 2)
          continue;
        double cost = 1.2 * radius + 4 * std::abs(std::sin(angle)) +
                      12 * std::max(0.0, -away.dot(offset) - 40);
        for (const Taken& other : taken_)
          if (const double area = overlap(frame, other.frame); area > 0)
            cost += (area + 20) * other.weight;
        if (cost < least) {
          least = cost;
          best = frame;
        }
      }
    cost_ += std::min(least, 1e9);
    block(best, 20);
    return best;
  }

  /// What the labels placed so far cover, and how far away they stand.
  double cost() const { return cost_; }

private:
  struct Taken {
    Frame frame;
    double weight;
  };
  double width_, height_, cost_ = 0;
  std::vector<Taken> taken_;

  /// Of 13.5 px text in a wide face; fonts of the reader's own are narrower.
  static double width_of(const std::string& text, bool is_bold) {
    double letters = 0;
    for (const char c : text)
      if (!continues_character(c)) ++letters;
    return (is_bold ? 9 : 7.9) * letters;
  }

  static double overlap(const Frame& a, const Frame& b) {
    const double across = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double down = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
    return across > 0 && down > 0 ? across * down : 0;
  }
};

} // namespace lcpush::desktop
