#include "vnv/harness/run_bytes.hpp"

#include <cstring>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace touchstone::vnv {
namespace {

class Writer {
 public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(const T& value) { bytes.append(reinterpret_cast<const char*>(&value), sizeof value); }
  void operator()(const std::string& text) {
    (*this)(text.size());
    bytes += text;
  }
  template <class T>
  void operator()(const std::vector<T>& list) {
    (*this)(list.size());
    for (const T& item : list) (*this)(item);
  }
  template <class T, int rows, int columns>
  void operator()(const Eigen::Matrix<T, rows, columns>& field) {
    values(field);
  }
  template <class T>
  void operator()(const Eigen::Array<T, Eigen::Dynamic, 1>& field) {
    values(field);
  }
  void operator()(const Samples& s);
  void operator()(const Value& e);
  void operator()(const Curve& c);

  std::string bytes;

 private:
  void values(const auto& field) {
    (*this)(field.cols());
    (*this)(field.rows());
    bytes.append(reinterpret_cast<const char*>(field.data()), sizeof(*field.data()) * field.size());
  }
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : left_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  void operator()(T& value) { take(&value, sizeof value); }
  void operator()(std::string& text) {
    text.resize(length());
    take(text.data(), text.size());
  }
  template <class T>
  void operator()(std::vector<T>& list) {
    list.resize(length());
    for (T& item : list) (*this)(item);
  }
  void operator()(Vectors& field) { values(field); }
  void operator()(Scalars& field) { values(field); }
  void operator()(Samples& s);
  void operator()(Value& e);
  void operator()(Curve& c);

  bool is_at_end() const { return left_.empty(); }

 private:
  void take(void* to, std::size_t count) {
    if (count > left_.size()) throw std::runtime_error("a run from its process: it ends early");
    if (count == 0) return;  // to nowhere, which is no place to copy to
    std::memcpy(to, left_.data(), count);
    left_ = left_.subspan(count);
  }
  /// Never more than could follow, so that torn bytes ask for no huge memory.
  std::size_t length() {
    std::size_t count = 0;
    take(&count, sizeof count);
    if (count > left_.size()) throw std::runtime_error("a run from its process: it ends early");
    return count;
  }
  void values(auto& field) {
    Eigen::Index columns = 0, rows = 0;
    (*this)(columns);
    (*this)(rows);
    field.resize(rows, columns);
    take(field.data(), sizeof(*field.data()) * field.size());
  }

  std::span<const char> left_;
};

// Each type is listed once, for both directions.
void each(auto& field, auto& s, std::type_identity<Samples>) {
  field(s.time), field(s.x), field(s.v), field(s.mass), field(s.density), field(s.pressure);
}
void each(auto& field, auto& e, std::type_identity<Value>) {
  auto& q = e.quantity;
  field(e.level), field(e.spacing), field(e.time), field(e.value);
  field(q.name), field(q.unit), field(q.kind), field(q.better);
}
void each(auto& field, auto& c, std::type_identity<Curve>) {
  field(c.figure), field(c.label), field(c.role), field(c.x), field(c.y), field(c.points);
}
void each(auto& field, auto& run, std::type_identity<Run>) {
  auto& s = run.summary;
  field(s.level), field(s.spacing), field(s.time_step), field(s.end_time), field(s.finished), field(s.outcome);
  field(s.cost), field(run.samples), field(run.history.time), field(run.history.seen), field(run.found);
  field(run.curves);
}

void Writer::operator()(const Samples& s) { each(*this, s, std::type_identity<Samples>{}); }
void Writer::operator()(const Value& e) { each(*this, e, std::type_identity<Value>{}); }
void Writer::operator()(const Curve& c) { each(*this, c, std::type_identity<Curve>{}); }
void Reader::operator()(Curve& c) { each(*this, c, std::type_identity<Curve>{}); }
void Reader::operator()(Samples& s) { each(*this, s, std::type_identity<Samples>{}); }
void Reader::operator()(Value& e) { each(*this, e, std::type_identity<Value>{}); }

}  // namespace

std::string to_bytes(const Run& run) {
  Writer writer;
  std::size_t of_samples = 1 << 12;
  for (const Samples& s : run.samples) of_samples += (sizeof(double) * 7 + 1) * static_cast<std::size_t>(s.size());
  writer.bytes.reserve(of_samples);
  each(writer, run, std::type_identity<Run>{});
  return std::move(writer.bytes);
}

Run run_from(const std::string& bytes) {
  Run run;
  Reader reader(bytes);
  each(reader, run, std::type_identity<Run>{});
  if (!reader.is_at_end()) throw std::runtime_error("a run from its process: it goes on after its end");
  return run;
}

}  // namespace touchstone::vnv
