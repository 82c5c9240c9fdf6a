// SPDX-License-Identifier: MIT
/// \file
/// A part of the library only: the other consumers compile all of it.

#include <tutavia/world.hpp>

int main() { return tutavia::maps::array().goals.size() == 4 ? 0 : 1; }
