// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every key of a scene file, said once: its name, the kind of its value, the setting it fills and what it means.
// TableReader visits the keys to read a file, SchemaWriter to write the schema, with the settings' own defaults.
// Those of the camera, which a tally's file has too, are in sky/camera_keys.h.

#include <optional>
#include <string>
#include <variant>

#include "scene/camera_kinds.h"
#include "scene/distribution_kinds.h"
#include "scene/kinds.h"
#include "scene/table_kinds.h"

namespace parhelion {

template <class Visitor>
void visitKeys(Visitor& v, SunSettings& sun) {
  v.key("elevation", Angle{{-90, 90}}, sun.elevation, "Elevation of the sun above the horizon, degrees.");
  v.key("diameter", Angle{{0, 10}}, sun.diameter, "Diameter of the sun's disc, degrees; 0 is a point sun.");
  v.key(
      "spectrum", Spectrum{}, sun.spectrum,
      "Sunlight: \"sun\" (extraterrestrial), \"sun-am1.5\" (through 1.5 atmospheres), \"equal\" energy, one wavelength "
      "in nm (luminance only), or a list of wavelengths of equal energy.");
  v.key("visible", Flag{}, sun.visible, "Draw the undeviated light, with its disc, into the image.");
}

template <class Visitor>
void visitKeys(Visitor& v, IceSettings& ice) {
  v.key(
      "index", IceIndex{}, ice,
      "Refractive index of ice: \"warren-brandt\" (table of 2008) or a number, the same at every wavelength; of a list "
      "of numbers rays take each in turn.");
}

/// A [[population]] as its keys say it; population_kind.cpp makes PopulationSettings of it.
struct PopulationKeys {
  std::optional<std::string> name;
  double weight = PopulationSettings{}.weight;
  ShapeName shape = ShapeName::prism;
  AspectDistribution aspect = PrismSettings{}.aspect;
  PyramidSettings pyramid;  // all but its aspect
  OrientationWords orientation = OrientationName::random;
  std::optional<AngleDistribution> tilt;  // about 0
  std::optional<AngleDistribution> roll;  // about 0
};

template <class Visitor>
void visitKeys(Visitor& v, PopulationKeys& p) {
  v.key("name", Optional{Text{}}, p.name, "Name, unique; \"population 1\" and so on when left out.");
  v.key("weight", Number{{0, 1e9}}, p.weight,
        "Share of all crystal surface in the cloud; the shares need not add up to 1.");
  v.key("shape", Choice<ShapeName>{}, p.shape,
        "\"prism\": hexagonal prism, a plate or a column by its aspect; \"pyramid\": with pyramids on its ends.");
  v.key(
      "aspect", Aspect{p.shape}, p.aspect,
      "Length along the c axis over the distance between opposite vertices of the hexagon (of a pyramid: of its prism "
      "part); prisms also { normal = [mean, sigma] } or { uniform = [from, to] }.");
  v.key("upper", Number{{0, 1}}, p.pyramid.upper, "Pyramids: height of the upper one as a share of its full height.");
  v.key("lower", Number{{0, 1}}, p.pyramid.lower, "Pyramids: height of the lower one as a share of its full height.");
  v.key("slope", Angle{{0, 90, true, true}}, p.pyramid.slope,
        "Pyramids: angle between their faces and the c axis, degrees.");
  v.key(
      "orientation", Orientation{}, p.orientation,
      "\"random\", \"plate\" (c axis vertical), \"column\" (horizontal), \"parry\" (horizontal, two prism faces too), "
      "\"lowitz\" (an axis through opposite prism edges horizontal), or zenith angle and azimuth of the c axis and "
      "roll about it.");
  v.key(
      "tilt", Optional{Spread{}}, p.tilt,
      "Spread of the axis about its rest, degrees: a number is the sigma of a normal density per solid angle. Exactly "
      "at rest when left out.");
  v.key(
      "roll", Optional{Spread{}}, p.roll,
      "Spread of the rotation about the c axis (lowitz: about its horizontal axis), degrees. Left out: none for parry, "
      "free for the others.");
}

/// An orientation in full.
struct AxisKeys {
  std::optional<AngleDistribution> zenith;
  AngleDistribution azimuth = AxisOrientation{}.azimuth;
  AngleDistribution roll = AxisOrientation{}.roll;
};

template <class Visitor>
void visitKeys(Visitor& v, AxisKeys& axis) {
  v.key("zenith", Optional{AngleValue{AngleValue::Of::zenith}}, axis.zenith, "Zenith angle of the c axis, degrees.");
  v.key("azimuth", AngleValue{AngleValue::Of::turn}, axis.azimuth, "Azimuth of the c axis from the sun, degrees.");
  v.key("roll", AngleValue{AngleValue::Of::turn}, axis.roll, "Rotation about the c axis, degrees.");
}

template <class Visitor>
void visitKeys(Visitor& v, TraceSettings& trace) {
  v.key("rays", RayCount{}, trace.rays, "Incident rays, all wavelengths together: 100000, \"10M\", \"1.5k\".");
  v.key("seed", Seed{}, trace.seed, "Seed of the random numbers; the same seed gives the same image, bit by bit.");
  v.key("engine", Choice<Engine>{}, trace.engine, "What finds the next face of a crystal.");
  v.key("path", Choice<PathMode>{}, trace.path,
        "At a face: deposit what leaves and follow the rest (\"split\"), or follow one branch picked by chance.");
  v.key("sampler", Choice<Sampler>{}, trace.sampler,
        "Where the numbers come from that rays are drawn from: independent ones, or scrambled Sobol' points.");
  v.key("symmetry", Choice<Symmetry>{}, trace.symmetry,
        "Symmetry of the sky to make use of: rays count as their mirror images, too (\"mirror\"), or for whole rings "
        "about the sun (\"radial\"); \"auto\" takes the most that the populations allow.");
}

/// [recon] as its keys say it; recon_kind.cpp makes ReconSettings of it.
struct ReconKeys {
  ReconMethod method = ReconMethod::adaptive;
  std::optional<double> sigma, period, relaxation, samples, lobes;
  std::optional<int> scales, iterations;
  std::optional<HitReading> reading;
  std::optional<KernelGain> gain;
  std::optional<KernelFlow> flow;
};

template <class Visitor>
void visitKeys(Visitor& v, ReconKeys& r) {
  constexpr Range kPixels{0, 1e4, true};
  v.key(
      "method", Choice<ReconMethod>{}, r.method,
      "How scattered hits become an image: \"adaptive\" filters, \"none\" (the plain radiance), or one of the methods "
      "of the literature; the other keys are settings of those.");
  v.key("sigma", Optional{Number{kPixels}}, r.sigma,
        "gaussian: standard deviation of the filter, pixels. Left out: by the number of hits.");
  v.key("scales", Optional{WholeNumber{1, 12}}, r.scales,
        "glassner: how many Gaussians of standard deviation 1, 2, 4, ... pixels are averaged; 6 when left out.");
  v.key("period", Optional{Number{kPixels}}, r.period,
        "marvasti, voronoi, act: Ts, pixels; frequencies up to 1/(2 Ts) pass. Left out: by the number of hits.");
  v.key("reading", Optional{Choice<HitReading>{}}, r.reading,
        "voronoi, act: whether hits are values of the picture (\"intensities\") or count by the area around them "
        "(\"densities\", when left out).");
  v.key("samples", Optional{Number{{0, 1e12, true}}}, r.samples,
        "gonzato-marchand: m, hits that a square grows to hold. Left out: by the number of hits.");
  v.key("lobes", Optional{Number{{1, 16}}}, r.lobes,
        "gonzato-marchand: k, zeros of the sinc inside a kernel; 1 when left out, above which steps ring.");
  v.key("gain", Optional{Choice<KernelGain>{}}, r.gain,
        "gonzato-marchand: steps that add up to 1 (\"unit\", when left out) or are used as published (\"paper\").");
  v.key("flow", Optional{Choice<KernelFlow>{}}, r.flow,
        "gonzato-marchand: steps sized where light comes from (\"scatter\", when left out) or goes to (\"gather\").");
  v.key("iterations", Optional{WholeNumber{0, 1000}}, r.iterations,
        "marvasti, voronoi, act, gonzato-marchand: corrections after the first filter; 3 for act and 0 for the others "
        "when left out. They end early where the residual grows.");
  v.key("relaxation", Optional{Number{{0, 1000, true}}}, r.relaxation,
        "marvasti: factor of the first picture and of each correction; 1 when left out.");
}

template <class Visitor>
void visitKeys(Visitor& v, Scene& scene) {
  v.key("sun", Table<SunSettings>{"[sun]"}, scene.sun, "The source of light.");
  v.key("ice", Table<IceSettings>{"[ice]"}, scene.ice, "What the crystals are made of.");
  v.key("population", Populations{}, scene.populations, "The crystals: at least one population.");
  v.key("camera", CameraTable{}, scene.camera, "Where the image looks.");
  v.key("trace", Table<TraceSettings>{"[trace]"}, scene.trace, "How light is followed.");
  v.key("recon", Recon{}, scene.recon, "How the image is made of the hits.");
}

}  // namespace parhelion
