// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>

#include "beam/ring_integral.h"
#include "picture/auto_exposure.h"
#include "picture/image.h"
#include "render/sweep_frames.h"
#include "trace/trace.h"

namespace parhelion {

/// How a sweep is watched and stopped.
struct SweepControl {
  TraceControl trace;                                              // its time limit is that of the whole sweep
  std::function<void(std::size_t frame, double seconds)> onFrame;  // after each frame that was rendered
  std::uint64_t keptLight = 0;                                     // bytes of it that frames may leave to the next
  RingStore rings;                                                 // which they leave, too
  std::uint64_t keptPictures = 0;                                  // bytes of frames that previews need not read again
};

/// R, G and B of finished frames by their EXRs, of as many as there was room for.
using FramePictures = std::map<std::filesystem::path, Image>;

/// How a sweep went.
struct SweepReport {
  std::size_t rendered = 0;     // frames; those that lacked nothing are not among them
  double worstImbalance = 0.0;  // of any rendered frame's energy, relative
  bool complete = false;        // no frame is left to be rendered
  FramePictures pictures;       // as they were written
};

/// Renders the frames that lack something, one after the other, each as render does. Stops within a frame when it is
/// told to or its time is over: of that frame nothing is written, and planFrames() finds later which are there.
/// Throws std::runtime_error.
SweepReport renderFrames(std::span<const SweepFrame> frames, const SweepControl& control);

struct SweepPreviewSettings {
  LightDisplay display;                     // without an exposure: the median of what the frames would choose
  std::filesystem::path contactSheet;       // empty: none
  const std::atomic<bool>* stop = nullptr;  // looked at between frames
  int threads = 0;                          // 0: one a processor
  const FramePictures* known = nullptr;     // which need not be read
};

/// What was written.
struct SweepPreviews {
  double exposure = 0.0;      // stops, of all of them
  std::size_t badPixels = 0;  // not finite, black in the previews
};

/// Writes the previews of all frames, whose EXRs are there, and their contact sheet, with one exposure. They appear
/// together, those of more than 256 frames 256 by 256, the sheet with the last ones. None if it was stopped. Throws
/// std::runtime_error.
std::optional<SweepPreviews> writePreviews(std::span<const SweepFrame> frames, const SweepPreviewSettings& settings);

}  // namespace parhelion
