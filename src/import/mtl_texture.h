#pragma once

#include "base/log.h"
#include "import/find_file.h"
#include "import/image_file.h"
#include "import/mtl.h"
#include "texture/texture.h"

namespace lapidary::import {

/// What materials are made with. Without `images`, textures are left out; `warnings` may be null.
struct MtlReading {
  WarningLog* warnings = nullptr;
  ImageFiles* images = nullptr;
  AllowFile allow = {};
  InputFiles* files = nullptr;  ///< notes the pictures, answers for the file system; may be null
};

/// The textures that the material states, as far as there are files for them: what is missing,
/// refused or broken is told to `reading.warnings`.
class MtlTextures {
 public:
  MtlTextures(const MtlMaterial& material, const MtlReading& reading);

  /// The first of a channel as colours; null when there is none.
  texture::TexturePtr color(MtlChannel channel);
  /// The same as plain numbers. A picture of gaps that is also that of the diffuse colours says by
  /// its alpha what is there.
  texture::TexturePtr number(MtlChannel channel);
  /// Heights of a bump, and pictures of normals.
  texture::TexturePtr height();
  texture::TexturePtr normals();
  /// Warns of all textures that nobody asked for.
  void warn_of_the_rest() const;

 private:
  const MtlTexture* take(MtlChannel channel);
  texture::TexturePtr read(const MtlTexture* stated, const PictureOptions& options) const;
  void warn(const MtlTexture& stated, std::string_view problem) const;

  const MtlMaterial& material_;
  const MtlReading& reading_;
  std::vector<bool> used_;
};

}  // namespace lapidary::import
