// The numbers by which somebody else's answers and motions are judged.
#pragma once

#include <algorithm>

#include "lcpush/types.hpp"

namespace lcpush::desktop {

struct VerifySettings {
  static constexpr Index fewest_facets = 4, most_facets = 256; ///< of a pyramid, as in a scene
  // Answers. Parts of the largest number involved.
  static constexpr double dependent = 1e-10;       ///< least squares leave such a direction open
  static constexpr double basis_dependent = 1e-11; ///< the same in the basis that z names, whose
                                                   ///< columns differ by the stiffness of pads
  /// Of the tolerance: what is slower does not move. A slow slip has one direction of friction, and
  /// in few digits nothing is at rest: the first that lets all laws hold.
  static constexpr double moves[] = {1e-4, 1e-2, 1};
  static constexpr int cone_rounds = 30; ///< of fits, each with a generator more a point: 15 were
                                         ///< the most that the shipped scenes took
  static constexpr double cone_gain = 1e-6; ///< of what is left: a round that takes off less is the
                                            ///< last, for the forces that are wrong stay so
  static constexpr double fits = 1e-3;      ///< of the tolerance: so well forces are fitted
  static constexpr double laws_first = 1e4; ///< weight of laws beside given sums: what these are
                                            ///< off by leaves 1e-8 of it in the laws
  static constexpr double of_given = 1e-7;  ///< so that a law's row below this part of a wrong
                                            ///< given one is the fit's, and not told
  static constexpr double own_first = 10;   ///< the error beside lcpush's own motion is told unless
                                            ///< the forces' own motion has so many times less
  static constexpr double kilogram_force = 9.80665, thousand = 1e3; ///< N; units that are mistaken
  static constexpr double of_asked = 0.05; ///< of a push or a load: what is off by less is measured
                                           ///< beside all forces, as solvers end
  static constexpr double nearly = 100;    ///< tolerances: what is off by less is no mistaken unit
  static constexpr double turned = 1e-2; ///< of the error: less is left by a right change of signs,
                                         ///< and is no imbalance to tell
  static constexpr double same_place = 1e-5;    ///< of the scene's size: six digits, which round
                                                ///< each of three numbers by up to 5e-6
  static constexpr double same_answer = 1e-6;   ///< least tolerance of "the same answer": two
                                                ///< solvers' answers in double agree to 1e-8
  static constexpr double times_tolerance = 10; ///< an answer off by the tolerance may lie so
                                                ///< many times it away from the exact one
  static constexpr double stationary = 0.01;    ///< descent takes off less: an optimiser stops
  // Motions: files are printed with six digits or more, single precision among them.
  static constexpr double rotation = 4e-4;  ///< off orthonormal: nine numbers in four digits
  static constexpr int rotation_rounds = 3; ///< each squares what a rotation is off
  static constexpr double interval = 1e-3;  ///< of a step: times printed with few digits
  static constexpr double digits = 1e-9;    ///< of the object's size: how far digits of places go
  static constexpr double coarsest_digit = 1e-3, finest_digit = 1e-9; ///< m, of places as printed
  static constexpr double same_speed = 1e-9; ///< of a difference: rounding, no other worst step
  static constexpr double at_rest = 1e-3;    ///< of the motion judged: slower, the laws hold it
  static constexpr double face_rim = 1e-4;   ///< of the object's size: a place beside a face that
                                             ///< digits and drift explain
  static constexpr double pushed_out = 5e-4; ///< of the object's size: a step of the laws still
                                             ///< pushes a point out that is so deep
  static constexpr double stays = 1e-7;      ///< of the object's size: places in single precision
  static constexpr double start = 1e-3;      ///< of the object's size, and of a turn: a simulator's
                                             ///< first step goes less far
  static constexpr double first_frame = 1.5; ///< intervals from 0: a first frame after a step
  /// Of each step's change: its own velocity is off by less.
  static constexpr double of_change = 0.125;
  static constexpr double of_landing = 0.03; ///< the same over two, which a landing lies within
  static constexpr double seldom = 0.5; ///< s between frames: longer ones are those of milliseconds
  /// Frames of a motion whose changes of velocity are followed, each with two steps of 0.1 ms; and
  /// how many windows, of so many frames or more, they fill without overlap: in a quarter of it an
  /// acceleration that is wrong by 4 % changes the velocity by the hundredth that is allowed; what
  /// goes on all the time adds up in the whole.
  static constexpr std::size_t change_frames = 200, change_windows[] = {4, 1},
                               least_change_frames = 8;
  static constexpr int change_parts[] = {4, 16}; ///< of an interval, where one step misses
  static constexpr double far_frame = 10; ///< sizes of the object from frame to frame, as of places
                                          ///< in millimetres
  static constexpr double far_turn = 0.5; ///< rad, between two frames
  // How finely a step between two frames is repeated, doubling its parts.
  static constexpr double most_parts = 64;          ///< simulators make up to 50 steps a frame
  static constexpr int wrong_frames = 8;            ///< then one part a frame: its verdict stands
  static constexpr double most_stated_parts = 1024; ///< where the file says how short its steps are
  static constexpr double most_jump_parts = 256; ///< where it jumps: a moment to 1/256 of a frame
  static constexpr double fine_parts = 32;       ///< leave 1/64 of what a frame's step changes open
  static constexpr double settling_parts = 4; ///< from then on twice as many say how many will do
  static constexpr double jump = 0.1;         ///< of the fastest speed, between two frames
  static constexpr double limit = 2; ///< of the way to twice as many steps, whose errors are half
  static constexpr double nearer = 0.9;   ///< finer parts count if they come so much nearer
  static constexpr int part_halvings = 8; ///< of a part that has no answer
  // Forces: the unit of a frame whose largest force or speed is next to nothing, as parts of what
  // else there is.
  static constexpr double least_force = 1e-200; ///< N: nothing over it is nothing
  static constexpr double of_loads = 1e-6, of_motion = 1e-9, of_speeds = 1e-3;
  static constexpr double gap = 1e-4; ///< of the object's size: with less, nobody's geometry agrees
  static constexpr double same_slip = 1e-3;    ///< of a slip: a body's contacts all slip so
  static constexpr double along_normal = 1e-6; ///< of a drive: what is across is rounding
  static constexpr double closing_slope =
      1e-3;                               ///< of a drive that hardly closes: its place is open
  static constexpr double closed = 1e-12; ///< of the object's size
  static constexpr int closings = 20;     ///< tries: another point may touch first
  // Words.
  static constexpr double in_metres = 1e-2, in_millimetres = 1e-5; ///< m/s: from there on
  static constexpr double negligible = 1e-9;   ///< scaled or SI: less only says how rounding went
  static constexpr double percent = 100;       ///< of a whole
  static constexpr int told_digits = 3;        ///< of a number: as answers are printed
  static constexpr int printed_digits = 5;     ///< the most that people print: more are not rounded
  static constexpr double decade = 10;         ///< a tolerance is proposed as a power of it
  static constexpr double rounded = 5e-3;      ///< of the largest number: half the last of 3 digits
  static constexpr std::size_t told_names = 8; ///< of a scene's, in a sentence
  static constexpr double solves = 1e-8; ///< scaled: what is left of a basis that is a solution's
};

/// The part of the largest number by which an answer may differ from another and be the same.
inline double close_by(double tolerance) {
  return std::max(VerifySettings::same_answer, VerifySettings::times_tolerance * tolerance);
}

} // namespace lcpush::desktop
