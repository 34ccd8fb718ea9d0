// The playground's solver as a WebAssembly module without imports: text in, text out.
//
// The page writes "question\nscene" to where input() says, calls ask(), and reads the answer. What
// would be thrown ends the module instead: its message stays in the memory to be read, and the page
// starts a fresh copy. So the code of the tool is compiled as it is.
#include "play/answers.hpp"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <system_error>

#include <wasi/api.h>

namespace {

// Never destroyed: a module has no end.
std::string& asked = *new std::string;
std::string& answer = *new std::string;
lcpush::desktop::Playground& playground = *new lcpush::desktop::Playground;

} // namespace

extern "C" {

[[clang::export_name("input")]] char* lcpush_input(std::size_t size) {
  asked.resize(size);
  return asked.data();
}

/// Where the answer, or a message, begins.
[[clang::export_name("ask")]] const char* lcpush_ask() {
  const std::string_view all = asked;
  const std::size_t end = std::min(all.find('\n'), all.size());
  answer = playground.answer_to(all.substr(0, end), all.substr(std::min(end + 1, all.size())));
  return answer.data();
}

[[clang::export_name("answer")]] const char* lcpush_answer() { return answer.data(); }
[[clang::export_name("answer_size")]] std::size_t lcpush_answer_size() { return answer.size(); }

// What the compiler calls for `throw`. All that is thrown here is a std::exception.
void* __cxa_allocate_exception(std::size_t size) noexcept { return std::malloc(size); }
void __cxa_free_exception(void* thrown) noexcept { std::free(thrown); }
[[noreturn]] void __cxa_throw(void* thrown, void* /*type*/, void (* /*destroy*/)(void*)) {
  answer = static_cast<std::exception*>(thrown)->what();
  __builtin_trap();
}
}

// printf could also print, for which libc would want functions from outside. Nothing here prints.
extern "C" __wasi_errno_t __wasi_fd_close(__wasi_fd_t) { __builtin_trap(); }
extern "C" __wasi_errno_t __wasi_fd_seek(__wasi_fd_t, __wasi_filedelta_t, __wasi_whence_t,
                                         __wasi_filesize_t*) {
  __builtin_trap();
}
extern "C" __wasi_errno_t __wasi_fd_write(__wasi_fd_t, const __wasi_ciovec_t*, std::size_t,
                                          __wasi_size_t*) {
  __builtin_trap();
}

// In the place of libc++'s own __d2fixed_buffered_n (see the linker's --wrap): that writes whole
// numbers above 2^53 with 100 kB of tables, and printf knows the same digits.
extern "C" std::to_chars_result __wrap__ZNSt3__220__d2fixed_buffered_nEPcS0_dj(char* first,
                                                                               char* last,
                                                                               double number,
                                                                               unsigned decimals) {
  char text[64];
  const int size = std::snprintf(text, sizeof text, "%.*f", static_cast<int>(decimals), number);
  if (size < 0 || size >= static_cast<int>(sizeof text) || size > last - first) __builtin_trap();
  std::memcpy(first, text, static_cast<std::size_t>(size));
  return {first + size, std::errc{}};
}
