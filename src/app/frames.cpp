#include "app/frames.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "app/outputs.h"

namespace lapidary::app {

std::string with_frame_number(std::string_view text, int frame) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find_first_not_of('#', i), text.size());
    if (end > i) {
      result += fmt::format("{:0{}}", frame, end - i);
      i = end;
    } else {
      result += text[i++];
    }
  }
  return result;
}

RenderCommand of_frame(const RenderCommand& command, int frame) {
  RenderCommand one = command;
  one.frames.reset();
  one.scene.frame = frame;
  for (std::string& output : one.outputs) output = with_frame_number(output, frame);
  one.stats_file = with_frame_number(command.stats_file, frame);
  one.plan_file = with_frame_number(command.plan_file, frame);
  return one;
}

bool is_done_already(const RenderCommand& command) {
  if (!command.resumes || command.blocks) return false;
  const Outputs outputs(command.outputs, Outputs::Checkpoints::kept);
  const auto exists = [](const std::string& file) {
    std::error_code ignored;
    return std::filesystem::exists(file, ignored);
  };
  return outputs.is_checkpoint_beside() && !exists(outputs.checkpoint()) &&
         std::ranges::all_of(outputs.pictures(), exists);
}

}  // namespace lapidary::app
