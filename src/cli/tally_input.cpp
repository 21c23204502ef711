// SPDX-License-Identifier: Apache-2.0
#include "cli/tally_input.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "cli/commands.h"
#include "cli/file_words.h"
#include "cli/outputs.h"
#include "cli/say.h"
#include "picture/exr.h"
#include "picture/file_kind.h"
#include "picture/file_reason.h"
#include "picture/memory_limit.h"
#include "render/scene_attributes.h"

namespace parhelion::cli {

namespace {

// More than the largest tally: 6 parts of kMaxImagePixels 64-bit integers.
constexpr std::uint64_t kMostSpooled = std::uint64_t{1} << 34;

std::string tallyName(const std::string& name) { return name == "-" ? "stdin" : name; }

[[noreturn]] void fail(const std::string& name, const std::string& reason) {
  throw std::runtime_error(tallyName(name) + ": " + reason);
}

}  // namespace

TallyInputs::Spooled TallyInputs::spooled(const std::string& name) const {
  const int pipe = name == "-" ? ::dup(STDIN_FILENO) : ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (pipe < 0) fail(name, reasonFor(name, errno));
  const Spooled from(::fdopen(pipe, "rb"));
  Spooled to(std::tmpfile());
  if (!from || !to) fail(name, std::strerror(errno));
  std::array<char, 65536> block{};
  std::uint64_t bytes = 0;
  while (const std::size_t more = std::fread(block.data(), 1, block.size(), from.get())) {
    if (bytes == 0 && kindOf({block.data(), more}).family != FileKind::Family::exr)
      fail(name, "not a tally of Parhelion");
    bytes += more;
    if (bytes > kMostSpooled) fail(name, "longer than any tally, " + byteText(kMostSpooled));
    if (std::fwrite(block.data(), 1, more, to.get()) != more) fail(name, std::strerror(errno));
  }
  if (std::ferror(from.get())) fail(name, std::strerror(EIO));
  if (bytes == 0) fail(name, "nothing came out of it");
  if (std::fflush(to.get()) != 0) fail(name, std::strerror(errno));
  return to;
}

TallyInputs::TallyInputs(std::span<const std::string> names) {
  for (const std::string& name : names) {
    if (!isStream(name)) {
      requireFit(name, Wanted::tally);
      files_.push_back({name, name});
      continue;
    }
    spooled_.push_back(spooled(name));
    files_.push_back({"/proc/self/fd/" + std::to_string(::fileno(spooled_.back().get())), tallyName(name)});
  }
}

bool isTallyFile(const std::string& name) {
  if (kindOf(startOfFile(name)).family != FileKind::Family::exr) return false;
  try {
    return readExrAttributes(name).contains(kTallyKey);
  } catch (const std::runtime_error&) {  // damaged: of which kind, its reader may say
    return false;
  }
}

bool isMeasuredTally(const std::string& name) {
  return isTallyFile(name) && tallyKindOf(std::filesystem::path(name)) != TallyKind::sky;
}

void requireMeasured(const RunOptions& options, TallyKind kind) {
  const TallyKind found = tallyKindOf(options.scene);
  if (found != kind)
    throw Unfit(options.scene + ": is the tally of a " + std::string(nameOf(found)) + ", not of a " +
                std::string(nameOf(kind)));
  if (!options.rays.empty() || !options.overrides.empty() || !options.seed.empty() || !options.engine.empty() ||
      !options.sampler.empty() || !options.stats.empty())
    throw Unfit(options.scene +
                ": is traced already: -D, --rays, --seed, --engine, --sampler and --stats are for scenes");
}

void reportMissing(const TallySet& set, bool complete, bool quiet) {
  if (set.missing.empty()) return;
  const std::string words = wordsFor(set.missing) + (countOf(set.missing) == 1 ? " is missing" : " are missing");
  if (complete) throw Unfit(words);
  if (!quiet) say("%s", words.c_str());
}

TallySet requireFitting(const TallyInputs& inputs) {
  try {
    return fittingTallies(inputs.files());
  } catch (const TallyMisfit& error) {
    throw Unfit(error.what());
  }
}

}  // namespace parhelion::cli
