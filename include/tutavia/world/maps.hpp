// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

#include "tutavia/world/scene.hpp"

/// \file
/// The maps of two papers: array, complex and maze, and two scenes for sampling.
///
/// Source of the first three: Abdulshaheed 2025, "A Delta-Smoothed Path Algorithm". The paper
/// prints pictures and lengths, but no coordinates: the geometry is a reconstruction, fitted to the
/// published A* lengths. The lattice spacing of 0.2 m is as published; the safety radius of 0.3 m
/// is our choice. Source of the scenes: the improved RRT* of MM Science Journal, October 2023
/// (RRTS), also reconstructed from its pictures: 50 x 50 m with five and six obstacles, from corner
/// to corner, for a point robot.

namespace tutavia::maps {
/// Four by four rectangular pillars in 16 x 16 m.
inline Scene array() {
  Scene scene;
  scene.name = "array";
  scene.workspace.bounds = {{0, 0}, {16, 16}};
  scene.workspace.safety_radius = 0.3;
  constexpr std::array left{1.125, 4.475, 7.825, 11.175};
  constexpr std::array right{3.575, 6.925, 10.275, 13.625};
  constexpr std::array bottom{2.925, 6.025, 9.125, 12.225};
  constexpr std::array top{4.275, 7.375, 10.475, 13.575};
  for (std::size_t i = 0; i < left.size(); ++i) {
    for (std::size_t j = 0; j < top.size(); ++j) {
      scene.workspace.obstacles.emplace_back(Polygon{
          {{left[i], bottom[j]}, {right[i], bottom[j]}, {right[i], top[j]}, {left[i], top[j]}}});
    }
  }
  scene.start = {2, 1};
  scene.goals = {{6, 8.3}, {14, 8.4}, {10, 15.2}, {14, 15.2}};
  scene.resolution = 0.2;
  return scene;
}

/// An ellipse, a rectangle and two triangles in 12 x 12 m.
inline Scene complex() {
  Scene scene;
  scene.name = "complex";
  scene.workspace.bounds = {{0, 0}, {12, 12}};
  scene.workspace.safety_radius = 0.3;
  scene.workspace.obstacles = {
      Polygon{{{3.4, 2.7},
               {3.3488887394336024, 2.8294095225512605},
               {3.199038105676658, 2.95},
               {2.9606601717798213, 3.053553390593274},
               {2.6500000000000004, 3.1330127018922194},
               {2.288228567653781, 3.1829629131445345},
               {1.9, 3.2},
               {1.511771432346219, 3.1829629131445345},
               {1.1500000000000004, 3.1330127018922194},
               {0.8393398282201787, 3.053553390593274},
               {0.6009618943233419, 2.95},
               {0.4511112605663976, 2.8294095225512605},
               {0.3999999999999999, 2.7},
               {0.4511112605663974, 2.57059047744874},
               {0.6009618943233417, 2.45},
               {0.839339828220178, 2.3464466094067267},
               {1.1499999999999992, 2.266987298107781},
               {1.511771432346219, 2.217037086855466},
               {1.8999999999999997, 2.2},
               {2.28822856765378, 2.217037086855466},
               {2.6500000000000004, 2.266987298107781},
               {2.960660171779821, 2.3464466094067262},
               {3.1990381056766575, 2.45},
               {3.348888739433602, 2.5705904774487394}}},
      Polygon{{{3.3, 6.2}, {5.2, 6.2}, {5.2, 7.1}, {3.3, 7.1}}},
      Polygon{{{9.5, 4.5}, {10.9, 8}, {8.1, 8}}},
      Polygon{{{5.9, 4}, {7.3, 4}, {6.6, 5.9}}},
  };
  scene.start = {2, 1};
  scene.goals = {{11, 6}, {11, 9}, {6, 10}, {2, 8}};
  scene.resolution = 0.2;
  return scene;
}

/// Six walls in 16 x 16 m.
inline Scene maze() {
  Scene scene;
  scene.name = "maze";
  scene.workspace.bounds = {{0, 0}, {16, 16}};
  scene.workspace.safety_radius = 0.3;
  scene.workspace.obstacles = {
      Polygon{{{0, 1.8}, {1.5, 1.8}, {1.5, 2.2}, {0, 2.2}}},
      Polygon{{{5.7, 10.1}, {12.8, 10.1}, {12.8, 10.5}, {5.7, 10.5}}},
      Polygon{{{11.6, 13.1}, {12, 13.1}, {12, 16}, {11.6, 16}}},
      Polygon{{{12.1, 1.9}, {12.5, 1.9}, {12.5, 9}, {12.1, 9}}},
      Polygon{{{8.8, 0}, {9.2, 0}, {9.2, 6.9}, {8.8, 6.9}}},
      Polygon{{{0, 8.1}, {11, 8.1}, {11, 8.5}, {0, 8.5}}},
  };
  scene.start = {2, 1};
  scene.goals = {{14.5, 14.5}, {7, 14}, {14, 6}, {2, 14}};
  scene.resolution = 0.2;
  return scene;
}

namespace detail {

inline Polygon rectangle(double left, double bottom, double right, double top) {
  return Polygon{{{left, bottom}, {right, bottom}, {right, top}, {left, top}}};
}

inline Scene rrt_scene() {
  Scene scene;
  scene.workspace.bounds = {{0, 0}, {50, 50}};
  scene.start = {0, 0};
  scene.goals = {{50, 50}};
  scene.resolution = 0.5;
  return scene;
}

}  // namespace detail

/// The first scene of the RRT* paper: four rectangles and a disc.
inline Scene rrt_scene_1() {
  Scene scene = detail::rrt_scene();
  scene.name = "rrt_scene_1";
  scene.workspace.obstacles = {detail::rectangle(8, 6, 18, 14), detail::rectangle(6, 24, 16, 40),
                               Disc{{27, 22}, 5}, detail::rectangle(24, 34, 40, 40),
                               detail::rectangle(36, 8, 44, 24)};
  return scene;
}

/// The second scene of the RRT* paper: four rectangles and two discs.
inline Scene rrt_scene_2() {
  Scene scene = detail::rrt_scene();
  scene.name = "rrt_scene_2";
  scene.workspace.obstacles = {
      detail::rectangle(6, 8, 14, 20),  Disc{{22, 10}, 5}, detail::rectangle(18, 24, 30, 30),
      detail::rectangle(8, 32, 14, 46), Disc{{38, 36}, 5}, detail::rectangle(34, 14, 46, 22)};
  return scene;
}

}  // namespace tutavia::maps
