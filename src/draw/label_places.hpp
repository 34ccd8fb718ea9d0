// Places labels one after the other where they cover nothing placed before.
#pragma once

#include <string>
#include <vector>

#include "draw/markup.hpp"

namespace lcpush::desktop {

/// Words beside what they name.
struct Label {
  std::vector<std::string> lines; ///< the first ones stand out
  Pixel at;                       ///< near which they stand
  Pixel away;                     ///< on which side, or zero
  Pixel target;                   ///< what they name: a leader starts there if they stand far off
  std::size_t strong_lines = 1;
};

class LabelPlaces {
public:
  static constexpr double line_height = 16;

  LabelPlaces(double width, double height) : width_(width), height_(height) {}

  /// Something drawn that labels should stay clear of, the more the heavier.
  void block(const Frame& frame, double weight);
  /// A square that reaches this far to each side.
  void block_around(const Pixel& at, double reach, double weight);
  void block_line(const Pixel& from, const Pixel& to, double weight);
  /// A line that runs on beyond the picture.
  void block_endless_line(const Pixel& from, const Pixel& to, double weight);
  /// What labels must not touch while there is any other place: edges, words.
  void bar(const Frame& frame);
  void bar_edges(const std::vector<Pixel>& outline);

  /// Where the label's lines cover least. Cost: O(what is blocked). The frame is barred, and its
  /// leader, for later labels.
  Frame place(const Label& label);

  /// The part of the picture's height that is used by what is blocked and by these labels, with
  /// `below` pixels below them. Nothing used lies in the `corner` at its top left.
  Frame used(const std::vector<Frame>& labels, const Pixel& corner, double below) const;

  /// What the labels placed so far cover, and how far away they stand.
  double cost() const { return cost_; }

private:
  struct Taken {
    Frame frame;
    double weight;
  };
  double width_, height_, cost_ = 0;
  std::vector<Taken> taken_;
  std::vector<Frame> drawn_; // of those, what is part of the picture
  std::vector<Frame> words_; // of the labels placed
  std::vector<Frame> edges_; // those barred, piece by piece

  void block_pieces(Pixel from, Pixel to, double weight, std::vector<Frame>& pieces);
  double cost_of(const Frame& frame, const Pixel& target) const;
};

/// Where a label's leader ends: the place of its frame that is next to `target`.
Pixel leader_end(const Frame& frame, const Pixel& target);

/// The labels in the order that gives them the best places, of those that let each be the first,
/// forwards and backwards.
std::vector<Frame> placed_labels(const LabelPlaces& places, const std::vector<Label>& labels);
/// Them in their frames, with their leaders, each with a dot on what it names.
std::string label_elements(const std::vector<Label>& labels, const std::vector<Frame>& frames);

} // namespace lcpush::desktop
