// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tutavia/grid/cell_costs.hpp"
#include "tutavia/plan/query.hpp"
#include "tutavia/plan/vehicle.hpp"
#include "tutavia/registry/algorithm_text.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/space/lattice_space.hpp"

/// \file
/// describe_job: what the results of a batch depend on, as one line.

namespace batch_program {

using namespace tutavia;

/// A number that tells the contents of spaces and queries apart (FNV-1a, 64 bits).
class Digest {
 public:
  Digest& add(std::string_view bytes);
  Digest& add(double value);
  std::string text() const;  ///< 16 hexadecimal digits

 private:
  std::uint64_t state_ = 0xcbf29ce484222325;
};

/// The digest of all that the answers of a space depend on.
std::string digest_of(const LatticeSpace& space);
std::string digest_of(const CellSpace& space);
std::string digest_of(const CellCosts& costs);
std::string digest_of(std::span<const Query> queries);
std::string digest_of(const Vehicle& vehicle);

/// A search and smoothers one after the other, with the options given, in the order of their names.
std::string algorithms_text(const AlgorithmText& search, std::span<const AlgorithmText> smoothers);

/// The line of a job: the library's version, the algorithms as texts, and the digests of space and
/// queries. Two jobs with the same line have the same results.
std::string describe_job(std::string_view algorithms, std::string_view space,
                         std::span<const Query> queries);

/// How many whole lines of results a file holds, and the bytes up to their end.
struct Progress {
  std::size_t results = 0;
  std::size_t bytes = 0;
};

/// Counts the results of a text that starts with the header. A last line without a line break was
/// cut off while it was written, and does not count. Errors: `invalid_input` for another header,
/// and for a line that does not start with its number or has another number of columns.
Expected<Progress, Failure> count_results(std::string_view text);

}  // namespace batch_program
