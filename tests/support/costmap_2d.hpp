// SPDX-License-Identifier: MIT
#pragma once

#include <tutavia/tutavia.hpp>

/// \file
/// What the README's program uses of nav2_costmap_2d::Costmap2D.

namespace nav2_costmap_2d {

class Costmap2D {
 public:
  unsigned char* getCharMap() const;
  unsigned int getSizeInCellsX() const;
  unsigned int getSizeInCellsY() const;
  double getOriginX() const;
  double getOriginY() const;
  double getResolution() const;
};

}  // namespace nav2_costmap_2d
