// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "plan/registry.hpp"
#include "spaces.hpp"
#include "tutavia/planner.hpp"
#include "tutavia/registry/algorithm_text.hpp"

/// \file
/// tutavia.Planner: chosen algorithms, with scratch memory for every kind of space.

namespace tutavia_python {

namespace py = pybind11;

template <class S>
using AnyPlanner = Planner<AnySearch<S>, AnySmoother<S>>;

/// A search, smoothers one after the other, and a vehicle for searches that plan headings.
struct Choice {
  AlgorithmText search;
  std::vector<AlgorithmText> smoothers{};
  std::optional<Vehicle> vehicle{};

  /// The choice as one line, for files of results.
  std::string text() const;
};

/// Algorithms on spaces of type S, and idle planners whose scratch memory is warm. All calls need
/// the GIL, which guards the list.
template <class S>
class PlannerPool {
 public:
  /// A planner for one call. It is given back even after an exception: its memory may take longer
  /// to release than Ctrl-C may take.
  class Loan {
   public:
    explicit Loan(PlannerPool& pool) : pool_(pool), planner_(pool.take()) {}
    ~Loan() { pool_.idle_.push_back(std::move(planner_)); }
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    AnyPlanner<S>* operator->() const { return planner_.get(); }

   private:
    PlannerPool& pool_;
    std::unique_ptr<AnyPlanner<S>> planner_;
  };

  /// \pre `make` has been called
  Loan lend() { return Loan(*this); }

  /// Makes the algorithms unless they are there. Raises InvalidOption.
  void make(const Choice& choice);
  const AnyPlanner<S>& model() const { return *model_; }

 private:
  std::unique_ptr<AnyPlanner<S>> take() {
    if (idle_.empty()) return std::make_unique<AnyPlanner<S>>(model_->worker());
    auto planner = std::move(idle_.back());
    idle_.pop_back();
    return planner;
  }

  std::unique_ptr<AnyPlanner<S>> model_;
  std::vector<std::unique_ptr<AnyPlanner<S>>> idle_;
};

/// tutavia.Planner.
class PlannerHandle {
 public:
  explicit PlannerHandle(Choice choice) : choice_(std::move(choice)) {}

  const Choice& choice() const { return choice_; }
  /// The pool for spaces of type S, made at the first call.
  template <class S>
  PlannerPool<S>& pool() {
    auto& pool = std::get<PlannerPool<S>>(pools_);
    pool.make(choice_);
    return pool;
  }

 private:
  Choice choice_;
  std::tuple<PlannerPool<LatticeSpace>, PlannerPool<CellSpace>> pools_;
};

/// Raises InvalidInput.
[[noreturn]] void refuse_space(const py::object& space);

/// Calls `use(handle)` with the handle of a space of either kind. Raises InvalidInput for what is
/// no space.
template <class Use>
auto with_space(const py::object& space, const Use& use) {
  if (py::isinstance<CellHandle>(space)) {
    return use(space.cast<std::shared_ptr<CellHandle>>());
  }
  if (py::isinstance<LatticeHandle>(space)) {
    return use(space.cast<std::shared_ptr<LatticeHandle>>());
  }
  refuse_space(space);
}

}  // namespace tutavia_python
