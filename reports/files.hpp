#pragma once
/// Files and folders that are whole or not there.

#include <filesystem>
#include <string>

namespace touchstone::reports {

/// Throws std::runtime_error naming the file and the cause.
void save(const std::filesystem::path& file, const std::string& text);

/// The same, whole or not at all: to a neighbouring temporary name, then renamed.
void save_whole(const std::filesystem::path& file, const std::string& text);

/// A folder beside another, in which that other is made anew; what is not published is removed.
class Staging {
 public:
  /// Throws std::runtime_error if the place is not writable, or holds what is no site, which would be lost.
  explicit Staging(std::filesystem::path site);
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  /// The staged folder takes the place of the site, which is removed.
  void publish();
  /// One staged file takes its place in the site; all else stays.
  void publish_file(const std::string& name);

 private:
  std::filesystem::path site_, folder_;
};

}  // namespace touchstone::reports
