// SPDX-License-Identifier: Apache-2.0
#include "render/frame_names.h"

#include <stdexcept>

#include "picture/photograph.h"

namespace parhelion {

namespace {

[[noreturn]] void refusePattern(const std::string& pattern, const std::string& reason) {
  throw std::invalid_argument("'" + pattern + "': " + reason);
}

}  // namespace

FrameNames::FrameNames(const std::string& pattern) {
  const std::string expected = "expected one number such as %04d in the name, for one frame_%04d.exr";
  bool numbered = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    std::string& part = numbered ? after_ : before_;
    if (pattern[i] != '%' || pattern.substr(i, 2) == "%%") {
      part += pattern[i];
      if (pattern[i] == '%') ++i;
      continue;
    }
    // %d, or %0 and the number of digits and d
    const std::size_t end = pattern.find_first_not_of("0123456789", i + 1);
    const std::string digits = end == std::string::npos ? "" : pattern.substr(i + 1, end - i - 1);
    const bool padded = digits.size() == 2 && digits[0] == '0';
    if (numbered || end == std::string::npos || pattern[end] != 'd' || !(digits.empty() || padded))
      refusePattern(pattern, expected + "; write %% for a percent sign");
    if (padded) digits_ = static_cast<std::size_t>(digits[1] - '0');
    numbered = true;
    i = end;
  }
  if (!numbered) refusePattern(pattern, expected);
  if (extensionOf("frame" + after_) != ".exr") refusePattern(pattern, "frames are .exr, each with a .png beside it");
}

std::filesystem::path FrameNames::operator()(std::size_t number) const {
  const std::string digits = std::to_string(number);
  return before_ + std::string(digits.size() < digits_ ? digits_ - digits.size() : 0, '0') + digits + after_;
}

}  // namespace parhelion
