#pragma once
/// Work shared between threads.

#include <omp.h>
#include <Eigen/Core>

#include <algorithm>

namespace touchstone {

/// Calls work(begin, end) for contiguous parts of [0, count), one part a thread; with one thread it is a plain call.
/// Results do not depend on the number of threads as long as no two parts write to the same place and no sum runs
/// across parts. `work` must not throw.
template <class Work>
void share_out(int threads, Eigen::Index count, const Work& work) {
  if (threads == 1) return work(Eigen::Index{0}, count);
#pragma omp parallel num_threads(threads)
  {
    const Eigen::Index part = omp_get_thread_num(), parts = omp_get_num_threads();
    work(count * part / parts, count * (part + 1) / parts);
  }
}

/// The same for fields of particles. Parts begin where a vector register does: numbers that are left over at the end of
/// a loop over vectors are reckoned one by one and may be rounded otherwise, as on arm64. So only the very last ones
/// are, for any number of threads.
template <class Work>
void share_out_fields(int threads, Eigen::Index count, const Work& work) {
  constexpr Eigen::Index block = 16;  // doubles  at least a vector register
  share_out(threads, (count + block - 1) / block,
            [&](Eigen::Index begin, Eigen::Index end) { work(begin * block, std::min(end * block, count)); });
}

}  // namespace touchstone
