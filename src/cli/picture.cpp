// SPDX-License-Identifier: Apache-2.0
#include "cli/picture.h"

#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/stats.h"
#include "math/names.h"
#include "picture/photograph.h"
#include "picture/staged_file.h"

namespace parhelion::cli {

namespace {

/// Of the EXR that is made from an input.
std::filesystem::path ownName(const std::string& input) {
  if (descriptorOf(input))
    throw CLI::ValidationError("-o", "a scene from a pipe has no name to call the picture by; name an .exr");
  return std::filesystem::path(input).filename().replace_extension(".exr");
}

}  // namespace

void PictureOptions::addTo(CLI::App& command) {
  command
      .add_option("-o,--output", output,
                  "The EXR, or its folder; the PNG stands beside it. Named after the input when left out")
      ->type_name("FILE");
  display.addTo(command, "Exposure of the preview; chosen by the picture when left out");
  addGamut(command, gamut);
}

void DisplayWords::addTo(CLI::App& command, const std::string& about) {
  command.add_option("--exposure", exposure, about)->type_name("STOPS")->transform(number(-100.0, 100.0));
  command
      .add_option("--ev", exposureValue,
                  "Exposure value at ISO 100, of a picture in absolute units: 0.125 * 2^EV cd/m2 become mid-grey, 18 %")
      ->type_name("EV")
      ->transform(number(-100.0, 100.0))
      ->excludes("--exposure");
  command
      .add_option("--tone", tone,
                  "Curve from linear light to the screen: reinhard, filmic or linear; reinhard when left out")
      ->type_name("NAME")
      ->check(nameOfOne<ToneCurve>());
}

LightDisplay DisplayWords::settings() const {
  return {exposure, exposureValue, tone.empty() ? ToneCurve::reinhard : valueOf<ToneCurve>(tone)};
}

void requireUnit(const LightDisplay& display, const Scene& scene) {
  if (display.exposureValue && !isAbsolute(scene))
    throw CLI::ValidationError(
        "--ev",
        "the scene's light has no absolute unit, as that of a [cloud] with an optical_depth has; give --exposure");
}

void addGamut(CLI::App& command, std::string& gamut) {
  command
      .add_option(
          "--gamut", gamut,
          "Colours of the EXR outside Rec.709: exact, with negative components; clip, mixed with grey of the same "
          "luminance until there are none; or acescg, all colours in the primaries of ACEScg; exact when left out")
      ->type_name("exact|clip|acescg")
      ->check(nameOfOne<Gamut>());
}

Gamut gamutOf(const std::string& gamut) { return gamut.empty() ? Gamut::exact : valueOf<Gamut>(gamut); }

SkyFiles PictureOptions::files(const std::string& input) const {
  // All of it is thrown away, as benchmarks want it.
  if (isNull(output)) return {output, output, display.settings(), gamutOf(gamut)};
  std::filesystem::path exr = output;
  std::error_code none;
  if (output.empty() || !exr.has_filename() || std::filesystem::is_directory(exr, none)) exr /= ownName(input);
  const std::string extension = extensionOf(exr);
  if (isStream(output) && extension.empty())
    throw CLI::ValidationError("-o", "a picture is two files and cannot go to " +
                                         (output == "-" ? std::string("stdout") : output) +
                                         ", a pipe or device; name an .exr");
  if (!extension.empty() && extension != ".exr" && extension != ".png")
    throw CLI::ValidationError("-o", "a picture is an .exr with a .png beside it, not " + output);
  // The file that was named keeps its name, also in capital letters.
  std::filesystem::path png = exr;
  if (extension != ".exr") exr.replace_extension(".exr");
  if (extension != ".png") png.replace_extension(".png");
  return {exr, png, display.settings(), gamutOf(gamut)};
}

WalkWatch walkWatch(const RunOptions& options, const StopSignal* stop) {
  const auto progress =
      std::make_shared<Progress>(progressStyle(options.quiet, options.progress), Progress::kOfTracing);
  const auto show = [progress](double share, double seconds) {
    progress->update(share, seconds, [&](Progress::Style style) {
      char line[80];
      if (style == Progress::Style::json)
        std::snprintf(line, sizeof line, R"({"walks": %.4g, "seconds": %.4g})", share, seconds);
      else
        std::snprintf(line, sizeof line, "%5.1f %%  of the walks through the cloud", 100.0 * share);
      return std::string(line);
    });
  };
  return {stop ? &stop->requested() : nullptr, show};
}

void reportPicture(const SkyFiles& files, const WrittenSky& written, const std::vector<std::string>& remarks) {
  for (const std::string& remark : remarks) say("recon: %s", remark.c_str());
  if (written.orders) printOrders(*written.orders);
  say("wrote %s and %s (exposure %s)", files.exr.c_str(), files.png.c_str(), exposureText(written.exposure).c_str());
  if (!written.unlit.empty()) say("there is no halo: %s", written.unlit.c_str());
  if (written.badPixels > 0) say("%zu pixels are not finite and black in the preview", written.badPixels);
}

}  // namespace parhelion::cli
