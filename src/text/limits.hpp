// How much is too much: what is refused, or left out, beyond these sizes, and why.
#pragma once

#include <cstddef>

#include "lcpush/types.hpp"

namespace lcpush::desktop::limits {

// What is read. No honest file comes near; the others must not use up the machine.
constexpr std::size_t scene_bytes = std::size_t{64} << 20U;
constexpr std::size_t matrix_bytes = std::size_t{1} << 28U;   // of a certified problem
constexpr std::size_t answer_bytes = std::size_t{256} << 20U; // full precision, all contacts
constexpr std::size_t toml_items = 1'000'000;                 // tables and values
constexpr int toml_list_depth = 8, json_depth = 100;          // the readers call themselves
constexpr std::size_t fraction_characters = 10000;
constexpr int fraction_exponent = 1000; // 1e1000 has a thousand digits, and products have more
constexpr std::size_t scene_points = 100000, scene_bodies = 1000;
constexpr Index patch_points = 10000; // each sees every other one of its patch: [T.6]

// No command takes more than a gigabyte, about: what would is refused before it is begun.
constexpr double memory = 1e9;             // bytes
constexpr Index unknowns_held = 1'500'000; // 510 bytes each
constexpr Index unknowns_matrix = 10'000;  // 8 bytes an entry
constexpr Index unknowns_device = 16'383;  // as lcpush.h says
constexpr Index unknowns_exported = 4'000; // 63 bytes an entry, most of them of text
constexpr double bytes_a_sample = 2400, bytes_a_sampled_point = 40; // of a sweep, text included

// Unknowns up to which a question is asked; beyond, its answer would take minutes.
constexpr Index unknowns_dense = 600; // pivots on the whole dictionary, where structured ones fail
constexpr Index unknowns_searched = 2000; // other answers, each as long as the first: three
                                          // covers
constexpr Index unknowns_pivoted_in_search = 8'000'000; // pivots, each of so many: about 0.5 s
constexpr Index scalars_existence = 50'000'000;         // 400 MB: hundreds of actuators that drag
constexpr Index unknowns_holding = 2000;                // every factor that is asked is a push
constexpr Index unknowns_grip = 600;       // every factor that is asked costs several pushes
constexpr Index unknowns_remedied = 1000;  // a solve for each change that might free a jam
constexpr Index unknowns_spread = 2000;    // hundreds of linear programs
constexpr Index unknowns_refined = 2000;   // one dense system
constexpr Index unknowns_stationary = 400; // one quadratic program's conditions
constexpr Index unknowns_traced = 1000;    // every pivot keeps its ratios; the page draws every row
constexpr Index unknowns_exact = 300;      // fractions grow with every pivot
constexpr Index unknowns_certified = 3000; // the basis in doubles comes from the dense dictionary
constexpr Index unknowns_proved = 60'000;  // fractions of every facet; 2 s
constexpr Index rows_certified = 1000;     // of a raw problem: a dense matrix of fractions

// Points and choices up to which sets are enumerated: the work doubles with each.
constexpr Index points_told_by_mode = 12; // 3^12 combinations; a person reads no more
constexpr std::size_t generators_enumerated = 6, pulls_enumerated = 8;

// What a command may be asked for.
constexpr Index covers = 1000000;
constexpr Index sweep_steps = 1000000, map_steps = 1000, report_steps = 10000;
constexpr std::size_t curves = 16; // more cannot be told apart
constexpr Index motion_solves = 1'000'000, motion_frames = 10'001;

} // namespace lcpush::desktop::limits
