// SPDX-License-Identifier: Apache-2.0
#include "view/canvas.h"

#include <cairo.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

#include "picture/memory_limit.h"

namespace parhelion {
namespace {

constexpr int kMaxCairoSide = 32767;

// The outline stands out from the letters by this share of their size.
constexpr double kOutline = 0.13;

void setColour(cairo_t* context, const Colour& c) { cairo_set_source_rgba(context, c.red, c.green, c.blue, c.alpha); }

/// The same letters on all screens: no fitting to pixels, no coloured edges.
void setFont(cairo_t* context) {
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

/// Length of the UTF-8 sequence that `text` begins with, 0 if it is none or stands for a control character. Unicode
/// 15.0, table 3-7.
std::size_t sequenceLength(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const auto follows = [&](std::size_t i) { return byte(i) >= 0x80 && byte(i) <= 0xBF; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return first >= 0x20 && first != 0x7F;
  if (first >= 0xC2 && first <= 0xDF) {
    const bool control = first == 0xC2 && second < 0xA0;
    return follows(1) && !control ? 2 : 0;
  }
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool surrogate = first == 0xED && second > 0x9F;
  const bool tooLarge = first == 0xF4 && second > 0x8F;
  if (overlong || surrogate || tooLarge || first < 0xE0 || first > 0xF4) return 0;
  const std::size_t length = first < 0xF0 ? 3 : 4;
  for (std::size_t i = 1; i < length; ++i)
    if (!follows(i)) return 0;
  return length;
}

/// The size of letters for what follows, and its measures.
cairo_font_extents_t fontOf(cairo_t* context, double size) {
  cairo_set_font_size(context, size);
  cairo_font_extents_t font;
  cairo_font_extents(context, &font);
  return font;
}

/// What cairo can write: it stops drawing for good at the first invalid byte.
std::string writable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = sequenceLength(text);
    result += length > 0 ? text.substr(0, length) : std::string_view("\uFFFD");
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

/// cairo remembers its first error and draws nothing more.
void requireHealthy(cairo_t* context, cairo_surface_t* surface) {
  for (const cairo_status_t status : {cairo_surface_status(surface), cairo_status(context)}) {
    if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
    if (status != CAIRO_STATUS_SUCCESS)
      throw std::runtime_error(std::string("drawing lines: ") + cairo_status_to_string(status));
  }
}

/// Straight from premultiplied, rounded.
std::uint8_t straight(std::uint32_t component, std::uint32_t alpha) {
  return alpha == 0 ? 0 : static_cast<std::uint8_t>(std::min(255u, (component * 255 + alpha / 2) / alpha));
}

}  // namespace

void Canvas::Release::operator()(_cairo* context) const { cairo_destroy(context); }
void Canvas::Release::operator()(_cairo_surface* surface) const { cairo_surface_destroy(surface); }

Canvas::Canvas(int width, int height) {
  if (width < 1 || height < 1 || width > kMaxCairoSide || height > kMaxCairoSide)
    throw std::invalid_argument("a drawing has from 1 to 32767 pixels a side");
  // Where memory ends while cairo 1.16 draws, it jumps to nowhere: so it is asked for before.
  constexpr std::uint64_t kPixel = 8, kForLines = 48'000'000;  // bytes; what all lines and letters of a picture take
  requireMemory("drawing lines", kForLines + kPixel * static_cast<unsigned>(width) * static_cast<unsigned>(height));
  surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height));
  context_.reset(cairo_create(surface_.get()));
  requireHealthy(context_.get(), surface_.get());
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
  setFont(context_.get());
}

void Canvas::rectangle(const Box& box, const Colour& colour) {
  cairo_t* context = context_.get();
  setColour(context, colour);
  cairo_rectangle(context, box.min.x, box.min.y, box.size().x, box.size().y);
  cairo_fill(context);
}

void Canvas::lines(const std::vector<PixelLine>& lines, const Stroke& stroke) {
  cairo_t* context = context_.get();
  setColour(context, stroke.colour);
  cairo_set_line_width(context, stroke.width);
  cairo_set_dash(context, &stroke.dash, stroke.dash > 0.0 ? 1 : 0, 0.0);
  for (const PixelLine& line : lines) {
    cairo_new_sub_path(context);
    for (const Vec2& p : line) cairo_line_to(context, p.x, p.y);
    if (line.size() > 2 && line.front() == line.back()) cairo_close_path(context);
  }
  cairo_stroke(context);
}

void Canvas::disc(const Vec2& centre, double radius, const Colour& colour) {
  cairo_t* context = context_.get();
  setColour(context, colour);
  cairo_new_path(context);
  cairo_arc(context, centre.x, centre.y, radius, 0.0, 2.0 * kPi);
  cairo_fill(context);
}

Box Canvas::textBox(std::string_view text, double size) const {
  cairo_t* context = context_.get();
  const cairo_font_extents_t font = fontOf(context, size);
  cairo_text_extents_t extents;
  cairo_text_extents(context, writable(text).c_str(), &extents);
  return {Vec2(0.0), Vec2(extents.x_advance, font.ascent + font.descent)};
}

void Canvas::text(std::string_view text, const Vec2& place, double size, const Colour& colour, const Colour& outline) {
  cairo_t* context = context_.get();
  const cairo_font_extents_t font = fontOf(context, size);
  cairo_new_path(context);
  cairo_move_to(context, place.x, place.y + font.ascent);
  cairo_text_path(context, writable(text).c_str());
  setColour(context, outline);
  cairo_set_line_width(context, 2.0 * kOutline * size);
  cairo_set_dash(context, nullptr, 0, 0.0);
  cairo_stroke_preserve(context);
  setColour(context, colour);
  cairo_fill(context);
}

LineArt Canvas::lineArt() const {
  cairo_surface_t* surface = surface_.get();
  cairo_surface_flush(surface);
  requireHealthy(context_.get(), surface);
  LineArt lines{cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
  lines.rgba.reserve(4 * static_cast<std::size_t>(lines.width) * static_cast<std::size_t>(lines.height));
  const unsigned char* data = cairo_image_surface_get_data(surface);
  const std::ptrdiff_t stride = cairo_image_surface_get_stride(surface);
  for (int y = 0; y < lines.height; ++y)
    for (int x = 0; x < lines.width; ++x) {
      std::uint32_t pixel;  // alpha in the highest byte, blue in the lowest, in the machine's order
      std::memcpy(&pixel, data + y * stride + 4 * static_cast<std::ptrdiff_t>(x), sizeof pixel);
      const std::uint32_t alpha = pixel >> 24;
      for (const int shift : {16, 8, 0}) lines.rgba.push_back(straight(pixel >> shift & 0xFF, alpha));
      lines.rgba.push_back(static_cast<std::uint8_t>(alpha));
    }
  return lines;
}

}  // namespace parhelion
