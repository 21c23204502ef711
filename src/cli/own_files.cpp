// SPDX-License-Identifier: Apache-2.0
#include "cli/own_files.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <initializer_list>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "cli/tables.h"
#include "picture/file_kind.h"
#include "picture/limits.h"
#include "render/own_pictures.h"

namespace parhelion::cli {

namespace {

constexpr std::string_view kChartMark = "<!-- parhelion ";  // behind the XML declaration

bool isOwnTable(std::string_view start) {
  const std::string_view columns = start.substr(0, start.find('\n'));
  return columns == kProfileColumns || columns == kMapColumns || columns == kPathColumns || columns == kLightColumns ||
         columns == std::string(kLightColumns) + kOtherLightColumns;
}

bool isOwnJson(const std::filesystem::path& path) {
  if (std::filesystem::file_size(path) > kMostOwnJsonBytes) return false;
  std::ifstream file(path);
  const auto json = nlohmann::json::parse(file, nullptr, false);
  const auto hasAll = [&json](std::initializer_list<const char*> keys) {
    return std::all_of(keys.begin(), keys.end(), [&json](const char* key) { return json.contains(key); });
  };
  return json.is_object() && (hasAll({"rays", "g", "delta", "by_order", "mean_path"}) ||
                              hasAll({"rays", "hits", "deposits", "engine", "energy"}) ||
                              hasAll({"rays", "hits", "method", "cpu_seconds", "peak_memory_bytes"}));
}

}  // namespace

bool isOwnFile(const std::filesystem::path& path) {
  const std::string start = startOfFile(path);
  const FileKind kind = kindOf(start);
  if (kind.isPhotograph()) return isOwnPicture(path);
  if (kind.family == FileKind::Family::empty)
    return std::filesystem::is_regular_file(path) && std::filesystem::file_size(path) == 0;
  if (kind.family != FileKind::Family::text) return false;
  if (start.starts_with('{')) return isOwnJson(path);
  return isOwnTable(start) || (start.starts_with("<?xml") && start.find(kChartMark) != std::string::npos);
}

}  // namespace parhelion::cli
