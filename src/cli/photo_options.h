// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "photo/photo_camera.h"

namespace parhelion::cli {

/// "96 x 64 pixels", for messages.
std::string sizeText(int width, int height);

/// Whether a picture shows, larger or smaller, what a camera does: its sides have the same ratio to within a pixel.
bool hasShapeOf(const Photograph& photograph, const CameraSettings& camera);

/// What a user says on the command line about a photograph's camera: its lens, and where it pointed.
struct PhotoOptions {
  std::string projection;
  std::optional<double> fovHorizontal, fovVertical, fovDiagonal;  // degrees
  std::optional<double> focal35mm, imageCircle;                   // mm; degrees
  std::string distortion, shift, sun;
  std::vector<std::string> horizon, known;
  std::optional<double> sunElevation, azimuth, elevation, roll;  // degrees
  bool assumeSrgb = false, edited = false;

  void addTo(CLI::App& command);

  /// How to read a photograph of whose pixels each takes so many bytes of work.
  PhotographRules rules(int bytesForUse) const { return {assumeSrgb, bytesForUse, edited}; }

  /// Whether anything was said of the lens or of where it pointed.
  bool given() const;

  /// The camera of a photograph: by these options, with the lens from its Exif where they do not say, or, where they
  /// say nothing at all, by the scene that the picture carries. `sceneSunElevation` (rad) is what to take for the sun
  /// where neither an option nor the horizon tells. `path` is for messages. Throws CLI::ValidationError that names the
  /// options to give where something is missing or cannot be.
  PhotoCamera camera(const Photograph& photograph, const std::string& path,
                     std::optional<double> sceneSunElevation) const;

 private:
  LensClues lensClues(const std::string& path) const;
  PhotoLens lens(const Photograph& photograph, const std::string& path) const;
  PointingClues pointingClues(std::optional<double> sceneSunElevation) const;
  std::string withNames(std::string message) const;
  PhotoCamera point(const CameraSettings& lens, const std::string& path, std::optional<double> sceneSunElevation) const;
  PhotoCamera pointByAngles(const CameraSettings& lens, const std::string& path,
                            std::optional<double> elevationOfSun) const;
  PhotoCamera pointByClues(const CameraSettings& lens, const std::string& path,
                           std::optional<double> sceneSunElevation) const;
};

}  // namespace parhelion::cli
