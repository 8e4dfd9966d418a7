#include "vnv/programs/interruption.hpp"

#include "vnv/programs/processes.hpp"
#include "vnv/programs/programs.hpp"
#include "vnv/programs/scratch_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>

#include <cstdio>
#include <fstream>
#include <functional>

namespace touchstone::programs {
namespace {

using namespace std::chrono_literals;

void say(const Streams& streams, const std::string& line) {
  if (write(streams.output, (line + "\n").data(), line.size() + 1) < 0) _exit(9);
}

/// A process that works with programs as `vnv` does. It and they write into a pipe, which ends with the last of them.
class Starter {
 public:
  explicit Starter(const std::function<void(const Streams&)>& work) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    std::fflush(nullptr);  // else what waits to be printed is printed twice
    id_ = fork();
    if (id_ == 0) {
      setpgid(0, 0);  // an orphaned process group cannot be paused
      for (const int one : {SIGTERM, SIGINT, SIGHUP})
        signal(one, SIG_DFL);  // who runs the tests may ignore them: nohup
      close(ends[0]);
      _exit(done(work, {.output = ends[1], .errors = ends[1]}));
    }
    close(ends[1]);
    said_ = ends[0];
  }
  ~Starter() {
    if (id_ > 0) kill(id_, SIGKILL);
    ending();
    close(said_);
  }
  Starter(const Starter&) = delete;
  Starter& operator=(const Starter&) = delete;

  /// The next line that any of them writes; empty when all have ended, "..." if they neither end nor write for 20 s.
  std::string line() const {
    std::string text;
    pollfd heard{.fd = said_, .events = POLLIN, .revents = 0};
    while (poll(&heard, 1, 20000) > 0) {
      char letter = 0;
      if (read(said_, &letter, 1) != 1 || letter == '\n') return text;
      text += letter;
    }
    return "...";
  }

  void tell(int signal) const { kill(id_, signal); }

  /// Waits until it pauses; whether it does.
  bool pauses() const {
    int status = 0;
    return waitpid(id_, &status, WUNTRACED) == id_ && WIFSTOPPED(status);
  }

  Ending ending() {
    if (id_ > 0) waitpid(id_, &status_, 0);
    id_ = 0;
    return {.status = WIFEXITED(status_) ? WEXITSTATUS(status_) : 0,
            .signal = WIFSIGNALED(status_) ? WTERMSIG(status_) : 0};
  }

 private:
  static int done(const std::function<void(const Streams&)>& work, const Streams& streams) {
    try {
      work(streams);
    } catch (const Interrupted& told) {
      say(streams, told.sentence());
      end_by(told.signal);
    }
    return 0;
  }

  pid_t id_ = 0;
  int said_ = -1, status_ = 0;
};

/// Runs a script of the shell to its end.
auto runs(const std::string& script, std::chrono::milliseconds grace = 20s) {
  return [=](const Streams& streams) {
    Running running(grace);
    running.start("script", {"sh", "-c", script}, streams);
    while (!running.wait(1s)) continue;
  };
}

TEST(ToldToEnd, EndsItsProgramThenItselfByTheSameSignal) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    Starter starter(runs("echo begun; exec sleep 60"));
    EXPECT_EQ(starter.line(), "begun");
    starter.tell(signal);
    EXPECT_EQ(starter.line(), (Interrupted{signal, "script"}.sentence()));
    EXPECT_EQ(starter.line(), "");
    EXPECT_EQ(starter.ending().signal, signal);
  }
}

TEST(ToldToEnd, SaysByWhatAndWhatItBrokeOff) {
  EXPECT_EQ((Interrupted{SIGTERM, "a.mpm, b.sph"}.sentence()), "interrupted by signal 15 (Terminated): a.mpm, b.sph");
}

TEST(ToldToEnd, EndsWhatItsProgramStartedToo) {
  Starter starter(runs("sleep 60 & sleep 60 & echo begun; wait"));
  EXPECT_EQ(starter.line(), "begun");
  starter.tell(SIGTERM);
  EXPECT_NE(starter.line(), "");
  EXPECT_EQ(starter.line(), "");
}

TEST(ToldToEnd, EndsAllThatRunBesideEachOther) {
  Starter starter([](const Streams& streams) {
    Running running(20s);
    for (const char* name : {"one", "two"}) running.start(name, {"sh", "-c", "echo begun; exec sleep 60"}, streams);
    while (!running.wait(1s)) continue;
  });
  EXPECT_EQ(starter.line() + starter.line(), "begunbegun");
  starter.tell(SIGTERM);
  const std::string told = starter.line();
  EXPECT_TRUE(told.ends_with(": one, two") || told.ends_with(": two, one")) << told;
  EXPECT_EQ(starter.line(), "");
}

TEST(ToldToEnd, LetsAProgramTidyUp) {
  Starter starter(runs("trap 'echo tidied; exit 1' TERM; echo begun; sleep 60 & wait"));
  EXPECT_EQ(starter.line(), "begun");
  starter.tell(SIGTERM);
  EXPECT_EQ(starter.line(), "tidied");
}

TEST(ToldToEnd, KillsAProgramThatDoesNotListen) {
  Starter starter(runs("trap '' TERM; echo begun; while :; do sleep 1; done", 100ms));
  EXPECT_EQ(starter.line(), "begun");
  starter.tell(SIGTERM);
  EXPECT_EQ(starter.line(), (Interrupted{SIGTERM, "script"}.sentence()));
  EXPECT_EQ(starter.line(), "");
  EXPECT_EQ(starter.ending().signal, SIGTERM);
}

TEST(ToldToEnd, TwiceDoesNotWait) {
  Starter starter(runs("trap '' TERM INT; echo begun; while :; do sleep 1; done", 1h));
  EXPECT_EQ(starter.line(), "begun");
  starter.tell(SIGTERM);
  starter.tell(SIGINT);
  EXPECT_NE(starter.line(), "...");
  EXPECT_EQ(starter.line(), "");
}

TEST(ToldToEnd, LeavesNoScratchFolder) {
  Starter starter([](const Streams& streams) {
    const ScratchFolder folder;
    say(streams, folder.path());
    runs("echo begun; exec sleep 60")(streams);
  });
  const std::filesystem::path folder = starter.line();
  EXPECT_EQ(starter.line(), "begun");
  EXPECT_TRUE(std::filesystem::is_directory(folder));
  starter.tell(SIGTERM);
  EXPECT_EQ(starter.ending().signal, SIGTERM);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(ToldToEnd, WhileItRunsNoProgramEndsWhenItsScratchFolderIsGone) {
  Starter starter([](const Streams& streams) {
    const ScratchFolder folder;
    say(streams, folder.path());
    sigset_t waiting;
    do {
      sigpending(&waiting);
    } while (!sigismember(&waiting, SIGTERM));
  });
  const std::filesystem::path folder = starter.line();
  EXPECT_TRUE(std::filesystem::is_directory(folder));
  starter.tell(SIGTERM);
  EXPECT_EQ(starter.ending().signal, SIGTERM);
  EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST(ToldToEnd, BySignalsThatItWasStartedToIgnoreGoesOn) {
  Starter starter([](const Streams& streams) {
    std::signal(SIGHUP, SIG_IGN);
    runs("echo begun; sleep 0.2; echo ended")(streams);
  });
  EXPECT_EQ(starter.line(), "begun");
  starter.tell(SIGHUP);
  EXPECT_EQ(starter.line(), "ended");
  EXPECT_TRUE(starter.ending().succeeded());
}

TEST(ToldToPause, PausesItsProgramAndGoesOnWithIt) {
  Starter starter(runs("echo $$; exec sleep 60"));
  const std::string stat = "/proc/" + starter.line() + "/stat";
  const auto state = [&stat] {
    std::ifstream file(stat);
    std::string id, name, letter;
    file >> id >> name >> letter;
    return letter;
  };
  starter.tell(SIGTSTP);
  ASSERT_TRUE(starter.pauses());
  for (int k = 0; k < 20000 && state() != "T"; ++k) usleep(1000);
  EXPECT_EQ(state(), "T");
  starter.tell(SIGCONT);
  for (int k = 0; k < 20000 && state() == "T"; ++k) usleep(1000);
  EXPECT_NE(state(), "T");
  starter.tell(SIGTERM);
  EXPECT_EQ(starter.line(), (Interrupted{SIGTERM, "script"}.sentence()));
  EXPECT_EQ(starter.line(), "");
}

TEST(AProcessThatIsKilled, TakesItsProgramAlong) {
  Starter starter(runs("echo begun; exec sleep 60"));
  EXPECT_EQ(starter.line(), "begun");
  starter.tell(SIGKILL);
  EXPECT_EQ(starter.line(), "");
}

TEST(AProcessThatIsKilled, TakesAlongWhatItsProgramStartedInSessionsOfTheirOwnAndWhatDoesNotListen) {
  Starter starter(
      runs("trap '' TERM; setsid sh -c 'trap \"\" TERM; echo begun; sleep 60' & while :; do sleep 1; done", 100ms));
  EXPECT_EQ(starter.line(), "begun");
  starter.tell(SIGKILL);
  EXPECT_EQ(starter.line(), "");
}

TEST(AProcessThatIsKilled, LetsItsProgramTidyUp) {
  Starter starter(runs("trap 'echo tidied; exit 1' TERM; echo begun; sleep 60 & wait"));
  EXPECT_EQ(starter.line(), "begun");
  starter.tell(SIGKILL);
  EXPECT_EQ(starter.line(), "tidied");
}

TEST(AProcessThatThrows, EndsItsProgram) {
  Starter starter([](const Streams& streams) {
    try {
      Running running(20s);
      running.start("script", {"sh", "-c", "echo begun; exec sleep 60"}, streams);
      throw std::runtime_error("something else");
    } catch (const std::runtime_error& error) {
      say(streams, error.what());
    }
  });
  std::string all = starter.line();  // what the script writes first may come to be written or not
  if (all == "begun") all = starter.line();
  EXPECT_EQ(all, "something else");
  EXPECT_EQ(starter.line(), "");
}

TEST(AnOrdinaryRun, LeavesSignalsAsTheyWere) {
  const auto holds_any = [] {
    sigset_t now;
    sigprocmask(SIG_BLOCK, nullptr, &now);
    return sigismember(&now, SIGTERM) || sigismember(&now, SIGINT) || sigismember(&now, SIGCHLD);
  };
  {
    const ScratchFolder folder;
    EXPECT_TRUE(run_into(folder.path() / "output", {"true"}).succeeded());
    EXPECT_TRUE(holds_any());
  }
  EXPECT_FALSE(holds_any());
}

TEST(AnOrdinaryRun, GivesTheProgramSignalsThatNobodyHolds) {
  const ScratchFolder folder;
  const auto before = std::signal(SIGINT, SIG_DFL);  // a shell that runs the tests behind its back ignores it
  EXPECT_EQ(run_and_capture({"sh", "-c", "kill -TERM $$; sleep 60"}).ending.signal, SIGTERM);
  EXPECT_THROW(run_into(folder.path() / "output", {"sh", "-c", "kill -INT $$; sleep 60"}), std::runtime_error);
  std::signal(SIGINT, before);
}

TEST(AnOrdinaryRun, EndsAsTheProgramDoes) {
  for (const int status : {0, 1, 3, 126, 127, 128, 143, 255})
    EXPECT_EQ(run_here({"sh", "-c", fmt::format("exit {}", status)}).status, status);
  for (const int signal : {SIGILL, SIGABRT, SIGFPE, SIGKILL, SIGSEGV, SIGUSR1, SIGXCPU})
    EXPECT_EQ(run_here({"sh", "-c", fmt::format("kill -{} $$; sleep 60", signal)}).signal, signal);
}

TEST(AnOrdinaryRun, LeavesNoProcess) {
  const auto before = descendants_of(getpid()).all;
  {
    Running running;
    for (int k = 0; k < 20; ++k) running.start("script", {"sh", "-c", "sleep 0.05 & exit 0"}, Streams{});
    for (int k = 0; k < 20; ++k) ASSERT_TRUE(running.wait(20s));
    while (running.wait(200ms)) continue;
    EXPECT_EQ(descendants_of(getpid()).all, before) << "what they left behind, and has ended, is waited for";
  }
}

}  // namespace
}  // namespace touchstone::programs
