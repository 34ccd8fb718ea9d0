// The matrices and columns of a contact problem by their names, of a file or a folder.
#pragma once

#include "formats/json_fields.hpp"
#include "lcpush/desktop/contacts.hpp"

#include <map>

namespace lcpush::desktop {

class ContactParts {
public:
  ContactParts(const JsonValue& root, std::string name);
  explicit ContactParts(const std::string& folder);

  bool is_normal_last = false;
  std::vector<std::string> unread; ///< keys that no contact problem has

  bool has(const std::string& key) const { return parts_.count(key) > 0; }
  [[noreturn]] void refuse(const std::string& sentence) const {
    throw InputError(name_ + ": " + sentence);
  }
  /// The first that is there. A size < 0 may be any.
  const SparseRows& part(const std::vector<std::string>& keys, Index rows, Index cols,
                         const std::string& what) const;
  Eigen::VectorXd vector(const std::vector<std::string>& keys, Index rows,
                         const std::string& what) const;

private:
  /// A number stands for all contacts, three rows each of what has been read before.
  JsonValue of_all_contacts(const JsonValue& mu) const;

  std::string name_;
  std::map<std::string, SparseRows> parts_;
};

} // namespace lcpush::desktop
