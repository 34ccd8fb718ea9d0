// lcpush: a whole file as text, or a message that says what to do.
#pragma once

#include <cstddef>
#include <fstream>
#include <string>

namespace lcpush::desktop {

/// As messages name the file: "-" is standard input.
std::string file_label(const std::string& path);

/// The bytes of the file at `path`, unchanged; of standard input for "-". Throws InputError if it
/// is a directory, cannot be read, or holds more than `max_bytes` (it stops reading there, so
/// /dev/zero is harmless).
std::string read_text_file(const std::string& path, std::size_t max_bytes);

/// The file at `path`, open to be read. Throws InputError.
std::ifstream open_file(const std::string& path);

/// Throws InputError: the file cannot be `done` ("read", "written") for this reason, an errno.
[[noreturn]] void refuse_file(const std::string& path, const char* done, int reason);

} // namespace lcpush::desktop
