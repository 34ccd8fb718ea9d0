// --certify FILE: the proof of an answer.
#include "cli/shell.hpp"
#include "text/format.hpp"
#include "text/limits.hpp"
#include "text/text_file.hpp"

namespace lcpush::cli {
namespace {

constexpr double another_answer = 1e-6; // of the largest force: farther than rounding explains

} // namespace

bool write_certificate(const Arguments& arguments, const commands::Result& result) {
  const std::optional<std::string> path = arguments.text("certify");
  if (!path) return true;
  if (result.box_certificate) {
    if (!result.box_certificate->obstacle.empty()) {
      tell("No certificate: " + result.box_certificate->obstacle + ", so " + *path +
           " was not written.");
      return false;
    }
    write_file(*path, result.box_certificate->json);
    tell("Certificate in " + *path + ", for docs/check/lcpush_check_box.py.");
    return true;
  }
  std::optional<Certificate> certificate = result.certify();
  if (!certificate) {
    tell("No certificate: exact numbers do not confirm what rounded ones show, so " + *path +
         " was not written.");
    return false;
  }
  if (certificate->law == "raw")
    for (const std::string& file : arguments.files())
      certificate->add_fingerprint(read_text_file(file, limits::matrix_bytes));
  write_file(*path, certificate_json(*certificate));
  tell("Certificate in " + *path + ": " + proof_statement(certificate->proof));
  if (certificate->distance > another_answer)
    tell("They are another answer of this scene than the printed one: forces differ by up to " +
         brief(100 * certificate->distance) + " % of the largest.");
  return true;
}

} // namespace lcpush::cli
