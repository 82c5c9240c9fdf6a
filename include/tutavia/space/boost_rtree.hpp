// SPDX-License-Identifier: MIT
#pragma once

/// \file
/// Boost.Geometry's R-tree, included in one place: Boost 1.74 reports a deprecated header of its
/// own on every inclusion, which is silenced here and only here.

#ifndef BOOST_ALLOW_DEPRECATED_HEADERS
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS
#else
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#endif
#include <boost/iterator/function_output_iterator.hpp>
