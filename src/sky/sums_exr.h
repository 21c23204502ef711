// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "picture/exr.h"
#include "picture/transaction.h"

namespace parhelion {

// Files of exact integers with checksums, which tallies of all kinds are. docs/outputs.md says how they can be read and
// checked without this program.

/// A plane of integers, row-major.
struct SumsPart {
  std::string name;  // "Y", "rings.hits"
  int width = 0, height = 0;
  bool blank = false;  // its numbers are known to be 0: nobody is asked for them

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

/// The plane for a list of numbers. Behind the last one it is filled up with zeros.
SumsPart listPart(std::string name, std::size_t numbers);

/// Sets `values` to those of a part from its number `first` on.
using SumsSource = std::function<void(std::size_t part, std::size_t first, std::span<std::int64_t> values)>;

/// Writes an EXR with a part for each plane, its 64-bit integers as two UINT channels `hi` and `lo`. The attributes get
/// "parhelion:" before their names, and stand in the first part's header together with the format, the parts and the
/// checksums. `software` stands there, too. In one piece or not at all. Throws std::runtime_error "path: reason".
void writeSumsExr(const Output& output, const ExrAttributes& attributes, std::span<const SumsPart> parts,
                  const SumsSource& source);

/// Such a file, open for reading.
class SumsExr {
 public:
  /// Throws std::runtime_error "path: reason" for files that are none, of another format, or whose header is damaged.
  explicit SumsExr(const std::filesystem::path& path);
  ~SumsExr();
  SumsExr(const SumsExr&) = delete;
  SumsExr& operator=(const SumsExr&) = delete;

  /// By their names without "parhelion:"; what the file needs for itself is not among them.
  const ExrAttributes& attributes() const { return attributes_; }

  const std::vector<SumsPart>& parts() const { return parts_; }

  /// Takes the numbers of a part in their order, some at a time: take(first, values). Throws std::runtime_error
  /// "path: reason" where the part is damaged, which is known only after its last number.
  void read(std::size_t part, const std::function<void(std::size_t, std::span<const std::int64_t>)>& take);

 private:
  struct File;

  void readHeader();
  void requireParts();

  std::filesystem::path path_;
  std::unique_ptr<File> file_;
  ExrAttributes attributes_;
  std::vector<SumsPart> parts_;
  std::vector<std::uint64_t> checksums_;  // by part
};

}  // namespace parhelion
