// SPDX-FileCopyrightText: 2026 Spindrift contributors
// SPDX-License-Identifier: Apache-2.0
#include "editor/viewport/shape_gizmo.h"

#include <QTest>
#include <cmath>

#include "core/nodes/cover_nodes.h"
#include "core/nodes/flow_nodes.h"
#include "editor/viewport/place_shape.h"
#include "tests/editor/support/test_scene.h"

using namespace spin;

namespace {

/// A node on the hill, seen from the south and above.
struct Fixture {
  template <class T>
  Fixture(const NodeType& type, const T& data) {
    auto scene = std::make_shared<SceneSnapshot>(*test::hillSnapshot());
    SceneNode node = makeNode(type, "node", "Node");
    node.data = std::make_shared<T>(data);
    scene->nodes.push_back(std::move(node));
    context = {scene, 0.0, ViewFrame({{128, -80, 140}, {128, 128, 15}, 45}, 900, 700)};
    gizmo.setNode("node");
  }
  Vec2d pixel(Vec3d place) const { return *context.view.project(place); }
  Vec3d ground(double x, double y) const { return {x, y, groundHeight(*context.scene, x, y)}; }
  std::optional<ShapePoint> point(ShapeHandle handle, std::size_t index = 0) const {
    for (const ShapePoint& p : nodeShape(context, "node").points)
      if (p.handle == handle && p.index == index) return p;
    return std::nullopt;
  }
  /// The values after a handle was dragged to a place.
  ShapeGizmo::Values dragTo(const ShapePoint& from, Vec3d to, DragKeys keys = {}) {
    if (!gizmo.begin(context, pixel(from.place))) return {};
    const ShapeGizmo::Values values = gizmo.drag(context, pixel(to), keys);
    gizmo.end();
    return values;
  }
  ViewportContext context;
  ShapeGizmo gizmo;
};

template <class T>
T valueOf(const ShapeGizmo::Values& values, const char* property) {
  for (const auto& [id, value] : values)
    if (id == property) return std::get<T>(value);
  return {};
}

bool near(Vec3d a, Vec3d b, double by) {
  return length(a - b) < by;
}

AvalancheReleaseNode square() {
  AvalancheReleaseNode release;
  release.outline = {{100, 60}, {150, 60}, {150, 100}, {100, 100}};
  return release;
}

}  // namespace

class ShapeGizmoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nodesWithoutAShapeHaveNone() {
    Fixture f(kSnowfallType, SnowfallNode());
    QVERIFY(nodeShape(f.context, "node").points.empty());
    QVERIFY(nodeShape(f.context, "cube").lines.empty());
    QVERIFY(nodeShape(f.context, "").lines.empty());
    QVERIFY(!f.gizmo.begin(f.context, {450, 350}));
    QVERIFY(!f.gizmo.beginOutline(f.context, {450, 350}));
  }

  /// The outline lies on the ground, corner by corner and between them.
  void theOutlineIsDraped() {
    Fixture f(kAvalancheReleaseType, square());
    const NodeShape shape = nodeShape(f.context, "node");
    QCOMPARE(shape.lines.size(), std::size_t{1});
    QVERIFY(shape.lines[0].points.size() > 40);
    for (const Vec3d& p : shape.lines[0].points)
      QVERIFY(std::abs(p.z - groundHeight(*f.context.scene, p.x, p.y)) < 0.2);
    QVERIFY(f.point(ShapeHandle::Corner, 3));
    QVERIFY(f.point(ShapeHandle::Centre));
    QCOMPARE(shapeNodeAt(f.context, f.pixel(f.ground(125, 60))), std::string("node"));
    QCOMPARE(shapeNodeAt(f.context, f.pixel(f.ground(125, 80))), std::string());
  }

  void aCornerFollowsThePointerOverTheGround() {
    Fixture f(kAvalancheReleaseType, square());
    const auto outline =
        valueOf<PlanPoints>(f.dragTo(*f.point(ShapeHandle::Corner, 1), f.ground(170, 50)), "outline_m");
    QCOMPARE(outline.size(), std::size_t{4});
    QVERIFY(std::hypot(outline[1].x - 170, outline[1].y - 50) < 0.5);
    QVERIFY(outline[0] == square().outline[0]);
    const auto moved =
        valueOf<PlanPoints>(f.dragTo(*f.point(ShapeHandle::Centre), f.ground(135, 80)), "outline_m");
    for (std::size_t k = 0; k < 4; ++k) QVERIFY(std::abs(moved[k].x - square().outline[k].x - 10.0) < 0.5);
    const auto snapped = valueOf<PlanPoints>(
        f.dragTo(*f.point(ShapeHandle::Centre), f.ground(135.3, 80.2), {true, false}), "outline_m");
    QCOMPARE(snapped[0].x, std::round(snapped[0].x));
  }

  /// On a side a corner is put in between, elsewhere behind the last one; beside the terrain nothing happens.
  void cornersAreAdded() {
    Fixture f(kAvalancheReleaseType, square());
    QVERIFY(f.gizmo.beginOutline(f.context, f.pixel(f.ground(125, 60))));
    auto outline = valueOf<PlanPoints>(f.gizmo.drag(f.context, f.pixel(f.ground(125, 50)), {}), "outline_m");
    QCOMPARE(outline.size(), std::size_t{5});
    QVERIFY(std::hypot(outline[1].x - 125, outline[1].y - 50) < 1.0);
    f.gizmo.end();
    QVERIFY(f.gizmo.beginOutline(f.context, f.pixel(f.ground(80, 80))));
    outline = valueOf<PlanPoints>(f.gizmo.drag(f.context, f.pixel(f.ground(80, 80)), {}), "outline_m");
    QCOMPARE(outline.size(), std::size_t{5});
    QVERIFY(std::hypot(outline[4].x - 80, outline[4].y - 80) < 1.0);
    f.gizmo.end();
    QVERIFY(!f.gizmo.beginOutline(f.context, {5, 5}));
  }

  void aCornerIsTakenOut() {
    Fixture f(kAvalancheReleaseType, square());
    const auto values = f.gizmo.withoutCorner(f.context, f.pixel(f.point(ShapeHandle::Corner, 2)->place));
    QVERIFY(values);
    const auto outline = valueOf<PlanPoints>(*values, "outline_m");
    QCOMPARE(outline.size(), std::size_t{3});
    QVERIFY(outline[2] == square().outline[3]);
    QVERIFY(!f.gizmo.withoutCorner(f.context, f.pixel(f.point(ShapeHandle::Centre)->place)));
  }

  /// The ends of a source on the ground go along it and keep their height above it; Shift lifts.
  void endsOfASourceFollowTheGround() {
    WaterSourceNode source;
    source.position = {110, 60, 0.5};
    source.end = {130, 60, 0.5};
    Fixture f(kWaterSourceType, source);
    const auto end = valueOf<Vec3d>(
        f.dragTo(*f.point(ShapeHandle::End, 1), f.ground(150, 80) + Vec3d{0, 0, 0.0}), "end_m");
    QVERIFY(std::hypot(end.x - 150, end.y - 80) < 3.0);
    QCOMPARE(end.z, 0.5);
    const ShapePoint first = *f.point(ShapeHandle::End, 0);
    const auto lifted =
        valueOf<Vec3d>(f.dragTo(first, first.place + Vec3d{0, 0, 10}, {false, true}), "position_m");
    QVERIFY(near(lifted, {110, 60, 10.5}, 0.2));
    const ShapeGizmo::Values both = f.dragTo(*f.point(ShapeHandle::Centre), f.ground(140, 70));
    QVERIFY(std::abs(valueOf<Vec3d>(both, "position_m").x - 130) < 3.0);
    QVERIFY(near(valueOf<Vec3d>(both, "end_m") - valueOf<Vec3d>(both, "position_m"), {20, 0, 0}, 1e-9));
  }

  void theArrowSetsTheVelocity() {
    WaterSourceNode source;
    source.position = {110, 60, 0};
    source.end = {130, 60, 0};
    source.velocity = {0, 4, 0};
    Fixture f(kWaterSourceType, source);
    const ShapePoint tip = *f.point(ShapeHandle::Arrow);
    const double scale = arrowScale(f.context.view, tip.place);
    const auto velocity = valueOf<Vec3d>(f.dragTo(tip, tip.place + Vec3d{3.0 * scale, 0, 0}), "velocity_m_s");
    QVERIFY(near(velocity, {3, 4, 0}, 0.2));
    const auto up =
        valueOf<Vec3d>(f.dragTo(tip, tip.place + Vec3d{0, 0, 2.0 * scale}, {false, true}), "velocity_m_s");
    QVERIFY(near(up, {0, 4, 2}, 0.2));
  }

  void theRimSetsTheRadius() {
    WaterSourceNode source;
    source.shape = WaterSourceShape::Disc;
    source.position = {128, 60, 2};
    source.radius = 4.0;
    source.velocity = {0, 2, 0};
    Fixture f(kWaterSourceType, source);
    const ShapePoint rim = *f.point(ShapeHandle::Rim);
    const Vec3d centre = f.point(ShapeHandle::Centre)->place;
    const double radius = valueOf<double>(f.dragTo(rim, centre + (rim.place - centre) * 1.5), "radius_m");
    QVERIFY(std::abs(radius - 6.0) < 0.1);
    QVERIFY(valueOf<double>(f.dragTo(rim, centre), "radius_m") > 0.0);
  }

  /// A face of a sink's box moves, the one across stays.
  void facesOfABoxMove() {
    FlowSinkNode sink;
    sink.position = {128, 60, 20};
    sink.size = {20, 30, 16};
    Fixture f(kFlowSinkType, sink);
    const ShapePoint right = *f.point(ShapeHandle::Face, 1);
    const ShapeGizmo::Values values = f.dragTo(right, right.place + Vec3d{10, 0, 0});
    QVERIFY(near(valueOf<Vec3d>(values, "size_m"), {30, 30, 16}, 0.1));
    QVERIFY(near(valueOf<Vec3d>(values, "position_m"), {133, 60, 20}, 0.1));
    const ShapePoint bottom = *f.point(ShapeHandle::Face, 4);
    const ShapeGizmo::Values shut = f.dragTo(bottom, bottom.place + Vec3d{0, 0, 60});
    QVERIFY(valueOf<Vec3d>(shut, "size_m").z > 0.0);
  }

  void thePlaneTurns() {
    FlowSinkNode sink;
    sink.shape = FlowSinkShape::Plane;
    sink.position = {128, 60, 20};
    sink.normal = {0, 1, 0};
    Fixture f(kFlowSinkType, sink);
    const ShapePoint tip = *f.point(ShapeHandle::Arrow);
    const double arm = length(tip.place - sink.position);
    const auto normal = valueOf<Vec3d>(f.dragTo(tip, sink.position + Vec3d{arm, 0, 0}), "normal");
    QVERIFY(near(normal, {1, 0, 0}, 0.05));
    const auto moved =
        valueOf<Vec3d>(f.dragTo(*f.point(ShapeHandle::Centre), sink.position + Vec3d{5, 5, 0}), "position_m");
    QVERIFY(near(moved, {133, 65, 20}, 0.2));
  }

  /// A heat source lies on the ground: its middle moves along it, its rim sets the radius.
  void aHeatSourceMovesAndGrows() {
    HeatSourceNode heat;
    heat.position = {110, 70, 3};
    heat.radius = 12;
    Fixture f(kHeatSourceType, heat);
    const NodeShape shape = nodeShape(f.context, "node");
    for (const Vec3d& p : shape.lines.at(0).points)
      QVERIFY(std::abs(std::hypot(p.x - 110, p.y - 70) - 12.0) < 0.1 &&
              std::abs(p.z - groundHeight(*f.context.scene, p.x, p.y)) < 0.2);
    const auto moved =
        valueOf<Vec3d>(f.dragTo(*f.point(ShapeHandle::Centre), f.ground(140, 90)), "position_m");
    QVERIFY(std::hypot(moved.x - 140, moved.y - 90) < 0.5);
    QCOMPARE(moved.z, 3.0);
    const ShapePoint rim = *f.point(ShapeHandle::Rim);
    QVERIFY(std::abs(valueOf<double>(f.dragTo(rim, f.ground(110, 100)), "radius_m") - 30.0) < 0.5);
    QCOMPARE(valueOf<double>(f.dragTo(rim, f.ground(110, 100.2), {true, false}), "radius_m"), 30.0);
    QVERIFY(valueOf<double>(f.dragTo(rim, f.ground(110, 70)), "radius_m") >= 0.1);
    QCOMPARE(shapeNodeAt(f.context, f.pixel(f.ground(110, 58))), std::string("node"));
  }

  /// The arrow points with the wind; its length is the speed. The sun goes over its sphere.
  void windAndSunTurn() {
    WeatherNode weather;
    weather.windSpeed = 10.0;
    weather.windFromDegrees = 270.0;
    weather.sunAzimuthDegrees = 180.0;
    weather.sunElevationDegrees = 30.0;
    Fixture f(kWeatherType, weather);
    QVERIFY2(nodeShape(f.context, "node").quiet, "shown only while selected");
    const Vec3d centre = weatherPlace(f.context);
    const ShapePoint tip = *f.point(ShapeHandle::Wind);
    QVERIFY(tip.place.x > centre.x && std::abs(tip.place.y - centre.y) < 1e-6);
    const ShapeGizmo::Values still = f.dragTo(tip, tip.place);
    QVERIFY(std::abs(valueOf<double>(still, "wind_speed_m_s") - 10.0) < 0.05);
    const double arm = tip.place.x - centre.x;
    const ShapeGizmo::Values turned = f.dragTo(tip, centre + Vec3d{0, -arm, 0}, {});
    QVERIFY(std::abs(valueOf<double>(turned, "wind_from_deg") - 360.0) < 0.5);
    QVERIFY(std::abs(valueOf<double>(turned, "wind_speed_m_s") - 10.0) < 0.1);
    const ShapeGizmo::Values calm = f.dragTo(tip, centre + Vec3d{0.2 * arm, 0, 0});
    QCOMPARE(valueOf<double>(calm, "wind_speed_m_s"), 0.0);
    const ShapeGizmo::Values snapped = f.dragTo(tip, centre + Vec3d{arm, 0.1 * arm, 0}, {true, false});
    QCOMPARE(valueOf<double>(snapped, "wind_from_deg"), 270.0);
    const ShapePoint sun = *f.point(ShapeHandle::Sun);
    const double reach = length(sun.place - centre);
    const ShapeGizmo::Values east = f.dragTo(sun, centre + sunDirection(120.0, 45.0) * reach);
    QVERIFY(std::abs(valueOf<double>(east, "sun_azimuth_deg") - 120.0) < 1.0);
    QVERIFY(std::abs(valueOf<double>(east, "sun_elevation_deg") - 45.0) < 1.0);
    weather.lightByDate = true;
    Fixture dated(kWeatherType, weather);
    QVERIFY(!dated.point(ShapeHandle::Sun));
  }

  /// Eye and target move; a view that stands in the camera is not crossed by its lines.
  void theCameraIsMoved() {
    CameraNode camera;
    camera.position = {60, 20, 40};
    camera.target = {128, 100, 25};
    Fixture f(kCameraType, camera);
    QVERIFY(!nodeShape(f.context, "node").quiet);
    const auto target = valueOf<Vec3d>(
        f.dragTo(*f.point(ShapeHandle::End, 1), f.point(ShapeHandle::End, 1)->place), "target_m");
    QVERIFY(near(target, camera.target, 0.2));
    const ShapePoint eye = *f.point(ShapeHandle::End, 0);
    QVERIFY(near(valueOf<Vec3d>(f.dragTo(eye, {70, 30, 40}), "position_m"), {70, 30, 40}, 0.5));
    QVERIFY(
        near(valueOf<Vec3d>(f.dragTo(eye, {60, 20, 60}, {false, true}), "position_m"), {60, 20, 60}, 0.5));
    f.context.view = ViewFrame({camera.position, camera.target, 45}, 900, 700);
    QVERIFY(nodeShape(f.context, "node").lines.empty());
  }

  void theDomainsFacesMove() {
    FlowSettingsNode flow;
    Fixture found(kFlowSettingsType, flow);
    QVERIFY2(nodeShape(found.context, "node").points.empty(), "equal corners: the domain is found");
    flow.domainMin = {100, 60, 0};
    flow.domainMax = {140, 100, 40};
    Fixture f(kFlowSettingsType, flow);
    const ShapePoint right = *f.point(ShapeHandle::Face, 1);
    const ShapeGizmo::Values values = f.dragTo(right, right.place + Vec3d{20, 0, 0});
    QVERIFY(near(valueOf<Vec3d>(values, "domain_max_m"), {160, 100, 40}, 0.2));
    QVERIFY(near(valueOf<Vec3d>(values, "domain_min_m"), flow.domainMin, 1e-9));
    const ShapeGizmo::Values shut = f.dragTo(right, right.place - Vec3d{80, 0, 0});
    QCOMPARE(valueOf<Vec3d>(shut, "domain_max_m").x, 101.0);
  }

  /// Only what moves by itself has a velocity; at rest there is a handle to begin with.
  void aBodyIsThrown() {
    RigidBodyNode body;
    body.model = "cube";
    Fixture still(kRigidBodyType, body);
    QVERIFY(nodeShape(still.context, "node").points.empty());
    body.motion = RigidMotion::Dynamic;
    Fixture f(kRigidBodyType, body);
    const ShapePoint handle = *f.point(ShapeHandle::Arrow);
    const double scale = arrowScale(f.context.view, handle.place);
    const auto velocity =
        valueOf<Vec3d>(f.dragTo(handle, handle.place + Vec3d{4 * scale, 0, 0}), "velocity_m_s");
    QVERIFY(near(velocity, {4, 0, 0}, 0.4));
    body.velocity = {5, 0, 0};
    Fixture moving(kRigidBodyType, body);
    const ShapePoint tip = *moving.point(ShapeHandle::Arrow);
    QVERIFY(near(valueOf<Vec3d>(moving.dragTo(tip, tip.place), "velocity_m_s"), {5, 0, 0}, 0.2));
  }
};

QTEST_APPLESS_MAIN(ShapeGizmoTest)
#include "shape_gizmo_test.moc"
