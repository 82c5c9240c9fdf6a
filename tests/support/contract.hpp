// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "tutavia/geometry/curve.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/inflated_space.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// The common parts of the contracts of searchers and smoothers.

namespace tutavia::test {

/// The robots for which an algorithm plans: a point has safety radius 0, a disc a positive one.
enum class Robot { any, point, disc };

/// A broken clause of a contract, and the first place where it broke.
struct Breach {
  std::string clause;
  std::string place;
};

/// Collects the clauses that an algorithm breaks, each once.
class Breaches {
 public:
  /// Names the place of the checks that follow.
  void at(std::string place) { place_ = std::move(place); }
  const std::string& place() const { return place_; }

  /// Records the clause if it was broken. Returns `kept`.
  bool check(bool kept, std::string_view clause) {
    if (!kept && !has(clause)) list_.push_back({std::string(clause), place_});
    return kept;
  }

  bool has(std::string_view clause) const {
    for (const Breach& breach : list_) {
      if (breach.clause == clause) return true;
    }
    return false;
  }
  const std::vector<Breach>& list() const { return list_; }

 private:
  std::string place_;
  std::vector<Breach> list_;
};

/// Calls `visit(type, name)` for each kind of space that the contracts cover, with its type as a
/// std::type_identity.
template <class Visit>
void for_each_kind_of_space(const Visit& visit) {
  visit(std::type_identity<LatticeSpace>{}, "LatticeSpace");
  visit(std::type_identity<CellSpace>{}, "CellSpace");
  visit(std::type_identity<InflatedSpace>{}, "InflatedSpace");
}

/// Fails the running test for every breach; `algorithm` and `space` are names for the message.
inline void report(const Breaches& breaches, std::string_view algorithm, std::string_view space) {
  INFO(algorithm << " on " << space);
  for (const Breach& breach : breaches.list()) {
    FAIL_CHECK("broken: " << breach.clause << " (" << breach.place << ")");
  }
  CHECK(breaches.list().empty());
}

/// Whether two curves have the same pieces with the same ends.
inline bool same_curve(const Curve& a, const Curve& b) {
  if (a.pieces().size() != b.pieces().size()) return false;
  for (std::size_t i = 0; i < a.pieces().size(); ++i) {
    if (a.pieces()[i].index() != b.pieces()[i].index()) return false;
    if (start_of(a.pieces()[i]) != start_of(b.pieces()[i])) return false;
    if (end_of(a.pieces()[i]) != end_of(b.pieces()[i])) return false;
  }
  return true;
}

}  // namespace tutavia::test
