// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "picture/chromaticities.h"
#include "picture/envmap.h"
#include "picture/image.h"
#include "picture/transaction.h"

namespace parhelion {

/// Text attributes of a file, name to value: "software", "parhelion:version", "parhelion:seed", "parhelion:rays",
/// "parhelion:scene" and so on. Numbers are text too: EXR has no 64-bit integers.
using ExrAttributes = std::map<std::string, std::string>;

/// Key of the luminance, cd/m^2, that R = G = B = 1 stands for; in the file it is OpenEXR's own number of that name.
inline constexpr const char* kWhiteLuminanceKey = "whiteLuminance";

/// That number, if there is one and it is above 0.
std::optional<double> whiteLuminanceOf(const ExrAttributes& attributes);

/// The picture a viewer shows, of which a file may hold a part only, or more.
struct DisplayWindow {
  int left = 0;  // pixels, of its upper left corner in the picture of the file
  int top = 0;
  int width = 0;
  int height = 0;
};

struct ExrFile {
  Image image;
  ExrAttributes attributes;
  DisplayWindow display = {};
  std::optional<Chromaticities> chromaticities = {};  // as the file has them
};

/// What channels R, G and B are to be.
enum class ExrColours {
  rec709,    // linear Rec.709; converted by a Bradford adaptation where the file has other chromaticities
  asStored,  // the numbers in the file
};

/// What becomes of a picture of ours that is damaged, or that another program has changed but for its checksum.
enum class EditedPictures { refused, read };

/// Writes a picture for any viewer: one part, all channels as 32-bit floats, scan lines, ZIP, with a checksum and, for
/// environment light, the attribute `envmap`. Its colours, and those of its layers, are written in the primaries of
/// `space`, to which they are taken from Rec.709 by a Bradford adaptation, with the chromaticities of these. Adds
/// `capDate` if the environment sets SOURCE_DATE_EPOCH; else the same picture gives the same bytes. In one piece or not
/// at all (atomic_file.h). Throws std::runtime_error "path: reason".
void writeBeautyExr(const Output& output, const Image& image, ExrAttributes attributes, Envmap envmap = Envmap::none,
                    const Chromaticities& space = kRec709Chromaticities);

/// Throws std::runtime_error if SOURCE_DATE_EPOCH is set and no EXR could be written with it.
void requireSourceDate();

/// Whether the file begins as EXR files do; false where it cannot be read.
bool isExr(const std::filesystem::path& path);

/// What of a file its reader needs.
struct ExrWanted {
  bool coloursOnly = false;  // channels R, G, B, A and Y
  int bytesForUse = 0;       // a pixel, that the caller is going to take beside the samples
  EditedPictures edited = EditedPictures::refused;
};

/// Reads the first part of any flat scan-line EXR, its channels as floats, and its text attributes. Before it takes
/// memory, it asks requireMemoryFor(). Pixels with samples that are not finite stay as they are stored. Throws
/// std::runtime_error "path: reason" for whatever is wrong with it, also for chromaticities that make no colour space
/// if they are needed, and for a checksum that does not fit. That is not among the attributes that it gives.
ExrFile readExr(const std::filesystem::path& path, ExrColours colours = ExrColours::rec709, ExrWanted wanted = {});

/// What an EXR says of itself before its samples come.
struct ExrFrame {
  int width, height;  // pixels
  DisplayWindow display;
  std::vector<std::string> channels;
  ExrAttributes attributes;
};

/// Throws as readExr does.
ExrFrame readExrFrame(const std::filesystem::path& path);

/// The samples of one channel in three numbers; those that are not finite make the mean so.
struct ChannelRange {
  std::string name;
  float least, greatest;
  double mean;
};

/// Of all channels of the first part, in memory for a few of its rows. Throws as readExr does.
std::vector<ChannelRange> readExrRanges(const std::filesystem::path& path,
                                        EditedPictures edited = EditedPictures::refused);

/// Its text attributes alone, whatever its first part is. Throws as readExr does if the header cannot be read.
ExrAttributes readExrAttributes(const std::filesystem::path& path);

}  // namespace parhelion
