// lcpush: the one exception of the desktop code: the user's input is wrong.
#pragma once

#include <stdexcept>
#include <string>

namespace lcpush::desktop {

/// Bad input. what() is the whole message, ready to print:
/// `scenes/a.toml:12: finger "left": friction must be >= 0, got -0.3`.
class InputError : public std::runtime_error {
public:
  explicit InputError(const std::string& message)
      : std::runtime_error(message), message_(message) {}
  InputError(const std::string& file, int line, const std::string& message);

  /// As messages name it; empty and 0: the message itself says where, or it is nowhere.
  const std::string& file() const { return file_; }
  int line() const { return line_; }
  /// what() without them.
  const std::string& message() const { return message_; }

private:
  std::string file_, message_;
  int line_ = 0;
};

} // namespace lcpush::desktop
