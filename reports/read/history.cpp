#include "reports/read/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace touchstone::reports {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> night_files(const fs::path& folder) {
  std::error_code cause;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, cause))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  if (cause) throw std::runtime_error(fmt::format("{}: cannot be read: {}", folder.string(), cause.message()));
  std::ranges::sort(files);
  return files;
}

}  // namespace

History read_history(const fs::path& folder, const std::string& suite) {
  History history;
  for (const auto& file : night_files(folder)) try {
      Night night = read_night(file);
      if (night.suite == suite) history.nights.push_back(std::move(night));
    } catch (const std::runtime_error& error) {
      history.refused.emplace_back(error.what());
    }
  std::ranges::stable_sort(history.nights, {}, &Night::finished_at);
  return history;
}

}  // namespace touchstone::reports
