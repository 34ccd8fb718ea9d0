// lcpush: the one exception of the desktop code: the user's input is wrong.
#pragma once

#include <stdexcept>
#include <string>

namespace lcpush::desktop {

/// Bad input. what() is the whole message, ready to print:
/// `scenes/a.toml:12: finger "left": friction must be >= 0, got -0.3`.
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
  InputError(const std::string& file, int line, const std::string& message)
      : std::runtime_error(file + ":" + std::to_string(line) + ": " + message) {}
};

} // namespace lcpush::desktop
