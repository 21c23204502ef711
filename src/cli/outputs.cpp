// SPDX-License-Identifier: Apache-2.0
#include "cli/outputs.h"

#include <filesystem>
#include <set>
#include <stdexcept>
#include <system_error>

#include <sys/stat.h>

#include "cli/own_files.h"
#include "picture/disk_space.h"
#include "picture/exr.h"
#include "picture/photograph.h"

namespace parhelion::cli {

namespace {

/// What one file has in common under all its names. Empty for what takes any number of outputs, such as /dev/null.
std::string identityOf(const std::string& name) {
  if (name == "-") return identityOf("/dev/stdout");
  struct stat status {};
  if (::stat(name.c_str(), &status) == 0) {
    if (S_ISCHR(status.st_mode)) return {};
    return std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino);
  }
  const std::filesystem::path place = followLinks(std::filesystem::absolute(name));
  std::error_code none;  // the path is complained about when it is opened
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(place, none);
  return none ? place.string() : canonical.string();
}

void requireDistinct(const Files& files) {
  std::set<std::string> taken;
  std::error_code none;  // what cannot be looked at cannot be read, of which its reader complains
  for (const std::string& input : files.inputs)
    if (std::filesystem::is_regular_file(input, none)) taken.insert(identityOf(input));
  // "-" can be the output of one option only, whatever stdout is.
  bool stdoutTaken = false;
  for (const std::string& output : files.outputs) {
    if (output.empty()) continue;
    const std::string identity = identityOf(output);
    const bool again = output == "-" && stdoutTaken;
    stdoutTaken = stdoutTaken || output == "-";
    if (again || (!identity.empty() && !taken.insert(identity).second))
      throw CLI::ValidationError("output", output + " would be written over the input or another output");
  }
}

/// Throws where the disks are too small for all of them together.
void requireSpace(const Files& files) {
  SpaceNeeds needs;
  for (const auto& [output, bytes] : files.leastBytes)
    if (!isNull(output)) needs.add(output, bytes);
}

void claimOutput(Transaction& run, const std::string& output, bool overwrite) {
  if (output.empty() || isNull(output)) return;
  run.claim(output);
  if (extensionOf(output) == ".exr") requireSourceDate();
  if (isStream(output) || overwrite || !std::filesystem::exists(output) || isOwnFile(output)) return;
  throw std::runtime_error(output +
                           ": is there and was not written by parhelion, so it is not replaced; name another output, "
                           "or say --overwrite");
}

}  // namespace

void addOverwrite(CLI::App& command, bool& overwrite) {
  command.add_flag("--overwrite", overwrite, "Replace files, too, that parhelion has not written");
}

Transaction claimOutputs(const Files& files, bool overwrite) {
  requireDistinct(files);
  Transaction run;
  for (const std::string& folder : files.folders) run.makeFolder(folder);
  for (const std::string& output : files.outputs) claimOutput(run, output, overwrite);
  requireSpace(files);
  return run;
}

void requireOutputs(const Files& files, bool overwrite) {
  requireDistinct(files);
  for (const std::string& output : files.outputs) {
    Transaction alone;
    claimOutput(alone, output, overwrite);
  }
  requireSpace(files);
}

bool isStream(const std::string& name) {
  if (name.empty()) return false;
  if (descriptorOf(name)) return true;
  struct stat status {};
  return ::stat(name.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

bool isNull(const std::string& name) {
  struct stat status {};
  struct stat null {};
  return ::stat(name.c_str(), &status) == 0 && ::stat("/dev/null", &null) == 0 && S_ISCHR(status.st_mode) &&
         status.st_rdev == null.st_rdev;
}

}  // namespace parhelion::cli
