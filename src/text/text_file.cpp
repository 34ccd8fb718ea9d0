#include "text/text_file.hpp"

#include "lcpush/desktop/input_error.hpp"

#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace lcpush::desktop {

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored))
    throw InputError(path + ": is a directory; name a file inside it");

  const auto refuse_unreadable = [&path](int reason) {
    const std::string text = std::generic_category().message(reason);
    throw InputError(path + ": cannot be read: " + text + "; check the path and its permissions");
  };
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) refuse_unreadable(errno);

  std::string text;
  std::array<char, 65536> chunk;
  while (stream) {
    stream.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_bytes)
      throw InputError(path + ": is larger than " + std::to_string(max_bytes) +
                       " bytes; is it the right file?");
  }
  if (stream.bad()) refuse_unreadable(errno);
  return text;
}

} // namespace lcpush::desktop
