// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

#include "tutavia/search/navigation_mesh.hpp"
#include "tutavia/space/cell_space.hpp"

/// \file
/// MeshOnDemand: a mesh that is made once enough queries have come.

namespace tutavia {

/// Counts the queries of AnyAngle in one space, and makes the mesh of the space's cells at the n-th
/// of them: a mesh takes as long as some 20 to 60 queries without one. Threads may share it; those
/// that search while one of them makes the mesh go on without. The query that makes it takes as
/// long as that, whatever its budget.
///
/// It serves the space of its first query and copies of that. Other spaces are searched without a
/// mesh, and so is a space whose mesh would exceed the limits of `NavigationMesh::build`.
class MeshOnDemand {
 public:
  /// The mesh is made by query number `queries` (at least 1).
  explicit MeshOnDemand(std::uint32_t queries) : left_(queries == 0 ? 1 : queries) {}

  /// Counts a query. Returns the mesh, or nullptr if there is none yet.
  const NavigationMesh* next(const CellSpace& space) {
    std::call_once(first_, [&] { identity_ = space.identity(); });
    if (identity_ != space.identity()) return nullptr;
    if (const NavigationMesh* ready = ready_.load(std::memory_order_acquire)) return ready;
    // Counts down to 0 once, however many threads there are.
    std::uint32_t left = left_.load(std::memory_order_relaxed);
    do {
      if (left == 0) return nullptr;
    } while (!left_.compare_exchange_weak(left, left - 1, std::memory_order_relaxed));
    if (left > 1) return nullptr;
    auto made = NavigationMesh::build(space.cells());
    if (!made) return nullptr;
    mesh_ = std::make_unique<const NavigationMesh>(std::move(*made));
    ready_.store(mesh_.get(), std::memory_order_release);
    return mesh_.get();
  }

 private:
  std::once_flag first_;
  std::shared_ptr<const void> identity_;  // of the space
  std::atomic<std::uint32_t> left_;
  std::unique_ptr<const NavigationMesh> mesh_;
  std::atomic<const NavigationMesh*> ready_{nullptr};
};

}  // namespace tutavia
