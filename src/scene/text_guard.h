// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace parhelion {

struct TextProblem {
  int line;    // from 1
  int column;  // from 1, code points
  std::string message;
  std::string hint;
};

/// Looks for what a TOML parser must not be given: bytes that are no UTF-8; nesting so deep that the stack of a
/// recursive parser or destructor would be at risk; and what toml++ 3.3.0 has undefined behaviour on: some non-ASCII
/// text outside strings and comments (its issue 190), also in a string right after a number, a table's header without
/// a name, and brackets that close another kind. The rest of TOML's grammar is left to the parser.
std::optional<TextProblem> findTextProblem(std::string_view text);

}  // namespace parhelion
