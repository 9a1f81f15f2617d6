#pragma once

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "image/image_io.h"

namespace lapidary::image::test {

namespace fs = std::filesystem;

/// A folder of this test's own, removed with everything in it.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "lapidary-image-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string path() const { return path_.string(); }
  std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  fs::path path_;
};

inline std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void put_bytes(const std::string& path, const std::string& bytes) {
  // Truncating an existing file waits for the disk on ext4; a new one does not.
  fs::remove(path);
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// Random light over many orders of magnitude, the same on every run.
inline Image random_image(int width, int height, int channels = 3, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> stops(-8, 6);
  Image image(width, height, channels);
  for (float& value : image.pixels) value = std::exp2(stops(random));
  return image;
}

/// The whole message of the Error that `action` throws; fails the test if it throws none.
template <typename Action>
std::string error_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no Error was thrown";
  return "";
}

/// The image in a file of these bytes; the name does not say what it is.
inline Image image_of(const std::string& bytes, const ReadOptions& options = {}) {
  const Folder folder;
  put_bytes(folder / "picture", bytes);
  return read_image(folder / "picture", options);
}

inline std::string refusal_of(const std::string& bytes) {
  return error_of([&] { image_of(bytes); });
}

/// A Radiance file with these lines and bytes.
inline std::string radiance(const std::string& resolution, const std::string& pixels) {
  return "#?RADIANCE\n# comment\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n" + resolution + "\n" +
         pixels;
}

}  // namespace lapidary::image::test
