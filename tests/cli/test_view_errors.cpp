// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "rendered_sky.h"

using namespace parhelion::test;
using parhelion::readPhotograph;
using parhelion::writePhotograph;

TEST_CASE("mistakes in a view are one clear complaint and exit 2") {
  WithSky folder;
  const struct {
    const char *options, *says;
  } cases[] = {
      {"s.exr", "nothing to write"},
      {"s.exr -o v.exr", ".png or .jpg"},
      {"s.exr -o s.exr", ".png or .jpg"},
      {"s.png -o s.png", "written over"},
      {"s.exr --beside s.png -o s.png", "written over"},
      {"s.exr -o v.png --overlay --layer v.png", "written over"},
      {"s.exr --unsharp 3 -o v.png", "AMOUNT,RADIUS"},
      {"s.exr --unsharp 3,0 -o v.png", "AMOUNT,RADIUS"},
      {"s.exr --unsharp 3,5 --red-minus-blue -o v.png", "views of their own"},
      {"s.exr --minus s.png --beside s.png -o v.png", "--minus"},
      {"s.exr --minus s.png -o v.png", "--exposure"},
      {"s.exr --ev 13 -o v.png", "--ev: s.exr is in no absolute unit"},
      {"hits.exr --ev 13 -o v.png", "--ev: hits.exr is in no absolute unit"},
      {"s.png --ev 13 -o v.png", "--ev: is for linear light"},
      {"s.png --tone linear -o v.png", "--tone: is for linear light"},
      {"s.exr --ev 13 --exposure 1 -o v.png", "--exposure"},
      {"s.exr --ev 13 --profile p.csv", "--ev: has no meaning"},
      {"s.exr --tone linear --minus s.exr -o v.png", "--tone: has no meaning"},
      {"s.exr --tone film -o v.png", "did you mean 'filmic'"},
      {"s.exr --glare window -o v.png", "expected one of eye, lens, none, not 'window'"},
      {"s.exr --glare eye --blades 7 -o v.png", "--blades: needs --glare lens"},
      {"s.exr --glare lens --blades 2 -o v.png", "--blades"},
      {"s.png --glare eye -o v.png", "--glare: is for linear light"},
      {"s.exr --glare eye --minus s.exr -o v.png", "--glare: has no meaning"},
      {"s.exr --bits 12 -o v.png", "expected one of 8, 16"},
      {"s.exr --bits 16 -o v.jpg", "--bits: needs -o with a .png"},
      {"s.exr --bits 16 --beside s.exr -o v.png", "--bits: is of one picture"},
      {"s.exr --minus hits.exr --exposure nan -o v.png", "expected a number"},
      {"s.exr --dots -o v.png", "parhelion trace"},
      {"s.png --dots -o v.png", "parhelion trace"},
      {"hits.exr --dot-size 2 -o v.png", "needs --dots"},
      {"s.exr --gain 2 -o v.png", "--gain"},
      {"s.exr --layer l.png", "no lines"},
      {"s.exr --overlay --layer l.jpg -o v.png", ".png"},
      {"s.exr --overlay --beside s.exr --layer l.png -o v.png", "--layer"},
      {"s.exr --circles 0 -o v.png", "radii"},
      {"s.exr --circles 22,,46 -o v.png", "radii"},
      {"s.exr --grid 0 -o v.png", "expected a number"},
      {"s.exr --chart c.svg -o v.png", "needs --profile"},
      {"s.exr --profile p.csv --chart c.gif", ".svg or .png"},
      {"s.exr --profile p.csv -o v.png", "--profile"},
      {"s.exr --profile p.csv --from 30 --to 20", "--from"},
      {"s.exr --profile p.csv --exposure 1", "--exposure"},
      {"s.exr --chart c.svg", "--chart: needs --profile"},
      {"s.exr --bin 1 -o v.png", "--bin: needs --profile"},
      {"s.exr --from 1 -o v.png", "--from: needs --profile"},
      {"s.exr --to 40 -o v.png", "--to: needs --profile"},
      {"s.exr --profile p.csv --from 60", "--from"},
      {"s.exr --labels -o v.png", "--labels: no lines"},
      {"s.png --exposure 1 -o v.png", "--exposure: is for linear light"},
      {"s.png --minus s.png --exposure 1 -o v.png", "--exposure: is for linear light"},
      {"s.png --sun 10,10 -o v.png", "without lines or --profile"},
      {"s.exr --unsharp 3,5 --fov-horizontal 60 -o v.png", "without lines or --profile"},
      {"s.exr --sun-elevation 10 -o v.png", "without lines or --profile"},
      {"s.exr --sun 10,10 --overlay -o v.png", "goes without camera options"},
      {"s.exr --mask s.png -o v.png", "--mask"},
      {"photo.png --grid -o v.png", "--fov"},
      {"photo.png --profile p.csv", "--fov"},
      {"s.exr --crystals plates -o v.png", "--crystals: is for halos"},
      {"s.exr --scene s.toml --grid -o v.png", "--scene: is for halos"},
      {"s.exr --overlay --crystals plate -o v.png", "did you mean 'plates'"},
      {"s.exr --overlay --crystals '' -o v.png", "plates, columns"},
      {"s.exr --overlay --crystals plates, -o v.png", "plates, columns"},
      {"s.exr --overlay --crystals plates --scene s.toml -o v.png", "both say whose halos"},
      {"s.exr --below-horizon -o v.png", "--below-horizon: no lines"},
  };
  for (const auto& [options, says] : cases) {
    const Outcome outcome = run(folder, std::string("parhelion view ") + options);
    CHECK_MESSAGE(outcome.exit == 2, options);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, options << " said " << outcome.err);
    CHECK_MESSAGE(lines(outcome.err) == 2, outcome.err);  // with the line that points to --help
    CHECK_MESSAGE(outcome.out.empty(), options);
  }
  for (const char* name : {"v.png", "v.exr", "l.png", "p.csv", "c.svg"})
    CHECK_MESSAGE(!std::filesystem::exists(folder / name), name);
}

TEST_CASE("pictures that cannot be read or do not fit are one clear line") {
  WithSky folder;
  writeFile(folder / "text.png", "no picture");
  REQUIRE(run(folder, "parhelion render s.toml --resolution 48x32 -o small.exr --quiet").exit == 0);
  writePhotograph(folder / "plain.png", readPhotograph(folder / "small.png"), {});
  REQUIRE(run(folder,
              "parhelion render s.toml -D sun.elevation=23 -D camera.fov_horizontal=80 --rays 1k -o high.exr "
              "--quiet")
              .exit == 0);
  REQUIRE(run(folder,
              "parhelion render s.toml -D population.columns.aspect=7 -D sun.elevation=-60 --rays 1 "
              "-o black.exr --exposure -50 --quiet")
              .exit == 0);
  REQUIRE(run(folder, "parhelion map s.toml --rays 1k -o map.exr --quiet").exit == 0);
  const struct {
    const char* options;
    int exit;
    const char* says;
  } cases[] = {
      {"none.png -o v.png", 1, "none.png"},
      {"none.exr -o v.png", 1, "none.exr"},
      {"text.png -o v.png", 2, "text.png"},
      {"map.exr -o v.png", 1, "R, G, B"},
      {"s.exr --minus small.exr -o v.png", 2, "different sizes"},
      {"s.exr --minus high.exr -o v.png", 2, "differ in sun.elevation (20 and 23), the camera's field of view"},
      {"s.exr --beside plain.png --overlay -o v.png", 2,
       "plain.png has no scene in it and is 48 x 32 pixels, the first picture 96 x 64 pixels"},
      {"s.exr --beside plain.png --profile p.csv", 2, "plain.png has no scene in it and is 48 x 32 pixels"},
      {"s.exr --red-minus-blue --mask small.png -o v.png", 1,
       "small.png: the mask is 48 x 32 pixels, the picture 96 x 64 pixels"},
      {"s.exr --red-minus-blue --mask black.png -o v.png", 1, "black.png: the mask shows no sky"},
      {"s.exr --profile p.csv --mask black.png --from 10 --to 50 --chart c.svg", 1,
       "s.exr: no pixel of sky between 10 and 50 degrees"},
      {"s.exr -o none/v.png", 1, "none/v.png"},
      {"s.exr --profile p.csv --chart none/c.svg", 1, "none/c.svg"},
  };
  for (const auto& [options, exit, says] : cases) {
    const Outcome outcome = run(folder, std::string("parhelion view ") + options);
    CHECK_MESSAGE(outcome.exit == exit, options);
    CHECK_MESSAGE(outcome.err.find(says) != std::string::npos, options << " said " << outcome.err);
    CHECK_MESSAGE(lines(outcome.err) <= 2, outcome.err);
    CHECK_FALSE(std::filesystem::exists(folder / "v.png"));
    CHECK_FALSE(std::filesystem::exists(folder / "p.csv"));
    CHECK_FALSE(std::filesystem::exists(folder / "c.svg"));
  }
}
