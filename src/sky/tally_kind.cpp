// SPDX-License-Identifier: Apache-2.0
#include "sky/tally_kind.h"

#include <optional>
#include <string>

#include "math/names.h"
#include "picture/exr_stream.h"
#include "sky/attribute_text.h"
#include "sky/sums_exr.h"

namespace parhelion {

TallyKind tallyKindOf(const AttributeReader& attributes) {
  const auto kind = attributes.has("kind") ? memberNamed<TallyKind>(attributes.text("kind")) : std::nullopt;
  if (!kind) attributes.reject("kind", "sky, map or profile");
  return *kind;
}

void requireTallyKind(const std::filesystem::path& path, const SumsExr& file, TallyKind kind) {
  const TallyKind found = tallyKindOf(AttributeReader(file.attributes()));
  if (found != kind)
    throw exrError(path, "is the tally of a " + std::string(nameOf(found)) + ", not of a " + std::string(nameOf(kind)));
}

TallyKind tallyKindOf(const std::filesystem::path& path) {
  const SumsExr file(path);
  return withExrErrors(path, [&] { return tallyKindOf(AttributeReader(file.attributes())); });
}

}  // namespace parhelion
