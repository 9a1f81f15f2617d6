#include "import/find_file.h"

#include <gtest/gtest.h>

#include "temp_folder.h"

namespace lapidary::import {
namespace {

using Status = FoundFile::Status;

TEST(FindFile, TakesTheNameAsStatedFirst) {
  const TempFolder folder;
  folder.write("a b.mtl", "1");
  folder.write("sub/c.mtl", "2");
  EXPECT_EQ(find_file(folder.path(), "a b.mtl", {}).path, folder.path() / "a b.mtl");
  EXPECT_EQ(find_file(folder.path(), "./sub/c.mtl", {}).path, folder.path() / "sub/c.mtl");
  EXPECT_EQ(find_file(folder.path() / "sub", "../a b.mtl", {}).path, folder.path() / "a b.mtl");
  EXPECT_EQ(find_file({}, (folder.path() / "a b.mtl").string(), {}).path,
            folder.path() / "a b.mtl");
}

TEST(FindFile, ForgivesBackslashesLetterCaseAndForeignFolders) {
  const TempFolder folder;
  folder.write("Sub/Wood.MTL", "1");
  folder.write("stone.mtl", "2");
  const auto wood = folder.path() / "Sub/Wood.MTL";
  EXPECT_EQ(find_file(folder.path(), "Sub\\Wood.MTL", {}).path, wood);
  EXPECT_EQ(find_file(folder.path(), "sub/wood.mtl", {}).path, wood);
  EXPECT_EQ(find_file(folder.path(), ".\\SUB\\wood.mtl", {}).path, wood);
  EXPECT_EQ(find_file(folder.path(), "C:\\Users\\me\\Stone.mtl", {}).path,
            folder.path() / "stone.mtl");
  EXPECT_EQ(find_file(folder.path(), "/home/me/stone.mtl", {}).path, folder.path() / "stone.mtl");
}

TEST(FindFile, DoesNotFindFoldersOrNothing) {
  const TempFolder folder;
  folder.write("sub/a", "1");
  for (const char* stated : {"sub", "none.mtl", "", ".", "..", "/", "sub/"}) {
    EXPECT_EQ(find_file(folder.path(), stated, {}).status, Status::missing) << stated;
  }
  EXPECT_EQ(find_file(folder.path(), std::string(5000, 'x'), {}).status, Status::missing);
}

TEST(FindFile, AsksWhetherAFileMayBeRead) {
  const TempFolder folder;
  folder.write("in/a.obj", "");
  folder.write("in/ok.mtl", "");
  folder.write("secret.mtl", "");
  const auto inside = folder.path() / "in";
  const AllowFile allow = [&](const std::filesystem::path& path) {
    return path.lexically_normal().parent_path() == inside;
  };
  EXPECT_EQ(find_file(inside, "ok.mtl", allow).status, Status::found);
  EXPECT_EQ(find_file(inside, "../secret.mtl", allow).status, Status::refused);
  EXPECT_EQ(find_file(inside, "../none.mtl", allow).status, Status::missing);
}

TEST(FindFile, ResolvesAgainstTheFolder) {
  EXPECT_EQ(resolve("models/car", "..\\maps\\paint.png"), "models/maps/paint.png");
  EXPECT_EQ(resolve("", "a b.png"), "a b.png");
}

}  // namespace
}  // namespace lapidary::import
