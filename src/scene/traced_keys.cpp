// SPDX-License-Identifier: Apache-2.0
#include "scene/traced_keys.h"

#include <array>
#include <charconv>
#include <string_view>
#include <type_traits>
#include <variant>

#include "math/checksum.h"
#include "math/names.h"
#include "sky/camera_text.h"

namespace parhelion {

namespace {

/// The shortest digits that read back as the same number.
std::string digitsOf(double x) {
  std::array<char, 32> digits{};
  // Nothing differs by the sign of a zero.
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), x + 0.0);
  return {digits.data(), result.ptr};
}

std::string digitsOf(const std::vector<double>& numbers) {
  std::string list;
  for (const double x : numbers) list += (list.empty() ? "" : " ") + digitsOf(x);
  return list;
}

std::string textOf(const FixedValue& fixed) { return digitsOf(fixed.value); }

template <class Distribution>
std::string textOf(const Distribution& distribution) {
  const auto& [first, second] = distribution;
  return std::string(Distribution::kWords.name) + " " + digitsOf(first) + " " + digitsOf(second);
}

template <class... Distributions>
std::string textOf(const std::variant<Distributions...>& distribution) {
  return std::visit([](const auto& own) { return textOf(own); }, distribution);
}

/// Lists settings. Each struct is taken apart whole, so that a member that is forgotten here does not compile.
class KeyLister {
 public:
  void sun(const SunSettings& settings) {
    const auto& [elevation, diameter, spectrum, visible, azimuth] = settings;
    put("sun.elevation", digitsOf(elevation));
    put("sun.diameter", digitsOf(diameter));
    std::visit([this](const auto& own) { light(own); }, spectrum);
    static_cast<void>(visible);  // drawn afterwards
    static_cast<void>(azimuth);  // all azimuths count from the sun
  }

  void ice(const IceSettings& settings) {
    const auto& [own, absorbs, k] = settings;
    std::visit([this](const auto& one) { put("ice.index", index(one)); }, own);
    // What is off is not told, so that scenes keep their hash.
    absorbs_ = absorbs;
    if (absorbs) put("ice.absorption", k ? digitsOf(*k) : "true");
  }

  /// The air reddens the light that reaches the crystals.
  void sky(const SkySettings& settings, const ObserverSettings& observer, const std::optional<SlabSettings>& cloud) {
    const auto& [air, ozone, aerosol, ground] = settings;
    static_cast<void>(ground);  // seen afterwards
    if (!air) return;
    const auto& [beta, alpha, albedo, g, height] = aerosol;
    static_cast<void>(albedo);  // likewise
    static_cast<void>(g);       // likewise
    put("sky.ozone", digitsOf(ozone));
    put("sky.aerosol", digitsOf(beta) + " " + digitsOf(alpha) + " " + digitsOf(height));
    const auto& [altitude] = observer;
    if (cloud && cloud->altitude)
      put("cloud.altitude", digitsOf(*cloud->altitude));
    else
      put("observer.altitude", digitsOf(altitude));
  }

  void population(std::size_t number, const PopulationSettings& settings) {
    const auto& [name, weight, shape, orientation, size, distortion, diffracts] = settings;
    prefix_ = "population." + std::to_string(number) + ".";
    if (namesMatter) put("name", name);  // no ray knows it, but patterns of paths may
    put("weight", digitsOf(weight));
    put("shape", std::string(nameOf(shape)));
    std::visit([this](const auto& own) { crystal(own); }, shape);
    std::visit([this](const auto& own) { stance(own); }, orientation);
    if (size && (absorbs_ || diffracts)) put("size", textOf(*size));
    if (distortion > 0.0) put("distortion", digitsOf(distortion));
    if (diffracts) put("diffraction", "true");
    prefix_.clear();
  }

  void trace(const TraceSettings& settings) {
    const auto& [rays, seed, engine, path, sampler, symmetry, paths, allocation] = settings;
    static_cast<void>(rays);        // how many there are changes none of them
    static_cast<void>(seed);        // told apart from the scene
    static_cast<void>(symmetry);    // of tallies alone
    static_cast<void>(allocation);  // likewise
    put("trace.engine", std::string(nameOf(engine)));
    put("trace.path", std::string(nameOf(path)));
    put("trace.sampler", std::string(nameOf(sampler)));
    if (paths.filter) put("trace.filter", paths.filter->text);
  }

  void layers(const PathSettings& settings) {
    const auto& [filter, layers] = settings;
    static_cast<void>(filter);  // of all that is traced
    for (std::size_t i = 0; i < layers.size(); ++i) {
      const auto& [name, paths, populations, tilt, order] = layers[i];
      prefix_ = "layer." + std::to_string(i) + ".";
      put("name", name);
      if (paths) put("paths", paths->text);
      for (const std::string& one : populations) put("population", one);
      if (tilt) put("tilt", digitsOf(tilt->from) + " " + digitsOf(tilt->to));
      if (order) put("order", std::to_string(*order));
    }
    prefix_.clear();
  }

  void tally(const Scene& scene, const TraceSettings& trace) {
    put("trace.symmetry", std::string(nameOf(trace.symmetry)));
    // The usual one is not told, so that scenes keep their hash.
    if (trace.allocation != Allocation::automatic) put("trace.allocation", std::string(nameOf(trace.allocation)));
    layers(trace.paths);
    for (const auto& [attribute, value] : textFromCamera(scene.camera)) put(attribute, value);
    put("camera.resolution", std::to_string(scene.camera.width) + " " + std::to_string(scene.camera.height));
  }

  std::vector<TracedKey> keys;
  bool namesMatter = false;

 private:
  void put(const std::string& key, std::string value) { keys.push_back({prefix_ + key, std::move(value)}); }

  static std::string index(const PublishedIndex& own) { return std::string(nameOf(own.material)); }
  static std::string index(const ConstantIndex& own) { return digitsOf(own.index); }
  static std::string index(const IndexMixture& own) { return digitsOf(own.indices); }
  static std::string index(const SellmeierIndex& own) {
    std::string text = "sellmeier " + digitsOf(own.constant);
    for (const auto& [strength, resonance] : own.terms) text += " " + digitsOf(strength) + " " + digitsOf(resonance);
    return text;
  }
  static std::string index(const CauchyIndex& own) { return "cauchy " + digitsOf(own.coefficients); }
  static std::string index(const IndexTable& own) {
    std::string text = "table";
    for (const auto& [wavelength, n, k] : own.nodes)
      text += " " + digitsOf(wavelength) + " " + digitsOf(n) + (own.hasK ? " " + digitsOf(k) : "");
    return text;
  }

  void light(const ContinuousSpectrum& own) { put("sun.spectrum", std::string(nameOf(own.source))); }
  void light(const MonochromaticSpectrum& own) { put("sun.spectrum", digitsOf(own.wavelength)); }
  void light(const BlackBody& own) { put("sun.spectrum", "blackbody " + digitsOf(own.temperature)); }
  void light(const LineSpectrum& own) {
    const auto& [wavelengths, weights] = own;
    put("sun.spectrum", "lines " + digitsOf(wavelengths) + " weights " + digitsOf(weights));
  }

  void crystal(const PrismSettings& own) {
    const auto& [aspect, ownSides, ownSpreads, upper, lower, notch] = own;
    put("aspect", textOf(aspect));
    sides(ownSides);
    spreads(ownSpreads);
    // What is not there is not told, so that scenes keep their hash.
    if (upper.cavity.isThere() || lower.cavity.isThere()) {
      put("upper.cavity", digitsOf({upper.cavity.depth, upper.cavity.width}));
      put("lower.cavity", digitsOf({lower.cavity.depth, lower.cavity.width}));
    }
    if (upper.cap.isThere()) put("upper.cap", digitsOf({upper.cap.width, upper.cap.aspect}));
    if (lower.cap.isThere()) put("lower.cap", digitsOf({lower.cap.width, lower.cap.aspect}));
    if (notch.isThere()) put("notch", digitsOf({notch.depth, notch.width}));
  }
  void crystal(const PyramidSettings& own) {
    const auto& [aspect, upper, lower, slope, upperSlope, lowerSlope, ownSides, ownSpreads] = own;
    put("aspect", digitsOf(aspect));
    put("upper", digitsOf(upper));
    put("lower", digitsOf(lower));
    put("slope", digitsOf(slope));
    if (upperSlope) put("upper.slope", digitsOf(*upperSlope));
    if (lowerSlope) put("lower.slope", digitsOf(*lowerSlope));
    sides(ownSides);
    spreads(ownSpreads);
  }
  void crystal(const PlanesSettings& own) {
    for (const auto& [number, normal, distance] : own.planes)
      put("plane", std::to_string(number) + " " + digitsOf(normal.x) + " " + digitsOf(normal.y) + " " +
                       digitsOf(normal.z) + " " + digitsOf(distance));
  }

  void crystal(const MeshSettings& own) {
    Checksum content;
    content.add(own.obj);
    put("mesh", std::to_string(content.value()));
  }

  void crystal(const RosetteSettings& own) {
    const auto& [bullets, aspect, slope, overlap] = own;
    put("bullets", std::to_string(bullets));
    put("aspect", digitsOf(aspect));
    put("slope", digitsOf(slope));
    put("overlap", digitsOf(overlap));
  }

  void spreads(const std::vector<ShapeSpread>& own) {
    for (const auto& [what, which, distribution] : own) {
      std::string text(nameOf(what));
      for (const bool one : which) text += one ? " 1" : " 0";
      put("spread", text + " " + textOf(distribution));
    }
  }

  /// Regular ones are not told, so that scenes keep their hash.
  void sides(const Sides& own) {
    if (own != kRegularSides) put("sides", digitsOf({own.begin(), own.end()}));
  }

  void stance(const RandomOrientation&) { put("orientation", "random"); }
  void stance(const AxisOrientation& own) {
    const auto& [zenith, azimuth, roll] = own;
    put("orientation.zenith", textOf(zenith));
    put("orientation.azimuth", textOf(azimuth));
    put("orientation.roll", textOf(roll));
  }
  void stance(const LowitzOrientation& own) {
    const auto& [axisZenith, spin] = own;
    put("orientation.axis-zenith", textOf(axisZenith));
    put("orientation.spin", textOf(spin));
  }

  std::string prefix_;
  bool absorbs_ = false;
};

KeyLister listed(const Scene& scene, const TraceSettings& trace) {
  KeyLister lister;
  lister.namesMatter = trace.paths.filter || !trace.paths.layers.empty();
  lister.sun(scene.sun);
  lister.ice(scene.ice);
  lister.sky(scene.sky, scene.observer, scene.cloud);
  for (std::size_t i = 0; i < scene.populations.size(); ++i) lister.population(i, scene.populations[i]);
  lister.trace(trace);
  return lister;
}

}  // namespace

std::vector<TracedKey> tracedKeys(const Scene& scene, const TraceSettings& trace) { return listed(scene, trace).keys; }

std::vector<TracedKey> talliedKeys(const Scene& scene, const TraceSettings& trace) {
  KeyLister lister = listed(scene, trace);
  lister.tally(scene, trace);
  return lister.keys;
}

std::uint64_t hashOf(const std::vector<TracedKey>& keys) {
  Checksum checksum;
  for (const auto& [key, value] : keys) checksum.add(key + "=" + value + "\n");
  return checksum.value();
}

}  // namespace parhelion
