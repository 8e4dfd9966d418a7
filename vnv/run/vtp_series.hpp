#pragma once
/// Particles as files that ParaView opens: VTK's XML of points (.vtp), and a collection of them with their times
/// (.pvd).

#include <filesystem>
#include <span>
#include <string>

#include "solvers/samples.hpp"

namespace touchstone::vnv {

/// Points with z = 0, and of each velocity, pressure, density, mass and its number, as doubles in SI units; the time is
/// the array of fields TimeValue. Bytes are appended raw, compressed by zlib. Written whole, or throws
/// std::runtime_error.
void write_vtp(const std::filesystem::path& file, const Samples& samples);

/// FOLDER/NAME_0.vtp and so on, then FOLDER/NAME.pvd, which names them with their times. The folder is made if need be.
void write_vtp_series(const std::filesystem::path& folder, const std::string& name, std::span<const Samples> series);

}  // namespace touchstone::vnv
