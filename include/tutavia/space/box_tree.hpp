// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "tutavia/geometry/box.hpp"
#include "tutavia/space/boost_rtree.hpp"

/// \file
/// BoxTree: which boxes meet a box.

namespace tutavia {

/// An immutable R-tree over numbered boxes (Boost.Geometry, bulk-loaded): a query costs O(log n +
/// k) for n boxes and k answers.
class BoxTree {
 public:
  using Entry = std::pair<Box, std::uint32_t>;

  BoxTree() = default;
  explicit BoxTree(const std::vector<Entry>& entries) : tree_(packed(entries)) {}

  /// Calls `visit(number)` for every box that meets `box`, touching included.
  ///
  /// The tree's query is instantiated once, for a plain function, because every further one costs
  /// the user's compiler a tenth of a second.
  template <class Visit>
  void for_each_in(const Box& box, Visit visit) const {
    query(box, &visit,
          [](void* context, std::uint32_t number) { (*static_cast<Visit*>(context))(number); });
  }

 private:
  using TreePoint = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
  using TreeBox = boost::geometry::model::box<TreePoint>;
  using TreeEntry = std::pair<TreeBox, std::uint32_t>;
  using Tree = boost::geometry::index::rtree<TreeEntry, boost::geometry::index::linear<8>>;

  static TreeBox tree_box(const Box& box) {
    return {{box.min.x(), box.min.y()}, {box.max.x(), box.max.y()}};
  }
  static Tree packed(const std::vector<Entry>& entries) {
    std::vector<TreeEntry> converted;
    converted.reserve(entries.size());
    for (const auto& [box, number] : entries) converted.emplace_back(tree_box(box), number);
    return {converted.begin(), converted.end()};
  }
  void query(const Box& box, void* context, void (*visit)(void*, std::uint32_t)) const {
    tree_.query(boost::geometry::index::intersects(tree_box(box)),
                boost::make_function_output_iterator(
                    [context, visit](const TreeEntry& entry) { visit(context, entry.second); }));
  }

  Tree tree_;
};

}  // namespace tutavia
