// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace parhelion {

/// The size of a picture in pixels.
struct PictureSize {
  int width, height;

  bool operator==(const PictureSize&) const = default;
};

/// What a camera noted about a picture (CIPA DC-008, "Exif 2.32"); nothing where it did not. Numbers are as they were
/// written, however absurd.
struct Exif {
  int orientation = 1;                    // tag 0x0112, 1 to 8; 1 where it is missing or something else
  std::optional<double> focalLength;      // tag 0x920A, mm
  std::optional<double> focalLength35mm;  // tag 0xA405, mm, the same view on 36 mm x 24 mm film
  std::optional<double> focalPlaneX;      // tag 0xA20E, pixels per focalPlaneUnit along the stored rows
  std::optional<double> focalPlaneY;      // tag 0xA20F
  int focalPlaneUnit = 2;                 // tag 0xA210: 2 inch, 3 cm; of some makers 4 mm, 5 micrometres
  std::optional<double> digitalZoom;      // tag 0xA404, how many times magnified by leaving out the picture's borders
  std::optional<int> pixelWidth;          // tag 0xA002, of the stored picture as it left the camera
  std::optional<int> pixelHeight;         // tag 0xA003
  std::string make, model;                // tags 0x010F, 0x0110
  std::string taken;  // tag 0x9003 or, without it, 0x0132: "2024:01:31 12:00:00" by the camera's clock

  // The size of the stored picture as it left the camera, where programs that scale pictures do not look: in the
  // maker's note (of Canon and Sony) and in the interoperability directory (tags 0x1001, 0x1002).
  std::vector<PictureSize> sizesTaken;

  bool operator==(const Exif&) const = default;
};

/// Reads the TIFF structure of an Exif block, from its byte order mark on (what follows "Exif\0\0" in a JPEG's APP1
/// segment, or a PNG's eXIf chunk). Whatever lies outside the block, turns in circles or has another type than it
/// should is passed over; never throws on account of its input.
Exif readExif(std::span<const std::uint8_t> tiff);

}  // namespace parhelion
