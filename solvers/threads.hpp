#pragma once
/// Work shared between threads.

#include <Eigen/Core>
#include <omp.h>

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

}  // namespace touchstone
