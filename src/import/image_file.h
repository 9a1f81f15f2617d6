#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "base/input_files.h"
#include "texture/pyramid.h"

namespace lapidary::import {

/// What the numbers in a picture's file mean.
enum class PictureSpace {
  automatic,  ///< colours: what files of the kind hold; a single channel: plain numbers
  srgb,
  linear,
};

/// What is taken of a picture.
enum class PictureChannel { color, red, green, blue, alpha };

struct PictureOptions {
  PictureSpace space = PictureSpace::automatic;
  PictureChannel channel = PictureChannel::color;

  auto operator<=>(const PictureOptions&) const = default;
};

/// Reads pictures for textures; one that is asked for again in the same way is shared.
class ImageFiles {
 public:
  /// `files` notes what is read, or was when it was read first; null: nobody wants to know.
  /// Throws Error when the file is no whole picture, or has numbers that are not finite.
  std::shared_ptr<const texture::Pyramid> read(const std::filesystem::path& file,
                                               const PictureOptions& options,
                                               InputFiles* files = nullptr);

  /// Bytes that all pictures hold which the present scene has asked for.
  std::size_t bytes() const { return bytes_; }

  /// Another scene follows: drops what the present one has not asked for.
  void begin_scene();

 private:
  struct Entry {
    std::shared_ptr<const texture::Pyramid> pyramid;
    std::vector<InputFiles::Note> notes;
    bool is_used = false;  ///< by the present scene
  };

  std::map<std::pair<std::filesystem::path, PictureOptions>, Entry> read_;
  std::size_t bytes_ = 0;
};

}  // namespace lapidary::import
