// SPDX-License-Identifier: Apache-2.0
// OBJ files: read, checked, made into crystals, and written as text that reads as the same.
#include <cmath>
#include <cstdint>
#include <string_view>

#include "crystal/mesh/mesh_from_obj.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace parhelion;
  try {
    const ObjMesh mesh = readObj({reinterpret_cast<const char*>(data), size});
    const std::string text = objText(mesh);
    if (objText(readObj(text)) != text) __builtin_trap();
    const CrystalMesh crystal = meshFromObj(mesh);
    if (!(crystal.volume() > 0.0) || !std::isfinite(crystal.volume())) __builtin_trap();
  } catch (const std::invalid_argument&) {  // ObjError, or faces that enclose nothing
  }
  return 0;
}
