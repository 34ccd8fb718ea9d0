// --certify FILE: the proof of an answer.
#pragma once

#include <functional>
#include <optional>

#include "cli/arguments.hpp"
#include "lcpush/desktop/certify.hpp"

namespace lcpush::cli {

inline const Option certify_option{"--certify", "FILE",
                                   "also write an exact proof of the answer for "
                                   "docs/check/lcpush_check.py"};

/// Before any work: throws UsageError if --certify is asked of standard input.
void refuse_certificate_of_stdin(const Arguments& arguments);
/// The same, and of a scene whose law has no certificate.
void check_certifiable(const Arguments& arguments, const SceneFile& file);

/// Writes what `certify` makes to the file of --certify, and says so on stderr; nothing without the
/// option. Returns false if there was to be a certificate and is none.
bool write_certificate(const Arguments& arguments,
                       const std::function<std::optional<Certificate>()>& certify);

} // namespace lcpush::cli
