// SPDX-License-Identifier: Apache-2.0
// Rings of light as bytes, for the cache of tables.
#include <cstring>
#include <memory>
#include <type_traits>

#include "render/table_cache.h"

namespace parhelion {

namespace {

/// Writes numbers one after the other.
class Numbers {
 public:
  template <class T>
  void add(const T& number) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  }
  template <class T, std::size_t N>
  void add(const std::array<T, N>& numbers) {
    for (const T& one : numbers) add(one);
  }
  template <class T>
  void add(const std::vector<T>& numbers) {
    add(numbers.size());
    for (const T& one : numbers) add(one);
  }
  void add(const PrismShare& prism) {
    add(prism.length);
    add(prism.share);
  }
  void add(const LightSegments::Segment& segment) {
    add(segment.from);
    add(segment.to);
    add(segment.share);
    add(segment.at);
    add(segment.xyz);
  }
  void add(const SheetTotals& totals) {
    add(totals.intercepted);
    add(totals.undeviated);
    add(totals.cutOff);
  }
  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

std::string keyOf(const RingStore::Kind& kind) {
  Numbers key;
  key.add(kind.prisms);
  key.add(kind.indices);
  key.add(kind.lights.indices);
  key.add(kind.lights.segments);
  key.add(kind.error);
  key.add(kind.cutShare);
  key.add(kind.rings);
  return "rings\n" + key.take();
}

std::string tableOf(const RingIntegral& rings) {
  Numbers table;
  table.add(rings.totals);
  table.add(rings.reached);
  for (std::size_t k = 0; k < rings.light.size(); ++k) {
    table.add(rings.light[k]);
    table.add(rings.error[k]);
  }
  return table.take();
}

std::optional<RingIntegral> ringsIn(const std::string& table, int count) {
  RingIntegral rings;
  const auto each = sizeof(Tristimulus) + sizeof(double), head = 3 * sizeof(double) + sizeof(bool);
  if (table.size() != head + static_cast<std::size_t>(count) * each) return std::nullopt;
  const char* from = table.data();
  const auto read = [&](auto& number) {
    std::memcpy(&number, from, sizeof number);
    from += sizeof number;
  };
  read(rings.totals.intercepted);
  read(rings.totals.undeviated);
  read(rings.totals.cutOff);
  read(rings.reached);
  for (int k = 0; k < count; ++k) {
    read(rings.light.emplace_back());
    read(rings.error.emplace_back());
  }
  return rings;
}

}  // namespace

RingStore ringStoreWith(std::optional<TableCache> cache) {
  if (!cache) return {};
  const auto shared = std::make_shared<const TableCache>(std::move(*cache));
  return RingStore({[shared](const RingStore::Kind& kind) -> std::optional<RingIntegral> {
                      const std::optional<std::string> table = shared->find(keyOf(kind));
                      return table ? ringsIn(*table, kind.rings) : std::nullopt;
                    },
                    [shared](const RingStore::Kind& kind, const RingIntegral& rings) {
                      shared->keep(keyOf(kind), tableOf(rings));
                    }});
}

}  // namespace parhelion
