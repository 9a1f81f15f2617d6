#include "import/text_blocks.h"

#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "import/line_cursor.h"
#include "temp_folder.h"

namespace lapidary::import {
namespace {

// All lines' words in brackets, as a parser sees them, with line numbers.
std::string words_of(TextBlocks blocks) {
  std::string result;
  LineCursor cursor("t");
  for (std::string_view block = blocks.next(); !block.empty(); block = blocks.next()) {
    cursor.start_block(block);
    while (!cursor.block_done()) {
      std::string words;
      for (cursor.skip_blanks(); !cursor.at_end(); cursor.skip_blanks()) {
        if (words.empty()) words = std::to_string(cursor.line()) + ":";
        words += '[' + std::string(cursor.word()) + ']';
      }
      result += words;
      cursor.next_statement();
    }
  }
  return result;
}

TEST(TextBlocks, KnowsAllLineEnds) {
  for (const char* text : {"a b\nc\n", "a b\r\nc\r\n", "a b\rc\r", "a b\nc", "a b\r\nc", "a b\rc",
                           "\ta \t b  \n  c \n\n"}) {
    EXPECT_EQ(words_of(TextBlocks::of_text(text)), "1:[a][b]2:[c]") << text;
  }
  EXPECT_EQ(words_of(TextBlocks::of_text("")), "");
  EXPECT_EQ(words_of(TextBlocks::of_text("\r\r\n\n\ra")), "5:[a]");
}

TEST(TextBlocks, JoinsContinuedLinesAndCountsThem) {
  EXPECT_EQ(words_of(TextBlocks::of_text("a \\\nb\\\r\n c\nd\n")), "1:[a][b][c]4:[d]");
  EXPECT_EQ(words_of(TextBlocks::of_text("a \\\rb\rd")), "1:[a][b]3:[d]");
  EXPECT_EQ(words_of(TextBlocks::of_text("a\\b\n")), "1:[a\\b]");
  EXPECT_EQ(words_of(TextBlocks::of_text("a \\")), "1:[a]");
  EXPECT_EQ(words_of(TextBlocks::of_text("a \\\n")), "1:[a]");
  EXPECT_EQ(words_of(TextBlocks::of_text("# C:\\folder\\\na\n")), "2:[a]");
}

TEST(TextBlocks, SkipsComments) {
  EXPECT_EQ(words_of(TextBlocks::of_text("# x\na # b\n#\n  # c\nd#e\n")), "2:[a]5:[d#e]");
}

TEST(TextBlocks, CutsFilesBetweenLines) {
  // Lines of all lengths around the size of a block, some of them continued.
  const TempFolder folder;
  for (const std::string end : {"\n", "\r\n", "\r"}) {
    std::string text, expected;
    int line = 1;
    for (std::size_t length = 1; length < 3000; length += 3) {
      const std::string word(length, static_cast<char>('a' + length % 26));
      const bool continued = length % 4 == 0;
      text += word + (continued ? " \\" + end : " ") + word + end;
      expected += std::to_string(line) + ":[" + word + "][" + word + "]";
      line += continued ? 2 : 1;
    }
    const auto file = folder.write("long.txt", text);
    EXPECT_GT(text.size(), std::size_t{2} << 20);
    EXPECT_EQ(words_of(TextBlocks::of_file(file)), expected);
  }
}

TEST(TextBlocks, DoesNotCutBetweenCarriageReturnAndLineFeed) {
  const TempFolder folder;
  for (std::size_t length = (1 << 20) - 3; length < (1 << 20) + 2; ++length) {
    const std::string word(length, 'x');
    EXPECT_EQ(words_of(TextBlocks::of_file(folder.write("t", word + "\r\nb\r\nc"))),
              "1:[" + word + "]2:[b]3:[c]");
    EXPECT_EQ(words_of(TextBlocks::of_file(folder.write("t", "a\n" + word + "\\\r\nb\r\nc"))),
              "1:[a]2:[" + word + "][b]4:[c]");
  }
}

TEST(TextBlocks, TakesLinesLongerThanABlock) {
  const TempFolder folder;
  const std::string word(5 << 20, 'x');
  EXPECT_EQ(words_of(TextBlocks::of_file(folder.write("l", "a\n" + word + "\nb"))),
            "1:[a]2:[" + word + "]3:[b]");
}

TEST(TextBlocks, RefusesWhatItCannotRead) {
  const TempFolder folder;
  EXPECT_THROW(TextBlocks::of_file(folder.path() / "none"), Error);
  EXPECT_THROW(TextBlocks::of_file(folder.path()).next(), Error);
  if (std::filesystem::exists("/dev/zero")) {
    EXPECT_THROW(TextBlocks::of_file("/dev/zero").next(), Error);
  }
}

}  // namespace
}  // namespace lapidary::import
