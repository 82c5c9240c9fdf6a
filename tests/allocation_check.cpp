// SPDX-License-Identifier: MIT
/// \file
/// Counts allocations: a program of its own, because it replaces operator new.

#include <cstdio>
#include <cstdlib>
#include <new>

#include "tutavia/certify/certify.hpp"
#include "tutavia/search/astar.hpp"
#include "tutavia/search/bidirectional_astar.hpp"
#include "tutavia/search/canonical_astar.hpp"
#include "tutavia/search/dijkstra.hpp"
#include "tutavia/search/jps.hpp"
#include "tutavia/search/penalty_astar.hpp"
#include "tutavia/search/weighted_astar.hpp"
#include "tutavia/space/lattice_space.hpp"
#include "tutavia/world/maps.hpp"

namespace {

std::size_t allocations = 0;

void* allocate(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace {

using namespace tutavia;

int failures = 0;

/// Says what was wrong; a run without failures says nothing.
void require(bool holds, const char* what, const char* why) {
  if (holds) return;
  std::fprintf(stderr, "%s: %s\n", what, why);
  ++failures;
}

void expect(const char* what, std::size_t counted, std::size_t allowed) {
  if (counted <= allowed) return;
  std::fprintf(stderr, "%s: %zu allocations, %zu allowed\n", what, counted, allowed);
  ++failures;
}

template <class A>
void check_search(const char* what, const LatticeSpace& space, const Scene& scene) {
  typename A::Scratch scratch;
  NoObserver no_observer;
  const Query query{.start = scene.start, .goal = scene.goals[0]};
  std::size_t cold = allocations;
  (void)A{}.search(space, query, scratch, no_observer);
  cold = allocations - cold;
  std::size_t warm = allocations;
  const auto route = A{}.search(space, query, scratch, no_observer);
  warm = allocations - warm;
  require(route.has_value(), what, "no route");
  if (!route) return;
  require(cold > warm, what, "the first query allocates no more than the second");
  expect(what, warm, 2);  // the route's pieces and their lengths

  const std::size_t before = allocations;
  const Certificate certificate = certify(space, route->curve);
  require(certificate.status == ProofStatus::proved, what, "a route that is not proved");
  expect("certificate", allocations - before, 0);
}

}  // namespace

int main() {
  for (const Scene& scene : {maps::array(), maps::complex(), maps::maze()}) {
    const auto space = LatticeSpace::build(scene.workspace, {.resolution = 0.2}).value();
    check_search<AStar>("A*, second query", space, scene);
    check_search<Dijkstra>("Dijkstra, second query", space, scene);
    check_search<WeightedAStar>("weighted A*, second query", space, scene);
    check_search<CanonicalAStar>("canonical A*, second query", space, scene);
    check_search<BidirectionalAStar>("bidirectional A*, second query", space, scene);
    check_search<PenaltyAStar>("penalty A*, second query", space, scene);
    check_search<Jps>("JPS, second query", space, scene);
  }
  return failures == 0 ? 0 : 1;
}
