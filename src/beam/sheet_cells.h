// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "beam/edge_parts.h"
#include "beam/pixel_film.h"
#include "sky/lens.h"

namespace parhelion {

/// How the light of sheets of orientations is put into a picture.
struct SheetPicture {
  double faint = 0.0;    // light to a pixel, below which it is put to its place by points
  bool hasEdge = false;  // the projection goes on smoothly beyond what the camera sees
  double widest = -2.0;  // cosine of the largest angle from the camera's axis that the picture shows; -2: all
};

/// What a class's light does at the nodes of a row, and where each of a few views of it is in the picture.
struct SheetNodes {
  static constexpr int kViews = 4;

  explicit SheetNodes(std::size_t room = 0) : light(room), density(room), excess(room) {
    for (auto* views : {&x, &y, &seen}) views->fill(std::vector<double>(room));
  }

  bool dark = true;
  std::vector<double> light, density, excess;  // what meets the exit, what leaves, the squared cosine outside
  std::array<std::vector<double>, kViews> x, y, seen;
};

/// A place on a sheet, between nodes too, and a class's light there.
struct SheetCorner {
  double row, column;  // in the units of the sheet
  double light, density, excess;
  Triple<double> lightDir;  // world
};

/// A mesh of cells, of which the nodes of two rows are known: each puts the light of a class into a picture. Corners
/// are exact, and place and light are linear between them.
class SheetCells {
 public:
  using Four = PixelFilm::Four;

  SheetCells(const Lens& lens, const SheetPicture& picture) : lens_(lens), picture_(picture) {}

  /// How one view of the cells between two rows is added.
  struct Strip {
    int view, columns, step;  // cells along the rows, and how many of them make one
    double share;             // of light, for each cell
    Four per;                 // the film's sums for each light
  };

  /// Adds all cells between rows. cornerOf(behind, column) is a node of the first row, or of the one behind it;
  /// exitAt(corner) tells density, excess and direction of the light at its place.
  template <class CornerOf, class ExitAt>
  void addCells(const SheetNodes& na, const SheetNodes& nb, const Strip& strip, PixelFilm& film,
                const CornerOf& cornerOf, const ExitAt& exitAt) const {
    if (na.dark && nb.dark) return;
    const auto v = static_cast<std::size_t>(strip.view);
    const double share = strip.share, most = kWide * lens_.width, faint = picture_.faint;
    for (int column = 0; column < strip.columns; column += strip.step) {
      const auto k = static_cast<std::size_t>(column), l = k + static_cast<std::size_t>(strip.step);
      if (!na.dark && !nb.dark) {
        if (na.light[k] + na.light[l] + nb.light[k] + nb.light[l] == 0.0 ||
            std::max({na.excess[k], na.excess[l], nb.excess[k], nb.excess[l]}) <= 0.0)
          continue;
        const LitPlace p[4] = {{na.x[v][k], na.y[v][k], share * na.density[k]},
                               {na.x[v][l], na.y[v][l], share * na.density[l]},
                               {nb.x[v][k], nb.y[v][k], share * nb.density[k]},
                               {nb.x[v][l], nb.y[v][l], share * nb.density[l]}};
        const bool out = na.excess[k] > 0.0 && na.excess[l] > 0.0 && nb.excess[k] > 0.0 && nb.excess[l] > 0.0;
        const double seen = na.seen[v][k] + na.seen[v][l] + nb.seen[v][k] + nb.seen[v][l];
        if (seen == 0.0 && out) continue;
        if (out && seen == 4.0 && std::abs(p[0].x - p[3].x) < most && std::abs(p[1].x - p[2].x) < most) {
          const double w = std::abs(p[0].x - p[3].x) + std::abs(p[1].x - p[2].x),
                       h = std::abs(p[0].y - p[3].y) + std::abs(p[1].y - p[2].y);
          if (p[0].light + p[1].light + p[2].light + p[3].light < faint * std::max(1.0, w * h))
            film.addFaintQuad(p, strip.per);
          else
            film.addQuad(p, strip.per);
          continue;
        }
      }
      if (addNodes(na, nb, k, l, strip, film)) continue;
      const SheetCorner c[4] = {cornerOf(false, column), cornerOf(false, column + strip.step), cornerOf(true, column),
                                cornerOf(true, column + strip.step)};
      const int depth = strip.step == 1 ? kEdgeDepth : kEdgeDepth + 1;
      const auto between = [&](const SheetCorner& p, const SheetCorner& q) {
        return exitAt({0.5 * (p.row + q.row), 0.5 * (p.column + q.column), 0.5 * (p.light + q.light), 0.0, 0.0, {}});
      };
      const auto add = [&](const SheetCorner& p, const SheetCorner& q, const SheetCorner& r, double part) {
        if (p.light + q.light + r.light == 0.0) return;
        addSky({-p.lightDir, part * p.density}, {-q.lightDir, part * q.density}, {-r.lightDir, part * r.density},
               kTornDepth, strip.per, film);
      };
      const auto isSmall = [](const auto&...) { return false; };
      addParts(c[0], c[1], c[2], 0.5 * share, depth, between, add, isSmall);
      addParts(c[1], c[3], c[2], 0.5 * share, depth, between, add, isSmall);
    }
  }

  /// The same of a row by itself, whose light comes to lines.
  template <class CornerOf, class ExitAt>
  void addLines(const SheetNodes& nodes, const Strip& strip, PixelFilm& film, const CornerOf& cornerOf,
                const ExitAt& exitAt) const {
    if (nodes.dark) return;
    const auto v = static_cast<std::size_t>(strip.view);
    const double share = strip.share, most = kWide * lens_.width;
    for (int column = 0; column < strip.columns; column += strip.step) {
      const auto k = static_cast<std::size_t>(column), l = k + static_cast<std::size_t>(strip.step);
      if (nodes.light[k] + nodes.light[l] == 0.0 || std::max(nodes.excess[k], nodes.excess[l]) <= 0.0) continue;
      const bool out = nodes.excess[k] > 0.0 && nodes.excess[l] > 0.0;
      const double seen = nodes.seen[v][k] + nodes.seen[v][l];
      if (seen == 0.0 && out) continue;
      const LitPlace a{nodes.x[v][k], nodes.y[v][k], share * nodes.density[k]},
          b{nodes.x[v][l], nodes.y[v][l], share * nodes.density[l]};
      if (out && seen == 2.0 && std::abs(a.x - b.x) < most) {
        film.addLine(a, b, strip.per);
        continue;
      }
      // Point by point.
      const int parts = kLineParts * strip.step;
      const SheetCorner from = cornerOf(column), to = cornerOf(column + strip.step);
      if (from.light + to.light == 0.0) continue;
      for (int part = 0; part < parts; ++part) {
        const double t = (part + 0.5) / parts;
        const SheetCorner at = exitAt({from.row,
                                       from.column + t * (to.column - from.column),
                                       from.light + t * (to.light - from.light),
                                       0.0,
                                       0.0,
                                       {}});
        if (const PicturePlace<double> place = lens_.placeBeyond(-at.lightDir); at.excess > 0.0 && place.inside)
          film.add({place.x, place.y, share * at.density / parts}, strip.per);
      }
    }
  }

 private:
  // Triangles across which light stops getting out are parted so often, with exact directions; those that the camera
  // tears apart, too.
  static constexpr int kEdgeDepth = 2, kTornDepth = 5;
  // Parts of a line that is one of these.
  static constexpr int kLineParts = 32;
  // All triangles that are wider than this share of the picture are looked at, whether the camera tears them apart.
  static constexpr double kWide = 0.125;

  /// Light on its way to a place of the picture.
  struct SkyLight {
    Triple<double> toSky;
    double light;
  };

  bool addNodes(const SheetNodes& na, const SheetNodes& nb, std::size_t k, std::size_t l, const Strip& strip,
                PixelFilm& film) const;
  void addSky(const SkyLight& a, const SkyLight& b, const SkyLight& c, int depth, const Four& per,
              PixelFilm& film) const;
  /// The part of a triangle within the image circle and above a horizon that is cut.
  void addSeen(const SkyLight* const (&all)[3], const LitPlace (&at)[3], const Four& per, PixelFilm& film) const;

  Lens lens_;
  SheetPicture picture_;
};

}  // namespace parhelion
