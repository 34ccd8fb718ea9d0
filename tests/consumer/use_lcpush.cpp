// A project that uses the headers alone.
#include <lcpush/status.hpp>
#include <lcpush/types.hpp>
#include <lcpush/version.hpp>

#include <cstdio>
#include <cstring>

#ifdef LCPUSH_EXTERN_TEMPLATES
#error "the headers alone must not expect compiled templates"
#endif

int main() {
  std::printf("lcpush %s\n", lcpush::version_text);
  const lcpush::Vector6<float> twist = lcpush::Vector6<float>::Ones();
  const bool is_named = std::strcmp(lcpush::status_text(lcpush::Status::solved), "solved") == 0;
  return is_named && twist.sum() == 6.0F ? 0 : 1;
}
