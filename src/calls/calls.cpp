// The interface of lcpush_desktop.h: exceptions end here.
#include "calls/listener.hpp"
#include "calls/questions.hpp"
#include "calls/request.hpp"
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

namespace lcpush::calls {
namespace {

const Command& question_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Command& question : questions()) {
    if (name == question.name) return question;
    names.push_back(question.name);
  }
  throw InputError("no question is called " + desktop::quoted(name) + suggestion(name, names) +
                   "; there are " + listed(names, "and"));
}

void answer_with(lcpush_desktop_answer& answer, const char* question, const char* text,
                 const lcpush_desktop_listener* other) {
  ForeignListener listener(other);
  try {
    if (question == nullptr || text == nullptr) throw InputError("a question has two texts");
    const Command& asked = question_named(question);
    const Request request(asked, text);
    if (asked.ends_with_what_there_is)
      if (const auto seconds = request.number("seconds", commands::longest_time, ", in seconds"))
        listener.end_after(*seconds);
    const commands::Result result = commands::run(asked, request, listener);
    answer.text = result.text;
    answer.code = listener.was_cancelled() ? LCPUSH_DESKTOP_CANCELLED
                  : result.is_good         ? LCPUSH_DESKTOP_SOLVED
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
} // namespace lcpush::calls

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
  if (answer == nullptr) return &lcpush::calls::no_memory();
  try {
    lcpush::calls::answer_with(*answer, question, request, listener);
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
  if (answer != &lcpush::calls::no_memory()) delete answer;
}

const char* lcpush_desktop_version(void) { return lcpush::version_text; }
}
