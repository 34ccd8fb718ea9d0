#include "contacts/contact_parts.hpp"

#include "text/format.hpp"
#include "text/text_file.hpp"

#include <algorithm>
#include <filesystem>

namespace lcpush::desktop {

using Eigen::VectorXd;

namespace {

constexpr const char* known_keys[] = {"W", "G", "M",  "H", "b", "g", "q",
                                      "f", "w", "mu", "V", "R", "s", "r"};

/// An array of rows, or of the numbers of a column.
SparseRows rows_of(const JsonValue& value, const JsonFields& fields, const std::string& key) {
  const JsonArray* const array = value.as<JsonArray>();
  if (array == nullptr)
    fields.refuse(value, desktop::quoted(key) + " must be an array of numbers or of rows, got " +
                             value.type());
  SparseRows rows;
  for (const JsonValue& entry : *array) {
    const JsonArray* const row = entry.as<JsonArray>();
    const auto width = row != nullptr ? static_cast<Index>(row->size()) : 1;
    if (rows.rows() == 0) {
      rows.cols = width;
      rows.entries.reserve(array->size() * static_cast<std::size_t>(width));
    }
    if (width != rows.cols)
      fields.refuse(entry, "row " + std::to_string(rows.rows() + 1) + " of " +
                               desktop::quoted(key) + " has " + counted(width, "number") +
                               ", the first has " + std::to_string(rows.cols));
    for (Index j = 0; j < width; ++j) {
      const JsonValue& number = row != nullptr ? (*row)[static_cast<std::size_t>(j)] : entry;
      if (number.as<double>() == nullptr)
        fields.refuse(number, desktop::quoted(key) + " must hold numbers, got " + number.type());
      if (*number.as<double>() != 0) rows.add(j, *number.as<double>());
    }
    rows.end_row();
  }
  return rows;
}

bool are_same(const SparseRows& A, const SparseRows& B) {
  const auto same = [](const SparseEntry& a, const SparseEntry& b) {
    return a.column == b.column && a.value == b.value;
  };
  return A.cols == B.cols && A.begins == B.begins &&
         std::equal(A.entries.begin(), A.entries.end(), B.entries.begin(), same);
}

} // namespace

ContactParts::ContactParts(const JsonValue& root, std::string name) : name_(std::move(name)) {
  const JsonFields fields(name_);
  if (root.as<JsonObject>() == nullptr)
    fields.refuse(root, std::string("a contact problem is an object with \"W\", \"b\" and "
                                    "\"mu\", or with \"M\", \"H\", \"f\" and \"mu\", got ") +
                            root.type());
  for (const auto& [key, value] : *root.as<JsonObject>())
    if (key != "normal" &&
        std::find(std::begin(known_keys), std::end(known_keys), key) == std::end(known_keys))
      unread.push_back(key);
  for (const char* key : known_keys)
    if (const JsonValue* const value = root.find(key))
      parts_[key] = key == std::string("mu") ? rows_of(of_all_contacts(*value), fields, key)
                                             : rows_of(*value, fields, key);
  const std::string normal = fields.text(root, "normal");
  is_normal_last = normal == "last";
  if (!normal.empty() && normal != "first" && normal != "last")
    fields.refuse(*root.find("normal"), "\"normal\" says which of a contact's three numbers is "
                                        "the normal's: \"first\" or \"last\", not " +
                                            desktop::quoted(normal));
}

ContactParts::ContactParts(const std::string& folder) : name_(folder) {
  for (const char* key : known_keys) {
    const std::string path = folder + "/" + key + ".mtx";
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) parts_[key] = read_sparse_matrix(path);
  }
  if (!has("V") && has("R") && !has("r")) parts_["r"] = parts_["R"]; // reactions
}

const SparseRows& ContactParts::part(const std::vector<std::string>& keys, Index rows, Index cols,
                                     const std::string& what) const {
  std::string first;
  for (const std::string& key : keys) {
    if (!has(key)) continue;
    if (first.empty()) first = key;
    if (!are_same(parts_.at(key), parts_.at(first)))
      refuse(desktop::quoted(first) + " and " + desktop::quoted(key) +
             " are both there and differ, but each is " + what + ": leave one out");
  }
  if (!first.empty()) {
    const SparseRows& part = parts_.at(first);
    if ((rows >= 0 && part.rows() != rows) || (cols >= 0 && part.cols != cols))
      refuse(
          desktop::quoted(first) + " is " + std::to_string(part.rows()) + " x " +
          std::to_string(part.cols) + ", but it is " + what +
          (rows < 0 || cols < 0 ? "" : ": " + std::to_string(rows) + " x " + std::to_string(cols)));
    return part;
  }
  refuse(desktop::quoted(keys[0]) + " is missing: " + what);
}

VectorXd ContactParts::vector(const std::vector<std::string>& keys, Index rows,
                              const std::string& what) const {
  const SparseRows& column = part(keys, rows, 1, what);
  VectorXd x = VectorXd::Zero(column.rows());
  for (Index i = 0; i < x.size(); ++i)
    for (const SparseEntry& entry : column.row(i)) x[i] = entry.value;
  return x;
}

JsonValue ContactParts::of_all_contacts(const JsonValue& mu) const {
  if (mu.as<double>() == nullptr) return mu;
  Index rows = 3;
  for (const char* key : {"b", "g", "H", "G", "W"}) { // the last says how many they are
    if (!has(key)) continue;
    const SparseRows& part = parts_.at(key);
    rows = has("M") && part.rows() == parts_.at("M").rows() ? part.cols : part.rows();
  }
  if (rows % 3 != 0)
    refuse("each contact has three rows, and " + std::to_string(rows) + " are no multiple of that");
  return {mu.line, JsonArray(static_cast<std::size_t>(rows / 3), mu)};
}

} // namespace lcpush::desktop
