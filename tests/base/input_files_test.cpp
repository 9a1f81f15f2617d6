#include "base/input_files.h"

#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string_view>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"

namespace lapidary {
namespace {

std::span<const std::byte> bytes(std::string_view text) {
  return std::as_bytes(std::span(text));
}

std::string sha256(std::string_view text) {
  Sha256 hash;
  hash.add(bytes(text));
  return to_text(hash.finish());
}

// The examples of FIPS 180-2, appendix B, and the empty text.
TEST(Sha256, IsThatOfTheStandard) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, DoesNotDependOnThePieces) {
  std::mt19937 random(1);
  std::string text(1000, '\0');
  for (char& c : text) c = static_cast<char>(random());
  for (std::size_t size = 0; size < 300; ++size) {
    const std::string_view some = std::string_view(text).substr(0, size);
    Sha256 hash;
    for (std::size_t at = 0; at < size;) {
      const std::size_t count = std::min<std::size_t>(size - at, random() % 90);
      hash.add(bytes(some.substr(at, count)));
      at += count;
    }
    ASSERT_EQ(to_text(hash.finish()), sha256(some)) << size;
  }
}

TEST(InputFiles, AreNamedFromAFolder) {
  InputFiles files;
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "no such folder";
  files.add(folder / "scene.lua", bytes("abc"));
  files.add(folder / "sub/../scene.lua", bytes("abc"));
  files.add(folder / "textures" / "a.png", bytes(""));
  files.add(folder / "../other/b.obj", bytes("abc"));
  const std::string abc = sha256("abc"), empty = sha256("");
  EXPECT_EQ(files.relative_to(folder),
            (std::vector<FileRecord>{
                {"../other/b.obj", abc}, {"scene.lua", abc}, {"textures/a.png", empty}}));
  files.add(folder / "scene.lua", bytes("it was changed meanwhile"));
  EXPECT_EQ(files.relative_to(folder).size(), 4u);
}

/// A file of its own, gone at the end.
class TextFile {
 public:
  explicit TextFile(const std::string& text) { std::ofstream(path_, std::ios::binary) << text; }
  ~TextFile() { std::filesystem::remove(path_); }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_ = std::filesystem::temp_directory_path() /
                                ("lapidary_input_files_test_" + std::to_string(::getpid()));
};

TEST(InputFiles, StandForTheFileSystemElsewhere) {
  const std::string text("a\0b\nc", 5);
  InputFiles here;
  FileAnswers answers;
  std::filesystem::path name;
  {
    const TextFile file(text);
    name = file.path();
    EXPECT_EQ(here.content(name), std::nullopt);
    EXPECT_EQ(here.answer("mood", name, [] { return "good"; }), "good");
    EXPECT_EQ(here.answer("mood", name, [] { return "bad"; }), "good") << "asked once";
    EXPECT_TRUE(is_file_answer_yes(&here, "being", name, [] { return true; }));
    here.add(name, bytes(text));
    here.relative_to(name.parent_path());
    answers = here.answers();
  }
  EXPECT_THROW(here.answers(), Error) << "what is to be sent is read again";

  InputFiles there(answers);
  const auto nobody = []() -> std::string { throw std::logic_error("asked here"); };
  EXPECT_EQ(there.answer("mood", name, nobody), "good");
  EXPECT_TRUE(is_file_answer_yes(&there, "being", name, [] { return false; }));
  EXPECT_EQ(there.content(name), text);
  there.add(name, bytes(*there.content(name)));
  EXPECT_EQ(there.relative_to(name.parent_path()), here.relative_to(name.parent_path()));
  EXPECT_THROW(there.answer("weather", name, nobody), Error);
  EXPECT_THROW(there.content("another"), Error);
  there.forget_contents();
  EXPECT_THROW(there.content(name), Error);
  EXPECT_EQ(there.answer("mood", name, nobody), "good");
}

TEST(InputFiles, AreNotNeededToAsk) {
  EXPECT_EQ(file_answer(nullptr, "mood", "x", [] { return "good"; }), "good");
  EXPECT_FALSE(is_file_answer_yes(nullptr, "being", "x", [] { return false; }));
  EXPECT_EQ(file_content(nullptr, "x"), std::nullopt);
}

}  // namespace
}  // namespace lapidary
