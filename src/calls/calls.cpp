// The interface of lcpush_desktop.h: exceptions end here.
#include "calls/questions.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "lcpush/lcpush_desktop.h"
#include "lcpush/version.hpp"
#include "text/wording.hpp"

#include <exception>
#include <new>

struct lcpush_desktop_answer {
  lcpush_desktop_answer_code code = LCPUSH_DESKTOP_FAILED;
  std::string text, file, message;
  int line = 0;
};

namespace lcpush::desktop {

const std::vector<Call>& calls() {
  static const std::vector<Call> list{{"scene", ask_scene},
                                      {"solve", ask_solve},
                                      {"break", ask_break},
                                      {"sweep", ask_sweep},
                                      {"spread", ask_spread},
                                      {"verify", ask_verify},
                                      {"verify_motion", ask_verify_motion},
                                      {"move", ask_move},
                                      {"report", ask_report},
                                      {"cone", ask_cone},
                                      {"plan", ask_plan},
                                      {"certify", ask_certify},
                                      {"pivots", ask_pivots},
                                      {"export", ask_export},
                                      {"matrices", ask_matrices},
                                      {"problem", ask_problem},
                                      {"lcp", ask_lcp},
                                      {"verify_lcp", ask_verify_lcp}};
  return list;
}

namespace {

const Call& call_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Call& call : calls()) {
    if (name == call.name) return call;
    names.emplace_back(call.name);
  }
  throw InputError("no question is called " + quoted(name) + suggestion(name, names) +
                   "; there are " + listed(names, "and"));
}

void answer_with(lcpush_desktop_answer& answer, const char* question, const char* request,
                 const lcpush_desktop_listener* other) {
  Listener listener(other);
  try {
    if (question == nullptr || request == nullptr) throw InputError("a question has two texts");
    const Told told = call_named(question).ask(request, listener);
    answer.text = told.text;
    answer.code = listener.was_cancelled() ? LCPUSH_DESKTOP_CANCELLED
                  : told.solved            ? LCPUSH_DESKTOP_SOLVED
                                           : LCPUSH_DESKTOP_NOT_SOLVED;
  } catch (const InputError& error) {
    answer.code = LCPUSH_DESKTOP_BAD_INPUT;
    answer.file = error.file();
    answer.line = error.line();
    answer.message = error.message();
  } catch (const Cancelled&) {
    answer.code = LCPUSH_DESKTOP_CANCELLED;
  } catch (const std::exception& error) {
    answer.message = error.what();
  }
}

/// For when there is no memory even for an answer.
lcpush_desktop_answer& no_memory() {
  static lcpush_desktop_answer answer{LCPUSH_DESKTOP_FAILED, {}, {}, "out of memory", 0};
  return answer;
}

} // namespace
} // namespace lcpush::desktop

extern "C" {

void lcpush_desktop_note(void* slate, double done) {
  static_cast<lcpush_desktop_slate*>(slate)->done = done;
}
int lcpush_desktop_is_cancelled(void* slate) {
  return static_cast<const lcpush_desktop_slate*>(slate)->is_cancelled;
}

lcpush_desktop_answer* lcpush_desktop_ask(const char* question, const char* request,
                                          const lcpush_desktop_listener* listener) {
  auto* const answer = new (std::nothrow) lcpush_desktop_answer;
  if (answer == nullptr) return &lcpush::desktop::no_memory();
  try {
    lcpush::desktop::answer_with(*answer, question, request, listener);
  } catch (...) { // no memory for the message either
    answer->code = LCPUSH_DESKTOP_FAILED;
  }
  return answer;
}

lcpush_desktop_answer_code lcpush_desktop_code(const lcpush_desktop_answer* answer) {
  return answer->code;
}
const char* lcpush_desktop_text(const lcpush_desktop_answer* answer) {
  return answer->text.c_str();
}
size_t lcpush_desktop_length(const lcpush_desktop_answer* answer) { return answer->text.size(); }
const char* lcpush_desktop_file(const lcpush_desktop_answer* answer) {
  return answer->file.c_str();
}
int lcpush_desktop_line(const lcpush_desktop_answer* answer) { return answer->line; }
const char* lcpush_desktop_message(const lcpush_desktop_answer* answer) {
  return answer->message.c_str();
}

void lcpush_desktop_free(lcpush_desktop_answer* answer) {
  if (answer != &lcpush::desktop::no_memory()) delete answer;
}

const char* lcpush_desktop_version(void) { return lcpush::version_text; }
}
