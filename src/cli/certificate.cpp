#include "cli/certificate.hpp"

#include <algorithm>
#include <iostream>

#include "text/format.hpp"
#include "text/wrap.hpp"

namespace lcpush::cli {

using namespace desktop;

namespace {
constexpr double another_answer = 1e-6; // of the largest force: farther than rounding explains
} // namespace

void refuse_certificate_of_stdin(const Arguments& arguments) {
  const std::vector<std::string>& files = arguments.files();
  if (arguments.has("--certify") && std::find(files.begin(), files.end(), "-") != files.end())
    throw UsageError("--certify ties its proof to a file: name one instead of -");
}

void check_certifiable(const Arguments& arguments, const SceneFile& file) {
  refuse_certificate_of_stdin(arguments);
  const std::string refusal = uncertified_law(file);
  if (arguments.has("--certify") && !refusal.empty()) throw UsageError("--certify " + refusal);
}

bool write_certificate(const Arguments& arguments,
                       const std::function<std::optional<Certificate>()>& certify) {
  const std::optional<std::string> path = arguments.value("--certify");
  if (!path) return true;
  const std::optional<Certificate> certificate = certify();
  const auto say = [](const std::string& sentence) {
    std::cerr << wrapped(sentence, columns_of(Stream::errors)) << "\n";
  };
  if (!certificate) {
    say("No certificate: exact numbers do not confirm what rounded ones show, so " + *path +
        " was not written.");
    return false;
  }
  write_file(*path, certificate_json(*certificate));
  say("Certificate in " + *path + ": " + proof_statement(certificate->proof));
  if (certificate->distance > another_answer)
    say("They are another answer of this scene than the printed one: forces differ by up to " +
        brief(100 * certificate->distance) + " % of the largest.");
  return true;
}

} // namespace lcpush::cli
