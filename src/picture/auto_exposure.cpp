// SPDX-License-Identifier: Apache-2.0
#include "picture/auto_exposure.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <glm/geometric.hpp>

#include "math/portable.h"
#include "picture/colour_space.h"

namespace parhelion {
namespace {

constexpr double kTargetStops = -3.0;       // of exposed light, for the luminance that is looked for
constexpr double kSceneryStops = -1.5;      // likewise, where there is light all over
constexpr double kShareOfChange = 0.75;     // in pixels darker than it
constexpr double kShareOfBrightest = 0.01;  // of the lit pixels, whose differences do not count

/// Marks pixels without light. Less than the stops of any float.
constexpr float kDark = -1000.0F;

/// log2 of every pixel's luminance; kDark where it has no light or is not finite.
std::vector<float> stopsOf(const Image& image) {
  const auto [red, green, blue] = image.rgb();
  std::vector<float> stops(image.pixels(), kDark);
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const double y = glm::dot(kRec709Luminance, Vec3{(*red)[i], (*green)[i], (*blue)[i]});
    if (std::isfinite(y) && y > 0.0) stops[i] = static_cast<float>(portable::log(y) / std::numbers::ln2);
  }
  return stops;
}

/// Weights of pixels by their stops, in steps of 1/64. They make quantiles without sorting.
class StopsHistogram {
 public:
  void add(float stops, double weight) {
    const double step = std::floor((static_cast<double>(stops) - kLeast) * kStepsPerStop);
    weights_[static_cast<std::size_t>(std::clamp(step, 0.0, kSteps - 1.0))] += weight;
    total_ += weight;
  }

  bool isEmpty() const { return total_ <= 0.0; }

  /// The stops below which this share of the weight lies.
  double below(double share) const {
    double sum = 0.0;
    std::size_t step = 0;
    while (step + 1 < weights_.size() && sum + weights_[step] < share * total_) sum += weights_[step++];
    return kLeast + (static_cast<double>(step) + 0.5) / kStepsPerStop;
  }

 private:
  static constexpr double kLeast = -152.0, kMost = 130.0;  // what floats can be, with a colour's weights
  static constexpr double kStepsPerStop = 64.0;
  static constexpr double kSteps = (kMost - kLeast) * kStepsPerStop;

  std::vector<double> weights_ = std::vector<double>(static_cast<std::size_t>(kSteps));
  double total_ = 0.0;
};

/// The lit pixels, each with the weight that `weightOf(index)` gives it.
template <class F>
StopsHistogram histogram(const std::vector<float>& stops, const F& weightOf) {
  StopsHistogram result;
  for (std::size_t i = 0; i < stops.size(); ++i)
    if (stops[i] > kDark) result.add(stops[i], weightOf(i));
  return result;
}

/// Cube roots of luminances, of which none counts as brighter than 2^most.
std::vector<double> lightnessOf(const std::vector<float>& stops, double most) {
  std::vector<double> lightness(stops.size());
  for (std::size_t i = 0; i < stops.size(); ++i)
    if (stops[i] > kDark)
      lightness[i] = portable::exp(std::numbers::ln2 / 3.0 * (std::min(static_cast<double>(stops[i]), most) - most));
  return lightness;
}

}  // namespace

double exposureOfScenery(const Image& image) {
  const StopsHistogram lit = histogram(stopsOf(image), [](std::size_t) { return 1.0; });
  return lit.isEmpty() ? 0.0 : kSceneryStops - lit.below(0.5);
}

double autoExposure(const Image& image) {
  const std::vector<float> stops = stopsOf(image);
  const StopsHistogram lit = histogram(stops, [](std::size_t) { return 1.0; });
  if (lit.isEmpty()) return 0.0;

  const std::vector<double> lightness = lightnessOf(stops, lit.below(1.0 - kShareOfBrightest));
  const auto width = static_cast<std::size_t>(image.width);
  const StopsHistogram changes = histogram(stops, [&](std::size_t i) {
    const auto changeTo = [&](std::size_t other) {
      return stops[other] > kDark ? lightness[other] - lightness[i] : 0.0;
    };
    const double right = (i + 1) % width != 0 ? changeTo(i + 1) : 0.0;
    const double lower = i + width < stops.size() ? changeTo(i + width) : 0.0;
    return std::sqrt(right * right + lower * lower);
  });
  return kTargetStops - (changes.isEmpty() ? lit : changes).below(kShareOfChange);
}

ToneSettings toneFor(const LightDisplay& how, const Image& image, std::optional<double> whiteLuminance) {
  if (!how.exposureValue) return {how.exposure ? *how.exposure : autoExposure(image), how.curve};
  if (!whiteLuminance) throw std::invalid_argument("no exposure value without the luminance of white");
  return {exposureFor(*how.exposureValue, *whiteLuminance, how.curve), how.curve};
}

}  // namespace parhelion
