// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "math/sum_visitor.h"

namespace parhelion {

/// The processes of one run, as mpirun has started them: its ranks, numbered from 0. One of these objects lives in each
/// of them, from before the command line is read to the end. All calls come from the thread that made it.
class Ranks : public SumVisitor {
 public:
  Ranks(int& argc, char**& argv);
  ~Ranks() override;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  int rank() const { return rank_; }
  int count() const { return count_; }

  /// How many of the ranks are on this one's machine, itself among them.
  int onThisMachine() const { return onThisMachine_; }

  /// What a message is about.
  enum class Subject : int { order, request, block, done, failure };

  struct Message {
    int from = 0;
    Subject subject{};
    std::string text;
  };

  void send(int to, Subject subject, std::string_view text) const;

  /// Sends an order to all others.
  void order(std::string_view text) const;

  /// The next message to this rank, if one has come.
  std::optional<Message> next() const;

  /// The next message to this rank. A rank that waits leaves the processor to others.
  Message wait() const;

  /// Adds up integers over all ranks, in a tree: rank 0 gets the sums, all others zeros. All ranks call it at the same
  /// time with as many integers.
  void visit(std::span<std::int64_t> sums) override;
  void visit(std::uint64_t& count) override;
  void visit(ExactSum::Units& sum) override;
  using SumVisitor::visit;

  /// Whether `bad` is true in any rank. All ranks call it at the same time.
  bool inAny(bool bad);

  /// Throws std::overflow_error in all ranks if a sum since the last call did not fit. All ranks call it.
  void requireNoOverflow();

  /// Bytes of integers that each rank but the first has given away to be added.
  std::uint64_t bytesReduced() const { return bytesReduced_; }

 private:
  int rank_ = 0, count_ = 1, onThisMachine_ = 1;
  std::uint64_t bytesReduced_ = 0;
};

}  // namespace parhelion
