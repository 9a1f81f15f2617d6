#include "distributed/file_message.h"

#include <utility>

#include "distributed/byte_stream.h"

namespace lapidary::distributed {

Message file_message(const FileAnswers& answers) {
  ByteWriter writer;
  for (const auto& [question, answer] : answers) {
    writer.add(std::string_view(question));
    writer.add(std::string_view(answer));
  }
  return std::move(writer).message(Topic::job);
}

FileAnswers read_file_message(const Bytes& bytes) {
  FileAnswers answers;
  ByteReader reader(bytes);
  while (!reader.rest().empty()) {
    std::string question = reader.take_text();
    answers.emplace(std::move(question), reader.take_text());
  }
  return answers;
}

}  // namespace lapidary::distributed
