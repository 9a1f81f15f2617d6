#include <gmock/gmock.h>

#include "description/leaves.h"
#include "scene_file.h"

namespace lapidary::lua {
namespace {

using description::Mesh;
using testing::ElementsAre;
using testing::HasSubstr;

class MeshNode : public SceneFile {
 protected:
  MeshNode() {
    write("scene/tri.obj", "mtllib tri.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl glow\nf 1 2 3\n");
    write("scene/tri.mtl", "newmtl glow\nKe 2 2 2\n");
  }
  const Mesh& mesh_of(const description::ObjectPtr& object) {
    return std::get<Mesh>(object->content);
  }
};

TEST_F(MeshNode, ComesFromAFileStandingUpright) {
  const auto loaded = load("return { mesh 'tri.obj', mesh { 'tri.obj', up = 'z' } }");
  const auto& objects = loaded.scene.objects;
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(mesh_of(objects[0]).triangles->triangles.size(), 1u);
  EXPECT_EQ(objects[0]->parent_from_object().point({0, 1, 0}), Vec3d(0, 0, 1));
  EXPECT_TRUE(objects[1]->parent_from_object().is_identity());
  EXPECT_EQ(objects[0]->name(), "tri");
  EXPECT_EQ(objects[0]->where.location().line, 1);
  EXPECT_TRUE(has_light(loaded.scene));
}

TEST_F(MeshNode, IsSharedByItsUses) {
  const auto loaded = load("return { mesh 'tri.obj', mesh 'tri.obj':translate(1, 0, 0) }");
  EXPECT_EQ(mesh_of(loaded.scene.objects[0]).triangles, mesh_of(loaded.scene.objects[1]).triangles);
}

TEST_F(MeshNode, WearsWhatItIsTold) {
  const auto loaded = load(
      "return { mesh 'tri.obj':material(matte 'red'), mesh { 'tri.obj', material = matte 'red' } "
      "}");
  for (const auto& object : loaded.scene.objects) {
    EXPECT_TRUE(mesh_of(object).materials.empty());
    EXPECT_TRUE(object->material);
  }
  EXPECT_FALSE(has_light(loaded.scene));
}

TEST_F(MeshNode, ComesFromLists) {
  const auto loaded = load(R"(return mesh {
    vertices = { {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0} },
    faces = { {1, 2, 3, 4} },
    uvs = { {0, 0}, {1, 0}, {1, 1}, {0, 1} },
  })");
  const auto& mesh = *mesh_of(loaded.scene.objects[0]).triangles;
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
  EXPECT_TRUE(loaded.scene.objects[0]->parent_from_object().is_identity());
}

TEST_F(MeshNode, RefusesListsThatDoNotFit) {
  constexpr auto vertices = "vertices = {{0,0,0},{1,0,0},{0,1,0}}, ";
  const auto error = [&](std::string_view rest) {
    return error_of("return mesh { " + std::string(vertices) + std::string(rest) + " }");
  };
  EXPECT_THAT(error("faces = {{1, 2, 4}}"),
              HasSubstr("faces[1][3] of mesh refers to vertex 4 of 3"));
  EXPECT_THAT(error("faces = {{0, 1, 2}}"), HasSubstr("refers to vertex 0"));
  EXPECT_THAT(error("faces = {{-1, 1, 2}}"), HasSubstr("too large or too small"));
  EXPECT_THAT(error("faces = {{1, 2}}"), HasSubstr("has 2 corners; a face needs three"));
  EXPECT_THAT(error("faces = {{1, 1, 1}}"), HasSubstr("leaves no triangle with an area"));
  EXPECT_THAT(error("faces = {}"), HasSubstr("needs either 'file', or 'vertices' and 'faces'"));
  EXPECT_THAT(error("faces = {{1, 2, 3}}, normals = {{0, 0, 1}}"),
              HasSubstr("normals of mesh must have one entry for each vertex: 3, not 1"));
  EXPECT_THAT(error("faces = {{1, 2, 3}}, file = 'tri.obj'"), HasSubstr("not both"));
}

TEST_F(MeshNode, RefusesFilesThatAreNone) {
  EXPECT_THAT(error_of("\nreturn mesh 'trii.obj'"),
              testing::AllOf(testing::StartsWith("main.lua:2: "),
                             HasSubstr("does not exist: 'trii.obj' (did you mean 'tri.obj'?)")));
  write("scene/empty.obj", "");
  EXPECT_THAT(error_of("return mesh 'empty.obj'"), HasSubstr("empty.obj"));
  write("scene/a.txt", "v 0 0 0");
  EXPECT_THAT(error_of("return mesh 'a.txt'"), HasSubstr("is of no kind of mesh that can be read"));
}

TEST_F(MeshNode, CannotSmuggleFilesThroughItsMaterials) {
  write("outside/glow.mtl", "newmtl glow\nKe 2 2 2\n");
  write("scene/bad.obj",
        "mtllib ../outside/glow.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl glow\nf 1 2 3\n");
  WarningLog log;
  options_.warnings = &log;
  EXPECT_FALSE(has_light(load("return mesh 'bad.obj'").scene));
  EXPECT_FALSE(log.take().empty());
}

TEST_F(MeshNode, IsReadOnceForAllScenesThatFollowEachOther) {
  import::SceneFiles kept;
  options_.kept = &kept;
  const auto triangles_of = [&](std::string_view text) {
    return mesh_of(load(text).scene.objects[0]).triangles;
  };
  const auto first = triangles_of("return { mesh 'tri.obj' }");
  write("scene/tri.obj", "no mesh any more");
  EXPECT_EQ(triangles_of("return { mesh 'tri.obj':translate(1, 0, 0) }"), first);
  // What one scene does not read the next one reads anew.
  load("return { sphere {} }");
  EXPECT_EQ(triangles_of("return { mesh { vertices = {{0,0,0}, {1,0,0}, {0,1,0}}, faces = "
                         "{{1,2,3}} } }")
                ->triangles.size(),
            1u);
  EXPECT_THAT(error_of("return { mesh 'tri.obj' }"), HasSubstr("tri.obj"));
}

TEST_F(MeshNode, IsNotedForEachSceneThatUsesIt) {
  import::SceneFiles kept;
  options_.kept = &kept;
  std::vector<std::vector<FileRecord>> noted;
  for (const char* text : {"return { mesh 'tri.obj' }", "return { mesh 'tri.obj' }", "return {}"}) {
    InputFiles files;
    options_.files = &files;
    load(text);
    noted.push_back(files.relative_to(folder_ / "scene"));
  }
  const auto names = [](const std::vector<FileRecord>& records) {
    std::vector<std::string> all;
    for (const FileRecord& record : records) all.push_back(record.name);
    return all;
  };
  EXPECT_THAT(names(noted[0]), ElementsAre("main.lua", "tri.mtl", "tri.obj"));
  EXPECT_EQ(noted[1], noted[0]);
  EXPECT_THAT(names(noted[2]), ElementsAre("main.lua"));
}

}  // namespace
}  // namespace lapidary::lua
