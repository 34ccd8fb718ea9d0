// The questions that another language may ask.
#pragma once

#include "calls/listener.hpp"

#include <string>
#include <vector>

namespace lcpush::desktop {

struct Told {
  bool solved = false; ///< or: agrees
  std::string text;
};

struct Call {
  const char* name;
  Told (*ask)(const std::string& request, Listener& listener);
};

// Each throws InputError, or Cancelled where the work cannot end with what there is.
Told ask_scene(const std::string& request, Listener& listener);
Told ask_solve(const std::string& request, Listener& listener);
Told ask_break(const std::string& request, Listener& listener);
Told ask_spread(const std::string& request, Listener& listener);
Told ask_move(const std::string& request, Listener& listener);
Told ask_verify(const std::string& request, Listener& listener);
Told ask_verify_motion(const std::string& request, Listener& listener);
Told ask_matrices(const std::string& request, Listener& listener);
Told ask_problem(const std::string& request, Listener& listener);
Told ask_cone(const std::string& request, Listener& listener);
Told ask_plan(const std::string& request, Listener& listener);
Told ask_certify(const std::string& request, Listener& listener);
Told ask_pivots(const std::string& request, Listener& listener);
Told ask_export(const std::string& request, Listener& listener);
Told ask_sweep(const std::string& request, Listener& listener);
Told ask_report(const std::string& request, Listener& listener);
Told ask_lcp(const std::string& request, Listener& listener);
Told ask_verify_lcp(const std::string& request, Listener& listener);

const std::vector<Call>& calls();

} // namespace lcpush::desktop
