#include "draw/label_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <tuple>

#include "draw/view.hpp"
#include "text/utf8.hpp"

namespace lcpush::desktop {
namespace {

constexpr double picture_margin = 6, clearance = 3;
constexpr double barred = 1000;   // outweighs every way around
constexpr double along_edge = 8;  // a pixel of a leader that cannot be told from an edge
constexpr double leader_gap = 14; // a label that stands nearer needs no leader

/// Of 13.5 px text in a wide face; fonts of the reader's own are narrower.
double width_of(const std::string& text, bool is_bold) {
  constexpr std::string_view thin = "ijlI.,:;'|", narrow = "frt ()-", wide = "mwMW";
  double width = 0;
  for (const char c : text) {
    if (continues_character(c)) continue;
    const auto is_in = [c](std::string_view set) { return set.find(c) != std::string_view::npos; };
    const bool is_capital = c >= 'A' && c <= 'Z';
    width += is_in(thin) ? 4.4 : is_in(narrow) ? 5.5 : is_in(wide) ? 13.2 : is_capital ? 10 : 8.7;
  }
  return (is_bold ? 1.13 : 1) * width;
}

Pixel size_of(const Label& label) {
  double width = 0;
  for (std::size_t k = 0; k < label.lines.size(); ++k)
    width = std::max(width, width_of(label.lines[k], k < label.strong_lines) + 6);
  return {width, LabelPlaces::line_height * static_cast<double>(label.lines.size()) + 2};
}

double overlap(const Frame& a, const Frame& b) {
  const double across = std::min(a.right, b.right) - std::max(a.left, b.left);
  const double down = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
  return across > 0 && down > 0 ? across * down : 0;
}

/// What of a line lies in the frame; of a line that is no longer than any picture needs, all of it.
/// An arrow of friction 1e7 is ten thousand kilometres long: that many pieces fill no memory here.
/// False: nothing.
bool clip(const Frame& frame, Pixel& from, Pixel& to) {
  constexpr double usual = 20000; // pixels
  if ((to - from).norm() <= usual) return true;
  const auto inside = clipped_line(frame, from, to - from, 0, 1);
  if (inside) std::tie(from, to) = *inside;
  return inside.has_value();
}

/// How many pixels of the line lie in the frame, in steps of 4.
double length_inside(const Frame& frame, Pixel from, Pixel to) {
  if (std::max(from.x(), to.x()) < frame.left || std::min(from.x(), to.x()) > frame.right ||
      std::max(from.y(), to.y()) < frame.top || std::min(from.y(), to.y()) > frame.bottom)
    return 0;
  if (!clip(frame, from, to)) return 0;
  const int pieces = std::max(1, static_cast<int>((to - from).norm() / 4));
  double inside = 0;
  for (int k = 0; k <= pieces; ++k) {
    const Pixel at = from + (to - from) * k / pieces;
    if (at.x() > frame.left && at.x() < frame.right && at.y() > frame.top && at.y() < frame.bottom)
      inside += 4;
  }
  return inside;
}

std::vector<Frame> placed_in_order(LabelPlaces places, const std::vector<Label>& labels,
                                   const std::vector<std::size_t>& order, double& cost) {
  std::vector<Frame> frames(labels.size());
  for (const std::size_t k : order) frames[k] = places.place(labels[k]);
  cost = places.cost();
  return frames;
}

} // namespace

void LabelPlaces::block_around(const Pixel& at, double reach, double weight) {
  block({at.x() - reach, at.y() - reach, at.x() + reach, at.y() + reach}, weight);
}

void LabelPlaces::block(const Frame& frame, double weight) {
  taken_.push_back({frame, weight});
  drawn_.push_back(frame);
}

void LabelPlaces::block_pieces(Pixel from, Pixel to, double weight, std::vector<Frame>& pieces) {
  if (!clip({-width_, -height_, 2 * width_, 2 * height_}, from, to)) return;
  const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / 8)));
  for (int k = 0; k < count; ++k) {
    const Pixel a = from + (to - from) * k / count, b = from + (to - from) * (k + 1) / count;
    pieces.push_back({std::min(a.x(), b.x()) - 2, std::min(a.y(), b.y()) - 2,
                      std::max(a.x(), b.x()) + 2, std::max(a.y(), b.y()) + 2});
    taken_.push_back({pieces.back(), weight});
  }
}

void LabelPlaces::block_line(const Pixel& from, const Pixel& to, double weight) {
  block_pieces(from, to, weight, drawn_);
}

void LabelPlaces::block_endless_line(const Pixel& from, const Pixel& to, double weight) {
  std::vector<Frame> pieces;
  block_pieces(from, to, weight, pieces);
}

void LabelPlaces::bar(const Frame& frame) {
  taken_.push_back({{frame.left - clearance, frame.top - clearance, frame.right + clearance,
                     frame.bottom + clearance},
                    barred});
}

void LabelPlaces::bar_edges(const std::vector<Pixel>& outline) {
  const std::size_t first = drawn_.size();
  for (std::size_t k = 0; k < outline.size(); ++k)
    block_line(outline[k], outline[(k + 1) % outline.size()], barred);
  edges_.insert(edges_.end(), drawn_.begin() + static_cast<std::ptrdiff_t>(first), drawn_.end());
}

Frame LabelPlaces::used(const std::vector<Frame>& labels, const Pixel& corner, double below) const {
  double top = height_, bottom = 0;
  for (const auto* frames : {&drawn_, &labels})
    for (const Frame& frame : *frames) {
      top = std::min(top, frame.top - (frame.left < corner.x() ? corner.y() : picture_margin));
      bottom = std::max(bottom, frame.bottom + below);
    }
  top = std::max(0.0, std::floor(top));
  return {0, top, width_, std::clamp(std::ceil(bottom), top + corner.y() + below, height_)};
}

double LabelPlaces::cost_of(const Frame& frame, const Pixel& target) const {
  double cost = 0;
  for (const Taken& other : taken_)
    if (const double area = overlap(frame, other.frame); area > 0)
      cost += (area + 20) * other.weight;
  const Pixel end = leader_end(frame, target);
  for (const Frame& word : words_) cost += barred * length_inside(word, end, target);
  for (const Frame& edge : edges_) cost += along_edge * length_inside(edge, end, target);
  return cost;
}

Frame LabelPlaces::place(const Label& label) {
  const Pixel size = size_of(label);
  Frame best{picture_margin, picture_margin, picture_margin + size.x(), picture_margin + size.y()};
  double least = std::numeric_limits<double>::infinity();
  for (double radius = 12; radius <= 202; radius += 10)
    for (int k = 0; k < 24; ++k) {
      const double angle = 2 * 3.14159265358979 * (k + 0.5) / 24;
      const Pixel offset(std::cos(angle) * (radius + size.x() / 2),
                         std::sin(angle) * (radius + size.y() / 2));
      const Pixel corner = label.at + offset - size / 2;
      const Frame frame{corner.x(), corner.y(), corner.x() + size.x(), corner.y() + size.y()};
      if (frame.left < picture_margin || frame.top < picture_margin ||
          frame.right > width_ - picture_margin || frame.bottom > height_ - picture_margin)
        continue;
      const double cost = 1.2 * radius + 4 * std::abs(std::sin(angle)) +
                          12 * std::max(0.0, -label.away.dot(offset) - 40) +
                          cost_of(frame, label.target);
      if (cost < least) {
        least = cost;
        best = frame;
      }
    }
  cost_ += std::min(least, 1e9);
  bar(best);
  words_.push_back(best);
  block_line(leader_end(best, label.target), label.target, 20);
  return best;
}

Pixel leader_end(const Frame& frame, const Pixel& target) {
  return {std::clamp(target.x(), frame.left, frame.right),
          std::clamp(target.y(), frame.top, frame.bottom)};
}

std::vector<Frame> placed_labels(const LabelPlaces& places, const std::vector<Label>& labels) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < labels.size(); ++k) order.push_back(k);
  std::vector<Frame> frames;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t turn = 0; turn < 2 * labels.size(); ++turn) {
    if (turn == labels.size()) std::reverse(order.begin(), order.end());
    double cost = 0;
    std::vector<Frame> tried = placed_in_order(places, labels, order, cost);
    if (cost < least) frames = std::move(tried);
    least = std::min(least, cost);
    std::rotate(order.begin(), order.begin() + 1, order.end());
  }
  return frames;
}

std::string label_elements(const std::vector<Label>& labels, const std::vector<Frame>& frames) {
  std::string leaders, words;
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const Label& label = labels[k];
    const Pixel end = leader_end(frames[k], label.target);
    if ((end - label.target).norm() > leader_gap)
      leaders += circle_element("leader-end", label.target, 1.8) +
                 line_element("leader", label.target, end);
    // Words that are narrower than their frame stand where the leader comes from.
    const bool is_left_of = label.target.x() > frames[k].right;
    const double x = is_left_of ? frames[k].right - 2 : frames[k].left + 2;
    words += "<g class=\"words\">\n";
    for (std::size_t line = 0; line < label.lines.size(); ++line)
      words += text_element(
          line < label.strong_lines ? "label strong" : "label",
          {x, frames[k].top + (static_cast<double>(line) + 0.8) * LabelPlaces::line_height},
          label.lines[line], is_left_of ? "end" : "start");
    words += "</g>\n";
  }
  return leaders + words;
}

} // namespace lcpush::desktop
