#include "vnv/programs/progress.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace touchstone::programs {
namespace progress_test {

using std::chrono::milliseconds;
using std::chrono::seconds;

const Work::Clock::time_point start = Work::Clock::now();

/// One part ends so many seconds after the start, and another begins.
void turn(Work& work, const std::string& from, const std::string& to, int second) {
  work.end(from, start + seconds(second));
  work.begin(to, start + seconds(second));
}

/// Parts that each took so many seconds last time.
Work expecting(const std::vector<std::pair<std::string, double>>& parts, Work work = Work()) {
  for (const auto& [name, last] : parts) work.expect(name, last);
  return work;
}

TEST(Durations, AreToldInTwoUnitsAtMost) {
  EXPECT_EQ(duration_in_words(0.4), "0 s");
  EXPECT_EQ(duration_in_words(59.4), "59 s");
  EXPECT_EQ(duration_in_words(59.6), "1 min");
  EXPECT_EQ(duration_in_words(3570), "1 h");
  EXPECT_EQ(duration_in_words(7500), "2 h 5 min");
}

TEST(WorkThatIsLeft, IsWhatItsPartsTookLast) {
  Work work = expecting({{"a", 30}, {"b", 60}});
  work.begin("a", start);
  EXPECT_EQ(work.left(start), 90);
  EXPECT_EQ(work.left(start + seconds(20)), 70);
  turn(work, "a", "b", 30);
  EXPECT_EQ(work.left(start + seconds(30)), 60);
}

TEST(WorkThatIsLeft, IsSharedByWhatRunsBesideEachOtherAndEndsWithTheLongest) {
  Work work;
  for (const char* name : {"a", "b", "c", "d"}) work.expect(name, 30);
  work.expect("timed", 10, true);
  work.begin("a", start);
  work.begin("b", start);
  EXPECT_EQ(work.left(start), 120 / 2 + 10);
  Work unequal = expecting({{"long", 100}, {"short", 10}});
  unequal.begin("long", start);
  unequal.begin("short", start);
  EXPECT_EQ(unequal.left(start), 100);
}

TEST(WorkThatIsLeft, TakesAsMuchLongerAsWhatHasEndedDid) {
  Work work = expecting({{"a", 90}, {"b", 50}});
  work.begin("a", start);
  turn(work, "a", "b", 190);  // twice as long, were ten seconds more expected and taken
  EXPECT_EQ(work.left(start + seconds(190)), 100);
  EXPECT_EQ(work.left(start + seconds(190 + 400)), 40) << "what is overdue takes a tenth more";
}

TEST(WorkThatIsLeft, IsUnknownBeforeAnythingIsKnownOrRuns) {
  EXPECT_EQ(expecting({{"a", 10}}).sentence(start), "0 of 1 done; none runs yet");
  Work first_time;
  first_time.expect("a", std::nullopt);
  first_time.begin("a", start);
  EXPECT_EQ(first_time.sentence(start + seconds(3)), "0 of 1 done, 1 of unknown cost; now a 3 s");
}

TEST(WorkThatIsLeft, IsToldByOtherMeasuresOnceAPartHasEnded) {
  Work files = expecting({{"a", 1e6}, {"b", 3e6}}, Work(0));  // by their bytes
  files.begin("a", start);
  EXPECT_EQ(files.left(start), std::nullopt);
  turn(files, "a", "b", 2);
  EXPECT_EQ(files.sentence(start + seconds(2)), "1 of 2 done, about 6 s left; now b 0 s");
}

TEST(WorkThatIsLeft, IsCalledAGuessWhileAnyOfItIs) {
  Work work = expecting({{"a", 10}});
  work.guess("b", 20);
  work.begin("b", start);
  EXPECT_EQ(work.sentence(start), "0 of 2 done, perhaps 30 s left; now b 0 s");
  turn(work, "b", "a", 20);
  EXPECT_EQ(work.sentence(start + seconds(20)), "1 of 2 done, about 10 s left; now a 0 s");
}

TEST(WorkThatIsLeft, IsToldWithWhatRunsAndWhatNobodyKnows) {
  Work work = expecting({{"a.mpm", 10}, {"b.sph", 300}});
  work.expect("c.sph", std::nullopt);
  work.begin("a.mpm", start);
  work.end("a.mpm", start + seconds(10));
  work.begin("c.sph", start + seconds(10));
  work.begin("b.sph", start + seconds(12));
  EXPECT_EQ(work.sentence(start + seconds(72)),
            "1 of 3 done, about 4 min left and 1 of unknown cost; now c.sph 1 min, b.sph 1 min");
}

TEST(AProgressLine, IsRewrittenInPlaceOnATerminalAndGoneAtTheEnd) {
  std::ostringstream out;
  {
    Progress line("vnv", out, 12);
    line.show([] { return "δ = 1 and more"; }, start);
    line.show([] { return "too soon"; }, start + milliseconds(100));
    line.show([] { return "2"; }, start + milliseconds(300));
  }
  EXPECT_EQ(out.str(), "\r\x1b[Kvnv: δ = 1 \r\x1b[Kvnv: 2\r\x1b[K");
}

TEST(AProgressLine, IsAPlainLineFromTimeToTimeInALog) {
  std::ostringstream out;
  {
    Progress line("vnv", out, 0);
    const auto now = Progress::Clock::now();
    for (int second = 0; second <= 7200; ++second)
      line.show([&] { return std::to_string(second); }, now + seconds(second));
  }
  EXPECT_TRUE(out.str().starts_with("vnv: 60\nvnv: 120\nvnv: 180\n")) << out.str();
  EXPECT_EQ(out.str().find_first_of("\r\x1b"), std::string::npos);
  const auto lines = std::ranges::count(out.str(), '\n');
  EXPECT_GT(lines, 30);
  EXPECT_LT(lines, 60) << "fewer as work goes on";
}

}  // namespace progress_test
}  // namespace touchstone::programs
