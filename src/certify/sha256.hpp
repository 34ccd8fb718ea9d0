// FIPS 180-4: the fingerprint that ties a certificate to its file.
#pragma once

#include <string>
#include <string_view>

namespace lcpush::desktop {

/// 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

} // namespace lcpush::desktop
