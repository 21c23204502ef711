// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

namespace parhelion {

/// The cheapest cut between a source and a sink, by growing a tree from each until they meet and sending flow along the
/// way (Boykov & Kolmogorov 2004, "An experimental comparison of min-cut/max-flow algorithms").
class MinCut {
 public:
  explicit MinCut(std::size_t nodes) : nodes_(nodes) {}

  /// What it costs to have the node on the sink's side (first) or on the source's (second); not negative.
  void terminals(std::size_t node, float onSinkSide, float onSourceSide);
  /// What it costs to have the two on different sides.
  void edge(std::size_t a, std::size_t b, float cost);
  void run();
  /// After run().
  bool onSourceSide(std::size_t node) const { return nodes_[node].parent != kFree && !nodes_[node].ofSink; }

 private:
  static constexpr int kFree = -1, kTerminal = -2, kOrphan = -3;  // parents that are no arcs
  struct Arc {
    int head;       // node it leads to
    int next;       // next arc from the same node, or -1
    float residue;  // flow that still fits; arc ^ 1 is the opposite one
  };
  struct Node {
    int first = -1;       // arc
    int parent = kFree;   // arc toward the root
    float terminal = 0;   // residue from the source; negative: to the sink
    int stamp = 0;        // when `distance` was last true
    int distance = 0;     // to the root
    bool ofSink = false;  // which tree
    bool active = false;
  };

  Node& node(int i) { return nodes_[static_cast<std::size_t>(i)]; }
  Arc& arc(int i) { return arcs_[static_cast<std::size_t>(i)]; }
  /// What fits along the arc away from the tree's root.
  float outward(int a, bool ofSink) { return ofSink ? arc(a ^ 1).residue : arc(a).residue; }
  void activate(int i);
  int meeting(int i);
  float narrowest(int i, bool ofSink, float flow);
  void push(int i, bool ofSink, float flow);
  void augment(int bridge);
  int rootDistance(int i);
  void adopt(int i);

  std::vector<Node> nodes_;
  std::vector<Arc> arcs_;
  std::deque<int> active_, orphans_;
  int time_ = 0;
};

}  // namespace parhelion
