// lcpush, the core in one include: no heap, no exceptions, no iostream. The pipeline:
//
//   Scene            what touches what, in SI units                      mechanics/scene.hpp
//     | assemble     one function a law of the paper                     mechanics/laws.hpp
//   FactoredProblem  w = M z + q,  0 <= z _|_ w >= 0                      lcp/problem.hpp
//     | solve        Lemke's pivots, under a pressure law                lcp/lemke.hpp
//     |              the same with O(n) a pivot                          lcp/structured_lemke.hpp
//     |                                                                  mechanics/pressure.hpp
//   z
//     | read_answer  forces, motion, contact modes, in SI units          mechanics/read_answer.hpp
//   Answer
//     | check        the laws again, by code that shares nothing above   mechanics/check.hpp
//   Residuals
//
// All memory is the caller's: make_workspace cuts it from one block, push_bytes says how long
// (mechanics/workspace.hpp). Files, reports and the like are in host/.
#pragma once

#include "lcpush/lcp/lemke.hpp"
#include "lcpush/mechanics/breaking.hpp"
#include "lcpush/mechanics/check.hpp"
#include "lcpush/mechanics/holding.hpp"
#include "lcpush/mechanics/motion.hpp"
#include "lcpush/mechanics/predicted_modes.hpp"
#include "lcpush/mechanics/pressure.hpp"
#include "lcpush/mechanics/read_answer.hpp"
#include "lcpush/mechanics/uniqueness.hpp"
#include "lcpush/mechanics/workspace.hpp"
#include "lcpush/status.hpp"
