// SPDX-License-Identifier: Apache-2.0
#include "cli/view_options.h"

#include <sstream>

#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/run_options.h"
#include "math/names.h"
#include "picture/photograph.h"
#include "view/dots.h"
#include "view/gaussian_blur.h"

namespace parhelion::cli {

namespace {

constexpr const char* kUsualCircles = "9,18,20,22,23,24,35,46";  // degrees: the rings of pyramids and of prisms
constexpr double kMostAmount = 1000.0;
constexpr double kLeastRadius = 0.1;  // pixels

std::string validCircles(const std::string& text) {
  const std::vector<double> radii = commaSeparated(text);
  bool good = !radii.empty();
  for (const double radius : radii) good = good && radius > 0.0 && radius < 180.0;
  return good ? "" : expectedNot("radii in degrees, for one 22,46", text);
}

/// The words between commas.
std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream list(text);
  for (std::string word; std::getline(list, word, ',');) all.push_back(word);
  if (text.empty() || text.back() == ',') all.emplace_back();
  return all;
}

std::string validFamilies(const std::string& text) {
  const CLI::Validator known = nameOfOne<HaloFamily>();
  for (std::string word : words(text))
    if (std::string complaint = known(word); !complaint.empty()) return complaint;
  return "";
}

std::string validUnsharp(const std::string& text) {
  const std::vector<double> pair = commaSeparated(text);
  const bool good =
      pair.size() == 2 && pair[0] >= 0.0 && pair[0] <= kMostAmount && pair[1] >= kLeastRadius && pair[1] <= kMaxBlur;
  return good ? "" : expectedNot("AMOUNT,RADIUS, for one 3,20 (radius 0.1 to 4096 pixels)", text);
}

void refuse(bool mistake, const char* option, const char* reason) {
  if (mistake) throw CLI::ValidationError(option, reason);
}

void addFilters(CLI::App& command, ViewOptions& o) {
  command.add_option("--unsharp", o.unsharp, "Unsharp mask: amount, and standard deviation of its Gaussian in pixels")
      ->type_name("AMOUNT,RADIUS")
      ->check(CLI::Validator(validUnsharp, ""));
  command.add_flag("--red-minus-blue", o.redMinusBlue,
                   "Red minus blue as grey, stretched: colours stand out of clouds");
  command
      .add_option("--beside", o.beside,
                  "A picture to the right, treated alike; may be repeated. With --profile, whose columns stand beside")
      ->type_name("OTHER")
      ->allow_extra_args(false);
  command.add_option("--reduce", o.reduction, "Make the view smaller: averages of N x N pixels, in linear light")
      ->type_name("N")
      ->transform(wholeNumber(1, 64));
  command.add_option("--minus", o.minus, "Take the linear light of a second picture off: mid-grey is no difference")
      ->type_name("OTHER");
  command
      .add_option("--layers", o.layers,
                  "Only these layers of a picture or tally that has some, with commas between them")
      ->type_name("A,B")
      ->delimiter(',')
      ->allow_extra_args(false);
  command.add_option("--gain", o.gain, "Of --red-minus-blue and --minus; chosen by the picture when left out")
      ->type_name("FACTOR")
      ->transform(number(0.0, 1e12));
  command.add_flag("--dots", o.dots,
                   "Black dots on white where a tally was hit: the input is one that trace has written");
  command
      .add_option("--dot-size", o.dotSize,
                  "Pixels across a dot; 1 when left out, more in pictures of more than 1600 pixels")
      ->type_name("PX")
      ->transform(wholeNumber(1, kMaxDotSize));
  o.display.addTo(command, "Exposure of linear light; chosen by the picture when left out");
  command
      .add_option(
          "--glare", o.glare,
          "Spread linear light as an eye does, so that the sun dazzles, or as a lens does that is stopped down, so "
          "that it is a star: eye, lens or none; none when left out")
      ->type_name("eye|lens|none")
      ->check(oneOf({"eye", "lens", "none"}));
  command.add_option("--blades", o.blades, "Of --glare lens: edges of the aperture; 6 when left out")
      ->type_name("N")
      ->transform(wholeNumber(3, 30));
  command.add_option("--aperture", o.aperture, "Of --glare lens: focal length over f-number, mm; 2 when left out")
      ->type_name("MM")
      ->transform(number(0.01, 1000.0));
  command.add_option("--bits", o.bits, "Bits of each component, 8 or 16; 8 when left out")
      ->type_name("8|16")
      ->check(oneOf({"8", "16"}));
  command.add_option("--mask", o.mask, "White where the input shows sky, for --profile and --red-minus-blue")
      ->type_name("FILE");
}

void addLines(CLI::App& command, ViewOptions& o) {
  command.add_flag("--overlay", o.overlay, "The usual lines: grid, horizon, zenith, halos, labels");
  command.add_option("--grid", o.grid, "Grid of altitude and azimuth from the sun")
      ->type_name("[DEG]")
      ->expected(0, 1)
      ->default_str("10")
      ->transform(number(1.0, 90.0));
  command.add_option("--circles", o.circles, "Circles about the sun")
      ->type_name("[DEG,DEG...]")
      ->expected(0, 1)
      ->default_str(kUsualCircles)
      ->check(CLI::Validator(validCircles, ""));
  command.add_flag("--horizon-line", o.horizonLine, "The horizon");
  command.add_flag("--zenith", o.zenith, "The zenith");
  command.add_flag("--halos", o.halos, "Halos and arcs that the scene's crystals make with this elevation of the sun");
  command
      .add_option("--crystals", o.crystals,
                  "Halos of these crystals, whatever the scene has: plates, columns, parry, lowitz, random, pyramids")
      ->type_name("NAME,NAME...")
      ->check(CLI::Validator(validFamilies, ""));
  command.add_option("--scene", o.scene, "Halos of this scene's crystals and ice, whatever is in the picture")
      ->type_name("SCENE");
  const auto below = [&command, &o](const char* name, bool draw, const char* about) {
    return command.add_flag_callback(
        name, [&o, draw] { o.belowHorizon = draw; }, about);
  };
  CLI::Option* no =
      below("--no-below-horizon", false, "Draw no lines below the horizon: so it is of photographs anyway");
  below("--below-horizon", true, "Draw lines below the horizon, too: so it is of simulations anyway")->excludes(no);
  command.add_flag("--labels", o.labels, "Names and degrees of the lines");
  command.add_option("--layer", o.layer, "Write the lines alone, with alpha, to lay over the picture elsewhere")
      ->type_name("FILE.png")
      ->check(fileOfKind({".png"}, ".png"));
}

void addProfile(CLI::App& command, ViewOptions& o) {
  command.add_option("--profile", o.profile, "Write the light over the angle from the sun as CSV; - for stdout")
      ->type_name("FILE.csv");
  command.add_option("--chart", o.chart, "Draw the profile, too")
      ->type_name("FILE")
      ->check(fileOfKind({".svg", ".png"}, ".svg or .png"));
  command.add_option("--bin", o.bin, "Width of the profile's bins; 0.25 when left out")
      ->type_name("DEG")
      ->transform(number(1e-3, 180.0));
  command.add_option("--from", o.from, "Where the profile begins; 0 when left out")
      ->type_name("DEG")
      ->transform(number(0.0, 180.0));
  command.add_option("--to", o.to, "Where the profile ends; 60 when left out")
      ->type_name("DEG")
      ->transform(number(0.0, 180.0));
}

}  // namespace

void ViewOptions::addTo(CLI::App& command) {
  command.add_option("input", input, "A photograph, a picture of render or recon, or a tally of trace")
      ->required()
      ->type_name("PICTURE");
  command.add_option("-o,--output", output, "The view")
      ->type_name("FILE")
      ->check(fileOfKind({".png", ".jpg", ".jpeg"}, ".png or .jpg"));
  addFilters(command, *this);
  addLines(command, *this);
  addProfile(command, *this);
  command.add_flag("--quiet", quiet, "Nothing on stderr");
  addOverwrite(command, overwrite);
  photo.addTo(command);
}

void ViewOptions::requireSense() const {
  const bool profiles = !profile.empty();
  const int kinds = !unsharp.empty() + redMinusBlue + dots + !minus.empty() + profiles;
  refuse(kinds > 1, "view", "--unsharp, --red-minus-blue, --dots, --minus and --profile are views of their own");
  refuse(!beside.empty() && !minus.empty(), "--minus", "is a view of its own and cannot stand beside another picture");
  refuse(profiles && (drawsLines() || !output.empty()), "--profile", "is a table; -o and lines are for pictures");
  refuse(!chart.empty() && !profiles, "--chart", "needs --profile");
  refuse((from || to || bin) && !profiles, from ? "--from" : to ? "--to" : "--bin", "needs --profile");
  refuse(output.empty() && layer.empty() && !profiles, "view", "nothing to write: give -o, --layer or --profile");
  refuse(profiles && beside.size() > 1, "--beside", "a profile stands beside one other");
  refuse(reduction != 1 && output.empty(), "--reduce", "needs -o");
  refuse(!layer.empty() && !drawsLines(), "--layer", "no lines were asked for: give --overlay, --grid or the like");
  refuse(!layer.empty() && !beside.empty(), "--layer",
         "the lines of two pictures are not one layer; leave --beside out");
  refuse(profileSettings().from >= profileSettings().to, "--from", "must be less than --to");
  refuse(gain && !redMinusBlue && minus.empty(), "--gain", "needs --red-minus-blue or --minus");
  refuse(dotSize && !dots, "--dot-size", "needs --dots");
  refuse(!mask.empty() && !profiles && !redMinusBlue, "--mask", "needs --profile or --red-minus-blue");
  refuse(display.exposure && (profiles || dots), "--exposure", "has no meaning for --profile and --dots");
  const bool developsNothing = profiles || dots || !minus.empty();
  refuse(display.exposureValue && developsNothing, "--ev", "has no meaning for --profile, --dots and --minus");
  refuse(!display.tone.empty() && developsNothing, "--tone", "has no meaning for --profile, --dots and --minus");
  refuse(addsGlare() && developsNothing, "--glare", "has no meaning for --profile, --dots and --minus");
  refuse((blades || aperture) && glare != "lens", blades ? "--blades" : "--aperture", "needs --glare lens");
  refuse(bits != 8 && (developsNothing || !beside.empty()), "--bits",
         "is of one picture, without --profile, --dots, --minus and --beside");
  refuse(bits != 8 && extensionOf(output) != ".png", "--bits", "needs -o with a .png");
  refuse(!scene.empty() && !drawsHalos(), "--scene", "is for halos: give --overlay or --halos");
  refuse(!crystals.empty() && !drawsHalos(), "--crystals", "is for halos: give --overlay or --halos");
  refuse(!scene.empty() && !crystals.empty(), "--scene", "and --crystals both say whose halos to draw");
  refuse(belowHorizon && !drawsLines(), "--below-horizon",
         "no lines were asked for: give --overlay, --grid or the like");
  refuse(labels && !drawsLines(), "--labels", "no lines were asked for: give --overlay, --grid or the like");
  refuse((photo.given() || photo.sunElevation) && !needsCamera(), "view",
         "the camera and the sun's elevation have no effect without lines or --profile");
}

std::vector<HaloFamily> ViewOptions::families() const {
  std::vector<HaloFamily> all;
  for (const std::string& word : words(crystals)) all.push_back(valueOf<HaloFamily>(word));
  return all;
}

bool ViewOptions::drawsLines() const {
  return overlay || grid || !circles.empty() || horizonLine || zenith || drawsHalos();
}

OverlaySettings ViewOptions::overlaySettings() const {
  OverlaySettings settings;
  if (grid || !overlay) settings.gridStep = grid ? radians(*grid) : 0.0;
  settings.horizon = overlay || horizonLine;
  settings.zenith = overlay || zenith;
  settings.labels = overlay || labels;
  settings.halos = drawsHalos();
  settings.onPaper = dots;
  for (const double radius : commaSeparated(circles)) settings.circles.push_back(radians(radius));
  return settings;
}

UnsharpSettings ViewOptions::unsharpSettings() const {
  const std::vector<double> pair = commaSeparated(unsharp);
  return {pair[0], pair[1]};
}

SkyProfileSettings ViewOptions::profileSettings() const {
  SkyProfileSettings settings;
  if (from) settings.from = radians(*from);
  if (to) settings.to = radians(*to);
  if (bin) settings.bin = radians(*bin);
  return settings;
}

}  // namespace parhelion::cli
