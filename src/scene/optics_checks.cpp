// SPDX-License-Identifier: Apache-2.0
#include "scene/optics_checks.h"

#include "optics/ice.h"
#include "scene/value.h"

namespace parhelion {

namespace {

void checkSize(const toml::table& population, const Scene& scene, bool saysAbsorption, Complaints& complaints) {
  const toml::node* size = population.get("size");
  const toml::node* diffraction = population.get("diffraction");
  const auto complain = [&](const toml::node& node, const char* message, const char* hint) {
    complaints.add(placeOf(node.source(), complaints), message, hint);
  };
  if (size && !saysAbsorption && !diffraction)
    complain(*size, "'size' changes nothing without 'diffraction', or 'absorption' of [ice]",
             "say diffraction = true, or diffraction = false to keep it for later");
  if (size) return;
  if (diffraction && diffraction->value_exact<bool>() == true)
    complain(*diffraction, "'diffraction' needs the 'size' of the crystals", "in micrometres: size = 30");
  if (scene.ice.absorbs)
    complain(population, "'absorption' of [ice] needs the 'size' of these crystals", "in micrometres: size = 300");
}

}  // namespace

void checkOptics(const toml::table& root, const Scene& scene, Complaints& complaints) {
  const toml::node* absorption = root["ice"]["absorption"].node();
  if (absorption && scene.ice.absorbs && !knowsAbsorption(scene.ice))
    complaints.add(placeOf(absorption->source(), complaints), "how much this material absorbs is not known",
                   "say it by a table with a column k, or as a number: absorption = 1e-6");
  const toml::array* populations = root["population"].as_array();
  for (std::size_t i = 0; populations && i < populations->size(); ++i) {
    const toml::table* one = (*populations)[i].as_table();
    const toml::node* shape = one ? one->get("shape") : nullptr;
    const bool isHaze = shape && shape->value_exact<std::string>() == "haze";
    if (one && !isHaze) checkSize(*one, scene, absorption != nullptr, complaints);
  }
}

}  // namespace parhelion
