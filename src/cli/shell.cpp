#include "cli/shell.hpp"

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <system_error>

#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/ending.hpp"
#include "lcpush/desktop/input_error.hpp"
#include "text/text_file.hpp"
#include "text/wording.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {
namespace {

/// lcpush writes text: no name should promise another kind of file.
void refuse_foreign_format(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  for (const char* foreign : {".pdf", ".png", ".jpg", ".jpeg", ".gif", ".docx", ".xlsx"})
    if (ending == foreign)
      throw UsageError("-o " + desktop::quoted(path) + ": lcpush does not write " + ending +
                       " files; it writes text, JSON, CSV, SVG and HTML");
}

} // namespace

std::size_t columns_of(Stream stream) {
  winsize size{};
  const int descriptor = stream == Stream::output ? STDOUT_FILENO : STDERR_FILENO;
  const bool is_known = isatty(descriptor) != 0 && ioctl(descriptor, TIOCGWINSZ, &size) == 0;
  return is_known && size.ws_col > 0 ? size.ws_col : usual_width;
}

void tell(const std::string& sentence) {
  std::cerr << wrapped(sentence, columns_of(Stream::errors)) << "\n";
}

void write_output(const Arguments& arguments, const std::string& text) {
  lift_time_limit();
  if (const std::optional<std::string> path = arguments.text("output"); path && *path != "-") {
    refuse_foreign_format(*path);
    write_file(*path, text);
    const bool is_page = text.compare(0, 9, "<!DOCTYPE") == 0;
    if (is_page || text.compare(0, 4, "<svg") == 0)
      tell("Wrote " + *path + (is_page ? "; open it in a browser." : "."));
    return;
  }
  errno = 0;
  std::cout << text << std::flush;
  if (!std::cout) refuse_file("standard output", "written", errno);
}

void write_file(const std::string& path, const std::string& text) {
  lift_time_limit();
  errno = 0;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path + ": is a directory; name a file inside it");
  // A device or a pipe cannot be renamed over.
  const bool direct =
      std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  const std::string partial = direct ? path : path + ".part";
  std::ofstream stream(partial, std::ios::binary);
  if (!stream) refuse_file(path, "written", errno);
  stream << text << std::flush;
  if (!stream) {
    const int reason = errno;
    if (!direct) std::remove(partial.c_str());
    refuse_file(path, "written", reason);
  }
  stream.close();
  if (direct) return;
  std::error_code failure;
  std::filesystem::rename(partial, path, failure);
  if (!failure) return;
  std::remove(partial.c_str());
  refuse_file(path, "written", failure.value());
}

void refuse_page_on_terminal(const Arguments& arguments, const std::string& name) {
  if (!arguments.has("output") && isatty(STDOUT_FILENO) != 0)
    throw UsageError("a page is for a browser: say where to with -o " + name + ".html");
}

void make_directory(const std::string& path) {
  std::error_code failure;
  std::filesystem::create_directories(path, failure);
  if (failure) throw InputError(path + ": cannot be made: " + failure.message());
}

} // namespace lcpush::cli
