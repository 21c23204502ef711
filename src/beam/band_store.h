// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "beam/band_light.h"
#include "beam/pixel_directions.h"
#include "beam/scatter_scene.h"

namespace parhelion {

/// All that decides what a band of light is.
struct BandKind {
  std::vector<PrismShare> prisms;
  std::vector<double> indices;  // at which light is traced
  int columns = 0;              // LightTable
  double cutShare = 0.0;
  BandMesh mesh;
  bool colours = false;
  LightSegments lights, fewLights;
  const WantedPaths* wanted = nullptr;

  bool operator==(const BandKind&) const = default;

  /// Whether bands of it have all that those of another one have, to the bit.
  bool covers(const BandKind& other) const {
    BandKind same = *this;
    same.mesh = other.mesh;
    return mesh.covers(other.mesh) && same == other;
  }
};

/// A band and its number.
struct NumberedBand {
  int number;
  const BandLight::Band* band;
};

/// Bands of light, kept from one picture to the next: neither the sun's place nor how crystals tilt matters to them.
/// What is kept changes no bit of any picture.
class BandStore {
 public:
  /// Keeps at most so many bytes of bands. With 0 there is nothing left of any kind once another is asked for.
  explicit BandStore(std::uint64_t mostBytes = 0) : mostBytes_(mostBytes) {}
  BandStore(const BandStore&) = delete;  // kinds of bands refer to it
  BandStore& operator=(const BandStore&) = delete;

  /// Bands that are made side by side.
  static constexpr std::size_t kAtOnce = 8;

  /// Memory that pictures are made in, one after the other: to have it anew for each takes longer than to use it.
  std::vector<AlignedVector<float>> room;

  /// Bands of one kind.
  class Bands {
   public:
    const BandLight& light() const { return light_; }

    /// Directions of light in crystals that were traced so far.
    long directions() const { return table_.directions(); }

    /// Makes those of these bands (rising numbers) that are not kept, and hands all out in their order, some at a time.
    void forEach(std::span<const int> numbers, const std::function<void(std::span<const NumberedBand>)>& take);

   private:
    friend class BandStore;
    struct Kept {
      BandLight::Band band;
      long lastPicture;
    };
    Bands(BandStore& store, BandKind kind);
    std::uint64_t bytesEach() const { return sizeof(float) * light_.layout().size(); }
    void drop(long beforePicture);

    BandStore& store_;
    BandKind kind_;
    std::shared_ptr<const CosineTable> cosines_;
    LightTable table_;
    BandLight light_;
    std::vector<BandLight::Band> made_;
    std::map<int, Kept> kept_;
    long lastPicture_ = 0;
  };

  /// A new picture begins: what neither the last one nor this one uses may go.
  void startPicture();

  /// Cosines for so many cells.
  std::shared_ptr<const CosineTable> cosines(int cells);

  /// Directions of a camera's pixels; kept until another camera's are asked for.
  std::shared_ptr<const PixelDirections> directions(const Camera& camera);

  /// Solid angles of a camera's pixels (sr).
  std::vector<double> solidAngles(const Camera& camera) const;

  /// Bands of a kind, or of one that covers it. Good until the next picture; without room, until another kind is asked
  /// for.
  Bands& open(const BandKind& kind);

 private:
  std::uint64_t mostBytes_, held_ = 0;
  long picture_ = 0;
  std::map<int, std::weak_ptr<const CosineTable>> cosines_;  // by cells
  std::shared_ptr<const PixelDirections> directions_;
  std::vector<std::unique_ptr<Bands>> kinds_;
};

}  // namespace parhelion
