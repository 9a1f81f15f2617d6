#include "description/nodes.h"

#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "construct.h"

namespace lapidary::description {
namespace {

using testing::HasSubstr;

class NodeTest : public testing::Test {
 protected:
  template <typename T>
  T solid(std::string_view name, std::string_view literal) {
    return std::get<T>(std::get<geometry::Solid>(make_.object(name, literal)->content));
  }
  Constructor make_;
};

TEST_F(NodeTest, EveryParameterIsDocumented) {
  std::set<std::string> names;
  for (const schema::NodeKind& kind : node_kinds()) {
    EXPECT_TRUE(names.insert(kind.info.name).second) << kind.info.name << " is declared twice";
    EXPECT_TRUE(kind.info.doc.ends_with('.')) << kind.info.name;
    EXPECT_FALSE(kind.info.section.empty()) << kind.info.name;
    std::set<std::string> parameters;
    for (const auto& p : kind.info.parameters) {
      EXPECT_TRUE(parameters.insert(p.name).second) << kind.info.name << "." << p.name;
      EXPECT_TRUE(p.doc.ends_with('.')) << kind.info.name << "." << p.name;
    }
  }
}

TEST_F(NodeTest, ShapesMeanWhatTheySay) {
  const auto ball = solid<geometry::Sphere>("sphere", "{center = {1, 2, 3}, radius = 4}");
  EXPECT_EQ(ball.center, Vec3d(1, 2, 3));
  EXPECT_EQ(ball.radius, 4);
  const auto box = solid<geometry::Box>("box", "{size = {2, 4, 6}, center = {1, 0, 0}}");
  EXPECT_EQ(box.min, Vec3d(0, -2, -3));
  EXPECT_EQ(box.max, Vec3d(2, 2, 3));
  const auto corners = solid<geometry::Box>("box", "{min = {0, 0, 0}, max = {1, 2, 3}}");
  EXPECT_EQ(corners.max, Vec3d(1, 2, 3));
  EXPECT_EQ(solid<geometry::HalfSpace>("plane", "{}").normal, Vec3d(0, 0, 1));
  EXPECT_EQ(solid<geometry::Cylinder>("cylinder", "{to = {1, 0, 0}}").to, Vec3d(1, 0, 0));
  const auto frustum = solid<geometry::Cone>("cone", "{to = {1, 0, 0}, radius = 2, radius2 = 3}");
  EXPECT_EQ(frustum.to, Vec3d(1, 0, 0));
  EXPECT_EQ(frustum.radius2, 3);
  EXPECT_EQ(solid<geometry::Cone>("cone", "{}").radius2, 0);
  const auto ring = solid<geometry::Torus>("torus", "{axis = {0, 3, 0}, major_radius = 2}");
  EXPECT_EQ(ring.axis, Vec3d(0, 1, 0));
  EXPECT_EQ(ring.major_radius, 2);
}

TEST_F(NodeTest, SuperellipsoidsAreConvex) {
  const auto pill = solid<geometry::Superellipsoid>(
      "superellipsoid", "{center = {1, 2, 3}, radii = {4, 5, 6}, e = 0.5, n = 2}");
  EXPECT_EQ(pill.center, Vec3d(1, 2, 3));
  EXPECT_EQ(pill.radii, Vec3d(4, 5, 6));
  EXPECT_EQ(pill.e, 0.5);
  EXPECT_EQ(pill.n, 2);
  for (const std::string name : {"e", "n"}) {
    EXPECT_THAT(make_.error_of("superellipsoid", "{" + name + " = 2.5}"),
                HasSubstr(name + " of superellipsoid must be at most 2: beyond, the solid is not "
                                 "convex and cannot be met exactly"));
    EXPECT_THAT(make_.error_of("superellipsoid", "{" + name + " = 0}"),
                HasSubstr("greater than 0"));
  }
}

TEST_F(NodeTest, AQuadricHasTheCoefficientsGiven) {
  const auto q = solid<geometry::Quadric>(
      "quadric", "{squares = {1, 2, 3}, products = {4, 5, 6}, linear = {7, 8, 9}, constant = 10}");
  // At (1, 10, 100) the digits of the value say which coefficient went where.
  EXPECT_EQ(value_at(*q.form, {1, 10, 100}), 1 + 200 + 30000 + 40 + 500 + 6000 + 7 + 80 + 900 + 10);
  EXPECT_EQ(solid<geometry::Quadric>("quadric", "{}").form->constant, -1);
  EXPECT_THAT(make_.error_of("quadric", "{squares = {0, 0, 0}}"),
              HasSubstr("squares of quadric must not be zero"));
}

TEST_F(NodeTest, AnEllipsoidIsAStretchedBall) {
  const auto object = make_.object("ellipsoid", "{center = {1, 2, 3}, radii = {4, 5, 6}}");
  const auto ball = std::get<geometry::Sphere>(std::get<geometry::Solid>(object->content));
  EXPECT_EQ(ball.radius, 1);
  EXPECT_EQ(object->parent_from_object().point({0, 0, 1}), Vec3d(1, 2, 9));
  EXPECT_EQ(object->parent_from_object().point({1, 0, 0}), Vec3d(5, 2, 3));
}

TEST_F(NodeTest, PolyhedraComeFromPlanesOrCorners) {
  const auto corner = solid<geometry::Polyhedron>(
      "polyhedron",
      "{planes = {{normal = {-1, 0, 0}}, {normal = {0, -1, 0}}, {normal = {0, 0, -1}},"
      " {point = {1, 0, 0}, normal = {1, 1, 1}}}}");
  EXPECT_EQ(corner.face_count(), 4u);
  EXPECT_NEAR(corner.volume(), 1.0 / 6.0, 1e-15);
  const auto hull = solid<geometry::Polyhedron>(
      "polyhedron", "{vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}}}");
  EXPECT_NEAR(hull.volume(), 1.0 / 6.0, 1e-15);
  EXPECT_THAT(make_.error_of("polyhedron", "{}"), HasSubstr("either 'planes' or 'vertices'"));
  EXPECT_THAT(make_.error_of("polyhedron", "{vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}"),
              HasSubstr("lie in one plane"));
  EXPECT_THAT(make_.error_of("polyhedron",
                             "{planes = {{normal = {0, 0, 1}},"
                             " {point = {0, 0, 1}, normal = {0, 0, -1}}}}"),
              HasSubstr("planes of polyhedron leave nothing between them"));
  EXPECT_THAT(make_.error_of("polyhedron", "{planes = {{normal = {0, 0, 0}}}}"),
              HasSubstr("planes[1].normal of polyhedron must not be zero"));
  EXPECT_THAT(make_.error_of("polyhedron", "{planes = {{nromal = {0, 0, 1}}}}"),
              HasSubstr("did you mean 'normal'?"));
}

TEST_F(NodeTest, PrismsAreDrawnOutPolygons) {
  const auto plate =
      solid<geometry::Prism>("prism",
                             "{points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, height = 2,"
                             " holes = {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}}}");
  EXPECT_NEAR(plate.volume(), 30.0, 1e-13);
  const auto pyramid = solid<geometry::Prism>(
      "prism", "{points = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, height = 3, scale = 0}");
  EXPECT_NEAR(pyramid.volume(), 4.0, 1e-14);
  EXPECT_EQ(make_.error_of("prism", "{points = {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}"),
            "scene.lua:7: the edge from points[3] to points[4] touches that from points[1] to "
            "points[2] (outlines must not cross or touch themselves or each other)");
  EXPECT_THAT(make_.error_of("prism", "{points = {{0, 0}, {1, 1}}}"), HasSubstr("needs three"));
  EXPECT_THAT(make_.error_of("prism", "{height = 2}"), HasSubstr("points"));
  EXPECT_THAT(make_.error_of("prism", "{points = {{0, 0}, {1, 0}, {0, 1}}, height = 0}"),
              HasSubstr("greater than 0"));
}

TEST_F(NodeTest, LathesAreTurnedPolygons) {
  const auto ring = solid<geometry::Lathe>(
      "lathe",
      "{points = {{1, 0}, {2, 0}, {2, 1}, {1, 1}}, holes = {{{1.25, 0.25}, {1.75, 0.25}, "
      "{1.75, 0.75}, {1.25, 0.75}}}}");
  EXPECT_NEAR(ring.volume(), 2 * pi * 1.5 * 0.75, 1e-14);
  const auto part =
      solid<geometry::Lathe>("lathe", "{points = {{0, 0}, {3, 0}, {0, 3}}, angle = 60}");
  EXPECT_NEAR(part.volume(), 9 * pi / 6, 1e-14);
  EXPECT_EQ(make_.error_of("lathe", "{points = {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}"),
            "scene.lua:7: the edge from points[3] to points[4] touches that from points[1] to "
            "points[2] (outlines must not cross or touch themselves or each other)");
  EXPECT_THAT(make_.error_of("lathe", "{points = {{0, 0}, {1, 0}, {-1, 1}}}"),
              HasSubstr("points[3] has the radius -1"));
  EXPECT_THAT(make_.error_of("lathe", "{points = {{0, 0}, {1, 0}, {0, 1}}, angle = 0}"),
              HasSubstr("angle"));
}

TEST_F(NodeTest, AliasesGoByTheirOwnNames) {
  EXPECT_EQ(make_.error_of("plane", "{nromal = {0, 0, 1}}"),
            "scene.lua:7: unknown parameter 'nromal' of plane (did you mean 'normal'?)");
  EXPECT_THAT(make_.error_of("plane", "5"), HasSubstr("write plane { point = ... }"));
}

TEST_F(NodeTest, ShapesWithoutExtentAreRefused) {
  EXPECT_THAT(make_.error_of("sphere", "{radius = 0}"), HasSubstr("must be greater than 0, not 0"));
  EXPECT_THAT(make_.error_of("cylinder", "{from = {1, 1, 1}, to = {1, 1, 1}}"),
              HasSubstr("to of cylinder must differ from 'from'"));
  EXPECT_THAT(make_.error_of("cone", "{from = {0, 0, 1}}"), HasSubstr("must differ from 'from'"));
  EXPECT_THAT(make_.error_of("cone", "{radius = 0}"),
              HasSubstr("radius of cone and 'radius2' must not both be 0"));
  EXPECT_THAT(make_.error_of("cone", "{radius2 = -1}"), HasSubstr("radius2 of cone"));
  EXPECT_THAT(make_.error_of("torus", "{axis = {0, 0, 0}}"),
              HasSubstr("axis of torus must not be zero"));
  EXPECT_THAT(make_.error_of("torus", "{minor_radius = 0}"), HasSubstr("minor_radius of torus"));
  EXPECT_THAT(make_.error_of("ellipsoid", "{radii = {1, 0, 1}}"),
              HasSubstr("radii.y of ellipsoid"));
  EXPECT_THAT(make_.error_of("plane", "{normal = {0, 0, 0}}"),
              HasSubstr("normal of plane must not be zero"));
  EXPECT_THAT(make_.error_of("box", "{min = {0, 0, 0}, max = {1, 0, 1}}"),
              HasSubstr("leaves the box no extent along y"));
  EXPECT_THAT(make_.error_of("box", "{size = {1, 1, 1e-30}, center = {0, 0, 1}}"),
              HasSubstr("size of box leaves the box no extent along z"));
  EXPECT_THAT(make_.error_of("box", "{size = {1, -1, 1}}"), HasSubstr("size.y of box"));
  EXPECT_THAT(make_.error_of("box", "{}"), HasSubstr("needs either 'min' and 'max', or 'size'"));
  EXPECT_THAT(make_.error_of("box", "{size = {1, 1, 1}, min = {0, 0, 0}}"),
              HasSubstr("needs either"));
  EXPECT_THAT(make_.error_of("rectangle", "{size = 0}"), HasSubstr("greater than 0"));
  EXPECT_THAT(make_.error_of("rectangle", "{corner = {0,0,0}, edge_u = {1,0,0}, edge_v = {2,0,0}}"),
              HasSubstr("parallel to 'edge_u'"));
  EXPECT_THAT(make_.error_of("disk", "{center = {1, 1, 1}, at = {1, 1, 1}}"),
              HasSubstr("at of disk must differ from 'center'"));
}

TEST_F(NodeTest, RectanglesFaceWhereTheyAreTold) {
  for (const char* normal :
       {"{1, 2, 3}", "{0, 0, -1}", "{0, 0, 1}", "{-1, 0, 0}", "{0, 1e-12, 1}"}) {
    const auto object =
        make_.object("rectangle", std::string("{size = {3, 2}, normal = ") + normal + "}");
    const auto& r = std::get<geometry::Rectangle>(std::get<geometry::Sheet>(object->content));
    const auto n = make_.object("plane", std::string("{normal = ") + normal + "}");
    const Vec3d wanted =
        normalize(std::get<geometry::HalfSpace>(std::get<geometry::Solid>(n->content)).normal);
    EXPECT_LT(length(normalize(cross(r.edge_u, r.edge_v)) - wanted), 1e-9) << normal;
    EXPECT_NEAR(length(r.edge_u), 3, 1e-12);
    EXPECT_NEAR(length(r.edge_v), 2, 1e-12);
    EXPECT_LT(length(r.corner + (r.edge_u + r.edge_v) * 0.5), 1e-12);
  }
}

TEST_F(NodeTest, GlassByNameOrIndex) {
  EXPECT_TRUE((make_.model<Glass, Material>("glass", "'N-BK7'").index.dispersive()));
  EXPECT_EQ((make_.model<Glass, Material>("glass", "1.7").index.at(500.0)), 1.7);
  EXPECT_EQ((make_.model<Glass, Material>("glass", "{}").index.at(500.0)), 1.5);
  const auto frosted = make_.model<Glass, Material>("glass", "{'diamond', roughness = 0.3}");
  EXPECT_EQ(frosted.roughness, 0.3);
  EXPECT_GT(frosted.index.at(500.0), 2.3);
  EXPECT_THAT(make_.error_of("glass", "'N-BK8'"), HasSubstr("did you mean 'N-BK7'?"));
  EXPECT_THAT(make_.error_of("glass", "'treacle'"), HasSubstr("known are "));
  EXPECT_THAT(make_.error_of("glass", "0"), HasSubstr("must be from 1 to 10"));
}

TEST_F(NodeTest, MetalByNameOrColor) {
  using Surface = std::variant<ConductorIndex, texture::Color>;
  const auto gold = make_.model<Metal, Material>("metal", "'gold'");
  EXPECT_TRUE(std::holds_alternative<ConductorIndex>(gold.surface));
  const Surface pink = make_.model<Metal, Material>("metal", "{color = 'pink'}").surface;
  EXPECT_TRUE(std::holds_alternative<texture::Color>(pink));
  EXPECT_THAT(make_.error_of("metal", "'gld'"), HasSubstr("did you mean 'gold'?"));
  EXPECT_THAT(make_.error_of("metal", "{'gold', color = 'pink'}"), HasSubstr("takes one of"));
  EXPECT_THAT(make_.error_of("metal", "{roughness = 2}"), HasSubstr("from 0 to 1"));
}

TEST_F(NodeTest, CamerasCheckTheirView) {
  const auto camera = make_.model<Perspective, Camera>(
      "perspective",
      "{from = {0, -4, 0}, at = {0, 0, 0}, fov = 30, fov_axis = 'x', focus = {1, 2, 3}}");
  EXPECT_EQ(camera.view.from, Vec3d(0, -4, 0));
  EXPECT_EQ(camera.fov_axis, FovAxis::x);
  EXPECT_EQ(camera.focus_distance, 6);
  EXPECT_FALSE((make_.model<Perspective, Camera>("perspective", "{}").focus_distance));
  EXPECT_EQ((make_.model<Perspective, Camera>("perspective", "{focus = 3}").focus_distance), 3);
  EXPECT_EQ((make_.model<Orthographic, Camera>("orthographic", "{size = 7}").size), 7);

  EXPECT_THAT(make_.error_of("perspective", "{from = {1, 1, 1}, at = {1, 1, 1}}"),
              HasSubstr("at of perspective must differ from 'from'"));
  EXPECT_THAT(make_.error_of("perspective", "{from = {0, 0, 5}, at = {0, 0, 0}}"),
              HasSubstr("up of perspective must not be parallel to the view"));
  EXPECT_THAT(make_.error_of("perspective", "{up = {0, 0, 0}}"), HasSubstr("must not be zero"));
  EXPECT_THAT(make_.error_of("perspective", "{fov = 180}"),
              HasSubstr("must be greater than 0 and less than 180"));
  EXPECT_THAT(make_.error_of("perspective", "{focus = {0, -50, 0}}"),
              HasSubstr("focus of perspective is a point behind the camera"));
  EXPECT_THAT(make_.error_of("perspective", "{focus = 0}"), HasSubstr("greater than 0"));
}

TEST_F(NodeTest, LensesAreShapedShiftedAndTilted) {
  const auto lens = make_.model<Perspective, Camera>(
      "perspective",
      "{blades = 6, blade_rotation = 15, anamorphic = 2, shift = {y = 0.25}, tilt = {10, -20}}");
  EXPECT_EQ(lens.blades, 6);
  EXPECT_EQ(lens.blade_rotation, 15);
  EXPECT_EQ(lens.anamorphic, 2);
  EXPECT_EQ(lens.shift, Vec2d({0, 0.25}));
  EXPECT_EQ(lens.tilt, Vec2d({10, -20}));
  // The plane that leans by 45 degrees through a point 1 above the axis meets it 1 before that.
  const auto focused = make_.model<Perspective, Camera>(
      "perspective", "{from = {0, -4, 0}, focus = {0.5, 2, 1}, tilt = {x = 45}}");
  EXPECT_NEAR(focused.focus_distance.value(), 5, 1e-14);

  EXPECT_THAT(make_.error_of("perspective", "{blades = 2}"),
              HasSubstr("blades of perspective must be at least 3, not 2"));
  EXPECT_THAT(make_.error_of("perspective", "{blades = 1}"), HasSubstr("at least 3, not 1"));
  EXPECT_THAT(make_.error_of("perspective", "{blades = -3}"), HasSubstr("from 0 to 1000"));
  EXPECT_THAT(make_.error_of("perspective", "{tilt = {90, 0}}"),
              HasSubstr("tilt.x of perspective must be greater than -90 and less than 90"));
  EXPECT_THAT(make_.error_of("perspective", "{shift = 1}"), HasSubstr("must be {x, y}, not 1"));
  EXPECT_THAT(make_.error_of("perspective", "{shift = {z = 1}}"), HasSubstr("one of x, y"));
  EXPECT_THAT(make_.error_of("perspective", "{anamorphic = 0}"), HasSubstr("from 0.01 to 100"));
  EXPECT_THAT(
      make_.error_of("perspective", "{from = {0, -4, 0}, focus = {0, 0, 3}, tilt = {x = 80}}"),
      HasSubstr("passes behind the camera"));
}

TEST_F(NodeTest, CamerasThatSeeAroundCheckHowFar) {
  const auto around = make_.model<Panorama, Camera>(
      "panorama", "{from = {0, 0, 1}, at = {0, 1, 1}, longitude = {-90, 45}, latitude = {0, 90}}");
  EXPECT_EQ(around.view.at, Vec3d(0, 1, 1));
  EXPECT_EQ(around.longitude, Vec2d({-90, 45}));
  EXPECT_EQ(around.latitude, Vec2d({0, 90}));
  const auto eye = make_.model<Fisheye, Camera>("fisheye", "{fov = 360, mapping = 'equisolid'}");
  EXPECT_EQ(eye.fov, 360);
  EXPECT_EQ(eye.mapping, FisheyeMapping::equisolid);

  EXPECT_THAT(make_.error_of("panorama", "{longitude = {-200, 200}}"),
              HasSubstr("longitude of panorama must span at most 360 degrees, not 400"));
  EXPECT_THAT(make_.error_of("panorama", "{latitude = {10, -10}}"),
              HasSubstr("must ascend, not go from 10 to -10"));
  EXPECT_THAT(make_.error_of("panorama", "{latitude = {-90, 91}}"), HasSubstr("from -90 to 90"));
  EXPECT_THAT(make_.error_of("fisheye", "{fov = 361}"),
              HasSubstr("fov of fisheye must be greater than 0 and at most 360"));
  EXPECT_THAT(make_.error_of("fisheye", "{fov = 360, mapping = 'stereographic'}"),
              HasSubstr("less than 360 where the mapping is stereographic"));
  EXPECT_THAT(make_.error_of("fisheye", "{fov = 200, mapping = 'orthographic'}"),
              HasSubstr("at most 180 where the mapping is orthographic, not 200"));
  EXPECT_THAT(make_.error_of("fisheye", "{mapping = 'equidistand'}"), HasSubstr("equidistant"));
}

TEST_F(NodeTest, CamerasMoveWhileTheShutterIsOpen) {
  const auto still = make_.make<Camera>("fisheye", "{}");
  EXPECT_FALSE(still->view_at_end);
  EXPECT_EQ(still->shutter.open, 0);
  EXPECT_EQ(still->shutter.close, 1);
  const auto moving =
      make_.make<Camera>("perspective",
                         "{from = {0, -4, 0}, at = {1, 0, 0}, motion = {from = {2, -4, 0}}, "
                         "shutter = 0.5}");
  EXPECT_EQ(moving->view_at_end.value().from, Vec3d(2, -4, 0));
  EXPECT_EQ(moving->view_at_end.value().at, Vec3d(1, 0, 0));
  EXPECT_EQ(moving->shutter.open, 0);
  EXPECT_EQ(moving->shutter.close, 0.5);
  EXPECT_EQ(make_.make<Camera>("orthographic", "{shutter = {0.25, 0.75}}")->shutter.open, 0.25);

  EXPECT_THAT(make_.error_of("perspective", "{shutter = {0.5, 0.25}}"),
              HasSubstr("shutter of perspective closes at 0.25, before it opens at 0.5"));
  EXPECT_THAT(make_.error_of("perspective", "{shutter = 1.5}"), HasSubstr("from 0 to 1"));
  EXPECT_THAT(make_.error_of("perspective", "{shutter = 'slow'}"),
              HasSubstr("must be a number or {open, close}, not the string 'slow'"));
  EXPECT_THAT(make_.error_of("perspective", "{at = {0, 0, 0}, motion = {from = {0, 0, 0}}}"),
              HasSubstr("motion.at of perspective must differ from 'from'"));
  EXPECT_THAT(make_.error_of("perspective", "{motion = {form = {1, 2, 3}}}"),
              HasSubstr("did you mean 'from'?"));
}

TEST_F(NodeTest, ScenesSortTheirParts) {
  const schema::Node ball = make_.node("sphere", "{}");
  const schema::Node lamp = make_.node("sphere_light", "{power = 1}");
  const schema::Node point = make_.node("point_light", "{power = 1}");
  const schema::Value inner[] = {schema::Value(ball)};
  const schema::Value nested[] = {schema::Value(ball), make_.arena().table(inner, {})};
  const schema::Value lights[] = {schema::Value(lamp), schema::Value(point)};
  const schema::Field fields[] = {{"lights", make_.arena().table(lights, {})},
                                  {"objects", make_.arena().table(nested, {})},
                                  {"unit", schema::Value(std::string_view("mm"))}};
  const auto scene = make_.node("scene", make_.arena().table({}, fields)).as<SceneDescription>();
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->objects.size(), 3u);
  EXPECT_EQ(scene->lights.size(), 1u);
  EXPECT_EQ(scene->metres_per_unit, 1e-3);
  EXPECT_FALSE(scene->camera);
  EXPECT_TRUE(has_light(*scene));
  EXPECT_EQ(scene->where.location().line, 7);
  EXPECT_FALSE(has_light(*make_.make<SceneDescription>("scene", "{}")));

  const schema::Field dark[] = {{"lights", schema::Value(ball)}};
  EXPECT_THAT(Constructor::message_of([&] { make_.node("scene", make_.arena().table({}, dark)); }),
              HasSubstr("lights of scene is a sphere that gives no light"));
  EXPECT_THAT(make_.error_of("scene", "{unit = 'furlong'}"), HasSubstr("must be one of m, dm, cm"));
  EXPECT_THAT(make_.error_of("scene", "{objects = {1}}"),
              HasSubstr("objects[1] of scene must be an object, not 1"));
  EXPECT_THAT(make_.error_of("scene", "{camera = 1}"), HasSubstr("must be a camera, not 1"));
}

}  // namespace
}  // namespace lapidary::description
