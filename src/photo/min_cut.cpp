// SPDX-License-Identifier: Apache-2.0
#include "photo/min_cut.h"

#include <algorithm>
#include <limits>

namespace parhelion {

void MinCut::terminals(std::size_t i, float onSinkSide, float onSourceSide) {
  nodes_[i].terminal = onSinkSide - onSourceSide;
}

void MinCut::edge(std::size_t a, std::size_t b, float cost) {
  const auto join = [&](std::size_t from, std::size_t to) {
    arcs_.push_back({static_cast<int>(to), nodes_[from].first, cost});
    nodes_[from].first = static_cast<int>(arcs_.size()) - 1;
  };
  join(a, b);
  join(b, a);
}

void MinCut::activate(int i) {
  if (node(i).active) return;
  node(i).active = true;
  active_.push_back(i);
}

// Grows the tree at an active node; the arc from the source's tree to the sink's where they meet, or -1.
int MinCut::meeting(int i) {
  const bool ofSink = node(i).ofSink;
  for (int a = node(i).first; a >= 0; a = arc(a).next) {
    if (outward(a, ofSink) <= 0.0F) continue;
    Node& other = node(arc(a).head);
    if (other.parent == kFree) {
      other.ofSink = ofSink;
      activate(arc(a).head);
    } else if (other.ofSink != ofSink) {
      return ofSink ? a ^ 1 : a;
    } else if (other.stamp > node(i).stamp || other.distance <= node(i).distance) {
      continue;
    }
    // A new leaf, or one that gets nearer to the root.
    other.parent = a ^ 1;
    other.stamp = node(i).stamp;
    other.distance = node(i).distance + 1;
  }
  return -1;
}

float MinCut::narrowest(int i, bool ofSink, float flow) {
  for (; node(i).parent != kTerminal; i = arc(node(i).parent).head) {
    flow = std::min(flow, outward(node(i).parent ^ 1, ofSink));
  }
  return std::min(flow, ofSink ? -node(i).terminal : node(i).terminal);
}

void MinCut::push(int i, bool ofSink, float flow) {
  const auto orphan = [&](int child) {
    node(child).parent = kOrphan;
    orphans_.push_front(child);
  };
  while (node(i).parent != kTerminal) {
    const int up = node(i).parent, down = up ^ 1;
    arc(ofSink ? up : down).residue -= flow;
    arc(ofSink ? down : up).residue += flow;
    const int next = arc(up).head;
    if (outward(down, ofSink) <= 0.0F) orphan(i);
    i = next;
  }
  node(i).terminal += ofSink ? flow : -flow;
  if (ofSink ? node(i).terminal >= 0.0F : node(i).terminal <= 0.0F) orphan(i);
}

void MinCut::augment(int bridge) {
  const int sourceEnd = arc(bridge ^ 1).head, sinkEnd = arc(bridge).head;
  const float flow = narrowest(sinkEnd, true, narrowest(sourceEnd, false, arc(bridge).residue));
  arc(bridge).residue -= flow;
  arc(bridge ^ 1).residue += flow;
  push(sourceEnd, false, flow);
  push(sinkEnd, true, flow);
}

// Arcs to the root, or -1 where an orphan is in the way. Remembers what it found along the way.
int MinCut::rootDistance(int i) {
  int steps = 0;
  for (int k = i;; k = arc(node(k).parent).head) {
    Node& here = node(k);
    if (here.stamp == time_) {
      steps += here.distance;
      break;
    }
    ++steps;
    if (here.parent == kTerminal) {
      here.stamp = time_;
      here.distance = 1;
      break;
    }
    if (here.parent < 0) return -1;
  }
  int distance = steps;
  for (int k = i; node(k).stamp != time_; k = arc(node(k).parent).head) {
    node(k).stamp = time_;
    node(k).distance = distance--;
  }
  return steps;
}

// Finds an orphan a new parent in its tree, or sets it free with all that hung on it.
void MinCut::adopt(int i) {
  const bool ofSink = node(i).ofSink;
  int best = kFree, nearest = std::numeric_limits<int>::max();
  for (int a = node(i).first; a >= 0; a = arc(a).next) {
    const Node& other = node(arc(a).head);
    if (outward(a ^ 1, ofSink) <= 0.0F || other.parent == kFree || other.ofSink != ofSink) continue;
    const int distance = rootDistance(arc(a).head);
    if (distance < 0 || distance >= nearest) continue;
    nearest = distance;
    best = a;
  }
  node(i).parent = best;
  if (best != kFree) {
    node(i).stamp = time_;
    node(i).distance = nearest + 1;
    return;
  }
  for (int a = node(i).first; a >= 0; a = arc(a).next) {
    Node& other = node(arc(a).head);
    if (other.parent == kFree || other.ofSink != ofSink) continue;
    if (outward(a ^ 1, ofSink) > 0.0F) activate(arc(a).head);
    if (other.parent >= 0 && arc(other.parent).head == i) {
      other.parent = kOrphan;
      orphans_.push_back(arc(a).head);
    }
  }
}

void MinCut::run() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].terminal == 0.0F) continue;
    nodes_[i].ofSink = nodes_[i].terminal < 0.0F;
    nodes_[i].parent = kTerminal;
    nodes_[i].distance = 1;
    activate(static_cast<int>(i));
  }
  while (!active_.empty()) {
    const int i = active_.front();
    const int bridge = node(i).parent == kFree ? -1 : meeting(i);
    ++time_;
    if (bridge < 0) {
      active_.pop_front();
      node(i).active = false;
      continue;
    }
    augment(bridge);
    while (!orphans_.empty()) {
      const int orphan = orphans_.front();
      orphans_.pop_front();
      adopt(orphan);
    }
  }
}

}  // namespace parhelion
