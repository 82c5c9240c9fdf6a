// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "../../examples/drive/drive_result.hpp"
#include "runs.hpp"
#include "tutavia/motion/band.hpp"
#include "tutavia/space/cell_space.hpp"
#include "tutavia/world/workspace.hpp"

/// \file
/// BandDrive: a simulated robot that follows the path of JPS_Theta* by elastic bands.

namespace reproduce {

/// The scene of a drive. The safety radius is the robot's [m].
struct BandScene {
  CellSpace space;
  Curve path;
  Disc obstacle;  ///< that the map does not have
};

/// A drive, and what its picture shows.
struct BandDrive {
  drive_program::DriveResult result{};
  std::vector<Band>
      bands{};  ///< of the last command before the obstacle appears, and of two after it
};

/// The path of JPS_Theta* and cubic Bezier pieces on the paper's raster with cells of 1 m, and an
/// obstacle on it.
BandScene band_scene(const Options& options);

/// Drives along the path. The obstacle, if wanted, appears when the robot's centre is 3 m away.
BandDrive drive_by_bands(const BandScene& scene, bool has_obstacle);

Table band_table(const BandScene& scene, const BandDrive& without, const BandDrive& with);
Claim band_claim(const BandDrive& with);
/// The map, the path, the driven path, bands, the robot every four seconds.
Picture band_picture(const BandScene& scene, const BandDrive& drive);

}  // namespace reproduce
