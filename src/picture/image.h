// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "math/conventions.h"
#include "picture/limits.h"

namespace parhelion {

/// One plane of an image, row-major from the top left.
struct Channel {
  std::string name;  // "R", "G", "B"; others as files name them
  std::vector<float> samples;
};

/// A picture as planes of equal size. R, G, B are linear Rec.709.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Channel> channels;

  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }

  /// A new channel of zeros. References to channels added before end.
  std::vector<float>& add(std::string name) {
    return channels.emplace_back(Channel{std::move(name), std::vector<float>(pixels())}).samples;
  }

  /// The samples of a channel, or null where the image has none of that name.
  const std::vector<float>* find(std::string_view name) const {
    for (const Channel& channel : channels) {
      if (channel.name == name) return &channel.samples;
    }
    return nullptr;
  }
  std::vector<float>* find(std::string_view name) {
    return const_cast<std::vector<float>*>(std::as_const(*this).find(name));
  }

  /// The same; a new channel of zeros where there is none.
  std::vector<float>& findOrAdd(const std::string& name) {
    std::vector<float>* const samples = find(name);
    return samples ? *samples : add(name);
  }

  /// The planes R, G, B; throws std::invalid_argument if one is missing.
  std::array<const std::vector<float>*, 3> rgb() const {
    const std::array planes{find("R"), find("G"), find("B")};
    if (!planes[0] || !planes[1] || !planes[2]) throw std::invalid_argument("the image has no channels R, G, B");
    return planes;
  }

  /// Changes the colour of each pixel by a function of (R, G, B); throws as rgb() does.
  template <class Change>
  void changeColours(const Change& change) {
    static_cast<void>(rgb());
    change3({find("R"), find("G"), find("B")}, change);
  }

  /// The same of every layer NAME that has the channels NAME.R, NAME.G and NAME.B.
  template <class Change>
  void changeColoursOfAll(const Change& change) {
    changeColours(change);
    for (const Channel& channel : channels) {
      if (!channel.name.ends_with(".R")) continue;
      const std::string layer = channel.name.substr(0, channel.name.size() - 1);
      const std::array planes{find(channel.name), find(layer + "G"), find(layer + "B")};
      if (planes[1] && planes[2]) change3(planes, change);
    }
  }

 private:
  template <class Change>
  void change3(const std::array<std::vector<float>*, 3>& planes, const Change& change) {
    for (std::size_t i = 0; i < pixels(); ++i) {
      const Vec3 colour = change(Vec3((*planes[0])[i], (*planes[1])[i], (*planes[2])[i]));
      for (int c = 0; c < 3; ++c) (*planes[static_cast<std::size_t>(c)])[i] = static_cast<float>(colour[c]);
    }
  }
};

}  // namespace parhelion
