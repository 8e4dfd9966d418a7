#include "vnv/gate/source.hpp"

#include "vnv/files/whole_file.hpp"
#include "vnv/programs/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <map>
#include <regex>
#include <set>

namespace touchstone::gate {
namespace {

namespace fs = std::filesystem;

bool is_build(const fs::path& folder) {
  return fs::exists(folder / "CMakeCache.txt") && fs::is_directory(folder / "vnv");
}

/// The program of a case by the file that registers its methods with ctest, which the program wrote when it was built.
Program program_of(const fs::path& tests, const Choice& choice) {
  const std::string stem = tests.stem().string(), text = files::read_whole(tests);
  Program program{.case_name = stem.substr(0, stem.rfind("_tests")),
                  .is_timed = text.find("RUN_SERIAL TRUE") != text.npos};
  program.file = tests.parent_path() / program.case_name;
  const std::regex method("--method ([^ ]+) --suite " + choice.suite + " ");
  for (std::sregex_iterator at(text.begin(), text.end(), method), end; at != end; ++at)
    if (choice.includes(program.case_name, (*at)[1])) program.methods.push_back((*at)[1]);
  return program;
}

/// The chosen cases: those of the sources, and flows that the build made a case of. What lies in of_reports/ is left out
/// where acceptance is compared, which runs nothing of it.
std::set<std::string> chosen_cases(const fs::path& source, const fs::path& build, const Choice& choice) {
  std::set<std::string> chosen;
  for (const fs::path& folder : {source / "vnv/cases", source / "vnv/cases/of_reports", build / "vnv/cases"}) {
    if (!fs::is_directory(folder) || (choice.suite == "acceptance" && folder.filename() == "of_reports")) continue;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".cpp" && choice.includes_case(entry.path().stem()))
        chosen.insert(entry.path().stem());
  }
  return chosen;
}

Build build_in(const fs::path& folder, const fs::path& source, const Choice& choice) {
  Build build{folder, source};
  const std::set<std::string> chosen = chosen_cases(source, folder, choice);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder / "vnv")) {
    if (!entry.path().filename().string().ends_with("_tests.cmake")) continue;
    Program program = program_of(entry.path(), choice);
    program.data = source / "data";
    if (chosen.contains(program.case_name) && fs::exists(program.file) && !program.methods.empty())
      build.programs.push_back(std::move(program));
  }
  std::ranges::sort(build.programs, {}, &Program::case_name);
  if (build.programs.empty())
    throw BadInput(fmt::format("{}: no program of a chosen case with a method that {} runs; expected one built in {}",
                               folder.string(), choice.suite, (folder / "vnv").string()));
  return build;
}

vnv::Record read(const fs::path& file) try { return vnv::read_record(file); } catch (const std::runtime_error& error) {
  throw BadInput(error.what());
}

void require_one_suite(const Records& records, const std::string& name) {
  for (const vnv::Record& record : records)
    if (record.suite != records.front().suite)
      throw BadInput(fmt::format("{}: records of suites '{}' and '{}', expected those of one", name,
                                 records.front().suite, record.suite));
}

Records records_in(const fs::path& path, const Choice& choice) {
  std::vector<fs::path> files;
  if (!fs::is_directory(path)) files.push_back(path);
  if (fs::is_directory(path))
    for (const fs::directory_entry& entry : fs::directory_iterator(path))
      if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::ranges::sort(files);
  if (files.empty()) throw BadInput(fmt::format("{}: no records, expected at least one *.json", path.string()));
  Records records;
  for (const fs::path& file : files) {
    vnv::Record record = read(file);
    if (choice.includes(record.case_name, record.method)) records.push_back(std::move(record));
  }
  if (records.empty())
    throw BadInput(
        fmt::format("{}: {} records and none of a chosen method, expected at least one", path.string(), files.size()));
  require_one_suite(records, path.string());
  return records;
}

/// The commit that a name means in the repository around a folder; empty if there is none.
std::string commit_of(const std::string& name) {
  if (name.empty() || name.front() == '-') return "";
  const programs::CapturedOutput captured =
      programs::run_and_capture({"git", "rev-parse", "--verify", "--quiet", name + "^{commit}"});
  return captured.ending.succeeded() ? captured.output.substr(0, captured.output.find('\n')) : "";
}

/// "12 of 275 steps, about 4 min left", by the last line that Ninja wrote; that line itself if it counts no steps.
std::string steps_in(const std::string& line, std::chrono::duration<double> taken) {
  long done = 0, all = 0;
  if (std::sscanf(line.c_str(), "[%ld/%ld]", &done, &all) != 2 || done <= 0) return line;
  const double left = taken.count() / static_cast<double>(done) * static_cast<double>(all - done);
  return fmt::format("{} of {} steps, about {} left", done, all, programs::duration_in_words(left));
}

}  // namespace

std::string configured(const fs::path& folder, const std::string& name) {
  std::ifstream cache(folder / "CMakeCache.txt");
  for (std::string line; std::getline(cache, line);)
    if (line.starts_with(name + ":")) return line.substr(line.find('=') + 1);
  return "";
}

bool Choice::includes_case(const std::string& name) const {
  return cases.empty() || std::ranges::find(cases, name) != cases.end();
}

bool Choice::includes(const std::string& case_name, const std::string& method) const try {
  return includes_case(case_name) && (only.empty() || std::regex_search(case_name + "." + method, std::regex(only)));
} catch (const std::regex_error& error) {
  throw BadInput(fmt::format("only '{}': {}, expected a regular expression", only, error.what()));
}

Build Revisions::build(const std::string& commit, const Choice& choice, std::ostream& log) {
  log << fmt::format("gate: builds {}, which takes minutes\n", commit.substr(0, 12)) << std::flush;
  check_out(commit);
  run({"cmake", "-S", source(), "-B", folder(), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DTOUCHSTONE_NATIVE=ON"},
      "configured");
  const std::set<std::string> cases = chosen_cases(source(), folder(), choice);
  if (cases.empty()) throw BadInput(fmt::format("{}: no such case in it that {} runs", commit, choice.suite));
  std::vector<std::string> build = {"cmake", "--build", folder(), "--target"};
  build.insert(build.end(), cases.begin(), cases.end());
  run(build, "built");
  const fs::path kept = scratch_ / commit;  // of what the next revision overwrites, what is run and compared
  fs::remove_all(kept);
  const auto keep = [&](const fs::path& from, const fs::path& part) {
    if (!fs::exists(from / part)) return;
    fs::create_directories((kept / part).parent_path());
    fs::copy(from / part, kept / part, fs::copy_options::recursive);
  };
  keep(source(), "build/vnv");
  keep(source(), "vnv/cases");
  keep(source(), "data");
  return build_in(kept / "build", kept, choice);
}

void Revisions::check_out(const std::string& commit) const {
  if (!fs::exists(source()))
    run({"git", "-C", repository_, "worktree", "add", "--detach", source(), commit}, "checked out");
  else
    run({"git", "-C", source(), "checkout", "--detach", commit}, "checked out");
}

void Revisions::run(const programs::Words& words, const std::string& what) const {
  const fs::path output = scratch_ / "output";
  const auto start = std::chrono::steady_clock::now();
  programs::Progress line("gate");
  const auto words_of_line = [&] {
    return steps_in(programs::last_lines(output, 1), std::chrono::steady_clock::now() - start);
  };
  if (!programs::run_into(output, words, [&] { line.show(words_of_line); }).succeeded())
    throw BadInput(fmt::format("{}: cannot be {}:\n{}", source().string(), what, programs::last_lines(output, 20)));
}

void Revisions::forget_source() const {
  if (!fs::exists(source())) return;
  try {
    programs::run_into(scratch_ / "output", {"git", "-C", repository_, "worktree", "remove", "--force", source()});
  } catch (...) {  // interrupted once more: what is left is removed with the folder, and forgotten by git in time
  }
}

Source open_source(const std::string& name, const Choice& choice, Revisions& revisions, std::ostream& log) {
  Source source{.name = name};
  if (fs::is_directory(name) && is_build(name)) {
    source.build = build_in(fs::absolute(name), configured(name, "CMAKE_HOME_DIRECTORY"), choice);
  } else if (fs::exists(name)) {
    source.records = records_in(name, choice);
  } else {
    const std::string commit = commit_of(name);
    if (commit.empty())
      throw BadInput(fmt::format("{}: neither a record, a folder of records, a build folder nor a git revision", name));
    source.build = revisions.build(commit, choice, log);
  }
  return source;
}

namespace {

void mask(std::string& bytes, const std::string& text) {
  if (text.empty()) return;
  for (std::size_t at = bytes.find(text); at != bytes.npos; at = bytes.find(text, at + text.size()))
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(at), text.size(), '*');
}

using Texts = std::map<std::string, std::string>;  // by file, within its folder

/// The compiled files of a case and of each library that it may be linked with, but for the one that holds the
/// revision.
std::map<std::string, Texts> objects_of(const Build& build, const std::string& case_name) {
  static const std::set<std::string> not_of_cases = {"vnv_command", "vnv_subcommands", "vnv_gate", "vnv_programs"};
  const fs::path folder = build.folder / "vnv/CMakeFiles";
  std::map<std::string, Texts> objects;
  if (!fs::is_directory(folder)) return objects;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path file = entry.path().lexically_relative(folder);
    const std::string target = file.begin()->stem().string();
    const bool is_library = target.starts_with("vnv") && !target.ends_with("_test") && !target.ends_with("_headers");
    if (target != case_name && (!is_library || not_of_cases.contains(target))) continue;
    if (file.extension() != ".o" || file.filename() == "environment.cpp.o") continue;
    std::string& bytes = objects[target][file.string()] = files::read_whole(entry.path());
    mask(bytes, build.folder.string());
    mask(bytes, build.source.string());
  }
  return objects;
}

bool are_compiled_alike(const Build& before, const Build& after, const Program& program, const Program& other) {
  if (files::read_whole(program.file) == files::read_whole(other.file)) return true;
  const auto objects = objects_of(before, program.case_name), others = objects_of(after, program.case_name);
  const auto are_alike = [&](const auto& target) {  // a library that one build lacks is not linked with the case
    const auto found = others.find(target.first);
    return found == others.end() ? target.first != program.case_name : found->second == target.second;
  };
  return objects.contains(program.case_name) && std::ranges::all_of(objects, are_alike);
}

/// The data that a case may read: all, but for the baselines of others.
Texts data_of(const Build& build, const std::string& case_name) {
  Texts data;
  const fs::path folder = build.source / "data";
  if (!fs::is_directory(folder)) return data;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const bool is_baseline = entry.path().parent_path().filename() == "baselines";
    if (entry.is_regular_file() && (!is_baseline || entry.path().stem() == case_name))
      data[entry.path().lexically_relative(folder).string()] = files::read_whole(entry.path());
  }
  return data;
}

}  // namespace

bool are_same_programs(const Build& before, const Build& after, const Program& program, const Program& other) {
  return program.methods == other.methods && are_compiled_alike(before, after, program, other) &&
         data_of(before, program.case_name) == data_of(after, program.case_name);
}

}  // namespace touchstone::gate
