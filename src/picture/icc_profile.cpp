// SPDX-License-Identifier: Apache-2.0
#include "picture/icc_profile.h"

#include <lcms2.h>
#include <lcms2_plugin.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <type_traits>

#include "picture/limits.h"
#include "picture/transfer.h"

namespace parhelion {
namespace {

struct Close {
  void operator()(void* context) const { cmsDeleteContext(static_cast<cmsContext>(context)); }
};
struct CloseProfile {
  void operator()(void* profile) const { cmsCloseProfile(profile); }
};
struct CloseTransform {
  void operator()(void* transform) const { cmsDeleteTransform(transform); }
};
using Context = std::unique_ptr<std::remove_pointer_t<cmsContext>, Close>;  // its errors go nowhere
using Profile = std::unique_ptr<void, CloseProfile>;
using Transform = std::unique_ptr<void, CloseTransform>;

/// Memory that lcms2 has taken for a context, whose user data this is. A profile of a few bytes can promise tables of
/// gigabytes.
struct Memory {
  std::uint64_t taken = 0;  // bytes
};

/// None while a context is not yet complete.
Memory* memoryOf(cmsContext context) { return static_cast<Memory*>(cmsGetContextUserData(context)); }

void release(cmsContext context, void* memory) {
  if (Memory* const all = memoryOf(context)) all->taken -= ::malloc_usable_size(memory);
  std::free(memory);
}

/// Null, as where there is no more memory, if it were too much.
void* resized(cmsContext context, void* memory, cmsUInt32Number size) {
  Memory* const all = memoryOf(context);
  if (all && all->taken + size > kMostProfileMemory) return nullptr;
  const std::size_t before = ::malloc_usable_size(memory);
  void* const now = std::realloc(memory, size);
  if (all && now) all->taken += ::malloc_usable_size(now) - before;
  return now;
}

void* allocated(cmsContext context, cmsUInt32Number size) { return resized(context, nullptr, size); }

/// A context for a profile of others.
Context limitedContext(Memory& memory) {
  cmsPluginMemHandler handler{};
  handler.base = {cmsPluginMagicNumber, LCMS_VERSION, cmsPluginMemHandlerSig, nullptr};
  handler.MallocPtr = allocated;
  handler.FreePtr = release;
  handler.ReallocPtr = resized;
  Context context(cmsCreateContext(&handler, &memory));
  if (!context) throw std::bad_alloc();
  return context;
}

// Profiles of sRGB by different makers differ by up to 1.4 steps of 8 bits (old GIMP's and darktable's, pure green).
constexpr double kSameColour = 2.0 / 255.0;

constexpr char kDamaged[] = "its colours are in a damaged profile";

/// The profile's own name for itself, printable and not too long for a line.
std::string nameOf(cmsHPROFILE profile) {
  constexpr std::size_t kLongest = 80;
  std::array<char, kLongest + 1> text{};
  cmsGetProfileInfoASCII(profile, cmsInfoDescription, "en", "US", text.data(), kLongest);
  std::string name = text.data();
  std::erase_if(name, [](char c) { return c < ' ' || c > '~' || c == '"'; });
  return name.empty() ? "without a name" : name;
}

/// Whether a grid of colours comes out of the profile as it went in, measured in sRGB.
bool isSrgb(cmsContext context, cmsHPROFILE profile) {
  const Profile srgb(cmsCreate_sRGBProfileTHR(context));
  const Transform transform(cmsCreateTransformTHR(context, profile, TYPE_RGB_DBL, srgb.get(), TYPE_RGB_DBL,
                                                  INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOCACHE));
  if (!transform) return false;
  constexpr int kSteps = 8;  // a component; 9^3 colours
  for (int i = 0; i < (kSteps + 1) * (kSteps + 1) * (kSteps + 1); ++i) {
    const std::array<double, 3> in{static_cast<double>(i % (kSteps + 1)) / kSteps,
                                   static_cast<double>(i / (kSteps + 1) % (kSteps + 1)) / kSteps,
                                   static_cast<double>(i / (kSteps + 1) / (kSteps + 1)) / kSteps};
    std::array<double, 3> out{};
    cmsDoTransform(transform.get(), in.data(), out.data(), 1);
    for (std::size_t c = 0; c < 3; ++c) {
      if (!(std::abs(out[c] - in[c]) <= kSameColour)) return false;
    }
  }
  return true;
}

/// Whether a grey profile's curve is sRGB's or the power of 2.2.
bool isUsualGrey(cmsHPROFILE profile) {
  const auto* curve = static_cast<const cmsToneCurve*>(cmsReadTag(profile, cmsSigGrayTRCTag));
  if (!curve) return false;
  bool srgb = true, power = true;
  for (int code = 0; code < 256; ++code) {
    const double encoded = code / 255.0;
    const double linear = cmsEvalToneCurveFloat(curve, static_cast<float>(encoded));
    srgb = srgb && std::abs(srgbEncode(linear) - encoded) <= kSameColour;
    power = power && std::abs(std::pow(std::max(linear, 0.0), 1.0 / 2.2) - encoded) <= kSameColour;
  }
  return srgb || power;
}

}  // namespace

std::string profileObjection(std::span<const std::uint8_t> bytes, bool grey) {
  Memory memory;
  const Context context = limitedContext(memory);
  const Profile profile(
      cmsOpenProfileFromMemTHR(context.get(), bytes.data(), static_cast<cmsUInt32Number>(bytes.size())));
  if (!profile) return kDamaged;
  // The file's own number: an enumeration of C++ must not hold others than its enumerators need.
  const cmsUInt32Number space = cmsGetColorSpace(profile.get());
  if (space == cmsSigRgbData && isSrgb(context.get(), profile.get())) return {};
  if (space == cmsSigGrayData && grey && isUsualGrey(profile.get())) return {};
  return "its colours are in the profile \"" + nameOf(profile.get()) + "\", not sRGB";
}

std::vector<std::uint8_t> srgbProfile() {
  const Context context(cmsCreateContext(nullptr, nullptr));
  if (!context) throw std::bad_alloc();
  const Profile profile(cmsCreate_sRGBProfileTHR(context.get()));
  cmsUInt32Number size = 0;
  if (!profile || !cmsSaveProfileToMem(profile.get(), nullptr, &size)) throw std::bad_alloc();
  std::vector<std::uint8_t> bytes(size);
  if (!cmsSaveProfileToMem(profile.get(), bytes.data(), &size)) throw std::bad_alloc();
  // ICC.1:2010, 7.2.8: six big-endian numbers from byte 24 are the date of the profile; 2000-01-01.
  constexpr std::array<std::uint8_t, 12> kDate{2000 >> 8, 2000 & 0xff, 0, 1, 0, 1, 0, 0, 0, 0, 0, 0};
  std::copy(kDate.begin(), kDate.end(), bytes.begin() + 24);
  return bytes;
}

}  // namespace parhelion
