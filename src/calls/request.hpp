// A request of another language: keys of a JSON object as values of a command's options.
#pragma once

#include "commands/values.hpp"
#include "formats/json_fields.hpp"

namespace lcpush::calls {

using namespace desktop;
using commands::Command;
using commands::Document;

class Request : public commands::Values {
public:
  /// Throws InputError if `text` is no object, or has a key that the command does not take.
  Request(const Command& command, const std::string& text);

  /// "stop_after" for "stop-after"; nullptr if it is not there, or null.
  const JsonValue* find(const std::string& option) const;

  bool has(const std::string& option) const override;
  std::optional<std::string> text(const std::string& option) const override;
  std::vector<std::string> texts(const std::string& option) const override;
  std::optional<Written> written(const std::string& option, const std::string& unit) const override;
  std::optional<std::vector<double>> numbers(const std::string& option,
                                             const std::vector<std::string>& units,
                                             const std::string& what) const override;
  std::string label(const std::string& option) const override;
  std::string usage(const std::string& option) const override { return label(option); }
  std::string row_name(Index row) const override {
    return "row " + std::to_string(row + 1) + " (counted from 1)";
  }
  void throw_refusal(const std::string& option, const std::string& sentence) const override;
  using Values::format;
  std::string format(const std::vector<std::string>& known) const override;
  Telling telling() const override {
    return text("format") == "full_text" ? Telling::full : Telling::brief;
  }

  std::size_t scene_count() const override { return find("scene") == nullptr ? 0 : 1; }
  Document given_scene(std::size_t k = 0) const override;
  std::size_t variation_count() const override;
  std::vector<Variation> variations(const VariedScene& scene) const override;
  std::optional<std::vector<Variation>> each(const VariedScene& scene) const override;

  commands::ExactMatrices exact_matrices() const override;
  RawProblem raw_problem() const override;
  std::optional<commands::NumberList> list(const std::string& option, Index n) const override;
  Document answer() const override { return document("answer", "a JSON object as solve gives it"); }
  Document trajectory() const override {
    return document("motion", "frames as move gives them, JSON or CSV");
  }
  Document contacts() const override {
    return {needed("problem", "the text of a JSON object with W, b and mu"), "problem"};
  }
  std::vector<double> z(const RawProblem& problem) const override;

private:
  std::string name_ = "request";
  JsonFields fields_{name_};
  JsonValue root_;

  std::string needed(const std::string& option, const std::string& what) const;
  Document document(const std::string& option, const std::string& what) const {
    return {needed(option, "the text of " + what), option};
  }
  std::vector<double> needed_numbers(const std::string& option, Index count) const;
  SparseRows matrix() const;
  std::vector<unsigned char> free_rows(Index n) const;
};

} // namespace lcpush::calls
