// SPDX-License-Identifier: Apache-2.0
#include "scene/describe.h"

#include <type_traits>

#include "math/overloaded.h"
#include "math/range.h"
#include "optics/materials.h"
#include "scene/scene_keys.h"
#include "sky/camera_keys.h"

namespace parhelion {

namespace {

/// How a distribution's numbers are shown: as they are, or radians as degrees.
using Show = std::string (*)(double);
std::string plain(double value) { return formatNumber(value); }
std::string inDegrees(double angle) { return formatNumber(degrees(angle)) + "°"; }

template <class Distribution>
std::string describe(const Distribution& distribution, Show show) {
  const auto fixed = [=](const FixedValue& d) { return show(d.value); };
  const auto spread = [=]<class D>(const D& d) {
    const auto& [first, second] = d;
    const DistributionWords& words = D::kWords;
    if (words.isRange) return show(first) + " to " + show(second);
    return show(first) + ", " + std::string(words.name) + ", " + std::string(words.second) + " " + show(second);
  };
  return std::visit(Overloaded{fixed, spread}, distribution);
}

/// The same for an azimuth or a roll, which may take every value.
std::string describeTurn(const AngleDistribution& turn) {
  return isFree(turn, 2.0 * kPi) ? "free" : describe(turn, inDegrees);
}

std::string describe(const OrientationSettings& orientation) {
  return std::visit(Overloaded{
                        [](const RandomOrientation&) { return std::string("random orientation"); },
                        [](const AxisOrientation& o) {
                          return std::string("c axis at zenith angle ").append(describe(o.zenith, inDegrees)) +
                                 "; azimuth " + describeTurn(o.azimuth) + "; roll " + describeTurn(o.roll);
                        },
                        [](const LowitzOrientation& o) {
                          return std::string("lowitz axis at zenith angle ").append(describe(o.axisZenith, inDegrees)) +
                                 "; spin " + describeTurn(o.spin);
                        },
                    },
                    orientation);
}

/// "450, 550, 650"
std::string listed(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + plain(number);
  return text;
}

std::string wordsFor(const kinds::PlaneList&, const std::vector<FacePlane>& planes) {
  return std::to_string(planes.size());
}
std::string wordsFor(const kinds::Number&, double number) { return plain(number); }
std::string wordsFor(const kinds::WholeNumber&, int number) { return plain(number); }
std::string wordsFor(double aspect) { return plain(aspect); }
std::string wordsFor(const AspectDistribution& aspect) { return describe(aspect, plain); }

/// Visits the keys of a population and describes its shape by those that the shape has.
class ShapeWords {
 public:
  explicit ShapeWords(const ShapeSettings& shape) : spreads_(spreadsOf(shape)) {}

  template <class Kind, class T>
  void key(std::string_view, const Kind&, const T&, std::string_view) {}

  template <class Kind, class T, class... Owners>
  void key(std::string_view name, const kinds::MemberOf<Kind, T, Owners...>& kind, const PopulationShape& shape,
           std::string_view) {
    // Haze is no crystal and has words of its own.
    if constexpr (!(std::is_same_v<Owners, HazeWords> || ...))
      kind.visitMember(shape, [&](const T& member) { add(name, wordsFor(kind.kind(), member)); });
  }
  void key(std::string_view name, const kinds::Aspect&, const PopulationShape& shape, std::string_view) {
    std::visit(
        [&](const auto& own) {
          if constexpr (requires { own.aspect; }) add(name, wordsFor(own.aspect));
        },
        shape);
  }
  void key(std::string_view name, const kinds::PyramidEnd& end, const PopulationShape& shape, std::string_view) {
    const auto* pyramid = std::get_if<PyramidSettings>(&shape);
    if (!pyramid) return;
    const std::optional<double>& slope = end.isUpper ? pyramid->upperSlope : pyramid->lowerSlope;
    add(name, plain(end.isUpper ? pyramid->upper : pyramid->lower) + (slope ? " at " + inDegrees(*slope) : ""));
  }
  void key(std::string_view name, const kinds::PyramidSlope&, const PopulationShape& shape, std::string_view) {
    const auto tell = [&](const auto& own) {
      if constexpr (requires { own.slope; }) add(name, inDegrees(own.slope));
    };
    std::visit(tell, shape);
  }
  void key(std::string_view name, const kinds::SideDistances&, const PopulationShape& shape, std::string_view) {
    const auto tell = [&](const auto& own) {
      if constexpr (requires { own.sides; })
        if (own.sides != kRegularSides) add(name, listed({own.sides.begin(), own.sides.end()}));
    };
    std::visit(tell, shape);
  }
  void key(std::string_view, const kinds::PrismEndTable<Cavity>& kind, const PopulationShape& shape, std::string_view) {
    if (const PrismEnd* end = endOf(kind, shape); end && end->cavity.isThere())
      text_ += std::string(kind.upper ? ", upper" : ", lower") + " pit " + plain(end->cavity.depth) + " deep, " +
               plain(end->cavity.width) + " wide";
  }
  void key(std::string_view, const kinds::PrismEndTable<Cap>& kind, const PopulationShape& shape, std::string_view) {
    if (const PrismEnd* end = endOf(kind, shape); end && end->cap.isThere())
      text_ += std::string(kind.upper ? ", upper" : ", lower") + " cap " + plain(end->cap.width) + " wide, aspect " +
               plain(end->cap.aspect);
  }
  void key(std::string_view, const kinds::NotchTable&, const PopulationShape& shape, std::string_view) {
    if (const auto* prism = std::get_if<PrismSettings>(&shape); prism && prism->notch.isThere())
      text_ += ", notches " + plain(prism->notch.depth) + " deep, " + plain(prism->notch.width) + " wide";
  }
  void key(std::string_view, const kinds::Mesh&, const PopulationShape& shape, std::string_view) {
    const auto* mesh = std::get_if<MeshSettings>(&shape);
    if (!mesh || !mesh->crystal) return;
    text_ += ", " + std::to_string(mesh->crystal->faces().size()) + " faces" +
             (mesh->crystal->isConvex() ? "" : ", not convex");
  }
  const std::string& text() const { return text_; }

 private:
  /// The end of a prism that a key tells of; none for keys of both.
  static const PrismEnd* endOf(const auto& kind, const PopulationShape& shape) {
    const auto* prism = std::get_if<PrismSettings>(&shape);
    if (!prism || (kind.upper && kind.lower)) return nullptr;
    return kind.upper ? &prism->upper : &prism->lower;
  }

  void add(std::string_view name, const std::string& words) {
    // What is spread is told by itself.
    for (const ShapeSpread& spread : spreads_)
      if (nameOf(spread.what) == name) return;
    text_ += ", " + std::string(name) + " " + words;
  }

  std::span<const ShapeSpread> spreads_;

  std::string text_;
};

/// "upper 0.5, normal, sigma 0.1", "sides 3 5 7 1, uniform, …"
std::string describe(const ShapeSpread& spread) {
  std::string what(nameOf(spread.what));
  for (std::size_t k = 0; k < spread.sides.size(); ++k)
    if (spread.sides[k]) what += " " + std::to_string(k + 3);
  return what + " " + describe(spread.distribution, isSlope(spread.what) ? inDegrees : plain);
}

std::string describe(const ShapeSettings& shape) {
  PopulationKeys keys{.shape = wordsOf(shape)};
  ShapeWords words(shape);
  visitKeys(words, keys);
  std::string text = std::string(nameOf(shape)) + words.text();
  for (const ShapeSpread& spread : spreadsOf(shape)) text += ", " + describe(spread);
  return text;
}

std::string describe(const SpectrumSettings& spectrum) {
  return std::visit(Overloaded{
                        [](const ContinuousSpectrum& s) { return std::string("spectrum ").append(nameOf(s.source)); },
                        [](const MonochromaticSpectrum& s) { return plain(s.wavelength) + " nm"; },
                        [](const LineSpectrum& s) {
                          const std::string lines = listed(s.wavelengths) + " nm";
                          return s.weights.empty() ? lines : lines + " weighted " + listed(s.weights);
                        },
                        [](const BlackBody& s) { return "black body of " + plain(s.temperature) + " K"; },
                    },
                    spectrum);
}

std::string describe(const SunSettings& sun) {
  const std::string azimuth = sun.azimuth ? ", azimuth " + inDegrees(*sun.azimuth) + " from north" : "";
  return std::string("elevation ").append(inDegrees(sun.elevation)) + azimuth + ", diameter " +
         inDegrees(sun.diameter) + ", " + describe(sun.spectrum) + (sun.visible ? ", drawn" : ", not drawn");
}

std::string describe(const IceSettings& ice) {
  const std::string index = std::visit(
      Overloaded{
          [](const PublishedIndex& own) { return "index of " + std::string(factsOf(own.material).source); },
          [](const ConstantIndex& own) { return "index " + plain(own.index); },
          [](const IndexMixture& own) { return "indices " + listed(own.indices) + " in turn"; },
          [](const SellmeierIndex&) { return std::string("index by Sellmeier's formula"); },
          [](const CauchyIndex&) { return std::string("index by Cauchy's formula"); },
          [](const IndexTable& own) { return "index by a table of " + std::to_string(own.nodes.size()) + " rows"; },
      },
      ice.index);
  if (!ice.absorbs) return index;
  return index + ", absorbs" + (ice.k ? " by k = " + plain(*ice.k) : "");
}

/// ", 30 um across, diffracts": what is not ideal about crystals.
std::string describeOptics(const PopulationSettings& population) {
  std::string text;
  if (population.size) text += ", " + describe(*population.size, plain) + " um across";
  if (population.distortion > 0.0) text += ", distorted by " + inDegrees(population.distortion);
  if (population.diffracts) text += ", diffracts";
  return text;
}

/// "rectilinear toward azimuth 0°, elevation 20°, roll 0°; 60° horizontal, 600 x 400 pixels"
class CameraDescription {
 public:
  explicit CameraDescription(const CameraSettings& camera) : camera_(camera) {}

  const std::string& text() const { return text_; }

  void projection(const CameraKey&) { text_ += std::string(nameOf(camera_.projection)) + " toward"; }
  void number(const CameraKey& key, InDegrees, double CameraSettings::*member) { add(key, inDegrees(camera_.*member)); }
  void number(const CameraKey& key, Unitless, double CameraSettings::*member) { add(key, plain(camera_.*member)); }
  void fieldOfView(const FieldOfViewAttributes&, InDegrees) {
    if (showsHemispheres(camera_.projection)) return;
    text_.append("; ").append(inDegrees(camera_.fieldOfView)).append(" ");
    text_ += keyOf(camera_.fieldOfViewAxis).axisName;
  }
  void resolution(const CameraKey&) {
    text_ += ", " + std::to_string(camera_.width) + " x " + std::to_string(camera_.height) + " pixels";
  }

  void choice(const CameraKey& key, auto member) {
    if (camera_.*member != CameraSettings().*member) add(key, std::string(nameOf(camera_.*member)));
  }

  // Most cameras have none of these.
  void numberOrNone(const CameraKey&, auto /*unit*/, auto /*member*/) {}
  void numbers(const CameraKey&, auto /*unit*/, auto /*member*/, const auto& /*parts*/) {}

 private:
  void add(const CameraKey& key, const std::string& value) {
    text_.append(text_.ends_with("toward") ? " " : ", ").append(key.name).append(" ").append(value);
  }

  const CameraSettings& camera_;
  std::string text_;
};

std::string describe(const CameraSettings& camera) {
  CameraDescription description(camera);
  visitCameraKeys(description);
  return description.text();
}

std::string describe(const SkySettings& sky, const ObserverSettings& observer) {
  return "ozone " + plain(sky.ozone) + " Dobson units; aerosol beta " + plain(sky.aerosol.beta) + ", alpha " +
         plain(sky.aerosol.alpha) + ", albedo " + plain(sky.aerosol.albedo) + ", g " + plain(sky.aerosol.g) +
         ", height " + plain(sky.aerosol.height) + " m; ground of albedo " + plain(sky.ground) + "; seen from " +
         plain(observer.altitude) + " m";
}

std::string describe(const TraceSettings& trace) {
  return std::to_string(trace.rays) + " rays, seed " + std::to_string(trace.seed) + ", engine " +
         std::string(nameOf(trace.engine)) + ", path " + std::string(nameOf(trace.path)) + ", sampler " +
         std::string(nameOf(trace.sampler)) + ", symmetry " + std::string(nameOf(trace.symmetry)) +
         (trace.paths.filter ? ", filter " + trace.paths.filter->text : "");
}

std::string describeOrders(int orders) {
  if (orders == SlabSettings::kAllOrders) return "any number of times";
  return orders == 1 ? "once" : orders == 2 ? "twice" : std::to_string(orders) + " times";
}

std::string describe(const SlabLayer& layer) {
  std::string text = "of optical depth " + plain(layer.opticalDepth);
  for (const std::string& name : layer.populations)
    text.append(&name == &layer.populations[0] ? ": " : ", ").append(name);
  return text;
}

std::string describe(const PhaseSettings& phase) {
  return std::visit(Overloaded{
                        [](const HenyeyGreenstein& own) { return "g " + plain(own.g); },
                        [](const PhaseTable& own) { return std::to_string(own.angles.size()) + " values"; },
                    },
                    phase);
}

std::string describe(const LayerSettings& layer) {
  std::string text = layer.name + ": " + (layer.paths ? "paths " + layer.paths->text : "all paths");
  for (const std::string& name : layer.populations) text += (&name == layer.populations.data() ? " of " : ", ") + name;
  if (layer.tilt) text += "; tilted " + inDegrees(layer.tilt->from) + " to " + inDegrees(layer.tilt->to);
  if (layer.order) text += "; scattered " + describeOrders(*layer.order);
  return text;
}

std::string row(const std::string& title, const std::string& text) {
  constexpr std::size_t kTitleWidth = 12;
  const std::size_t gap = title.size() < kTitleWidth ? kTitleWidth - title.size() : 1;
  return title + std::string(gap, ' ') + text + '\n';
}

}  // namespace

std::string describeScene(const Scene& scene) {
  double sum = 0.0;
  for (const PopulationSettings& p : scene.populations) sum += p.weight;
  for (const HazeSettings& haze : scene.hazes) sum += haze.weight;

  std::string text = row("sun", describe(scene.sun)) + row("ice", describe(scene.ice));
  for (const PopulationSettings& p : scene.populations) {
    const std::string share = formatNumber(100.0 * p.weight / sum) + " % of the surface";
    text += row("population",
                p.name + ": " + share + "; " + describe(p.shape) + describeOptics(p) + "; " + describe(p.orientation));
  }
  for (const HazeSettings& haze : scene.hazes)
    text += row("haze", haze.name + ": " + formatNumber(100.0 * haze.weight / sum) + " % of the surface; " +
                            describe(haze.phase));
  if (scene.cloud)
    text += row("cloud", "optical depth " + plain(scene.cloud->opticalDepth) + ", light scattered " +
                             describeOrders(scene.cloud->orders) +
                             (scene.cloud->altitude ? ", at " + plain(*scene.cloud->altitude) + " m" : ""));
  if (scene.cloud)
    for (const SlabLayer& layer : scene.cloud->layers) text += row("cloud layer", describe(layer));
  for (const LayerSettings& layer : scene.trace.paths.layers) text += row("layer", describe(layer));
  if (scene.sky.air) text += row("air", describe(scene.sky, scene.observer));
  text += row("camera", describe(scene.camera)) + row("trace", describe(scene.trace));
  return text + row("recon", std::string(nameOf(scene.recon)));
}

}  // namespace parhelion
