// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <initializer_list>
#include <string>

#include "scene/scene_keys.h"

namespace parhelion {

namespace {

/// The keys that a method has of its own.
std::vector<std::string_view> keysOf(ReconMethod method) {
  switch (method) {
    case ReconMethod::adaptive:
    case ReconMethod::none:
      return {};
    case ReconMethod::gaussian:
      return {"sigma"};
    case ReconMethod::glassner:
      return {"scales"};
    case ReconMethod::marvasti:
      return {"period", "iterations", "relaxation"};
    case ReconMethod::voronoi:
    case ReconMethod::act:
      return {"period", "reading", "iterations"};
    case ReconMethod::gonzatoMarchand:
      return {"samples", "lobes", "gain", "flow", "iterations"};
  }
  return {};
}

constexpr ReconMethod kMethods[] = {ReconMethod::gaussian, ReconMethod::glassner, ReconMethod::marvasti,
                                    ReconMethod::voronoi,  ReconMethod::act,      ReconMethod::gonzatoMarchand};

void rejectKeysOfOthers(TableReader& reader, ReconMethod chosen) {
  const std::vector<std::string_view> own = keysOf(chosen);
  std::vector<std::string_view> complained;
  for (const ReconMethod method : kMethods) {
    for (const std::string_view key : keysOf(method)) {
      const auto has = [key](const auto& keys) { return std::find(keys.begin(), keys.end(), key) != keys.end(); };
      if (!reader.has(key) || has(own) || has(complained)) continue;
      complained.push_back(key);
      std::string list;
      for (const std::string_view name : own) list += (list.empty() ? "" : ", ") + std::string(name);
      reader.reject(key, std::string("the method \"").append(nameOf(chosen)) + "\" has no '" + std::string(key) + "'",
                    list.empty() ? "it has no settings" : "its settings: " + list);
    }
  }
}

template <class T>
void set(T& setting, const std::optional<T>& given) {
  if (given) setting = *given;
}

ReconSettings settingsOf(const ReconKeys& keys) {
  switch (keys.method) {
    case ReconMethod::adaptive:
      return AdaptiveSettings{};
    case ReconMethod::none:
      return NoSettings{};
    case ReconMethod::gaussian:
      return GaussianSettings{keys.sigma};
    case ReconMethod::glassner: {
      GlassnerSettings glassner;
      set(glassner.scales, keys.scales);
      return glassner;
    }
    case ReconMethod::marvasti: {
      MarvastiSettings marvasti{.period = keys.period};
      set(marvasti.iterations, keys.iterations);
      set(marvasti.relaxation, keys.relaxation);
      return marvasti;
    }
    case ReconMethod::voronoi: {
      VoronoiSettings voronoi{.period = keys.period};
      set(voronoi.reading, keys.reading);
      set(voronoi.iterations, keys.iterations);
      return voronoi;
    }
    case ReconMethod::act: {
      ActSettings act{.period = keys.period};
      set(act.reading, keys.reading);
      set(act.iterations, keys.iterations);
      return act;
    }
    case ReconMethod::gonzatoMarchand: {
      GonzatoMarchandSettings paper{.samples = keys.samples};
      set(paper.lobes, keys.lobes);
      set(paper.gain, keys.gain);
      set(paper.flow, keys.flow);
      set(paper.iterations, keys.iterations);
      return paper;
    }
  }
  return {};
}

}  // namespace

bool Recon::read(const Value& in, ReconSettings& out) const {
  const toml::table* table = in.node.as_table();
  if (!table) return in.mustBe("a table");
  TableReader reader(*table, "[recon]", in.complaints);
  ReconKeys keys;
  visitKeys(reader, keys);
  reader.rejectUnknown();
  if (reader.rejected("method")) return false;  // which keys it may have depends on it
  rejectKeysOfOthers(reader, keys.method);
  if (keys.method == ReconMethod::act && keys.iterations == 0)
    reader.reject("iterations", "the method \"act\" needs at least 1 iteration: it starts from an even grey");
  out = settingsOf(keys);
  return true;
}

Json Recon::schema() const { return tableSchema<ReconKeys>(); }

}  // namespace parhelion
