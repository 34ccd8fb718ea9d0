#include "text/text_file.hpp"

#include "lcpush/desktop/input_error.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace lcpush::desktop {

void refuse_file(const std::string& path, const char* done, int reason) {
  throw InputError(path + ": cannot be " + done + ": " + std::generic_category().message(reason) +
                   "; check the path and its permissions");
}

std::string file_label(const std::string& path) { return path == "-" ? "standard input" : path; }

std::ifstream open_file(const std::string& path) {
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse_file(path, "read", errno);
  return stream;
}

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path + ": is a directory; name a file inside it");

  std::ifstream file;
  if (path != "-") file = open_file(path);
  std::istream& stream = path == "-" ? std::cin : file;
  std::string text;
  std::array<char, 65536> chunk;
  while (stream) {
    stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_bytes)
      throw InputError(path + ": is larger than " + std::to_string(max_bytes) +
                       " bytes; is it the right file?");
  }
  if (stream.bad()) refuse_file(path, "read", errno);
  return text;
}

} // namespace lcpush::desktop
