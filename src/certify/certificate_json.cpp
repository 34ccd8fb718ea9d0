#include "certify/sha256.hpp"
#include "formats/json_writer.hpp"
#include "lcpush/desktop/certify.hpp"

namespace lcpush::desktop {

std::string certificate_json(const Certificate& certificate) {
  JsonWriter json;
  json.begin_object();
  json.member("certificate", 1).member("proof", proof_text(certificate.proof));
  json.member("law", certificate.law);
  if (certificate.facets > 0) json.member("facets", certificate.facets);
  json.member("push", certificate.push.text());
  std::string numbers;
  for (const Rational& x : certificate.x) numbers += (numbers.empty() ? "" : ",") + x.text();
  std::vector<std::string> fingerprints = certificate.fingerprints;
  fingerprints.push_back(sha256(numbers));
  json.list("sha256", fingerprints, [&](const std::string& digits) { json.value(digits); });
  if (certificate.law == "raw") {
    json.key("free").begin_array();
    for (std::size_t i = 0; i < certificate.free.size(); ++i)
      if (certificate.free[i] != 0) json.value(i + 1);
    json.end_array();
  }
  json.list("basis", certificate.basis, [&](Index i) { json.value(i + 1); });
  json.list("x", certificate.x, [&](const Rational& x) { json.value(x.text()); });
  json.member("statement", proof_statement(certificate.proof));
  return json.end_object().text();
}

} // namespace lcpush::desktop
