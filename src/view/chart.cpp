// SPDX-License-Identifier: Apache-2.0
#include "view/chart.h"

#include <cairo.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "picture/atomic_file.h"
#include "picture/photograph.h"
#include "picture/png.h"

namespace parhelion {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

/// A file without a name. Files rather than pipes: nobody waits for anybody, and nobody hangs up.
File unnamedFile() {
  File file(std::tmpfile());
  if (!file) throw std::runtime_error("temporary file: " + std::generic_category().message(errno));
  return file;
}

std::string contents(std::FILE* file) {
  std::string all;
  std::array<char, 65536> block;
  std::rewind(file);
  while (const std::size_t bytes = std::fread(block.data(), 1, block.size(), file)) all.append(block.data(), bytes);
  return all;
}

/// A gnuplot string in which nothing has a meaning.
std::string literal(std::string_view text) {
  std::string all = "'";
  for (const char c : text) {
    if (c == '\'') all += '\'';
    all += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return all + "'";
}

std::string dataBlock(const ChartCurve& curve, std::size_t number) {
  std::string text = "$curve" + std::to_string(number) + " << END\n";
  char line[64];
  for (const Vec2& point : curve.points) {
    std::snprintf(line, sizeof line, "%.10g %.9g\n", point.x, point.y);
    text += line;
  }
  return text + "END\n";
}

std::string script(std::string_view extension, const ChartAxes& axes, std::span<const ChartCurve> curves) {
  constexpr std::array kColours{"#0072b2", "#d55e00", "#009e73", "#cc79a7"};  // told apart by every eye (Okabe & Ito)
  std::string text = "set encoding utf8\n";
  text += extension == ".svg" ? "set terminal svg size 960,600 font 'DejaVu Sans,14' background '#ffffff'\n"
                              : "set terminal pngcairo size 960,600 font 'DejaVu Sans,11' background '#ffffff'\n";
  text += "set xlabel " + literal(axes.x) + " noenhanced\nset ylabel " + literal(axes.y) +
          " noenhanced\nset border 3\nset tics nomirror out\nset grid linecolor rgb '#dddddd' linetype 1\nset key top "
          "right noenhanced\n"
          "set xrange [*:*] noextend\nset yrange [0:*]\n";
  for (std::size_t i = 0; i < curves.size(); ++i) text += dataBlock(curves[i], i);
  for (std::size_t i = 0; i < curves.size(); ++i)
    text += (i == 0 ? "plot $curve" : ", $curve") + std::to_string(i) + " using 1:2 with lines lw 2 lc rgb '" +
            kColours[i % kColours.size()] + "' title " + literal(curves[i].title);
  return text + "\n";
}

/// Runs gnuplot on a script; what it prints.
std::string gnuplot(const std::string& commands) {
  const File in = unnamedFile(), out = unnamedFile(), complaints = unnamedFile();
  if (std::fwrite(commands.data(), 1, commands.size(), in.get()) != commands.size() || std::fflush(in.get()) != 0)
    throw std::runtime_error("temporary file: " + std::generic_category().message(errno));
  std::rewind(in.get());

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ::fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, ::fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, ::fileno(complaints.get()), STDERR_FILENO);
  // Without the user's own settings, and without a shell.
  std::array<std::string, 2> words{"gnuplot", "--default-settings"};
  std::array<char*, 3> arguments{words[0].data(), words[1].data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, "gnuplot", &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error == ENOENT) throw std::runtime_error("charts are drawn by gnuplot, which is missing: package gnuplot-nox");
  if (error != 0) throw std::runtime_error("gnuplot: " + std::generic_category().message(error));

  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const std::string picture = contents(out.get());
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || picture.empty()) {
    std::string reason = contents(complaints.get());
    for (char& c : reason)
      if (c == '\n') c = ' ';
    throw std::runtime_error("gnuplot failed: " + reason);
  }
  return picture;
}

/// Gives cairo the next bytes of a string.
cairo_status_t nextBytes(void* closure, unsigned char* data, unsigned count) {
  auto& rest = *static_cast<std::string_view*>(closure);
  if (rest.size() < count) return CAIRO_STATUS_READ_ERROR;
  std::copy_n(rest.begin(), count, data);
  rest.remove_prefix(count);
  return CAIRO_STATUS_SUCCESS;
}

/// The pixels of a PNG without transparency.
Preview pixelsOf(std::string_view png) {
  const std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)> surface(
      cairo_image_surface_create_from_png_stream(nextBytes, &png), cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("gnuplot failed: it gave no picture");
  Preview picture;
  picture.width = cairo_image_surface_get_width(surface.get());
  picture.height = cairo_image_surface_get_height(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < picture.height; ++y) {
    const unsigned char* const row =
        cairo_image_surface_get_data(surface.get()) + static_cast<std::ptrdiff_t>(y) * stride;
    for (int x = 0; x < picture.width; ++x) {
      std::uint32_t pixel = 0;  // alpha, R, G, B from the highest byte on
      std::memcpy(&pixel, row + 4 * x, sizeof pixel);
      for (const int shift : {16, 8, 0}) picture.rgb.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  }
  return picture;
}

void writeSvg(const Output& output, const std::string& svg, const std::string& software) {
  AtomicFile file(output);
  const std::size_t declaration = svg.find('\n') + 1;
  file.write(svg.substr(0, declaration) + "<!-- " + software + " -->\n" + svg.substr(declaration));
  file.commit();
}

}  // namespace

void drawChart(const Output& output, const ChartAxes& axes, std::span<const ChartCurve> curves,
               const std::string& software) {
  if (std::all_of(curves.begin(), curves.end(), [](const ChartCurve& curve) { return curve.points.empty(); }))
    throw std::invalid_argument("a chart needs a point at least");
  const std::string extension = extensionOf(output.path);
  const std::string picture = gnuplot(script(extension, axes, curves));
  if (extension == ".svg") return writeSvg(output, picture, software);
  writePng(output, pixelsOf(picture), {{"Software", software}});
}

}  // namespace parhelion
