/* lcpush's desktop for other languages: a question as JSON, an answer as JSON.
 *
 *   lcpush_desktop_answer* answer = lcpush_desktop_ask("solve", "{\"scene\": \"..TOML..\"}", NULL);
 *   if (lcpush_desktop_code(answer) == LCPUSH_DESKTOP_SOLVED)
 *     puts(lcpush_desktop_text(answer));
 *   lcpush_desktop_free(answer);
 *
 * Questions are the tool's commands: scene, tables, solve, break, sweep, spread, verify,
 * verify_motion, move, report, hold, cone, plan, design, certify, pivots, export, matrices,
 * problem, lcp, verify_lcp and contacts; docs/embed/desktop.md has their keys. An answer's text is
 * what the tool prints with --json, byte for byte, or in another "format".
 *
 * All functions may be called from several threads at once, each with answers of its own. No
 * exception leaves them. This is not the interface for microcontrollers: that is lcpush.h. */
#ifndef LCPUSH_DESKTOP_H
#define LCPUSH_DESKTOP_H

#include <stddef.h>

#if defined(_WIN32)
#define LCPUSH_DESKTOP_API
#else
#define LCPUSH_DESKTOP_API __attribute__((visibility("default")))
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef enum {
  LCPUSH_DESKTOP_SOLVED = 0,     /* or: agrees; as the tool's exit status */
  LCPUSH_DESKTOP_NOT_SOLVED = 1, /* it ran, and the text says why not */
  LCPUSH_DESKTOP_BAD_INPUT = 2,  /* file, line and message say what to change */
  LCPUSH_DESKTOP_CANCELLED = 3,  /* the listener said so; the text is what there is, or empty */
  LCPUSH_DESKTOP_FAILED = 4      /* out of memory, or a fault of lcpush: the message says which */
} lcpush_desktop_answer_code;

/* Is called by the thread that asks, some 50 times a second at most. Members may be NULL. */
typedef struct {
  void* context;
  void (*progress)(void* context, double done); /* 0 to 1, where that is known */
  int (*is_cancelled)(void* context);           /* not 0: end now */
} lcpush_desktop_listener;

/* Instead of callbacks into a language that is not called from every thread, or not until its end:
 * what a listener notes and reads whose `context` is a slate, with these two as its members.
 * Another thread looks at `done` (begin with -1: nothing is known), and sets `is_cancelled`. */
typedef struct {
  volatile double done;
  volatile int is_cancelled;
} lcpush_desktop_slate;
LCPUSH_DESKTOP_API void lcpush_desktop_note(void* slate, double done);
LCPUSH_DESKTOP_API int lcpush_desktop_is_cancelled(void* slate);

typedef struct lcpush_desktop_answer lcpush_desktop_answer;

/* `request` is a JSON object; UTF-8. Never NULL; to be freed. `listener` may be NULL. */
LCPUSH_DESKTOP_API lcpush_desktop_answer*
lcpush_desktop_ask(const char* question, const char* request,
                   const lcpush_desktop_listener* listener);

LCPUSH_DESKTOP_API lcpush_desktop_answer_code
lcpush_desktop_code(const lcpush_desktop_answer* answer);

/* These live as long as the answer. */
LCPUSH_DESKTOP_API const char* lcpush_desktop_text(const lcpush_desktop_answer* answer);
LCPUSH_DESKTOP_API size_t lcpush_desktop_length(const lcpush_desktop_answer* answer);
/* Of an error: "" unless there is one; line 0: no line. The message has neither file nor line. */
LCPUSH_DESKTOP_API const char* lcpush_desktop_file(const lcpush_desktop_answer* answer);
LCPUSH_DESKTOP_API int lcpush_desktop_line(const lcpush_desktop_answer* answer);
LCPUSH_DESKTOP_API const char* lcpush_desktop_message(const lcpush_desktop_answer* answer);

/* NULL is fine. */
LCPUSH_DESKTOP_API void lcpush_desktop_free(lcpush_desktop_answer* answer);

/* Such as "1.2.3". */
LCPUSH_DESKTOP_API const char* lcpush_desktop_version(void);

#ifdef __cplusplus
}
#endif

#endif
