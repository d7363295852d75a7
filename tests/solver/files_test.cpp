#include "solver/support/files.hpp"

#include <gtest/gtest.h>

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

TEST_F(Files, ALinkStaysALink) {
  write_file(folder_ / "text", "old");
  fs::create_symlink(folder_ / "text", folder_ / "link");
  write_file(folder_ / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
  EXPECT_EQ(read_file(folder_ / "text"), "new");
}

}  // namespace
}  // namespace slfb
