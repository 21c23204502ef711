// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <variant>

#include "math/names.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const AxisOrientation& axisOf(const PopulationSettings& p) { return std::get<AxisOrientation>(p.orientation); }

bool isFree(const AngleDistribution& d) {
  const auto* range = std::get_if<UniformRange>(&d);
  return range && range->from == 0.0 && range->to == 2.0 * kPi;
}

double fixedValue(const AngleDistribution& d) { return std::get<FixedValue>(d).value; }

}  // namespace

TEST_CASE("the documented scene gives the settings it describes") {
  const Scene scene = sceneOf(kExample);
  CHECK(scene.sun.elevation == radians(20.0));
  CHECK(scene.sun.diameter == radians(0.533));
  CHECK(std::get<ContinuousSpectrum>(scene.sun.spectrum).source == ContinuousSpectrum::Source::extraterrestrial);
  CHECK_FALSE(scene.sun.visible);
  CHECK(std::holds_alternative<PublishedIndex>(scene.ice.index));
  CHECK(scene.camera.projection == Projection::fisheyeEqualArea);
  CHECK(scene.camera.elevation == radians(90.0));
  CHECK(scene.camera.fieldOfView == radians(180.0));
  CHECK(scene.camera.imageCircle == 0.0);
  CHECK(scene.trace.rays == 10'000'000);
  CHECK(std::holds_alternative<AdaptiveSettings>(scene.recon));

  REQUIRE(scene.populations.size() == 2);
  const PopulationSettings& plates = scene.populations[0];
  CHECK(plates.name == "plates");
  CHECK(plates.weight == 0.6);
  CHECK(std::get<FixedValue>(std::get<PrismSettings>(plates.shape).aspect).value == 0.1);
  CHECK(std::get<Normal>(axisOf(plates).zenith).mean == 0.0);
  CHECK(std::get<Normal>(axisOf(plates).zenith).sigma == radians(1.0));
  CHECK(isFree(axisOf(plates).roll));
  const AxisOrientation& inFull = axisOf(scene.populations[1]);
  CHECK(fixedValue(inFull.zenith) == radians(90.0));
  CHECK(isFree(inFull.azimuth));
  CHECK(std::get<Normal>(inFull.roll).sigma == radians(5.0));
}

TEST_CASE("a range of zenith angles may begin and end beyond a pole") {
  const auto zenith = [](const std::string& range) {
    return std::get<UniformRange>(
        axisOf(populationWith("orientation = { zenith = { uniform = " + range + " } }")).zenith);
  };
  CHECK(zenith("[-5, 10]").from == radians(-5.0));
  CHECK(zenith("[-5, 10]").to == radians(10.0));
  CHECK(zenith("[170, 185]").to == radians(185.0));
}

TEST_CASE("what a scene leaves out has the defaults of the settings") {
  const Scene scene = sceneOf(kPopulation);
  CHECK(scene.sun.elevation == SunSettings{}.elevation);
  CHECK(scene.camera.fieldOfView == CameraSettings{}.fieldOfView);
  CHECK(scene.camera.elevation == CameraSettings{}.elevation);
  CHECK(scene.camera.width == CameraSettings{}.width);
  CHECK(scene.trace.rays == TraceSettings{}.rays);
  CHECK(scene.populations.at(0).name == "population 1");
  CHECK(scene.populations[0].weight == 1.0);
  CHECK(std::holds_alternative<RandomOrientation>(scene.populations[0].orientation));
}

TEST_CASE("the spectrum is a name, a wavelength or a list of wavelengths, integers or not") {
  CHECK(std::get<ContinuousSpectrum>(sceneWith("sun.spectrum = 'sun-am1.5'").sun.spectrum).source ==
        ContinuousSpectrum::Source::airMass1_5);
  CHECK(std::get<MonochromaticSpectrum>(sceneWith("sun.spectrum = 550").sun.spectrum).wavelength == 550.0);
  CHECK(std::get<ContinuousSpectrum>(sceneWith("sun.spectrum = 'D65'").sun.spectrum).source ==
        ContinuousSpectrum::Source::d65);
  CHECK(std::get<BlackBody>(sceneWith("sun.spectrum = { blackbody = 3000 }").sun.spectrum).temperature == 3000.0);
  const auto weighted = std::get<LineSpectrum>(
      sceneWith("sun.spectrum = { wavelengths = [450, 550.5], weights = [1, 2.5] }").sun.spectrum);
  CHECK(weighted.wavelengths == std::vector<double>{450.0, 550.5});
  CHECK(weighted.weights == std::vector<double>{1.0, 2.5});
  CHECK(std::get<LineSpectrum>(sceneWith("sun.spectrum = { wavelengths = [450] }").sun.spectrum).weights.empty());
  const Scene lines = sceneWith("sun.spectrum = [450, 550.5]");
  CHECK(std::get<LineSpectrum>(lines.sun.spectrum).wavelengths == std::vector<double>{450.0, 550.5});
}

TEST_CASE("a constant index of ice is a number above 1") {
  CHECK(std::get<ConstantIndex>(sceneWith("ice.index = 1.31").ice.index).index == 1.31);
  CHECK(std::get<ConstantIndex>(sceneWith("ice.index = 3").ice.index).index == 3.0);
}

TEST_CASE("a column's tilt is about the horizontal, its roll free unless given") {
  const auto column = axisOf(populationWith("orientation = 'column'\ntilt = { uniform = 2 }"));
  CHECK(std::get<UniformRange>(column.zenith).from == doctest::Approx(radians(88.0)));
  CHECK(std::get<UniformRange>(column.zenith).to == doctest::Approx(radians(92.0)));
  CHECK(isFree(column.roll));
  const auto rolled = axisOf(populationWith("orientation = 'column'\nroll = { uniform = 3 }"));
  CHECK(fixedValue(rolled.zenith) == 0.5 * kPi);
  CHECK(std::get<UniformRange>(rolled.roll).from == radians(-3.0));
  CHECK(std::get<UniformRange>(rolled.roll).to == radians(3.0));
}

TEST_CASE("a plate's uniform tilt is one-sided, its other tilts are about the zenith") {
  const auto uniform = axisOf(populationWith("orientation = 'plate'\ntilt = { uniform = 2 }"));
  CHECK(std::get<UniformRange>(uniform.zenith).from == 0.0);
  CHECK(std::get<UniformRange>(uniform.zenith).to == radians(2.0));
  const auto arcsine = axisOf(populationWith("orientation = 'plate'\ntilt = { arcsine = 5 }"));
  CHECK(std::get<Arcsine>(arcsine.zenith).amplitude == radians(5.0));
  const auto polar = axisOf(populationWith("orientation = 'plate'\ntilt = { polar-normal = 1 }"));
  CHECK(std::get<PolarNormal>(polar.zenith).sigma == radians(1.0));
  const auto laplace = axisOf(populationWith("orientation = 'plate'\ntilt = { laplace = 1 }"));
  CHECK(std::get<Laplace>(laplace.zenith).scale == radians(1.0));
}

TEST_CASE("a tilt of 0 or none leaves the axis exactly at rest") {
  CHECK(fixedValue(axisOf(populationWith("orientation = 'plate'")).zenith) == 0.0);
  CHECK(fixedValue(axisOf(populationWith("orientation = 'plate'\ntilt = 0")).zenith) == 0.0);
  CHECK(fixedValue(axisOf(populationWith("orientation = 'column'\ntilt = { laplace = 0.0 }")).zenith) == 0.5 * kPi);
}

TEST_CASE("a Parry column's roll is 0 unless given, and polar-normal rolls are normal") {
  CHECK(fixedValue(axisOf(populationWith("orientation = 'parry'\ntilt = 1")).roll) == 0.0);
  const auto spread = axisOf(populationWith("orientation = 'parry'\nroll = { polar-normal = 0.5 }"));
  CHECK(std::get<Normal>(spread.roll).sigma == radians(0.5));
  CHECK(isFree(spread.azimuth));
}

TEST_CASE("a Lowitz orientation tilts an axis about the horizontal and spins freely unless told") {
  const auto free = std::get<LowitzOrientation>(populationWith("orientation = 'lowitz'\ntilt = 1").orientation);
  CHECK(std::get<Normal>(free.axisZenith).mean == 0.5 * kPi);
  CHECK(isFree(free.spin));
  const auto spun = std::get<LowitzOrientation>(populationWith("orientation = 'lowitz'\nroll = 40").orientation);
  CHECK(fixedValue(spun.axisZenith) == 0.5 * kPi);
  CHECK(std::get<Normal>(spun.spin).sigma == radians(40.0));
}

TEST_CASE("pyramids have shares of the full height and a slope") {
  const auto keys = "shape = 'pyramid'\naspect = 0\nupper = 1\nlower = 0.25\nslope = 30";
  const auto pyramid = std::get<PyramidSettings>(populationWith(keys).shape);
  CHECK(pyramid.aspect == 0.0);
  CHECK(pyramid.upper == 1.0);
  CHECK(pyramid.lower == 0.25);
  CHECK(pyramid.slope == radians(30.0));
  CHECK(std::get<PyramidSettings>(populationWith("shape = 'pyramid'").shape).aspect == PyramidSettings{}.aspect);
}

TEST_CASE("prisms take distributions of the aspect") {
  const auto normal = std::get<PrismSettings>(populationWith("aspect = { normal = [0.1, 0.02] }").shape).aspect;
  CHECK(std::get<Normal>(normal).mean == 0.1);
  CHECK(std::get<Normal>(normal).sigma == 0.02);
  const auto uniform = std::get<PrismSettings>(populationWith("aspect = { uniform = [0.5, 2] }").shape).aspect;
  CHECK(std::get<UniformRange>(uniform).to == 2.0);
  const auto fixed = std::get<PrismSettings>(populationWith("aspect = { uniform = [2, 2] }").shape).aspect;
  CHECK(std::get<FixedValue>(fixed).value == 2.0);
}

TEST_CASE("a camera's defaults follow its projection") {
  const auto flat = sceneWith("camera.projection = 'rectilinear'").camera;
  CHECK(flat.fieldOfView == radians(60.0));
  CHECK(flat.elevation == 0.0);
  CHECK(flat.width == 1024);
  const auto map = sceneWith("camera.projection = 'equirectangular'").camera;
  CHECK(map.fieldOfView == radians(360.0));
  CHECK(map.elevation == 0.0);
  CHECK(map.width == 2048);
  CHECK(map.height == 1024);
  const auto fisheye = sceneWith("camera.projection = 'fisheye-orthographic'").camera;
  CHECK(fisheye.fieldOfView == radians(180.0));
  CHECK(fisheye.elevation == radians(90.0));
}

TEST_CASE("the field of view is along the axis its key names") {
  const auto camera = sceneWith("[camera]\nfov_diagonal = 190\nimage_circle = 200\nresolution = [640, 480]").camera;
  CHECK(camera.fieldOfViewAxis == FieldOfViewAxis::diagonal);
  CHECK(camera.fieldOfView == radians(190.0));
  CHECK(camera.imageCircle == radians(200.0));
  CHECK(camera.width == 640);
  CHECK(camera.height == 480);
}

TEST_CASE("a byte order mark and Windows line ends change nothing") {
  std::string text;
  for (const char c : kExample) text += c == '\n' ? "\r\n" : std::string(1, c);
  const Scene scene = sceneOf("\xEF\xBB\xBF" + text);
  CHECK(scene.populations.size() == 2);
  CHECK(std::holds_alternative<AdaptiveSettings>(scene.recon));
  const auto errors = errorsOf("\xEF\xBB\xBF[sun]\r\nelevation = 91\r\n[[population]]\r\n");
  CHECK(linesOf(errors) ==
        std::vector<std::string>{"2:13 'elevation' must be a number from -90 to 90 degrees, not 91"});
  CHECK(errors.at(0).excerpt.find('\r') == std::string::npos);
}

TEST_CASE("each method of reconstruction has its own settings") {
  const auto recon = [](const std::string& keys) { return sceneWith("[recon]\n" + keys).recon; };
  CHECK(std::get<GaussianSettings>(recon("method = 'gaussian'\nsigma = 2.5")).sigma == 2.5);
  CHECK_FALSE(std::get<GaussianSettings>(recon("method = 'gaussian'")).sigma);
  CHECK(std::get<GlassnerSettings>(recon("method = 'glassner'\nscales = 3")).scales == 3);
  const auto marvasti =
      std::get<MarvastiSettings>(recon("method = 'marvasti'\nperiod = 4\niterations = 7\nrelaxation = 0.5"));
  CHECK(marvasti.period == 4.0);
  CHECK(marvasti.iterations == 7);
  CHECK(marvasti.relaxation == 0.5);
  const auto voronoi = std::get<VoronoiSettings>(recon("method = 'voronoi'\nreading = 'intensities'\niterations = 2"));
  CHECK(voronoi.reading == HitReading::intensities);
  CHECK(voronoi.iterations == 2);
  CHECK(std::get<ActSettings>(recon("method = 'act'\nperiod = 3.0")).period == 3.0);
  const auto paper = std::get<GonzatoMarchandSettings>(
      recon("method = 'gonzato-marchand'\nsamples = 16\nlobes = 2\ngain = 'paper'\nflow = 'gather'\niterations = 1"));
  CHECK(paper.samples == 16.0);
  CHECK(paper.lobes == 2.0);
  CHECK(paper.gain == KernelGain::paper);
  CHECK(paper.flow == KernelFlow::gather);
  CHECK(paper.iterations == 1);
  CHECK(std::holds_alternative<NoSettings>(recon("method = 'none'")));
}

TEST_CASE("a setting of another method is an error that says what the method has") {
  const auto errors =
      errorsOf(std::string(kPopulation) + "[recon]\nmethod = 'gaussian'\nsamples = 16\niterations = 2\n");
  REQUIRE(errors.size() == 2);
  CHECK(errors[0].message == "the method \"gaussian\" has no 'samples'");
  CHECK(errors[0].hint == "its settings: sigma");
  CHECK(errors[1].message == "the method \"gaussian\" has no 'iterations'");
  CHECK(errorsOf(std::string(kPopulation) + "[recon]\nsigma = 2\n").at(0).hint == "it has no settings");
}

TEST_CASE("ice may be a mixture of indices") {
  CHECK(std::get<IndexMixture>(sceneWith("ice.index = [1.30, 1.31, 1.32]").ice.index).indices ==
        std::vector<double>{1.30, 1.31, 1.32});
  CHECK(errorsOf(std::string(kPopulation) + "[ice]\nindex = [1.31, 0.9]\n").size() == 1);
  CHECK(errorsOf(std::string(kPopulation) + "[ice]\nindex = []\n").size() == 1);
}

TEST_CASE("a cloud has a depth, and light that is scattered once") {
  const auto cloudOf = [](const std::string& keys) { return sceneOf("[[population]]\n[cloud]\n" + keys + "\n").cloud; };
  CHECK_FALSE(sceneOf("[[population]]\n").cloud);
  CHECK(cloudOf("optical_depth = 0.5")->opticalDepth == 0.5);
  CHECK(cloudOf("optical_depth = 2\norders = 1")->opticalDepth == 2.0);
  CHECK(cloudOf("optical_depth = 2\norders = 7")->orders == 7);
  CHECK_FALSE(cloudOf("optical_depth = 2")->altitude);
  CHECK(cloudOf("optical_depth = 2\norders = \"all\"")->orders == SlabSettings::kAllOrders);
  CHECK(errorsOf("[[population]]\n[cloud]\noptical_depth = 1\norders = 0").at(0).message ==
        "'orders' must be a whole number from 1 to 1000000 or \"all\", not 0");
  for (const char* wrong : {"optical_depth = -1", "optical_depth = 0", "orders = 1", "optical_depth = 1\norders = 1.5"})
    CHECK_THROWS_AS(cloudOf(wrong), SceneError);
}
