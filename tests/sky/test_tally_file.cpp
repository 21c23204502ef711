// SPDX-License-Identifier: Apache-2.0
// A tally's file is read as it was written, or refused.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "damage.h"
#include "picture/exr_stream.h"
#include "sky/small_tallies.h"
#include "sky/sums_exr.h"
#include "sky/tally_exr.h"
#include "sky/tally_info_text.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

constexpr TallySymmetry kAll[] = {TallySymmetry::none, TallySymmetry::mirror, TallySymmetry::radial};

/// What is said of a tally that is written with right checksums after `change`.
std::string objectionAfter(TallySymmetry symmetry, const std::function<void(Tally&)>& change) {
  const TemporaryDirectory directory;
  Tally tally = smallTally(symmetry);
  change(tally);
  writeTallyExr(directory / "t.exr", tally);
  return errorOf([&] { readTallyExr(directory / "t.exr"); });
}

/// What is said of the attributes that `change` leaves.
std::string objectionTo(const std::function<void(ExrAttributes&)>& change) {
  ExrAttributes attributes = textFromInfo(smallTally().info);
  change(attributes);
  try {
    infoFromText(attributes);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a tally of any symmetry comes back from its file, rings and all") {
  const TemporaryDirectory directory;
  for (const TallySymmetry symmetry : kAll)
    for (const int colours : {1, 3}) {
      const Tally tally = smallTally(symmetry, colours);
      writeTallyExr(directory / "t.exr", tally);
      CHECK(readTallyExr(directory / "t.exr") == tally);
      CHECK(readTallyInfo(directory / "t.exr") == tally.info);
    }
}

TEST_CASE("a flipped bit or a cut in a plain tally is refused, or changes nothing that is read") {
  const TemporaryDirectory directory;
  const Tally tally = smallTally();
  writeTallyExr(directory / "t.exr", tally);
  const Survived survived = damaged(directory / "t.exr", [&] {
    Tally read = readTallyExr(directory / "t.exr");
    read.info.version = tally.info.version;
    return read == tally;
  });
  CHECK(survived.readWrong == 0);
  CHECK(survived.refused > 100);
}

TEST_CASE("a flipped bit or a cut in a radial tally is refused, or changes nothing that is read") {
  const TemporaryDirectory directory;
  const Tally tally = smallTally(TallySymmetry::radial, 1);
  writeTallyExr(directory / "t.exr", tally);
  const Survived survived = damaged(directory / "t.exr", [&] { return readTallyExr(directory / "t.exr") == tally; });
  CHECK(survived.readWrong == 0);
  CHECK(survived.refused > 100);
}

TEST_CASE("a file of sums has room for the numbers of 64 layers beside those of the whole") {
  const TemporaryDirectory directory;
  constexpr int kNumbers = 12, kLayers = 64;
  std::vector<SumsPart> parts;
  for (int i = 0; i < kNumbers * (kLayers + 1); ++i) parts.push_back({"part" + std::to_string(i), 5, 3});
  writeSumsExr(directory / "l.exr", {}, parts, [](std::size_t part, std::size_t first, auto values) {
    for (std::int64_t& value : values) value = static_cast<std::int64_t>(100 * part + first++);
  });
  SumsExr file(directory / "l.exr");
  REQUIRE(file.parts().size() == parts.size());
  const std::size_t last = parts.size() - 1;
  const auto place = std::ranges::find(file.parts(), parts[last].name, &SumsPart::name) - file.parts().begin();
  file.read(static_cast<std::size_t>(place), [&](std::size_t first, auto values) {
    for (const std::int64_t value : values) CHECK(value == static_cast<std::int64_t>(100 * last + first++));
  });
}

TEST_CASE("parts of zeros of several sizes, between others, come back from a file of sums") {
  const TemporaryDirectory directory;
  const std::vector<SumsPart> parts{
      {"a", 50, 40}, {"zero", 50, 40}, {"long", 90, 3}, {"empty", 90, 3}, {"none", 50, 40}};
  const auto valueAt = [](std::size_t part, std::size_t i) {
    return part % 2 == 1 || part == 4 ? 0 : static_cast<std::int64_t>(i * i + part) << 30;
  };
  writeSumsExr(directory / "t.exr", {}, parts,
               [&](std::size_t part, std::size_t first, std::span<std::int64_t> values) {
                 for (std::size_t i = 0; i < values.size(); ++i) values[i] = valueAt(part, first + i);
               });
  SumsExr file(directory / "t.exr");
  REQUIRE(file.parts().size() == parts.size());
  for (std::size_t place = 0; place < parts.size(); ++place) {
    const auto of = std::ranges::find(parts, file.parts()[place].name, &SumsPart::name) - parts.begin();
    std::size_t count = 0;
    file.read(place, [&](std::size_t first, std::span<const std::int64_t> values) {
      for (std::size_t i = 0; i < values.size(); ++i)
        CHECK(values[i] == valueAt(static_cast<std::size_t>(of), first + i));
      count += values.size();
    });
    CHECK(count == parts[static_cast<std::size_t>(of)].size());
  }
}

TEST_CASE("sums that no run makes are refused, though their checksums fit") {
  constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
  for (const TallySymmetry symmetry : kAll) {
    CAPTURE(std::string(nameOf(symmetry)));
    CHECK(objectionAfter(symmetry, [](Tally&) {}).empty());
    for (int slot = 0; slot < 6; ++slot) {
      CAPTURE(slot);
      for (const std::int64_t bad : {kLeast, std::int64_t{-1}})
        CHECK(has(objectionAfter(symmetry, [&](Tally& t) { t.setRaw(5, slot, bad); }), "and should be 0 or more"));
    }
    CHECK(has(objectionAfter(symmetry, [](Tally& t) { t.setRaw(5, Tally::kFirstHalf, t.raw(5, Tally::kY) + 1); }),
              "first half's light of the pixel in column 5, row 0"));
    for (const int slot : {Tally::kY, Tally::kX, Tally::kZ}) {
      CAPTURE(slot);
      const std::int64_t tooMuch = toFixed(symmetry == TallySymmetry::mirror ? 900.0 : 450.0);
      CHECK(has(objectionAfter(symmetry,
                               [&](Tally& t) {
                                 t.setRaw(5, slot, tooMuch);
                                 if (slot == Tally::kY) t.setRaw(5, Tally::kSquares, tooMuch / 4);
                               }),
                symmetry == TallySymmetry::radial || slot != Tally::kY ? "at most what the crystals have intercepted"
                                                                       : "and should be at"));
    }
    CHECK(has(objectionAfter(symmetry, [](Tally& t) { t.setRaw(5, Tally::kHits, 1'000'000); }), "number of hits"));
    CHECK(has(objectionAfter(symmetry, [](Tally& t) { t.setRaw(5, Tally::kHits, 0); }), "0 where there is no hit"));
    if (symmetry == TallySymmetry::radial) continue;
    CHECK(has(objectionAfter(symmetry, [](Tally& t) { t.setRaw(5, Tally::kSquares, 0); }), "at least the squared"));
    CHECK(has(objectionAfter(symmetry, [](Tally& t) { t.setRaw(5, Tally::kSquares, toFixed(1e5, kSquareScale)); }),
              "at most the squared"));
  }
}

TEST_CASE("all pixels together hold no more than was intercepted") {
  CHECK(has(objectionAfter(TallySymmetry::none,
                           [](Tally& t) {
                             for (int pixel = 0; pixel < t.pixels(); ++pixel)
                               for (int i = 0; i < 20; ++i) t.add(pixel, 0.5 * t.info.white, true);
                           }),
            "of all pixels together"));
}

TEST_CASE("rings that no run makes are refused") {
  const auto after = [](int slot, std::int64_t value) {
    return objectionAfter(TallySymmetry::radial, [&](Tally& t) { t.makeRings(t.info.toSun()).setRaw(7, slot, value); });
  };
  CHECK(has(after(Tally::kY, -1), "of ring 7"));
  CHECK(has(after(Tally::kHits, -1), "of ring 7"));
  CHECK(has(after(Tally::kHits, 401), "of ring 7"));
  CHECK(has(after(Tally::kY, toFixed(1e6)), "of ring 7"));
}

TEST_CASE("totals that do not fit each other or the rays are refused") {
  const auto after = [](const std::function<void(TallyInfo&)>& change) {
    return objectionAfter(TallySymmetry::none, [&](Tally& t) { change(t.info); });
  };
  CHECK(has(after([](TallyInfo& i) { i.intercepted = {}; }), "undeviated"));
  CHECK(has(after([](TallyInfo& i) { i.intercepted = i.undeviated = {}; }), "intercepted by 400 rays"));
  CHECK(has(after([](TallyInfo& i) { i.interceptedXyz[1] = {}; }), "intercepted by 400 rays"));
  CHECK(has(after([](TallyInfo& i) { i.rays.clear(); }), "intercepted by 0 rays"));
  CHECK(has(after([](TallyInfo& i) { i.rays = {{0, 100'000}}; }), "intercepted by 100000 rays"));
  CHECK(has(after([](TallyInfo& i) { i.intercepted = i.interceptedXyz[1] = LightTotal(toFixed(1e9)); }),
            "and should be about 400"));
  CHECK(has(after([](TallyInfo& i) { i.undeviated = LightTotal(-5); }), "parhelion:undeviated is '-5'"));
  CHECK(has(objectionAfter(TallySymmetry::none,
                           [](Tally& t) {
                             t.info.rays.clear();
                             t.info.intercepted = t.info.undeviated = {};
                             t.info.interceptedXyz = {};
                           }),
            "number of hits"));
}

TEST_CASE("attributes that make no sense are refused with what they are and what they should be") {
  const auto with = [](const char* name, const char* value) {
    return objectionTo([&](ExrAttributes& a) { a[name] = value; });
  };
  CHECK(objectionTo([](ExrAttributes&) {}).empty());
  for (const char* rays : {"5+0", "10+5 5+3", "0+5 4+3", "18446744073709551615+1", "5", "5+", "+5", "5+5 ", " 5+5",
                           "5+5  20+5", "5-5", "5+5,20+5", "-5+3", "99999999999999999999+1"})
    CHECK(has(with("rays", rays), "parhelion:rays is '" + std::string(rays) + "', and should be ranges"));
  for (const char* elevation : {"nan", "inf", "-inf", "2", "", "0x1", "0.3 "})
    CHECK(has(with("sun.elevation", elevation), "parhelion:sun.elevation is '"));
  for (const char* white : {"nan", "-1", "inf"}) CHECK(has(with("white.X", white), "parhelion:white.X is '"));
  for (const char* units : {"nan", "-1", "1.5", "", "170141183460469231731687303715884105728"})
    CHECK(has(with("intercepted", units), "parhelion:intercepted is '"));
  CHECK(with("intercepted", "170141183460469231731687303715884105727").empty());
  CHECK(has(with("scene.hash", "12"), "16 hexadecimal digits"));
  CHECK(has(with("symmetry", "round"), "none, mirror or radial"));
  CHECK(has(with("camera.azimuth", "nan"), "parhelion:camera.azimuth is 'nan'"));
  for (const auto& [name, value] : textFromInfo(smallTally().info)) {
    if (name.starts_with("camera.shift")) continue;  // left out where it is 0
    CAPTURE(name);
    CHECK(has(objectionTo([name = name](ExrAttributes& a) { a.erase(name); }), "is missing"));
  }
}

TEST_CASE("tallies of before and of times to come are refused by name, with the way out") {
  const TemporaryDirectory directory;
  const Tally tally = smallTally();
  const auto path = directory / "t.exr";
  writeTallyExr(path, tally);
  std::string bytes = contents(path);
  const std::string attribute = "parhelion:tally" + std::string("\0string\0\1\0\0\0", 12);
  const std::size_t at = bytes.find(attribute);
  REQUIRE(at != std::string::npos);
  for (const char format : {'2', '4'}) {
    bytes[at + attribute.size()] = format;
    put(path, bytes);
    const std::string error = errorOf([&] { readTallyExr(path); });
    CHECK(has(error, path.string() + ": a tally of format " + format));
    CHECK(has(error, "trace it again"));
  }
}
