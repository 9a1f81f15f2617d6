#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "lua/load_scene.h"

namespace lapidary::lua {

/// A folder of scene files, gone with the test.
class SceneFile : public testing::Test {
 protected:
  SceneFile() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              (std::string("lapidary-lua-") + test->name() + "-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_ / "scene");
    options_.print = [this](std::string_view line) { printed_.emplace_back(line); };
  }
  ~SceneFile() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  /// Writes a file; `name` is relative to the folder above the scene's.
  std::filesystem::path write(const std::string& name, std::string_view text) const {
    const auto file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  LoadedScene load(std::string_view text) {
    return load_scene(write("scene/main.lua", text), options_);
  }
  /// The message of the error that loading ends with, from "main.lua" on.
  std::string error_of(std::string_view text) {
    try {
      load(text);
    } catch (const Error& error) {
      const std::string message = error.what();
      const std::string place = (folder_ / "scene").string() + "/";
      return message.starts_with(place) ? message.substr(place.size()) : message;
    }
    return "no error";
  }
  /// What a chunk prints.
  std::vector<std::string> output_of(std::string_view text) {
    printed_.clear();
    load(std::string(text) + "\nreturn {}");
    return printed_;
  }

  std::filesystem::path folder_;
  LoadOptions options_;
  std::vector<std::string> printed_;
};

}  // namespace lapidary::lua
