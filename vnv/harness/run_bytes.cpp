#include "vnv/harness/run_bytes.hpp"

#include <boost/iostreams/device/array.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/stream.hpp>
#include <cereal/archives/binary.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>

#include <stdexcept>

namespace cereal {

/// Fields of one column per particle, and those of one number.
template <class Archive, class Field>
requires std::is_base_of_v<Eigen::PlainObjectBase<Field>, Field>
void save(Archive& archive, const Field& field) {
  archive(field.rows(), field.cols());
  archive(binary_data(field.data(), sizeof(double) * static_cast<std::size_t>(field.size())));
}
template <class Archive, class Field>
requires std::is_base_of_v<Eigen::PlainObjectBase<Field>, Field>
void load(Archive& archive, Field& field) {
  Eigen::Index rows = 0, columns = 0;
  archive(rows, columns);
  field.resize(rows, columns);
  archive(binary_data(field.data(), sizeof(double) * static_cast<std::size_t>(field.size())));
}

}  // namespace cereal

namespace touchstone {

// Each type is listed once, for both directions.
void serialize(auto& archive, Samples& s) { archive(s.time, s.x, s.v, s.mass, s.density, s.pressure); }

namespace vnv {

void serialize(auto& archive, Cost& c) { archive(cereal::binary_data(&c, sizeof c)); }
void serialize(auto& archive, RunSummary& s) {
  archive(s.level, s.spacing, s.time_step, s.end_time, s.finished, s.outcome, s.cost);
}
void serialize(auto& archive, Quantity& q) { archive(q.name, q.unit, q.kind, q.better); }
void serialize(auto& archive, Value& v) { archive(v.level, v.spacing, v.time, v.quantity, v.value); }
void serialize(auto& archive, Curve& c) { archive(c.figure, c.label, c.role, c.x, c.y, c.points); }
void serialize(auto& archive, Room& r) {
  archive(r.domain.box.low, r.domain.box.high, r.domain.periodic_x, r.domain.periodic_y, r.filled.low, r.filled.high);
}
void serialize(auto& archive, History& h) { archive(h.time, h.values); }
void serialize(auto& archive, Run& r) { archive(r.summary, r.samples, r.history, r.found, r.curves, r.room); }

}  // namespace vnv
}  // namespace touchstone

namespace touchstone::vnv {

namespace io = boost::iostreams;

std::string to_bytes(const Run& run) {
  std::size_t of_samples = 1 << 12;
  for (const Samples& s : run.samples) of_samples += (sizeof(double) * 7 + 1) * static_cast<std::size_t>(s.size());
  std::string bytes;
  bytes.reserve(of_samples);  // whatever else it took would count as memory of the run
  io::stream<io::back_insert_device<std::string>> out(bytes);
  cereal::BinaryOutputArchive archive(out);
  archive(run);
  out.flush();
  return bytes;
}

Run run_from(const std::string& bytes) {
  io::stream<io::array_source> in(bytes.data(), bytes.size());
  cereal::BinaryInputArchive archive(in);
  Run run;
  archive(run);
  if (in.peek() != EOF) throw std::runtime_error("a run from its process: it goes on after its end");
  return run;
}

}  // namespace touchstone::vnv
