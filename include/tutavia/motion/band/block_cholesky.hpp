// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>
#include <vector>

/// \file
/// BlockSystem: symmetric linear equations in which a block meets its next two neighbours.

namespace tutavia::detail {

/// The equations (H + damping diag(H)) x = b for a symmetric H of 4 x 4 blocks, of which row i has
/// entries in the columns i - 2 to i + 2. Solved by a block Cholesky factorisation in O(n) for n
/// blocks. Allocates only to grow.
class BlockSystem {
 public:
  static constexpr int size = 4;  // of a block
  using Block = Eigen::Matrix<double, size, size>;
  using Vector = Eigen::Matrix<double, size, 1>;

  /// The system of n blocks, all zero.
  void reset(std::size_t n) {
    for (auto* blocks : {&diagonal_, &next_, &second_}) blocks->assign(n, Block::Zero());
    right_.assign(n, Vector::Zero());
  }

  std::size_t blocks() const { return diagonal_.size(); }
  /// The block in row i and column j, i <= j <= i + 2; of the diagonal blocks, both halves count.
  Block& at(std::size_t i, std::size_t j) {
    return j == i ? diagonal_[i] : j == i + 1 ? next_[i] : second_[i];
  }
  /// The right-hand side b.
  Vector& right(std::size_t i) { return right_[i]; }
  const Vector& right(std::size_t i) const { return right_[i]; }
  const Vector& solution(std::size_t i) const { return solution_[i]; }

  /// Solves the equations; false if the damped matrix is not positive definite. Leaves H and b.
  bool solve(double damping);

 private:
  std::vector<Block> diagonal_, next_, second_;
  std::vector<Vector> right_, solution_;
  // The lower factor: the blocks of column i in the rows i, i + 1 and i + 2.
  std::vector<Block> factor_, factor_next_, factor_second_;
};

inline bool BlockSystem::solve(double damping) {
  const std::size_t n = blocks();
  factor_ = diagonal_;
  factor_next_ = next_;
  factor_second_ = second_;
  solution_ = right_;
  for (std::size_t i = 0; i < n; ++i) {
    factor_[i].diagonal() += damping * diagonal_[i].diagonal();
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::LLT<Block> llt(factor_[i]);
    if (llt.info() != Eigen::Success) return false;
    factor_[i] = llt.matrixL();
    const auto lower = factor_[i].template triangularView<Eigen::Lower>();
    lower.solveInPlace(solution_[i]);
    if (i + 1 == n) break;
    // The rows below, transposed: L^-1 times the blocks to the right.
    lower.solveInPlace(factor_next_[i]);
    factor_[i + 1].noalias() -= factor_next_[i].transpose() * factor_next_[i];
    solution_[i + 1].noalias() -= factor_next_[i].transpose() * solution_[i];
    if (i + 2 == n) continue;
    lower.solveInPlace(factor_second_[i]);
    factor_[i + 2].noalias() -= factor_second_[i].transpose() * factor_second_[i];
    factor_next_[i + 1].noalias() -= factor_next_[i].transpose() * factor_second_[i];
    solution_[i + 2].noalias() -= factor_second_[i].transpose() * solution_[i];
  }
  for (std::size_t i = n; i-- > 0;) {
    if (i + 1 < n) solution_[i].noalias() -= factor_next_[i] * solution_[i + 1];
    if (i + 2 < n) solution_[i].noalias() -= factor_second_[i] * solution_[i + 2];
    factor_[i].template triangularView<Eigen::Lower>().transpose().solveInPlace(solution_[i]);
  }
  return true;
}

}  // namespace tutavia::detail
