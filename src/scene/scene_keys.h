// SPDX-License-Identifier: Apache-2.0
#pragma once

// Every key of a scene file, said once: its name, the kind of its value, the setting it fills and what it means.
// TableReader visits the keys to read a file, SchemaWriter to write the schema, with the settings' own defaults.
// Those of the camera, which a tally's file has too, are in sky/camera_keys.h; those of tables about a crystal's faces
// in scene/shape_keys.h.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/camera_kinds.h"
#include "scene/distribution_kinds.h"
#include "scene/ice_keys.h"
#include "scene/kinds.h"
#include "scene/member_kinds.h"
#include "scene/shape_keys.h"
#include "scene/table_kinds.h"

namespace parhelion {

/// A spectrum as a table.
struct SpectrumKeys {
  std::vector<double> wavelengths, weights;
  std::optional<double> blackbody = std::nullopt;
};

template <class Visitor>
void visitKeys(Visitor& v, SpectrumKeys& s) {
  v.key("wavelengths", kinds::Wavelengths{}, s.wavelengths, "Spectral lines, nm.");
  v.key("weights", kinds::Weights{}, s.weights, "Energies of the lines, in any unit; all alike when left out.");
  v.key("blackbody", kinds::Optional{kinds::Number{{500, 1e6}, "K"}}, s.blackbody,
        "Temperature of a black body, kelvin; instead of lines.");
}

/// The [sun] as its keys say it; sun_kind.cpp makes SunSettings of it.
struct SunKeys {
  SunSettings sun;
  std::optional<DateTime> date = std::nullopt;
  std::optional<double> latitude = std::nullopt, longitude = std::nullopt;  // rad
  std::optional<bool> refraction = std::nullopt;
};

template <class Visitor>
void visitKeys(Visitor& v, SunKeys& keys) {
  SunSettings& sun = keys.sun;
  v.key("elevation", kinds::Angle{{-90, 90}}, sun.elevation, "Elevation of the sun above the horizon, degrees.");
  v.key("azimuth", kinds::Optional{kinds::Angle{{-360, 360}}}, sun.azimuth,
        "Azimuth of the sun from north, degrees, east 90. Only cameras whose azimuth_from is \"north\" ask for it.");
  v.key("date", kinds::Optional{kinds::Date{}}, keys.date,
        "Date and time with the offset from UTC, such as 2026-12-21T09:30:00+01:00; with latitude and longitude in "
        "the place of elevation and azimuth.");
  v.key("latitude", kinds::Optional{kinds::Angle{{-90, 90}}}, keys.latitude,
        "Latitude of the observer, degrees, north positive.");
  v.key("longitude", kinds::Optional{kinds::Angle{{-180, 180}}}, keys.longitude,
        "Longitude of the observer, degrees, east positive.");
  v.key("refraction", kinds::Optional{kinds::Flag{}}, keys.refraction,
        "Whether the sun of a date stands where the air's refraction shows it; true when left out.");
  v.key("diameter", kinds::Angle{{0, 10}}, sun.diameter, "Diameter of the sun's disc, degrees; 0 is a point sun.");
  v.key("spectrum", kinds::Spectrum{}, sun.spectrum,
        "Sunlight: \"sun\" (extraterrestrial), \"sun-am1.5\" (through 1.5 atmospheres), \"equal\" energy, an "
        "illuminant of "
        "the CIE (\"A\", \"D50\", \"D55\", \"D65\", \"D75\", \"E\"), one wavelength in nm (luminance only), a list of "
        "wavelengths of equal energy, { wavelengths = [...], weights = [...] }, or { blackbody = 3000 } kelvin.");
  v.key("visible", kinds::Flag{}, sun.visible, "Draw the undeviated light, with its disc, into the image.");
}

template <class Visitor>
void visitKeys(Visitor& v, AerosolSettings& a) {
  v.key("beta", kinds::Number{{0, 10}}, a.beta,
        "Vertical optical depth at 1000 nm. Clean air 0.02 to 0.05, haze 0.2 and more.");
  v.key("alpha", kinds::Number{{-1, 4}}, a.alpha, "The depth falls with this power of the wavelength.");
  v.key("albedo", kinds::AerosolAlbedo{}, a.albedo, "Share of the light it takes from a beam that it scatters.");
  v.key("g", kinds::Number{{-0.95, 0.95}}, a.g, "Mean cosine of the angle by which it scatters.");
  v.key("height", kinds::Number{{100, 20000}, "m"}, a.height, "Height in which its density falls to 1/e, m.");
}

/// The ground as a table.
struct GroundKeys {
  double albedo = SkySettings{}.ground;
};

template <class Visitor>
void visitKeys(Visitor& v, GroundKeys& ground) {
  v.key("albedo", kinds::Number{{0, 1}}, ground.albedo, "Share of light that the ground reflects.");
}

template <class Visitor>
void visitKeys(Visitor& v, SkySettings& sky) {
  v.key("air", kinds::Flag{}, sky.air,
        "Show the sky behind the halo, and the ground, by the light of the air: pictures are in absolute units then.");
  v.key("ozone", kinds::Number{{0, 1000}, "Dobson units"}, sky.ozone, "Column of ozone, Dobson units.");
  v.key("aerosol", kinds::Aerosol{}, sky.aerosol,
        "Fine particles in the air: a table, or a number, which is its 'beta'.");
  v.key("ground", kinds::Ground{}, sky.ground,
        "The ground below the horizon: \"snow\" (albedo 0.8), \"grass\" (0.1), \"sea\" (0.06), or { albedo = 0.15 }, "
        "which is the default.");
}

template <class Visitor>
void visitKeys(Visitor& v, ObserverSettings& observer) {
  v.key("altitude", kinds::Number{{0, 50000}, "m"}, observer.altitude,
        "Of the observer, in the air, m above sea level.");
}

/// A [[population]] as its keys say it; population_kind.cpp makes PopulationSettings of it.
struct PopulationKeys {
  std::optional<std::string> name = std::nullopt;
  double weight = PopulationSettings{}.weight;
  PopulationShape shape = PrismSettings{};
  std::optional<PhaseTable> phase = std::nullopt;  // of haze
  OrientationWords orientation = OrientationName::random;
  std::optional<AngleDistribution> tilt = std::nullopt;  // about 0
  std::optional<AngleDistribution> roll = std::nullopt;  // about 0
  std::optional<LengthDistribution> size = std::nullopt;
  double distortion = PopulationSettings{}.distortion;
  bool diffraction = PopulationSettings{}.diffracts;
};

template <class Visitor>
void visitKeys(Visitor& v, PopulationKeys& p) {
  v.key("name", kinds::Optional{kinds::Text{}}, p.name, "Name, unique; \"population 1\" and so on when left out.");
  v.key("weight", kinds::Number{{0, 1e9}}, p.weight,
        "Share of all crystal surface in the cloud; the shares need not add up to 1.");
  v.key("shape", kinds::Choice<PopulationShape>{}, p.shape,
        "\"prism\": hexagonal prism, a plate or a column by its aspect; \"pyramid\": with pyramids on its ends; "
        "\"planes\": any convex crystal, by the planes of its faces; \"mesh\": a closed mesh from an OBJ file; "
        "\"rosette\": hexagonal bullets that meet in a centre; "
        "\"haze\": irregular crystals, which scatter by a phase function.");
  v.key("aspect", kinds::Aspect{}, p.shape,
        "Length along the c axis over the distance between opposite vertices of the hexagon (of a pyramid or a bullet: "
        "of its prism part); or { normal = [mean, sigma] }, { uniform = [from, to] }, { laplace = [mean, scale] }, "
        "{ lognormal = [median, sigma] }.");
  v.key(
      "sides", kinds::SideDistances{}, p.shape,
      "Prisms and pyramids: distances of faces 3 to 8 from the c axis, over those of a regular crystal: six numbers or "
      "distributions; one distribution, of which each side is drawn; or { threefold = ... }, { twofold = ... }, "
      "{ sixfold = ... }, where every second, every third or every side is drawn as one. What the faces leave is the "
      "crystal; faces too far out are none.");
  v.key("upper", kinds::PyramidEnd{true}, p.shape,
        "Pyramids: height of the upper one as a share of its full height, a number or a distribution, or a table with "
        "its slope, too.");
  v.key("lower", kinds::PyramidEnd{false}, p.shape, "Pyramids: the same of the lower one.");
  v.key("slope", kinds::PyramidSlope{}, p.shape,
        "Pyramids: angle between their faces and the c axis, degrees, where an end has none of its own; a number or a "
        "distribution. Rosettes: the same of each bullet's pyramid, a number.");
  v.key("planes", kinds::MemberOf(kinds::PlaneList{}, &PlanesSettings::planes), p.shape,
        "Any convex crystal: the planes of its faces.");
  v.key("cavity", kinds::cavityTable(true, true), p.shape,
        "Prisms with a fixed aspect and regular sides: a hexagonal pit in both ends, { depth = 0.4, width = 0.8 }.");
  v.key("upper_cavity", kinds::cavityTable(true, false), p.shape, "The same of the upper end alone.");
  v.key("lower_cavity", kinds::cavityTable(false, true), p.shape, "The same of the lower end alone.");
  v.key("cap", kinds::capTable(true, true), p.shape,
        "Prisms with a fixed aspect and regular sides: a plate on both ends, { width = 3, aspect = 0.1 }.");
  v.key("upper_cap", kinds::capTable(true, false), p.shape, "The same of the upper end alone.");
  v.key("lower_cap", kinds::capTable(false, true), p.shape, "The same of the lower end alone.");
  v.key("notch", kinds::NotchTable{}, p.shape,
        "Prisms with a fixed aspect and regular sides: a notch in the middle of each side, as in sector plates, "
        "{ depth = 0.6, width = 0.4 }.");
  v.key("bullets", kinds::MemberOf(kinds::WholeNumber{1, RosetteSettings::kMostBullets}, &RosetteSettings::bullets),
        p.shape, "Rosettes: how many bullets meet in the centre, as far from each other as they can.");
  v.key("overlap", kinds::MemberOf(kinds::Number{{0, 1}}, &RosetteSettings::overlap), p.shape,
        "Rosettes: how far each bullet reaches beyond the centre, as a share of the height of its pyramid. At 0 they "
        "touch there in a point, which no light goes through.");
  v.key("mesh", kinds::Mesh{}, p.shape,
        "Meshes: an OBJ file beside the scene, of closed surfaces of any polygons; z is along the c axis. Polygons in "
        "one plane are one face, whose number may be the name of its group.");
  v.key("g", kinds::MemberOf(kinds::Optional{kinds::Number{{-1, 1, true, true}}}, &HazeWords::g), p.shape,
        "Haze: mean cosine of the angle of scattering, of Henyey and Greenstein's phase function; 0.75 when left out.");
  v.key("phase", kinds::Optional{kinds::Phase{}}, p.phase,
        "Haze: its phase function instead, as a list of [angle, value]: angles grow from 0 to 180 degrees, values are "
        "in any unit. Or the name of a .csv file beside the scene, whose lines are angle,value.");
  v.key(
      "orientation", kinds::Orientation{}, p.orientation,
      "\"random\", \"plate\" (c axis vertical), \"column\" (horizontal), \"parry\" (horizontal, two prism faces too), "
      "\"lowitz\" (an axis through opposite prism edges horizontal), or zenith angle and azimuth of the c axis and "
      "roll about it.");
  v.key(
      "tilt", kinds::Optional{kinds::Spread{}}, p.tilt,
      "Spread of the axis about its rest, degrees: a number is the sigma of a normal density per solid angle. An axis "
      "that is tilted past a pole comes down on the other side. Exactly at rest when left out.");
  v.key(
      "roll", kinds::Optional{kinds::Spread{}}, p.roll,
      "Spread of the rotation about the c axis (lowitz: about its horizontal axis), degrees. Left out: none for parry, "
      "free for the others.");
  v.key("size", kinds::Optional{kinds::Length{{kSmallestCrystal, kLargestCrystal}, "µm"}}, p.size,
        "The largest distance between two corners of a crystal, micrometres: a number or a distribution. For "
        "'absorption' of [ice] and for 'diffraction'.");
  v.key("distortion", kinds::Angle{{0, 30}}, p.distortion,
        "Spread by which faces are tilted at each encounter, degrees (Macke, Mueller & Raschke 1996).");
  v.key("diffraction", kinds::Flag{}, p.diffraction,
        "Spread light that leaves by a face as Fraunhofer's pattern of the face does; needs 'size'.");
}

/// An orientation in full.
struct AxisKeys {
  std::optional<AngleDistribution> zenith;
  AngleDistribution azimuth = AxisOrientation{}.azimuth;
  AngleDistribution roll = AxisOrientation{}.roll;
};

template <class Visitor>
void visitKeys(Visitor& v, AxisKeys& axis) {
  v.key(
      "zenith", kinds::Optional{kinds::AngleValue{kinds::AngleValue::Of::zenith}}, axis.zenith,
      "Zenith angle of the c axis, degrees. Of a distribution, what lies beyond 0 or 180 comes down on the other side "
      "of the pole, at an azimuth 180 degrees further: { uniform = [-5, 10] }.");
  v.key("azimuth", kinds::AngleValue{kinds::AngleValue::Of::turn}, axis.azimuth,
        "Azimuth of the c axis from the sun, degrees.");
  v.key("roll", kinds::AngleValue{kinds::AngleValue::Of::turn}, axis.roll, "Rotation about the c axis, degrees.");
}

template <class Visitor>
void visitKeys(Visitor& v, TraceSettings& trace) {
  v.key("rays", kinds::RayCount{}, trace.rays, "Incident rays, all wavelengths together: 100000, \"10M\", \"1.5k\".");
  v.key("seed", kinds::Seed{}, trace.seed,
        "Seed of the random numbers; the same seed gives the same image, bit by bit.");
  v.key("engine", kinds::Choice<Engine>{}, trace.engine, "What finds the next face of a crystal.");
  v.key("path", kinds::Choice<PathMode>{}, trace.path,
        "At a face: deposit what leaves and follow the rest (\"split\"), or follow one branch picked by chance.");
  v.key("sampler", kinds::Choice<Sampler>{}, trace.sampler,
        "Where the numbers come from that rays are drawn from: independent ones, or scrambled Sobol' points.");
  v.key("symmetry", kinds::Choice<Symmetry>{}, trace.symmetry,
        "Symmetry of the sky to make use of: rays count as their mirror images, too (\"mirror\"), or for whole rings "
        "about the sun (\"radial\"); \"auto\" takes the most that the populations allow.");
  v.key("allocation", kinds::Choice<Allocation>{}, trace.allocation,
        "How the rays of a picture are shared out among populations: as their light is (\"light\"), or more to those "
        "that "
        "make more noise, as a pilot run finds it (\"auto\"). The light is the same.");
  v.key("filter", kinds::Optional{kinds::Paths{}}, trace.paths.filter,
        "Keeps only light of such raypaths: a pattern such as \"3-5\", or the name of a halo.");
}

/// The most orders that a number asks for; more are "all".
inline constexpr int kMostOrders = 1'000'000;

/// A [[layer]] as its keys say it.
struct LayerKeys {
  std::optional<std::string> name = std::nullopt;
  std::optional<PathPattern> paths = std::nullopt;
  std::vector<std::string> populations = {};
  std::optional<LayerSettings::TiltRange> tilt = std::nullopt;
  std::optional<int> order = std::nullopt;
};

template <class Visitor>
void visitKeys(Visitor& v, LayerKeys& layer) {
  v.key("name", kinds::Optional{kinds::Text{}}, layer.name,
        "Name, unique: the picture has channels NAME.R, NAME.G, "
        "NAME.B.");
  v.key("paths", kinds::Optional{kinds::Paths{}}, layer.paths,
        "Raypaths of the layer: a pattern such as \"1-3\", or the name of a halo. All when left out.");
  v.key("populations", kinds::Names{}, layer.populations, "Populations of the layer by name. All when left out.");
  v.key("tilt", kinds::Optional{kinds::Tilts{}}, layer.tilt,
        "Range of the crystals' own tilt from their rest, degrees; the end is not in it.");
  v.key("order", kinds::Optional{kinds::WholeNumber{1, kMostOrders}}, layer.order,
        "How often the light was scattered in the [cloud]. Any number of times when left out.");
}

/// How layers are said in short.
enum class LayersBy { populations };

constexpr std::string_view nameOf(LayersBy value) {
  switch (value) {
    case LayersBy::populations:
      return "populations";
  }
  return {};
}

template <class Visitor>
void visitKeys(Visitor& v, ReconSettings& r) {
  constexpr Range kPixels{0, 1e4, true};
  v.key(
      "method", kinds::Choice<ReconSettings>{}, r,
      "How scattered hits become an image: \"adaptive\" filters, \"none\" (the plain radiance), or one of the methods "
      "of the literature; the other keys are settings of those.");
  v.key("sigma", kinds::MemberOf(kinds::Optional{kinds::Number{kPixels, "pixels"}}, &GaussianSettings::sigma), r,
        "gaussian: standard deviation of the filter, pixels. Left out: by the number of hits.");
  v.key("scales", kinds::MemberOf(kinds::WithoutDefault{kinds::WholeNumber{1, 12}}, &GlassnerSettings::scales), r,
        "glassner: how many Gaussians of standard deviation 1, 2, 4, ... pixels are averaged; 6 when left out.");
  v.key("period",
        kinds::MemberOf(kinds::Optional{kinds::Number{kPixels, "pixels"}}, &MarvastiSettings::period,
                        &VoronoiSettings::period, &ActSettings::period),
        r, "marvasti, voronoi, act: Ts, pixels; frequencies up to 1/(2 Ts) pass. Left out: by the number of hits.");
  v.key("reading",
        kinds::MemberOf(kinds::WithoutDefault{kinds::Choice<HitReading>{}}, &VoronoiSettings::reading,
                        &ActSettings::reading),
        r,
        "voronoi, act: whether hits are values of the picture (\"intensities\") or count by the area around them "
        "(\"densities\", when left out).");
  v.key("samples", kinds::MemberOf(kinds::Optional{kinds::Number{{0, 1e12, true}}}, &GonzatoMarchandSettings::samples),
        r, "gonzato-marchand: m, hits that a square grows to hold. Left out: by the number of hits.");
  v.key("lobes", kinds::MemberOf(kinds::WithoutDefault{kinds::Number{{1, 16}}}, &GonzatoMarchandSettings::lobes), r,
        "gonzato-marchand: k, zeros of the sinc inside a kernel; 1 when left out, above which kernels ring.");
  v.key("gain", kinds::MemberOf(kinds::WithoutDefault{kinds::Choice<KernelGain>{}}, &GonzatoMarchandSettings::gain), r,
        "gonzato-marchand: kernels that add up to 1 (\"unit\", when left out) or are used as published (\"paper\").");
  v.key("flow", kinds::MemberOf(kinds::WithoutDefault{kinds::Choice<KernelFlow>{}}, &GonzatoMarchandSettings::flow), r,
        "gonzato-marchand: kernels sized where light comes from (\"scatter\", when left out) or goes to (\"gather\").");
  v.key("iterations",
        kinds::MemberOf(kinds::WithoutDefault{kinds::WholeNumber{0, 1000}}, &MarvastiSettings::iterations,
                        &VoronoiSettings::iterations, &ActSettings::iterations, &GonzatoMarchandSettings::iterations),
        r,
        "marvasti, voronoi, act, gonzato-marchand: corrections after the first filter; 3 for act and 0 for the others "
        "when left out. They end early where the residual grows.");
  v.key("relaxation",
        kinds::MemberOf(kinds::WithoutDefault{kinds::Number{{0, 1000, true}}}, &MarvastiSettings::relaxation), r,
        "marvasti: factor of the first picture and of each correction; 1 when left out.");
}

/// [[cloud.layer]] as its keys say it.
struct SlabLayerKeys {
  std::vector<std::string> populations;
  std::optional<double> opticalDepth = std::nullopt;
};

template <class Visitor>
void visitKeys(Visitor& v, SlabLayerKeys& layer) {
  v.key("populations", kinds::Names{}, layer.populations, "What it is made of: names of populations.");
  v.key("optical_depth", kinds::Optional{kinds::Number{{0, 1e4, true}}}, layer.opticalDepth,
        "Vertical depth of the layer by the shadows of its crystals.");
}

/// [cloud] as its keys say it.
struct SlabKeys {
  std::optional<double> opticalDepth = std::nullopt;
  int orders = 1;
  std::vector<SlabLayer> layers;
  std::optional<double> altitude = std::nullopt;
};

template <class Visitor>
void visitKeys(Visitor& v, SlabKeys& slab) {
  v.key("optical_depth", kinds::Optional{kinds::Number{{0, 1e4, true}}}, slab.opticalDepth,
        "Vertical depth of the cloud by the shadows of its crystals. Pictures are in cd/m2 then.");
  v.key("orders", kinds::Orders{}, slab.orders,
        "How often light may be scattered: 1, 2 and so on, or \"all\" until it has left the cloud.");
  v.key("layer", kinds::SlabLayers{}, slab.layers,
        "Layers from top to bottom, each with its own populations and depth, in the place of one depth for all.");
  v.key("altitude", kinds::Optional{kinds::Number{{0, 50000}, "m"}}, slab.altitude,
        "Of the cloud, where there is air, m above sea level. Left out: crystals float around the observer.");
}

template <class Visitor>
void visitKeys(Visitor& v, Scene& scene) {
  v.key("sun", kinds::SunTable{}, scene.sun, "The source of light.");
  v.key("ice", kinds::Table<IceSettings>{"[ice]"}, scene.ice, "What the crystals are made of.");
  v.key("population", kinds::Populations{}, scene, "The crystals: at least one population.");
  v.key(
      "cloud", kinds::Slab{}, scene.cloud,
      "The cloud that the crystals are in. Left out: single crystals, whose light is in units of what they intercept.");
  std::optional<LayersBy> layersBy;  // made into layers by addLayerPerPopulation()
  v.key("layers", kinds::Optional{kinds::Choice<LayersBy>{}}, layersBy,
        "\"populations\": a layer for each population, in the place of [[layer]].");
  v.key("layer", kinds::Layers{}, scene.trace.paths.layers,
        "Light to be told apart: each exit goes to the first layer that takes it, what none takes to the rest.");
  v.key("camera", kinds::CameraTable{}, scene.camera, "Where the image looks.");
  v.key("sky", kinds::Table<SkySettings>{"[sky]"}, scene.sky, "The air and the ground behind the halo.");
  v.key("observer", kinds::Table<ObserverSettings>{"[observer]"}, scene.observer, "Where the picture is taken.");
  v.key("trace", kinds::Table<TraceSettings>{"[trace]"}, scene.trace, "How light is followed.");
  v.key("recon", kinds::Recon{}, scene.recon, "How the image is made of the hits.");
}

}  // namespace parhelion
