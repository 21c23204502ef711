// SPDX-License-Identifier: Apache-2.0
#include "picture/picture_text.h"

#include <utility>

#include "picture/exr.h"
#include "picture/file_kind.h"
#include "picture/jpeg.h"
#include "picture/png_read.h"
#include "picture/stored_picture.h"

namespace parhelion {

std::map<std::string, std::string> readPictureText(const std::filesystem::path& path) {
  switch (kindOf(startOfFile(path)).family) {
    case FileKind::Family::exr:
      return readExrAttributes(path);
    case FileKind::Family::png:
      return readPngText(path);
    case FileKind::Family::jpeg:
      if (std::string comments = readJpegComments(path); !comments.empty()) return {{"comment", std::move(comments)}};
      return {};
    default:
      throw pictureError(path, "not a JPEG, PNG or EXR file");
  }
}

}  // namespace parhelion
