#include "solver/support/files.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/temporary_folder.hpp"

namespace slfb {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  // Of each test alone: tests run beside each other.
  Folder own_folder_;
  fs::path folder_ = own_folder_.path();
};

std::string message_of(const auto& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST_F(Files, WhatIsWrittenIsReadBackWithEveryByte) {
  const std::string text("a\r\nb\0c\n\n", 8);
  for (const std::string& content : {text, std::string(), std::string("longer than what was there before\n")}) {
    write_file(folder_ / "text", content);
    EXPECT_EQ(read_file(folder_ / "text"), content);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1) << "a temporary file is left";
}

TEST_F(Files, ErrorsNameTheFile) {
  EXPECT_NE(message_of([&] { read_file(folder_ / "none"); }).find((folder_ / "none").string()), std::string::npos);
  EXPECT_NE(message_of([&] { read_file(folder_); }).find(folder_.string()), std::string::npos);
  const fs::path lost = folder_ / "no-folder" / "text";
  EXPECT_NE(message_of([&] { write_file(lost, "x"); }).find(lost.string()), std::string::npos);
}

TEST_F(Files, AFolderThatCannotBeMadeIsNamed) {
  write_file(folder_ / "text", "kept");
  EXPECT_NE(message_of([&] { make_output_folder(folder_ / "text/runs"); }).find((folder_ / "text/runs").string()),
            std::string::npos);
  EXPECT_EQ(read_file(folder_ / "text"), "kept");
}

TEST_F(Files, AFileThatAUserNamesMayBeALink) {
  write_file(folder_ / "text", "old");
  fs::create_symlink(folder_ / "text", folder_ / "link");
  write_named_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file(folder_ / "text"), "new");
}

TEST_F(Files, APlantedLinkOrPipeIsReplaced) {
  write_file(folder_ / "precious", "kept");
  fs::create_symlink(folder_ / "precious", folder_ / "link");
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  for (const char* name : {"link", "pipe"}) {
    write_file(folder_ / name, "new");
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder_ / name)));
    EXPECT_EQ(read_file(folder_ / name), "new");
  }
  EXPECT_EQ(read_file(folder_ / "precious"), "kept");
}

TEST_F(Files, APipeIsNotReadToAnEndThatItMayNotHave) {
  ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
  EXPECT_NE(message_of([&] { read_file(folder_ / "pipe"); }).find("no regular file"), std::string::npos);
}

TEST_F(Files, WhatAKilledProcessLeftUnfinishedIsRemoved) {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  const std::string dead = "result.h5." + std::to_string(child) + "-1000.part",
                    alive = "result.h5." + std::to_string(getpid()) + "-1000.part";
  for (const std::string& name : {dead, alive, std::string("note.part"), std::string("result.h5")})
    write_file(folder_ / name, "x");
  remove_unfinished(folder_);
  EXPECT_FALSE(fs::exists(folder_ / dead));
  for (const std::string& name : {alive, std::string("note.part"), std::string("result.h5")})
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_NO_THROW(remove_unfinished(folder_ / "none"));
}

}  // namespace
}  // namespace slfb
