// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace parhelion {

/// The message of the Error that `work` throws, "" if none.
template <class Error = std::runtime_error, class F>
std::string errorOf(const F& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace parhelion
