// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "picture/staged_file.h"

namespace parhelion {

class Transaction;

/// Where a file is to be written: by itself, and then it appears when it is complete, or with the others of a run.
struct Output {
  Output(std::filesystem::path file, Transaction* run = nullptr) : path(std::move(file)), transaction(run) {}
  Output(const std::string& file) : path(file) {}
  Output(const char* file) : path(file) {}

  std::filesystem::path path;
  Transaction* transaction = nullptr;
};

/// The files of one run, which appear together or not at all. Each is complete and on the disk under a temporary name
/// before the first one is renamed. What fails or is killed before leaves all files as they were; a failing rename has
/// those before it taken back. Pipes and open descriptors get theirs before the first rename. Several threads may write
/// files of it; all else is for one thread.
class Transaction {
 public:
  Transaction() = default;
  ~Transaction();
  Transaction(Transaction&&) = default;
  Transaction& operator=(Transaction&&) = delete;

  /// Finds out whether the file can be written, and keeps other runs from writing it until commit() or the end.
  /// Throws std::runtime_error "path: reason".
  void claim(const std::filesystem::path& path);

  /// Makes a folder if it is not there. It goes away again without a commit. Throws std::runtime_error.
  void makeFolder(const std::filesystem::path& folder);

  /// That file as one of this run's. The transaction must not move as long as it is used.
  Output at(const std::filesystem::path& path) { return {path, this}; }

  /// All that was written appears. What was claimed only stays as it is. Throws std::runtime_error "path: reason".
  void commit();

  /// For AtomicFile: the file to write into, and what becomes of it when it is complete.
  StagedFile take(const std::filesystem::path& path);
  void stage(StagedFile file);

 private:
  std::unique_ptr<std::mutex> oneByOne_ = std::make_unique<std::mutex>();  // of what is claimed and staged
  std::vector<std::pair<std::filesystem::path, StagedFile>> claimed_;
  std::vector<StagedFile> staged_;
  std::vector<std::filesystem::path> madeFolders_;
};

}  // namespace parhelion
