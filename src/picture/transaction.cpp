// SPDX-License-Identifier: Apache-2.0
#include "picture/transaction.h"

#include <unistd.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <system_error>

#include "picture/file_reason.h"

namespace parhelion {

Transaction::~Transaction() {
  claimed_.clear();
  staged_.clear();
  for (const std::filesystem::path& folder : madeFolders_) ::rmdir(folder.c_str());
}

void Transaction::claim(const std::filesystem::path& path) { claimed_.emplace_back(path, StagedFile(path, true)); }

void Transaction::makeFolder(const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::create_directory(folder, error)) madeFolders_.push_back(folder);
  if (error) throw std::runtime_error(folder.string() + ": " + reasonFor(folder, error.value()));
}

StagedFile Transaction::take(const std::filesystem::path& path) {
  const std::scoped_lock alone(*oneByOne_);
  const auto found =
      std::find_if(claimed_.begin(), claimed_.end(), [&](const auto& claimed) { return claimed.first == path; });
  if (found == claimed_.end()) return StagedFile(path, false);
  StagedFile file = std::move(found->second);
  claimed_.erase(found);
  return file;
}

void Transaction::stage(StagedFile file) {
  const std::scoped_lock alone(*oneByOne_);
  staged_.push_back(std::move(file));
}

void Transaction::commit() {
  for (StagedFile& file : staged_) file.passOn();
  const Placing unbroken;
  std::size_t placed = 0;
  try {
    for (; placed < staged_.size(); ++placed) staged_[placed].place();
  } catch (const std::runtime_error&) {
    while (placed > 0) staged_[--placed].undo();
    throw;
  }
  std::set<std::filesystem::path> folders;
  for (const StagedFile& file : staged_)
    if (const auto folder = file.folder()) folders.insert(*folder);
  for (const std::filesystem::path& folder : folders) syncFolder(folder);
  staged_.clear();
  claimed_.clear();
  madeFolders_.clear();
}

}  // namespace parhelion
