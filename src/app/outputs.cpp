#include "app/outputs.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "film/develop.h"
#include "image/file_format.h"
#include "render/checkpoint.h"

namespace lapidary::app {
namespace {

bool is_exr(const std::string& picture) {
  return image::format_of_name(picture) == image::FileFormat::exr;
}

std::string checkpoint_file(const std::vector<std::string>& pictures) {
  const auto exr = std::ranges::find_if(pictures, is_exr);
  if (exr != pictures.end()) return *exr;
  return std::filesystem::path(pictures.front()).replace_extension("checkpoint.exr").string();
}

}  // namespace

image::WriteOptions write_options(const render::Canvas& canvas, const PictureFacts& facts) {
  const auto [render, film] = render::settings_of(facts.origin);
  image::WriteOptions options;
  options.metadata = {{"scene", facts.origin.scene},
                      {"samples", static_cast<double>(canvas.picture().pass_count())},
                      {"seed", std::to_string(render.seed)},
                      {"seconds", facts.seconds},
                      {"software", "Lapidary " + facts.origin.version}};
  options.display.exposure = std::log2(film.exposure);
  options.display.tone =
      film.tone == description::ToneCurve::filmic ? image::Tone::filmic : image::Tone::none;
  return options;
}

std::vector<std::string> outputs_of(const RenderCommand& command) {
  if (!command.outputs.empty()) return command.outputs;
  const std::string stem = std::filesystem::path(command.scene.file).stem().string();
  return {stem + (command.scene.frame ? "_####.png" : ".png")};
}

Outputs::Outputs(std::vector<std::string> pictures, Checkpoints checkpoints)
    : pictures_(std::move(pictures)) {
  if (checkpoints == Checkpoints::kept) checkpoint_ = checkpoint_file(pictures_);
}

film::Layers Outputs::layers() const {
  return std::ranges::any_of(pictures_, is_exr) ? film::Layers::all : film::Layers::beauty;
}

bool Outputs::is_checkpoint_beside() const {
  return !checkpoint_.empty() && std::ranges::find(pictures_, checkpoint_) == pictures_.end();
}

void Outputs::check() const {
  for (const std::string& picture : pictures_) image::check_writable(picture);
  if (is_checkpoint_beside()) image::check_writable(checkpoint_);
}

void Outputs::write_with_checkpoint(const render::Canvas& canvas,
                                    const image::LayeredImage& picture, const PictureFacts& facts,
                                    image::Compression compression) const {
  image::WriteOptions options = write_options(canvas, facts);
  options.compression = compression;
  image::write_image(checkpoint_, picture, render::checkpoint_of(facts.origin, canvas), options);
}

void Outputs::write_checkpoint(const render::Canvas& canvas, const PictureFacts& facts) const {
  write_with_checkpoint(canvas, film::develop(canvas.picture()), facts, image::Compression::none);
}

void Outputs::write(const render::Canvas& canvas, const PictureFacts& facts,
                    Completion completion) const {
  const image::LayeredImage picture = film::develop(canvas.picture());
  const image::WriteOptions options = write_options(canvas, facts);
  std::exception_ptr problem;
  const auto attempt = [&problem](const auto& write_one) {
    try {
      write_one();
    } catch (const Error&) {
      if (!problem) problem = std::current_exception();
    }
  };
  const auto keep = [&] { write_with_checkpoint(canvas, picture, facts, image::Compression::zip); };
  const bool keeps = !checkpoint_.empty() &&
                     (!is_checkpoint_beside() || completion == Completion::to_be_continued);
  if (keeps) attempt(keep);
  for (const std::string& file : pictures_) {
    if (file != checkpoint_) attempt([&] { image::write_image(file, picture, options); });
  }
  if (!problem) return;
  // What was rendered must not be lost with a picture that has no room.
  if (is_checkpoint_beside() && !keeps) attempt(keep);
  std::rethrow_exception(problem);
}

void Outputs::remove_checkpoint() const {
  std::error_code ignored;  // where there is none
  if (is_checkpoint_beside()) std::filesystem::remove(checkpoint_, ignored);
}

}  // namespace lapidary::app
