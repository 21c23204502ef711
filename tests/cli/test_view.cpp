// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "picture/exr.h"
#include "picture/photograph.h"
#include "rendered_sky.h"
#include "sky/tally_exr.h"

using namespace parhelion::test;
using parhelion::Photograph;
using parhelion::readPhotograph;

namespace {

std::vector<std::uint8_t> samples(const Photograph& photograph) {
  return std::get<std::vector<std::uint8_t>>(photograph.samples);
}

const std::string kCamera =
    " --projection fisheye-equal-area --fov-horizontal 90 --azimuth 0 --elevation 25 --roll 0 "
    "--sun-elevation 20 ";

}  // namespace

TEST_CASE("a sky without lines and filters is its preview, and a photograph is itself") {
  WithSky folder;
  const Outcome outcome = run(folder, "parhelion view s.exr -o v.png");
  CHECK(outcome.exit == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find("exposure") != std::string::npos);
  CHECK(outcome.err.find("wrote v.png") != std::string::npos);
  CHECK(samples(readPhotograph(folder / "v.png")) == samples(readPhotograph(folder / "s.png")));
  CHECK(run(folder, "parhelion view s.png -o w.png --quiet").err.empty());
  CHECK(samples(readPhotograph(folder / "w.png")) == samples(readPhotograph(folder / "s.png")));
  // Its scene goes along, so that a view can be viewed again.
  CHECK(readPhotograph(folder / "v.png").text.at("parhelion:scene").find("columns") != std::string::npos);
  CHECK(run(folder, "parhelion view v.png --grid -o again.png").exit == 0);
}

TEST_CASE("the lines over a sky are those over its preview with the same camera, and those of the layer") {
  WithSky folder;
  REQUIRE(run(folder, "parhelion view s.exr --overlay --layer sky.png -o a.png").exit == 0);
  REQUIRE(run(folder, "parhelion view s.png --overlay --layer photo-lines.png -o b.png" + kCamera).exit == 0);
  CHECK(samples(readPhotograph(folder / "a.png")) == samples(readPhotograph(folder / "b.png")));
  const Photograph layer = readPhotograph(folder / "sky.png");
  CHECK(layer.channels == 4);
  CHECK(samples(layer) == samples(readPhotograph(folder / "photo-lines.png")));
  CHECK(samples(readPhotograph(folder / "a.png")) != samples(readPhotograph(folder / "s.png")));
}

TEST_CASE("a picture in absolute units is exposed by an exposure value, on any tone curve") {
  WithSky folder;
  parhelion::Image image{2, 1, {}};
  // 0.125 * 2^13 cd/m2, and five stops more.
  for (const char* name : {"R", "G", "B"}) image.add(name) = {4.0F, 128.0F};
  parhelion::writeBeautyExr(folder / "absolute.exr", image, {{parhelion::kWhiteLuminanceKey, "256"}});
  std::set<int> bright;
  for (const std::string tone : {"", " --tone reinhard", " --tone filmic", " --tone linear"}) {
    const Outcome outcome = run(folder, "parhelion view absolute.exr --ev 13 -o v.png" + tone);
    REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
    const auto shown = samples(readPhotograph(folder / "v.png"));
    CHECK(std::abs(shown[0] - 118) <= 1);  // 18 % of white in sRGB
    bright.insert(shown[3]);
  }
  CHECK(bright.size() == 3);  // the usual one is reinhard
  REQUIRE(run(folder, "parhelion view absolute.exr --ev 12 -o v.png --tone linear").exit == 0);
  CHECK(std::abs(samples(readPhotograph(folder / "v.png"))[0] - 162) <= 1);  // 36 %
}

TEST_CASE("glare puts a veil around the sun that is drawn, and needs to know the camera") {
  WithSky folder;
  REQUIRE(
      run(folder, "parhelion render s.toml -D sun.visible=true -D camera.image_circle=80 -o sun.exr --quiet").exit ==
      0);
  REQUIRE(run(folder, "parhelion view sun.exr --exposure -3 --glare eye -o dazzled.png").exit == 0);
  REQUIRE(run(folder, "parhelion view sun.exr --exposure -3 --glare none -o plain.png").exit == 0);
  const auto dazzled = samples(readPhotograph(folder / "dazzled.png"));
  const auto plain = samples(readPhotograph(folder / "plain.png"));
  double with = 0.0, without = 0.0;
  for (std::size_t i = 0; i < plain.size(); ++i) {
    with += dazzled[i];
    without += plain[i];
  }
  CHECK(with > 1.02 * without);
  // The corners of a fisheye show nothing, with glare or without.
  for (int c = 0; c < 3; ++c) CHECK(dazzled[static_cast<std::size_t>(c)] == 0);
  parhelion::Image image{2, 1, {}};
  for (const char* name : {"R", "G", "B"}) image.add(name) = {4.0F, 128.0F};
  parhelion::writeBeautyExr(folder / "bare.exr", image, {});
  const Outcome outcome = run(folder, "parhelion view bare.exr --glare eye -o v.png");
  CHECK(outcome.exit == 2);
  CHECK(outcome.err.find("--glare: bare.exr has no scene that tells its camera") != std::string::npos);
}

TEST_CASE("a view of 16 bits is finer than one of 8 bits, and the same picture") {
  WithSky folder;
  for (const std::string more : {"", " --overlay", " --unsharp 2,3", " --reduce 2"}) {
    REQUIRE(run(folder, "parhelion view s.exr --bits 16 -o deep.png" + more).exit == 0);
    REQUIRE(run(folder, "parhelion view s.exr --bits 8 -o flat.png" + more).exit == 0);
    const Photograph deep = readPhotograph(folder / "deep.png");
    const auto fine = std::get<std::vector<std::uint16_t>>(deep.samples);
    const auto coarse = samples(readPhotograph(folder / "flat.png"));
    REQUIRE(fine.size() == coarse.size());
    CHECK(std::set<std::uint16_t>(fine.begin(), fine.end()).size() > 256);
    for (std::size_t i = 0; i < fine.size(); ++i) CHECK(std::abs(fine[i] / 257.0 - coarse[i]) < 2.0);
    CHECK(deep.text.contains("parhelion:scene"));
  }
}

TEST_CASE("each line can be asked for by itself, with and without numbers") {
  WithSky folder;
  std::set<std::vector<std::uint8_t>> different;
  for (const std::string lines : {"--grid", "--grid 20", "--circles", "--circles 22", "--circles 22,46",
                                  "--horizon-line", "--zenith --grid", "--halos", "--halos --labels", "--overlay"}) {
    const Outcome outcome = run(folder, "parhelion view s.exr -o v.png " + lines);
    CHECK_MESSAGE(outcome.exit == 0, lines << outcome.err);
    different.insert(samples(readPhotograph(folder / "v.png")));
  }
  CHECK(different.size() >= 9);  // this picture does not show the zenith
}

TEST_CASE("a preview knows its scene, in other folders and sizes too, and one without it asks the sky beside it") {
  WithSky folder;
  std::filesystem::create_directory(folder / "elsewhere");
  std::filesystem::copy_file(folder / "s.png", folder / "elsewhere/COPY.PNG");
  REQUIRE(run(folder, "parhelion view s.exr --overlay --layer sky.png --quiet").exit == 0);
  const auto lines = samples(readPhotograph(folder / "sky.png"));
  const auto check = [&](const std::string& picture, const std::string& scene) {
    const Outcome outcome = run(folder, "parhelion view " + picture + " --overlay --layer lines.png");
    CHECK_MESSAGE(outcome.exit == 0, outcome.err);
    CHECK_MESSAGE(outcome.err.find("scene in " + scene + "\n") != std::string::npos, outcome.err);
    CHECK(samples(readPhotograph(folder / "lines.png")) == lines);
  };
  check("s.png", "s.png");
  check("elsewhere/COPY.PNG", "elsewhere/COPY.PNG");
  // Its text lost, as messengers and photo sites do.
  std::filesystem::copy_file(folder / "photo.png", folder / "s.png", std::filesystem::copy_options::overwrite_existing);
  check("s.png", "s.exr");
  std::filesystem::rename(folder / "s.exr", folder / "s.EXR");
  check("s.png", "s.EXR");

  REQUIRE(run(folder, "parhelion view s.EXR --reduce 2 -o half.png").exit == 0);
  CHECK(run(folder, "parhelion view half.png --overlay -o v.png").exit == 0);
  CHECK(readPhotograph(folder / "v.png").width == 48);
}

TEST_CASE("an overlay names what the scene's crystals make, or those that are asked for") {
  WithSky folder;
  std::set<std::vector<std::uint8_t>> different;
  const auto lines = [&](const std::string& options) {
    const Outcome outcome = run(folder, "parhelion view " + options + " --layer lines.png");
    CHECK_MESSAGE(outcome.exit == 0, outcome.err);
    different.insert(samples(readPhotograph(folder / "lines.png")));
    return outcome.err;
  };
  CHECK(lines("s.exr --overlay").find("halos of the crystals in s.exr") != std::string::npos);
  CHECK(lines("photo.png --overlay" + kCamera).find("photo.png has no scene") != std::string::npos);
  writeFile(folder / "plates.toml", "[[population]]\nname = \"p\"\norientation = \"plate\"\n");
  CHECK(lines("s.exr --overlay --scene plates.toml").find("crystals in plates.toml") != std::string::npos);
  CHECK(different.size() == 3);
  lines("s.exr --overlay --crystals plates");
  CHECK(different.size() == 3);  // the same as those of the scene of plates
  lines("s.exr --overlay --crystals plates,columns");
  lines("s.exr --overlay --crystals plates --no-below-horizon");
  CHECK(different.size() == 5);
}

TEST_CASE("an overlay names no halos on the ground, nor where no sunlight reaches the crystals") {
  WithSky folder;
  const auto lines = [&](const std::string& scene, const std::string& options = "") {
    const Outcome made = run(folder, "parhelion render s.toml -o sky.exr --rays 1k --overwrite " + scene);
    CHECK_MESSAGE(made.exit == 0, made.err);
    const Outcome outcome = run(folder, "parhelion view sky.exr --halos --layer lines.png --overwrite" + options);
    CHECK_MESSAGE(outcome.exit == 0, outcome.err);
    const auto drawn = samples(readPhotograph(folder / "lines.png"));
    return std::tuple(std::ranges::any_of(drawn, [](int sample) { return sample != 0; }), made.err, outcome.err);
  };
  const std::string down = "-D camera.elevation=-40 -D sun.elevation=20 ";  // the 46 degree ring reaches there
  CHECK(std::get<0>(lines(down)));
  CHECK(std::get<0>(lines(down + "-D sky.air=true -D observer.altitude=3000")));
  CHECK_FALSE(std::get<0>(lines(down + "-D sky.air=true")));
  CHECK_FALSE(std::get<0>(lines(down + "-D camera.horizon=cut")));
  CHECK(std::get<0>(lines(down + "-D sky.air=true", " --below-horizon")));
  const std::string set = "-D sun.elevation=-3 -D camera.elevation=60 ";
  CHECK(std::get<0>(lines(set)));
  const auto [drawn, made, viewed] = lines(set + "-D sky.air=true");
  CHECK_FALSE(drawn);
  CHECK(made.find("there is no halo: the sun is below the horizon") != std::string::npos);
  CHECK(viewed.find("no halos: the sun is below the horizon") != std::string::npos);
  const auto [inCloud, clouded, ofCloud] = lines(set + "-D cloud.optical_depth=1");
  CHECK_FALSE(inCloud);
  CHECK(clouded.find("there is no halo: a cloud without an end takes all light of a sun that is not above the") !=
        std::string::npos);
}

TEST_CASE("side by side both pictures are treated alike") {
  WithSky folder;
  REQUIRE(run(folder, "parhelion view s.png --beside s.png --unsharp 3,5 -o both.png").exit == 0);
  REQUIRE(run(folder, "parhelion view s.png --unsharp 3,5 -o one.png").exit == 0);
  const Photograph both = readPhotograph(folder / "both.png"), one = readPhotograph(folder / "one.png");
  REQUIRE(both.width == 2 * 96 + 4);
  const auto sheet = samples(both), half = samples(one);
  for (std::size_t y = 0; y < 64; ++y)
    for (std::size_t i = 0; i < 3 * 96; ++i) {
      CHECK(sheet[3 * 196 * y + i] == half[3 * 96 * y + i]);
      CHECK(sheet[3 * (196 * y + 100) + i] == half[3 * 96 * y + i]);
    }
  CHECK(both.text.count("parhelion:scene") == 0);
}

TEST_CASE("a picture minus itself is mid-grey, and so is red minus blue of grey") {
  WithSky folder;
  REQUIRE(run(folder, "parhelion view s.exr --minus s.exr -o a.png").exit == 0);
  for (const std::uint8_t value : samples(readPhotograph(folder / "a.png"))) CHECK(value == 128);
  REQUIRE(run(folder, "parhelion render s.toml -D sun.spectrum=550 -o grey.exr --quiet").exit == 0);
  REQUIRE(run(folder, "parhelion view grey.exr --red-minus-blue -o b.png").exit == 0);
  for (const std::uint8_t value : samples(readPhotograph(folder / "b.png"))) CHECK(value == 128);
}

TEST_CASE("dots are the hits of a tally") {
  WithSky folder;
  REQUIRE(run(folder, "parhelion view hits.exr --dots -o dots.png").exit == 0);
  const parhelion::Tally tally = parhelion::readTallyExr(folder / "hits.exr");
  const auto page = samples(readPhotograph(folder / "dots.png"));
  long hits = 0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    hits += tally.hits(pixel) > 0;
    CHECK((page[static_cast<std::size_t>(3 * pixel)] == 0) == (tally.hits(pixel) > 0));
  }
  CHECK(hits > 20);
}

TEST_CASE("dots of light that counts for whole rings are drawn with a word about it") {
  WithSky folder;
  const auto isTold = [&](const std::string& symmetry) {
    const std::string trace = "parhelion trace s.toml --rays 300 --overwrite -o r.exr ";
    const Outcome outcome =
        run(folder, trace + "--symmetry " + symmetry + " && parhelion view r.exr --dots --overwrite -o d.png");
    REQUIRE_MESSAGE(outcome.exit == 0, outcome.err);
    return outcome.err.find("--symmetry mirror") != std::string::npos;
  };
  CHECK(isTold("radial"));
  CHECK_FALSE(isTold("mirror"));
}

TEST_CASE("dots under lines are grey, so that the lines can be read") {
  WithSky folder;
  REQUIRE(run(folder, "parhelion view hits.exr --dots --overlay --layer lines.png -o dots.png").exit == 0);
  const parhelion::Tally tally = parhelion::readTallyExr(folder / "hits.exr");
  const auto page = samples(readPhotograph(folder / "dots.png")), lines = samples(readPhotograph(folder / "lines.png"));
  long bare = 0;
  for (std::size_t pixel = 0; pixel < page.size() / 3; ++pixel) {
    if (lines[4 * pixel + 3] != 0) continue;
    const bool hit = tally.hits(static_cast<int>(pixel)) > 0;
    bare += hit;
    CHECK(page[3 * pixel] == (hit ? 153 : 255));
  }
  CHECK(bare > 10);
}

TEST_CASE("pictures of one camera and one sun can be taken from each other, and names may end in capitals") {
  WithSky folder;
  REQUIRE(run(folder, "parhelion render s.toml --seed 7 -o other.exr --quiet").exit == 0);
  REQUIRE(run(folder, "parhelion view s.exr --minus other.exr -o V.PNG").exit == 0);
  CHECK(samples(readPhotograph(folder / "V.PNG")).size() == 3 * 96 * 64);
  REQUIRE(run(folder, "parhelion view s.exr -o V.JPG").exit == 0);
  CHECK(readPhotograph(folder / "V.JPG").width == 96);
  REQUIRE(run(folder, "parhelion view s.exr --profile p.csv --chart P.SVG").exit == 0);
  CHECK(readFile(folder / "P.SVG").find("<svg") != std::string::npos);
}

TEST_CASE("a profile has the agreed columns and finds the ring in a sky, its tally, and beside them a photograph") {
  WithSky folder;
  const Outcome outcome = run(folder, "parhelion view s.exr --profile - --from 15 --to 40 --bin 1 --quiet");
  REQUIRE(outcome.exit == 0);
  CHECK(outcome.err.empty());
  std::istringstream csv(outcome.out);
  std::string line;
  std::getline(csv, line);
  CHECK(line == "from_deg,to_deg,R,G,B,luminance,stderr,pixels");
  double brightest = 0.0, where = 0.0;
  int rows = 0;
  while (std::getline(csv, line)) {
    double from, to, r, g, b, y, error;
    long pixels;
    REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf,%lf,%ld", &from, &to, &r, &g, &b, &y, &error, &pixels) ==
            8);
    CHECK(from == 15.0 + rows);
    CHECK(to == 16.0 + rows);
    CHECK(y == doctest::Approx(0.2126 * r + 0.7152 * g + 0.0722 * b).epsilon(1e-3));
    CHECK(pixels > 0);
    if (y > brightest) where = from;
    brightest = std::max(brightest, y);
    ++rows;
  }
  CHECK(rows == 25);
  CHECK((where == 21.0 || where == 22.0));

  REQUIRE(run(folder, "parhelion view s.png --profile p.csv --beside hits.exr --chart p.svg" + kCamera).exit == 0);
  const std::string both = readFile(folder / "p.csv");
  CHECK(both.rfind("from_deg,to_deg,R,G,B,luminance,stderr,pixels,"
                   "R_other,G_other,B_other,luminance_other,stderr_other,pixels_other\n",
                   0) == 0);
  CHECK(lines(both) == 1 + 240);
  CHECK(readFile(folder / "p.svg").find("hits.exr") != std::string::npos);
}

TEST_CASE("what the mask takes away is in no bin") {
  WithSky folder;
  // Everything bluer than the median is not sky: red minus blue as a mask of 0 and 255.
  REQUIRE(run(folder, "parhelion view s.png --red-minus-blue --gain 1e9 -o mask.png").exit == 0);
  const auto pixels = [&](const std::string& options) {
    long sum = 0, n = 0;
    std::istringstream csv(run(folder, "parhelion view s.exr --profile - --to 180 --bin 180 --quiet " + options).out);
    std::string line;
    while (std::getline(csv, line))
      if (std::sscanf(line.c_str(), "%*f,%*f,%*f,%*f,%*f,%*f,%*f,%ld", &n) == 1) sum += n;
    return sum;
  };
  const auto mask = samples(readPhotograph(folder / "mask.png"));
  long sky = 0;
  for (std::size_t i = 0; i < mask.size(); i += 3) sky += mask[i] > 0;
  CHECK(pixels("") == 96 * 64);
  CHECK(sky < 96 * 64);
  CHECK(pixels("--mask mask.png") == sky);
}
