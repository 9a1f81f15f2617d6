// Files that other people made, kept outside the project: each is a mesh or one clear error.

#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <gtest/gtest.h>

#include "import/obj.h"
#include "obj_test_support.h"

namespace lapidary::import {
namespace {

namespace fs = std::filesystem;

const fs::path shared_data = LAPIDARY_SHARED_DATA;

std::vector<fs::path> files_ending_in(const std::string& extension) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(shared_data)) {
    if (entry.path().extension() == extension) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// Triangles per file, of files whose triangles the manifest counts.
std::map<std::string, std::size_t> manifest() {
  std::map<std::string, std::size_t> result;
  std::ifstream file(shared_data / "MANIFEST.tsv");
  std::size_t name_column = 0, triangles_column = 0;
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, '\t');) cells.push_back(cell);
    if (triangles_column == 0) {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i] == "file") name_column = i;
        if (cells[i] == "triangles") triangles_column = i;
      }
      continue;
    }
    if (cells.size() <= triangles_column || cells[triangles_column].empty()) continue;
    result[cells[name_column]] = std::stoul(cells[triangles_column]);
  }
  return result;
}

std::size_t dropped_triangles(WarningLog& log) {
  for (const Warning& warning : log.take()) {
    if (warning.text.find("triangles of zero area") != std::string::npos) {
      return std::stoul(warning.text);
    }
  }
  return 0;
}

TEST(SharedData, EveryObjFileIsAMeshOrOneError) {
  if (!fs::exists(shared_data)) GTEST_SKIP() << "there is no " << shared_data;
  const auto expected = manifest();
  const auto start = std::chrono::steady_clock::now();
  std::size_t meshes = 0, counted = 0;
  for (const fs::path& file : files_ending_in(".obj")) {
    SCOPED_TRACE(file);
    WarningLog log;
    try {
      const ObjScene scene = read_obj(file, {.warnings = &log});
      expect_sound(scene);
      ++meshes;
      const auto entry = expected.find(fs::relative(file, shared_data).string());
      if (entry == expected.end()) continue;
      EXPECT_EQ(scene.mesh.triangles.size() + dropped_triangles(log), entry->second);
      ++counted;
    } catch (const Error& error) {
      EXPECT_EQ(error.where().file, file.string());
      EXPECT_TRUE(file.string().find("nasty") != std::string::npos) << error.what();
    }
  }
  EXPECT_GT(meshes, 60);
  EXPECT_GT(counted, 60);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(100));
}

TEST(SharedData, EveryMtlFileIsMaterialsOrOneError) {
  if (!fs::exists(shared_data)) GTEST_SKIP() << "there is no " << shared_data;
  std::size_t materials = 0;
  for (const fs::path& file : files_ending_in(".mtl")) {
    SCOPED_TRACE(file);
    try {
      WarningLog log;
      materials += read_mtl(file, &log).size();
    } catch (const Error& error) {
      EXPECT_EQ(error.where().file, file.string());
    }
  }
  EXPECT_GT(materials, 40);
}

}  // namespace
}  // namespace lapidary::import
