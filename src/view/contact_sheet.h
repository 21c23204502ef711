// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "picture/image.h"
#include "picture/tone.h"

namespace parhelion {

/// Most pictures on one sheet; more would be too small to show anything.
inline constexpr std::size_t kMaxSheetPictures = 2500;

/// A grid of pictures with lines of text under each, all in pixels.
struct SheetLayout {
  int columns = 1, rows = 1;
  int pictureWidth = 1, pictureHeight = 1;  // the room for each picture
  int labelHeight = 0;                      // the room below it for its lines
  int labelWidth = 0;                       // of that, where it is wider than the picture's

  int columnWidth() const { return pictureWidth > labelWidth ? pictureWidth : labelWidth; }

  int width() const;
  int height() const;
};

/// A sheet about as high as wide, at most 2000 pixels either way but for the labels, for so many pictures of up to
/// `width` x `height` pixels with `labelLines` lines of text each. Pictures are never made larger than they are, and
/// columns only so wide as lines of `labelWidth` ask for, as far as there is room.
SheetLayout layOutSheet(std::size_t pictures, int width, int height, int labelLines, int labelWidth = 0);

/// What the widest of these lines needs in the smallest letters; never more than a line of usual length.
int labelWidthOf(std::span<const std::string> labels);

/// The channels R, G, B of a picture made smaller, so that it fits into the room for it, each pixel being the average
/// of the rectangle it covers. As it is where it fits already.
Image reducedToFit(const Image& picture, const SheetLayout& layout);

/// A reduced picture and the lines of text under it.
struct SheetCell {
  Image picture;
  std::vector<std::string> labels;
};

/// All cells, row by row from the top left, developed with one exposure; at most columns x rows of them, each picture
/// within its room. Text too long for its cell loses its beginning: of a key ("population.plates.tilt 1") whole parts
/// up to a dot first, letters only where its last part does not fit either.
Preview contactSheet(const SheetLayout& layout, std::span<const SheetCell> cells, const ToneSettings& tone);

}  // namespace parhelion
