/// A reader, given whatever libFuzzer makes of its samples: it gives datasets of equally many rows or refuses in one
/// line. Built by Clang as fuzz_vtk_xml, fuzz_npz and so on, each with the name of its function in READER; libhdf5 may
/// crash, so that fuzz_hdf5_unguarded needs -fork=1 -ignore_crashes=1.

#include <cstdlib>
#include <string_view>

#include "vnv/doors/read/delimited.hpp"
#include "vnv/doors/read/hdf5.hpp"
#include "vnv/doors/read/lammps.hpp"
#include "vnv/doors/read/npy.hpp"
#include "vnv/doors/read/pickle.hpp"
#include "vnv/doors/read/series.hpp"
#include "vnv/doors/read/vtk_legacy.hpp"
#include "vnv/doors/read/vtk_xml.hpp"

namespace touchstone::vnv::doors {

/// Those within a .npz stand behind its checksums.
[[maybe_unused]] static std::vector<Dataset> read_pickle(const char* file, std::string_view bytes, const Limits&) {
  const Pickle pickle(bytes, file);
  return {};
}

}  // namespace touchstone::vnv::doors

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace touchstone::vnv::doors;
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    for (const Dataset& dataset : READER("no such folder/a.vtp", bytes, Limits{.most_bytes = 1 << 22}))
      for (const Array& array : dataset.arrays)
        if (array.rows() != dataset.rows()) std::abort();
  } catch (const Unreadable& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
  return 0;
}
