#include "vnv/files/whole_file.hpp"

#include "vnv/files/held_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace touchstone::files {
namespace {

namespace fs = std::filesystem;

class AWholeFile : public testing::Test {
 protected:
  AWholeFile() { fs::create_directories(folder_); }
  ~AWholeFile() override { fs::remove_all(folder_); }

  std::string text() const {
    std::ifstream stream(file_);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  const fs::path folder_ = fs::path(testing::TempDir()) /
                           ("whole_file." + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
  const fs::path file_ = folder_ / "record.json";
};

TEST_F(AWholeFile, TakesThePlaceOfTheFormerOneAndLeavesNothingBesideIt) {
  write_whole(file_, std::string(100000, 'a'));
  write_whole(file_, "second\n");
  EXPECT_EQ(text(), "second\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(AWholeFile, HasAFolderMadeForItWithThoseAbove) {
  make_folder(folder_ / "a" / "b");
  make_folder(folder_ / "a" / "b");
  EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
  write_whole(file_, "no folder");
  for (const fs::path& folder : {file_, file_ / "below"}) {
    try {
      make_folder(folder);
      ADD_FAILURE() << folder << " was made";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(error.what(), folder.string() + ": no folder can be made: Not a directory");
    }
  }
}

TEST_F(AWholeFile, LeavesTheFormerOneWhereTheDiskIsFull) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  write_whole(file_, "first\n");
  fs::create_symlink("/dev/full", neighbour(file_, "part"));
  EXPECT_THROW(write_whole(file_, "second\n"), std::runtime_error);
  EXPECT_EQ(text(), "first\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(AWholeFile, SaysWhichAndWhyItCannotBeWritten) {
  try {
    write_whole(folder_ / "nowhere" / "record.json", "text");
    FAIL() << "written";
  } catch (const std::runtime_error& error) {
    EXPECT_EQ(error.what(),
              (folder_ / "nowhere" / "record.json").string() + ": cannot be written: No such file or directory");
  }
}

TEST_F(AWholeFile, RemovesWhatAKilledWriterLeftButNotWhatAnotherStillWrites) {
  const fs::path of_none = folder_ / ".record.json.999999999.part", of_one_that_runs = folder_ / ".record.json.1.part";
  std::ofstream(of_none) << "torn";
  std::ofstream(of_one_that_runs) << "half";
  write_whole(file_, "text");
  EXPECT_FALSE(fs::exists(of_none));
  EXPECT_TRUE(fs::exists(of_one_that_runs));
}

TEST_F(AWholeFile, InAHeldFolderLosesNothingOfThoseWhoAddToItAtOnce) {
  for (int k = 0; k < 4; ++k)
    if (fork() == 0) {
      for (int line = 0; line < 5; ++line) {
        const HeldFolder held(folder_);
        const std::string former = text();
        usleep(1000);
        write_whole(file_, former + "x");
      }
      _exit(0);
    }
  while (wait(nullptr) > 0) continue;
  EXPECT_EQ(text(), std::string(20, 'x'));
}

TEST_F(AWholeFile, RemovesWhatAKilledWriterLeftThatNobodyHasWaitedForYet) {
  const pid_t writer = fork();
  if (writer == 0) _exit(0);
  siginfo_t ending;
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(writer), &ending, WEXITED | WNOWAIT), 0);
  const fs::path part = folder_ / (".record.json." + std::to_string(writer) + ".part");
  std::ofstream(part) << "torn";
  write_whole(file_, "text");
  EXPECT_FALSE(fs::exists(part));
  waitpid(writer, nullptr, 0);
}

}  // namespace
}  // namespace touchstone::files
