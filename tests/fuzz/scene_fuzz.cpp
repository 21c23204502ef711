// SPDX-License-Identifier: Apache-2.0
// A scene, and behind a zero byte overrides, a line each.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/describe.h"
#include "scene/parse_scene.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  const std::string_view all(reinterpret_cast<const char*>(data), size);
  const std::size_t end = all.find('\0');
  std::vector<std::string> overrides;
  if (end != std::string_view::npos)
    for (std::string_view rest = all.substr(end + 1); !rest.empty() && overrides.size() < 8;) {
      const std::size_t line = std::min(rest.find('\n'), rest.size());
      overrides.emplace_back(rest.substr(0, line));
      rest.remove_prefix(std::min(line + 1, rest.size()));
    }
  try {
    describeScene(parseScene(all.substr(0, end), "scene", overrides).scene);
  } catch (const SceneError&) {
  }
  return 0;
}
