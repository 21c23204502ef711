// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "picture/auto_exposure.h"
#include "picture/gamut.h"
#include "picture/image.h"
#include "picture/tone.h"
#include "picture/transaction.h"
#include "recon/reconstruct.h"
#include "render/more_orders.h"
#include "render/traced_sky.h"

namespace parhelion {

/// A traced sky, reconstructed as its scene says. `threads` 0: one a processor.
ReconstructedSky developSky(const TracedSky& traced, const LoadedScene& loaded, int threads);

/// What more goes into a picture.
struct SkyAdditions {
  LayerGains gains;  // of light that is scattered more than once, as the picture's
  int threads = 0;   // for the air's light and that of further orders; 0: one a processor
  WalkWatch watch = {};
};

/// Of a scene with a cloud or air turns the image of a tally with that info into cd/m^2, with air adds what is behind
/// it (air_background.h), draws the sun into it if the scene makes it visible, and writes it as linear EXR with the
/// scene inside, its colours as `gamut` says; other than exact ones are noted under kGamutKey. Light that the cloud
/// scatters more than once, where the scene asks for it, is traced here (more_orders.h); returns how that went. Throws
/// std::runtime_error.
std::optional<OrderReport> writeSky(const Output& exr, Image& image, const TallyInfo& info, const LoadedScene& loaded,
                                    Gamut gamut = Gamut::exact, const SkyAdditions& additions = {});

/// The exposure (stops) that the preview of a finished picture gets where none is asked for.
double ownExposure(const Image& image, const Scene& scene);

/// How its preview is developed: with that exposure where `how` asks for none. Throws as toneFor() does.
ToneSettings previewTone(LightDisplay how, const Image& image, const Scene& scene);

/// Whether pictures of a scene are in cd/m^2.
bool isAbsolute(const Scene& scene);

/// Why no sunlight reaches the crystals of a scene whose pictures are in cd/m^2, for people; "" where it does.
std::string whyUnlit(const Scene& scene);

/// An exposure as people and PNG texts read it: "+1.50 stops".
std::string exposureText(double stops);

/// Writes a preview developed at that exposure, which is among the PNG's texts, and so is the scene that it shows, as
/// TOML; a sheet of several pictures has none. Throws std::runtime_error.
void writePreview(const Output& png, const Preview& preview, double stops, const std::string& scene);

/// Where the two files of a sky go.
struct SkyFiles {
  std::filesystem::path exr, png;
  LightDisplay display;        // of the preview
  Gamut gamut = Gamut::exact;  // of the EXR
  Transaction* run = nullptr;  // with whose other files they appear; none: each by itself
  int threads = 0;             // for the air's light and that of further orders; 0: one a processor
  LayerGains gains = {};       // of layers, as the picture's
  WalkWatch watch = {};
};

/// What was written.
struct WrittenSky {
  double exposure;                    // of the preview, stops
  std::size_t badPixels;              // not finite in the sky, black in the preview
  std::optional<OrderReport> orders;  // of a cloud whose light is scattered more than once
  std::string unlit;                  // whyUnlit()
};

/// Writes a sky reconstructed from a tally with that info as writeSky() does, and its preview. Throws
/// std::runtime_error.
WrittenSky writeSkyFiles(const SkyFiles& files, Image image, const TallyInfo& info, const LoadedScene& loaded);

}  // namespace parhelion
