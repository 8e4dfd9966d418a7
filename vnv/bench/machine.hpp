#pragma once
/// What one core of this machine can do at most, measured.

#include <string>
#include <vector>

namespace touchstone::bench {

/// Floating-point operations a second when a core multiplies and adds in registers and does nothing else; one fused
/// operation counts twice, as is usual.
template <class Real>
double multiply_add_peak();

/// A level of the memory, by what the system says of its size.
struct MemoryLevel {
  std::string name;  // "L1"
  double bytes;      // that one core can fill; of the last, far more than all caches
};
std::vector<MemoryLevel> memory_levels();

/// Bytes a second of a = b + s c (McCalpin's triad, counted as two reads and one write) over three arrays that fill
/// half a level.
double triad_bandwidth(const MemoryLevel& level);

/// The smallest level that holds so many bytes.
const MemoryLevel& level_that_holds(double bytes, const std::vector<MemoryLevel>& levels);

}  // namespace touchstone::bench
