// SPDX-License-Identifier: Apache-2.0
#include "view/contact_sheet.h"

#include <algorithm>
#include <cmath>

#include "view/canvas.h"

namespace parhelion {

namespace {

// pixels
constexpr int kMostAcross = 2000;
constexpr int kGap = 6;
constexpr int kLineHeight = 18;
constexpr double kTextSize = 14.0, kLeastTextSize = 9.0;

constexpr std::uint8_t kPaper = 40;  // sRGB grey, lighter than the night in the pictures
constexpr Colour kInk{0.92, 0.92, 0.92};
constexpr Colour kNoOutline{0.0, 0.0, 0.0, 0.0};

/// The part of a row of pixels that one target pixel averages.
struct Share {
  std::size_t first;
  std::vector<double> weights;  // add up to 1
};

std::vector<Share> sharesOf(int source, int target) {
  std::vector<Share> shares;
  const double step = static_cast<double>(source) / target;
  for (int i = 0; i < target; ++i) {
    const double from = i * step, to = std::min<double>(source, (i + 1) * step);
    Share share{static_cast<std::size_t>(from), {}};
    for (double pixel = std::floor(from); pixel < to; pixel += 1.0)
      share.weights.push_back((std::min(to, pixel + 1.0) - std::max(from, pixel)) / (to - from));
    shares.push_back(std::move(share));
  }
  return shares;
}

std::vector<float> averaged(const std::vector<float>& samples, int width, const std::vector<Share>& columns,
                            const std::vector<Share>& rows) {
  std::vector<float> result;
  result.reserve(columns.size() * rows.size());
  for (const Share& row : rows)
    for (const Share& column : columns) {
      double sum = 0.0;
      for (std::size_t y = 0; y < row.weights.size(); ++y)
        for (std::size_t x = 0; x < column.weights.size(); ++x)
          sum += row.weights[y] * column.weights[x] *
                 samples[(row.first + y) * static_cast<std::size_t>(width) + column.first + x];
      result.push_back(static_cast<float>(sum));
    }
  return result;
}

/// The layout with so many columns.
SheetLayout layoutOf(int pictures, int columns, int width, int height, int labelHeight, int labelWidth) {
  const int rows = (pictures + columns - 1) / columns;
  const auto share = [](int count, int extent) {
    return static_cast<double>(kMostAcross - kGap * (count + 1)) / count / extent;
  };
  const double scale = std::min({1.0, share(columns, width), share(rows, height)});
  const auto scaled = [scale](int extent) { return std::max(1, static_cast<int>(std::floor(scale * extent))); };
  const int room = (kMostAcross - kGap) / columns - kGap;
  return {columns, rows, scaled(width), scaled(height), labelHeight, std::min(labelWidth, room)};
}

void paste(Preview& sheet, const Preview& picture, int left, int top) {
  const std::size_t bytes = std::size_t{3} * static_cast<std::size_t>(picture.width);
  for (int y = 0; y < picture.height; ++y) {
    const auto from = picture.rgb.begin() + static_cast<std::ptrdiff_t>(bytes * static_cast<std::size_t>(y));
    const std::ptrdiff_t to = 3 * (static_cast<std::ptrdiff_t>(top + y) * sheet.width + left);
    std::copy_n(from, bytes, sheet.rgb.begin() + to);
  }
}

/// The text with as much of its beginning cut off as needed: the value stands at its end, after a space, and the last
/// part of the key before it.
std::string fitting(const Canvas& canvas, std::string text, double size, double width) {
  const auto fits = [&](const std::string& t) { return canvas.textBox(t, size).size().x <= width; };
  for (std::size_t dot = text.find('.'); !fits(text) && dot < text.find(' '); dot = text.find('.'))
    text.erase(0, dot + 1);
  if (fits(text)) return text;
  const auto isContinuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  std::size_t start = 1;
  while (start < text.size() && (isContinuation(text[start]) || !fits("…" + text.substr(start)))) ++start;
  return "…" + text.substr(start);
}

/// The size at which the widest of all labels fits, as far as letters can be read.
double textSize(const Canvas& canvas, std::span<const SheetCell> cells, double width) {
  double widest = width;
  for (const SheetCell& cell : cells)
    for (const std::string& label : cell.labels) widest = std::max(widest, canvas.textBox(label, kTextSize).size().x);
  return std::max(kLeastTextSize, kTextSize * width / widest);
}

}  // namespace

int SheetLayout::width() const { return columns * (columnWidth() + kGap) + kGap; }
int SheetLayout::height() const { return rows * (pictureHeight + labelHeight + kGap) + kGap; }

int labelWidthOf(std::span<const std::string> labels) {
  constexpr int kMostLabelWidth = 200;
  const Canvas canvas(1, 1);
  int widest = 0;
  for (const std::string& label : labels)
    widest = std::max(widest, static_cast<int>(std::ceil(canvas.textBox(label, kLeastTextSize).size().x)) + 2);
  return std::min(widest, kMostLabelWidth);
}

SheetLayout layOutSheet(std::size_t pictures, int width, int height, int labelLines, int labelWidth) {
  const int count = static_cast<int>(std::min(pictures, kMaxSheetPictures));
  const auto unevenness = [](const SheetLayout& layout) {
    return std::max(layout.width(), layout.height()) / static_cast<double>(std::min(layout.width(), layout.height()));
  };
  SheetLayout best;
  for (int columns = 1; columns <= std::max(1, count); ++columns) {
    const SheetLayout layout = layoutOf(count, columns, width, height, labelLines * kLineHeight, labelWidth);
    if (columns == 1 || unevenness(layout) <= unevenness(best)) best = layout;
  }
  return best;
}

Image reducedToFit(const Image& picture, const SheetLayout& layout) {
  const double scale = std::min({1.0, static_cast<double>(layout.pictureWidth) / picture.width,
                                 static_cast<double>(layout.pictureHeight) / picture.height});
  const auto scaled = [scale](int extent, int most) {
    return std::clamp(static_cast<int>(std::lround(scale * extent)), 1, most);
  };
  Image small{scaled(picture.width, layout.pictureWidth), scaled(picture.height, layout.pictureHeight), {}};
  const std::vector<Share> columns = sharesOf(picture.width, small.width),
                           rows = sharesOf(picture.height, small.height);
  const auto planes = picture.rgb();
  for (std::size_t c = 0; c < planes.size(); ++c)
    small.channels.push_back({std::string(1, "RGB"[c]), averaged(*planes[c], picture.width, columns, rows)});
  return small;
}

Preview contactSheet(const SheetLayout& layout, std::span<const SheetCell> cells, const ToneSettings& tone) {
  Preview sheet{layout.width(), layout.height(), {}, 0};
  sheet.rgb.assign(std::size_t{3} * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height),
                   kPaper);
  Canvas canvas(sheet.width, sheet.height);
  const double size = textSize(canvas, cells, layout.columnWidth());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int column = static_cast<int>(i) % layout.columns, row = static_cast<int>(i) / layout.columns;
    const int left = kGap + column * (layout.columnWidth() + kGap);
    const int top = kGap + row * (layout.pictureHeight + layout.labelHeight + kGap);
    const Preview picture = developPreview(cells[i].picture, tone);
    sheet.badPixels += picture.badPixels;
    paste(sheet, picture, left + (layout.columnWidth() - picture.width) / 2,
          top + (layout.pictureHeight - picture.height) / 2);
    for (std::size_t line = 0; line < cells[i].labels.size(); ++line)
      canvas.text(fitting(canvas, cells[i].labels[line], size, layout.columnWidth()),
                  Vec2(left, top + layout.pictureHeight + kLineHeight * static_cast<int>(line)), size, kInk,
                  kNoOutline);
  }
  layOver(sheet, canvas.lineArt());
  return sheet;
}

}  // namespace parhelion
