// lcpush, the core in one include: no heap, no exceptions, no iostream. The pipeline:
//
//   Scene            what touches what, in SI units                      mechanics/model/scene.hpp
//     | assemble     one function a law of the paper                     mechanics/model/laws.hpp
//   FactoredProblem  w = M z + q,  0 <= z _|_ w >= 0                      lcp/problem.hpp
//     | solve        Lemke's pivots                                      lcp/pivots/lemke.hpp
//     |              the same with O(n) a pivot               lcp/pivots/structured_lemke.hpp
//     |              either under a pressure law                  mechanics/solve/pressure.hpp
//   z
//     | read_answer  forces, motion, modes, in SI units           mechanics/model/read_answer.hpp
//   Answer
//     | check        the laws again, by code that shares nothing above   mechanics/model/check.hpp
//   Residuals
//
// All memory is the caller's: make_workspace cuts it from one block, push_bytes says how long
// (mechanics/solve/workspace.hpp). Files, reports and the like are in desktop/.
#pragma once

#include "lcpush/lcp/pivots/lemke.hpp"
#include "lcpush/mechanics/model/check.hpp"
#include "lcpush/mechanics/model/read_answer.hpp"
#include "lcpush/mechanics/model/validate.hpp"
#include "lcpush/mechanics/solve/breaking.hpp"
#include "lcpush/mechanics/solve/predicted_modes.hpp"
#include "lcpush/mechanics/solve/pressure.hpp"
#include "lcpush/mechanics/solve/step.hpp"
#include "lcpush/mechanics/solve/workspace.hpp"
#include "lcpush/mechanics/study/motion.hpp"
#include "lcpush/mechanics/study/study_memory.hpp"
#include "lcpush/mechanics/study/uniqueness.hpp"
#include "lcpush/status.hpp"
