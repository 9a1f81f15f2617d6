#pragma once

#include <string>
#include <vector>

#include "app/command_line.h"
#include "film/film.h"
#include "image/image_io.h"
#include "render/canvas.h"
#include "render/origin.h"

namespace lapidary::app {

/// What is written of a picture beside its pixels.
struct PictureFacts {
  const render::Origin& origin;
  double seconds = 0;  ///< of rendering
};
image::WriteOptions write_options(const render::Canvas& canvas, const PictureFacts& facts);

/// The pictures that a command is to write; of a frame with #### for its number.
std::vector<std::string> outputs_of(const RenderCommand& command);

/// The files that a picture goes to. Its checkpoint is the second part of the first OpenEXR file
/// among them, else NAME.checkpoint.exr beside the first.
class Outputs {
 public:
  enum class Checkpoints { kept, none };
  /// Whether a render has come to where it was to go.
  enum class Completion { complete, to_be_continued };

  /// At least one picture.
  Outputs(std::vector<std::string> pictures, Checkpoints checkpoints);

  const std::vector<std::string>& pictures() const { return pictures_; }
  /// Which layers they have room for.
  film::Layers layers() const;
  /// The file with the checkpoint; empty where none is kept.
  const std::string& checkpoint() const { return checkpoint_; }

  /// Whether the checkpoint has a file of its own, which is there only until the pictures are
  /// complete.
  bool is_checkpoint_beside() const;

  /// Finds out before the work what would fail after it. Throws Error.
  void check() const;

  /// Writes the checkpoint's file alone, in haste: with the picture so far, not packed. Throws
  /// Error, and then the file is as it was.
  void write_checkpoint(const render::Canvas& canvas, const PictureFacts& facts) const;

  /// Writes all files; a checkpoint beside the pictures only where these are not complete, or
  /// cannot be written. One that cannot does not keep it from the others: throws the first Error
  /// after them.
  void write(const render::Canvas& canvas, const PictureFacts& facts, Completion completion) const;

  /// Removes a checkpoint that is beside the pictures, if there is one: they are complete.
  void remove_checkpoint() const;

 private:
  void write_with_checkpoint(const render::Canvas& canvas, const image::LayeredImage& picture,
                             const PictureFacts& facts, image::Compression compression) const;

  std::vector<std::string> pictures_;
  std::string checkpoint_;
};

}  // namespace lapidary::app
