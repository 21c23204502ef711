// SPDX-License-Identifier: Apache-2.0
// The file of a tally, or what such a file is to hold. No mutation of a file has checksums that fit; those of a file
// that is made here do, so that what it says is looked at. Such an input is
//   - attributes "name=value" without "parhelion:", each with a zero byte behind it, and one more at their end,
//   - the parts of the file in the same way, as "Y=12x9",
//   - the integers that are not 0: number of the part (8 bits), place in it (32), value (64), the lowest byte first.
// A tally that is read is shown, reconstructed, and added to another one.
#include <cstring>
#include <optional>
#include <string_view>

#include "input_file.h"
#include "math/number_text.h"
#include "parallel/threads.h"
#include "recon/reconstruct.h"
#include "render/measured_tally.h"
#include "render/tally_sum.h"
#include "sky/radiance.h"
#include "sky/sums_exr.h"
#include "sky/tally_exr.h"

namespace {

using namespace parhelion;

/// The next list of an input, without the byte at its end.
std::vector<std::pair<std::string, std::string>> takeList(std::string_view& input) {
  std::vector<std::pair<std::string, std::string>> list;
  while (!input.empty()) {
    const std::size_t end = std::min(input.find('\0'), input.size());
    const std::string_view entry = input.substr(0, end);
    input.remove_prefix(std::min(end + 1, input.size()));
    if (entry.empty()) break;
    const std::size_t equals = std::min(entry.find('='), entry.size());
    list.emplace_back(entry.substr(0, equals), entry.substr(std::min(equals + 1, entry.size())));
  }
  return list;
}

std::optional<SumsPart> partFrom(const std::string& name, std::string_view size) {
  constexpr std::int64_t kMostNumbers = 1 << 14;  // the rings of a sky are 9000
  const std::size_t x = std::min(size.find('x'), size.size());
  const auto width = wholeNumberIn(size.substr(0, x));
  const auto height = wholeNumberIn(size.substr(std::min(x + 1, size.size())));
  const auto fits = [](std::optional<std::int64_t> side) { return side && *side >= 1 && *side <= kMostNumbers; };
  if (!fits(width) || !fits(height) || *width * *height > kMostNumbers) return {};
  return SumsPart{name, static_cast<int>(*width), static_cast<int>(*height)};
}

/// An integer of a file.
struct Number {
  std::uint8_t part = 0;
  std::uint32_t place = 0;
  std::int64_t value = 0;
};

std::vector<Number> numbersIn(std::string_view bytes) {
  const auto take = [&bytes](auto& value) {
    std::memcpy(&value, bytes.data(), sizeof value);
    bytes.remove_prefix(sizeof value);
  };
  constexpr std::size_t kOfNumber = 13;  // bytes
  std::vector<Number> numbers;
  while (bytes.size() >= kOfNumber) {
    Number& number = numbers.emplace_back();
    take(number.part);
    take(number.place);
    take(number.value);
  }
  return numbers;
}

/// Writes the file that an input describes. Throws std::runtime_error where there can be none.
void writeFile(const std::filesystem::path& path, std::string_view input) {
  constexpr std::size_t kMostParts = 16;
  ExrAttributes attributes;
  for (auto& [name, value] : takeList(input)) attributes[name] = value;
  std::vector<SumsPart> parts;
  for (const auto& [name, size] : takeList(input))
    if (const auto part = partFrom(name, size); part && parts.size() < kMostParts) parts.push_back(*part);
  if (parts.empty()) throw std::runtime_error("no parts");
  const std::vector<Number> numbers = numbersIn(input);
  writeSumsExr(path, attributes, parts, [&](std::size_t part, std::size_t first, std::span<std::int64_t> values) {
    std::memset(values.data(), 0, values.size_bytes());
    for (const Number& number : numbers)
      if (number.part == part && number.place >= first && number.place - first < values.size())
        values[number.place - first] = number.value;
  });
}

/// Moves rays far away, so that they are other ones. None where there is no room for them.
template <class Origin>
bool moveRays(Origin& origin) {
  constexpr std::uint64_t kFar = std::uint64_t{1} << 62;
  if (!origin.rays.empty() && origin.rays.back().end() >= kFar) return false;
  for (RayRange& range : origin.rays) range.first += kFar;
  return true;
}

/// Adding may find that sums do not fit, and then leaves them as they were; what was added can be taken out.
template <class Tally, class Origin, class Add, class TakeOut, class IsSame>
void addAndTakeOut(Tally tally, Origin Tally::*origin, const Add& add, const TakeOut& takeOut, const IsSame& isSame) {
  const Tally before = tally;
  Tally other = tally;
  if (!moveRays(other.*origin)) return;
  try {
    add(tally, other);
  } catch (const std::overflow_error&) {
    return require(isSame(tally, before));
  }
  takeOut(tally, other);
  require(isSame(tally, before));
}

void useSky(const std::filesystem::path& path) {
  Tally tally = readTallyExr(path);
  if (tally.rings()) tally.spreadRings();  // a file may hold other pixels, which adding makes anew
  addAndTakeOut(
      tally, &Tally::info, [](Tally& all, const Tally& more) { all.merge(more); },
      [](Tally& all, const Tally& more) { all.subtract(more); },
      [](const Tally& one, const Tally& other) { return one == other; });
  constexpr int kFewPixels = 200;
  plainRadiance(tally);
  // One thread: many take addresses, of which our driver allows a gigabyte.
  static Threads one(1);
  if (tally.pixels() <= kFewPixels) one.run([&] { reconstruct(tally, AdaptiveSettings()); });
}

template <class Tally>
void useMeasured(const Tally& tally) {
  addAndTakeOut(
      tally, &Tally::origin, [](Tally& all, const Tally& more) { mergeTally(all, more); },
      [](Tally& all, const Tally& more) { subtractTally(all, more); },
      [](const Tally& one, const Tally& other) {
        return one.origin == other.origin && one.sums.totals() == other.sums.totals();
      });
}

void useFile(const std::filesystem::path& path) {
  const std::vector<TallyFile> file{{path, "tally"}}, twice{{path, "one"}, {path, "other"}};
  const TallySet set = fittingTallies(file);
  if (!set.origin.rays.empty()) {
    try {
      fittingTallies(twice);
      require(false);  // the rays are in both
    } catch (const TallyMisfit&) {
    }
  }
  switch (set.kind) {
    case TallyKind::sky:
      return useSky(path);
    case TallyKind::map:
      return useMeasured(readMapTally(path));
    case TallyKind::profile:
      return useMeasured(readProfileTally(path));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Limits limits;
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::filesystem::path& path = inputFile(data, size);
  if (input.starts_with("v/1\x01")) {
    mayRefuse([&] { useFile(path); });
    return 0;
  }
  static const MemoryFile file;
  const std::filesystem::path& made = file.emptied();
  if (mayRefuse([&] { writeFile(made, input); })) mayRefuse([&] { useFile(made); });
  return 0;
}
