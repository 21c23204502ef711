// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kinds (kinds.h) of keys that fill a variant of settings: one key chooses the alternative, as kinds::Choice, and the
// keys after it fill members of what is chosen. A key need not belong to all alternatives:
//
//   bool isOf(const Variant&) const   whether the chosen alternative has this key

#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "math/names.h"
#include "scene/schema_writer.h"
#include "scene/table_reader.h"

namespace parhelion {

namespace kinds {

/// Fills one and the same member of all alternatives that have it. Where the one chosen has none, the value is only
/// checked; rejectKeysOfOthers() complains about the key.
template <class Kind, class T, class... Owners>
class MemberOf {
 public:
  explicit constexpr MemberOf(Kind kind, T Owners::*... members) : kind_(kind), members_(members...) {}

  template <class Variant>
  bool read(const Value& in, Variant& chosen) const {
    T value{};
    if (!kind_.read(in, value)) return false;
    visitMember(chosen, [&](T& member) { member = value; });
    return true;
  }
  Json schema() const { return kind_.schema(); }

  /// The default of the first alternative that has the member.
  template <class Variant>
  Json write(const Variant&) const {
    return std::apply([this](auto first, auto...) { return kind_.write(defaultOf(first)); }, members_);
  }
  template <class Variant>
  bool isOf(const Variant& chosen) const {
    return (std::holds_alternative<Owners>(chosen) || ...);
  }

  /// Calls use(member) with the member of the chosen alternative, if it has it.
  template <class Variant, class Use>
  void visitMember(Variant& chosen, const Use& use) const {
    const auto useOf = [&]<class Owner>(T Owner::*member) {
      if (auto* owner = std::get_if<Owner>(&chosen)) use(owner->*member);
    };
    std::apply([&](auto... members) { (useOf(members), ...); }, members_);
  }
  const Kind& kind() const { return kind_; }

 private:
  template <class Owner>
  static T defaultOf(T Owner::*member) {
    return Owner{}.*member;
  }

  Kind kind_;
  std::tuple<T Owners::*...> members_;
};

/// A value whose default differs from alternative to alternative; the key's documentation says them.
template <class Kind>
struct WithoutDefault {
  Kind kind;

  template <class T>
  bool read(const Value& in, T& out) const {
    return kind.read(in, out);
  }
  Json schema() const { return kind.schema(); }
  template <class T>
  Json write(const T&) const {
    return {};
  }
};

template <class Kind>
WithoutDefault(Kind) -> WithoutDefault<Kind>;

}  // namespace kinds

/// Visits the keys of one table and lists those that not all alternatives have.
class KeysOfChosen {
 public:
  template <class Kind, class T>
  void key(std::string_view name, const Kind& kind, const T& value, std::string_view /*documentation*/) {
    if constexpr (requires { kind.isOf(value); }) (kind.isOf(value) ? own : others).push_back(name);
  }

  std::vector<std::string_view> own, others;
};

/// The keys by which the alternative that the settings of a table hold is told from others.
template <class T>
KeysOfChosen keysOfChosen(T settings) {
  KeysOfChosen keys;
  visitKeys(keys, settings);
  return keys;
}

}  // namespace parhelion
