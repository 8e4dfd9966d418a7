#include "vnv/doors/client/touchstone/solver.hpp"

#include "vnv/doors/read/dataset.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

namespace touchstone::vnv::doors {
namespace client_test {

/// Numbers of which decimal digits keep nothing but the shortest that are unique: thirds, tiny and huge ones.
class Thirds {
 public:
  explicit Thirds(const client::Scene& scene) : third_(scene["nu"] / 3) {}
  void step() { time_ += 0.1; }
  double time() const { return time_; }
  client::Samples samples() const {
    return {.x = {third_, 1e-300 / 3}, .y = {time_, 5e-324}, .v_x = {1e300 / 3, -0.0}, .v_y = {0.1 + 0.2, -time_ / 3}};
  }

 private:
  double third_, time_ = 0;
};

class Lame : public Thirds {
 public:
  using Thirds::Thirds;
  client::Samples samples() const { return {.x = {1, 2}, .y = {1, 2}, .v_x = {1}}; }
};

class Changing : public Thirds {
 public:
  using Thirds::Thirds;
  client::Samples samples() const {
    return time() < 0.15 ? client::Samples{.x = {1}, .y = {1}, .p = {1}} : client::Samples{.x = {1}, .y = {1}};
  }
};

class Stuck : public Thirds {
 public:
  using Thirds::Thirds;
  void step() {}
};

/// Ends each step where it is told, but for steps above a length.
class Exact : public Thirds {
 public:
  using Thirds::Thirds;
  void step(double at_most) { now_ += std::min(at_most, 0.04); }
  double time() const { return now_; }

 private:
  double now_ = 0;
};

/// Knows nothing of what moves across.
class Along : public Thirds {
 public:
  using Thirds::Thirds;
  client::Samples samples() const { return {.x = {1, 2}, .y = {1, 2}, .v_x = {3, 4}}; }
};

const programs::ScratchFolder& folder() {
  static const programs::ScratchFolder one;
  return one;
}
const client::Scene scene{.spacing = 0.1, .start = {}, .parameters = {{"H", 1}, {"nu", 1}}};

template <class Solver>
std::vector<Dataset> written_by(const std::vector<double>& times) {
  const std::string file = folder() / "samples.csv";
  client::write_samples<Solver>(scene, times, file);
  return read_datasets(file);
}

template <class Solver>
std::string refusal() {
  try {
    client::write_samples<Solver>(scene, {0.1, 0.2}, folder() / "none.csv");
  } catch (const std::exception& error) {
    EXPECT_FALSE(std::filesystem::exists(folder() / "none.csv"));
    return error.what();
  }
  return "";
}

TEST(ClassesOfOthers, HandOverTheirNumbersToTheLastBit) {
  const std::vector<Dataset> all = written_by<Thirds>({0.1, 0.3});
  ASSERT_EQ(all.size(), 2u);
  Thirds expected(scene);
  for (const Dataset& data : all) {
    while (expected.time() < *data.time) expected.step();
    EXPECT_EQ(*data.time, expected.time());
    const client::Samples s = expected.samples();
    for (const auto& [name, values] :
         {std::pair("x [m]", s.x), {"y [m]", s.y}, {"v_x [m/s]", s.v_x}, {"v_y [m/s]", s.v_y}})
      for (std::size_t row = 0; row < values.size(); ++row)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(data.array(name)->values.at(row)),
                  std::bit_cast<std::uint64_t>(values[row]))
            << name << " " << row;
    EXPECT_EQ(data.array("p [Pa]"), nullptr) << "what a solver does not have is not written";
  }
}

TEST(ClassesOfOthers, MayLeaveWhatTheyDoNotHaveEmpty) {
  const std::vector<Dataset> all = written_by<Along>({0.1});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_NE(all[0].array("v_x [m/s]"), nullptr);
  EXPECT_EQ(all[0].array("v_y [m/s]"), nullptr);
}

TEST(ClassesOfOthers, EndTheirStepsAtTheTimesAskedForIfTheyCan) {
  const std::vector<Dataset> all = written_by<Exact>({0.1, 0.25});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(*all[0].time, 0.1);
  EXPECT_EQ(*all[1].time, 0.25);
}

TEST(ClassesOfOthers, AreRefusedWhereTheirSamplesOrTimesCannotBe) {
  EXPECT_EQ(refusal<Lame>(), "samples(): 1 values of v_x [m/s], expected 2 as of x");
  EXPECT_EQ(refusal<Changing>(), "samples(): t [s],x [m],y [m], expected t [s],x [m],y [m],p [Pa] as before");
  EXPECT_EQ(refusal<Stuck>(), "step() left the time at 0.000000 s");
  EXPECT_THROW(scene["mu"], std::invalid_argument);
}

TEST(ClassesOfOthers, AreConfiguredByTheWordsOfTheirProgram) {
  files::write_whole(folder() / "particles.csv",
                     "x [m],y [m],v_x [m/s],v_y [m/s],p [Pa],rho [kg/m³],mass [kg/m]\n1,2,3,4,5,6,7\n");
  struct FromStart {
    explicit FromStart(const client::Scene& from) : seen(from.start), time_(from["t0"]) { seen.mass.clear(); }
    void step() { time_ += 1; }
    double time() const { return time_; }
    const client::Samples& samples() const { return seen; }
    client::Samples seen;
    double time_;
  };
  const auto status = [](std::vector<std::string> words) {
    std::vector<char*> all;
    for (std::string& word : words) all.push_back(word.data());
    return client::run<FromStart>(static_cast<int>(all.size()), all.data());
  };
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder().path());
  EXPECT_EQ(status({"me", "0.1", "1", "particles.csv", "a=1,t0=0.5"}), 0);
  EXPECT_EQ(status({"me", "0.1", "1", "nothing.csv", "t0=0"}), 1);
  EXPECT_EQ(status({"me", "0.1", "soon", "particles.csv", "t0=0"}), 1);
  EXPECT_EQ(status({"me", "0.1", "1", "particles.csv"}), 1);
  std::filesystem::current_path(before);
  EXPECT_EQ(files::read_whole(folder() / "samples.csv"),
            "t [s],x [m],y [m],v_x [m/s],v_y [m/s],p [Pa],rho [kg/m³]\n1.5,1,2,3,4,5,6\n");
}

}  // namespace client_test
}  // namespace touchstone::vnv::doors
