// A project that links the compiled desktop library.
#include <lcpush/host/json.hpp>
#include <lcpush/host/matrix_market.hpp>

#include <cstdio>

int main() {
  const lcpush::host::HostMatrix q = lcpush::host::parse_inline_vector("-5 -6", "q");
  lcpush::host::JsonWriter json;
  json.begin_object().key("q").numbers(q.values).end_object();
  std::fputs(json.text().c_str(), stdout);
  return json.text() == "{\n  \"q\": [-5, -6]\n}\n" ? 0 : 1;
}
