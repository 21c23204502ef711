// SPDX-License-Identifier: Apache-2.0
#include "cli/picture.h"

#include <cstdio>

#include "cli/run_options.h"
#include "math/names.h"
#include "render/sky_files.h"

namespace parhelion::cli {

void PictureOptions::addTo(CLI::App& command) {
  command
      .add_option("-o,--output", output,
                  "The EXR, or its folder; the PNG stands beside it. Named after the input when left out")
      ->type_name("FILE");
  command.add_option("--exposure", exposure, "Exposure of the preview; chosen by the picture when left out")
      ->type_name("STOPS")
      ->check(number(-100.0, 100.0));
  addGamut(command, gamut);
}

void addGamut(CLI::App& command, std::string& gamut) {
  command
      .add_option("--gamut", gamut,
                  "Colours of the EXR outside Rec.709: exact, with negative components, or mixed with grey of the same "
                  "luminance until there are none; exact when left out")
      ->type_name("exact|clip")
      ->check(nameOfOne<Gamut>());
}

Gamut gamutOf(const std::string& gamut) { return gamut.empty() ? Gamut::exact : valueOf<Gamut>(gamut); }

std::filesystem::path PictureOptions::exr(const std::string& input) const {
  const std::filesystem::path own = std::filesystem::path(input).filename().replace_extension(".exr");
  if (output.empty()) return own;
  if (output == "-") throw CLI::ValidationError("-o", "a picture is two files and cannot go to stdout");
  std::filesystem::path path = output;
  if (!path.has_filename() || std::filesystem::is_directory(path)) return path / own;
  const std::string extension = path.extension().string();
  if (!extension.empty() && extension != ".exr" && extension != ".png")
    throw CLI::ValidationError("-o", "a picture is an .exr with a .png beside it, not " + output);
  return path.replace_extension(".exr");
}

void writePicture(ReconstructedSky sky, const TallyInfo& info, const LoadedScene& loaded, const PictureOptions& options,
                  const std::string& input, bool quiet) {
  const SkyFiles files{options.exr(input), options.png(input), options.exposure, gamutOf(options.gamut)};
  const WrittenSky written = writeSkyFiles(files, std::move(sky.image), info, loaded);
  if (quiet) return;
  for (const std::string& remark : sky.remarks) std::fprintf(stderr, "recon: %s\n", remark.c_str());
  std::fprintf(stderr, "wrote %s and %s (exposure %s)\n", files.exr.c_str(), files.png.c_str(),
               exposureText(written.exposure).c_str());
  if (written.badPixels > 0)
    std::fprintf(stderr, "%zu pixels are not finite and black in the preview\n", written.badPixels);
}

}  // namespace parhelion::cli
