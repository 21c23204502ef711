// SPDX-License-Identifier: Apache-2.0
#include "render/table_cache.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

#include <doctest/doctest.h>

#include "picture/temporary_directory.h"
#include "render/integrated_sky.h"
#include "render/scenes.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

namespace fs = std::filesystem;

/// The folder's only file.
fs::path onlyFileIn(const fs::path& folder) {
  std::vector<fs::path> all;
  for (const auto& one : fs::directory_iterator(folder)) all.push_back(one.path());
  REQUIRE(all.size() == 1);
  return all.front();
}

std::uintmax_t bytesOf(const fs::path& folder) {
  std::uintmax_t sum = 0;
  for (const auto& one : fs::directory_iterator(folder)) sum += one.file_size();
  return sum;
}

}  // namespace

TEST_CASE("a sky of which rings are found in a cache has the same bits as one without") {
  const TemporaryDirectory folder;
  const LoadedScene scene = columnsScene();
  const IntegratedSky plain = integrateSky(scene, 0.05);
  const auto withCache = [&] {
    LightStore store{BandStore(), ringStoreWith(TableCache(folder / "tables", 1'000'000'000, "test"))};
    return integrateSky(scene, 0.05, &store);
  };
  const IntegratedSky made = withCache(), found = withCache();
  CHECK(plain.directions > 0);
  CHECK(made.directions == plain.directions);
  CHECK(found.directions == 0);
  CHECK(found.error == plain.error);
  CHECK(found.cutOff == plain.cutOff);
  CHECK(found.reached == plain.reached);
  CHECK(found.info.undeviatedFraction() == plain.info.undeviatedFraction());
  for (const IntegratedSky* sky : {&made, &found})
    for (std::size_t c = 0; c < plain.image.channels.size(); ++c)
      CHECK(sky->image.channels[c].samples == plain.image.channels[c].samples);
}

TEST_CASE("a table comes back as it was kept, for the same key and program alone") {
  const TemporaryDirectory folder;
  const TableCache cache(folder.path(), 1'000'000, "one");
  const std::string table("a\0b\n", 4);
  CHECK_FALSE(cache.find("key"));
  cache.keep("key", table);
  CHECK(cache.find("key") == table);
  CHECK_FALSE(cache.find("other"));
  CHECK_FALSE(TableCache(folder.path(), 1'000'000, "two").find("key"));
}

TEST_CASE("a table with any byte damaged, cut short or replaced is none, and is made anew") {
  const TemporaryDirectory folder;
  const TableCache cache(folder.path(), 1'000'000, "program");
  cache.keep("key", "table");
  const fs::path file = onlyFileIn(folder.path());
  const std::string whole = contents(file);
  for (std::size_t k = 0; k < whole.size(); ++k) {
    CAPTURE(k);
    std::string damaged = whole;
    damaged[k] = static_cast<char>(damaged[k] ^ 1);
    put(file, damaged);
    CHECK_FALSE(cache.find("key"));
    put(file, whole.substr(0, k));
    CHECK_FALSE(cache.find("key"));
  }
  put(file, whole + "x");
  CHECK_FALSE(cache.find("key"));
  cache.keep("key", "table");
  CHECK(contents(file) == whole);
  CHECK(cache.find("key") == "table");
}

TEST_CASE("tables keep within their limit, those go first that were used last long ago, and other files stay") {
  const TemporaryDirectory folder;
  const TableCache cache(folder.path(), 4'000, "program");
  put(folder / "somebody's.txt", std::string(5'000, 'x'));
  const std::string table(1'000, 't');
  const auto now = fs::file_time_type::clock::now();
  int hours = 10;
  for (const char* key : {"a", "b", "c"}) {
    cache.keep(key, table);
    // Each as if it were older than the ones to come.
    for (const auto& one : fs::directory_iterator(folder.path()))
      if (one.path().extension() == ".table" && one.last_write_time() > now - std::chrono::hours(1))
        fs::last_write_time(one.path(), now - std::chrono::hours(hours));
    --hours;
  }
  CHECK(cache.find("a"));  // so it is younger than b
  cache.keep("d", table);
  CHECK_FALSE(cache.find("b"));
  for (const char* key : {"a", "c", "d"}) CHECK(cache.find(key) == table);
  CHECK(fs::exists(folder / "somebody's.txt"));
  CHECK(bytesOf(folder.path()) <= 9'000);
  cache.keep("large", std::string(4'000, 'l'));
  CHECK_FALSE(cache.find("large"));
  CHECK(cache.find("d"));
}

TEST_CASE("where no table can be kept nothing fails") {
  const TemporaryDirectory folder;
  put(folder / "file", "in the way");
  const TableCache cache(folder / "file" / "tables", 1'000'000, "program");
  CHECK_NOTHROW(cache.keep("key", "table"));
  CHECK_FALSE(cache.find("key"));
  CHECK(contents(folder / "file") == "in the way");
}

TEST_CASE("processes that keep and look for the same tables at the same time see whole ones or none") {
  const TemporaryDirectory folder;
  const std::string table(100'000, 't');
  std::vector<pid_t> children;
  for (int k = 0; k < 2; ++k) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      const TableCache cache(folder / "tables", 350'000, "program");
      int bad = 0;
      for (int round = 0; round < 60; ++round) {
        const std::string key = std::to_string(round % 5);
        cache.keep(key, key + table);
        const auto found = cache.find(key);
        if (found && *found != key + table) ++bad;
      }
      _exit(bad == 0 ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 1;
    waitpid(child, &status, 0);
    CHECK(status == 0);
  }
  CHECK(bytesOf(folder / "tables") <= 450'000);
  CHECK(bytesOf(folder / "tables") > 0);
}
