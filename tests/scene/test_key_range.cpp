// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <stdexcept>

#include "scene/key_range.h"

using namespace parhelion;

namespace {

using Values = std::vector<std::string>;

Values valuesOf(const std::string& text) { return parseKeyRange(text).values; }

template <class Work>
std::string refusal(Work work) {
  try {
    work();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace

TEST_CASE("a range holds both its ends where the step divides it, and decimals stay the decimals they are") {
  CHECK(parseKeyRange("sun.elevation=0:60:1").key == "sun.elevation");
  CHECK(valuesOf("sun.elevation=0:60:1").size() == 61);
  CHECK(valuesOf("k=0:1:0.1") == Values{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"});
  CHECK(valuesOf("k=0:1:0.3") == Values{"0", "0.3", "0.6", "0.9"});
  CHECK(valuesOf("k=-0.2:0.2:0.1") == Values{"-0.2", "-0.1", "0", "0.1", "0.2"});
  CHECK(valuesOf("k=-0.3:0.3:0.1") == Values{"-0.3", "-0.2", "-0.1", "0", "0.1", "0.2", "0.3"});
  CHECK(valuesOf("k=5:5:1") == Values{"5"});
  // The thousandth value of a running sum would be off by 1e-13 already.
  CHECK(valuesOf("k=0:1000:0.1")[9999] == "999.9");
  CHECK(valuesOf("k=0:1000:0.1").back() == "1000");
}

TEST_CASE("a range runs downward too, and a list keeps its order") {
  CHECK(valuesOf("k=1:-1:-0.5") == Values{"1", "0.5", "0", "-0.5", "-1"});
  CHECK(valuesOf("k=10,5,7.50") == Values{"10", "5", "7.5"});
  CHECK(valuesOf(" k = 3 , 4 ") == Values{"3", "4"});
  CHECK(parseKeyRange(" population.0.tilt =1").key == "population.0.tilt");
}

TEST_CASE("whole numbers such as seeds and numbers of rays keep all their digits") {
  CHECK(valuesOf("trace.seed=1234567890123456,1e6") == Values{"1234567890123456", "1000000"});
  CHECK(valuesOf("trace.rays=1e6:3e6:1e6") == Values{"1000000", "2000000", "3000000"});
}

TEST_CASE("dates run by steps of time on the clock of the first, and lists keep their own clocks") {
  CHECK(valuesOf("sun.date=2026-12-21T09:00:00+01:00:2026-12-21T08:40:00Z:20min") ==
        Values{"2026-12-21T09:00:00+01:00", "2026-12-21T09:20:00+01:00", "2026-12-21T09:40:00+01:00"});
  CHECK(valuesOf("k=2024-02-29T00:30Z:2024-02-28T00:00Z:-12h") ==
        Values{"2024-02-29T00:30:00Z", "2024-02-28T12:30:00Z", "2024-02-28T00:30:00Z"});
  CHECK(valuesOf("k=2026-12-21T09:00:00Z:2026-12-21T09:00:01Z:0.1s").size() == 11);
  CHECK(valuesOf("k=2026-12-21T09:00:00Z:2026-12-21T09:00:01Z:0.1s")[7] == "2026-12-21T09:00:00.7Z");
  CHECK(valuesOf("k=2026-01-01T12:00:00Z:2026-12-31T12:00:00Z:1d").size() == 365);
  CHECK(valuesOf("k= 2026-12-21T09:00:00+01:00 , 2026-06-21t09:00-05:30") ==
        Values{"2026-12-21T09:00:00+01:00", "2026-06-21T09:00:00-05:30"});
  CHECK(valuesOf("k=2026-12-21T09:00:00Z") == Values{"2026-12-21T09:00:00Z"});
}

TEST_CASE("dates that do not exist and steps that are no times are refused with what was meant") {
  const struct {
    const char *text, *says;
  } cases[] = {{"k=2026-02-30T09:00:00Z", "'2026-02-30T09:00:00Z' is no date"},
               {"k=2026-02-20T09:00:00", "no date and time that exists, with its offset"},
               {"k=2026-02-20T09:00:00Z,2026-02-29T09:00:00Z", "'2026-02-29T09:00:00Z' is no date"},
               {"k=2026-02-20T09:00:00Z,", "'' is no date"},
               {"k=2026-02-20T09:00:00Z:2026-02-21T09:00:00Z", "a range is from:to:step"},
               {"k=2026-02-20T09:00:00Z:2026-02-21T09:00:00Z:1h:2h", "'1h:2h' is no step of time"},
               {"k=2026-02-20T09:00:00Z:2026-02-21T09:00:00Z:1month", "'1month' is no step of time"},
               {"k=2026-02-20T09:00:00Z:2026-02-21T09:00:00Z:0s", "the step is 0"},
               {"k=2026-02-20T09:00:00Z:2026-02-21T09:00:00Z:-1h", "lead away from 2026-02-21T09:00:00Z"},
               {"k=2026-02-20T09:00:00Z:2027-02-21T09:00:00Z:1s", "more than 100000 values"},
               {"k=2026-02-20T09:00:00Z:2026-02-20T09:00:00.000001Z:0.0000001s", "below a microsecond"},
               {"k=2026-02-20T09:00:00Z;2026-02-21T09:00:00Z", "is no date"}};
  for (const auto& [text, says] : cases) {
    const std::string error = refusal([&, range = text] { parseKeyRange(range); });
    CHECK_MESSAGE(error.find(says) != std::string::npos, text << " said: " << error);
  }
}

TEST_CASE("what is no range is refused with what was meant") {
  const struct {
    const char *text, *says;
  } cases[] = {{"sun.elevation", "key=from:to:step"}, {"=1:2:1", "key=from:to:step"},
               {"k=", "'' is not a number"},          {"k=1,,2", "'' is not a number"},
               {"k=1:2", "a range is from:to:step"},  {"k=1:2:3:4", "a range is from:to:step"},
               {"k=1:2:x", "'x' is not a number"},    {"k=red,green", "'red' is not a number"},
               {"k=nan", "'nan' is not a number"},    {"k=0:inf:1", "'inf' is not a number"},
               {"k=0:1:0", "the step is 0"},          {"k=0:0:0", "the step is 0"},
               {"k=0:1:-0.1", "lead away from 1"},    {"k=0:1e9:1", "more than 100000 values"},
               {"k=-1e308:1e308:1e-300", "too long"}, {"k=1e9:1000000000.01:0.0001", "lost in 12 digits"}};
  for (const auto& [text, says] : cases) {
    const std::string error = refusal([&, range = text] { parseKeyRange(range); });
    CHECK_MESSAGE(error.find(says) != std::string::npos, text << " said: " << error);
  }
}

TEST_CASE("keys go together value by value, or in all combinations with the last key fastest") {
  const std::vector<KeyRange> ranges{parseKeyRange("a=1:2:1"), parseKeyRange("b=7,9")};
  using Frames = std::vector<Values>;
  CHECK(sweepFrames(ranges, false) == Frames{{"a=1", "b=7"}, {"a=2", "b=9"}});
  CHECK(sweepFrames(ranges, true) == Frames{{"a=1", "b=7"}, {"a=1", "b=9"}, {"a=2", "b=7"}, {"a=2", "b=9"}});
}

TEST_CASE("keys of different numbers of values cannot go together, and both numbers are told") {
  const std::vector<KeyRange> ranges{parseKeyRange("a=1:61:1"), parseKeyRange("b=7,9,11")};
  const std::string error = refusal([&] { sweepFrames(ranges, false); });
  CHECK(error.find("a has 61") != std::string::npos);
  CHECK(error.find("b has 3") != std::string::npos);
  CHECK(sweepFrames(ranges, true).size() == 183);
}

TEST_CASE("a key that comes twice and combinations without end are refused") {
  const std::vector<KeyRange> twice{parseKeyRange("a=1,2"), parseKeyRange("a=3,4")};
  CHECK(refusal([&] { sweepFrames(twice, true); }).find("a is given twice") != std::string::npos);
  const std::vector<KeyRange> many{parseKeyRange("a=1:1000:1"), parseKeyRange("b=1:1000:1")};
  CHECK(refusal([&] { sweepFrames(many, true); }).find("more than 100000 frames") != std::string::npos);
}
