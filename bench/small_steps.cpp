// SPDX-License-Identifier: Apache-2.0
// What the inner parts of tracing cost, each alone: nanoseconds a call. scripts/bench runs it.
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "csv.h"
#include "math/tabulated_density.h"
#include "optics/interface.h"
#include "random_stream.h"
#include "rays_finders.h"
#include "rays_queries.h"
#include "sky/camera.h"
#include "sky/deposit_buffer.h"
#include "trace/ray_source.h"

namespace parhelion::bench {
namespace {

constexpr double kAspect = 2.0;
constexpr int kInputs = 1 << 12;  // of each step, in turn; a power of two
constexpr int kSide = 1024;       // pixels, of pictures

/// Numbers in (0, 1).
std::vector<double> uniformNumbers() {
  std::vector<double> numbers(kInputs);
  RandomStream random(1, 0, RandomPurpose::path);
  for (double& u : numbers) u = random.next();
  return numbers;
}

/// Directions all over the sphere.
std::vector<Vec3> directions() {
  std::vector<Vec3> all(kInputs);
  RandomStream random(2, 0, RandomPurpose::path);
  for (Vec3& v : all) {
    const double z = 2.0 * random.next() - 1.0, azimuth = 2.0 * kPi * random.next(), r = std::sqrt(1.0 - z * z);
    v = {r * std::cos(azimuth), r * std::sin(azimuth), z};
  }
  return all;
}

void philoxBlock(benchmark::State& state) {
  PhiloxBlock<std::uint64_t> counter{};
  for (auto _ : state) {
    ++counter.a;
    benchmark::DoNotOptimize(philox(counter, 1));
  }
}

void incidentRay(benchmark::State& state) {
  const Cloud cloud = randomPrisms(kAspect);
  RaySource source(cloud, {}, 256);
  std::uint64_t index = 0;
  for (auto _ : state) benchmark::DoNotOptimize(source.ray(index++));
}

void nextFace(benchmark::State& state, const FinderKind& kind) {
  const Cloud cloud = randomPrisms(kAspect);
  const Crystal crystal = onlyCrystal(cloud);
  const std::vector<InteriorRay> rays = interiorRays(cloud, kInputs);
  withFinder(makeFinder(kind, cloud), [&](const auto& finder) {
    std::size_t i = 0;
    for (auto _ : state) {
      const InteriorRay& ray = rays[i++ % kInputs];
      benchmark::DoNotOptimize(finder.nextFace(crystal, ray.point, ray.lightDir, ray.leftFace));
    }
  });
}

void fresnelInside(benchmark::State& state) {
  const std::vector<double> cosines = uniformNumbers();
  const RelativeIndex outOfIce(1.0 / 1.31);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(fresnel(cosines[i++ % kInputs], outOfIce));
}

void pixelAt(benchmark::State& state, Projection projection) {
  CameraSettings settings;
  settings.projection = projection;
  if (projection == Projection::rectilinear) settings.fieldOfView = radians(90.0);
  settings.width = settings.height = kSide;
  const Camera camera(settings);
  const std::vector<Vec3> sky = directions();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(camera.pixelAt(sky[i++ % kInputs]));
}

void tabulatedSample(benchmark::State& state) {
  const TabulatedDensity density([](double x) { return std::exp(-0.5 * x * x); }, -4.0, 4.0, 1024);
  const std::vector<double> numbers = uniformNumbers();
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(density.sample(numbers[i++ % kInputs]));
}

void depositBuffer(benchmark::State& state) {
  TallyInfo info;
  info.camera.width = info.camera.height = kSide;
  Tally tally(info, 1);
  DepositBuffer buffer(tally, std::make_shared<DepositBuffer::Locks>());
  const Camera camera(info.camera);
  std::vector<int> pixels;
  for (const Vec3& toSky : directions())
    pixels.push_back(camera.pixelAt({toSky.x, toSky.y, std::abs(toSky.z)}).value_or(0));
  std::size_t i = 0;
  for (auto _ : state) {
    buffer.add(pixels[i % kInputs], toFixedLight(Vec3(0.0, 1.0, 0.0), tally.perWhite()), i);
    ++i;
  }
  buffer.flush();
}

void registerAll() {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("Philox block", philoxBlock);
  RegisterBenchmark("Cloud::incidentRay", incidentRay);
  for (const FinderKind& kind : finderKinds())
    RegisterBenchmark(("nextFace/" + kind.id).c_str(), [&kind](benchmark::State& state) { nextFace(state, kind); });
  RegisterBenchmark("fresnel", fresnelInside);
  for (const Projection projection :
       {Projection::rectilinear, Projection::fisheyeEqualArea, Projection::fisheyeEquidistant,
        Projection::fisheyeStereographic, Projection::fisheyeOrthographic, Projection::equirectangular})
    RegisterBenchmark(("Camera::pixelAt/" + std::string(nameOf(projection))).c_str(),
                      [projection](benchmark::State& state) { pixelAt(state, projection); });
  RegisterBenchmark("TabulatedDensity::sample", tabulatedSample);
  RegisterBenchmark("DepositBuffer::add", depositBuffer);
}

}  // namespace
}  // namespace parhelion::bench

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::AddCustomContext("machine", parhelion::bench::machine());
  benchmark::AddCustomContext("seed", "1");
  benchmark::AddCustomContext("inputs", "aspect 2 in random orientation; pictures of 1024 x 1024 pixels");
  parhelion::bench::registerAll();
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
