// SPDX-License-Identifier: MIT
#include "tutavia/motion/band/block_cholesky.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cstddef>

#include "support/catch.hpp"
#include "tutavia/core/random.hpp"

namespace {

using namespace tutavia;
using detail::BlockSystem;

/// A random positive definite matrix of n x n blocks with two blocks beside the diagonal.
Eigen::MatrixXd banded_matrix(Eigen::Index n, Random& random) {
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(20 * n, 4 * n);
  for (Eigen::Index row = 0; row < 20 * n; ++row) {
    const Eigen::Index first = 4 * (row / 20);
    for (Eigen::Index k = first; k < std::min(first + 12, 4 * n); ++k) {
      jacobian(row, k) = random.uniform(-1, 1);
    }
  }
  return jacobian.transpose() * jacobian;
}

TEST_CASE("a block system has the solution of the dense matrix") {
  Random random(7);
  for (Eigen::Index n = 1; n <= 12; ++n) {
    const Eigen::MatrixXd matrix = banded_matrix(n, random);
    BlockSystem system;
    system.reset(static_cast<std::size_t>(n));
    Eigen::VectorXd right(4 * n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = i; j < std::min(n, i + 3); ++j) {
        system.at(std::size_t(i), std::size_t(j)) = matrix.block<4, 4>(4 * i, 4 * j);
      }
      for (int k = 0; k < 4; ++k) right[4 * i + k] = random.uniform(-1, 1);
      system.right(std::size_t(i)) = right.segment<4>(4 * i);
    }
    for (const double damping : {0.0, 0.5}) {
      REQUIRE(system.solve(damping));
      Eigen::MatrixXd damped = matrix;
      damped.diagonal() *= 1 + damping;
      const Eigen::VectorXd expected = damped.ldlt().solve(right);
      for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Vector4d part = expected.segment<4>(4 * i);
        CHECK((system.solution(std::size_t(i)) - part).norm() <= 1e-9 * (1 + part.norm()));
      }
    }
  }
}

TEST_CASE("a block system that is not positive definite is not solved") {
  BlockSystem system;
  system.reset(2);
  system.at(0, 0).setIdentity();
  system.at(1, 1) = -BlockSystem::Block::Identity();
  CHECK_FALSE(system.solve(0));
}

}  // namespace
