// SPDX-License-Identifier: Apache-2.0
#pragma once

// The words for the members of a family, for scene files, options, statistics and summaries. A family is an enumeration
// or a variant of settings. Its words are said once, beside it:
//
//   constexpr std::string_view nameOf(Enumeration)   an exhaustive switch that ends with `return {};`
//   static constexpr std::string_view kName          in each alternative of a variant
//
// All lists of words follow from these.

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace parhelion {

/// The word for the alternative that `settings` holds.
template <class... Settings>
constexpr std::string_view nameOf(const std::variant<Settings...>& settings) {
  return std::visit([](const auto& own) -> std::string_view { return own.kName; }, settings);
}

/// All members of a family, in its order.
template <class Enumeration>
struct Family {
  static_assert(std::is_enum_v<Enumeration>);

  /// Enumerators count 0, 1, 2, ..., and what is none has no name.
  static consteval std::size_t size() {
    std::size_t count = 0;
    while (!nameOf(static_cast<Enumeration>(count)).empty()) ++count;
    return count;
  }
  static constexpr Enumeration member(std::size_t index) { return static_cast<Enumeration>(index); }
  static constexpr std::string_view name(std::size_t index) { return nameOf(member(index)); }
};

template <class... Settings>
struct Family<std::variant<Settings...>> {
  static consteval std::size_t size() { return sizeof...(Settings); }

  /// With the defaults of its settings.
  static std::variant<Settings...> member(std::size_t index) {
    using Make = std::variant<Settings...> (*)();
    constexpr Make kMakers[] = {[]() -> std::variant<Settings...> { return Settings{}; }...};
    return kMakers[index]();
  }
  static constexpr std::string_view name(std::size_t index) {
    constexpr std::string_view kNames[] = {Settings::kName...};
    return kNames[index];
  }
};

/// The names of a family in its order, checked: none is empty, no two are alike.
template <class F>
consteval auto checkedNames() {
  std::array<std::string_view, Family<F>::size()> names;
  static_assert(names.size() > 0, "the first enumerator has no name");
  for (std::size_t i = 0; i < names.size(); ++i) {
    names[i] = Family<F>::name(i);
    if (names[i].empty() || std::find(names.begin(), names.begin() + i, names[i]) != names.begin() + i)
      throw "a name is empty or taken";  // which no constant expression can do: it does not compile
  }
  return names;
}

template <class F>
inline constexpr auto kNamesOf = checkedNames<F>();

/// All enumerators, in their order.
template <class Enumeration>
inline constexpr auto kMembersOf = [] {
  std::array<Enumeration, Family<Enumeration>::size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = Family<Enumeration>::member(i);
  return all;
}();

template <class F>
std::vector<std::string_view> acceptedNames() {
  return {kNamesOf<F>.begin(), kNamesOf<F>.end()};
}

/// The member of this name, with the defaults of its settings, if there is one.
template <class F>
std::optional<F> memberNamed(std::string_view name) {
  for (std::size_t i = 0; i < kNamesOf<F>.size(); ++i) {
    if (kNamesOf<F>[i] == name) return Family<F>::member(i);
  }
  return std::nullopt;
}

/// The same for a name that is known to be one. Throws std::bad_optional_access where it is not.
template <class F>
F valueOf(std::string_view name) {
  return memberNamed<F>(name).value();
}

}  // namespace parhelion
