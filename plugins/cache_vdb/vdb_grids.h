// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/sim/air_part.h"
#include "plugins/cache_vdb/openvdb_headers.h"
#include "plugins/sdk/exporter.h"

namespace spin {

/// One volume of a file and how the manifest lists it.
struct VdbGrid {
  openvdb::GridBase::Ptr grid;
  ExportedAttribute attribute;
};

/// Whether the cells' integer coordinates fit those of OpenVDB.
bool fitsVdb(const AirPart& part);

/// `density` (mist and snow together, kg/m3) and the fields of the part by their own names. A voxel is a
/// cell, its index the cell's number on the lattice, its place the cell's centre in local m, z up; background
/// 0. The cells of a brick are active where any of them is not 0. Amounts are fog volumes, velocities
/// contravariant and at the voxels' centres. Each grid tells its `unit`. Numbers are stored in 16 bits where
/// that costs no more than their last digits.
std::vector<VdbGrid> vdbGrids(const AirPart& part);

}  // namespace spin
