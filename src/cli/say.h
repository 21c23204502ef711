// SPDX-License-Identifier: Apache-2.0
#pragma once

// The only way for words to a terminal: whatever a file, a name or a command line has put into them arrives escaped
// (scene/utf8.h). Tables, JSON and pictures go through text_output.h and picture/ instead.

#include <string>
#include <string_view>

namespace parhelion::cli {

/// A line on stderr, made as printf() does, without its end. Of a line that is too long for anybody to read the middle
/// is left out: the reason stands at the end.
[[gnu::format(printf, 1, 2)]] void say(const char* format, ...);

/// The same on stdout: the answer that a command was asked for.
[[gnu::format(printf, 1, 2)]] void answer(const char* format, ...);

// Texts of several lines, as they are but for what acts on a terminal.
void sayLines(std::string_view text);
void answerLines(std::string_view text);

/// The first bytes of a text that somebody has put into a file, with "…" where there are more.
std::string shortened(std::string_view text);

/// A word of a command line in a message: in quotes, its end left out where that is far away.
std::string inQuotes(std::string_view word);

}  // namespace parhelion::cli
