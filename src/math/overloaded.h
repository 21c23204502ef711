// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// Lambdas joined into one visitor for std::visit, one for each alternative.
template <class... Fs>
struct Overloaded : Fs... {
  using Fs::operator()...;
};
template <class... Fs>
Overloaded(Fs...) -> Overloaded<Fs...>;

}  // namespace parhelion
