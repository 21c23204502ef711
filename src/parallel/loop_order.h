// SPDX-License-Identifier: Apache-2.0
#pragma once

#if defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace parhelion {

/// Tells the thread sanitizer what it cannot see by itself, as TBB is compiled without it: the calls of a loop's
/// function come after all that was done before the loop, and before all that is done behind it. Among each other they
/// have no order, so a race between two of them is found. In other builds nothing is left of this.
///
/// It must live as long as the loop.
class LoopOrder {
 public:
  LoopOrder() = default;
  ~LoopOrder() { acquire(end_); }
  LoopOrder(const LoopOrder&) = delete;
  LoopOrder& operator=(const LoopOrder&) = delete;

  /// The loop's function f, which must live as long. The loop begins here.
  template <class F>
  auto around(const F& f) {
    release(begin_);
    return Function<F>{this, &f};
  }

 private:
  template <class F>
  struct Function {
    LoopOrder* order;
    const F* f;

    template <class Argument>
    void operator()(const Argument& argument) const {
      const Call call(*order);
      (*f)(argument);
    }
  };

  /// Ends with the call, even where that throws.
  struct Call {
    explicit Call(LoopOrder& loopOrder) : order(loopOrder) { acquire(order.begin_); }
    ~Call() { release(order.end_); }
    LoopOrder& order;
  };

#if defined(__SANITIZE_THREAD__)
  static void release(char& place) { __tsan_release(&place); }
  static void acquire(char& place) { __tsan_acquire(&place); }
#else
  static void release(char&) {}
  static void acquire(char&) {}
#endif

  char begin_ = 0, end_ = 0;  // the sanitizer knows both ends of the loop by these addresses
};

}  // namespace parhelion
