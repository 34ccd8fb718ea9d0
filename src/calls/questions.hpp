// The questions that another language may ask.
#pragma once

#include "commands/command.hpp"

namespace lcpush::calls {

const std::vector<commands::Command>& questions();

} // namespace lcpush::calls
