// SPDX-License-Identifier: Apache-2.0
#include "render/ranks/ranks.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdlib>
#include <thread>

#include <mpi.h>

#include "sky/fixed_point.h"

namespace parhelion {

namespace {

// MPI calls these without any context, so what they find out is global: a sum of this process did not fit.
std::atomic<bool> overflowed{false};

template <class Integer>
void addEach(const Integer* from, Integer* to, int count) {
  for (int i = 0; i < count; ++i)
    if (__builtin_add_overflow(from[i], to[i], &to[i])) overflowed = true;
}

void addInt64(void* from, void* to, int* count, MPI_Datatype* /*type*/) {
  addEach(static_cast<const std::int64_t*>(from), static_cast<std::int64_t*>(to), *count);
}

/// 128-bit integers, which MPI has no type for: two words each, as they lie in memory.
void addInt128(void* from, void* to, int* count, MPI_Datatype* /*type*/) {
  using Words = std::array<std::uint64_t, 2>;
  const auto* a = static_cast<const Words*>(from);
  auto* b = static_cast<Words*>(to);
  for (int i = 0; i < *count; ++i) {
    const auto x = std::bit_cast<ExactSum::Units>(a[i]);
    auto y = std::bit_cast<ExactSum::Units>(b[i]);
    addEach(&x, &y, 1);
    b[i] = std::bit_cast<Words>(y);
  }
}

/// A sum of MPI's making, freed with the program.
MPI_Op sumBy(MPI_User_function* add) {
  MPI_Op op;
  MPI_Op_create(add, 1, &op);
  return op;
}

/// Adds `count` items at `sums` over all ranks to rank 0.
void reduceTo0(int rank, void* sums, int count, MPI_Datatype type, MPI_Op add) {
  if (rank == 0)
    MPI_Reduce(MPI_IN_PLACE, sums, count, type, add, 0, MPI_COMM_WORLD);
  else
    MPI_Reduce(sums, nullptr, count, type, add, 0, MPI_COMM_WORLD);
}

}  // namespace

Ranks::Ranks(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  if (provided < MPI_THREAD_FUNNELED) MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &count_);
  MPI_Comm machine;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  MPI_Comm_size(machine, &onThisMachine_);
  MPI_Comm_free(&machine);
}

Ranks::~Ranks() { MPI_Finalize(); }

void Ranks::send(int to, Subject subject, std::string_view text) const {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_BYTE, to, static_cast<int>(subject), MPI_COMM_WORLD);
}

void Ranks::order(std::string_view text) const {
  for (int rank = 0; rank < count_; ++rank)
    if (rank != rank_) send(rank, Subject::order, text);
}

std::optional<Ranks::Message> Ranks::next() const {
  int there = 0, bytes = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) return {};
  MPI_Get_count(&status, MPI_BYTE, &bytes);
  Message message{status.MPI_SOURCE, static_cast<Subject>(status.MPI_TAG),
                  std::string(static_cast<std::size_t>(bytes), '\0')};
  MPI_Recv(message.text.data(), bytes, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return message;
}

Ranks::Message Ranks::wait() const {
  // MPI itself would wait by looking again and again, with a whole processor.
  constexpr std::chrono::microseconds kFirst{50}, kLongest{5000};
  for (std::chrono::microseconds pause = kFirst;; pause = std::min(2 * pause, kLongest)) {
    if (std::optional<Message> message = next()) return *std::move(message);
    std::this_thread::sleep_for(pause);
  }
}

void Ranks::visit(std::span<std::int64_t> sums) {
  // In pieces, so that MPI needs little memory of its own.
  constexpr std::size_t kPiece = 1 << 17;
  static const MPI_Op add = sumBy(addInt64);
  for (std::size_t first = 0; first < sums.size(); first += kPiece) {
    const std::span<std::int64_t> piece = sums.subspan(first, std::min(kPiece, sums.size() - first));
    reduceTo0(rank_, piece.data(), static_cast<int>(piece.size()), MPI_INT64_T, add);
  }
  bytesReduced_ += sums.size_bytes();
  if (rank_ == 0) return;
  std::ranges::fill(sums, 0);
}

void Ranks::visit(std::uint64_t& count) {
  auto bits = std::bit_cast<std::int64_t>(count);
  visit(std::span(&bits, 1));
  count = std::bit_cast<std::uint64_t>(bits);
}

void Ranks::visit(ExactSum::Units& sum) {
  static const MPI_Op add = sumBy(addInt128);
  static const MPI_Datatype type = [] {
    MPI_Datatype words;
    MPI_Type_contiguous(2, MPI_UINT64_T, &words);
    MPI_Type_commit(&words);
    return words;
  }();
  reduceTo0(rank_, &sum, 1, type, add);
  bytesReduced_ += sizeof sum;
  if (rank_ != 0) sum = 0;
}

bool Ranks::inAny(bool bad) {
  int any = bad ? 1 : 0;
  MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_LOR, MPI_COMM_WORLD);
  return any != 0;
}

void Ranks::requireNoOverflow() {
  if (inAny(overflowed.exchange(false))) rejectLight();
}

}  // namespace parhelion
