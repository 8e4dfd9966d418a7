#pragma once
/// A site that is whole or not there.

#include "vnv/programs/interruption.hpp"

#include <filesystem>
#include <string>

namespace touchstone::reports {

/// A folder beside another, in which that other is made anew; what is not published is removed. What asks this program
/// to end waits so long, or until it is asked for.
class Staging {
 public:
  /// Throws std::runtime_error if the place is not writable, or holds what is no site, which would be lost.
  explicit Staging(std::filesystem::path site);
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  const std::filesystem::path& folder() const { return folder_; }

  /// Throws programs::Interrupted if this program was asked to end.
  void stop_if_told() const { held_.stop_if_told(site_.string()); }
  /// The staged folder takes the place of the site, which is removed; where the system can, in one step, so that there
  /// is a whole site whenever this is killed.
  void publish();
  /// One staged file takes its place in the site; all else stays.
  void publish_file(const std::string& name);

 private:
  programs::HeldSignals held_;
  std::filesystem::path site_, folder_;
};

}  // namespace touchstone::reports
