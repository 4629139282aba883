// Golden tests of every kind of mistake in options, and of every note: the text, and what to write instead.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include "parser/options/option_reader.hpp"
#include "tests/golden.hpp"
#include "tests/parser/diagnostic/golden_scene_list.hpp"

namespace lute::test {
namespace {

const std::string kGolden = LUTE_SOURCE_DIR "/tests/parser/options/option_messages.golden";

// A case is the line of arguments, then the text of test.ini, where <NUL> stands for that byte.
std::string said_about(const std::string& options) {
  const std::size_t end = options.find('\n');
  std::istringstream line(options.substr(0, end));
  std::vector<std::string> arguments;
  for (std::string word; line >> word;) arguments.push_back(word);
  OptionEnvironment environment;
  environment.variable = [](const std::string&) { return std::nullopt; };
  environment.read_file = [&](const std::string& path) {
    if (path != "test.ini") return std::optional<std::string>();
    return std::optional(std::regex_replace(options.substr(end + 1), std::regex("<NUL>"), std::string(1, '\0')));
  };
  try {
    std::string said;
    for (const std::string& note : read_options(arguments, environment).notices) said += "note: " + note + "\n";
    return said;
  } catch (const OptionError& error) {
    return "error: " + std::string(error.what()) + "\n" + (error.hint().empty() ? "" : "  hint: " + error.hint() + "\n");
  }
}

TEST(OptionMessages, AreAsRecorded) {
  const GoldenScenes golden = read_golden_scenes(kGolden);
  ASSERT_GT(golden.cases.size(), 30u);
  if (golden_is_renewed()) {
    std::string text = golden.head;
    for (const auto& [options, says] : golden.cases) {
      text.append(kSceneMark).append(options).append(kSaysMark).append(said_about(options));
    }
    return renew_golden(kGolden, text);
  }
  for (const auto& [options, says] : golden.cases) {
    EXPECT_NE(says, "") << options;
    EXPECT_EQ(said_about(options), says) << options;
  }
}

// The literals in the statements that make an error or a note, or say what a switch takes.
std::set<std::string> texts_in_sources() {
  const std::regex statement(R"re((?:OptionError\(|\bnotice\("|return "[\w ]+ behind it)[^;]*;)re");
  const std::regex literal(R"re("((?:[^"\\]|\\.)*)")re");
  std::set<std::string> texts;
  for (const auto& entry : std::filesystem::directory_iterator(LUTE_SOURCE_DIR "/parser/options")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string source = file_text(entry.path());
    for (std::sregex_iterator found(source.begin(), source.end(), statement), end; found != end; ++found) {
      const std::string text = found->str();
      for (std::sregex_iterator part(text.begin(), text.end(), literal); part != end; ++part) {
        if ((*part)[1].length() > 3) texts.insert((*part)[1]);
      }
    }
  }
  return texts;
}

TEST(OptionMessages, EveryKindIsRecorded) {
  const std::string all = read_golden_scenes(kGolden).all_said();
  const std::set<std::string> texts = texts_in_sources();
  ASSERT_GT(texts.size(), 35u);
  for (const std::string& text : texts) EXPECT_NE(all.find(text), std::string::npos) << text;
}

}  // namespace
}  // namespace lute::test
