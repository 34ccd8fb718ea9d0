/* The desktop's C interface, as C99: answers, errors as data, progress, cancelling. */
#include <stdio.h>
#include <string.h>

#include "lcpush/lcpush_desktop.h"

static int failures = 0;

static void check(int holds, const char* what) {
  if (holds) return;
  ++failures;
  printf("failed: %s\n", what);
}

#define OBJECT "[object]\\nmass = 0.2\\nbox = [0.1, 0.03, 0.01]\\n"
#define FINGERS                                                                                    \
  "[[finger]]\\nname = \\\"left\\\"\\nshape = \\\"disc\\\"\\ncenter = [0, 0, 0.005]\\n"            \
  "radius = 0.005\\nnormal = [0, 0, -1]\\nfriction = 0.5\\ngrip_force = 20\\n"                     \
  "[[finger]]\\nname = \\\"right\\\"\\nshape = \\\"disc\\\"\\ncenter = [0, 0, -0.005]\\n"          \
  "radius = 0.005\\nnormal = [0, 0, 1]\\nfriction = 0.5\\ngrip_force = 20\\n"
#define PUSHER                                                                                     \
  "[[pusher]]\\nname = \\\"wall\\\"\\nshape = \\\"point\\\"\\ncenter = [-0.05, 0.004, 0]\\n"       \
  "normal = [1, 0, 0]\\nfriction = 0.3\\nacceleration = [0.1, 0, 0]\\n"
#define SCENE "\"file\": \"s.toml\", \"scene\": \"" OBJECT FINGERS PUSHER "\""

static const char* const vary =
    "{" SCENE ", \"vary\": {\"list\": [{\"path\": \"left.friction\", \"from\": 0.1, \"to\": 1}]}, "
    "\"steps\": 100000}";

static int begins(const char* text, const char* with) {
  return strncmp(text, with, strlen(with)) == 0;
}

static void test_answers(void) {
  lcpush_desktop_answer* answer = lcpush_desktop_ask("solve", "{" SCENE "}", NULL);
  check(lcpush_desktop_code(answer) == LCPUSH_DESKTOP_SOLVED, "a scene is solved");
  check(strstr(lcpush_desktop_text(answer), "\"status\": \"solved\"") != NULL, "its JSON says so");
  check(lcpush_desktop_length(answer) == strlen(lcpush_desktop_text(answer)), "length");
  check(lcpush_desktop_line(answer) == 0 && *lcpush_desktop_message(answer) == '\0', "no error");
  lcpush_desktop_free(answer);
  answer = lcpush_desktop_ask(
      "lcp", "{\"M\": {\"rows\": 1, \"row\": [0], \"column\": [0], \"value\": [-1]}, \"q\": [-1]}",
      NULL);
  check(lcpush_desktop_code(answer) == LCPUSH_DESKTOP_NOT_SOLVED, "no answer is an answer");
  check(strstr(lcpush_desktop_text(answer), "\"ray\"") != NULL, "its ray");
  lcpush_desktop_free(answer);
  check(begins(lcpush_desktop_version(), "0."), "version");
}

static void expect_error(const char* question, const char* request, const char* file, int line,
                         const char* message) {
  lcpush_desktop_answer* const answer = lcpush_desktop_ask(question, request, NULL);
  check(lcpush_desktop_code(answer) == LCPUSH_DESKTOP_BAD_INPUT, message);
  check(strcmp(lcpush_desktop_file(answer), file) == 0, lcpush_desktop_file(answer));
  check(lcpush_desktop_line(answer) == line, message);
  check(begins(lcpush_desktop_message(answer), message), lcpush_desktop_message(answer));
  check(lcpush_desktop_length(answer) == 0, "an error has no text");
  lcpush_desktop_free(answer);
}

static void test_errors(void) {
  expect_error("slove", "{}", "", 0, "no question is called \"slove\" (did you mean \"solve\"?)");
  expect_error("solve", NULL, "", 0, "a question has two texts");
  expect_error("solve", "{", "request", 1, "");
  expect_error("solve", "[]", "request", 1, "a question is a JSON object");
  expect_error("solve", "{}", "request", 1, "\"scene\" is missing");
  expect_error("solve", "{\n\"secne\": 3}", "request", 2, "no option is called \"secne\"");
  expect_error("solve", "{" SCENE ", \"solver\": \"lemko\"}", "request", 1, "\"solver\" is lemke");
  expect_error("solve", "{\"file\": \"a.toml\", \"scene\": \"[object]\\nmass = -1\\n\"}", "a.toml",
               2, "");
  expect_error("sweep", "{" SCENE "}", "request", 1, "say what to vary: \"vary\"");
  expect_error("move", "{" SCENE ", \"frames\": 1}", "request", 1, "\"frames\" is a whole");
  expect_error("lcp",
               "{\"M\": {\"rows\": 2, \"row\": [1, 0], \"column\": [0, 0], \"value\": "
               "[1, 1]}, \"q\": [1, 1]}",
               "request", 1, "entry 1 of \"M\" is at row 0, column 0");
}

typedef struct {
  int told, ended, asked_late;
  double last;
} seen;

static void note(void* context, double done) {
  seen* const all = context;
  check(done >= 0 && done <= 1, "progress is a share");
  ++all->told;
  all->last = done;
}
static int is_over(void* context) {
  seen* const all = context;
  all->asked_late += all->ended;
  return all->ended = all->told > 0; /* however slow the machine is */
}

static void test_cancelling(void) {
  seen all = {0, 0, 0, 0};
  const lcpush_desktop_listener listener = {&all, note, is_over};
  lcpush_desktop_answer* answer = lcpush_desktop_ask("sweep", vary, &listener);
  check(lcpush_desktop_code(answer) == LCPUSH_DESKTOP_CANCELLED, "a long sweep is cancelled");
  check(all.asked_late == 0 && all.last < 0.9, "it ends when it is told to");
  lcpush_desktop_free(answer);
  all.ended = all.told = 0;
  answer = lcpush_desktop_ask("move", "{" SCENE ", \"step\": 1e-5}", &listener);
  check(lcpush_desktop_code(answer) == LCPUSH_DESKTOP_CANCELLED, "a motion is cancelled");
  check(strstr(lcpush_desktop_text(answer), "\"end\": \"stopped\"") != NULL, "with what there is");
  lcpush_desktop_free(answer);
}

/* What a slate takes the place of: callbacks of another thread's. */
static void test_slates(void) {
  lcpush_desktop_slate slate = {-1, 1};
  const lcpush_desktop_listener listener = {&slate, lcpush_desktop_note,
                                            lcpush_desktop_is_cancelled};
  lcpush_desktop_answer* answer = lcpush_desktop_ask("sweep", vary, &listener);
  check(lcpush_desktop_code(answer) == LCPUSH_DESKTOP_CANCELLED, "a slate ends a sweep");
  lcpush_desktop_free(answer);
  slate.is_cancelled = 0;
  slate.done = -1;
  answer = lcpush_desktop_ask("move", "{" SCENE ", \"time\": 0.1}", &listener);
  check(lcpush_desktop_code(answer) == LCPUSH_DESKTOP_SOLVED, "an empty slate ends nothing");
  check(slate.done >= 0 && slate.done <= 1, "a share is noted on it");
  lcpush_desktop_free(answer);
}

int main(void) {
  test_answers();
  test_errors();
  test_cancelling();
  test_slates();
  lcpush_desktop_free(NULL);
  if (failures == 0) printf("ok\n");
  return failures != 0;
}
