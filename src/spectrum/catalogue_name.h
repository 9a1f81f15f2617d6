#pragma once

#include <string>
#include <string_view>

namespace lapidary {

/// The letters and digits of a name in lower case: "N-BK7", "n bk7" and "nbk7" are one name.
inline std::string catalogue_key(std::string_view name) {
  std::string key;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') key += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) key += c;
  }
  return key;
}

}  // namespace lapidary
