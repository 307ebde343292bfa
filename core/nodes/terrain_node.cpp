// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "core/nodes/terrain_node.h"

namespace spin {
namespace {

constexpr PropertyRow kTerrainRows[] = {
    property<&TerrainNode::source>("source", SPIN_TR("File"),
                                   SPIN_TR("Raster file with the elevation model."))
        .path(),
    property<&TerrainNode::epsg>("epsg", SPIN_TR("EPSG code"),
                                 SPIN_TR("Coordinate system; 0 takes the one named in the file."))
        .range(0, 999999, 1)
        .affecting(Affects::Nothing),
    property<&TerrainNode::cellSize>(
        "cell_size_m", SPIN_TR("Cell size"),
        SPIN_TR("Distance of the heights in files without coordinates; 0 takes the file's, or 1 m."))
        .in(Unit::Metre)
        .range(0, 10000, 1),
    property<&TerrainNode::heightUnit>(
        "height_unit_m", SPIN_TR("Height unit"),
        SPIN_TR("Metres per unit of height in files that name no unit, such as 16-bit PNG."))
        .in(Unit::Metre)
        .range(1e-6, 1000, 0.1),
    property<&TerrainNode::hasNoData>(
        "has_no_data", SPIN_TR("Marks holes"),
        SPIN_TR("The hole value marks cells without height, in files that cannot name one.")),
    property<&TerrainNode::noData>("no_data", SPIN_TR("Hole value"),
                                   SPIN_TR("Value of cells without height, in units of the file."))
        .range(-1e9, 1e9, 1),
    property<&TerrainNode::verticalScale>("vertical_scale", SPIN_TR("Vertical scale"),
                                          SPIN_TR("Factor on the heights above the lowest point."))
        .in(Unit::Factor)
        .range(0.01, 100, 0.1),
    property<&TerrainNode::coverDetailCell>(
        "cover_detail_cell_m", SPIN_TR("Fine cover cell"),
        SPIN_TR("Size of the snow cover cells near models; elsewhere the cover has the terrain's cells."))
        .in(Unit::Metre)
        .range(0.05, 10, 0.05),
    property<&TerrainNode::coverDetailMargin>("cover_detail_margin_m", SPIN_TR("Fine cover margin"),
                                              SPIN_TR("How far round a model the fine cover reaches."))
        .in(Unit::Metre)
        .range(0, 100, 1),
    property<&TerrainNode::credit>("credit", SPIN_TR("Credit line"),
                                   SPIN_TR("Source of the data, printed on pictures."))
        .affecting(Affects::Picture),
};

constexpr Choice kUpAxes[] = {
    {"file", SPIN_TR("As the file says")},
    {"y", SPIN_TR("Y is up")},
    {"z", SPIN_TR("Z is up")},
};

constexpr PropertyRow kModelRows[] = {
    property<&ModelNode::source>("source", SPIN_TR("File"), SPIN_TR("Model file (glTF, OBJ, PLY).")).path(),
    property<&ModelNode::upAxis>("up_axis", SPIN_TR("Up axis"), SPIN_TR("Which way is up in the model file."))
        .oneOf(kUpAxes),
    property<&ModelNode::unitScale>("unit_m", SPIN_TR("Unit of the file"),
                                    SPIN_TR("Metres per unit of the file; 0 takes what the format says."))
        .in(Unit::Metre)
        .range(0, 1000, 0.01),
    property<&ModelNode::position>("position_m", SPIN_TR("Position"),
                                   SPIN_TR("Place in local metres: east, north, up."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 0.5)
        .animated(),
    property<&ModelNode::onGround>("on_ground", SPIN_TR("Stand on ground"),
                                   SPIN_TR("The height counts from the terrain under the model.")),
    property<&ModelNode::rotationDegrees>("rotation_deg", SPIN_TR("Rotation"),
                                          SPIN_TR("Turn about the x, y and z axes, in that order."))
        .in(Unit::Degree)
        .range(-3600, 3600, 5)
        .animated(),
    property<&ModelNode::scale>("scale", SPIN_TR("Scale"), SPIN_TR("Factor along each axis."))
        .in(Unit::Factor)
        .range(0.001, 1000, 0.1)
        .animated(),
    property<&ModelNode::coverCell>("cover_cell_m", SPIN_TR("Cover cell"),
                                    SPIN_TR("Size of the snow cover cells on this model."))
        .in(Unit::Metre)
        .range(0.02, 10, 0.05),
    property<&ModelNode::catchesSnow>(
        "catches_snow", SPIN_TR("Catches snow"),
        SPIN_TR("Snow lies on the parts that face up; otherwise the model only shelters what is below it.")),
    property<&ModelNode::surface>(
        "surface", SPIN_TR("Surface"),
        SPIN_TR("What the snow lies on: how well it conducts heat, how dark it is."))
        .oneOf(kGroundTypeChoices),
    property<&ModelNode::heat>(
        "heat_w_m2", SPIN_TR("Heat"),
        SPIN_TR("Heat that comes up through the surface: 10 for a house, 100 melts 26 mm of water a day."))
        .in(Unit::WattPerSquareMetre)
        .range(-1000, 10000, 5)
        .animated(),
    property<&ModelNode::dusting>(
        "dusting", SPIN_TR("Dusting"),
        SPIN_TR("In pictures, how much of the snow of the ground beside it shows on what faces up: for trees "
                "and small things in great numbers that catch no snow of their own."))
        .in(Unit::Factor)
        .range(0, 1, 0.05)
        .animated()
        .affecting(Affects::Picture),
    property<&ModelNode::fineCover>(
        "fine_cover", SPIN_TR("Fine cover round it"),
        SPIN_TR("The ground round the model has small cover cells, so that lee and "
                "eaves show; off for what stands far away or in great numbers.")),
    property<&ModelNode::copies>("copies_m", SPIN_TR("Copies"),
                                 SPIN_TR("Places (east, north) at which the model stands once more."))
        .in(Unit::Metre)
        .range(-1e6, 1e6, 1),
    property<&ModelNode::copyTurnDegrees>("copy_turn_deg", SPIN_TR("Turn of copies"),
                                          SPIN_TR("Range within which copies are turned at random."))
        .in(Unit::Degree)
        .range(0, 360, 5),
    property<&ModelNode::copyScale>(
        "copy_scale", SPIN_TR("Size of copies"),
        SPIN_TR("Share by which copies are larger or smaller at random: 0.2 gives 0.8 to 1.2."))
        .in(Unit::Factor)
        .range(0, 0.9, 0.05),
    property<&ModelNode::copySeed>("copy_seed", SPIN_TR("Seed of copies"),
                                   SPIN_TR("Another number turns and scales the copies otherwise."))
        .range(0, 1000000, 1),
};

}  // namespace

constinit const NodeType kTerrainType =
    nodeType<TerrainNode>("terrain", SPIN_TR("Terrain"),
                          SPIN_TR("An elevation model; the ground of the scene."), true, kTerrainRows);
constinit const NodeType kModelType = nodeType<ModelNode>(
    "model", SPIN_TR("Model"), SPIN_TR("An imported object: a house, a tree, a car."), false, kModelRows);

}  // namespace spin
