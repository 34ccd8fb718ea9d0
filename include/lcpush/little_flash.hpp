// What a build for devices with little flash leaves out.
#pragma once

namespace lcpush {

/// With LCPUSH_LITTLE_FLASH, defined for every file of a program, there are pyramids alone and no
/// even pressure, and the C interface pivots on the whole table: for few points, with nearly 20 KB
/// of code less (docs/embed/embedding.md).
#ifdef LCPUSH_LITTLE_FLASH
inline constexpr bool little_flash = true;
#else
inline constexpr bool little_flash = false;
#endif

} // namespace lcpush
