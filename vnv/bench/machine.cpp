#include "vnv/bench/machine.hpp"

#include "vnv/bench/in_turn.hpp"

#include <unistd.h>

#include <array>

namespace touchstone::bench {
namespace {

/// Keeps a value, and so what led to it, from being optimised away.
template <class Value>
void keep(Value& value) {
  asm volatile("" : "+m"(value) : : "memory");
}

/// One register of the processor compiled for.
template <class Real>
struct Register {
  using type [[gnu::vector_size(__BIGGEST_ALIGNMENT__)]] = Real;
};

/// Ten chains hide the latency of a fused operation and leave registers for its operands among sixteen.
template <class Real>
void multiply_and_add(long times) {
  using Lanes = typename Register<Real>::type;
  std::array<Lanes, 10> chain{};
  Lanes scale = Lanes{} + Real(0.999), step = Lanes{} + Real(1e-3);
  keep(scale);
  keep(step);
  for (long k = 0; k < times; ++k)
    for (Lanes& x : chain) x = x * scale + step;
  for (Lanes& x : chain) keep(x);
}

/// Bytes of a cache, or a usual size where the system does not say.
double cache(int which, double usual) {
  const long bytes = sysconf(which);
  return bytes > 0 ? static_cast<double>(bytes) : usual;
}

}  // namespace

template <class Real>
double multiply_add_peak() {
  constexpr long times = 100000;
  constexpr double operations = 2.0 * 10 * __BIGGEST_ALIGNMENT__ / sizeof(Real) * times;
  return operations / time_in_turn({[] { multiply_and_add<Real>(times); }}).of(0);
}
template double multiply_add_peak<double>();
template double multiply_add_peak<float>();

std::vector<MemoryLevel> memory_levels() {
  constexpr double kilo = 1024, mega = 1024 * kilo;
  const double l3 = cache(_SC_LEVEL3_CACHE_SIZE, 8 * mega);
  return {{"L1", cache(_SC_LEVEL1_DCACHE_SIZE, 32 * kilo)},
          {"L2", cache(_SC_LEVEL2_CACHE_SIZE, 512 * kilo)},
          {"L3", l3},
          {"memory", 8 * l3}};
}

double triad_bandwidth(const MemoryLevel& level) {
  const auto count = static_cast<std::size_t>(level.bytes / 2 / 3 / sizeof(double));
  std::vector<double> a(count), b(count, 1), c(count, 2);
  double s = 3;
  const Times times = time_in_turn({[&] {
    keep(s);
    double* __restrict to = a.data();
    const double *from = b.data(), *scaled = c.data();
    for (std::size_t k = 0; k < count; ++k) to[k] = from[k] + s * scaled[k];
    keep(a);
  }});
  return 3 * sizeof(double) * static_cast<double>(count) / times.of(0);
}

const MemoryLevel& level_that_holds(double bytes, const std::vector<MemoryLevel>& levels) {
  for (const MemoryLevel& level : levels)
    if (bytes <= level.bytes) return level;
  return levels.back();
}

}  // namespace touchstone::bench
