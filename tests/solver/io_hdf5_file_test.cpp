#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "solver/io/hdf5_file.hpp"
#include "tests/hostile_hdf5.hpp"

namespace slfb::io {
namespace {

using ::testing::Test;

class Hdf5FileTest : public Test {
 protected:
  Hdf5FileTest()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                (std::string("slfb_hdf5_") + ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~Hdf5FileTest() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::filesystem::path file(const std::string& name = "file.h5") const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

template <class Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

std::vector<double> sines(std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) values[i] = std::sin(0.01 * static_cast<double>(i));
  return values;
}

TEST_F(Hdf5FileTest, NumbersComeBackAsTheyWereWritten) {
  const std::vector<double> real{0.1, -1e300, std::numeric_limits<double>::infinity()};
  const std::vector<std::int64_t> integers{-5, std::numeric_limits<std::int64_t>::max()};
  const std::vector<std::uint32_t> indices{0, 4'000'000'000U};
  {
    Hdf5File target = Hdf5File::create(file());
    target.write("a/b/real", real, "m s-1");
    target.write("a/integers", integers);
    target.write("indices", indices);
    target.write("empty", std::vector<double>{}, "m");
    target.write_attribute("a", "ratio", 0.1);
    target.write_attribute("/", "count", std::int64_t{-7});
    target.write_attribute("/", "text", std::string("µ = 0.3\nsecond line"));
    target.write_attribute("/", "nothing", std::string());
    target.write_attribute("new/group", "list", std::vector<std::int64_t>{1, 0});
    target.close();
  }
  const Hdf5File source = Hdf5File::open(file());
  EXPECT_EQ(source.read_doubles("a/b/real"), real);
  EXPECT_EQ(source.read_string_attribute("a/b/real", "unit"), "m s-1");
  EXPECT_EQ(source.read_integers("a/integers"), integers);
  EXPECT_EQ(source.read_unsigned("indices"), indices);
  EXPECT_TRUE(source.read_doubles("empty").empty());
  EXPECT_EQ(source.read_double_attribute("a", "ratio"), 0.1);
  EXPECT_EQ(source.read_integer_attribute("/", "count"), -7);
  EXPECT_EQ(source.read_string_attribute("/", "text"), "µ = 0.3\nsecond line");
  EXPECT_EQ(source.read_string_attribute("/", "nothing"), "");
  EXPECT_EQ(source.read_integers_attribute("new/group", "list"), (std::vector<std::int64_t>{1, 0}));
  EXPECT_EQ(source.children("/"), (std::vector<std::string>{"a", "empty", "indices", "new"}));
  EXPECT_EQ(source.children("a"), (std::vector<std::string>{"b", "integers"}));
  EXPECT_TRUE(source.exists("/"));
  EXPECT_TRUE(source.exists("a/b/real"));
  EXPECT_TRUE(source.exists("/a/b"));
  EXPECT_FALSE(source.exists("a/c/real"));
  EXPECT_TRUE(source.has_attribute("a", "ratio"));
  EXPECT_FALSE(source.has_attribute("a", "unit"));
  EXPECT_FALSE(source.has_attribute("c", "unit"));
}

TEST_F(Hdf5FileTest, SinglePrecisionKeepsSevenDigitsAndNotANumber) {
  const std::vector<double> values{std::numbers::pi, -1e-20, std::numeric_limits<double>::quiet_NaN()};
  {
    Hdf5File target = Hdf5File::create(file());
    target.write("values", values, "1", Storage::float32);
    target.close();
  }
  const auto back = Hdf5File::open(file()).read_doubles("values");
  ASSERT_EQ(back.size(), 3U);
  EXPECT_NEAR(back[0], values[0], 1e-7 * values[0]);
  EXPECT_NEAR(back[1], values[1], 1e-7 * 1e-20);
  EXPECT_TRUE(std::isnan(back[2]));
}

TEST_F(Hdf5FileTest, LongSmoothSeriesAreCompressedAndShapesKept) {
  const auto values = sines(300'000);
  {
    Hdf5File target = Hdf5File::create(file());
    target.write("table", values, "m", Storage::float64, {100'000, 3});
    target.write("constant", std::vector<double>(300'000, 1.0), "1");
    target.close();
  }
  const Hdf5File source = Hdf5File::open(file());
  EXPECT_EQ(source.shape("table"), (Shape{100'000, 3}));
  EXPECT_EQ(source.read_doubles("table"), values);
  EXPECT_LT(std::filesystem::file_size(file()), 2U * 300'000U * sizeof(double) * 3U / 4U);
}

TEST_F(Hdf5FileTest, AMissingFileIsNamed) {
  const std::string message = message_of([&] { Hdf5File::open(file("absent.h5")); });
  EXPECT_NE(message.find("absent.h5"), std::string::npos) << message;
  EXPECT_NE(message.find("does not exist"), std::string::npos) << message;
}

TEST_F(Hdf5FileTest, AFileOfAnotherKindIsNamedWithTheReason) {
  std::ofstream(file()) << "this is not HDF5";
  const std::string message = message_of([&] { Hdf5File::open(file()); });
  EXPECT_NE(message.find(file().string()), std::string::npos) << message;
  EXPECT_NE(message.find("signature"), std::string::npos) << message;
}

TEST_F(Hdf5FileTest, ATruncatedFileIsAnError) {
  {
    Hdf5File target = Hdf5File::create(file());
    target.write("values", sines(10'000), "m");
    target.close();
  }
  std::filesystem::resize_file(file(), std::filesystem::file_size(file()) / 2);
  EXPECT_NE(message_of([&] { (void)Hdf5File::open(file()).read_doubles("values"); }).find(file().string()),
            std::string::npos);
}

TEST_F(Hdf5FileTest, MissingItemsAreNamedWithTheFile) {
  {
    Hdf5File target = Hdf5File::create(file());
    target.write("bed/time", {1.0, 2.0}, "s");
    target.close();
  }
  const Hdf5File source = Hdf5File::open(file());
  const std::vector<std::string> messages{message_of([&] { (void)source.read_doubles("bed/pressure"); }),
                                          message_of([&] { (void)source.read_double_attribute("bed", "pressure"); }),
                                          message_of([&] { (void)source.children("bed/pressure"); })};
  for (const std::string& message : messages) {
    EXPECT_NE(message.find(file().string()), std::string::npos) << message;
    EXPECT_NE(message.find("bed"), std::string::npos) << message;
    EXPECT_NE(message.find("pressure"), std::string::npos) << message;
  }
}

TEST_F(Hdf5FileTest, WritingOneItemTwiceOrOutOfShapeIsAnError) {
  Hdf5File target = Hdf5File::create(file());
  target.write("values", {1.0}, "m");
  EXPECT_NE(message_of([&] { target.write("values", {2.0}, "m"); }).find("values"), std::string::npos);
  EXPECT_NE(message_of([&] {
              target.write("table", {1.0, 2.0, 3.0}, "m", Storage::float64, {2, 2});
            }).find("table"),
            std::string::npos);
}

TEST_F(Hdf5FileTest, AFailedAtomicWriteLeavesTheOldFileAndNoTemporary) {
  write_atomically(file(), [](Hdf5File& target) { target.write("values", {1.0}, "m"); });
  EXPECT_THROW(write_atomically(file(),
                                [](Hdf5File& target) {
                                  target.write("values", {2.0}, "m");
                                  throw std::runtime_error("stopped half way");
                                }),
               std::runtime_error);
  EXPECT_EQ(Hdf5File::open(file()).read_doubles("values"), std::vector<double>{1.0});
  const auto entries = std::filesystem::directory_iterator(file().parent_path());
  EXPECT_EQ(std::distance(begin(entries), end(entries)), 1);
}

/// A file with a checksum.
void write_checked(const std::filesystem::path& file) {
  write_atomically(
      file,
      [](Hdf5File& target) {
        target.write("values", sines(1000), "m");
        target.write("whole", std::vector<std::int64_t>{1, 2});
        target.write_attribute("/", "text", std::string("abc"));
      },
      Checksum::whole_file);
}

TEST_F(Hdf5FileTest, TheSameNumbersAreTheSameBytesWheneverTheyAreWritten) {
  write_checked(file("now.h5"));
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 counts whole seconds
  write_checked(file("later.h5"));
  EXPECT_EQ(hostile::bytes_of(file("now.h5")), hostile::bytes_of(file("later.h5")));
}

TEST_F(Hdf5FileTest, EachChangedByteAndEachMissingEndIsFound) {
  write_checked(file());
  const std::string whole = hostile::bytes_of(file());
  EXPECT_EQ(Hdf5File::open(file(), Checksum::whole_file).read_doubles("values"), sines(1000));
  for (std::size_t k = 0; k < whole.size(); k += 7) {
    std::string damaged = whole;
    damaged[k] = static_cast<char>(damaged[k] ^ 0x10);
    hostile::set_bytes(file(), damaged);
    EXPECT_NE(message_of([&] { Hdf5File::open(file()); }).find(file().string()), std::string::npos) << "byte " << k;
    hostile::set_bytes(file(), whole.substr(0, k));
    EXPECT_NE(message_of([&] { Hdf5File::open(file()); }).find(file().string()), std::string::npos) << k << " bytes";
  }
}

TEST_F(Hdf5FileTest, AnyReaderOfHdf5FindsItsPartBehindTheChecksum) {
  write_checked(file());
  const hid_t handle = H5Fopen(file().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(handle, 0);
  EXPECT_GT(H5Lexists(handle, "values", H5P_DEFAULT), 0);
  H5Fclose(handle);
}

TEST_F(Hdf5FileTest, AFileWithoutChecksumIsReadWhereNoneIsRequired) {
  write_atomically(file(), [](Hdf5File& target) { target.write("values", {1.0}, "m"); });
  EXPECT_EQ(Hdf5File::open(file()).read_doubles("values"), std::vector<double>{1.0});
  EXPECT_NE(message_of([&] { Hdf5File::open(file(), Checksum::whole_file); }).find("has no checksum"),
            std::string::npos);
}

TEST_F(Hdf5FileTest, WhatNeedNotFitItsClaimIsRefused) {
  const auto refused = [&](const std::function<void(hid_t)>& edit, const auto& read) {
    write_checked(file());
    hostile::change(file(), edit);
    const Hdf5File source = Hdf5File::open(file());
    const std::string message = message_of([&] { read(source); });
    EXPECT_NE(message.find(file().string()), std::string::npos) << message;
    return message;
  };
  const auto read_values = [](const Hdf5File& source) { (void)source.read_doubles("values"); };
  const auto read_text = [](const Hdf5File& source) { (void)source.read_string_attribute("/", "text"); };

  // Ten texts where a buffer for one is ready.
  refused(
      [](hid_t target) {
        H5Adelete(target, "text");
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, 3);
        const hsize_t ten = 10;
        const hid_t space = H5Screate_simple(1, &ten, nullptr);
        const hid_t text = H5Acreate2(target, "text", type, space, H5P_DEFAULT, H5P_DEFAULT);
        const std::string letters(30, 'x');
        H5Awrite(text, type, letters.data());
        H5Aclose(text);
        H5Sclose(space);
        H5Tclose(type);
      },
      read_text);
  // 10^15 values, none of which is stored.
  const std::string message = refused(
      [](hid_t target) {
        H5Ldelete(target, "values", H5P_DEFAULT);
        const hsize_t many = 1'000'000'000'000'000, chunk = 1000;
        const hid_t space = H5Screate_simple(1, &many, nullptr), layout = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_chunk(layout, 1, &chunk);
        H5Dclose(H5Dcreate2(target, "values", H5T_IEEE_F64LE, space, H5P_DEFAULT, layout, H5P_DEFAULT));
        H5Pclose(layout);
        H5Sclose(space);
      },
      read_values);
  EXPECT_NE(message.find("1000000000000000"), std::string::npos) << message;
  // Another file in the place of a data set.
  refused(
      [](hid_t target) {
        H5Ldelete(target, "values", H5P_DEFAULT);
        H5Lcreate_external("/etc/passwd", "values", target, "values", H5P_DEFAULT, H5P_DEFAULT);
      },
      read_values);
  // Text in the place of numbers, reals in the place of whole numbers.
  refused(
      [](hid_t target) {
        H5Ldelete(target, "values", H5P_DEFAULT);
        const hid_t space = H5Screate(H5S_SCALAR);
        H5Dclose(H5Dcreate2(target, "values", H5T_C_S1, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        H5Sclose(space);
      },
      read_values);
  refused([](hid_t target) { hostile::replace(target, "whole", {1.5}); },
          [](const Hdf5File& source) { (void)source.read_integers("whole"); });
}

TEST_F(Hdf5FileTest, APipeIsNotWaitedFor) {
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  EXPECT_NE(message_of([&] { Hdf5File::open(file()); }).find("no regular file"), std::string::npos);
}

TEST_F(Hdf5FileTest, ACrashOfTheLibraryIsAnErrorThatNamesTheFile) {
  EXPECT_NE(message_of([&] { read_with_care(file(), [] { raise(SIGKILL); }); }).find(file().string()),
            std::string::npos);
  int calls = 0;
  read_with_care(file(), [&] { ++calls; });
  EXPECT_EQ(calls, 1) << "the other call was in another process";
}

TEST_F(Hdf5FileTest, ThreadsWriteFilesSideBySide) {
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([this, t] {
        for (int repetition = 0; repetition < 10; ++repetition) {
          write_atomically(file(std::to_string(t)), [t](Hdf5File& target) {
            for (int i = 0; i < 10; ++i) target.write("d" + std::to_string(i), sines(600), "m");
            target.write_attribute("/", "thread", std::int64_t{t});
          });
        }
      });
    }
  }
  for (int t = 0; t < 4; ++t) {
    const Hdf5File source = Hdf5File::open(file(std::to_string(t)));
    EXPECT_EQ(source.read_integer_attribute("/", "thread"), t);
    EXPECT_EQ(source.read_doubles("d9"), sines(600));
  }
}

}  // namespace
}  // namespace slfb::io
