// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/property/property_table.h"

namespace spin {

/// What flows. All but Custom are presets (core/flow/flow_materials.h gives their numbers and sources);
/// Custom takes the numbers of a FlowMaterialNode.
enum class FlowMaterialKind : std::uint8_t {
  DrySnow,
  WetSnow,
  Slush,
  Water,
  CrossThinning,
  CrossThickening,
  Custom
};
inline constexpr int kFlowMaterialKinds = 7;

/// Values of the cells of a release's painted area; others count as not painted.
inline constexpr std::uint8_t kReleasePainted = 1;
inline constexpr std::uint8_t kReleaseUnpainted = 255;

/// Snow that breaks loose: the area within the outline and the painted area together, covered by a slab.
struct AvalancheReleaseNode : NodeData {
  PlanPoints outline;            ///< corners in plan, local m; the last joins the first; fewer than 3 = none
  std::string source;            ///< painted area beside the scene, 8-bit PNG; empty = nothing painted
  double depth = 1.0;            ///< m
  bool depthIsVertical = false;  ///< else measured along the slope's normal, as release depths are
  double density = 0.0;          ///< kg/m3; 0 = the material's
  FlowMaterialKind material = FlowMaterialKind::DrySnow;
  std::string customMaterial;  ///< id of a FlowMaterialNode, for Custom
  double releaseTime = 0.0;    ///< s of film
};
extern const NodeType kAvalancheReleaseType;

enum class WaterSourceShape : std::uint8_t { Line, Disc };

/// Where fluid enters the scene.
struct WaterSourceNode : NodeData {
  WaterSourceShape shape = WaterSourceShape::Line;
  Vec3d position{};      ///< m, local: one end of the line, or the centre of the disc
  Vec3d end{4, 0, 0};    ///< m, local: the line's other end
  bool onGround = true;  ///< heights count from the terrain under each point
  double radius = 0.5;   ///< m, of the disc
  /// m/s. Of a disc only the direction counts: its speed follows from flow and radius.
  Vec3d velocity{0, 2, 0};
  double flowPerMetre = 0.5;  ///< m2/s, of the line
  double flow = 0.5;          ///< m3/s, of the disc
  FlowMaterialKind material = FlowMaterialKind::Water;
  std::string customMaterial;
  double start = 0.0;  ///< s of film
  double stop = 1e6;   ///< s of film
};
extern const NodeType kWaterSourceType;

enum class FlowSinkShape : std::uint8_t { Plane, Box };

/// Takes particles out: those behind the plane, or those inside the box.
struct FlowSinkNode : NodeData {
  FlowSinkShape shape = FlowSinkShape::Box;
  Vec3d position{};        ///< m, local: a point of the plane, or the box's centre
  Vec3d normal{0, 0, 1};   ///< towards the side that stays
  Vec3d size{10, 10, 10};  ///< m, edges of the box along x, y and z
};
extern const NodeType kFlowSinkType;

enum class RigidMotion : std::uint8_t { Static, Kinematic, Dynamic };

/// Makes a model solid for the flow.
struct RigidBodyNode : NodeData {
  std::string model;  ///< id of a ModelNode
  RigidMotion motion = RigidMotion::Static;
  double density = 2600.0;   ///< kg/m3, of a dynamic body
  double friction = 0.4;     ///< Coulomb's coefficient, against flow, ground and other bodies
  double restitution = 0.2;  ///< share of the normal speed that a collision gives back
  Vec3d velocity{};          ///< m/s at the start, of a dynamic body
  Vec3d spin{};              ///< rad/s at the start, of a dynamic body
};
extern const NodeType kRigidBodyType;

enum class FlowLaw : std::uint8_t { Newtonian, PowerLaw, Bingham, HerschelBulkley, Cross, Frictional };

/// Numbers of a material of one's own; which of them count depends on the law (core/physics/rheology.h).
struct FlowMaterialNode : NodeData {
  FlowLaw law = FlowLaw::Frictional;
  double density = 300.0;            ///< kg/m3
  double viscosity = 5.0;            ///< Pa s: mu, the consistency K [Pa s^n], or Cross' mu_0
  double exponent = 1.0;             ///< n
  double cohesion = 100.0;           ///< Pa: c, or the yield stress of Bingham and Herschel-Bulkley
  double frictionAngleDegrees = 25;  ///< internal friction
  double tensileStrength = 0.0;      ///< Pa
  double viscosityAtSpeed = 1.0;     ///< Pa s: Cross' mu_inf
  double crossFactor = 1.0;          ///< Cross' K, s^n
  double least = 0.0;                ///< Pa s
  double most = 3000.0;              ///< Pa s
};
extern const NodeType kFlowMaterialType;

enum class FlowAccuracy : std::uint8_t { Fast, Accurate };
enum class FlowDensity : std::uint8_t { Summation, Continuity };
enum class FlowPressure : std::uint8_t { StateEquation, Implicit };
enum class GroundGrip : std::uint8_t { Coulomb, NoSlip, FreeSlip };

/// How flow is computed.
struct FlowSettingsNode : NodeData {
  double spacing = 0.5;  ///< m between particles at rest
  FlowAccuracy accuracy = FlowAccuracy::Fast;
  FlowDensity density = FlowDensity::Continuity;
  FlowPressure pressure = FlowPressure::StateEquation;
  double soundSpeed = 0.0;    ///< m/s; 0 = from the depth and speed to be expected
  double longestStep = 0.02;  ///< s
  double smoothing = 0.1;     ///< c of XSPH
  double viscosityCap = 0.0;  ///< Pa s; 0 = by spacing, so that it does not rule the step
  double windDrag = 0.0;      ///< 1/m
  double margin = 50.0;       ///< m, of the domain round sources and ground that flow can reach
  double headroom = 20.0;     ///< m, of the domain above the ground and the sources
  Vec3d domainMin{};          ///< m, local; equal corners = the domain is found
  Vec3d domainMax{};
  bool closed = false;  ///< sides of the domain are smooth walls
  GroundGrip grip = GroundGrip::Coulomb;
  double turbulence = 0.0;  ///< xi, m/s2; 0 = none
  /// Coulomb's coefficients by GroundType.
  double quartz = 0.4, sand = 0.4, soil = 0.35, vegetation = 0.3, rock = 0.4, ice = 0.1, asphalt = 0.4,
         water = 0.05;
};
extern const NodeType kFlowSettingsType;

}  // namespace spin
